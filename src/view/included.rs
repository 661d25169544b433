//! A drawing within another.

use super::drawing::{Drawing, Form, Frame, Mark, Spot, Stroke, Text};
use super::labels::clip;

impl Drawing {
    /// Adds all that another drawing shows, with its left top corner at `at`, on its own ground. What lies beyond its edges stays
    /// hidden: areas and lines are cut off there.
    pub fn include(&mut self, other: &Self, at: Spot) {
        self.include_scaled(other, at, 1.0);
    }

    /// The same with the other drawing so many times as large.
    pub fn include_scaled(&mut self, other: &Self, at: Spot, scale: f64) {
        let frame = other.frame();
        let ground = Form::Rect { frame, fill: Some(other.background), stroke: None };
        self.put(placed(&ground, at, scale), None);
        for mark in &other.marks {
            let seen = cut(&mark.form, &frame).into_iter();
            self.marks.extend(seen.map(|form| Mark { form: placed(&form, at, scale), event: mark.event }));
        }
    }
}

/// What is seen of a mark through a window. Circles, arcs and texts are small and are kept as they are.
fn cut(form: &Form, frame: &Frame) -> Vec<Form> {
    match form {
        Form::Line { points, .. } if points.iter().all(|&at| frame.contains(at)) => vec![form.clone()],
        Form::Line { points, stroke } => {
            pieces(points, frame).into_iter().map(|points| Form::Line { points, stroke: *stroke }).collect()
        }
        Form::Area { rings, fill } => {
            let rings: Vec<Vec<Spot>> =
                rings.iter().map(|ring| cut_ring(ring, frame)).filter(|ring| ring.len() > 2).collect();
            let is_seen = !rings.is_empty();
            is_seen.then_some(Form::Area { rings, fill: *fill }).into_iter().collect()
        }
        Form::Arrow { from, to, head, stroke } => match clip(frame, [*from, *to]) {
            Some([start, end]) if end == *to => {
                vec![Form::Arrow { from: start, to: end, head: *head, stroke: *stroke }]
            }
            Some(ends) => vec![Form::Line { points: ends.to_vec(), stroke: *stroke }],
            None => Vec::new(),
        },
        _ => vec![form.clone()],
    }
}

/// The parts of a polyline within the window, each as long as it stays inside.
fn pieces(points: &[Spot], frame: &Frame) -> Vec<Vec<Spot>> {
    let mut pieces: Vec<Vec<Spot>> = Vec::new();
    for ends in points.windows(2) {
        let Some([from, to]) = clip(frame, [ends[0], ends[1]]) else { continue };
        match pieces.last_mut() {
            Some(piece) if piece.last() == Some(&from) => piece.push(to),
            _ => pieces.push(vec![from, to]),
        }
    }
    pieces
}

/// The ring cut along the four edges one after the other (Sutherland and Hodgman 1974). Where it left the window, what comes back
/// runs along the edge, which an area filled by even and odd does not show.
fn cut_ring(ring: &[Spot], frame: &Frame) -> Vec<Spot> {
    let mut ring = ring.to_vec();
    let edges = [(0, frame.low[0], 1.0), (0, frame.high[0], -1.0), (1, frame.low[1], 1.0), (1, frame.high[1], -1.0)];
    for (axis, bound, sign) in edges {
        let inside = |at: &Spot| sign * (at[axis] - bound) >= 0.0;
        let mut kept = Vec::with_capacity(ring.len() + 4);
        for (i, to) in ring.iter().enumerate() {
            let from = &ring[(i + ring.len() - 1) % ring.len()];
            if inside(from) != inside(to) {
                let share = (bound - from[axis]) / (to[axis] - from[axis]);
                let mut edge: Spot = std::array::from_fn(|k| from[k] + share * (to[k] - from[k]));
                edge[axis] = bound;
                kept.push(edge);
            }
            if inside(to) {
                kept.push(*to);
            }
        }
        ring = kept;
    }
    ring
}

/// A mark so many times as large, with the corner of its drawing at `at`.
fn placed(form: &Form, at: Spot, scale: f64) -> Form {
    let spot = |spot: &Spot| [at[0] + spot[0] * scale, at[1] + spot[1] * scale];
    let spots = |points: &[Spot]| points.iter().map(spot).collect();
    let line = |stroke: &Stroke| Stroke {
        colour: stroke.colour,
        width: stroke.width * scale,
        dash: stroke.dash.map(|dash| dash.map(|length| length * scale)),
    };
    match form {
        Form::Line { points, stroke } => Form::Line { points: spots(points), stroke: line(stroke) },
        Form::Area { rings, fill } => Form::Area { rings: rings.iter().map(|ring| spots(ring)).collect(), fill: *fill },
        Form::Circle { centre, radius, fill, stroke } => {
            let stroke = stroke.as_ref().map(line);
            Form::Circle { centre: spot(centre), radius: radius * scale, fill: *fill, stroke }
        }
        Form::Arc { centre, radius, angles, stroke } => {
            Form::Arc { centre: spot(centre), radius: radius * scale, angles: *angles, stroke: line(stroke) }
        }
        Form::Arrow { from, to, head, stroke } => {
            Form::Arrow { from: spot(from), to: spot(to), head: head * scale, stroke: line(stroke) }
        }
        Form::Rect { frame, fill, stroke } => {
            let frame = Frame { low: spot(&frame.low), high: spot(&frame.high) };
            Form::Rect { frame, fill: *fill, stroke: stroke.as_ref().map(line) }
        }
        Form::Text(text) => Form::Text(Text { at: spot(&text.at), size: text.size * scale, ..text.clone() }),
        Form::Outline { steps, fill } => {
            Form::Outline { steps: steps.iter().map(|step| step.moved(|at| spot(&at))).collect(), fill: *fill }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::view::{Theme, sample};

    #[test]
    fn an_included_drawing_lies_where_it_was_put_and_keeps_its_events() {
        let inner = sample::two_marks();
        let mut outer = Drawing::new([300.0, 300.0], Theme::Light.palette().ground);
        outer.include(&inner, [7.0, 11.0]);
        assert_eq!(outer.marks.len(), inner.marks.len() + 1);
        let Form::Line { points, .. } = &outer.marks[2].form else { panic!("the second mark is a line") };
        assert_eq!(points, &[[7.0, 31.0], [107.0, 31.0]]);
        assert_eq!(outer.marks[2].event, Some(2));
    }

    #[test]
    fn what_lies_beyond_the_edges_of_an_included_drawing_is_cut_off() {
        let palette = Theme::Light.palette();
        let mut inner = Drawing::new([100.0, 80.0], palette.ground);
        let far = vec![[-50.0, -50.0], [150.0, -50.0], [150.0, 40.0], [-50.0, 40.0]];
        inner.put(Form::Area { rings: vec![far.clone()], fill: palette.left }, None);
        inner.put(Form::Line { points: far, stroke: crate::view::Stroke::solid(palette.ink, 1.0) }, None);
        let mut outer = Drawing::new([300.0, 300.0], palette.ground);
        outer.include(&inner, [10.0, 20.0]);
        let Form::Area { rings, .. } = &outer.marks[1].form else { panic!("the area comes first") };
        let corners: Vec<_> = rings[0].iter().map(|at| at.map(f64::round)).collect();
        for corner in [[10.0, 20.0], [110.0, 20.0], [110.0, 60.0], [10.0, 60.0]] {
            assert!(corners.contains(&corner), "{corners:?}");
        }
        assert_eq!(corners.len(), 4);
        let Form::Line { points, .. } = &outer.marks[2].form else { panic!("then the line") };
        assert_eq!(points, &[[110.0, 60.0], [10.0, 60.0]]);
        assert_eq!(outer.marks.len(), 3);
    }

    #[test]
    fn a_drawing_that_is_made_smaller_has_smaller_letters_and_thinner_lines() {
        let inner = sample::two_marks();
        let mut outer = Drawing::new([300.0, 300.0], Theme::Light.palette().ground);
        outer.include_scaled(&inner, [10.0, 10.0], 0.5);
        let Form::Line { points, stroke } = &outer.marks[2].form else { panic!("the second mark is a line") };
        assert_eq!(points, &[[10.0, 20.0], [60.0, 20.0]]);
        let Form::Line { stroke: before, .. } = &inner.marks[1].form else { panic!("it is a line there too") };
        assert!((stroke.width - before.width / 2.0).abs() < 1e-12);
    }
}
