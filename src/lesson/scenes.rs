//! Scenes as lessons ask for them: by name, changed, with an accuracy; each compiled and traced once.

use super::model::{Aim, At, Change};
use crate::document::{Place, Replacement, Step, Structure, Syntax};
use crate::scene::{EmbeddedFiles, Files, Scene, embedded_scene, load_with};
use crate::trace::{RayTree, record_pixel, record_ray};
use glam::DVec3;
use serde_json::Value as Json;
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

/// Where the scenes beside a lesson come from. What comes with the program is always there.
pub trait Shelf: Sync {
    /// The text of a file beside the lesson; none where there is none.
    fn text(&self, lesson: &str, file: &str) -> Option<String>;

    /// The pictures that such a file may name.
    fn pictures<'a>(&'a self, lesson: &str) -> Box<dyn Files + 'a>;
}

/// Scenes, compiled, and rays, recorded.
#[derive(Default)]
pub struct Scenes {
    compiled: Mutex<BTreeMap<String, Arc<Compiled>>>,
    traced: Mutex<BTreeMap<String, Arc<RayTree>>>,
}

/// A scene with the text that it was compiled from.
#[derive(Debug)]
pub struct Compiled {
    /// Its name, as the lesson gives it.
    pub name: String,
    /// Its text, changes made.
    pub text: String,
    /// The scene.
    pub scene: Arc<Scene>,
}

impl Scenes {
    /// The scene that is aimed at.
    ///
    /// # Errors
    /// If there is no such scene, a change cannot be made, or the changed scene cannot be used.
    pub fn scene(&self, lesson: &str, aim: &Aim, shelf: &dyn Shelf) -> Result<Arc<Compiled>, String> {
        let key = format!("{lesson}|{}|{:?}|{:?}", aim.scene, aim.changes, aim.accuracy);
        let known = lock(&self.compiled).get(&key).cloned();
        if let Some(compiled) = known {
            return Ok(compiled);
        }
        let compiled = Arc::new(compile(lesson, aim, shelf)?);
        lock(&self.compiled).insert(key, Arc::clone(&compiled));
        Ok(compiled)
    }

    /// What is aimed at, recorded.
    ///
    /// # Errors
    /// As [`Self::scene`]; and if there is no aim, or the pixel lies outside the picture.
    pub fn trace(&self, lesson: &str, aim: &Aim, shelf: &dyn Shelf) -> Result<(Arc<Compiled>, Arc<RayTree>), String> {
        let compiled = self.scene(lesson, aim, shelf)?;
        let at = aim.at.ok_or("nothing is aimed at yet: the `step` block needs a `pixel` or a `ray`")?;
        let key = format!("{lesson}|{}|{:?}|{:?}|{at:?}", aim.scene, aim.changes, aim.accuracy);
        let known = lock(&self.traced).get(&key).cloned();
        if let Some(tree) = known {
            return Ok((compiled, tree));
        }
        let tree = Arc::new(record(&compiled.scene, at)?);
        lock(&self.traced).insert(key, Arc::clone(&tree));
        Ok((compiled, tree))
    }
}

fn lock<T>(mutex: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The whole story of a pixel or a ray of a scene.
///
/// # Errors
/// If the pixel lies outside the picture, or the ray has no direction.
pub fn record(scene: &Scene, at: At) -> Result<RayTree, String> {
    match at {
        At::Pixel([x, y]) => {
            let (width, height) = (scene.image.width, scene.image.height);
            if x >= width || y >= height {
                return Err(format!("pixel {x}, {y} lies outside the picture of {width} × {height}"));
            }
            Ok(record_pixel(scene, x, y))
        }
        At::Ray([ox, oy, oz, dx, dy, dz]) => {
            let direction = DVec3::new(dx, dy, dz);
            if direction == DVec3::ZERO {
                return Err("a ray with the direction (0, 0, 0) goes nowhere".to_owned());
            }
            Ok(record_ray(scene, DVec3::new(ox, oy, oz), direction))
        }
    }
}

fn compile(lesson: &str, aim: &Aim, shelf: &dyn Shelf) -> Result<Compiled, String> {
    let name = &aim.scene;
    if name.is_empty() {
        return Err("there is no scene yet: the `step` block needs a `scene`".to_owned());
    }
    let (text, files): (String, Box<dyn Files>) = match (embedded_scene(name), shelf.text(lesson, name)) {
        (_, Some(text)) => (text, shelf.pictures(lesson)),
        (Some(embedded), None) => (embedded.text.to_owned(), Box::new(EmbeddedFiles::of_scene(name))),
        (None, None) => {
            return Err(format!(
                "there is no scene `{name}`: `rayscope scenes` lists those that come with the program, and beside the lesson there is no such file"
            ));
        }
    };
    let text = changed(&text, &aim.changes)?;
    let scene = load_with(&text, name, files.as_ref())
        .map_err(|errors| format!("the scene {name} cannot be used: {errors}"))?;
    let scene = match &aim.accuracy {
        Some(profile) => scene.with_profile(profile),
        None => scene,
    };
    Ok(Compiled { name: name.clone(), text, scene: Arc::new(scene) })
}

/// A scene's text with changes made in it; everything else stays as it was.
///
/// # Errors
/// If a place cannot be reached.
pub fn changed(text: &str, changes: &[Change]) -> Result<String, String> {
    let mut text = text.to_owned();
    for change in changes {
        let syntax = Syntax::of(&text);
        known_name(&text, &syntax, change)?;
        let replacements = Structure { text: &text, syntax: &syntax }.set(&change.at, &change.to);
        let Some(replacements) = replacements else {
            return Err(format!("there is no place `{}` in the scene that a value could be put at", change.at));
        };
        text = made(&text, replacements);
    }
    Ok(text)
}

/// Something in the file that has names of its own is there before it is changed: a name that was mistyped would be a new thing, which
/// nothing uses.
fn known_name(text: &str, syntax: &Syntax, change: &Change) -> Result<(), String> {
    let [Step::Field(group), Step::Field(name), _, ..] = change.at.0.as_slice() else { return Ok(()) };
    let whole = syntax.value_at(text, &Place::ROOT.field(group));
    let Some(Json::Object(things)) = whole.filter(|_| NAMED_GROUPS.contains(&group.as_str())) else { return Ok(()) };
    if things.contains_key(name) {
        return Ok(());
    }
    let names: Vec<&str> = things.keys().map(String::as_str).collect();
    Err(format!("there is nothing named `{name}` among the {group} of the scene: there are {}", names.join(", ")))
}

/// The fields of a scene file that hold things by name.
const NAMED_GROUPS: [&str; 3] = ["materials", "solids", "media"];

/// The replacements are apart, so that the last ones can be made first.
fn made(text: &str, mut replacements: Vec<Replacement>) -> String {
    replacements.sort_by_key(|replacement| replacement.range.start);
    let mut text = text.to_owned();
    for replacement in replacements.into_iter().rev() {
        text.replace_range(replacement.range, &replacement.text);
    }
    text
}

/// Nothing beside the lesson.
pub struct NoShelf;

impl Shelf for NoShelf {
    fn text(&self, _: &str, _: &str) -> Option<String> {
        None
    }

    fn pictures<'a>(&'a self, _: &str) -> Box<dyn Files + 'a> {
        Box::new(EmbeddedFiles::of_scene(""))
    }
}
