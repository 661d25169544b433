//! `rayscope accuracy --map` through the real binary.

use std::process::{Command, Output, Stdio};

fn accuracy(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_rayscope"));
    command.args(["accuracy", "hello/sphere", "--width", "24"]).args(arguments).stdin(Stdio::null()).output().unwrap()
}

fn text(bytes: Vec<u8>) -> String {
    String::from_utf8(bytes).unwrap()
}

#[test]
fn each_map_is_drawn_with_its_legend() {
    for (kind, telling) in
        [("error", "largest difference of a channel"), ("digits", "digits"), ("tier", "certain"), ("time", "ns")]
    {
        let [light, dark] = ["light", "dark"].map(|theme| accuracy(&["--map", kind, "--theme", theme]));
        assert!(light.status.success(), "{kind}: {}", text(light.stderr));
        let drawn = text(light.stdout);
        assert!(drawn.starts_with("<svg") && drawn.contains(telling), "{kind}");
        assert_ne!(drawn, text(dark.stdout), "{kind}");
    }
}

#[test]
fn a_file_that_ends_in_png_holds_pixels() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("tier.png");
    let output = accuracy(&["--map", "tier", "-o", file.to_str().unwrap()]);
    assert!(output.status.success(), "{}", text(output.stderr));
    assert!(std::fs::read(&file).unwrap().starts_with(b"\x89PNG"));
}

#[test]
fn single_precision_loses_more_digits_than_the_scene_as_it_stands() {
    let folder = tempfile::tempdir().unwrap();
    let profile = folder.path().join("single.json");
    std::fs::write(&profile, r#"{ "arithmetic": "f32" }"#).unwrap();
    let single = accuracy(&["--map", "digits", "--accuracy", profile.to_str().unwrap()]);
    assert!(single.status.success(), "{}", text(single.stderr));
    assert!(text(single.stdout).contains("Digits lost, f32"));
    assert!(text(accuracy(&["--map", "digits"]).stdout).contains("Digits lost, adaptive"));
}
