//! Scene files and what they compile to.
//!
//! [`load`] takes text to a [`Scene`] or to *all* of its errors. After compiling, every default and reference is
//! resolved; nobody asks again.

mod check;
mod compile;
mod diagnostics;
mod embedded;
mod file;
mod lenient;
mod model;
mod object_index;
mod pictures;
mod problem;
mod projection;
mod rules;
mod sight;
mod solid_file;
mod solids;
mod source;
mod transform;

pub use compile::load;
pub use diagnostics::{Diagnostic, Diagnostics};
pub use embedded::{EmbeddedScene, embedded_scene, embedded_scenes};
pub use file::{
    Ambient, Background, CameraFile, Colour, ImageFile, LightFile, LimitsFile, MOST_PIXELS, MaterialFile, MediaFile,
    SceneFile, scene_schema,
};
pub use lenient::Lenient;
pub use model::{Camera, Image, Light, LightKind, Limits, Material, MediaPolicy, Object, Rgb, Scene, Shortcuts};
pub use object_index::ObjectIndex;
pub use pictures::{decode, decode_heights};
pub use projection::Projection;
pub use sight::{Candidate, LightSight, Sight, Sights};
pub use solid_file::{HalfSpaceFile, Scale, SolidFile, Transform};
pub use solids::compile_solid;
