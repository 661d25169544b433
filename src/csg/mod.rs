//! Compound objects: placed primitives, the Boolean tree over them, and the inside intervals of a ray.

mod combine;
mod extent;
mod interval_list;
mod placement;
mod report;
mod solid;

pub use extent::Extent;
pub use interval_list::{Boundary, Interval, IntervalList};
pub use placement::Placement;
pub use solid::{Leaf, Node, Solid};
