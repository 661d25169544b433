//! What a course as a whole is held to: links, terms, needs.

use super::{Checked, check_lesson};
use crate::lesson::course::Course;
use crate::lesson::model::Lesson;
use crate::lesson::place::{Finding, Place};
use crate::lesson::prose::Target;
use crate::lesson::scenes::{Scenes, Shelf};

/// Runs all lessons of a course. `watch` is told how many are done, of how many, and says whether to go on.
#[must_use]
pub fn check_course(course: &Course, shelf: &dyn Shelf, watch: &mut dyn FnMut(usize, usize) -> bool) -> Checked {
    let mut all = Checked { findings: course.findings.clone(), ..Checked::default() };
    for (number, lesson) in course.lessons.iter().enumerate() {
        if !watch(number, course.lessons.len()) {
            break;
        }
        let checked = check_in_course(lesson, course, shelf);
        all.findings.extend(checked.findings);
        all.claims += checked.claims;
        all.values += checked.values;
        all.answers += checked.answers;
    }
    all.findings.sort();
    all.findings.dedup();
    all
}

/// Runs one lesson of a course, with its links and what it needs.
#[must_use]
pub fn check_in_course(lesson: &Lesson, course: &Course, shelf: &dyn Shelf) -> Checked {
    // Scenes are kept for one lesson: a whole course of pictures and hierarchies would fill the memory.
    let mut checked = check_lesson(lesson, &Scenes::default(), shelf);
    checked.findings.extend(broken_links(lesson, course));
    let needs = course.unmet_needs().into_iter().filter(|finding| finding.file == lesson.file);
    checked.findings.extend(needs);
    let read = course.findings.iter().filter(|finding| finding.file == lesson.file);
    checked.findings.extend(read.cloned());
    checked.findings.sort();
    checked.findings.dedup();
    checked
}

/// Links that lead nowhere.
fn broken_links(lesson: &Lesson, course: &Course) -> Vec<Finding> {
    let broken = |(target, place): &(Target, Place)| {
        let message = match target {
            Target::Term(name) if course.glossary.find(name).is_none() => {
                let near =
                    course.glossary.nearest(name).map_or(String::new(), |near| format!("; the nearest is `{near}`"));
                format!("the glossary has no term `{name}`{near}")
            }
            Target::Lesson(id) if !course.has(id) => format!("there is no lesson `{id}`"),
            Target::Source(path) if !is_source(path) => format!("`{path}` is no file of the program's source"),
            _ => return None,
        };
        Some(Finding { file: lesson.file.clone(), place: *place, message })
    };
    lesson.links.iter().filter_map(broken).collect()
}

/// A path into the source, with no way out of it. That the file is there is seen to by a test, which has the source beside it.
fn is_source(path: &str) -> bool {
    path.starts_with("src/") && !path.contains("..") && path.to_ascii_lowercase().ends_with(".rs")
}
