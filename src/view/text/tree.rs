//! The whole tree as text, for terminals and for snapshots: a worked example that reads by itself.
//!
//! Each event is a row, indented below its parent, with everything that the row leaves out under it. An explanation is
//! printed the first time that it applies. Places in the source are left out, so that a snapshot changes when the work
//! changes and not when a file does.

use super::beneath::{beneath, equated};
use super::detail::{DetailLine, detail};
use super::row::row;
use crate::record::{Event, EventId};
use crate::trace::RayTree;
use std::collections::{BTreeMap, BTreeSet};

/// The whole tree as text.
#[must_use]
pub fn tree_text(tree: &RayTree) -> String {
    let mut text = String::new();
    let mut explained = BTreeSet::new();
    let mut depths: BTreeMap<EventId, usize> = BTreeMap::new();
    for event in &tree.events {
        let depth = event.parent.and_then(|parent| depths.get(&parent)).map_or(0, |depth| depth + 1);
        depths.insert(event.id, depth);
        write_event(&mut text, event, depth, &mut explained);
    }
    text
}

fn write_event(text: &mut String, event: &Event, depth: usize, explained: &mut BTreeSet<&'static str>) {
    let row = row(event);
    let gap = if row.numbers.is_empty() { "" } else { "   " };
    put_line(text, depth, &format!("{} {}{gap}{}", row.icon, row.label, row.numbers));
    let explanation = detail(event).explanation;
    let below = depth + 2;
    if explained.insert(explanation) {
        put_wrapped(text, below, "—", explanation);
    }
    for line in beneath(event) {
        match line {
            DetailLine::Pair { name, value } => put_wrapped(text, below, &format!("{name}:"), &value),
            DetailLine::Working { symbol, formula, numbers, result } => {
                put_working(text, below, &symbol, [&formula, &numbers, &result]);
            }
            DetailLine::Table { headers, rows, .. } => put_table(text, below, &headers, &rows),
        }
    }
}

/// Lines longer than this are broken where there is a place for it.
const WIDTH: usize = 104;

/// `symbol = formula = numbers = result`, without a part that says the same as the one before it, and with a line for
/// each part where one line would be too long.
fn put_working(text: &mut String, depth: usize, symbol: &str, parts: [&str; 3]) {
    let said = equated(symbol, parts);
    let line = said.join(" = ");
    if line.chars().count() <= WIDTH || said.len() < 3 {
        put_line(text, depth, &line);
        return;
    }
    put_line(text, depth, &said[..2].join(" = "));
    let indent = " ".repeat(symbol.chars().count());
    for part in &said[2..] {
        put_line(text, depth, &format!("{indent} = {part}"));
    }
}

/// Levels that are shown by blanks. With blanks alone the story of a ray that is mirrored 10,000 times would take gigabytes.
const INDENTED: usize = 60;

/// What stands before a line at this depth: two blanks for each level, and below the deepest of these the level's number.
#[must_use]
pub fn indent(depth: usize) -> String {
    let blanks = "  ".repeat(depth.min(INDENTED));
    if depth > INDENTED { format!("{blanks}{depth}: ") } else { blanks }
}

fn put_line(text: &mut String, depth: usize, line: &str) {
    text.push_str(&indent(depth));
    text.push_str(line.trim_end());
    text.push('\n');
}

/// Words after a head, broken into lines that start below the first word.
fn put_wrapped(text: &mut String, depth: usize, head: &str, words: &str) {
    let hanging = if head.chars().count() < 3 { head.chars().count() } else { 2 };
    let mut line = head.to_owned();
    for word in words.split(' ') {
        if line.chars().count() + 1 + word.chars().count() > WIDTH && line.trim() != "" && line != head {
            put_line(text, depth, &line);
            line = " ".repeat(hanging);
        }
        line.push(' ');
        line.push_str(word);
    }
    put_line(text, depth, &line);
}

/// A table with aligned columns: numbers to the right, words to the left.
fn put_table(text: &mut String, depth: usize, headers: &[&str], rows: &[Vec<String>]) {
    let columns = 0..headers.len();
    let cell = |row: &[String], column: usize| row.get(column).cloned().unwrap_or_default();
    let width = |column: usize| {
        let cells = rows.iter().map(|row| cell(row, column).chars().count());
        cells.chain([headers[column].chars().count()]).max().unwrap_or(0)
    };
    let widths: Vec<usize> = columns.clone().map(width).collect();
    let numeric: Vec<bool> =
        columns.clone().map(|column| rows.iter().all(|row| is_number(&cell(row, column)))).collect();
    let mut put = |cells: Vec<String>| {
        let padded = cells.iter().zip(&widths).zip(&numeric).map(|((cell, &width), &numeric)| {
            if numeric { format!("{cell:>width$}") } else { format!("{cell:<width$}") }
        });
        put_line(text, depth, &padded.collect::<Vec<_>>().join("  "));
    };
    if headers.iter().any(|header| !header.is_empty()) {
        put(headers.iter().map(|&header| header.to_owned()).collect());
    }
    for row in rows {
        put(columns.clone().map(|column| cell(row, column)).collect());
    }
}

fn is_number(cell: &str) -> bool {
    cell.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '−' | '∞')) || cell == "none" || cell.is_empty()
}
