//! What the view shows before anybody zooms: the eye, the hits, and the objects that were hit.

use super::super::drawing::{Frame, Spot};
use super::super::flights::{End, Flights};
use super::SideViewOptions;
use super::plane::PlaneView;
use crate::record::{Event, RayKind, What};
use crate::scene::Scene;
use crate::trace::RayTree;
use glam::DVec3;
use std::collections::BTreeSet;

/// Room for the caption above, the scale below, and labels at the sides, in points.
const MARGINS: [f64; 4] = [34.0, 34.0, 40.0, 34.0];

/// The eye is left out when it is farther from what it looks at than this many times the size of that: otherwise what
/// is hit would be a speck.
const FAR_EYE: f64 = 5.0;

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
fn content(plane: &PlaneView, scene: &Scene, tree: &RayTree, flights: &Flights) -> Frame {
    let mut seen = Gathered::default();
    for flight in flights.all.iter().filter(|flight| flight.kind != RayKind::Shadow) {
        if let End::Hit { t, .. } = flight.end {
            seen.add(plane.spot(flight.origin + flight.direction * t));
        }
    }
    let crossed = crossed_objects(tree, flights);
    let counts = |index: usize| crossed.is_empty() || crossed.contains(&index);
    for (_, object) in scene.objects.iter().enumerate().filter(|(index, _)| counts(*index)) {
        let extent = object.solid.extent();
        if extent.low.is_finite() && extent.high.is_finite() {
            corners(extent.low, extent.high).for_each(|corner| seen.add(plane.spot(corner)));
        }
    }
    let eye = plane.spot(flights.all[0].origin);
    let Some(hits) = seen.frame else { return around(eye) };
    let diagonal = (hits.high[0] - hits.low[0]).hypot(hits.high[1] - hits.low[1]);
    let away = (0..2).map(|i| (hits.low[i] - eye[i]).max(eye[i] - hits.high[i]).max(0.0)).fold(0.0, f64::max);
    if away <= FAR_EYE * diagonal || diagonal == 0.0 {
        seen.add(eye);
    }
    seen.frame.unwrap_or(hits)
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

fn around(spot: Spot) -> Frame {
    Frame { low: spot, high: spot }.grown(1.0)
}

/// The eight corners of a box.
pub(super) fn corners(low: DVec3, high: DVec3) -> impl Iterator<Item = DVec3> {
    (0..8).map(move |i| {
        let pick = |axis: usize| if i >> axis & 1 == 0 { low[axis] } else { high[axis] };
        DVec3::new(pick(0), pick(1), pick(2))
    })
}

#[derive(Default)]
struct Gathered {
    frame: Option<Frame>,
}

impl Gathered {
    fn add(&mut self, spot: Spot) {
        if !spot.iter().all(|x| x.is_finite()) {
            return;
        }
        let frame = self.frame.get_or_insert(Frame { low: spot, high: spot });
        *frame = Frame {
            low: std::array::from_fn(|i| frame.low[i].min(spot[i])),
            high: std::array::from_fn(|i| frame.high[i].max(spot[i])),
        };
    }
}
