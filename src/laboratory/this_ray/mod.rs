//! One ray, by every method: how many digits of every number are right, where they were lost, and what the method takes.
//!
//! **The truth.** The ray is traced once with hits of 77 digits: the *exact* tree. What is left of its own errors is the
//! rounding of what follows from hits (points, normals, colours), which is in `f64` whatever the method; so a number that is
//! the same in both trees counts as right in all of its digits.
//!
//! **Errors.** Inside solvers they are measured by exact shadows of every operation, from the exact placement of the object
//! on ([`Shadowed`](crate::math::Shadowed)). Those of hit times and of all that follows are differences from the same number
//! in the exact tree; so are those inside solvers where the ray itself is not the exact one any more.
//!
//! **Digits right** of a number x with the error e: −log₁₀(e / |x|); of vectors and colours, by their largest coordinate.
//!
//! **Digits lost** in an event: those that are right of what goes into it, less those that are right of its worst number.

mod digits;
mod flow;
mod outline;
mod parting;
mod target;
mod text;
mod timing;
mod twins;

pub use digits::{Number, digits_right};
pub use flow::Told;
pub use outline::OutlineRow;
pub use parting::Parting;
pub use target::Target;
pub use text::this_ray_text;
pub use timing::time_methods;

use crate::record::{EventId, What};
use crate::scene::{Profile, Scene};
use crate::shape::Method;
use crate::trace::RayTree;

/// A ray by one method, beside the exact one.
#[derive(Clone, Debug)]
pub struct Story {
    /// The method.
    pub method: Method,
    /// What the ray did.
    pub tree: RayTree,
    /// What there is to tell of each event, by its number.
    pub told: Vec<Told>,
    /// The same event in the exact tree, if there is one, by the event's number.
    pub twins: Vec<Option<EventId>>,
    /// Where the trees part, if they do.
    pub parting: Option<Parting>,
}

/// A ray by every method.
#[derive(Clone, Debug)]
pub struct ThisRay {
    /// The ray with hits of 77 digits.
    pub exact: RayTree,
    /// The others, in the order of [`Method::ALL`].
    pub stories: Vec<Story>,
}

/// Traces a ray by every method, and lays the trees side by side.
#[must_use]
pub fn this_ray(scene: &Scene, target: Target) -> ThisRay {
    let record = |method| target.record(&by(scene, method));
    let exact = record(Method::Exact);
    let stories = Method::ALL.into_iter().map(|method| Story::new(method, record(method), &exact)).collect();
    ThisRay { exact, stories }
}

/// The scene, with hits found by a method.
fn by(scene: &Scene, method: Method) -> Scene {
    scene.with_profile(&Profile { method: Some(method), ..Profile::STANDARD })
}

impl Story {
    fn new(method: Method, tree: RayTree, exact: &RayTree) -> Self {
        let (twins, parting) = twins::pair(&tree, exact);
        let told = flow::told(method, &tree, |id| twins[id as usize].map(|twin| exact.event(twin)));
        Self { method, tree, told, twins, parting }
    }

    /// The hit that the ray itself sees: its event.
    #[must_use]
    pub fn hit(&self) -> Option<EventId> {
        self.tree.events.iter().find(|event| matches!(event.what, What::Hit { .. })).map(|event| event.id)
    }

    /// Digits right of the time of the hit that is seen; none where nothing is hit, or nothing like it in the exact tree.
    #[must_use]
    pub fn hit_digits(&self) -> Option<f64> {
        let told = &self.told[self.hit()? as usize];
        told.numbers.iter().find(|number| number.name == "t").map(Number::digits)
    }

    /// Digits right of the colour that comes back.
    #[must_use]
    pub fn colour_digits(&self, exact: &RayTree) -> f64 {
        let ([found, truth], part) = ([self.tree.colour(), exact.colour()], |v: [f64; 3]| v.to_vec());
        Number::compared("colour", &part(found), &part(truth), 0.0).digits()
    }

    /// The events in which at least so many digits are lost, those with the largest losses first.
    #[must_use]
    pub fn losses(&self, least: f64) -> Vec<EventId> {
        let mut events: Vec<_> = (0..).zip(&self.told).filter(|(_, told)| told.lost >= least).collect();
        events.sort_by(|(_, a), (_, b)| b.lost.total_cmp(&a.lost));
        events.into_iter().map(|(id, _)| id).collect()
    }
}
