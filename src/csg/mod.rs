//! Compound objects: placed primitives, the Boolean tree over them, and the inside intervals of a ray.

mod ball;
mod combine;
mod course;
mod extent;
mod hierarchy;
mod interval_list;
mod node;
mod placement;
mod query;
mod report;
mod solid;
mod wide_union;

pub use ball::Ball;
pub use course::Course;
pub use extent::Extent;
pub use hierarchy::Hierarchy;
pub use interval_list::{Boundaries, Boundary, Interval, IntervalList};
pub use node::{Enclosure, Leaf, Node};
pub use placement::Placement;
pub use solid::Solid;
pub use wide_union::WideUnion;
