//! Scene files and what they compile to.
//!
//! [`load`] takes text to a [`Scene`] or to *all* of its errors. After compiling, every default and reference is
//! resolved; nobody asks again.

mod around_file;
mod camera;
mod camera_file;
mod camera_reader;
mod check;
mod coat;
mod coat_reader;
mod compile;
mod detail;
mod diagnostics;
mod effects;
mod embedded;
mod file;
mod files;
mod glass_file;
mod glass_reader;
mod lenient;
mod light;
mod light_file;
mod light_reader;
mod model;
mod object_index;
mod origin;
mod pictures;
mod problem;
mod profile;
mod profile_file;
mod projection;
mod reading;
mod relief_file;
mod relief_reader;
mod rules;
mod sight;
mod solid_file;
mod solid_texture_reader;
mod solids;
mod source;
mod texture_file;
mod transform;

pub use around_file::{DetailFile, EnvironmentFile, EnvironmentFilterFile, LayoutFile};
pub use camera::{Adaptive, Camera, Image, Lens, Sampling};
pub use camera_file::{AdaptiveFile, ApertureFile, CameraFile, LensFile, PixelFilterFile, SamplingFile};
pub use coat::{Bumps, Coat, GrainCoat, LeafCoat, MovingTexture, Texture, mapped_part};
pub use compile::{load, load_with};
pub use detail::Detail;
pub use diagnostics::{Diagnostic, Diagnostics};
pub use effects::{Effects, Reason, reasons};
pub use embedded::{EmbeddedScene, embedded_scene, embedded_scenes};
pub use file::{
    Ambient, Background, Colour, ImageFile, LimitsFile, MOST_PIXELS, MaterialFile, MediaFile, MirrorsFile, SceneFile,
    scene_schema,
};
pub use files::{EmbeddedFiles, Files};
pub use glass_file::{DispersionFile, FresnelFile, GlassFile, MediumFile, MetalFile};
pub use lenient::Lenient;
pub use light::{Area, Light, LightKind};
pub use light_file::{AreaFile, LightFile};
pub use model::{Limits, Material, MediaPolicy, Object, Rgb, Scene, SceneEnvironment, Shortcuts, Split};
pub use object_index::ObjectIndex;
pub use origin::{Origin, Recipe};
pub use pictures::{decode, decode_heights};
pub use profile::Profile;
pub use profile_file::{
    ArithmeticFile, BumpTermsFile, ProfileFile, RootsFile, SearchFile, SearchWord, ShortcutFile, profile_schema,
};
pub use projection::{Glance, Projection, View};
pub use relief_file::{BumpFile, FrameFile};
pub use sight::{Candidate, LightSight, Sight, Sights};
pub use solid_file::{HalfSpaceFile, Scale, SolidFile, Transform};
pub use solids::compile_solid;
pub use texture_file::{FilterFile, MapFile, NoiseFile, StopFile, TextureFile, TurbulenceFile, WarpFile, WrapFile};
