//! Journals while texts are edited, and what crashed programs left behind.

use crate::app::system::{Journals, Left, since_1970};
use crate::document::{Document, Journal, Recovered};
use egui::Context;
use std::time::Duration;

/// The longest time between two notes, in seconds: less than the second that may be lost, as writing takes time too.
const PERIOD: f64 = 0.4;

/// A journal that was left behind.
#[derive(Debug)]
pub struct Offer {
    /// What it holds.
    pub state: Recovered,
    left: Left,
}

/// The journal of the open document, and those that were left behind.
pub struct Recovery {
    journals: Journals,
    journal: Journal,
    noted: f64,
    offers: Vec<Offer>,
}

impl Recovery {
    /// Looks at what was left behind. What has no whole state is left alone.
    #[must_use]
    pub fn among(journals: Journals) -> Self {
        let offer = |left: Left| {
            let state = Recovered::read(&left.bytes).filter(Recovered::is_change)?;
            Some(Offer { state, left })
        };
        let mut offers: Vec<Offer> = journals.left_behind().into_iter().filter_map(offer).collect();
        offers.sort_by_key(|offer| offer.state.when);
        Self { journals, journal: Journal::default(), noted: f64::NEG_INFINITY, offers }
    }

    /// What was left behind first of all.
    #[must_use]
    pub fn offer(&self) -> Option<&Offer> {
        self.offers.first()
    }

    /// Takes the first offer out of the list; it stays where it is for the next start.
    pub fn later(&mut self) -> Option<Offer> {
        (!self.offers.is_empty()).then(|| self.offers.remove(0))
    }

    /// Removes what was left behind, after the journal of what was made of it is written.
    pub fn remove(&mut self, offer: &Offer) {
        self.journals.remove_other(&offer.left);
    }

    /// Why the last note could not be written.
    #[must_use]
    pub fn problem(&self) -> Option<String> {
        self.journals.problem()
    }

    /// Notes what has changed since the last note, if it is time to.
    pub fn follow(&mut self, ctx: &Context, document: &Document, name: &str) {
        if !document.is_dirty() {
            if self.journal.is_begun() {
                self.journal.forget();
                self.journals.remove();
            }
            return;
        }
        let now = ctx.input(|input| input.time);
        if now < self.noted + PERIOD {
            ctx.request_repaint_after(Duration::from_secs_f64(PERIOD));
            return;
        }
        self.note(document, name);
        self.noted = now;
    }

    /// Notes what has changed since the last note at once.
    pub fn note(&mut self, document: &Document, name: &str) {
        if let Some(write) = self.journal.note(document, name, since_1970().as_secs()) {
            self.journals.write(write);
        }
    }
}

/// How long ago a moment was, in whole minutes.
#[must_use]
pub fn minutes_since(when: u64) -> usize {
    usize::try_from(since_1970().as_secs().saturating_sub(when) / 60).unwrap_or(usize::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Selection;
    use std::fs;
    use std::path::{Path, PathBuf};

    fn in_folder(folder: &Path) -> Recovery {
        Recovery::among(Journals::in_folder(folder))
    }

    fn edited() -> Document {
        let mut document = Document::new("{}");
        document.typed("{ \"title\": \"new\" }", Selection::at(3), "Type");
        document
    }

    /// Waits until the thread has written a journal.
    fn journal_in(folder: &Path) -> PathBuf {
        for _ in 0..2_000 {
            let found = fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path());
            let whole = found.filter(|path| path.extension().is_some_and(|extension| extension == "journal"));
            if let Some(path) = whole.into_iter().next() {
                return path;
            }
            std::thread::sleep(Duration::from_millis(5));
        }
        panic!("no journal was written");
    }

    #[test]
    fn what_a_living_program_edits_is_not_offered_and_what_a_dead_one_left_is() {
        let folder = tempfile::tempdir().unwrap();
        let mut living = in_folder(folder.path());
        living.note(&edited(), "mine.json");
        let journal = journal_in(folder.path());
        assert!(in_folder(folder.path()).offer().is_none(), "its program lives");
        // A killed program leaves its journal, and its lock is free.
        let other = tempfile::tempdir().unwrap();
        fs::copy(&journal, other.path().join("edit-x.journal")).unwrap();
        fs::write(other.path().join("edit-x.lock"), "").unwrap();
        let mut next = in_folder(other.path());
        assert_eq!(next.offer().map(|offer| offer.state.name.as_str()), Some("mine.json"));
        let offer = next.later().unwrap();
        next.remove(&offer);
        drop(next);
        assert_eq!(fs::read_dir(other.path()).unwrap().count(), 0);
    }

    #[test]
    fn a_program_that_ends_as_it_should_leaves_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let mut recovery = in_folder(folder.path());
        recovery.note(&edited(), "mine.json");
        journal_in(folder.path());
        drop(recovery);
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
    }

    #[test]
    fn what_is_no_journal_is_left_alone() {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("edit-y.journal"), "rayscope journal 1\n= 5").unwrap();
        assert!(in_folder(folder.path()).offer().is_none());
        assert!(folder.path().join("edit-y.journal").exists());
    }
}
