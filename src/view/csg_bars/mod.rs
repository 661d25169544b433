//! The whole CSG tree of an object at once: each node's inside intervals as a bar, all on one t axis.

mod rows;
#[cfg(test)]
mod tests;

use super::axis::Axis;
use super::drawing::{Anchor, Drawing, Form, Frame, Spot, Stroke, Text};
use super::events_of::Story;
use super::flights::End;
use super::fonts::{Face, text_width};
use super::interval_bars::range;
use super::labels::{Label, shortened};
use super::palette::{Colour, Theme};
use super::sheet::{SMALL, Sheet, TEXT, is_roomy};
use super::text::{brief, times};
use crate::record::{Edge, EventId, Span, What};
use crate::scene::Scene;
use crate::trace::RayTree;
use rows::{Row, rows};
use std::fmt::Write as _;

/// The heights of rows, in points: lower ones could not be read, higher ones would lie too far apart to be compared.
const PITCH: [f64; 2] = [14.0, 64.0];
/// Room below the rows for the numbers of the axis and the names of the marked times.
const BELOW: f64 = 34.0;
/// How far operands are set in.
const INDENT: f64 = 12.0;
/// Between the end of a bar, or an upright line, and the number beside it.
const ASIDE: f64 = 4.0;

/// The bars of the object that `selected` belongs to. `probe_t` marks one more time on the axis.
#[must_use]
pub fn csg_bars(
    scene: &Scene,
    tree: &RayTree,
    selected: EventId,
    probe_t: Option<f64>,
    size: [f64; 2],
    theme: Theme,
) -> Option<Drawing> {
    let story = Story::of(tree, selected)?;
    let object = story.object_near(selected)?;
    let What::Object { index, name, .. } = &tree.event(object).what else { return None };
    let solid = &scene.objects.get(*index).filter(|other| other.name == *name)?.solid;
    let rows = rows(solid, tree, object)?;
    let hit = match story.flights.ray_of(object).end {
        End::Hit { event, t } => Some((event, t)),
        _ => None,
    };
    let mut sheet = Sheet::new(size, theme, object);
    let result = rows[0].spans.as_ref().map_or(String::new(), |spans| times(spans));
    let ray = story.flights.ray_of(object).kind.name();
    let room = sheet.caption(&format!("{name} along the {ray} ray"), &format!("inside of all of it: {result}"));
    sheet.drawing.description = description(name, ray, &rows, hit);
    let lists: Vec<&[Span]> = rows.iter().filter_map(|row| row.spans.as_deref().ok()).collect();
    let lit = lit(&story, &rows, selected);
    if is_roomy(&room) {
        let bars = Bars::new(room, &rows, range(&lists, hit), lit, [hit.map(|(_, t)| t), probe_t]);
        bars.draw(&mut sheet, &rows, hit, probe_t);
    }
    Some(sheet.finish())
}

/// The row of the selected event: the nearest node above it, or the leaf that was hit.
fn lit(story: &Story, rows: &[Row], selected: EventId) -> Option<usize> {
    let row_of = |id: EventId| rows.iter().position(|row| row.event == Some(id));
    let above = story.tree.path(selected).into_iter().rev().find_map(row_of);
    above.or_else(|| story.primitive_near(selected).and_then(row_of))
}

fn description(name: &str, ray: &str, rows: &[Row], hit: Option<(EventId, f64)>) -> String {
    let mut text =
        format!("The CSG tree of {name} along the {ray} ray, each node with the times at which the ray is inside.");
    for row in rows {
        let operator = row.operator.map_or(String::new(), |operator| format!("{} ", operator.sign()));
        let told = match &row.spans {
            Ok(spans) => times(spans),
            Err(reason) => format!("not asked, for {reason}"),
        };
        let remark = row.remark.as_ref().map_or(String::new(), |remark| format!(", {remark}"));
        let _ = write!(text, " Level {}: {operator}{}: {told}{remark}.", row.depth, row.name);
    }
    if let Some((_, t)) = hit {
        let _ = write!(text, " The hit that is seen is at t = {}.", brief(t));
    }
    text
}

struct Bars {
    room: Frame,
    axis: Axis,
    pitch: f64,
    /// The first row that is shown, and how many.
    first: usize,
    shown: usize,
    lit: Option<usize>,
    /// The places of the upright lines.
    upright: Vec<f64>,
}

impl Bars {
    fn new(room: Frame, rows: &[Row], values: [f64; 2], lit: Option<usize>, marked: [Option<f64>; 2]) -> Self {
        let widest = rows.iter().map(|row| INDENT * row.depth as f64 + text_width(&title(row), TEXT, Face::Sans));
        let column = (widest.fold(0.0, f64::max) + 8.0).min(0.36 * room.size()[0]);
        let height = room.size()[1] - BELOW;
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "as many rows as fit on a canvas")]
        let most = ((height / PITCH[0]).floor().max(1.0) as usize).min(rows.len());
        let pitch = (height / most as f64).clamp(PITCH[0], PITCH[1]);
        // The lit row stays in sight, with what lies above it as long as there is room.
        let first = lit.unwrap_or(0).saturating_sub(most / 2).min(rows.len() - most);
        let axis = with_room_for_numbers(values, [room.low[0] + column + 6.0, room.high[0] - 6.0], rows);
        let marked = [Some(0.0)].into_iter().chain(marked).flatten().filter(|t| axis.shows(*t));
        let upright = marked.map(|t| axis.at(t)).collect();
        Self { room, axis, pitch, first, shown: most, lit, upright }
    }

    fn middle(&self, index: usize) -> f64 {
        self.room.low[1] + self.pitch * ((index - self.first) as f64 + 0.5)
    }

    fn base(&self) -> f64 {
        self.room.low[1] + self.pitch * self.shown as f64 + 2.0
    }

    fn draw(&self, sheet: &mut Sheet, rows: &[Row], hit: Option<(EventId, f64)>, probe_t: Option<f64>) {
        let visible = self.first..self.first + self.shown;
        if let Some(index) = self.lit.filter(|index| visible.contains(index)) {
            self.light(sheet, index, rows[index].event);
        }
        self.times(sheet, hit, probe_t);
        for index in visible.clone() {
            self.bars(sheet, &rows[index], index);
        }
        self.behind(sheet);
        for index in visible {
            self.name(sheet, &rows[index], index);
            self.words(sheet, &rows[index], index);
        }
        self.numbers(sheet);
        if self.shown < rows.len() {
            let text = format!("rows {} to {} of {}", self.first + 1, self.first + self.shown, rows.len());
            let at = [self.room.low[0], self.base() + 11.0];
            sheet.write(&text, at, Anchor::Start, SMALL, sheet.palette.faint);
        }
    }

    fn light(&self, sheet: &mut Sheet, index: usize, event: Option<EventId>) {
        let (y, half) = (self.middle(index), 0.5 * self.pitch);
        let frame = Frame { low: [self.room.low[0] - 4.0, y - half], high: [self.room.high[0], y + half] };
        let fill = Some(sheet.palette.highlight.faded(0.26));
        sheet.drawing.put(Form::Rect { frame, fill, stroke: None }, event);
    }

    /// The colour of what is left, right and combined, as everywhere.
    fn colour(sheet: &Sheet, row: &Row) -> Colour {
        match row.side {
            None => sheet.palette.combined,
            Some(0) => sheet.palette.left,
            Some(_) => sheet.palette.right,
        }
    }

    fn bars(&self, sheet: &mut Sheet, row: &Row, index: usize) {
        let [left, right] = self.axis.points;
        let y = self.middle(index);
        let stroke = Stroke::solid(sheet.palette.grid, 1.0);
        sheet.drawing.put(Form::Line { points: vec![[left, y], [right, y]], stroke }, row.event);
        let thick = (0.44 * self.pitch).clamp(6.0, 22.0);
        let Ok(spans) = &row.spans else {
            self.never_asked(sheet, row, y, thick);
            return;
        };
        for span in spans {
            let from = span.enter.as_ref().map_or(left, |edge| self.axis.at(edge.t).max(left).min(right));
            let to = span.leave.as_ref().map_or(right, |edge| self.axis.at(edge.t).max(left).min(right));
            // A stretch too short to see is still there.
            let (from, to) = if to - from < 1.5 { (from - 0.75, from + 0.75) } else { (from, to) };
            let frame = Frame { low: [from, y - 0.5 * thick], high: [to, y + 0.5 * thick] };
            let colour = Self::colour(sheet, row);
            sheet.drawing.put(Form::Rect { frame, fill: Some(colour), stroke: None }, row.event);
            sheet.placer.reserve(frame.grown(1.0));
            self.unbounded(sheet, row, [span.enter.is_none(), span.leave.is_none()], y, colour);
        }
    }

    /// Arrow heads where a bar goes on beyond the axis.
    fn unbounded(&self, sheet: &mut Sheet, row: &Row, open: [bool; 2], y: f64, colour: Colour) {
        let [left, right] = self.axis.points;
        let stroke = Stroke::solid(colour, 1.5);
        for (is_open, x, outward) in [(open[0], left, -1.0), (open[1], right, 1.0)] {
            if is_open {
                let (from, to) = ([x - 8.0 * outward, y], [x + 5.0 * outward, y]);
                sheet.drawing.put(Form::Arrow { from, to, head: 8.0, stroke }, row.event);
            }
        }
    }

    /// Hatching from end to end.
    fn never_asked(&self, sheet: &mut Sheet, row: &Row, y: f64, thick: f64) {
        let [left, right] = self.axis.points;
        let frame = Frame { low: [left, y - 0.5 * thick], high: [right, y + 0.5 * thick] };
        let stroke = Stroke::solid(sheet.palette.faint.faded(0.5), 1.0);
        let own = sheet.event;
        sheet.event = row.event.unwrap_or(own);
        let count = ((right - left + thick) / 7.0).floor().max(0.0);
        let strokes = (0..2_000).map(f64::from).take_while(|i| *i <= count);
        for x in strokes.map(|i| left + 7.0 * i) {
            sheet.line(&frame, &[[x, y - 0.5 * thick], [x - thick, y + 0.5 * thick]], stroke);
        }
        sheet.event = own;
    }

    fn name(&self, sheet: &mut Sheet, row: &Row, index: usize) {
        let column = self.axis.points[0] - self.room.low[0] - 6.0;
        let inset = (INDENT * row.depth as f64).min(0.4 * column);
        let y = self.middle(index);
        let text = shortened(&title(row), column - inset, TEXT, Face::Sans);
        let ink = if row.spans.is_ok() { sheet.palette.ink } else { sheet.palette.faint };
        let label = Label { event: row.event, ..Label::new(text, TEXT, ink) };
        let text = label.at([self.room.low[0] + inset, y], Anchor::Start, None);
        sheet.placer.put_at(&mut sheet.drawing, text, row.event);
    }

    /// The times at the ends of the bars, beside them; what there is to say where there are none.
    fn words(&self, sheet: &mut Sheet, row: &Row, index: usize) {
        let y = self.middle(index);
        let (faint, bad) = (sheet.palette.faint, sheet.palette.bad);
        let middle = f64::midpoint(self.axis.points[0], self.axis.points[1]);
        match &row.spans {
            Err(reason) => self.say(sheet, row, &format!("not asked: {reason}"), middle, y, faint),
            Ok(spans) if spans.is_empty() => {
                let (text, colour) = match &row.remark {
                    Some(remark) => (remark.as_str(), if row.operator.is_some() { bad } else { faint }),
                    None => ("missed", faint),
                };
                self.say(sheet, row, text, middle, y, colour);
            }
            Ok(spans) => {
                for (edge, outward) in spans.iter().flat_map(|span| [(&span.enter, -1.0), (&span.leave, 1.0)]) {
                    if let Some(edge) = edge.as_ref().filter(|edge| self.axis.shows(edge.t)) {
                        self.number(sheet, row, edge.t, y, outward);
                    }
                }
            }
        }
    }

    /// A time beside the end of a bar; beyond an upright line that would go through it.
    fn number(&self, sheet: &mut Sheet, row: &Row, t: f64, y: f64, outward: f64) {
        let (x, number) = (self.axis.at(t), brief(t));
        let anchor = if outward < 0.0 { Anchor::End } else { Anchor::Start };
        let at = |x: f64, sheet: &Sheet| beside(&number, [x + outward * ASIDE, y], anchor, sheet);
        let text = at(x, sheet);
        let frame = text.frame();
        let within = |line: &&f64| frame.low[0] - 1.0 < **line && **line < frame.high[0] + 1.0;
        let beyond = self.upright.iter().find(within).map(|line| at(*line, sheet));
        let is_put = beyond.is_some_and(|text| sheet.placer.put_at(&mut sheet.drawing, text, row.event));
        if !is_put {
            sheet.placer.put_at(&mut sheet.drawing, text, row.event);
        }
    }

    fn say(&self, sheet: &mut Sheet, row: &Row, text: &str, x: f64, y: f64, colour: Colour) {
        let width = self.axis.points[1] - self.axis.points[0] - 12.0;
        let text = shortened(text, width, SMALL, Face::Sans);
        let label = Label { event: row.event, ..Label::new(text, SMALL, colour) };
        let text = label.at([x, y], Anchor::Middle, Some(sheet.palette.ground));
        sheet.placer.put_at(&mut sheet.drawing, text, row.event);
    }

    /// What lies behind the ray's start is paler.
    fn behind(&self, sheet: &mut Sheet) {
        let [left, right] = self.axis.points;
        let start = self.axis.at(0.0).min(right);
        if start > left {
            let frame = Frame { low: [left - 6.0, self.room.low[1]], high: [start, self.base()] };
            let fill = Some(sheet.palette.ground.faded(0.6));
            sheet.drawing.put(Form::Rect { frame, fill, stroke: None }, None);
        }
    }

    /// Upright lines at the ray's start, the hit that is seen, and the time that is looked at.
    fn times(&self, sheet: &mut Sheet, hit: Option<(EventId, f64)>, probe_t: Option<f64>) {
        let palette = sheet.palette;
        let probe = probe_t.map(|t| (t, format!("t = {}", brief(t)), palette.ink, None));
        let seen = hit.map(|(event, t)| (t, format!("seen: t = {}", brief(t)), palette.good, Some(event)));
        let start = Some((0.0, "the ray starts".to_owned(), palette.faint, None));
        for (t, name, colour, event) in [probe, seen, start].into_iter().flatten().filter(|(t, ..)| self.axis.shows(*t))
        {
            let x = self.axis.at(t);
            let stroke = Stroke::solid(colour, 1.4);
            let points = vec![[x, self.room.low[1] - 2.0], [x, self.base()]];
            sheet.drawing.put(Form::Line { points, stroke }, event);
            let y = self.base() + 24.0;
            for (side, anchor) in [(0.0, Anchor::Middle), (-3.0, Anchor::Start), (3.0, Anchor::End)] {
                let label = Label::new(name.clone(), SMALL, colour).at([x + side, y], anchor, None);
                if sheet.placer.put_at(&mut sheet.drawing, label, event) {
                    break;
                }
            }
        }
    }

    fn numbers(&self, sheet: &mut Sheet) {
        let [left, right] = self.axis.points;
        let (base, faint) = (self.base(), sheet.palette.faint);
        let stroke = Stroke::solid(faint, 1.0);
        sheet.drawing.put(Form::Line { points: vec![[left, base], [right, base]], stroke }, None);
        for tick in self.axis.ticks((right - left) / 60.0) {
            let x = self.axis.at(tick);
            sheet.drawing.put(Form::Line { points: vec![[x, base], [x, base + 4.0]], stroke }, None);
            sheet.write(&brief(tick), [x, base + 11.0], Anchor::Middle, SMALL, faint);
        }
        sheet.write("t", [left - 8.0, base + 11.0], Anchor::Middle, TEXT, faint);
    }
}

/// An axis on which the numbers beside the outermost ends find room, too.
fn with_room_for_numbers(values: [f64; 2], [left, right]: [f64; 2], rows: &[Row]) -> Axis {
    let axis = Axis { values, points: [left, right] };
    let spans = || rows.iter().filter_map(|row| row.spans.as_ref().ok()).flatten();
    let reach = |t: f64| text_width(&brief(t), SMALL, Face::Sans) + ASIDE;
    let seen = |edge: &&Edge| axis.shows(edge.t);
    let before =
        spans().filter_map(|span| span.enter.as_ref()).filter(seen).map(|edge| reach(edge.t) - axis.at(edge.t) + left);
    let after =
        spans().filter_map(|span| span.leave.as_ref()).filter(seen).map(|edge| reach(edge.t) + axis.at(edge.t) - right);
    // Narrow drawings keep most of their width for the bars.
    let most = 0.12 * (right - left);
    let points = [left + before.fold(0.0, f64::max).min(most), right - after.fold(0.0, f64::max).min(most)];
    Axis { values, points }
}

/// The operator's sign and the node's name.
fn title(row: &Row) -> String {
    match row.operator {
        Some(operator) => format!("{} {}", operator.sign(), row.name),
        None => row.name.clone(),
    }
}

/// A number beside the end of a bar.
fn beside(text: &str, at: Spot, anchor: Anchor, sheet: &Sheet) -> Text {
    Label::new(text, SMALL, sheet.palette.ink).at(at, anchor, Some(sheet.palette.ground))
}
