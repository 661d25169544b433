//! A ray against planes: the solver behind the plane table of § 6.2.3.
//!
//! Inside a plane is n·p ≤ d. Along the ray n·p − d changes at the rate n·c, so the ray crosses at
//! t = (d − n·S) / (n·c), going in where n·c < 0 and out where n·c > 0. It is inside all planes from the latest
//! entering time to the earliest leaving time (Cyrus and Beck, Computers & Graphics 3, 1978).
//!
//! Each time carries a bound on its error. Where the bounds leave open whether the ray hits, or whether it runs beside a
//! plane, the answer counts as undecided.

use super::boundary::Root;
use super::solver::{Attempt, Call};
use super::{GenericRay, Part};
use crate::math::{Real, dot};
use crate::record::PlaneSense;
use glam::DVec3;

/// A plane with its inside: n·p ≤ d, where n need not be unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HalfSpace {
    /// n, outward.
    pub normal: DVec3,
    /// d.
    pub offset: f64,
}

impl HalfSpace {
    /// The point of the plane that is nearest to the origin.
    #[must_use]
    pub fn spot(&self) -> DVec3 {
        let scale = crate::math::scale_to_unit(self.normal.to_array());
        let normal = self.normal * scale;
        normal * (self.offset * scale / normal.length_squared())
    }
}

/// The latest entering or earliest leaving time so far, and the plane that it belongs to.
#[derive(Clone, Copy, Debug)]
pub(super) struct Extreme<A> {
    /// The time.
    pub time: A,
    /// The plane's number.
    pub plane: usize,
    /// Bounds of the true latest or earliest time, whichever plane's it is.
    low: A,
    high: A,
}

/// A row of the table, and what has come of it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Step<A> {
    /// The plane's number.
    pub plane: usize,
    /// d − n·S.
    pub numerator: A,
    /// n·c.
    pub denominator: A,
    /// Their quotient, unless parallel.
    pub time: Option<A>,
    /// How the ray stands to the plane.
    pub sense: PlaneSense,
    /// The latest entering time so far.
    pub t_in: Option<A>,
    /// The earliest leaving time so far.
    pub t_out: Option<A>,
}

/// The stretch of the ray inside all planes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Clip<A> {
    /// The latest entering time; none if no plane is entered.
    pub enter: Option<Extreme<A>>,
    /// The earliest leaving time; none if no plane is left.
    pub leave: Option<Extreme<A>>,
    /// Whether the ray is inside anywhere.
    pub hits: bool,
    /// The tightest passage beside a plane that the ray is parallel to.
    beside: Option<Call>,
}

/// The table with its running results.
struct Table<'a, A> {
    ray: &'a GenericRay<'a, A>,
    clip: Clip<A>,
    decided: bool,
}

/// Fills in the table row by row, until the ray surely misses; `observe` sees every row.
#[inline]
pub(super) fn clip<A: Real>(
    ray: &GenericRay<A>,
    planes: impl Iterator<Item = (usize, HalfSpace)>,
    mut observe: impl FnMut(Step<A>),
) -> Attempt<Clip<A>> {
    let clip = Clip { enter: None, leave: None, hits: false, beside: None };
    let mut table = Table { ray, clip, decided: true };
    for (index, plane) in planes {
        if !table.row(index, &plane, &mut observe) {
            return Attempt { found: table.clip, decided: table.decided };
        }
    }
    let surely = table.clip.bounds().is_none_or(|(enter, leave)| enter.high < leave.low);
    let hits = surely || !A::DOUBT_IS_ZERO && table.clip.bounds().is_some_and(|(enter, leave)| enter.time < leave.time);
    Attempt { found: Clip { hits, ..table.clip }, decided: table.decided && surely }
}

impl<A: Real> Table<'_, A> {
    /// Works out one row. The ray misses when the answer is false.
    #[inline]
    fn row(&mut self, index: usize, plane: &HalfSpace, observe: &mut impl FnMut(Step<A>)) -> bool {
        let normal = plane.normal.to_array().map(A::from_f64);
        let numerator = A::from_f64(plane.offset) - dot(normal, self.ray.origin);
        let denominator = dot(normal, self.ray.direction);
        let rounding = 4.0 * A::UNIT_ROUNDOFF;
        let doubt = rounding * (plane.offset.abs() + weighed(plane.normal, self.ray.origin_size));
        let slope_doubt = rounding * weighed(plane.normal, self.ray.direction_size);
        let parallel = denominator.abs().to_f64() <= slope_doubt;
        let time = (!parallel).then(|| numerator / denominator);
        let outside = parallel && numerator.to_f64() < -doubt;
        let sense = match time {
            None if outside => PlaneSense::ParallelOutside,
            None => PlaneSense::ParallelInside,
            Some(_) if denominator < A::ZERO => PlaneSense::Entering,
            Some(_) => PlaneSense::Leaving,
        };
        if let Some(time) = time {
            let error = (doubt + time.abs().to_f64() * slope_doubt) / denominator.abs().to_f64()
                + 2.0 * A::UNIT_ROUNDOFF * time.abs().to_f64();
            self.take(index, time, A::from_f64(error), sense == PlaneSense::Entering);
        } else {
            let input_doubt = doubt / (4.0 * A::UNIT_ROUNDOFF) * f64::UNIT_ROUNDOFF;
            self.runs_beside(numerator.to_f64(), doubt, input_doubt);
            self.decided &= slope_doubt == 0.0 && numerator.abs().to_f64() > doubt;
        }
        let (t_in, t_out) = (self.clip.enter.map(|x| x.time), self.clip.leave.map(|x| x.time));
        observe(Step { plane: index, numerator, denominator, time, sense, t_in, t_out });
        !self.clip.surely_misses() && !outside
    }

    /// Keeps the closest decision on the side of a parallel plane.
    fn runs_beside(&mut self, value: f64, doubt: f64, input_doubt: f64) {
        let question = "Does the ray run beside the plane on its inside?";
        let near = self.clip.bounds().map_or(f64::NAN, |(enter, leave)| 0.5 * (enter.time + leave.time).to_f64());
        let call = Call { question, value, doubt, input_doubt, near };
        self.clip.beside = Some(self.clip.beside.map_or(call, |other| other.closer(call)));
    }

    /// Moves the entering time on, or the leaving time back.
    #[inline]
    fn take(&mut self, plane: usize, time: A, error: A, entering: bool) {
        let slot = if entering { &mut self.clip.enter } else { &mut self.clip.leave };
        let new = Extreme { time, plane, low: time - error, high: time + error };
        *slot = Some(match *slot {
            None => new,
            Some(old) if entering => {
                let (low, high) = (old.low.max(new.low), old.high.max(new.high));
                Extreme { low, high, ..if time > old.time { new } else { old } }
            }
            Some(old) => {
                let (low, high) = (old.low.min(new.low), old.high.min(new.high));
                Extreme { low, high, ..if time < old.time { new } else { old } }
            }
        });
    }
}

/// Σ |nᵢ| sᵢ.
#[inline]
fn weighed(normal: DVec3, size: [f64; 3]) -> f64 {
    normal.x.abs() * size[0] + normal.y.abs() * size[1] + normal.z.abs() * size[2]
}

impl<A: Real> Clip<A> {
    fn bounds(&self) -> Option<(Extreme<A>, Extreme<A>)> {
        self.enter.zip(self.leave)
    }

    fn surely_misses(&self) -> bool {
        self.bounds().is_some_and(|(enter, leave)| enter.low > leave.high)
    }

    /// The closest decision: whether the ray enters before it leaves, or on which side of a parallel plane it runs.
    pub fn closest_call(&self, ray: &GenericRay<A>, planes: &[HalfSpace]) -> Call {
        let question = "Does the ray enter the last plane before it leaves the first?";
        let never = Call { question, value: f64::INFINITY, doubt: 0.0, input_doubt: 0.0, near: f64::NAN };
        let order = self.bounds().map_or(never, |(enter, leave)| {
            let half = |extreme: Extreme<A>| 0.5 * (extreme.high - extreme.low).to_f64();
            let moved = |extreme: Extreme<A>| input_error(ray, &planes[extreme.plane], extreme.time.to_f64());
            Call {
                question,
                value: (leave.time - enter.time).to_f64(),
                doubt: half(enter) + half(leave),
                input_doubt: moved(enter) + moved(leave),
                near: 0.5 * (enter.time + leave.time).to_f64(),
            }
        });
        self.beside.map_or(order, |beside| beside.closer(order))
    }

    /// Where the ray enters and leaves, if it hits.
    #[inline]
    pub fn roots(&self, ray: &GenericRay<A>, planes: &[HalfSpace]) -> Option<[Root; 2]> {
        let root = |extreme: Extreme<A>| {
            let (tau, normal) = (extreme.time.to_f64(), planes[extreme.plane].normal.to_array());
            Root { tau, error: ray.root_error(normal, tau), part: Part::try_from(extreme.plane).unwrap_or(Part::MAX) }
        };
        self.bounds().filter(|_| self.hits).map(|(enter, leave)| [root(enter), root(leave)])
    }
}

/// How far the time of a plane moves when the ray's own numbers and the plane's move by half a unit in their last places.
fn input_error<A: Real>(ray: &GenericRay<A>, plane: &HalfSpace, tau: f64) -> f64 {
    let slope = dot(plane.normal.to_array(), ray.direction.map(Real::to_f64)).abs();
    f64::UNIT_ROUNDOFF * (weighed(plane.normal, ray.sway(tau)) + plane.offset.abs()) / slope
}
