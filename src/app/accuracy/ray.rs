//! The accuracy of the selected ray: what each method takes for it, how many digits it gets right, and where it loses them.

use crate::app::accuracy::pane::Wish;
use crate::app::frame::background::Background;
use crate::app::frame::empty::empty;
use crate::app::frame::theme::{Palette, bold};
use crate::app::story::recording::Recording;
use crate::app::workbench::OpenScene;
use crate::cpu_time;
use crate::laboratory::{Story, Target, ThisRay, Timing, this_ray, time_methods};
use crate::record::EventId;
use crate::scene::Scene;
use crate::view::{row, seconds, significant};
use egui::{Grid, Label, RichText, ScrollArea, Ui};
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
    pub fn state(&self, recording: Option<&Recording>) -> String {
        let Some([x, y]) = recording.map(|recording| recording.pixel) else {
            return "No pixel is recorded.".to_owned();
        };
        match (&self.known, &self.job) {
            (None, _) => format!("Pixel ({x}, {y}): tracing it by every method"),
            (Some(_), Some(_)) => format!("Pixel ({x}, {y}): measuring what every method takes"),
            (Some(_), None) => format!("Pixel ({x}, {y}) by every method, against hits of 77 digits"),
        }
    }

    /// Shows the methods and the losses of the chosen one; returns what is asked for.
    pub fn ui(&mut self, ui: &mut Ui, open: &OpenScene, recording: Option<&Recording>) -> Option<Wish> {
        let Some(recording) = recording else {
            empty(ui, "Click a pixel of the picture: its ray is traced by every method.");
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
                let words = "Choose a method: its story is shown, from the first event on that is not as it should be.";
                ui.label(RichText::new(words).weak());
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

/// A row for each method; returns the story that was chosen.
fn methods(ui: &mut Ui, known: &Known, recording: &Recording) -> Option<Wish> {
    let palette = Palette::current(ui.ctx());
    let mut wish = None;
    Grid::new("methods").num_columns(5).striped(true).spacing([18.0, 6.0]).show(ui, |ui| {
        for title in
            ["method", "this ray takes", "digits right of the hit time", "of the colour", "what happens otherwise"]
        {
            ui.label(RichText::new(title).small().weak());
        }
        ui.end_row();
        for (k, story) in known.ray.stories.iter().enumerate() {
            let label = ui.selectable_label(recording.by == Some(story.method), story.method.name());
            if label.on_hover_text("Show its story.").clicked() {
                wish = Some(told(story, first(story)));
            }
            ui.label(RichText::new(known.timings.get(k).map_or_else(|| "…".to_owned(), taken)).monospace());
            ui.label(RichText::new(story.hit_digits().map_or_else(|| "no hit".to_owned(), digits)).monospace());
            ui.label(RichText::new(digits(story.colour_digits(&known.ray.exact))).monospace());
            match &story.parting {
                Some(parting) => ui.add(Label::new(RichText::new(&parting.reason).color(palette.problem)).wrap()),
                None => ui.label(RichText::new("nothing").color(palette.weak)),
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
        ui.label(RichText::new(format!("{name} loses no digits in any event of this ray.")).weak());
        return None;
    }
    ui.label(RichText::new(format!("Where {name} loses digits")).family(bold()));
    let mut wish = None;
    Grid::new("losses").num_columns(4).striped(true).spacing([18.0, 3.0]).show(ui, |ui| {
        for title in ["lost", "right", "worst number", "event"] {
            ui.label(RichText::new(title).small().weak());
        }
        ui.end_row();
        for &event in losses.iter().take(MOST_LOSSES) {
            let about = &story.told[event as usize];
            ui.label(RichText::new(tenths(about.lost)).monospace());
            ui.label(RichText::new(about.right.map_or_else(String::new, digits)).monospace());
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
        ui.label(RichText::new(format!("and {} more", losses.len() - MOST_LOSSES)).small().weak());
    }
    wish
}

fn taken(timing: &Timing) -> String {
    timing.told().map_or_else(|| "noise".to_owned(), seconds)
}

fn digits(digits: f64) -> String {
    if digits.is_infinite() { "all".to_owned() } else { tenths(digits) }
}

fn tenths(x: f64) -> String {
    format!("{x:.1}")
}
