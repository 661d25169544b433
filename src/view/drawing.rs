//! A drawing as a list of marks: pixels, SVG and tests all come from the same list.
//!
//! Coordinates are points, x to the right and y down, from the top left corner.

use super::fonts::{Face, text_width};
use super::palette::Colour;
use crate::record::EventId;
use std::fmt::Write as _;

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
}

impl Drawing {
    /// An empty drawing. Sizes that no screen has are brought into range, so that nothing later divides by zero.
    #[must_use]
    pub fn new(size: [f64; 2], background: Colour) -> Self {
        let [width, height] = size.map(|x| if x.is_finite() { x.clamp(16.0, 16_384.0) } else { 16.0 });
        Self { width, height, background, marks: Vec::new() }
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

    /// The event whose mark lies at `at`, or within `reach` points of it. Lines and points win over areas, nearer ones
    /// over farther ones, and upper ones over lower ones.
    #[must_use]
    pub fn event_at(&self, at: Spot, reach: f64) -> Option<EventId> {
        let mut best: Option<(f64, EventId)> = None;
        for mark in self.marks.iter().rev() {
            let Some(event) = mark.event else { continue };
            let distance = mark.form.distance(at);
            if distance <= reach && best.is_none_or(|(nearest, _)| distance < nearest) {
                best = Some((distance, event));
            }
        }
        best.map(|(_, event)| event)
    }

    /// All texts.
    pub fn texts(&self) -> impl Iterator<Item = &Text> {
        self.marks.iter().filter_map(|mark| match &mark.form {
            Form::Text(text) => Some(text),
            _ => None,
        })
    }

    /// The list of marks as text, rounded to a tenth of a point, for comparing drawings.
    #[must_use]
    pub fn to_text(&self) -> String {
        let mut text = format!("drawing {} × {} on {}\n", tenth(self.width), tenth(self.height), hex(self.background));
        for mark in &self.marks {
            text.push_str(&mark.form.to_text());
            if let Some(event) = mark.event {
                let _ = write!(text, "  event {event}");
            }
            text.push('\n');
        }
        text
    }
}

/// An area counts as this far away, so that what is drawn on it is found first.
const AREA_DISTANCE: f64 = 1e-3;

impl Form {
    /// How far away `at` is.
    fn distance(&self, at: Spot) -> f64 {
        match self {
            Self::Line { points, .. } => {
                points.windows(2).map(|ends| distance_to_line(at, ends[0], ends[1])).fold(f64::INFINITY, f64::min)
            }
            Self::Area { rings, .. } => {
                if is_within(rings, at) {
                    AREA_DISTANCE
                } else {
                    f64::INFINITY
                }
            }
            Self::Circle { centre, radius, fill, .. } => {
                let distance = length([at[0] - centre[0], at[1] - centre[1]]) - radius;
                if fill.is_some() { distance.max(0.0) } else { distance.abs() }
            }
            Self::Arc { centre, radius, .. } => (length([at[0] - centre[0], at[1] - centre[1]]) - radius).abs(),
            Self::Arrow { from, to, .. } => distance_to_line(at, *from, *to),
            Self::Rect { frame, .. } => {
                if frame.contains(at) {
                    AREA_DISTANCE
                } else {
                    f64::INFINITY
                }
            }
            Self::Text(text) => {
                if text.frame().contains(at) {
                    0.0
                } else {
                    f64::INFINITY
                }
            }
        }
    }

    fn to_text(&self) -> String {
        match self {
            Self::Line { points, stroke } => format!("line {} {}", path(points), stroke_text(stroke)),
            Self::Area { rings, fill } => {
                let rings: Vec<_> = rings.iter().map(|ring| path(ring)).collect();
                format!("area {} fill {}", rings.join(" and "), hex(*fill))
            }
            Self::Circle { centre, radius, fill, stroke } => {
                format!("circle {} r {}{}", spot(*centre), tenth(*radius), paint_text(*fill, *stroke))
            }
            Self::Arc { centre, radius, angles: [from, to], stroke } => {
                let [from, to] = [from.to_degrees(), to.to_degrees()].map(tenth);
                format!("arc {} r {} {from}°…{to}° {}", spot(*centre), tenth(*radius), stroke_text(stroke))
            }
            Self::Arrow { from, to, stroke, .. } => {
                format!("arrow {} → {} {}", spot(*from), spot(*to), stroke_text(stroke))
            }
            Self::Rect { frame, fill, stroke } => {
                format!("rect {} … {}{}", spot(frame.low), spot(frame.high), paint_text(*fill, *stroke))
            }
            Self::Text(Text { at, text, anchor, size, colour, face, .. }) => {
                let anchor = ["start", "middle", "end"][*anchor as usize];
                let face = ["", " bold", " mono"][*face as usize];
                format!("text {} {anchor} {}{face} {} “{text}”", spot(*at), tenth(*size), hex(*colour))
            }
        }
    }
}

/// One decimal, without a negative zero.
fn tenth(x: f64) -> String {
    let text = format!("{x:.1}");
    if text == "-0.0" { "0.0".to_owned() } else { text }
}

fn spot(at: Spot) -> String {
    format!("{},{}", tenth(at[0]), tenth(at[1]))
}

/// Long paths are cut: their ends and number of points tell one from another.
fn path(points: &[Spot]) -> String {
    const SHOWN: usize = 6;
    let shown: Vec<_> = points.iter().take(SHOWN).map(|&at| spot(at)).collect();
    let more = points.len().saturating_sub(SHOWN);
    match (more, points.last()) {
        (1.., Some(&last)) => format!("{} … {} ({} points)", shown.join(" "), spot(last), points.len()),
        _ => shown.join(" "),
    }
}

fn hex(colour: Colour) -> String {
    let Colour { r, g, b, a } = colour;
    if a == 255 { format!("#{r:02x}{g:02x}{b:02x}") } else { format!("#{r:02x}{g:02x}{b:02x}{a:02x}") }
}

fn stroke_text(stroke: &Stroke) -> String {
    let dash = if stroke.dash.is_some() { " dashed" } else { "" };
    format!("{} {}{dash}", hex(stroke.colour), tenth(stroke.width))
}

fn paint_text(fill: Option<Colour>, stroke: Option<Stroke>) -> String {
    let fill = fill.map(|fill| format!(" fill {}", hex(fill))).unwrap_or_default();
    let stroke = stroke.map(|stroke| format!(" rim {}", stroke_text(&stroke))).unwrap_or_default();
    fill + &stroke
}

/// The length of a vector.
pub(super) fn length(v: Spot) -> f64 {
    v[0].hypot(v[1])
}

fn distance_to_line(at: Spot, from: Spot, to: Spot) -> f64 {
    let along = [to[0] - from[0], to[1] - from[1]];
    let squared = along[0] * along[0] + along[1] * along[1];
    let offset = [at[0] - from[0], at[1] - from[1]];
    let share =
        if squared > 0.0 { ((offset[0] * along[0] + offset[1] * along[1]) / squared).clamp(0.0, 1.0) } else { 0.0 };
    length([offset[0] - share * along[0], offset[1] - share * along[1]])
}

fn is_within(rings: &[Vec<Spot>], at: Spot) -> bool {
    let mut inside = false;
    for ring in rings {
        for (i, &a) in ring.iter().enumerate() {
            let b = ring[(i + 1) % ring.len()];
            let crosses = (a[1] > at[1]) != (b[1] > at[1]);
            if crosses && at[0] < a[0] + (at[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]) {
                inside = !inside;
            }
        }
    }
    inside
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::view::Theme;

    fn drawing() -> Drawing {
        let palette = Theme::Light.palette();
        let mut drawing = Drawing::new([100.0, 80.0], palette.ground);
        let square = |low: f64, high: f64| vec![[low, low], [high, low], [high, high], [low, high]];
        drawing.put(Form::Area { rings: vec![square(10.0, 60.0), square(30.0, 40.0)], fill: palette.left }, 1);
        drawing
            .put(Form::Line { points: vec![[0.0, 20.0], [100.0, 20.0]], stroke: Stroke::solid(palette.ink, 1.0) }, 2);
        drawing
    }

    #[test]
    fn a_line_on_an_area_is_found_first_and_a_hole_is_not_the_area() {
        let drawing = drawing();
        assert_eq!(drawing.event_at([15.0, 50.0], 3.0), Some(1));
        assert_eq!(drawing.event_at([15.0, 20.0], 3.0), Some(2));
        assert_eq!(drawing.event_at([80.0, 22.0], 3.0), Some(2));
        assert_eq!(drawing.event_at([35.0, 35.0], 3.0), None);
        assert_eq!(drawing.event_at([80.0, 70.0], 3.0), None);
    }

    #[test]
    fn the_list_of_marks_reads_as_text() {
        let text = drawing().to_text();
        assert!(text.starts_with("drawing 100.0 × 80.0 on #ffffff\narea 10.0,10.0 60.0,10.0"), "{text}");
        assert!(text.ends_with("line 0.0,20.0 100.0,20.0 #1c1f24 1.0  event 2\n"), "{text}");
    }

    #[test]
    fn a_size_that_makes_no_sense_becomes_one_that_does() {
        let drawing = Drawing::new([f64::NAN, -3.0], Theme::Dark.palette().ground);
        assert_eq!([drawing.width, drawing.height], [16.0, 16.0]);
    }
}
