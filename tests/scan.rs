//! `rayscope scan` through the real binary.

use serde_json::Value;
use std::fs;
use std::process::{Command, Output, Stdio};

fn scan(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_rayscope"));
    command.arg("scan").args(arguments).stdin(Stdio::null()).output().unwrap()
}

fn data(arguments: &[&str]) -> Value {
    let output = scan(&[arguments, &["--format", "json"]].concat());
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).unwrap()
}

fn painted(order: &Value) -> Vec<u64> {
    order["painted"].as_array().unwrap().iter().map(|times| times.as_u64().unwrap()).collect()
}

/// The complaint of a scan that is refused.
fn complaint(arguments: &[&str]) -> String {
    let output = scan(arguments);
    assert_eq!(output.status.code(), Some(2), "{arguments:?}");
    assert!(output.stdout.is_empty(), "{arguments:?}");
    String::from_utf8(output.stderr).unwrap()
}

#[test]
fn texture_scanning_leaves_holes_and_overlaps_and_inverse_scanning_neither() {
    let data = data(&["textures/scanning"]);
    assert_eq!(data["pixels"], serde_json::json!([48, 36]));
    let [forward, inverse] = ["forward", "inverse"].map(|order| painted(&data[order]));
    let (holes, overlaps) = (data["forward"]["holes"].as_u64().unwrap(), data["forward"]["overlaps"].as_u64().unwrap());
    assert!(holes > 100 && overlaps > 100, "{holes} holes, {overlaps} overlaps");
    assert_eq!((&data["inverse"]["holes"], &data["inverse"]["overlaps"]), (&0.into(), &0.into()));
    // The counts are those of the pixels, and every texel is carried somewhere.
    let counted = forward.iter().zip(&inverse).filter(|(forward, inverse)| **forward == 0 && **inverse > 0).count();
    assert_eq!(counted as u64, holes);
    assert_eq!(forward.iter().filter(|times| **times > 1).count() as u64, overlaps);
    assert_eq!(forward.iter().sum::<u64>(), 32 * 32);
    assert!(inverse.iter().all(|times| *times <= 1));
    assert_eq!(inverse.iter().sum::<u64>(), data["covered"].as_u64().unwrap());
}

#[test]
fn holes_are_near_the_eye_and_overlaps_far_from_it() {
    let data = data(&["textures/scanning"]);
    let [forward, inverse] = ["forward", "inverse"].map(|order| painted(&data[order]));
    let mean_row = |rows: Vec<usize>| rows.iter().sum::<usize>() as f64 / rows.len() as f64;
    let holes = (0..forward.len()).filter(|&i| forward[i] == 0 && inverse[i] > 0).map(|i| i / 48).collect();
    let overlaps = (0..forward.len()).filter(|&i| forward[i] > 1).map(|i| i / 48).collect();
    // Rows count downwards, and what is lower in the picture is nearer.
    let [holes, overlaps] = [mean_row(holes), mean_row(overlaps)];
    assert!(holes > overlaps + 6.0, "{holes} and {overlaps}");
}

#[test]
fn many_pixels_leave_only_holes_and_few_hardly_any() {
    let holes = |columns: &str| {
        let data = data(&["textures/scanning", "--columns", columns]);
        data["forward"]["holes"].as_u64().unwrap() as f64 / data["covered"].as_u64().unwrap() as f64
    };
    assert!(holes("200") > 0.9);
    assert!(holes("12") < 0.02);
}

#[test]
fn an_image_texture_of_any_flat_object_can_be_scanned() {
    for (object, texels) in [("wall", [256, 256]), ("floor", [16, 16])] {
        let data = data(&["textures/image_map", "--object", object, "--columns", "96"]);
        assert_eq!((&data["object"], &data["texels"]), (&object.into(), &serde_json::json!(texels)));
        assert_eq!(data["inverse"]["overlaps"], 0);
    }
    assert_eq!(data(&["textures/image_map"])["object"], "wall");
}

#[test]
fn the_drawing_is_a_picture_in_either_format() {
    let folder = tempfile::tempdir().unwrap();
    let svg = scan(&["textures/scanning", "--format", "svg", "--theme", "dark"]);
    let svg = String::from_utf8(svg.stdout).unwrap();
    assert!(svg.starts_with("<svg") && svg.contains("Inverse scanning"), "{}", &svg[..200]);
    let file = folder.path().join("scan.png");
    assert!(scan(&["textures/scanning", "--format", "png", "-o", file.to_str().unwrap()]).status.success());
    let picture = image::load_from_memory(&fs::read(file).unwrap()).unwrap();
    assert_eq!((picture.width(), picture.height()), (2240, 1020));
}

#[test]
fn the_text_tells_the_same_counts_as_the_data() {
    let data = data(&["textures/scanning"]);
    let text = String::from_utf8(scan(&["textures/scanning"]).stdout).unwrap();
    let [holes, overlaps] = ["holes", "overlaps"].map(|name| data["forward"][name].as_u64().unwrap());
    assert!(text.contains(&format!("{holes} holes: ")), "{text}");
    assert!(text.contains(&format!("{overlaps} pixels painted more than once")), "{text}");
    assert!(text.contains(&format!("each of {} pixels painted once", data["covered"])), "{text}");
}

#[test]
fn what_cannot_be_scanned_is_refused_with_what_can() {
    let unknown = complaint(&["textures/image_map", "--object", "ceiling"]);
    assert!(unknown.contains("`ceiling` is not in the scene; one of `wall`, `floor` was expected"), "{unknown}");
    let curved = complaint(&["textures/image_map", "--object", "globe"]);
    assert!(curved.contains("`globe` carries no picture on a flat part; one of `wall`, `floor`"), "{curved}");
    let part = complaint(&["textures/image_map", "--part", "top"]);
    assert!(part.contains("`wall` has no flat part `top`") && part.contains("one of `"), "{part}");
    let plain = complaint(&["csg/bowl"]);
    assert!(plain.contains("no object of the scene carries a picture on a flat part"), "{plain}");
    assert!(complaint(&["textures/scanning", "--columns", "0"]).contains("1..=400"));
}

#[test]
fn a_picture_behind_the_eye_is_not_scanned() {
    let folder = tempfile::tempdir().unwrap();
    fs::copy("scenes/textures/checker.png", folder.path().join("checker.png")).unwrap();
    let scene = r#"{"camera": {"eye": [0, 0, 5], "look_at": [0, 0, 9], "up": [0, 1, 0]},
        "materials": {"m": {"texture": {"kind": "image", "file": "checker.png"}}},
        "objects": [{"shape": "square", "material": "m", "name": "tile"}]}"#;
    let file = folder.path().join("behind.json");
    fs::write(&file, scene).unwrap();
    let message = complaint(&[file.to_str().unwrap()]);
    assert!(message.contains("none of the 48 × 36 pixels shows the picture on `tile`"), "{message}");
}
