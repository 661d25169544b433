//! The files beside a scene file on disk. A scene may come from anywhere, so it reads nothing outside its own folder unless
//! whoever opens it says so.

use crate::scene::{EmbeddedFiles, Files};
use std::borrow::Cow;
use std::fs;
use std::path::{Path, PathBuf};

/// The files that the scene of this name may have: those in its folder, or those that come with the program.
#[must_use]
pub fn files_of_scene(name: &str, outside: Outside) -> Box<dyn Files> {
    let path = Path::new(name);
    if path.is_file() {
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        Box::new(FolderFiles { folder: folder.to_owned(), outside })
    } else {
        Box::new(EmbeddedFiles::of_scene(name))
    }
}

/// Whether a scene may name files outside its folder.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Outside {
    /// No: they are refused.
    #[default]
    Refused,
    /// Yes.
    Allowed,
}

/// The files in the folder of a scene file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FolderFiles {
    folder: PathBuf,
    outside: Outside,
}

/// The largest file that is read, in bytes. More would fill the memory before anything is known of what it holds; fewer
/// would refuse large panoramas.
const LARGEST: u64 = 1 << 30;

impl Files for FolderFiles {
    fn read(&self, path: &str) -> Result<Cow<'static, [u8]>, String> {
        let full = self.folder.join(path);
        let cannot = |error: std::io::Error| format!("cannot read the file {}: {error}", full.display());
        // Links are followed first, so that none leads out of the folder unseen.
        let real = full.canonicalize().map_err(cannot)?;
        let folder = self.folder.canonicalize().map_err(cannot)?;
        if self.outside == Outside::Refused && !real.starts_with(&folder) {
            return Err(format!(
                "the file {} lies outside the scene's folder {}; copy it there, or allow it with --allow-outside-files",
                real.display(),
                folder.display()
            ));
        }
        let size = fs::metadata(&real).map_err(cannot)?.len();
        if size > LARGEST {
            return Err(format!("the file {} has {size} bytes; at most {LARGEST} are read", full.display()));
        }
        fs::read(&real).map(Cow::Owned).map_err(cannot)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A folder with a scene's folder in it, and a file in each.
    fn folders() -> tempfile::TempDir {
        let outer = tempfile::tempdir().expect("a folder for the test");
        fs::create_dir(outer.path().join("scene")).expect("a folder");
        fs::write(outer.path().join("scene/inside.png"), b"in").expect("a file");
        fs::write(outer.path().join("outside.png"), b"out").expect("a file");
        outer
    }

    fn read(outer: &tempfile::TempDir, path: &str, outside: Outside) -> Result<Vec<u8>, String> {
        let files = FolderFiles { folder: outer.path().join("scene"), outside };
        files.read(path).map(Cow::into_owned)
    }

    #[test]
    fn files_in_the_folder_are_read_and_those_outside_are_refused() {
        let outer = folders();
        assert_eq!(read(&outer, "inside.png", Outside::Refused), Ok(b"in".to_vec()));
        assert_eq!(read(&outer, "./../scene/inside.png", Outside::Refused), Ok(b"in".to_vec()));
        let absolute = outer.path().join("outside.png");
        for path in ["../outside.png", absolute.to_str().expect("a path in UTF-8")] {
            let refused = read(&outer, path, Outside::Refused).unwrap_err();
            assert!(
                refused.contains("outside the scene's folder") && refused.contains("--allow-outside-files"),
                "{refused}"
            );
            assert_eq!(read(&outer, path, Outside::Allowed), Ok(b"out".to_vec()));
        }
    }

    #[cfg(unix)]
    #[test]
    fn a_link_does_not_lead_out_of_the_folder() {
        let outer = folders();
        std::os::unix::fs::symlink("../outside.png", outer.path().join("scene/link.png")).expect("a link");
        assert!(read(&outer, "link.png", Outside::Refused).unwrap_err().contains("outside the scene's folder"));
    }

    #[test]
    fn a_missing_file_is_named() {
        let missing = read(&folders(), "gone.png", Outside::Refused).unwrap_err();
        assert!(missing.contains("gone.png"), "{missing}");
    }
}
