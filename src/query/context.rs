//! What an event is a part of: its ray, the hit before it, the search of which it is a step.

use crate::record::{Event, EventId, RayKind, What};
use crate::trace::RayTree;

/// What an event is a part of, by the numbers of other events.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Context {
    /// The ray that it belongs to, and what that ray has hit.
    frame: u32,
    /// The frame's ray, as far as it was told of.
    ray: Option<EventId>,
    /// The hit of that ray, if it comes before the event.
    hit: Option<EventId>,
    /// The search with one object.
    object: Option<EventId>,
    /// The search with one primitive.
    leaf: Option<EventId>,
    /// The terms of one light.
    light: Option<EventId>,
    /// One of the six steps.
    step: Option<EventId>,
}

/// A ray in the making: events below it come in order, first the ray, then its hit, then what is seen there.
#[derive(Clone, Copy, Debug, Default)]
struct Frame {
    ray: Option<EventId>,
    hit: Option<EventId>,
}

/// The contexts of all events of a tree, found in one pass.
#[derive(Debug)]
pub(super) struct Contexts(Vec<Context>);

impl Contexts {
    pub fn of(tree: &RayTree) -> Self {
        let mut contexts: Vec<Context> = Vec::with_capacity(tree.events.len());
        let mut frames = vec![Frame::default()];
        for (id, event) in (0..).zip(&tree.events) {
            let above = event.parent.and_then(|parent| contexts.get(parent as usize)).copied().unwrap_or_default();
            contexts.push(below(above, id, &event.what, &mut frames));
        }
        Self(contexts)
    }
}

/// The context of an event below another one.
fn below(above: Context, id: EventId, what: &What, frames: &mut Vec<Frame>) -> Context {
    let mut own = above;
    match what {
        What::Pixel { .. } | What::Sample(_) => own.open(frames, Frame::default()),
        What::LooseRay { .. } => own.open(frames, Frame { ray: Some(id), hit: None }),
        // The ray from the eye is told of beside the steps that follow it.
        What::Ray { ray: RayKind::Camera, .. } => frames[own.frame as usize].ray = Some(id),
        What::Ray { .. } => {
            own.open(frames, Frame { ray: Some(id), hit: None });
            (own.object, own.leaf) = (None, None);
        }
        // Light from a point of a medium does not come from the surface behind it.
        What::Scatter(_) => own.open(frames, Frame { ray: above.ray, hit: None }),
        What::Hit { .. } => frames[own.frame as usize].hit = Some(id),
        What::Object { .. } => (own.object, own.leaf) = (Some(id), None),
        What::Primitive { .. } => own.leaf = Some(id),
        What::Light { .. } => own.light = Some(id),
        What::Step { .. } => own.step = Some(id),
        _ => {}
    }
    let frame = frames[own.frame as usize];
    (own.ray, own.hit) = (frame.ray, frame.hit);
    own
}

impl Context {
    fn open(&mut self, frames: &mut Vec<Frame>, frame: Frame) {
        self.frame = u32::try_from(frames.len()).unwrap_or(u32::MAX);
        frames.push(frame);
    }
}

/// An event with what it is a part of.
pub(super) struct View<'a> {
    tree: &'a RayTree,
    event: &'a Event,
    context: Context,
}

impl<'a> View<'a> {
    pub fn new(tree: &'a RayTree, contexts: &Contexts, id: EventId) -> Self {
        Self { tree, event: tree.event(id), context: contexts.0[id as usize] }
    }

    /// What happened.
    pub fn what(&self) -> &'a What {
        &self.event.what
    }

    /// Its ray; the event of a loose ray, where that is given instead of a pixel.
    pub fn ray(&self) -> Option<&'a What> {
        self.told(self.context.ray)
    }

    /// The hit that it belongs to: itself, or the one that its ray has made before. The search for hits with one object belongs to
    /// none.
    pub fn hit(&self) -> Option<&'a What> {
        self.told(self.context.hit.filter(|_| self.context.object.is_none()))
    }

    /// The search with an object that it is a part of.
    pub fn object(&self) -> Option<&'a What> {
        self.told(self.context.object)
    }

    /// The search with a primitive that it is a part of.
    pub fn leaf(&self) -> Option<&'a What> {
        self.told(self.context.leaf)
    }

    /// The terms of the light that it is a part of.
    pub fn light(&self) -> Option<&'a What> {
        self.told(self.context.light)
    }

    /// The step that it is a part of.
    pub fn step(&self) -> Option<&'a What> {
        self.told(self.context.step)
    }

    /// The whole story.
    pub fn root(&self) -> Option<&'a What> {
        self.told(Some(0))
    }

    fn told(&self, id: Option<EventId>) -> Option<&'a What> {
        Some(&self.tree.events.get(id? as usize)?.what)
    }
}
