//! Words and formulas in lines.

use super::flow::Look;
use crate::lesson::Told;
use crate::lesson::prose::{Inline, Target, code, latex};
use crate::view::{Face, Formula, text_width};

/// Letters of formulas are smaller for their size than those of the text.
pub const FORMULA: f64 = 1.13;

/// A part of a line.
#[derive(Clone, Debug)]
pub enum Piece {
    /// A word, with the space behind it where one follows.
    Word {
        /// The word.
        text: String,
        /// Its face.
        face: Face,
    },
    /// A formula.
    Formula(Formula),
    /// The end of a line that was asked for.
    End,
}

/// Pieces that stay on one line.
pub type Glued = Vec<Piece>;

impl Piece {
    /// Its width in a text of that size.
    pub fn width(&self, size: f64) -> f64 {
        match self {
            Self::Word { text, face } => text_width(text, size, *face),
            Self::Formula(formula) => formula.width * size * FORMULA,
            Self::End => 0.0,
        }
    }

    /// How far it rises above the line.
    pub fn height(&self, size: f64) -> f64 {
        if let Self::Formula(formula) = self { formula.height * size * FORMULA } else { 0.0 }
    }

    /// How far it goes below the line.
    pub fn depth(&self, size: f64) -> f64 {
        if let Self::Formula(formula) = self { formula.depth * size * FORMULA } else { 0.0 }
    }
}

/// The words of a text.
pub fn glued_words(text: &str, look: Look) -> Vec<Glued> {
    let mut setter = Setter::default();
    setter.text(text, look.face);
    setter.finished()
}

/// A line of a lesson.
pub fn glued(line: &[Inline<Told>], look: Look) -> Vec<Glued> {
    let mut setter = Setter::default();
    setter.line(line, look.face);
    setter.finished()
}

/// Lines no wider than that in a text of that size; what is wider by itself stands alone.
pub fn in_lines(glued: Vec<Glued>, width: f64, size: f64) -> Vec<Vec<Piece>> {
    let mut lines: Vec<Vec<Piece>> = vec![Vec::new()];
    let mut used = 0.0;
    for pieces in glued {
        let wide: f64 = pieces.iter().map(|piece| piece.width(size)).sum();
        // The space behind the last word of a line may stand out.
        if used > 0.0 && used + wide - text_width(" ", size, Face::Sans) > width {
            lines.push(Vec::new());
            used = 0.0;
        }
        used += wide;
        let ends = pieces.iter().any(|piece| matches!(piece, Piece::End));
        if let Some(last) = lines.last_mut() {
            last.extend(pieces);
        }
        if ends {
            lines.push(Vec::new());
            used = 0.0;
        }
    }
    lines.retain(|line| !line.is_empty());
    lines
}

/// Takes words and formulas one after the other, and glues together what no space is between.
#[derive(Default)]
struct Setter {
    done: Vec<Glued>,
    open: Glued,
}

impl Setter {
    fn finished(mut self) -> Vec<Glued> {
        self.close();
        self.done
    }

    fn close(&mut self) {
        if !self.open.is_empty() {
            self.done.push(std::mem::take(&mut self.open));
        }
    }

    fn text(&mut self, text: &str, face: Face) {
        for word in text.split_inclusive(char::is_whitespace) {
            let ends = word.ends_with(char::is_whitespace);
            let shown = word.trim_end();
            let text = if ends { format!("{shown} ") } else { shown.to_owned() };
            // A space after a formula belongs to the line, not to a word.
            if !text.is_empty() {
                self.open.push(Piece::Word { text, face });
            }
            if ends {
                self.close();
            }
        }
    }

    fn line(&mut self, line: &[Inline<Told>], face: Face) {
        for inline in line {
            match inline {
                Inline::Text(text) => self.text(text, face),
                Inline::Value(value) => self.text(&value.text.replace(' ', "\u{a0}"), face),
                Inline::Emphasis(line) | Inline::Strong(line) => self.line(line, Face::Bold),
                Inline::Code(pieces) => self.text(&code(pieces), Face::Mono),
                Inline::Formula(pieces) => self.formula(&latex(pieces), face),
                Inline::Link(target, line) => {
                    self.line(line, face);
                    if let Target::Source(path) = target {
                        self.text(&format!(" ({path})"), face);
                    }
                }
                Inline::Break => {
                    self.open.push(Piece::End);
                    self.close();
                }
            }
        }
    }

    fn formula(&mut self, latex: &str, face: Face) {
        match Formula::typeset(latex, false) {
            Ok(formula) => self.open.push(Piece::Formula(formula)),
            Err(_) => self.text(latex, face),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(lines: &[Vec<Piece>]) -> Vec<String> {
        let piece = |piece: &Piece| match piece {
            Piece::Word { text, .. } => text.clone(),
            Piece::Formula(formula) => format!("<{}>", formula.words),
            Piece::End => String::new(),
        };
        lines.iter().map(|line| line.iter().map(piece).collect::<String>().trim_end().to_owned()).collect()
    }

    #[test]
    fn what_no_space_is_between_stays_on_one_line() {
        let line = vec![
            Inline::Text("The time (".to_owned()),
            Inline::Formula(vec![crate::lesson::prose::Piece::Text("t".to_owned())]),
            Inline::Text("), then".to_owned()),
        ];
        let lines = in_lines(glued(&line, Look::TEXT), 45.0, Look::TEXT.size);
        assert_eq!(shown(&lines), ["The time", "(<t>), then"]);
    }

    #[test]
    fn no_line_is_wider_than_the_page_unless_one_word_is() {
        let text = "Every ray that leaves the eye is asked for all of its hits with every object of the scene.";
        let lines = in_lines(glued_words(text, Look::TEXT), 120.0, Look::TEXT.size);
        assert!(lines.len() > 3);
        for line in &lines {
            assert!(line.iter().map(|piece| piece.width(10.0)).sum::<f64>() <= 123.0);
        }
        assert_eq!(shown(&lines).join(" "), text);
    }
}
