//! Events in words: the one-line row, the structured detail, and the tree as text.

mod detail;
mod explain;
mod format;
mod row;
mod tree;

pub use detail::{Detail, DetailLine, detail};
pub use format::{brief, brief_vector, span_list};
pub use row::{Row, row};
pub use tree::tree_text;
