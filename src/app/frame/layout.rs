//! The window on `egui` alone: where the panels lie, and what a click in one does to the others.

use crate::app::frame::panel::{empty, panel};
use crate::app::frame::problem;
use crate::app::frame::scene_menu::Choice;
use crate::app::frame::split::{Direction, GAP, split};
use crate::app::frame::theme::Palette;
use crate::app::frame::top_bar;
use crate::app::picture::panel::ImageView;
use crate::app::picture::renderer::Renderer;
use crate::app::story::detail as detail_panel;
use crate::app::story::panel as tree_panel;
use crate::app::story::toolbar;
use crate::app::workbench::{OpenScene, Workbench};
use crate::record::Effect;
use crate::scene::Scene;
use egui::{Context, Rect, RichText, Ui, UiBuilder};

/// How the window is divided: shares from 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shares {
    /// The left column's share of the width.
    pub left: f32,
    /// The outline's share of what is left.
    pub outline: f32,
    /// The picture's share of the left column's height.
    pub picture: f32,
    /// The detail's share of the right column's height.
    pub detail: f32,
}

impl Default for Shares {
    fn default() -> Self {
        Self { left: 0.35, outline: 0.52, picture: 0.5, detail: 0.48 }
    }
}

impl Workbench {
    /// Shows the workbench in all of `ui` and lets it be used.
    pub fn ui(&mut self, ui: &mut Ui) {
        self.take_files(ui.ctx());
        let palette = Palette::current(ui.ctx());
        let whole = ui.max_rect();
        ui.painter().rect_filled(whole, 0.0, palette.window);
        let (bar, rest) = whole.split_top_bottom_at_y(whole.top() + top_bar::height(ui, self.open.as_ref()));
        self.top_bar(ui, bar);
        let mut rest = rest.shrink(GAP);
        if let Some(problem) = &self.problem {
            let (message, below) = rest.split_top_bottom_at_y(rest.top() + problem::height(problem, rest.height()));
            if problem::ui(ui, message, problem, self.open.as_ref()) {
                self.problem = None;
            }
            rest = below.with_min_y(below.top() + GAP);
        }
        self.panels(ui, rest);
        self.effects_window(&ui.ctx().clone());
        self.accuracy_window(&ui.ctx().clone());
    }

    fn top_bar(&mut self, ui: &mut Ui, bar: Rect) {
        let pixel = self.recording.as_ref().map(|recording| recording.pixel);
        let builder = UiBuilder::new().id_salt("top bar").max_rect(bar);
        let action = ui.scope_builder(builder, |ui| top_bar::ui(ui, &self.menu, self.open.as_ref(), pixel)).inner;
        match action {
            Some(top_bar::Action::Choose(Choice::Embedded(name))) => self.open_scene(ui.ctx(), &name),
            Some(top_bar::Action::Choose(Choice::OpenFile)) => self.dialog.open(ui.ctx()),
            Some(top_bar::Action::Record(pixel)) => self.record(pixel),
            Some(top_bar::Action::Effects) => self.toggle_effects(),
            Some(top_bar::Action::Accuracy) => self.toggle_accuracy(),
            None => {}
        }
    }

    fn effects_window(&mut self, ctx: &Context) {
        let chosen = self.open.as_ref().and_then(|open| self.effects.ui(ctx, open));
        if let Some(effects) = chosen {
            self.switch(ctx, effects);
        }
    }

    fn accuracy_window(&mut self, ctx: &Context) {
        let wish = self.open.as_ref().and_then(|open| self.accuracy.ui(ctx, open, self.recording.as_ref()));
        if let Some(wish) = wish {
            self.grant(ctx, wish);
        }
    }

    fn panels(&mut self, ui: &mut Ui, rect: Rect) {
        use Direction::{Below, Beside};
        let shares = &mut self.shares;
        let (left, others) = split(ui, "Width of the picture", rect, Beside, &mut shares.left, 280.0);
        let (middle, right) = split(ui, "Width of the outline", others, Beside, &mut shares.outline, 280.0);
        let (picture, side) = split(ui, "Height of the picture", left, Below, &mut shares.picture, 140.0);
        let (detail, plots) = split(ui, "Height of the detail", right, Below, &mut shares.detail, 140.0);
        self.picture_panel(ui, picture);
        self.side_panel(ui, side);
        self.outline_panel(ui, middle);
        panel(ui, detail, "Selected event", |_| {}, |ui| detail_panel::ui(ui, self.recording.as_ref()));
        let mut clicked = None;
        panel(ui, plots, "Along the ray", |_| {}, |ui| clicked = self.plots.ui(ui, self.recording.as_ref()));
        if let Some(event) = clicked {
            self.select(event);
        }
    }

    fn picture_panel(&mut self, ui: &mut Ui, rect: Rect) {
        let Some(open) = &self.open else {
            panel(ui, rect, "Picture", |_| {}, |ui| empty(ui, "No scene is open."));
            return;
        };
        let texture = self.renderer.texture(ui.ctx()).cloned();
        let state = progress(ui.ctx(), &self.renderer, &open.scene) + &left_out(open);
        let mut chosen = None;
        let view = ImageView { scene: &open.scene, texture, recording: self.recording.as_ref() };
        let tools = |ui: &mut Ui| {
            ui.label(RichText::new(state).small().weak());
        };
        panel(ui, rect, "Picture", tools, |ui| chosen = self.image.ui(ui, &view));
        if let Some(pixel) = chosen {
            self.record(pixel);
        }
    }

    fn side_panel(&mut self, ui: &mut Ui, rect: Rect) {
        let Some(open) = &self.open else {
            panel(ui, rect, "Side view", |_| {}, |ui| empty(ui, "No scene is open."));
            return;
        };
        let mut clicked = None;
        // Header and contents both need it, one after the other.
        let side = std::cell::RefCell::new(&mut self.side);
        panel(
            ui,
            rect,
            "Side view",
            |ui| side.borrow_mut().tools(ui),
            |ui| clicked = side.borrow_mut().ui(ui, &open.scene, self.recording.as_ref()),
        );
        if let Some(event) = clicked {
            self.select(event);
        }
    }

    fn outline_panel(&mut self, ui: &mut Ui, rect: Rect) {
        let position = toolbar::position(self.recording.as_ref());
        let tools = |ui: &mut Ui| {
            ui.label(RichText::new(position).small().weak());
        };
        panel(ui, rect, "The ray's story", tools, |ui| {
            let (bar, rows) = toolbar::cut(ui.available_rect_before_wrap());
            let builder = UiBuilder::new().id_salt("stepper").max_rect(bar.shrink2(egui::vec2(8.0, 4.0)));
            ui.scope_builder(builder, |ui| toolbar::ui(ui, self.recording.as_mut()));
            let edge = egui::Stroke::new(1.0, Palette::current(ui.ctx()).edge);
            ui.painter().hline(bar.x_range(), bar.bottom(), edge);
            let builder = UiBuilder::new().id_salt("rows").max_rect(rows.with_min_y(rows.top() + 1.0));
            ui.scope_builder(builder, |ui| tree_panel::ui(ui, self.recording.as_mut()));
        });
    }
}

/// How the scene is looked at, and the effects that are switched off, in words.
fn left_out(open: &OpenScene) -> String {
    let called = open.looked_at().effects;
    let off = |effect: &Effect| called.has(*effect) && !open.scene.effects.has(*effect);
    let names: Vec<&str> = Effect::ALL.into_iter().filter(off).map(Effect::name).collect();
    let without = if names.is_empty() { String::new() } else { format!(" · without {}", names.join(", ")) };
    open.look.as_ref().map_or_else(String::new, |look| format!(" · {}", look.name)) + &without
}

/// How far the picture is, in words.
fn progress(ctx: &Context, renderer: &Renderer, scene: &Scene) -> String {
    let size = format!("{} × {}", scene.image.width, scene.image.height);
    if renderer.finished() {
        return size;
    }
    ctx.request_repaint_after(std::time::Duration::from_millis(100));
    format!("{size} · rendering, {:.0} %", 100.0 * renderer.share_done())
}
