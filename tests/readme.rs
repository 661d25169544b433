//! What the README shows is what the program does.

use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

fn file(name: &str) -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(name)).unwrap()
}

fn rayscope(arguments: &[&str], input: &str) -> String {
    let mut child = Command::new(env!("CARGO_BIN_EXE_rayscope"))
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    child.stdin.take().unwrap().write_all(input.as_bytes()).unwrap();
    let output = child.wait_with_output().unwrap();
    assert!(output.status.success(), "{arguments:?}");
    String::from_utf8(output.stdout).unwrap()
}

#[test]
fn the_requests_are_answered_as_shown() {
    let readme = file("README.md");
    let mut lines = readme.lines();
    let mut checked = 0;
    while let Some(line) = lines.next() {
        let Some(request) = line.strip_prefix("    $ echo '").and_then(|line| line.strip_suffix("' | rayscope probe"))
        else {
            continue;
        };
        let shown = lines.next().unwrap().trim_start();
        assert_eq!(rayscope(&["probe"], request).trim_end(), shown);
        checked += 1;
    }
    assert_eq!(checked, 2);
}

#[test]
fn every_line_of_the_shown_trace_is_in_the_real_one() {
    let readme = file("README.md");
    let (_, after) = readme.split_once("    $ rayscope trace csg/bowl --pixel 333,150\n").unwrap();
    let (shown, _) = after.split_once("\n\n").unwrap();
    let real = rayscope(&["trace", "csg/bowl", "--pixel", "333,150"], "");
    let real: Vec<&str> = real.lines().map(str::trim).collect();
    let shown = shown.lines().map(str::trim).filter(|line| *line != "…");
    for line in shown {
        assert!(real.contains(&line), "not in the trace: {line}");
    }
}

#[test]
fn the_example_scene_is_a_scene() {
    let readme = file("README.md");
    let (_, after) = readme.split_once("```json\n").unwrap();
    let (scene, _) = after.split_once("```").unwrap();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("lens.json");
    fs::write(&path, scene).unwrap();
    let trace = rayscope(&["trace", path.to_str().unwrap()], "");
    assert!(trace.contains("✓ hit surface of S₁ in lens") || trace.contains("✓ hit surface of S₂ in lens"), "{trace}");
}

#[test]
fn the_continuous_check_runs_the_readmes_test_command() {
    assert!(file("README.md").contains("All tests run with\n\n    cargo test\n"));
    let run = file(".ci/run");
    assert!(run.contains("\ncargo test\n") && run.ends_with("\nweb/check.sh\n"), "{run}");
}
