//! The rays at the interface: the normal upright, the incoming ray from the left.

use super::{Interface, percent};
use crate::math::portable;
use crate::record::EventId;
use crate::view::drawing::{Anchor, Form, Frame, Spot, Stroke};
use crate::view::fonts::Face;
use crate::view::labels::{Label, shortened};
use crate::view::palette::Colour;
use crate::view::sheet::{SMALL, Sheet, TEXT};
use crate::view::text::{brief, degrees};
use std::f64::consts::FRAC_PI_2;

/// Room for names at the ends of rays, in points.
const RIM: f64 = 20.0;

/// Between rays that are shorter there is no room for numbers, in points.
const ROOMY: f64 = 130.0;

pub(super) fn draw(sheet: &mut Sheet, room: &Frame, interface: &Interface) {
    let [width, height] = room.size();
    let radius = (0.5 * width).min(0.5 * height) - RIM;
    if radius < 24.0 {
        return;
    }
    let fan = Fan { centre: room.middle(), radius, room: *room };
    fan.media(sheet, interface);
    fan.normal(sheet);
    if let Some(critical) = interface.critical {
        fan.critical(sheet, critical);
    }
    fan.rays(sheet, interface);
    fan.arcs(sheet, interface);
    fan.names(sheet, interface);
}

struct Fan {
    centre: Spot,
    radius: f64,
    room: Frame,
}

impl Fan {
    /// The place at a distance from the foot and an angle in degrees from the upward normal, clockwise.
    fn at(&self, distance: f64, angle: f64) -> Spot {
        let (sin, cos) = portable::sin_cos(angle.to_radians());
        [self.centre[0] + distance * sin, self.centre[1] - distance * cos]
    }

    /// The media as two grounds, the denser the darker.
    fn media(&self, sheet: &mut Sheet, interface: &Interface) {
        let Frame { low: [left, top], high: [right, bottom] } = self.room;
        let y = self.centre[1];
        let frames = [Frame { low: [left, top], high: [right, y] }, Frame { low: [left, y], high: [right, bottom] }];
        for (frame, n) in frames.into_iter().zip(interface.indices) {
            let opacity = (0.04 + 0.2 * (n - 1.0)).clamp(0.04, 0.3);
            let fill = Some(sheet.palette.left.faded(opacity));
            sheet.drawing.put(Form::Rect { frame, fill, stroke: None }, sheet.event);
        }
        let stroke = Stroke::solid(sheet.palette.ink, 1.8);
        sheet.line(&self.room, &[[left, y], [right, y]], stroke);
        sheet.placer.avoid_line([left, y], [right, y]);
        let ink = sheet.palette.ink;
        for (i, y) in [top + 10.0, bottom - 10.0].into_iter().enumerate() {
            let n = format!("n{} = {}", ["₁", "₂"][i], brief(interface.indices[i]));
            let name = &interface.names[i];
            let text = if name.is_empty() { n } else { format!("{n}, {name}") };
            let text = shortened(&text, 0.62 * (right - left), TEXT, Face::Sans);
            sheet.write(&text, [left + 6.0, y], Anchor::Start, TEXT, ink);
        }
    }

    fn normal(&self, sheet: &mut Sheet) {
        let ends = [self.at(self.radius, 0.0), self.at(self.radius, 180.0)];
        let stroke = Stroke::dashed(sheet.palette.normal, 1.3, [5.0, 4.0]);
        sheet.line(&self.room, &ends, stroke);
        sheet.placer.avoid_line(ends[0], ends[1]);
    }

    /// Where total internal reflection begins, on the side that the ray comes from.
    fn critical(&self, sheet: &mut Sheet, critical: f64) {
        let end = self.at(0.86 * self.radius, -critical);
        let stroke = Stroke::dashed(sheet.palette.bad, 1.4, [3.0, 3.0]);
        sheet.line(&self.room, &[self.centre, end], stroke);
        sheet.placer.avoid_line(self.centre, end);
    }

    /// Wider where more light goes.
    fn rays(&self, sheet: &mut Sheet, interface: &Interface) {
        let palette = sheet.palette;
        let share = interface.reflectance.clamp(0.0, 1.0);
        let [incoming, reflected, refracted] = interface.rays;
        let from = self.at(self.radius, -interface.theta1);
        self.ray(sheet, [from, self.centre], palette.camera, 3.0, incoming);
        let to = self.at(self.radius, interface.theta1);
        self.ray(sheet, [self.centre, to], palette.reflected, 1.2 + 1.8 * share, reflected);
        if let Some(theta2) = interface.theta2 {
            let to = self.at(self.radius, 180.0 - theta2);
            self.ray(sheet, [self.centre, to], palette.refracted, 3.0 - 1.8 * share, refracted);
        }
    }

    fn ray(&self, sheet: &mut Sheet, [from, to]: [Spot; 2], colour: Colour, width: f64, event: Option<EventId>) {
        let own = sheet.event;
        sheet.event = event.unwrap_or(own);
        sheet.line(&self.room, &[from, to], Stroke::solid(colour, width));
        let way = |share: f64| std::array::from_fn(|i| from[i] + (to[i] - from[i]) * share);
        sheet.arrow(way(0.4), way(0.62), colour, width);
        sheet.placer.avoid_line(from, to);
        sheet.event = own;
    }

    fn arcs(&self, sheet: &mut Sheet, interface: &Interface) {
        let colour = sheet.palette.normal;
        let up = -FRAC_PI_2;
        let theta1 = interface.theta1.to_radians();
        // The caption has the numbers too.
        let named = |name: &str, angle: f64| {
            if self.radius < ROOMY { name.to_owned() } else { format!("{name} = {}", degrees(angle)) }
        };
        let arcs = [
            (0.34, [up, up - theta1], Some(named("θ₁", interface.theta1))),
            (0.34, [up, up + theta1], Some("θ₁".to_owned())),
        ];
        let second = interface
            .theta2
            .map(|theta2| (0.4, [FRAC_PI_2, FRAC_PI_2 - theta2.to_radians()], Some(named("θ₂", theta2))));
        for (share, angles, text) in arcs.into_iter().chain(second) {
            let radius = share * self.radius;
            let stroke = Stroke::solid(colour, 1.6);
            sheet.arc(self.centre, radius, angles, stroke);
            let (sin, cos) = portable::sin_cos(f64::midpoint(angles[0], angles[1]));
            let middle = [self.centre[0] + radius * cos, self.centre[1] + radius * sin];
            if let Some(text) = text {
                sheet.write_near(&text, middle, 6.0, colour);
            }
        }
    }

    /// The rays' names and shares at their ends, the critical angle at its line.
    fn names(&self, sheet: &mut Sheet, interface: &Interface) {
        let palette = sheet.palette;
        let share = interface.reflectance;
        if let Some(critical) = interface.critical {
            let around = self.at(0.86 * self.radius, -critical);
            sheet.write_near(&format!("critical {}", degrees(critical)), around, 4.0, palette.bad);
        }
        // At either end of the normal, where no ray runs beside it.
        let ends = [0.0, 180.0].map(|angle| self.at(self.radius - 4.0, angle));
        let sides = [(5.0, Anchor::Start), (-5.0, Anchor::End)];
        let places = ends.into_iter().flat_map(|[x, y]| sides.map(|(aside, anchor)| ([x + aside, y], anchor)));
        let texts = places.map(|(at, anchor)| Label::new("normal", SMALL, palette.normal).at(at, anchor, None));
        if let Some(text) = texts.into_iter().find(|text| sheet.placer.is_clear(&text.frame())) {
            sheet.placer.put_at(&mut sheet.drawing, text, Some(sheet.event));
        }
        let out = self.radius - 2.0;
        let mut ends = vec![
            (self.at(out, interface.theta1), format!("reflected {}", percent(share)), palette.reflected),
            (self.at(out, -interface.theta1), "incoming".to_owned(), palette.camera),
        ];
        if let Some(theta2) = interface.theta2 {
            let text = format!("refracted {}", percent(1.0 - share));
            ends.insert(0, (self.at(out, 180.0 - theta2), text, palette.refracted));
        }
        for (at, text, colour) in ends {
            sheet.write_near(&text, at, 6.0, colour);
        }
    }
}
