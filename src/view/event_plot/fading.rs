//! A ray's stretch in a medium: what is left of each colour along it, and the points at which light is turned.

use crate::math::portable;
use crate::record::Segment;
use crate::view::sheet::{Chart, Fact, Sheet, is_roomy, within_axes};
use crate::view::text::{brief, brief_vector};
use crate::view::{Spot, Stroke};

/// Steps of a curve: a bend of an exponential is never sharper than these show.
const STEPS: u32 = 96;

pub(super) fn draw(sheet: &mut Sheet, segment: &Segment, turned_at: &[f64]) {
    let whole = segment.length.is_finite();
    let note = if whole {
        format!("After a length of {}, {} is left.", brief(segment.length), brief_vector(segment.transmittance))
    } else {
        "The ray does not leave the medium: only colours that are not taken away arrive.".to_owned()
    };
    let room = sheet.caption(&format!("Light on its way through {}", segment.medium), &note);
    let rates: [f64; 3] = std::array::from_fn(|colour| segment.absorption[colour] + segment.scattering[colour]);
    let strokes = strokes(sheet, rates == [rates[0]; 3]);
    let mut facts: Vec<Fact> = strokes.iter().map(|(stroke, name)| Fact::Line(*stroke, (*name).to_owned())).collect();
    if !turned_at.is_empty() {
        facts.push(Fact::Line(Stroke::solid(sheet.palette.scattered, 1.6), "turned here".to_owned()));
    }
    let (room, _) = sheet.facts(room, &facts);
    let frame = within_axes(room);
    let Some(length) = shown_length(segment, rates).filter(|_| is_roomy(&frame)) else { return };
    let chart = Chart::free(frame, [0.0, length], [0.0, 1.04]);
    for (rate, (stroke, _)) in rates.into_iter().zip(strokes) {
        let at = |step: u32| length * f64::from(step) / f64::from(STEPS);
        let points: Vec<Spot> = (0..=STEPS).map(|step| chart.at([at(step), portable::exp(-rate * at(step))])).collect();
        sheet.line(&chart.frame, &points, stroke);
        if whole {
            sheet.mark(&chart.frame, chart.at([length, portable::exp(-rate * length)]), 3.4, stroke.colour);
        }
    }
    for at in turned_at.iter().filter(|at| chart.x.shows(**at)) {
        let line = [chart.at([*at, 0.0]), chart.at([*at, 1.0])];
        sheet.line(&chart.frame, &line, Stroke::solid(sheet.palette.scattered, 1.6));
        sheet.placer.avoid_line(line[0], line[1]);
        let name = format!("turned after {}", brief(*at));
        sheet.write_near(&name, chart.at([*at, 0.5]), 7.0, sheet.palette.scattered);
    }
    sheet.axes(&chart, ["way in the medium", "share that is left"], false);
}

/// The channels' lines, told apart by dash as well as by colour; one line where all channels are alike.
fn strokes(sheet: &Sheet, are_alike: bool) -> Vec<(Stroke, &'static str)> {
    let palette = sheet.palette;
    if are_alike {
        return vec![(Stroke::solid(palette.ink, 2.0), "every colour")];
    }
    vec![
        (Stroke::solid(palette.bad, 2.0), "red"),
        (Stroke::dashed(palette.good, 2.0, [7.0, 4.0]), "green"),
        (Stroke::dashed(palette.camera, 2.0, [2.0, 3.5]), "blue"),
    ]
}

/// How much of the way is drawn: all of it, or of one without end as much as leaves e⁻⁵ of the colour that fades least.
fn shown_length(segment: &Segment, rates: [f64; 3]) -> Option<f64> {
    let slowest = rates.into_iter().filter(|rate| *rate > 0.0).fold(f64::INFINITY, f64::min);
    let length = if segment.length.is_finite() { segment.length } else { 5.0 / slowest };
    let is_sound = rates.iter().all(|rate| (0.0..1e150).contains(rate)) && (1e-150..1e150).contains(&length);
    is_sound.then_some(length)
}
