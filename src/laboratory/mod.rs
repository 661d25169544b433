//! The accuracy laboratory: what accuracy costs in time.
//!
//! A **knob** trades accuracy for time: the arithmetic, the samples, the filter of images. A **setting** is one value of one knob, all
//! else being as the scene says. Each setting's picture is timed, in turn with all others, and compared with a **reference**
//! that has every knob at its best; so each is a **point**: error against seconds. Points that no other point beats in both
//! are the **frontier**.

mod answer;
mod bench;
mod combination;
mod errors;
mod frontier;
mod knob;
mod maps;
mod pair;
mod plan;
mod plot;
mod point;
mod proposal;
mod referee;
mod reference;
mod reference_file;
mod results;
mod stopwatch;
mod study;
mod subject;
mod this_ray;
mod timing;
mod whole;

pub use answer::{Answer, Goal};
pub use combination::{Base, Prediction, Step, predictions};
pub use errors::errors;
pub use frontier::{Standing, frontier};
pub use knob::{Knob, Setting};
pub use maps::{
    MapKind, TIMINGS, Times, digits_lost, digits_map, error_map, map_of_digits, map_of_times, tier_map, time_map,
    time_pixels,
};
pub use plan::{Earlier, Plan, Tools};
pub use plot::plot;
pub use point::{Errors, Noise, Point, Reference, Study, Timing};
pub use reference::{Sums, best_profile, is_random, reference_scene, what_is_true};
pub use reference_file::{NoStore, Store, checksum};
pub use stopwatch::{Stopwatch, Taken, pinned_work};
pub use study::{Run, study};
pub use subject::{narrowed, setting_named};
pub use this_ray::{
    Number, OutlineRow, Parting, Story, Target, ThisRay, Told, digits_right, this_ray, this_ray_text, time_methods,
};
pub use timing::Repeat;
