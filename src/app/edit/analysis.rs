//! What is read of the text once for each of its revisions: its tree, its values, the things in it.

use crate::document::{Document, Place, Syntax, Target, target_at, targets};
use serde_json::Value;

/// What the text holds.
#[derive(Debug, Default)]
pub struct Analysis {
    revision: Option<u64>,
    /// Its words and tree.
    pub syntax: Syntax,
    /// Its values, as far as they can be read.
    pub whole: Value,
    /// The things that can be edited one by one.
    pub targets: Vec<Target>,
}

impl Analysis {
    /// Reads the text anew, if it has changed.
    pub fn follow(&mut self, document: &Document) {
        if self.revision == Some(document.revision()) {
            return;
        }
        let syntax = Syntax::of(document.text());
        self.whole = syntax.root().map(|root| syntax.value(document.text(), root)).unwrap_or_default();
        self.syntax = syntax;
        self.targets = targets(&self.whole);
        self.revision = Some(document.revision());
    }

    /// Forgets what was read: there is another document.
    pub fn reset(&mut self) {
        self.revision = None;
    }

    /// The thing at a place of the text, by its number in [`targets`](Self::targets).
    #[must_use]
    pub fn target_of(&self, place: &Place) -> Option<usize> {
        target_at(&self.targets, place)
    }
}
