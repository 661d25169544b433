//! The phase function at a point where light is turned: its lobe as a polar curve about the ray, with the ways to the lights.

use crate::math::portable;
use crate::record::Phase;
use crate::view::sheet::{Chart, Fact, Sheet, is_roomy};
use crate::view::text::brief;
use crate::view::{Colour, Spot, Stroke};
use std::f64::consts::{PI, TAU};

/// Steps of the curve round the point.
const STEPS: u32 = 180;

pub(super) fn draw(sheet: &mut Sheet, phases: &[&Phase]) {
    let anisotropy = phases.first().map_or(0.0, |phase| phase.anisotropy);
    let habit = if anisotropy > 0.0 {
        "mostly on"
    } else if anisotropy < 0.0 {
        "mostly back"
    } else {
        "every way alike"
    };
    let note = format!(
        "g = {}: light is turned {habit}. Angles are those to the ray; its way on is to the right.",
        brief(anisotropy)
    );
    let room = sheet.caption("By how much light is turned", &note);
    let [lobe, way, on] = [sheet.palette.scattered, sheet.palette.shadow, sheet.palette.camera];
    let facts = [
        Fact::Line(Stroke::solid(lobe, 2.0), "phase function".to_owned()),
        Fact::Line(Stroke::solid(way, 1.8), "towards a light".to_owned()),
        Fact::Line(Stroke::dashed(lobe, 1.8, [7.0, 4.0]), "the path goes on".to_owned()),
        Fact::Line(Stroke::solid(on, 1.8), "the ray".to_owned()),
    ];
    let (frame, _) = sheet.facts(room, &facts);
    let curve = curve(anisotropy);
    let reach = curve.iter().map(|[x, y]| portable::hypot(*x, *y)).fold(0.0, f64::max);
    if !is_roomy(&frame) || !(1e-150..1e150).contains(&reach) {
        return;
    }
    let (low, high) = bounds(&curve, reach);
    let Some(chart) = Chart::even(frame, low, high, false) else { return };
    let ring = chart.all_at(&curve);
    sheet.area(&chart.frame, std::slice::from_ref(&ring), lobe.faded(0.16));
    sheet.outline(&chart.frame, &ring, Stroke::solid(lobe, 2.0));
    let centre = chart.at([0.0, 0.0]);
    let arm = 0.5 * frame.size()[0].min(frame.size()[1]) / chart.scale();
    ray(sheet, &chart, arm, on);
    for (number, phase) in phases.iter().enumerate() {
        // Only the angle to the ray counts; lights are drawn above and below by turns.
        let side = if number % 2 == 0 { 1.0 } else { -1.0 };
        let (cosine, is_path) = (phase.cosine.clamp(-1.0, 1.0), phase.towards == "on");
        let sine = side * (1.0 - cosine * cosine).max(0.0).sqrt();
        let tip = chart.at([0.8 * arm * cosine, 0.8 * arm * sine]);
        if !tip.iter().all(|x| x.is_finite()) {
            continue;
        }
        let stroke = if is_path { Stroke::dashed(lobe, 1.8, [7.0, 4.0]) } else { Stroke::solid(way, 1.8) };
        sheet.line(&chart.frame, &[centre, tip], stroke);
        sheet.placer.avoid_line(centre, tip);
        let name = if is_path { "on" } else { phase.towards.as_str() };
        let text = format!("{name}: p = {}", brief(phase.value));
        if chart.frame.contains(tip) {
            sheet.write_near(&text, tip, 8.0, if is_path { lobe } else { way });
        }
    }
    sheet.mark(&chart.frame, centre, 4.0, sheet.palette.ink);
}

/// The ray, which comes from the left.
fn ray(sheet: &mut Sheet, chart: &Chart, arm: f64, colour: Colour) {
    let [from, centre] = [chart.at([-0.95 * arm, 0.0]), chart.at([0.0, 0.0])];
    sheet.arrow(from, centre, colour, 1.8);
    let ahead = [centre, chart.at([0.95 * arm, 0.0])];
    sheet.line(&chart.frame, &ahead, Stroke::dashed(sheet.palette.faint, 1.0, [2.0, 4.0]));
}

/// p(cosθ) at every angle about the ray.
fn curve(g: f64) -> Vec<Spot> {
    let place = |step: u32| {
        let (sine, cosine) = portable::sin_cos(TAU * f64::from(step) / f64::from(STEPS));
        let squared = 1.0 + g * g - 2.0 * g * cosine;
        let value = (1.0 - g * g) / (4.0 * PI * squared * squared.sqrt());
        [value * cosine, value * sine]
    };
    (0..STEPS).map(place).collect()
}

/// The lobe and the point, with some room about them.
fn bounds(curve: &[Spot], reach: f64) -> (Spot, Spot) {
    let air = 0.18 * reach;
    let end = |axis: usize, sign: f64| {
        sign * curve.iter().map(|spot| sign * spot[axis]).fold(0.35 * reach, f64::max) + sign * air
    };
    ([end(0, -1.0), end(1, -1.0)], [end(0, 1.0), end(1, 1.0)])
}
