//! A primitive in its own space, as textbooks draw it: the unit sphere, the cube from −1 to 1, with the ray S + c t.
//!
//! On the left the section by a plane that holds the ray, where lengths along the ray are true to each other; on the right
//! all of the shape's outline. Small drawings show one of the two.

mod section;
mod space;
#[cfg(test)]
mod tests;

use super::drawing::{Anchor, Drawing, Frame, Spot, Stroke};
use super::fonts::{Face, text_width};
use super::labels::{Label, wrapped};
use super::palette::Theme;
use super::primitive_at::PrimitiveAt;
use super::sheet::{Fact, SMALL, Sheet, TEXT, is_roomy};
use super::text::{brief, brief_vector, titled};
use crate::record::{CandidateFate, EventId, format_number};
use crate::scene::Scene;
use crate::shape::{Bounds, Primitive};
use crate::trace::RayTree;
use glam::DVec3;
use std::fmt::Write as _;

/// Which of the two halves is shown where there is no room for both.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum GenericLook {
    /// The section by a plane that holds the ray.
    #[default]
    Section,
    /// The outline in space.
    Space,
}

/// What of the generic space is seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GenericViewOptions {
    /// Width and height in points.
    pub size: [f64; 2],
    /// Light or dark.
    pub theme: Theme,
    /// What is shown where there is room for one half alone.
    pub look: GenericLook,
    /// A time on the ray that is marked.
    pub probe_t: Option<f64>,
}

/// The primitive that `selected` is about, in its generic coordinates.
#[must_use]
pub fn generic_view(scene: &Scene, tree: &RayTree, selected: EventId, options: &GenericViewOptions) -> Option<Drawing> {
    let at = PrimitiveAt::of(scene, tree, selected)?;
    if !(at.origin.is_finite() && at.direction.is_finite() && at.direction != DVec3::ZERO) {
        return None;
    }
    let mut sheet = Sheet::new(options.size, options.theme, at.event);
    let name = titled(at.leaf.shape.name(), &at.leaf.name);
    let note = format!("S = {}, c = {}", brief_vector(at.origin.to_array()), brief_vector(at.direction.to_array()));
    let room = sheet.caption(&format!("{name}: F = {}", at.leaf.shape.equation()), &note);
    let subject = Subject { at, probe_t: options.probe_t.filter(|t| t.is_finite()), selected };
    let room = matrix(&mut sheet, room, &subject);
    sheet.drawing.description = subject.description(&name);
    let [left, right] = halves(room, options.look);
    if let Some(frame) = left.filter(is_roomy) {
        section::draw(&mut sheet, &frame, &subject);
    }
    if let Some(frame) = right.filter(is_roomy) {
        space::draw(&mut sheet, &frame, &subject);
    }
    Some(sheet.finish())
}

/// Both halves where there is the width for them, else the one that is asked for.
fn halves(room: Frame, look: GenericLook) -> [Option<Frame>; 2] {
    let [width, _] = room.size();
    if width >= 520.0 {
        let middle = room.middle()[0];
        return [
            Some(Frame { high: [middle - 8.0, room.high[1]], ..room }),
            Some(Frame { low: [middle + 8.0, room.low[1]], ..room }),
        ];
    }
    match look {
        GenericLook::Section => [Some(room), None],
        GenericLook::Space => [None, Some(room)],
    }
}

/// The matrix that takes the world's ray there, in a column at the right where there is room.
fn matrix(sheet: &mut Sheet, room: Frame, subject: &Subject) -> Frame {
    if room.size()[0] < 700.0 {
        return room;
    }
    let mut facts = vec![Fact::words("M⁻¹, world to generic")];
    let cells = subject.at.inverse.map(|row| row.map(brief));
    for row in &cells {
        let [a, b, c, d] = std::array::from_fn(|i| padded(&row[i], &cells.each_ref().map(|row| row[i].as_str())));
        facts.push(Fact::words(format!("{a}  {b}  {c}  |  {d}")));
    }
    facts.push(Fact::words("S = M⁻¹ origin"));
    facts.push(Fact::words("c = M⁻¹ direction"));
    facts.push(Fact::words("t is the same in both spaces"));
    sheet.facts(room, &facts).0
}

/// A number with as much space before it as makes it as wide as the widest of its column.
fn padded(number: &str, column: &[&str]) -> String {
    /// As wide as a digit, as a point, and narrower than any sign.
    const SPACES: [char; 3] = ['\u{2007}', '\u{2008}', '\u{200a}'];
    let width = |text: &str| text_width(text, TEXT, Face::Sans);
    let widest = column.iter().map(|other| width(other)).fold(0.0, f64::max) + 1e-6;
    let mut padded = number.to_owned();
    for space in SPACES {
        while width(&format!("{space}{padded}")) <= widest {
            padded.insert(0, space);
        }
    }
    padded
}

/// What a half shows, at its foot, set off from the ray.
fn subtitle(sheet: &mut Sheet, frame: &Frame, text: &str) {
    // The scale stands beside it.
    let lines = wrapped(text, frame.size()[0] - 60.0, SMALL, Face::Sans);
    let above = lines.len() - 1;
    for (i, line) in lines.into_iter().enumerate() {
        let y = frame.high[1] - 7.0 - 1.3 * SMALL * (above - i) as f64;
        let label = Label::new(line, SMALL, sheet.palette.faint);
        let text = label.at([frame.low[0] + 2.0, y], Anchor::Start, Some(sheet.palette.ground));
        sheet.placer.put_at(&mut sheet.drawing, text, None);
    }
}

/// What is drawn, in both halves alike.
struct Subject<'a> {
    at: PrimitiveAt<'a>,
    probe_t: Option<f64>,
    selected: EventId,
}

/// A place on the ray.
struct Stop {
    t: f64,
    point: DVec3,
    event: EventId,
    accepted: bool,
    normal: DVec3,
}

impl Subject<'_> {
    fn description(&self, name: &str) -> String {
        let at = &self.at;
        let mut text = format!(
            "{name} in its generic coordinates, where F = {}. The ray starts at S = {} and runs along c = {}.",
            at.leaf.shape.equation(),
            brief_vector(at.origin.to_array()),
            brief_vector(at.direction.to_array())
        );
        for stop in self.stops() {
            let [point, normal] = [stop.point, stop.normal].map(|v| brief_vector(v.to_array()));
            let t = format_number(stop.t);
            let _ = if stop.accepted {
                write!(text, " At t = {t} it is at {point}, a hit with the normal {normal}.")
            } else {
                write!(text, " At t = {t} it is at {point}, no hit of it.")
            };
        }
        if at.hits().next().is_none() {
            text.push_str(" It does not meet the shape.");
        }
        if let Some(t) = self.probe_t {
            let point = brief_vector(at.point(t).to_array());
            let _ = write!(text, " At the marked t = {} it is at {point}, where d = {}.", brief(t), brief(at.d(t)));
        }
        text
    }

    /// Every hit time that was looked at.
    fn stops(&self) -> Vec<Stop> {
        let stop = |(event, candidate): (EventId, &crate::record::Candidate)| Stop {
            t: candidate.t,
            point: DVec3::from_array(candidate.point),
            event,
            accepted: candidate.fate == CandidateFate::Accepted,
            normal: self.at.normal(candidate),
        };
        self.at.candidates().map(stop).filter(|stop| stop.t.is_finite() && stop.point.is_finite()).collect()
    }

    /// The corners of what should be seen of the shape: its box, of an unbounded one the part around the ray's hits.
    fn bounds(&self) -> [DVec3; 2] {
        let Bounds { low, high } = self.at.leaf.shape.bounds();
        let reach = |x: f64, open: f64| if x.is_finite() { x } else { open };
        let hits: Vec<DVec3> = self.stops().iter().map(|stop| stop.point).collect();
        let around =
            hits.first().copied().unwrap_or_else(|| self.at.origin.clamp(DVec3::splat(-6.0), DVec3::splat(6.0)));
        let corner = |bound: DVec3, side: f64| {
            DVec3::from_array(std::array::from_fn(|i| reach(bound[i], around[i] + side * 2.0)))
        };
        [corner(low, -1.0), corner(high, 1.0)]
    }

    /// S where it is not so far off that the shape would be a speck.
    fn start(&self) -> Option<DVec3> {
        let [low, high] = self.bounds();
        let (middle, size) = ((low + high) * 0.5, (high - low).length());
        (self.at.origin.distance(middle) < 2.2 * size).then_some(self.at.origin)
    }

    /// The time nearest to the middle of the shape.
    fn middle_t(&self) -> f64 {
        let [low, high] = self.bounds();
        let c = self.at.direction;
        ((low + high) * 0.5 - self.at.origin).dot(c) / c.length_squared()
    }

    /// The ray, its start, its stops and the probe, by what takes generic points to places.
    fn ray(&self, sheet: &mut Sheet, frame: &Frame, place: &dyn Fn(DVec3) -> Spot) {
        let palette = sheet.palette;
        let own = sheet.event;
        sheet.event = self.at.transform;
        let [low, high] = self.bounds();
        let reach = 4.0 * (high - low).length() / self.at.direction.length();
        let middle = self.middle_t();
        let (from, to) = ((middle - reach).max(0.0).min(middle + reach), middle + reach);
        let (first, last) = (place(self.at.point(from)), place(self.at.point(to)));
        let behind = place(self.at.point((middle - reach).min(0.0)));
        sheet.line(frame, &[behind, first], Stroke::dashed(palette.camera.faded(0.45), 1.2, [3.0, 4.0]));
        sheet.line(frame, &[first, last], Stroke::solid(palette.camera, 2.2));
        sheet.placer.avoid_line(first, last);
        self.head(sheet, frame, place, middle);
        if let Some(start) = self.start().map(place) {
            sheet.mark(frame, start, 4.0, palette.ink);
            if frame.contains(start) {
                sheet.write_near("S", start, 6.0, palette.ink);
            }
        }
        sheet.event = own;
        for stop in self.stops() {
            self.stop(sheet, frame, place, &stop);
        }
        self.probe(sheet, frame, place);
        sheet.event = own;
    }

    /// An arrow head before the first hit, or in the middle.
    fn head(&self, sheet: &mut Sheet, frame: &Frame, place: &dyn Fn(DVec3) -> Spot, middle: f64) {
        let t = self.at.hits().next().unwrap_or(middle);
        let at = place(self.at.point(t));
        let next = place(self.at.point(t + 1e-3 / self.at.direction.length()));
        let way = [next[0] - at[0], next[1] - at[1]];
        let length = super::drawing::length(way);
        if length.is_nan() || length <= 1e-9 {
            return;
        }
        let back = |points: f64| std::array::from_fn(|i| at[i] - way[i] / length * points);
        let (from, to) = (back(34.0), back(22.0));
        if frame.contains(from) && frame.contains(to) {
            sheet.arrow(from, to, sheet.palette.camera, 2.2);
        }
    }

    fn stop(&self, sheet: &mut Sheet, frame: &Frame, place: &dyn Fn(DVec3) -> Spot, stop: &Stop) {
        let palette = sheet.palette;
        let at = place(stop.point);
        if !frame.contains(at) {
            return;
        }
        sheet.event = stop.event;
        if !stop.accepted {
            let stroke = Stroke::solid(palette.bad, 1.6);
            for slope in [1.0, -1.0] {
                let ends = [[at[0] - 3.5, at[1] - 3.5 * slope], [at[0] + 3.5, at[1] + 3.5 * slope]];
                sheet.line(frame, &ends, stroke);
            }
            sheet.write_near(&brief(stop.t), at, 6.0, palette.bad);
            return;
        }
        let unit = place(stop.point + stop.normal * 1e-3);
        let way = [unit[0] - at[0], unit[1] - at[1]];
        let one = place(stop.point + self.any_across(stop.normal) * 1e-3);
        let scale = super::drawing::length([one[0] - at[0], one[1] - at[1]]).max(super::drawing::length(way));
        if scale > 0.0 {
            let tip = std::array::from_fn(|i| at[i] + way[i] / scale * 30.0);
            if sheet.arrow(at, tip, palette.normal, 1.6) {
                sheet.write_near("n", tip, 2.0, palette.normal);
            }
        }
        let colour = if stop.t < 0.0 { palette.faint } else { palette.good };
        sheet.mark(frame, at, 4.6, colour);
        sheet.write_near(&format!("t = {}", brief(stop.t)), at, 7.0, palette.ink);
    }

    /// Some direction at a right angle to the normal that lies in the plane of ray and normal.
    fn any_across(&self, normal: DVec3) -> DVec3 {
        let c = self.at.direction.normalize();
        (c - normal * c.dot(normal)).normalize_or(c)
    }

    fn probe(&self, sheet: &mut Sheet, frame: &Frame, place: &dyn Fn(DVec3) -> Spot) {
        let Some(t) = self.probe_t else { return };
        let at = place(self.at.point(t));
        if !frame.contains(at) {
            return;
        }
        sheet.event = self.selected;
        let d = self.at.d(t);
        let word = if d > 0.0 { "outside" } else { "inside" };
        sheet.mark(frame, at, 6.5, sheet.palette.highlight);
        sheet.mark(frame, at, 2.5, sheet.palette.ink);
        let ink = sheet.palette.ink;
        sheet.write_near(&format!("t = {}: d = {}, {word}", brief(t), brief(d)), at, 9.0, ink);
    }
}
