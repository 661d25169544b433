//! The aligned trees: one row for each pair of events, laid out only where it is seen.

use super::stories::Stories;
use crate::app::frame::theme::Palette;
use crate::app::frame::words::say;
use crate::compare::{Pair, Standing, Tolerance};
use crate::view::row;
use egui::{Align2, Color32, FontId, Role, ScrollArea, Sense, TextStyle, Ui, WidgetInfo, pos2, vec2};

/// Height of a row, in points.
const ROW: f32 = 22.0;
/// How far a level is moved to the right.
const INDENT: f32 = 12.0;
/// So many levels are moved to the right; deeper rows would have no room for words.
const MOST_INDENTS: u16 = 14;
/// Width of the column of marks.
const MARK: f32 = 22.0;

/// Shows the rows of this list in so much height; returns the one that was clicked. `scroll` is the row to be brought into sight.
pub fn ui(
    ui: &mut Ui,
    stories: &Stories,
    list: &[usize],
    chosen: Option<usize>,
    scroll: Option<usize>,
    height: f32,
) -> Option<usize> {
    ui.spacing_mut().item_spacing.y = 0.0;
    let mut area =
        ScrollArea::vertical().auto_shrink(false).id_salt("pairs").max_height(height).min_scrolled_height(height);
    if let Some(place) = scroll.and_then(|row| list.binary_search(&row).ok()) {
        area = area.vertical_scroll_offset((place as f32 * ROW - height / 3.0).max(0.0));
    }
    let output = area.show_rows(ui, ROW, list.len(), |ui, range| {
        let mut clicked = None;
        for &row in &list[range] {
            if show(ui, stories, row, chosen == Some(row)) {
                clicked = Some(row);
            }
        }
        clicked
    });
    output.inner
}

/// What a row says.
struct Line {
    label: String,
    /// Our numbers and theirs; one text where they are the same.
    numbers: Vec<String>,
}

fn line(stories: &Stories, place: usize, pair: Pair) -> Line {
    let trees = [&*stories.left.tree, &*stories.right.tree];
    let rows = [pair.left.map(|id| row(trees[0].event(id))), pair.right.map(|id| row(trees[1].event(id)))];
    let label = rows.iter().flatten().next().map_or_else(String::new, |row| format!("{} {}", row.icon, row.label));
    let mut numbers: Vec<String> = rows.into_iter().flatten().map(|row| row.numbers).collect();
    numbers.dedup();
    if pair.standing == Standing::Changed {
        let changes = stories.pairs.changes(place, trees, &Tolerance::EXACT);
        let label_is_same = numbers.len() < 2;
        if let Some(change) = changes.first().filter(|_| label_is_same) {
            numbers = change.texts().map(|text| format!("{}: {text}", change.name)).to_vec();
        }
    }
    Line { label, numbers }
}

/// The numbers of both sides in one line; a side that has none beside one that has some shows a dash.
fn side_by_side(numbers: &[String]) -> String {
    let side = |text: &String| if text.is_empty() { "–".to_owned() } else { text.clone() };
    if numbers.len() < 2 { numbers.concat() } else { numbers.iter().map(side).collect::<Vec<_>>().join("  |  ") }
}

fn show(ui: &mut Ui, stories: &Stories, place: usize, is_chosen: bool) -> bool {
    let pair = stories.pairs.pairs[place];
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), ROW), Sense::hover());
    let response = ui.interact(rect, ui.scope_id().with(("pair", place)), Sense::click());
    let line = line(stories, place, pair);
    let word = say(ui.ctx(), standing_word(pair.standing));
    let numbers = side_by_side(&line.numbers);
    let spoken = if numbers.is_empty() {
        format!("{word}: {}", line.label)
    } else {
        format!("{word}: {}, {numbers}", line.label)
    };
    response.widget_info(|| WidgetInfo::labeled(Role::TreeItem, true, &spoken));
    ui.ctx().accesskit_node_builder(response.id, |node| {
        node.set_level(pair.depth as usize + 1);
        node.set_selected(is_chosen);
    });
    let palette = Palette::current(ui.ctx());
    if is_chosen {
        ui.painter().rect_filled(rect, 0.0, palette.selected);
    } else if response.hovered() || response.has_focus() {
        ui.painter().rect_filled(rect, 0.0, palette.hovered);
    }
    let ink = match pair.standing {
        // On the colour of the selection, only the full ink can be read.
        Standing::Same if is_chosen => palette.text,
        Standing::Same => palette.weak,
        Standing::Changed => palette.accent,
        Standing::OnlyLeft | Standing::OnlyRight => palette.problem,
    };
    let painter = ui.painter_at(rect);
    let mono = TextStyle::Monospace.resolve(ui.style());
    let middle = rect.center().y;
    painter.text(pos2(rect.left() + MARK / 2.0, middle), Align2::CENTER_CENTER, pair.standing.mark(), mono, ink);
    let depth = u16::try_from(pair.depth).unwrap_or(MOST_INDENTS).min(MOST_INDENTS);
    let left = rect.left() + MARK + INDENT * f32::from(depth);
    let body = TextStyle::Body.resolve(ui.style());
    let text = if pair.standing == Standing::Same && !is_chosen { palette.weak } else { palette.text };
    let end = put(ui, &line.label, body, text, left, rect);
    put(ui, &numbers, FontId::proportional(12.0), ink, end + 10.0, rect);
    response.on_hover_text(spoken).clicked()
}

/// One line from `x` on, ended by `…` where it does not fit; returns where it ends.
fn put(ui: &Ui, text: &str, font: FontId, colour: Color32, x: f32, rect: egui::Rect) -> f32 {
    let room = rect.right() - 6.0 - x;
    if room < 20.0 || text.is_empty() {
        return x;
    }
    let mut job = egui::text::LayoutJob::simple_singleline(text.to_owned(), font, colour);
    job.wrap = egui::text::TextWrapping::truncate_at_width(room);
    let galley = ui.ctx().fonts_mut(|fonts| fonts.layout_job(job));
    let size = galley.size();
    ui.painter_at(rect).galley(pos2(x, rect.center().y - size.y / 2.0), galley, colour);
    x + size.x
}

/// The name of a standing in the catalogue of words.
pub const fn standing_word(standing: Standing) -> &'static str {
    match standing {
        Standing::Same => "compare-same",
        Standing::Changed => "compare-changed",
        Standing::OnlyLeft => "compare-only-here",
        Standing::OnlyRight => "compare-only-there",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_side_without_numbers_shows_a_dash_beside_one_that_has_some() {
        let told = |numbers: &[&str]| side_by_side(&numbers.iter().map(ToString::to_string).collect::<Vec<_>>());
        assert_eq!(told(&["", "t = 2"]), "–  |  t = 2");
        assert_eq!([told(&[""]), told(&["t = 2"])], ["", "t = 2"]);
    }
}
