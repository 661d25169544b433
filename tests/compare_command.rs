//! `rayscope compare` through the real binary.

use serde_json::Value;
use std::io::Write;
use std::process::{Command, Output, Stdio};

fn compare(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_rayscope"));
    command.arg("compare").args(arguments).current_dir(env!("CARGO_MANIFEST_DIR"));
    command.stdin(Stdio::null()).output().unwrap()
}

fn said(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).unwrap()
}

#[test]
fn the_three_sample_programs_do_not_differ() {
    for language in ["python", "cpp", "javascript"] {
        let output = compare(&[&format!("tests/compare/{language}.jsonl"), "compare/still_life"]);
        assert_eq!(output.status.code(), Some(0), "{language}: {}", said(&output));
        assert!(said(&output).starts_with("no difference in 9 stories"), "{language}: {}", said(&output));
    }
}

#[test]
fn a_departure_is_told_with_its_cause_and_ends_with_code_1() {
    let right = std::fs::read_to_string("tests/compare/python.jsonl").unwrap();
    let wrong = right.replacen("\"n1\": 1, \"n2\": 1.5", "\"n1\": 1.5, \"n2\": 1", 1);
    assert_ne!(right, wrong);
    let mut file = tempfile::NamedTempFile::new().unwrap();
    file.write_all(wrong.as_bytes()).unwrap();
    let path = file.path().to_str().unwrap();
    let output = compare(&[path, "compare/still_life"]);
    assert_eq!(output.status.code(), Some(1));
    assert!(said(&output).contains("likely cause: n₁ and n₂ are swapped [indices-swapped]"), "{}", said(&output));
    let output = compare(&[path, "compare/still_life", "--format", "json"]);
    let data: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!((data["same"].as_bool(), data["format"].as_str()), (Some(false), Some("rayscope-compare/1")));
    let departing: Vec<&Value> =
        data["stories"].as_array().unwrap().iter().filter(|story| !story["departure"].is_null()).collect();
    assert_eq!(departing.len(), 1);
    assert_eq!(departing[0]["departure"]["causes"][0]["cause"], "indices-swapped");
}

#[test]
fn two_pixels_two_scenes_and_two_settings_are_laid_side_by_side() {
    let pixels = compare(&["csg/bowl", "--pixel", "312,313", "--with-pixel", "333,150"]);
    assert_eq!(pixels.status.code(), Some(1));
    assert!(said(&pixels).contains("first difference: Pixel (312, 313)"), "{}", said(&pixels));
    let scenes = compare(&["csg/bowl", "--with-scene", "csg/lens", "--format", "json"]);
    let data: Value = serde_json::from_slice(&scenes.stdout).unwrap();
    assert!(data["only_left"].as_u64() > Some(0) && data["only_right"].as_u64() > Some(0));
    assert!(data["rows"].as_array().unwrap().iter().all(|row| row["standing"] != "same"));
    let settings = compare(&["optics/glass_ball", "--with-accuracy", "draft"]);
    assert_eq!(settings.status.code(), Some(1));
    let same = compare(&["csg/bowl", "--with-pixel", "312,313"]);
    assert_eq!(same.status.code(), Some(0));
    assert!(said(&same).starts_with("no difference in "));
}

#[test]
fn what_cannot_be_compared_is_answered_with_what_to_do() {
    let mut file = tempfile::NamedTempFile::new().unwrap();
    file.write_all(b"{\"pixel\": [1, 2]}\n{\"t\": \"five\"}\n").unwrap();
    let path = file.path().to_str().unwrap();
    for (arguments, part) in [
        (vec![path, "csg/bowl"], "line 2, column 2: `t`: expected a number"),
        (vec!["csg/bowl"], "with what is csg/bowl to be compared?"),
        (vec!["no_such_file.jsonl", "csg/bowl"], "cannot read no_such_file.jsonl: no such file"),
        (vec![path, "no/such"], "line 2"),
        (vec!["csg/bowl", "--with-pixel", "9999,0"], "lies outside the picture"),
        (vec!["csg/bowl", "--with-pixel", "1,1", "--tolerance", "2"], "a share from 0 to 1"),
    ] {
        let output = compare(&arguments);
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {said}");
        assert!(said.contains(part), "{arguments:?}: {said}");
    }
}
