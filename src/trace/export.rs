//! The recorded trace as JSON, with a format name that changes when its meaning does.

use super::encoding::srgb;
use super::tree::RayTree;
use crate::record::{Event, Triple, What};
use schemars::generate::SchemaSettings;
use schemars::transform::RecursiveTransform;
use schemars::{JsonSchema, Schema};
use serde::Serialize;

/// The name and version of the format.
pub const TRACE_FORMAT: &str = "rayscope-trace/1";

/// A recorded trace as it is written.
#[derive(Debug, Serialize, JsonSchema)]
#[schemars(title = "rayscope trace", description = "Everything that one pixel's ray did, in order.")]
pub struct TraceFile<'a> {
    /// Always `rayscope-trace/1`.
    format: &'static str,
    /// The scene's name or file.
    scene: &'a str,
    /// The pixel [x, y], (0, 0) being the top left one; `null` for a ray that was given instead.
    pixel: Option<[u32; 2]>,
    /// Columns and rows of the image; `null` for a ray that was given instead.
    size: Option<[u32; 2]>,
    /// The linear RGB colour that the ray brought back.
    colour: Triple,
    /// The same colour as sRGB bytes.
    srgb: [u8; 3],
    /// The events, in the order in which they began; each names its parent.
    events: &'a [Event],
}

impl<'a> TraceFile<'a> {
    /// The file of a recorded tree.
    #[must_use]
    pub fn new(scene: &'a str, tree: &'a RayTree) -> Self {
        let (pixel, size) = match tree.events.first().map(|event| &event.what) {
            Some(What::Pixel { x, y, width, height }) => (Some([*x, *y]), Some([*width, *height])),
            _ => (None, None),
        };
        let colour = tree.colour();
        Self { format: TRACE_FORMAT, scene, pixel, size, colour, srgb: srgb(colour.into()), events: &tree.events }
    }
}

/// The JSON Schema of [`TraceFile`].
#[must_use]
pub fn trace_schema() -> Schema {
    // As it is written, not as it would be read: what is left out when empty is not required.
    SchemaSettings::draft2020_12()
        .for_serialize()
        .with_transform(RecursiveTransform(allow_null_for_numbers))
        .into_generator()
        .into_root_schema_for::<TraceFile<'_>>()
}

/// JSON has no infinity: a number that is not finite, as from a ray too long to be squared, is written as `null`.
fn allow_null_for_numbers(schema: &mut Schema) {
    if schema.get("type").is_some_and(|kind| kind == "number") {
        schema.insert("type".to_owned(), serde_json::json!(["number", "null"]));
    }
}
