//! Which event is drawn for the one that is selected, and what else its drawing needs.

use super::lens::Seen;
use crate::record::{Environment, Event, EventId, Mapping, Phase, Texels, Texture, Triple, What};
use crate::trace::RayTree;

/// The event that tells most about `selected`: itself if it has a drawing, else the best of those that belong to it.
pub(super) fn telling(tree: &RayTree, selected: EventId) -> Option<EventId> {
    if selected >= tree.end() {
        return None;
    }
    let what = &tree.event(selected).what;
    if rank(what).is_some() {
        return Some(selected);
    }
    let ray = ray_above(tree, selected);
    match what {
        What::Hit { .. } => best(tree, selected, tree.subtree_end(ray)),
        // A ray that meets nothing looks at the environment at most.
        What::Nothing { .. } => best(tree, ray, tree.subtree_end(ray)),
        What::Texture(_) | What::Sample(_) | What::Step { .. } | What::Ray { .. } => {
            best(tree, selected, tree.subtree_end(selected))
        }
        _ => None,
    }
}

/// The best of the events after `first`, on the same ray, up to the next hit.
fn best(tree: &RayTree, first: EventId, end: EventId) -> Option<EventId> {
    let mut found: Option<(u8, EventId)> = None;
    let mut id = first + 1;
    while id < end {
        let what = &tree.event(id).what;
        if matches!(what, What::Hit { .. }) && matches!(tree.event(first).what, What::Hit { .. }) {
            break;
        }
        if let Some(rank) = rank(what).filter(|rank| found.is_none_or(|(least, _)| *rank < least)) {
            found = Some((rank, id));
        }
        id = match what {
            // What another ray met is its own story, and what a bump or an environment looked up is told by its drawing.
            What::Ray { .. } | What::Bump(_) | What::FrameMap(_) | What::Environment(_) => tree.subtree_end(id),
            _ => id + 1,
        };
    }
    found.map(|(_, id)| id)
}

/// How much an event tells about a surface, the lowest most; none for those that have no drawing.
const fn rank(what: &What) -> Option<u8> {
    Some(match what {
        What::Mapping(_) => 0,
        What::Texels(_) => 1,
        What::Rings(_) => 2,
        What::Undulate(_) => 3,
        What::Octaves(_) => 4,
        What::Lattice(_) => 5,
        What::Bump(_) => 6,
        What::FrameMap(_) => 7,
        What::Detail(_) => 8,
        What::Environment(_) => 9,
        What::Lens(_) => 10,
        What::Confusion(_) => 11,
        What::Wavelength(_) => 12,
        What::Segment(_) => 13,
        What::Scatter(_) => 14,
        What::Phase(_) => 15,
        _ => return None,
    })
}

/// The spawned ray that an event belongs to, or the root.
fn ray_above(tree: &RayTree, id: EventId) -> EventId {
    let mut above = tree.path(id).into_iter().rev();
    above.find(|&id| matches!(tree.event(id).what, What::Ray { .. })).unwrap_or(0)
}

/// The lens that an event belongs to, and how far out of focus the hit of its ray is. None where the lens was not recorded.
pub(super) fn lens_of(tree: &RayTree, id: EventId) -> Option<Seen<'_>> {
    let is_sample = |id: &EventId| matches!(tree.event(*id).what, What::Sample(_));
    let first = tree.path(id).into_iter().rev().find(is_sample).unwrap_or(0);
    let events = || (first..tree.subtree_end(first)).map(|id| &tree.event(id).what);
    let lens = events().find_map(|what| if let What::Lens(lens) = what { Some(lens) } else { None })?;
    let confusion = events().find_map(|what| if let What::Confusion(own) = what { Some(own) } else { None });
    Some(Seen { lens, confusion })
}

/// How far along the ray light is turned on a stretch in a medium: at the points told beside it.
pub(super) fn turned_on(tree: &RayTree, segment: EventId) -> Vec<f64> {
    let Some(parent) = tree.event(segment).parent else { return Vec::new() };
    let later = tree.children(parent).filter(|event| event.id > segment);
    // The next stretch, or what comes out of this one, ends it.
    let own = later.take_while(|event| !matches!(event.what, What::Segment(_) | What::Passage(_)));
    let distances = own.filter_map(|event| match &event.what {
        What::Scatter(scatter) => Some(scatter.distance),
        _ => None,
    });
    distances.collect()
}

/// Every angle that the phase function was asked for at a point: for a point those below it, for one of them that alone.
pub(super) fn phases_of<'t>(tree: &'t RayTree, id: EventId) -> Vec<&'t Phase> {
    let phase = |event: &'t Event| match &event.what {
        What::Phase(phase) => Some(phase),
        _ => None,
    };
    match phase(tree.event(id)) {
        Some(own) => vec![own],
        None => tree.children(id).filter_map(phase).collect(),
    }
}

/// What the drawing of texels needs, from as many events as there are.
#[derive(Default)]
pub(super) struct Footprint<'a> {
    pub mapping: Option<(EventId, &'a Mapping)>,
    pub environment: Option<&'a Environment>,
    pub texels: Option<(EventId, &'a Texels)>,
}

/// The mapping and the texels that belong together, one of which is `id`. The texels come after the mapping or below it; a
/// look-up between two levels of the pyramid has its texels in two events below it.
pub(super) fn footprint_of(tree: &RayTree, id: EventId) -> Footprint<'_> {
    let mut footprint = Footprint::default();
    match &tree.event(id).what {
        What::Mapping(mapping) => {
            footprint.mapping = Some((id, mapping));
            let end = tree.event(id).parent.map_or(tree.end(), |parent| tree.subtree_end(parent));
            footprint.texels = texels_in(tree, id + 1, end);
        }
        What::Texels(own) => {
            footprint.texels = texels_in(tree, id, tree.subtree_end(id)).or(Some((id, own)));
            let is_texels = |id: &EventId| matches!(tree.event(*id).what, What::Texels(_));
            let mut above = tree.path(id).into_iter().rev().skip_while(is_texels);
            let parent = above.next();
            let before = parent.into_iter().flat_map(|parent| (parent..id).rev());
            let place = before.map(|id| tree.event(id)).find(|event| {
                let is_beside = event.parent == parent || Some(event.id) == parent;
                is_beside && matches!(event.what, What::Mapping(_) | What::Environment(_))
            });
            match place.map(|event| (event.id, &event.what)) {
                Some((id, What::Mapping(mapping))) => footprint.mapping = Some((id, mapping)),
                Some((_, What::Environment(environment))) => footprint.environment = Some(environment),
                _ => {}
            }
        }
        _ => {}
    }
    footprint
}

/// The first of these events that lists texels, before another mapping.
fn texels_in(tree: &RayTree, first: EventId, end: EventId) -> Option<(EventId, &Texels)> {
    let all = (first..end).map(|id| (id, &tree.event(id).what));
    let mut before_next = all.take_while(|(_, what)| !matches!(what, What::Mapping(_)));
    before_next.find_map(|(id, what)| match what {
        What::Texels(texels) if !texels.texels.is_empty() => Some((id, texels)),
        _ => None,
    })
}

/// The point in the space of the texture that an event is a part of.
pub(super) fn point_of(tree: &RayTree, id: EventId) -> Option<Triple> {
    tree.path(id).into_iter().rev().find_map(|above| match &tree.event(above).what {
        What::Texture(Texture { point, .. }) => Some(*point),
        _ => None,
    })
}
