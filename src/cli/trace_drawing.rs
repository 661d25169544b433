//! Which drawing of a recorded ray is written, and of which of its events.

use super::drawn::Theme;
use super::failure::Failure;
use crate::record::{EventId, What};
use crate::scene::Scene;
use crate::trace::RayTree;
use crate::view::{
    self, Drawing, GenericLook, GenericViewOptions, OverviewOptions, SectionPlane, SideViewOptions, Wireframe,
};
use clap::ValueEnum;

/// Drawings are this large, in points.
const SIZE: [f64; 2] = [960.0, 600.0];

/// A drawing of a recorded ray.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum TraceDrawing {
    /// The scene from the side, with the ray and all that it spawned
    Side,
    /// What the surface carries where the ray meets it: texels, noise, rings, bump, grain, environment
    Texture,
    /// The lens that the ray starts from, its plane of focus, and how far the hit is out of focus
    Lens,
    /// White light taken apart by wavelength
    Wavelengths,
    /// How light fades on a stretch inside a medium, and where it is turned
    Medium,
    /// By how much light is turned at a point of a medium
    Phase,
    /// The intervals that the ray has in the parts of a compound, and what they are combined to
    Intervals,
    /// Where the ray is outside and inside of the primitive that it meets
    Signs,
    /// The whole tree of a compound at once, each part with the intervals that the ray has in it
    Tree,
    /// The scene in space, with the camera, the lights and all rays
    Overview,
    /// The primitive that is met in its own space, with the transformed ray
    Generic,
    /// The table of planes of a cube or polyhedron, beside what each plane leaves of the ray
    Planes,
    /// Snell's law at the surface: the angles, and how much is reflected at each
    Snell,
    /// The five components of the colour that comes back
    Shading,
}

impl TraceDrawing {
    /// The drawing of what the tree's first ray met; for textures, of the first of its rays that met one, such as an
    /// environment in a mirror.
    ///
    /// # Errors
    /// If there is nothing of that kind to draw.
    pub fn drawn(self, scene: &Scene, tree: &RayTree, theme: Theme) -> Result<Drawing, Failure> {
        let end = ends(tree).next().unwrap_or(0);
        let event_plot = |is_it: &dyn Fn(&What) -> bool| {
            let event = first(tree, 0..tree.end(), is_it)?;
            view::event_plot(Some(scene), tree, event, SIZE, theme.into())
        };
        let (drawing, missing) = match self {
            Self::Side => (Some(side_view(scene, tree, theme)), ""),
            Self::Texture => (
                ends(tree).find_map(|end| view::event_plot(Some(scene), tree, end, SIZE, theme.into())),
                "the ray meets nothing that carries a texture, bump, grain, detail or environment",
            ),
            Self::Lens => (event_plot(&|what| matches!(what, What::Lens(_))), "the scene has no lens"),
            Self::Wavelengths => (
                event_plot(&|what| matches!(what, What::Wavelength(_))),
                "the ray meets nothing that takes light apart by wavelength",
            ),
            Self::Medium => (
                event_plot(&|what| matches!(what, What::Segment(_))),
                "the ray goes through no medium that takes light away",
            ),
            Self::Phase => (
                event_plot(&|what| matches!(what, What::Scatter(_))),
                "the ray goes through no medium that turns light",
            ),
            Self::Intervals => (
                view::interval_bars(tree, object_of(tree, end), SIZE, theme.into()),
                "what the ray meets there is no compound, so that no intervals were combined",
            ),
            Self::Signs => (
                view::sign_plot(tree, primitive_of(tree, end), SIZE, theme.into()),
                "no primitive was asked where the ray is inside of it",
            ),
            Self::Tree => {
                (view::csg_bars(scene, tree, object_of(tree, end), None, SIZE, theme.into()), "the ray meets no object")
            }
            Self::Overview => (overview(scene, tree, theme), ""),
            Self::Generic => (generic(scene, tree, primitive_of(tree, end), theme), "no primitive was asked"),
            Self::Planes => (
                view::plane_table(tree, primitive_of(tree, end), None, SIZE, theme.into()).map(|table| table.drawing),
                "what the ray meets is not made of planes",
            ),
            Self::Snell => (
                (0..tree.end()).find_map(|event| match tree.event(event).what {
                    What::Snell { .. } => view::snell_diagram(tree, event, SIZE, theme.into()),
                    _ => None,
                }),
                "the ray meets no surface between two transparent media",
            ),
            Self::Shading => (view::shading_bars(tree, end, SIZE, theme.into()), "the ray brings no colour back"),
        };
        drawing.ok_or_else(|| {
            Failure::refused(format!("there is nothing to draw: {missing}; try another --pixel, or --drawing side"))
        })
    }
}

/// The side view with everything that happened up to the last event.
fn side_view(scene: &Scene, tree: &RayTree, theme: Theme) -> Drawing {
    let options = SideViewOptions {
        size: SIZE,
        theme: theme.into(),
        plane: SectionPlane::RayAndUp,
        zoom: 1.0,
        pan: [0.0, 0.0],
        probe_t: None,
    };
    view::side_view(scene, tree, tree.end().saturating_sub(1), &options)
}

fn overview(scene: &Scene, tree: &RayTree, theme: Theme) -> Option<Drawing> {
    let options = OverviewOptions { size: SIZE, theme: theme.into(), ..OverviewOptions::default() };
    view::overview(scene, &Wireframe::of(scene), tree, tree.end().saturating_sub(1), &options)
}

fn generic(scene: &Scene, tree: &RayTree, event: EventId, theme: Theme) -> Option<Drawing> {
    let options = GenericViewOptions { size: SIZE, theme: theme.into(), look: GenericLook::Section, probe_t: None };
    view::generic_view(scene, tree, event, &options)
}

/// The events that end rays, the camera ray's first: a hit, or that the ray met nothing.
fn ends(tree: &RayTree) -> impl Iterator<Item = EventId> + '_ {
    (0..tree.end()).filter(|&id| matches!(tree.event(id).what, What::Hit { .. } | What::Nothing { .. }))
}

/// The search for hits with the object that was met; the whole tree where none was.
fn object_of(tree: &RayTree, end: EventId) -> EventId {
    let What::Hit { object, .. } = &tree.event(end).what else { return 0 };
    first(tree, 0..end, |what| matches!(what, What::Object { name, .. } if name == object)).unwrap_or(end)
}

/// The primitive that was met; the object where it has none to show.
fn primitive_of(tree: &RayTree, end: EventId) -> EventId {
    let above = object_of(tree, end);
    let What::Hit { leaf, .. } = &tree.event(end).what else { return above };
    let below = above..tree.subtree_end(above);
    first(tree, below, |what| matches!(what, What::Primitive { name, .. } if name == leaf)).unwrap_or(above)
}

fn first(tree: &RayTree, mut among: std::ops::Range<EventId>, is_it: impl Fn(&What) -> bool) -> Option<EventId> {
    among.find(|&id| is_it(&tree.event(id).what))
}
