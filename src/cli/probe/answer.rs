//! What a request is answered with.

use super::request::{Arithmetic, Request};
use crate::csg::{Boundary, IntervalList, Solid};
use crate::math::DoubleDouble;
use crate::optics::refract;
use crate::record::{NullRecorder, Sense, Triple};
use glam::DVec3;
use serde::Serialize;
use serde_json::Value;
use std::io::{self, Write};

/// One line of output, but for the id.
#[derive(Debug, Serialize)]
#[serde(untagged)]
pub enum Answer {
    Hits { hits: Vec<Hit>, inside: Vec<[Option<f64>; 2]> },
    Optics(Interface),
    Refusal { error: String },
}

#[derive(Debug, Serialize)]
pub struct Hit {
    t: f64,
    kind: Sense,
    part: String,
    leaf: usize,
    normal: Triple,
}

#[derive(Debug, Serialize)]
pub struct Interface {
    reflected: Triple,
    refracted: Option<Triple>,
    cos_i: f64,
    cos_t: Option<f64>,
    reflectance: f64,
    critical_angle_degrees: Option<f64>,
}

#[derive(Serialize)]
struct Line<'a> {
    id: &'a Value,
    #[serde(flatten)]
    answer: &'a Answer,
}

impl Answer {
    /// Answers a request.
    pub fn to(request: &Request) -> Self {
        match request {
            Request::Hits { solid, origin, direction, arithmetic } => hits(solid, *origin, *direction, *arithmetic),
            Request::Interface { direction, normal, n1, n2 } => interface(*direction, *normal, *n1, *n2),
        }
    }

    /// Says what was wrong with the request in this line of the input.
    pub fn refusal(line: usize, problem: &str) -> Self {
        Self::Refusal { error: format!("line {line}: {problem}") }
    }

    /// Whether the request could not be answered.
    pub const fn is_refusal(&self) -> bool {
        matches!(self, Self::Refusal { .. })
    }

    /// Writes the line.
    pub fn write(&self, id: &Value, output: &mut impl Write) -> io::Result<()> {
        serde_json::to_writer(&mut *output, &Line { id, answer: self })?;
        output.write_all(b"\n")
    }
}

fn hits(solid: &Solid, origin: DVec3, direction: DVec3, arithmetic: Arithmetic) -> Answer {
    let list = match arithmetic {
        Arithmetic::Single => solid.inside::<f32>(origin, direction, &mut NullRecorder),
        Arithmetic::Double => solid.inside::<f64>(origin, direction, &mut NullRecorder),
        Arithmetic::DoubleDouble => solid.inside::<DoubleDouble>(origin, direction, &mut NullRecorder),
    };
    let boundaries = list.boundaries();
    let hits = boundaries.iter().map(|(boundary, sense)| hit(solid, origin, direction, boundary, *sense)).collect();
    Answer::Hits { hits, inside: inside(&list) }
}

fn hit(solid: &Solid, origin: DVec3, direction: DVec3, boundary: &Boundary, kind: Sense) -> Hit {
    let normal = solid.normal(boundary, origin + direction * boundary.t).to_array();
    let parts = solid.leaves.get(boundary.leaf).map(|leaf| &leaf.parts);
    let part = parts.and_then(|parts| parts.get(usize::from(boundary.part))).cloned().unwrap_or_default();
    Hit { t: boundary.t, kind, part, leaf: boundary.leaf, normal }
}

fn inside(list: &IntervalList) -> Vec<[Option<f64>; 2]> {
    let end = |boundary: Option<Boundary>| boundary.map(|boundary| boundary.t);
    list.intervals().map(|interval| [end(interval.enter), end(interval.leave)]).collect()
}

fn interface(direction: DVec3, normal: DVec3, n1: f64, n2: f64) -> Answer {
    let optics = refract(direction, normal, n1, n2);
    Answer::Optics(Interface {
        reflected: optics.reflected.to_array(),
        refracted: optics.refracted.map(|refracted| refracted.to_array()),
        cos_i: optics.cos_i,
        cos_t: optics.cos_t,
        reflectance: optics.reflectance(),
        critical_angle_degrees: optics.critical_angle_degrees(),
    })
}
