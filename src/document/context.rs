//! Where in the JSON a cursor is: what may be written there, and what of it is written already.

use super::place::Place;
use super::syntax::{NodeId, NodeKind, Syntax};
use super::tokens::TokenKind;
use std::ops::Range;

/// What can be written at a cursor.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Context {
    /// The name of a further field of the object.
    Key {
        /// The object.
        object: Place,
        /// The name that is there already, whole, if any: the object is looked at as if it were not.
        own: Option<String>,
        /// Whether a colon follows.
        has_value: bool,
    },
    /// A value.
    Value {
        /// Its place.
        place: Place,
    },
}

/// A context with the word that the cursor is in.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AtCursor {
    /// What can be written.
    pub context: Context,
    /// The word that would be replaced; empty where the cursor stands alone.
    pub word: Range<usize>,
}

/// What can be written at an offset; none within comments and where nothing may stand, as behind a value.
#[must_use]
pub fn context_at(text: &str, syntax: &Syntax, offset: usize) -> Option<AtCursor> {
    let (word, before) = word_at(text, syntax, offset)?;
    let Some(container) = container_at(syntax, word.start) else {
        return (before.is_none()).then_some(AtCursor { context: Context::Value { place: Place::ROOT }, word });
    };
    let before = &text[syntax.tokens[before?].range.clone()];
    let place = syntax.place(container);
    let node = &syntax.nodes[container];
    let child = node.children.iter().rposition(|child| syntax.nodes[*child].whole().start <= word.start);
    let context = match (node.kind, before) {
        (NodeKind::Object, "{" | ",") => {
            let own = node
                .children
                .iter()
                .map(|child| &syntax.nodes[*child])
                .find(|child| child.whole().start == word.start && !word.is_empty());
            let has_value =
                own.is_some_and(|own| own.kind != NodeKind::Missing || text[..own.range.start].ends_with(':'));
            Context::Key {
                object: place,
                own: own.and_then(|own| own.key.as_ref()).map(|(name, _)| name.clone()),
                has_value,
            }
        }
        (NodeKind::Object, ":") => {
            let (name, _) = syntax.nodes[node.children[child?]].key.as_ref()?;
            Context::Value { place: place.field(name) }
        }
        (NodeKind::Array, "[" | ",") => {
            let index = node.children.iter().filter(|child| syntax.nodes[**child].range.end <= word.start).count();
            Context::Value { place: place.item(index) }
        }
        _ => return None,
    };
    Some(AtCursor { context, word })
}

/// The word at an offset, and the token before it that is no comment. None within a comment.
fn word_at(text: &str, syntax: &Syntax, offset: usize) -> Option<(Range<usize>, Option<usize>)> {
    let touching = syntax.token_at(offset).filter(|token| {
        let token = &syntax.tokens[*token];
        let inside = token.range.start < offset && offset < token.range.end;
        // At its beginning a quoted word is not yet being written.
        token.kind != TokenKind::Punctuation && (inside || token.range.end == offset)
    });
    let word = match touching.map(|token| &syntax.tokens[token]) {
        Some(token) if token.kind == TokenKind::Comment => {
            let is_line = text[token.range.clone()].starts_with("//");
            if is_line || offset < token.range.end {
                return None;
            }
            offset..offset
        }
        Some(token) if is_closed_before(text, &token.range, offset) => return None,
        Some(token) => token.range.clone(),
        None => offset..offset,
    };
    let end = syntax.tokens.partition_point(|token| token.range.end <= word.start);
    let before = (0..end).rev().find(|token| syntax.tokens[*token].kind != TokenKind::Comment);
    Some((word, before))
}

/// Whether the cursor stands behind the closing quote of a text, where nothing more belongs to it.
fn is_closed_before(text: &str, range: &Range<usize>, offset: usize) -> bool {
    let written = &text[range.clone()];
    offset == range.end && written.len() > 1 && written.starts_with('"') && written.ends_with('"')
}

/// The innermost object or list that an offset is inside of, brackets not counted.
fn container_at(syntax: &Syntax, offset: usize) -> Option<NodeId> {
    let is_inside = |id: NodeId| {
        let node = &syntax.nodes[id];
        let holds = matches!(node.kind, NodeKind::Object | NodeKind::Array);
        holds && node.range.start < offset && (offset < node.range.end || (!node.closed && offset == node.range.end))
    };
    let mut here = syntax.node_at(offset)?;
    while !is_inside(here) {
        here = syntax.nodes[here].parent?;
    }
    Some(here)
}
