//! Tables on paper: columns as wide as what is in them, all smaller where the page is too narrow.

use super::flow::{Flow, Look, WIDTH};
use super::line::{Piece, glued};
use crate::lesson::Told;
use crate::lesson::prose::Line;

/// The room between columns, in sizes of the text.
const BETWEEN: f64 = 1.6;

/// Smaller letters cannot be read.
const SMALLEST: f64 = 5.0;

impl Flow {
    /// A table.
    pub fn table(&mut self, head: &[Line<Told>], rows: &[Vec<Line<Told>>], indent: f64) {
        let look = |size: f64| Look { size, after: 0.0, ..Look::TEXT };
        let cells = |row: &[Line<Told>]| -> Vec<Vec<Piece>> {
            row.iter().map(|cell| glued(cell, look(9.0)).concat()).collect()
        };
        let head = cells(head);
        let rows: Vec<Vec<Vec<Piece>>> = rows.iter().map(|row| cells(row)).collect();
        let columns = rows.iter().map(Vec::len).chain([head.len()]).max().unwrap_or(0);
        let widths = |size: f64| -> Vec<f64> {
            let wide = |row: &Vec<Vec<Piece>>, column: usize| {
                row.get(column).map_or(0.0, |cell| cell.iter().map(|piece| piece.width(size)).sum::<f64>())
            };
            let widest = |column| rows.iter().chain([&head]).map(|row| wide(row, column)).fold(0.0, f64::max);
            (0..columns).map(|column| widest(column) + BETWEEN * size).collect()
        };
        let whole: f64 = widths(9.0).iter().sum();
        let size = (9.0 * ((WIDTH - indent) / whole.max(1.0)).min(1.0)).max(SMALLEST);
        let widths = widths(size);
        let placed = |row: &[Vec<Piece>]| -> Vec<(f64, Vec<Piece>)> {
            let starts = widths.iter().scan(indent, |x, width| Some(std::mem::replace(x, *x + width)));
            starts.zip(row.iter().cloned()).collect()
        };
        let right = indent + widths.iter().sum::<f64>();
        self.gap(3.0);
        self.cells(&placed(&head), look(size));
        self.rule(indent, right);
        for row in &rows {
            self.cells(&placed(row), look(size));
        }
        self.gap(7.0);
    }
}
