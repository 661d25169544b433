//! The field into which a link is pasted.

use crate::app::frame::theme::Palette;
use crate::app::frame::words::say;
use crate::share::link::{Link, LinkError};
use egui::{Button, Context, Id, Key, Modal, RichText, Role, TextEdit, WidgetInfo};

/// Width of the field, in points.
const WIDTH: f32 = 520.0;

/// What was typed so far.
#[derive(Default)]
pub struct LinkField {
    typed: String,
    was_focused: bool,
}

/// What came of a frame.
pub enum Outcome {
    /// It stays open.
    Stay,
    /// It was closed.
    Close,
    /// A link is to be followed.
    Follow(Box<Link>),
}

impl LinkField {
    /// Shows the field with what is wrong with the link.
    pub fn ui(&mut self, ctx: &Context) -> Outcome {
        let read: Result<Link, LinkError> = self.typed.parse();
        let mut is_wanted = false;
        let mut is_closed = false;
        let modal = Modal::new(Id::unique("link field")).show(ctx, |ui| {
            ui.set_width(WIDTH.min(ctx.content_rect().width() - 60.0));
            ui.heading(say(ctx, "share-open-link"));
            ui.label(say(ctx, "share-link-help"));
            self.field(ui);
            if let (Err(error), false) = (&read, self.typed.trim().is_empty()) {
                ui.label(RichText::new(format!("✗ {error}")).color(Palette::current(ctx).problem));
            }
            ui.horizontal(|ui| {
                let button = ui.add_enabled(read.is_ok(), Button::new(say(ctx, "share-link-follow")));
                is_wanted = button.clicked() || ui.input(|input| input.key_pressed(Key::Enter));
                is_closed = ui.button(say(ctx, "share-close")).clicked();
            });
        });
        match read {
            Ok(link) if is_wanted => Outcome::Follow(Box::new(link)),
            _ if is_closed || modal.should_close() => Outcome::Close,
            _ => Outcome::Stay,
        }
    }

    fn field(&mut self, ui: &mut egui::Ui) {
        let title = say(ui.ctx(), "share-link-field");
        let field = TextEdit::singleline(&mut self.typed).hint_text("rayscope:csg/bowl?pixel=310,240");
        let response = ui.add(field.desired_width(f32::INFINITY));
        response.widget_info(|| WidgetInfo::labeled(Role::TextInput, true, &title));
        if !std::mem::replace(&mut self.was_focused, true) {
            response.request_focus();
        }
    }
}
