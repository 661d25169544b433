//! Where results go: the standard output, or a file that is written whole or not at all.

use super::failure::Failure;
use std::fs::{self, File};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};
use tempfile::NamedTempFile;

/// An open destination. It is opened before the work begins, so that a wrong path is found out at once.
#[derive(Debug)]
pub enum Output {
    /// The standard output.
    Standard,
    /// A device or named pipe: nothing that could be put in place of another.
    Device(File, PathBuf),
    /// A new file beside the one that it will replace.
    File(NamedTempFile, PathBuf),
}

impl Output {
    /// Opens a destination; none, or `-`, is the standard output.
    pub fn create(path: Option<&Path>) -> Result<Self, Failure> {
        let Some(path) = path.filter(|path| *path != Path::new("-")) else { return Ok(Self::Standard) };
        open(path).map_err(|error| match missing_folder(path) {
            Some(folder) if error.kind() == ErrorKind::NotFound => {
                Failure::refused(format!("cannot write {}: there is no folder {}", path.display(), folder.display()))
            }
            _ => Failure::from_file(path, &error),
        })
    }

    /// Whether it is a person who would read it.
    pub fn is_terminal(&self) -> bool {
        matches!(self, Self::Standard) && io::IsTerminal::is_terminal(&io::stdout())
    }

    /// Writes everything, or leaves what was there before.
    pub fn write(self, bytes: &[u8]) -> Result<(), Failure> {
        match self {
            Self::Standard => {
                let mut output = io::stdout().lock();
                output.write_all(bytes).and_then(|()| output.flush()).map_err(|error| Failure::from_stdout(&error))
            }
            Self::Device(mut file, path) => match file.write_all(bytes) {
                Err(error) if error.kind() == ErrorKind::BrokenPipe => Err(Failure::from_stdout(&error)),
                written => written.map_err(|error| Failure::from_file(&path, &error)),
            },
            Self::File(mut file, path) => file
                .write_all(bytes)
                .and_then(|()| file.as_file().sync_all())
                .and_then(|()| file.persist(&path).map_err(io::Error::from))
                .map(|_| ())
                .map_err(|error| Failure::from_file(&path, &error)),
        }
    }
}

fn open(path: &Path) -> io::Result<Output> {
    match fs::metadata(path) {
        Ok(found) if found.is_dir() => Err(ErrorKind::IsADirectory.into()),
        // What is written through a link belongs into the file that it leads to.
        Ok(found) if found.is_file() => beside(&fs::canonicalize(path)?),
        Ok(_) => Ok(Output::Device(File::options().write(true).open(path)?, path.to_owned())),
        Err(_) if path.file_name().is_none() => Err(ErrorKind::IsADirectory.into()),
        Err(_) => beside(path),
    }
}

fn beside(path: &Path) -> io::Result<Output> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".rayscope-");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        // As any other new file: the umask takes away what the user wants taken away.
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    Ok(Output::File(builder.tempfile_in(folder_of(path))?, path.to_owned()))
}

fn folder_of(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

fn missing_folder(path: &Path) -> Option<&Path> {
    Some(folder_of(path)).filter(|folder| !folder.is_dir())
}
