//! What is asked for on the command line.

use std::path::PathBuf;

/// What `--help` prints.
pub const HELP: &str = "\
Builds the pages of the rayscope workbench for web hosts.

Usage: cargo run --release --manifest-path web/build/Cargo.toml -- [OPTIONS]

Options:
  -o, --out FOLDER   Where to, `dist` if nothing is said. What an earlier build left there is replaced
      --wasm FILE    A program that is compiled already, instead of compiling it
      --no-compress  Without the variants .br and .gz: faster, for looking at changes to the page
  -h, --help         This
";

/// What is asked for.
#[derive(Debug, PartialEq, Eq)]
pub struct Asked {
    /// The folder to write to.
    pub out: PathBuf,
    /// A program that is compiled already.
    pub wasm: Option<PathBuf>,
    /// Whether compressed variants are written.
    pub is_compressed: bool,
}

/// Reads the arguments; nothing, if help is asked for.
pub fn parse(mut arguments: impl Iterator<Item = String>) -> Result<Option<Asked>, String> {
    let mut asked = Asked { out: "dist".into(), wasm: None, is_compressed: true };
    while let Some(argument) = arguments.next() {
        match argument.as_str() {
            "-h" | "--help" => return Ok(None),
            "--no-compress" => asked.is_compressed = false,
            "-o" | "--out" => asked.out = value(&argument, arguments.next())?,
            "--wasm" => asked.wasm = Some(value(&argument, arguments.next())?),
            _ => return Err(format!("`{argument}` is not an option; --help lists them")),
        }
    }
    Ok(Some(asked))
}

fn value(option: &str, value: Option<String>) -> Result<PathBuf, String> {
    value.map(PathBuf::from).ok_or_else(|| format!("{option} must be followed by a path"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parsed(arguments: &[&str]) -> Result<Option<Asked>, String> {
        parse(arguments.iter().map(|&argument| argument.to_owned()))
    }

    #[test]
    fn without_arguments_everything_is_built_into_dist() {
        assert_eq!(parsed(&[]), Ok(Some(Asked { out: "dist".into(), wasm: None, is_compressed: true })));
    }

    #[test]
    fn a_ready_program_another_folder_and_no_compression_can_be_asked_for() {
        let asked = Asked { out: "elsewhere".into(), wasm: Some("a.wasm".into()), is_compressed: false };
        assert_eq!(parsed(&["--wasm", "a.wasm", "-o", "elsewhere", "--no-compress"]), Ok(Some(asked)));
    }

    #[test]
    fn what_is_not_understood_is_named() {
        assert!(parsed(&["--fast"]).is_err_and(|error| error.contains("`--fast`")));
        assert!(parsed(&["-o"]).is_err_and(|error| error.contains("-o")));
    }
}
