//! The course: all lessons that come with the program, or those of a folder, in their order.

use super::glossary::Glossary;
use super::model::Lesson;
use super::place::Finding;
use super::source::read;
use include_dir::{Dir, include_dir};
use std::collections::{BTreeMap, BTreeSet};

/// The lessons that come with the program.
pub static EMBEDDED: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/lessons");

/// A lesson's text, wherever it comes from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LessonText {
    /// The name of its folder.
    pub id: String,
    /// The file, as messages are to name it.
    pub file: String,
    /// What it says.
    pub text: String,
}

/// Lessons that belong together, with their glossary.
#[derive(Clone, Debug, Default)]
pub struct Course {
    /// The lessons, by the names of their folders.
    pub lessons: Vec<Lesson>,
    /// Their terms.
    pub glossary: Glossary,
    /// What was found wrong while they were read.
    pub findings: Vec<Finding>,
    /// Lessons that may be needed and linked to, though they are no part of it: the program's, of a course from elsewhere.
    pub beside: BTreeSet<String>,
}

impl Course {
    /// The course that comes with the program.
    #[must_use]
    pub fn embedded() -> Self {
        let mut texts: Vec<LessonText> = EMBEDDED
            .dirs()
            .filter_map(|dir| {
                let id = dir.path().to_str()?.replace('\\', "/");
                let file = dir.get_file(dir.path().join("lesson.md"))?;
                // The template is there to be copied, and is no lesson of the course.
                let is_numbered = id.starts_with(|c: char| c.is_ascii_digit());
                is_numbered.then(|| LessonText {
                    file: format!("lessons/{id}/lesson.md"),
                    id,
                    text: file.contents_utf8().unwrap_or_default().to_owned(),
                })
            })
            .collect();
        texts.sort_by(|a, b| a.id.cmp(&b.id));
        let glossary = EMBEDDED.get_file("glossary.md").and_then(include_dir::File::contents_utf8);
        Self::read(&texts, Some(("lessons/glossary.md", glossary.unwrap_or_default())))
    }

    /// The course of these texts, in their order.
    #[must_use]
    pub fn read(texts: &[LessonText], glossary: Option<(&str, &str)>) -> Self {
        let mut course = Self::default();
        for LessonText { id, file, text } in texts {
            let (lesson, findings) = read(id, file, text);
            course.lessons.extend(lesson);
            course.findings.extend(findings);
        }
        if let Some((file, text)) = glossary {
            let (terms, findings) = Glossary::read(file, text);
            course.glossary = terms;
            course.findings.extend(findings);
        }
        course
    }

    /// The lesson of that name.
    #[must_use]
    pub fn lesson(&self, id: &str) -> Option<&Lesson> {
        self.lessons.iter().find(|lesson| lesson.id == id)
    }

    /// Whether there is a lesson of that name, in it or beside it.
    #[must_use]
    pub fn has(&self, id: &str) -> bool {
        self.lesson(id).is_some() || self.beside.contains(id)
    }

    /// How many lessons lie between each lesson and the first that it builds on: its level on the course's map. What needs
    /// nothing is on level 0.
    #[must_use]
    pub fn levels(&self) -> BTreeMap<&str, usize> {
        let mut levels: BTreeMap<&str, usize> = BTreeMap::new();
        // Needs lead to earlier lessons, so that one pass is enough.
        for lesson in &self.lessons {
            let needed = lesson.header.needs.iter().filter_map(|id| levels.get(id.value.as_str())).max();
            levels.insert(&lesson.id, needed.map_or(0, |level| level + 1));
        }
        levels
    }

    /// Needs that are no lesson, or none that comes before.
    #[must_use]
    pub fn unmet_needs(&self) -> Vec<Finding> {
        let mut findings = Vec::new();
        for (number, lesson) in self.lessons.iter().enumerate() {
            for need in &lesson.header.needs {
                let found = self.lessons.iter().position(|other| other.id == need.value);
                let message = match found {
                    None if self.beside.contains(&need.value) => continue,
                    None => format!("there is no lesson `{}`", need.value),
                    Some(at) if at >= number => format!("`{}` does not come before this lesson", need.value),
                    Some(_) => continue,
                };
                findings.push(Finding { file: lesson.file.clone(), place: need.place, message });
            }
        }
        findings
    }
}
