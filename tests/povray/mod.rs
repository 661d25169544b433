//! Pictures by POV-Ray, where it is installed, and by this program.

use rayscope::scene::{Image, Scene};
use rayscope::trace::{Progress, render};
use std::path::Path;
use std::process::{Command, Stdio};

/// Three bytes a pixel as POV-Ray draws the scene; none where it is not installed.
pub fn picture(scene: &Path, width: u32, height: u32) -> Option<Vec<u8>> {
    let folder = tempfile::tempdir().unwrap();
    let png = folder.path().join("picture.png");
    let output = Command::new("povray")
        .arg(format!("+I{}", scene.display()))
        .arg(format!("+O{}", png.display()))
        .args([format!("+W{width}"), format!("+H{height}")])
        .args(["-D", "+WT1", "+FN8", "-GA"])
        .stdin(Stdio::null())
        .output();
    let Ok(output) = output else {
        eprintln!("povray is not installed, so its pictures are not compared");
        return None;
    };
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{} is not drawn by POV-Ray:\n{said}", scene.display());
    Some(image::open(png).unwrap().to_rgb8().into_raw())
}

/// Three bytes a pixel as this program draws it.
pub fn ours(mut scene: Scene, width: u32, height: u32) -> Vec<u8> {
    scene.image = Image { width, height };
    render(&scene, &Progress::new()).0.to_rgb8()
}
