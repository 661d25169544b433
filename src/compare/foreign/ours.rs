//! What we recorded, looked up the way that another ray tracer tells it: ray by ray.

use crate::csg::Leaf;
use crate::record::{Candidate, Event, EventId, Operator, RayKind, Span, What};
use crate::scene::{Material, Object, Scene};
use crate::trace::RayTree;
use glam::DVec3;

/// A ray of ours.
#[derive(Clone, Debug)]
pub struct OurRay {
    /// The event that describes it.
    pub event: EventId,
    /// The ray that sent it, by its place in the list.
    pub parent: Option<usize>,
    /// Why it was sent.
    pub kind: RayKind,
    /// Where it starts.
    pub origin: DVec3,
    /// Where it goes.
    pub direction: DVec3,
    /// The light that it goes to, if it is a shadow ray.
    pub light: Option<String>,
    /// The object that it left.
    pub left: Option<String>,
}

/// A recorded pixel by its rays.
pub struct Ours<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// The recorded pixel.
    pub tree: &'a RayTree,
    /// The rays in the order of the story; the first is the camera ray.
    pub rays: Vec<OurRay>,
    /// The ray that each event belongs to.
    owner: Vec<usize>,
}

/// A hit of ours.
#[derive(Clone, Copy, Debug)]
pub struct OurHit<'a> {
    /// The event.
    pub event: EventId,
    /// The object's name.
    pub object: &'a str,
    /// The primitive's name.
    pub leaf: &'a str,
    /// The part of its surface.
    pub part: &'a str,
    /// The hit time.
    pub t: f64,
    /// The bound on its error.
    pub t_error: f64,
    /// In world space.
    pub point: DVec3,
    /// In generic coordinates.
    pub generic_point: DVec3,
    /// Out of the solid.
    pub n_geometric: DVec3,
    /// Towards the side that the ray came from.
    pub n_shading: DVec3,
}

impl<'a> Ours<'a> {
    /// Sorts a recorded pixel by its rays.
    pub fn new(scene: &'a Scene, tree: &'a RayTree) -> Self {
        let mut ours = Self { scene, tree, rays: Vec::new(), owner: Vec::with_capacity(tree.events.len()) };
        ours.rays.push(first_ray(tree));
        for event in &tree.events {
            let around = event.parent.map_or(0, |parent| ours.owner[parent as usize]);
            let owner = match &event.what {
                What::Ray { ray, origin, direction, depth, left, .. } if *depth > 0 => {
                    ours.rays.push(OurRay {
                        event: event.id,
                        parent: Some(around),
                        kind: *ray,
                        origin: (*origin).into(),
                        direction: (*direction).into(),
                        light: ours.light_of(event),
                        left: left.clone(),
                    });
                    ours.rays.len() - 1
                }
                _ => around,
            };
            ours.owner.push(owner);
        }
        ours
    }

    fn light_of(&self, event: &Event) -> Option<String> {
        match &self.tree.event(event.parent?).what {
            What::Light { name, .. } => Some(name.clone()),
            _ => None,
        }
    }

    /// The events of a ray, those of the rays that it sent left out.
    pub fn of(&self, ray: usize) -> impl Iterator<Item = &'a Event> + '_ {
        self.tree.events.iter().filter(move |event| self.owner[event.id as usize] == ray)
    }

    /// What a ray hit; none where it hit nothing.
    pub fn hit(&self, ray: usize) -> Option<OurHit<'a>> {
        self.of(ray).find_map(our_hit)
    }

    /// The event that says that a ray hit nothing.
    pub fn nothing(&self, ray: usize) -> Option<&'a Event> {
        self.of(ray).find(|event| matches!(event.what, What::Nothing { .. }))
    }

    /// What a ray found out about an object.
    pub fn object(&self, ray: usize, wanted: &str) -> Option<&'a Event> {
        self.of(ray).find(|event| matches!(&event.what, What::Object { name, .. } if name == wanted))
    }

    /// The events below an event.
    pub fn below(&self, id: EventId) -> &'a [Event] {
        &self.tree.events[id as usize + 1..self.tree.subtree_end(id) as usize]
    }

    /// The primitives that were asked for an object, with their names.
    pub fn primitives(&self, object: EventId) -> impl Iterator<Item = (&'a Event, &'a str)> + use<'a> {
        self.below(object).iter().filter_map(|event| match &event.what {
            What::Primitive { name, .. } => Some((event, name.as_str())),
            _ => None,
        })
    }

    /// The hit times of a primitive that were looked at; none where it was not asked.
    pub fn candidates(&self, primitive: EventId) -> Option<(EventId, &'a [Candidate])> {
        self.below(primitive).iter().find_map(|event| match &event.what {
            What::Roots { candidates } => Some((event.id, candidates.as_slice())),
            _ => None,
        })
    }

    /// S and c of a primitive, or of the first one below an object.
    pub fn transform(&self, below: EventId) -> Option<(EventId, DVec3, DVec3)> {
        self.below(below).iter().find_map(|event| match &event.what {
            What::Transform { origin, direction, .. } => Some((event.id, (*origin).into(), (*direction).into())),
            _ => None,
        })
    }

    /// The lists of an object's uppermost node: its event, its operator, left, right and combined.
    pub fn combined(&self, object: EventId) -> Option<Combined<'a>> {
        self.below(object).iter().find_map(|event| match &event.what {
            What::Combine { operator, left, right, combined, .. } => Some(Combined {
                event: event.id,
                operator: *operator,
                left,
                right: right.as_deref().unwrap_or_default(),
                result: combined,
            }),
            _ => None,
        })
    }

    /// The scene's object of this name.
    pub fn scene_object(&self, name: &str) -> Option<&'a Object> {
        self.scene.objects.iter().find(|object| object.name == name)
    }

    /// The primitive of this name in an object of the scene.
    pub fn leaf(&self, object: &str, leaf: &str) -> Option<&'a Leaf> {
        self.scene_object(object)?.solid.leaves.iter().find(|candidate| candidate.name == leaf)
    }

    /// The material of this name.
    pub fn material(&self, name: &str) -> Option<&'a Material> {
        self.scene.materials.iter().find(|material| material.name == name)
    }

    /// Whether the hit lies on a primitive that is subtracted, so that its normal is turned round.
    pub fn is_turned_round(&self, ray: usize, hit: &OurHit) -> bool {
        let Some(combined) = self.object(ray, hit.object).and_then(|object| self.combined(object.id)) else {
            return false;
        };
        let edges = combined.result.iter().flat_map(|span| [&span.enter, &span.leave]).flatten();
        edges.into_iter().any(|edge| edge.t == hit.t && edge.flipped)
    }
}

/// A node of a compound, for one ray.
#[derive(Clone, Copy, Debug)]
pub struct Combined<'a> {
    /// The event.
    pub event: EventId,
    /// The operator.
    pub operator: Operator,
    /// Inside the left solid.
    pub left: &'a [Span],
    /// Inside the right solid.
    pub right: &'a [Span],
    /// Inside the result.
    pub result: &'a [Span],
}

fn first_ray(tree: &RayTree) -> OurRay {
    let described = tree.events.iter().find_map(|event| match &event.what {
        What::Ray { origin, direction, depth: 0, .. } | What::LooseRay { origin, direction } => {
            Some((event.id, *origin, *direction))
        }
        _ => None,
    });
    let (event, origin, direction) = described.unwrap_or_default();
    let (kind, parent, light, left) = (RayKind::Camera, None, None, None);
    OurRay { event, parent, kind, origin: origin.into(), direction: direction.into(), light, left }
}

fn our_hit(event: &Event) -> Option<OurHit<'_>> {
    let What::Hit { object, leaf, part, t, t_error, point, generic_point, n_geometric, n_shading, .. } = &event.what
    else {
        return None;
    };
    Some(OurHit {
        event: event.id,
        object,
        leaf,
        part,
        t: *t,
        t_error: *t_error,
        point: (*point).into(),
        generic_point: (*generic_point).into(),
        n_geometric: (*n_geometric).into(),
        n_shading: (*n_shading).into(),
    })
}
