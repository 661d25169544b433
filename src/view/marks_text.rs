//! Drawings as text, for comparing them in tests.

use super::drawing::{Drawing, Form, Spot, Stroke, Text};
use super::palette::Colour;
use std::fmt::Write as _;

impl Drawing {
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

impl Form {
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
            Self::Outline { steps, fill } => {
                let points: Vec<Spot> = steps.iter().flat_map(|step| step.spots()).collect();
                format!("outline {} fill {}", path(&points), hex(*fill))
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

#[cfg(test)]
mod tests {
    use crate::view::sample::two_marks;

    #[test]
    fn the_list_of_marks_reads_as_text() {
        let text = two_marks().to_text();
        assert!(text.starts_with("drawing 100.0 × 80.0 on #ffffff\narea 10.0,10.0 60.0,10.0"), "{text}");
        assert!(text.ends_with("line 0.0,20.0 100.0,20.0 #1c1f24 1.0  event 2\n"), "{text}");
    }
}
