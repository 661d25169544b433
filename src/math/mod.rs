//! Arithmetic and equations: what every solver is written in and with.

mod double_double;
mod polynomial;
mod quadratic;
mod range;
mod real;

pub use double_double::DoubleDouble;
pub use polynomial::{Quartic, Separators, evaluate, root_between};
pub use quadratic::Quadratic;
pub use range::Range;
pub use real::{Real, dot, scale_to_unit};
