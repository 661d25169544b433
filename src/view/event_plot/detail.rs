//! The face with the polygon on it, in (u, v), and the hit.

use crate::record::Detail;
use crate::view::sheet::{Chart, Fact, Sheet, bounds, is_roomy, within_axes};
use crate::view::text::place;
use crate::view::{Frame, Spot, Stroke};

pub(super) fn draw(sheet: &mut Sheet, detail: &Detail) {
    let title = format!("A detail on {}", detail.part);
    let note =
        format!("The hit at (u, v) = {} lies inside the polygon, so the material is the detail’s.", place(detail.uv));
    let room = sheet.caption(&title, &note);
    let [inner, outer] = [sheet.palette.right, sheet.palette.left];
    let facts = [
        Fact::Swatch(inner.faded(0.55), detail.material.clone()),
        Fact::Swatch(outer.faded(0.25), detail.below.clone()),
        Fact::Dot(sheet.palette.ink, "the hit".to_owned()),
    ];
    let (room, _) = sheet.facts(room, &facts);
    let frame = within_axes(room);
    let square: [Spot; 4] = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let places = square.into_iter().chain(detail.polygon.iter().copied()).chain([detail.uv]);
    let Some([low, high]) = bounds(places).filter(|_| is_roomy(&frame)) else { return };
    let Some(chart) = fitting(frame, low, high) else { return };
    sheet.area(&chart.frame, &[chart.all_at(&square)], outer.faded(0.25));
    let polygon = chart.all_at(&detail.polygon);
    sheet.area(&chart.frame, std::slice::from_ref(&polygon), sheet.palette.ground);
    sheet.area(&chart.frame, std::slice::from_ref(&polygon), inner.faded(0.55));
    sheet.outline(&chart.frame, &polygon, Stroke::solid(inner, 2.0));
    if detail.uv.iter().all(|x| x.is_finite()) {
        sheet.mark(&chart.frame, chart.at(detail.uv), 4.5, sheet.palette.ink);
    }
    sheet.axes(&chart, ["u", "v"], false);
}

/// A chart in as much of the frame as has the proportions of what is shown, with a little air around it.
fn fitting(frame: Frame, low: Spot, high: Spot) -> Option<Chart> {
    let air = 0.04 * (high[0] - low[0]).max(high[1] - low[1]);
    let (low, high) = (low.map(|x| x - air), high.map(|x| x + air));
    let wanted: Spot = std::array::from_fn(|i| high[i] - low[i]);
    let room = frame.size();
    let scale = (room[0] / wanted[0]).min(room[1] / wanted[1]);
    let size = wanted.map(|x| x * scale);
    let left = frame.low[0] + 0.5 * (room[0] - size[0]);
    let frame = Frame { low: [left, frame.low[1]], high: [left + size[0], frame.low[1] + size[1]] };
    Chart::even(frame, low, high, false).filter(|_| is_roomy(&frame))
}
