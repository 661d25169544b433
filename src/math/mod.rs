//! Arithmetic and equations: what every solver is written in and with.

mod alone;
mod double_double;
mod elementary;
mod polynomial;
mod quadratic;
mod range;
mod real;
mod traced;
mod wide_map;

pub use alone::Alone;
pub use double_double::DoubleDouble;
pub use elementary::{exp, ln};
pub use polynomial::{Quartic, Separators, evaluate, root_between};
pub use quadratic::Quadratic;
pub use range::Range;
pub use real::{Real, cross, dot, scale_to_unit};
pub use traced::{Traced, counted};
pub use wide_map::WideMap;
