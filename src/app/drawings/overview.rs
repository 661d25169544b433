//! The scene in space: turned by dragging or by the arrow keys, with the lines made once for a scene in the background.

use super::canvas::{Canvas, put};
use super::seen::{REACH, Seen, describe, focus_ring};
use crate::app::frame::ticks;
use crate::app::frame::words::say;
use crate::app::story::recording::Recording;
use crate::document::rounded;
use crate::math::portable;
use crate::record::EventId;
use crate::scene::Scene;
use crate::view::{Drawing, OverviewOptions, Stand, Wireframe, overview};
use egui::{CursorIcon, EventFilter, Key as KeyName, PointerButton, Response, Sense, Ui};
use std::sync::{Arc, Mutex, PoisonError};

/// Radians for a point of dragging, and for an arrow key.
const TURN: f64 = 0.008;
const KEY_TURN: f64 = 0.12;
/// By how much + and − change the zoom.
const KEY_ZOOM: f64 = 1.2;

/// Where one stands and what of it is seen.
#[derive(Clone, Copy, PartialEq)]
struct View {
    yaw: f64,
    pitch: f64,
    zoom: f64,
    pan: [f64; 2],
    is_perspective: bool,
    is_camera: bool,
}

impl Default for View {
    fn default() -> Self {
        Self { yaw: 0.7, pitch: 0.4, zoom: 1.0, pan: [0.0; 2], is_perspective: true, is_camera: false }
    }
}

/// A drawing and what it was made for.
#[derive(Clone, PartialEq)]
struct Key {
    seen: Seen,
    view: View,
}

/// The lines of the scene that they were made for.
type Kept = Arc<Mutex<Option<(Arc<Scene>, Arc<Wireframe>)>>>;

impl Key {
    /// Drawn by a thread of its own, which makes the lines where those of another scene are kept.
    fn draw(&self, kept: &Kept) -> Option<Drawing> {
        let View { yaw, pitch, zoom, pan, is_perspective, is_camera } = self.view;
        let stand = if is_camera { Stand::Camera } else { Stand::Orbit { yaw, pitch } };
        let Seen { scene, tree, selected, probe_t, theme, .. } = &self.seen;
        let (theme, probe_t) = (*theme, *probe_t);
        let options = OverviewOptions { size: self.seen.size(), theme, stand, is_perspective, zoom, pan, probe_t };
        let wires = {
            let mut kept = kept.lock().unwrap_or_else(PoisonError::into_inner);
            if let Some((_, wires)) = kept.as_ref().filter(|(of, _)| Arc::ptr_eq(of, scene)) {
                Arc::clone(wires)
            } else {
                let wires = Arc::new(Wireframe::of(scene));
                *kept = Some((Arc::clone(scene), Arc::clone(&wires)));
                wires
            }
        };
        overview(scene, &wires, tree, *selected, &options)
    }
}

/// The panel of the overview.
#[derive(Default)]
pub struct OverviewPane {
    view: View,
    wires: Kept,
    canvas: Canvas<Key>,
}

impl OverviewPane {
    /// Shows the scene; returns the event whose mark was clicked.
    pub fn ui(&mut self, ui: &mut Ui, recording: &Recording) -> Option<EventId> {
        let rect = ui.available_rect_before_wrap();
        let response = ui.interact(rect, ui.scope_id().with("overview"), Sense::click_and_drag());
        let response = response.on_hover_and_drag_cursor(CursorIcon::Grab);
        self.dragged(ui, &response);
        self.keyed(ui, &response);
        let key = Key { seen: Seen::of(ui, recording, rect), view: self.view };
        let (wanted, wires) = (key.clone(), Arc::clone(&self.wires));
        let shown = self.canvas.update(ui.ctx(), &key, move || wanted.draw(&wires))?;
        let (Some(texture), Some(drawing)) = (&shown.texture, &shown.drawing) else { return None };
        describe(ui, &response, "pane-overview", drawing);
        put(&ui.painter_at(rect), texture, rect.min);
        focus_ring(ui, &response);
        let click = response.clicked().then(|| response.interact_pointer_pos()).flatten()?;
        response.request_focus();
        let local = click - rect.min;
        shown.drawing.as_ref().filter(|_| shown.key == key)?.event_at([f64::from(local.x), f64::from(local.y)], REACH)
    }

    /// Turned with the main button, moved with another or with Shift, zoomed with the wheel.
    fn dragged(&mut self, ui: &Ui, response: &Response) {
        let by = response.drag_delta();
        let moves = ui.input(|input| input.modifiers.shift) || !response.dragged_by(PointerButton::Primary);
        if response.dragged() && moves {
            self.view.pan = [self.view.pan[0] + f64::from(by.x), self.view.pan[1] + f64::from(by.y)];
        } else if response.dragged() {
            self.turn(-TURN * f64::from(by.x), TURN * f64::from(by.y));
        }
        if response.hovered() {
            let (scroll, pinch) = ui.input(|input| (input.smooth_scroll_delta.y, input.zoom_delta()));
            self.zoom(f64::from(pinch) * portable::exp(f64::from(scroll) / 200.0));
        }
    }

    fn keyed(&mut self, ui: &Ui, response: &Response) {
        if !response.has_focus() {
            return;
        }
        let filter = EventFilter { horizontal_arrows: true, vertical_arrows: true, ..EventFilter::default() };
        ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
        let pressed = |key| f64::from(u8::from(ui.input(|input| input.modifiers.is_none() && input.key_pressed(key))));
        let across = pressed(KeyName::ArrowRight) - pressed(KeyName::ArrowLeft);
        let upward = pressed(KeyName::ArrowUp) - pressed(KeyName::ArrowDown);
        if across != 0.0 || upward != 0.0 {
            self.turn(KEY_TURN * across, KEY_TURN * upward);
        }
        let closer = pressed(KeyName::Plus) + pressed(KeyName::Equals) - pressed(KeyName::Minus);
        self.zoom(portable::powf(KEY_ZOOM, closer));
    }

    /// How it is turned: yaw and pitch in degrees, and the zoom. None where one looks through the scene's own camera.
    #[must_use]
    pub fn orbit(&self) -> Option<[f64; 3]> {
        let View { yaw, pitch, zoom, is_camera, .. } = self.view;
        // Nobody sees a thousandth of a degree.
        (!is_camera).then(|| [yaw.to_degrees(), pitch.to_degrees(), zoom].map(|x| rounded(x, 3)))
    }

    /// Turns it so.
    pub fn turn_to(&mut self, [yaw, pitch, zoom]: [f64; 3]) {
        self.view = View { yaw: 0.0, pitch: 0.0, is_perspective: self.view.is_perspective, ..View::default() };
        self.turn(yaw.to_radians(), pitch.to_radians());
        self.zoom(zoom);
    }

    /// Whoever turns the view leaves the scene's own camera.
    fn turn(&mut self, yaw: f64, pitch: f64) {
        let view = &mut self.view;
        view.is_camera = false;
        view.yaw = (view.yaw + yaw).rem_euclid(std::f64::consts::TAU);
        view.pitch = (view.pitch + pitch).clamp(-1.55, 1.55);
    }

    fn zoom(&mut self, factor: f64) {
        self.view.zoom = (self.view.zoom * factor).clamp(0.05, 200.0);
    }

    /// The choices at the right end of the header, from right to left.
    pub fn tools(&mut self, ui: &mut Ui) {
        let is_moved = self.view != View::default();
        let fit = ui.add_enabled(is_moved, egui::Button::new(say(ui.ctx(), "drawings-fit")));
        if fit.on_hover_text(say(ui.ctx(), "drawings-overview-fit-about")).clicked() {
            self.view = View::default();
        }
        ui.menu_button(say(ui.ctx(), "drawings-look"), |ui| {
            let mut is_camera = self.view.is_camera;
            let words = say(ui.ctx(), "drawings-camera");
            let camera = ticks::checkbox(ui, &mut is_camera, words);
            if camera.on_hover_text(say(ui.ctx(), "drawings-camera-about")).changed() {
                self.view = View { is_camera, zoom: 1.0, pan: [0.0; 2], ..self.view };
            }
            let mut is_parallel = !self.view.is_perspective;
            let words = say(ui.ctx(), "drawings-parallel");
            let parallel = ticks::checkbox(ui, &mut is_parallel, words);
            if parallel.on_hover_text(say(ui.ctx(), "drawings-parallel-about")).changed() {
                self.view.is_perspective = !is_parallel;
            }
        });
    }
}
