//! What each panel shows, and what a click in one does to the others.

use super::frame::empty::empty;
use super::frame::words::{say, say_with};
use super::lesson::marks;
use super::pane::Pane;
use super::picture::panel::ImageView;
use super::picture::renderer::Renderer;
use super::share;
use super::story::{detail, pane as story_pane};
use super::workbench::{OpenScene, Workbench};
use crate::lesson::model::Surface;
use crate::record::Effect;
use crate::scene::Scene;
use egui::{Context, Ui, UiBuilder};
use std::sync::Arc;

impl Workbench {
    /// Shows what is in a panel.
    pub(in crate::app) fn pane(&mut self, ui: &mut Ui, pane: Pane) {
        match pane {
            pane if self.is_veiled(pane) => self.veil_pane(ui),
            Pane::Picture => self.picture_pane(ui),
            Pane::Side => self.side_pane(ui),
            Pane::Story => story_pane::ui(ui, self),
            Pane::Detail => detail::ui(ui, self.recording.as_ref()),
            Pane::Along => {
                if let Some(event) = self.plots.ui(ui, self.recording.as_ref()) {
                    self.select(event);
                }
            }
            Pane::Compare => self.compare_pane(ui),
            Pane::Accuracy => self.accuracy_pane(ui),
            Pane::Effects => self.effects_pane(ui),
            Pane::Editor => self.editor_pane(ui),
            Pane::Properties => self.editing.properties_ui(ui),
            Pane::Search => self.search_pane(ui),
            Pane::Lesson => self.lesson_pane(ui),
            Pane::Overview
            | Pane::Generic
            | Pane::Intervals
            | Pane::Signs
            | Pane::Snell
            | Pane::Shading
            | Pane::Planes => {
                if let Some(event) = self.drawings.ui(ui, pane, self.recording.as_mut()) {
                    self.select(event);
                }
            }
        }
    }

    /// The tools at the right end of a panel's header, from right to left.
    pub(in crate::app) fn pane_tools(&mut self, ui: &mut Ui, pane: Pane) {
        if self.is_veiled(pane) {
            return;
        }
        match pane {
            Pane::Picture => self.move_switch(ui),
            Pane::Side => self.side.tools(ui),
            _ => self.drawings.tools(ui, pane, self.recording.as_mut()),
        }
        share::tools(ui, self, pane);
    }

    /// How things stand in a panel, in a few words.
    pub(in crate::app) fn pane_state(&self, ctx: &Context, pane: Pane) -> Option<String> {
        match pane {
            Pane::Picture => self.open.as_ref().map(|open| self.picture_state(ctx, open)),
            Pane::Editor => Some(self.editor_state(ctx)),
            Pane::Story => Some(story_pane::position(ctx, self)),
            _ => None,
        }
    }

    /// The button that ends a panel's having the window to itself.
    pub(in crate::app) fn alone_tools(&mut self, ui: &mut Ui, pane: Pane) {
        if ui.button(say(ui.ctx(), "view-together")).clicked() {
            self.dock.toggle_alone(pane);
        }
    }

    /// Lets what nobody sees stop working.
    pub(in crate::app) fn pause_what_is_not_seen(&mut self) {
        if !self.dock.shows(Pane::Accuracy) {
            self.accuracy.pause();
        }
        if !self.dock.shows(Pane::Search) {
            self.search.pause();
        }
        if !self.dock.shows(Pane::Effects) {
            self.effects.pause();
        }
    }

    fn picture_pane(&mut self, ui: &mut Ui) {
        self.picture_keys(ui.ctx());
        let Some(open) = &self.open else { return empty(ui, &say(ui.ctx(), "no-scene")) };
        let texture = self.renderer.texture(ui.ctx()).cloned();
        self.search.update(ui.ctx(), &open.scene);
        let layers = self.search.layers(ui.ctx(), &open.scene);
        let told = |pixel| self.search.told(&open.scene, pixel);
        let recording = self.recording.as_ref();
        let view = ImageView { scene: &open.scene, texture, recording, layers: &layers, told: &told };
        let chosen = self.image.ui(ui, &view);
        // A lesson may wait for the click; then it is an answer.
        match (self.awaits_click(Surface::Image), self.image.clicked.take()) {
            (Some(question), Some(click)) => self.answer_click(question, Surface::Image, click),
            _ => chosen.into_iter().for_each(|pixel| self.record(pixel)),
        }
        self.picture_handles(ui);
        if let Some((place, _)) = self.image.seen {
            marks::draw(ui, &self.lesson_marks(Surface::Image), |at| place.on_screen(at));
        }
    }

    fn side_pane(&mut self, ui: &mut Ui) {
        let Some(open) = &self.open else { return empty(ui, &say(ui.ctx(), "no-scene")) };
        let chosen = self.side.ui(ui, &open.scene, self.recording.as_ref());
        match (self.awaits_click(Surface::Side), self.side.clicked.take()) {
            (Some(question), Some(click)) => self.answer_click(question, Surface::Side, click),
            _ => chosen.into_iter().for_each(|event| self.select(event)),
        }
        self.section_handles(ui);
        if let Some(rect) = self.side.rect() {
            marks::draw(ui, &self.lesson_marks(Surface::Side), |at| marks::within(rect, at));
        }
    }

    fn accuracy_pane(&mut self, ui: &mut Ui) {
        let Some(open) = &self.open else { return empty(ui, &say(ui.ctx(), "no-scene")) };
        let wish = padded(ui, |ui| self.accuracy.ui(ui, open, self.recording.as_ref()));
        if let Some(wish) = wish {
            self.grant(ui.ctx(), wish);
        }
    }

    fn compare_pane(&mut self, ui: &mut Ui) {
        let Some(open) = &self.open else { return empty(ui, &say(ui.ctx(), "no-scene")) };
        let wish = padded(ui, |ui| self.compare.ui(ui, open, self.recording.as_ref()));
        if let Some(wish) = wish {
            self.grant_comparison(wish);
        }
    }

    fn effects_pane(&mut self, ui: &mut Ui) {
        let Some(open) = &self.open else { return empty(ui, &say(ui.ctx(), "no-scene")) };
        let chosen = padded(ui, |ui| self.effects.ui(ui, open));
        if let Some(effects) = chosen {
            self.switch(ui.ctx(), effects);
        }
    }

    fn search_pane(&mut self, ui: &mut Ui) {
        let Some(open) = &self.open else { return empty(ui, &say(ui.ctx(), "no-scene")) };
        self.search.update(ui.ctx(), &open.scene);
        let place = padded(ui, |ui| self.search.ui(ui, &open.scene));
        if let Some(place) = place {
            self.go_to(place);
        }
    }

    /// How large the picture is, how far, and what is left out of it, in words.
    fn picture_state(&self, ctx: &Context, open: &OpenScene) -> String {
        progress(ctx, &self.renderer, &open.scene) + &left_out(ctx, open)
    }
}

fn padded<T>(ui: &mut Ui, contents: impl FnOnce(&mut Ui) -> T) -> T {
    let rect = ui.available_rect_before_wrap().shrink2(egui::vec2(10.0, 6.0));
    ui.scope_builder(UiBuilder::new().max_rect(rect), contents).inner
}

/// How the scene is looked at, and the effects that are switched off, in words.
fn left_out(ctx: &Context, open: &OpenScene) -> String {
    // What the scene calls for is worked out anew only where something may differ from it.
    let called = if open.look.is_none() { open.whole.effects } else { open.looked_at().effects };
    let off = |effect: &Effect| called.has(*effect) && !open.scene.effects.has(*effect);
    let names: Vec<&str> = Effect::ALL.into_iter().filter(off).map(Effect::name).collect();
    let without = if names.is_empty() {
        String::new()
    } else {
        format!(" · {}", say_with(ctx, "picture-without", &[("effects", (&names.join(", ")).into())]))
    };
    open.look.as_ref().map_or_else(String::new, |look| format!(" · {}", look.name)) + &without
}

/// How far the picture is, in words.
fn progress(ctx: &Context, renderer: &Renderer, scene: &Arc<Scene>) -> String {
    let size = format!("{} × {}", scene.image.width, scene.image.height);
    if renderer.finished() {
        return size;
    }
    ctx.request_repaint_after(std::time::Duration::from_millis(100));
    let percent = format!("{:.0} %", 100.0 * renderer.share_done());
    format!("{size} · {}", say_with(ctx, "picture-rendering", &[("percent", (&percent).into())]))
}
