//! `rayscope accuracy --map` through the real binary.

use std::process::{Command, Output, Stdio};

fn accuracy(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_rayscope"));
    command.args(["accuracy", "hello/sphere", "--width", "24"]).args(arguments).stdin(Stdio::null()).output().unwrap()
}

#[test]
fn each_map_is_drawn_with_its_legend() {
    let folder = tempfile::tempdir().unwrap();
    for (kind, more, telling) in [
        ("error", &["--no-cache", "--budget", "1s"][..], "largest difference of a channel"),
        ("digits", &[], "digits"),
        ("tier", &[], "certain"),
        ("time", &["--theme", "dark"], "ns"),
    ] {
        let file = folder.path().join(format!("{kind}.svg"));
        let path = file.to_str().unwrap();
        let output = accuracy(&[&["--map", kind, "-o", path], more].concat());
        assert!(output.status.success(), "{kind}: {}", String::from_utf8_lossy(&output.stderr));
        let drawn = std::fs::read_to_string(&file).unwrap();
        assert!(drawn.starts_with("<svg") && drawn.contains(telling), "{kind}");
    }
}

#[test]
fn a_map_without_a_file_to_draw_it_in_is_refused() {
    for arguments in [&["--map", "tier"][..], &["--map", "tier", "-o", "map.txt"]] {
        let output = accuracy(arguments);
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{message}");
        assert!(message.contains(".svg or .png"), "{message}");
    }
}
