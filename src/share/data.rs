//! A recorded ray as data.

use crate::trace::{RayTree, TraceFile};

/// The trace as JSON, as `rayscope trace --format json` writes it.
///
/// # Errors
/// If it cannot be written as JSON, which no recorded trace is known to cause.
pub fn trace_json(scene: &str, tree: &RayTree) -> Result<String, String> {
    serde_json::to_string(&TraceFile::new(scene, tree)).map(|text| text + "\n").map_err(|error| error.to_string())
}
