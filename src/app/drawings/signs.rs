//! d(t) with a t that is dragged along the ray, by the pointer or the arrow keys.

use super::canvas::{Canvas, put};
use super::seen::{Seen, focus_ring};
use crate::app::frame::empty::empty;
use crate::app::frame::words::say;
use crate::app::story::recording::Recording;
use crate::record::EventId;
use crate::view::{Drawing, ProbedSigns, SignPlotLayout, probed_sign_plot};
use egui::accesskit::Action;
use egui::{CursorIcon, EventFilter, Key as KeyName, Rect, Response, Role, Sense, Ui, WidgetInfo};
use std::sync::{Arc, Mutex, PoisonError};

/// The share of the axis that an arrow key moves t by, and with Shift.
const STEPS: [f64; 2] = [0.01, 0.1];

/// A drawing and what it was made for.
#[derive(Clone, PartialEq)]
struct Key {
    event: EventId,
    seen: Seen,
}

impl Key {
    fn draw(&self) -> Option<ProbedSigns> {
        let Seen { scene, tree, probe_t, theme, .. } = &self.seen;
        probed_sign_plot(scene, tree, self.event, *probe_t, self.seen.size(), *theme)
    }
}

/// The panel of the sign plot.
#[derive(Default)]
pub struct SignsPane {
    canvas: Canvas<Key>,
    /// The axis of the drawing that was made last.
    layout: Arc<Mutex<Option<SignPlotLayout>>>,
}

impl SignsPane {
    /// Shows the plot and moves the recording's t.
    pub fn ui(&mut self, ui: &mut Ui, recording: &mut Recording) {
        let rect = ui.available_rect_before_wrap();
        let key = Key { event: recording.plotted().signs, seen: Seen::of(ui, recording, rect) };
        let (wanted, layout) = (key.clone(), Arc::clone(&self.layout));
        let draw = move || {
            let plot = wanted.draw();
            *layout.lock().unwrap_or_else(PoisonError::into_inner) = plot.as_ref().map(|plot| plot.layout);
            plot.map(|plot| plot.drawing)
        };
        let Some(shown) = self.canvas.update(ui.ctx(), &key, draw) else { return };
        let (Some(texture), Some(drawing)) = (&shown.texture, &shown.drawing) else {
            empty(ui, &say(ui.ctx(), "drawings-no-signs"));
            return;
        };
        let Some(layout) = *self.layout.lock().unwrap_or_else(PoisonError::into_inner) else { return };
        let response = ui.interact(rect, ui.scope_id().with("signs"), Sense::click_and_drag());
        name(ui, &response, recording.probe_t, layout, drawing);
        let response = response.on_hover_and_drag_cursor(CursorIcon::ResizeHorizontal);
        put(&ui.painter_at(rect), texture, rect.min);
        focus_ring(ui, &response);
        if let Some(t) = dragged(&response, rect, layout).or_else(|| keyed(ui, &response, recording.probe_t, layout)) {
            recording.probe_t = Some(t);
            ui.ctx().request_repaint();
        }
    }

    /// The button that lets go of t.
    pub fn tools(ui: &mut Ui, recording: Option<&mut Recording>) {
        let Some(recording) = recording else { return };
        let clear = egui::Button::new(say(ui.ctx(), "drawings-clear-t"));
        let clear = ui.add_enabled(recording.probe_t.is_some(), clear);
        if clear.on_hover_text(say(ui.ctx(), "drawings-clear-t-about")).clicked() {
            recording.probe_t = None;
        }
    }
}

/// A slider to screen readers, whose value is t and whose description is what the drawing shows.
fn name(ui: &Ui, response: &Response, probe_t: Option<f64>, layout: SignPlotLayout, drawing: &Drawing) {
    let label = say(ui.ctx(), "drawings-t");
    response.widget_info(|| WidgetInfo::labeled(Role::Slider, true, &label));
    ui.ctx().accesskit_node_builder(response.id, |node| {
        node.set_numeric_value(probe_t.unwrap_or(layout.t[0]));
        node.set_min_numeric_value(layout.t[0]);
        node.set_max_numeric_value(layout.t[1]);
        node.add_action(Action::Increment);
        node.add_action(Action::Decrement);
        node.set_description(drawing.in_words().into_owned());
    });
}

fn dragged(response: &Response, rect: Rect, layout: SignPlotLayout) -> Option<f64> {
    let is_meant = response.clicked() || response.dragged();
    let at = response.interact_pointer_pos().filter(|_| is_meant)?;
    response.request_focus();
    Some(layout.t_at(f64::from(at.x - rect.left())))
}

/// The arrow keys, and what assistive technology asks of a slider.
fn keyed(ui: &Ui, response: &Response, probe_t: Option<f64>, layout: SignPlotLayout) -> Option<f64> {
    let asked = |action| ui.input(|input| input.has_accesskit_action_request(response.id, action));
    let mut way = f64::from(i8::from(asked(Action::Increment)) - i8::from(asked(Action::Decrement)));
    let mut step = STEPS[0];
    if response.has_focus() {
        let filter = EventFilter { horizontal_arrows: true, ..EventFilter::default() };
        ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
        ui.input(|input| {
            let [right, left] = [KeyName::ArrowRight, KeyName::ArrowLeft].map(|key| i8::from(input.key_pressed(key)));
            way += f64::from(right - left);
            step = STEPS[usize::from(input.modifiers.shift)];
        });
    }
    let [low, high] = layout.t;
    let from = probe_t.unwrap_or_else(|| 0.0_f64.max(low).min(high));
    (way != 0.0).then(|| (from + way.signum() * step * (high - low)).max(low).min(high))
}
