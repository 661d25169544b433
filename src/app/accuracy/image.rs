//! The accuracy of the whole image: error against seconds, filling in while it is measured, and maps of the chosen setting.

use crate::app::accuracy::chart::{Chart, MapOf, View};
use crate::app::accuracy::pane::Wish;
use crate::app::accuracy::point::{Shown, chosen_point, list};
use crate::app::frame::background::Background;
use crate::app::frame::task::{self, Task};
use crate::app::frame::words::{say, say_with};
use crate::app::workbench::OpenScene;
use crate::cpu_time;
use crate::laboratory::{MapKind, NoStore, Plan, Study, Tools, study};
use crate::scene::Scene;
use crate::trace::Progress;
use egui::{Button, Context, Rect, ScrollArea, Ui, UiBuilder, vec2};
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use std::time::Duration;
use web_time::Instant;

/// About how long a study takes, in seconds: what a person will wait for while the plot fills in.
const BUDGET: f64 = 20.0;
/// The most columns of the pictures that are measured.
const WIDTH: u32 = 160;
/// Between two plots of a study that goes on. A new one for each round would keep a core busy with drawing.
const BETWEEN: Duration = Duration::from_millis(400);
/// Width of the column of settings, in points.
const COLUMN: f32 = 330.0;
/// Between the list of settings and the chosen one, in points.
const GAP: f32 = 8.0;
/// The share of the height that the list has where there is too little for both.
const LIST: f32 = 0.4;

/// What is remembered of the image between frames.
#[derive(Default)]
pub struct ImageScope {
    job: Option<Background<Study>>,
    study: Option<Arc<Study>>,
    is_complete: bool,
    /// The name of the chosen setting; none for the scene as it stands.
    chosen: Option<String>,
    view: View,
    chart: Chart,
    shown: Option<Shown>,
    /// The heights of the list and of the chosen setting in the frame before, in points.
    heights: [f32; 2],
}

impl ImageScope {
    /// Stops what is running. What was measured stays.
    pub fn pause(&mut self) {
        self.job = None;
        self.chart.pause();
    }

    /// How far the study is, in words.
    pub fn state(&self, ctx: &Context) -> String {
        let count = |study: &Study| study.all().count();
        let seconds = |job: &Background<Study>| format!("{:.0}", job.seconds());
        match (&self.job, &self.study) {
            (Some(job), None) => say_with(ctx, "accuracy-rendering", &[("seconds", (&seconds(job)).into())]),
            (Some(job), Some(study)) => {
                let (seconds, budget) = (seconds(job), format!("{BUDGET:.0}"));
                let values =
                    [("count", count(study).into()), ("seconds", (&seconds).into()), ("budget", (&budget).into())];
                say_with(ctx, "accuracy-measuring", &values)
            }
            (None, Some(study)) if self.is_complete => {
                let percent = format!("{:.0}", 100.0 * study.waiting);
                let values = [("count", count(study).into()), ("percent", (&percent).into())];
                say_with(ctx, "accuracy-measured", &values)
            }
            (None, Some(study)) => say_with(ctx, "accuracy-measured-less", &[("count", count(study).into())]),
            (None, None) => say(ctx, "accuracy-nothing"),
        }
    }

    /// Shows plot or map, settings and the chosen one; returns what is asked for.
    pub fn ui(&mut self, ui: &mut Ui, open: &OpenScene) -> Option<Wish> {
        self.measure(ui, &open.whole);
        ui.horizontal_wrapped(|ui| {
            ui.selectable_value(&mut self.view, View::Plot, say(ui.ctx(), "accuracy-plot"));
            for (kind, word) in MAPS {
                let tip = say(ui.ctx(), &format!("{word}-about"));
                ui.selectable_value(&mut self.view, View::Map(kind), say(ui.ctx(), word)).on_hover_text(tip);
            }
            let again = ui.add_enabled(self.job.is_none(), Button::new(say(ui.ctx(), "accuracy-again")));
            if again.on_hover_text(say(ui.ctx(), "accuracy-again-about")).clicked() {
                *self = Self { chosen: self.chosen.take(), view: self.view, ..Self::default() };
            }
        });
        let whole = ui.available_rect_before_wrap();
        let (left, right) = whole.split_left_right_at_x(whole.right() - COLUMN);
        let Some(study) = self.study.clone() else {
            ui.allocate_rect(whole, egui::Sense::hover());
            return None;
        };
        let points: Vec<_> = study.all().collect();
        let place = points.iter().position(|point| Some(point.plain_name()) == self.chosen).unwrap_or(0);
        let left = left.with_max_x(left.right() - 12.0);
        let chosen = match self.view {
            View::Plot => self.chart.plot(ui, left, &study, &open.name, place),
            View::Map(kind) => {
                let of = MapOf { kind, study: Arc::clone(&study), place };
                self.chart.map(ui, left, &of, &open.whole);
                None
            }
        };
        let (above, below) = right.split_top_bottom_at_y(right.top() + list_height(right.height() - GAP, self.heights));
        let below = below.with_min_y(below.top() + GAP);
        let (listed, list_height) = column(ui, "settings", above, |ui| list(ui, &study, place));
        let setting = |ui: &mut Ui| chosen_point(ui, &mut self.shown, &study, place);
        let ((paired, wish), setting_height) = column(ui, "setting", below, setting);
        let heights = [list_height, setting_height];
        if std::mem::replace(&mut self.heights, heights) != heights {
            ui.ctx().request_repaint();
        }
        if let Some(place) = chosen.or(listed).or(paired) {
            self.chosen = points.get(place).map(|point| point.plain_name());
            ui.ctx().request_repaint();
        }
        wish
    }

    /// Measures the scene once, and takes what there is of it.
    fn measure(&mut self, ui: &Ui, whole: &Arc<Scene>) {
        if self.study.is_none() && self.job.is_none() {
            self.job = task::begin(ui.ctx(), whole, MeasureAccuracy);
        }
        let Some(job) = &self.job else { return };
        let finished = job.is_finished();
        if let Some(study) = job.take() {
            self.study = Some(Arc::new(study));
        }
        if finished {
            (self.job, self.is_complete) = (None, true);
        } else {
            // The seconds are counted.
            ui.ctx().request_repaint_after(Duration::from_millis(250));
        }
    }
}

/// The maps, with their names in the catalogue of words.
const MAPS: [(MapKind, &str); 4] = [
    (MapKind::Error, "accuracy-map-error"),
    (MapKind::Digits, "accuracy-map-digits"),
    (MapKind::Tier, "accuracy-map-certainty"),
    (MapKind::Time, "accuracy-map-time"),
];

/// To measure what accuracy costs in a scene.
#[derive(Serialize, Deserialize)]
pub struct MeasureAccuracy;

impl Task for MeasureAccuracy {
    const NAME: &'static str = "accuracy";
    type News = Study;

    fn run(self, scene: &Arc<Scene>, progress: &Progress, publish: &mut dyn FnMut(Study)) {
        run(scene, progress, publish);
    }
}

/// Runs a study; publishes what is known now and then, and the end.
fn run(scene: &Scene, progress: &Progress, publish: &mut dyn FnMut(Study)) {
    let plan = Plan { width: WIDTH, budget: BUDGET, ..Plan::default() };
    let mut last: Option<Instant> = None;
    let mut watch = |known: &dyn Fn() -> Study| {
        if last.is_none_or(|last| last.elapsed() >= BETWEEN) {
            publish(known());
            last = Some(Instant::now());
        }
    };
    let (mut stopwatch, mut store) = (cpu_time::taken, NoStore);
    let tools = Tools { stopwatch: &mut stopwatch, store: &mut store, progress, watch: &mut watch };
    let run = study(scene, &plan, None, tools);
    if let Some(run) = run {
        publish(run.study);
    }
}

/// How high the list of settings is: as high as it needs to be, unless the chosen one would not have enough.
fn list_height(room: f32, [list, setting]: [f32; 2]) -> f32 {
    // A point more than they need: what just fits would be scrolled for a rounding error.
    let most = (room - setting - 1.0).max(LIST * room);
    if list == 0.0 { LIST * room } else { (list + 1.0).min(most) }
}

/// Contents in a rectangle that scroll where they need to, and how high they are.
fn column<T>(ui: &mut Ui, salt: &str, rect: Rect, contents: impl FnOnce(&mut Ui) -> T) -> (T, f32) {
    ui.scope_builder(UiBuilder::new().id_salt(salt.to_owned()).max_rect(rect), |ui| {
        ui.spacing_mut().item_spacing = vec2(8.0, 4.0);
        let shown = ScrollArea::vertical().id_salt(salt.to_owned()).auto_shrink(false).show(ui, contents);
        (shown.inner, shown.content_size.y)
    })
    .inner
}
