//! References from one run to the next: files in a folder, named by what they are of.

use super::super::failure::{Failure, warn};
use super::super::scene_argument::SceneArgument;
use crate::folder::files_of_scene;
use crate::laboratory::{Store, checksum};
use crate::scene::{Files, Scene, load_with};
use std::borrow::Cow;
use std::cell::Cell;
use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::UNIX_EPOCH;

/// The folder, if there is one, and the scene whose references it keeps.
pub struct Cache {
    folder: Option<PathBuf>,
    /// The scene and the program: what else a reference depends on.
    origin: String,
}

impl Cache {
    /// The cache in this folder, or in the user's own.
    pub fn open(folder: Option<&Path>, is_off: bool, identity: u64) -> Self {
        let folder = folder.map(Path::to_owned).or_else(users_folder).filter(|_| !is_off);
        Self { folder, origin: format!("scene {identity:016x}, {}", program()) }
    }

    fn path(&self, name: &str) -> Option<PathBuf> {
        let file = format!("{:016x}.reference", checksum(format!("{}, {name}", self.origin).as_bytes()));
        self.folder.as_ref().map(|folder| folder.join(file))
    }
}

impl Store for Cache {
    fn load(&mut self, name: &str) -> Option<Vec<u8>> {
        fs::read(self.path(name)?).ok()
    }

    fn save(&mut self, name: &str, bytes: &[u8]) {
        let (Some(folder), Some(path)) = (&self.folder, self.path(name)) else { return };
        let save = || {
            fs::create_dir_all(folder)?;
            let file = tempfile::NamedTempFile::new_in(folder)?;
            fs::write(file.path(), bytes)?;
            file.persist(&path).map_err(std::io::Error::from)
        };
        if let Err(error) = save() {
            warn(&format!("the reference was not kept in {}: {error}", folder.display()));
        }
    }
}

/// The folder for caches: as the XDG Base Directory Specification says, or as Windows does.
fn users_folder() -> Option<PathBuf> {
    let variable = |name: &str| env::var_os(name).filter(|value| !value.is_empty()).map(PathBuf::from);
    let folder = variable("XDG_CACHE_HOME").filter(|folder| folder.is_absolute());
    let folder = folder.or_else(|| variable("LOCALAPPDATA")).or_else(|| Some(variable("HOME")?.join(".cache")));
    folder.map(|folder| folder.join("rayscope"))
}

/// The program: its version, and the time and the size of its file, for a program under work keeps its version.
fn program() -> String {
    let file = env::current_exe().and_then(fs::metadata).ok();
    let size = file.as_ref().map_or(0, fs::Metadata::len);
    let time = file.and_then(|file| file.modified().ok()).and_then(|time| time.duration_since(UNIX_EPOCH).ok());
    format!("version {}, {size} bytes of {}", env!("CARGO_PKG_VERSION"), time.map_or(0, |time| time.as_secs()))
}

/// Files whose bytes are added to a checksum when they are read.
struct Watched {
    files: Box<dyn Files>,
    sum: Cell<u64>,
}

impl Files for Watched {
    fn read(&self, path: &str) -> Result<Cow<'static, [u8]>, String> {
        let bytes = self.files.read(path)?;
        self.sum.set(chained(self.sum.get(), &bytes));
        Ok(bytes)
    }
}

fn chained(sum: u64, bytes: &[u8]) -> u64 {
    sum.rotate_left(1) ^ checksum(bytes)
}

/// The scene, and a number for its text and for all files that it names.
pub fn load_identified(argument: &SceneArgument) -> Result<(Scene, u64), Failure> {
    let text = argument.text()?;
    let sum = Cell::new(checksum(text.as_bytes()));
    let files = Watched { files: files_of_scene(argument.name(), argument.outside()), sum };
    let scene = load_with(&text, argument.name(), &files)
        .map_err(|errors| Failure::usage(format!("the scene {} cannot be used\n{errors}", argument.name())))?;
    Ok((scene, files.sum.get()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_saved_is_loaded_again_by_the_same_scene_alone() {
        let folder = tempfile::tempdir().unwrap();
        let cache = |identity| Cache::open(Some(folder.path()), false, identity);
        cache(1).save("small", b"colours");
        assert_eq!(cache(1).load("small").as_deref(), Some(&b"colours"[..]));
        assert_eq!([cache(1).load("large"), cache(2).load("small")], [None, None]);
    }

    #[test]
    fn nothing_is_kept_where_nothing_is_to_be_kept() {
        let folder = tempfile::tempdir().unwrap();
        let mut cache = Cache::open(Some(folder.path()), true, 1);
        cache.save("small", b"colours");
        assert_eq!(cache.load("small"), None);
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
    }

    #[test]
    fn a_scene_with_another_picture_is_another_scene() {
        let folder = tempfile::tempdir().unwrap();
        let scene = folder.path().join("scene.json");
        fs::write(
            &scene,
            r#"{"materials": {"m": {"texture": {"kind": "image", "file": "p.png"}}},
                "objects": [{"shape": "sphere", "material": "m"}]}"#,
        )
        .unwrap();
        let identity = |grey: u8| {
            image::GrayImage::from_pixel(2, 2, image::Luma([grey])).save(folder.path().join("p.png")).unwrap();
            load_identified(&SceneArgument::named(scene.to_str().unwrap())).unwrap().1
        };
        assert_ne!(identity(0), identity(255));
        assert_eq!(identity(7), identity(7));
    }
}
