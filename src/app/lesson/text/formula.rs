//! Formulas as pixels, each set once.

use crate::app::frame::theme::{Palette, drawing_theme};
use crate::view::Formula;
use egui::{ColorImage, Context, TextureHandle, TextureOptions, Vec2, vec2};
use std::collections::BTreeMap;

/// So many formulas are kept. Fewer, and a long lesson sets some anew in each frame; more, and they only take memory.
const MOST: usize = 600;

/// A formula that is ready to be shown.
#[derive(Clone)]
pub struct SetFormula {
    /// Its pixels; its colour is in them.
    pub texture: TextureHandle,
    /// How large it is, in points.
    pub size: Vec2,
    /// How far it rises above the baseline, in points.
    pub ascent: f32,
    /// It in words, for whoever hears it.
    pub words: String,
}

/// All formulas that were set.
#[derive(Default)]
pub struct Formulas {
    set: BTreeMap<Key, Option<SetFormula>>,
}

/// What the pixels of a formula depend on.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord)]
struct Key {
    latex: String,
    is_display: bool,
    /// The size of an em in pixels, in hundredths.
    em: u32,
    ink: [u8; 4],
}

impl Formulas {
    /// A formula with an em of so many points; none if it cannot be set.
    pub fn formula(&mut self, ctx: &Context, latex: &str, is_display: bool, em: f32) -> Option<SetFormula> {
        let scale = ctx.pixels_per_point();
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "an em is a few hundred pixels at most"
        )]
        let key = Key {
            latex: latex.to_owned(),
            is_display,
            em: (em * scale * 100.0).round() as u32,
            ink: {
                let ink = drawing_theme(ctx).palette().ink;
                [ink.r, ink.g, ink.b, ink.a]
            },
        };
        if let Some(known) = self.set.get(&key) {
            return known.clone();
        }
        if self.set.len() >= MOST {
            self.set.clear();
        }
        let set = set(ctx, latex, is_display, em);
        self.set.insert(key, set.clone());
        set
    }
}

fn set(ctx: &Context, latex: &str, is_display: bool, em: f32) -> Option<SetFormula> {
    let formula = Formula::typeset(latex, is_display).ok()?;
    let scale = ctx.pixels_per_point();
    let pixels = formula.pixels(em * scale, drawing_theme(ctx).palette().ink);
    let image = ColorImage::from_rgba_premultiplied([pixels.width as usize, pixels.height as usize], &pixels.rgba);
    Some(SetFormula {
        texture: ctx.load_texture("formula", image, TextureOptions::LINEAR),
        size: vec2(pixels.width as f32, pixels.height as f32) / scale,
        ascent: pixels.baseline as f32 / scale,
        words: formula.words,
    })
}

/// The colour that running text and formulas have.
#[must_use]
pub fn ink(ctx: &Context) -> egui::Color32 {
    Palette::current(ctx).text
}
