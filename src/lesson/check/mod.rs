//! What a lesson is held to: everything in it is run.

mod course;
mod questions;
mod size;

pub use course::{check_course, check_in_course};

use super::model::{Lesson, Part, Step};
use super::place::{Finding, Place};
use super::question::Posed;
use super::scenes::{Scenes, Shelf};
use super::stage::Stage;
use crate::view::{Subject, Theme, View};
use questions::check_answers;

/// What a check came to.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Checked {
    /// What is wrong.
    pub findings: Vec<Finding>,
    /// How many claims and slips were held against recorded rays.
    pub claims: usize,
    /// How many values of the text were looked up.
    pub values: usize,
    /// How many answers were judged.
    pub answers: usize,
}

/// Runs a lesson: every step is traced, every value looked up, every claim held against the record, every question answered rightly
/// and in all wrong ways that it expects.
#[must_use]
pub fn check_lesson(lesson: &Lesson, scenes: &Scenes, shelf: &dyn Shelf) -> Checked {
    let mut check = Check { lesson, scenes, shelf, checked: Checked::default() };
    check.opening();
    for step in lesson.steps.iter().filter(|step| step.is_whole) {
        check.step(step);
    }
    // Of what could not be read it is not known how long it takes, and what it ends with.
    if lesson.is_whole {
        check.sizes();
        check.ending();
    }
    check.checked.findings.sort();
    check.checked.findings.dedup();
    check.checked
}

pub(super) struct Check<'a> {
    lesson: &'a Lesson,
    scenes: &'a Scenes,
    shelf: &'a dyn Shelf,
    checked: Checked,
}

impl Check<'_> {
    fn add(&mut self, place: Place, message: impl Into<String>) {
        self.checked.findings.push(Finding { file: self.lesson.file.clone(), place, message: message.into() });
    }

    /// The opening is about what the first step looks at.
    fn opening(&mut self) {
        let Some(step) = self.lesson.steps.first().filter(|step| step.is_whole) else { return };
        if let Ok(stage) = Stage::new(self.lesson, step, self.scenes, self.shelf) {
            stage.tell(&self.lesson.opening, &mut self.checked.findings);
        }
    }

    fn step(&mut self, step: &Step) {
        let stage = match Stage::new(self.lesson, step, self.scenes, self.shelf) {
            Ok(stage) => stage,
            Err(finding) => return self.checked.findings.push(finding),
        };
        for view in step.views.iter().chain(&step.after) {
            if draw(view.value, &stage).is_none() {
                let message =
                    format!("the view `{}` shows nothing of this ray: {}", view.value.name, view.value.missing);
                self.add(view.place, message);
            }
        }
        for query in &step.highlight {
            if query.value.first(&stage.tree).is_none() {
                self.add(query.place, format!("no event of the recorded ray answers `{}`", query.value));
            }
        }
        if let Some(t) = &step.t
            && let Err(error) = t.value.number(&stage.known())
        {
            self.checked.findings.push(stage.finding(t, &error));
        }
        for (_, name) in &step.names {
            if let Err(error) = name.value.evaluate(&stage.known()) {
                self.checked.findings.push(stage.finding(name, &error));
            }
        }
        for part in &step.parts {
            self.part(part, &stage, step);
        }
    }

    fn part(&mut self, part: &Part, stage: &Stage, step: &Step) {
        match part {
            Part::Prose(prose) => {
                self.checked.values += count_values(prose);
                stage.tell(prose, &mut self.checked.findings);
            }
            Part::Table(table) => {
                if stage.table(table, &mut self.checked.findings).rows.is_empty() {
                    self.add(table.of.place, "the list is empty, and so is the table");
                }
            }
            Part::Claims(claims) => claims.iter().for_each(|claim| self.claim(claim, stage)),
            Part::Slip(slip) => {
                stage.tell(&slip.printed, &mut self.checked.findings);
                stage.tell(&slip.right, &mut self.checked.findings);
                self.claim(&slip.shown, stage);
            }
            Part::Question(question) => {
                match Posed::new(question, stage) {
                    Ok(posed) => check_answers(self, &posed, stage, question.place),
                    Err(findings) => self.checked.findings.extend(findings),
                }
                for variant in &step.variants {
                    self.variant(step, variant, question);
                }
            }
        }
    }

    /// A question that stands for other rays too has to hold for them.
    fn variant(&mut self, step: &Step, aim: &super::model::Aim, question: &super::model::Question) {
        let posed = Stage::with_aim(self.lesson, step, aim, self.scenes, self.shelf)
            .map_err(|finding| vec![finding])
            .and_then(|stage| Posed::new(question, &stage).map(|posed| (posed, stage)));
        match posed {
            Ok((posed, stage)) => check_answers(self, &posed, &stage, question.place),
            Err(findings) => {
                let at = aim.at.map_or(String::new(), |at| format!("with the variant {at}: "));
                let findings = findings
                    .into_iter()
                    .map(|finding| Finding { message: format!("{at}{}", finding.message), ..finding });
                self.checked.findings.extend(findings);
            }
        }
    }

    fn claim(&mut self, claim: &super::model::Sited<super::expression::Expression>, stage: &Stage) {
        self.checked.claims += 1;
        match claim.value.holds(&stage.known()) {
            Ok(true) => {}
            Ok(false) => {
                let sides = claim.value.sides(&stage.known());
                let sides = sides.map_or(String::new(), |[a, b]| format!(": the left side is {a}, the right side {b}"));
                self.add(claim.place, format!("`{}` does not hold{sides}", claim.value.text()));
            }
            Err(error) => self.checked.findings.push(stage.finding(claim, &error)),
        }
    }
}

/// A drawing of what a step is about: of its event, or of what tells most.
pub(super) fn draw(view: &View, stage: &Stage) -> Option<crate::view::Drawing> {
    let scene = stage.scene.scene.as_ref();
    let subject = Subject { scene, tree: &stage.tree, event: stage.event, size: [480.0, 320.0], theme: Theme::Light };
    view.draw(&subject).or_else(|| view.draw_telling(&subject))
}

fn count_values(prose: &[super::prose::Block<super::prose::Reference>]) -> usize {
    let mut count = 0;
    for block in prose {
        block.for_each_line(&mut |line| {
            count += line.iter().filter(|inline| matches!(inline, super::prose::Inline::Value(_))).count();
        });
    }
    count
}
