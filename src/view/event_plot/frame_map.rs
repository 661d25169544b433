//! Tangent, binormal and normal before and after, in space, with the roughness along and across the grain.

use crate::math::portable;
use crate::record::{FrameMap, Triple};
use crate::view::sheet::{Fact, Oblique, Sheet, is_roomy};
use crate::view::text::{brief, place};
use crate::view::{Spot, Stroke};
use glam::DVec3;

pub(super) fn draw(sheet: &mut Sheet, map: &FrameMap) {
    let note = format!(
        "Turned by {}° about N, then tilted by the slopes {} along and across the grain.",
        brief(map.turn),
        place(map.tilt)
    );
    let room = sheet.caption("The frame before and after", &note);
    let colours = [sheet.palette.left, sheet.palette.right, sheet.palette.normal];
    let facts = [
        Fact::Line(Stroke::dashed(sheet.palette.faint, 1.2, [4.0, 3.0]), "before: T, B, N".to_owned()),
        Fact::Line(Stroke::solid(colours[0], 2.6), "T′, along the grain".to_owned()),
        Fact::Line(Stroke::solid(colours[1], 2.6), "B′, across the grain".to_owned()),
        Fact::Line(Stroke::solid(colours[2], 2.6), "N′, the normal".to_owned()),
        Fact::Swatch(sheet.palette.highlight.faded(0.35), format!("roughness {}", place(map.roughness))),
    ];
    let facts: Vec<Fact> = facts.into_iter().chain(highlight(map.roughness).map(Fact::words)).collect();
    let (room, _) = sheet.facts(room, &facts);
    let [width, height] = room.size();
    let axes = map.before.map(DVec3::from_array);
    // Seen in the frame before: its T, B and N are x, y and z.
    let local = |v: Triple| axes.map(|axis| axis.dot(DVec3::from_array(v)));
    let known = map.before.iter().chain(&map.after).flatten().chain(&map.roughness).all(|x| x.is_finite());
    if !is_roomy(&room) || !known {
        return;
    }
    let scale = (width / 2.9).min(height / 2.15);
    let view = Oblique { centre: [room.middle()[0], room.middle()[1] + 0.18 * scale], scale };
    let plane = circle(|cos, sin| view.at([cos, sin, 0.0]));
    sheet.area(&room, std::slice::from_ref(&plane), sheet.palette.faint.faded(0.1));
    sheet.outline(&room, &plane, Stroke::solid(sheet.palette.grid, 1.0));
    let after = map.after.map(local);
    roughness(sheet, &view, &after, map.roughness, &room);
    let origin = view.at([0.0; 3]);
    let before = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|axis| view.at(axis));
    for tip in before {
        sheet.line(&room, &[origin, tip], Stroke::dashed(sheet.palette.faint, 1.4, [4.0, 3.0]));
        sheet.placer.avoid_line(origin, tip);
    }
    let after = after.map(|vector| view.at(vector));
    let drawn = [0, 1, 2].map(|i| sheet.arrow(origin, after[i], colours[i], 2.6));
    for (i, name) in ["T′", "B′", "N′"].into_iter().enumerate().filter(|(i, _)| drawn[*i]) {
        sheet.write_near(name, after[i], 6.0, colours[i]);
    }
    for (tip, name) in before.into_iter().zip(["T", "B", "N"]) {
        sheet.write_near(name, tip, 5.0, sheet.palette.ink);
    }
    sheet.dot(origin, 3.5, sheet.palette.ink);
}

/// The ellipse of roughness in the plane of T′ and B′, its larger half axis 0.7.
fn roughness(
    sheet: &mut Sheet,
    view: &Oblique,
    [t, b, _]: &[Triple; 3],
    roughness: [f64; 2],
    room: &crate::view::Frame,
) {
    let largest = roughness[0].abs().max(roughness[1].abs());
    if largest > 0.0 {
        let [along, across] = roughness.map(|x| 0.7 * x / largest);
        let ellipse = circle(|cos, sin| view.at(std::array::from_fn(|i| along * cos * t[i] + across * sin * b[i])));
        sheet.area(room, std::slice::from_ref(&ellipse), sheet.palette.highlight.faded(0.35));
        sheet.outline(room, &ellipse, Stroke::solid(sheet.palette.highlight, 1.6));
    }
}

/// What the roughness does: it is the spread of the surface's slopes, so a highlight is drawn out where it is larger.
fn highlight([along, across]: [f64; 2]) -> [&'static str; 2] {
    if along < across {
        ["highlight: narrow along the grain,", "wide across it"]
    } else if along > across {
        ["highlight: wide along the grain,", "narrow across it"]
    } else {
        ["highlight: the same along the grain", "and across it"]
    }
}

/// Places around a circle.
fn circle(at: impl Fn(f64, f64) -> Spot) -> Vec<Spot> {
    let angles = (0..72).map(|i| f64::from(i) * std::f64::consts::TAU / 72.0);
    angles.map(|angle| at(portable::cos(angle), portable::sin(angle))).collect()
}
