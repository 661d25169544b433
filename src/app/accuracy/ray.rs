//! The accuracy of the selected ray: what each method takes for it, how many digits it gets right, and where it loses them.

use crate::app::accuracy::pane::Wish;
use crate::app::frame::background::Background;
use crate::app::frame::empty::empty;
use crate::app::frame::theme::{Palette, bold};
use crate::app::frame::words::{say, say_with};
use crate::app::story::recording::Recording;
use crate::app::workbench::OpenScene;
use crate::cpu_time;
use crate::laboratory::{Story, Target, ThisRay, Timing, this_ray, time_methods};
use crate::record::EventId;
use crate::scene::Scene;
use crate::view::{row, seconds, significant};
use egui::{Context, Grid, Label, RichText, ScrollArea, Ui};
use std::sync::Arc;

/// How often each method is timed.
const REPEATS: u32 = 7;
/// The loss of less than this many digits is not listed.
const LEAST_LOSS: f64 = 0.5;
/// At most so many losses are listed.
const MOST_LOSSES: usize = 12;

/// What is known of a ray.
#[derive(Clone)]
struct Known {
    ray: Arc<ThisRay>,
    /// Of each method, once they were measured.
    timings: Arc<[Timing]>,
}

/// Which ray.
#[derive(Clone)]
struct Asked {
    scene: Arc<Scene>,
    pixel: [u32; 2],
}

impl PartialEq for Asked {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.scene, &other.scene) && self.pixel == other.pixel
    }
}

/// What is remembered of the ray between frames.
#[derive(Default)]
pub struct RayScope {
    asked: Option<Asked>,
    job: Option<Background<Known>>,
    /// Whether the job is about another ray than the one that is asked for.
    is_stale: bool,
    known: Option<Known>,
}

impl RayScope {
    /// Stops what is running. What is known stays.
    pub fn pause(&mut self) {
        if self.job.take().is_some() {
            (self.asked, self.is_stale) = (None, false);
        }
    }

    /// What is shown, in words.
    pub fn state(&self, ctx: &Context, recording: Option<&Recording>) -> String {
        let Some([x, y]) = recording.map(|recording| recording.pixel) else {
            return say(ctx, "accuracy-ray-none");
        };
        let word = match (&self.known, &self.job) {
            (None, _) => "accuracy-ray-tracing",
            (Some(_), Some(_)) => "accuracy-ray-measuring",
            (Some(_), None) => "accuracy-ray-done",
        };
        say_with(ctx, word, &[("x", x.into()), ("y", y.into())])
    }

    /// Shows the methods and the losses of the chosen one; returns what is asked for.
    pub fn ui(&mut self, ui: &mut Ui, open: &OpenScene, recording: Option<&Recording>) -> Option<Wish> {
        let Some(recording) = recording else {
            empty(ui, &say(ui.ctx(), "accuracy-ray-click"));
            return None;
        };
        self.follow(ui, &Asked { scene: Arc::clone(&open.scene), pixel: recording.pixel });
        let known = self.known.clone()?;
        let mut wish = None;
        ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
            wish = methods(ui, &known, recording);
            ui.add_space(12.0);
            let told = known.ray.stories.iter().find(|story| Some(story.method) == recording.by);
            if let Some(story) = told {
                wish = losses(ui, story, recording).or(wish.take());
            } else {
                ui.label(RichText::new(say(ui.ctx(), "accuracy-ray-choose")).weak());
            }
        });
        wish
    }

    /// Works out what is asked for, once. A ray that is not asked for any more is finished with first: it cannot be left in the
    /// middle, and many at a time would keep the machine busy.
    fn follow(&mut self, ui: &Ui, asked: &Asked) {
        if self.asked.as_ref() != Some(asked) {
            (self.asked, self.known) = (Some(asked.clone()), None);
            self.job.iter().for_each(Background::cancel);
            self.is_stale = self.job.is_some();
        }
        if let Some(job) = &self.job {
            let finished = job.is_finished();
            let news = job.take().filter(|_| !self.is_stale);
            self.known = news.or(self.known.take());
            if finished {
                (self.job, self.is_stale) = (None, false);
            }
        }
        if self.job.is_none() && self.known.is_none() {
            self.job = start(ui, asked.clone());
        }
    }
}

fn start(ui: &Ui, asked: Asked) -> Option<Background<Known>> {
    Background::start(ui.ctx(), "this ray", move |progress, publish| {
        let target = Target::Pixel(asked.pixel);
        let ray = Arc::new(this_ray(&asked.scene, target));
        publish(Known { ray: Arc::clone(&ray), timings: Arc::new([]) });
        let mut stopwatch = cpu_time::taken;
        let timings = time_methods(&asked.scene, target, &mut stopwatch, REPEATS, &|| progress.cancelled());
        publish(Known { ray, timings: timings.into() });
    })
}

/// The titles of the columns, by their names in the catalogue of words.
const METHOD_TITLES: [&str; 5] =
    ["accuracy-method", "accuracy-takes", "accuracy-hit-digits", "accuracy-colour-digits", "accuracy-otherwise"];

/// A row for each method; returns the story that was chosen.
fn methods(ui: &mut Ui, known: &Known, recording: &Recording) -> Option<Wish> {
    let palette = Palette::current(ui.ctx());
    let mut wish = None;
    Grid::new("methods").num_columns(5).striped(true).spacing([18.0, 6.0]).show(ui, |ui| {
        for title in METHOD_TITLES {
            ui.label(RichText::new(say(ui.ctx(), title)).small().weak());
        }
        ui.end_row();
        for (k, story) in known.ray.stories.iter().enumerate() {
            let label = ui.selectable_label(recording.by == Some(story.method), story.method.name());
            if label.on_hover_text(say(ui.ctx(), "accuracy-ray-show")).clicked() {
                wish = Some(told(story, first(story)));
            }
            ui.label(
                RichText::new(known.timings.get(k).map_or_else(|| "…".to_owned(), |timing| taken(ui.ctx(), timing)))
                    .monospace(),
            );
            ui.label(
                RichText::new(
                    story
                        .hit_digits()
                        .map_or_else(|| say(ui.ctx(), "accuracy-no-hit"), |right| digits(ui.ctx(), right)),
                )
                .monospace(),
            );
            ui.label(RichText::new(digits(ui.ctx(), story.colour_digits(&known.ray.exact))).monospace());
            match &story.parting {
                Some(parting) => ui.add(Label::new(RichText::new(&parting.reason).color(palette.problem)).wrap()),
                None => ui.label(RichText::new(say(ui.ctx(), "accuracy-same")).color(palette.weak)),
            };
            ui.end_row();
        }
    });
    wish
}

/// The first event that is not as it should be: where the story parts from the exact one, else where most digits are lost,
/// else the hit.
fn first(story: &Story) -> EventId {
    let parting = story.parting.as_ref().map(|parting| parting.event);
    parting.or_else(|| story.losses(LEAST_LOSS).first().copied()).or_else(|| story.hit()).unwrap_or(0)
}

fn told(story: &Story, event: EventId) -> Wish {
    Wish::Story(story.method, Arc::new(story.tree.clone()), event)
}

/// Where the chosen method loses digits; returns the event that was chosen.
fn losses(ui: &mut Ui, story: &Story, recording: &Recording) -> Option<Wish> {
    let losses = story.losses(LEAST_LOSS);
    let name = story.method.name();
    if losses.is_empty() {
        ui.label(RichText::new(say_with(ui.ctx(), "accuracy-loses-none", &[("name", name.into())])).weak());
        return None;
    }
    ui.label(RichText::new(say_with(ui.ctx(), "accuracy-loses", &[("name", name.into())])).family(bold()));
    let mut wish = None;
    Grid::new("losses").num_columns(4).striped(true).spacing([18.0, 3.0]).show(ui, |ui| {
        for title in ["accuracy-lost", "accuracy-right", "accuracy-worst", "accuracy-event"] {
            ui.label(RichText::new(say(ui.ctx(), title)).small().weak());
        }
        ui.end_row();
        for &event in losses.iter().take(MOST_LOSSES) {
            let about = &story.told[event as usize];
            ui.label(RichText::new(tenths(about.lost)).monospace());
            ui.label(RichText::new(about.right.map_or_else(String::new, |right| digits(ui.ctx(), right))).monospace());
            let worst = about
                .worst()
                .map_or_else(String::new, |number| format!("{} ± {}", number.name, significant(number.error, 2)));
            ui.label(RichText::new(worst).monospace());
            let shown = row(story.tree.event(event)).label;
            if ui.selectable_label(recording.selected() == event, shown).clicked() {
                wish = Some(told(story, event));
            }
            ui.end_row();
        }
    });
    if losses.len() > MOST_LOSSES {
        ui.label(
            RichText::new(say_with(ui.ctx(), "accuracy-more", &[("count", (losses.len() - MOST_LOSSES).into())]))
                .small()
                .weak(),
        );
    }
    wish
}

fn taken(ctx: &Context, timing: &Timing) -> String {
    timing.told().map_or_else(|| say(ctx, "accuracy-noise"), seconds)
}

fn digits(ctx: &Context, digits: f64) -> String {
    if digits.is_infinite() { say(ctx, "accuracy-all") } else { tenths(digits) }
}

fn tenths(x: f64) -> String {
    format!("{x:.1}")
}
