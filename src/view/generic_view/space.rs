//! The shape's outline in space, seen along parallel lines, with the ray.

use super::{Subject, subtitle};
use crate::shape::Primitive;
use crate::view::drawing::{Frame, Spot, Stroke};
use crate::view::sheet::{Oblique, Sheet, bounds};
use glam::DVec3;

/// How long the axes are drawn.
const AXIS: f64 = 1.6;

pub(super) fn draw(sheet: &mut Sheet, frame: &Frame, subject: &Subject) {
    let outline = subject.at.leaf.shape.outline();
    let unit = Oblique { centre: [0.0; 2], scale: 1.0 };
    let [low, high] = subject.bounds();
    let hits = subject.stops().into_iter().filter(|stop| stop.accepted).map(|stop| stop.point);
    let near: Vec<DVec3> = subject.start().into_iter().chain(hits).collect();
    // The ends of the axes too, unless what is seen lies so far off that it would become a speck.
    let tips = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z].map(|axis| axis * AXIS);
    let are_near = (0.5 * (low + high)).length() < 2.2 * (high - low).length();
    let tips = tips.into_iter().filter(|_| are_near);
    let points = outline.iter().flatten().copied().chain(near).chain([low, high]).chain(tips);
    let Some([low, high]) = bounds(points.map(|point| unit.at(point.to_array()))) else { return };
    let room = frame.size();
    let scale = (0..2).map(|i| (room[i] - 36.0).max(20.0) / (high[i] - low[i]).max(1e-9)).fold(f64::INFINITY, f64::min);
    let middle = frame.middle();
    let centre: Spot = std::array::from_fn(|i| middle[i] - scale * f64::midpoint(low[i], high[i]));
    let view = Oblique { centre, scale };
    let place = |point: DVec3| view.at(point.to_array());
    let own = std::mem::replace(&mut sheet.event, subject.at.event);
    axes(sheet, frame, &place);
    for line in &outline {
        let spots: Vec<Spot> = line.iter().map(|point| place(*point)).collect();
        sheet.line(frame, &spots, Stroke::solid(sheet.palette.inside.faded(0.75), 1.1));
    }
    sheet.event = own;
    subject.ray(sheet, frame, &place);
    subtitle(sheet, frame, "all of it");
}

/// The coordinate axes with their ones.
fn axes(sheet: &mut Sheet, frame: &Frame, place: &dyn Fn(DVec3) -> Spot) {
    let faint = sheet.palette.faint;
    for (axis, name) in [(DVec3::X, "x"), (DVec3::Y, "y"), (DVec3::Z, "z")] {
        let tip = place(axis * AXIS);
        sheet.line(frame, &[place(DVec3::ZERO), tip], Stroke::solid(faint.faded(0.7), 1.0));
        sheet.mark(frame, place(axis), 1.8, faint);
        if frame.contains(tip) {
            sheet.write_near(name, tip, 2.0, faint);
        }
    }
}
