//! A drawing within another.

use super::drawing::{Drawing, Form, Frame, Mark, Spot, Text};

impl Drawing {
    /// Adds all that another drawing shows, with its left top corner at `at`, on its own ground.
    pub fn include(&mut self, other: &Self, at: Spot) {
        let ground = Form::Rect { frame: other.frame(), fill: Some(other.background), stroke: None };
        self.put(moved(&ground, at), None);
        self.marks.extend(other.marks.iter().map(|mark| Mark { form: moved(&mark.form, at), event: mark.event }));
    }
}

fn moved(form: &Form, by: Spot) -> Form {
    let spot = |at: &Spot| [at[0] + by[0], at[1] + by[1]];
    let spots = |points: &[Spot]| points.iter().map(spot).collect();
    match form {
        Form::Line { points, stroke } => Form::Line { points: spots(points), stroke: *stroke },
        Form::Area { rings, fill } => Form::Area { rings: rings.iter().map(|ring| spots(ring)).collect(), fill: *fill },
        Form::Circle { centre, radius, fill, stroke } => {
            Form::Circle { centre: spot(centre), radius: *radius, fill: *fill, stroke: *stroke }
        }
        Form::Arc { centre, radius, angles, stroke } => {
            Form::Arc { centre: spot(centre), radius: *radius, angles: *angles, stroke: *stroke }
        }
        Form::Arrow { from, to, head, stroke } => {
            Form::Arrow { from: spot(from), to: spot(to), head: *head, stroke: *stroke }
        }
        Form::Rect { frame, fill, stroke } => {
            let frame = Frame { low: spot(&frame.low), high: spot(&frame.high) };
            Form::Rect { frame, fill: *fill, stroke: *stroke }
        }
        Form::Text(text) => Form::Text(Text { at: spot(&text.at), ..text.clone() }),
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
}
