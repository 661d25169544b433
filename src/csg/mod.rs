//! Compound objects: placed primitives, the Boolean tree over them, and the inside intervals of a ray.

mod combine;
mod course;
mod extent;
mod hierarchy;
mod interval_list;
mod placement;
mod report;
mod solid;

pub use course::Course;
pub use extent::Extent;
pub use hierarchy::Hierarchy;
pub use interval_list::{Boundaries, Boundary, Interval, IntervalList};
pub use placement::Placement;
pub use solid::{Leaf, Node, Solid};
