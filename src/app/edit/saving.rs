//! Writing scenes to files, on a thread, whole or not at all.

use crate::app::edit::dialog::Then;
use crate::app::frame::background::Background;
use crate::app::system::{self, NoDialogue};
use crate::folder::{Outside, files_of_scene};
use egui::Context;
use serde_json::Value;
use std::fs;
use std::path::{Component, Path, PathBuf};
use std::sync::mpsc::{Receiver, TryRecvError, channel};

/// A file that is to be written.
#[derive(Clone, Debug)]
pub struct Order {
    /// Where.
    pub path: PathBuf,
    /// What.
    pub text: String,
    /// What is there, as far as we know: if another program has changed it, nothing is written.
    pub expected: Option<String>,
    /// The scene that it is a copy of, with the names of the pictures that it needs beside it.
    pub copy_of: Option<(String, Vec<String>)>,
}

/// What became of an order.
#[derive(Clone, Debug)]
pub struct Written {
    /// Where.
    pub path: PathBuf,
    /// What.
    pub text: String,
    /// Why it was not written, if it was not.
    pub outcome: Result<(), Refusal>,
}

/// Why a file was not written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Refusal {
    /// Another program has changed it.
    Changed,
    /// The system says why.
    System(String),
}

/// At most one file and one dialogue.
#[derive(Default)]
pub struct Saving {
    job: Option<Background<Written>>,
    dialogue: Option<Receiver<Result<Option<PathBuf>, NoDialogue>>>,
    /// What is to be done when the file is written.
    pub then: Option<Then>,
}

/// What became of the dialogue that asks where to save.
pub enum Place {
    /// Nothing yet.
    Waiting,
    /// It was closed.
    Closed,
    /// The system shows none.
    Missing,
    /// A file was chosen.
    File(PathBuf),
}

impl Saving {
    /// Begins to write a file.
    pub fn start(&mut self, ctx: &Context, order: Order) {
        self.job = Background::start(ctx, "save", move |_, publish| {
            let outcome = order.write();
            publish(Written { path: order.path, text: order.text, outcome });
        });
    }

    /// What was written, once.
    pub fn take(&mut self) -> Option<Written> {
        let written = self.job.as_ref()?.take()?;
        self.job = None;
        Some(written)
    }

    /// Asks where to write, unless it is being asked already.
    pub fn ask(&mut self, ctx: &Context, title: String, name: &str) {
        if self.dialogue.is_some() {
            return;
        }
        let (sender, receiver) = channel();
        let (ctx, name) = (ctx.clone(), name.to_owned());
        let ask = move || {
            // The window may have gone away meanwhile; then nobody waits for this.
            let _ = sender.send(system::ask_where(Some(title), &name, "json"));
            ctx.request_repaint();
        };
        self.dialogue = system::begin("save dialogue", ask).then_some(receiver);
    }

    /// What was chosen in the dialogue, once.
    pub fn chosen(&mut self) -> Place {
        let place = match self.dialogue.as_ref().map(Receiver::try_recv) {
            None | Some(Err(TryRecvError::Empty)) => return Place::Waiting,
            Some(Ok(Ok(Some(path)))) => Place::File(path),
            Some(Ok(Err(NoDialogue))) => Place::Missing,
            Some(Ok(Ok(None)) | Err(TryRecvError::Disconnected)) => Place::Closed,
        };
        self.dialogue = None;
        place
    }
}

impl Order {
    /// Writes a file beside the old one and then puts it in its place, so that at no moment there is only half of it.
    fn write(&self) -> Result<(), Refusal> {
        let refused = |error: std::io::Error| Refusal::System(error.to_string());
        // What a link leads to is replaced, not the link.
        let path = self.path.canonicalize().unwrap_or_else(|_| self.path.clone());
        if let Some(expected) = &self.expected
            && fs::read_to_string(&path).is_ok_and(|there| there != *expected)
        {
            return Err(Refusal::Changed);
        }
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        system::replace(&path, self.text.as_bytes()).map_err(refused)?;
        self.copy_pictures(folder).map_err(Refusal::System)
    }

    /// Writes the pictures of the original beside its copy, except those that are there.
    fn copy_pictures(&self, folder: &Path) -> Result<(), String> {
        let Some((original, names)) = &self.copy_of else { return Ok(()) };
        let files = files_of_scene(original, Outside::Refused);
        for name in names {
            let path = Path::new(name);
            let stays_inside = path.components().all(|part| matches!(part, Component::Normal(_) | Component::CurDir));
            let target = folder.join(path);
            if !stays_inside || target.exists() {
                continue;
            }
            let bytes = files.read(name)?;
            let written = system::write_with_folders(&target, &bytes);
            written.map_err(|error| format!("{}: {error}", target.display()))?;
        }
        Ok(())
    }
}

/// The names of all pictures that a scene's values refer to.
#[must_use]
pub fn pictures_of(whole: &Value) -> Vec<String> {
    let mut found = Vec::new();
    collect(whole, &mut found);
    found
}

fn collect(value: &Value, found: &mut Vec<String>) {
    match value {
        Value::Array(items) => items.iter().for_each(|item| collect(item, found)),
        Value::Object(fields) => {
            for (name, value) in fields {
                match value {
                    Value::String(file) if name == "file" && !found.contains(file) => found.push(file.clone()),
                    value => collect(value, found),
                }
            }
        }
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn order(path: PathBuf, text: &str, expected: Option<&str>) -> Order {
        Order { path, text: text.to_owned(), expected: expected.map(str::to_owned), copy_of: None }
    }

    #[test]
    fn a_file_is_replaced_only_where_nobody_else_changed_it() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("scene.json");
        assert_eq!(order(path.clone(), "one", None).write(), Ok(()));
        assert_eq!(order(path.clone(), "two", Some("one")).write(), Ok(()));
        fs::write(&path, "theirs").unwrap();
        assert_eq!(order(path.clone(), "three", Some("two")).write(), Err(Refusal::Changed));
        assert_eq!(fs::read_to_string(&path).unwrap(), "theirs");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1, "nothing else is left in the folder");
    }

    #[test]
    fn a_folder_that_is_not_there_is_named_as_the_reason() {
        let path = Path::new("no/such/folder/scene.json").to_owned();
        assert!(matches!(order(path, "x", None).write(), Err(Refusal::System(_))));
    }

    #[test]
    fn a_copy_of_a_scene_takes_its_pictures_along() {
        let name = "textures/image_map";
        let text = crate::scene::embedded_scene(name).unwrap().text;
        let pictures = pictures_of(&serde_json::from_str(text).unwrap());
        assert!(!pictures.is_empty());
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("mine.json");
        let mut order = order(path.clone(), text, None);
        order.copy_of = Some((name.to_owned(), pictures));
        assert_eq!(order.write(), Ok(()));
        let path = path.to_str().unwrap();
        assert!(crate::scene::load_with(text, path, files_of_scene(path, Outside::Refused).as_ref()).is_ok());
    }
}
