//! What every drawing has to keep, for tests.

use super::drawing::{Drawing, Form, Frame, Spot, Stroke, Text};
use super::labels::clip;
use super::outline::frame_of;
use super::sheet::bounds;

/// The box of a mark.
pub fn extent(form: &Form) -> Frame {
    let around = |points: &[Spot]| {
        let [low, high] = bounds(points.iter().copied()).expect("a mark has a place");
        Frame { low, high }
    };
    match form {
        Form::Line { points, .. } => around(points),
        Form::Area { rings, .. } => around(&rings.concat()),
        Form::Circle { centre, radius, .. } | Form::Arc { centre, radius, .. } => around(&[*centre]).grown(*radius),
        Form::Arrow { from, to, .. } => around(&[*from, *to]),
        Form::Rect { frame, .. } => *frame,
        Form::Text(text) => text.frame(),
        Form::Outline { steps, .. } => frame_of(steps).expect("a mark has a place"),
    }
}

/// What runs through the letters of a text: a line above it, or one below it that no halo sets it off from.
fn strikes(form: &Form, letters: &Frame) -> bool {
    let is_seen = |stroke: &Stroke| stroke.width >= 0.9 && stroke.colour.a > 100;
    let crossed = |points: &[Spot]| points.windows(2).any(|ends| clip(letters, [ends[0], ends[1]]).is_some());
    match form {
        Form::Line { points, stroke } => is_seen(stroke) && crossed(points),
        Form::Arrow { from, to, stroke, .. } => is_seen(stroke) && crossed(&[*from, *to]),
        Form::Arc { centre, radius, angles: [from, to], stroke } => {
            let at = |i: u32| from + (to - from) * f64::from(i) / 24.0;
            let points: Vec<Spot> =
                (0..=24).map(|i| [centre[0] + radius * at(i).cos(), centre[1] + radius * at(i).sin()]).collect();
            is_seen(stroke) && crossed(&points)
        }
        _ => false,
    }
}

/// The part of a text's box that its letters fill, without what only some of them have above and below.
fn letters(text: &Text) -> Frame {
    let Frame { low, high } = text.frame();
    let aside = 0.28 * (high[1] - low[1]);
    Frame { low: [low[0] + 1.0, low[1] + aside], high: [high[0] - 1.0, high[1] - aside] }
}

/// Whether every mark lies on the canvas, no text covers another, and no line runs through one.
pub fn assert_readable(drawing: &Drawing, what: &str) {
    let canvas = drawing.frame().grown(0.01);
    for mark in &drawing.marks {
        assert!(canvas.holds(&extent(&mark.form)), "{what}: {:?} is cut off", mark.form);
    }
    for (i, mark) in drawing.marks.iter().enumerate() {
        let Form::Text(text) = &mark.form else { continue };
        let below = if text.halo.is_some() { &[] } else { &drawing.marks[..i] };
        for other in drawing.marks[i + 1..].iter().chain(below) {
            assert!(!strikes(&other.form, &letters(text)), "{what}: “{}” is struck by {:?}", text.text, other.form);
        }
    }
    let texts: Vec<&Text> = drawing.texts().collect();
    for (i, text) in texts.iter().enumerate() {
        for other in &texts[..i] {
            assert!(!text.frame().overlaps(&other.frame()), "{what}: “{}” covers “{}”", text.text, other.text);
        }
    }
}
