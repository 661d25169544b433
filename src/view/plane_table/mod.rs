//! The plane table of § 6.2.3, filled in row by row, and beside it the stretch of the ray that is inside all planes so far.

mod slabs;
#[cfg(test)]
mod tests;

use super::drawing::{Anchor, Drawing, Form, Frame};
use super::events_of::Story;
use super::fonts::{Face, text_width};
use super::labels::shortened;
use super::palette::Theme;
use super::sheet::{SMALL, Sheet, TEXT};
use super::text::{brief, significant};
use crate::record::{EventId, PlaneRow, PlaneSense, What, format_number};
use crate::trace::RayTree;
use std::fmt::Write as _;

/// The table as a drawing, with the place of each row that is filled in: a click there sets the cursor.
#[derive(Clone, Debug, PartialEq)]
pub struct PlaneTable {
    /// The drawing.
    pub drawing: Drawing,
    /// The rows from the first up to the cursor.
    pub rows: Vec<Frame>,
    /// How many rows there are in all.
    pub count: usize,
}

/// The `Planes` event at, above or below `selected`, filled in up to and with the row `cursor`; all of it where that is none.
#[must_use]
pub fn plane_table(
    tree: &RayTree,
    selected: EventId,
    cursor: Option<usize>,
    size: [f64; 2],
    theme: Theme,
) -> Option<PlaneTable> {
    let event = planes_near(tree, selected)?;
    let What::Planes { rows, stopped } = &tree.event(event).what else { return None };
    let last = cursor.unwrap_or(usize::MAX).min(rows.len().checked_sub(1)?);
    let table = Table { rows, last, stopped: stopped.as_deref().filter(|_| last + 1 == rows.len()) };
    let mut sheet = Sheet::new(size, theme, event);
    let room = sheet.caption(&table.title(), &table.note());
    sheet.drawing.description = table.description();
    let places = table.draw(&mut sheet, room);
    Some(PlaneTable { drawing: sheet.finish(), rows: places, count: rows.len() })
}

/// The table of the selected event, of the primitive that it belongs to, or the first below it.
fn planes_near(tree: &RayTree, selected: EventId) -> Option<EventId> {
    let story = Story::of(tree, selected)?;
    let below = |id: EventId| (id..tree.subtree_end(id)).find(|&id| matches!(tree.event(id).what, What::Planes { .. }));
    for id in tree.path(selected).into_iter().rev() {
        if let Some(found) = below(id) {
            return Some(found);
        }
        if matches!(tree.event(id).what, What::Object { .. } | What::Ray { .. } | What::Step { .. }) {
            break;
        }
    }
    let hit = story.hit(selected)?;
    let What::Hit { leaf, .. } = &tree.event(hit).what else { return None };
    let is_leaf = |id: &EventId| matches!(&tree.event(*id).what, What::Primitive { name, .. } if name == leaf);
    (0..hit).rev().find(is_leaf).and_then(below)
}

struct Table<'t> {
    rows: &'t [PlaneRow],
    last: usize,
    stopped: Option<&'t str>,
}

/// How much narrower columns are where there is little room for the slabs beside them.
const TIGHT: f64 = 0.8;

/// The heights of rows, in points.
const PITCH: [f64; 2] = [13.0, 60.0];

impl Table<'_> {
    fn current(&self) -> &PlaneRow {
        &self.rows[self.last]
    }

    fn title(&self) -> String {
        format!("Plane table: row {} of {}, {}", self.last + 1, self.rows.len(), self.current().name)
    }

    /// The current row, worked out.
    fn note(&self) -> String {
        if let Some(reason) = self.stopped {
            return format!("stopped: {}", reason.replace("t_in", "tᵢₙ").replace("t_out", "tₒᵤₜ"));
        }
        let row = self.current();
        let [numerator, denominator] = [row.numerator, row.denominator].map(brief);
        match (row.t, row.sense) {
            (Some(t), PlaneSense::Entering) => {
                format!("t = {numerator} / {denominator} = {}, entering: tᵢₙ = {}", brief(t), open(row.t_in, "−∞"))
            }
            (Some(t), _) => {
                format!("t = {numerator} / {denominator} = {}, leaving: tₒᵤₜ = {}", brief(t), open(row.t_out, "∞"))
            }
            (None, PlaneSense::ParallelOutside) => format!("m·c = {denominator}: parallel, outside: the ray misses"),
            (None, _) => format!("m·c = {denominator}: parallel, inside: nothing changes"),
        }
    }

    fn description(&self) -> String {
        let mut text = format!("The plane table, {} of {} rows filled in.", self.last + 1, self.rows.len());
        for row in &self.rows[..=self.last] {
            let [numerator, denominator] = [row.numerator, row.denominator].map(format_number);
            let time = row.t.map_or("no t".to_owned(), |t| format!("t = {}", format_number(t)));
            let _ = write!(
                text,
                " Plane {}: {numerator} / {denominator}, {time}, {}; t_in = {}, t_out = {}.",
                row.name,
                sense(row.sense),
                open(row.t_in, "−∞"),
                open(row.t_out, "∞"),
            );
        }
        if let Some(reason) = self.stopped {
            let _ = write!(text, " Stopped: {reason}.");
        }
        text
    }

    /// Whether every number can be written in full in columns so much narrower.
    fn fits(&self, columns: &[Column], tight: f64) -> bool {
        let fits =
            |column: &Column, row| text_width(&column.text(row), TEXT, Face::Sans) <= tight * column.width() - 4.0;
        let numbers = columns.iter().filter(|column| column.anchor() == Anchor::End);
        numbers.clone().all(|column| self.rows.iter().all(|row| fits(column, row)))
    }

    fn draw(&self, sheet: &mut Sheet, room: Frame) -> Vec<Frame> {
        let [width, height] = room.size();
        if width < 90.0 || height < 5.0 * PITCH[0] {
            return Vec::new();
        }
        let columns = Column::that_fit(width);
        let tight = if width < 380.0 && self.fits(&columns, TIGHT) { TIGHT } else { 1.0 };
        let wide = |column: &Column| tight * column.width();
        let used: f64 = columns.iter().map(wide).sum();
        // One line more for the heading and one for what is left of the ray, with room for the axis.
        let pitch = ((height - 20.0) / (self.rows.len() as f64 + 2.0)).clamp(PITCH[0], PITCH[1]);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few rows, never negative")]
        let most = (((height - 20.0) / pitch).floor().max(3.0) - 2.0) as usize;
        // Of a table that is too long the rows up to the cursor are shown.
        let first = (self.last + 1).saturating_sub(most);
        let heading = room.low[1] + 0.5 * pitch;
        let mut x = room.low[0];
        for column in &columns {
            let faint = sheet.palette.faint;
            sheet.write(column.heading(), column.place(x, heading, wide(column)), column.anchor(), SMALL, faint);
            x += wide(column);
        }
        let mut places = Vec::new();
        for (index, row) in self.rows.iter().enumerate().skip(first).take(most) {
            let y = room.low[1] + pitch * ((index - first) as f64 + 1.0);
            let frame = Frame { low: [room.low[0], y], high: [room.high[0], y + pitch] };
            if index <= self.last {
                draw_row(sheet, (&columns, tight), frame, row, index == self.last);
                places.push(frame);
            } else {
                let name = shortened(&row.name, 70.0, TEXT, Face::Sans);
                let faint = sheet.palette.faint.faded(0.7);
                sheet.write(&name, [room.low[0] + 2.0, y + 0.5 * pitch], Anchor::Start, TEXT, faint);
            }
        }
        let left = room.low[0] + used + 14.0;
        let shown = self.rows.len().min(most);
        if room.high[0] - left > 60.0 {
            let area = Frame { low: [left, room.low[1]], high: room.high };
            slabs::draw(sheet, area, pitch, self.rows, first..first + shown, self.last);
        }
        places
    }
}

/// A row that is filled in; the current one is lit.
fn draw_row(sheet: &mut Sheet, (columns, tight): (&[Column], f64), frame: Frame, row: &PlaneRow, is_current: bool) {
    if is_current {
        let fill = Some(sheet.palette.highlight.faded(0.28));
        sheet.drawing.put(Form::Rect { frame, fill, stroke: None }, sheet.event);
    }
    let middle = frame.middle()[1];
    let mut x = frame.low[0];
    for column in columns {
        let width = tight * column.width();
        let text = column.text_within(row, width - 4.0);
        let ink = sheet.palette.ink;
        sheet.write(&text, column.place(x, middle, width), column.anchor(), TEXT, ink);
        x += width;
    }
}

/// A time, or the sign for none.
fn open(t: Option<f64>, none: &str) -> String {
    t.map_or(none.to_owned(), brief)
}

const fn sense(sense: PlaneSense) -> &'static str {
    match sense {
        PlaneSense::Entering => "entering",
        PlaneSense::Leaving => "leaving",
        PlaneSense::ParallelInside => "parallel, inside",
        PlaneSense::ParallelOutside => "parallel, outside",
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Column {
    Plane,
    Numerator,
    Denominator,
    Time,
    Sense,
    In,
    Out,
}

impl Column {
    const ALL: [Self; 7] =
        [Self::Plane, Self::Numerator, Self::Denominator, Self::Time, Self::Sense, Self::In, Self::Out];

    /// All of them where the slabs have room beside them; else without those that the others follow from.
    fn that_fit(width: f64) -> Vec<Self> {
        let dispensable: [&[Self]; 3] = [&[], &[Self::Sense], &[Self::Sense, Self::Numerator, Self::Denominator]];
        let kept = |without: &[Self]| Self::ALL.into_iter().filter(|c| !without.contains(c)).collect::<Vec<_>>();
        let fits = |columns: &Vec<Self>| columns.iter().map(|c| c.width()).sum::<f64>() <= 0.66 * width;
        dispensable.into_iter().map(kept).find(fits).unwrap_or_else(|| kept(dispensable[2]))
    }

    const fn width(self) -> f64 {
        match self {
            Self::Plane => 62.0,
            Self::Numerator => 80.0,
            Self::Sense => 96.0,
            Self::Denominator | Self::Time | Self::In | Self::Out => 52.0,
        }
    }

    const fn heading(self) -> &'static str {
        match self {
            Self::Plane => "plane",
            Self::Numerator => "m·(spot − S)",
            Self::Denominator => "m·c",
            Self::Time => "t",
            Self::Sense => "sense",
            Self::In => "tᵢₙ",
            Self::Out => "tₒᵤₜ",
        }
    }

    const fn anchor(self) -> Anchor {
        match self {
            Self::Plane | Self::Sense => Anchor::Start,
            _ => Anchor::End,
        }
    }

    /// The place of its text in a row.
    fn place(self, left: f64, y: f64, width: f64) -> [f64; 2] {
        match self {
            Self::Plane => [left + 2.0, y],
            Self::Sense => [left + 12.0, y],
            _ => [left + width - 2.0, y],
        }
    }

    fn text(self, row: &PlaneRow) -> String {
        self.text_of(row, 4)
    }

    /// With so many digits that it is no wider; a number without its power of ten would be another one.
    fn text_within(self, row: &PlaneRow, width: f64) -> String {
        let mut texts = (1..=4).rev().map(|digits| self.text_of(row, digits));
        let fitting = texts.find(|text| text_width(text, TEXT, Face::Sans) <= width);
        fitting.unwrap_or_else(|| match self {
            Self::Plane | Self::Sense => shortened(&self.text(row), width, TEXT, Face::Sans),
            _ => self.text_of(row, 1),
        })
    }

    fn text_of(self, row: &PlaneRow, digits: i32) -> String {
        let number = |x: f64| significant(x, digits);
        let open = |t: Option<f64>, none: &str| t.map_or(none.to_owned(), number);
        match self {
            Self::Plane => row.name.clone(),
            Self::Numerator => number(row.numerator),
            Self::Denominator => number(row.denominator),
            Self::Time => open(row.t, "none"),
            Self::Sense => sense(row.sense).to_owned(),
            Self::In => open(row.t_in, "−∞"),
            Self::Out => open(row.t_out, "∞"),
        }
    }
}
