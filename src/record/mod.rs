//! What a ray did, as plain data: events, the working behind their numbers, and who listens.
//!
//! This is the lowest layer. It knows numbers and text, and nothing of shapes, scenes or drawings. The types here
//! derive `Serialize` and `JsonSchema` because they *are* the exported trace format.

mod camera;
mod effect;
mod event;
#[cfg(test)]
mod kept;
mod medium;
mod numbers;
mod parts;
mod quantity;
mod recorder;
mod spectrum;
mod surface;
mod what;
mod working;

pub use camera::{Average, Confusion, Lens, LightSample, Sample};
pub use effect::Effect;
pub use event::{Entry, Event, EventId, Source, Triple};
#[cfg(test)]
pub use kept::Kept;
pub use medium::{Overlap, Passage, Phase, Scatter, Segment};
pub use numbers::{Binding, Numbers};
pub use parts::{
    Candidate, CandidateFate, Certificate, Edge, Operator, PlaneRow, PlaneSense, RayKind, Sense, Sign, SignSpan, Span,
    Tier,
};
pub use quantity::Quantity;
pub use recorder::{Counter, NullRecorder, Recorder};
pub use spectrum::{Conductor, Wavelength};
pub use surface::{
    Bump, Detail, Environment, FrameMap, Lattice, LatticeCorner, Mapping, Octave, Octaves, Rings, Stop, TexelShare,
    Texels, Texture, Undulate,
};
pub use what::What;
pub use working::{Accuracy, Measured, Outcome, Value, Working, format_number};
