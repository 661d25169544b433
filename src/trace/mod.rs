//! Tracing: the six steps of § 6.1, shading, spawned rays, whole pictures, and the tree of a recorded pixel.
#![expect(
    clippy::inline_always,
    reason = "what every ray runs stays in one piece, as it would be without the effects that call the same functions"
)]

mod allotment;
mod area_light;
mod beam;
mod calls;
mod closest;
mod departure;
mod digest;
mod division;
mod encoding;
mod export;
mod finish;
mod highlight;
mod leaving;
mod lens;
mod light;
mod media;
mod nearest;
mod one_thread;
mod overlap;
mod path;
mod picture;
mod pixel;
mod ray;
mod samples;
mod scanning;
mod scatter;
mod segment;
mod shadow;
mod spawn;
mod tally;
mod tree;

pub use beam::Beam;
pub use calls::{Every, Opaque, Repertoire};
pub use closest::Surface;
pub use departure::{Ahead, Departure};
pub use digest::digests;
pub use encoding::srgb;
pub use export::{TRACE_FORMAT, TraceFile, trace_schema};
pub use one_thread::OneThread;
pub use overlap::{Overlap, Overlaps};
pub use picture::{FIRST_BLOCK, Picture, Progress, Share, render, render_rows, render_share};
pub use pixel::{record_pixel, record_ray, trace_pixel, trace_pixel_with, trace_ray};
pub use ray::{Ray, Tracer};
pub use scanning::Scanning;
pub use tally::Tally;
pub use tree::{RayTree, TreeRecorder};
