//! Where the pictures come from that a scene names. Compiling a scene reads no files by itself: it asks for them.

use super::embedded::embedded_file;
use std::borrow::Cow;

/// Gets the files that a scene names.
pub trait Files {
    /// The bytes of the file at `path`, as the scene spells it.
    ///
    /// # Errors
    /// Says why it cannot be had, and what to do about it.
    fn read(&self, path: &str) -> Result<Cow<'static, [u8]>, String>;
}

/// The files that come with the program, from one of its scenes' folders.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EmbeddedFiles {
    folder: String,
}

impl EmbeddedFiles {
    /// The files in the folder of the scene of this name (`textures/image` lies in `textures`).
    #[must_use]
    pub fn of_scene(name: &str) -> Self {
        let folder = name.rsplit_once('/').map_or("", |(folder, _)| folder);
        Self { folder: folder.to_owned() }
    }
}

impl Files for EmbeddedFiles {
    fn read(&self, path: &str) -> Result<Cow<'static, [u8]>, String> {
        let found = embedded_file(&format!("{}/{path}", self.folder));
        found.map(Cow::Borrowed).ok_or_else(|| {
            format!("there is no file `{path}` among those that come with the program in `{}`", self.folder)
        })
    }
}
