//! A bump: the tangent plane seen from above with what tilts the normal, and a cut through both normals.

use crate::math::portable;
use crate::record::{Bump, Triple};
use crate::view::drawing::length;
use crate::view::sheet::{Fact, SMALL, Sheet, is_roomy};
use crate::view::text::{angle_between, brief, place};
use crate::view::{Anchor, Form, Frame, Spot, Stroke};
use glam::DVec3;

pub(super) fn draw(sheet: &mut Sheet, bump: &Bump) {
    let angle = angle_between(bump.before, bump.after);
    let note = format!(
        "The slopes (b_u, b_v) = {} turn the normal by {}°: N′ = N + b_v (P_u × n) + b_u (n × P_v).",
        place(bump.slopes),
        brief(angle)
    );
    let room = sheet.caption("The normal before and after the bump", &note);
    let facts = [
        Fact::Line(Stroke::solid(sheet.palette.faint, 1.6), "P_u and P_v".to_owned()),
        Fact::Line(Stroke::solid(sheet.palette.right, 2.0), "b_v (P_u × n)".to_owned()),
        Fact::Line(Stroke::solid(sheet.palette.left, 2.0), "b_u (n × P_v)".to_owned()),
        Fact::Line(Stroke::solid(sheet.palette.bad, 2.4), "their sum".to_owned()),
        Fact::Line(Stroke::solid(sheet.palette.normal, 2.4), "N′, after".to_owned()),
        Fact::Line(Stroke::dashed(sheet.palette.normal, 1.4, [4.0, 3.0]), "N, before".to_owned()),
        Fact::Line(Stroke::dashed(sheet.palette.bad, 1.4, [5.0, 4.0]), "as if tilted so".to_owned()),
    ];
    let (room, _) = sheet.facts(room, &facts);
    let ([width, height], middle) = (room.size(), room.middle());
    // Beside each other, or one below the other where there is more room that way.
    let (end, start) = if height > width {
        ([room.high[0], middle[1] - 6.0], [room.low[0], middle[1] + 6.0])
    } else {
        ([middle[0] - 6.0, room.high[1]], [middle[0] + 6.0, room.low[1]])
    };
    let (above, cut) = (Frame { low: room.low, high: end }, Frame { low: start, high: room.high });
    if is_roomy(&above) {
        heading(sheet, &above, "from above");
        from_above(sheet, bump, &above);
        heading(sheet, &cut, "cut through N and N′");
        side(sheet, angle, &cut);
    }
}

fn heading(sheet: &mut Sheet, room: &Frame, text: &str) {
    sheet.write(text, [room.middle()[0], room.low[1] + 4.0], Anchor::Middle, SMALL, sheet.palette.faint);
}

/// P_u, P_v and the terms in the tangent plane, P_u to the right, the normal towards the reader.
fn from_above(sheet: &mut Sheet, bump: &Bump, room: &Frame) {
    let [p_u, p_v, n] = [bump.p_u, bump.p_v, bump.before].map(DVec3::from_array);
    let Some(across) = p_u.reject_from(n).try_normalize() else { return };
    let up = n.cross(across);
    let flat = |v: DVec3| [v.dot(across), v.dot(up)];
    let scaled = |v: Triple, by: f64| flat(DVec3::from_array(v) * by);
    let [b_u, b_v] = bump.slopes;
    let terms = [scaled(bump.p_u_cross_n, b_v), scaled(bump.n_cross_p_v, b_u)];
    let sum = [terms[0][0] + terms[1][0], terms[0][1] + terms[1][1]];
    let half = 0.5 * room.size()[0].min(room.size()[1] - 16.0) - 14.0;
    let centre = [room.middle()[0], room.middle()[1] + 8.0];
    if half < 20.0 {
        return;
    }
    disc(sheet, centre, half);
    // Directions and terms have units of their own, so each pair has a scale of its own.
    let view = |vectors: &[Spot], reach: f64| {
        let longest = vectors.iter().map(|&v| length(v)).fold(0.0, f64::max);
        let scale = if longest > 0.0 && longest.is_finite() { reach / longest } else { 0.0 };
        move |v: Spot| [centre[0] + scale * v[0], centre[1] - scale * v[1]]
    };
    let directions = [flat(p_u), flat(p_v)];
    let place = view(&directions, half - 4.0);
    for (vector, name) in directions.into_iter().zip(["P_u", "P_v"]) {
        if sheet.arrow(centre, place(vector), sheet.palette.faint, 1.6) {
            sheet.write_near(name, place(vector), 4.0, sheet.palette.faint);
        }
    }
    let place = view(&[terms[0], terms[1], sum], half - 8.0);
    sheet.arrow(centre, place(terms[0]), sheet.palette.right, 2.0);
    sheet.arrow(centre, place(terms[1]), sheet.palette.left, 2.0);
    // The other two sides of the parallelogram whose diagonal is the sum.
    let dashes = Stroke::dashed(sheet.palette.faint, 1.0, [3.0, 3.0]);
    for term in terms {
        sheet.line(room, &[place(term), place(sum)], dashes);
    }
    sheet.arrow(centre, place(sum), sheet.palette.bad, 2.4);
    sheet.dot(centre, 3.5, sheet.palette.ink);
}

/// The tangent plane.
fn disc(sheet: &mut Sheet, centre: Spot, radius: f64) {
    let fill = Some(sheet.palette.faint.faded(0.1));
    let stroke = Some(Stroke::solid(sheet.palette.grid, 1.0));
    sheet.drawing.put(Form::Circle { centre, radius, fill, stroke }, sheet.event);
}

/// The surface as a level line with N upwards, and the tilted one that the turned normal pretends.
fn side(sheet: &mut Sheet, angle: f64, room: &Frame) {
    let [width, height] = room.size();
    let reach = (0.5 * width - 14.0).min(0.5 * height);
    let foot = [room.middle()[0], room.middle()[1] + 8.0 + 0.4 * reach];
    if reach < 24.0 || !angle.is_finite() {
        return;
    }
    let (sin, cos) = portable::sin_cos(angle.to_radians());
    let along = |by: f64, [x, y]: Spot| [foot[0] + by * x, foot[1] - by * y];
    let half = 0.8 * reach;
    let ink = sheet.palette.ink;
    sheet.line(room, &[along(-half, [1.0, 0.0]), along(half, [1.0, 0.0])], Stroke::solid(ink, 1.6));
    let tilted = [along(-0.9 * half, [cos, -sin]), along(0.9 * half, [cos, -sin])];
    sheet.line(room, &tilted, Stroke::dashed(sheet.palette.bad, 1.4, [5.0, 4.0]));
    let before = along(0.96 * reach, [0.0, 1.0]);
    sheet.line(room, &[foot, before], Stroke::dashed(sheet.palette.normal, 1.4, [4.0, 3.0]));
    sheet.placer.avoid_line(foot, before);
    let after = along(reach, [sin, cos]);
    sheet.arrow(foot, after, sheet.palette.normal, 2.4);
    let level = -std::f64::consts::FRAC_PI_2;
    sheet.arc(foot, 0.45 * reach, [level, level + angle.to_radians()], Stroke::solid(ink, 1.2));
    let half_way = 0.5 * angle.to_radians();
    let label = along(0.45 * reach, [portable::sin(half_way), portable::cos(half_way)]);
    sheet.write_near(&format!("{}°", brief(angle)), label, 5.0, ink);
    sheet.write_near("N", before, 5.0, sheet.palette.normal);
    sheet.write_near("N′", after, 5.0, sheet.palette.normal);
}
