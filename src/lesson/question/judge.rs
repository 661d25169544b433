//! Answers, judged.

use super::pose::{Form, Posed, Reckoned, Spot, Stretch};
use crate::lesson::expression::ExpressionError;
use crate::lesson::prose::{Prose, Told};
use crate::lesson::stage::Stage;
use crate::math::portable;
use serde::{Deserialize, Serialize};

/// What a student answers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Answer {
    /// A number, or a time.
    Number(f64),
    /// The number of a choice, counted from 0.
    Choice(usize),
    /// The numbers of the items, counted from 0, in the order that they were put in.
    Order(Vec<usize>),
    /// The interval list that was picked, as times; a missing end is unbounded.
    Intervals(Vec<Stretch>),
}

/// What comes of an answer.
#[derive(Clone, Debug, PartialEq)]
pub struct Verdict {
    /// Whether it is right.
    pub is_right: bool,
    /// The wrong answer that was expected and given, counted from 0; of a choice, the choice.
    pub misconception: Option<usize>,
    /// What is said about it; of a right answer, why it is.
    pub feedback: Option<Prose<Told>>,
}

impl Verdict {
    fn right(feedback: Option<&Prose<Told>>) -> Self {
        Self { is_right: true, misconception: None, feedback: feedback.cloned() }
    }

    fn wrong(which: Option<(usize, &Prose<Told>)>) -> Self {
        Self {
            is_right: false,
            misconception: which.map(|(place, _)| place),
            feedback: which.map(|(_, because)| because.clone()),
        }
    }
}

impl Posed {
    /// Judges an answer. Of a kind that the question does not ask for, it is wrong. Clicks and edited scenes are judged by
    /// [`Self::judge_click`] and [`Self::judge_edit`].
    #[must_use]
    pub fn judge(&self, answer: &Answer) -> Verdict {
        match (&self.form, answer) {
            (Form::Number(reckoned) | Form::Time(reckoned), Answer::Number(number)) => {
                self.reckoned(reckoned, |value| (value - number).abs())
            }
            (Form::Intervals(reckoned), Answer::Intervals(list)) => {
                self.reckoned(reckoned, |value| if value == list { 0.0 } else { f64::INFINITY })
            }
            (Form::Choice(choices), Answer::Choice(place)) => match choices.get(*place) {
                Some(choice) if choice.is_right => Verdict::right(Some(&choice.because)),
                Some(choice) => Verdict::wrong(Some((*place, &choice.because))),
                None => Verdict::wrong(None),
            },
            (Form::Order { right, wrong, .. }, Answer::Order(order)) => {
                if order == right {
                    return Verdict::right(self.explain.as_ref());
                }
                let expected = wrong.iter().enumerate().find(|(_, (known, _))| known == order);
                Verdict::wrong(expected.map(|(place, (_, because))| (place, because)))
            }
            _ => Verdict::wrong(None),
        }
    }

    /// Judges a click; `project` says where a place lies, in the coordinates of the click. Of several places that it may mean, the nearest
    /// is meant.
    #[must_use]
    pub fn judge_click(&self, click: [f64; 2], project: impl Fn(&Spot) -> Option<[f64; 2]>) -> Verdict {
        let Form::Place(_, reckoned) = &self.form else { return Verdict::wrong(None) };
        let distance =
            |spot: &Spot| project(spot).map_or(f64::INFINITY, |[x, y]| portable::hypot(x - click[0], y - click[1]));
        self.reckoned(reckoned, distance)
    }

    /// Judges an edited scene by its stage.
    ///
    /// # Errors
    /// If what is asked has no value there.
    pub fn judge_edit(&self, edited: &Stage) -> Result<Verdict, ExpressionError> {
        let Form::Edit(posed) = &self.form else { return Ok(Verdict::wrong(None)) };
        if edited.fulfils(&posed.edit.until.value)? {
            return Ok(Verdict::right(self.explain.as_ref()));
        }
        for (place, wrong) in posed.edit.wrong.iter().enumerate() {
            if edited.fulfils(&wrong.when.value).unwrap_or(false) {
                return Ok(Verdict::wrong(posed.because.get(place).map(|because| (place, because))));
            }
        }
        Ok(Verdict::wrong(None))
    }

    /// The nearest of the right answer and the expected wrong ones decides, where it is near enough.
    fn reckoned<T>(&self, reckoned: &Reckoned<T>, distance: impl Fn(&T) -> f64) -> Verdict {
        let to_answer = distance(&reckoned.answer);
        let distances = reckoned.wrong.iter().map(|(value, _)| distance(value)).enumerate();
        let nearest = distances.filter(|(_, far)| *far <= reckoned.tolerance).min_by(|a, b| a.1.total_cmp(&b.1));
        match nearest {
            Some((place, far)) if far < to_answer => Verdict::wrong(Some((place, &reckoned.wrong[place].1))),
            _ if to_answer <= reckoned.tolerance => Verdict::right(self.explain.as_ref()),
            _ => Verdict::wrong(None),
        }
    }
}
