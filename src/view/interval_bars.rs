//! Left, right and combined list of a CSG node as bars on one t axis.

use super::axis::Axis;
use super::drawing::{Anchor, Drawing, Form, Frame, Stroke, Text};
use super::flights::{End, Flights};
use super::fonts::{Face, text_width};
use super::labels::{Label, Placer, shortened, wrapped};
use super::palette::{Colour, Palette, Theme};
use super::text::{brief, row, span_list};
use crate::record::{Certificate, Edge, EventId, Operator, Span, What};
use crate::trace::RayTree;
use std::fmt::Write as _;

/// Sizes in points.
const TEXT: f64 = 11.5;
const SMALL: f64 = 10.5;
const MARGIN: f64 = 12.0;

/// Room between the last bar's row and the axis, so that the labels below that bar stand clear of the line.
const LAST_LABELS: f64 = 9.0;

/// Bars that are closer lie on each other: then the caption stands alone.
const LEAST_PITCH: f64 = 8.0;

/// Between two names of boundaries in a line; closer, they read as one.
const BETWEEN: f64 = 3.0;

/// For how many names to come a name leaves room.
const LOOKED_AHEAD: usize = 3;

/// Between the name of a boundary and the line that goes up or down at it.
const ASIDE: f64 = 3.0;

/// Slices in which an unbounded end fades out.
const FADE_STEPS: u32 = 7;

/// The bars of the `Combine` event at or nearest above `selected`, else of the first below it.
#[must_use]
pub fn interval_bars(tree: &RayTree, selected: EventId, size: [f64; 2], theme: Theme) -> Option<Drawing> {
    probed_interval_bars(tree, selected, None, size, theme)
}

/// The same with one more time marked.
#[must_use]
pub fn probed_interval_bars(
    tree: &RayTree,
    selected: EventId,
    probe_t: Option<f64>,
    size: [f64; 2],
    theme: Theme,
) -> Option<Drawing> {
    let event = combine_at(tree, selected)?;
    let What::Combine { name, operator, left, right, combined, early_out } = &tree.event(event).what else {
        return None;
    };
    let palette = theme.palette();
    let drawing = Drawing::new(size, palette.ground);
    let hit = match Flights::of(tree).ray_of(event).end {
        End::Hit { event, t } => Some((event, t)),
        _ => None,
    };
    let mut bars = Bars {
        placer: Placer::new(drawing.frame().grown(-2.0)),
        axis: Axis { values: range(&[left, right.as_deref().unwrap_or(&[]), combined], hit), points: [0.0, 1.0] },
        drawing,
        palette,
        event,
        probe_t,
    };
    let top = bars.caption(&row(tree.event(event)).label, early_out.as_deref());
    let names = ["left".to_owned(), "right".to_owned(), format!("left {} right", operator.sign())];
    let heads = operands(tree, event, *operator, name, names);
    bars.lay_out(&heads);
    let lists = [Some(left), right.as_ref(), Some(combined)];
    bars.lists(top, &heads, lists, hit);
    bars.drawing.description = description(&row(tree.event(event)).label, &heads, lists, early_out.as_deref(), hit);
    Some(bars.drawing)
}

/// The three lists in words.
fn description(
    title: &str,
    heads: &[String; 3],
    lists: [Option<&Vec<Span>>; 3],
    early_out: Option<&str>,
    hit: Option<(EventId, f64)>,
) -> String {
    let mut text = format!("Intervals of {title}.");
    for (head, list) in heads.iter().zip(lists) {
        let told = list.map_or("not asked".to_owned(), |list| span_list(list));
        let _ = write!(text, " {head}: {told}.");
    }
    if let Some(reason) = early_out {
        let _ = write!(text, " Early out: {reason}.");
    }
    if let Some((_, t)) = hit {
        let _ = write!(text, " The hit that is seen is at t = {}.", brief(t));
    }
    text
}

fn combine_at(tree: &RayTree, selected: EventId) -> Option<EventId> {
    let is_combine = |id: &EventId| matches!(tree.event(*id).what, What::Combine { .. });
    if selected >= tree.end() {
        return None;
    }
    let above = tree.path(selected).into_iter().rev().find(is_combine);
    above.or_else(|| (selected..tree.subtree_end(selected)).find(is_combine))
}

/// The bars' names, with the names of the operands where they are known.
fn operands(tree: &RayTree, event: EventId, operator: Operator, name: &str, plain: [String; 3]) -> [String; 3] {
    let mut below = tree.children(event).filter_map(|child| match &child.what {
        What::Primitive { name, .. } | What::Combine { name, .. } => Some(name.clone()),
        _ => None,
    });
    let (left, right) = (below.next(), below.next());
    let [plain_left, plain_right, plain_result] = plain;
    let named = |plain: String, name: Option<String>| name.map_or(plain.clone(), |name| format!("{plain}: {name}"));
    let result = if name == operator.name() { None } else { Some(name.to_owned()) };
    [named(plain_left, left), named(plain_right, right), result.unwrap_or(plain_result)]
}

/// The stretch of t that is shown: all boundaries, the hit, and the ray's start unless it is far off.
pub(super) fn range(lists: &[&[Span]], hit: Option<(EventId, f64)>) -> [f64; 2] {
    let ends = lists.iter().flat_map(|list| list.iter()).flat_map(|span| [&span.enter, &span.leave]).flatten();
    let times: Vec<f64> = ends.map(|edge| edge.t).filter(|t| t.is_finite()).collect();
    let hit = hit.map(|(_, t)| t).filter(|t| t.is_finite());
    let (first, last) = bounds(&times).or(hit.map(|t| (t, t))).unwrap_or((0.0, 1.0));
    let length = last - first;
    let near = |t: f64| t > first - 1.5 * length && t < last + 1.5 * length;
    let (mut low, mut high) = (first, last);
    // The start is shown unless everything else would shrink to less than two fifths; so is the hit.
    for t in [Some(0.0), hit].into_iter().flatten() {
        if near(t) || length == 0.0 {
            (low, high) = (low.min(t), high.max(t));
        }
    }
    let margin = if high > low { 0.08 * (high - low) } else { 0.5 * low.abs().max(1.0) };
    [low - margin, high + margin]
}

fn bounds(times: &[f64]) -> Option<(f64, f64)> {
    let low = times.iter().copied().reduce(f64::min)?;
    let high = times.iter().copied().reduce(f64::max)?;
    Some((low, high))
}

struct Bars {
    drawing: Drawing,
    placer: Placer,
    axis: Axis,
    palette: &'static Palette,
    event: EventId,
    probe_t: Option<f64>,
}

impl Bars {
    /// The title and the reason of an early out; returns the height that is left below them.
    fn caption(&mut self, title: &str, early_out: Option<&str>) -> f64 {
        let width = self.drawing.width - 2.0 * MARGIN;
        let mut y = MARGIN + 0.5 * TEXT;
        let label = Label::new(shortened(title, width, 13.0, Face::Bold), 13.0, self.palette.ink).face(Face::Bold);
        self.placer.put_at(&mut self.drawing, label.at([MARGIN, y], Anchor::Start, None), Some(self.event));
        if let Some(reason) = early_out {
            for line in wrapped(&format!("Early out: {reason}"), width, TEXT, Face::Sans) {
                y += 16.5;
                let label = Label::new(line, TEXT, self.palette.bad);
                self.placer.put_at(&mut self.drawing, label.at([MARGIN, y], Anchor::Start, None), Some(self.event));
            }
        }
        y + 14.0
    }

    /// Leaves room for the bars' names at the left.
    fn lay_out(&mut self, heads: &[String; 3]) {
        let widest = heads.iter().map(|head| text_width(head, TEXT, Face::Sans)).fold(0.0, f64::max);
        let column = widest.min(0.3 * self.drawing.width);
        self.axis.points = [MARGIN + column + 10.0, self.drawing.width - MARGIN];
    }

    fn lists(&mut self, top: f64, heads: &[String; 3], lists: [Option<&Vec<Span>>; 3], hit: Option<(EventId, f64)>) {
        let bottom = self.drawing.height - 34.0 - LAST_LABELS;
        let pitch = ((bottom - top) / 3.0).min(110.0);
        if pitch < LEAST_PITCH {
            return;
        }
        let thick = (pitch * 0.34).clamp(7.0, 26.0);
        let colours = [self.palette.left, self.palette.right, self.palette.combined];
        let middles = [0.5, 1.5, 2.5].map(|rows| top + pitch * rows);
        let base = top + pitch * 3.0 + LAST_LABELS;
        self.time_marks(top, base, hit);
        for ((list, head), (y, colour)) in lists.iter().zip(heads).zip(middles.into_iter().zip(colours)) {
            self.head(head, y);
            self.track(y);
            for span in list.iter().flat_map(|list| list.iter()) {
                self.bar(span, y, thick, colour);
            }
        }
        self.guides(lists[2], [middles[0] - thick * 0.5, middles[2]]);
        self.shade_behind(top, base);
        self.ticks(base);
        for (list, y) in lists.iter().zip(middles) {
            match list {
                Some(list) if list.is_empty() => self.remark("empty", y),
                Some(list) => self.edges(list, y, thick),
                None => self.remark("not asked", y),
            }
        }
    }

    fn head(&mut self, head: &str, y: f64) {
        let room = self.axis.points[0] - MARGIN - 8.0;
        let label = Label::new(shortened(head, room, TEXT, Face::Sans), TEXT, self.palette.ink);
        self.placer.put_at(&mut self.drawing, label.at([MARGIN, y], Anchor::Start, None), None);
    }

    fn track(&mut self, y: f64) {
        let [left, right] = self.axis.points;
        let stroke = Stroke::solid(self.palette.grid, 1.0);
        self.drawing.put(Form::Line { points: vec![[left, y], [right, y]], stroke }, None);
    }

    /// A bar; an end that is unbounded fades out and has an arrow head.
    fn bar(&mut self, span: &Span, y: f64, thick: f64, colour: Colour) {
        let [left, right] = self.axis.points;
        let from = span.enter.as_ref().map_or(left, |edge| self.axis.at(edge.t).max(left).min(right));
        let to = span.leave.as_ref().map_or(right, |edge| self.axis.at(edge.t).max(left).min(right));
        let fade = 28.0_f64.min((to - from) / 2.0);
        let solid_from = if span.enter.is_none() { from + fade } else { from };
        let solid_to = if span.leave.is_none() { to - fade } else { to };
        // A stretch too short to see is still there.
        let (low, high) =
            if solid_to - solid_from < 1.5 { (solid_from - 0.75, solid_from + 0.75) } else { (solid_from, solid_to) };
        self.block([low, high], y, thick, colour);
        if span.enter.is_none() {
            self.open_end([from + fade, from], y, thick, colour);
        }
        if span.leave.is_none() {
            self.open_end([to - fade, to], y, thick, colour);
        }
    }

    fn block(&mut self, [from, to]: [f64; 2], y: f64, thick: f64, colour: Colour) {
        let frame = Frame { low: [from.min(to), y - thick / 2.0], high: [from.max(to), y + thick / 2.0] };
        self.drawing.put(Form::Rect { frame, fill: Some(colour), stroke: None }, self.event);
    }

    /// Fades out from the bar's solid part towards the end of the axis, where an arrow points on.
    fn open_end(&mut self, [solid, end]: [f64; 2], y: f64, thick: f64, colour: Colour) {
        let slice = (end - solid) / f64::from(FADE_STEPS);
        for i in 0..FADE_STEPS {
            let from = solid + slice * f64::from(i);
            let opacity = 1.0 - (f64::from(i) + 1.0) / (f64::from(FADE_STEPS) + 1.0);
            self.block([from, from + slice], y, thick, colour.faded(opacity));
        }
        let outwards = (end - solid).signum();
        let stroke = Stroke::solid(colour, 1.5);
        let (from, to) = ([end - outwards * 8.0, y], [end + outwards * 4.0, y]);
        self.drawing.put(Form::Arrow { from, to, head: 8.0, stroke }, self.event);
    }

    /// Thin lines from the boundaries of the result up to the operands that they come from.
    fn guides(&mut self, combined: Option<&Vec<Span>>, [top, bottom]: [f64; 2]) {
        let ends = combined.into_iter().flatten().flat_map(|span| [&span.enter, &span.leave]).flatten();
        for edge in ends.filter(|edge| self.axis.shows(edge.t)) {
            let x = self.axis.at(edge.t);
            let stroke = Stroke::dashed(self.palette.combined, 1.0, [2.0, 3.0]);
            self.drawing.put(Form::Line { points: vec![[x, top], [x, bottom]], stroke }, None);
        }
    }

    /// What lies behind the ray's start is greyed.
    fn shade_behind(&mut self, top: f64, base: f64) {
        let [left, right] = self.axis.points;
        let start = self.axis.at(0.0).min(right);
        if start > left {
            let frame = Frame { low: [left - 5.0, top], high: [start, base] };
            self.drawing.put(Form::Rect { frame, fill: Some(self.palette.ground.faded(0.62)), stroke: None }, None);
        }
    }

    /// The ray's start and the hit that is seen.
    fn time_marks(&mut self, top: f64, base: f64, hit: Option<(EventId, f64)>) {
        let probe_t = self.probe_t.filter(|t| self.axis.shows(*t));
        let mut mark = |t: f64, name: String, colour: Colour, event: Option<EventId>| {
            let x = self.axis.at(t);
            let stroke = Stroke::solid(colour, 1.4);
            self.drawing.put(Form::Line { points: vec![[x, top - 2.0], [x, base]], stroke }, event);
            self.placer.avoid_line([x, top - 2.0], [x, base]);
            for (side, anchor) in [(0.0, Anchor::Middle), (-3.0, Anchor::Start), (3.0, Anchor::End)] {
                let label = Label::new(name.clone(), SMALL, colour);
                if self.placer.put_at(&mut self.drawing, label.at([x + side, base + 25.0], anchor, None), event) {
                    break;
                }
            }
        };
        if let Some(t) = probe_t {
            mark(t, format!("t = {}", brief(t)), self.palette.highlight.mixed(self.palette.ink, 0.5), None);
        }
        if let Some((event, t)) = hit.filter(|(_, t)| self.axis.shows(*t)) {
            mark(t, format!("seen: t = {}", brief(t)), self.palette.good, Some(event));
        }
        if self.axis.shows(0.0) {
            mark(0.0, "the ray starts".to_owned(), self.palette.ink, None);
        } else {
            let [left, right] = self.axis.points;
            let text =
                if self.axis.values[0] > 0.0 { "← the ray starts at t = 0" } else { "the ray starts at t = 0 →" };
            let label = Label::new(text, SMALL, self.palette.faint);
            let mut places = [([left, base + 25.0], Anchor::Start), ([right, base + 25.0], Anchor::End)];
            if self.axis.values[0] <= 0.0 {
                places.reverse();
            }
            let mut put = |(at, anchor)| self.placer.put_at(&mut self.drawing, label.at(at, anchor, None), None);
            let _ = put(places[0]) || put(places[1]);
        }
    }

    fn ticks(&mut self, base: f64) {
        let [left, right] = self.axis.points;
        let stroke = Stroke::solid(self.palette.faint, 1.0);
        self.drawing.put(Form::Line { points: vec![[left, base], [right, base]], stroke }, None);
        let name = Label::new("t", TEXT, self.palette.faint);
        self.placer.put_at(&mut self.drawing, name.at([left - 8.0, base + 9.0], Anchor::Middle, None), None);
        for tick in self.axis.ticks((right - left) / 60.0) {
            let x = self.axis.at(tick);
            self.drawing.put(Form::Line { points: vec![[x, base], [x, base + 4.0]], stroke }, None);
            let label = Label::new(brief(tick), SMALL, self.palette.faint);
            self.placer.put_at(&mut self.drawing, label.at([x, base + 11.0], Anchor::Middle, None), None);
        }
    }

    fn remark(&mut self, text: &str, y: f64) {
        let halo = Some(self.palette.ground);
        let label = Label::new(text, TEXT, self.palette.faint);
        let x = f64::midpoint(self.axis.points[0], self.axis.points[1]);
        self.placer.put_at(&mut self.drawing, label.at([x, y], Anchor::Middle, halo), Some(self.event));
    }

    /// The names of the boundaries: entries above the bar, exits below it, shorter where there is no room.
    fn edges(&mut self, spans: &[Span], y: f64, thick: f64) {
        let offset = thick / 2.0 + 0.78 * SMALL;
        let mut names = Vec::new();
        for span in spans {
            for (edge, first, outward) in [(&span.enter, -offset, Anchor::Start), (&span.leave, offset, Anchor::End)] {
                if let Some(edge) = edge.as_ref().filter(|edge| self.axis.shows(edge.t)) {
                    if edge.certificate == Certificate::Undecidable {
                        self.doubtful_end(edge.t, y, thick);
                    }
                    names.push(self.edge_names(edge, [y + first, y - first], outward));
                }
            }
        }
        for (i, places) in names.iter().enumerate() {
            let next = &names[i + 1..names.len().min(i + 1 + LOOKED_AHEAD)];
            if let Some(text) = self.edge_name(places, next) {
                self.placer.put_at(&mut self.drawing, text, Some(self.event));
            }
        }
    }

    /// An end of which the ray's own numbers do not say whether it exists: a broken line across the bar.
    fn doubtful_end(&mut self, t: f64, y: f64, thick: f64) {
        let (x, half) = (self.axis.at(t), 0.5 * thick + 3.0);
        let stroke = Stroke::dashed(self.palette.bad, 2.5, [3.0, 2.0]);
        self.drawing.put(Form::Line { points: vec![[x, y - half], [x, y + half]], stroke }, Some(self.event));
    }

    /// What may be written at an end of a bar, what is read most easily first.
    fn edge_names(&self, edge: &Edge, heights: [f64; 2], outward: Anchor) -> Vec<Text> {
        let x = self.axis.at(edge.t);
        let doubtful = edge.certificate == Certificate::Undecidable;
        let turned = match (doubtful, edge.flipped) {
            (true, _) => ", undecidable",
            (false, true) => ", turned round",
            (false, false) => "",
        };
        let long = format!("{}  {} of {}{turned}", brief(edge.t), edge.part, edge.name);
        let middling = format!("{}  {}", brief(edge.t), edge.name);
        let mut places = Vec::new();
        for name in [long, middling, brief(edge.t)] {
            let label = Label::new(name, SMALL, self.palette.ink);
            for y in heights {
                for anchor in [outward, Anchor::Middle, Anchor::Start, Anchor::End] {
                    let aside = match anchor {
                        Anchor::Start => ASIDE,
                        Anchor::Middle => 0.0,
                        Anchor::End => -ASIDE,
                    };
                    places.push(label.at([x + aside, y], anchor, Some(self.palette.ground)));
                }
            }
        }
        places.retain(|text| text.frame().low[0] >= self.axis.points[0] - 6.0);
        places
    }

    /// The first of the names that is clear of all lines and leaves those to come a clear place too; a shorter one is read
    /// more easily than a long one across a line. Where there is none, one across a line.
    fn edge_name(&self, places: &[Text], next: &[Vec<Text>]) -> Option<Text> {
        let is_clear = |text: &&Text| is_clear(&self.placer, text);
        let leaves_room = |text: &&Text| {
            let mut placer = self.placer.clone();
            placer.reserve(text.frame());
            next.iter().all(|places| {
                let place = places.iter().find(|text| self::is_clear(&placer, text)).map(Text::frame);
                place.map(|place| placer.reserve(place)).is_some()
            })
        };
        let mut clear = places.iter().filter(is_clear);
        let first = clear.clone().next();
        let across = || places.iter().find(|text| self.placer.is_free(&beside(text)));
        clear.find(leaves_room).or(first).or_else(across).cloned()
    }
}

/// A text with what keeps it apart from the next.
fn beside(text: &Text) -> Frame {
    let Frame { low, high } = text.frame();
    Frame { low: [low[0] - BETWEEN, low[1]], high: [high[0] + BETWEEN, high[1]] }
}

/// Whether a name lies on no other and on none of the upright lines.
fn is_clear(placer: &Placer, text: &Text) -> bool {
    placer.is_free(&beside(text)) && placer.is_clear(&text.frame().grown(1.0))
}
