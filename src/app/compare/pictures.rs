//! Two pictures in one frame with a slider between them, or what differs between them, amplified.

use super::pin::Pin;
use crate::app::frame::background::Background;
use crate::app::frame::task::{self, Task};
use crate::app::frame::theme::Palette;
use crate::app::frame::ticks;
use crate::app::frame::words::{say, say_with};
use crate::app::picture::thumbnail::texture;
use crate::compare::{PictureDifference, picture_difference};
use crate::scene::{Image, Scene};
use crate::trace::{Picture, Progress, render};
use crate::view::significant;
use egui::{
    Color32, Context, CursorIcon, EventFilter, Key, Rect, Role, Sense, Stroke, StrokeKind, TextureHandle, Ui,
    WidgetInfo, pos2, vec2,
};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Columns of the pictures: few enough that both are there within seconds, enough to see what differs.
const COLUMNS: u32 = 360;
/// How far a key moves the slider.
const KEY_STEP: f32 = 0.02;
/// Room for the names below a picture, in points.
const NAMES: f32 = 24.0;
/// No picture is given less height than this, in points: the panel scrolls instead.
const LOWEST: f32 = 180.0;

/// To render a scene at one go.
#[derive(Serialize, Deserialize)]
pub struct RenderWhole;

impl Task for RenderWhole {
    const NAME: &'static str = "whole picture";
    type News = Picture;

    fn run(self, scene: &Arc<Scene>, progress: &Progress, publish: &mut dyn FnMut(Picture)) {
        publish(render(scene, progress).0);
    }
}

/// Two pictures that are being rendered.
struct Running {
    scenes: [Arc<Scene>; 2],
    work: [Background<Picture>; 2],
    pictures: [Option<Picture>; 2],
}

struct Shown {
    scenes: [Arc<Scene>; 2],
    left: TextureHandle,
    right: TextureHandle,
    amplified: Option<TextureHandle>,
    difference: Option<PictureDifference>,
}

/// The pictures that are shown, and those that are being rendered.
pub struct Pictures {
    shown: Option<Shown>,
    running: Option<Running>,
    /// Where the slider stands, from 0 to 1.
    share: f32,
    is_amplified: bool,
}

impl Default for Pictures {
    fn default() -> Self {
        Self { shown: None, running: None, share: 0.5, is_amplified: false }
    }
}

impl Pictures {
    /// Shows the pictures of two stories' scenes in a panel of this height.
    pub fn ui(&mut self, ui: &mut Ui, left: &Pin, right: &Pin, room: f32) {
        let top = ui.cursor().top();
        self.update(ui.ctx(), [&left.scene, &right.scene]);
        let Some(shown) = &self.shown else {
            ui.label(say(ui.ctx(), "compare-rendering"));
            return;
        };
        let Some(difference) = &shown.difference else {
            ui.label(say(ui.ctx(), "compare-two-sizes"));
            return;
        };
        let [largest, rmse] = [difference.largest, difference.rmse].map(|x| significant(x, 3));
        let pixels = difference.differing;
        let arguments = [("largest", (&largest).into()), ("rmse", (&rmse).into()), ("pixels", pixels.into())];
        ui.label(say_with(ui.ctx(), "compare-figures", &arguments));
        let words = say(ui.ctx(), "compare-amplified");
        ticks::checkbox(ui, &mut self.is_amplified, words);
        let amplified = shown.amplified.clone().filter(|_| self.is_amplified);
        let height = room - (ui.cursor().top() - top) - NAMES;
        match amplified {
            Some(texture) => {
                let rect = frame(ui, &texture, height);
                image(ui, &texture, rect, [0.0, 1.0]);
            }
            None => self.slider(ui, height),
        }
    }

    fn update(&mut self, ctx: &Context, scenes: [&Arc<Scene>; 2]) {
        let is_of = |known: &[Arc<Scene>; 2]| std::iter::zip(known, scenes).all(|(a, b)| Arc::ptr_eq(a, b));
        if let Some(shown) = self.running.as_mut().and_then(|running| running.shown(ctx)) {
            (self.shown, self.running) = (Some(shown), None);
        }
        let is_known = self.shown.as_ref().is_some_and(|shown| is_of(&shown.scenes));
        let is_running = self.running.as_ref().is_some_and(|running| is_of(&running.scenes));
        if !is_known && !is_running {
            self.running = Running::start(ctx, scenes);
            self.shown = None;
        }
    }

    /// Both pictures: ours on the left of the slider, the pinned one on its right.
    fn slider(&mut self, ui: &mut Ui, height: f32) {
        let Some(shown) = &self.shown else { return };
        let rect = frame(ui, &shown.left, height);
        image(ui, &shown.left, rect, [0.0, self.share]);
        image(ui, &shown.right, rect, [self.share, 1.0]);
        let name = say(ui.ctx(), "compare-slider");
        let response = ui.interact(rect, ui.scope_id().with("slider"), Sense::click_and_drag());
        let value = f64::from(self.share) * 100.0;
        response.widget_info(|| WidgetInfo::slider(true, value, &name));
        if let Some(at) = response.interact_pointer_pos() {
            self.share = ((at.x - rect.left()) / rect.width().max(1.0)).clamp(0.0, 1.0);
        }
        if response.has_focus() {
            let filter = EventFilter { horizontal_arrows: true, ..EventFilter::default() };
            ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
            let pressed = |key| f32::from(u8::from(ui.input(|input| input.key_pressed(key))));
            let moved = pressed(Key::ArrowRight) - pressed(Key::ArrowLeft);
            self.share = (self.share + KEY_STEP * moved).clamp(0.0, 1.0);
        }
        let palette = Palette::current(ui.ctx());
        let x = rect.left() + self.share * rect.width();
        let width = if response.has_focus() { 3.0 } else { 1.5 };
        ui.painter().vline(x, rect.y_range(), Stroke::new(width, palette.accent));
        ui.painter().circle(pos2(x, rect.center().y), 6.0, palette.panel, Stroke::new(width, palette.accent));
        response.on_hover_cursor(CursorIcon::ResizeHorizontal);
        let sides = [say(ui.ctx(), "compare-left-side"), say(ui.ctx(), "compare-right-side")];
        ui.horizontal(|ui| {
            ui.set_max_width(rect.width());
            ui.label(egui::RichText::new(&sides[0]).small().weak());
            ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                ui.label(egui::RichText::new(&sides[1]).small().weak());
            });
        });
    }
}

impl Running {
    fn start(ctx: &Context, scenes: [&Arc<Scene>; 2]) -> Option<Self> {
        let [left, right] = scenes.map(|scene| task::begin(ctx, &Arc::new(smaller(scene)), RenderWhole));
        Some(Self { scenes: scenes.map(Arc::clone), work: [left?, right?], pictures: [None, None] })
    }

    /// Both, once they are there.
    fn shown(&mut self, ctx: &Context) -> Option<Shown> {
        for (picture, work) in self.pictures.iter_mut().zip(&self.work) {
            *picture = work.take().or(picture.take());
        }
        let [Some(left), Some(right)] = &self.pictures else { return None };
        let difference = picture_difference(left, right);
        Some(Shown {
            scenes: self.scenes.clone(),
            left: texture(ctx, "compare left", left),
            right: texture(ctx, "compare right", right),
            amplified: difference.as_ref().map(|found| texture(ctx, "compare amplified", &found.amplified)),
            difference,
        })
    }
}

/// The scene with a picture of few columns.
fn smaller(scene: &Scene) -> Scene {
    let Image { width, height } = scene.image;
    let columns = width.min(COLUMNS);
    let rows = u64::from(height) * u64::from(columns) / u64::from(width.max(1));
    let image = Image { width: columns, height: u32::try_from(rows).unwrap_or(height).max(1) };
    Scene { image, ..scene.clone() }
}

/// Room for a picture, as large as this height and the panel's width allow.
fn frame(ui: &mut Ui, texture: &TextureHandle, height: f32) -> Rect {
    let size = texture.size_vec2();
    let room = vec2(ui.available_width() - 4.0, height.max(LOWEST));
    let scale = (room.x / size.x).min(room.y / size.y).max(0.05);
    let (rect, response) = ui.allocate_exact_size(size * scale, Sense::hover());
    let name = say(ui.ctx(), "compare-picture");
    response.widget_info(|| WidgetInfo::labeled(Role::Image, true, &name));
    rect
}

/// The part of a picture between two shares of its width.
fn image(ui: &Ui, texture: &TextureHandle, rect: Rect, [from, to]: [f32; 2]) {
    let at = |share: f32| rect.left() + share * rect.width();
    let place = Rect::from_x_y_ranges(at(from)..=at(to), rect.y_range());
    let part = Rect::from_min_max(pos2(from, 0.0), pos2(to, 1.0));
    ui.painter().image(texture.id(), place, part, Color32::WHITE);
    let edge = Stroke::new(1.0, Palette::current(ui.ctx()).edge);
    ui.painter().rect_stroke(rect, 0.0, edge, StrokeKind::Outside);
}
