//! Formulas as SVG within a line of text: in the text's own colour, on its baseline, and with words for whoever hears it.

use super::{Formula, Letter, Part};
use crate::view::outline::{Pen, rectangle};
use crate::view::svg::{escaped, outline};
use std::collections::BTreeSet;
use std::fmt::Write as _;

/// The letters that the formulas of a page have in common: each is written once, and shown wherever it stands.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct SharedLetters {
    used: BTreeSet<Letter>,
}

impl SharedLetters {
    /// What the page has to hold besides its formulas: an element that shows nothing by itself.
    #[must_use]
    pub fn definitions(&self) -> String {
        if self.used.is_empty() {
            return String::new();
        }
        let mut out =
            "<svg width=\"0\" height=\"0\" style=\"position:absolute\" aria-hidden=\"true\"><defs>".to_owned();
        for letter in &self.used {
            let _ = write!(out, "<path id=\"{}\" d=\"{}\"/>", letter.name(), path(&letter.outline()));
        }
        out.push_str("</defs></svg>");
        out
    }
}

impl Formula {
    /// An `svg` element that holds everything it needs.
    #[must_use]
    pub fn svg(&self) -> String {
        self.element(|letter| {
            let outline = letter.outline();
            (!outline.is_empty()).then(|| format!("<path d=\"{}\"", path(&outline)))
        })
    }

    /// An `svg` element for a page that holds the letters too.
    #[must_use]
    pub fn svg_sharing(&self, letters: &mut SharedLetters) -> String {
        self.element(|letter| {
            let has_ink = !letter.outline().is_empty();
            has_ink.then(|| {
                letters.used.insert(letter);
                format!("<use href=\"#{}\"", letter.name())
            })
        })
    }

    fn element(&self, mut shape: impl FnMut(Letter) -> Option<String>) -> String {
        let [width, height, depth] = [self.width, self.height, self.depth];
        let mut out = format!(
            "<svg class=\"formula\" role=\"img\" aria-label=\"{}\" width=\"{}em\" height=\"{}em\" \
             viewBox=\"0 {} {} {}\" style=\"vertical-align:{}em\" fill=\"currentColor\">",
            escaped(&self.words),
            em(width),
            em(height + depth),
            units(-height),
            units(width),
            units(height + depth),
            em(-depth),
        );
        for part in &self.parts {
            match part {
                Part::Letter { letter, at: [x, y], size } => {
                    if let Some(shape) = shape(*letter) {
                        let (x, y, size) = (units(*x), units(*y), em(*size));
                        let _ = write!(out, "{shape} transform=\"translate({x} {y})scale({size} -{size})\"/>");
                    }
                }
                Part::Rule(frame) => out.push_str(&area(&rectangle(*frame))),
                Part::Area(steps) => out.push_str(&area(steps)),
            }
        }
        out.push_str("</svg>");
        out
    }
}

fn area(steps: &[Pen]) -> String {
    let steps: Vec<Pen> = steps.iter().map(|step| step.moved(|spot| spot.map(|x| x * 1000.0))).collect();
    format!("<path d=\"{}\"/>", path(&steps))
}

/// Four decimals of an em: less than a hundredth of a pixel in any text.
fn em(x: f64) -> String {
    trimmed(&format!("{x:.4}"))
}

/// Thousandths of an em, to a tenth.
fn units(x: f64) -> String {
    tenth(x * 1000.0)
}

fn tenth(x: f64) -> String {
    trimmed(&format!("{x:.1}"))
}

fn trimmed(text: &str) -> String {
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

fn path(steps: &[Pen]) -> String {
    outline(steps, tenth)
}
