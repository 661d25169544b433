//! The contents: the course with its map.

use super::frame::Head;
use super::lesson::{link, needs};
use super::{Book, BookFile, map};
use crate::view::escaped;

/// The page.
pub fn file(book: &mut Book) -> BookFile {
    let course = book.course;
    let mut page = book.page();
    let minutes: u32 = course.lessons.iter().map(|lesson| lesson.header.minutes.value).sum();
    page.put(format_args!(
        "<h1>Following a ray</h1>\n<p class=\"idea\">A course in ray tracing with recorded rays: predict what happens, then look at every \
         number. {} lessons, {} hours altogether.</p>\n",
        course.lessons.len(),
        minutes.div_ceil(60),
    ));
    page.put("<h2>Lessons</h2>\n<ol class=\"lessons\">\n");
    for lesson in &course.lessons {
        let needs = needs(lesson, course, "");
        let after = if needs.is_empty() { String::new() } else { format!(" · builds on {}", needs.join(", ")) };
        page.put(format_args!(
            "<li>{}<span class=\"idea\">{}</span><span class=\"facts\">§ {} · {} minutes{after}</span></li>\n",
            link(lesson, ""),
            escaped(&lesson.header.idea),
            escaped(&lesson.header.section.value),
            lesson.header.minutes.value,
        ));
    }
    page.put("</ol>\n<h2>What needs what</h2>\n");
    page.put(format_args!(
        "<figure class=\"drawing\"><div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Map of the course\">{}</div>\
         <figcaption>Each lesson with lines from those that it builds on. What stands in the same row can be read in any order.\
         </figcaption></figure>\n",
        map::svg(course)
    ));
    page.finished(&Head {
        path: "index.html".to_owned(),
        title: "Following a ray".to_owned(),
        about: "A course in ray tracing with recorded rays.".to_owned(),
        ..Head::default()
    })
}
