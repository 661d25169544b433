//! The settings of a study as a list, and the chosen one: its picture beside the scene's, its figures, and what to choose instead.

use crate::app::accuracy::pane::Wish;
use crate::app::frame::theme::{Palette, bold};
use crate::app::picture::thumbnail::{difference, texture, thumbnail};
use crate::laboratory::{Point, Study};
use crate::view::{brief, seconds, significant};
use egui::{Button, Context, FontFamily, Grid, Label, Response, RichText, TextureHandle, Ui};
use std::sync::Arc;

/// Width of the small pictures, in points.
const SMALL: f32 = 98.0;
/// Width of a setting's name in the list, in points.
const NAME: f32 = 180.0;

/// The pictures of the chosen setting, ready to be shown.
pub struct Shown {
    study: Arc<Study>,
    place: usize,
    standard: TextureHandle,
    own: TextureHandle,
    off: (TextureHandle, u8),
    closer: Option<(usize, TextureHandle)>,
    faster: Option<(usize, TextureHandle)>,
}

impl Shown {
    fn new(ctx: &Context, study: &Arc<Study>, place: usize) -> Option<Self> {
        let point = study.all().nth(place)?;
        let of = |place: usize| Some((place, texture(ctx, "pair", &study.all().nth(place)?.picture)));
        Some(Self {
            study: Arc::clone(study),
            place,
            standard: texture(ctx, "as it stands", &study.standard.picture),
            own: texture(ctx, "setting", &point.picture),
            off: difference(ctx, &point.picture, &study.reference.picture),
            closer: study.as_fast_but_closer(point).and_then(of),
            faster: study.as_close_but_faster(point).and_then(of),
        })
    }
}

/// All settings with their times and errors; returns the place of the one that was clicked.
pub fn list(ui: &mut Ui, study: &Study, chosen: usize) -> Option<usize> {
    let palette = Palette::current(ui.ctx());
    let mut clicked = None;
    Grid::new("settings").num_columns(3).striped(true).spacing([10.0, 2.0]).show(ui, |ui| {
        for title in ["setting", "time", "error"] {
            ui.label(RichText::new(title).small().weak());
        }
        ui.end_row();
        for (place, point) in study.all().enumerate() {
            if named(ui, point, place == chosen).clicked() {
                clicked = Some(place);
            }
            let ink = if point.on_frontier { palette.text } else { palette.weak };
            ui.label(RichText::new(time(point)).monospace().color(ink));
            ui.label(RichText::new(error(point)).monospace().color(ink));
            ui.end_row();
        }
    });
    clicked
}

/// A setting's name as a button that is no wider than there is room for.
fn named(ui: &mut Ui, point: &Point, is_chosen: bool) -> Response {
    let name = point.plain_name();
    let text = RichText::new(&name).small().family(if point.on_frontier { bold() } else { FontFamily::Proportional });
    let button = Button::selectable(is_chosen, text).truncate();
    let shown = ui.scope(|ui| {
        ui.set_max_width(NAME);
        ui.add(button)
    });
    shown.inner.on_hover_text(format!("{name}. {}", meaning(point)))
}

fn meaning(point: &Point) -> &'static str {
    if point.is_control() {
        "A control: it must change nothing but the time."
    } else if point.timing.told().is_none() {
        "Its time is lost in noise: the machine was busy with other things."
    } else if point.on_frontier {
        "On the frontier: nothing that was measured is both faster and closer."
    } else {
        "Something that was measured is both faster and closer."
    }
}

fn time(point: &Point) -> String {
    point.timing.told().map_or_else(|| "noise".to_owned(), seconds)
}

fn error(point: &Point) -> String {
    match point.errors.rmse {
        0.0 => "0, exactly".to_owned(),
        error => significant(error, 2),
    }
}

/// The chosen setting; returns the place of another one that was chosen instead, and what is asked of the workbench.
pub fn chosen_point(
    ui: &mut Ui,
    shown: &mut Option<Shown>,
    study: &Arc<Study>,
    place: usize,
) -> (Option<usize>, Option<Wish>) {
    let is_shown = |shown: &Shown| Arc::ptr_eq(&shown.study, study) && shown.place == place;
    if !shown.as_ref().is_some_and(is_shown) {
        *shown = Shown::new(ui.ctx(), study, place);
    }
    let (Some(shown), Some(point)) = (shown.as_ref(), study.all().nth(place)) else { return (None, None) };
    let mut wish = None;
    ui.vertical(|ui| {
        ui.add(Label::new(RichText::new(point.plain_name()).family(bold()).size(14.5)).wrap());
        if !point.settings.is_empty() {
            let look = ui.button("Look at the scene so");
            if look.on_hover_text("Renders the whole picture with this setting, and records rays with it.").clicked() {
                wish = Some(Wish::Look(point.name(), point.profile));
            }
        }
    });
    pictures(ui, shown);
    figures(ui, point);
    (pairs(ui, study, shown, point), wish)
}

fn pictures(ui: &mut Ui, shown: &Shown) {
    let (off, largest) = &shown.off;
    let off_by = format!("How far it is from the reference: the brightest pixel differs by {largest} of 255");
    let columns = [
        ("as it stands", &shown.standard, "The scene as it stands".to_owned()),
        ("this setting", &shown.own, "With this setting".to_owned()),
        ("off by", off, off_by),
    ];
    Grid::new("pictures").num_columns(3).spacing([8.0, 2.0]).show(ui, |ui| {
        for (_, texture, meaning) in &columns {
            thumbnail(ui, texture, SMALL, meaning);
        }
        ui.end_row();
        for (name, ..) in &columns {
            ui.label(RichText::new(*name).small().weak());
        }
    });
}

fn figures(ui: &mut Ui, point: &Point) {
    let timing = &point.timing;
    let share = if timing.seconds > 0.0 { 100.0 * timing.spread / timing.seconds } else { 0.0 };
    let taken = match timing.noise {
        Some(noise) => noise.describe(),
        None => format!("{} ± {share:.1} %, {} times", seconds(timing.seconds), timing.repeats),
    };
    let errors = &point.errors;
    let rows = [
        ("time", taken),
        ("error", format!("{}, root mean square; {} at 99.9 %", error(point), significant(errors.p999, 2))),
        ("wrong", format!("{} pixels, 1 − SSIM {}", errors.wrong_pixels, significant(errors.dissimilarity, 2))),
    ];
    Grid::new("figures").num_columns(2).spacing([10.0, 1.0]).show(ui, |ui| {
        for (name, value) in rows {
            ui.label(RichText::new(name).small().weak());
            ui.label(RichText::new(value).small());
            ui.end_row();
        }
    });
}

/// What is as fast and closer, and what is as close and faster; returns the one that was clicked.
fn pairs(ui: &mut Ui, study: &Study, shown: &Shown, point: &Point) -> Option<usize> {
    let mut clicked = None;
    let pairs = [("as fast, but closer", &shown.closer), ("as close, but faster", &shown.faster)];
    if pairs.iter().all(|(_, pair)| pair.is_none()) {
        let words = if point.timing.told().is_none() {
            "With a time that is lost in noise it cannot be compared."
        } else {
            "Nothing that was measured is as fast and clearly closer, or as close and clearly faster."
        };
        ui.add(Label::new(RichText::new(words).small().weak()).wrap());
        return None;
    }
    Grid::new("pairs").num_columns(2).spacing([8.0, 4.0]).show(ui, |ui| {
        for (title, pair) in pairs {
            let Some((place, texture)) = pair else { continue };
            let Some(other) = study.all().nth(*place) else { continue };
            thumbnail(ui, texture, SMALL, &other.plain_name());
            ui.vertical(|ui| {
                ui.label(RichText::new(title).small().weak());
                let button = ui.add(Button::new(RichText::new(other.plain_name()).small()).truncate());
                if button.on_hover_text("Choose it.").clicked() {
                    clicked = Some(*place);
                }
                ui.label(RichText::new(gain(other, point)).small());
            });
            ui.end_row();
        }
    });
    clicked
}

/// By how much a pair differs, in words.
fn gain(other: &Point, point: &Point) -> String {
    let times = other.timing.seconds / point.timing.seconds;
    let errors = other.errors.rmse / point.errors.rmse;
    let errors = if errors.is_finite() { format!("{} × the error", brief(rounded(errors))) } else { error(other) };
    format!("{} × the time, {errors}", brief(rounded(times)))
}

/// Two digits after the point.
fn rounded(x: f64) -> f64 {
    (100.0 * x).round() / 100.0
}
