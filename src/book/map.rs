//! The map of the course: lessons as boxes in rows, with lines from what each of them builds on.

use super::{lesson_path, number_of};
use crate::lesson::Course;
use crate::lesson::model::Lesson;
use crate::view::{Face, escaped, text_width};
use std::collections::BTreeMap;
use std::fmt::Write as _;

/// Sizes in points.
const BOX: [f64; 2] = [168.0, 42.0];
const GAP: [f64; 2] = [18.0, 38.0];
const SIZE: f64 = 12.0;

/// The map as SVG in the colours of the page; its boxes are links.
pub fn svg(course: &Course) -> String {
    let places = places(course);
    let width = places.values().map(|[x, _]| x + BOX[0]).fold(BOX[0], f64::max) + 2.0;
    let height = places.values().map(|[_, y]| y + BOX[1]).fold(BOX[1], f64::max) + 2.0;
    let mut out =
        format!("<svg class=\"map\" width=\"{width}\" height=\"{height}\" viewBox=\"-1 -1 {width} {height}\">\n");
    for lesson in &course.lessons {
        for need in &lesson.header.needs {
            if let (Some(from), Some(to)) = (places.get(need.value.as_str()), places.get(lesson.id.as_str())) {
                line(&mut out, *from, *to);
            }
        }
    }
    for lesson in &course.lessons {
        if let Some(place) = places.get(lesson.id.as_str()) {
            a_box(&mut out, lesson, *place);
        }
    }
    out + "</svg>"
}

/// The left upper corners of the boxes.
fn places(course: &Course) -> BTreeMap<&str, [f64; 2]> {
    let columns = course.levels();
    let mut used: BTreeMap<usize, usize> = BTreeMap::new();
    let mut places = BTreeMap::new();
    for lesson in &course.lessons {
        let row = columns.get(lesson.id.as_str()).copied().unwrap_or(0);
        let before = used.entry(row).or_insert(0);
        places.insert(lesson.id.as_str(), [*before as f64 * (BOX[0] + GAP[0]), row as f64 * (BOX[1] + GAP[1])]);
        *before += 1;
    }
    places
}

fn line(out: &mut String, from: [f64; 2], to: [f64; 2]) {
    let [x0, y0] = [from[0] + BOX[0] / 2.0, from[1] + BOX[1]];
    let [x1, y1] = [to[0] + BOX[0] / 2.0, to[1]];
    let bend = GAP[1] * 0.8;
    let _ = writeln!(
        out,
        "<path d=\"M{x0} {y0}C{x0} {} {x1} {} {x1} {y1}\" fill=\"none\" stroke=\"currentColor\" stroke-opacity=\"0.45\"/>",
        y0 + bend,
        y1 - bend
    );
}

fn a_box(out: &mut String, lesson: &Lesson, [x, y]: [f64; 2]) {
    let [width, height] = BOX;
    let _ = write!(
        out,
        "<a href=\"{}\"><title>{}</title><rect x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" rx=\"5\"/>",
        lesson_path(&lesson.id),
        escaped(&lesson.header.title)
    );
    let lines = lines(&format!("{} {}", number_of(lesson), lesson.header.title), width - 16.0);
    let first = y + height / 2.0 + SIZE * 0.36 - (lines.len() as f64 - 1.0) * SIZE * 0.62;
    for (place, line) in lines.iter().enumerate() {
        let at = first + place as f64 * SIZE * 1.24;
        let _ = write!(out, "<text x=\"{}\" y=\"{at:.1}\" font-size=\"{SIZE}\">{}</text>", x + 8.0, escaped(line));
    }
    out.push_str("</a>\n");
}

/// A title in two lines at most; what does not fit is left to the list above.
fn lines(title: &str, width: f64) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in title.split_whitespace() {
        let last = lines.len() - 1;
        let longer = format!("{} {word}", lines[last]).trim().to_owned();
        if lines[last].is_empty() || text_width(&longer, SIZE, Face::Sans) <= width {
            lines[last] = longer;
        } else if lines.len() == 2 {
            lines[1].push_str(" …");
            break;
        } else {
            lines.push(word.to_owned());
        }
    }
    lines
}
