//! Interval lists to choose from, each as bars on the same axis.

use crate::app::frame::theme::{Palette, colour, drawing_theme};
use crate::lesson::question::{Reckoned, Stretch, list_text, offered_lists};
use crate::record::format_number;
use egui::{Align2, FontId, Rect, RichText, Role, Sense, Stroke, Ui, WidgetInfo, pos2, vec2};

/// Height of a list with its bars, in points.
const ROW: f32 = 26.0;
/// Height of a bar, in points.
const BAR: f32 = 10.0;

/// Shows the lists; a click chooses one.
pub fn ui(ui: &mut Ui, reckoned: &Reckoned<Vec<Stretch>>, chosen: &mut Option<usize>, is_done: bool) {
    let lists = offered_lists(reckoned);
    let axis = Axis::of(&lists);
    for (place, list) in lists.into_iter().enumerate() {
        let is_chosen = *chosen == Some(place);
        let name = list_text(list);
        ui.horizontal(|ui| {
            let button = ui.radio(is_chosen, "");
            button.widget_info(|| WidgetInfo::selected(Role::RadioButton, true, is_chosen, &name));
            let width = (ui.available_width() - 24.0).max(60.0);
            let (rect, bars) = ui.allocate_exact_size(vec2(width, ROW), Sense::CLICK);
            axis.paint(ui, rect, list, is_chosen);
            if button.clicked() || bars.clicked() {
                *chosen = Some(place);
            }
            bars.on_hover_text(&name);
            if is_done && *list == reckoned.answer {
                ui.label(RichText::new("✓").color(Palette::current(ui.ctx()).accent));
            }
        });
    }
    axis.scale(ui);
}

/// The times that all lists are drawn on.
struct Axis {
    low: f64,
    high: f64,
    ends: Vec<f64>,
}

impl Axis {
    fn of(lists: &[&Vec<Stretch>]) -> Self {
        let mut ends: Vec<f64> = lists.iter().flat_map(|list| list.iter().flatten()).filter_map(|end| *end).collect();
        ends.sort_by(f64::total_cmp);
        ends.dedup();
        let (first, last) = (ends.first().copied().unwrap_or(0.0), ends.last().copied().unwrap_or(1.0));
        let margin = 0.08 * (last - first).max(1e-6);
        Self { low: first - margin, high: last + margin, ends }
    }

    fn x(&self, rect: Rect, t: f64) -> f32 {
        #[expect(clippy::cast_possible_truncation, reason = "screen coordinates are f32")]
        let share = ((t - self.low) / (self.high - self.low)) as f32;
        rect.left() + share.clamp(0.0, 1.0) * rect.width()
    }

    fn paint(&self, ui: &Ui, rect: Rect, list: &[Stretch], is_chosen: bool) {
        let palette = Palette::current(ui.ctx());
        let painter = ui.painter();
        if is_chosen {
            painter.rect_filled(rect, 3.0, palette.selected);
        }
        let middle = rect.center().y;
        painter.hline(rect.x_range(), middle, Stroke::new(1.0, palette.edge));
        for &t in &self.ends {
            let x = self.x(rect, t);
            painter.vline(x, (middle - 7.0)..=(middle + 7.0), Stroke::new(1.0, palette.edge));
        }
        let fill = colour(drawing_theme(ui.ctx()).palette().reflected);
        for [from, to] in list {
            let left = from.map_or(rect.left(), |t| self.x(rect, t));
            let right = to.map_or(rect.right(), |t| self.x(rect, t));
            let bar =
                Rect::from_min_max(pos2(left, middle - BAR / 2.0), pos2(right.max(left + 2.0), middle + BAR / 2.0));
            painter.rect_filled(bar, 2.0, fill);
        }
    }

    /// The first and the last time below the bars.
    fn scale(&self, ui: &mut Ui) {
        let palette = Palette::current(ui.ctx());
        let inset = ui.spacing().icon_width + ui.spacing().icon_spacing + ui.spacing().item_spacing.x;
        let (whole, _) = ui.allocate_exact_size(vec2(ui.available_width(), 16.0), Sense::hover());
        let rect = whole.with_min_x(whole.left() + inset).with_max_x(whole.right() - 24.0);
        let font = FontId::proportional(11.0);
        let painter = ui.painter();
        for t in self.ends.first().into_iter().chain(self.ends.last()) {
            let at = pos2(self.x(rect, *t), rect.top());
            painter.text(at, Align2::CENTER_TOP, format!("t = {}", format_number(*t)), font.clone(), palette.weak);
        }
    }
}
