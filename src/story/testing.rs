//! Trees for tests.

use crate::record::{Entry, RayKind, Recorder, What};
use crate::scene::{embedded_scene, embedded_scenes, load};
use crate::trace::{RayTree, TreeRecorder, record_pixel};

/// The telling pixel of an embedded scene.
pub fn recorded(name: &str) -> RayTree {
    let embedded = embedded_scene(name).unwrap();
    let scene = load(embedded.text, name).unwrap();
    record_pixel(&scene, scene.pixels[0][0], scene.pixels[0][1])
}

/// The telling pixels of all embedded scenes, with the scene's name.
pub fn every_telling_pixel() -> impl Iterator<Item = (String, RayTree)> {
    embedded_scenes().into_iter().flat_map(|embedded| {
        let scene = load(embedded.text, &embedded.name).unwrap();
        let pixels = scene.pixels.clone();
        pixels.into_iter().map(move |[x, y]| (format!("{} ({x}, {y})", embedded.name), record_pixel(&scene, x, y)))
    })
}

pub fn bowl() -> RayTree {
    recorded("csg/bowl")
}

pub fn fishbowl() -> RayTree {
    recorded("optics/fishbowl")
}

pub fn entry(what: What) -> Entry {
    Entry::new(what)
}

pub fn object(name: &str, intervals: usize) -> Entry {
    entry(What::Object { index: 0, name: name.to_owned(), intervals })
}

pub fn primitive(name: &str) -> Entry {
    entry(What::Primitive { shape: "sphere".to_owned(), name: name.to_owned(), leaf: 0, hits: 1 })
}

pub fn nothing() -> Entry {
    entry(What::Nothing { background: [0.0; 3] })
}

pub fn ray(kind: RayKind, depth: u32) -> Entry {
    entry(What::Ray {
        ray: kind,
        origin: [0.0; 3],
        direction: [0.0, 0.0, 1.0],
        depth,
        medium: "air".to_owned(),
        weight: 1.0,
        wavelength: None,
        left: None,
    })
}

/// ```text
/// 0 pixel ┬ 1 camera ray
///         ├ 2 object a ┬ 3 primitive p
///         │            └ 4 primitive q
///         ├ 5 object b ─ 6 primitive r
///         ├ 7 reflected ray ┬ 8 object a ─ 9 primitive p
///         │                 └ 10 nothing
///         └ 11 nothing
/// ```
pub fn small() -> RayTree {
    let mut recorder = TreeRecorder::new();
    recorder.begin();
    recorder.note(|| ray(RayKind::Camera, 0));
    recorder.begin();
    recorder.note(|| primitive("p"));
    recorder.note(|| primitive("q"));
    recorder.end(|| object("a", 1));
    recorder.begin();
    recorder.note(|| primitive("r"));
    recorder.end(|| object("b", 0));
    recorder.begin();
    recorder.begin();
    recorder.note(|| primitive("p"));
    recorder.end(|| object("a", 1));
    recorder.note(nothing);
    recorder.end(|| ray(RayKind::Reflected, 1));
    recorder.note(nothing);
    recorder.end(|| entry(What::Pixel { x: 0, y: 0, width: 1, height: 1 }));
    recorder.finish()
}
