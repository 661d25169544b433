//! The files that the page is made of, as they are in the repository.

use std::path::{Path, PathBuf};

/// A file of the page.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File {
    /// Where it is below the page's folder, with `/` between.
    pub path: String,
    /// What is in it.
    pub bytes: Vec<u8>,
}

impl File {
    /// A file.
    pub const fn new(path: String, bytes: Vec<u8>) -> Self {
        Self { path, bytes }
    }
}

/// The folder `web` of the repository that this was compiled in.
pub fn web_folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().map(Path::to_owned).unwrap_or_default()
}

/// The page, and the examples of how others embed it.
pub fn page(web: &Path) -> Result<Vec<File>, String> {
    let mut files = Vec::new();
    collect(&web.join("page"), "", &mut files)?;
    collect(&web.join("examples"), "examples/", &mut files)?;
    Ok(files)
}

/// In the order of their names, so that the same files give the same pages everywhere.
fn collect(folder: &Path, prefix: &str, files: &mut Vec<File>) -> Result<(), String> {
    let told = |error: std::io::Error| format!("{} cannot be read: {error}", folder.display());
    let mut entries = std::fs::read_dir(folder).map_err(told)?.collect::<Result<Vec<_>, _>>().map_err(told)?;
    entries.sort_by_key(std::fs::DirEntry::file_name);
    for entry in entries {
        let name = format!("{prefix}{}", entry.file_name().to_string_lossy());
        if entry.path().is_dir() {
            collect(&entry.path(), &format!("{name}/"), files)?;
        } else {
            files.push(File::new(name, std::fs::read(entry.path()).map_err(told)?));
        }
    }
    Ok(())
}
