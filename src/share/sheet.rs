//! A step on a sheet of the shape of a screen: its title, its drawings, its working. A drawing itself, so that a PDF and a
//! moving picture are made from it as from any other.

use super::figures::{Figure, figures_of};
use super::lines::{SetLine, broken, set};
use super::{Account, Steps};
use crate::view::{Anchor, Colour, Drawing, Face, Form, Frame, Palette, Spot, Text, beneath, detail, equated, row};
use std::fmt::Write as _;

/// Width and height of a sheet in points: 16 by 9.
pub const SHEET: [f64; 2] = [960.0, 540.0];

/// Sizes in points.
const MARGIN: f64 = 28.0;
const TITLE: f64 = 22.0;
const NUMBERS: f64 = 15.0;
const NOTE: f64 = 13.0;
const LINE: f64 = 12.0;
const SMALL: f64 = 10.5;
const LEADING: f64 = 1.38;
/// Where the working begins.
const COLUMN: f64 = 600.0;
/// The drawings' upper edge at the least, and what is left below them.
const TOP: f64 = 98.0;
const BOTTOM: f64 = 34.0;
/// The caption of a moving picture.
const CAPTION: f64 = 64.0;

/// A step of an account, on its sheet.
pub struct Sheet<'a> {
    account: &'a Account<'a>,
    steps: &'a Steps,
    place: usize,
    drawing: Drawing,
    palette: &'static Palette,
}

impl<'a> Sheet<'a> {
    fn new(account: &'a Account<'a>, steps: &'a Steps, place: usize) -> Self {
        let palette = account.theme.palette();
        Self { account, steps, place, drawing: Drawing::new(SHEET, palette.ground), palette }
    }

    /// The step as a slide: title, note, drawings on the left, working on the right.
    pub fn slide(account: &'a Account<'a>, steps: &'a Steps, place: usize) -> Drawing {
        let mut sheet = Self::new(account, steps, place);
        let top = sheet.heading();
        // Where there is no working, the drawings have the whole width.
        let has_working = !beneath(account.tree.event(sheet.event())).is_empty();
        let width = if has_working { COLUMN - MARGIN - 20.0 } else { SHEET[0] - 2.0 * MARGIN };
        let height = SHEET[1] - top - BOTTOM;
        let figures = figures_of(account, sheet.event(), |count| share(count, [width, height], false));
        let has_figures = !figures.is_empty();
        sheet.put_figures(&figures, [MARGIN, top], false);
        sheet.working(top + LINE, if has_figures { COLUMN } else { MARGIN });
        sheet.footer();
        sheet.told(&figures)
    }

    /// The step as a frame of a moving picture: drawings, and the event's row as their caption.
    pub fn frame(account: &'a Account<'a>, steps: &'a Steps, place: usize) -> Drawing {
        let mut sheet = Self::new(account, steps, place);
        let room = [SHEET[0], SHEET[1] - CAPTION];
        let figures = figures_of(account, sheet.event(), |count| share(count, room, true));
        sheet.put_figures(&figures, [0.0, 0.0], true);
        sheet.caption();
        sheet.told(&figures)
    }

    fn event(&self) -> u32 {
        self.steps.events[self.place]
    }

    fn put_figures(&mut self, figures: &[Figure], at: Spot, beside: bool) {
        let mut at = at;
        for figure in figures {
            self.drawing.include(&figure.drawing, at);
            if beside { at[0] += figure.drawing.width } else { at[1] += figure.drawing.height }
        }
    }

    fn put(&mut self, text: impl Into<String>, at: Spot, size: f64, colour: Colour, face: Face) {
        let text = Text { at, text: text.into(), anchor: Anchor::Start, size, colour, face, halo: None };
        self.drawing.put(Form::Text(text), None);
    }

    /// The title, the numbers and the note; where they end.
    fn heading(&mut self) -> f64 {
        let event = self.account.tree.event(self.event());
        let (row, detail) = (row(event), detail(event));
        let width = SHEET[0] - 2.0 * MARGIN;
        let mut y = MARGIN + 8.0;
        for line in broken(&format!("{} {}", row.icon, detail.title), width, TITLE, Face::Bold).into_iter().take(2) {
            self.put(line, [MARGIN, y], TITLE, self.palette.ink, Face::Bold);
            y += TITLE * LEADING;
        }
        y -= TITLE * LEADING - NUMBERS * LEADING - 2.0;
        for line in broken(&row.numbers, width, NUMBERS, Face::Sans).into_iter().take(2).filter(|line| !line.is_empty())
        {
            self.put(line, [MARGIN, y], NUMBERS, self.palette.camera, Face::Sans);
            y += NUMBERS * LEADING;
        }
        for line in broken(detail.explanation, width, NOTE, Face::Sans).into_iter().take(3) {
            self.put(line, [MARGIN, y], NOTE, self.palette.faint, Face::Sans);
            y += NOTE * LEADING;
        }
        (y + 2.0).max(TOP)
    }

    /// As much of the working as there is room for, and how much there is none for.
    fn working(&mut self, top: f64, left: f64) {
        let lines = beneath(self.account.tree.event(self.event()));
        let set = set(&lines, SHEET[0] - MARGIN - left, LINE);
        let bottom = SHEET[1] - BOTTOM - LINE;
        let mut y = top;
        for (i, line) in set.iter().enumerate() {
            y += if line.begins && i > 0 { 0.35 * LINE } else { 0.0 };
            let rest = set.len() - i;
            if y > bottom && rest > 1 {
                let more = format!("… {rest} more lines; the worked example holds them all");
                self.put(more, [left, y], SMALL, self.palette.faint, Face::Sans);
                return;
            }
            let SetLine { text, face, indent, .. } = line;
            self.put(text.clone(), [left + indent, y], LINE, self.palette.ink, *face);
            y += LINE * LEADING;
        }
    }

    fn footer(&mut self) {
        let y = SHEET[1] - 12.0;
        let where_from = format!("{} · {}", self.account.name, self.account.aim());
        self.put(where_from, [MARGIN, y], SMALL, self.palette.faint, Face::Sans);
        self.count([SHEET[0] - MARGIN, y], SMALL);
        self.progress();
    }

    /// `3 / 12` at the right.
    fn count(&mut self, at: Spot, size: f64) {
        let mut text = format!("{} / {}", self.place + 1, self.steps.events.len());
        if self.steps.left_out > 0 {
            let _ = write!(text, ", {} more left out", self.steps.left_out);
        }
        let colour = self.palette.faint;
        let text = Text { at, text, anchor: Anchor::End, size, colour, face: Face::Sans, halo: None };
        self.drawing.put(Form::Text(text), None);
    }

    /// A bar along the lower edge, as long as the share of the steps up to this one.
    fn progress(&mut self) {
        let share = (self.place + 1) as f64 / self.steps.events.len().max(1) as f64;
        let [width, height] = SHEET;
        let frame = |right: f64| Frame { low: [0.0, height - 4.0], high: [right, height] };
        self.drawing.put(Form::Rect { frame: frame(width), fill: Some(self.palette.grid), stroke: None }, None);
        self.drawing
            .put(Form::Rect { frame: frame(width * share), fill: Some(self.palette.camera), stroke: None }, None);
    }

    fn caption(&mut self) {
        let event = self.account.tree.event(self.event());
        let row = row(event);
        let ground = Frame { low: [0.0, SHEET[1] - CAPTION], high: SHEET };
        self.drawing.put(Form::Rect { frame: ground, fill: Some(self.palette.panel), stroke: None }, None);
        let width = SHEET[0] - 2.0 * MARGIN - if self.steps.left_out > 0 { 220.0 } else { 90.0 };
        let first = |text: &str, size, face| broken(text, width, size, face).into_iter().next().unwrap_or_default();
        let title = first(&format!("{} {}", row.icon, detail(event).title), 18.0, Face::Bold);
        self.put(title, [MARGIN, SHEET[1] - CAPTION + 26.0], 18.0, self.palette.ink, Face::Bold);
        let numbers = first(&row.numbers, NUMBERS, Face::Sans);
        self.put(numbers, [MARGIN, SHEET[1] - CAPTION + 48.0], NUMBERS, self.palette.ink, Face::Sans);
        self.count([SHEET[0] - MARGIN, SHEET[1] - CAPTION + 26.0], NUMBERS);
        self.progress();
    }

    /// The sheet with everything on it said in words.
    fn told(mut self, figures: &[Figure]) -> Drawing {
        let event = self.account.tree.event(self.event());
        let (row, detail) = (row(event), detail(event));
        let mut words = vec![
            format!("Step {} of {}: {}. {}", self.place + 1, self.steps.events.len(), detail.title, row.numbers),
            detail.explanation.to_owned(),
        ];
        words.extend(beneath(event).iter().map(in_words));
        words.extend(figures.iter().map(|figure| figure.drawing.in_words().into_owned()));
        self.drawing.description = words.join("\n");
        self.drawing
    }
}

/// The size of each of so many drawings in a room: beside each other or one below the other.
fn share(count: usize, [width, height]: [f64; 2], beside: bool) -> [f64; 2] {
    let count = count.max(1) as f64;
    if beside { [width / count, height] } else { [width, height / count] }
}

fn in_words(line: &crate::view::DetailLine) -> String {
    use crate::view::DetailLine;
    match line {
        DetailLine::Pair { name, value } => format!("{name}: {value}"),
        DetailLine::Working { symbol, formula, numbers, result } => {
            equated(symbol, [formula, numbers, result]).join(" = ")
        }
        DetailLine::Table { title, headers, rows } => {
            let row = |row: &Vec<String>| {
                let cells = headers.iter().zip(row).map(|(header, cell)| format!("{header} {cell}").trim().to_owned());
                cells.collect::<Vec<_>>().join(", ")
            };
            format!("{title}: {}", rows.iter().map(row).collect::<Vec<_>>().join("; "))
        }
    }
}
