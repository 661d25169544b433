//! The window on `egui` alone: keys, the top bar, messages, and below them the panels.

use super::dock::Room;
use super::frame::scene_menu::Choice;
use super::frame::theme::Palette;
use super::frame::{problem, top_bar};
use super::help::Help;
use super::workbench::Workbench;
use super::{command, dock};
use egui::{Rect, Ui, UiBuilder, Vec2};

/// The gap between the panels and the window's edge, in points.
const MARGIN: f32 = 6.0;

impl Workbench {
    /// Shows the workbench in all of `ui` and lets it be used.
    pub fn ui(&mut self, ui: &mut Ui) {
        let ctx = ui.ctx().clone();
        let window = ctx.content_rect().size() * ctx.zoom_factor();
        let magnification = self.dock.preset().magnification(window);
        self.settings.apply(&ctx, magnification);
        // What is presented is large because it is to be, not because there is little room.
        self.dock.fit(self.room(ui.max_rect().size() * magnification));
        self.take_files(&ctx);
        self.receive_opened(&ctx);
        self.follow_lesson(&ctx);
        self.advance_story(&ctx);
        self.arrive();
        // What lies over the workbench has the keys.
        let is_free = matches!(self.help, Help::None) && !self.is_asking();
        let command = if is_free { command::pressed(&ctx, self) } else { None };
        if let Some(command) = command {
            command.run(self, &ctx);
        }
        self.follow_edits(&ctx);
        let whole = ui.max_rect();
        ui.painter().rect_filled(whole, 0.0, Palette::current(&ctx).window);
        let (bar, rest) = whole.split_top_bottom_at_y(whole.top() + top_bar::height(ui, self));
        if !self.is_embedded {
            self.top_bar(ui, bar);
        }
        let margin = if self.dock.room() == Room::OneColumn { 0.0 } else { MARGIN };
        let rest = self.messages(ui, rest.shrink(margin));
        ui.scope_builder(UiBuilder::new().id_salt("dock").max_rect(rest), |ui| dock::show(ui, self));
        self.show_help(ui);
        self.show_sharing(ui);
        self.show_opening(&ctx);
        self.pause_what_is_not_seen();
        self.ask_questions(&ctx);
    }

    /// A frame in a page is read beside the page: however wide it is, it holds few things.
    fn room(&self, window: Vec2) -> Room {
        match Room::of(window) {
            Room::Enough if self.is_embedded => Room::TwoColumns,
            room => room,
        }
    }

    fn top_bar(&mut self, ui: &mut Ui, bar: Rect) {
        let builder = UiBuilder::new().id_salt("top bar").max_rect(bar);
        let action = ui.scope_builder(builder, |ui| top_bar::ui(ui, self)).inner;
        match action {
            Some(top_bar::Action::Choose(Choice(name))) => self.open_scene(ui.ctx(), &name),
            Some(top_bar::Action::Record(pixel)) => self.record(pixel),
            Some(top_bar::Action::Run(command)) => command.run(self, ui.ctx()),
            None => {}
        }
    }

    /// Shows what went wrong, and returns the room below.
    fn messages(&mut self, ui: &mut Ui, rest: Rect) -> Rect {
        let Some(problem) = &self.problem else { return rest };
        let (message, below) = rest.split_top_bottom_at_y(rest.top() + problem::height(ui, problem, rest.size()));
        if problem::ui(ui, message, problem, self.open.as_ref()) {
            self.problem = None;
        }
        below.with_min_y(below.top() + MARGIN)
    }
}
