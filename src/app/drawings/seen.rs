//! What every drawing of a panel depends on, and how it is told to those who do not see it.

use crate::app::frame::theme::{Palette, drawing_theme};
use crate::app::frame::words::say;
use crate::app::story::recording::Recording;
use crate::record::EventId;
use crate::scene::Scene;
use crate::trace::RayTree;
use crate::view::{Drawing, Theme};
use egui::{Rect, Response, Role, Stroke, StrokeKind, Ui, WidgetInfo};
use std::sync::Arc;

/// How far from a mark a click still counts, in points. Less makes thin lines hard to hit.
pub const REACH: f64 = 5.0;

/// What is selected, how large the panel is, and which colours are on.
#[derive(Clone)]
pub struct Seen {
    /// The scene.
    pub scene: Arc<Scene>,
    /// What was recorded in it.
    pub tree: Arc<RayTree>,
    /// The selected event.
    pub selected: EventId,
    /// The time that is looked at.
    pub probe_t: Option<f64>,
    /// The theme.
    pub theme: Theme,
    points: [u32; 2],
    pixels_per_point: f32,
}

impl PartialEq for Seen {
    fn eq(&self, other: &Self) -> bool {
        let rest = |seen: &Self| (seen.selected, seen.probe_t, seen.theme, seen.points, seen.pixels_per_point);
        Arc::ptr_eq(&self.scene, &other.scene) && Arc::ptr_eq(&self.tree, &other.tree) && rest(self) == rest(other)
    }
}

impl Seen {
    /// What there is to draw in this rectangle.
    pub fn of(ui: &Ui, recording: &Recording, rect: Rect) -> Self {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a panel is a few thousand points")]
        let points = [rect.width().max(1.0) as u32, rect.height().max(1.0) as u32];
        Self {
            scene: Arc::clone(&recording.scene),
            tree: Arc::clone(&recording.tree),
            selected: recording.selected(),
            probe_t: recording.probe_t,
            theme: drawing_theme(ui.ctx()),
            points,
            pixels_per_point: ui.pixels_per_point(),
        }
    }

    /// Width and height in points.
    #[must_use]
    pub fn size(&self) -> [f64; 2] {
        self.points.map(f64::from)
    }
}

/// Names a drawing for screen readers, with what there is to see in it.
pub fn describe(ui: &Ui, response: &Response, word: &str, drawing: &Drawing) {
    let label = say(ui.ctx(), word);
    response.widget_info(|| WidgetInfo::labeled(Role::Image, true, &label));
    ui.ctx().accesskit_node_builder(response.id, |node| node.set_description(drawing.in_words().into_owned()));
}

/// A menu with what can be chosen, named in the catalogue of words, under the name of what is chosen. Buttons beside each other would
/// leave no room for the tabs of a header.
pub fn choice<T: Copy + PartialEq>(ui: &mut Ui, chosen: &mut T, choices: &[(T, &str)]) {
    let word = choices.iter().find(|(value, _)| value == chosen).map_or("", |(_, word)| word);
    ui.menu_button(format!("{}  ⏷", say(ui.ctx(), word)), |ui| {
        for &(value, word) in choices {
            let about = say(ui.ctx(), &format!("{word}-about"));
            if ui.selectable_label(*chosen == value, say(ui.ctx(), word)).on_hover_text(about).clicked() {
                *chosen = value;
                ui.close();
            }
        }
    });
}

/// Shows where the keys go.
pub fn focus_ring(ui: &Ui, response: &Response) {
    if response.has_focus() {
        let accent = Palette::current(ui.ctx()).accent;
        ui.painter().rect_stroke(response.rect.shrink(1.0), 0.0, Stroke::new(1.5, accent), StrokeKind::Inside);
    }
}
