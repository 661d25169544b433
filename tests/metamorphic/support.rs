//! Solids written as in scene files, rays, and the spans of a ray inside a solid.

use crate::random::Random;
use glam::DVec3;
use rayscope::csg::{Boundary, Solid};
use rayscope::record::NullRecorder;
use rayscope::scene::compile_solid;
use serde_json::{Value, json};

/// One end of a span: the time and the bound on its error.
pub type End = (f64, f64);

pub fn compile(solid: &Value) -> Solid {
    compile_solid(solid).unwrap_or_else(|problem| panic!("{solid}: {problem}"))
}

/// The spans inside. Ends without bound are infinite.
pub fn spans(solid: &Solid, (origin, direction): (DVec3, DVec3)) -> Vec<[End; 2]> {
    let end = |boundary: Option<Boundary>, missing: f64| boundary.map_or((missing, 0.0), |b| (b.t, b.error));
    let list = solid.inside::<f64>(origin, direction, &mut NullRecorder);
    list.intervals().map(|i| [end(i.enter, f64::NEG_INFINITY), end(i.leave, f64::INFINITY)]).collect()
}

/// Whether two ends may be the same place: no further apart than both errors and a rounding allow.
pub fn agree(a: End, b: End) -> bool {
    a.0 == b.0 || (a.0 - b.0).abs() <= a.1 + b.1 + 2.0 * f64::EPSILON * a.0.abs()
}

/// What keeps two lists of spans from being the same, but for their errors.
pub fn same(found: &[[End; 2]], expected: &[[End; 2]]) -> Result<(), String> {
    let alike = found.len() == expected.len()
        && found.iter().flatten().zip(expected.iter().flatten()).all(|(a, b)| agree(*a, *b));
    if alike { Ok(()) } else { Err(format!("{found:?} for {expected:?}")) }
}

/// Solids of every shape that has an inside, in their generic poses.
pub fn shapes() -> Vec<Value> {
    let face = |normal: [f64; 3], offset: f64| json!({"normal": normal, "offset": offset});
    let corner = [
        face([-1.0, 0.0, 0.0], 0.5),
        face([0.0, -2.0, 0.0], 1.0),
        face([0.0, 0.0, -1.0], 0.5),
        face([1.0, 2.0, 3.0], 1.5),
    ];
    vec![
        json!({"shape": "plane"}),
        json!({"shape": "sphere"}),
        json!({"shape": "tapered_cylinder", "s": 0.4}),
        json!({"shape": "tapered_cylinder", "s": 1.75}),
        json!({"shape": "cylinder"}),
        json!({"shape": "cone"}),
        json!({"shape": "cube"}),
        json!({"shape": "convex_polyhedron", "planes": corner}),
        json!({"shape": "torus", "d": 0.3}),
        json!({"shape": "torus", "d": 1}),
        json!({"shape": "torus", "d": 2.5}),
        json!({"shape": "superellipsoid", "n": 4, "m": 4}),
        json!({"shape": "superellipsoid", "n": 1, "m": 2.5}),
        json!({"shape": "superellipsoid", "n": 0.5, "m": 0.5}),
        json!({"shape": "superellipsoid", "n": 0.6, "m": 3}),
        json!({"shape": "superellipsoid", "n": 3, "m": 0.6}),
    ]
}

/// A rotation, a scaling that is not the same along all axes, and a move.
pub fn transform(random: &mut Random) -> Vec<Value> {
    let moved = random.vector(-3.0, 3.0).to_array();
    let size = random.vector(0.5, 2.0).to_array();
    vec![rotation(random), json!({"scale": size}), rotation(random), json!({"translate": moved})]
}

pub fn rotation(random: &mut Random) -> Value {
    json!({"rotate": {"axis": random.direction().to_array(), "degrees": random.between(0.0, 360.0)}})
}

/// The solid with these steps after its own.
pub fn placed(solid: &Value, steps: &[Value]) -> Value {
    let mut solid = solid.clone();
    let mut all = solid["transform"].as_array().cloned().unwrap_or_default();
    all.extend_from_slice(steps);
    solid["transform"] = Value::Array(all);
    solid
}

pub fn compound(operator: &str, of: &[&Value]) -> Value {
    json!({"shape": operator, "of": of})
}

/// A ray towards a point near the solid, from some distance.
pub fn ray_at(solid: &Solid, random: &mut Random) -> (DVec3, DVec3) {
    let extent = solid.extent();
    let (low, high) = (extent.low.max(DVec3::splat(-4.0)), extent.high.min(DVec3::splat(4.0)));
    let target = low + (high - low) * random.vector(0.0, 1.0);
    let direction = random.direction();
    (target - direction * 10.0_f64.powf(random.between(0.0, 3.0)), direction * random.between(0.3, 3.0))
}
