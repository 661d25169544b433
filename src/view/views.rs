//! Every drawing of a recorded ray, once: the command line, the workbench, slides and worked examples all take them from
//! this list.

use super::csg_bars::csg_bars;
use super::drawing::Drawing;
use super::event_plot::event_plot;
use super::generic_view::{GenericLook, GenericViewOptions, generic_view};
use super::interval_bars::interval_bars;
use super::overview::{OverviewOptions, overview};
use super::palette::Theme;
use super::plane_table::plane_table;
use super::shading_bars::shading_bars;
use super::side_view::{SideViewOptions, side_view};
use super::sign_plot::sign_plot;
use super::snell_diagram::snell_diagram;
use super::wireframe::Wireframe;
use crate::record::{EventId, What};
use crate::scene::Scene;
use crate::trace::RayTree;

/// What is drawn, and how.
#[derive(Clone, Copy)]
pub struct Subject<'a> {
    /// The scene that the ray was recorded in.
    pub scene: &'a Scene,
    /// The recorded ray.
    pub tree: &'a RayTree,
    /// The event that the drawing is about.
    pub event: EventId,
    /// Width and height in points.
    pub size: [f64; 2],
    /// Light or dark.
    pub theme: Theme,
}

/// A kind of drawing.
#[derive(Clone, Copy, Debug)]
pub struct View {
    /// The word that asks for it.
    pub name: &'static str,
    /// What it shows, for a list of choices.
    pub about: &'static str,
    /// Why there may be none of a ray: `there is nothing to draw: …`.
    pub missing: &'static str,
    /// The events that it may be about when none is named, the most telling first.
    telling: fn(&RayTree) -> Vec<EventId>,
    draw: fn(&Subject) -> Option<Drawing>,
}

/// All views, in the order in which lists offer them.
pub static ALL_VIEWS: &[View] = &[
    View {
        name: "side",
        about: "The scene from the side, with the ray and all that it spawned",
        missing: "nothing was recorded",
        telling: |tree| vec![tree.end().saturating_sub(1)],
        draw: |subject| {
            let options = SideViewOptions { size: subject.size, theme: subject.theme, ..SideViewOptions::default() };
            Some(side_view(subject.scene, subject.tree, subject.event, &options))
        },
    },
    View {
        name: "intervals",
        about: "The intervals that the ray has in the parts of a compound, and what they are combined to",
        missing: "what the ray meets there is no compound, so that no intervals were combined",
        telling: searches,
        draw: |subject| {
            let event = search_behind(subject.tree, subject.event);
            interval_bars(subject.tree, event, subject.size, subject.theme)
        },
    },
    View {
        name: "signs",
        about: "Where the ray is outside and inside of the primitive that it meets",
        missing: "no primitive was asked where the ray is inside of it",
        telling: searches,
        draw: |subject| {
            let event = primitive_behind(subject.tree, subject.event);
            sign_plot(subject.tree, event, subject.size, subject.theme)
        },
    },
    View {
        name: "csg",
        about: "The intervals of every part of a compound at once, as the tree that combines them",
        missing: "the ray meets no object whose parts could be listed",
        telling: searches,
        draw: |subject| {
            let event = search_behind(subject.tree, subject.event);
            csg_bars(subject.scene, subject.tree, event, None, subject.size, subject.theme)
        },
    },
    View {
        name: "generic",
        about: "The primitive that the ray meets in its own space, with the ray transformed into it",
        missing: "the ray comes to no primitive",
        telling: searches,
        draw: |subject| {
            let (size, theme) = (subject.size, subject.theme);
            let options = GenericViewOptions { size, theme, look: GenericLook::default(), probe_t: None };
            generic_view(subject.scene, subject.tree, primitive_behind(subject.tree, subject.event), &options)
        },
    },
    View {
        name: "overview",
        about: "The scene in space as lines, with the camera, the lights and all rays",
        missing: "nothing was recorded",
        telling: |tree| vec![tree.end().saturating_sub(1)],
        draw: |subject| {
            let options = OverviewOptions { size: subject.size, theme: subject.theme, ..OverviewOptions::default() };
            overview(subject.scene, &Wireframe::of(subject.scene), subject.tree, subject.event, &options)
        },
    },
    View {
        name: "snell",
        about: "Snell's law at an interface: angles, critical angle, and how much is reflected",
        missing: "the ray meets no surface between two transparent media",
        telling: |tree| first(tree, |what| matches!(what, What::Snell { .. })),
        draw: |subject| snell_diagram(subject.tree, subject.event, subject.size, subject.theme),
    },
    View {
        name: "shading",
        about: "The five terms that make up a colour, and the lights that they come from",
        missing: "no colour was worked out from the terms of shading",
        telling: searches,
        draw: |subject| shading_bars(subject.tree, subject.event, subject.size, subject.theme),
    },
    View {
        name: "planes",
        about: "The plane table of a cube or polyhedron, and how its slabs narrow the ray",
        missing: "what the ray meets is not made of planes",
        telling: searches,
        draw: |subject| {
            plane_table(subject.tree, primitive_behind(subject.tree, subject.event), None, subject.size, subject.theme)
                .map(|table| table.drawing)
        },
    },
    View {
        name: "event",
        about: "What happened at an event: a texture, bump, lens, wavelength or medium",
        missing: "the ray meets nothing of which there is a drawing besides the scene's",
        telling: |tree| (0..tree.end()).collect(),
        draw: what_happened,
    },
    View {
        name: "texture",
        about: "What the surface carries where the ray meets it: texels, noise, rings, bump, grain, environment",
        missing: "the ray meets nothing that carries a texture, bump, grain, detail or environment",
        telling: |tree| ends(tree).collect(),
        draw: what_happened,
    },
    View {
        name: "lens",
        about: "The lens that the ray starts from, its plane of focus, and how far the hit is out of focus",
        missing: "the scene has no lens",
        telling: |tree| first(tree, |what| matches!(what, What::Lens(_))),
        draw: what_happened,
    },
    View {
        name: "wavelengths",
        about: "White light taken apart by wavelength",
        missing: "the ray meets nothing that takes light apart by wavelength",
        telling: |tree| first(tree, |what| matches!(what, What::Wavelength(_))),
        draw: what_happened,
    },
    View {
        name: "medium",
        about: "How light fades on a stretch inside a medium, and where it is turned",
        missing: "the ray goes through no medium that takes light away",
        telling: |tree| first(tree, |what| matches!(what, What::Segment(_))),
        draw: what_happened,
    },
    View {
        name: "phase",
        about: "By how much light is turned at a point of a medium",
        missing: "the ray goes through no medium that turns light",
        telling: |tree| first(tree, |what| matches!(what, What::Scatter(_))),
        draw: what_happened,
    },
];

impl View {
    /// The view of that name.
    #[must_use]
    pub fn named(name: &str) -> Option<&'static Self> {
        ALL_VIEWS.iter().find(|view| view.name == name)
    }

    /// The drawing of the subject's event; of a hit, that of the search which found it. None if there is nothing of that
    /// kind to draw.
    #[must_use]
    pub fn draw(&self, subject: &Subject) -> Option<Drawing> {
        (subject.event < subject.tree.end()).then(|| (self.draw)(subject)).flatten()
    }

    /// The drawing of whatever tells most; the subject's own event does not matter. None if there is nothing of that kind
    /// to draw.
    #[must_use]
    pub fn draw_telling(&self, subject: &Subject) -> Option<Drawing> {
        (self.telling)(subject.tree).into_iter().find_map(|event| self.draw(&Subject { event, ..*subject }))
    }
}

fn what_happened(subject: &Subject) -> Option<Drawing> {
    event_plot(Some(subject.scene), subject.tree, subject.event, subject.size, subject.theme)
}

/// The events that end rays, the camera ray's first: a hit, or that the ray met nothing.
fn ends(tree: &RayTree) -> impl Iterator<Item = EventId> + '_ {
    (0..tree.end()).filter(|&id| matches!(tree.event(id).what, What::Hit { .. } | What::Nothing { .. }))
}

/// What the first ray met; the whole tree where it met nothing.
fn searches(tree: &RayTree) -> Vec<EventId> {
    let met = ends(tree).next().filter(|&id| matches!(tree.event(id).what, What::Hit { .. }));
    vec![met.unwrap_or(0)]
}

fn first(tree: &RayTree, is_it: fn(&What) -> bool) -> Vec<EventId> {
    (0..tree.end()).find(|&id| is_it(&tree.event(id).what)).into_iter().collect()
}

/// Of a hit, or of one that was turned down: the search that found it. Of anything else itself.
#[must_use]
pub fn search_behind(tree: &RayTree, event: EventId) -> EventId {
    let (What::Hit { object, .. } | What::Rejected { object, .. }) = &tree.event(event).what else { return event };
    let is_search = |id: &EventId| matches!(&tree.event(*id).what, What::Object { name, .. } if name == object);
    (0..event).rev().find(is_search).unwrap_or(event)
}

/// Of a hit, or of one that was turned down: the primitive that was hit, as the search for it came upon it. Of anything else
/// itself.
#[must_use]
pub fn primitive_behind(tree: &RayTree, event: EventId) -> EventId {
    let (What::Hit { leaf, .. } | What::Rejected { leaf, .. }) = &tree.event(event).what else { return event };
    let search = search_behind(tree, event);
    let is_leaf = |id: &EventId| matches!(&tree.event(*id).what, What::Primitive { name, .. } if name == leaf);
    (search..tree.subtree_end(search)).find(is_leaf).unwrap_or(search)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{embedded_scene, load};
    use crate::trace::record_pixel;
    use std::collections::BTreeSet;

    fn recorded(name: &str) -> (Scene, RayTree) {
        let scene = load(embedded_scene(name).unwrap().text, name).unwrap();
        let [x, y] = scene.pixels[0];
        let tree = record_pixel(&scene, x, y);
        (scene, tree)
    }

    #[test]
    fn every_view_has_a_name_of_its_own() {
        let names: BTreeSet<_> = ALL_VIEWS.iter().map(|view| view.name).collect();
        assert_eq!(names.len(), ALL_VIEWS.len());
        assert!(ALL_VIEWS.iter().all(|view| View::named(view.name).is_some()));
        assert!(View::named("sideways").is_none());
    }

    #[test]
    fn every_view_of_every_event_is_there_or_is_not_but_never_fails() {
        let (scene, tree) = recorded("csg/bowl");
        for view in ALL_VIEWS {
            for event in (0..tree.end() + 2).step_by(7) {
                let subject = Subject { scene: &scene, tree: &tree, event, size: [320.0, 240.0], theme: Theme::Dark };
                if let Some(drawing) = view.draw(&subject) {
                    assert_eq!([drawing.width, drawing.height], [320.0, 240.0], "{}", view.name);
                }
            }
        }
    }

    #[test]
    fn behind_a_hit_is_the_search_for_its_object_and_its_leaf() {
        let (_, tree) = recorded("csg/bowl");
        let hit = ends(&tree).next().unwrap();
        let What::Hit { object, leaf, .. } = &tree.event(hit).what else { panic!("the bowl is hit") };
        let (search, primitive) = (search_behind(&tree, hit), primitive_behind(&tree, hit));
        assert!(matches!(&tree.event(search).what, What::Object { name, .. } if name == object));
        assert!(matches!(&tree.event(primitive).what, What::Primitive { name, .. } if name == leaf));
        assert!(tree.path(primitive).contains(&search));
        assert_eq!(search_behind(&tree, primitive), primitive);
    }
}
