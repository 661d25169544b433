//! The rays in words.

use super::super::flights::{End, Flight, Flights};
use super::super::text::{brief, brief_vector};
use crate::record::{EventId, What};
use crate::trace::RayTree;

/// More rays than these are only counted: nobody listens to a list of thousands.
const MOST_RAYS: usize = 16;

/// The rays up to and with `step`, a sentence each.
pub(in crate::view) fn told_rays(tree: &RayTree, flights: &Flights, step: EventId) -> String {
    let happened: Vec<&Flight> = flights.all.iter().filter(|flight| flight.event <= step).collect();
    let mut sentences: Vec<String> = happened.iter().take(MOST_RAYS).map(|flight| told(tree, flight, step)).collect();
    if happened.len() > MOST_RAYS {
        sentences.push(format!("And {} more rays.", happened.len() - MOST_RAYS));
    }
    sentences.join(" ")
}

fn told(tree: &RayTree, flight: &Flight, step: EventId) -> String {
    let from = brief_vector(flight.origin.to_array());
    let along = brief_vector(flight.direction.to_array());
    let end = match flight.end {
        End::Hit { event, t } if event <= step => match &tree.event(event).what {
            What::Hit { object, part, point, .. } => {
                format!("hits {part} of {object} at t = {}, at {}", brief(t), brief_vector(*point))
            }
            _ => format!("hits something at t = {}", brief(t)),
        },
        End::Blocked { event, t, .. } if event <= step => match &tree.event(event).what {
            What::Shadow { object, .. } => format!("is blocked by {object} at t = {}", brief(t)),
            _ => format!("is blocked at t = {}", brief(t)),
        },
        End::Light(t) | End::Blocked { light: t, .. } if t.is_finite() => {
            format!("runs to its light at t = {}", brief(t))
        }
        _ => "runs on".to_owned(),
    };
    format!("The {} ray from {from} along {along} {end}.", flight.kind.name())
}
