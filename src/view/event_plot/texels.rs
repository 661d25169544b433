//! The pixel on the grid of texels: its outline, the place of the hit, and how much each texel counts.

use super::telling::Footprint;
use crate::record::{TexelShare, Texels};
use crate::view::drawing::Text;
use crate::view::fonts::text_width;
use crate::view::labels::Label;
use crate::view::sheet::{Chart, Fact, SMALL, Sheet, bounds, ink_on, is_roomy, rim, shown, within_axes};
use crate::view::text::{brief, brief_vector, place, spoken};
use crate::view::{Anchor, Face, Frame, Spot, Stroke};

/// The parts of the drawing in texels of the level that is looked at, rows downwards.
struct Grid {
    /// The place of the hit.
    hit: Option<Spot>,
    /// The pixel's corners.
    footprint: Vec<Spot>,
    /// Columns and rows of the image.
    size: Option<Spot>,
}

pub(super) fn draw(sheet: &mut Sheet, footprint: &Footprint) {
    let level = footprint.texels.map_or(0.0, |(_, texels)| texels.level).floor().clamp(0.0, 60.0);
    let grid = grid(footprint, level);
    let room = sheet.caption("The pixel on the texels of the image", &note(footprint, &grid, level));
    let facts = facts(sheet, footprint, &grid);
    let (room, _) = sheet.facts(room, &facts);
    let frame = within_axes(room);
    let shares = footprint.texels.map_or(&[][..], |(_, texels)| &texels.texels);
    let corners = shares.iter().flat_map(|share| {
        let [x, y] = share.at.map(|at| at as f64);
        [[x, y], [x + 1.0, y + 1.0]]
    });
    let places = grid.footprint.iter().copied().chain(grid.hit).chain(corners);
    let Some([low, high]) = bounds(places).filter(|_| is_roomy(&frame)) else { return };
    let Some(chart) = Chart::even(frame, low.map(|x| x - 0.6), high.map(|x| x + 0.6), true) else { return };
    sheet.area(&frame, &[rim(&frame)], sheet.palette.panel);
    if let Some((event, _)) = footprint.texels {
        let own = std::mem::replace(&mut sheet.event, event);
        for share in shares {
            texel(sheet, &chart, share);
        }
        sheet.event = own;
    }
    sheet.whole_lines(&chart);
    border(sheet, &chart, grid.size);
    outline(sheet, &chart, &grid);
    for share in shares {
        weight(sheet, &chart, &grid, share);
    }
    sheet.axes(&chart, ["column", "row"], true);
}

fn grid(footprint: &Footprint, level: f64) -> Grid {
    let from = |size: [u32; 2], hit: Spot, corners: &[Spot]| {
        let size = size.map(|texels| texels.max(1));
        let own = size.map(|texels| on_level(texels, level));
        let scaled = |point: Spot| std::array::from_fn(|i| point[i] * own[i] / f64::from(size[i]));
        Grid {
            hit: Some(scaled(hit)),
            footprint: corners.iter().map(|&corner| scaled(corner)).collect(),
            size: Some(own),
        }
    };
    if let Some((_, mapping)) = footprint.mapping {
        let [columns, rows] = mapping.size.map(f64::from);
        let hit = [mapping.st[0] * columns, (1.0 - mapping.st[1]) * rows];
        from(mapping.size, hit, &mapping.footprint)
    } else if let Some(environment) = footprint.environment {
        from(environment.size, environment.at, &environment.footprint)
    } else {
        Grid { hit: None, footprint: Vec::new(), size: None }
    }
}

/// How many columns or rows a level of the pyramid has: half as many as the one before, rounded up.
fn on_level(texels: u32, level: f64) -> f64 {
    f64::from((0_u32..32).take_while(|&k| f64::from(k) < level).fold(texels, |texels, _| texels.div_ceil(2)))
}

fn note(footprint: &Footprint, grid: &Grid, level: f64) -> String {
    let place = footprint
        .mapping
        .map(|(_, mapping)| format!("(u, v) = {} is (s, t) = {}. ", place(mapping.uv), place(mapping.st)))
        .unwrap_or_default();
    let on = if level > 0.0 { format!(" on level {level} of the pyramid") } else { String::new() };
    let size = grid.size.map(|size| format!("The image has {} × {} texels{on}.", brief(size[0]), brief(size[1])));
    place + &size.unwrap_or_default()
}

fn facts(sheet: &Sheet, footprint: &Footprint, grid: &Grid) -> Vec<Fact> {
    let mut facts = Vec::new();
    if let Some((_, Texels { filter, texels, left_out, colour, .. })) = footprint.texels {
        facts.push(Fact::words(format!("filter: {}", spoken(filter))));
        facts.push(Fact::Swatch(shown(*colour), brief_vector(*colour)));
        let all = texels.len() + left_out;
        facts.push(Fact::words(if all == 1 { "1 texel".to_owned() } else { format!("{all} texels") }));
        if *left_out > 0 {
            facts.push(Fact::words(format!("the {} largest are drawn", texels.len())));
        }
    }
    if grid.footprint.len() > 2 {
        facts.push(Fact::Line(Stroke::solid(sheet.palette.bad, 2.0), "the pixel".to_owned()));
    }
    facts.extend(grid.hit.map(|_| Fact::Dot(sheet.palette.ink, "the hit".to_owned())));
    facts
}

fn corners(share: &TexelShare) -> [Spot; 4] {
    let [x, y] = share.at.map(|at| at as f64);
    [[x, y], [x + 1.0, y], [x + 1.0, y + 1.0], [x, y + 1.0]]
}

fn texel(sheet: &mut Sheet, chart: &Chart, share: &TexelShare) {
    let ring = chart.all_at(&corners(share));
    sheet.area(&chart.frame, std::slice::from_ref(&ring), shown(share.colour));
    // Smaller ones would be all rim.
    if chart.scale() > 8.0 {
        sheet.outline(&chart.frame, &ring, Stroke::solid(sheet.palette.faint, 1.2));
    }
}

/// Where the image ends; beyond it, it repeats or its edge goes on.
fn border(sheet: &mut Sheet, chart: &Chart, size: Option<Spot>) {
    let Some([columns, rows]) = size else { return };
    let ring = chart.all_at(&[[0.0, 0.0], [columns, 0.0], [columns, rows], [0.0, rows]]);
    sheet.outline(&chart.frame, &ring, Stroke::dashed(sheet.palette.ink, 1.6, [7.0, 4.0]));
}

/// The weight in the middle of its texel, where it has room.
fn weight(sheet: &mut Sheet, chart: &Chart, grid: &Grid, share: &TexelShare) {
    let text = weight_text(share.weight);
    let [x, y] = share.at.map(|at| at as f64);
    let room = Frame { low: chart.at([x, y]), high: chart.at([x + 1.0, y + 1.0]) };
    let needed = [text_width(&text, SMALL, Face::Sans) + 6.0, 1.6 * SMALL];
    let size = room.size();
    if size[0] >= needed[0] && size[1] >= needed[1] && chart.frame.holds(&room.grown(-1.0)) {
        // At the edge away from the hit, where its dot leaves it alone, if the pixel's outline does too.
        let is_above = grid.hit.is_some_and(|hit| y + 0.5 < hit[1]);
        let inset = 0.9 * SMALL;
        let (upper, lower) = (room.low[1] + inset, room.high[1] - inset);
        let heights = if is_above { [upper, room.middle()[1], lower] } else { [lower, room.middle()[1], upper] };
        let fill = shown(share.colour);
        let label = Label::new(text, SMALL, ink_on(fill));
        let [left, middle, right] = [room.low[0] + 4.0, room.middle()[0], room.high[0] - 4.0];
        let columns = [(middle, Anchor::Middle), (left, Anchor::Start), (right, Anchor::End)];
        let places = heights.iter().flat_map(|&y| columns.map(|(x, anchor)| label.at([x, y], anchor, Some(fill))));
        let places: Vec<Text> = places.collect();
        let clear = places.iter().find(|text| sheet.placer.is_clear(&text.frame()));
        if let Some(text) = clear.or(places.first()).cloned() {
            sheet.placer.put_at(&mut sheet.drawing, text, Some(sheet.event));
        }
    }
}

fn weight_text(weight: f64) -> String {
    format!("{}", (weight * 1e4).round() / 1e4)
}

fn outline(sheet: &mut Sheet, chart: &Chart, grid: &Grid) {
    if grid.footprint.len() > 2 {
        let ring = chart.all_at(&grid.footprint);
        sheet.outline(&chart.frame, &ring, Stroke::solid(sheet.palette.ground, 4.0));
        sheet.outline(&chart.frame, &ring, Stroke::solid(sheet.palette.bad, 2.0));
    }
    if let Some(hit) = grid.hit.filter(|hit| hit.iter().all(|x| x.is_finite())) {
        sheet.mark(&chart.frame, chart.at(hit), 4.5, sheet.palette.ink);
    }
}
