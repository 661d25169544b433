//! How digits go from event to event: what is right before one, and what is after it.
//!
//! A tree is read in the order in which things happened. Of the ray that is being followed it is known how right it is itself,
//! how right it is in generic coordinates, how right what the solver works out, the hit, and the terms of its colour; each event
//! is laid against what it was worked out from.

use super::digits::{Number, is_working, numbers};
use crate::math::{Real, portable};
use crate::record::{Event, EventId, What};
use crate::shape::Method;
use crate::trace::RayTree;

/// What there is to tell of an event.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Told {
    /// Its numbers.
    pub numbers: Vec<Number>,
    /// Digits right of the worst of them; none where it has none, infinite where all are exact.
    pub right: Option<f64>,
    /// Digits lost in it.
    pub lost: f64,
}

impl Told {
    /// The number with the fewest digits right.
    #[must_use]
    pub fn worst(&self) -> Option<&Number> {
        self.numbers.iter().min_by(|a, b| a.digits().total_cmp(&b.digits()))
    }
}

/// Decimal digits of the numbers that a method solves with.
pub fn digits_of(method: Method) -> f64 {
    let roundoff = match method {
        Method::Single => f32::UNIT_ROUNDOFF,
        Method::Double | Method::Adaptive | Method::Textbook => f64::UNIT_ROUNDOFF,
        Method::DoubleDouble => crate::math::DoubleDouble::UNIT_ROUNDOFF,
        Method::Exact => crate::math::Precise::UNIT_ROUNDOFF,
    };
    -portable::log10(roundoff)
}

/// How right things are of the ray that is being followed, in digits.
#[derive(Clone, Copy, Debug)]
struct Followed {
    /// The ray itself.
    ray: f64,
    /// Its hit times count in proportion to this at least.
    reach: f64,
    /// In generic coordinates.
    transformed: f64,
    /// What the solver has worked out.
    worked: f64,
    /// The hit; before there is one, the ray.
    hit: f64,
    /// What a new ray is made from.
    spawning: f64,
    /// The worst of the terms of the colour.
    terms: f64,
}

impl Followed {
    fn new(ray: f64, reach: f64) -> Self {
        Self { ray, reach, transformed: ray, worked: ray, hit: ray, spawning: ray, terms: f64::INFINITY }
    }
}

/// What there is to tell of each event of a tree; `twin` gives the same event in the exact tree.
pub fn told<'a>(method: Method, tree: &RayTree, twin: impl Fn(EventId) -> Option<&'a Event>) -> Vec<Told> {
    let digits = digits_of(method);
    let mut flow = Flow { solver: digits, plain: digits.min(digits_of(Method::Double)), rays: Vec::new() };
    tree.events.iter().map(|event| flow.tell(event, twin(event.id), tree)).collect()
}

struct Flow {
    /// Digits of the numbers that the method solves with.
    solver: f64,
    /// Digits of all others: those of `f64`, or fewer where hits have fewer.
    plain: f64,
    /// The rays that are being followed, each with the number after its last event.
    rays: Vec<(EventId, Followed)>,
}

impl Flow {
    fn tell(&mut self, event: &Event, twin: Option<&Event>, tree: &RayTree) -> Told {
        while self.rays.last().is_some_and(|&(end, _)| end <= event.id) {
            self.leave();
        }
        let around = self.rays.last().map_or(Followed::new(self.plain, 0.0), |&(_, ray)| ray);
        let numbers = numbers(event, twin, around.ray < self.plain, around.reach);
        let right = numbers.iter().map(Number::digits).reduce(f64::min);
        let known = right.unwrap_or(f64::INFINITY);
        let before = self.before(event, &around, &numbers, known);
        self.follow(event, known, tree);
        let lost = if known < before { before - known } else { 0.0 };
        Told { numbers, right, lost }
    }

    /// Digits right of what goes into an event.
    fn before(&self, event: &Event, ray: &Followed, numbers: &[Number], right: f64) -> f64 {
        let before = match &event.what {
            What::Ray { .. } => ray.spawning,
            What::Transform { .. } => return if ray.ray < self.plain { ray.ray } else { self.solver },
            what if is_working(what) => return ray.transformed.min(self.solver),
            What::Roots { .. } => ray.transformed.min(ray.worked),
            // These take over what others worked out.
            What::Combine { .. } | What::Rejected { .. } | What::Shadow { .. } => right,
            What::Hit { .. } => {
                let time = numbers.iter().find(|number| number.name == "t").map_or(f64::INFINITY, Number::digits);
                ray.ray.min(time)
            }
            What::Colour { .. } | What::Passage(_) | What::Average(_) | What::Written { .. } => ray.hit.min(ray.terms),
            _ => ray.hit,
        };
        before.min(self.plain)
    }

    /// Takes what is right of an event into account for those that follow.
    fn follow(&mut self, event: &Event, right: f64, tree: &RayTree) {
        if let What::Ray { origin, direction, depth, .. } = &event.what {
            let size = |v: &[f64; 3]| v.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
            // A ray that starts on a surface meets it at t = 0, but for what rounding makes of its start.
            let reach = if *depth > 0 { size(origin) / size(direction) } else { 0.0 };
            let followed = Followed::new(right.min(self.plain), reach);
            let end = tree.subtree_end(event.id);
            // The camera's ray is what the steps beside it are about.
            let end = if *depth == 0 { self.rays.last().map_or(tree.end(), |&(end, _)| end) } else { end };
            self.rays.push((end, followed));
            return;
        }
        if matches!(event.what, What::Sample(_) | What::LooseRay { .. }) {
            self.rays.push((tree.subtree_end(event.id), Followed::new(self.plain, 0.0)));
            return;
        }
        let Some((_, ray)) = self.rays.last_mut() else { return };
        match &event.what {
            What::Transform { .. } => (ray.transformed, ray.worked) = (right, f64::INFINITY),
            what if is_working(what) => ray.worked = ray.worked.min(right),
            What::Hit { .. } => (ray.hit, ray.spawning) = (right, right),
            What::Reflection { .. } | What::Snell { .. } => ray.spawning = ray.hit.min(right),
            What::Ambient { .. }
            | What::Light { .. }
            | What::Texture(_)
            | What::Nothing { .. }
            | What::Colour { .. } => {
                ray.terms = ray.terms.min(right);
            }
            _ => {}
        }
    }

    /// Ends a ray: its colour is a term of that of the ray before.
    fn leave(&mut self) {
        let Some((_, left)) = self.rays.pop() else { return };
        if let Some((_, ray)) = self.rays.last_mut() {
            ray.terms = ray.terms.min(left.terms);
        }
    }
}
