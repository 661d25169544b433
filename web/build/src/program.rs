//! Compiles the program to WebAssembly.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

const TARGET: &str = "wasm32-unknown-unknown";

/// Compiles the program and reads it.
pub fn compile(web: &Path) -> Result<Vec<u8>, String> {
    let root = web.parent().ok_or("the folder web has no parent")?;
    check_version(&root.join("Cargo.lock"))?;
    check_target()?;
    let wasm = run_cargo(root)?;
    std::fs::read(&wasm).map_err(|error| format!("{} was compiled but cannot be read: {error}", wasm.display()))
}

/// The bindings are made by a library that understands exactly one version of what it finds in the program.
fn check_version(lock: &Path) -> Result<(), String> {
    let text = std::fs::read_to_string(lock).map_err(|error| format!("{} cannot be read: {error}", lock.display()))?;
    let pinned =
        pinned(include_str!("../Cargo.toml")).ok_or("web/build/Cargo.toml pins no wasm-bindgen-cli-support")?;
    match locked(&text, "wasm-bindgen") {
        Some(version) if version == pinned => Ok(()),
        Some(version) => Err(format!(
            "{} has wasm-bindgen {version}, and web/build makes bindings for {pinned}: write wasm-bindgen-cli-support = \
             \"={version}\" into web/build/Cargo.toml and build again",
            lock.display()
        )),
        None => Err(format!("{} has no wasm-bindgen, which the program in the browser needs", lock.display())),
    }
}

/// The version that our own Cargo.toml asks for.
fn pinned(manifest: &str) -> Option<&str> {
    let line = manifest.lines().find(|line| line.starts_with("wasm-bindgen-cli-support"))?;
    line.split('"').nth(1)?.strip_prefix('=')
}

/// The version of a package in a Cargo.lock.
fn locked<'a>(lock: &'a str, package: &str) -> Option<&'a str> {
    let name = format!("name = \"{package}\"");
    let mut lines = lock.lines().skip_while(|line| *line != name);
    lines.nth(1)?.split('"').nth(1)
}

fn check_target() -> Result<(), String> {
    let asked = Command::new("rustc").args(["--print", "target-libdir", "--target", TARGET]).output();
    let answer = asked.map_err(|error| format!("rustc cannot be run: {error}"))?;
    let folder = PathBuf::from(String::from_utf8_lossy(&answer.stdout).trim());
    if answer.status.success() && folder.is_dir() {
        return Ok(());
    }
    Err(format!("the Rust toolchain has no standard library for {TARGET}: `rustup target add {TARGET}` installs it"))
}

/// Runs cargo; the path of what it compiled is in the messages that it writes for programs.
fn run_cargo(root: &Path) -> Result<PathBuf, String> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut command = Command::new(cargo);
    command.args(["build", "--profile", "web", "--target", TARGET, "--bin", "rayscope"]);
    command.arg("--message-format=json-render-diagnostics").current_dir(root).stderr(Stdio::inherit());
    let built = command.output().map_err(|error| format!("cargo cannot be run: {error}"))?;
    if !built.status.success() {
        return Err("the program could not be compiled; the reason is above".to_owned());
    }
    artefact(&String::from_utf8_lossy(&built.stdout))
        .ok_or_else(|| "cargo compiled the program but does not say where to".to_owned())
}

fn artefact(messages: &str) -> Option<PathBuf> {
    const NAME: &str = "rayscope.wasm";
    let end = messages.rfind(&format!("{NAME}\""))? + NAME.len();
    let start = messages[..end].rfind('"')? + 1;
    Some(PathBuf::from(messages[start..end].replace("\\\\", "\\")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_version_that_is_locked_is_found_by_the_whole_name() {
        let lock = "[[package]]\nname = \"wasm-bindgen-futures\"\nversion = \"0.4.1\"\n\n[[package]]\n\
                    name = \"wasm-bindgen\"\nversion = \"0.2.130\"\n";
        assert_eq!(locked(lock, "wasm-bindgen"), Some("0.2.130"));
        assert_eq!(locked(lock, "wasm"), None);
    }

    #[test]
    fn our_own_manifest_pins_the_version() {
        assert!(pinned(include_str!("../Cargo.toml")).is_some_and(|version| version.starts_with("0.2.")));
    }

    #[test]
    fn the_compiled_program_is_found_in_what_cargo_says() {
        let messages = "{\"reason\":\"compiler-artifact\",\"filenames\":[\"/a/web/librayscope.rlib\"]}\n\
                        {\"reason\":\"compiler-artifact\",\"filenames\":[\"/a/web/rayscope.wasm\"]}\n";
        assert_eq!(artefact(messages), Some(PathBuf::from("/a/web/rayscope.wasm")));
        assert_eq!(artefact("{\"reason\":\"build-finished\"}"), None);
    }
}
