//! The three channels of a colour spline over [−1, 1], the colours that they make, and the place that is asked for.

use crate::record::{Stop, Undulate};
use crate::view::sheet::{Chart, Fact, SMALL, Sheet, TEXT, is_roomy, shown, within_axes};
use crate::view::text::{brief, brief_vector};
use crate::view::{Anchor, Colour, Form, Frame, Spot, Stroke};

/// The height of the band of colours, and its largest share of the whole: the curves come first.
const BAND: f64 = 26.0;
const BAND_SHARE: f64 = 0.18;

pub(super) fn draw(sheet: &mut Sheet, undulate: &Undulate) {
    let note = format!("At {} the colour is {}.", brief(undulate.argument), brief_vector(undulate.colour));
    let room = sheet.caption("A colour from the spline", &note);
    let strokes = strokes(sheet);
    let mut facts: Vec<Fact> = strokes.iter().map(|(stroke, name)| Fact::Line(*stroke, (*name).to_owned())).collect();
    facts.push(Fact::Dot(sheet.palette.ink, "a stop".to_owned()));
    facts.push(Fact::Swatch(shown(undulate.colour), "the colour".to_owned()));
    let (room, _) = sheet.facts(room, &facts);
    let mut frame = within_axes(room);
    let band_height = BAND.min(BAND_SHARE * frame.size()[1]);
    frame.high[1] -= band_height + 6.0;
    let Some(range) = range(undulate).filter(|_| is_roomy(&frame)) else { return };
    let chart = Chart::free(frame, [-1.0, 1.0], range);
    segment(sheet, &chart, undulate);
    for (channel, (stroke, _)) in strokes.into_iter().enumerate() {
        let points: Vec<Spot> = undulate.curve.iter().map(|stop| chart.at([stop.at, stop.colour[channel]])).collect();
        sheet.line(&frame, &points, stroke);
        for stop in undulate.stops.iter().filter(|stop| chart.x.shows(stop.at) && chart.y.shows(stop.colour[channel])) {
            sheet.dot(chart.at([stop.at, stop.colour[channel]]), 3.2, stroke.colour);
        }
    }
    let top = frame.high[1] + 6.0;
    let band = Frame { low: [frame.low[0], top], high: [frame.high[0], top + band_height] };
    colours(sheet, &chart, &undulate.curve, &band);
    argument(sheet, &chart, undulate, &band);
    numbers(sheet, &chart, &band);
}

/// The channels' lines, told apart by dash as well as by colour.
fn strokes(sheet: &Sheet) -> [(Stroke, &'static str); 3] {
    let palette = sheet.palette;
    [
        (Stroke::solid(palette.bad, 2.0), "red"),
        (Stroke::dashed(palette.good, 2.0, [7.0, 4.0]), "green"),
        (Stroke::dashed(palette.camera, 2.0, [2.0, 3.5]), "blue"),
    ]
}

/// From 0 to 1, and as far beyond as the spline swings.
fn range(undulate: &Undulate) -> Option<[f64; 2]> {
    let channels = undulate.curve.iter().chain(&undulate.stops).flat_map(|stop| stop.colour);
    let finite = channels.filter(|value| value.is_finite() && value.abs() < 1e9);
    let (low, high) = finite.fold((0.0_f64, 1.0_f64), |(low, high), value| (low.min(value), high.max(value)));
    let air = 0.06 * (high - low);
    (!undulate.curve.is_empty()).then_some([low - air, high + air])
}

/// The stretch between the two stops that the argument lies between.
fn segment(sheet: &mut Sheet, chart: &Chart, undulate: &Undulate) {
    let ends = [undulate.stops.get(undulate.segment), undulate.stops.get(undulate.segment.saturating_add(1))];
    if let [Some(from), Some(to)] = ends {
        let [low, high] = chart.y.values;
        let ring = [[from.at, low], [to.at, low], [to.at, high], [from.at, high]];
        sheet.area(&chart.frame, &[chart.all_at(&ring)], sheet.palette.highlight.faded(0.13));
    }
}

/// The spline's colours, each half-way to its neighbours.
fn colours(sheet: &mut Sheet, chart: &Chart, curve: &[Stop], band: &Frame) {
    let place = |at: f64| chart.x.at(at).max(band.low[0]).min(band.high[0]);
    for (number, stop) in curve.iter().enumerate() {
        let next = curve.get(number + 1).map_or(band.high[0], |next| place(f64::midpoint(stop.at, next.at)));
        let before =
            number.checked_sub(1).map_or(band.low[0], |before| place(f64::midpoint(curve[before].at, stop.at)));
        if next > before {
            // A point into the next one, or the ground would shine through between the two.
            let frame = Frame { low: [before, band.low[1]], high: [(next + 1.0).min(band.high[0]), band.high[1]] };
            sheet.drawing.put(Form::Rect { frame, fill: Some(shown(stop.colour)), stroke: None }, sheet.event);
        }
    }
    let rim = Stroke::solid(sheet.palette.faint, 1.0);
    sheet.drawing.put(Form::Rect { frame: *band, fill: None, stroke: Some(rim) }, None);
}

/// The place that is asked for, through curves and colours.
fn argument(sheet: &mut Sheet, chart: &Chart, undulate: &Undulate, band: &Frame) {
    if !chart.x.shows(undulate.argument) {
        return;
    }
    let x = chart.x.at(undulate.argument);
    let line = vec![[x, chart.frame.low[1]], [x, band.high[1]]];
    let whole = Frame { low: chart.frame.low, high: band.high };
    let halo: Colour = sheet.palette.ground;
    sheet.line(&whole, &line, Stroke::solid(halo, 3.6));
    sheet.line(&whole, &line, Stroke::solid(sheet.palette.ink, 1.6));
    sheet.placer.avoid_line(line[0], line[1]);
    let text = format!("asked for: {}", brief(undulate.argument));
    let above = chart.frame.low[1] - 9.0;
    for (at, anchor) in [(x, Anchor::Middle), (chart.frame.low[0], Anchor::Start), (chart.frame.high[0], Anchor::End)] {
        if sheet.write(&text, [at, above], anchor, TEXT, sheet.palette.ink) {
            return;
        }
    }
}

/// Numbers below the band and at the left.
fn numbers(sheet: &mut Sheet, chart: &Chart, band: &Frame) {
    let faint = sheet.palette.faint;
    let rim = Stroke::solid(faint, 1.0);
    sheet.drawing.put(Form::Rect { frame: chart.frame, fill: None, stroke: Some(rim) }, None);
    let [left, right] = chart.x.points;
    for tick in chart.x.ticks((right - left) / 70.0) {
        sheet.write(&brief(tick), [chart.x.at(tick), band.high[1] + 10.0], Anchor::Middle, SMALL, faint);
    }
    for tick in chart.y.ticks(chart.frame.size()[1] / 34.0) {
        sheet.write(&brief(tick), [left - 7.0, chart.y.at(tick)], Anchor::End, SMALL, faint);
    }
}
