//! From fast to sure: how every solver is run.
//!
//! A solver is written once, for any arithmetic, and says of its answer whether rounding could have made it another one.
//! It is run in the ray's own arithmetic first. Only where that leaves the answer open is it run again with 32 digits, on
//! the ray as it was given. Where the deciding number is so small that half a unit in the last places of the ray's own
//! numbers would turn its sign, no arithmetic can help: the answer is that for the numbers as they stand, and it carries
//! the certificate *undecidable*.
//!
//! Source: J. R. Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric predicates", Discrete &
//! Computational Geometry 18 (1997), for filters in front of dearer arithmetic.

use super::boundary::Boundaries;
use super::{Approach, Crossing, Crossings, GenericRay, Primitive, report};
use crate::math::{Real, Traced, counted};
use crate::record::{Candidate, Certificate, Entry, NullRecorder, Recorder, Sense, Tier, What};

/// A solver's answer, and whether it is beyond doubt.
pub(super) struct Attempt<F> {
    /// What was found.
    pub found: F,
    /// No rounding error could have made it another answer.
    pub decided: bool,
}

/// The decision of a solver that was closest to going the other way.
#[derive(Clone, Copy, Debug)]
pub(super) struct Call {
    /// What was asked, as a question with two answers.
    pub question: &'static str,
    /// The number whose sign is the answer.
    pub value: f64,
    /// Bound on its rounding error.
    pub doubt: f64,
    /// How far it moves when the ray's own numbers move by half a unit in their last places.
    pub input_doubt: f64,
    /// The place on the ray that it is about, in τ.
    pub near: f64,
}

impl Call {
    /// Whether rounding cannot have turned the sign.
    #[inline]
    pub fn is_beyond_doubt(&self) -> bool {
        self.value.abs() > self.doubt || self.doubt == 0.0
    }

    /// Whether the ray's own numbers leave the sign open.
    fn is_undecidable(&self) -> bool {
        self.value.abs() <= self.input_doubt && self.input_doubt > 0.0
    }

    /// Of two calls the closer one.
    pub fn closer(self, other: Self) -> Self {
        let room = |call: &Self| call.value.abs() / call.input_doubt;
        if room(&other) < room(&self) { other } else { self }
    }
}

/// A primitive whose crossings come from one solver.
pub(super) trait Solver: Primitive + Sized {
    /// What the solver finds, with all that its working shows.
    type Found<A: Real>;

    /// Solves in one arithmetic.
    fn solve<A: Real>(&self, ray: &GenericRay<A>) -> Attempt<Self::Found<A>>;

    /// The same as far as it takes to know the first crossing with t > 0, if that is less.
    #[inline]
    fn solve_ahead<A: Real>(&self, ray: &GenericRay<A>) -> Attempt<Self::Found<A>> {
        self.solve(ray)
    }

    /// The closest decision on the way to `found`.
    fn closest_call<A: Real>(&self, ray: &GenericRay<A>, found: &Self::Found<A>) -> Call;

    /// What the ray does at its first root. After a touch the others touch too, else they go out and in by turns.
    fn first_sense<A: Real>(&self, _ray: &GenericRay<A>) -> Sense {
        Sense::Enter
    }

    /// The places where the ray crosses the surface, ascending.
    fn roots<'a, A: Real>(&self, ray: &'a GenericRay<'a, A>, found: &'a Self::Found<A>) -> impl Boundaries;

    /// The working, as it is shown.
    fn working<A: Real>(&self, ray: &GenericRay<A>, found: &Self::Found<A>) -> Vec<Entry>;

    /// d(t) and its signs, as they are shown.
    fn signs<A: Real>(&self, ray: &GenericRay<A>, _found: &Self::Found<A>, crossings: &[Crossing]) -> Entry {
        report::implicit(self, ray, crossings)
    }

    /// The hit times that were looked at and do not count.
    fn rejected<A: Real>(&self, ray: &GenericRay<A>, found: &Self::Found<A>, crossings: &[Crossing]) -> Vec<Candidate>;
}

/// Appends the crossings of a primitive, and reports how they were found.
#[inline]
pub(super) fn crossings<A: Real, R: Recorder>(
    solver: &impl Solver,
    ray: &GenericRay<A>,
    recorder: &mut R,
    crossings: &mut Crossings,
) {
    let attempt = solver.solve(ray);
    if attempt.decided || A::FINEST {
        let certificate =
            if attempt.decided { Certificate::Certain } else { verdict(&solver.closest_call(ray, &attempt.found)) };
        deliver(solver, ray, &attempt.found, certificate, recorder, crossings, || vec![tier(solver, ray)]);
    } else {
        fall_back(solver, ray, recorder, crossings);
    }
}

/// The first crossing with t > 0, and nothing told.
#[inline]
pub(super) fn first_crossing<A: Real>(solver: &impl Solver, approach: &impl Approach) -> Option<Crossing> {
    let ray = approach.generic::<A>();
    let attempt = solver.solve_ahead(&ray);
    let certificate = if attempt.decided {
        Certificate::Certain
    } else if A::FINEST {
        verdict(&solver.closest_call(&ray, &attempt.found))
    } else {
        return first_crossing_after_fallback::<A>(solver, approach);
    };
    solver.roots(&ray, &attempt.found).first_ahead(solver.first_sense(&ray), ray.t_per_tau, certificate)
}

/// The same with 32 digits.
#[cold]
#[inline(never)]
fn first_crossing_after_fallback<A: Real>(solver: &impl Solver, approach: &impl Approach) -> Option<Crossing> {
    let mut crossings = Crossings::new();
    fall_back(solver, &approach.generic::<A>(), &mut NullRecorder, &mut crossings);
    crossings.into_iter().find(|crossing| crossing.t > 0.0)
}

/// Solves once more with 32 digits.
#[cold]
#[inline(never)]
fn fall_back<A: Real, R: Recorder>(
    solver: &impl Solver,
    ray: &GenericRay<A>,
    recorder: &mut R,
    crossings: &mut Crossings,
) {
    let wide = ray.widen();
    let Attempt { found, .. } = solver.solve(&wide);
    let certificate = verdict(&solver.closest_call(&wide, &found));
    let tiers = || vec![tier(solver, ray), tier(solver, &wide)];
    deliver(solver, &wide, &found, certificate, recorder, crossings, tiers);
}

/// How sure an answer is that the first arithmetic could not give.
fn verdict(call: &Call) -> Certificate {
    if call.is_undecidable() { Certificate::Undecidable } else { Certificate::Fallback }
}

/// Appends the crossings, and tells all about them; `tiers` are the attempts, the last of which decided.
#[inline]
fn deliver<S: Solver, A: Real, R: Recorder>(
    solver: &S,
    ray: &GenericRay<A>,
    found: &S::Found<A>,
    certificate: Certificate,
    recorder: &mut R,
    crossings: &mut Crossings,
    tiers: impl FnOnce() -> Vec<(Tier, Call)>,
) {
    let begin = crossings.len();
    solver.roots(ray, found).append(solver.first_sense(ray), ray.t_per_tau, certificate, crossings);
    if R::RECORDING {
        let own = &crossings[begin..];
        let working =
            if recorder.is_measuring() { shown(solver, &ray.shadowed()) } else { shown(solver, &ray.traced()) };
        for entry in working {
            recorder.note(|| entry);
        }
        recorder.note(|| decision(tiers(), ray.t_per_tau, certificate));
        recorder.note(|| solver.signs(ray, found, own));
        recorder.note(|| report::roots(solver, ray, own, solver.rejected(ray, found, own)));
    }
}

/// The working, solved once more with numbers that keep account of their errors.
fn shown<A: Real>(solver: &impl Solver, ray: &GenericRay<A>) -> Vec<Entry> {
    solver.working(ray, &solver.solve(ray).found)
}

/// The closest decision, as every arithmetic that was tried saw it.
fn decision(tiers: Vec<(Tier, Call)>, t_per_tau: f64, certificate: Certificate) -> Entry {
    let (question, input_doubt, near) = tiers
        .last()
        .map(|(_, call)| (call.question.to_owned(), call.input_doubt, call.near * t_per_tau))
        .unwrap_or_default();
    let tiers = tiers.into_iter().map(|(tier, _)| tier).collect();
    let near = near.is_finite().then_some(near);
    Entry::new(What::Decision { question, tiers, input_doubt, near, certificate })
}

/// One arithmetic's attempt, with what it took.
fn tier<A: Real>(solver: &impl Solver, ray: &GenericRay<A>) -> (Tier, Call) {
    let traced: GenericRay<Traced<A>> = ray.traced();
    let (attempt, operations) = counted(|| solver.solve(&traced));
    let call = solver.closest_call(&traced, &attempt.found);
    let tier = Tier {
        arithmetic: A::NAME.to_owned(),
        value: call.value,
        doubt: call.doubt,
        decided: attempt.decided,
        operations,
        f64_operations: operations * A::F64_OPERATIONS,
    };
    (tier, call)
}
