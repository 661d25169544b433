//! The environment's map with the place that the direction points at, and what the pixel covers of it, enlarged.

use super::picture;
use crate::record::Environment;
use crate::texture::image::Texels;
use crate::view::sheet::{Chart, Fact, SMALL, Sheet, bounds, is_roomy, rim, shown};
use crate::view::text::{brief, brief_vector, solid_angle};
use crate::view::{Anchor, Form, Frame, Spot, Stroke};

/// `image` is that of the environment, where it is at hand.
pub(super) fn draw(sheet: &mut Sheet, environment: &Environment, image: Option<&Texels>) {
    let image = image.filter(|image| image.size() == environment.size);
    let covers = match environment.footprint.as_slice() {
        [] => String::new(),
        _ => format!(" The pixel covers {}.", solid_angle(environment.solid_angle)),
    };
    let [column, row] = environment.at.map(|at| brief(at.floor()));
    let direction = brief_vector(environment.direction);
    let note = format!("The direction {direction} points at texel ({column}, {row}).{covers}");
    let room = sheet.caption("The environment", &note);
    let (mut room, below) = sheet.facts(room, &facts(sheet, environment));
    if let Some(below) = below.filter(|_| !environment.footprint.is_empty()) {
        compare(sheet, environment, below);
    }
    let heading = format!("the map, {} × {} texels", environment.size[0], environment.size[1]);
    sheet.write(&heading, [room.low[0], room.low[1] + 4.0], Anchor::Start, SMALL, sheet.palette.faint);
    room.low[1] += 14.0;
    let [columns, rows] = environment.size.map(|texels| f64::from(texels.max(1)));
    let known = environment.at.iter().all(|x| x.is_finite());
    let corners = bounds(environment.footprint.iter().copied());
    let both = corners.is_some() && room.size()[1] > 170.0;
    let upper = if both { room.low[1] + 0.5 * room.size()[1] - 8.0 } else { room.high[1] };
    let Some(map) = whole_map(Frame { low: room.low, high: [room.high[0], upper] }, columns, rows) else { return };
    sheet.area(&map.frame, &[rim(&map.frame)], sheet.palette.panel);
    if let Some(image) = image {
        picture::draw(sheet, &map, image);
    }
    creases(sheet, &map, environment);
    let outline = map.all_at(&environment.footprint);
    sheet.area(&map.frame, std::slice::from_ref(&outline), sheet.palette.bad.faded(0.35));
    sheet.outline(&map.frame, &outline, Stroke::solid(sheet.palette.ground, 2.6));
    sheet.outline(&map.frame, &outline, Stroke::solid(sheet.palette.bad, 1.2));
    let stroke = Stroke::solid(sheet.palette.faint, 1.2);
    sheet.drawing.put(Form::Rect { frame: map.frame, fill: None, stroke: Some(stroke) }, sheet.event);
    if known {
        sheet.mark(&map.frame, map.at(environment.at), 3.5, sheet.palette.ink);
    }
    if let Some([low, high]) = corners.filter(|_| both && known) {
        let below = Frame { low: [room.low[0], upper + 24.0], high: room.high };
        inset(sheet, environment, below, [low, high], (&map, image));
    }
}

fn facts(sheet: &Sheet, environment: &Environment) -> Vec<Fact> {
    let mut facts = vec![Fact::Swatch(shown(environment.nearest), "the nearest texel".to_owned())];
    if environment.footprint.is_empty() {
        facts.push(Fact::words("nothing is averaged"));
    } else {
        facts.push(Fact::Swatch(shown(environment.colour), "the average".to_owned()));
        facts.push(Fact::Line(Stroke::solid(sheet.palette.bad, 2.0), "the pixel".to_owned()));
    }
    facts.push(Fact::Dot(sheet.palette.ink, "the direction".to_owned()));
    facts
}

/// Both colours side by side, where they are told apart more easily than in two samples.
fn compare(sheet: &mut Sheet, environment: &Environment, room: Frame) {
    let [width, height] = room.size();
    if height < 60.0 {
        return;
    }
    let side = 0.5 * width;
    let top = room.low[1] + 6.0;
    let half = |left: f64| Frame { low: [left, top], high: [left + side, top + side.min(height - 30.0)] };
    let frames = [half(room.low[0]), half(room.low[0] + side)];
    let colours = [environment.nearest, environment.colour].map(shown);
    for ((frame, colour), name) in frames.into_iter().zip(colours).zip(["nearest", "average"]) {
        sheet.drawing.put(Form::Rect { frame, fill: Some(colour), stroke: None }, sheet.event);
        let at = [frame.middle()[0], frame.high[1] + 9.0];
        sheet.write(name, at, Anchor::Middle, SMALL, sheet.palette.faint);
    }
    let stroke = Some(Stroke::solid(sheet.palette.faint, 0.8));
    let frame = Frame { low: frames[0].low, high: frames[1].high };
    sheet.drawing.put(Form::Rect { frame, fill: None, stroke }, None);
}

/// The whole image in as much of the frame as has its proportions.
fn whole_map(room: Frame, columns: f64, rows: f64) -> Option<Chart> {
    let [width, height] = room.size();
    let scale = (width / columns).min(height / rows);
    let size = [columns * scale, rows * scale];
    let left = room.low[0];
    let frame = Frame { low: [left, room.low[1]], high: [left + size[0], room.low[1] + size[1]] };
    Chart::even(frame, [0.0; 2], [columns, rows], true).filter(|_| is_roomy(&room))
}

/// Lines of equal longitude and latitude, or the folds of the cross.
fn creases(sheet: &mut Sheet, map: &Chart, environment: &Environment) {
    let parts: [u32; 2] = if environment.layout == "cross" {
        let [columns, rows] = environment.size;
        if columns > rows { [4, 3] } else { [3, 4] }
    } else {
        [8, 4]
    };
    let stroke = Stroke::solid(sheet.palette.grid, 1.0);
    let ([left, top], [right, bottom]) = (map.frame.low, map.frame.high);
    let [width, height] = map.frame.size();
    for part in 1..parts[0] {
        let x = left + width * f64::from(part) / f64::from(parts[0]);
        sheet.line(&map.frame, &[[x, top], [x, bottom]], stroke);
    }
    for part in 1..parts[1] {
        let y = top + height * f64::from(part) / f64::from(parts[1]);
        sheet.line(&map.frame, &[[left, y], [right, y]], stroke);
    }
}

/// What the pixel covers, enlarged, with the texels as a grid.
fn inset(
    sheet: &mut Sheet,
    environment: &Environment,
    room: Frame,
    [low, high]: [Spot; 2],
    (map, image): (&Chart, Option<&Texels>),
) {
    let low: Spot = std::array::from_fn(|i| low[i].min(environment.at[i]));
    let high: Spot = std::array::from_fn(|i| high[i].max(environment.at[i]));
    let air = 0.3 * (high[0] - low[0]).max(high[1] - low[1]).max(0.5);
    let chart = Chart::even(room, low.map(|x| x - air), high.map(|x| x + air), true);
    let Some(chart) = chart.filter(|_| is_roomy(&room)) else { return };
    sheet.area(&room, &[rim(&room)], sheet.palette.panel);
    if let Some(image) = image {
        picture::draw(sheet, &chart, image);
    }
    sheet.whole_lines(&chart);
    let outline = chart.all_at(&environment.footprint);
    sheet.area(&room, std::slice::from_ref(&outline), sheet.palette.bad.faded(0.22));
    // A rim of the ground, so that it is seen on any picture.
    sheet.outline(&room, &outline, Stroke::solid(sheet.palette.ground, 4.0));
    sheet.outline(&room, &outline, Stroke::solid(sheet.palette.bad, 2.0));
    sheet.mark(&room, chart.at(environment.at), 3.5, sheet.palette.ink);
    let stroke = Stroke::solid(sheet.palette.faint, 1.2);
    sheet.drawing.put(Form::Rect { frame: room, fill: None, stroke: Some(stroke) }, sheet.event);
    let times = chart.scale() / map.scale();
    let text = format!("{} times enlarged; the lines part texels", brief((times * 10.0).round() / 10.0));
    let at = [room.low[0], room.low[1] - 9.0];
    sheet.write(&text, at, Anchor::Start, SMALL, sheet.palette.faint);
}
