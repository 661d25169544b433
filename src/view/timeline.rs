//! All events of a recorded ray along one line, in the order in which they happened.
//!
//! Rays are brackets, in lanes by their distance from the camera ray; below the brackets bars tell how much happened. What is rare
//! or went wrong has a line of its own for each kind, so that nothing of it is lost where thousands of events share a place.

use super::drawing::{Anchor, Drawing, Form, Frame, Stroke, Text};
use super::fonts::Face;
use super::palette::{Colour, Palette, Theme};
use super::text::count;
use crate::math::portable;
use crate::record::{Certificate, Event, EventId, RayKind, What};
use crate::trace::RayTree;
use std::fmt::Write as _;

/// Sizes in points.
const TEXT: f64 = 10.0;
const MARGIN: f64 = 6.0;
/// Room for the signs at the left.
const HEADS: f64 = 22.0;
/// Height of a line of rare events.
const NOTABLE_LINE: f64 = 11.0;
/// Height of the axis with its numbers.
pub const AXIS: f64 = 18.0;
/// Height of a tick of the axis; its number begins below it.
const TICK: f64 = 3.0;
/// Above everything.
const TOP: f64 = 3.0;
/// Height of the flags of breakpoints.
const FLAGS: f64 = 9.0;
/// Width of a place in a line of rare events: that of a sign.
const SIGN: f64 = 8.0;
/// Width of a bar.
const BAR: f64 = 2.0;
/// A lane is no higher, and no lower: lower ones cannot be told apart, and what is deeper shares the last lane.
const LANE: std::ops::RangeInclusive<f64> = 6.0..=14.0;

/// What has a line of its own, from the rarest. Where there is no room for all, the last go first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Notable {
    Limit,
    Undecidable,
    TotalReflection,
    Overlap,
    EarlyOut,
    Rejected,
}

impl Notable {
    const ALL: [Self; 6] =
        [Self::Limit, Self::Undecidable, Self::TotalReflection, Self::Overlap, Self::EarlyOut, Self::Rejected];

    fn of(what: &What) -> Option<Self> {
        match what {
            What::Limit { .. } => Some(Self::Limit),
            What::Decision { certificate: Certificate::Undecidable, .. } => Some(Self::Undecidable),
            What::Snell { total_internal_reflection: true, .. } => Some(Self::TotalReflection),
            What::Overlap(_) | What::Medium { interpenetration: true, .. } => Some(Self::Overlap),
            What::Combine { early_out: Some(_), .. } => Some(Self::EarlyOut),
            What::Rejected { .. } => Some(Self::Rejected),
            _ => None,
        }
    }

    const fn sign(self) -> &'static str {
        match self {
            Self::Limit => "⊘",
            Self::Undecidable => "?",
            Self::TotalReflection => "∠",
            Self::Overlap => "∩",
            Self::EarlyOut => "⊣",
            Self::Rejected => "✗",
        }
    }

    const fn name(self) -> &'static str {
        match self {
            Self::Limit => "limit met",
            Self::Undecidable => "undecidable decision",
            Self::TotalReflection => "total internal reflection",
            Self::Overlap => "overlap of objects",
            Self::EarlyOut => "early out",
            Self::Rejected => "rejected hit",
        }
    }

    const fn colour(self, palette: &Palette) -> Colour {
        match self {
            Self::Limit | Self::Undecidable | Self::Overlap => palette.bad,
            Self::TotalReflection => palette.refracted,
            Self::EarlyOut | Self::Rejected => palette.faint,
        }
    }
}

/// Where events lie from left to right.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimelineScale {
    left: f64,
    right: f64,
    events: EventId,
}

impl TimelineScale {
    /// The scale of a timeline of this width for so many events.
    #[must_use]
    pub fn new(width: f64, events: EventId) -> Self {
        let left = MARGIN + HEADS;
        Self { left, right: (width - MARGIN).max(left + 1.0), events: events.max(1) }
    }

    /// The middle of an event, in points from the left.
    #[must_use]
    pub fn x(&self, id: EventId) -> f64 {
        self.edge(id) + 0.5 * (self.right - self.left) / f64::from(self.events)
    }

    fn edge(&self, id: EventId) -> f64 {
        self.left + (self.right - self.left) * f64::from(id) / f64::from(self.events)
    }

    /// The event at a place; the first or the last one beyond the ends.
    #[must_use]
    pub fn event(&self, x: f64) -> EventId {
        let share = ((x - self.left) / (self.right - self.left)).clamp(0.0, 1.0);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a share of the number of events")]
        let event = (share * f64::from(self.events)) as EventId;
        event.min(self.events - 1)
    }

    fn slots(&self, width: f64) -> usize {
        self.slot(self.right, width) + 1
    }

    fn slot(&self, x: f64, width: f64) -> usize {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few thousand points at most")]
        let slot = ((x - self.left) / width).max(0.0) as usize;
        slot
    }
}

/// What a timeline is of.
#[derive(Clone, Copy, Debug)]
pub struct Timed<'a> {
    /// The tree.
    pub tree: &'a RayTree,
    /// The end of the events that are told: the room of the others stays empty.
    pub told: EventId,
    /// Where breakpoints stop, ascending.
    pub stops: &'a [EventId],
    /// The event that is marked, if any.
    pub selected: Option<EventId>,
}

/// The timeline of a tree.
#[must_use]
pub fn timeline(timed: Timed, size: [f64; 2], theme: Theme) -> Option<Drawing> {
    let Timed { tree, told, stops, selected } = timed;
    if tree.events.is_empty() {
        return None;
    }
    let palette = theme.palette();
    let drawing = Drawing::new(size, palette.ground);
    let scale = TimelineScale::new(drawing.width, tree.end());
    let (told, stops) = (told.clamp(1, tree.end()), &stops[..stops.partition_point(|&stop| stop < told)]);
    let survey = Survey::of(tree, told, &scale);
    let mut strip = Strip { tree, palette, scale, drawing, top: TOP };
    strip.stops(stops);
    strip.notable(&survey);
    strip.lanes(&survey);
    strip.axis();
    strip.untold(told);
    if let Some(selected) = selected.filter(|&id| id < tree.end()) {
        strip.current(selected);
    }
    strip.drawing.description = describe(tree, &survey, stops.len());
    Some(strip.drawing)
}

/// The height, in points, at which a tree's timeline has all its lines, and lanes as high as they become; more would stay empty.
#[must_use]
pub fn timeline_height(tree: &RayTree, has_stops: bool) -> f64 {
    let (mut notable, mut lanes) = ([false; Notable::ALL.len()], 1);
    for event in &tree.events {
        if let Some(kind) = Notable::of(&event.what) {
            notable[kind as usize] = true;
        }
        if let What::Ray { ray, depth, .. } = &event.what
            && *ray != RayKind::Camera
        {
            lanes = lanes.max(depth.saturating_add(1));
        }
    }
    let lines = notable.iter().filter(|is_there| **is_there).count();
    let flags = if has_stops { FLAGS } else { 0.0 };
    TOP + flags + NOTABLE_LINE * lines as f64 + LANE.end() * f64::from(lanes) + AXIS
}

/// A ray and the events that are its own.
struct Bracket {
    event: EventId,
    end: EventId,
    kind: RayKind,
    lane: usize,
}

/// What one pass over the tree finds.
struct Survey {
    /// The events whose outcome is not told, as they go on behind what is.
    under_way: Vec<EventId>,
    brackets: Vec<Bracket>,
    /// For each notable kind how often it happened, and for each place of its line the first time.
    notable: [(usize, Vec<Option<EventId>>); 6],
    /// For each lane and bar how many events there are.
    bars: Vec<Vec<u32>>,
}

impl Survey {
    fn of(tree: &RayTree, told: EventId, scale: &TimelineScale) -> Self {
        let mut survey = Self {
            under_way: if told < tree.end() { tree.path(told - 1) } else { Vec::new() },
            brackets: vec![Bracket { event: 0, end: told, kind: RayKind::Camera, lane: 0 }],
            notable: std::array::from_fn(|_| (0, vec![None; scale.slots(SIGN)])),
            bars: Vec::new(),
        };
        let mut owners: Vec<u32> = Vec::with_capacity(told as usize);
        for event in &tree.events[..told as usize] {
            let owner = survey.owner(event, &owners);
            owners.push(owner);
            survey.count(event, owner, scale);
        }
        survey
    }

    /// The place of the bracket that the event belongs to. Events come in order, so the latest to belong ends it.
    fn owner(&mut self, event: &Event, owners: &[u32]) -> u32 {
        let above = event.parent.map_or(0, |parent| owners[parent as usize]);
        match &event.what {
            What::Ray { ray, depth, .. } if *ray != RayKind::Camera => {
                let lane = usize::try_from(*depth).unwrap_or(usize::MAX);
                self.brackets.push(Bracket { event: event.id, end: event.id + 1, kind: *ray, lane });
                u32::try_from(self.brackets.len() - 1).unwrap_or(above)
            }
            _ => above,
        }
    }

    fn count(&mut self, event: &Event, owner: u32, scale: &TimelineScale) {
        let x = scale.x(event.id);
        if let Some(kind) = Notable::of(&event.what).filter(|_| !self.under_way.contains(&event.id)) {
            let (count, places) = &mut self.notable[kind as usize];
            *count += 1;
            places[scale.slot(x, SIGN)].get_or_insert(event.id);
        }
        let bracket = &mut self.brackets[owner as usize];
        bracket.end = bracket.end.max(event.id + 1);
        let lane = bracket.lane;
        while self.bars.len() <= lane {
            self.bars.push(vec![0; scale.slots(BAR)]);
        }
        self.bars[lane][scale.slot(x, BAR)] += 1;
    }
}

struct Strip<'a> {
    tree: &'a RayTree,
    palette: &'static Palette,
    scale: TimelineScale,
    drawing: Drawing,
    /// How far down it is filled.
    top: f64,
}

impl Strip<'_> {
    fn text(&mut self, at: [f64; 2], text: impl Into<String>, anchor: Anchor, colour: Colour, event: Option<EventId>) {
        let text = Text { at, text: text.into(), anchor, size: TEXT, colour, face: Face::Sans, halo: None };
        self.drawing.put(Form::Text(text), event);
    }

    /// Breakpoints are flags that hang from the top, one for each place at most.
    fn stops(&mut self, stops: &[EventId]) {
        if stops.is_empty() {
            return;
        }
        let mut last = f64::NEG_INFINITY;
        for &stop in stops {
            let x = self.scale.x(stop);
            if x - last >= SIGN / 2.0 {
                last = x;
                let flag = vec![[x - 3.5, self.top], [x + 3.5, self.top], [x, self.top + 7.0]];
                self.drawing.put(Form::Area { rings: vec![flag], fill: self.palette.bad }, stop);
            }
        }
        self.top += FLAGS;
    }

    /// One line for each kind that there is, as far as there is room beside one lane and the axis.
    fn notable(&mut self, survey: &Survey) {
        let room = self.drawing.height - self.top - AXIS - LANE.start();
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few lines")]
        let lines = (room / NOTABLE_LINE).max(0.0) as usize;
        let present = Notable::ALL.into_iter().filter(|kind| survey.notable[*kind as usize].0 > 0);
        for kind in present.take(lines) {
            let colour = kind.colour(self.palette);
            let baseline = self.top + NOTABLE_LINE / 2.0 + Text::baseline_below_middle(TEXT);
            self.text([MARGIN + HEADS - 6.0, baseline], kind.sign(), Anchor::End, colour, None);
            let middle = self.top + NOTABLE_LINE / 2.0;
            let line = Form::Line {
                points: vec![[self.scale.left, middle], [self.scale.right, middle]],
                stroke: Stroke::solid(self.palette.grid.faded(0.6), 1.0),
            };
            self.drawing.put(line, None);
            for &event in survey.notable[kind as usize].1.iter().flatten() {
                self.text([self.scale.x(event), baseline], kind.sign(), Anchor::Middle, colour, Some(event));
            }
            self.top += NOTABLE_LINE;
        }
    }

    fn lanes(&mut self, survey: &Survey) {
        let room = (self.drawing.height - self.top - AXIS).max(*LANE.start());
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few lanes")]
        let fit = ((room / LANE.start()) as usize).max(1);
        let lanes = survey.bars.len().min(fit);
        let height = (room / lanes as f64).clamp(*LANE.start(), *LANE.end());
        for lane in 0..lanes {
            let top = self.top + height * lane as f64;
            let deepest = lane + 1 == lanes && lanes < survey.bars.len();
            // Numbers of low lanes would lie on each other.
            if height >= TEXT || lane == 0 || lane + 1 == lanes {
                self.head(lane, top + height / 2.0, deepest);
            }
            let sharing = if deepest { &survey.bars[lane..] } else { &survey.bars[lane..=lane] };
            self.bars(sharing, top + height);
        }
        let mut filled = vec![f64::NEG_INFINITY; lanes];
        for bracket in &survey.brackets {
            let lane = bracket.lane.min(lanes - 1);
            self.bracket(bracket, self.top + height * lane as f64 + 1.5, &mut filled[lane], height);
        }
        self.top += height * lanes as f64;
    }

    fn head(&mut self, lane: usize, middle: f64, deepest: bool) {
        let name = if deepest { format!("{lane}+") } else { lane.to_string() };
        let baseline = middle + Text::baseline_below_middle(TEXT - 1.0);
        let at = [MARGIN + HEADS - 6.0, baseline];
        let (size, colour, face) = (TEXT - 1.0, self.palette.faint, Face::Sans);
        let text = Text { at, text: name, anchor: Anchor::End, size, colour, face, halo: None };
        self.drawing.put(Form::Text(text), None);
    }

    /// How much happened, from nothing to the height of half a lane, by the logarithm: one event is still seen beside a thousand.
    fn bars(&mut self, sharing: &[Vec<u32>], bottom: f64) {
        let fill = self.palette.faint.faded(0.45);
        let counts = (0..self.scale.slots(BAR)).map(|slot| sharing.iter().map(|bars| bars[slot]).sum::<u32>());
        for (slot, count) in counts.enumerate().filter(|(_, count)| *count > 0) {
            let x = self.scale.left + BAR * slot as f64;
            let height = (1.0 + portable::log2(f64::from(count)) * 0.6).min(4.5);
            let frame = Frame { low: [x, bottom - height], high: [(x + BAR * 0.75).min(self.scale.right), bottom] };
            self.drawing.put(Form::Rect { frame, fill: Some(fill), stroke: None }, None);
        }
    }

    /// A line over the ray's events with a tick where it was sent; rays too short to be told apart share one.
    fn bracket(&mut self, ray: &Bracket, y: f64, filled: &mut f64, height: f64) {
        let (from, to) = (self.scale.edge(ray.event), self.scale.edge(ray.end));
        let to = to.max(from + 1.5);
        if to <= *filled + 2.0 {
            return;
        }
        let from = from.max(*filled);
        *filled = to;
        let colour = ray_colour(ray.kind, self.palette);
        let stroke = match ray.kind {
            RayKind::Shadow => Stroke::dashed(colour, 1.5, [3.0, 2.0]),
            _ => Stroke::solid(colour, 1.8),
        };
        let line = Form::Line { points: vec![[from, y], [(to - 0.5).max(from + 0.5), y]], stroke };
        self.drawing.put(line, ray.event);
        if to - from > 5.0 {
            let tick = vec![[from + 0.5, y], [from + 0.5, y + height - 3.0]];
            self.drawing.put(Form::Line { points: tick, stroke: Stroke::solid(colour, 1.2) }, ray.event);
        }
        if to - from > 18.0 && height > 9.5 {
            let baseline = y + height / 2.0 + Text::baseline_below_middle(TEXT - 1.0);
            self.text([from + 4.0, baseline], ray_sign(ray.kind), Anchor::Start, colour, Some(ray.event));
        }
    }

    /// The numbers of the first and the last event, and round ones between.
    fn axis(&mut self) {
        let y = self.top + 1.5;
        let ink = self.palette.faint;
        let ends = vec![[self.scale.left, y], [self.scale.right, y]];
        self.drawing.put(Form::Line { points: ends, stroke: Stroke::solid(self.palette.grid, 1.0) }, None);
        let baseline = y + TICK + 1.5 + 0.72 * TEXT;
        let (events, mut free) = (self.tree.end(), self.scale.left);
        let step = round_step(events, (self.scale.right - self.scale.left) / 70.0);
        let numbers = std::iter::once(1).chain((1..).map(|k| k * step).take_while(|&n| n < events));
        for number in numbers.chain([events]) {
            let x = self.scale.x(number - 1);
            let tick = vec![[x, y], [x, y + TICK]];
            let half = 3.0 * number.to_string().len() as f64;
            let middle = x.max(self.scale.left + half).min((self.scale.right - half).max(self.scale.left + half));
            // The last number has its place reserved.
            let limit = if number == events { f64::INFINITY } else { self.scale.right - 6.0 * half };
            if middle - half >= free && middle + half <= limit {
                self.drawing.put(Form::Line { points: tick, stroke: Stroke::solid(ink, 1.0) }, None);
                self.text([middle, baseline], number.to_string(), Anchor::Middle, ink, None);
                free = middle + half + 8.0;
            }
        }
    }

    /// A band over what is not told.
    fn untold(&mut self, told: EventId) {
        if told < self.tree.end() {
            let frame = Frame { low: [self.scale.edge(told), 0.0], high: [self.scale.right, self.top] };
            let fill = Some(self.palette.grid.faded(0.6));
            self.drawing.put(Form::Rect { frame, fill, stroke: None }, None);
        }
    }

    fn current(&mut self, id: EventId) {
        let x = self.scale.x(id);
        let ends = vec![[x, 0.0], [x, self.top + 4.0]];
        self.drawing.put(Form::Line { points: ends, stroke: Stroke::solid(self.palette.ink, 1.5) }, id);
    }
}

/// The smallest of 1, 2, 5, 10, … of which at most `most` fit.
fn round_step(events: EventId, most: f64) -> EventId {
    let steps = (0..9).flat_map(|k| [1, 2, 5].map(|digit| digit * 10_u32.pow(k)));
    let mut enough = steps.filter(|&step| f64::from(events) / f64::from(step) <= most.max(1.0));
    enough.next().unwrap_or(EventId::MAX)
}

const fn ray_colour(kind: RayKind, palette: &Palette) -> Colour {
    match kind {
        RayKind::Camera => palette.camera,
        RayKind::Reflected => palette.reflected,
        RayKind::Refracted => palette.refracted,
        RayKind::Shadow => palette.shadow,
        RayKind::Scattered => palette.scattered,
    }
}

/// The sign that the ray's row has.
const fn ray_sign(kind: RayKind) -> &'static str {
    match kind {
        RayKind::Camera => "→",
        RayKind::Reflected => "↗",
        RayKind::Refracted => "↘",
        RayKind::Shadow => "⇢",
        RayKind::Scattered => "↝",
    }
}

fn describe(tree: &RayTree, survey: &Survey, stops: usize) -> String {
    let rays = |kind| survey.brackets.iter().filter(|ray| ray.kind == kind).count();
    let kinds = RayKind::ALL.map(|kind| (kind, rays(kind)));
    let kinds: Vec<_> = kinds
        .into_iter()
        .filter(|(_, rays)| *rays > 0)
        .map(|(kind, rays)| count(rays, &format!("{} ray", kind.name())))
        .collect();
    let notable: Vec<_> = Notable::ALL
        .into_iter()
        .map(|kind| (kind.name(), &survey.notable[kind as usize]))
        .filter(|(_, (count, _))| *count > 0)
        .map(|(name, (times, places))| {
            let first = places.iter().flatten().next().map_or(0, |id| id + 1);
            format!("{name}: {times}, first at {first}")
        })
        .collect();
    let deepest = survey.bars.len().saturating_sub(1);
    let mut text = format!(
        "Timeline of {}: {}, at most {deepest} away from the camera ray.",
        count(tree.events.len(), "event"),
        kinds.join(", ")
    );
    if !notable.is_empty() {
        let _ = write!(text, " {}.", notable.join("; "));
    }
    if stops > 0 {
        let _ = write!(text, " Breakpoints stop at {}.", count(stops, "event"));
    }
    text
}

#[cfg(test)]
#[path = "timeline_tests.rs"]
mod tests;
