//! The folder in which journals are kept, and what crashed programs left in it.
//!
//! Each open document has a journal and a lock beside it that is held as long as the program lives. A journal whose lock is free was
//! left behind. Writing is done on a thread; a journal is removed when its text is saved, given up, or the program ends as it should.

use crate::document::Write;
use std::fs::{self, File, OpenOptions};
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::JoinHandle;

/// A journal that was left behind.
#[derive(Debug)]
pub struct Left {
    /// What is in it.
    pub bytes: Vec<u8>,
    journal: PathBuf,
    lock_path: PathBuf,
    /// Held, so that no other program offers it too.
    _lock: Option<File>,
}

/// The journal of this program, in a folder with those of others.
pub struct Journals {
    folder: PathBuf,
    own: Option<Own>,
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

impl Journals {
    /// Those of a folder, which may not be there yet.
    pub fn in_folder(folder: &Path) -> Self {
        Self { folder: folder.to_owned(), own: None, problem: Arc::default() }
    }

    /// The journals that no program holds.
    pub fn left_behind(&self) -> Vec<Left> {
        let entries = fs::read_dir(&self.folder).into_iter().flatten().flatten().map(|entry| entry.path());
        let mut journals: Vec<PathBuf> =
            entries.filter(|path| path.extension().is_some_and(|extension| extension == "journal")).collect();
        journals.sort();
        journals.into_iter().filter_map(left_in).collect()
    }

    /// Writes a note.
    pub fn write(&mut self, note: Write) {
        self.send(Order::Write(note));
    }

    /// Removes the journal: there is nothing to be offered any more.
    pub fn remove(&mut self) {
        self.send(Order::Remove);
    }

    /// Removes what was left behind, after the journal of what was made of it is written.
    pub fn remove_other(&mut self, left: &Left) {
        self.send(Order::RemoveOther(left.journal.clone(), left.lock_path.clone()));
    }

    /// Why the last note could not be written.
    pub fn problem(&self) -> Option<String> {
        self.problem.lock().unwrap_or_else(PoisonError::into_inner).clone()
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

impl Drop for Journals {
    /// The program ends as it should, so nothing has to be offered at the next start.
    fn drop(&mut self) {
        if !std::thread::panicking() && self.own.is_some() {
            self.send(Order::Remove);
        }
    }
}

impl Own {
    /// Takes a name in the folder that no other program has, and begins to listen.
    fn begin(folder: &Path, problem: &Arc<Mutex<Option<String>>>) -> io::Result<Self> {
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

fn carry_out(order: &Order, journal: &Path) -> io::Result<()> {
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
fn removed(path: &Path) -> io::Result<()> {
    match fs::remove_file(path) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error),
        _ => Ok(()),
    }
}

fn left_in(journal: PathBuf) -> Option<Left> {
    let lock_path = journal.with_extension("lock");
    let lock = File::open(&lock_path).ok();
    if lock.as_ref().is_some_and(|lock| lock.try_lock().is_err()) {
        return None;
    }
    Some(Left { bytes: fs::read(&journal).ok()?, journal, lock_path, _lock: lock })
}
