//! Looks that are told apart without their colours: each component has a pattern of its own.

use crate::view::drawing::{Form, Frame, Stroke};
use crate::view::palette::{Colour, Palette};
use crate::view::sheet::Sheet;

/// The lines of a pattern.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Pattern {
    Plain,
    Rising,
    Falling,
    Upright,
    Level,
}

/// A colour with a pattern.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Look {
    pub colour: Colour,
    pub pattern: Pattern,
}

/// Between lines of a pattern, in points.
const PITCH: f64 = 6.0;

impl Look {
    /// Of ambient, diffuse, specular, reflected and transmitted light.
    pub fn all(palette: &Palette) -> [Self; 5] {
        let look = |colour, pattern| Self { colour, pattern };
        [
            look(palette.extent, Pattern::Plain),
            look(palette.categories[0], Pattern::Rising),
            look(palette.categories[1], Pattern::Upright),
            look(palette.reflected, Pattern::Falling),
            look(palette.refracted, Pattern::Level),
        ]
    }
}

/// Fills a frame with a look.
pub(super) fn hatched(sheet: &mut Sheet, frame: Frame, look: Look) {
    let rim = Some(Stroke::solid(sheet.palette.ground, 0.8));
    sheet.drawing.put(Form::Rect { frame, fill: Some(look.colour), stroke: rim }, sheet.event);
    let stroke = Stroke::solid(sheet.palette.ground.faded(0.8), 1.1);
    let ([left, top], [right, bottom]) = (frame.low, frame.high);
    let [width, height] = frame.size();
    let count = |length: f64| (1..).map(move |i| PITCH * f64::from(i)).take_while(move |at| *at < length);
    match look.pattern {
        Pattern::Plain => {}
        Pattern::Upright => {
            for x in count(width) {
                sheet.line(&frame, &[[left + x, top], [left + x, bottom]], stroke);
            }
        }
        Pattern::Level => {
            for y in count(height).map(|y| y - 2.0) {
                sheet.line(&frame, &[[left, top + y], [right, top + y]], stroke);
            }
        }
        Pattern::Rising => {
            for x in count(width + height) {
                sheet.line(&frame, &[[left + x, top], [left + x - height, bottom]], stroke);
            }
        }
        Pattern::Falling => {
            for x in count(width + height) {
                sheet.line(&frame, &[[left + x - height, top], [left + x, bottom]], stroke);
            }
        }
    }
}
