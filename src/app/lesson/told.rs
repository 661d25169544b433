//! The parts of a step with their values put in, and its questions worked out.

use crate::lesson::expression::Expression;
use crate::lesson::model::{Part, Sited};
use crate::lesson::prose::{Prose, Reference, Told};
use crate::lesson::{Finding, Posed, Stage, ToldTable};

/// A part of a step, told.
pub enum ToldPart {
    /// Text.
    Prose(Prose<Told>),
    /// Where the source chapter slips.
    Slip {
        /// What it prints.
        printed: Prose<Told>,
        /// What is right.
        right: Prose<Told>,
    },
    /// A table of what was recorded.
    Table(ToldTable),
    /// A question, by its place among those of the step.
    Question(usize),
}

/// Tells the parts of a step one after the other.
pub struct Teller<'a> {
    /// What the step is about.
    pub stage: &'a Stage,
    /// What has no value.
    pub findings: Vec<Finding>,
    /// The questions so far, each with its number in the lesson.
    pub posed: Vec<(usize, Posed)>,
    /// How many questions the lesson has asked so far.
    pub asked: usize,
}

impl Teller<'_> {
    /// A text with its values.
    pub fn tell(&mut self, prose: &Prose<Reference>) -> Prose<Told> {
        self.stage.tell(prose, &mut self.findings)
    }

    /// The value of an expression, as a number.
    pub fn number(&mut self, expression: &Sited<Expression>) -> Option<f64> {
        let number = expression.value.number(&self.stage.known());
        number.map_err(|error| self.findings.push(self.stage.finding(expression, &error))).ok()
    }

    /// A part; none of what only teachers read, and of questions that cannot be posed.
    pub fn part(&mut self, part: &Part) -> Option<ToldPart> {
        match part {
            Part::Prose(prose) => Some(ToldPart::Prose(self.tell(prose))),
            Part::Claims(_) => None,
            Part::Slip(slip) => {
                Some(ToldPart::Slip { printed: self.tell(&slip.printed), right: self.tell(&slip.right) })
            }
            Part::Table(table) => Some(ToldPart::Table(self.stage.table(table, &mut self.findings))),
            Part::Question(question) => {
                let number = self.asked;
                self.asked += 1;
                let posed = Posed::new(question, self.stage).map_err(|wrong| self.findings.extend(wrong)).ok()?;
                self.posed.push((number, posed));
                Some(ToldPart::Question(self.posed.len() - 1))
            }
        }
    }
}

/// Links the terms where they first stand in the whole step, not once in each of its parts.
pub fn link_once(
    opening: Prose<Told>,
    mut parts: Vec<ToldPart>,
    linked: impl Fn(Prose<Told>) -> Prose<Told>,
) -> (Prose<Told>, Vec<ToldPart>) {
    let count = opening.len();
    let mut all = opening;
    for part in &mut parts {
        if let ToldPart::Prose(prose) = part {
            all.append(&mut prose.clone());
        }
    }
    let mut all = linked(all).into_iter();
    let opening = all.by_ref().take(count).collect();
    for part in &mut parts {
        if let ToldPart::Prose(prose) = part {
            *prose = all.by_ref().take(prose.len()).collect();
        }
    }
    (opening, parts)
}
