//! The solvers against hits that were computed with 40 digits: nothing missed, nothing invented, nothing misplaced.
//!
//! `oracle/README.md` says what the numbers mean and when a solver is right.

use glam::DVec3;
use rayscope::math::{DoubleDouble, Real};
use rayscope::record::{NullRecorder, Sense};
use rayscope::shape::{
    ConvexPolyhedron, Crossing, Cube, GenericRay, HalfSpace, Part, Primitive, Shape, Sphere, Square, Superellipsoid,
    TaperedCylinder, Torus,
};
use serde_json::Value;

/// Cases that are judged wrong today, with the reason. A cure has to take them off this list.
const KNOWN_FAILURES: &[(&str, &str)] = &[];

/// The largest error that any hit may have, in units of what the input's last digit can move it by.
const WORST_ERROR: f64 = 16.0;

struct Zone {
    low: f64,
    high: f64,
    before: String,
    after: String,
    hits: u64,
}

struct Hit {
    t: f64,
    floor: f64,
    side: String,
    surfaces: Vec<String>,
    normals: Vec<Option<DVec3>>,
}

struct Case {
    id: String,
    shape: Shape,
    origin: DVec3,
    direction: DVec3,
    ambiguous: bool,
    hits: Vec<Hit>,
    zones: Vec<Zone>,
}

/// Numbers stand in quotes in the files, so that no JSON library rounds them.
fn number(value: &Value) -> f64 {
    value.as_str().unwrap().parse().unwrap()
}

fn vector(value: &Value) -> DVec3 {
    DVec3::new(number(&value[0]), number(&value[1]), number(&value[2]))
}

fn text(value: &Value) -> String {
    value.as_str().unwrap().to_owned()
}

fn list<T>(value: &Value, read: impl Fn(&Value) -> T) -> Vec<T> {
    value.as_array().unwrap().iter().map(read).collect()
}

fn shape(file: &str, parameters: &Value, polyhedra: &Value) -> Shape {
    let parameter = |name: &str| number(&parameters[name]);
    match file {
        "sphere" => Shape::Sphere(Sphere::new().unwrap()),
        "square" => Shape::Square(Square::new().unwrap()),
        "cube" => Shape::Cube(Cube::new().unwrap()),
        "tapered" => Shape::TaperedCylinder(TaperedCylinder::new(parameter("s")).unwrap()),
        "torus" => Shape::Torus(Torus::new(parameter("d")).unwrap()),
        "superellipsoid" => Shape::Superellipsoid(Superellipsoid::new(parameter("n"), parameter("m")).unwrap()),
        _ => {
            let planes = list(&polyhedra[parameters["shape"].as_str().unwrap()], |plane| HalfSpace {
                normal: vector(&plane["normal"]),
                offset: number(&plane["offset"]),
            });
            Shape::ConvexPolyhedron(ConvexPolyhedron::new(planes).unwrap())
        }
    }
}

fn cases(file: &str) -> Vec<Case> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/oracle");
    let read = |name: &str| std::fs::read_to_string(format!("{folder}/{name}")).unwrap();
    let polyhedra: Value = serde_json::from_str(&read("polyhedra.json")).unwrap();
    let mut shapes: Vec<(Value, Shape)> = Vec::new();
    read(&format!("{file}.jsonl"))
        .lines()
        .map(|line| {
            let case: Value = serde_json::from_str(line).unwrap();
            let parameters = &case["parameters"];
            if !shapes.iter().any(|(known, _)| known == parameters) {
                shapes.push((parameters.clone(), shape(file, parameters, &polyhedra)));
            }
            Case {
                id: text(&case["id"]),
                shape: shapes.iter().find(|(known, _)| known == parameters).unwrap().1.clone(),
                origin: vector(&case["origin"]),
                direction: vector(&case["direction"]),
                ambiguous: case["ambiguous"].as_bool().unwrap(),
                hits: list(&case["hits"], |hit| Hit {
                    t: number(&hit["t"]),
                    floor: number(&hit["floor"]),
                    side: text(&hit["side"]),
                    surfaces: list(&hit["surf"], text),
                    normals: list(&hit["normals"], |n| (!n.is_null()).then(|| vector(n))),
                }),
                zones: list(&case["zones"], |zone| Zone {
                    low: number(&zone[0]),
                    high: number(&zone[1]),
                    before: text(&zone[2]),
                    after: text(&zone[3]),
                    hits: zone[4].as_u64().unwrap(),
                }),
            }
        })
        .collect()
}

fn solve<A: Real>(case: &Case) -> Vec<Crossing> {
    let mut crossings = Vec::new();
    let ray = GenericRay::<A>::new(case.origin, case.direction);
    case.shape.crossings(&ray, &mut NullRecorder, &mut crossings);
    crossings
}

fn ulp(x: f64) -> f64 {
    x.abs().next_up() - x.abs()
}

/// How far `t` lies outside of a zone.
fn distance(zone: &Zone, t: f64) -> f64 {
    (zone.low - t).max(t - zone.high).max(0.0)
}

/// The zone that a reported t belongs to: the nearest one, if it is near enough.
fn zone_of(case: &Case, t: f64) -> Option<usize> {
    let zones = &case.zones;
    let nearest = (0..zones.len()).min_by(|&a, &b| distance(&zones[a], t).total_cmp(&distance(&zones[b], t)))?;
    let zone = &zones[nearest];
    let gap = (0..zones.len())
        .filter(|&k| k != nearest)
        .map(|k| (zones[k].low - zone.high).max(zone.low - zones[k].high).max(0.0))
        .fold(f64::INFINITY, f64::min);
    let length = 1.0 / case.direction.abs().max_element();
    let width = 4.0 * (zone.high - zone.low) + 4.0 * ulp(zone.high);
    (distance(zone, t) <= width.max((1e-3 * length).min(0.45 * gap))).then_some(nearest)
}

#[derive(Default)]
struct Verdict {
    missed: usize,
    extra: usize,
    /// The largest error of a hit that stands alone in its zone, over what the input's last digit can do.
    error: f64,
}

/// The rule of `oracle/README.md`.
fn judge(case: &Case, ends: &[f64]) -> Verdict {
    let square = matches!(case.shape, Shape::Square(_));
    let mut verdict = Verdict::default();
    let mut reported = vec![Vec::new(); case.zones.len()];
    for &t in ends {
        match zone_of(case, t) {
            Some(zone) => reported[zone].push(t),
            None => verdict.extra += 1,
        }
    }
    for (zone, reported) in case.zones.iter().zip(reported) {
        let must = if square { zone.after == "in" } else { zone.before != zone.after };
        let count = reported.len();
        match (must, count) {
            (true, 0) => verdict.missed += 1,
            (true, _) if count % 2 == 0 || square => verdict.extra += count - 1,
            (false, _) if count % 2 == 1 && !square => verdict.extra += 1,
            _ => {}
        }
        if must && count > 0 && zone.hits == 1 {
            let hit = case.hits.iter().find(|hit| zone.low <= hit.t && hit.t <= zone.high);
            let error = hit.map_or(0.0, |hit| (reported[0] - hit.t).abs() / (hit.floor + 0.5 * ulp(hit.t)));
            verdict.error = verdict.error.max(error);
        }
    }
    verdict
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
fn check_surfaces(case: &Case, crossings: &[Crossing]) -> Result<(), String> {
    if crossings.len() != case.hits.len() {
        return Err(format!("{} hits for {}", crossings.len(), case.hits.len()));
    }
    let parts = case.shape.parts();
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
            if from_part(&case.shape, crossing.part, point) <= blur {
                continue;
            }
            return Err(format!("part {part} for {:?}", hit.surfaces));
        };
        let Some(Some(expected)) = hit.normals.get(k) else { continue };
        let normal = case.shape.normal(point, crossing.part).normalize();
        let moved = blur + hit.floor * case.direction.length();
        let tolerance = 1e-14 + bending(&case.shape, point) * moved;
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
    let cases = cases(file);
    for case in &cases {
        let crossings = solve::<A>(case);
        let ends: Vec<_> = crossings.iter().map(|crossing| crossing.t).collect();
        let verdict = judge(case, &ends);
        missed += verdict.missed;
        extra += verdict.extra;
        if verdict.error > worst.0 {
            worst = (verdict.error, case.id.clone());
        }
        let surfaces = if case.ambiguous { Ok(()) } else { check_surfaces(case, &crossings) };
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
