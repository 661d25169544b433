//! Questions with names: where a person may want to stop.

/// A question with a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Preset {
    /// A name for programs, of letters and hyphens.
    pub key: &'static str,
    /// What is found.
    pub title: &'static str,
    /// The question.
    pub query: &'static str,
}

impl Preset {
    /// The message of the catalogue that says the title in the language that is set.
    #[must_use]
    pub fn word(&self) -> String {
        format!("asked-{}", self.key)
    }
}

/// The questions that are offered by name.
pub const PRESETS: [Preset; 12] = [
    Preset { key: "tir", title: "A total internal reflection", query: "tir" },
    Preset { key: "deep", title: "A ray at depth 3 or more", query: "ray & depth>=3" },
    Preset { key: "early-out", title: "An early out in a Boolean tree", query: "csg.early_out" },
    Preset { key: "rejected", title: "A hit that is rejected", query: "rejected | candidate.rejected" },
    Preset { key: "undecidable", title: "A decision that the ray's own numbers do not allow", query: "undecidable" },
    Preset { key: "fallback", title: "A decision that needed finer arithmetic", query: "fallback" },
    Preset { key: "shadowed", title: "A light that is hidden", query: "shadowed" },
    Preset { key: "limit", title: "A ray that a limit stops", query: "limit" },
    Preset { key: "extent", title: "An extent that spares the work behind it", query: "extent.missed" },
    Preset { key: "spawned", title: "A reflected or refracted ray", query: "reflected | refracted" },
    Preset { key: "background", title: "A ray that hits nothing", query: "nothing" },
    Preset { key: "grazing", title: "Light that grazes a surface", query: "theta1>=80" },
];
