//! A thin lens from the side: the plane of focus, the sample's ray, all rays of its place, and how far they spread at the hit.

use crate::record::{Confusion, Lens, Triple};
use crate::view::sheet::{Chart, Fact, SMALL, Sheet, is_roomy, within_axes};
use crate::view::text::{brief, place};
use crate::view::{Anchor, Form, Frame, Spot, Stroke};
use glam::DVec3;

/// A lens with what its ray hit.
pub(super) struct Seen<'a> {
    pub lens: &'a Lens,
    pub confusion: Option<&'a Confusion>,
}

/// The plane through the middle of the lens, along the view and through the sample's point of the lens.
struct Cut {
    eye: DVec3,
    forward: DVec3,
    across: DVec3,
}

impl Cut {
    fn new(lens: &Lens) -> Option<Self> {
        let [eye, forward, point] = [lens.eye, lens.forward, lens.point].map(DVec3::from_array);
        // From the very middle every plane along the view is as good.
        let across = (point - eye).try_normalize().or_else(|| forward.cross(DVec3::Y).try_normalize())?;
        Some(Self { eye, forward, across })
    }

    /// How far along the view a point lies, and how far across it.
    fn at(&self, point: Triple) -> Spot {
        let from_eye = DVec3::from_array(point) - self.eye;
        [from_eye.dot(self.forward), from_eye.dot(self.across)]
    }
}

pub(super) fn draw(sheet: &mut Sheet, seen: &Seen) {
    let Seen { lens, confusion } = *seen;
    let spread = confusion.map_or_else(
        || "The ray hits nothing.".to_owned(),
        |c| {
            let (depth, pixels) = (brief(c.depth), brief(c.pixels));
            format!(
                "At the hit, {depth} away, they are spread over a circle that is {pixels} pixels wide in the picture."
            )
        },
    );
    let note =
        format!("All rays of this place meet in the plane of focus, {} away. {spread}", brief(lens.focus_distance));
    let room = sheet.caption("The lens from the side", &note);
    let mut facts = vec![
        Fact::Line(Stroke::solid(sheet.palette.ink, 4.0), "the lens".to_owned()),
        Fact::Line(Stroke::dashed(sheet.palette.normal, 1.6, [5.0, 4.0]), "plane of focus".to_owned()),
        Fact::Line(Stroke::solid(sheet.palette.camera, 2.0), "this sample's ray".to_owned()),
        Fact::Line(Stroke::solid(sheet.palette.faint, 1.0), "from the rim of the lens".to_owned()),
    ];
    facts
        .extend(confusion.map(|_| Fact::Line(Stroke::solid(sheet.palette.bad, 3.0), "circle of confusion".to_owned())));
    let (room, below) = sheet.facts(room, &facts);
    if let Some(below) = below {
        opening(sheet, lens, &below);
    }
    let frame = within_axes(room);
    if is_roomy(&frame)
        && let Some(cut) = Cut::new(lens)
    {
        side(sheet, seen, &cut, frame);
    }
}

/// The rays along the view, on axes of their own: a lens is small beside what it looks at.
fn side(sheet: &mut Sheet, Seen { lens, confusion }: &Seen, cut: &Cut, frame: Frame) {
    let ([_, start], [_, focus]) = (cut.at(lens.point), cut.at(lens.focus));
    let (radius, distance) = (lens.radius, lens.focus_distance);
    let end = confusion.map_or(1.5 * distance, |confusion| confusion.depth);
    let along = |from: f64, z: f64| from + (focus - from) * z / distance;
    let far = 1.08 * end.max(distance);
    let reach = || [0.0, end, distance].into_iter().flat_map(|z| [-radius, radius].map(|from| along(from, z)));
    let [low, high] = [reach().fold(0.0, f64::min), reach().fold(0.0, f64::max)];
    let margin = 0.08 * (high - low);
    if !(far.is_finite() && margin.is_finite() && far > 0.0 && margin > 0.0 && distance > 0.0) {
        return;
    }
    let (low, high) = (low - margin, high + margin);
    let chart = Chart::free(frame, [-0.04 * far, far], [low, high]);
    let line = |from: f64, z: f64| chart.all_at(&[[0.0, from], [z, along(from, z)]]);
    let faint = Stroke::solid(sheet.palette.faint, 1.0);
    let rays = [line(-radius, end), line(radius, end)];
    let cone = vec![rays[0][0], chart.at([distance.min(end), along(0.0, distance.min(end))]), rays[1][0]];
    if end >= distance {
        let beyond = vec![chart.at([distance, focus]), rays[0][1], rays[1][1]];
        sheet.area(&chart.frame, &[beyond], sheet.palette.faint.faded(0.12));
        sheet.area(&chart.frame, &[cone], sheet.palette.faint.faded(0.12));
    } else {
        let before = vec![rays[0][0], rays[0][1], rays[1][1], rays[1][0]];
        sheet.area(&chart.frame, &[before], sheet.palette.faint.faded(0.12));
    }
    for ray in &rays {
        sheet.line(&chart.frame, ray, faint);
    }
    if end < distance {
        let onwards = |from: f64| chart.all_at(&[[end, along(from, end)], [distance, focus]]);
        for from in [-radius, radius] {
            sheet.line(&chart.frame, &onwards(from), Stroke::dashed(sheet.palette.faint, 1.0, [3.0, 3.0]));
        }
    }
    let plane = chart.all_at(&[[distance, low], [distance, high]]);
    sheet.line(&chart.frame, &plane, Stroke::dashed(sheet.palette.normal, 1.6, [5.0, 4.0]));
    let own = line(start, end);
    sheet.line(&chart.frame, &own, Stroke::solid(sheet.palette.ground, 4.0));
    sheet.line(&chart.frame, &own, Stroke::solid(sheet.palette.camera, 2.0));
    sheet.line(&chart.frame, &chart.all_at(&[[0.0, -radius], [0.0, radius]]), Stroke::solid(sheet.palette.ink, 4.0));
    sheet.axes(&chart, ["along the view", "across it"], false);
    if confusion.is_some() {
        let circle = [rays[0][1], rays[1][1]];
        sheet.line(&chart.frame, &circle, Stroke::solid(sheet.palette.bad, 3.0));
    }
    let meeting = chart.at([distance, focus]);
    sheet.mark(&chart.frame, meeting, 4.0, sheet.palette.normal);
    sheet.mark(&chart.frame, own[0], 4.0, sheet.palette.camera);
    if confusion.is_some() {
        sheet.mark(&chart.frame, own[1], 4.5, sheet.palette.camera);
    }
    for (text, at) in [("L", own[0]), ("F", meeting)] {
        if chart.frame.contains(at) {
            sheet.write_near(text, at, 6.0, sheet.palette.ink);
        }
    }
    if confusion.is_some() && chart.frame.contains(own[1]) {
        sheet.write_near("hit", own[1], 6.0, sheet.palette.ink);
    }
}

/// The opening as it is seen from behind the camera, with the sample's point in it.
fn opening(sheet: &mut Sheet, lens: &Lens, room: &Frame) {
    /// A smaller opening would show no shape.
    const SMALLEST: f64 = 24.0;
    let [width, height] = room.size();
    let half = (0.5 * width).min(0.5 * (height - 28.0)).min(60.0) - 4.0;
    if half < SMALLEST {
        return;
    }
    let centre = [room.middle()[0], room.low[1] + 24.0 + half];
    let at = |[x, y]: Spot| [centre[0] + half * x, centre[1] - half * y];
    sheet.write("its opening", [centre[0], room.low[1] + 12.0], Anchor::Middle, SMALL, sheet.palette.faint);
    let frame = Frame { low: at([-1.05, 1.05]), high: at([1.05, -1.05]) };
    sheet.placer.reserve(frame);
    let rim = Stroke::solid(sheet.palette.grid, 1.0);
    if lens.outline.is_empty() {
        let square = Frame { low: at([-1.0, 1.0]), high: at([1.0, -1.0]) };
        sheet.drawing.put(Form::Rect { frame: square, fill: None, stroke: Some(rim) }, sheet.event);
    } else {
        let outline: Vec<Spot> = lens.outline.iter().map(|&corner| at(corner)).collect();
        sheet.area(&frame, std::slice::from_ref(&outline), sheet.palette.faint.faded(0.12));
        sheet.outline(&frame, &outline, Stroke::solid(sheet.palette.ink, 1.4));
    }
    sheet.mark(&frame, at(lens.at), 4.0, sheet.palette.camera);
    let foot = centre[1] + half + 14.0;
    if foot + 8.0 < sheet.drawing.height {
        sheet.write(&place(lens.at), [centre[0], foot], Anchor::Middle, SMALL, sheet.palette.faint);
    }
}
