//! What the view shows before anybody zooms: the eye, the hits, and the objects that were hit.

use super::super::drawing::{Frame, Spot, length};
use super::super::flights::{End, Flights};
use super::SideViewOptions;
use super::plane::PlaneView;
use crate::record::{Event, EventId, RayKind, What};
use crate::scene::Scene;
use crate::trace::RayTree;
use glam::DVec3;
use std::collections::BTreeSet;

/// Room for the caption above, the scale below, and labels at the sides, in points.
const MARGINS: [f64; 4] = [34.0, 34.0, 40.0, 34.0];

/// The eye is left out when it is farther from what it looks at than this many times the size of that: otherwise what
/// is hit would be a speck.
const FAR_EYE: f64 = 5.0;

/// An object whose box is this many times as large as the way from the eye to the hit is a floor rather than a thing.
const HUGE: f64 = 2.0;

/// What other rays come to may make the view this much wider.
const WIDER: f64 = 1.6;

/// Sets scale and centre of `plane`.
pub(super) fn fit(
    plane: PlaneView,
    scene: &Scene,
    tree: &RayTree,
    flights: &Flights,
    options: &SideViewOptions,
) -> PlaneView {
    let size = options.size.map(|x| if x.is_finite() { x.clamp(16.0, 16_384.0) } else { 16.0 });
    let content = content(&plane, scene, tree, flights);
    let [left, top, right, bottom] = [MARGINS[0], MARGINS[1], MARGINS[2], MARGINS[3]];
    let room = [(size[0] - left - right).max(8.0), (size[1] - top - bottom).max(8.0)];
    let extent: Spot = std::array::from_fn(|i| (content.high[i] - content.low[i]).max(1e-9));
    let zoom = if options.zoom.is_finite() { options.zoom.clamp(1e-3, 1e6) } else { 1.0 };
    let scale = (room[0] / extent[0]).min(room[1] / extent[1]).min(1e9) * zoom;
    let middle: Spot = std::array::from_fn(|i| f64::midpoint(content.low[i], content.high[i]));
    let pan = options.pan.map(|x| if x.is_finite() { x } else { 0.0 });
    let target = [left + room[0] / 2.0 + pan[0], top + room[1] / 2.0 + pan[1]];
    PlaneView { scale, centre: [target[0] - middle[0] * scale, target[1] - middle[1] * scale], ..plane }
}

/// The box of what should be seen, in the units of the world.
///
/// The first ray's hit, what it hit, and the eye come first. What other rays hit and cross is taken in as long as that
/// does not make all the rest small.
fn content(plane: &PlaneView, scene: &Scene, tree: &RayTree, flights: &Flights) -> Frame {
    let first = &flights.all[0];
    let eye = plane.spot(first.origin);
    let crossed = crossed_objects(tree, flights);
    let boxes: Vec<(usize, Frame)> = (0..scene.objects.len())
        .filter(|index| crossed.is_empty() || crossed.contains(index))
        .filter_map(|index| Some((index, object_frame(plane, scene, index)?)))
        .collect();
    let mut hits = flights.all.iter().filter(|flight| flight.kind != RayKind::Shadow).filter_map(|flight| {
        let End::Hit { t, .. } = flight.end else { return None };
        Some(plane.spot(flight.origin + flight.direction * t))
    });
    let mut seen = match first.end {
        End::Hit { event, .. } => {
            let hit = hits.next().unwrap_or(eye);
            let frame = Frame { low: hit, high: hit };
            let reach = HUGE * length([hit[0] - eye[0], hit[1] - eye[1]]);
            let object = object_of(tree, event).and_then(|name| scene.objects.iter().position(|o| o.name == name));
            let own = boxes.iter().find(|(index, own)| Some(*index) == object && diagonal(own) < reach);
            own.map_or(frame, |(_, own)| joined(frame, own))
        }
        _ => match boxes.split_first() {
            Some(((_, one), rest)) => rest.iter().fold(*one, |all, (_, other)| joined(all, other)),
            None => return Frame { low: eye, high: eye }.grown(1.0),
        },
    };
    let away = (0..2).map(|i| (seen.low[i] - eye[i]).max(eye[i] - seen.high[i]).max(0.0)).fold(0.0, f64::max);
    if away <= FAR_EYE * diagonal(&seen) || diagonal(&seen) == 0.0 {
        seen = joined(seen, &Frame { low: eye, high: eye });
    }
    let most = WIDER * diagonal(&seen);
    let others = hits.map(|hit| Frame { low: hit, high: hit }).chain(boxes.iter().map(|(_, frame)| *frame));
    for wider in others.collect::<Vec<_>>() {
        let with = joined(seen, &wider);
        if diagonal(&with) <= most {
            seen = with;
        }
    }
    seen
}

fn object_of(tree: &RayTree, hit: EventId) -> Option<&str> {
    match &tree.event(hit).what {
        What::Hit { object, .. } => Some(object),
        _ => None,
    }
}

/// The box of an object's corners in the drawing; none where it is unbounded.
fn object_frame(plane: &PlaneView, scene: &Scene, index: usize) -> Option<Frame> {
    let extent = scene.objects[index].solid.extent();
    if !(extent.low.is_finite() && extent.high.is_finite()) {
        return None;
    }
    let spots = corners(extent.low, extent.high).map(|corner| plane.spot(corner));
    spots.map(|spot| Frame { low: spot, high: spot }).reduce(|all, spot| joined(all, &spot))
}

fn diagonal(frame: &Frame) -> f64 {
    length([frame.high[0] - frame.low[0], frame.high[1] - frame.low[1]])
}

/// The box of two boxes.
fn joined(a: Frame, b: &Frame) -> Frame {
    let low = std::array::from_fn(|i| a.low[i].min(b.low[i]));
    Frame { low, high: std::array::from_fn(|i| a.high[i].max(b.high[i])) }
}

/// The objects that some ray, shadow rays apart, is inside of somewhere.
fn crossed_objects(tree: &RayTree, flights: &Flights) -> BTreeSet<usize> {
    let not_shadow = |event: &&Event| flights.ray_of(event.id).kind != RayKind::Shadow;
    let crossed = tree.events.iter().filter(not_shadow).filter_map(|event| match &event.what {
        What::Object { index, intervals: 1.., .. } => Some(*index),
        _ => None,
    });
    crossed.collect()
}

/// The eight corners of a box.
pub(super) fn corners(low: DVec3, high: DVec3) -> impl Iterator<Item = DVec3> {
    (0..8).map(move |i| {
        let pick = |axis: usize| if i >> axis & 1 == 0 { low[axis] } else { high[axis] };
        DVec3::new(pick(0), pick(1), pick(2))
    })
}
