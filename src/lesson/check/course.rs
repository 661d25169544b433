//! What a course as a whole is held to: links, terms, needs.

use super::{Checked, check_lesson};
use crate::lesson::course::{Course, START};
use crate::lesson::model::{Lesson, Part};
use crate::lesson::place::{Finding, Place};
use crate::lesson::prose::{Block, Inline, Prose, Reference, Target};
use crate::lesson::scenes::{Scenes, Shelf};

/// Runs all lessons of a course. `watch` is told how many are done, of how many, and says whether to go on.
#[must_use]
pub fn check_course(course: &Course, shelf: &dyn Shelf, watch: &mut dyn FnMut(usize, usize) -> bool) -> Checked {
    let mut all = Checked { findings: course.findings.clone(), ..Checked::default() };
    all.findings.extend(course.unmet_needs());
    for (number, lesson) in course.lessons.iter().enumerate() {
        if !watch(number, course.lessons.len()) {
            break;
        }
        // Scenes are kept for one lesson: a whole course of pictures and hierarchies would fill the memory.
        let checked = check_lesson(lesson, &Scenes::default(), shelf);
        all.findings.extend(checked.findings);
        all.claims += checked.claims;
        all.values += checked.values;
        all.answers += checked.answers;
        all.findings.extend(broken_links(lesson, course));
    }
    all.findings.sort();
    all.findings.dedup();
    all
}

/// Links that lead nowhere.
fn broken_links(lesson: &Lesson, course: &Course) -> Vec<Finding> {
    let mut broken = Vec::new();
    for_each_prose(lesson, &mut |prose, place| {
        for target in targets(prose) {
            let message = match target {
                Target::Term(name) if course.glossary.find(name).is_none() => {
                    format!("the glossary has no term `{name}`")
                }
                Target::Lesson(id) if course.lesson(id).is_none() => format!("there is no lesson `{id}`"),
                Target::Source(path) if !is_source(path) => format!("`{path}` is no file of the program's source"),
                _ => continue,
            };
            broken.push(Finding { file: lesson.file.clone(), place, message });
        }
    });
    broken
}

/// A path into the source, with no way out of it. That the file is there is seen to by a test, which has the source beside it.
fn is_source(path: &str) -> bool {
    path.starts_with("src/") && !path.contains("..") && path.to_ascii_lowercase().ends_with(".rs")
}

fn for_each_prose(lesson: &Lesson, show: &mut dyn FnMut(&Prose<Reference>, Place)) {
    show(&lesson.opening, START);
    for step in &lesson.steps {
        for part in &step.parts {
            match part {
                Part::Prose(prose) => show(prose, step.place),
                Part::Slip(slip) => {
                    show(&slip.printed, slip.shown.place);
                    show(&slip.right, slip.shown.place);
                }
                Part::Question(question) => {
                    show(&question.ask, question.place);
                    question.hints.iter().chain(&question.explain).for_each(|prose| show(prose, question.place));
                }
                Part::Claims(_) | Part::Table(_) => {}
            }
        }
    }
}

fn targets(prose: &[Block<Reference>]) -> Vec<&Target> {
    let mut found = Vec::new();
    for block in prose {
        block.for_each_line(&mut |line| links(line, &mut found));
    }
    found
}

fn links<'a>(line: &'a [Inline<Reference>], found: &mut Vec<&'a Target>) {
    for inline in line {
        match inline {
            Inline::Link(target, _) => found.push(target),
            Inline::Emphasis(line) | Inline::Strong(line) => links(line, found),
            _ => {}
        }
    }
}
