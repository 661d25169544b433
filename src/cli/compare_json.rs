//! What `rayscope compare` found, as data.

use super::failure::Failure;
use crate::compare::foreign::{Comparison, ForeignDeparture, Place, StoryComparison};
use crate::compare::{Departure, Said, Standing, Tolerance, TreeDifference};
use crate::record::EventId;
use crate::trace::RayTree;
use serde::Serialize;

#[derive(Serialize)]
struct Foreign {
    format: &'static str,
    same: bool,
    checks: usize,
    stories: Vec<Story>,
    notes: Vec<String>,
}

#[derive(Serialize)]
struct Story {
    pixel: Option<[u32; 2]>,
    line: usize,
    checks: usize,
    departing: usize,
    departure: Option<ForeignFirst>,
}

#[derive(Serialize)]
struct ForeignFirst {
    line: usize,
    event: EventId,
    event_says: String,
    ray: String,
    subject: &'static str,
    ours: Value,
    theirs: Value,
    off: Option<f64>,
    allowed: f64,
    causes: Vec<CauseFound>,
}

#[derive(Serialize)]
struct CauseFound {
    cause: &'static str,
    says: &'static str,
    evidence: String,
    misfit: f64,
}

/// What is said in one field.
#[derive(Serialize)]
#[serde(untagged)]
enum Value {
    Number(f64),
    Numbers(Vec<f64>),
    Words(String),
}

#[derive(Serialize)]
struct Difference {
    format: &'static str,
    same: usize,
    changed: usize,
    only_left: usize,
    only_right: usize,
    first_departure: Option<First>,
    first_parting: Option<First>,
    rows: Vec<Row>,
}

#[derive(Serialize)]
struct First {
    left: EventId,
    right: EventId,
    event: String,
    why: String,
}

#[derive(Serialize)]
struct Row {
    left: Option<EventId>,
    right: Option<EventId>,
    standing: &'static str,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    changes: Vec<Changed>,
}

#[derive(Serialize)]
struct Changed {
    name: String,
    left: Option<Value>,
    right: Option<Value>,
}

/// The comparison with another ray tracer.
pub fn foreign_json(comparison: &Comparison) -> Result<String, Failure> {
    written(&Foreign {
        format: "rayscope-compare/1",
        same: comparison.first_departure().is_none(),
        checks: comparison.checks(),
        stories: comparison.stories.iter().map(story).collect(),
        notes: comparison.notes.clone(),
    })
}

/// Two trees: all rows that are not the same.
pub fn difference_json(pairs: &TreeDifference, trees: [&RayTree; 2], tolerance: &Tolerance) -> Result<String, Failure> {
    let [same, changed, only_left, only_right] = pairs.counts();
    let rows = pairs.different().map(|place| {
        let pair = pairs.pairs[place];
        let changes = pairs.changes(place, trees, tolerance).into_iter();
        let changes = changes.map(|change| Changed {
            name: change.name,
            left: change.left.as_ref().map(value),
            right: change.right.as_ref().map(value),
        });
        let standing = match pair.standing {
            Standing::Same => "same",
            Standing::Changed => "changed",
            Standing::OnlyLeft => "only_left",
            Standing::OnlyRight => "only_right",
        };
        Row { left: pair.left, right: pair.right, standing, changes: changes.collect() }
    });
    written(&Difference {
        format: "rayscope-difference/1",
        same,
        changed,
        only_left,
        only_right,
        first_departure: pairs.first_departure(trees[0], trees[1], tolerance).map(first),
        first_parting: pairs.first_parting(trees[0], trees[1], tolerance).map(first),
        rows: rows.collect(),
    })
}

fn first(departure: Departure) -> First {
    First { left: departure.left, right: departure.right, event: departure.event, why: departure.why }
}

fn story(story: &StoryComparison) -> Story {
    let pixel = match story.place {
        Place::Pixel(pixel) => Some(pixel),
        Place::Ray(_) => None,
    };
    let departure = story.departure.as_ref().map(foreign_first);
    Story { pixel, line: story.line, checks: story.checks, departing: story.departing, departure }
}

fn foreign_first(departure: &ForeignDeparture) -> ForeignFirst {
    let check = &departure.check;
    let causes = departure.causes.iter().map(|explanation| CauseFound {
        cause: explanation.cause.id,
        says: explanation.cause.says,
        evidence: explanation.evidence.clone(),
        misfit: explanation.misfit,
    });
    ForeignFirst {
        line: check.line,
        event: check.event,
        event_says: departure.event.clone(),
        ray: departure.ray.clone(),
        subject: check.subject.words(),
        ours: value(&check.ours),
        theirs: value(&check.theirs),
        off: Some(check.off).filter(|off| off.is_finite()),
        allowed: check.allowed,
        causes: causes.collect(),
    }
}

fn value(said: &Said) -> Value {
    match said {
        Said::Words(words) => Value::Words(words.clone()),
        Said::Numbers(numbers) => match numbers[..] {
            [number] => Value::Number(number),
            _ => Value::Numbers(numbers.clone()),
        },
    }
}

fn written(data: &impl Serialize) -> Result<String, Failure> {
    serde_json::to_string_pretty(data).map_err(|error| Failure::refused(error.to_string()))
}
