//! What is written beside the user's files so that a crash loses next to nothing, and what can be read of it afterwards.
//!
//! A journal is a line that says what it is, and records. The first record holds everything; each further one is the
//! change since the one before. A record says how long it is and carries a check, so that a journal that was cut off
//! anywhere, or damaged, yields the last state that is whole. This layer makes and understands bytes; it writes
//! nothing.

use super::change::{Selection, difference};
use super::text::Document;
use serde::{Deserialize, Serialize};

/// The first line. Another version would be another line.
const HEAD: &[u8] = b"rayscope journal 1\n";

/// After this many records the journal is written anew: more would take longer to read back; fewer would write the whole
/// text more often.
const MOST_RECORDS: usize = 1_000;

/// What is to be written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Write {
    /// The whole journal, in place of what was there.
    Anew(Vec<u8>),
    /// This, after what is there.
    More(Vec<u8>),
}

/// What a journal held.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Recovered {
    /// The scene's name, or its file's.
    pub name: String,
    /// When the last change was noted, in seconds since 1970.
    pub when: u64,
    /// The text as it was last saved or opened.
    pub saved: String,
    /// The text as it was last.
    pub text: String,
    /// Where the cursor was.
    pub selection: Selection,
}

#[derive(Serialize, Deserialize)]
struct Later {
    when: u64,
    at: usize,
    removed: usize,
    inserted: String,
    selection: Selection,
}

/// What of a document is in its journal.
#[derive(Debug, Default)]
pub struct Journal {
    revision: Option<u64>,
    name: String,
    saved: String,
    text: String,
    records: usize,
}

impl Journal {
    /// What has to be written so that the journal holds the document as it is; none where it does already.
    pub fn note(&mut self, document: &Document, name: &str, when: u64) -> Option<Write> {
        if self.revision == Some(document.revision()) && self.name == name && self.saved == document.saved() {
            return None;
        }
        self.revision = Some(document.revision());
        let goes_on = self.records > 0 && self.records < MOST_RECORDS && self.name == name;
        if goes_on && self.saved == document.saved() {
            let change = difference(&self.text, document.text())?;
            let later = Later {
                when,
                at: change.range.start,
                removed: change.range.len(),
                inserted: change.text,
                selection: document.selection(),
            };
            self.records += 1;
            document.text().clone_into(&mut self.text);
            return Some(Write::More(record(b'+', &later)));
        }
        name.clone_into(&mut self.name);
        document.saved().clone_into(&mut self.saved);
        document.text().clone_into(&mut self.text);
        self.records = 1;
        let whole = Recovered {
            name: name.to_owned(),
            when,
            saved: self.saved.clone(),
            text: self.text.clone(),
            selection: document.selection(),
        };
        Some(Write::Anew([HEAD, &record(b'=', &whole)[..]].concat()))
    }

    /// Whether anything was written since the journal was begun or forgotten.
    #[must_use]
    pub const fn is_begun(&self) -> bool {
        self.records > 0
    }

    /// Forgets what was written: the next note holds everything.
    pub fn forget(&mut self) {
        *self = Self::default();
    }
}

impl Recovered {
    /// The last whole state of a journal; none where not even the first record is whole.
    #[must_use]
    pub fn read(bytes: &[u8]) -> Option<Self> {
        let (_, payload, mut rest) = next_record(bytes.strip_prefix(HEAD)?).filter(|(kind, ..)| *kind == b'=')?;
        let mut state: Self = serde_json::from_slice(payload).ok()?;
        while let Some((b'+', payload, after)) = next_record(rest) {
            let Some(()) = serde_json::from_slice(payload).ok().and_then(|later| state.go_on(&later)) else { break };
            rest = after;
        }
        state.selection = state.selection.within(&state.text);
        Some(state)
    }

    fn go_on(&mut self, later: &Later) -> Option<()> {
        let range = later.at..later.at.checked_add(later.removed)?;
        // Whether it lies in the text, on the borders of characters.
        self.text.get(range.clone())?;
        self.text.replace_range(range, &later.inserted);
        (self.when, self.selection) = (later.when, later.selection);
        Some(())
    }

    /// Whether there is anything to give back.
    #[must_use]
    pub fn is_change(&self) -> bool {
        self.text != self.saved
    }
}

/// `KIND LENGTH CHECK\nPAYLOAD\n`
fn record(kind: u8, payload: &impl Serialize) -> Vec<u8> {
    // Plain structs of texts and numbers always become JSON.
    let payload = serde_json::to_vec(payload).unwrap_or_default();
    let mut bytes = vec![kind];
    bytes.extend(format!(" {} {:016x}\n", payload.len(), check(&payload)).into_bytes());
    bytes.extend(payload);
    bytes.push(b'\n');
    bytes
}

/// The kind and payload of the record that the bytes begin with, and what follows it; none if it is not whole.
fn next_record(bytes: &[u8]) -> Option<(u8, &[u8], &[u8])> {
    let end = bytes.iter().position(|byte| *byte == b'\n')?;
    let head = std::str::from_utf8(&bytes[..end]).ok()?;
    let (kind, numbers) = head.split_once(' ')?;
    let (length, sum) = numbers.split_once(' ')?;
    let (&[kind], length) = (kind.as_bytes(), length.parse::<usize>().ok()?) else { return None };
    let body = &bytes[end + 1..];
    let payload = body.get(..length)?;
    let rest = body[length..].strip_prefix(b"\n")?;
    (u64::from_str_radix(sum, 16) == Ok(check(payload))).then_some((kind, payload, rest))
}

/// FNV-1a with 64 bits (Fowler, Noll and Vo): it finds what is cut off or overwritten by chance, and nothing more is asked.
fn check(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |sum, byte| (sum ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Cause;

    fn written(file: &mut Vec<u8>, write: Option<Write>) {
        match write {
            Some(Write::Anew(bytes)) => *file = bytes,
            Some(Write::More(bytes)) => file.extend(bytes),
            None => {}
        }
    }

    /// A journal of three states, with the length of the file after each.
    fn three_states() -> (Vec<u8>, Vec<(usize, String)>) {
        let (mut document, mut journal) = (Document::new("{}"), Journal::default());
        let (mut file, mut states) = (Vec::new(), Vec::new());
        for (when, text) in ["{ \"a\": 1 }", "{ \"a\": \"é\" }", "{ \"a\": \"€\" }"].into_iter().enumerate() {
            document.rewrite(text, Selection::at(3), Cause::new("Change"));
            written(&mut file, journal.note(&document, "scene.json", when as u64));
            states.push((file.len(), text.to_owned()));
        }
        (file, states)
    }

    #[test]
    fn a_journal_cut_off_anywhere_gives_the_last_whole_state() {
        let (file, states) = three_states();
        for length in 0..=file.len() {
            let expected = states.iter().rev().find(|(end, _)| *end <= length).map(|(_, text)| text.as_str());
            assert_eq!(
                Recovered::read(&file[..length]).as_ref().map(|state| state.text.as_str()),
                expected,
                "{length}"
            );
        }
    }

    #[test]
    fn a_byte_that_is_wrong_ends_the_journal_there() {
        let (file, states) = three_states();
        for place in 0..file.len() {
            let mut damaged = file.clone();
            damaged[place] ^= 0x15;
            let whole = states.iter().rev().find(|(end, _)| *end <= place).map(|(_, text)| text.as_str());
            let read = Recovered::read(&damaged);
            assert_eq!(read.as_ref().map(|state| state.text.as_str()), whole, "{place}");
        }
    }

    #[test]
    fn nothing_is_written_where_nothing_changed() {
        let (mut document, mut journal) = (Document::new("a"), Journal::default());
        document.typed("ab", Selection::at(2), "Type");
        assert!(matches!(journal.note(&document, "x", 1), Some(Write::Anew(_))));
        assert_eq!(journal.note(&document, "x", 2), None);
        document.typed("abc", Selection::at(3), "Type");
        assert!(matches!(journal.note(&document, "x", 3), Some(Write::More(_))));
    }
}
