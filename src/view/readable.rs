//! What every drawing has to keep, for tests.

use super::drawing::{Drawing, Form, Frame, Spot, Text};
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

/// Whether every mark lies on the canvas and no text covers another.
pub fn assert_readable(drawing: &Drawing, what: &str) {
    let canvas = drawing.frame().grown(0.01);
    for mark in &drawing.marks {
        assert!(canvas.holds(&extent(&mark.form)), "{what}: {:?} is cut off", mark.form);
    }
    let texts: Vec<&Text> = drawing.texts().collect();
    for (i, text) in texts.iter().enumerate() {
        for other in &texts[..i] {
            assert!(!text.frame().overlaps(&other.frame()), "{what}: “{}” covers “{}”", text.text, other.text);
        }
    }
}
