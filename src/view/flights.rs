//! The rays of a tree, with where each begins and ends and which events belong to it.

use crate::record::{EventId, RayKind, Triple, What};
use crate::trace::RayTree;
use glam::DVec3;

/// A ray and how it ended.
#[derive(Clone, Debug, PartialEq)]
pub struct Flight {
    /// The event that stands for it: its `Ray`, or the root for a ray that was given.
    pub event: EventId,
    /// Why it was sent.
    pub kind: RayKind,
    /// Where it starts.
    pub origin: DVec3,
    /// Where it goes.
    pub direction: DVec3,
    /// What stopped it.
    pub end: End,
}

/// What stopped a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum End {
    /// A hit, with its time.
    Hit {
        /// The `Hit` event.
        event: EventId,
        /// The hit time.
        t: f64,
    },
    /// It was on its way to a light that it reached, at this time.
    Light(f64),
    /// It was on its way to a light, and at this time something let nothing through.
    Blocked {
        /// The `Shadow` event.
        event: EventId,
        /// The hit time.
        t: f64,
        /// The time at which it would have reached the light.
        light: f64,
    },
    /// Nothing: it goes on without end.
    Nothing,
}

/// All rays of a tree, and for each event the ray that it belongs to.
#[derive(Clone, Debug, PartialEq)]
pub struct Flights {
    /// The rays, in order. The first is the camera ray or the ray that was given.
    pub all: Vec<Flight>,
    owners: Vec<usize>,
}

impl Flights {
    /// Reads them from a tree.
    pub fn of(tree: &RayTree) -> Self {
        let mut flights = Self { all: vec![first(tree)], owners: Vec::with_capacity(tree.events.len()) };
        for event in &tree.events {
            let owner = event.parent.and_then(|parent| flights.owners.get(parent as usize)).copied().unwrap_or(0);
            let owner = match &event.what {
                What::Ray { ray, origin, direction, .. } if *ray != RayKind::Camera => {
                    let end =
                        if *ray == RayKind::Shadow { light_end(tree, event.parent, *direction) } else { End::Nothing };
                    flights.all.push(Flight {
                        event: event.id,
                        kind: *ray,
                        origin: DVec3::from_array(*origin),
                        direction: DVec3::from_array(*direction),
                        end,
                    });
                    flights.all.len() - 1
                }
                _ => owner,
            };
            flights.owners.push(owner);
            flights.all[owner].end = flights.all[owner].end.after(event.id, &event.what);
        }
        flights
    }

    /// The place in [`all`](Self::all) of the ray that an event belongs to.
    pub fn owner(&self, event: EventId) -> usize {
        self.owners.get(event as usize).copied().unwrap_or(0)
    }

    /// The ray that an event belongs to.
    pub fn ray_of(&self, event: EventId) -> &Flight {
        &self.all[self.owner(event)]
    }
}

impl End {
    fn after(self, event: EventId, what: &What) -> Self {
        match (self, what) {
            (Self::Nothing, What::Hit { t, .. }) => Self::Hit { event, t: *t },
            (Self::Light(light), What::Shadow { t, passes, .. }) if *passes == 0.0 => {
                Self::Blocked { event, t: *t, light }
            }
            (end, _) => end,
        }
    }
}

/// The ray that the tree is about.
fn first(tree: &RayTree) -> Flight {
    let camera = tree.events.iter().find_map(|event| match &event.what {
        What::Ray { ray: RayKind::Camera, origin, direction, .. } | What::LooseRay { origin, direction } => {
            Some((event.id, *origin, *direction))
        }
        _ => None,
    });
    let (event, origin, direction): (_, Triple, Triple) = camera.unwrap_or((0, [0.0; 3], [0.0, 0.0, -1.0]));
    let [origin, direction] = [origin, direction].map(DVec3::from_array);
    Flight { event, kind: RayKind::Camera, origin, direction, end: End::Nothing }
}

/// How far a shadow ray would go: the light above it knows its distance.
fn light_end(tree: &RayTree, parent: Option<EventId>, direction: Triple) -> End {
    let distance = parent.and_then(|parent| match &tree.event(parent).what {
        What::Light { distance, .. } => *distance,
        What::LightSample(sample) => Some(sample.distance),
        _ => None,
    });
    End::Light(distance.map_or(f64::INFINITY, |distance| distance / DVec3::from_array(direction).length()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::view::sample;

    #[test]
    fn each_ray_knows_its_end_and_each_event_its_ray() {
        let tree = sample::every_kind();
        let flights = Flights::of(&tree);
        let kinds: Vec<_> = flights.all.iter().map(|flight| flight.kind).collect();
        assert_eq!(
            kinds,
            [RayKind::Camera, RayKind::Shadow, RayKind::Reflected, RayKind::Scattered, RayKind::Refracted]
        );
        assert!(matches!(flights.all[0].end, End::Hit { t, .. } if t == 4.5));
        // The light is 5 away along a unit direction, and a quarter of its light passes what is in the way.
        assert_eq!(flights.all[1].end, End::Light(5.0));
        assert_eq!(flights.all[2].end, End::Nothing);
        let last = tree.end() - 1;
        assert_eq!(flights.owner(last), 0);
        assert_eq!(flights.owner(flights.all[3].event), 3);
    }
}
