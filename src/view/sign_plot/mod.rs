//! d(t) along the ray: where it is positive (outside), zero (on the surface) and negative (inside).

mod probe;
#[cfg(test)]
mod tests;

use super::axis::{Axis, round_step};
use super::drawing::{Anchor, Drawing, Form, Frame, Spot, Stroke};
use super::events_of::Story;
use super::fonts::Face;
use super::labels::{Label, Placer, shortened};
use super::palette::{Colour, Palette, Theme};
use super::text::brief;
use crate::math::portable;
use crate::record::{EventId, Sign, SignSpan, What};
use crate::scene::Scene;
use crate::trace::RayTree;
pub use probe::{ProbedSigns, SignPlotLayout, SignProbe};

/// A curve that is no higher than this has no room: the caption stands alone.
const LEAST: f64 = 6.0;
/// Sizes in points.
const TEXT: f64 = 11.5;
const SMALL: f64 = 10.5;
const MARGIN: f64 = 12.0;
const STRIP: f64 = 13.0;

/// The plot of the `Implicit` event at or near `selected`: itself, the first below it, the first below the nearest
/// event above it that has one and is part of the same object, or for a hit that of the primitive that was hit; of the same ray,
/// in any case.
#[must_use]
pub fn sign_plot(tree: &RayTree, selected: EventId, size: [f64; 2], theme: Theme) -> Option<Drawing> {
    drawn(tree, asked_near(tree, selected)?, None, size, theme).map(|plot| plot.drawing)
}

/// The same, with a time that can be dragged along the ray: the point there, d, and whether that is inside. The time is brought
/// to the nearest one that the plot shows. F is the shape's own, at the point that the recorded S and c give.
#[must_use]
pub fn probed_sign_plot(
    scene: &Scene,
    tree: &RayTree,
    selected: EventId,
    probe_t: Option<f64>,
    size: [f64; 2],
    theme: Theme,
) -> Option<ProbedSigns> {
    let event = asked_near(tree, selected)?;
    let plot = drawn(tree, event, probe_t.map(|t| (scene, t)), size, theme)?;
    let layout = SignPlotLayout { t: plot.t.values, x: plot.t.points, y: [MARGIN + 30.0, plot.d.points[0] + STRIP] };
    Some(ProbedSigns { drawing: plot.drawing, layout, probe: plot.probe })
}

fn drawn(tree: &RayTree, event: EventId, probe: Option<(&Scene, f64)>, size: [f64; 2], theme: Theme) -> Option<Plot> {
    let What::Implicit { equation, samples, roots, signs } = &tree.event(event).what else { return None };
    let samples: Vec<Spot> = samples.iter().copied().filter(|[t, d]| t.is_finite() && d.is_finite()).collect();
    let ([first, _], [last, _]) = (samples.first()?, samples.last()?);
    if first >= last {
        return None;
    }
    let palette = theme.palette();
    let drawing = Drawing::new(size, palette.ground);
    let compression = Compression::of(&samples);
    let (top, bottom) = (MARGIN + 30.0, drawing.height - 48.0);
    let mut plot = Plot {
        t: Axis { values: [*first, *last], points: [MARGIN + 40.0, drawing.width - MARGIN] },
        d: compression.axis(&samples, [bottom, top]),
        placer: Placer::new(drawing.frame().grown(-2.0)),
        drawing,
        palette,
        event,
        compression,
        probe: probe.and_then(|(scene, t)| SignProbe::of(scene, tree, event, t.clamp(*first, *last))),
    };
    plot.caption(equation);
    if bottom - top > LEAST {
        let extent = probe::extent_of(tree, event);
        plot.grid();
        plot.extent(extent);
        plot.curve(&with_roots(&samples, roots));
        plot.strip(signs);
        plot.probe();
        plot.start();
        plot.roots(roots);
        plot.start_name();
        plot.extent_name(extent);
        plot.values();
    }
    plot.drawing.description = plot.description(equation, roots, signs);
    Some(plot)
}

/// The `Implicit` event that `selected` is about: one of the same ray beside it or, for what happens at a hit, that of the primitive
/// that was hit.
fn asked_near(tree: &RayTree, selected: EventId) -> Option<EventId> {
    let story = Story::of(tree, selected)?;
    implicit_near(&story, selected).or_else(|| implicit_near(&story, story.primitive_near(selected)?))
}

fn implicit_near(story: &Story, selected: EventId) -> Option<EventId> {
    let Story { tree, flights } = story;
    let own = flights.owner(selected);
    // Below the colour of a hit lie the rays that it sent, which ask the same shapes.
    let is_it = |id: &EventId| matches!(tree.event(*id).what, What::Implicit { .. }) && flights.owner(*id) == own;
    let below = |id: EventId| (id..tree.subtree_end(id)).find(is_it);
    for id in tree.path(selected).into_iter().rev() {
        if let Some(found) = below(id) {
            return Some(found);
        }
        if matches!(tree.event(id).what, What::Object { .. } | What::Ray { .. } | What::Step { .. }) {
            return None;
        }
    }
    None
}

/// How d is brought onto paper: straight, or through asinh(d / unit), which is straight near zero and logarithmic far
/// from it, so that the zeros of a steep polynomial stay apart from the axis.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Compression {
    unit: Option<f64>,
}

impl Compression {
    /// Straight where the largest d is at most `STEEP` times the middle one.
    fn of(samples: &[Spot]) -> Self {
        /// Smaller would compress a parabola, whose plain shape students know; larger would let the dip of a torus,
        /// seen from far, vanish in the line of the axis.
        const STEEP: f64 = 12.0;
        let mut sizes: Vec<f64> = samples.iter().map(|[_, d]| d.abs()).collect();
        sizes.sort_by(f64::total_cmp);
        let largest = sizes.last().copied().unwrap_or(0.0);
        let deepest = samples.iter().map(|[_, d]| -d).fold(0.0, f64::max);
        let middle = sizes.get(sizes.len() / 2).copied().unwrap_or(0.0);
        let scale = if deepest > 0.0 { deepest.min(middle) } else { middle };
        let steep = largest > STEEP * scale && scale > 0.0;
        Self { unit: steep.then(|| round_step(scale / 2.0)) }
    }

    fn apply(self, d: f64) -> f64 {
        self.unit.map_or(d, |unit| portable::asinh(d / unit))
    }

    fn axis(self, samples: &[Spot], points: [f64; 2]) -> Axis {
        let values = samples.iter().map(|[_, d]| self.apply(*d));
        let low = values.clone().fold(0.0, f64::min);
        let high = values.fold(0.0, f64::max);
        let margin = if high > low { 0.08 * (high - low) } else { 1.0 };
        Axis { values: [low - margin, high + margin], points }
    }

    /// Values of d at which a tick stands.
    fn ticks(self, axis: &Axis) -> Vec<f64> {
        let Some(unit) = self.unit else {
            return axis.ticks(((axis.points[0] - axis.points[1]) / 34.0).max(2.0));
        };
        let decades = (0..16).map(|power| unit * portable::powi(10.0, power));
        let both = decades.flat_map(|d| [d, -d]).filter(|&d| axis.shows(self.apply(d)));
        std::iter::once(0.0).chain(both).collect()
    }
}

/// The samples with the roots put in as zeros, so that the curve changes colour where it crosses the axis.
fn with_roots(samples: &[Spot], roots: &[f64]) -> Vec<Spot> {
    let mut all: Vec<Spot> = samples.to_vec();
    all.extend(roots.iter().filter(|root| root.is_finite()).map(|&root| [root, 0.0]));
    all.sort_by(|a, b| a[0].total_cmp(&b[0]));
    all
}

struct Plot {
    drawing: Drawing,
    placer: Placer,
    palette: &'static Palette,
    t: Axis,
    d: Axis,
    compression: Compression,
    event: EventId,
    probe: Option<SignProbe>,
}

impl Plot {
    fn at(&self, [t, d]: Spot) -> Spot {
        [self.t.at(t), self.d.at(self.compression.apply(d))]
    }

    fn colour(&self, sign: Sign) -> Colour {
        match sign {
            Sign::Positive => self.palette.outside,
            Sign::Negative => self.palette.inside,
        }
    }

    fn caption(&mut self, equation: &str) {
        let width = self.drawing.width - 2.0 * MARGIN;
        let text = shortened(&format!("d(t) = F(S + c t) with F = {equation}"), width, TEXT, Face::Sans);
        let label = Label::new(text, TEXT, self.palette.ink);
        self.placer.put_at(&mut self.drawing, label.at([MARGIN, MARGIN + 2.0], Anchor::Start, None), Some(self.event));
        let name = match self.compression.unit {
            Some(unit) => format!("d, compressed: asinh(d / {})", brief(unit)),
            None => "d".to_owned(),
        };
        self.read_out();
        let label = Label::new(name, SMALL, self.palette.faint);
        self.placer.put_at(&mut self.drawing, label.at([MARGIN, MARGIN + 20.0], Anchor::Start, None), None);
    }

    fn grid(&mut self) {
        let [left, right] = self.t.points;
        let fine = Stroke::solid(self.palette.grid.faded(0.7), 0.8);
        for d in self.compression.ticks(&self.d) {
            let y = self.d.at(self.compression.apply(d));
            self.drawing.put(Form::Line { points: vec![[left, y], [right, y]], stroke: fine }, None);
        }
        let zero = self.d.at(0.0);
        self.placer.avoid_line([left, zero], [right, zero]);
        let stroke = Stroke::solid(self.palette.faint, 1.2);
        self.drawing.put(Form::Line { points: vec![[left, zero], [right, zero]], stroke }, None);
    }

    /// The curve in pieces of one sign, each with the area between it and the axis.
    fn curve(&mut self, samples: &[Spot]) {
        let mut piece: Vec<Spot> = Vec::new();
        for &[t, d] in samples {
            let crossing = piece
                .last()
                .filter(|last| last[1] * d < 0.0)
                .map(|last| last[0] + (t - last[0]) * last[1] / (last[1] - d));
            if let Some(crossing) = crossing {
                piece.push([crossing, 0.0]);
                self.piece(&piece);
                piece = vec![[crossing, 0.0]];
            }
            piece.push([t, d]);
            if d == 0.0 {
                self.piece(&piece);
                piece = vec![[t, d]];
            }
        }
        self.piece(&piece);
    }

    fn piece(&mut self, samples: &[Spot]) {
        let Some(&[_, d]) = samples.iter().find(|[_, d]| *d != 0.0) else { return };
        let colour = self.colour(if d > 0.0 { Sign::Positive } else { Sign::Negative });
        let points: Vec<Spot> = samples.iter().map(|&sample| self.at(sample)).collect();
        if points.len() < 2 {
            return;
        }
        let zero = self.d.at(0.0);
        self.placer.avoid_outline(&points);
        let mut ring = points.clone();
        ring.push([points[points.len() - 1][0], zero]);
        ring.push([points[0][0], zero]);
        self.drawing.put(Form::Area { rings: vec![ring], fill: colour.faded(0.16) }, self.event);
        self.drawing.put(Form::Line { points, stroke: Stroke::solid(colour, 2.0) }, self.event);
    }

    /// The strip of signs under the plot.
    fn strip(&mut self, signs: &[SignSpan]) {
        let [left, right] = self.t.points;
        let top = self.d.points[0] + 5.0;
        self.placer.avoid_line([left, top + STRIP / 2.0], [right, top + STRIP / 2.0]);
        for span in signs {
            let end = |t: Option<f64>, open: f64| t.map_or(open, |t| self.t.at(t).max(left).min(right));
            let (from, to) = (end(span.from, left), end(span.to, right));
            let frame = Frame { low: [from, top], high: [to, top + STRIP] };
            let colour = self.colour(span.sign);
            self.drawing.put(Form::Rect { frame, fill: Some(colour.faded(0.85)), stroke: None }, self.event);
            let (short, long) = match span.sign {
                Sign::Positive => ("+", "+ outside"),
                Sign::Negative => ("−", "− inside"),
            };
            for text in [long, short] {
                let label = Label::new(text, SMALL, self.palette.ground).face(Face::Bold);
                let text = label.at([f64::midpoint(from, to), top + STRIP / 2.0], Anchor::Middle, None);
                if text.frame().low[0] > from + 1.0 && self.placer.put_at(&mut self.drawing, text, Some(self.event)) {
                    break;
                }
            }
        }
    }

    fn roots(&mut self, roots: &[f64]) {
        let zero = self.d.at(0.0);
        for &root in roots.iter().filter(|root| self.t.shows(**root)) {
            let x = self.t.at(root);
            let stroke = Stroke::dashed(self.palette.faint, 1.0, [2.0, 3.0]);
            self.drawing.put(Form::Line { points: vec![[x, zero], [x, self.d.points[0] + 5.0]], stroke }, self.event);
            let rim = Some(Stroke::solid(self.palette.ground, 1.5));
            let circle = Form::Circle { centre: [x, zero], radius: 4.5, fill: Some(self.palette.ink), stroke: rim };
            self.drawing.put(circle, self.event);
            self.placer.reserve(Frame { low: [x, zero], high: [x, zero] }.grown(5.0));
            self.placer.avoid_line([x, zero], [x, self.d.points[0]]);
        }
        for &root in roots.iter().filter(|root| self.t.shows(**root)) {
            let label = Label::new(format!("t = {}", brief(root)), TEXT, self.palette.ink).of(self.event);
            // Far enough for the places above and below the axis, on the side that the curve leaves free.
            self.placer.put_near(&mut self.drawing, [self.t.at(root), zero], 11.0, &label, self.palette);
        }
    }

    /// Where the ray starts.
    fn start(&mut self) {
        if !self.t.shows(0.0) {
            return;
        }
        let (x, [bottom, top]) = (self.t.at(0.0), self.d.points);
        let stroke = Stroke::solid(self.palette.ink, 1.2);
        self.drawing.put(Form::Line { points: vec![[x, top], [x, bottom]], stroke }, None);
        self.placer.avoid_line([x, top], [x, bottom]);
    }

    fn start_name(&mut self) {
        if !self.t.shows(0.0) {
            return;
        }
        let (x, top) = (self.t.at(0.0), self.d.points[1]);
        let label = Label::new("the ray starts", SMALL, self.palette.ink);
        for (side, anchor) in [(4.0, Anchor::Start), (-4.0, Anchor::End)] {
            let text = label.at([x + side, top + 6.0], anchor, Some(self.palette.ground));
            if self.placer.put_at(&mut self.drawing, text, None) {
                return;
            }
        }
    }

    /// Numbers along both axes.
    fn values(&mut self) {
        for d in self.compression.ticks(&self.d) {
            let y = self.d.at(self.compression.apply(d));
            let label = Label::new(brief(d), SMALL, self.palette.faint);
            let text = label.at([self.t.points[0] - 6.0, y], Anchor::End, None);
            self.placer.put_at(&mut self.drawing, text, None);
        }
        let base = self.d.points[0] + 5.0 + STRIP;
        let [left, right] = self.t.points;
        let stroke = Stroke::solid(self.palette.faint, 1.0);
        for tick in self.t.ticks((right - left) / 60.0) {
            let x = self.t.at(tick);
            self.drawing.put(Form::Line { points: vec![[x, base], [x, base + 4.0]], stroke }, None);
            let label = Label::new(brief(tick), SMALL, self.palette.faint);
            self.placer.put_at(&mut self.drawing, label.at([x, base + 12.0], Anchor::Middle, None), None);
        }
        let name = Label::new("t", TEXT, self.palette.faint);
        self.placer.put_at(&mut self.drawing, name.at([left - 12.0, base + 12.0], Anchor::Middle, None), None);
    }
}
