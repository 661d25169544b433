//! Lines of text that fit a width: paragraphs, working and tables, set with the fonts of drawings.

use crate::view::{DetailLine, Face, equated, text_width};

/// A line that is ready to be set.
#[derive(Clone, Debug, PartialEq)]
pub struct SetLine {
    /// The text.
    pub text: String,
    /// Its look.
    pub face: Face,
    /// How far it is moved to the right, in points.
    pub indent: f64,
    /// Whether a little room is left above it.
    pub begins: bool,
}

/// How far lines that go on are moved to the right, in sizes of the text.
const HANGING: f64 = 1.4;

/// A paragraph broken at spaces, so that each line is at most `width` wide. A single word that is too wide is broken anywhere.
pub fn broken(text: &str, width: f64, size: f64, face: Face) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in text.split(' ') {
        let fits = |line: &str, word: &str| text_width(&format!("{line} {word}"), size, face) <= width;
        let last = lines.len() - 1;
        if lines[last].is_empty() {
            lines[last].push_str(word);
        } else if fits(&lines[last], word) {
            lines[last].push(' ');
            lines[last].push_str(word);
        } else {
            lines.push(word.to_owned());
        }
        break_last(&mut lines, width, size, face);
    }
    lines
}

/// Breaks a last line that is too wide, being one word.
fn break_last(lines: &mut Vec<String>, width: f64, size: f64, face: Face) {
    while let Some(last) = lines.last().filter(|last| text_width(last, size, face) > width) {
        let fits = last.char_indices().skip(1).take_while(|(at, _)| text_width(&last[..*at], size, face) <= width);
        let Some((at, _)) = fits.last() else { return };
        let rest = last[at..].to_owned();
        if let Some(last) = lines.last_mut() {
            last.truncate(at);
        }
        lines.push(rest);
    }
}

/// The lines of an event's detail, set in `size` within `width`.
pub fn set(lines: &[DetailLine], width: f64, size: f64) -> Vec<SetLine> {
    lines.iter().flat_map(|line| set_one(line, width, size)).collect()
}

fn set_one(line: &DetailLine, width: f64, size: f64) -> Vec<SetLine> {
    match line {
        DetailLine::Pair { name, value } => hanging(&format!("{name}: {value}"), width, size, Face::Sans),
        DetailLine::Working { symbol, formula, numbers, result } => {
            let parts = equated(symbol, [formula, numbers, result]);
            let whole = parts.join(" = ");
            if text_width(&whole, size, Face::Sans) <= width || parts.len() < 3 {
                return hanging(&whole, width, size, Face::Sans);
            }
            let mut set = hanging(&parts[..2].join(" = "), width, size, Face::Sans);
            for part in &parts[2..] {
                let more = hanging(&format!("= {part}"), width - HANGING * size, size, Face::Sans);
                set.extend(more.into_iter().map(|line| SetLine {
                    indent: line.indent + HANGING * size,
                    begins: false,
                    ..line
                }));
            }
            set
        }
        DetailLine::Table { title, headers, rows } => table(title, headers, rows, width, size),
    }
}

fn hanging(text: &str, width: f64, size: f64, face: Face) -> Vec<SetLine> {
    let lines = broken(text, width - HANGING * size, size, face);
    let set = |(i, text)| SetLine { text, face, indent: if i == 0 { 0.0 } else { HANGING * size }, begins: i == 0 };
    lines.into_iter().enumerate().map(set).collect()
}

/// A table in columns where it fits, else each row as its cells with the names of their columns.
fn table(title: &str, headers: &[&str], rows: &[Vec<String>], width: f64, size: f64) -> Vec<SetLine> {
    let mut set = hanging(title, width, size, Face::Bold);
    let aligned = aligned(headers, rows);
    let widest = aligned.iter().map(|line| text_width(line, size, Face::Mono)).fold(0.0, f64::max);
    if widest <= width {
        let line = |text: String| SetLine { text, face: Face::Mono, indent: 0.0, begins: false };
        set.extend(aligned.into_iter().map(line));
        return set;
    }
    for row in rows {
        let cells = headers.iter().zip(row).filter(|(_, cell)| !cell.is_empty());
        let named = cells.map(|(header, cell)| format!("{header} {cell}").trim().to_owned());
        set.extend(hanging(&named.collect::<Vec<_>>().join(" · "), width, size, Face::Sans));
    }
    set
}

/// The rows of a table with spaces between, so that the columns stand below each other in a font of one width.
fn aligned(headers: &[&str], rows: &[Vec<String>]) -> Vec<String> {
    let head: Vec<String> = headers.iter().map(|&header| header.to_owned()).collect();
    let has_head = head.iter().any(|header| !header.is_empty());
    let lines: Vec<&Vec<String>> = has_head.then_some(&head).into_iter().chain(rows).collect();
    let length = |text: &String| text.chars().count();
    let widths: Vec<usize> = (0..headers.len())
        .map(|column| lines.iter().filter_map(|line| line.get(column)).map(length).max().unwrap_or(0))
        .collect();
    let line = |cells: &&Vec<String>| {
        let padded = cells.iter().zip(&widths).map(|(cell, &width)| format!("{cell:<width$}"));
        padded.collect::<Vec<_>>().join("  ").trim_end().to_owned()
    };
    lines.iter().map(line).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_line_is_wider_than_it_may_be_and_no_word_is_lost() {
        let text =
            "The closest hit in front of the ray's start: 0.1234567890123456789012345678901234567890 is what is seen.";
        for width in [30.0, 80.0, 200.0] {
            let lines = broken(text, width, 11.0, Face::Sans);
            assert!(lines.iter().all(|line| text_width(line, 11.0, Face::Sans) <= width), "{lines:?}");
            let letters = |text: &str| text.replace(' ', "");
            assert_eq!(letters(&lines.concat()), letters(text));
        }
    }

    #[test]
    fn a_working_that_is_too_long_for_a_line_has_a_line_for_each_part() {
        let working = DetailLine::Working {
            symbol: "t".to_owned(),
            formula: "(−B − √D) / A".to_owned(),
            numbers: "(−0.123456789 − √0.987654321) / 1.5".to_owned(),
            result: "−0.7448".to_owned(),
        };
        assert_eq!(set(std::slice::from_ref(&working), 2000.0, 11.0).len(), 1);
        let narrow: Vec<String> = set(&[working], 240.0, 11.0).into_iter().map(|line| line.text).collect();
        assert_eq!(narrow, ["t = (−B − √D) / A", "= (−0.123456789 − √0.987654321) / 1.5", "= −0.7448"]);
    }

    #[test]
    fn a_table_that_is_too_wide_names_its_columns_in_each_row() {
        let table = DetailLine::Table {
            title: "planes".to_owned(),
            headers: vec!["plane", "t"],
            rows: vec![vec!["top".to_owned(), "1.5".to_owned()], vec!["bottom".to_owned(), "2".to_owned()]],
        };
        let texts = |width| -> Vec<String> {
            set(std::slice::from_ref(&table), width, 11.0).into_iter().map(|line| line.text).collect()
        };
        assert_eq!(texts(400.0), ["planes", "plane   t", "top     1.5", "bottom  2"]);
        assert_eq!(texts(60.0)[..2], ["planes".to_owned(), "plane".to_owned()]);
        assert!(texts(60.0).concat().contains("1.5"));
    }
}
