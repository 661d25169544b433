//! A file that a person chose or dropped.

use std::path::Path;

/// For those who name the file that cannot be read.
const NO_DIALOGUE: &str =
    "no file dialogue can be shown: it needs xdg-desktop-portal with a backend for the desktop, or zenity";

/// A file that was chosen in a dialogue or dropped on the window.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picked {
    /// Its path; in a browser, which tells no more, its name.
    pub name: String,
    /// What is in it, or why that cannot be read; none where it can be read by its path.
    pub text: Option<Result<String, Unread>>,
}

/// Why a file is no text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Unread {
    /// What is in it is no UTF-8.
    NoText,
    /// The system says why.
    System(String),
    /// None could be chosen: the system shows no dialogue.
    #[cfg_attr(target_arch = "wasm32", expect(dead_code, reason = "a browser always has one"))]
    NoDialogue,
}

/// The system shows no dialogue in which a file could be chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NoDialogue;

impl Picked {
    /// A file with what was read of it.
    pub fn read(name: String, bytes: Result<Vec<u8>, String>) -> Self {
        let text = bytes.map_err(Unread::System).and_then(|bytes| String::from_utf8(bytes).map_err(|_| Unread::NoText));
        Self { name, text: Some(text) }
    }

    /// What is in it.
    ///
    /// # Errors
    /// Why it cannot be read.
    pub fn whole(&self) -> Result<String, String> {
        match &self.text {
            None => std::fs::read_to_string(&self.name).map_err(|error| error.to_string()),
            Some(Ok(text)) => Ok(text.clone()),
            Some(Err(Unread::NoText)) => Err("it is no text".to_owned()),
            Some(Err(Unread::System(error))) => Err(error.clone()),
            Some(Err(Unread::NoDialogue)) => Err(NO_DIALOGUE.to_owned()),
        }
    }

    /// Whether its name ends so.
    pub fn ends_in(&self, ending: &str) -> bool {
        Path::new(&self.name).extension().is_some_and(|own| own == ending)
    }
}
