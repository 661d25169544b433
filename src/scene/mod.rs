//! Scene files and what they compile to.
//!
//! [`load`] takes text to a [`Scene`] or to *all* of its errors. After compiling, every default and reference is
//! resolved; nobody asks again.

mod check;
mod compile;
mod diagnostics;
mod embedded;
mod file;
mod model;
mod solid_file;
mod source;

pub use compile::{compile_solid, load};
pub use diagnostics::{Diagnostic, Diagnostics};
pub use embedded::{EmbeddedScene, embedded_scene, embedded_scenes};
pub use file::{SceneFile, scene_schema};
pub use model::{Camera, Image, Light, LightKind, Limits, Material, MediaPolicy, Object, Rgb, Scene};
pub use solid_file::{SolidFile, Transform};
