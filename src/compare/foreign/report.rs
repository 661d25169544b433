//! The comparison of all that a foreign ray tracer says with our own stories.

use super::causes::{CAUSES, CLOSE, Case, Cause, Explanation, explain};
use super::check::{Check, Subject};
use super::line::{Line, RayWord};
use super::ours::Ours;
use super::read::ForeignTrace;
use super::walk::Walk;
use crate::scene::{Sampling, Scene, Shortcuts};
use crate::trace::{RayTree, record_pixel, record_ray};
use crate::view::row;
use glam::DVec3;
use rayon::prelude::*;

/// What a story is about.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Place {
    /// A pixel; (0, 0) is the top left one.
    Pixel([u32; 2]),
    /// A ray of its own: origin and direction.
    Ray([DVec3; 2]),
}

/// All stories of a foreign ray tracer beside ours.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// One for each pixel or ray, in the order of the lines.
    pub stories: Vec<StoryComparison>,
    /// What is worth knowing and no departure: names that are not known, lines that belong to nothing.
    pub notes: Vec<String>,
}

/// One story beside ours.
#[derive(Clone, Debug)]
pub struct StoryComparison {
    /// What it is about.
    pub place: Place,
    /// Its first line.
    pub line: usize,
    /// Our own story; kept of the first fifty that depart.
    pub tree: Option<RayTree>,
    /// How many things were compared.
    pub checks: usize,
    /// How many of them depart.
    pub departing: usize,
    /// The first departure in the order of our story.
    pub departure: Option<ForeignDeparture>,
}

/// Where a foreign ray tracer departs from us, and why.
#[derive(Clone, Debug)]
pub struct ForeignDeparture {
    /// What was compared.
    pub check: Check,
    /// Our event in words.
    pub event: String,
    /// The ray that it happened to, in words.
    pub ray: String,
    /// The causes that explain it, the likeliest first.
    pub causes: Vec<Explanation>,
}

impl Comparison {
    /// How many things were compared.
    #[must_use]
    pub fn checks(&self) -> usize {
        self.stories.iter().map(|story| story.checks).sum()
    }

    /// The causes that explain the first departures of the most stories, with how many each explains.
    #[must_use]
    pub fn verdict(&self) -> Vec<(&'static Cause, usize)> {
        let mut counts: Vec<(&'static Cause, usize)> = CAUSES.iter().map(|cause| (*cause, 0)).collect();
        let departures = self.stories.iter().filter_map(|story| story.departure.as_ref());
        for explanation in departures.flat_map(|departure| &departure.causes) {
            if let Some((_, count)) = counts.iter_mut().find(|(cause, _)| *cause == explanation.cause) {
                *count += 1;
            }
        }
        counts.retain(|(_, count)| *count > 0);
        counts.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
        counts
    }

    /// One program mostly makes one mistake: of the causes that explain a departure, that one is the likeliest which explains
    /// the most others too.
    fn weigh(&mut self) {
        let verdict = self.verdict();
        let count = |explanation: &Explanation| {
            verdict.iter().find(|(cause, _)| *cause == explanation.cause).map_or(0, |(_, count)| *count)
        };
        for departure in self.stories.iter_mut().filter_map(|story| story.departure.as_mut()) {
            departure
                .causes
                .sort_by_key(|explanation| (explanation.misfit > CLOSE, std::cmp::Reverse(count(explanation))));
        }
    }

    /// The first story that departs.
    #[must_use]
    pub fn first_departure(&self) -> Option<(&StoryComparison, &ForeignDeparture)> {
        self.stories.iter().find_map(|story| story.departure.as_ref().map(|departure| (story, departure)))
    }
}

/// Compares all stories; `share` is the share of a number by which it may be off.
///
/// # Errors
/// Says so where the scene takes several samples of a pixel, of which there is no one story, or where a pixel lies outside.
pub fn compare_foreign(scene: &Scene, trace: &ForeignTrace, share: f64) -> Result<Comparison, String> {
    if scene.sampling.is_many() || scene.lens.is_some() {
        return Err("the scene takes several samples of a pixel, so that a pixel has no one story to compare; \
                    compare with a scene without `sampling` and `lens`"
            .to_owned());
    }
    let mut scene = Scene { shortcuts: Shortcuts::NONE, sampling: Sampling::CENTRE, ..scene.clone() };
    if let Some([width, height]) = trace.size() {
        (scene.image.width, scene.image.height) = (width.max(1), height.max(1));
    }
    // The errors too are told in the order of the lines.
    let told: Vec<Result<Told, String>> =
        stories_of(&trace.lines).into_par_iter().map(|lines| told(&scene, lines, share)).collect();
    let mut notes = trace.unknown();
    let mut stories = Vec::new();
    let mut kept = 0;
    for told in told {
        let Told { story, notes: more } = told?;
        notes.extend(more);
        stories.extend(story.map(|story| {
            kept += usize::from(story.departure.is_some());
            let is_kept = story.departure.is_some() && kept <= MOST_TREES;
            StoryComparison { tree: story.tree.filter(|_| is_kept), ..story }
        }));
    }
    if notes.len() > MOST_NOTES {
        let more = notes.len() - MOST_NOTES;
        notes.truncate(MOST_NOTES);
        notes.push(format!("and {more} more notes"));
    }
    let mut comparison = Comparison { stories, notes };
    comparison.weigh();
    Ok(comparison)
}

/// Notes that are kept; nobody reads more.
const MOST_NOTES: usize = 30;
/// Trees of ours that are kept, of the first stories that depart: a whole picture's would fill the memory.
const MOST_TREES: usize = 50;

/// What came out of the lines of one story.
struct Told {
    story: Option<StoryComparison>,
    notes: Vec<String>,
}

fn told(scene: &Scene, lines: &[Line], share: f64) -> Result<Told, String> {
    let Some(place) = place_of(lines) else {
        let first = lines.first().map_or(0, |line| line.number);
        let note = format!(
            "line {first}: these lines belong to no pixel and to no ray; begin with {{\"pixel\": [column, row]}} or with a \
             camera ray that has an origin and a direction"
        );
        return Ok(Told { story: None, notes: vec![note] });
    };
    let tree = record(scene, place, lines)?;
    let mut notes = Vec::new();
    let story = story(scene, place, tree, lines, share, &mut notes);
    Ok(Told { story: Some(story), notes })
}

fn record(scene: &Scene, place: Place, lines: &[Line]) -> Result<RayTree, String> {
    match place {
        Place::Pixel([x, y]) if x < scene.image.width && y < scene.image.height => Ok(record_pixel(scene, x, y)),
        Place::Pixel([x, y]) => Err(format!(
            "line {}: pixel {x},{y} lies outside the picture of {} × {} pixels; another size is told by \
             {{\"size\": [columns, rows]}}",
            lines.first().map_or(0, |line| line.number),
            scene.image.width,
            scene.image.height
        )),
        Place::Ray([origin, direction]) => Ok(record_ray(scene, origin, direction)),
    }
}

fn story(
    scene: &Scene,
    place: Place,
    tree: RayTree,
    lines: &[Line],
    share: f64,
    notes: &mut Vec<String>,
) -> StoryComparison {
    let ours = Ours::new(scene, &tree);
    let mut walk = Walk::new(&ours, share);
    for line in lines {
        walk.line(line);
    }
    notes.append(&mut walk.notes);
    let departing: Vec<&Check> = walk.checks.iter().filter(|check| !check.holds()).collect();
    // Of one event, which object it is comes before its numbers, and those in the order of the lines.
    let first = departing.iter().min_by_key(|check| check.order);
    let departure = first.map(|check| departure(&ours, check, &walk.checks));
    let (checks, departing) = (walk.checks.len(), departing.len());
    let line = lines.first().map_or(0, |line| line.number);
    StoryComparison { place, line, checks, departing, departure, tree: Some(tree) }
}

fn departure(ours: &Ours, check: &Check, checks: &[Check]) -> ForeignDeparture {
    let explained = |check: &Check| explain(Case { ours, check, checks });
    let mut causes = explained(check);
    if matches!(check.subject, Subject::HitObject | Subject::HitLeaf | Subject::Lit(_)) {
        // The time of the hit, or the name of what is in the way, says more than that it is another one.
        let same_place = |other: &&Check| {
            other.event == check.event && other.line == check.line && other.subject != check.subject && !other.holds()
        };
        let more = checks.iter().filter(same_place).flat_map(explained);
        let mut better: Vec<Explanation> = more.collect();
        better.extend(causes.into_iter().filter(|cause| cause.misfit < 1.0 || check.time.is_none()));
        causes = better;
        let mut known = Vec::new();
        causes.retain(|explanation| {
            let is_new = !known.contains(&explanation.cause.id);
            known.push(explanation.cause.id);
            is_new
        });
    }
    let ray = &ours.rays[check.ray];
    let event = row(ours.tree.event(check.event));
    let ray = format!("{} ray", ray.kind.name());
    ForeignDeparture { check: check.clone(), event: event.label, ray, causes }
}

/// The lines of each story: a new one begins with a pixel, and with a camera ray after a camera ray.
fn stories_of(lines: &[Line]) -> Vec<&[Line]> {
    let mut stories = Vec::new();
    let (mut start, mut has_camera) = (0, false);
    for (place, line) in lines.iter().enumerate() {
        let is_camera = line.ray == Some(RayWord::Camera);
        if place > start && (line.pixel.is_some() || (is_camera && has_camera)) {
            stories.push(&lines[start..place]);
            (start, has_camera) = (place, false);
        }
        has_camera |= is_camera;
    }
    if start < lines.len() {
        stories.push(&lines[start..]);
    }
    stories
}

fn place_of(lines: &[Line]) -> Option<Place> {
    if let Some(pixel) = lines.iter().find_map(|line| line.pixel) {
        return Some(Place::Pixel(pixel));
    }
    let camera = lines.iter().find(|line| line.ray == Some(RayWord::Camera))?;
    Some(Place::Ray([camera.origin?.into(), camera.direction?.into()]))
}
