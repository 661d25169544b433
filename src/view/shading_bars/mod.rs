//! The colour that a ray brings back as stacked bars: five components that add up to the total, and below them each light's
//! part.

mod hatch;
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
    let mut sheet = Sheet::new(size, theme, event);
    let room = sheet.caption("Where the colour comes from", &format!("total {}", amounts(shading.total)));
    sheet.drawing.description = description(&shading);
    let (bars, table) = split(room, &shading);
    table::draw(&mut sheet, table, &shading);
    draw_bars(&mut sheet, bars, &shading);
    Some(sheet.drawing)
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

/// The bars at the left and the table at the right, or the table below.
fn split(room: Frame, shading: &Shading) -> (Frame, Frame) {
    let ([left, top], [right, bottom]) = (room.low, room.high);
    let [width, height] = room.size();
    if width >= 560.0 {
        let middle = right - table::WIDTH;
        return (
            Frame { low: [left, top], high: [middle - 16.0, bottom] },
            Frame { low: [middle, top], high: [right, bottom] },
        );
    }
    let lamps = shading.lamps.len() as f64;
    let wanted = 3.0 * 26.0 + 26.0 + lamps * 24.0;
    let middle = bottom - table::HEIGHT.min(0.66 * height);
    let bars = Frame { low: [left, top], high: [right, (top + wanted).min(middle - 4.0)] };
    (bars, Frame { low: [left, bars.high[1] + 6.0], high: [right, bottom] })
}

/// Room for the names of channels and lights, and for the totals.
const NAMES: [f64; 2] = [44.0, 96.0];
const SUMS: f64 = 50.0;
/// Room for the axis, and the height of all bars from which there is one.
const AXIS: f64 = 24.0;
const ROOMY: f64 = 84.0;

fn draw_bars(sheet: &mut Sheet, room: Frame, shading: &Shading) {
    let has_axis = room.size()[1] >= ROOMY;
    let bottom = room.high[1] - if has_axis { AXIS } else { 0.0 };
    let most = shading.total.into_iter().filter(|x| x.is_finite()).fold(1.0, f64::max);
    let widest = shading.lamps.iter().map(|lamp| text_width(&lamp.name, SMALL, Face::Sans)).fold(0.0, f64::max);
    let names = (widest + 8.0).min(0.25 * room.size()[0]).clamp(NAMES[0], NAMES[1]);
    let axis = Axis { values: [0.0, most], points: [room.low[0] + names, room.high[0] - SUMS] };
    if axis.points[1] - axis.points[0] < 30.0 || bottom - room.low[1] < 24.0 {
        return;
    }
    let lamps = shading.lamps.len() as f64;
    // A lamp has two thirds of a channel's height.
    let pitch = ((bottom - room.low[1]) / (3.0 + 0.67 * lamps)).clamp(12.0, 72.0);
    let mut y = room.low[1];
    for (channel, name) in CHANNELS.into_iter().enumerate() {
        let frame = Frame { low: [axis.points[0], y + 2.0], high: [axis.points[1], y + pitch - 2.0] };
        sheet.write(name, [room.low[0], y + 0.5 * pitch], Anchor::Start, TEXT, sheet.palette.ink);
        let end = stack(sheet, &axis, frame, &shading.parts, channel);
        let sum = amount(shading.total[channel]);
        sheet.write(&sum, [end + 6.0, y + 0.5 * pitch], Anchor::Start, TEXT, sheet.palette.ink);
        y += pitch;
    }
    for lamp in &shading.lamps {
        let next = y + 0.67 * pitch;
        if next > bottom + 0.5 {
            break;
        }
        draw_lamp(sheet, &axis, [y, next], room.low[0], lamp, &shading.parts);
        y = next;
    }
    full_line(sheet, &axis, [room.low[1], y]);
    if has_axis {
        numbers(sheet, &axis, y);
    }
}

/// The components one behind the other; gives where they end.
fn stack(sheet: &mut Sheet, axis: &Axis, row: Frame, parts: &[Part], channel: usize) -> f64 {
    let mut sum = 0.0;
    for part in parts {
        let next = sum + part.colour[channel];
        let [from, to] = [sum, next].map(|x| axis.at(x).clamp(axis.points[0], axis.points[1]));
        let frame = Frame { low: [from.min(to), row.low[1]], high: [from.max(to), row.high[1]] };
        if to != from {
            hatched(sheet, frame, part.look);
        }
        sum = next;
    }
    axis.at(sum).clamp(axis.points[0], axis.points[1])
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
    sheet.write(&full, [end + 6.0, middle], Anchor::Start, SMALL, sheet.palette.faint);
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
