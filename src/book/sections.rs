//! The sections of the syllabus, with the lessons and scenes that belong to each.

use super::frame::Head;
use super::lesson::link;
use super::{Book, BookFile};
use crate::lesson::model::Lesson;
use crate::view::escaped;
use std::collections::BTreeMap;

/// The place of a section on the page.
pub fn anchor(section: &str) -> String {
    format!("section-{}", section.replace(|c: char| !c.is_ascii_alphanumeric(), "-"))
}

/// A section as numbers, so that 6.10 comes after 6.9.
fn in_order(section: &str) -> Vec<u32> {
    section.split('.').map(|part| part.parse().unwrap_or(u32::MAX)).collect()
}

/// What belongs to a section.
#[derive(Default)]
struct Section<'a> {
    lessons: Vec<&'a Lesson>,
    examples: Vec<usize>,
}

/// The page.
pub fn file(book: &mut Book) -> BookFile {
    let course = book.course;
    let mut sections: BTreeMap<(Vec<u32>, &str), Section> = BTreeMap::new();
    for lesson in &course.lessons {
        let section = lesson.header.section.value.as_str();
        sections.entry((in_order(section), section)).or_default().lessons.push(lesson);
    }
    for (place, example) in book.examples.iter().enumerate() {
        for section in &example.sections {
            sections.entry((in_order(section), section)).or_default().examples.push(place);
        }
    }
    let mut page = book.page();
    page.put("<h1>Sections of the syllabus</h1>\n<dl class=\"sections\">\n");
    for ((_, name), section) in &sections {
        page.put(format_args!("<dt id=\"{}\">§ {}</dt>\n<dd>\n<ul>\n", anchor(name), escaped(name)));
        for lesson in &section.lessons {
            page.put(format_args!(
                "<li>{}<span class=\"idea\">{}</span></li>\n",
                link(lesson, ""),
                escaped(&lesson.header.idea)
            ));
        }
        page.put("</ul>\n");
        if !section.examples.is_empty() {
            let links: Vec<String> = section.examples.iter().map(|&place| book.examples[place].link("")).collect();
            page.put(format_args!("<p class=\"examples\">Worked examples: {}</p>\n", links.join(", ")));
        }
        page.put("</dd>\n");
    }
    page.put("</dl>\n");
    page.finished(&Head {
        path: "sections.html".to_owned(),
        title: "Sections of the syllabus".to_owned(),
        about: "Each section with its lessons and worked examples.".to_owned(),
        ..Head::default()
    })
}
