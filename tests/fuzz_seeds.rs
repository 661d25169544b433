//! What fuzzing found, and seeds that reach far into the program, replayed: no panic, no hang, no nonsense in the answers.

#[path = "fuzz_seeds/probe_rules.rs"]
mod probe_rules;
#[path = "fuzz_seeds/scene_rules.rs"]
mod scene_rules;

use std::path::{Path, PathBuf};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

/// The longest that a seed may take. All take milliseconds; a busy machine is slow, and a hang has no end.
const LONGEST: Duration = Duration::from_secs(20);

/// Every file of a folder of seeds, by name.
fn seeds(folder: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fuzz_seeds").join(folder);
    let mut files: Vec<_> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.sort();
    assert!(!files.is_empty());
    files
}

/// Runs the check on each seed, on a thread of its own with a stack like that of the program's workers.
fn replay(folder: &str, check: fn(&[u8]) -> Result<(), String>) {
    for file in seeds(folder) {
        let bytes = std::fs::read(&file).unwrap();
        let (answer, outcome) = channel();
        thread::spawn(move || answer.send(check(&bytes)));
        let name = file.file_name().unwrap().to_string_lossy();
        match outcome.recv_timeout(LONGEST) {
            Ok(Ok(())) => {}
            Ok(Err(problem)) => panic!("{name}: {problem}"),
            Err(RecvTimeoutError::Timeout) => panic!("{name} takes longer than {LONGEST:?}"),
            Err(RecvTimeoutError::Disconnected) => panic!("{name} panics"),
        }
    }
}

#[test]
fn requests_are_answered_in_time_and_with_numbers() {
    replay("probe", probe_rules::check_probe);
}

#[test]
fn scene_files_are_loaded_and_traced_in_time_and_with_numbers() {
    replay("scene", scene_rules::check_scene);
}
