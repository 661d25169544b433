//! What another ray tracer printed, beside our own stories.

use crate::app::frame::background::Background;
use crate::app::frame::words::{say, say_with};
use crate::compare::foreign::{Comparison, ForeignTrace, Place, SHARE, StoryComparison, compare_foreign};
use crate::record::EventId;
use crate::scene::Scene;
use crate::trace::RayTree;
use egui::{Context, RichText, ScrollArea, Ui};
use std::sync::Arc;

/// Departing stories that are listed.
const LISTED: usize = 50;

/// A comparison, or why there is none.
type Answer = Result<Arc<Comparison>, String>;

/// What another ray tracer printed.
#[derive(Default)]
pub struct Foreign {
    name: String,
    /// Why it cannot be used.
    problem: Option<String>,
    trace: Option<Arc<ForeignTrace>>,
    shown: Option<(Arc<Scene>, Answer)>,
    running: Option<(Arc<Scene>, Background<Answer>)>,
}

/// A story of ours that is to be shown, at an event.
pub struct Shown {
    /// The scene.
    pub scene: Arc<Scene>,
    /// The pixel.
    pub pixel: [u32; 2],
    /// Our story.
    pub tree: RayTree,
    /// The event.
    pub event: EventId,
}

impl Foreign {
    /// Takes in what a file holds.
    pub fn open(&mut self, name: &str, text: &str) {
        *self = Self { name: name.to_owned(), ..Self::default() };
        match ForeignTrace::read(text) {
            Ok(trace) => self.trace = Some(Arc::new(trace)),
            Err(errors) => {
                let list: Vec<String> = errors.iter().map(ToString::to_string).collect();
                self.problem = Some(list.join("\n"));
            }
        }
    }

    /// Says that a file cannot be read.
    pub fn refuse(&mut self, name: &str, why: String) {
        *self = Self { name: name.to_owned(), problem: Some(why), ..Self::default() };
    }

    /// Whether there is anything.
    pub const fn is_open(&self) -> bool {
        self.trace.is_some() || self.problem.is_some()
    }

    /// Shows where it departs; returns the story that is to be shown.
    pub fn ui(&mut self, ui: &mut Ui, scene: &Arc<Scene>) -> Option<Shown> {
        if let Some(problem) = &self.problem {
            ui.label(
                RichText::new(say_with(ui.ctx(), "compare-unreadable", &[("name", (&self.name).into())])).strong(),
            );
            ui.label(RichText::new(problem).monospace());
            return None;
        }
        self.update(ui.ctx(), scene);
        let Some((_, found)) = &self.shown else {
            let word = if self.running.is_some() { "compare-working" } else { "compare-foreign-about" };
            ui.label(say(ui.ctx(), word));
            return None;
        };
        match found {
            Err(why) => {
                ui.label(why);
                None
            }
            Ok(comparison) => {
                ScrollArea::vertical()
                    .auto_shrink(false)
                    .id_salt("foreign")
                    .show(ui, |ui| report(ui, &self.name, scene, comparison))
                    .inner
            }
        }
    }

    fn update(&mut self, ctx: &Context, scene: &Arc<Scene>) {
        if let Some((of, job)) = &self.running
            && let Some(found) = job.take()
        {
            self.shown = Some((Arc::clone(of), found));
            self.running = None;
        }
        let is_of = |known: &Arc<Scene>| Arc::ptr_eq(known, scene);
        let is_known = self.shown.as_ref().is_some_and(|(known, _)| is_of(known))
            || self.running.as_ref().is_some_and(|(known, _)| is_of(known));
        if let Some(trace) = self.trace.clone().filter(|_| !is_known) {
            let of = Arc::clone(scene);
            let job = Background::start(ctx, "foreign", move |_, publish| {
                publish(compare_foreign(&of, &trace, SHARE).map(Arc::new));
            });
            self.running = job.map(|job| (Arc::clone(scene), job));
        }
    }
}

fn report(ui: &mut Ui, name: &str, scene: &Arc<Scene>, comparison: &Comparison) -> Option<Shown> {
    let departing: Vec<&StoryComparison> =
        comparison.stories.iter().filter(|story| story.departure.is_some()).collect();
    let arguments = [
        ("name", name.into()),
        ("stories", comparison.stories.len().into()),
        ("departing", departing.len().into()),
        ("checks", comparison.checks().into()),
    ];
    let word = if departing.is_empty() { "compare-foreign-same" } else { "compare-foreign-departs" };
    ui.label(RichText::new(say_with(ui.ctx(), word, &arguments)).strong());
    for note in &comparison.notes {
        ui.label(RichText::new(note).small().weak());
    }
    let mut asked = None;
    for story in departing.into_iter().take(LISTED) {
        ui.separator();
        if story_ui(ui, story)
            && let (Place::Pixel(pixel), Some(departure), Some(tree)) = (story.place, &story.departure, &story.tree)
        {
            let (scene, tree) = (Arc::clone(scene), tree.clone());
            asked = Some(Shown { scene, pixel, tree, event: departure.check.event });
        }
    }
    asked
}

/// One story that departs; returns whether it is to be shown.
fn story_ui(ui: &mut Ui, story: &StoryComparison) -> bool {
    let Some(departure) = &story.departure else { return false };
    let check = &departure.check;
    let mut is_asked = false;
    ui.horizontal_wrapped(|ui| {
        ui.label(RichText::new(story.place.words()).strong());
        ui.label(say_with(ui.ctx(), "compare-line", &[("line", check.line.into())]));
        ui.label(format!("{}: {}", departure.ray, check.subject.words()));
        if story.tree.is_some() && matches!(story.place, Place::Pixel(_)) {
            is_asked = ui.button(say(ui.ctx(), "compare-go-ours")).clicked();
        }
    });
    ui.label(&departure.event);
    let [ours, theirs] = check.texts();
    ui.label(RichText::new(say_with(ui.ctx(), "compare-ours", &[("value", (&ours).into())])).monospace());
    ui.label(RichText::new(say_with(ui.ctx(), "compare-theirs", &[("value", (&theirs).into())])).monospace());
    if departure.causes.is_empty() {
        ui.label(say(ui.ctx(), "compare-no-cause"));
    }
    for (place, explanation) in departure.causes.iter().take(3).enumerate() {
        let word = if place == 0 { "compare-cause" } else { "compare-other-cause" };
        ui.label(say_with(ui.ctx(), word, &[("cause", explanation.cause.says.into())]));
        ui.label(RichText::new(&explanation.evidence).small().weak());
    }
    is_asked
}
