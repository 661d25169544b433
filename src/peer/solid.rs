//! A peer scene's solids, each as a generic primitive and the steps that take it to its place.

use glam::{DMat3, DVec3};
use serde::Deserialize;
use serde_json::{Value, json};

#[derive(Deserialize)]
pub(super) struct Solid {
    #[serde(flatten)]
    shape: Shape,
    material: Option<String>,
    /// Object to world, three rows of four.
    matrix: Option<[[f64; 4]; 3]>,
}

#[derive(Deserialize)]
#[serde(tag = "shape", rename_all = "snake_case")]
enum Shape {
    Sphere { center: [f64; 3], radius: f64 },
    Box { min: [f64; 3], max: [f64; 3] },
    Cylinder { base: [f64; 3], cap: [f64; 3], radius: f64 },
    Cone { base: [f64; 3], base_radius: f64, cap: [f64; 3], cap_radius: f64 },
    Torus { major: f64, minor: f64 },
    Superellipsoid { e: f64, n: f64 },
    Plane { normal: [f64; 3], distance: f64 },
    Union { children: Vec<Solid> },
    Intersection { children: Vec<Solid> },
    Difference { children: Vec<Solid> },
}

impl Solid {
    /// The solid as a scene file says it.
    pub fn to_file(&self) -> Result<Value, String> {
        let (mut file, mut steps) = self.shape.to_file()?;
        steps.extend(self.matrix.map(|rows| json!({ "matrix": rows })));
        if let Some(material) = &self.material {
            file["material"] = json!(material);
        }
        if !steps.is_empty() {
            file["transform"] = json!(steps);
        }
        Ok(file)
    }
}

impl Shape {
    /// The generic primitive or the compound, and the steps of its transform.
    fn to_file(&self) -> Result<(Value, Vec<Value>), String> {
        Ok(match self {
            Self::Sphere { center, radius } => {
                (json!({ "shape": "sphere" }), vec![json!({ "scale": radius }), json!({ "translate": center })])
            }
            Self::Box { min, max } => {
                let [low, high] = [min, max].map(|corner| DVec3::from_array(*corner));
                let (half, middle) = (0.5 * (high - low), 0.5 * (low + high));
                let steps = vec![json!({ "scale": half.to_array() }), json!({ "translate": middle.to_array() })];
                (json!({ "shape": "cube" }), steps)
            }
            Self::Cylinder { base, cap, radius } => (json!({ "shape": "cylinder" }), along(*base, *cap, *radius)?),
            Self::Cone { base, base_radius, cap, cap_radius } => {
                tapered((*base, *base_radius), (*cap, *cap_radius))?
            }
            // The peer's axis is y, the generic one's z: the axes change places in a circle, which mirrors nothing.
            Self::Torus { major, minor } => {
                let rows = [[0.0, *minor, 0.0, 0.0], [0.0, 0.0, *minor, 0.0], [*minor, 0.0, 0.0, 0.0]];
                (json!({ "shape": "torus", "d": major / minor }), vec![json!({ "matrix": rows })])
            }
            // (|x|^(2/e) + |y|^(2/e))^(e/n) + |z|^(2/n) = 1.
            Self::Superellipsoid { e, n } => {
                (json!({ "shape": "superellipsoid", "n": 2.0 / e, "m": 2.0 / n }), Vec::new())
            }
            Self::Plane { normal, distance } => {
                let normal = DVec3::from_array(*normal);
                let frame = frame(normal).ok_or("the normal of a plane is (0, 0, 0)")?;
                (json!({ "shape": "plane" }), vec![matrix(frame, normal.normalize() * *distance)])
            }
            Self::Union { children } => (compound("union", children)?, Vec::new()),
            Self::Intersection { children } => (compound("intersection", children)?, Vec::new()),
            Self::Difference { children } => (compound("difference", children)?, Vec::new()),
        })
    }
}

fn compound(operator: &str, children: &[Solid]) -> Result<Value, String> {
    let each = children.iter().enumerate();
    let parts = each.map(|(k, child)| child.to_file().map_err(|message| format!("children[{k}]: {message}")));
    Ok(json!({ "shape": operator, "of": parts.collect::<Result<Vec<_>, _>>()? }))
}

/// A cone or a part of one; the generic one stands on its end of radius 1.
fn tapered(one: ([f64; 3], f64), other: ([f64; 3], f64)) -> Result<(Value, Vec<Value>), String> {
    let (base, cap) = if one.1 == 0.0 { (other, one) } else { (one, other) };
    let shape = if cap.1 == 0.0 {
        json!({ "shape": "cone" })
    } else {
        json!({ "shape": "tapered_cylinder", "s": cap.1 / base.1 })
    };
    Ok((shape, along(base.0, cap.0, base.1)?))
}

/// Takes the z axis from 0 to 1 to that from `base` to `cap`, and radius 1 to `radius`.
fn along(base: [f64; 3], cap: [f64; 3], radius: f64) -> Result<Vec<Value>, String> {
    let [base, cap] = [base, cap].map(DVec3::from_array);
    let axis = cap - base;
    let frame = frame(axis).ok_or("its two ends are the same point")?;
    let linear = DMat3::from_cols(frame.x_axis * radius, frame.y_axis * radius, axis);
    Ok(vec![matrix(linear, base)])
}

/// A rotation that takes z to this direction; without rounding where the direction is that of an axis.
fn frame(direction: DVec3) -> Option<DMat3> {
    let z = direction.try_normalize()?;
    let (x, y) = z.any_orthonormal_pair();
    Some(DMat3::from_cols(x, y, z))
}

fn matrix(linear: DMat3, translation: DVec3) -> Value {
    let rows: [[f64; 4]; 3] = std::array::from_fn(|row| {
        [linear.x_axis[row], linear.y_axis[row], linear.z_axis[row], translation[row]]
    });
    json!({ "matrix": rows })
}
