//! How a command ends that did not go well: one message, one exit code.

use std::io::{self, ErrorKind, Write};
use std::path::Path;
use std::process::ExitCode;

/// A request was refused, or a result could not be written.
const REFUSED: u8 = 1;
/// The command line or a scene is wrong.
const USAGE: u8 = 2;
/// 128 + SIGINT, as shells report it.
const INTERRUPTED: u8 = 130;
/// 128 + SIGPIPE, as shells report it for tools that are ended by a closed pipe.
const CLOSED_PIPE: u8 = 141;

/// Says something that the user should know though the command goes on.
pub fn warn(message: &str) {
    let _ = writeln!(io::stderr(), "rayscope: {message}");
}

/// Why a command stopped.
#[derive(Debug, PartialEq, Eq)]
pub struct Failure {
    code: u8,
    message: Option<String>,
}

impl Failure {
    /// A request was refused, or a result could not be written.
    pub fn refused(message: impl Into<String>) -> Self {
        Self { code: REFUSED, message: Some(message.into()) }
    }

    /// What was compared differs, which has been said.
    pub const fn differs() -> Self {
        Self { code: REFUSED, message: None }
    }

    /// The command line or a scene is wrong.
    pub fn usage(message: impl Into<String>) -> Self {
        Self { code: USAGE, message: Some(message.into()) }
    }

    /// The user pressed Ctrl-C.
    pub fn interrupted(message: impl Into<String>) -> Self {
        Self { code: INTERRUPTED, message: Some(message.into()) }
    }

    /// The standard output could not be written. If its reader has gone there is nobody to tell.
    pub fn from_stdout(error: &io::Error) -> Self {
        if error.kind() == ErrorKind::BrokenPipe {
            return Self { code: CLOSED_PIPE, message: None };
        }
        Self::refused(format!("cannot write to the standard output: {}", reason(error)))
    }

    /// A file could not be written.
    pub fn from_file(path: &Path, error: &io::Error) -> Self {
        Self::refused(format!("cannot write {}: {}", path.display(), reason(error)))
    }

    /// Says what went wrong and gives the exit code for it.
    pub fn report(self) -> ExitCode {
        if let Some(message) = self.message {
            // With the standard error gone too, the exit code is all that is left to say.
            let _ = writeln!(io::stderr(), "rayscope: {message}");
        }
        ExitCode::from(self.code)
    }
}

/// What the system said, in words.
pub fn reason(error: &io::Error) -> String {
    match error.kind() {
        ErrorKind::NotFound => "no such file".to_owned(),
        ErrorKind::PermissionDenied => "no permission".to_owned(),
        ErrorKind::IsADirectory => "it is a folder, not a file".to_owned(),
        ErrorKind::NotADirectory => "a part of the path is not a folder".to_owned(),
        ErrorKind::StorageFull => "the disk is full".to_owned(),
        ErrorKind::QuotaExceeded => "the disk quota is used up".to_owned(),
        ErrorKind::ReadOnlyFilesystem => "the disk can only be read".to_owned(),
        _ => without_code(&error.to_string()),
    }
}

/// Drops ` (os error 5)` from the end.
fn without_code(message: &str) -> String {
    message.split(" (os error").next().unwrap_or(message).to_lowercase()
}

/// Prints help, the version or a complaint about the arguments.
pub fn report_usage(error: &clap::Error) -> ExitCode {
    match error.print() {
        Ok(()) => ExitCode::from(u8::try_from(error.exit_code()).unwrap_or(USAGE)),
        Err(broken) => Failure::from_stdout(&broken).report(),
    }
}
