//! The plane table as it is shown: a row for each plane, filled in as on paper (§ 6.2.3).

use super::planes::{HalfSpace, Step, clip};
use super::{Crossing, GenericRay, Part, Primitive, report};
use crate::math::Real;
use crate::record::{Candidate, Entry, PlaneRow, PlaneSense, Sense, Value, What, format_number};
use glam::DVec3;

/// The table of a primitive made of planes, as far as it was needed.
pub(super) fn table<A: Real>(planes: &[HalfSpace], names: &[String], ray: &GenericRay<A>) -> Entry {
    let steps = steps(planes, ray);
    let rows: Vec<_> = steps.iter().map(|step| row(step, ray, planes, names)).collect();
    let stopped = rows.last().and_then(|row| stop_reason(row, rows.len() == planes.len()));
    let last = rows.last().cloned();
    let entry = Entry::new(What::Planes { rows, stopped });
    match last.zip(steps.last()) {
        Some((row, step)) => row_working(entry, &row, step, ray),
        None => entry,
    }
}

/// The rows in the solver's own numbers.
fn steps<A: Real>(planes: &[HalfSpace], ray: &GenericRay<A>) -> Vec<Step<A>> {
    let mut steps = Vec::new();
    clip(ray, planes.iter().copied().enumerate(), |step| steps.push(step));
    steps
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

/// numerator, denominator and t of the row that decided, as they are worked out.
fn row_working<A: Real>(entry: Entry, row: &PlaneRow, step: &Step<A>, ray: &GenericRay<A>) -> Entry {
    let scale = ray.t_per_tau;
    let numerator = report::measured(step.numerator, 1.0);
    let denominator = report::measured(step.denominator, 1.0 / scale);
    let bindings = [
        ("m", Value::Vector(row.normal)),
        ("spot", Value::Vector(row.spot)),
        ("S", report::start(ray)),
        ("c", report::course(ray)),
        ("numerator", Value::Number(numerator.value)),
        ("denominator", Value::Number(denominator.value)),
    ];
    let entry = entry.line("numerator", "m·(spot − S)", &bindings, numerator).line(
        "denominator",
        "m·c",
        &bindings,
        denominator,
    );
    match step.time {
        Some(time) => entry.line("t", "numerator / denominator", &bindings, report::measured(time, scale)),
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
pub(super) fn rejected<A: Real>(
    shape: &impl Primitive,
    planes: &[HalfSpace],
    ray: &GenericRay<A>,
    found: &[Crossing],
) -> Vec<Candidate> {
    let accepted = |step: &Step<A>| found.iter().any(|crossing| usize::from(crossing.part) == step.plane);
    steps(planes, ray)
        .into_iter()
        .filter(|step| !accepted(step))
        .filter_map(|step| {
            let sense = if step.sense == PlaneSense::Entering { Sense::Enter } else { Sense::Leave };
            let reason = match (found, sense) {
                ([enter, _], Sense::Enter) => {
                    format!("other planes are entered later, the last at t = {}", format_number(enter.t))
                }
                ([_, leave], _) => {
                    format!("another plane is left earlier, at t = {}", format_number(leave.t))
                }
                _ => "at no time is the ray inside all planes".to_owned(),
            };
            let part = Part::try_from(step.plane).unwrap_or(Part::MAX);
            Some(report::rejected(shape, ray, (step.time?.to_f64(), part, sense), reason))
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
    table(&half_spaces, &names, ray)
}
