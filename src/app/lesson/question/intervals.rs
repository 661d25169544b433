//! Interval lists to choose from, each as bars on the same axis.

use crate::app::frame::theme::{Palette, colour, drawing_theme};
use crate::app::frame::ticks;
use crate::lesson::expression::{Format, Value};
use crate::lesson::question::{Reckoned, Stretch, list_text, offered_lists};
use egui::{Align2, FontId, Rect, RichText, Role, Sense, Stroke, Ui, WidgetInfo, pos2, vec2};
use std::collections::BTreeSet;

/// Height of a list with its bars, in points.
const ROW: f32 = 34.0;
/// Where the bars lie below the ends in numbers, from the top of the row, in points.
const MIDDLE: f32 = 24.0;
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
            let button = ticks::radio(ui, is_chosen);
            button.widget_info(|| WidgetInfo::selected(Role::RadioButton, true, is_chosen, &name));
            let width = (ui.available_width() - 24.0).max(60.0);
            let (rect, bars) = ui.allocate_exact_size(vec2(width, ROW), Sense::CLICK);
            axis.paint(ui, rect, list, is_chosen);
            axis.write(ui, rect, list);
            if button.clicked() || bars.clicked() {
                *chosen = Some(place);
            }
            bars.on_hover_text(&name);
            if is_done && *list == reckoned.answer {
                ui.label(RichText::new("✓").color(Palette::current(ui.ctx()).accent));
            }
        });
    }
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
        let middle = rect.top() + MIDDLE;
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

    /// The ends of all bars above them.
    fn write(&self, ui: &Ui, rect: Rect, list: &[Stretch]) {
        let text = told(list, digits(&self.ends));
        let font = FontId::proportional(12.0);
        let at = pos2(rect.left() + 4.0, rect.top() + 1.0);
        ui.painter_at(rect).text(at, Align2::LEFT_TOP, text, font, Palette::current(ui.ctx()).text);
    }
}

/// With how many digits ends are told: as few as a text has, and more only where two of them would look the same.
fn digits(ends: &[f64]) -> usize {
    let tells_apart = |digits: &usize| {
        let written: BTreeSet<String> = ends.iter().map(|end| shown(*end, *digits)).collect();
        written.len() == ends.len()
    };
    (3..6).find(tells_apart).unwrap_or(6)
}

fn shown(t: f64, digits: usize) -> String {
    Format::Significant(digits).written(&Value::Number(t))
}

/// A list in words, with so many digits.
fn told(list: &[Stretch], digits: usize) -> String {
    let end = |t: Option<f64>, unbounded: &str| t.map_or(unbounded.to_owned(), |t| shown(t, digits));
    let stretches = list.iter().map(|[from, to]| format!("t = {} … {}", end(*from, "−∞"), end(*to, "∞")));
    let stretches: Vec<String> = stretches.collect();
    if stretches.is_empty() { "∅".to_owned() } else { stretches.join("  ∪  ") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_ends_of_every_bar_are_told_with_as_few_digits_as_tell_them_apart() {
        let ends = [2.548_771, 3.1, 8.25];
        assert_eq!(
            told(&[[Some(2.548_771), Some(3.1)], [Some(8.25), None]], digits(&ends)),
            "t = 2.55 … 3.1  ∪  t = 8.25 … ∞"
        );
        assert_eq!(digits(&[2.548_771, 2.548_9, 3.1]), 5);
        assert_eq!(told(&[], 3), "∅");
    }
}
