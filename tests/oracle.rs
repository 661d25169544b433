//! The solvers against hits that were computed with 40 digits: nothing missed, nothing invented, nothing misplaced.
//!
//! `oracle/README.md` says what the numbers mean and when a solver is right.

use glam::DVec3;
use rayscope::accuracy::judge;
use rayscope::accuracy::oracle::{Case, Target, cases};
use rayscope::math::{DoubleDouble, Real};
use rayscope::record::{NullRecorder, Sense};
use rayscope::shape::{Crossing, Crossings, GenericRay, HalfSpace, Part, Primitive, Shape};

/// Cases that are judged wrong today, with the reason. A cure has to take them off this list.
const KNOWN_FAILURES: &[(&str, &str)] = &[];

/// The largest error that any hit may have, in units of what the input's last digit can move it by.
const WORST_ERROR: f64 = 16.0;

fn solve<A: Real>(shape: &Shape, case: &Case) -> Crossings {
    let mut crossings = Crossings::new();
    let ray = GenericRay::<A>::new(case.origin, case.direction);
    shape.crossings(&ray, &mut NullRecorder, &mut crossings);
    crossings
}

/// Whether the oracle's name of a surface means our part.
fn same_surface(oracle: &str, part: &str) -> bool {
    let renamed = match oracle {
        "+y" => "top",
        "-y" => "bottom",
        "+x" => "right",
        "-x" => "left",
        "+z" => "front",
        "-z" => "back",
        "side" => "wall",
        "sphere" | "torus" | "super" | "square" => "surface",
        other => other,
    };
    renamed == part || oracle.strip_prefix('f').is_some_and(|k| part.strip_prefix("plane ") == Some(k))
}

/// Sense, part and normal of each crossing of a case whose structure is beyond doubt.
fn check_surfaces(shape: &Shape, case: &Case, crossings: &[Crossing]) -> Result<(), String> {
    if crossings.len() != case.hits.len() {
        return Err(format!("{} hits for {}", crossings.len(), case.hits.len()));
    }
    let parts = shape.parts();
    for (crossing, hit) in crossings.iter().zip(&case.hits) {
        let sense = match crossing.sense {
            Sense::Enter => "in",
            Sense::Leave => "out",
            Sense::Touch => "touch",
        };
        if sense != hit.side {
            return Err(format!("{sense} for {}", hit.side));
        }
        let part = &parts[usize::from(crossing.part)];
        let ray = GenericRay::<f64>::new(case.origin, case.direction);
        let point = ray.point(crossing.t / ray.t_per_tau);
        // What rounding of the inputs does to the point, in units of the object.
        let blur = 8.0 * f64::EPSILON * (case.origin.abs().max_element() + 2.0);
        let Some(k) = hit.surfaces.iter().position(|surface| same_surface(surface, part)) else {
            // Within rounding of an edge either face will do.
            if from_part(shape, crossing.part, point) <= blur {
                continue;
            }
            return Err(format!("part {part} for {:?}", hit.surfaces));
        };
        let Some(Some(expected)) = hit.normals.get(k) else { continue };
        let normal = shape.normal(point, crossing.part).normalize();
        let moved = blur + hit.floor * case.direction.length();
        let tolerance = 1e-14 + bending(shape, point) * moved;
        if (normal - *expected).length() > tolerance {
            return Err(format!("normal {normal} for {expected}, more than {tolerance:e} off"));
        }
    }
    Ok(())
}

/// How far a point is from the surface of which the part is a piece.
fn from_part(shape: &Shape, part: Part, point: DVec3) -> f64 {
    match shape {
        Shape::Cube(cube) => (cube.normal(point, part).dot(point) - 1.0).abs(),
        Shape::ConvexPolyhedron(solid) => {
            let HalfSpace { normal, offset } = solid.planes()[usize::from(part)];
            (normal.dot(point) - offset).abs() / normal.length()
        }
        Shape::TaperedCylinder(solid) => {
            let wall = point.truncate().length() - solid.radius(point.z);
            [wall, point.z, point.z - 1.0][usize::from(part)].abs()
        }
        _ => 0.0,
    }
}

/// How fast the unit normal turns as the point moves.
fn bending(shape: &Shape, point: DVec3) -> f64 {
    let to_axis = 1.0 / point.truncate().length();
    match shape {
        Shape::TaperedCylinder(_) | Shape::Torus(_) => 4.0 + 4.0 * to_axis,
        // Sharp edges and tips: unlimited.
        Shape::Superellipsoid(_) => f64::INFINITY,
        _ => 4.0,
    }
}

fn check<A: Real>(file: &str) {
    let (mut missed, mut extra, mut worst) = (0, 0, (0.0, String::new()));
    let mut problems = Vec::new();
    let cases = cases(file).unwrap();
    for case in &cases {
        let Target::Shape(shape) = &case.target else { panic!("{file} has primitives alone") };
        let crossings = solve::<A>(shape, case);
        let ends: Vec<_> = crossings.iter().map(|crossing| crossing.t).collect();
        let verdict = judge(case, &ends, 1.0);
        missed += verdict.missed;
        extra += verdict.extra;
        if verdict.error > worst.0 {
            worst = (verdict.error, case.id.clone());
        }
        let surfaces = if case.ambiguous { Ok(()) } else { check_surfaces(shape, case, &crossings) };
        let wrong = verdict.missed + verdict.extra > 0 || surfaces.is_err() || verdict.error > WORST_ERROR;
        let known = KNOWN_FAILURES.iter().any(|(id, _)| *id == case.id);
        if wrong && !known {
            problems.push(format!(
                "{}: {} missed, {} extra, error {:.1}, {surfaces:?}: {ends:?} for {:?}",
                case.id,
                verdict.missed,
                verdict.extra,
                verdict.error,
                case.hits.iter().map(|hit| hit.t).collect::<Vec<_>>()
            ));
        } else if known && !wrong {
            problems.push(format!("{} is right now: take it off the list", case.id));
        }
    }
    println!(
        "{file}: {} cases, {missed} missed, {extra} extra, largest error {:.2} ({})",
        cases.len(),
        worst.0,
        worst.1
    );
    assert!(problems.is_empty(), "{} problems\n{}", problems.len(), problems.join("\n"));
}

macro_rules! oracle_tests {
    ($($file:ident $with_more_digits:ident)*) => { $(
        #[test]
        fn $file() {
            check::<f64>(stringify!($file));
        }

        #[test]
        fn $with_more_digits() {
            check::<DoubleDouble>(stringify!($file));
        }
    )* };
}

oracle_tests! {
    sphere sphere_with_32_digits
    square square_with_32_digits
    tapered tapered_with_32_digits
    cube cube_with_32_digits
    polyhedron polyhedron_with_32_digits
    torus torus_with_32_digits
    superellipsoid superellipsoid_with_32_digits
}
