//! The settings of a study as a list, and the chosen one: its picture beside the scene's, its figures, and what to choose instead.

use crate::app::accuracy::pane::Wish;
use crate::app::frame::theme::{Palette, bold};
use crate::app::frame::words::{say, say_with};
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
        for title in ["accuracy-setting", "accuracy-time", "accuracy-error"] {
            ui.label(RichText::new(say(ui.ctx(), title)).small().weak());
        }
        ui.end_row();
        for (place, point) in study.all().enumerate() {
            if named(ui, point, place == chosen).clicked() {
                clicked = Some(place);
            }
            let ink = if point.on_frontier { palette.text } else { palette.weak };
            ui.label(RichText::new(time(ui.ctx(), point)).monospace().color(ink));
            ui.label(RichText::new(error(ui.ctx(), point)).monospace().color(ink));
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
    shown.inner.on_hover_text(format!("{name}. {}", say(ui.ctx(), meaning(point))))
}

/// What a point is, by its name in the catalogue of words.
fn meaning(point: &Point) -> &'static str {
    if point.is_control() {
        "accuracy-is-control"
    } else if point.timing.told().is_none() {
        "accuracy-is-noise"
    } else if point.on_frontier {
        "accuracy-is-frontier"
    } else {
        "accuracy-is-beaten"
    }
}

fn time(ctx: &Context, point: &Point) -> String {
    point.timing.told().map_or_else(|| say(ctx, "accuracy-noise"), seconds)
}

fn error(ctx: &Context, point: &Point) -> String {
    match point.errors.rmse {
        0.0 => say(ctx, "accuracy-exact"),
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
            let look = ui.button(say(ui.ctx(), "accuracy-look"));
            if look.on_hover_text(say(ui.ctx(), "accuracy-look-about")).clicked() {
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
    let largest = u32::from(*largest);
    let off_by = say_with(ui.ctx(), "accuracy-off-by-about", &[("largest", largest.into())]);
    let columns = [
        ("accuracy-stands", &shown.standard, say(ui.ctx(), "accuracy-stands-about")),
        ("accuracy-own", &shown.own, say(ui.ctx(), "accuracy-own-about")),
        ("accuracy-off-by", off, off_by),
    ];
    Grid::new("pictures").num_columns(3).spacing([8.0, 2.0]).show(ui, |ui| {
        for (_, texture, meaning) in &columns {
            thumbnail(ui, texture, SMALL, meaning);
        }
        ui.end_row();
        for (name, ..) in &columns {
            ui.label(RichText::new(say(ui.ctx(), name)).small().weak());
        }
    });
}

fn figures(ui: &mut Ui, point: &Point) {
    let timing = &point.timing;
    let share = if timing.seconds > 0.0 { 100.0 * timing.spread / timing.seconds } else { 0.0 };
    let taken = if let Some(noise) = timing.noise {
        noise.describe()
    } else {
        let told = format!("{} ± {share:.1} %", seconds(timing.seconds));
        say_with(ui.ctx(), "accuracy-times", &[("time", (&told).into()), ("count", timing.repeats.into())])
    };
    let errors = &point.errors;
    let rows = [
        ("accuracy-time", taken),
        ("accuracy-error", {
            let (rms, p999) = (error(ui.ctx(), point), significant(errors.p999, 2));
            say_with(ui.ctx(), "accuracy-rms", &[("rms", (&rms).into()), ("p999", (&p999).into())])
        }),
        ("accuracy-wrong", {
            let (pixels, ssim) = (errors.wrong_pixels.to_string(), significant(errors.dissimilarity, 2));
            say_with(ui.ctx(), "accuracy-wrong-pixels", &[("pixels", (&pixels).into()), ("ssim", (&ssim).into())])
        }),
    ];
    Grid::new("figures").num_columns(2).spacing([10.0, 1.0]).show(ui, |ui| {
        for (name, value) in rows {
            ui.label(RichText::new(say(ui.ctx(), name)).small().weak());
            ui.label(RichText::new(value).small());
            ui.end_row();
        }
    });
}

/// What is as fast and closer, and what is as close and faster; returns the one that was clicked.
fn pairs(ui: &mut Ui, study: &Study, shown: &Shown, point: &Point) -> Option<usize> {
    let mut clicked = None;
    let pairs = [("accuracy-closer", &shown.closer), ("accuracy-faster", &shown.faster)];
    if pairs.iter().all(|(_, pair)| pair.is_none()) {
        let words = if point.timing.told().is_none() { "accuracy-not-compared" } else { "accuracy-no-pair" };
        ui.add(Label::new(RichText::new(say(ui.ctx(), words)).small().weak()).wrap());
        return None;
    }
    Grid::new("pairs").num_columns(2).spacing([8.0, 4.0]).show(ui, |ui| {
        for (title, pair) in pairs {
            let Some((place, texture)) = pair else { continue };
            let Some(other) = study.all().nth(*place) else { continue };
            thumbnail(ui, texture, SMALL, &other.plain_name());
            ui.vertical(|ui| {
                ui.label(RichText::new(say(ui.ctx(), title)).small().weak());
                let button = ui.add(Button::new(RichText::new(other.plain_name()).small()).truncate());
                if button.on_hover_text(say(ui.ctx(), "accuracy-choose")).clicked() {
                    clicked = Some(*place);
                }
                ui.label(RichText::new(gain(ui.ctx(), other, point)).small());
            });
            ui.end_row();
        }
    });
    clicked
}

/// By how much a pair differs, in words.
fn gain(ctx: &Context, other: &Point, point: &Point) -> String {
    let times = other.timing.seconds / point.timing.seconds;
    let errors = other.errors.rmse / point.errors.rmse;
    let errors = if errors.is_finite() {
        say_with(ctx, "accuracy-times-error", &[("factor", (&brief(rounded(errors))).into())])
    } else {
        error(ctx, other)
    };
    let factor = brief(rounded(times));
    say_with(ctx, "accuracy-times-time", &[("factor", (&factor).into()), ("errors", (&errors).into())])
}

/// Two digits after the point.
fn rounded(x: f64) -> f64 {
    (100.0 * x).round() / 100.0
}
