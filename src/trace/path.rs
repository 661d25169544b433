//! Long paths: the last ray that a hit sends is traced after the hit, not within it.
//!
//! Light that glass has caught, or that runs between mirrors, may go round thousands of times. Were every ray traced within
//! the one that sent it, each would hold its piece of the stack until the last one is answered. So on a long path a hit hands
//! over the last ray that it sends, with a relay that knows what to do with its colour. The ray is traced, and the ray after
//! it, and when one of them has a colour, it comes back through the relays in turn. Where a hit sends two rays, the first of
//! them is always traced within it.

use super::calls::Repertoire;
use super::ray::{Components, Ray, Tracer};
use super::segment::Passage;
use crate::record::{RayKind, Recorder};
use crate::scene::Rgb;

/// What becomes of a ray.
#[expect(clippy::large_enum_variant, reason = "rays are handed over where they are, without a call of the allocator")]
pub(super) enum Answer<'a> {
    /// It brings back this colour.
    Colour(Rgb),
    /// Another ray will tell.
    Onward(Onward<'a>),
}

/// The last ray that a hit sends.
pub(super) struct Onward<'a> {
    pub ray: Ray,
    pub relay: Relay<'a>,
}

/// What is done with its colour.
pub(super) struct Relay<'a> {
    /// What the hit has gathered without it.
    pub components: Components,
    /// What its colour counts there.
    pub share: Rgb,
    /// The medium before the hit, where that takes light away.
    pub passage: Option<Passage<'a>>,
}

impl<'a, E: Repertoire> Tracer<'a, E> {
    /// The colour that an answer stands for.
    #[inline(always)]
    pub(super) fn colour_of<R: Recorder>(&self, answer: Answer<'a>, recorder: &mut R) -> Rgb {
        match answer {
            Answer::Colour(colour) => colour,
            Answer::Onward(onward) => self.follow(onward, recorder),
        }
    }

    /// Traces a ray and those after it, and brings the colour of the last one back to the first.
    #[inline(never)]
    fn follow<R: Recorder>(&self, first: Onward<'a>, recorder: &mut R) -> Rgb {
        let mut path: Vec<Onward> = Vec::new();
        let mut next = first;
        let mut colour = loop {
            recorder.begin();
            let answer = self.answer(&next.ray, recorder);
            path.push(next);
            match answer {
                Answer::Colour(colour) => break colour,
                Answer::Onward(onward) => next = onward,
            }
        };
        for Onward { ray, relay } in path.into_iter().rev() {
            recorder.end(|| self.describe_ray(&ray));
            colour = self.relayed(ray.kind, &relay, colour, recorder);
        }
        colour
    }

    /// The colour of a ray that has sent one of this kind, which brought back `colour`.
    fn relayed<R: Recorder>(&self, kind: RayKind, relay: &Relay, colour: Rgb, recorder: &mut R) -> Rgb {
        let Relay { mut components, share, ref passage } = *relay;
        let component =
            if kind == RayKind::Reflected { &mut components.reflected } else { &mut components.transmitted };
        *component += colour * share;
        recorder.note(|| components.describe());
        match passage {
            None => components.total(),
            Some(passage) => self.colour_through(passage, components.total(), recorder),
        }
    }
}
