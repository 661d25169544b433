//! A lesson on paper: pages of A4 with its text, formulas, drawings and tables, and the answers at the end.

mod blocks;
mod flow;
mod line;
mod questions;
mod table;

use super::numbered_title;
use crate::lesson::model::{Lesson, Part, Sited, Step};
use crate::lesson::{Course, Finding, Posed, Scenes, Shelf, Stage};
use crate::view::{Subject, Theme, View, pdf};
use flow::{Flow, Look};

/// Width and height of a drawing in points, as it is made: in smaller ones labels would lie on each other.
const DRAWING: [f64; 2] = [620.0, 366.0];

/// Its width on paper. Larger ones leave much of a page white where they do not fit on it.
const ON_PAPER: f64 = 410.0;

/// A lesson as a PDF, and what is wrong with it.
#[must_use]
pub fn lesson_pdf(course: &Course, lesson: &Lesson, shelf: &dyn Shelf) -> (Vec<u8>, Vec<Finding>) {
    let mut printer = Printer { flow: Flow::new(), findings: Vec::new(), asked: Vec::new() };
    let scenes = Scenes::default();
    printer.heading(course, lesson);
    for (place, step) in lesson.steps.iter().enumerate() {
        match Stage::new(lesson, step, &scenes, shelf) {
            Ok(stage) => {
                if place == 0 {
                    let opening = stage.tell(&lesson.opening, &mut printer.findings);
                    printer.flow.prose(&opening, 0.0);
                }
                printer.step(place + 1, step, &stage);
            }
            Err(finding) => printer.findings.push(finding),
        }
    }
    printer.answers();
    let title = numbered_title(lesson);
    let pages = printer.flow.finished(&title);
    (pdf(&title, &pages), printer.findings)
}

struct Printer {
    flow: Flow,
    findings: Vec<Finding>,
    /// The questions with their numbers, for the answers at the end.
    asked: Vec<(String, Posed)>,
}

impl Printer {
    fn heading(&mut self, course: &Course, lesson: &Lesson) {
        let header = &lesson.header;
        self.flow.words(&format!("§ {} · {} minutes", header.section.value, header.minutes.value), Look::SMALL);
        self.flow.words(&numbered_title(lesson), Look::TITLE);
        self.flow.words(&header.idea, Look::IDEA);
        let needs: Vec<String> =
            header.needs.iter().filter_map(|id| course.lesson(&id.value)).map(numbered_title).collect();
        if !needs.is_empty() {
            self.flow.words(&format!("It builds on {}.", needs.join(", ")), Look::SMALL);
        }
        self.flow.gap(8.0);
    }

    fn step(&mut self, number: usize, step: &Step, stage: &Stage) {
        self.flow.gap(10.0);
        // A heading at the foot of a page would stand apart from its text.
        self.flow.keep(90.0);
        self.flow.words(&format!("{number}  {}", step.title), Look::HEADING);
        self.flow.words(&format!("Looked at: {}", stage.aim_in_words()), Look::SMALL);
        let mut questions = 0;
        let mut is_drawn = false;
        for part in &step.parts {
            match part {
                Part::Prose(prose) => {
                    let prose = stage.tell(prose, &mut self.findings);
                    self.flow.prose(&prose, 0.0);
                }
                Part::Claims(_) => {}
                Part::Slip(slip) => {
                    let [printed, right] =
                        [&slip.printed, &slip.right].map(|prose| stage.tell(prose, &mut self.findings));
                    self.flow.slip(&printed, &right);
                }
                Part::Table(table) => {
                    let told = stage.table(table, &mut self.findings);
                    self.flow.table(&told.head, &told.rows, 0.0);
                }
                Part::Question(question) => match Posed::new(question, stage) {
                    Ok(posed) => {
                        // What a question is about is seen before it is asked.
                        self.drawings(&step.views, stage, &mut is_drawn);
                        questions += 1;
                        let number = format!("{number}.{questions}");
                        self.flow.question(&number, &posed);
                        self.asked.push((number, posed));
                    }
                    Err(findings) => self.findings.extend(findings),
                },
            }
        }
        self.drawings(&step.views, stage, &mut is_drawn);
    }

    fn drawings(&mut self, views: &[Sited<&'static View>], stage: &Stage, is_drawn: &mut bool) {
        if std::mem::replace(is_drawn, true) {
            return;
        }
        for view in views.iter().map(|view| view.value) {
            let scene = &stage.scene.scene;
            let subject = Subject { scene, tree: &stage.tree, event: stage.event, size: DRAWING, theme: Theme::Light };
            if let Some(drawing) = view.draw(&subject).or_else(|| view.draw_telling(&subject)) {
                self.flow.drawing(&drawing, ON_PAPER);
                self.flow.words(view.about, Look::SMALL);
            }
        }
    }

    fn answers(&mut self) {
        if self.asked.is_empty() {
            return;
        }
        self.flow.next_page();
        self.flow.words("Answers", Look::HEADING);
        for (number, posed) in std::mem::take(&mut self.asked) {
            self.flow.answer(&number, &posed);
        }
    }
}
