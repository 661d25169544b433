//! Paragraphs, lists, code and boxes on paper.

use super::flow::{Flow, Look};
use super::line::{Glued, glued, glued_words};
use crate::lesson::Told;
use crate::lesson::prose::{Block, code, latex};
use crate::view::Formula;

/// How far the text of a list stands from its signs.
const STEP: f64 = 16.0;

impl Flow {
    /// Paragraphs and the like, with their left end so far from that of the text.
    pub fn prose(&mut self, prose: &[Block<Told>], indent: f64) {
        for block in prose {
            self.block(block, indent);
        }
    }

    fn block(&mut self, block: &Block<Told>, indent: f64) {
        match block {
            Block::Paragraph(line) => self.lines(glued(line, Look::TEXT), indent, Look::TEXT),
            Block::Heading(line) => {
                self.keep(40.0);
                self.lines(glued(line, Look::LABEL), indent, Look::LABEL);
            }
            Block::List { numbered, items } => {
                for (place, item) in items.iter().enumerate() {
                    let sign = if *numbered { format!("{}.", place + 1) } else { "•".to_owned() };
                    self.item(&sign, item, indent);
                }
            }
            Block::Quote(blocks) => self.prose(blocks, indent + STEP),
            Block::Code(pieces) => {
                for line in code(pieces).trim_end().lines() {
                    self.lines(glued_words(&line.replace(' ', "\u{a0}"), Look::CODE), indent + STEP, Look::CODE);
                }
                self.gap(Look::TEXT.after);
            }
            Block::Formula(pieces) => match Formula::typeset(&latex(pieces), true) {
                Ok(formula) => self.display(&formula, indent),
                Err(_) => self.lines(glued_words(&latex(pieces), Look::CODE), indent, Look::CODE),
            },
            Block::Table { head, rows } => self.table(head, rows, indent),
        }
    }

    /// An item: its sign stands before its first line.
    pub fn item(&mut self, sign: &str, item: &[Block<Told>], indent: f64) {
        if let [Block::Paragraph(line), rest @ ..] = item {
            self.signed(sign, glued(line, Look::TEXT), indent);
            self.prose(rest, indent + STEP);
        } else {
            self.signed(sign, glued_words(" ", Look::TEXT), indent);
            self.prose(item, indent + STEP);
        }
    }

    /// A line with a sign before it.
    pub fn signed(&mut self, sign: &str, line: Vec<Glued>, indent: f64) {
        self.hanging(Some((sign, STEP)), line, indent + STEP, Look { after: 2.0, ..Look::TEXT });
    }

    /// Where the printed chapter slips.
    pub fn slip(&mut self, printed: &[Block<Told>], right: &[Block<Told>]) {
        self.gap(4.0);
        self.keep(70.0);
        self.rule(0.0, super::flow::WIDTH);
        self.gap(5.0);
        self.words("A slip in the printed chapter", Look::LABEL);
        for (who, said) in [("Printed", printed), ("Right", right)] {
            self.words(who, Look { after: 0.0, ..Look::SMALL });
            self.prose(said, STEP);
        }
        self.rule(0.0, super::flow::WIDTH);
        self.gap(8.0);
    }
}
