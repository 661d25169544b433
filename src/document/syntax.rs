//! The tree of a scene's text with the range of every value, made of any text, however broken.
//!
//! The reader of scene files stops at the first thing that is not JSON. An editor cannot: while something is being
//! typed, the text is broken most of the time. Here a bracket closes what it can, a missing value is a value of its
//! own kind, and whatever is left over is passed over.

use super::place::{Place, Step};
use super::tokens::{Token, TokenKind, scan};
use serde_json::{Map, Value};
use std::ops::Range;

/// The place of a node in [`Syntax::nodes`].
pub type NodeId = usize;

/// What a value is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NodeKind {
    /// `{ … }`
    Object,
    /// `[ … ]`
    Array,
    /// Text, a number or a word.
    Scalar,
    /// A field that has no value yet.
    Missing,
}

/// A value.
#[derive(Clone, Debug)]
pub struct Node {
    /// What it is.
    pub kind: NodeKind,
    /// Where it stands, with its brackets or quotes.
    pub range: Range<usize>,
    /// The object or list that it is in.
    pub parent: Option<NodeId>,
    /// The name of its field with the range of that name, if it is in an object.
    pub key: Option<(String, Range<usize>)>,
    /// The values in it, in the order of the text.
    pub children: Vec<NodeId>,
    /// Whether its closing bracket is there.
    pub closed: bool,
}

impl Node {
    /// From the name of its field, if it has one, to its end.
    #[must_use]
    pub fn whole(&self) -> Range<usize> {
        self.key.as_ref().map_or(self.range.start, |(_, name)| name.start)..self.range.end
    }
}

/// The tree and the words that it is made of.
#[derive(Clone, Debug, Default)]
pub struct Syntax {
    /// The words of the text, in its order.
    pub tokens: Vec<Token>,
    /// The values, those outside before those inside.
    pub nodes: Vec<Node>,
}

/// Deeper values are not read: no scene goes as deep, and each level takes room on the stack.
const MOST_NESTING: usize = 200;

impl Syntax {
    /// Reads any text.
    #[must_use]
    pub fn of(text: &str) -> Self {
        let mut reader =
            Reader { text, syntax: Self { tokens: scan(text), nodes: Vec::new() }, open: Vec::new(), key: None };
        for token in 0..reader.syntax.tokens.len() {
            reader.take(token);
        }
        reader.end();
        reader.syntax
    }

    /// The outermost value.
    #[must_use]
    pub fn root(&self) -> Option<NodeId> {
        (!self.nodes.is_empty()).then_some(0)
    }

    /// The value at a place. Of fields with the same name the last one counts, as in the scene.
    #[must_use]
    pub fn find(&self, place: &Place) -> Option<NodeId> {
        place.0.iter().try_fold(self.root()?, |here, step| self.child(here, step))
    }

    fn child(&self, node: NodeId, step: &Step) -> Option<NodeId> {
        let node = &self.nodes[node];
        match (step, node.kind) {
            (Step::Field(name), NodeKind::Object) => node
                .children
                .iter()
                .rev()
                .copied()
                .find(|child| self.nodes[*child].key.as_ref().is_some_and(|(key, _)| key == name)),
            (Step::Item(index), NodeKind::Array) => node.children.get(*index).copied(),
            _ => None,
        }
    }

    /// Where a value is.
    #[must_use]
    pub fn place(&self, node: NodeId) -> Place {
        let mut steps = Vec::new();
        let mut here = node;
        while let Some(parent) = self.nodes[here].parent {
            let step = if let Some((name, _)) = &self.nodes[here].key {
                Step::Field(name.clone())
            } else {
                let siblings = &self.nodes[parent].children;
                Step::Item(siblings.iter().position(|child| *child == here).unwrap_or_default())
            };
            steps.push(step);
            here = parent;
        }
        steps.reverse();
        Place(steps)
    }

    /// The innermost value, with the name of its field, that the offset lies in or at the end of.
    #[must_use]
    pub fn node_at(&self, offset: usize) -> Option<NodeId> {
        let mut here = self.root().filter(|root| touches(&self.nodes[*root].range, offset))?;
        loop {
            let children = &self.nodes[here].children;
            // Nodes of one parent stand one after the other, so the first that ends behind the offset is the only one.
            let next = children.partition_point(|child| self.nodes[*child].range.end < offset);
            match children.get(next).copied().filter(|child| touches(&self.nodes[*child].whole(), offset)) {
                Some(child) => here = child,
                None => return Some(here),
            }
        }
    }

    /// The place of the innermost value at an offset; the whole where there is none.
    #[must_use]
    pub fn place_at(&self, offset: usize) -> Place {
        self.node_at(offset).map_or(Place::ROOT, |node| self.place(node))
    }

    /// The range of the value at a place.
    #[must_use]
    pub fn range(&self, place: &Place) -> Option<Range<usize>> {
        self.find(place).map(|node| self.nodes[node].range.clone())
    }

    /// The value of a node, as far as it can be read: what is broken is null.
    #[must_use]
    pub fn value(&self, text: &str, node: NodeId) -> Value {
        self.value_within(text, node, MOST_NESTING)
    }

    fn value_within(&self, text: &str, id: NodeId, depth: usize) -> Value {
        let node = &self.nodes[id];
        let Some(depth) = depth.checked_sub(1) else { return Value::Null };
        match node.kind {
            NodeKind::Object => {
                let mut map = Map::new();
                for child in &node.children {
                    if let Some((name, _)) = &self.nodes[*child].key {
                        map.insert(name.clone(), self.value_within(text, *child, depth));
                    }
                }
                Value::Object(map)
            }
            NodeKind::Array => node.children.iter().map(|child| self.value_within(text, *child, depth)).collect(),
            NodeKind::Scalar => serde_json::from_str(&text[node.range.clone()]).unwrap_or_default(),
            NodeKind::Missing => Value::Null,
        }
    }

    /// The value at a place, if there is one.
    #[must_use]
    pub fn value_at(&self, text: &str, place: &Place) -> Option<Value> {
        self.find(place).map(|node| self.value(text, node))
    }

    /// The token that the offset lies in or at the end of; of two that meet there, the one that is a word.
    #[must_use]
    pub fn token_at(&self, offset: usize) -> Option<usize> {
        let first = self.tokens.partition_point(|token| token.range.end < offset);
        let touching = (first..self.tokens.len()).take_while(|token| self.tokens[*token].range.start <= offset);
        touching.min_by_key(|token| self.tokens[*token].kind == TokenKind::Punctuation)
    }
}

fn touches(range: &Range<usize>, offset: usize) -> bool {
    range.start <= offset && offset <= range.end
}

/// A name that waits for its value.
struct Waiting {
    name: String,
    range: Range<usize>,
    /// Behind the name, or behind its colon.
    end: usize,
    colon: bool,
}

struct Reader<'t> {
    text: &'t str,
    syntax: Syntax,
    open: Vec<NodeId>,
    key: Option<Waiting>,
}

impl Reader<'_> {
    fn take(&mut self, token: usize) {
        let Token { kind, range } = self.syntax.tokens[token].clone();
        match kind {
            TokenKind::Comment => {}
            TokenKind::Punctuation => self.punctuation(token, range),
            _ if self.wants_key() && self.text[range.clone()].starts_with('"') => self.name(token, range),
            _ if self.open.is_empty() && !self.syntax.nodes.is_empty() => {
                self.syntax.tokens[token].kind = TokenKind::Error;
            }
            _ if self.wants_key() => {}
            _ => {
                self.add(NodeKind::Scalar, range);
            }
        }
    }

    /// Whether a name has to come next: in an object, unless a colon was just read.
    fn wants_key(&self) -> bool {
        let in_object = self.open.last().is_some_and(|node| self.syntax.nodes[*node].kind == NodeKind::Object);
        in_object && !self.key.as_ref().is_some_and(|key| key.colon)
    }

    fn name(&mut self, token: usize, range: Range<usize>) {
        self.give_up_key();
        if self.syntax.tokens[token].kind == TokenKind::String {
            self.syntax.tokens[token].kind = TokenKind::Key;
        }
        let written = &self.text[range.clone()];
        let name = serde_json::from_str(written).unwrap_or_else(|_| written.trim_matches('"').to_owned());
        self.key = Some(Waiting { name, end: range.end, range, colon: false });
    }

    fn punctuation(&mut self, token: usize, range: Range<usize>) {
        match &self.text[range.clone()] {
            ":" => match &mut self.key {
                Some(key) if !key.colon => (key.colon, key.end) = (true, range.end),
                _ => self.syntax.tokens[token].kind = TokenKind::Error,
            },
            "," => {
                self.give_up_key();
                if self.open.is_empty() {
                    self.syntax.tokens[token].kind = TokenKind::Error;
                }
            }
            "{" => self.begin(token, NodeKind::Object, range),
            "[" => self.begin(token, NodeKind::Array, range),
            "}" => self.close(token, NodeKind::Object, range.end),
            _ => self.close(token, NodeKind::Array, range.end),
        }
    }

    fn begin(&mut self, token: usize, kind: NodeKind, range: Range<usize>) {
        if self.open.is_empty() && !self.syntax.nodes.is_empty() {
            if self.syntax.nodes.iter().any(|node| matches!(node.kind, NodeKind::Object | NodeKind::Array)) {
                self.syntax.tokens[token].kind = TokenKind::Error;
                return;
            }
            self.turn_down(token);
        }
        let node = self.add(kind, range);
        self.open.push(node);
    }

    /// A word before the first bracket is what is wrong, not all that follows.
    fn turn_down(&mut self, before: usize) {
        for token in self.syntax.tokens[..before].iter_mut().filter(|token| token.kind != TokenKind::Comment) {
            token.kind = TokenKind::Error;
        }
        self.syntax.nodes.clear();
    }

    /// Closes the innermost value of this kind with all that is open in it; without one, the bracket is an error.
    fn close(&mut self, token: usize, kind: NodeKind, end: usize) {
        self.give_up_key();
        let Some(depth) = self.open.iter().rposition(|node| self.syntax.nodes[*node].kind == kind) else {
            self.syntax.tokens[token].kind = TokenKind::Error;
            return;
        };
        let inner_end = self.syntax.tokens[token].range.start;
        for node in self.open.drain(depth + 1..) {
            self.syntax.nodes[node].range.end = inner_end;
        }
        if let Some(node) = self.open.pop() {
            self.syntax.nodes[node].range.end = end;
            self.syntax.nodes[node].closed = true;
        }
    }

    /// A name whose value never came.
    fn give_up_key(&mut self) {
        if let Some(end) = self.key.as_ref().map(|key| key.end) {
            self.add(NodeKind::Missing, end..end);
        }
    }

    fn add(&mut self, kind: NodeKind, range: Range<usize>) -> NodeId {
        let (id, parent) = (self.syntax.nodes.len(), self.open.last().copied());
        let key = self.key.take().map(|key| (key.name, key.range));
        let closed = matches!(kind, NodeKind::Scalar | NodeKind::Missing);
        self.syntax.nodes.push(Node { kind, range, parent, key, children: Vec::new(), closed });
        if let Some(parent) = parent {
            self.syntax.nodes[parent].children.push(id);
        }
        id
    }

    fn end(&mut self) {
        self.give_up_key();
        for node in self.open.drain(..) {
            self.syntax.nodes[node].range.end = self.text.len();
        }
    }
}
