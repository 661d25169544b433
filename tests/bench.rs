//! `rayscope bench` through the real binary.

use serde_json::Value;
use std::path::Path;
use std::process::{Command, Output, Stdio};

fn bench(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_rayscope"));
    let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/peers");
    command.args(["bench", "--peer", "povray", "--repeats", "1", "--width", "64", "--scenes"]).arg(scenes);
    command.args(arguments).stdin(Stdio::null()).output().unwrap()
}

#[test]
fn each_scene_is_timed_by_both_and_the_pictures_compared() {
    let output = bench(&["--scene", "d_csg", "--scene", "b_tori", "--format", "json"]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let result: Value = serde_json::from_slice(&output.stdout).unwrap();
    let scenes = result["scenes"].as_array().unwrap();
    let names: Vec<_> = scenes.iter().map(|scene| scene["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["b_tori", "d_csg"]);
    let installed = !result["povray"].is_null();
    for scene in scenes {
        assert!(scene["rayscope_s"].as_f64().unwrap() > 0.0, "{scene}");
        assert!(scene["rays"].as_u64().unwrap() >= 64 * 48, "{scene}");
        for field in ["povray_s", "agree"] {
            assert_eq!(scene[field].is_number(), installed, "{scene}");
        }
        assert!(!installed || scene["agree"].as_f64().unwrap() == 1.0, "{scene}");
    }
    if !installed {
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(said.contains("apt-get install povray") && said.contains("povray.org/download"), "{said}");
    }
}

#[test]
fn without_pov_ray_it_says_how_to_get_it_and_times_the_rest() {
    let mut command = Command::new(env!("CARGO_BIN_EXE_rayscope"));
    let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/peers");
    let empty = tempfile::tempdir().unwrap();
    command.args(["bench", "--peer", "povray", "--repeats", "1", "--width", "16", "--scene", "d_csg", "--scenes"]);
    let output = command.arg(scenes).env("PATH", empty.path()).stdin(Stdio::null()).output().unwrap();
    let (said, table) = (String::from_utf8_lossy(&output.stderr), String::from_utf8_lossy(&output.stdout));
    assert!(output.status.success() && said.contains("apt-get install povray"), "{said}");
    let row: Vec<&str> = table.lines().nth(1).unwrap().split_whitespace().collect();
    assert_eq!((row[0], row[1], row[2], row[4]), ("d_csg", "–", "–", "–"));
    assert!(row[3].parse::<f64>().is_ok());
}

#[test]
fn a_scene_that_is_not_there_is_answered_with_those_that_are() {
    let output = bench(&["--scene", "z_none"]);
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2));
    assert!(said.contains("no scene `z_none`") && said.contains("a_spheres, b_tori"), "{said}");
}
