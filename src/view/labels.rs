//! Where labels go, so that none covers another and none is cut off.

use super::drawing::{Anchor, Drawing, Form, Frame, Spot, Stroke, Text, length};
use super::fonts::Face;
use super::palette::{Colour, Palette};
use crate::record::EventId;

/// What a label says and looks like, before it has a place.
#[derive(Clone, Debug)]
pub struct Label {
    /// The text.
    pub text: String,
    /// Its size in points.
    pub size: f64,
    /// Its colour.
    pub colour: Colour,
    /// Its look.
    pub face: Face,
    /// The event that it stands for.
    pub event: Option<EventId>,
}

impl Label {
    /// A label in running text.
    pub fn new(text: impl Into<String>, size: f64, colour: Colour) -> Self {
        Self { text: text.into(), size, colour, face: Face::Sans, event: None }
    }

    /// The same label, standing for an event.
    pub fn of(mut self, event: EventId) -> Self {
        self.event = Some(event);
        self
    }

    /// The same label in another look.
    pub fn face(mut self, face: Face) -> Self {
        self.face = face;
        self
    }

    /// The text at a place, with its box's middle at the height of `at`.
    pub fn at(&self, at: Spot, anchor: Anchor, halo: Option<Colour>) -> Text {
        Text {
            at: [at[0], at[1] + Text::baseline_below_middle(self.size)],
            text: self.text.clone(),
            anchor,
            size: self.size,
            colour: self.colour,
            face: self.face,
            halo,
        }
    }
}

/// Knows what is taken.
#[derive(Clone, Debug)]
pub struct Placer {
    canvas: Frame,
    taken: Vec<Frame>,
    lines: Vec<[Spot; 2]>,
    outlines: Vec<[Spot; 2]>,
    spots: Vec<Frame>,
}

/// Directions in the order in which they are tried, with a unit offset and the anchor that turns the text outwards.
const DIRECTIONS: [(Spot, Anchor); 8] = [
    ([0.8, -0.75], Anchor::Start),
    ([0.8, 0.75], Anchor::Start),
    ([-0.8, -0.75], Anchor::End),
    ([-0.8, 0.75], Anchor::End),
    ([0.0, -1.1], Anchor::Middle),
    ([0.0, 1.1], Anchor::Middle),
    ([1.0, 0.0], Anchor::Start),
    ([-1.0, 0.0], Anchor::End),
];

/// Distances from the place that is labelled, in points, and what they cost. Farther than the last, a label no longer
/// seems to belong.
const DISTANCES: [(f64, f64); 5] = [(0.0, 0.0), (9.0, 4.0), (20.0, 8.0), (34.0, 12.0), (52.0, 16.0)];

impl Placer {
    /// A placer that keeps labels within `canvas`.
    pub const fn new(canvas: Frame) -> Self {
        Self { canvas, taken: Vec::new(), lines: Vec::new(), outlines: Vec::new(), spots: Vec::new() }
    }

    /// Keeps labels out of `frame`.
    pub fn reserve(&mut self, frame: Frame) {
        self.taken.push(frame);
    }

    /// Keeps labels off a line where there is a choice.
    pub fn avoid_line(&mut self, from: Spot, to: Spot) {
        self.lines.push([from, to]);
    }

    /// Keeps labels off an outline where that costs nothing else.
    pub fn avoid_outline(&mut self, points: &[Spot]) {
        self.outlines.extend(points.windows(2).map(|ends| [ends[0], ends[1]]));
    }

    /// Keeps labels off a closed line where there is a choice.
    pub fn avoid_ring(&mut self, corners: &[Spot]) {
        let next = corners.iter().cycle().skip(1);
        self.lines.extend(corners.iter().zip(next).map(|(corner, next)| [*corner, *next]));
    }

    /// Keeps labels off a spot where there is a choice.
    pub fn avoid_spot(&mut self, at: Spot, radius: f64) {
        self.spots.push(Frame { low: at, high: at }.grown(radius));
    }

    /// Whether nothing lies there yet and it is within the canvas.
    pub fn is_free(&self, frame: &Frame) -> bool {
        self.canvas.holds(frame) && !self.taken.iter().any(|taken| taken.overlaps(frame))
    }

    /// Whether it is free, and off every line, outline and spot.
    pub fn is_clear(&self, frame: &Frame) -> bool {
        self.is_free(frame) && self.cost(frame, &self.outlines) == 0.0
    }

    /// Puts a text that has its place already, if that is free.
    pub fn put_at(&mut self, drawing: &mut Drawing, text: Text, event: Option<EventId>) -> bool {
        let frame = text.frame();
        let free = self.is_free(&frame);
        if free {
            self.reserve(frame);
            drawing.put(Form::Text(text), event);
        }
        free
    }

    /// Puts the label near `around`, `gap` points off, where it covers least; not at all where there is no room.
    pub fn put_near(
        &mut self,
        drawing: &mut Drawing,
        around: Spot,
        gap: f64,
        label: &Label,
        palette: &Palette,
    ) -> bool {
        let Some(text) = self.best_place(around, gap, label, palette.ground) else { return false };
        let frame = text.frame();
        self.reserve(frame.grown(1.0));
        let nearest: Spot = std::array::from_fn(|i| around[i].max(frame.low[i]).min(frame.high[i]));
        let offset = [nearest[0] - around[0], nearest[1] - around[1]];
        if length(offset) > gap + 12.0 {
            let share = gap.max(3.0) / length(offset);
            let start = [around[0] + offset[0] * share, around[1] + offset[1] * share];
            let stroke = Stroke::solid(label.colour.faded(0.6), 0.8);
            drawing.put(Form::Line { points: vec![start, nearest], stroke }, label.event);
        }
        drawing.put(Form::Text(text), label.event);
        true
    }

    fn best_place(&self, around: Spot, gap: f64, label: &Label, halo: Colour) -> Option<Text> {
        let outlines = self.outlines_about(around);
        let mut best: Option<(f64, Text)> = None;
        for (distance, farness) in DISTANCES {
            // Between places that are as good, the first wins.
            for (direction, anchor) in DIRECTIONS {
                let reach = gap + distance;
                let half_height = 0.5 * label.size;
                let at = [
                    around[0] + direction[0] * reach,
                    around[1] + direction[1] * (reach + if direction[0] == 0.0 { half_height } else { 0.0 }),
                ];
                let text = label.at(at, anchor, Some(halo));
                let frame = text.frame();
                if !self.is_free(&frame) {
                    continue;
                }
                let cost = self.cost(&frame, &outlines) + farness;
                if best.as_ref().is_none_or(|(least, _)| cost < *least) {
                    best = Some((cost, text));
                }
            }
        }
        best.map(|(_, text)| text)
    }

    /// The outlines that a label of this spot may come upon.
    fn outlines_about(&self, spot: Spot) -> Vec<[Spot; 2]> {
        /// As far as labels go from what they name, with half their width.
        const REACH: f64 = 130.0;
        /// Among more, no place is better than another.
        const MOST: usize = 600;
        let about = Frame { low: spot, high: spot }.grown(REACH);
        self.outlines.iter().filter(|line| crosses(&about, **line)).take(MOST).copied().collect()
    }

    fn cost(&self, frame: &Frame, outlines: &[[Spot; 2]]) -> f64 {
        let lines = self.lines.iter().filter(|line| crosses(frame, **line)).map(|_| 5.0);
        let spots = self.spots.iter().filter(|spot| spot.overlaps(frame)).map(|_| 9.0);
        let outlines = outlines.iter().filter(|line| crosses(frame, **line)).take(3).map(|_| 1.6);
        lines.chain(spots).chain(outlines).sum()
    }
}

/// Whether the line passes through the frame.
fn crosses(frame: &Frame, line: [Spot; 2]) -> bool {
    let [from, to] = line;
    // Most lines are far off, on one side of the frame: that is seen without a division.
    let is_beside = (0..2).any(|i| from[i].max(to[i]) < frame.low[i] || from[i].min(to[i]) > frame.high[i]);
    !is_beside && clip(frame, line).is_some()
}

/// The part of a line within a frame (Liang and Barsky, 1984).
pub fn clip(frame: &Frame, [from, to]: [Spot; 2]) -> Option<[Spot; 2]> {
    let (mut first, mut last) = (0.0_f64, 1.0_f64);
    for i in 0..2 {
        let along = to[i] - from[i];
        let (mut near, mut far) = (frame.low[i] - from[i], frame.high[i] - from[i]);
        if along == 0.0 {
            if near > 0.0 || far < 0.0 {
                return None;
            }
            continue;
        }
        (near, far) = (near / along, far / along);
        if along < 0.0 {
            (near, far) = (far, near);
        }
        first = first.max(near);
        last = last.min(far);
    }
    let at = |share: f64| std::array::from_fn(|i| from[i] + (to[i] - from[i]) * share);
    (first <= last && first.is_finite() && last.is_finite()).then(|| [at(first), at(last)])
}

/// A text cut with an ellipsis so that it is at most `width` wide.
pub fn shortened(text: &str, width: f64, size: f64, face: Face) -> String {
    use super::fonts::text_width;
    if text_width(text, size, face) <= width {
        return text.to_owned();
    }
    let mut kept: Vec<char> = text.chars().collect();
    while !kept.is_empty() {
        kept.pop();
        let shorter = kept.iter().collect::<String>().trim_end().to_owned() + "…";
        if text_width(&shorter, size, face) <= width {
            return shorter;
        }
    }
    String::new()
}

/// A text in three lines at most, each at most `width` wide.
pub fn wrapped(text: &str, width: f64, size: f64, face: Face) -> Vec<String> {
    use super::fonts::text_width;
    let (mut lines, mut rest) = (Vec::new(), text);
    while lines.len() < 2 && text_width(rest, size, face) > width {
        let breaks = rest.match_indices(' ').map(|(place, _)| place);
        let Some(place) = breaks.take_while(|&place| text_width(&rest[..place], size, face) <= width).last() else {
            break;
        };
        lines.push(rest[..place].to_owned());
        rest = &rest[place + 1..];
    }
    lines.push(shortened(rest, width, size, face));
    lines
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::view::Theme;

    fn canvas() -> Frame {
        Frame { low: [0.0, 0.0], high: [100.0, 100.0] }
    }

    #[test]
    fn labels_of_one_spot_do_not_cover_each_other_and_the_last_finds_no_room() {
        let palette = Theme::Light.palette();
        let mut drawing = Drawing::new([100.0, 100.0], palette.ground);
        let mut placer = Placer::new(canvas());
        let label = Label::new("t = 1.25", 11.0, palette.ink);
        let put = (0..40).filter(|_| placer.put_near(&mut drawing, [50.0, 50.0], 5.0, &label, palette)).count();
        assert!((4..40).contains(&put), "{put}");
        let frames: Vec<_> = drawing.texts().map(Text::frame).collect();
        assert_eq!(frames.len(), put);
        for (i, a) in frames.iter().enumerate() {
            assert!(canvas().holds(a));
            assert!(frames[..i].iter().all(|b| !a.overlaps(b)));
        }
    }

    #[test]
    fn a_label_keeps_off_a_line_where_it_can() {
        let palette = Theme::Light.palette();
        let mut placer = Placer::new(canvas());
        placer.avoid_line([50.0, 50.0], [100.0, 0.0]);
        let label = Label::new("eye", 11.0, palette.ink);
        let text = placer.best_place([50.0, 50.0], 5.0, &label, palette.ground).unwrap();
        assert!(clip(&text.frame(), [[50.0, 50.0], [100.0, 0.0]]).is_none());
    }

    #[test]
    fn a_line_is_clipped_at_the_sides() {
        assert_eq!(clip(&canvas(), [[-50.0, 50.0], [50.0, 50.0]]), Some([[0.0, 50.0], [50.0, 50.0]]));
        assert_eq!(clip(&canvas(), [[50.0, 150.0], [50.0, -50.0]]), Some([[50.0, 100.0], [50.0, 0.0]]));
        assert_eq!(clip(&canvas(), [[-50.0, 150.0], [-50.0, -50.0]]), None);
    }

    #[test]
    fn a_text_that_is_too_wide_ends_in_an_ellipsis() {
        let short = shortened("the quick brown fox", 60.0, 11.0, Face::Sans);
        assert!(short.ends_with('…') && short.starts_with("the"), "{short}");
        assert_eq!(shortened("fox", 60.0, 11.0, Face::Sans), "fox");
        assert_eq!(wrapped("the quick brown fox", 70.0, 11.0, Face::Sans), ["the quick", "brown fox"]);
        let three = wrapped("the quick brown fox jumps over the dog", 90.0, 11.0, Face::Sans);
        assert!(three.len() == 3 && three.concat().ends_with("dog"), "{three:?}");
    }
}
