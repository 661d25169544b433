//! What stands in brackets, and in rows and columns, in words.

use super::symbols::word;
use super::{node_words, of, tidied};
use ratex_parser::ParseNode;

/// What stands between a pair of brackets that grow with it.
pub fn delimited(body: &[ParseNode], left: &str, right: &str) -> String {
    if let [ParseNode::Array { body: rows, .. }] = body {
        return table(rows, left, right);
    }
    let inside = of(body);
    match (left, right) {
        ("|" | "\\vert" | "\\lvert", "|" | "\\vert" | "\\rvert") => format!("the absolute value of ({inside})"),
        ("\\|" | "\\Vert" | "\\lVert", "\\|" | "\\Vert" | "\\rVert") => format!("the norm of ({inside})"),
        _ => tidied(&[bracket(left).to_owned(), inside, bracket(right).to_owned()]),
    }
}

/// A full stop stands for no bracket at all.
fn bracket(sign: &str) -> &str {
    if sign == "." { "" } else { word(sign) }
}

fn table(rows: &[Vec<ParseNode>], left: &str, right: &str) -> String {
    let cells = |row: &Vec<ParseNode>| row.iter().map(node_words).collect::<Vec<_>>().join(", ");
    let is_vector = rows.len() == 1 || rows.iter().all(|row| row.len() == 1);
    let said: Vec<String> = rows.iter().map(cells).filter(|row| !row.is_empty()).collect();
    match (left, right) {
        (_, ".") => format!("either {}", said.join("; or ")),
        ("|" | "\\vert", _) => format!("the determinant of the matrix with rows {}", said.join("; ")),
        _ if is_vector => format!("the vector ({})", said.join(", ")),
        _ => format!("the matrix with rows {}", said.join("; ")),
    }
}

/// Rows without brackets: lines of a calculation below each other, or a table.
pub fn rows(node: &ParseNode) -> String {
    let ParseNode::Array { body, col_separation_type, .. } = node else { return String::new() };
    let between = if col_separation_type.is_some() { " " } else { ", " };
    let row = |row: &Vec<ParseNode>| {
        let cells: Vec<String> = row.iter().map(node_words).filter(|cell| !cell.is_empty()).collect();
        cells.join(between)
    };
    let rows: Vec<String> = body.iter().map(row).filter(|row| !row.is_empty()).collect();
    rows.join("; ")
}
