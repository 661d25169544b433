//! Snell's law at an interface: the rays at their true angles, and beside them how much is reflected at every angle.

mod fan;
mod fresnel;
#[cfg(test)]
mod tests;

use super::drawing::{Drawing, Frame};
use super::events_of::Story;
use super::palette::Theme;
use super::sheet::{Sheet, is_roomy};
use super::text::{brief, degrees};
use crate::math::portable;
use crate::record::{EventId, RayKind, What};
use crate::trace::RayTree;

/// What the diagram shows, read from the events.
struct Interface {
    /// Indices of refraction on the incoming side and beyond.
    indices: [f64; 2],
    /// The media's names; empty where they are not known.
    names: [String; 2],
    /// Degrees.
    theta1: f64,
    /// Degrees; none for total internal reflection.
    theta2: Option<f64>,
    /// Degrees; none where light goes into the denser medium.
    critical: Option<f64>,
    /// The unpolarised reflectance.
    reflectance: f64,
    /// The events of the incoming, the reflected and the refracted ray, where they were sent.
    rays: [Option<EventId>; 3],
}

/// The diagram of the `Snell` event of the ray that `selected` belongs to, or of the ray that sent it.
#[must_use]
pub fn snell_diagram(tree: &RayTree, selected: EventId, size: [f64; 2], theme: Theme) -> Option<Drawing> {
    let story = Story::of(tree, selected)?;
    let event = story.nearest(selected, |what| matches!(what, What::Snell { .. }))?;
    let interface = read(&story, event)?;
    let mut sheet = Sheet::new(size, theme, event);
    let (title, note) = (title(&interface), note(&interface));
    let room = sheet.caption(&title, &note);
    sheet.drawing.description = description(&interface);
    let (left, right) = split(room);
    // Names of the rays stay on their side.
    let right_of = Frame { low: [left.high[0], left.low[1]], high: [left.high[0] + 6.0, left.high[1]] };
    sheet.placer.reserve(right_of);
    sheet.placer.reserve(Frame { low: [0.0, left.low[1]], high: [left.low[0] - 2.0, left.high[1]] });
    fan::draw(&mut sheet, &left, &interface);
    // Before the chart beside it keeps names within itself.
    sheet.place_names();
    if let Some(right) = right.filter(is_roomy) {
        fresnel::draw(&mut sheet, right, &interface);
    }
    Some(sheet.finish())
}

fn read(story: &Story, event: EventId) -> Option<Interface> {
    let What::Snell { n1, n2, theta1, theta2, critical, reflectance, .. } = &story.tree.event(event).what else {
        return None;
    };
    let medium = story.of_same_ray(event).filter(|other| other.id < event).filter_map(|other| match &other.what {
        What::Medium { before, after, .. } => Some([before.clone(), after.clone()]),
        _ => None,
    });
    Some(Interface {
        indices: [*n1, *n2],
        names: medium.last().unwrap_or_default(),
        theta1: *theta1,
        theta2: *theta2,
        critical: *critical,
        reflectance: *reflectance,
        rays: [
            Some(story.flights.ray_of(event).event),
            story.sent(event, RayKind::Reflected),
            story.sent(event, RayKind::Refracted),
        ],
    })
}

fn title(interface: &Interface) -> String {
    match interface.theta2 {
        Some(_) => "Snell's law: n₁ sin θ₁ = n₂ sin θ₂".to_owned(),
        None => "Snell's law: total internal reflection".to_owned(),
    }
}

/// Snell's law with this ray's numbers put in.
fn note(interface: &Interface) -> String {
    let [n1, n2] = interface.indices.map(brief);
    let first = degrees(interface.theta1);
    match (interface.theta2, interface.critical) {
        (Some(theta2), _) => format!("{n1} · sin {first} = {n2} · sin {}", degrees(theta2)),
        (None, Some(critical)) => {
            format!("θ₁ = {first} is more than the critical angle {}, so no θ₂ fits", degrees(critical))
        }
        (None, None) => format!("{n1} · sin {first} is more than {n2}, so no θ₂ fits"),
    }
}

fn description(interface: &Interface) -> String {
    let [n1, n2] = interface.indices.map(brief);
    let side = |name: &str, n: &str| if name.is_empty() { format!("index {n}") } else { format!("{name}, index {n}") };
    let [before, after] = [side(&interface.names[0], &n1), side(&interface.names[1], &n2)];
    let reflected = format!("{} of the light is reflected", percent(interface.reflectance));
    let beyond = match interface.theta2 {
        Some(theta2) => format!("is refracted to θ₂ = {}, and {reflected}", degrees(theta2)),
        None => format!("is reflected totally, and {reflected}"),
    };
    let critical = match interface.critical {
        Some(critical) => format!("The critical angle is {}.", degrees(critical)),
        None => "Into the denser medium there is no critical angle.".to_owned(),
    };
    let brewster = degrees(interface.brewster());
    format!(
        "Snell's law at an interface. A ray goes from {before} to {after}. It arrives at θ₁ = {} from the normal, {beyond}. \
         {critical} Brewster's angle is {brewster}.",
        degrees(interface.theta1)
    )
}

/// A share as a percentage.
fn percent(share: f64) -> String {
    format!("{} %", super::text::significant(share * 100.0, 3))
}

/// Side by side where there is the width, above each other where there is the height; else the rays alone.
fn split(room: Frame) -> (Frame, Option<Frame>) {
    let [width, height] = room.size();
    let ([left, top], [right, bottom]) = (room.low, room.high);
    if width >= 400.0 {
        let middle = left + 0.5 * width;
        (
            Frame { low: [left, top], high: [middle - 10.0, bottom] },
            Some(Frame { low: [middle + 10.0, top], high: [right, bottom] }),
        )
    } else if height >= 330.0 {
        let middle = top + 0.5 * height;
        (
            Frame { low: [left, top], high: [right, middle - 8.0] },
            Some(Frame { low: [left, middle + 8.0], high: [right, bottom] }),
        )
    } else {
        (room, None)
    }
}

impl Interface {
    /// tan θ = n₂ / n₁: there Rₚ is 0.
    fn brewster(&self) -> f64 {
        let [n1, n2] = self.indices;
        portable::atan2(n2, n1).to_degrees()
    }
}
