//! Changes of values in the text of a scene that leave everything else as it was: comments, spaces, the order of fields.
//!
//! They are made on the ranges of the tolerant tree, so that they work while other parts of the text are broken.

use super::change::Replacement;
use super::place::{Place, Step};
use super::syntax::{Node, NodeId, NodeKind, Syntax};
use super::tokens::TokenKind;
use super::written::written;
use serde_json::{Map, Value};
use std::ops::Range;

/// A text with its tree, to be changed.
#[derive(Clone, Copy)]
pub struct Structure<'a> {
    /// The text.
    pub text: &'a str,
    /// Its tree.
    pub syntax: &'a Syntax,
}

impl<'a> Structure<'a> {
    /// Sets the value at a place. What is missing on the way is made: objects for fields; items only at the end of a list.
    ///
    /// None where the way is blocked by a value of another kind, or an item lies beyond the end of its list.
    #[must_use]
    pub fn set(self, place: &Place, value: &Value) -> Option<Vec<Replacement>> {
        if let Some(node) = self.syntax.find(place) {
            return Some(self.overwrite(node, value));
        }
        let (above, step) = place.parent()?;
        match self.syntax.find(&above) {
            Some(node) => self.insert(node, step, value),
            None => self.set(&above, &wrapped(step, value)?),
        }
    }

    /// The replacements that make a node this value. Of lists with as many items, only those are touched that differ.
    fn overwrite(self, id: NodeId, value: &Value) -> Vec<Replacement> {
        let node = &self.syntax.nodes[id];
        if self.syntax.value(self.text, id) == *value && node.kind != NodeKind::Missing {
            return Vec::new();
        }
        if let (NodeKind::Array, Value::Array(items)) = (node.kind, value)
            && items.len() == node.children.len()
            && !items.is_empty()
        {
            let each = node.children.iter().zip(items);
            return each.flat_map(|(child, item)| self.overwrite(*child, item)).collect();
        }
        if node.kind == NodeKind::Missing {
            let colon = if self.text[..node.range.start].ends_with(':') { "" } else { ":" };
            return vec![Replacement::new(node.range.clone(), format!("{colon} {}", written(value)))];
        }
        vec![Replacement::new(node.range.clone(), written(value))]
    }

    /// A further field of an object, or a further item at the end of a list.
    fn insert(self, id: NodeId, step: &Step, value: &Value) -> Option<Vec<Replacement>> {
        let node = &self.syntax.nodes[id];
        match (node.kind, step) {
            (NodeKind::Object, Step::Field(name)) => {
                let field = format!("{}: {}", Value::from(name.as_str()), written(value));
                Some(self.insert_text(id, node.children.len(), &field))
            }
            (NodeKind::Array, Step::Item(index)) if *index == node.children.len() => {
                Some(self.insert_text(id, *index, &written(value)))
            }
            _ => None,
        }
    }

    /// A further item of the list at `place`, before the item that stands at `index` now. None where there is no such list.
    #[must_use]
    pub fn insert_item(self, place: &Place, index: usize, value: &Value) -> Option<Vec<Replacement>> {
        match self.syntax.find(place) {
            Some(id) => {
                let node = &self.syntax.nodes[id];
                let fits = node.kind == NodeKind::Array && index <= node.children.len();
                fits.then(|| self.insert_text(id, index, &written(value)))
            }
            None if index == 0 => self.set(place, &Value::Array(vec![value.clone()])),
            None => None,
        }
    }

    fn insert_text(self, id: NodeId, index: usize, inserted: &str) -> Vec<Replacement> {
        let node = &self.syntax.nodes[id];
        let Some(next) = node.children.get(index) else {
            return self.append_text(id, inserted);
        };
        let start = self.syntax.nodes[*next].whole().start;
        let gap = self.gap_before(node, index);
        vec![Replacement::new(start..start, format!("{inserted},{gap}"))]
    }

    fn append_text(self, id: NodeId, inserted: &str) -> Vec<Replacement> {
        let node = &self.syntax.nodes[id];
        let Some(last) = node.children.last().map(|last| &self.syntax.nodes[*last]) else {
            return vec![self.first_text(node, inserted)];
        };
        let gap = self.gap_before(node, node.children.len() - 1);
        let end = last.range.end;
        match self.token_after(end).filter(|token| self.text[token.clone()] == *",") {
            // A comma too many is used up.
            Some(comma) => vec![Replacement::new(comma.end..comma.end, format!("{gap}{inserted}"))],
            None => vec![Replacement::new(end..end, format!(",{gap}{inserted}"))],
        }
    }

    /// Into empty brackets; what stands there, such as a comment, stays.
    fn first_text(self, node: &Node, inserted: &str) -> Replacement {
        let inside = node.range.start + 1..if node.closed { node.range.end - 1 } else { node.range.end };
        let padding = if node.kind == NodeKind::Object { " " } else { "" };
        if self.text[inside.clone()].trim().is_empty() {
            return Replacement::new(inside, format!("{padding}{inserted}{padding}"));
        }
        Replacement::new(inside.start..inside.start, format!("{padding}{inserted}{padding}"))
    }

    /// What stands between values here: a line break with the indentation of the value at `index`, or a space.
    fn gap_before(self, node: &Node, index: usize) -> &'a str {
        let start = self.syntax.nodes[node.children[index]].whole().start;
        let before = &self.text[..start];
        let gap = &self.text[before.trim_end().len()..start];
        // Only the last line break: blank lines between groups are not repeated.
        match gap.rfind('\n') {
            Some(newline) if gap[..newline].ends_with('\r') => &gap[newline - 1..],
            Some(newline) => &gap[newline..],
            None => " ",
        }
    }

    /// Takes a value away, with the name of its field and the comma that it needed. None where there is no such value.
    #[must_use]
    pub fn remove(self, place: &Place) -> Option<Vec<Replacement>> {
        let id = self.syntax.find(place)?;
        let node = &self.syntax.nodes[id];
        let parent = &self.syntax.nodes[node.parent?];
        let index = parent.children.iter().position(|child| *child == id)?;
        let whole = node.whole();
        let comma = if index > 0 {
            let before = self.syntax.nodes[parent.children[index - 1]].range.end;
            self.token_after(before)
        } else {
            self.token_after(whole.end)
        };
        let comma = comma.filter(|token| self.text[token.clone()] == *",");
        let only = parent.children.len() == 1;
        let behind = comma.as_ref().filter(|comma| index == 0 && comma.start == whole.end);
        let own = match behind {
            Some(comma) => whole.start..self.gap_end(comma.end),
            None if index > 0 || only => self.gap_start(whole.start)..whole.end,
            None => whole,
        };
        let own = if only { own.start..self.gap_before_bracket(own.end) } else { own };
        Some(with_comma(own, comma))
    }

    /// Back over the white space before an offset, but not over the end of a line comment's line.
    fn gap_start(self, offset: usize) -> usize {
        let start = self.text[..offset].trim_end().len();
        let after_line_comment = self.syntax.tokens.iter().any(|token| {
            token.kind == TokenKind::Comment
                && token.range.end == start
                && self.text[token.range.clone()].starts_with("//")
        });
        if after_line_comment {
            start + self.text[start..offset].find('\n').map_or(0, |newline| newline + 1)
        } else {
            start
        }
    }

    /// Over the spaces before a closing bracket, so that none are left in empty ones.
    fn gap_before_bracket(self, offset: usize) -> usize {
        let rest = self.text[offset..].trim_start_matches([' ', '\t']);
        if rest.starts_with(['}', ']']) { self.text.len() - rest.len() } else { offset }
    }

    fn gap_end(self, offset: usize) -> usize {
        self.text.len() - self.text[offset..].trim_start().len()
    }

    /// The first token behind an offset that is no comment.
    fn token_after(self, offset: usize) -> Option<Range<usize>> {
        let first = self.syntax.tokens.partition_point(|token| token.range.start < offset);
        let behind = self.syntax.tokens[first..].iter();
        behind.filter(|token| token.kind != TokenKind::Comment).map(|token| token.range.clone()).next()
    }
}

/// The value inside what a step leads from.
fn wrapped(step: &Step, value: &Value) -> Option<Value> {
    match step {
        Step::Field(name) => Some(Value::Object(Map::from_iter([(name.clone(), value.clone())]))),
        Step::Item(0) => Some(Value::Array(vec![value.clone()])),
        Step::Item(_) => None,
    }
}

/// A range and a comma before, in or behind it are taken away.
fn with_comma(own: Range<usize>, comma: Option<Range<usize>>) -> Vec<Replacement> {
    let own_away = Replacement::new(own.clone(), "");
    match comma {
        Some(comma) if comma.end == own.start => vec![Replacement::new(comma.start..own.end, "")],
        Some(comma) if comma.start < own.start || comma.end > own.end => vec![Replacement::new(comma, ""), own_away],
        _ => vec![own_away],
    }
}
