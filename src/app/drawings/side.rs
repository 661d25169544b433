//! The side view: the scene cut open along the ray, with everything up to the selected event drawn in.

use crate::app::drawings::canvas::{Canvas, put};
use crate::app::drawings::seen::{choice, describe};
use crate::app::frame::empty::empty;
use crate::app::frame::theme::drawing_theme;
use crate::app::frame::words::say;
use crate::app::story::recording::Recording;
use crate::math::portable;
use crate::record::EventId;
use crate::scene::Scene;
use crate::trace::RayTree;
use crate::view::{Drawing, PlaneView, SectionPlane, SideViewOptions, Theme, side_view, side_view_plane};
use egui::{Color32, CursorIcon, Pos2, Rect, Response, Role, Sense, Ui, Vec2, WidgetInfo, pos2, vec2};
use std::sync::Arc;

/// How far one can zoom in and out. Further in, the drawing's numbers run out of digits; further out, nothing is left.
const ZOOM_RANGE: std::ops::RangeInclusive<f64> = 0.05..=500.0;

/// How far from a mark a click still counts, in points. Less makes thin lines hard to hit.
const REACH: f64 = 5.0;

/// Which part of the drawing is seen.
#[derive(Clone, Copy, PartialEq)]
struct Sight {
    zoom: f64,
    pan: [f64; 2],
}

impl Sight {
    const WHOLE: Self = Self { zoom: 1.0, pan: [0.0; 2] };
}

/// The side view with its pan and zoom.
pub struct SidePanel {
    plane: SectionPlane,
    sight: Sight,
    canvas: Canvas<Key>,
    /// Where the drawing lies on screen, and what it is of.
    seen: Option<(Rect, Key)>,
    /// Where it was clicked in this frame, in points of the drawing.
    pub clicked: Option<[f64; 2]>,
}

/// Everything that the drawing depends on.
#[derive(Clone)]
struct Key {
    scene: Arc<Scene>,
    tree: Arc<RayTree>,
    step: EventId,
    plane: SectionPlane,
    theme: Theme,
    size: [u32; 2],
    sight: Sight,
    probe_t: Option<f64>,
    pixels_per_point: f32,
}

impl PartialEq for Key {
    fn eq(&self, other: &Self) -> bool {
        let rest =
            |key: &Self| (key.step, key.plane, key.theme, key.size, key.sight, key.probe_t, key.pixels_per_point);
        Arc::ptr_eq(&self.scene, &other.scene) && Arc::ptr_eq(&self.tree, &other.tree) && rest(self) == rest(other)
    }
}

impl Key {
    fn options(&self) -> SideViewOptions {
        SideViewOptions {
            size: self.size.map(f64::from),
            theme: self.theme,
            plane: self.plane,
            zoom: self.sight.zoom,
            pan: self.sight.pan,
            probe_t: self.probe_t,
        }
    }

    fn draw(&self) -> Drawing {
        side_view(&self.scene, &self.tree, self.step, &self.options())
    }
}

impl Default for SidePanel {
    fn default() -> Self {
        Self {
            plane: SectionPlane::RayAndUp,
            sight: Sight::WHOLE,
            canvas: Canvas::default(),
            seen: None,
            clicked: None,
        }
    }
}

impl SidePanel {
    /// Shows the whole scene again.
    pub fn fit(&mut self) {
        self.sight = Sight::WHOLE;
    }

    /// Where the drawing lies on screen; none before it was shown.
    #[must_use]
    pub fn rect(&self) -> Option<Rect> {
        self.seen.as_ref().map(|(rect, _)| *rect)
    }

    /// Where the drawing lies on screen, and which places of the world are where in it; none before it was shown.
    #[must_use]
    pub fn plane(&self) -> Option<(Rect, PlaneView)> {
        let (rect, key) = self.seen.as_ref()?;
        Some((*rect, side_view_plane(&key.scene, &key.tree, key.step, &key.options())))
    }

    /// The choice of the plane and the zoom, for the panel's header (right to left).
    pub fn tools(&mut self, ui: &mut Ui) {
        let fitted = self.sight == Sight::WHOLE;
        let fit = ui.add_enabled(!fitted, egui::Button::new(say(ui.ctx(), "drawings-fit")));
        if fit.on_hover_text(say(ui.ctx(), "drawings-side-fit-about")).clicked() {
            self.fit();
        }
        let planes = [(SectionPlane::RayAndUp, "drawings-ray-and-up"), (SectionPlane::Incidence, "drawings-incidence")];
        choice(ui, &mut self.plane, &planes);
    }

    /// Shows the drawing; returns the event whose mark was clicked.
    pub fn ui(&mut self, ui: &mut Ui, scene: &Arc<Scene>, recording: Option<&Recording>) -> Option<EventId> {
        let Some(recording) = recording else {
            empty(ui, &say(ui.ctx(), "drawings-side-none"));
            return None;
        };
        let rect = ui.available_rect_before_wrap();
        let response = ui.interact(rect, ui.scope_id().with("side view"), Sense::click_and_drag());
        let title = say(ui.ctx(), "pane-side");
        response.widget_info(|| WidgetInfo::labeled(Role::Image, true, &title));
        let response = response.on_hover_and_drag_cursor(CursorIcon::Grab);
        self.pan_and_zoom(ui, &response, rect);
        let at = response.interact_pointer_pos().filter(|_| response.clicked());
        self.clicked = at.map(|at| [f64::from(at.x - rect.left()), f64::from(at.y - rect.top())]);
        let key = self.key(ui, scene, recording, rect);
        self.seen = Some((rect, key.clone()));
        let wanted = key.clone();
        let shown = self.canvas.update(ui.ctx(), &key, move || Some(wanted.draw()))?;
        if let Some(drawing) = &shown.drawing {
            describe(ui, &response, "pane-side", drawing);
        }
        if let Some(texture) = &shown.texture {
            // A drawing that is a moment old is moved to where the new one will be.
            let (place, painter) = (moved(rect, &shown.key, &key), ui.painter_at(rect));
            if shown.key.sight.zoom == key.sight.zoom {
                put(&painter, texture, place.min);
            } else {
                painter.image(texture.id(), place, unit_square(), Color32::WHITE);
            }
        }
        let click = response.clicked().then(|| response.interact_pointer_pos()).flatten()?;
        let local = click - rect.min;
        shown.drawing.as_ref().filter(|_| shown.key == key)?.event_at([f64::from(local.x), f64::from(local.y)], REACH)
    }

    fn key(&self, ui: &Ui, scene: &Arc<Scene>, recording: &Recording, rect: Rect) -> Key {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a panel is a few thousand points")]
        let size = [rect.width().max(1.0) as u32, rect.height().max(1.0) as u32];
        Key {
            scene: Arc::clone(scene),
            tree: Arc::clone(&recording.tree),
            step: recording.selected(),
            plane: self.plane,
            theme: drawing_theme(ui.ctx()),
            size,
            sight: self.sight,
            probe_t: recording.probe_t,
            pixels_per_point: ui.pixels_per_point(),
        }
    }

    fn pan_and_zoom(&mut self, ui: &Ui, response: &Response, rect: Rect) {
        let dragged = response.drag_delta();
        let Sight { zoom: before, pan: [x, y] } = self.sight;
        let pan = [x + f64::from(dragged.x), y + f64::from(dragged.y)];
        self.sight.pan = pan;
        let Some(pointer) = response.hover_pos() else { return };
        let (scroll, pinch) = ui.input(|input| (input.smooth_scroll_delta.y, input.zoom_delta()));
        let factor = f64::from(pinch) * portable::exp(f64::from(scroll) / 200.0);
        let zoom = (before * factor).clamp(*ZOOM_RANGE.start(), *ZOOM_RANGE.end());
        // What lies under the pointer stays there.
        let from_middle = pointer - rect.center();
        let at = [f64::from(from_middle.x), f64::from(from_middle.y)];
        self.sight = Sight { zoom, pan: std::array::from_fn(|i| at[i] + (pan[i] - at[i]) * zoom / before) };
    }
}

/// Where a drawing made for `then` belongs now.
fn moved(rect: Rect, then: &Key, now: &Key) -> Rect {
    #[expect(clippy::cast_possible_truncation, reason = "screen coordinates are f32")]
    let scale = (now.sight.zoom / then.sight.zoom) as f32;
    #[expect(clippy::cast_possible_truncation, reason = "screen coordinates are f32")]
    let pan = |key: &Key| vec2(key.sight.pan[0] as f32, key.sight.pan[1] as f32);
    let size = Vec2::from(then.size.map(|points| points as f32)) * scale;
    let middle = rect.min + Vec2::from(now.size.map(|points| points as f32)) / 2.0;
    Rect::from_center_size(middle + pan(now) - pan(then) * scale, size)
}

fn unit_square() -> Rect {
    Rect::from_min_max(Pos2::ZERO, pos2(1.0, 1.0))
}
