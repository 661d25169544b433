//! Questions, posed about a recorded ray and judged by it.

mod judge;
mod pose;

pub use judge::{Answer, Verdict};
pub use pose::{Form, Posed, PosedChoice, PosedEdit, Reckoned, Spot, Stretch};
