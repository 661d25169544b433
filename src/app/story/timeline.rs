//! The strip with all events in a line: drawn in the background, with the place where one stands painted over it.

use super::recording::Recording;
use crate::app::drawings::canvas::{Canvas, put};
use crate::app::frame::theme::{Palette, drawing_theme};
use crate::app::frame::words::say;
use crate::record::EventId;
use crate::story::Step;
use crate::trace::RayTree;
use crate::view::{Drawing, TIMELINE_AXIS, Theme, Timed, TimelineScale, timeline, timeline_height};
use egui::accesskit::Action;
use egui::{EventFilter, Key as KeyName, Rangef, Rect, Response, Role, Sense, Stroke, Ui, WidgetInfo, pos2};
use std::sync::Arc;

/// Most height of the strip, in points: what would need more shares lanes.
const HEIGHT: f32 = 108.0;
/// Room below the drawing for the head of the line where one stands, in points.
const HEAD: f32 = 7.0;

/// How far from a mark a click still counts, in points.
const REACH: f64 = 4.0;

/// Everything that the drawing depends on. Where one stands is not a part of it, so that a step draws nothing anew.
#[derive(Clone)]
struct Key {
    tree: Arc<RayTree>,
    told: EventId,
    stops: Arc<[EventId]>,
    size: [u32; 2],
    theme: Theme,
    pixels_per_point: f32,
}

impl PartialEq for Key {
    fn eq(&self, other: &Self) -> bool {
        let rest = |key: &Self| (key.told, key.size, key.theme, key.pixels_per_point);
        Arc::ptr_eq(&self.tree, &other.tree) && Arc::ptr_eq(&self.stops, &other.stops) && rest(self) == rest(other)
    }
}

impl Key {
    fn draw(&self) -> Option<Drawing> {
        let timed = Timed { tree: &self.tree, told: self.told, stops: &self.stops, selected: None };
        timeline(timed, self.size.map(f64::from), self.theme)
    }
}

/// The strip.
#[derive(Default)]
pub struct Timeline {
    canvas: Canvas<Key>,
    /// How high the strip of a tree is, with or without breakpoints.
    height: Option<(Arc<RayTree>, bool, f32)>,
}

impl Timeline {
    /// How high the strip of a recording is: no higher than there is something in it.
    pub fn height(&mut self, recording: &Recording) -> f32 {
        let (tree, has_stops) = (&recording.tree, !recording.story().stops_shared().is_empty());
        match &self.height {
            Some((of, with, height)) if Arc::ptr_eq(of, tree) && *with == has_stops => *height,
            _ => {
                #[expect(clippy::cast_possible_truncation, reason = "screen coordinates are f32")]
                let height = (timeline_height(tree, has_stops) as f32 + HEAD).min(HEIGHT);
                self.height = Some((Arc::clone(tree), has_stops, height));
                height
            }
        }
    }

    /// Shows the strip; returns the event that was clicked or dragged to.
    pub fn ui(&mut self, ui: &mut Ui, recording: &Recording) -> Option<EventId> {
        let room = egui::vec2(ui.available_width(), self.height(recording));
        let (rect, response) = ui.allocate_exact_size(room, Sense::click_and_drag());
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a panel is a few thousand points")]
        let size = [rect.width().max(1.0) as u32, (rect.height() - HEAD).max(1.0) as u32];
        let key = Key {
            tree: Arc::clone(&recording.tree),
            told: recording.last_told().map_or(recording.tree.end(), |last| last + 1),
            stops: Arc::clone(recording.story().stops_shared()),
            size,
            theme: drawing_theme(ui.ctx()),
            pixels_per_point: ui.pixels_per_point(),
        };
        let wanted = key.clone();
        let shown = self.canvas.update(ui.ctx(), &key, move || wanted.draw());
        let drawing = shown.and_then(|shown| shown.drawing.as_ref().filter(|_| shown.key == key));
        if let Some(texture) = shown.and_then(|shown| shown.texture.as_ref()) {
            put(&ui.painter_at(rect), texture, rect.min);
        }
        let scale = TimelineScale::new(f64::from(size[0]), recording.tree.end());
        paint_place(ui, rect, &scale, recording.selected(), &response);
        name(ui, &response, recording, drawing);
        let target = pointed_at(&response, rect, &scale, drawing).or_else(|| keyed(ui, &response, recording));
        response.on_hover_ui(|ui| {
            ui.label(say(ui.ctx(), "step-timeline-about"));
        });
        target.filter(|&event| event != recording.selected())
    }
}

fn paint_place(ui: &Ui, rect: Rect, scale: &TimelineScale, selected: EventId, response: &Response) {
    let palette = Palette::current(ui.ctx());
    #[expect(clippy::cast_possible_truncation, reason = "screen coordinates are f32")]
    let x = rect.left() + scale.x(selected) as f32;
    let painter = ui.painter_at(rect);
    // Down to the axis: the numbers below it are to be read.
    #[expect(clippy::cast_possible_truncation, reason = "a few points")]
    let foot = rect.bottom() - TIMELINE_AXIS as f32;
    painter.vline(x, Rangef::new(rect.top(), foot), Stroke::new(1.5, palette.accent));
    let head = [pos2(x - 5.0, foot - 7.0), pos2(x + 5.0, foot - 7.0), pos2(x, foot)];
    painter.add(egui::Shape::convex_polygon(head.to_vec(), palette.accent, Stroke::NONE));
    if response.has_focus() {
        painter.rect_stroke(rect, 0.0, Stroke::new(1.0, palette.accent), egui::StrokeKind::Inside);
    }
}

/// A slider to screen readers: its value is the event's number, and its description what the drawing shows.
fn name(ui: &Ui, response: &Response, recording: &Recording, drawing: Option<&Drawing>) {
    let label = say(ui.ctx(), "step-timeline");
    response.widget_info(|| WidgetInfo::labeled(Role::Slider, true, &label));
    ui.ctx().accesskit_node_builder(response.id, |node| {
        node.set_numeric_value(f64::from(recording.selected() + 1));
        node.set_min_numeric_value(1.0);
        node.set_max_numeric_value(f64::from(recording.tree.end()));
        node.add_action(Action::Increment);
        node.add_action(Action::Decrement);
        if let Some(drawing) = drawing {
            node.set_description(drawing.description.clone());
        }
    });
}

fn pointed_at(response: &Response, rect: Rect, scale: &TimelineScale, drawing: Option<&Drawing>) -> Option<EventId> {
    let at = response.interact_pointer_pos()? - rect.min;
    let (x, y) = (f64::from(at.x), f64::from(at.y));
    if response.clicked() {
        // A mark that is hit is meant; beside marks the place is.
        return drawing.and_then(|drawing| drawing.event_at([x, y], REACH)).or(Some(scale.event(x)));
    }
    response.dragged().then(|| scale.event(x))
}

/// The arrow keys, and what assistive technology asks of a slider.
fn keyed(ui: &Ui, response: &Response, recording: &Recording) -> Option<EventId> {
    let asked = |action| ui.input(|input| input.has_accesskit_action_request(response.id, action));
    let (mut back, mut on) = (asked(Action::Decrement), asked(Action::Increment));
    if response.has_focus() {
        let filter = EventFilter { horizontal_arrows: true, ..EventFilter::default() };
        ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
        ui.input(|input| {
            back |= input.key_pressed(KeyName::ArrowLeft);
            on |= input.key_pressed(KeyName::ArrowRight);
        });
    }
    match (back, on) {
        (true, false) => recording.story().target(Step::Back),
        (false, true) => recording.story().target(Step::Next),
        _ => None,
    }
}
