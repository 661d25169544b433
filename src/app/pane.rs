//! Every panel of the workbench, in one list: menus, layouts, tests and the words for them follow it.

use serde::{Deserialize, Serialize};

/// A panel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Pane {
    /// The rendered picture, with the recorded pixel and its rays.
    Picture,
    /// The scene cut open along the ray.
    Side,
    /// The scene from anywhere, as lines.
    Overview,
    /// A primitive in its own space.
    Generic,
    /// The tree of events.
    Story,
    /// The selected event in full.
    Detail,
    /// Whatever can be drawn of the selected event.
    Along,
    /// The interval lists of a whole Boolean tree.
    Intervals,
    /// d(t) along the ray.
    Signs,
    /// Snell's law and Fresnel's equations.
    Snell,
    /// The terms that make up a colour.
    Shading,
    /// The plane table of a cube or polyhedron.
    Planes,
    /// Finding pixels by what happened to their rays.
    Search,
    /// Two traces or two pictures beside each other.
    Compare,
    /// The text of the scene file.
    Editor,
    /// The parameters of the selected object.
    Properties,
    /// What accuracy costs in time.
    Accuracy,
    /// What each effect costs.
    Effects,
    /// The course, and the lesson that is open.
    Lesson,
}

impl Pane {
    /// All panels, in the order of menus.
    pub const ALL: [Self; 19] = [
        Self::Picture,
        Self::Side,
        Self::Overview,
        Self::Generic,
        Self::Story,
        Self::Detail,
        Self::Along,
        Self::Intervals,
        Self::Signs,
        Self::Snell,
        Self::Shading,
        Self::Planes,
        Self::Search,
        Self::Compare,
        Self::Editor,
        Self::Properties,
        Self::Accuracy,
        Self::Effects,
        Self::Lesson,
    ];

    /// The name of its title in the catalogue of words; with `-about` behind it, that of what it shows.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Picture => "pane-picture",
            Self::Side => "pane-side",
            Self::Overview => "pane-overview",
            Self::Generic => "pane-generic",
            Self::Story => "pane-story",
            Self::Detail => "pane-detail",
            Self::Along => "pane-along",
            Self::Intervals => "pane-intervals",
            Self::Signs => "pane-signs",
            Self::Snell => "pane-snell",
            Self::Shading => "pane-shading",
            Self::Planes => "pane-planes",
            Self::Search => "pane-search",
            Self::Compare => "pane-compare",
            Self::Editor => "pane-editor",
            Self::Properties => "pane-properties",
            Self::Accuracy => "pane-accuracy",
            Self::Effects => "pane-effects",
            Self::Lesson => "pane-lesson",
        }
    }
}
