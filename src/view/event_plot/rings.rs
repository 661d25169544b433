//! The log cut across: light and dark rings, and the point in one of them.

use crate::math::portable;
use crate::record::{Rings, Triple};
use crate::view::sheet::{Chart, Fact, Sheet, is_roomy, rim, within_axes};
use crate::view::text::brief;
use crate::view::{Colour, Spot, Stroke};

/// Logs with at most so many rings up to the point are drawn whole; with more, each ring would become a hairline.
const WHOLE: f64 = 8.0;

/// Dark and light wood, on paper of any colour.
const WOOD: [Colour; 2] = [Colour::hex(0xa8_6c_30), Colour::hex(0xe8_c9_98)];

pub(super) fn draw(sheet: &mut Sheet, rings: &Rings, point: Option<Triple>) {
    let shade = if rings.dark { "dark" } else { "light" };
    let past =
        if rings.stirred < 0.0 { " Stirring took it past the axis, where the plain log has no ring." } else { "" };
    let (towards, is_own) = direction(rings.radius, point);
    let turned = if is_own { "" } else { " It is drawn at an angle about the axis that is not its own." };
    let note = format!(
        "At the distance {} from the axis the point lies at {} rings, in ring {}, which is {shade}.{past}{turned}",
        brief(rings.radius),
        brief(rings.stirred),
        brief(rings.ring)
    );
    let room = sheet.caption("The log, cut across its axis", &note);
    let [dark, light] = WOOD;
    let facts = [
        Fact::Swatch(dark, "odd rings: dark".to_owned()),
        Fact::Swatch(light, "even rings: light".to_owned()),
        Fact::Line(Stroke::solid(sheet.palette.ink, 1.6), "distance, in rings".to_owned()),
    ];
    let (room, _) = sheet.facts(room, &facts);
    let frame = within_axes(room);
    let distance = rings.stirred;
    if !is_roomy(&frame) || !(0.0..1e12).contains(&distance) {
        return;
    }
    let at = towards.map(|x| x * distance);
    let (low, high) = if distance <= WHOLE {
        let reach = distance.floor() + 1.6;
        ([-reach; 2], [reach; 2])
    } else {
        (at.map(|x| x - 0.5 * WHOLE), at.map(|x| x + 0.5 * WHOLE))
    };
    let Some(chart) = Chart::even(frame, low, high, false) else { return };
    sheet.area(&chart.frame, &[rim(&chart.frame)], light);
    for ring in odd_rings(&chart) {
        band(sheet, &chart, ring, towards, dark);
    }
    radius(sheet, &chart, at);
    sheet.axes(&chart, ["", "rings from the axis"], false);
}

/// Where the point lies about the axis, and whether it does: as its texture says, if the log's axis is z; else at a place
/// that reads well, for the event does not tell where the axis is.
fn direction(radius: f64, point: Option<Triple>) -> (Spot, bool) {
    match point {
        Some([x, y, _]) if radius > 0.0 && (portable::hypot(x, y) - radius).abs() < 1e-9 * radius => {
            ([x / radius, y / radius], true)
        }
        _ => ([0.8, 0.6], false),
    }
}

/// The dark rings that are seen; the chart is at most some dozens of rings wide.
fn odd_rings(chart: &Chart) -> impl Iterator<Item = f64> + use<> {
    let ([left, right], [bottom, top]) = (chart.x.values, chart.y.values);
    let nearest = portable::hypot(0.0_f64.max(left).min(right), 0.0_f64.max(bottom).min(top));
    let farthest = portable::hypot(left.abs().max(right.abs()), bottom.abs().max(top.abs()));
    let first = 2.0 * ((nearest - 1.0) / 2.0).floor().max(0.0) + 1.0;
    (0..400).map(move |i| first + 2.0 * f64::from(i)).take_while(move |ring| *ring < farthest)
}

/// One ring, or the part of it near the chart where it is much larger.
fn band(sheet: &mut Sheet, chart: &Chart, ring: f64, towards: Spot, fill: Colour) {
    /// Of a chord's distance from its arc in points: more would be seen as corners.
    const COARSEST: f64 = 0.15;
    let [width, height] = chart.frame.size();
    let outer = ring + 1.0;
    let radius = outer * chart.scale();
    let half = (1.5 * portable::hypot(width, height) / (ring * chart.scale())).min(std::f64::consts::PI);
    let step = (8.0 * COARSEST / radius).sqrt();
    let steps = (2.0 * half / step).ceil().clamp(12.0, 2_000.0);
    let middle = portable::atan2(towards[1], towards[0]);
    let place = |r: f64, i: i32| {
        let angle = middle - half + 2.0 * half * f64::from(i) / steps;
        chart.at([r * portable::cos(angle), r * portable::sin(angle)])
    };
    #[expect(clippy::cast_possible_truncation, reason = "at most 2000")]
    let last = steps as i32;
    let arc = |r: f64| (0..=last).map(move |i| place(r, i));
    let rings = if half < std::f64::consts::PI {
        vec![arc(outer).chain((0..=last).rev().map(|i| place(ring, i))).collect()]
    } else {
        vec![arc(outer).collect(), arc(ring).collect()]
    };
    sheet.area(&chart.frame, &rings, fill);
}

/// From the axis to the point.
fn radius(sheet: &mut Sheet, chart: &Chart, at: Spot) {
    let [axis, point] = [chart.at([0.0, 0.0]), chart.at(at)];
    let ink = sheet.palette.ink;
    sheet.line(&chart.frame, &[axis, point], Stroke::solid(sheet.palette.ground, 3.6));
    sheet.line(&chart.frame, &[axis, point], Stroke::solid(ink, 1.6));
    for (place, name, size) in [(axis, "axis", 3.0), (point, "the point", 4.5)] {
        sheet.mark(&chart.frame, place, size, ink);
        if chart.frame.contains(place) {
            sheet.placer.avoid_line(axis, point);
            sheet.write_near(name, place, 7.0, ink);
        }
    }
}
