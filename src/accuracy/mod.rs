//! How right the solvers are: judged by hits that were computed with 40 digits, and followed into the distance and towards
//! tangents.

mod experiment;
mod hits;
mod judge;
pub mod oracle;
mod plot;
mod random;
pub mod spawned;
mod stability;
mod subject;

pub use experiment::{Place, Question, experiment};
pub use judge::{Verdict, judge};
pub use plot::plot;
pub use random::Random;
pub use stability::{Row, SHAPES, stability};
pub use subject::{Subject, subject};
