//! A ray against planes: the plane table of § 6.2.3, for the cube and for convex polyhedra.
//!
//! Inside a plane is n·p ≤ d. Along the ray n·p − d changes at the rate n·c, so the ray crosses at
//! t = (d − n·S) / (n·c), going in where n·c < 0 and out where n·c > 0. It is inside all planes from the latest
//! entering time to the earliest leaving time (Cyrus and Beck, Computers & Graphics 3, 1978).
//!
//! Each time carries a bound on its error. Where the bounds leave open whether the ray hits, or whether it runs beside a
//! plane, nothing is guessed: the table is worked out once more with 32 digits, and what these cannot tell apart is equal.

use super::{Crossing, GenericRay, Part, Primitive, boundary, boundary::Root, report};
use crate::math::{Real, dot};
use crate::record::{Candidate, Certificate, Entry, PlaneRow, PlaneSense, Recorder, Sense, Value, What, format_number};
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

/// A number that is known to lie between two bounds.
#[derive(Clone, Copy, Debug)]
struct Known<A> {
    low: A,
    high: A,
}

/// The latest entering or earliest leaving time so far, and the plane that it belongs to.
#[derive(Clone, Copy, Debug)]
struct Extreme<A> {
    time: A,
    plane: usize,
    known: Known<A>,
}

/// What came of a row of the table, for those who want to see it.
#[derive(Clone, Copy, Debug)]
struct Step<A> {
    plane: usize,
    numerator: A,
    denominator: A,
    time: Option<A>,
    sense: PlaneSense,
    t_in: Option<A>,
    t_out: Option<A>,
}

/// The times between which the ray is inside all planes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Clip {
    /// The latest entering time and its plane; none if no plane is entered.
    pub enter: Option<Root>,
    /// The earliest leaving time and its plane; none if no plane is left.
    pub leave: Option<Root>,
    /// Whether the ray is inside anywhere.
    pub hits: bool,
}

/// The table with its running results.
struct Table<'a, A> {
    ray: &'a GenericRay<'a, A>,
    t_in: Option<Extreme<A>>,
    t_out: Option<Extreme<A>>,
    undecided: bool,
}

impl<A: Real> Table<'_, A> {
    /// Works out one row. The ray surely misses when the answer is false.
    fn row(&mut self, index: usize, plane: &HalfSpace, observe: &mut impl FnMut(Step<A>)) -> bool {
        let normal = plane.normal.to_array().map(A::from_f64);
        let offset = A::from_f64(plane.offset);
        let (numerator, doubt) = less_product(offset, normal, self.ray.origin);
        let (negative_denominator, slope_doubt) = less_product(A::ZERO, normal, self.ray.direction);
        let denominator = -negative_denominator;
        let parallel = denominator.abs() <= slope_doubt;
        let time = if parallel { None } else { Some(numerator / denominator) };
        let sense = match time {
            None if numerator < -doubt => PlaneSense::ParallelOutside,
            None => PlaneSense::ParallelInside,
            Some(_) if denominator < A::ZERO => PlaneSense::Entering,
            Some(_) => PlaneSense::Leaving,
        };
        if parallel && slope_doubt > A::ZERO && !A::FINEST || parallel && numerator < A::ZERO && numerator >= -doubt {
            self.undecided = true;
        }
        if let Some(time) = time {
            let error = (doubt + time.abs() * slope_doubt) / denominator.abs()
                + A::from_f64(2.0 * A::UNIT_ROUNDOFF) * time.abs();
            self.take(index, time, error, sense == PlaneSense::Entering);
        }
        let (t_in, t_out) = (self.t_in.map(|x| x.time), self.t_out.map(|x| x.time));
        observe(Step { plane: index, numerator, denominator, time, sense, t_in, t_out });
        let passed = self.t_in.zip(self.t_out).is_some_and(|(enter, leave)| enter.known.low > leave.known.high);
        !passed && sense != PlaneSense::ParallelOutside
    }

    /// Moves the entering time on, or the leaving time back.
    fn take(&mut self, plane: usize, time: A, error: A, entering: bool) {
        let known = Known { low: time - error, high: time + error };
        let slot = if entering { &mut self.t_in } else { &mut self.t_out };
        let new = Extreme { time, plane, known };
        *slot = Some(match *slot {
            None => new,
            Some(old) => {
                let replaces = if entering { time > old.time } else { time < old.time };
                let known = if entering {
                    Known { low: old.known.low.max(known.low), high: old.known.high.max(known.high) }
                } else {
                    Known { low: old.known.low.min(known.low), high: old.known.high.min(known.high) }
                };
                Extreme { known, ..if replaces { new } else { old } }
            }
        });
    }
}

/// a − n·v and a bound on its error.
fn less_product<A: Real>(a: A, n: [A; 3], v: [A; 3]) -> (A, A) {
    let size = a.abs() + (n[0] * v[0]).abs() + (n[1] * v[1]).abs() + (n[2] * v[2]).abs();
    (a - dot(n, v), size * A::from_f64(4.0 * A::UNIT_ROUNDOFF))
}

/// Fills in the table in the ray's own arithmetic; none where that cannot decide whether the ray hits.
fn clip_once<A: Real>(
    ray: &GenericRay<A>,
    planes: impl Iterator<Item = (usize, HalfSpace)>,
    observe: &mut impl FnMut(Step<A>),
) -> Option<Clip> {
    let mut table = Table { ray, t_in: None, t_out: None, undecided: false };
    for (index, plane) in planes {
        if !table.row(index, &plane, observe) {
            return Some(table.result(false));
        }
    }
    let hits = match table.t_in.zip(table.t_out) {
        None => true,
        Some((enter, leave)) if enter.known.high < leave.known.low => true,
        Some((enter, leave)) if A::FINEST => enter.time < leave.time,
        Some(_) => return None,
    };
    if table.undecided && !A::FINEST { None } else { Some(table.result(hits)) }
}

impl<A: Real> Table<'_, A> {
    fn result(&self, hits: bool) -> Clip {
        let root = |extreme: Extreme<A>| Root {
            tau: extreme.time.to_f64(),
            error: (extreme.known.high - extreme.known.low).to_f64(),
            part: Part::try_from(extreme.plane).unwrap_or(Part::MAX),
        };
        Clip { enter: self.t_in.map(root), leave: self.t_out.map(root), hits }
    }
}

/// The stretch of the ray inside all planes, each given with its number.
pub(super) fn clip<A: Real>(ray: &GenericRay<A>, planes: impl Iterator<Item = (usize, HalfSpace)> + Clone) -> Clip {
    let decided = clip_once(ray, planes.clone(), &mut |_| ()).or_else(|| clip_once(&ray.widen(), planes, &mut |_| ()));
    decided.unwrap_or(Clip { enter: None, leave: None, hits: false })
}

/// All that a primitive made of planes does with a ray.
pub(super) fn crossings<A: Real, R: Recorder>(
    shape: &impl Primitive,
    planes: &[HalfSpace],
    ray: &GenericRay<A>,
    recorder: &mut R,
    crossings: &mut Vec<Crossing>,
) {
    let begin = crossings.len();
    let numbered = planes.iter().copied().enumerate();
    let mut rows = Vec::new();
    let names = if R::RECORDING { shape.parts() } else { Vec::new() };
    let first = clip_once(ray, numbered.clone(), &mut |step| {
        if R::RECORDING {
            rows.push(row(&step, ray, planes, &names));
        }
    });
    let clip = first.unwrap_or_else(|| {
        rows.clear();
        let wide = ray.widen();
        let second = clip_once(&wide, numbered, &mut |step| {
            if R::RECORDING {
                rows.push(row(&step, &wide, planes, &names));
            }
        });
        second.unwrap_or(Clip { enter: None, leave: None, hits: false })
    });
    if let Clip { enter: Some(enter), leave: Some(leave), hits: true } = clip {
        boundary::append_alternating(&[enter, leave], Sense::Enter, ray.t_per_tau, Certificate::Certain, crossings);
    }
    let found = &crossings[begin..];
    if R::RECORDING {
        let rejected = rejected(shape, ray, &rows, found);
        recorder.note(|| table_entry(rows, planes.len(), ray));
        recorder.note(|| report::implicit(shape, ray, found));
        recorder.note(|| report::roots(shape, ray, found, rejected));
    }
}

/// A row in the terms of the shared t.
fn row<A: Real>(step: &Step<A>, ray: &GenericRay<A>, planes: &[HalfSpace], names: &[String]) -> PlaneRow {
    let plane = planes[step.plane];
    let t = |tau: A| tau.to_f64() * ray.t_per_tau;
    PlaneRow {
        plane: step.plane,
        name: names.get(step.plane).cloned().unwrap_or_default(),
        normal: plane.normal.to_array(),
        spot: plane.spot().to_array(),
        numerator: step.numerator.to_f64(),
        denominator: step.denominator.to_f64() / ray.t_per_tau,
        t: step.time.map(t),
        sense: step.sense,
        t_in: step.t_in.map(t),
        t_out: step.t_out.map(t),
    }
}

/// The table with the working of its last row, which decided it.
fn table_entry<A: Real>(rows: Vec<PlaneRow>, planes: usize, ray: &GenericRay<A>) -> Entry {
    let stopped = rows.last().and_then(|row| stop_reason(row, rows.len() == planes));
    let last = rows.last().cloned();
    let mut entry = Entry::new(What::Planes { rows, stopped });
    if let Some(row) = last {
        entry = row_working(entry, &row, ray);
    }
    entry
}

/// numerator, denominator and t of one row, as they are worked out.
fn row_working<A: Real>(entry: Entry, row: &PlaneRow, ray: &GenericRay<A>) -> Entry {
    let bindings = [
        ("m", Value::Vector(row.normal)),
        ("spot", Value::Vector(row.spot)),
        ("S", report::start(ray)),
        ("c", report::course(ray)),
        ("numerator", Value::Number(row.numerator)),
        ("denominator", Value::Number(row.denominator)),
    ];
    let entry = entry.line("numerator", "m·(spot − S)", &bindings, row.numerator).line(
        "denominator",
        "m·c",
        &bindings,
        row.denominator,
    );
    match row.t {
        Some(t) => entry.line("t", "numerator / denominator", &bindings, t),
        None => entry,
    }
}

/// Why the ray misses, if the last row that was worked out says so.
fn stop_reason(row: &PlaneRow, complete: bool) -> Option<String> {
    if row.sense == PlaneSense::ParallelOutside {
        return Some(format!("the ray runs beside {} on its outside, so it misses", row.name));
    }
    let (t_in, t_out) = (row.t_in?, row.t_out?);
    (t_in > t_out || !complete)
        .then(|| format!("t_in = {} > t_out = {}, so the ray misses", format_number(t_in), format_number(t_out)))
}

/// The hit times of the table that are not on the solid.
fn rejected<A: Real>(
    shape: &impl Primitive,
    ray: &GenericRay<A>,
    rows: &[PlaneRow],
    found: &[Crossing],
) -> Vec<Candidate> {
    let accepted = |row: &PlaneRow| found.iter().any(|crossing| usize::from(crossing.part) == row.plane);
    rows.iter()
        .filter(|row| !accepted(row))
        .filter_map(|row| {
            let sense = if row.sense == PlaneSense::Entering { Sense::Enter } else { Sense::Leave };
            let reason = match (found, sense) {
                ([enter, _], Sense::Enter) => {
                    format!("other planes are entered later, the last at t = {}", format_number(enter.t))
                }
                ([_, leave], _) => {
                    format!("another plane is left earlier, at t = {}", format_number(leave.t))
                }
                _ => "at no time is the ray inside all planes".to_owned(),
            };
            let part = Part::try_from(row.plane).unwrap_or(Part::MAX);
            Some(report::rejected(shape, ray, (row.t? / ray.t_per_tau, part, sense), reason))
        })
        .collect()
}

/// The table of the one plane z = 0, for the plane and the square.
pub(super) fn single_row<A: Real>(ray: &GenericRay<A>, name: &str) -> Entry {
    let plane = HalfSpace { normal: DVec3::Z, offset: 0.0 };
    axis_table(ray, &[(plane, name)])
}

/// The table of planes across the z axis, for shapes that have such planes among their parts.
pub(super) fn axis_table<A: Real>(ray: &GenericRay<A>, planes: &[(HalfSpace, &str)]) -> Entry {
    let names: Vec<_> = planes.iter().map(|(_, name)| (*name).to_owned()).collect();
    let half_spaces: Vec<_> = planes.iter().map(|(plane, _)| *plane).collect();
    let mut rows = Vec::new();
    let numbered = half_spaces.iter().copied().enumerate();
    let _ = clip_once(&ray.widen(), numbered, &mut |step| rows.push(row(&step, &ray.widen(), &half_spaces, &names)));
    table_entry(rows, half_spaces.len(), ray)
}
