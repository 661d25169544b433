//! Solids in scene files and probe requests: the types that their JSON Schema is generated from, and the parameters.
//!
//! The primitives come from the one list, [`for_each_shape!`](crate::for_each_shape).

use super::around_file::DetailFile;
use super::lenient::Lenient;
use crate::for_each_shape;
use crate::shape::HalfSpace;
use glam::DVec3;
use schemars::JsonSchema;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

/// A type of parameter in the list of shapes: how it is written in files.
pub trait Parameter: Sized {
    /// What stands in the file.
    type File: DeserializeOwned + JsonSchema;

    /// Takes over what stands in the file.
    fn from_file(file: Self::File) -> Self;
}

impl Parameter for f64 {
    type File = Self;

    fn from_file(file: Self) -> Self {
        file
    }
}

/// A plane n·p = d with its inside, n·p ≤ d.
#[derive(Clone, Copy, Debug, Deserialize, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct HalfSpaceFile {
    /// n, pointing outwards; it need not be unit.
    pub normal: [f64; 3],
    /// d.
    pub offset: f64,
}

impl Parameter for Vec<HalfSpace> {
    type File = Vec<HalfSpaceFile>;

    fn from_file(file: Self::File) -> Self {
        file.into_iter()
            .map(|plane| HalfSpace { normal: DVec3::from_array(plane.normal), offset: plane.offset })
            .collect()
    }
}

/// A step of a transform.
#[derive(Clone, Copy, Debug, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
#[schemars(deny_unknown_fields)]
pub enum Transform {
    /// Scales about the origin; no factor is 0.
    Scale(Scale),
    /// Turns about an axis through the origin, counterclockwise as seen from the tip of the axis.
    Rotate {
        /// The axis, of any length but 0.
        axis: [f64; 3],
        /// The angle in degrees.
        degrees: f64,
    },
    /// Moves.
    Translate([f64; 3]),
    /// Any affine map from object to world, by rows; not singular.
    Matrix([[f64; 4]; 3]),
}

/// The factors of a scaling.
#[derive(Clone, Copy, Debug, Deserialize, Serialize, JsonSchema)]
#[serde(untagged)]
#[schemars(inline)]
pub enum Scale {
    /// The same along all axes.
    Uniform(f64),
    /// Along x, y and z.
    PerAxis([f64; 3]),
}

/// What every solid may have besides its shape.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Common {
    pub name: Lenient<String>,
    pub material: Lenient<String>,
    pub priority: Option<Lenient<i32>>,
    pub transform: Lenient<Vec<Lenient<Transform>>>,
    pub details: Lenient<Vec<Lenient<DetailFile>>>,
}

macro_rules! solid_variants {
    ($($variant:ident $about:literal { $($(#[$attribute:meta])* $parameter:ident : $type:ty,)* })*) => {
        /// A primitive, a compound of solids, or a copy of a named solid.
        #[derive(JsonSchema)]
        #[schemars(tag = "shape", rename_all = "snake_case", deny_unknown_fields)]
        pub enum SolidFile {
            $(
                #[doc = $about]
                $variant {
                    $($(#[$attribute])* $parameter: $type,)*
                    /// Its name in the trace.
                    #[schemars(default, skip_serializing_if = "String::is_empty")]
                    name: String,
                    /// The name of its material; parts without one take that of the solid around them.
                    #[schemars(default, skip_serializing_if = "String::is_empty")]
                    material: String,
                    /// On an object only: the higher one wins where transparent objects overlap, if `media` is `priority`.
                    #[schemars(default)]
                    priority: i32,
                    /// The steps that take it from its generic pose to its place, in the order in which they are applied.
                    #[schemars(default)]
                    transform: Vec<Transform>,
                    /// Polygons on its flat parts, with materials of their own; the last one lies on top.
                    #[schemars(default)]
                    details: Vec<DetailFile>,
                },
            )*
        }
    };
}

macro_rules! define_solid_file {
    ($($variant:ident $name:literal $about:literal { $($parameter:ident : $type:ty = $doc:literal,)* })*) => {
        solid_variants! {
            $($variant $about { $(#[doc = $doc] $parameter: <$type as Parameter>::File,)* })*
            Union "All points that are in one of the solids or more." {
                /// The solids, one or more.
                #[schemars(length(min = 1))]
                of: Vec<SolidFile>,
            }
            Intersection "The points that are in all of the solids." {
                /// The solids, one or more.
                #[schemars(length(min = 1))]
                of: Vec<SolidFile>,
            }
            Difference "The points of the first solid that are in none of the others." {
                /// The solids, one or more.
                #[schemars(length(min = 1))]
                of: Vec<SolidFile>,
            }
            Copy "A copy of one of the file's `solids`." {
                /// The name of the solid.
                solid: String,
            }
        }
    };
}

for_each_shape!(define_solid_file);
