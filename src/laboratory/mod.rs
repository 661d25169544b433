//! The accuracy laboratory: what accuracy costs in time.
//!
//! A **knob** trades accuracy for time: the arithmetic, the samples, the filter of images. A **setting** is one value of one knob, all
//! else being as the scene says. Each setting's picture is timed, in turn with all others, and compared with a **reference**
//! that has every knob at its best; so each is a **point**: error against seconds. Points that no other point beats in both
//! are the **frontier**.

mod knob;
mod point;

pub use knob::{Knob, Setting};
pub use point::{Errors, Noise, Point, Reference, Study, Timing};
