//! The colour that a ray brings back as stacked bars: five components that add up to the total, and below them each light's
//! part.

mod hatch;
mod legend;
mod plan;
mod table;
#[cfg(test)]
mod tests;

use super::axis::Axis;
use super::drawing::{Anchor, Drawing, Form, Frame, Stroke};
use super::events_of::Story;
use super::fonts::{Face, text_width};
use super::labels::shortened;
use super::palette::{Palette, Theme};
use super::sheet::{SMALL, Sheet, TEXT};
use super::text::brief;
use crate::record::{EventId, Triple, What};
use crate::trace::RayTree;
use hatch::{Look, hatched};
use plan::{Key, Plan, SHARE};
use std::fmt::Write as _;

/// A component with its look.
struct Part {
    name: &'static str,
    colour: Triple,
    look: Look,
}

/// One light's share of the diffuse and the specular component.
struct Lamp {
    event: EventId,
    name: String,
    diffuse: Triple,
    specular: Triple,
}

struct Shading {
    parts: [Part; 5],
    total: Triple,
    lamps: Vec<Lamp>,
}

const CHANNELS: [&str; 3] = ["red", "green", "blue"];

/// The bars of the `Colour` event that `selected` is, or of the ray that it belongs to.
#[must_use]
pub fn shading_bars(tree: &RayTree, selected: EventId, size: [f64; 2], theme: Theme) -> Option<Drawing> {
    let story = Story::of(tree, selected)?;
    let event = story.nearest(selected, |what| matches!(what, What::Colour { .. }))?;
    let shading = read(&story, event, theme.palette())?;
    let total = format!("total {}", amounts(shading.total));
    let (mut sheet, mut plan) = begin(size, theme, event, &shading, &total);
    if plan.lamps < shading.lamps.len() {
        let note = format!("{total}; too low for all lights");
        (sheet, plan) = begin(size, theme, event, &shading, &note);
    }
    sheet.drawing.description = description(&shading);
    match plan.key {
        Key::Table(room) => table::draw(&mut sheet, room, &shading),
        Key::Legend(room) => legend::draw(&mut sheet, room, &shading),
    }
    draw_bars(&mut sheet, &plan, &shading);
    Some(sheet.finish())
}

/// A sheet with its caption, and what there is room for below it.
fn begin(size: [f64; 2], theme: Theme, event: EventId, shading: &Shading, note: &str) -> (Sheet, Plan) {
    let mut sheet = Sheet::new(size, theme, event);
    let room = sheet.caption("Where the colour comes from", note);
    (sheet, Plan::of(room, shading))
}

fn read(story: &Story, event: EventId, palette: &Palette) -> Option<Shading> {
    let What::Colour { ambient, diffuse, specular, reflected, transmitted, total } = &story.tree.event(event).what
    else {
        return None;
    };
    let looks = Look::all(palette);
    let names = ["ambient", "diffuse", "specular", "reflected", "transmitted"];
    let colours = [ambient, diffuse, specular, reflected, transmitted];
    let parts = std::array::from_fn(|i| Part { name: names[i], colour: *colours[i], look: looks[i] });
    let lamps = story.of_same_ray(event).filter(|other| other.id < event).filter_map(|other| match &other.what {
        What::Light { name, diffuse, specular, .. } => {
            Some(Lamp { event: other.id, name: name.clone(), diffuse: *diffuse, specular: *specular })
        }
        _ => None,
    });
    Some(Shading { parts, total: *total, lamps: lamps.collect() })
}

/// A share of light. What nobody could see or measure is as good as nothing.
fn amount(x: f64) -> String {
    const NOTHING: f64 = 1e-7;
    if x != 0.0 && x.abs() < NOTHING { "≈ 0".to_owned() } else { brief(x) }
}

/// Red, green and blue.
fn amounts(colour: Triple) -> String {
    format!("({})", colour.map(amount).join(", "))
}

fn description(shading: &Shading) -> String {
    let parts: Vec<String> =
        shading.parts.iter().map(|part| format!("{} {}", part.name, amounts(part.colour))).collect();
    let mut text = format!(
        "The colour that the ray brings back, red, green and blue, is {}: the sum of {}.",
        amounts(shading.total),
        parts.join(", ")
    );
    for lamp in &shading.lamps {
        let [diffuse, specular] = [lamp.diffuse, lamp.specular].map(amounts);
        let _ = write!(text, " Of that, light {} gives diffuse {diffuse} and specular {specular}.", lamp.name);
    }
    text
}

/// Room for the names of channels and lights, and for the totals.
const NAMES: [f64; 2] = [44.0, 96.0];
const SUMS: f64 = 50.0;
fn draw_bars(sheet: &mut Sheet, plan: &Plan, shading: &Shading) {
    let (room, bottom) = (plan.bars, plan.base());
    let most = shading.total.into_iter().filter(|x| x.is_finite()).fold(1.0, f64::max);
    let lamps = &shading.lamps[..plan.lamps];
    let widest = lamps.iter().map(|lamp| text_width(&lamp.name, SMALL, Face::Sans)).fold(0.0, f64::max);
    let names = (widest + 8.0).min(0.25 * room.size()[0]).clamp(NAMES[0], NAMES[1]);
    let axis = Axis { values: [0.0, most], points: [room.low[0] + names, room.high[0] - SUMS] };
    if axis.points[1] - axis.points[0] < 30.0 || bottom - room.low[1] < 24.0 {
        return;
    }
    let pitch = plan.pitch();
    let mut y = room.low[1];
    for (channel, name) in CHANNELS.into_iter().enumerate() {
        let frame = Frame { low: [axis.points[0], y + 2.0], high: [axis.points[1], y + pitch - 2.0] };
        sheet.write(name, [room.low[0], y + 0.5 * pitch], Anchor::Start, TEXT, sheet.palette.ink);
        let end = stack(sheet, &axis, frame, &shading.parts, channel);
        let sum = amount(shading.total[channel]);
        sheet.write_over(&sum, [end + 6.0, y + 0.5 * pitch], Anchor::Start, TEXT, sheet.palette.ink);
        y += pitch;
    }
    for lamp in lamps {
        draw_lamp(sheet, &axis, [y, y + SHARE * pitch], room.low[0], lamp, &shading.parts);
        y += SHARE * pitch;
    }
    full_line(sheet, &axis, [room.low[1], y]);
    if plan.has_axis() {
        numbers(sheet, &axis, y);
    }
}

/// The components one behind the other; gives where they end.
fn stack(sheet: &mut Sheet, axis: &Axis, row: Frame, parts: &[Part], channel: usize) -> f64 {
    let mut sum = 0.0;
    for part in parts {
        let next = sum + part.colour[channel];
        let [from, to] = [sum, next].map(|x| axis.at(x).max(axis.points[0]).min(axis.points[1]));
        let frame = Frame { low: [from.min(to), row.low[1]], high: [from.max(to), row.high[1]] };
        if to != from {
            hatched(sheet, frame, part.look);
        }
        sum = next;
    }
    axis.at(sum).max(axis.points[0]).min(axis.points[1])
}

/// A light's name and three thin bars: its diffuse and specular terms in each channel.
fn draw_lamp(sheet: &mut Sheet, axis: &Axis, [top, bottom]: [f64; 2], left: f64, lamp: &Lamp, parts: &[Part; 5]) {
    let own = std::mem::replace(&mut sheet.event, lamp.event);
    let thick = (bottom - top - 3.0) / 3.0;
    let looks = [parts[1].look, parts[2].look];
    let mut end = axis.points[0];
    for channel in 0..3 {
        let y = top + 2.0 + thick * channel as f64;
        let terms = [lamp.diffuse, lamp.specular].map(|term| term[channel]);
        let split = Part { name: "", colour: [terms[0]; 3], look: looks[0] };
        let rest = Part { name: "", colour: [terms[1]; 3], look: looks[1] };
        let row = Frame { low: [axis.points[0], y], high: [axis.points[1], y + thick - 0.5] };
        end = stack(sheet, axis, row, &[split, rest], 0).max(end);
    }
    let middle = f64::midpoint(top, bottom);
    let name = shortened(&lamp.name, axis.points[0] - left - 6.0, SMALL, Face::Sans);
    sheet.write(&name, [left, middle], Anchor::Start, SMALL, sheet.palette.faint);
    let none = lamp.diffuse == [0.0; 3] && lamp.specular == [0.0; 3];
    let sum = std::array::from_fn(|i| lamp.diffuse[i] + lamp.specular[i]);
    let full = if none { "adds nothing".to_owned() } else { amounts(sum) };
    sheet.write_over(&full, [end + 6.0, middle], Anchor::Start, SMALL, sheet.palette.faint);
    sheet.event = own;
}

/// What is more than 1 is clipped when the pixel is written.
fn full_line(sheet: &mut Sheet, axis: &Axis, [top, bottom]: [f64; 2]) {
    let x = axis.at(1.0);
    let stroke = Stroke::dashed(sheet.palette.faint, 1.2, [4.0, 3.0]);
    sheet.drawing.put(Form::Line { points: vec![[x, top], [x, bottom]], stroke }, None);
}

fn numbers(sheet: &mut Sheet, axis: &Axis, base: f64) {
    let [left, right] = axis.points;
    let faint = sheet.palette.faint;
    let stroke = Stroke::solid(faint, 1.0);
    sheet.drawing.put(Form::Line { points: vec![[left, base], [right, base]], stroke }, None);
    for tick in axis.ticks((right - left) / 50.0) {
        let x = axis.at(tick);
        sheet.drawing.put(Form::Line { points: vec![[x, base], [x, base + 4.0]], stroke }, None);
        sheet.write(&brief(tick), [x, base + 12.0], Anchor::Middle, SMALL, faint);
    }
}
