//! Animations and pictures beside a scene, through the real binary.

use std::fs;
use std::path::Path;
use std::process::{Command, Output, Stdio};

fn rayscope(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_rayscope")).args(arguments).stdin(Stdio::null()).output().unwrap()
}

fn complaint(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

fn render(arguments: &[&str], output: &Path) -> Output {
    let file = output.to_str().unwrap();
    rayscope(&[&["render", "textures/marble", "--width", "24", "-o", file], arguments].concat())
}

#[test]
fn frames_become_numbered_files_and_one_animated_file_with_the_same_pixels() {
    let folder = tempfile::tempdir().unwrap();
    let numbered = render(&["--frames", "1..451:225"], &folder.path().join("marble.png"));
    assert!(numbered.status.success(), "{}", complaint(&numbered));
    let mut names: Vec<_> = fs::read_dir(folder.path()).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    names.sort();
    assert_eq!(names, ["marble_0001.png", "marble_0226.png", "marble_0451.png"]);
    let animated = folder.path().join("marble.apng");
    let output = render(&["--frames", "1..451:225", "--rate", "10"], &animated);
    assert!(output.status.success(), "{}", complaint(&output));
    let mut reader =
        png::Decoder::new(std::io::BufReader::new(fs::File::open(&animated).unwrap())).read_info().unwrap();
    assert_eq!(reader.info().animation_control().unwrap().num_frames, 3);
    for name in names {
        let mut frame = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut frame).unwrap();
        let alone = image::open(folder.path().join(name)).unwrap().to_rgb8();
        assert_eq!(alone.into_raw(), frame);
        let control = reader.info().frame_control().unwrap();
        assert_eq!((control.delay_num, control.delay_den), (1, 10));
    }
}

#[test]
fn frames_that_make_no_sense_are_refused_before_anything_is_rendered() {
    let folder = tempfile::tempdir().unwrap();
    for frames in ["9..1", "x", "1..2:0"] {
        let output = render(&["--frames", frames], &folder.path().join("marble.png"));
        assert_eq!(output.status.code(), Some(2));
        assert!(complaint(&output).contains("expected 1..900"), "{}", complaint(&output));
    }
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
}

/// A scene in a folder of its own, whose picture lies where `picture` says.
fn scene_with_picture(folder: &Path, picture: &str) -> String {
    let scene = format!(
        r#"{{"image": {{"width": 8, "height": 6}}, "materials": {{"m": {{"texture": {{"kind": "image", "file": {picture:?}}}}}}},
        "objects": [{{"shape": "sphere", "material": "m"}}]}}"#
    );
    let path = folder.join("scene.json");
    fs::write(&path, scene).unwrap();
    path.to_str().unwrap().to_owned()
}

#[test]
fn a_picture_is_read_from_the_scenes_folder_and_from_nowhere_else_unless_allowed() {
    let outer = tempfile::tempdir().unwrap();
    let folder = outer.path().join("scene");
    fs::create_dir(&folder).unwrap();
    let checker = concat!(env!("CARGO_MANIFEST_DIR"), "/scenes/textures/checker.png");
    fs::copy(checker, folder.join("inside.png")).unwrap();
    fs::copy(checker, outer.path().join("outside.png")).unwrap();
    fs::write(folder.join("broken.png"), b"\x89PNG\r\n\x1a\nno picture").unwrap();
    let out = outer.path().join("out.png");
    let run = |picture: &str, more: &[&str]| {
        let scene = scene_with_picture(&folder, picture);
        rayscope(&[&["render", &scene, "-o", out.to_str().unwrap()], more].concat())
    };
    assert!(run("inside.png", &[]).status.success());
    fs::remove_file(&out).unwrap();
    for (picture, message) in
        [("../outside.png", "--allow-outside-files"), ("gone.png", "gone.png"), ("broken.png", "broken.png")]
    {
        let output = run(picture, &[]);
        assert_eq!(output.status.code(), Some(2), "{picture}");
        assert!(complaint(&output).contains(message), "{}", complaint(&output));
        assert!(complaint(&output).contains("materials.m.texture.file"), "{}", complaint(&output));
        assert!(!out.exists());
    }
    assert!(run("../outside.png", &["--allow-outside-files"]).status.success());
}
