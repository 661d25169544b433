//! Arithmetic and equations: what every solver is written in and with.

mod alone;
mod double_double;
mod elementary;
mod lane_map;
mod pair;
pub mod portable;
mod precise;
mod precise_limbs;
mod precise_power;
mod quadratic;
mod range;
mod real;
mod root_between;
mod shadowed;
mod traced;
mod wide_map;

pub use alone::Alone;
pub use double_double::DoubleDouble;
pub use elementary::{exp, ln, power, sine_cosine, sine_cosine_of_eighth};
pub use lane_map::{LaneMap, Lanes, coordinates};
pub use pair::Pair;
pub use precise::Precise;
pub use quadratic::Quadratic;
pub use range::Range;
pub use real::{Real, cross, dot, scale_to_unit};
pub use root_between::root_between;
pub use shadowed::Shadowed;
pub use traced::{Traced, counted};
pub use wide_map::WideMap;
