//! The text of a scene while it is edited: its history, its words and its tree, what may be written where, changes that
//! leave everything else as it was, and the journal that a crash leaves behind.
//!
//! Nothing here knows windows or files. Places are those of the JSON, ranges are bytes of the text.

mod change;
mod completion;
mod context;
mod find;
mod flaws;
mod guide;
mod journal;
mod lines;
mod motion;
mod place;
mod sameness;
mod sheet;
mod structured;
mod syntax;
mod target;
mod template;
mod text;
mod tokens;
mod written;

pub use change::{Replacement, Selection, difference};
pub use completion::{Completion, Item, complete, names_for, value_at};
pub use context::{AtCursor, Context, context_at};
pub use find::{bracket_pair, find_all};
pub use flaws::{Flaw, flaws};
pub use guide::{Allowed, Guide};
pub use journal::{Journal, Recovered, Write};
pub use lines::{Line, compare_lines, with_context};
pub use motion::{Settings, across_view, along_axis, along_nearest_axis, decimals_for, depth, moved, rounded};
pub use place::{Place, Step};
pub use sameness::{changed_events, counterparts, same_event};
pub use sheet::{Control, Property, Range, Section, sheet};
pub use structured::Structure;
pub use syntax::{Node, NodeId, NodeKind, Syntax};
pub use target::{Target, TargetKind, object_and_leaf, object_at, place_of_leaf, target_at, targets};
pub use template::Template;
pub use text::{Cause, Document};
pub use tokens::{Token, TokenKind};
pub use written::{number_text, written};
