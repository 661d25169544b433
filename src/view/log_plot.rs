//! Curves over a logarithmic axis, in panels above each other, each curve with its name at its end.

use super::axis::Axis;
use super::drawing::{Anchor, Drawing, Form, Frame, Spot, Stroke};
use super::fonts::Face;
use super::labels::Label;
use super::palette::{Colour, Theme};
use super::text::brief;
use crate::math::portable;
use std::fmt::Write as _;

/// What is to be plotted.
#[derive(Clone, Debug, PartialEq)]
pub struct LogPlot {
    /// One line.
    pub title: String,
    /// A line or two of explanation.
    pub notes: Vec<String>,
    /// The name of the x axis with its unit.
    pub x_name: String,
    /// The ends of the x axis: the powers of ten on the left and on the right, in either order.
    pub x_powers: [i32; 2],
    /// From top to bottom.
    pub panels: Vec<Panel>,
}

/// One panel.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// The name of its y axis with its unit.
    pub y_name: String,
    /// How y is brought onto paper.
    pub scale: Scale,
    /// The curves.
    pub curves: Vec<Curve>,
}

/// How y is brought onto paper.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// By its logarithm, from one power of ten to another; what lies beyond is drawn at the end.
    Log(i32, i32),
    /// As a share, from 0 to 1.
    Share,
}

/// A named curve: (x, y) with gaps where y is NaN.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// Its name.
    pub name: String,
    /// Which colour it has, counted from 0.
    pub colour: usize,
    /// Its points, in order.
    pub points: Vec<Spot>,
}

/// Sizes in points.
const TITLE: f64 = 14.0;
const TEXT: f64 = 11.5;
const SMALL: f64 = 10.5;
const MARGIN: f64 = 14.0;
const LINE: f64 = 15.0;
/// Room for the numbers at the left and for the curves' names at the right.
const LEFT: f64 = 58.0;
const RIGHT: f64 = 104.0;
/// Room between panels, and below the last one.
const BETWEEN: f64 = 34.0;
const BELOW: f64 = 46.0;
/// The upper panel is this much higher than the others.
const FIRST: f64 = 1.7;

/// Draws the plot.
#[must_use]
pub fn log_plot(plot: &LogPlot, size: [f64; 2], theme: Theme) -> Drawing {
    let palette = theme.palette();
    let mut drawing = Drawing::new(size, palette.ground);
    let mut y = MARGIN + 4.0;
    let title = Label::new(&plot.title, TITLE, palette.ink).face(Face::Bold);
    drawing.put(Form::Text(title.at([MARGIN, y], Anchor::Start, None)), None);
    y += LINE + 4.0;
    for note in &plot.notes {
        let label = Label::new(note, TEXT, palette.faint);
        drawing.put(Form::Text(label.at([MARGIN, y], Anchor::Start, None)), None);
        y += LINE;
    }
    let top = y + 16.0;
    let gaps = BETWEEN * (plot.panels.len().saturating_sub(1)) as f64;
    let unit = (drawing.height - BELOW - top - gaps) / (FIRST + plot.panels.len().saturating_sub(1) as f64);
    let [left, right] = plot.x_powers.map(f64::from);
    let x = Axis { values: [left, right], points: [MARGIN + LEFT, drawing.width - MARGIN - RIGHT] };
    let mut low = top;
    for (k, panel) in plot.panels.iter().enumerate() {
        let high = low + if k == 0 { FIRST * unit } else { unit };
        let y = match panel.scale {
            Scale::Log(from, to) => Axis { values: [from, to].map(f64::from), points: [high, low] },
            Scale::Share => Axis { values: [0.0, 1.0], points: [high, low] },
        };
        let mut painter = Painter { drawing: &mut drawing, theme, x, y, panel };
        painter.grid(plot, k + 1 == plot.panels.len());
        painter.curves();
        low = high + BETWEEN;
    }
    drawing.description = description(plot);
    drawing
}

/// The plot in words: of each curve where it begins and ends, and its largest value.
fn description(plot: &LogPlot) -> String {
    let mut text = format!("{}. {} The x axis is {}.", plot.title, plot.notes.join(" "), plot.x_name);
    for panel in &plot.panels {
        let _ = write!(text, " {}:", panel.y_name);
        for curve in &panel.curves {
            let known: Vec<&Spot> = curve.points.iter().filter(|[_, y]| y.is_finite()).collect();
            let Some((first, last)) = known.first().zip(known.last()) else { continue };
            let most = known.iter().map(|[_, y]| *y).fold(f64::NEG_INFINITY, f64::max);
            let [from, to, most] = [first[1], last[1], most].map(brief);
            let _ = write!(text, " {} goes from {from} to {to}, at most {most};", curve.name);
        }
    }
    text
}

struct Painter<'a> {
    drawing: &'a mut Drawing,
    theme: Theme,
    x: Axis,
    y: Axis,
    panel: &'a Panel,
}

impl Painter<'_> {
    fn text(&mut self, text: &str, at: Spot, anchor: Anchor, colour: Colour) {
        let label = Label::new(text, SMALL, colour);
        self.drawing.put(Form::Text(label.at(at, anchor, None)), None);
    }

    fn line(&mut self, points: Vec<Spot>, stroke: Stroke) {
        self.drawing.put(Form::Line { points, stroke }, None);
    }

    fn grid(&mut self, plot: &LogPlot, last: bool) {
        let palette = self.theme.palette();
        let fine = Stroke::solid(palette.grid.faded(0.7), 0.8);
        let ([left, right], [bottom, top]) = (self.x.points, self.y.points);
        let (from, to) = (plot.x_powers[0].min(plot.x_powers[1]), plot.x_powers[0].max(plot.x_powers[1]));
        for power in from..=to {
            let x = self.x.at(f64::from(power));
            self.line(vec![[x, top], [x, bottom]], fine);
            if last && (to - from <= 9 || (power - from) % 2 == 0) {
                self.text(&power_of_ten(power), [x, bottom + 12.0], Anchor::Middle, palette.faint);
            }
        }
        for (value, name) in self.ticks() {
            let y = self.y.at(value);
            self.line(vec![[left, y], [right, y]], fine);
            self.text(&name, [left - 6.0, y], Anchor::End, palette.faint);
        }
        let frame = Frame { low: [left, top], high: [right, bottom] };
        self.drawing.put(Form::Rect { frame, fill: None, stroke: Some(Stroke::solid(palette.faint, 1.0)) }, None);
        let name = Label::new(&self.panel.y_name, TEXT, palette.ink);
        self.drawing.put(Form::Text(name.at([left, top - 12.0], Anchor::Start, None)), None);
        if last {
            let name = Label::new(&plot.x_name, TEXT, palette.ink);
            let middle = f64::midpoint(left, right);
            self.drawing.put(Form::Text(name.at([middle, bottom + 31.0], Anchor::Middle, None)), None);
        }
    }

    /// Values on the axis, and how they read.
    fn ticks(&self) -> Vec<(f64, String)> {
        match self.panel.scale {
            Scale::Log(from, to) => {
                // As many as have room above each other.
                let room = (self.y.points[0] - self.y.points[1]) / 18.0;
                let step = (1..=10).find(|step| f64::from((to - from) / step) <= room).unwrap_or(10);
                (from..=to).filter(|power| power % step == 0).map(|k| (f64::from(k), power_of_ten(k))).collect()
            }
            Scale::Share => [0_u8, 25, 50, 75, 100].map(|k| (f64::from(k) / 100.0, format!("{k} %"))).to_vec(),
        }
    }

    fn at(&self, [x, y]: Spot) -> Spot {
        let y = match self.panel.scale {
            Scale::Log(from, to) => portable::log10(y).max(f64::from(from)).min(f64::from(to)),
            Scale::Share => y,
        };
        [self.x.at(portable::log10(x)), self.y.at(y)]
    }

    fn curves(&mut self) {
        let palette = self.theme.palette();
        let colours = [palette.faint, palette.shadow, palette.refracted, palette.camera, palette.bad];
        let dashes = [None, Some([5.0, 3.0]), None, Some([1.5, 3.0]), None];
        let mut ends = Vec::new();
        // Broken lines last, so that they are seen on top of unbroken ones that go the same way.
        let (broken, whole): (Vec<_>, Vec<_>) =
            self.panel.curves.iter().partition(|curve| dashes[curve.colour % dashes.len()].is_some());
        for curve in whole.into_iter().chain(broken) {
            let k = curve.colour % colours.len();
            let (colour, dash) = (colours[k], dashes[k]);
            let pieces = curve.points.split(|[_, y]| y.is_nan());
            for piece in pieces.filter(|piece| !piece.is_empty()) {
                let points: Vec<Spot> = piece.iter().map(|&point| self.at(point)).collect();
                let end = points[points.len() - 1];
                if points.len() > 1 {
                    self.line(points, Stroke { colour, width: 2.0, dash });
                } else {
                    self.drawing.put(Form::Circle { centre: end, radius: 2.0, fill: Some(colour), stroke: None }, None);
                }
            }
            let last = curve.points.iter().rev().find(|[_, y]| !y.is_nan());
            if let Some(&last) = last {
                ends.push((self.at(last), curve.name.as_str(), colour));
            }
        }
        self.names(ends);
    }

    /// The names at the curves' ends, moved apart where they would cover each other.
    fn names(&mut self, mut ends: Vec<(Spot, &str, Colour)>) {
        ends.sort_by(|a, b| a.0[1].total_cmp(&b.0[1]));
        let [bottom, top] = self.y.points;
        let mut heights: Vec<f64> = ends.iter().map(|(end, _, _)| end[1]).collect();
        let gap = SMALL + 3.0;
        let room = heights.len().saturating_sub(1) as f64;
        for k in 0..heights.len() {
            let least = if k == 0 { top } else { heights[k - 1] + gap };
            heights[k] = heights[k].max(least);
        }
        for k in (0..heights.len()).rev() {
            let below = room - k as f64;
            heights[k] = heights[k].min(bottom - gap * below);
        }
        let right = self.x.points[1];
        for ((end, name, colour), height) in ends.into_iter().zip(heights) {
            let stroke = Stroke::solid(colour.faded(0.6), 0.8);
            self.line(vec![end, [right + 6.0, end[1]], [right + 14.0, height]], stroke);
            self.text(name, [right + 17.0, height], Anchor::Start, colour);
        }
    }
}

/// 10⁻³ and the like; 1 and 10 as they are.
pub(super) fn power_of_ten(power: i32) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    match power {
        0 => "1".to_owned(),
        1 => "10".to_owned(),
        _ => {
            let sign = if power < 0 { "⁻" } else { "" };
            let digits = power.unsigned_abs().to_string();
            let digits = digits.chars().filter_map(|digit| digit.to_digit(10)).map(|digit| DIGITS[digit as usize]);
            format!("10{sign}{}", digits.collect::<String>())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::view::{Text, Theme, png};

    fn sample() -> LogPlot {
        let curve = |name: &str, colour, y: f64| Curve {
            name: name.to_owned(),
            colour,
            points: (0..5).map(|k| [10.0_f64.powi(k), if k == 2 { f64::NAN } else { y }]).collect(),
        };
        let names = ["f32", "f64", "adaptive", "double-double", "textbook"];
        let curves = |y| (0..).zip(names).map(|(k, name)| curve(name, k, y)).collect();
        LogPlot {
            title: "Title".to_owned(),
            notes: vec!["Note".to_owned()],
            x_name: "x".to_owned(),
            x_powers: [0, 4],
            panels: vec![
                Panel { y_name: "above".to_owned(), scale: Scale::Log(-1, 9), curves: curves(1e3) },
                Panel { y_name: "below".to_owned(), scale: Scale::Share, curves: curves(0.0) },
            ],
        }
    }

    #[test]
    fn names_at_the_ends_of_equal_curves_do_not_cover_each_other_and_stay_within() {
        let drawing = log_plot(&sample(), [720.0, 520.0], Theme::Light);
        let frames: Vec<Frame> = drawing.texts().map(Text::frame).collect();
        for (k, frame) in frames.iter().enumerate() {
            assert!(drawing.frame().holds(frame), "{:?}", drawing.texts().nth(k));
            assert!(frames[..k].iter().all(|other| !other.overlaps(frame)), "{:?}", drawing.texts().nth(k));
        }
        assert!(!png(&drawing, 1.0).is_empty());
    }

    #[test]
    fn a_curve_has_a_gap_where_nothing_is_known() {
        let drawing = log_plot(&sample(), [720.0, 520.0], Theme::Dark);
        let thick =
            |form: &Form| matches!(form, Form::Line { points, stroke } if stroke.width == 2.0 && points.len() == 2);
        // Five curves in two panels, each in two pieces of two points.
        assert_eq!(drawing.marks.iter().filter(|mark| thick(&mark.form)).count(), 20);
    }

    #[test]
    fn powers_of_ten_are_written_as_people_write_them() {
        assert_eq!([-16, -1, 0, 1, 8].map(power_of_ten), ["10⁻¹⁶", "10⁻¹", "1", "10", "10⁸"]);
    }
}
