//! Links from the book: within it, and into the workbench.

use crate::lesson::Stage;
use crate::lesson::model::{Aim, At, Step};
use crate::scene::{Profile, embedded_scene};
use crate::share::link;
use crate::story::Level;
use glam::DVec3;

/// A name as a part of an address: letters, digits, `-` and `_`.
pub fn slug(name: &str) -> String {
    let safe = |c: char| if c.is_alphanumeric() || c == '_' { c } else { '-' };
    name.to_lowercase().chars().map(safe).collect()
}

/// The place of a term on the page of the glossary.
pub fn term(name: &str) -> String {
    format!("term-{}", slug(name))
}

/// The link that opens a step's ray in the workbench. None where a scene of the lesson's own is too long for one.
pub fn to_workbench(step: &Step, stage: &Stage) -> Option<String> {
    let aim = &stage.aim;
    let at = match aim.at? {
        At::Pixel(pixel) => link::Aim::Pixel(pixel),
        At::Ray([ox, oy, oz, dx, dy, dz]) => link::Aim::Ray([DVec3::new(ox, oy, oz), DVec3::new(dx, dy, dz)]),
    };
    let level = match step.level {
        Level::Story => "story",
        Level::Working => "working",
        Level::Everything => "everything",
    };
    let whole = link::Link {
        text: (!comes_with_the_program(aim)).then(|| stage.scene.text.clone()),
        aim: Some(at),
        event: Some(link::EventPlace::of(&stage.tree, stage.event)),
        level: Some(level.to_owned()),
        views: step.views.iter().map(|view| view.value.name.to_owned()).collect(),
        accuracy: aim.accuracy.as_ref().and_then(accuracy),
        ..link::Link::to_scene(&aim.scene)
    };
    whole.written().ok()
}

fn accuracy(profile: &Profile) -> Option<link::Accuracy> {
    let named = Profile::NAMED.iter().find(|(_, known)| known == profile);
    match named {
        Some((name, _)) => Some(link::Accuracy::Named((*name).to_owned())),
        None => profile.to_json("lesson").ok().map(link::Accuracy::Text),
    }
}

/// The command that prints a step's ray; none where the scene is the lesson's own, or changed by it.
pub fn trace_command(aim: &Aim) -> Option<String> {
    if !comes_with_the_program(aim) || aim.accuracy.is_some() {
        return None;
    }
    Some(match aim.at? {
        At::Pixel([x, y]) => format!("rayscope trace {} --pixel {x},{y}", aim.scene),
        At::Ray(ray) => {
            let numbers: Vec<String> = ray.iter().map(|x| format!("{x:?}").trim_end_matches(".0").to_owned()).collect();
            format!("rayscope trace {} --ray={}", aim.scene, numbers.join(","))
        }
    })
}

fn comes_with_the_program(aim: &Aim) -> bool {
    aim.changes.is_empty() && embedded_scene(&aim.scene).is_some()
}
