//! What is drawn on, and the heading.

use super::{FrontierPlot, legend};
use crate::view::drawing::{Anchor, Drawing, Form, Frame, Spot};
use crate::view::fonts::Face;
use crate::view::labels::{Label, shortened};
use crate::view::palette::{Colour, Palette, Theme};

/// Sizes in points.
const TITLE: f64 = 14.0;
pub const TEXT: f64 = 11.5;
pub const SMALL: f64 = 10.5;
pub const MARGIN: f64 = 14.0;
pub const LINE: f64 = 15.0;
/// Room for the numbers at the left, and for the axis below.
const LEFT: f64 = 62.0;
const BELOW: f64 = 44.0;

/// The drawing as far as it goes.
pub struct Paper<'a> {
    /// What is plotted.
    pub plot: &'a FrontierPlot,
    /// The marks.
    pub drawing: Drawing,
    /// The colours.
    pub palette: &'static Palette,
    /// What is left beside the field for labels that find no room in it.
    pub column: Option<Frame>,
}

impl<'a> Paper<'a> {
    /// An empty one.
    pub fn new(plot: &'a FrontierPlot, size: [f64; 2], theme: Theme) -> Self {
        let palette = theme.palette();
        Self { plot, drawing: Drawing::new(size, palette.ground), palette, column: None }
    }

    /// Adds a mark; `point` is the place of the point that it stands for.
    pub fn put(&mut self, form: Form, point: Option<usize>) {
        self.drawing.put(form, point.and_then(|k| u32::try_from(k).ok()));
    }

    /// Adds a small text with its middle at the height of `at`.
    pub fn text(&mut self, text: &str, at: Spot, anchor: Anchor, colour: Colour) {
        let label = Label::new(text, SMALL, colour);
        self.put(Form::Text(label.at(at, anchor, None)), None);
    }

    /// Title, notes, legend and the y axis's name; returns what is left for the field.
    pub fn heading(&mut self) -> Frame {
        let width = self.drawing.width - 2.0 * MARGIN;
        let mut y = MARGIN + 4.0;
        let title = shortened(&self.plot.title, width, TITLE, Face::Bold);
        let title = Label::new(title, TITLE, self.palette.ink).face(Face::Bold);
        self.put(Form::Text(title.at([MARGIN, y], Anchor::Start, None)), None);
        y += LINE + 4.0;
        for note in &self.plot.notes {
            let note = Label::new(shortened(note, width, TEXT, Face::Sans), TEXT, self.palette.faint);
            self.put(Form::Text(note.at([MARGIN, y], Anchor::Start, None)), None);
            y += LINE;
        }
        let whole = self.drawing.frame();
        let bottom = (whole.high[1] - BELOW).max(y + 60.0);
        let (left, mut right) = (MARGIN + LEFT, whole.high[0] - MARGIN);
        if legend::stands_beside(self.drawing.width) {
            right -= legend::WIDTH;
            let beside = Frame { low: [right + 16.0, y + 4.0], high: [whole.high[0] - 6.0, bottom] };
            let used = legend::column(self, beside.low);
            self.column = Some(Frame { low: [beside.low[0], used + 10.0], high: beside.high });
        } else {
            y = legend::rows(self, y, width);
        }
        let name = shortened(&self.plot.y_name, right - MARGIN, TEXT, Face::Sans);
        let name = Label::new(name, TEXT, self.palette.ink);
        self.put(Form::Text(name.at([MARGIN, y + 5.0], Anchor::Start, None)), None);
        Frame { low: [left, y + 16.0], high: [right, bottom] }
    }
}
