//! From LaTeX to letters and rules with their places.

use super::letters::measures_of;
use super::{FormulaError, Letter, Part};
use crate::view::drawing::{Frame, Spot};
use crate::view::outline::Pen;
use ratex_layout::{LayoutOptions, layout_with_fallback_metrics, to_display_list, validate_layout};
use ratex_parser::{ParseNode, Parser};
use ratex_types::{Color, DisplayItem, MathStyle, PathCommand};
use std::sync::Arc;

/// Longer texts are no formulas; without a bound, one that was pasted by mistake would be laid out for minutes.
const MOST_BYTES: usize = 8_000;

/// A formula that is larger, in em, was not meant: `\rule{9999em}{1em}` would take all memory as pixels.
const LARGEST: f64 = 400.0;

impl FormulaError {
    fn of_all(message: impl Into<String>) -> Self {
        Self { message: message.into(), at: None }
    }
}

/// The formula's parts as its author wrote them.
pub fn parsed(latex: &str) -> Result<Vec<ParseNode>, FormulaError> {
    if latex.len() > MOST_BYTES {
        return Err(FormulaError::of_all(format!("a formula has {MOST_BYTES} bytes at most")));
    }
    // The dot that keyboards have is no sign of a product to TeX, and would be set too close.
    let dotted = latex.replace('·', "⋅");
    let nodes = Parser::new(&dotted).parse().map_err(|error| {
        let at = error.loc.map(|place| original(latex, &dotted, place.start));
        FormulaError { message: plain(&error.message), at }
    })?;
    if nodes.is_empty() { Err(FormulaError::of_all("the formula is empty")) } else { Ok(nodes) }
}

/// Where the character of `latex` begins that stands at that byte of `dotted`: the two have the same number of characters.
fn original(latex: &str, dotted: &str, at: usize) -> usize {
    let before = dotted[..dotted.floor_char_boundary(at.min(dotted.len()))].chars().count();
    latex.chars().take(before).map(char::len_utf8).sum()
}

/// The parser's message as the program's own messages begin.
fn plain(message: &str) -> String {
    if let Some(command) = message.strip_prefix("Undefined control sequence: ") {
        return format!("there is no command {command}");
    }
    let mut letters = message.chars();
    letters.next().map(|first| first.to_lowercase().chain(letters).collect()).unwrap_or_default()
}

/// Letters and rules with their places, and width, height and depth of all.
pub fn parts(latex: &str, nodes: &[ParseNode], display: bool) -> Result<(Vec<Part>, [f64; 3]), FormulaError> {
    let style = if display { MathStyle::Display } else { MathStyle::Text };
    let options = LayoutOptions { style, ..LayoutOptions::default() };
    let boxes = layout_with_fallback_metrics(nodes, &options, Arc::new(measures_of(latex).collect()));
    validate_layout(&boxes).map_err(FormulaError::of_all)?;
    let list = to_display_list(&boxes);
    let size = [list.width, list.height, list.depth];
    if !size.iter().all(|length| length.abs() <= LARGEST) {
        return Err(FormulaError::of_all("the formula is too large"));
    }
    let baseline = list.height;
    let mut parts = Vec::with_capacity(list.items.len());
    for item in &list.items {
        parts.extend(parts_of(item, baseline)?);
    }
    let is_near = |spot: Spot| spot.iter().all(|x| x.abs() <= LARGEST);
    if parts.iter().flat_map(Part::outline).flat_map(Pen::spots).all(is_near) {
        Ok((parts, size))
    } else {
        Err(FormulaError::of_all("a part of the formula lies too far away"))
    }
}

fn parts_of(item: &DisplayItem, baseline: f64) -> Result<Vec<Part>, FormulaError> {
    match item {
        DisplayItem::GlyphPath { x, y, scale, font, char_code, color } => {
            plain_colour(*color)?;
            let letter = Letter::find(font, *char_code).map_err(FormulaError::of_all)?;
            Ok(vec![Part::Letter { letter, at: [*x, y - baseline], size: *scale }])
        }
        DisplayItem::Line { x, y, width, thickness, color, dashed: false } => {
            plain_colour(*color)?;
            let y = y - baseline;
            Ok(vec![Part::Rule(Frame { low: [*x, y - thickness / 2.0], high: [x + width, y + thickness / 2.0] })])
        }
        DisplayItem::Rect { x, y, width, height, color } => {
            plain_colour(*color)?;
            let y = y - baseline;
            Ok(vec![Part::Rule(Frame { low: [*x, y], high: [x + width, y + height] })])
        }
        DisplayItem::Path { x, y, commands, fill: true, color } => {
            plain_colour(*color)?;
            let steps: Vec<Pen> = commands.iter().map(|command| step(*command, [*x, y - baseline])).collect();
            // Each contour by itself: where two that run in opposite directions overlap, winding would leave a hole.
            let contours = steps.chunk_by(|_, next| !matches!(next, Pen::Move(_)));
            Ok(contours.map(|contour| Part::Area(contour.to_vec())).collect())
        }
        DisplayItem::Line { .. } | DisplayItem::Path { .. } => {
            Err(FormulaError::of_all("dashed lines, lines through letters and rings round them cannot be drawn"))
        }
    }
}

/// A formula has the colour of the text around it, on any ground.
fn plain_colour(colour: Color) -> Result<(), FormulaError> {
    if colour == Color::BLACK {
        Ok(())
    } else {
        Err(FormulaError::of_all("a part of a formula has no colour of its own: it has that of the text around it"))
    }
}

fn step(command: PathCommand, [x0, y0]: Spot) -> Pen {
    let at = |x: f64, y: f64| [x0 + x, y0 + y];
    match command {
        PathCommand::MoveTo { x, y } => Pen::Move(at(x, y)),
        PathCommand::LineTo { x, y } => Pen::Line(at(x, y)),
        PathCommand::QuadTo { x1, y1, x, y } => Pen::Quad(at(x1, y1), at(x, y)),
        PathCommand::CubicTo { x1, y1, x2, y2, x, y } => Pen::Cubic(at(x1, y1), at(x2, y2), at(x, y)),
        PathCommand::Close => Pen::Close,
    }
}
