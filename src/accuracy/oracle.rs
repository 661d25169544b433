//! The reader of the exact hits in `tests/oracle/`, which are part of the program. `tests/oracle/README.md` says what they
//! mean.
//!
//! Numbers stand in quotes in the files, so that no JSON library rounds them.

use crate::csg::{Leaf, Placement, Solid};
use crate::record::Operator;
use crate::shape::{ConvexPolyhedron, Cube, HalfSpace, Shape, Sphere, Square, Superellipsoid, TaperedCylinder, Torus};
use glam::{DAffine3, DMat3, DVec3};
use serde_json::Value;

macro_rules! files {
    ($($name:literal)*) => {
        /// The files of primitives and of compounds, by their names without the ending.
        pub const FILES: &[&str] = &[$($name),*];

        fn text_of(file: &str) -> Option<&'static str> {
            match file {
                $($name => Some(include_str!(concat!("../../tests/oracle/", $name, ".jsonl"))),)*
                _ => None,
            }
        }
    };
}

files! { "sphere" "square" "tapered" "cube" "polyhedron" "torus" "superellipsoid" "csg" }

const POLYHEDRA: &str = include_str!("../../tests/oracle/polyhedra.json");

/// What a ray is sent at.
#[derive(Clone, Debug)]
pub enum Target {
    /// A primitive in its generic coordinates.
    Shape(Shape),
    /// Placed primitives, combined.
    Solid(Box<Solid>),
}

impl Target {
    /// Whether it bounds nothing.
    #[must_use]
    pub const fn is_square(&self) -> bool {
        matches!(self, Self::Shape(Shape::Square(_)))
    }
}

/// A stretch of t on which the ray, its numbers moved by half a last digit, can be on the surface.
#[derive(Clone, Debug)]
pub struct Zone {
    /// Its lower end.
    pub low: f64,
    /// Its upper end.
    pub high: f64,
    /// Whether the ray is inside (`in`) or outside (`out`) before it.
    pub before: String,
    /// The same behind it.
    pub after: String,
    /// How many exact hits lie within.
    pub hits: u64,
}

/// An exact hit.
#[derive(Clone, Debug)]
pub struct Hit {
    /// The hit time, rounded to `f64`.
    pub t: f64,
    /// How far it moves at most when each number of the input moves by half its last digit.
    pub floor: f64,
    /// `in`, `out` or `touch`.
    pub side: String,
    /// The surfaces that meet there.
    pub surfaces: Vec<String>,
    /// Their outward unit normals; none where a surface has no normal.
    pub normals: Vec<Option<DVec3>>,
}

/// A ray with its exact hits.
#[derive(Clone, Debug)]
pub struct Case {
    /// Its name.
    pub id: String,
    /// What comes of it: `hit`, `miss`, `tangent-touch` and so on.
    pub kind: String,
    /// What the ray is sent at.
    pub target: Target,
    /// S.
    pub origin: DVec3,
    /// c, of any length.
    pub direction: DVec3,
    /// Half a last digit of the input can change what is hit.
    pub ambiguous: bool,
    /// No rounding excuses another structure.
    pub strict: bool,
    /// The exact hits, ascending.
    pub hits: Vec<Hit>,
    /// Where hits may be reported, ascending.
    pub zones: Vec<Zone>,
}

/// All cases of a file.
///
/// # Errors
/// Names the file and the line, and what was expected there.
pub fn cases(file: &str) -> Result<Vec<Case>, String> {
    let text = text_of(file).ok_or_else(|| format!("there is no file {file}; there are {}", FILES.join(", ")))?;
    let polyhedra = json(POLYHEDRA).map_err(|error| format!("polyhedra.json: {error}"))?;
    let mut reader = Reader { file, polyhedra, shapes: Vec::new() };
    let lines = text.lines().enumerate();
    lines.map(|(k, line)| reader.case(line).map_err(|error| format!("{file}.jsonl:{}: {error}", k + 1))).collect()
}

struct Reader<'a> {
    file: &'a str,
    polyhedra: Value,
    /// Shapes that were met before: polyhedra take time to check.
    shapes: Vec<(String, Value, Shape)>,
}

impl Reader<'_> {
    fn case(&mut self, line: &str) -> Result<Case, String> {
        let case = json(line)?;
        let flag = |name: &str| case[name].as_bool().unwrap_or(false);
        Ok(Case {
            id: text(&case["id"])?,
            kind: text(&case["kind"])?,
            target: self.target(&case)?,
            origin: vector(&case["origin"])?,
            direction: vector(&case["direction"])?,
            ambiguous: flag("ambiguous"),
            strict: flag("strict"),
            hits: list(&case["hits"], hit)?,
            zones: list(&case["zones"], zone)?,
        })
    }

    fn target(&mut self, case: &Value) -> Result<Target, String> {
        match case.get("tree") {
            Some(tree) => self.solid(tree).map(|solid| Target::Solid(Box::new(solid))),
            None => self.shape(self.file, &case["parameters"]).map(Target::Shape),
        }
    }

    fn solid(&mut self, node: &Value) -> Result<Solid, String> {
        if let Some(operator) = node.get("operator") {
            let operator = match operator.as_str() {
                Some("union") => Operator::Union,
                Some("intersection") => Operator::Intersection,
                Some("difference") => Operator::Difference,
                _ => return Err(format!("expected an operator, found {operator}")),
            };
            return Ok(Solid::pair("", operator, self.solid(&node["left"])?, self.solid(&node["right"])?));
        }
        let shape = self.shape(&text(&node["shape"])?, &node["parameters"])?;
        Ok(Solid::leaf(Leaf::new("", shape, placement(&node["matrix"])?)))
    }

    fn shape(&mut self, name: &str, parameters: &Value) -> Result<Shape, String> {
        let known = |(a, b, _): &&(String, Value, Shape)| a == name && b == parameters;
        if let Some((_, _, shape)) = self.shapes.iter().find(known) {
            return Ok(shape.clone());
        }
        let shape = new_shape(name, parameters, &self.polyhedra)?;
        self.shapes.push((name.to_owned(), parameters.clone(), shape.clone()));
        Ok(shape)
    }
}

fn new_shape(name: &str, parameters: &Value, polyhedra: &Value) -> Result<Shape, String> {
    let parameter = |name: &str| number(&parameters[name]);
    match name {
        "sphere" => Sphere::new().map(Shape::Sphere),
        "square" => Square::new().map(Shape::Square),
        "cube" => Cube::new().map(Shape::Cube),
        "tapered" => TaperedCylinder::new(parameter("s")?).map(Shape::TaperedCylinder),
        "torus" => Torus::new(parameter("d")?).map(Shape::Torus),
        "superellipsoid" => Superellipsoid::new(parameter("n")?, parameter("m")?).map(Shape::Superellipsoid),
        "polyhedron" => {
            let planes = list(&polyhedra[text(&parameters["shape"])?], |plane| {
                Ok(HalfSpace { normal: vector(&plane["normal"])?, offset: number(&plane["offset"])? })
            })?;
            ConvexPolyhedron::new(planes).map(Shape::ConvexPolyhedron)
        }
        other => Err(format!("there is no shape {other}")),
    }
}

/// Three rows of four, object to world.
fn placement(matrix: &Value) -> Result<Placement, String> {
    let rows = list(matrix, |row| list(row, number))?;
    let column = |k: usize| {
        let of = |row: usize| rows.get(row).and_then(|row: &Vec<f64>| row.get(k)).copied().unwrap_or(f64::NAN);
        DVec3::new(of(0), of(1), of(2))
    };
    Placement::new(DAffine3 { matrix3: DMat3::from_cols(column(0), column(1), column(2)), translation: column(3) })
}

fn hit(hit: &Value) -> Result<Hit, String> {
    Ok(Hit {
        t: number(&hit["t"])?,
        floor: number(&hit["floor"])?,
        side: text(&hit["side"])?,
        surfaces: list(&hit["surf"], |surface| match surface.as_str() {
            Some(name) => Ok(name.to_owned()),
            None => list(surface, text).map(|names| names.join(" ")),
        })?,
        normals: list(&hit["normals"], |normal| if normal.is_null() { Ok(None) } else { vector(normal).map(Some) })?,
    })
}

fn zone(zone: &Value) -> Result<Zone, String> {
    Ok(Zone {
        low: number(&zone[0])?,
        high: number(&zone[1])?,
        before: text(&zone[2])?,
        after: text(&zone[3])?,
        hits: zone[4].as_u64().ok_or("expected the number of hits in a zone")?,
    })
}

fn json(text: &str) -> Result<Value, String> {
    serde_json::from_str(text).map_err(|error| error.to_string())
}

fn number(value: &Value) -> Result<f64, String> {
    let number = value.as_str().and_then(|text| text.parse().ok());
    number.ok_or_else(|| format!("expected a number in quotes, found {value}"))
}

fn vector(value: &Value) -> Result<DVec3, String> {
    Ok(DVec3::new(number(&value[0])?, number(&value[1])?, number(&value[2])?))
}

fn text(value: &Value) -> Result<String, String> {
    value.as_str().map(str::to_owned).ok_or_else(|| format!("expected a text, found {value}"))
}

fn list<T>(value: &Value, read: impl FnMut(&Value) -> Result<T, String>) -> Result<Vec<T>, String> {
    value.as_array().ok_or_else(|| format!("expected a list, found {value}"))?.iter().map(read).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_file_can_be_read() {
        for file in FILES {
            let cases = cases(file).unwrap();
            assert!(cases.len() > 300, "{file}: {}", cases.len());
            assert!(cases.iter().all(|case| case.direction != DVec3::ZERO && case.zones.len() <= 64), "{file}");
        }
    }

    #[test]
    fn a_file_that_is_not_there_is_answered_with_those_that_are() {
        let error = cases("tapir").unwrap_err();
        assert!(error.contains("tapir") && error.contains("tapered"), "{error}");
    }
}
