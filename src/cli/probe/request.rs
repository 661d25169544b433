//! What a line asks for, checked.

use crate::csg::Solid;
use crate::scene::compile_solid;
use glam::DVec3;
use serde_json::{Map, Value};

/// A request that can be answered.
#[derive(Debug)]
pub enum Request {
    /// All hits of a ray with a solid.
    Hits { solid: Box<Solid>, origin: DVec3, direction: DVec3, arithmetic: Arithmetic },
    /// What an interface does to a ray.
    Interface { direction: DVec3, normal: DVec3, n1: f64, n2: f64 },
}

/// What the solvers compute in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Arithmetic {
    Single,
    Double,
    DoubleDouble,
}

type Object = Map<String, Value>;

impl Request {
    /// Reads a request; the error says what was wrong and where.
    pub fn parse(value: &Value) -> Result<Self, String> {
        let request = object(value, "the request")?;
        check_names(request, &["id", "solid", "ray", "arithmetic", "interface"], "")?;
        match (request.get("solid"), request.get("interface")) {
            (Some(_), Some(_)) => Err("a request has either `solid` and `ray` or `interface`, not both".to_owned()),
            (Some(solid), None) => Self::hits(request, solid),
            (None, Some(interface)) => Self::interface(object(interface, "interface")?),
            (None, None) => Err("expected `solid` and `ray`, or `interface`".to_owned()),
        }
    }

    fn hits(request: &Object, solid: &Value) -> Result<Self, String> {
        let ray = object(request.get("ray").ok_or("`ray` is missing")?, "ray")?;
        check_names(ray, &["origin", "direction"], "ray.")?;
        Ok(Self::Hits {
            solid: compile_solid(solid).map(Box::new).map_err(|problem| format!("solid: {problem}"))?,
            origin: triple(ray, "origin", "ray.")?,
            direction: some_length(ray, "direction", "ray.")?,
            arithmetic: arithmetic(request.get("arithmetic"))?,
        })
    }

    fn interface(interface: &Object) -> Result<Self, String> {
        check_names(interface, &["direction", "normal", "n1", "n2"], "interface.")?;
        Ok(Self::Interface {
            direction: some_length(interface, "direction", "interface.")?,
            normal: some_length(interface, "normal", "interface.")?,
            n1: index_of_refraction(interface, "n1")?,
            n2: index_of_refraction(interface, "n2")?,
        })
    }
}

fn object<'a>(value: &'a Value, place: &str) -> Result<&'a Object, String> {
    value.as_object().ok_or_else(|| format!("{place}: expected an object in braces, found {}", kind(value)))
}

/// Refuses a member whose name is a slip of one that is known. Others are let be: they may be notes of the sender.
fn check_names(object: &Object, known: &[&str], place: &str) -> Result<(), String> {
    for name in object.keys().filter(|name| !known.contains(&name.as_str())) {
        let meant = known.iter().find(|known| !object.contains_key(**known) && is_slip(name, known));
        if let Some(meant) = meant {
            return Err(format!("{place}{name}: there is no such member; did you mean `{meant}`?"));
        }
    }
    Ok(())
}

fn is_slip(name: &str, known: &str) -> bool {
    known.len() > 2 && strsim::damerau_levenshtein(&name.to_lowercase(), known) <= 2
}

fn triple(object: &Object, name: &str, place: &str) -> Result<DVec3, String> {
    let value = object.get(name).ok_or_else(|| format!("{place}{name} is missing"))?;
    let numbers: Option<Vec<f64>> = value.as_array().and_then(|array| array.iter().map(Value::as_f64).collect());
    let numbers: Option<[f64; 3]> = numbers.and_then(|numbers| numbers.try_into().ok());
    numbers
        .map(DVec3::from_array)
        .ok_or_else(|| format!("{place}{name}: expected three numbers such as [0, 0, 1], found {}", short(value)))
}

fn some_length(object: &Object, name: &str, place: &str) -> Result<DVec3, String> {
    match triple(object, name, place)? {
        DVec3::ZERO => Err(format!("{place}{name}: a vector without length has no direction")),
        vector => Ok(vector),
    }
}

fn index_of_refraction(interface: &Object, name: &str) -> Result<f64, String> {
    let value = interface.get(name).ok_or_else(|| format!("interface.{name} is missing"))?;
    value
        .as_f64()
        .filter(|&n| n > 0.0)
        .ok_or_else(|| format!("interface.{name}: expected a number greater than 0, found {}", short(value)))
}

fn arithmetic(value: Option<&Value>) -> Result<Arithmetic, String> {
    match value.map(Value::as_str) {
        None | Some(Some("f64")) => Ok(Arithmetic::Double),
        Some(Some("f32")) => Ok(Arithmetic::Single),
        Some(Some("double-double")) => Ok(Arithmetic::DoubleDouble),
        Some(_) => {
            let found = value.map_or_else(String::new, short);
            Err(format!("arithmetic: expected \"f32\", \"f64\" or \"double-double\", found {found}"))
        }
    }
}

fn kind(value: &Value) -> &'static str {
    match value {
        Value::Null => "null",
        Value::Bool(_) => "a truth value",
        Value::Number(_) => "a number",
        Value::String(_) => "a text",
        Value::Array(_) => "a list",
        Value::Object(_) => "an object",
    }
}

/// The value as it was written, or its kind where that would be long.
fn short(value: &Value) -> String {
    let text = value.to_string();
    if text.chars().count() <= 40 { text } else { kind(value).to_owned() }
}
