//! The effects of the scene: a switch for each that it calls for, what it costs, and the picture without it.

use crate::app::effects::job::LedgerJob;
use crate::app::frame::code::with_code;
use crate::app::frame::theme::{Palette, bold};
use crate::app::frame::ticks;
use crate::app::frame::words::{say, say_with};
use crate::app::picture::thumbnail::{difference, texture, thumbnail};
use crate::app::workbench::OpenScene;
use crate::ledger::{Ledger, Price, Row};
use crate::record::Effect;
use crate::scene::{Effects, Reason, Scene, reasons};
use crate::trace::Picture;
use egui::{
    Align, Context, Grid, Label, Layout, RichText, ScrollArea, Sense, Stroke, StrokeKind, TextureHandle, Ui, pos2, vec2,
};
use std::sync::Arc;

/// The titles of the columns, by their names in the catalogue of words.
const TITLES: [&str; 6] =
    ["effects-effect", "effects-rays", "effects-ns", "effects-share", "effects-without", "effects-difference"];
/// Width of the small pictures, in points.
const SMALL: f32 = 96.0;
/// Width of the bar that shows a share, in points.
const BAR: f32 = 70.0;

/// What the panel remembers between frames.
#[derive(Default)]
pub struct EffectsPane {
    job: Option<LedgerJob>,
    shown: Option<Shown>,
}

/// A ledger, ready to be shown.
struct Shown {
    ledger: Ledger,
    /// For each row the picture without the effect and how it differs, with the largest difference of a channel.
    pictures: Vec<Option<(TextureHandle, TextureHandle, u8)>>,
}

impl EffectsPane {
    /// Forgets everything: the scene has changed.
    pub fn reset(&mut self) {
        (self.job, self.shown) = (None, None);
    }

    /// Stops measuring: nobody looks.
    pub fn pause(&mut self) {
        self.job = None;
    }

    /// Shows the panel; returns the effects that shall be on, where a switch was moved.
    pub fn ui(&mut self, ui: &mut Ui, open: &OpenScene) -> Option<Effects> {
        self.measure(ui.ctx(), &open.whole);
        self.contents(ui, open)
    }

    /// Measures the whole scene once, and takes the ledger when it is there.
    fn measure(&mut self, ctx: &Context, whole: &Arc<Scene>) {
        if self.shown.is_none() && self.job.is_none() {
            self.job = LedgerJob::start(ctx, whole);
        }
        if let Some(ledger) = self.job.as_ref().and_then(LedgerJob::result) {
            let pictures = ledger.rows.iter().map(|row| textures(ctx, &ledger.picture, row)).collect();
            self.shown = Some(Shown { ledger, pictures });
            self.job = None;
        }
    }

    fn contents(&self, ui: &mut Ui, open: &OpenScene) -> Option<Effects> {
        ui.label(RichText::new(self.state(ui.ctx())).weak());
        ui.add_space(4.0);
        let (called, idle): (Vec<_>, Vec<_>) = reasons(&open.whole).into_iter().partition(|reason| reason.called_for);
        let mut chosen = None;
        ScrollArea::vertical().auto_shrink([false, false]).show(ui, |ui| {
            Grid::new("effects called for").num_columns(6).striped(true).spacing([14.0, 8.0]).show(ui, |ui| {
                for title in TITLES {
                    ui.label(RichText::new(say(ui.ctx(), title)).small().weak());
                }
                ui.end_row();
                for reason in &called {
                    if let Some(effects) = self.row(ui, reason, open.scene.effects) {
                        chosen = Some(effects);
                    }
                    ui.end_row();
                }
            });
            ui.add_space(10.0);
            idle_effects(ui, &idle);
        });
        chosen
    }

    /// What the figures are, or how far they are.
    fn state(&self, ctx: &Context) -> String {
        match (&self.shown, &self.job) {
            (Some(Shown { ledger, .. }), _) => {
                let size = format!("{} × {}", ledger.picture.width, ledger.picture.height);
                let ns = format!("{:.0}", ledger.ns_per_pixel);
                let values = [("size", (&size).into()), ("ns", (&ns).into()), ("pairs", ledger.pairs.into())];
                say_with(ctx, "effects-measured", &values)
            }
            (None, Some(job)) => {
                let percent = format!("{:.0}", 100.0 * job.share_done());
                say_with(ctx, "effects-measuring", &[("percent", (&percent).into())])
            }
            (None, None) => say(ctx, "effects-no-thread"),
        }
    }

    /// One effect that is called for; returns what its switch was moved to.
    fn row(&self, ui: &mut Ui, reason: &Reason, effects: Effects) -> Option<Effects> {
        let effect = reason.effect;
        let mut is_on = effects.has(effect);
        let switched = name(ui, reason, &mut is_on);
        let place = self.shown.as_ref().and_then(|shown| {
            let at = shown.ledger.rows.iter().position(|row| row.reason.effect == effect)?;
            Some((&shown.ledger.rows[at], shown.pictures[at].as_ref()))
        });
        let Some((row, pictures)) = place else {
            (0..5).for_each(|_| {
                ui.label("");
            });
            return switched.then(|| switch(effects, effect, is_on));
        };
        ui.label(row.rays.to_string()).on_hover_text({
            let (rays, calls) = (row.rays.to_string(), row.calls.to_string());
            say_with(ui.ctx(), "effects-rays-about", &[("rays", (&rays).into()), ("calls", (&calls).into())])
        });
        price(ui, row.price);
        if let Some((without, difference, largest)) = pictures {
            thumbnail(ui, without, SMALL, &say(ui.ctx(), "effects-picture-without"));
            let largest = u32::from(*largest);
            let meaning = say_with(ui.ctx(), "effects-difference-about", &[("largest", largest.into())]);
            thumbnail(ui, difference, SMALL, &meaning);
        }
        switched.then(|| switch(effects, effect, is_on))
    }
}

fn switch(effects: Effects, effect: Effect, is_on: bool) -> Effects {
    if is_on { effects.with(effect) } else { effects.without(effect) }
}

/// The switch with the effect's name, and why the scene calls for it; returns whether it was moved.
fn name(ui: &mut Ui, reason: &Reason, is_on: &mut bool) -> bool {
    let effect = reason.effect.name();
    ui.with_layout(Layout::top_down(Align::Min), |ui| {
        ui.set_width(230.0);
        let moved = ticks::checkbox(ui, is_on, RichText::new(effect).family(bold())).changed();
        ui.add(Label::new(with_code(&reason.why, 11.0, Palette::current(ui.ctx()).weak)).wrap());
        moved
    })
    .inner
}

/// A price in figures, and its share of the picture's time as a bar.
fn price(ui: &mut Ui, price: Option<Price>) {
    let palette = Palette::current(ui.ctx());
    let Some(price) = price else {
        ui.label("");
        ui.label("");
        return;
    };
    let figures = format!("{:.0} ± {:.0}", price.ns_per_pixel, price.spread);
    let colour = if price.is_clear() { palette.text } else { palette.weak };
    let label = ui.label(RichText::new(figures).monospace().color(colour));
    if !price.is_clear() {
        label.on_hover_text(say(ui.ctx(), "effects-unclear"));
    }
    let (rect, _) = ui.allocate_exact_size(vec2(BAR, 16.0), Sense::hover());
    #[expect(clippy::cast_possible_truncation, reason = "a width in points")]
    let share = price.share.clamp(0.0, 1.0) as f32;
    ui.painter().rect_filled(rect, 2.0, palette.backdrop);
    ui.painter().rect_filled(rect.with_max_x(rect.left() + share * rect.width()), 2.0, palette.accent);
    ui.painter().rect_stroke(rect, 2.0, Stroke::new(1.0, palette.edge), StrokeKind::Inside);
    let percent = format!("{:.0} %", 100.0 * price.share);
    let on_bar = share > 0.5;
    let ink = if on_bar { palette.panel } else { palette.text };
    let at = if on_bar { pos2(rect.left() + 5.0, rect.center().y) } else { pos2(rect.right() - 5.0, rect.center().y) };
    let anchor = if on_bar { egui::Align2::LEFT_CENTER } else { egui::Align2::RIGHT_CENTER };
    ui.painter().text(at, anchor, percent, egui::FontId::proportional(11.0), ink);
}

/// The effects that the scene does not call for: none of their code runs.
fn idle_effects(ui: &mut Ui, idle: &[Reason]) {
    if idle.is_empty() {
        return;
    }
    ui.label(RichText::new(say(ui.ctx(), "effects-idle")).small().weak());
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        for (i, reason) in idle.iter().enumerate() {
            let why = with_code(&reason.why, 13.5, Palette::current(ui.ctx()).text);
            let between = if i + 1 < idle.len() { " ·" } else { "" };
            let name = format!("{}{between}", reason.effect.name());
            ui.label(RichText::new(name).weak()).on_hover_text(why);
        }
    });
}

/// The picture without an effect, how it differs from the whole one, and by how much at most.
fn textures(ctx: &Context, whole: &Picture, row: &Row) -> Option<(TextureHandle, TextureHandle, u8)> {
    let without = row.without.as_ref()?;
    let (difference, largest) = difference(ctx, without, whole);
    Some((texture(ctx, "without", without), difference, largest))
}
