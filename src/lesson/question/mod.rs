//! Questions, posed about a recorded ray and judged by it.

mod judge;
mod lists;
mod pose;

pub use judge::{Answer, Verdict};
pub use lists::{list_text, offered_lists};
pub use pose::{Form, Posed, PosedChoice, PosedEdit, Reckoned, Spot, Stretch};
