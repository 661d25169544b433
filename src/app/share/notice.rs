//! What is said about sharing: how far it is, what came of it, what went wrong.

use super::saving::Saving;
use crate::app::frame::theme::Palette;
use crate::app::frame::words::say;
use egui::{Align2, Context, Id, Key, Label, ProgressBar, RichText, Window, vec2};

/// Width of the notice, in points.
const WIDTH: f32 = 380.0;

/// A message that stays until it is closed.
pub struct Notice {
    /// What it says.
    pub text: String,
    is_good: bool,
}

impl Notice {
    /// Something went well.
    pub const fn good(text: String) -> Self {
        Self { text, is_good: true }
    }

    /// Something went wrong.
    pub const fn bad(text: String) -> Self {
        Self { text, is_good: false }
    }
}

/// Shows how far the work is, or what came of it, in the lower right corner.
pub fn ui(ctx: &Context, saving: &mut Option<Saving>, notice: &mut Option<Notice>) {
    if saving.is_none() && notice.is_none() {
        return;
    }
    let palette = Palette::current(ctx);
    let window =
        Window::new(say(ctx, "share-title")).id(Id::unique("share notice")).collapsible(false).resizable(false);
    window.anchor(Align2::RIGHT_BOTTOM, vec2(-14.0, -14.0)).default_width(WIDTH).show(ctx, |ui| {
        ui.set_max_width(WIDTH);
        let mut given_up = false;
        if let Some(saving) = saving {
            ui.label(say(ctx, "share-working"));
            ui.add(ProgressBar::new(saving.share_done()).desired_width(WIDTH).show_percentage());
            given_up = ui.button(say(ctx, "share-cancel")).clicked();
        } else if let Some(told) = notice {
            let (sign, colour) = if told.is_good { ("✓", palette.text) } else { ("✗", palette.problem) };
            ui.add(Label::new(RichText::new(format!("{sign} {}", told.text)).color(colour)).wrap().selectable(true));
            given_up =
                ui.button(say(ctx, "share-close")).clicked() || ctx.input(|input| input.key_pressed(Key::Escape));
        }
        if given_up {
            *saving = None;
            *notice = None;
        }
    });
}
