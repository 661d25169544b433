//! The lines that a foreign ray tracer prints: one JSON object for each thing that it wants to have compared.

use crate::record::Triple;
use schemars::generate::SchemaSettings;
use schemars::{JsonSchema, Schema};

/// One line. Every member may be left out; which of them are there says what the line is about.
#[derive(Clone, Debug, Default, PartialEq, JsonSchema)]
#[schemars(
    title = "rayscope compare line",
    description = "One line of what a ray tracer says of a pixel, for `rayscope compare MINE.jsonl SCENE`. Every member may be left out."
)]
pub struct Line {
    /// Where the line stands in the file, from 1.
    #[schemars(skip)]
    pub number: usize,
    /// What is called otherwise than anything in the format, and what that is likely meant to be.
    #[schemars(skip)]
    pub unknown: Vec<String>,
    /// Begins the story of a pixel, [column, row]; (0, 0) is the top left one.
    pub pixel: Option<[u32; 2]>,
    /// Columns and rows of the picture, if not those of the scene.
    pub size: Option<[u32; 2]>,
    /// Begins a ray: `camera`, `reflected`, `refracted` or `shadow`. A camera ray without a pixel is a ray of its own.
    #[schemars(with = "Option<RayWord>")]
    pub ray: Option<RayWord>,
    /// Where the ray starts, in world space.
    pub origin: Option<Triple>,
    /// Where the ray goes, in world space; of any length, which is the unit of t.
    pub direction: Option<Triple>,
    /// How many rays it is away from the camera ray. Only needed where `colour` lines do not say when a ray ends.
    pub depth: Option<u32>,
    /// What was found out about one object of the scene, or, with `leaf`, about one primitive in it.
    pub object: Option<String>,
    /// The primitive, by its name; not needed where the object is made of one, or only one in the scene has this name.
    pub leaf: Option<String>,
    /// The ray's origin in the primitive's generic coordinates: S.
    pub generic_origin: Option<Triple>,
    /// The ray's direction in the primitive's generic coordinates: c.
    pub generic_direction: Option<Triple>,
    /// The hit times with the primitive, or with the whole object where `leaf` is left out. Those behind the ray's start may be left out.
    pub hits: Option<Vec<f64>>,
    /// The intervals inside the object; `null` for an end without bound. What lies behind the ray's start may be left out.
    pub inside: Option<Vec<[Option<f64>; 2]>>,
    /// The object that is hit first; `null` for none.
    #[schemars(with = "Option<String>")]
    pub hit: Option<Option<String>>,
    /// The hit time.
    pub t: Option<f64>,
    /// The hit point in world space.
    pub point: Option<Triple>,
    /// The unit normal that shading uses, on the side that the ray came from.
    pub normal: Option<Triple>,
    /// The unit normal out of the solid.
    pub outward: Option<Triple>,
    /// A light, by its name: what it does at the hit; on a shadow ray, the light that the ray is sent to.
    pub light: Option<String>,
    /// The unit vector towards the light.
    pub towards: Option<Triple>,
    /// Whether any of the light arrives.
    pub lit: Option<bool>,
    /// The object that stands before the light.
    pub blocked_by: Option<String>,
    /// The light's diffuse term; beside `colour`, that of all lights.
    pub diffuse: Option<Triple>,
    /// The light's specular term; beside `colour`, that of all lights.
    pub specular: Option<Triple>,
    /// The mirrored direction.
    pub reflected: Option<Triple>,
    /// The refracted direction; `null` where all light is reflected.
    #[schemars(with = "Option<Triple>")]
    pub refracted: Option<Option<Triple>>,
    /// The index of refraction on the side that the ray comes from.
    pub n1: Option<f64>,
    /// The index of refraction beyond.
    pub n2: Option<f64>,
    /// The linear RGB colour that the ray brings back. It ends the ray.
    pub colour: Option<Triple>,
    /// The ambient term of that colour.
    pub ambient: Option<Triple>,
    /// What the mirrored ray adds to that colour.
    pub mirrored: Option<Triple>,
    /// What the refracted ray adds to that colour.
    pub transmitted: Option<Triple>,
    /// The pixel as it is written, three sRGB bytes.
    pub written: Option<[u8; 3]>,
}

/// Why a ray was sent.
#[derive(Clone, Copy, Debug, PartialEq, Eq, JsonSchema)]
#[schemars(rename_all = "snake_case")]
pub enum RayWord {
    /// From the eye through a pixel.
    Camera,
    /// Mirrored at a surface.
    Reflected,
    /// Through a surface.
    Refracted,
    /// Towards a light.
    Shadow,
}

impl RayWord {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Camera, Self::Reflected, Self::Refracted, Self::Shadow];

    /// The word for it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Camera => "camera",
            Self::Reflected => "reflected",
            Self::Refracted => "refracted",
            Self::Shadow => "shadow",
        }
    }
}

/// The members of a line.
pub(super) const MEMBERS: [&str; 32] = [
    "pixel",
    "size",
    "ray",
    "origin",
    "direction",
    "depth",
    "object",
    "leaf",
    "generic_origin",
    "generic_direction",
    "hits",
    "inside",
    "hit",
    "t",
    "point",
    "normal",
    "outward",
    "light",
    "towards",
    "lit",
    "blocked_by",
    "diffuse",
    "specular",
    "reflected",
    "refracted",
    "n1",
    "n2",
    "colour",
    "ambient",
    "mirrored",
    "transmitted",
    "written",
];

/// The JSON Schema of one line.
#[must_use]
pub fn line_schema() -> Schema {
    SchemaSettings::draft2020_12().into_generator().into_root_schema_for::<Line>()
}
