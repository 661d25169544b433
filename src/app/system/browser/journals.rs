//! Journals in the browser's own store, one for each tab, and what tabs that were closed or crashed left there.
//!
//! A tab has a number that lives as long as it does. A journal belongs to a living tab as long as its stamp is young; after a reload it
//! is the tab's own.

use crate::app::system::since_1970;
use crate::document::Write;
use web_sys::Storage;

/// What the names of journals begin with in the store.
const JOURNAL: &str = "rayscope.journal.";
/// What the names of their stamps begin with: the second at which its tab last wrote.
const STAMP: &str = "rayscope.alive.";
/// Where a tab keeps its number.
const TAB: &str = "rayscope.tab";
/// A tab that has not written for so many seconds may have crashed. One that is only idle does not lose its journal: it is offered,
/// not removed.
const YOUNG: u64 = 4;

/// A journal that was left behind.
#[derive(Debug)]
pub struct Left {
    /// What is in it.
    pub bytes: Vec<u8>,
    tab: String,
}

/// The journal of this tab, in the store with those of others.
pub struct Journals {
    tab: String,
    text: String,
    problem: Option<String>,
}

impl Journals {
    /// Those of this browser, for this site.
    pub fn in_browser() -> Self {
        Self { tab: number_of_tab(), text: String::new(), problem: None }
    }

    /// The journals that no living tab holds.
    pub fn left_behind(&self) -> Vec<Left> {
        let Some(store) = store() else { return Vec::new() };
        let names = (0..store.length().unwrap_or(0)).filter_map(|place| store.key(place).ok()?);
        let mut tabs: Vec<String> = names.filter_map(|name| Some(name.strip_prefix(JOURNAL)?.to_owned())).collect();
        tabs.sort();
        tabs.retain(|tab| *tab == self.tab || !is_alive(&store, tab));
        let left = |tab: String| {
            let text = store.get_item(&format!("{JOURNAL}{tab}")).ok()??;
            Some(Left { bytes: text.into_bytes(), tab })
        };
        tabs.into_iter().filter_map(left).collect()
    }

    /// Writes a note.
    pub fn write(&mut self, note: Write) {
        match note {
            Write::Anew(bytes) => self.text = String::from_utf8_lossy(&bytes).into_owned(),
            Write::More(bytes) => self.text.push_str(&String::from_utf8_lossy(&bytes)),
        }
        let Some(store) = store() else { return };
        let kept = store.set_item(&self.own(JOURNAL), &self.text);
        // Without a stamp it would be offered too early, not lost.
        let _ = store.set_item(&self.own(STAMP), &since_1970().as_secs().to_string());
        self.problem = kept.err().map(|_| "the browser's store is full or switched off".to_owned());
    }

    /// Removes the journal: there is nothing to be offered any more.
    pub fn remove(&mut self) {
        self.text.clear();
        forget(&self.tab);
    }

    /// Removes what was left behind. What this tab has written since is its own.
    pub fn remove_other(&mut self, left: &Left) {
        if left.tab != self.tab {
            forget(&left.tab);
        } else if self.text.is_empty() {
            self.remove();
        }
    }

    /// Why the last note could not be written.
    pub fn problem(&self) -> Option<String> {
        self.problem.clone()
    }

    fn own(&self, kind: &str) -> String {
        format!("{kind}{}", self.tab)
    }
}

fn forget(tab: &str) {
    if let Some(store) = store() {
        for kind in [JOURNAL, STAMP] {
            // A store that cannot be changed keeps what it has.
            let _ = store.remove_item(&format!("{kind}{tab}"));
        }
    }
}

fn is_alive(store: &Storage, tab: &str) -> bool {
    let stamp = store.get_item(&format!("{STAMP}{tab}")).ok().flatten().and_then(|text| text.parse::<u64>().ok());
    stamp.is_some_and(|stamp| since_1970().as_secs().saturating_sub(stamp) < YOUNG)
}

/// The number of this tab: the moment at which it was opened.
fn number_of_tab() -> String {
    let session = web_sys::window().and_then(|window| window.session_storage().ok()?);
    let known = session.as_ref().and_then(|session| session.get_item(TAB).ok()?);
    known.unwrap_or_else(|| {
        let number = since_1970().as_micros().to_string();
        if let Some(session) = session {
            // Without it a reload offers the journal a few seconds later.
            let _ = session.set_item(TAB, &number);
        }
        number
    })
}

fn store() -> Option<Storage> {
    web_sys::window()?.local_storage().ok()?
}
