//! The section of the shape by a plane that holds the ray.

use super::{Subject, subtitle};
use crate::csg::{Leaf, Placement, Solid};
use crate::math::portable;
use crate::shape::{Bounds, Primitive, Shape};
use crate::view::axis::round_step;
use crate::view::drawing::{Anchor, Form, Frame, Spot, Stroke};
use crate::view::labels::Label;
use crate::view::sheet::{SMALL, Sheet};
use crate::view::side_view::{PlaneView, section};
use crate::view::text::brief;
use glam::{DAffine3, DVec3};

pub(super) fn draw(sheet: &mut Sheet, frame: &Frame, subject: &Subject) {
    let Some(plane) = plane(frame, subject) else { return };
    let shape = subject.at.leaf.shape.clone();
    let Ok(placement) = Placement::new(DAffine3::IDENTITY) else { return };
    let solid = Solid::leaf(Leaf::new(subject.at.leaf.name.clone(), shape, placement));
    let section = section(&solid, &plane, sheet.drawing.frame());
    let own = std::mem::replace(&mut sheet.event, subject.at.event);
    axes(sheet, frame, &plane);
    let colour = sheet.palette.inside;
    sheet.area(frame, &section.rings, colour.faded(0.2));
    for line in &section.outline {
        sheet.line(frame, line, Stroke::solid(colour, 2.0));
    }
    if section.outline.is_empty() {
        for [from, to] in cuts(&subject.at.leaf.shape, &plane) {
            sheet.line(frame, &[from, to], Stroke::solid(colour, 2.0));
            sheet.placer.avoid_line(from, to);
        }
    }
    sheet.event = own;
    subject.ray(sheet, frame, &|point| plane.spot(point));
    caption(sheet, frame, &plane);
}

/// Where the plane cuts a shape that bounds nothing: from where its edge goes through the plane to where it comes back.
fn cuts(shape: &Shape, plane: &PlaneView) -> Vec<[Spot; 2]> {
    let Bounds { low, high } = shape.bounds();
    if (high - low).min_element() > 0.0 {
        return Vec::new();
    }
    let side = |point: DVec3| (point - plane.origin).dot(plane.normal);
    let outline = shape.outline();
    let pairs = outline.iter().flat_map(|line| line.windows(2)).map(|pair| [pair[0], pair[1]]);
    let crossing = |[from, to]: [DVec3; 2]| {
        let [before, after] = [side(from), side(to)];
        ((before < 0.0) != (after < 0.0)).then(|| plane.spot(from.lerp(to, before / (before - after))))
    };
    let mut spots: Vec<Spot> = pairs.filter_map(crossing).collect();
    spots.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    spots.chunks_exact(2).map(|ends| [ends[0], ends[1]]).collect()
}

/// The plane of the ray and of z, which stays upright; where the ray runs along z nearly, that of the ray and of y. The ray runs
/// to the right.
fn plane(frame: &Frame, subject: &Subject) -> Option<PlaneView> {
    let direction = subject.at.direction.try_normalize()?;
    let up = [DVec3::Z, DVec3::Y, DVec3::X].into_iter().find(|axis| axis.dot(direction).abs() < 0.9)?;
    let across = (direction - up * direction.dot(up)).try_normalize()?;
    let normal = across.cross(up);
    let mut plane = PlaneView { origin: subject.at.origin, across, up, normal, scale: 1.0, centre: [0.0; 2] };
    let [low, high] = seen(&plane, subject);
    let room = frame.size();
    let extent: Spot = std::array::from_fn(|i| (high[i] - low[i]).max(1e-9));
    let scale = ((room[0] - 40.0).max(20.0) / extent[0]).min((room[1] - 40.0).max(20.0) / extent[1]);
    let middle: Spot = std::array::from_fn(|i| f64::midpoint(low[i], high[i]) * scale);
    let target = frame.middle();
    plane.scale = scale;
    plane.centre = std::array::from_fn(|i| target[i] - middle[i]);
    (scale.is_finite() && scale > 0.0).then_some(plane)
}

/// The corners of what should be seen in the plane's unit scale: the shape's box, the hits, and S if it is near.
fn seen(plane: &PlaneView, subject: &Subject) -> [Spot; 2] {
    let [low, high] = subject.bounds();
    let corner = |i: usize| DVec3::from_array(std::array::from_fn(|k| if i >> k & 1 == 0 { low[k] } else { high[k] }));
    let hits = subject.stops().into_iter().map(|stop| stop.point).filter(|point| {
        let middle = (low + high) * 0.5;
        point.distance(middle) < 1.6 * (high - low).length()
    });
    let points = (0..8).map(corner).chain(subject.start()).chain(hits);
    let spots = points.map(|point| plane.spot(point));
    spots.fold([[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]], |[low, high], spot| {
        [std::array::from_fn(|i| low[i].min(spot[i])), std::array::from_fn(|i| high[i].max(spot[i]))]
    })
}

/// The traces of the coordinate axes: each is drawn as it is seen along the plane's normal, through the foot of the origin.
fn axes(sheet: &mut Sheet, frame: &Frame, plane: &PlaneView) {
    let origin = plane.spot(DVec3::ZERO);
    let faint = sheet.palette.faint;
    for (axis, name) in [(DVec3::X, "x"), (DVec3::Y, "y"), (DVec3::Z, "z")] {
        let [x, y] = plane.shift(axis);
        if portable::hypot(x, y) < 0.35 * plane.scale {
            continue;
        }
        let end = |length: f64| [origin[0] + x * length, origin[1] + y * length];
        sheet.line(frame, &[end(-1.6), end(1.6)], Stroke::solid(faint.faded(0.5), 0.9));
        for one in [-1.0, 1.0] {
            sheet.mark(frame, end(one), 1.8, faint);
        }
        if frame.contains(end(1.6)) {
            sheet.write_near(name, end(1.6), 2.0, faint);
        }
    }
}

/// Which plane it is, and its scale.
fn caption(sheet: &mut Sheet, frame: &Frame, plane: &PlaneView) {
    let faint = sheet.palette.faint;
    let off = (plane.origin.dot(plane.normal)).abs();
    let text = if off < 1e-9 {
        "section through the ray and the origin".to_owned()
    } else {
        format!("section through the ray, {} from the origin", brief(off))
    };
    subtitle(sheet, frame, &text);
    let length = round_step(40.0 / plane.scale);
    let points = length * plane.scale;
    if points >= 0.4 * frame.size()[0] {
        return;
    }
    // At the right, or as far from it as the ray and its names leave room.
    let y = frame.high[1] - 4.0;
    let number = Label::new(brief(length), SMALL, faint);
    for right in [6.0, 66.0, 126.0, 186.0].map(|aside| frame.high[0] - aside) {
        let text = number.at([right - points - 5.0, y - 3.0], Anchor::End, None);
        let whole = Frame { low: text.frame().low, high: [right, text.frame().high[1].max(y)] };
        if whole.low[0] > frame.low[0] && sheet.placer.is_clear(&whole) {
            let bar = [[right - points, y - 3.0], [right - points, y], [right, y], [right, y - 3.0]];
            sheet.line(frame, &bar, Stroke::solid(faint, 1.2));
            sheet.placer.reserve(whole);
            sheet.drawing.put(Form::Text(text), None);
            return;
        }
    }
}
