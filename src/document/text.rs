//! A text that is being edited: every change can be taken back, bit for bit, to the text that was opened.

use super::change::{Replacement, Selection, Splice, difference, splice};

/// What a change was for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cause {
    /// What it did, for the menu: `Change radius of lens`.
    pub name: String,
    /// Changes one after the other with the same gesture are one: a drag, a slider.
    pub gesture: Option<String>,
}

impl Cause {
    /// A change that stands alone.
    #[must_use]
    pub fn new(name: impl Into<String>) -> Self {
        Self { name: name.into(), gesture: None }
    }

    /// A part of a gesture: it is taken back together with the parts before it.
    #[must_use]
    pub fn part_of(name: impl Into<String>, gesture: impl Into<String>) -> Self {
        Self { name: name.into(), gesture: Some(gesture.into()) }
    }
}

/// The gesture of typing; words are told apart by what is typed.
const TYPING: &str = "typing";

/// A change that was made.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Edit {
    cause: Cause,
    /// In the order in which they were made.
    splices: Vec<Splice>,
    before: Selection,
    after: Selection,
}

/// A text with its history.
#[derive(Clone, Debug, Default)]
pub struct Document {
    text: String,
    saved: String,
    selection: Selection,
    done: Vec<Edit>,
    undone: Vec<Edit>,
    /// Whether the last change is complete, so that nothing may be added to it.
    sealed: bool,
    revision: u64,
    dirty: bool,
}

impl Document {
    /// A text as it was opened: nothing to save, nothing to take back.
    #[must_use]
    pub fn new(text: impl Into<String>) -> Self {
        let text = text.into();
        Self { saved: text.clone(), text, ..Self::default() }
    }

    /// A text with unsaved changes over the text that was saved.
    #[must_use]
    pub fn recovered(saved: impl Into<String>, text: &str, selection: Selection, name: &str) -> Self {
        let mut document = Self::new(saved);
        document.rewrite(text, selection, Cause::new(name));
        document
    }

    /// The text.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The text as it was last saved or opened.
    #[must_use]
    pub fn saved(&self) -> &str {
        &self.saved
    }

    /// Where the cursor is.
    #[must_use]
    pub fn selection(&self) -> Selection {
        self.selection
    }

    /// Moves the cursor; what is typed then is a change of its own.
    pub fn select(&mut self, selection: Selection) {
        let selection = selection.within(&self.text);
        self.sealed |= self.selection != selection;
        self.selection = selection;
    }

    /// Another number after every change, so that what was made of the text can be told from what has to be made anew.
    #[must_use]
    pub fn revision(&self) -> u64 {
        self.revision
    }

    /// Whether the text is another than the one that was saved.
    #[must_use]
    pub fn is_dirty(&self) -> bool {
        self.dirty
    }

    /// The text is now saved as it stands.
    pub fn mark_saved(&mut self) {
        self.saved.clone_from(&self.text);
        self.dirty = false;
        self.sealed = true;
    }

    /// The text was saved as it stood at an earlier moment.
    pub fn mark_saved_as(&mut self, text: &str) {
        text.clone_into(&mut self.saved);
        self.dirty = self.text != self.saved;
        self.sealed = true;
    }

    /// Ends a gesture: the next change is one of its own.
    pub fn seal(&mut self) {
        self.sealed = true;
    }

    /// Replaces ranges of the text; returns whether that changed anything. The cursor keeps its place in the text.
    pub fn replace(&mut self, replacements: Vec<Replacement>, cause: Cause) -> bool {
        let before = self.selection;
        let splices = splice(&mut self.text, replacements);
        let moved = |offset| splices.iter().fold(offset, carried);
        let after = Selection { anchor: moved(before.anchor), head: moved(before.head) };
        self.note(splices, before, after, cause)
    }

    /// Makes the text another one, with the cursor where it is told; returns whether that changed anything.
    pub fn rewrite(&mut self, text: &str, selection: Selection, cause: Cause) -> bool {
        let before = self.selection;
        let change = difference(&self.text, text);
        let splices = splice(&mut self.text, change.into_iter().collect());
        self.note(splices, before, selection, cause)
    }

    /// What the editor's text has become by typing, deleting or pasting, and what that is called. Letters of a word are one
    /// change.
    pub fn typed(&mut self, text: &str, selection: Selection, name: &str) -> bool {
        let cause = Cause::part_of(name, TYPING);
        let before = self.selection;
        let change = difference(&self.text, text);
        let splices = splice(&mut self.text, change.into_iter().collect());
        if let [splice] = &splices[..] {
            self.sealed |= !continues(self.done.last(), splice);
        }
        self.note(splices, before, selection, cause)
    }

    fn note(&mut self, splices: Vec<Splice>, before: Selection, after: Selection, cause: Cause) -> bool {
        self.selection = after.within(&self.text);
        if splices.is_empty() {
            return false;
        }
        self.undone.clear();
        let after = self.selection;
        let goes_on = !self.sealed && cause.gesture.is_some();
        match self.done.last_mut().filter(|last| goes_on && last.cause.gesture == cause.gesture) {
            Some(last) => last.absorb(splices, after),
            None => self.done.push(Edit { cause, splices, before, after }),
        }
        self.sealed = false;
        self.changed();
        true
    }

    fn changed(&mut self) {
        self.revision += 1;
        self.dirty = self.text != self.saved;
    }

    /// Takes the last change back; returns its name, or none where there is nothing to take back.
    pub fn undo(&mut self) -> Option<&str> {
        let edit = self.done.pop()?;
        edit.splices.iter().rev().for_each(|splice| splice.undo(&mut self.text));
        self.selection = edit.before;
        self.undone.push(edit);
        self.sealed = true;
        self.changed();
        self.undone.last().map(|edit| edit.cause.name.as_str())
    }

    /// Makes the change again that was taken back last; returns its name.
    pub fn redo(&mut self) -> Option<&str> {
        let edit = self.undone.pop()?;
        edit.splices.iter().for_each(|splice| splice.redo(&mut self.text));
        self.selection = edit.after;
        self.done.push(edit);
        self.sealed = true;
        self.changed();
        self.done.last().map(|edit| edit.cause.name.as_str())
    }

    /// What would be taken back.
    #[must_use]
    pub fn undo_name(&self) -> Option<&str> {
        self.done.last().map(|edit| edit.cause.name.as_str())
    }

    /// What would be made again.
    #[must_use]
    pub fn redo_name(&self) -> Option<&str> {
        self.undone.last().map(|edit| edit.cause.name.as_str())
    }
}

impl Edit {
    /// Takes up a further part of its gesture. A part that replaces what the one before inserted takes its place, so that a
    /// long drag keeps no more than its ends.
    fn absorb(&mut self, splices: Vec<Splice>, after: Selection) {
        self.after = after;
        let same = self.splices.len() == splices.len()
            && self.splices.iter().zip(&splices).all(|(old, new)| old.at == new.at && old.inserted == new.removed);
        if same && splices.len() == 1 {
            for (old, new) in self.splices.iter_mut().zip(splices) {
                old.inserted = new.inserted;
            }
        } else {
            self.splices.extend(splices);
        }
    }
}

/// Where an offset is after a splice before it or around it.
fn carried(offset: usize, splice: &Splice) -> usize {
    if offset < splice.at + splice.removed.len() {
        // Within what was replaced, or before it.
        offset.min(splice.at + splice.inserted.len())
    } else {
        offset - splice.removed.len() + splice.inserted.len()
    }
}

/// Whether a typed letter goes on with the word that was typed before it, or a deletion with the deletion before it.
fn continues(last: Option<&Edit>, next: &Splice) -> bool {
    let Some(last) = last.filter(|edit| edit.cause.gesture.as_deref() == Some(TYPING)).and_then(|e| e.splices.last())
    else {
        return false;
    };
    let is_word = |c: char| c.is_alphanumeric() || matches!(c, '_' | '.' | '-');
    let inserts = |splice: &Splice| splice.removed.is_empty() && !splice.inserted.is_empty();
    let deletes = |splice: &Splice| splice.inserted.is_empty() && splice.removed.chars().count() == 1;
    if inserts(last) && inserts(next) {
        let one = next.inserted.chars().count() == 1;
        let ended =
            last.inserted.chars().next_back().is_some_and(|c| !is_word(c)) && next.inserted.starts_with(is_word);
        one && !ended && next.at == last.at + last.inserted.len() && !next.inserted.contains('\n')
    } else {
        deletes(last) && deletes(next) && (next.at + next.removed.len() == last.at || next.at == last.at)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn type_at_end(document: &mut Document, letters: &str) {
        for letter in letters.chars() {
            let text = format!("{}{letter}", document.text());
            document.typed(&text, Selection::at(text.len()), "Type");
        }
    }

    #[test]
    fn a_word_is_taken_back_at_once_and_the_next_one_stays_another() {
        let mut document = Document::new("");
        type_at_end(&mut document, "two words");
        document.undo();
        assert_eq!(document.text(), "two ");
        document.undo();
        assert_eq!((document.text(), document.undo_name(), document.is_dirty()), ("", None, false));
        document.redo();
        document.redo();
        assert_eq!((document.text(), document.selection()), ("two words", Selection::at(9)));
    }

    #[test]
    fn a_drag_is_one_change_until_it_ends() {
        let mut document = Document::new("r: 1");
        let set = |document: &mut Document, value: &str| {
            let range = 3..document.text().len();
            document.replace(vec![Replacement::new(range, value)], Cause::part_of("Change r", "drag r"))
        };
        for value in ["2", "3", "42"] {
            assert!(set(&mut document, value));
        }
        document.seal();
        set(&mut document, "5");
        assert_eq!(document.undo(), Some("Change r"));
        assert_eq!(document.text(), "r: 42");
        document.undo();
        assert_eq!(document.text(), "r: 1");
        assert_eq!(document.undo(), None);
    }

    #[test]
    fn a_change_before_the_cursor_carries_it_along() {
        let mut document = Document::new("abc def");
        document.select(Selection::at(4));
        document.replace(vec![Replacement::new(0..3, "x")], Cause::new("Change"));
        assert_eq!(document.selection(), Selection::at(2));
        document.undo();
        assert_eq!(document.selection(), Selection::at(4));
    }

    #[test]
    fn typing_back_what_was_saved_leaves_nothing_to_save() {
        let mut document = Document::new("a");
        type_at_end(&mut document, "b");
        assert!(document.is_dirty());
        document.typed("a", Selection::at(1), "Type");
        assert!(!document.is_dirty());
        type_at_end(&mut document, "c");
        document.mark_saved();
        assert!(!document.is_dirty());
        document.undo();
        assert!(document.is_dirty());
    }
}
