//! How right the solvers are: judged by hits that were computed with 40 digits, and followed into the distance and towards
//! tangents.

mod contender;
mod judge;
pub mod oracle;
mod random;
pub mod spawned;
mod stability;

pub use contender::Contender;
pub use judge::{Verdict, judge};
pub use random::Random;
pub use stability::{Row, SHAPES, stability};
