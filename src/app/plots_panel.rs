//! Interval bars and the sign plot of d(t), both for the selected event.

use super::canvas::Canvas;
use super::panel::empty;
use super::recording::Recording;
use super::theme::drawing_theme;
use crate::record::EventId;
use crate::trace::RayTree;
use crate::view::{Drawing, Theme, interval_bars, sign_plot};
use egui::{Color32, Pos2, Rect, Role, Sense, Ui, Vec2, WidgetInfo, pos2};
use std::sync::Arc;

/// What there is to plot of an event.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Plot {
    Bars,
    Signs,
}

impl Plot {
    const fn name(self) -> &'static str {
        match self {
            Self::Bars => "Interval bars",
            Self::Signs => "Sign plot of d(t)",
        }
    }

    fn draw(self, key: &Key) -> Option<Drawing> {
        let size = key.size.map(f64::from);
        match self {
            Self::Bars => interval_bars(&key.tree, key.selected, size, key.theme),
            Self::Signs => sign_plot(&key.tree, key.selected, size, key.theme),
        }
    }
}

/// Everything that a plot depends on.
#[derive(Clone)]
struct Key {
    tree: Arc<RayTree>,
    selected: EventId,
    size: [u32; 2],
    theme: Theme,
    pixels_per_point: f32,
}

impl PartialEq for Key {
    fn eq(&self, other: &Self) -> bool {
        let rest = |key: &Self| (key.selected, key.size, key.theme, key.pixels_per_point);
        Arc::ptr_eq(&self.tree, &other.tree) && rest(self) == rest(other)
    }
}

/// The plots, one above the other.
#[derive(Default)]
pub struct PlotsPanel {
    bars: Canvas<Key>,
    signs: Canvas<Key>,
}

impl PlotsPanel {
    /// Shows what there is to plot of the selected event.
    pub fn ui(&mut self, ui: &mut Ui, recording: Option<&Recording>) {
        let nothing = "Select a CSG node to see its intervals, or a primitive to see d(t) along the ray.";
        let Some(recording) = recording else {
            empty(ui, nothing);
            return;
        };
        let whole = ui.available_rect_before_wrap();
        let (upper, lower) = whole.split_top_bottom_at_y(whole.center().y.round());
        let bars = show(ui, &mut self.bars, Plot::Bars, recording, upper);
        let signs = show(ui, &mut self.signs, Plot::Signs, recording, lower);
        if bars == Some(false) && signs == Some(false) {
            empty(ui, nothing);
        }
    }
}

/// Shows one plot; returns whether there is one, or none if that is not known yet.
fn show(ui: &Ui, canvas: &mut Canvas<Key>, plot: Plot, recording: &Recording, rect: Rect) -> Option<bool> {
    let inside = rect.shrink(4.0);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a panel is a few thousand points")]
    let size = [inside.width().max(1.0) as u32, inside.height().max(1.0) as u32];
    let key = Key {
        tree: Arc::clone(&recording.tree),
        selected: recording.selected(),
        size,
        theme: drawing_theme(ui.ctx()),
        pixels_per_point: ui.pixels_per_point(),
    };
    let wanted = key.clone();
    let shown = canvas.update(ui.ctx(), &key, move || plot.draw(&wanted))?;
    if let Some(texture) = &shown.texture {
        let response = ui.interact(rect, ui.scope_id().with(plot.name()), Sense::hover());
        response.widget_info(|| WidgetInfo::labeled(Role::Image, true, plot.name()));
        let place = Rect::from_min_size(inside.min, Vec2::from(shown.key.size.map(|points| points as f32)));
        let unit_square = Rect::from_min_max(Pos2::ZERO, pos2(1.0, 1.0));
        ui.painter_at(rect).image(texture.id(), place, unit_square, Color32::WHITE);
    }
    Some(shown.drawing.is_some())
}
