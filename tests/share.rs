//! What `rayscope trace` writes for other people, and links, through the real binary.

use std::fs;
use std::path::Path;
use std::process::{Command, Output, Stdio};

fn rayscope(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_rayscope")).args(arguments).stdin(Stdio::null()).output().unwrap()
}

fn written(arguments: &[&str]) -> Vec<u8> {
    let output = rayscope(&[&["trace"], arguments].concat());
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    output.stdout
}

fn text(arguments: &[&str]) -> String {
    String::from_utf8(written(arguments)).unwrap()
}

fn complaint(arguments: &[&str]) -> (String, Option<i32>) {
    let output = rayscope(arguments);
    (String::from_utf8(output.stderr).unwrap(), output.status.code())
}

#[test]
fn every_format_begins_as_its_kind_does_and_is_the_same_each_time() {
    for (format, begin) in [
        ("pdf", &b"%PDF-1.7"[..]),
        ("slides-pdf", b"%PDF-1.7"),
        ("gif", b"GIF89a"),
        ("apng", b"\x89PNG\r\n"),
        ("slides", b"<!DOCTYPE html>"),
        ("markdown", b"# "),
        ("link", b"rayscope:hello/sphere?pixel="),
    ] {
        let arguments = ["hello/sphere", "--format", format];
        let bytes = written(&arguments);
        assert!(bytes.starts_with(begin), "{format}: {:?}", &bytes[..16]);
        assert!(bytes == written(&arguments), "{format}");
    }
}

#[test]
fn a_pdf_of_two_views_has_two_pages() {
    let pdf = written(&["csg/bowl", "--format", "pdf", "--view", "side,signs"]);
    assert!(pdf.windows(8).any(|at| at == b"/Count 2"));
}

#[test]
fn a_worked_example_lies_beside_its_drawings() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("my bowl.md");
    written(&["csg/bowl", "--format", "markdown", "--level", "working", "-o", file.to_str().unwrap()]);
    check_figures(&file);
    let inner = format!("{}/example/", folder.path().display());
    written(&["csg/bowl", "--format", "markdown", "-o", &inner]);
    check_figures(&folder.path().join("example/trace.md"));
}

/// Every drawing that the Markdown names is there, and no other file is.
fn check_figures(file: &Path) {
    let markdown = fs::read_to_string(file).unwrap();
    let named: Vec<&str> = markdown.split("](").skip(1).filter_map(|rest| rest.split(')').next()).collect();
    assert!(!named.is_empty());
    for name in &named {
        let svg = fs::read_to_string(file.with_file_name(name)).unwrap();
        assert!(svg.starts_with("<svg "), "{name}");
    }
    let entries = fs::read_dir(file.parent().unwrap()).unwrap();
    let svgs = entries.filter(|entry| entry.as_ref().unwrap().file_name().to_string_lossy().ends_with(".svg"));
    assert_eq!(svgs.count(), named.len());
}

#[test]
fn a_link_to_a_scene_of_ones_own_holds_its_text() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("mine.json");
    fs::write(&file, r#"{"title": "Mine", "objects": []}"#).unwrap();
    let own = text(&[file.to_str().unwrap(), "--pixel", "3,4", "--format", "link"]);
    assert!(own.contains("pixel=3,4") && own.contains("&text="), "{own}");
    let embedded = text(&["csg/bowl", "--pixel", "3,4", "--format", "link", "--event", "2", "--accuracy", "draft"]);
    assert!(embedded.starts_with("rayscope:csg/bowl?pixel=3,4&event=2&path=Pixel."), "{embedded}");
    assert!(embedded.contains("accuracy=draft") && !embedded.contains("text="), "{embedded}");
}

#[test]
fn a_link_that_is_wrong_is_refused_before_any_window_opens() {
    for (link, told) in [
        ("rayscope:csg/bowl?pixel=1", "no pair"),
        ("rayscope:", "names no scene"),
        ("https://example.org/", "nothing behind a #"),
    ] {
        let (message, code) = complaint(&["open", link]);
        assert_eq!(code, Some(2), "{link}");
        assert!(message.contains(told), "{message}");
    }
}
