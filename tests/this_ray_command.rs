//! `rayscope accuracy SCENE --pixel` and `--ray` through the real binary.

use serde_json::Value;
use std::process::{Command, Output};

fn accuracy(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_rayscope"));
    command.arg("accuracy").args(arguments).output().unwrap()
}

fn json(arguments: &[&str]) -> Value {
    let output = accuracy(&[arguments, &["--format", "json"]].concat());
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).unwrap()
}

#[test]
fn a_pixel_is_told_by_every_method_with_times_and_digits() {
    let report = json(&["hard/far_torus", "--pixel", "130,95"]);
    let methods = report["methods"].as_array().unwrap();
    let names: Vec<_> = methods.iter().map(|method| method["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["f32", "f64", "adaptive", "double-double", "textbook"]);
    for method in methods {
        // A time is told with its spread and repeats, or it is said why not.
        assert!(method["ns"].as_f64().is_some_and(|ns| ns > 0.0) != method["noise"].is_string(), "{method}");
        assert!(method["spread_ns"].as_f64().unwrap() >= 0.0, "{method}");
        // Those in which the thread had to wait do not count.
        assert!(method["repeats"].as_u64().is_some_and(|repeats| (1..=15).contains(&repeats)), "{method}");
    }
    let digits = |k: usize| methods[k]["hit_digits"].as_f64().unwrap_or(f64::INFINITY);
    assert!(digits(0) < 8.0 && digits(1) > 14.0 && digits(3) > 15.0, "{methods:?}");
    let events = report["events"].as_array().unwrap();
    let quartic = events.iter().find(|event| event["label"].as_str().unwrap().starts_with("quartic")).unwrap();
    let lost = |k: usize| quartic["methods"][k]["lost"].as_f64().unwrap();
    assert!(lost(1) > 5.0 && quartic["methods"][4].is_null(), "{quartic}");
    let numbers = quartic["methods"][1]["numbers"].as_array().unwrap();
    let q = numbers.iter().find(|number| number["name"] == "q").unwrap();
    let [value, error, digits] = [&q["value"][0], &q["error"], &q["digits"]].map(|x| x.as_f64().unwrap());
    assert!((digits + (error / value.abs()).log10()).abs() < 1e-9, "{q}");
}

#[test]
fn a_ray_of_ones_own_is_told_as_text() {
    let output = accuracy(&["hello/sphere", "--ray", "0,-4,1,0,1,0"]);
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(output.status.success() && text.contains("Digits right of the worst number of each event"), "{text}");
    assert!(text.contains("hit surface of ball") && text.contains("Where digits were lost"), "{text}");
}

#[test]
fn what_makes_no_sense_for_one_ray_is_refused() {
    for (arguments, part) in [
        (&["hello/sphere", "--pixel", "640,0"][..], "the last one is 639,479"),
        (&["hello/sphere", "--pixel", "3,4", "--format", "csv"], "not as csv"),
        (&["hello/sphere", "--pixel", "3,4", "--knob", "depth"], "cannot be used with"),
        (&["hello/sphere", "--pixel", "3"], "expected a column and a row"),
    ] {
        let output = accuracy(arguments);
        let complaint = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{complaint}");
        assert!(complaint.contains(part), "{arguments:?}: {complaint}");
    }
}
