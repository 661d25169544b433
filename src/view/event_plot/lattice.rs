//! A cell of the noise lattice in space: what its eight corners say of the point, and how much each counts.

use crate::record::{Lattice, LatticeCorner, Triple};
use crate::view::sheet::{Chart, Fact, Oblique, SMALL, Sheet, bounds, is_roomy, within_axes};
use crate::view::text::{brief, brief_vector};
use crate::view::{Anchor, Colour, Frame, Spot, Stroke};
use glam::DVec3;

/// The longest gradient's arrow in edges of the cell: longer ones would reach the arrows of the next corner.
const ARROW: f64 = 0.36;

/// The edges of a cube as pairs of corners, x fastest; the last three meet at the corner that is behind all others.
const EDGES: [[usize; 2]; 12] =
    [[0, 1], [1, 3], [4, 5], [5, 7], [7, 6], [6, 4], [0, 4], [1, 5], [3, 7], [0, 2], [2, 3], [2, 6]];
const HIDDEN: usize = 9;

pub(super) fn draw(sheet: &mut Sheet, lattice: &Lattice) {
    let note = format!(
        "p = {} lies at {} in its cell. Noise is the sum of value · weight over the corners: {}.",
        brief_vector(lattice.point),
        brief_vector(lattice.offset),
        brief(lattice.noise)
    );
    let room = sheet.caption(&format!("{} noise: one cell of the lattice", capital(&lattice.method)), &note);
    let mut facts = vec![
        Fact::Dot(sheet.palette.outside, "a corner, value > 0".to_owned()),
        Fact::Dot(sheet.palette.inside, "a corner, value < 0".to_owned()),
        Fact::words("larger dots: more weight"),
        Fact::Dot(sheet.palette.ink, "the point".to_owned()),
    ];
    if lattice.method != "value" {
        facts.insert(2, Fact::Line(Stroke::solid(sheet.palette.normal, 2.0), "its gradient".to_owned()));
    }
    let (room, below) = sheet.facts(room, &facts);
    if is_roomy(&room) && lattice.corners.len() == 8 {
        cell(sheet, lattice, room);
    }
    if let Some(below) = below {
        fade(sheet, lattice, below);
    }
}

fn capital(word: &str) -> String {
    let mut letters = word.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().collect::<String>() + letters.as_str())
}

fn cell(sheet: &mut Sheet, lattice: &Lattice, room: Frame) {
    let longest = lattice.corners.iter().map(|corner| length(corner.gradient)).fold(0.0, f64::max);
    let Some(view) = view(lattice, longest, &room) else { return };
    let place = |number: usize| view.at(step(number));
    for (number, [from, to]) in EDGES.into_iter().enumerate() {
        let ends = [place(from), place(to)];
        let colour = sheet.palette.faint;
        let stroke = if number < HIDDEN { Stroke::solid(colour, 1.3) } else { Stroke::dashed(colour, 1.0, [4.0, 4.0]) };
        sheet.line(&room, &ends, stroke);
        sheet.placer.avoid_line(ends[0], ends[1]);
    }
    names(sheet, &view);
    point(sheet, &view, lattice.offset, &room);
    for (number, corner) in lattice.corners.iter().enumerate() {
        gradient(sheet, &view, step(number), corner, longest);
    }
    for (number, corner) in lattice.corners.iter().enumerate() {
        dot(sheet, place(number), corner);
    }
    for (number, corner) in lattice.corners.iter().enumerate() {
        let text = format!("{} · {}", rounded(corner.value), rounded(corner.weight));
        sheet.write_near(&text, place(number), radius(corner) + 2.0, sheet.palette.ink);
    }
}

/// Where one looks from, so that the cell and all arrows have room, and beside them the texts.
fn view(lattice: &Lattice, longest: f64, room: &Frame) -> Option<Oblique> {
    let unit = Oblique { centre: [0.0; 2], scale: 1.0 };
    let tips = lattice.corners.iter().enumerate().map(|(number, corner)| tip(step(number), corner, longest));
    let [low, high] = bounds((0..8).map(step).chain(tips).map(|place| unit.at(place)))?;
    let [width, height] = room.size();
    let scale = (0.7 * width / (high[0] - low[0])).min(0.94 * height / (high[1] - low[1]));
    let centre = std::array::from_fn(|i| room.middle()[i] - scale * f64::midpoint(low[i], high[i]));
    Some(Oblique { centre, scale })
}

/// Where a gradient's arrow ends.
fn tip(from: Triple, corner: &LatticeCorner, longest: f64) -> Triple {
    let share = if longest > 0.0 { ARROW / longest } else { 0.0 };
    std::array::from_fn(|i| from[i] + share * corner.gradient[i])
}

/// The corner with this number, x fastest.
fn step(number: usize) -> Triple {
    [number & 1, number >> 1 & 1, number >> 2 & 1].map(|bit| bit as f64)
}

fn length(v: Triple) -> f64 {
    let length = DVec3::from_array(v).length();
    if length.is_finite() { length } else { 0.0 }
}

/// Three decimals, for numbers that are all about as large as 1.
fn rounded(x: f64) -> String {
    brief((x * 1e3).round() / 1e3)
}

/// The radius of a dot whose area is the corner's weight.
fn radius(corner: &LatticeCorner) -> f64 {
    3.0 + 9.0 * if corner.weight.is_finite() { corner.weight.clamp(0.0, 1.0).sqrt() } else { 0.0 }
}

fn colour(sheet: &Sheet, corner: &LatticeCorner) -> Colour {
    if corner.value < 0.0 { sheet.palette.inside } else { sheet.palette.outside }
}

fn gradient(sheet: &mut Sheet, view: &Oblique, from: Triple, corner: &LatticeCorner, longest: f64) {
    sheet.arrow(view.at(from), view.at(tip(from, corner, longest)), sheet.palette.normal, 1.8);
}

fn dot(sheet: &mut Sheet, at: Spot, corner: &LatticeCorner) {
    let fill = colour(sheet, corner);
    sheet.dot(at, radius(corner), fill);
}

/// The point, and how it stands above the floor of the cell.
fn point(sheet: &mut Sheet, view: &Oblique, offset: Triple, room: &Frame) {
    let [x, y, z] = offset;
    let stroke = Stroke::dashed(sheet.palette.ink.faded(0.7), 1.0, [2.0, 3.0]);
    let path = [[x, 0.0, 0.0], [x, y, 0.0], [x, y, z]].map(|at| view.at(at));
    sheet.line(room, &path, stroke);
    sheet.line(room, &[view.at([0.0, y, 0.0]), path[1]], stroke);
    if path.iter().flatten().all(|x| x.is_finite()) {
        sheet.dot(path[2], 4.5, sheet.palette.ink);
        sheet.write_near("p", path[2], 6.0, sheet.palette.ink);
    }
}

/// x, y and z beside the edges that run along them.
fn names(sheet: &mut Sheet, view: &Oblique) {
    let faint = sheet.palette.faint;
    for (at, name, [dx, dy]) in
        [([0.5, 0.0, 0.0], "x", [0.0, 10.0]), ([1.0, 0.5, 0.0], "y", [9.0, 6.0]), ([0.0, 0.0, 0.5], "z", [-9.0, 0.0])]
    {
        let [x, y] = view.at(at);
        sheet.write_over(name, [x + dx, y + dy], Anchor::Middle, SMALL, faint);
    }
}

/// The fade curve, and where the three coordinates lie on it.
fn fade(sheet: &mut Sheet, lattice: &Lattice, room: Frame) {
    let side = room.size()[0].min(room.size()[1]).min(190.0);
    let mut frame = within_axes(Frame { low: room.low, high: [room.low[0] + side + 30.0, room.low[1] + side] });
    frame.high[0] = frame.high[0].min(room.high[0] - 2.0);
    if !is_roomy(&frame) || side < 90.0 {
        return;
    }
    let chart = Chart::free(frame, [0.0, 1.0], [0.0, 1.0]);
    let curve = |x: f64| x * x * x * (x * (x * 6.0 - 15.0) + 10.0);
    let points: Vec<Spot> = (0..=40).map(|i| f64::from(i) / 40.0).map(|x| chart.at([x, curve(x)])).collect();
    sheet.line(&frame, &points, Stroke::solid(sheet.palette.combined, 2.0));
    let mut marked: Vec<(Spot, Vec<&str>)> = Vec::new();
    for (name, (x, y)) in ["x", "y", "z"].iter().zip(lattice.offset.into_iter().zip(lattice.fade)) {
        let at = chart.at([x, y]);
        match marked.iter_mut().find(|(known, _)| *known == at) {
            Some((_, names)) => names.push(name),
            None => marked.push((at, vec![name])),
        }
    }
    for (at, names) in marked.into_iter().filter(|(at, _)| frame.grown(1.0).contains(*at)) {
        sheet.mark(&frame, at, 3.5, sheet.palette.ink);
        sheet.write_near(&names.join(", "), at, 6.0, sheet.palette.ink);
    }
    sheet.axes(&chart, ["", "fade"], false);
}
