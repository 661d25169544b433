//! A drawing as a list of marks: pixels, SVG and tests all come from the same list.
//!
//! Coordinates are points, x to the right and y down, from the top left corner.

use super::fonts::{Face, text_width};
use super::outline::Pen;
use super::palette::Colour;
use crate::math::portable;
use crate::record::EventId;
use std::borrow::Cow;

/// A place in a drawing.
pub type Spot = [f64; 2];

/// A rectangle with its sides along the axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// The left top corner.
    pub low: Spot,
    /// The right bottom corner.
    pub high: Spot,
}

impl Frame {
    /// Whether the two share more than an edge.
    #[must_use]
    pub fn overlaps(&self, other: &Self) -> bool {
        (0..2).all(|i| self.low[i] < other.high[i] && other.low[i] < self.high[i])
    }

    /// Whether `other` lies within.
    #[must_use]
    pub fn holds(&self, other: &Self) -> bool {
        (0..2).all(|i| self.low[i] <= other.low[i] && other.high[i] <= self.high[i])
    }

    /// Whether the place lies within.
    #[must_use]
    pub fn contains(&self, at: Spot) -> bool {
        (0..2).all(|i| self.low[i] <= at[i] && at[i] <= self.high[i])
    }

    /// Width and height.
    #[must_use]
    pub fn size(&self) -> [f64; 2] {
        [self.high[0] - self.low[0], self.high[1] - self.low[1]]
    }

    /// The place in the middle.
    #[must_use]
    pub fn middle(&self) -> Spot {
        std::array::from_fn(|i| f64::midpoint(self.low[i], self.high[i]))
    }

    /// Wider by `by` on each side.
    #[must_use]
    pub fn grown(&self, by: f64) -> Self {
        Self { low: self.low.map(|x| x - by), high: self.high.map(|x| x + by) }
    }
}

/// How a line is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stroke {
    /// Its colour.
    pub colour: Colour,
    /// Its width in points.
    pub width: f64,
    /// Lengths of dash and gap, if it is dashed.
    pub dash: Option<[f64; 2]>,
}

impl Stroke {
    /// An unbroken line.
    #[must_use]
    pub const fn solid(colour: Colour, width: f64) -> Self {
        Self { colour, width, dash: None }
    }

    /// A dashed line.
    #[must_use]
    pub const fn dashed(colour: Colour, width: f64, dash: [f64; 2]) -> Self {
        Self { colour, width, dash: Some(dash) }
    }
}

/// Which end of a text stands at its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    /// The left one.
    Start,
    /// The middle.
    Middle,
    /// The right one.
    End,
}

/// A line of text.
#[derive(Clone, Debug, PartialEq)]
pub struct Text {
    /// Where it stands; y is the baseline.
    pub at: Spot,
    /// The text.
    pub text: String,
    /// Which end stands at `at`.
    pub anchor: Anchor,
    /// Its size in points.
    pub size: f64,
    /// Its colour.
    pub colour: Colour,
    /// Its look.
    pub face: Face,
    /// The colour of the rim that sets it off from what lies below.
    pub halo: Option<Colour>,
}

/// Heights above and below the baseline in sizes, of everything but the tallest accents.
const ASCENT: f64 = 0.78;
const DESCENT: f64 = 0.24;

/// The width of a halo's line in sizes of the text: enough to set letters off from a line, too little to blot it out.
pub(super) const HALO: f64 = 0.27;

impl Text {
    /// The box that the text fills.
    #[must_use]
    pub fn frame(&self) -> Frame {
        let width = text_width(&self.text, self.size, self.face);
        let left = match self.anchor {
            Anchor::Start => self.at[0],
            Anchor::Middle => self.at[0] - width / 2.0,
            Anchor::End => self.at[0] - width,
        };
        let [top, bottom] = [self.at[1] - ASCENT * self.size, self.at[1] + DESCENT * self.size];
        Frame { low: [left, top], high: [left + width, bottom] }
    }

    /// How far below the middle of its box the baseline of a text lies.
    #[must_use]
    pub fn baseline_below_middle(size: f64) -> f64 {
        (ASCENT - DESCENT) / 2.0 * size
    }
}

/// What a mark looks like.
#[derive(Clone, Debug, PartialEq)]
pub enum Form {
    /// Straight lines from point to point.
    Line {
        /// The points, two or more.
        points: Vec<Spot>,
        /// How it is drawn.
        stroke: Stroke,
    },
    /// The area that an odd number of rings go round.
    Area {
        /// Closed rings.
        rings: Vec<Vec<Spot>>,
        /// The colour of the area.
        fill: Colour,
    },
    /// A circle.
    Circle {
        /// Its centre.
        centre: Spot,
        /// Its radius.
        radius: f64,
        /// The colour of the disc.
        fill: Option<Colour>,
        /// The rim.
        stroke: Option<Stroke>,
    },
    /// A part of a circle.
    Arc {
        /// The centre.
        centre: Spot,
        /// The radius.
        radius: f64,
        /// The angles of its ends in radians, from the x axis towards the y axis (clockwise on screen).
        angles: [f64; 2],
        /// How it is drawn.
        stroke: Stroke,
    },
    /// A line with a head at its far end.
    Arrow {
        /// Where it begins.
        from: Spot,
        /// Its tip.
        to: Spot,
        /// The length of the head.
        head: f64,
        /// How it is drawn.
        stroke: Stroke,
    },
    /// A rectangle.
    Rect {
        /// Its corners.
        frame: Frame,
        /// The colour of the area.
        fill: Option<Colour>,
        /// The rim.
        stroke: Option<Stroke>,
    },
    /// A line of text.
    Text(Text),
    /// An area with curved edges, filled wherever the pen goes round (non-zero winding).
    Outline {
        /// The way round it.
        steps: Vec<Pen>,
        /// The colour of the area.
        fill: Colour,
    },
}

/// A mark and the event that it stands for.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// What it looks like.
    pub form: Form,
    /// The event that it stands for; none for axes and the like.
    pub event: Option<EventId>,
}

/// A drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawing {
    /// In points.
    pub width: f64,
    /// In points.
    pub height: f64,
    /// The ground.
    pub background: Colour,
    /// What is drawn, from the bottom up.
    pub marks: Vec<Mark>,
    /// What there is to see, in sentences and with its numbers, for whoever does not see it.
    pub description: String,
}

impl Drawing {
    /// An empty drawing. Sizes that no screen has are brought into range, so that nothing later divides by zero.
    #[must_use]
    pub fn new(size: [f64; 2], background: Colour) -> Self {
        let [width, height] = size.map(|x| if x.is_finite() { x.clamp(16.0, 16_384.0) } else { 16.0 });
        Self { width, height, background, marks: Vec::new(), description: String::new() }
    }

    /// The whole of it.
    #[must_use]
    pub fn frame(&self) -> Frame {
        Frame { low: [0.0, 0.0], high: [self.width, self.height] }
    }

    /// Adds a mark that stands for an event.
    pub fn put(&mut self, form: Form, event: impl Into<Option<EventId>>) {
        self.marks.push(Mark { form, event: event.into() });
    }

    /// The drawing in words: its description, or where it has none, the texts in it.
    #[must_use]
    pub fn in_words(&self) -> Cow<'_, str> {
        if !self.description.is_empty() {
            return Cow::Borrowed(&self.description);
        }
        Cow::Owned(self.texts().map(|text| text.text.as_str()).collect::<Vec<_>>().join(" · "))
    }

    /// All texts.
    pub fn texts(&self) -> impl Iterator<Item = &Text> {
        self.marks.iter().filter_map(|mark| match &mark.form {
            Form::Text(text) => Some(text),
            _ => None,
        })
    }
}

/// The length of a vector.
pub(super) fn length(v: Spot) -> f64 {
    portable::hypot(v[0], v[1])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::view::Theme;

    #[test]
    fn a_size_that_makes_no_sense_becomes_one_that_does() {
        let drawing = Drawing::new([f64::NAN, -3.0], Theme::Dark.palette().ground);
        assert_eq!([drawing.width, drawing.height], [16.0, 16.0]);
    }
}
