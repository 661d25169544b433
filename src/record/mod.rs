//! What a ray did, as plain data: events, the working behind their numbers, and who listens.
//!
//! This is the lowest layer. It knows numbers and text, and nothing of shapes, scenes or drawings. The types here
//! derive `Serialize` and `JsonSchema` because they *are* the exported trace format.

mod event;
mod recorder;
mod working;

pub use event::{
    Candidate, CandidateFate, Edge, Entry, Event, EventId, Operator, PlaneRow, PlaneSense, RayKind, Sense, Sign,
    SignSpan, Source, Span, Triple, What,
};
pub use recorder::{Counter, NullRecorder, Recorder};
pub use working::{Value, Working, format_number};
