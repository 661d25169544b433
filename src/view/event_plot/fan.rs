//! White light taken apart at an interface: a ray of each wavelength in its own colour, and the index of refraction that
//! bends it so.

use crate::math::portable;
use crate::optics::pure;
use crate::record::{EventId, Wavelength, What};
use crate::trace::RayTree;
use crate::view::sheet::{Chart, Fact, Sheet, bounds, is_roomy, seen_on, shown};
use crate::view::text::{brief, degrees};
use crate::view::{Colour, Form, Frame, Spot, Stroke};
use glam::DVec3;

/// Colours for which the angles are told, with wavelengths in nm that look so.
const TOLD: [(&str, f64); 3] = [("red", 650.0), ("yellow", 578.0), ("blue", 460.0)];

/// Most fans are only a degree or two wide. Their angles are drawn so much larger that they open up to this many degrees at
/// most: with more, a fan would look like another glass; with less, its rays would cover each other.
const WIDEST: f64 = 30.0;

/// All wavelengths that were sent from where `id` was.
pub(super) fn sent_together(tree: &RayTree, id: EventId) -> Vec<(EventId, &Wavelength)> {
    let parent = tree.event(id).parent;
    let end = parent.map_or(tree.end(), |parent| tree.subtree_end(parent));
    let beside = (parent.unwrap_or(id)..end).map(|id| tree.event(id)).filter(|event| event.parent == parent);
    let all = beside.filter_map(|event| match &event.what {
        What::Wavelength(wavelength) => Some((event.id, wavelength)),
        _ => None,
    });
    all.collect()
}

/// `all` are the wavelengths of one interface, of which the sheet's own event is one.
pub(super) fn draw(sheet: &mut Sheet, all: &[(EventId, &Wavelength)]) {
    let Some(&(_, own)) = all.iter().find(|(id, _)| *id == sheet.event) else { return };
    let bent = all.iter().filter(|(_, one)| one.theta2.is_some()).count();
    let kept = if bent < all.len() {
        format!(" {} of {} are reflected as a whole.", all.len() - bent, all.len())
    } else {
        String::new()
    };
    let way = own.theta2.map_or("is reflected as a whole".to_owned(), |angle| format!("goes on at {}", degrees(angle)));
    let fan = Fan::of(all);
    let stretched = match fan.times {
        1.0 => String::new(),
        times => format!(" The angles between the rays are drawn {} times as large.", brief(times)),
    };
    let note = format!(
        "Light of {} nm, n {} → {}, comes at {} and {way}.{kept}{stretched}",
        brief(own.nanometres),
        brief(own.n1),
        brief(own.n2),
        degrees(own.theta1)
    );
    let room = sheet.caption("White light taken apart", &note);
    let facts = facts(sheet, all, own);
    let (room, below) = sheet.facts(room, &facts);
    rays(sheet, all, own, &fan, &room);
    if let Some(below) = below {
        curve(sheet, all, own, below);
    }
}

/// How the angles of refraction are drawn.
struct Fan {
    /// The angle in the middle, in degrees, which is drawn as it is.
    middle: f64,
    /// How many times as large the differences from it are drawn.
    times: f64,
}

impl Fan {
    fn of(all: &[(EventId, &Wavelength)]) -> Self {
        let angles = all.iter().filter_map(|(_, one)| angle_of(one));
        let (low, high) = angles.fold((90.0_f64, 0.0_f64), |(low, high), angle| (low.min(angle), high.max(angle)));
        let middle = f64::midpoint(low, high);
        let room = WIDEST.min(2.0 * middle.min(90.0 - middle));
        let fits = |times: &f64| (high - low) * times <= room;
        let times = [50.0, 20.0, 10.0, 5.0, 2.0].into_iter().find(fits).filter(|_| high > low);
        Self { middle, times: times.unwrap_or(1.0) }
    }

    fn drawn(&self, one: &Wavelength) -> Option<f64> {
        angle_of(one).map(|angle| self.middle + self.times * (angle - self.middle))
    }
}

/// The angle of refraction in degrees, if there is one.
fn angle_of(one: &Wavelength) -> Option<f64> {
    one.theta2.filter(|angle| (0.0..=90.0).contains(angle))
}

/// The angles of the wavelengths that are nearest to the lines that are told, each once.
fn facts(sheet: &Sheet, all: &[(EventId, &Wavelength)], own: &Wavelength) -> Vec<Fact> {
    let mut facts = vec![Fact::Line(Stroke::solid(sheet.palette.ink, 2.2), format!("θ₁ = {}", degrees(own.theta1)))];
    let mut told = Vec::new();
    for (name, line) in TOLD {
        let distance = |one: &Wavelength| (one.nanometres - line).abs();
        let nearest = all.iter().filter(|(_, one)| one.nanometres.is_finite());
        let Some((id, one)) = nearest.min_by(|(_, a), (_, b)| distance(a).total_cmp(&distance(b))) else { continue };
        if told.contains(id) || distance(one) > 60.0 {
            continue;
        }
        told.push(*id);
        let angle = one.theta2.map_or("reflected".to_owned(), |angle| format!("θ₂ = {}", degrees(angle)));
        facts.push(Fact::Swatch(colour_of(sheet, one), format!("{name}, {} nm: {angle}", brief(one.nanometres))));
    }
    facts
}

/// Light of the wavelength as a screen shows it best: its hue, at full strength and clear of the ground.
fn colour_of(sheet: &Sheet, one: &Wavelength) -> Colour {
    let colour = pure(one.nanometres).max(DVec3::ZERO);
    seen_on(sheet.palette.ground, shown((colour / colour.max_element().max(1e-9)).to_array()))
}

/// The interface as a level line, with the ray from the upper left and all that goes on below.
fn rays(sheet: &mut Sheet, all: &[(EventId, &Wavelength)], own: &Wavelength, fan: &Fan, room: &Frame) {
    let [width, height] = room.size();
    let reach = 0.5 * width.min(height) - 6.0;
    if !is_roomy(room) || reach < 20.0 || !(0.0..=90.0).contains(&own.theta1) {
        return;
    }
    let foot = room.middle();
    let along = |length: f64, degrees: f64, down: f64| {
        let (sin, cos) = portable::sin_cos(degrees.to_radians());
        [foot[0] + down * length * sin, foot[1] + down * length * cos]
    };
    let (ink, faint) = (sheet.palette.ink, sheet.palette.faint);
    let beyond = Frame { low: [room.low[0], foot[1]], high: room.high };
    sheet.drawing.put(Form::Rect { frame: beyond, fill: Some(faint.faded(0.09)), stroke: None }, None);
    sheet.line(room, &[[room.low[0], foot[1]], [room.high[0], foot[1]]], Stroke::solid(faint, 1.2));
    let normal = [along(0.9 * reach, 0.0, -1.0), along(0.9 * reach, 0.0, 1.0)];
    sheet.line(room, &normal, Stroke::dashed(sheet.palette.normal, 1.2, [4.0, 3.0]));
    let own_event = sheet.event;
    // What is selected comes last, on top of its neighbours.
    let (selected, others): (Vec<_>, Vec<_>) = all.iter().partition(|(id, _)| *id == own_event);
    for (id, one) in others.into_iter().chain(selected) {
        let Some(theta2) = fan.drawn(one) else { continue };
        sheet.event = id;
        let (end, is_own) = (along(reach, theta2, 1.0), id == own_event);
        if is_own {
            sheet.line(room, &[foot, end], Stroke::solid(ink, 5.2));
        }
        sheet.line(room, &[foot, end], Stroke::solid(colour_of(sheet, one), if is_own { 3.0 } else { 1.7 }));
    }
    sheet.event = own_event;
    let start = along(reach, own.theta1, -1.0);
    sheet.line(room, &[start, foot], Stroke::solid(ink, 2.2));
    arc(sheet, foot, 0.34 * reach, [-90.0, -90.0 - own.theta1], "θ₁");
    if let Some(theta2) = fan.drawn(own) {
        arc(sheet, foot, 0.42 * reach, [90.0, 90.0 - theta2], "θ₂");
    }
    for (name, index, [x, y]) in [("n₁", own.n1, [0.62, -0.55]), ("n₂", own.n2, [-0.62, 0.55])] {
        sheet.write_near(&format!("{name} = {}", brief(index)), [foot[0] + x * reach, foot[1] + y * reach], 2.0, faint);
    }
}

/// The angle between the normal and a ray, in degrees on the screen.
fn arc(sheet: &mut Sheet, centre: Spot, radius: f64, ends: [f64; 2], name: &str) {
    let ink = sheet.palette.ink;
    let [from, to] = ends.map(f64::to_radians);
    sheet.arc(centre, radius, [from, to], Stroke::solid(ink, 1.2));
    let half = f64::midpoint(from, to);
    sheet.write_near(
        name,
        [centre[0] + radius * portable::cos(half), centre[1] + radius * portable::sin(half)],
        4.0,
        ink,
    );
}

/// The index of the medium that takes the light apart, by wavelength.
fn curve(sheet: &mut Sheet, all: &[(EventId, &Wavelength)], own: &Wavelength, room: Frame) {
    let beyond = all.iter().any(|(_, one)| one.n2 != own.n2);
    let index = |one: &Wavelength| if beyond { one.n2 } else { one.n1 };
    let frame =
        Frame { low: [room.low[0] + 40.0, room.low[1] + 26.0], high: [room.high[0] - 6.0, room.high[1] - 22.0] };
    let points: Vec<Spot> = all.iter().map(|(_, one)| [one.nanometres, index(one)]).collect();
    let Some([low, high]) = bounds(points.iter().copied()) else { return };
    let air = 0.08 * (high[1] - low[1]);
    let is_drawable = high[0] > low[0] && air > 0.0 && high.iter().chain(&low).all(|x| x.abs() < 1e9);
    if !is_roomy(&frame) || !is_drawable {
        return;
    }
    let chart = Chart::free(frame, [low[0] - 8.0, high[0] + 8.0], [low[1] - air, high[1] + air]);
    let places: Vec<Spot> = points.iter().filter(|point| point.iter().all(|x| x.is_finite())).copied().collect();
    let places = chart.all_at(&places);
    sheet.line(&frame, &places, Stroke::solid(sheet.palette.faint, 1.2));
    let own_event = sheet.event;
    for (id, one) in all {
        let place = chart.at([one.nanometres, index(one)]);
        let is_own = *id == own_event;
        if is_own {
            sheet.mark(&frame, place, 6.0, sheet.palette.ink);
        }
        sheet.event = *id;
        sheet.mark(&frame, place, if is_own { 4.6 } else { 3.4 }, colour_of(sheet, one));
        sheet.event = own_event;
    }
    sheet.axes(&chart, ["λ in nm", if beyond { "n₂ by wavelength" } else { "n₁ by wavelength" }], false);
}
