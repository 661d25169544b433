//! Fresnel's reflectance at every angle of incidence, with this ray's.

use super::Interface;
use crate::math::portable;
use crate::optics::refract;
use crate::view::drawing::{Frame, Spot, Stroke};
use crate::view::sheet::{Chart, Sheet, is_roomy, within_axes};
use crate::view::text::{brief, degrees};
use glam::DVec3;

/// Steps of a curve; its steepest part begins at the critical angle, which is a point of its own.
const STEPS: u32 = 180;

pub(super) fn draw(sheet: &mut Sheet, room: Frame, interface: &Interface) {
    let frame = within_axes(room);
    if !is_roomy(&frame) {
        return;
    }
    let chart = Chart::free(frame, [0.0, 90.0], [0.0, 1.0]);
    let palette = sheet.palette;
    let here = chart.at([interface.theta1, interface.reflectance]);
    sheet.axes(&chart, ["θ₁ in degrees", "reflected share R"], false);
    let curves = [
        (1, Stroke::dashed(palette.left, 1.4, [6.0, 3.0]), "Rₛ", 0.72),
        (2, Stroke::dashed(palette.right, 1.4, [2.0, 3.0]), "Rₚ", 0.8),
        (0, Stroke::solid(palette.ink, 2.2), "R", 0.9),
    ];
    let samples = samples(interface);
    for (which, stroke, _, _) in &curves {
        let points: Vec<Spot> = samples.iter().map(|(angle, shares)| chart.at([*angle, shares[*which]])).collect();
        for ends in points.windows(2) {
            sheet.placer.avoid_line(ends[0], ends[1]);
        }
        sheet.line(&chart.frame, &points, *stroke);
    }
    keep_within(sheet, &chart.frame);
    critical_line(sheet, &chart, interface);
    let foot = chart.at([interface.theta1, 0.0]);
    sheet.line(&chart.frame, &[foot, here], Stroke::dashed(palette.highlight, 1.4, [3.0, 3.0]));
    sheet.mark(&chart.frame.grown(1.0), here, 5.0, palette.reflected);
    let text = format!("R = {} at {}", brief(interface.reflectance), degrees(interface.theta1));
    let shorter = format!("R = {}", brief(interface.reflectance));
    sheet.write_one_near(&[&text, &shorter], here, 8.0, palette.reflected);
    for (which, stroke, name, share) in curves {
        // Each name stands where its curve is between the ground and total reflection.
        let end = interface.critical.unwrap_or(90.0);
        let angle = end * share;
        let at = chart.at([angle, shares(interface, angle)[which]]);
        sheet.write_near(name, at, 5.0, stroke.colour);
    }
    let brewster = interface.brewster();
    let place = chart.at([brewster, 0.0]);
    sheet.mark(&chart.frame.grown(1.0), place, 3.0, palette.right);
    sheet.write_near(&format!("Brewster {}", degrees(brewster)), place, 6.0, palette.right);
}

/// Keeps names off the rim of the chart and off the numbers about it.
fn keep_within(sheet: &mut Sheet, frame: &Frame) {
    let ([left, top], [right, bottom]) = (frame.low, frame.high);
    let around = frame.grown(60.0);
    for (low, high) in [
        (around.low, [left + 1.0, around.high[1]]),
        ([right - 1.0, around.low[1]], around.high),
        (around.low, [around.high[0], top + 1.0]),
        ([around.low[0], bottom - 1.0], around.high),
    ] {
        sheet.placer.reserve(Frame { low, high });
    }
}

fn critical_line(sheet: &mut Sheet, chart: &Chart, interface: &Interface) {
    let Some(critical) = interface.critical.filter(|angle| *angle < 90.0) else { return };
    let ends = [chart.at([critical, 0.0]), chart.at([critical, 1.0])];
    let colour = sheet.palette.bad;
    sheet.line(&chart.frame, &ends, Stroke::dashed(colour, 1.4, [3.0, 3.0]));
    sheet.placer.avoid_line(ends[0], ends[1]);
    sheet.write_near(&format!("critical {}", degrees(critical)), chart.at([critical, 0.5]), 6.0, colour);
}

/// R, Rₛ and Rₚ at an angle of incidence in degrees.
pub(super) fn shares(interface: &Interface, angle: f64) -> [f64; 3] {
    let (sin, cos) = portable::sin_cos(angle.to_radians());
    let [n1, n2] = interface.indices;
    let optics = refract(DVec3::new(sin, 0.0, -cos), DVec3::Z, n1, n2);
    let [r_s, r_p] = optics.fresnel();
    [optics.reflectance(), r_s, r_p]
}

/// Evenly over all angles, and closer towards the critical angle, where the curves go up like a root.
fn samples(interface: &Interface) -> Vec<(f64, [f64; 3])> {
    let even = (0..=STEPS).map(|step| 90.0 * f64::from(step) / f64::from(STEPS));
    let near = interface.critical.into_iter().flat_map(|critical| {
        (0..=24).map(move |step| critical - f64::from(step * step) / 576.0 * 2.0_f64.min(critical))
    });
    let mut angles: Vec<f64> = even.chain(near).collect();
    angles.sort_by(f64::total_cmp);
    angles.into_iter().map(|angle| (angle, shares(interface, angle))).collect()
}
