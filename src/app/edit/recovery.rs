//! The folder in which journals are kept while texts are edited, and what crashed programs left in it.
//!
//! Each open document has a journal and a lock beside it that is held as long as the program lives. A journal whose lock is free was
//! left behind. Writing is done on a thread; a journal is removed when its text is saved, given up, or the program ends as it should.

use crate::document::{Document, Journal, Recovered, Write};
use egui::Context;
use std::fs::{self, File, OpenOptions};
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, SystemTime};

/// The longest time between two notes, in seconds: less than the second that may be lost, as writing takes time too.
const PERIOD: f64 = 0.4;

/// A journal that was left behind.
#[derive(Debug)]
pub struct Offer {
    /// What it holds.
    pub state: Recovered,
    journal: PathBuf,
    lock_path: PathBuf,
    /// Held, so that no other program offers it too.
    _lock: Option<File>,
}

/// The journal of the open document, and those that were left behind.
pub struct Recovery {
    folder: PathBuf,
    journal: Journal,
    own: Option<Own>,
    noted: f64,
    offers: Vec<Offer>,
    problem: Arc<Mutex<Option<String>>>,
}

enum Order {
    Write(Write),
    Remove,
    RemoveOther(PathBuf, PathBuf),
}

struct Own {
    sender: Option<Sender<Order>>,
    thread: Option<JoinHandle<()>>,
    lock_path: PathBuf,
    _lock: File,
}

impl Recovery {
    /// Looks at what was left in a folder, which may not be there yet.
    #[must_use]
    pub fn in_folder(folder: &Path) -> Self {
        Self {
            folder: folder.to_owned(),
            journal: Journal::default(),
            own: None,
            noted: f64::NEG_INFINITY,
            offers: left_behind(folder),
            problem: Arc::default(),
        }
    }

    /// What was left behind first of all.
    #[must_use]
    pub fn offer(&self) -> Option<&Offer> {
        self.offers.first()
    }

    /// Takes the first offer out of the list; it stays in the folder for the next start.
    pub fn later(&mut self) -> Option<Offer> {
        (!self.offers.is_empty()).then(|| self.offers.remove(0))
    }

    /// Removes what was left behind, after the journal of what was made of it is written.
    pub fn remove(&mut self, offer: &Offer) {
        let (journal, lock) = (offer.journal.clone(), offer.lock_path.clone());
        self.send(Order::RemoveOther(journal, lock));
    }

    /// Why the last note could not be written.
    #[must_use]
    pub fn problem(&self) -> Option<String> {
        self.problem.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// Notes what has changed since the last note, if it is time to.
    pub fn follow(&mut self, ctx: &Context, document: &Document, name: &str) {
        if !document.is_dirty() {
            if self.journal.is_begun() {
                self.journal.forget();
                self.send(Order::Remove);
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
        if let Some(write) = self.journal.note(document, name, now()) {
            self.send(Order::Write(write));
        }
    }

    fn send(&mut self, order: Order) {
        if self.own.is_none() {
            match Own::begin(&self.folder, &self.problem) {
                Ok(own) => self.own = Some(own),
                Err(error) => {
                    *self.problem.lock().unwrap_or_else(PoisonError::into_inner) = Some(error.to_string());
                    return;
                }
            }
        }
        if let Some(sender) = self.own.as_ref().and_then(|own| own.sender.as_ref()) {
            // The thread listens until this end goes away.
            let _ = sender.send(order);
        }
    }
}

impl Drop for Recovery {
    /// The program ends as it should, so nothing has to be offered at the next start.
    fn drop(&mut self) {
        if !std::thread::panicking() && self.own.is_some() {
            self.send(Order::Remove);
        }
    }
}

impl Own {
    /// Takes a name in the folder that no other program has, and begins to listen.
    fn begin(folder: &Path, problem: &Arc<Mutex<Option<String>>>) -> std::io::Result<Self> {
        fs::create_dir_all(folder)?;
        let (lock, lock_path) = tempfile::Builder::new().prefix("edit-").suffix(".lock").tempfile_in(folder)?.keep()?;
        lock.lock()?;
        let journal = lock_path.with_extension("journal");
        let (sender, receiver) = channel();
        let problem = Arc::clone(problem);
        let work = move || {
            for order in receiver {
                let outcome = carry_out(&order, &journal);
                *problem.lock().unwrap_or_else(PoisonError::into_inner) = outcome.err().map(|error| error.to_string());
            }
        };
        let thread = std::thread::Builder::new().name("journal".to_owned()).spawn(work)?;
        Ok(Self { sender: Some(sender), thread: Some(thread), lock_path, _lock: lock })
    }
}

impl Drop for Own {
    fn drop(&mut self) {
        self.sender = None;
        if let Some(thread) = self.thread.take() {
            // What it still has to write is written; whether it could is no longer of use to anybody.
            let _ = thread.join();
        }
        if !std::thread::panicking() {
            let _ = fs::remove_file(&self.lock_path);
        }
    }
}

fn carry_out(order: &Order, journal: &Path) -> std::io::Result<()> {
    match order {
        Order::Write(Write::Anew(bytes)) => {
            let folder = journal.parent().unwrap_or(Path::new("."));
            let mut file = tempfile::NamedTempFile::new_in(folder)?;
            file.write_all(bytes)?;
            file.as_file().sync_data()?;
            file.persist(journal).map(drop).map_err(|error| error.error)
        }
        Order::Write(Write::More(bytes)) => OpenOptions::new().append(true).open(journal)?.write_all(bytes),
        Order::Remove => removed(journal),
        Order::RemoveOther(journal, lock) => removed(journal).and(removed(lock)),
    }
}

/// What is not there needs no removing.
fn removed(path: &Path) -> std::io::Result<()> {
    match fs::remove_file(path) {
        Err(error) if error.kind() != std::io::ErrorKind::NotFound => Err(error),
        _ => Ok(()),
    }
}

/// The journals in a folder that no program holds, oldest first. Those without a whole state are left alone.
fn left_behind(folder: &Path) -> Vec<Offer> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path());
    let journals = entries.filter(|path| path.extension().is_some_and(|extension| extension == "journal"));
    let mut offers: Vec<Offer> = journals.filter_map(offer_of).collect();
    offers.sort_by(|a, b| a.state.when.cmp(&b.state.when).then_with(|| a.journal.cmp(&b.journal)));
    offers
}

fn offer_of(journal: PathBuf) -> Option<Offer> {
    let lock_path = journal.with_extension("lock");
    let lock = File::open(&lock_path).ok();
    if lock.as_ref().is_some_and(|lock| lock.try_lock().is_err()) {
        return None;
    }
    let state = Recovered::read(&fs::read(&journal).ok()?).filter(Recovered::is_change)?;
    Some(Offer { state, journal, lock_path, _lock: lock })
}

/// Seconds since 1970.
fn now() -> u64 {
    SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).map_or(0, |since| since.as_secs())
}

/// How long ago a moment was, in whole minutes.
#[must_use]
pub fn minutes_since(when: u64) -> usize {
    usize::try_from(now().saturating_sub(when) / 60).unwrap_or(usize::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Selection;

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
        let mut living = Recovery::in_folder(folder.path());
        living.note(&edited(), "mine.json");
        let journal = journal_in(folder.path());
        assert!(Recovery::in_folder(folder.path()).offer().is_none(), "its program lives");
        // A killed program leaves its journal, and its lock is free.
        let other = tempfile::tempdir().unwrap();
        fs::copy(&journal, other.path().join("edit-x.journal")).unwrap();
        fs::write(other.path().join("edit-x.lock"), "").unwrap();
        let mut next = Recovery::in_folder(other.path());
        assert_eq!(next.offer().map(|offer| offer.state.name.as_str()), Some("mine.json"));
        let offer = next.later().unwrap();
        next.remove(&offer);
        drop(next);
        assert_eq!(fs::read_dir(other.path()).unwrap().count(), 0);
    }

    #[test]
    fn a_program_that_ends_as_it_should_leaves_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let mut recovery = Recovery::in_folder(folder.path());
        recovery.note(&edited(), "mine.json");
        journal_in(folder.path());
        drop(recovery);
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
    }

    #[test]
    fn what_is_no_journal_is_left_alone() {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("edit-y.journal"), "rayscope journal 1\n= 5").unwrap();
        assert!(Recovery::in_folder(folder.path()).offer().is_none());
        assert!(folder.path().join("edit-y.journal").exists());
    }
}
