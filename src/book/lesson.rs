//! The page of a lesson.

use super::frame::Head;
use super::page::Page;
use super::step::Steps;
use super::{Book, BookFile, lesson_path, number_of, numbered_title};
use crate::lesson::Course;
use crate::lesson::model::Lesson;
use crate::view::escaped;

/// The page, and the pictures that it shows for the first time.
pub fn files(book: &mut Book, place: usize) -> Vec<BookFile> {
    let (course, shelf) = (book.course, book.shelf);
    let lesson = &course.lessons[place];
    let path = lesson_path(&lesson.id);
    let mut page = book.page_in_folder();
    let mut steps = Steps::new(lesson, path.clone(), shelf);
    page.put("<article class=\"lesson\">\n");
    heading(lesson, &mut page);
    steps.opening(&mut page);
    // Terms of the opening are found with the first step.
    for number in 0..lesson.steps.len() {
        steps.write(number, &mut page, &mut book.pictures);
    }
    page.put("</article>\n");
    let neighbour = |place: Option<usize>| {
        place
            .and_then(|place| course.lessons.get(place))
            .map(|lesson| (lesson_path(&lesson.id), numbered_title(lesson)))
    };
    let head = Head {
        path,
        title: numbered_title(lesson),
        about: lesson.header.idea.clone(),
        before: neighbour(place.checked_sub(1)),
        after: neighbour(Some(place + 1)),
        scripts: &[],
    };
    page.files.append(&mut steps.files);
    let written = page.finished(&head);
    book.keep(&mut page);
    page.files.push(written);
    page.files
}

fn heading(lesson: &Lesson, page: &mut Page) {
    let header = &lesson.header;
    let (number, root) = (number_of(lesson), page.root);
    let number = if number.is_empty() { String::new() } else { format!("Lesson {number} · ") };
    page.put(format_args!(
        "<header>\n<p class=\"kicker\">{number}<a href=\"{root}sections.html#{}\">§ {}</a> · {} minutes</p>\n<h1>{}</h1>\n\
         <p class=\"idea\">{}</p>\n",
        super::sections::anchor(&header.section.value),
        escaped(&header.section.value),
        header.minutes.value,
        escaped(&header.title),
        escaped(&header.idea),
    ));
    let needs = needs(lesson, page.course, page.root);
    if !needs.is_empty() {
        page.put(format_args!("<p class=\"needs\">It builds on {}.</p>\n", needs.join(", ")));
    }
    page.put(format_args!(
        "<p class=\"open\">In the workbench: <code>rayscope lesson open {}</code></p>\n",
        escaped(&lesson.id)
    ));
    page.put("<nav class=\"steps\" aria-label=\"Steps\"><ol>\n");
    for (number, step) in lesson.steps.iter().enumerate() {
        page.put(format_args!("<li><a href=\"#step-{}\">{}</a></li>\n", number + 1, escaped(&step.title)));
    }
    page.put("</ol></nav>\n</header>\n");
}

/// Links to the lessons that a lesson builds on.
pub fn needs(lesson: &Lesson, course: &Course, root: &str) -> Vec<String> {
    let needed = lesson.header.needs.iter().filter_map(|id| course.lesson(&id.value));
    needed.map(|needed| link(needed, root)).collect()
}

/// A link to a lesson.
pub fn link(lesson: &Lesson, root: &str) -> String {
    format!("<a href=\"{root}{}\">{}</a>", lesson_path(&lesson.id), escaped(&numbered_title(lesson)))
}
