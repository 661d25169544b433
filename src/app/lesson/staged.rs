//! A step, set up in the background: its scene compiled, its rays recorded, its text told, its questions worked out.

use super::told::{Teller, ToldPart, link_once};
use crate::app::frame::background::Background;
use crate::app::pane::Pane;
use crate::app::share::pane_named;
use crate::lesson::model::{Aim, Lesson, Sited, Step};
use crate::lesson::prose::{Prose, Told};
use crate::lesson::{Finding, Posed, Scenes, Shelf, Stage, Term};
use crate::lesson_folder::Lessons;
use crate::record::EventId;
use crate::scene::{Scene, embedded_scene};
use crate::story::Level;
use crate::view::View;
use egui::Context;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::{Arc, OnceLock};

/// Lessons with what is known of their scenes.
#[derive(Clone)]
pub struct School {
    /// The lessons.
    pub lessons: Arc<Lessons>,
    /// Their scenes, compiled and traced once.
    pub scenes: Arc<Scenes>,
}

/// A step that is ready to be shown.
pub struct Staged {
    /// The step, counted from 0.
    pub step: usize,
    /// Its scene and its ray.
    pub stage: Stage,
    /// Its scene without its accuracy.
    pub whole: Arc<Scene>,
    /// The name that its scene is opened under.
    pub scene_name: String,
    /// The lesson's opening, before the first step.
    pub opening: Prose<Told>,
    /// What is told and asked, in order.
    pub parts: Vec<ToldPart>,
    /// Its questions, each with its number in the lesson.
    pub posed: Vec<(usize, Posed)>,
    /// How much the story tells.
    pub level: Level,
    /// The panels with its drawings.
    pub views: Vec<Pane>,
    /// Those that wait for the answers.
    pub after: Vec<Pane>,
    /// Where the probe stands.
    pub t: Option<f64>,
    /// The events that are marked.
    pub marked: BTreeSet<EventId>,
    /// What the terms of the glossary mean.
    pub terms: BTreeMap<String, Prose<Told>>,
    /// What has no value.
    pub findings: Vec<Finding>,
}

/// A step, or why it cannot be set up.
pub type Outcome = Result<Box<Staged>, Finding>;

impl School {
    /// Lessons whose scenes are not compiled yet.
    pub fn new(lessons: Lessons) -> Self {
        Self { lessons: Arc::new(lessons), scenes: Arc::default() }
    }

    /// The course that comes with the program, read once.
    pub fn embedded() -> Self {
        static COURSE: OnceLock<Arc<Lessons>> = OnceLock::new();
        let lessons = COURSE.get_or_init(|| Arc::new(Lessons::embedded()));
        Self { lessons: Arc::clone(lessons), scenes: Arc::default() }
    }

    /// Begins to set a step up.
    pub fn begin(&self, ctx: &Context, lesson: &str, step: usize) -> Option<Background<Outcome>> {
        let (school, lesson) = (self.clone(), lesson.to_owned());
        Background::start(ctx, "lesson", move |_, publish| {
            if let Some(outcome) = school.staged(&lesson, step) {
                publish(outcome);
            }
        })
    }

    fn staged(&self, lesson: &str, number: usize) -> Option<Outcome> {
        let lesson = self.lessons.course.lesson(lesson)?;
        let step = lesson.steps.get(number)?;
        let shelf = &self.lessons.shelf;
        let stage = match Stage::new(lesson, step, &self.scenes, shelf) {
            Ok(stage) => stage,
            Err(finding) => return Some(Err(finding)),
        };
        let plain = Aim { accuracy: None, ..stage.aim.clone() };
        // The step's own scene was compiled from the same text.
        let whole = self
            .scenes
            .scene(&lesson.id, &plain, shelf)
            .map_or(Arc::clone(&stage.scene.scene), |plain| Arc::clone(&plain.scene));
        Some(Ok(Box::new(self.told(lesson, number, step, stage, whole))))
    }

    fn told(&self, lesson: &Lesson, number: usize, step: &Step, stage: Stage, whole: Arc<Scene>) -> Staged {
        let earlier = lesson.steps[..number].iter().map(|step| step.questions().count()).sum();
        let mut teller = Teller { stage: &stage, findings: Vec::new(), posed: Vec::new(), asked: earlier };
        let opening = if number == 0 { teller.tell(&lesson.opening) } else { Vec::new() };
        let parts = step.parts.iter().filter_map(|part| teller.part(part)).collect();
        let t = step.t.as_ref().and_then(|t| teller.number(t));
        let Teller { findings, posed, .. } = teller;
        let glossary = &self.lessons.course.glossary;
        let (opening, parts) = link_once(opening, parts, |prose| glossary.linked(prose));
        let marked = step.highlight.iter().flat_map(|query| query.value.matches(&stage.tree).collect::<Vec<_>>());
        let meaning = |term: &Term| (term.name.clone(), stage.tell(&term.meaning, &mut Vec::new()));
        Staged {
            step: number,
            whole,
            scene_name: self.scene_name(lesson, &stage.aim.scene),
            opening,
            parts,
            posed,
            level: step.level,
            views: panes(&step.views),
            after: panes(&step.after),
            t,
            marked: marked.collect(),
            terms: glossary.terms.iter().map(meaning).collect(),
            findings,
            stage,
        }
    }

    /// The name that a scene is opened under: that of its file, where it lies beside the lesson.
    fn scene_name(&self, lesson: &Lesson, name: &str) -> String {
        let shelf = &self.lessons.shelf;
        let is_beside = shelf.text(&lesson.id, name).is_some();
        match shelf.file(&lesson.id) {
            Some(file) if is_beside => file.with_file_name(name).display().to_string(),
            None if is_beside && embedded_scene(name).is_none() => format!("lessons/{}/{name}", lesson.id),
            _ => name.to_owned(),
        }
    }
}

/// The panels that show these drawings, each once.
fn panes(views: &[Sited<&'static View>]) -> Vec<Pane> {
    let mut panes = Vec::new();
    for pane in views.iter().filter_map(|view| pane_named(view.value.name)) {
        if !panes.contains(&pane) {
            panes.push(pane);
        }
    }
    panes
}
