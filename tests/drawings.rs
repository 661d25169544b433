//! `rayscope trace --drawing` through the real binary.

use std::process::{Command, Output, Stdio};

fn trace(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_rayscope"));
    command.arg("trace").args(arguments).stdin(Stdio::null()).output().unwrap()
}

fn svg(scene: &str, arguments: &[&str]) -> String {
    let output = trace(&[&[scene, "--format", "svg"], arguments].concat());
    assert!(output.status.success(), "{scene} {arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

/// The complaint of a drawing that cannot be had, and the exit code.
fn complaint(arguments: &[&str]) -> (String, Option<i32>) {
    let output = trace(arguments);
    assert!(output.stdout.is_empty(), "{arguments:?}");
    (String::from_utf8(output.stderr).unwrap(), output.status.code())
}

#[test]
fn the_side_view_is_what_is_drawn_where_nothing_else_is_asked_for() {
    assert_eq!(svg("csg/bowl", &[]), svg("csg/bowl", &["--drawing", "side"]));
}

#[test]
fn each_drawing_shows_what_it_is_named_for() {
    for (scene, drawing, telling) in [
        ("textures/filters", "texture", "The pixel on the texels of the image"),
        ("textures/wood", "texture", "The log, cut across its axis"),
        ("textures/environment", "texture", "The environment"),
        ("csg/bowl", "intervals", "bowl = left − right"),
        ("csg/bowl", "signs", "outside"),
        ("csg/bowl", "csg", "S₁"),
        ("csg/bowl", "overview", "eye"),
        ("csg/bowl", "generic", "world to generic"),
        ("csg/bowl", "shading", "transmitted"),
        ("primitives/cube", "planes", "t_out"),
        ("optics/glass_ball", "snell", "refracted"),
    ] {
        let drawn = svg(scene, &["--drawing", drawing]);
        assert!(drawn.starts_with("<svg") && drawn.contains(telling), "{scene} {drawing}");
        assert_ne!(drawn, svg(scene, &["--drawing", drawing, "--theme", "dark"]), "{scene} {drawing}");
    }
}

#[test]
fn a_drawing_of_what_is_not_there_is_refused_with_the_reason() {
    let folder = tempfile::tempdir().unwrap();
    let empty = folder.path().join("empty.json");
    std::fs::write(&empty, "{}").unwrap();
    for (scene, drawing, reason) in [
        ("hello/sphere", "texture", "carries a texture, bump, grain, detail or environment"),
        ("hello/sphere", "intervals", "no compound"),
        ("hello/sphere", "planes", "not made of planes"),
        ("hello/sphere", "snell", "between two transparent media"),
        (empty.to_str().unwrap(), "signs", "no primitive was asked"),
    ] {
        let (message, code) = complaint(&[scene, "--format", "svg", "--drawing", drawing]);
        assert_eq!(code, Some(1), "{message}");
        assert!(message.contains("there is nothing to draw") && message.contains(reason), "{message}");
    }
}

#[test]
fn a_view_is_asked_for_by_either_of_its_two_options_and_of_an_event() {
    assert_eq!(svg("csg/bowl", &["--view", "signs"]), svg("csg/bowl", &["--drawing", "signs"]));
    let root = svg("csg/bowl", &["--view", "side", "--event", "0"]);
    assert_ne!(root, svg("csg/bowl", &["--view", "side"]));
    let (message, code) = complaint(&["csg/bowl", "--format", "svg", "--event", "4000000"]);
    assert_eq!(code, Some(2));
    assert!(message.contains("there is no event 4000000"), "{message}");
}

#[test]
fn options_that_mean_nothing_for_a_format_are_refused() {
    for (arguments, told) in [
        (&["--format", "svg", "--view", "side,signs"][..], "--format pdf"),
        (&["--format", "svg", "--level", "story"], "which steps"),
        (&["--format", "slides", "--seconds", "2"], "--format gif"),
        (&["--format", "slides", "--event", "3"], "svg, png, pdf or link"),
        (&["--format", "gif", "--seconds", "0"], "0.05 to 30"),
        (&["--format", "svg", "--view", "sideways"], "possible values: side"),
    ] {
        let (message, code) = complaint(&[&["csg/bowl"], arguments].concat());
        assert_eq!(code, Some(2), "{arguments:?}");
        assert!(message.contains(told), "{arguments:?}: {message}");
    }
}

#[test]
fn a_drawing_needs_a_format_that_can_show_it() {
    for format in ["text", "json"] {
        let (message, code) = complaint(&["csg/bowl", "--format", format, "--drawing", "texture"]);
        assert_eq!(code, Some(2));
        assert!(message.contains("--format svg or --format png"), "{message}");
    }
}
