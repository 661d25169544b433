//! `rayscope accuracy` through the real binary: what it writes, and what it says where it cannot.

use serde_json::Value;
use std::fs;
use std::process::{Command, Output, Stdio};

/// A ball in front of a mirror: small, and quick.
const SCENE: &str = r#"{
  "camera": {"eye": [0, 0, 5], "look_at": [0, 0, 0], "up": [0, 1, 0], "field_of_view": 40},
  "image": {"width": 32, "height": 24},
  "lights": [{"name": "lamp", "point": [3, 4, 5]}],
  "materials": {"clay": {"diffuse": [0.8, 0.2, 0.2]}, "mirror": {"reflectivity": 0.7}},
  "objects": [{"shape": "sphere", "material": "clay"},
              {"shape": "plane", "material": "mirror", "transform": [{"translate": [0, 0, -2]}]}]
}"#;

struct Folder(tempfile::TempDir);

impl Folder {
    fn new() -> Self {
        let folder = Self(tempfile::tempdir().unwrap());
        fs::write(folder.path("scene.json"), SCENE).unwrap();
        folder
    }

    fn path(&self, name: &str) -> String {
        self.0.path().join(name).to_str().unwrap().to_owned()
    }

    /// Runs the command on the scene, with the cache in this folder.
    fn accuracy(&self, more: &[&str]) -> Output {
        let mut command = Command::new(env!("CARGO_BIN_EXE_rayscope"));
        command.args(["accuracy", &self.path("scene.json"), "--cache", &self.path("cache")]);
        command.args(more).stdin(Stdio::null()).output().unwrap()
    }

    fn json(&self, more: &[&str]) -> Value {
        let output = self.accuracy(&[&["--format", "json", "--budget", "0.3"], more].concat());
        assert!(output.status.success(), "{}", complaint(&output));
        serde_json::from_slice(&output.stdout).unwrap()
    }
}

fn complaint(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

#[test]
fn the_json_has_the_members_of_the_contract() {
    let found = Folder::new().json(&[]);
    assert!(found["reference"]["error"].is_number());
    let points = found["points"].as_array().unwrap();
    assert!(points.len() > 10);
    for point in points {
        assert!(point["knob"].is_string() && point["value"].is_string(), "{point}");
        let noise = &point["noise"];
        assert!(point["seconds"].is_number() || (point["seconds"].is_null() && noise.is_string()), "{point}");
        assert!(point["spread"].is_number() && point["repeats"].is_u64() && point["error"].is_number(), "{point}");
        assert!(point["frontier"].is_boolean() && point["wrong_pixels"].is_u64(), "{point}");
        // Repeats in which the thread had to wait are kept, and do not count.
        let [times, waits] = ["times", "waits"].map(|each| point[each].as_array().unwrap().len() as u64);
        assert!(times == waits && times >= point["repeats"].as_u64().unwrap(), "{point}");
        if point["control"] == true {
            assert_eq!((&point["error"], &point["change"]), (&0.0.into(), &0.0.into()), "{point}");
        }
    }
    assert!(points.iter().any(|point| point["control"] == true));
}

#[test]
fn a_second_run_finds_the_reference_in_the_cache_and_a_broken_one_is_made_anew() {
    let folder = Folder::new();
    assert_eq!(folder.json(&["--knob", "shortcuts"])["reference"]["cached"], false);
    assert_eq!(folder.json(&["--knob", "shortcuts"])["reference"]["cached"], true);
    for entry in fs::read_dir(folder.path("cache")).unwrap() {
        fs::write(entry.unwrap().path(), b"something else").unwrap();
    }
    let output = folder.accuracy(&["--knob", "shortcuts", "--budget", "0.3"]);
    assert!(output.status.success() && complaint(&output).contains("made anew"), "{}", complaint(&output));
    assert_eq!(folder.json(&["--knob", "shortcuts"])["reference"]["cached"], true);
}

#[test]
fn a_resumed_run_adds_repeats_and_refuses_what_is_of_another_scene() {
    let folder = Folder::new();
    let first = folder.json(&["--knob", "depth"]);
    let file = folder.path("run.json");
    fs::write(&file, first.to_string()).unwrap();
    let second = folder.json(&["--knob", "depth", "--resume", &file]);
    let times = |run: &Value| run["points"][0]["times"].as_array().unwrap().clone();
    assert!(times(&second).starts_with(&times(&first)), "{:?} {:?}", times(&first), times(&second));
    let changed = SCENE.replace("0.7", "0.6");
    fs::write(folder.path("scene.json"), changed).unwrap();
    let refused = folder.accuracy(&["--resume", &file]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(complaint(&refused).contains("another scene"), "{}", complaint(&refused));
    fs::write(&file, "{}").unwrap();
    let refused = folder.accuracy(&["--resume", &file]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(complaint(&refused).contains("--format json"), "{}", complaint(&refused));
}

#[test]
fn an_answer_is_a_profile_that_render_takes() {
    let folder = Folder::new();
    let [profile, picture] = ["profile.json", "picture.png"].map(|name| folder.path(name));
    // Any error will do, so that there is an answer unless all times are lost in noise.
    let output = folder.accuracy(&["--for-error", "1", "--profile", &profile, "--budget", "1"]);
    if complaint(&output).contains("lost in noise") {
        // The machine is too busy for an answer, and that is said.
        assert_eq!(output.status.code(), Some(1));
        return;
    }
    assert!(output.status.success(), "{}", complaint(&output));
    let mut render = Command::new(env!("CARGO_BIN_EXE_rayscope"));
    let rendered =
        render.args(["render", &folder.path("scene.json"), "-o", &picture, "--accuracy", &profile]).output().unwrap();
    assert!(rendered.status.success(), "{}", complaint(&rendered));
}

#[test]
fn what_is_wrong_with_the_arguments_is_said() {
    let folder = Folder::new();
    for (arguments, expected) in [
        (&["--budget", "soon"][..], "expected a time above 0"),
        (&["--for-error", "7"][..], "expected an error from 0 to 1"),
        (&["--plot", "plot.eps"][..], ".svg, .png or .pdf"),
        (&["--knob", "zoom"][..], "shortcuts"),
        (&["--profile", "profile.json"][..], "--for-time"),
        (&["--resume", "missing.json"][..], "missing.json cannot be resumed: no such file"),
    ] {
        let refused = folder.accuracy(arguments);
        assert_eq!(refused.status.code(), Some(2), "{arguments:?}");
        assert!(complaint(&refused).contains(expected), "{arguments:?}: {}", complaint(&refused));
    }
}
