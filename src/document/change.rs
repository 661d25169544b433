//! A change of a text: ranges of it replaced, with what is needed to take the change back.

use std::ops::Range;

/// A range of the text and what takes its place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Replacement {
    /// The range, in bytes of the text before the change.
    pub range: Range<usize>,
    /// What stands there afterwards.
    pub text: String,
}

impl Replacement {
    /// `text` in place of the range.
    #[must_use]
    pub fn new(range: Range<usize>, text: impl Into<String>) -> Self {
        Self { range, text: text.into() }
    }
}

/// What a range held before, and what it holds now.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Splice {
    /// Where it begins, before and after.
    pub at: usize,
    pub removed: String,
    pub inserted: String,
}

impl Splice {
    pub fn undo(&self, text: &mut String) {
        text.replace_range(self.at..self.at + self.inserted.len(), &self.removed);
    }

    pub fn redo(&self, text: &mut String) {
        text.replace_range(self.at..self.at + self.removed.len(), &self.inserted);
    }

    pub fn is_nothing(&self) -> bool {
        self.removed == self.inserted
    }
}

/// Where the selection is: both ends in bytes, the cursor at `head`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct Selection {
    /// Where it was begun.
    pub anchor: usize,
    /// Where the cursor is.
    pub head: usize,
}

impl Selection {
    /// A cursor without anything selected.
    #[must_use]
    pub const fn at(offset: usize) -> Self {
        Self { anchor: offset, head: offset }
    }

    /// The selected range.
    #[must_use]
    pub fn range(&self) -> Range<usize> {
        self.anchor.min(self.head)..self.anchor.max(self.head)
    }

    /// The same within a text, on the borders of characters.
    #[must_use]
    pub fn within(self, text: &str) -> Self {
        let border = |offset: usize| text.floor_char_boundary(offset.min(text.len()));
        Self { anchor: border(self.anchor), head: border(self.head) }
    }
}

/// Makes the replacements, in any order and not overlapping; returns what each did, in the order in which they were made.
///
/// Replacements outside the text, within a character or over each other are left out.
pub(super) fn splice(text: &mut String, mut replacements: Vec<Replacement>) -> Vec<Splice> {
    // From the end to the beginning, so that no range moves before it is replaced. Of two at the same place, the later one
    // in the list comes later in the text.
    let mut splices = Vec::new();
    let mut end = text.len();
    let mut order: Vec<usize> = (0..replacements.len()).collect();
    order.sort_by_key(|i| (replacements[*i].range.start, replacements[*i].range.end, *i));
    for i in order.into_iter().rev() {
        let Replacement { range, text: inserted } = std::mem::replace(&mut replacements[i], Replacement::new(0..0, ""));
        let is_sound = range.start <= range.end && range.end <= end;
        if !is_sound || !text.is_char_boundary(range.start) || !text.is_char_boundary(range.end) {
            continue;
        }
        end = range.start;
        let splice = Splice { at: range.start, removed: text[range.clone()].to_owned(), inserted };
        if !splice.is_nothing() {
            text.replace_range(range, &splice.inserted);
            splices.push(splice);
        }
    }
    splices
}

/// The one replacement that takes `before` to `after`: all but what both begin and end with. None where they are equal.
#[must_use]
pub fn difference(before: &str, after: &str) -> Option<Replacement> {
    if before == after {
        return None;
    }
    let same = before.bytes().zip(after.bytes()).take_while(|(a, b)| a == b).count();
    let start = before.floor_char_boundary(same).min(after.floor_char_boundary(same));
    let (left, right) = (&before.as_bytes()[start..], &after.as_bytes()[start..]);
    let same = left.iter().rev().zip(right.iter().rev()).take_while(|(a, b)| a == b).count();
    // Bytes at the end that are alike may begin within a character.
    let behind = before.ceil_char_boundary(before.len() - same);
    let tail = (before.len() - behind).min(after.len() - after.ceil_char_boundary(after.len() - same));
    Some(Replacement::new(start..before.len() - tail, &after[start..after.len() - tail]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn replacements_in_any_order_are_made_where_they_were_meant() {
        let mut text = "one two three".to_owned();
        let wanted = vec![Replacement::new(8..13, "3"), Replacement::new(0..3, "1"), Replacement::new(3..3, "!")];
        let splices = splice(&mut text, wanted);
        assert_eq!(text, "1! two 3");
        splices.iter().rev().for_each(|splice| splice.undo(&mut text));
        assert_eq!(text, "one two three");
    }

    #[test]
    fn what_overlaps_or_lies_outside_is_left_out() {
        let mut text = "aé".to_owned();
        let wanted = vec![
            Replacement::new(0..2, "x"),
            Replacement::new(5..9, "y"),
            Replacement::new(Range { start: 3, end: 1 }, "z"),
        ];
        assert!(splice(&mut text, wanted).is_empty());
        assert_eq!(text, "aé");
    }

    #[test]
    fn a_difference_holds_whole_characters() {
        for (before, after) in [("aéb", "aèb"), ("aa", "aaa"), ("", "é"), ("ab", ""), ("€x", "₤x"), ("xax", "xx")]
        {
            let change = difference(before, after).unwrap();
            let mut text = before.to_owned();
            text.replace_range(change.range, &change.text);
            assert_eq!(text, after);
        }
        assert_eq!(difference("same", "same"), None);
    }
}
