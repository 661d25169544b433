//! The points themselves: their shapes, their error bars, the thin lines through the settings of a knob, and the frontier.

use super::paper::Paper;
use super::scale::LogScale;
use super::{FrontierPlot, Layout, PlotPoint};
use crate::math::portable;
use crate::view::drawing::{Form, Spot, Stroke};
use crate::view::palette::{Colour, Palette};
use std::f64::consts::{PI, TAU};

/// The radius of a marker in points.
pub const RADIUS: f64 = 4.6;
/// The ring about the standard.
pub const RING: f64 = 8.0;

/// Draws the thin lines, the frontier, the error bars and the markers.
pub fn draw(paper: &mut Paper, layout: &Layout) {
    let plot = paper.plot;
    knob_lines(paper, layout);
    let stairs = staircase(plot, layout);
    if stairs.len() > 1 {
        let stroke = Stroke::solid(paper.palette.camera, 2.0);
        paper.put(Form::Line { points: stairs, stroke }, None);
    }
    // What is on the frontier lies on top.
    let mut order: Vec<usize> = (0..plot.points.len()).collect();
    order.sort_by_key(|&k| (plot.points[k].is_standard, plot.points[k].on_frontier, k));
    for &k in &order {
        error_bar(paper, layout, k);
    }
    for &k in &order {
        let Some(at) = layout.spots[k] else { continue };
        let point = &plot.points[k];
        let look = Look { group: point.group, prominent: point.on_frontier, noisy: point.noisy };
        if point.is_standard {
            let stroke = Some(Stroke::solid(paper.palette.ink, 1.4));
            paper.put(Form::Circle { centre: at, radius: RING, fill: None, stroke }, Some(k));
        }
        sign(paper, at, look, Some(k));
    }
}

/// What decides how a marker looks.
#[derive(Clone, Copy)]
pub struct Look {
    /// Whose shape and colour it has.
    pub group: Option<usize>,
    /// On the frontier: filled.
    pub prominent: bool,
    /// Its time is lost in noise: its rim is dashed.
    pub noisy: bool,
}

/// Draws one marker.
pub fn sign(paper: &mut Paper, at: Spot, look: Look, point: Option<usize>) {
    let palette = paper.palette;
    let full = colour(look.group, palette);
    // What is beaten is greyed, and still tells its knob.
    let (fill, rim, width) = if look.prominent {
        (full, full.mixed(palette.ink, 0.45), 1.1)
    } else {
        (palette.ground, full.mixed(palette.faint, 0.4), 1.3)
    };
    let ring = outline(look.group.map_or(0, |group| group + 1), at);
    paper.put(Form::Area { rings: vec![ring.clone()], fill }, point);
    let mut closed = ring;
    closed.push(closed[0]);
    let dash = look.noisy.then_some([1.6, 1.6]);
    paper.put(Form::Line { points: closed, stroke: Stroke { colour: rim, width, dash } }, point);
}

/// The colour of a group; ink for what belongs to none.
pub fn colour(group: Option<usize>, palette: &Palette) -> Colour {
    group.map_or(palette.ink, |group| palette.categories[group % palette.categories.len()])
}

/// How many shapes there are: one for each knob, one for combinations, one for what belongs to no group.
const SHAPES: usize = 14;

/// A shape about a place.
fn outline(shape: usize, at: Spot) -> Vec<Spot> {
    let polar =
        |radius: f64, angle: f64| [at[0] + radius * portable::sin(angle), at[1] - radius * portable::cos(angle)];
    let regular = |corners: u32, radius: f64, turn: f64| {
        (0..corners).map(|k| polar(radius * RADIUS, turn + TAU * f64::from(k) / f64::from(corners))).collect()
    };
    let star = |points: u32, inner: f64, turn: f64| {
        let corner = |k: u32| {
            let radius = if k.is_multiple_of(2) { 1.35 } else { inner };
            polar(radius * RADIUS, turn + PI * f64::from(k) / f64::from(points))
        };
        (0..2 * points).map(corner).collect()
    };
    match shape % SHAPES {
        0 => regular(24, 1.0, 0.0),
        1 => regular(4, 1.2, PI / 4.0),
        2 => regular(4, 1.3, 0.0),
        3 => regular(3, 1.35, 0.0),
        4 => regular(3, 1.35, PI),
        5 => star(5, 0.55, 0.0),
        6 => cross(at, 0.0),
        7 => cross(at, PI / 4.0),
        8 => regular(6, 1.15, 0.0),
        9 => regular(3, 1.35, PI / 2.0),
        10 => regular(3, 1.35, -PI / 2.0),
        11 => star(4, 0.5, 0.0),
        12 => star(6, 0.75, 0.0),
        _ => [[-1.0, -1.0], [1.0, -1.0], [-1.0, 1.0], [1.0, 1.0]]
            .map(|corner| std::array::from_fn(|i| at[i] + 1.1 * RADIUS * corner[i]))
            .to_vec(),
    }
}

/// A plus sign, turned by an angle.
fn cross(at: Spot, turn: f64) -> Vec<Spot> {
    let (arm, half) = (1.3 * RADIUS, 0.42 * RADIUS);
    let quarter = [[-half, -arm], [half, -arm], [half, -half]];
    let corners = (0..4_u8).flat_map(|k| {
        let (sin, cos) = portable::sin_cos(turn + f64::from(k) * PI / 2.0);
        quarter.map(|[x, y]| [at[0] + x * cos - y * sin, at[1] + x * sin + y * cos])
    });
    corners.collect()
}

/// The places of the settings of each knob that have an error, in their order.
pub fn knob_paths(plot: &FrontierPlot, layout: &Layout) -> Vec<Vec<Spot>> {
    let path = |group: usize| {
        let own = plot.points.iter().zip(&layout.spots).filter(|(point, _)| point.group == Some(group));
        let own = own.filter(|_| plot.loose != Some(group));
        own.filter(|(point, _)| point.error > 0.0).filter_map(|(_, spot)| *spot).collect()
    };
    (0..plot.groups.len()).map(path).collect()
}

/// A thin line through the settings of each knob.
fn knob_lines(paper: &mut Paper, layout: &Layout) {
    for (group, points) in knob_paths(paper.plot, layout).into_iter().enumerate() {
        if points.len() > 1 {
            let stroke = Stroke::solid(colour(Some(group), paper.palette).faded(0.35), 0.9);
            paper.put(Form::Line { points, stroke }, None);
        }
    }
}

/// The frontier: with more time the least error falls in steps. Controls are compared with another picture and take no
/// part.
pub fn staircase(plot: &FrontierPlot, layout: &Layout) -> Vec<Spot> {
    let on_it = |k: &usize| plot.points[*k].on_frontier && !plot.points[*k].is_control;
    let mut spots: Vec<Spot> = (0..plot.points.len()).filter(on_it).filter_map(|k| layout.spots[k]).collect();
    spots.sort_by(|a, b| a[0].total_cmp(&b[0]).then(b[1].total_cmp(&a[1])));
    let Some(first) = spots.first() else { return Vec::new() };
    let mut stairs = vec![[first[0], layout.field.low[1]]];
    let mut lowest = layout.field.low[1];
    for [x, y] in spots {
        if y > lowest {
            stairs.push([x, lowest]);
            stairs.push([x, y]);
            lowest = y;
        }
    }
    stairs.push([layout.field.high[0], lowest]);
    stairs.dedup();
    stairs
}

/// How far the quartiles of the time lie from each other, where that is more than the marker covers.
fn error_bar(paper: &mut Paper, layout: &Layout, k: usize) {
    let point = &paper.plot.points[k];
    let Some([_, y]) = layout.spots[k] else { return };
    let sides = [layout.field.low[0], layout.field.high[0]];
    let Some([low, high]) = bar(&layout.x, sides, point) else { return };
    let colour = colour(point.group, paper.palette).mixed(paper.palette.faint, 0.5);
    let stroke = Stroke::solid(colour, 1.1);
    paper.put(Form::Line { points: vec![[low, y], [high, y]], stroke }, Some(k));
    for x in [low, high] {
        paper.put(Form::Line { points: vec![[x, y - 3.0], [x, y + 3.0]], stroke }, Some(k));
    }
}

/// The ends of a point's error bar, within the field's sides.
pub fn bar(x: &LogScale, [left, right]: [f64; 2], point: &PlotPoint) -> Option<[f64; 2]> {
    let ends = [point.seconds - point.spread, point.seconds + point.spread]
        .map(|value| if value > 0.0 { x.at(value).max(left).min(right) } else { left });
    (point.spread > 0.0 && ends[1] - ends[0] > 2.6 * RADIUS).then_some(ends)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_group_up_to_the_last_shape_has_one_of_its_own() {
        let shapes: Vec<_> = (0..SHAPES).map(|shape| outline(shape, [0.0, 0.0])).collect();
        for (k, shape) in shapes.iter().enumerate() {
            assert!(shapes[..k].iter().all(|other| other != shape), "{k}");
            let reach = shape.iter().map(|corner| corner[0].hypot(corner[1])).fold(0.0, f64::max);
            assert!((0.9..1.7).contains(&(reach / RADIUS)), "{k}: {reach}");
        }
    }
}
