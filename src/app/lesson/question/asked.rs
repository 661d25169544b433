//! A question that is asked: what is being answered, what was said about it, what is kept of it.

use super::Seen;
use super::number::number;
use crate::lesson::question::{Form, offered_lists};
use crate::lesson::{Answer, Posed, Record, Verdict};
use crate::record::format_number;

/// A question with its answer so far.
pub struct Asked {
    /// Its number in the lesson, counted from 0.
    pub number: usize,
    /// The question.
    pub posed: Posed,
    /// What is being answered.
    pub draft: Draft,
    /// What was said about the last answer.
    pub verdict: Option<Verdict>,
    /// Why the answer cannot be judged.
    pub problem: Option<String>,
    /// What is kept of it.
    pub record: Record,
    /// What was said just now and is not brought into sight yet.
    pub news: Option<News>,
}

/// Something that is said about a question.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum News {
    /// One hint more.
    Hint,
    /// What came of an answer.
    Outcome,
}

/// An answer that is not given yet.
#[derive(Clone, Debug, PartialEq)]
pub enum Draft {
    /// What was typed.
    Number(String),
    /// The choice, by its place.
    Choice(Option<usize>),
    /// The things in their order.
    Order(Vec<usize>),
    /// A place that was clicked, in the coordinates of the click; whether the next click answers.
    Place {
        /// Whether the next click answers.
        is_armed: bool,
        /// Where it was clicked last.
        at: Option<[f64; 2]>,
    },
    /// The interval list, by its place among those that are offered.
    Intervals(Option<usize>),
    /// What is answered elsewhere: on the sign plot, in the scene.
    Elsewhere,
}

impl Asked {
    /// A question as it was left.
    #[must_use]
    pub fn new(number: usize, posed: Posed, record: Record) -> Self {
        let draft = draft_of(&posed.form, record.last.as_ref());
        let verdict =
            record.last.as_ref().map(|last| posed.judge(last)).filter(|verdict| verdict.is_right || !record.solved);
        let mut asked = Self { number, posed, draft, verdict, problem: None, record, news: None };
        if asked.is_told() {
            asked.verdict = None;
            asked.draft = asked.right();
        }
        asked
    }

    /// Whether nothing more is asked: it was answered rightly, or the answer was shown.
    #[must_use]
    pub const fn is_done(&self) -> bool {
        self.record.solved || self.record.revealed
    }

    /// Whether there is an answer to be judged.
    #[must_use]
    pub fn is_complete(&self, seen: &Seen) -> bool {
        match (&self.posed.form, &self.draft) {
            (_, Draft::Number(typed)) => !typed.trim().is_empty(),
            (_, Draft::Choice(chosen) | Draft::Intervals(chosen)) => chosen.is_some(),
            (Form::Time(_), _) => seen.probe_t.is_some(),
            (_, Draft::Order(_)) | (Form::Edit(_), _) => true,
            (_, Draft::Place { .. } | Draft::Elsewhere) => false,
        }
    }

    /// The answer, where it is one that can be written down.
    ///
    /// # Errors
    /// Why what was typed is none.
    pub fn answer(&self, seen: &Seen) -> Result<Option<Answer>, String> {
        Ok(match (&self.posed.form, &self.draft) {
            (Form::Number(reckoned), Draft::Number(typed)) => Some(Answer::Number(number(typed, &reckoned.unit)?)),
            (_, Draft::Choice(chosen)) => chosen.map(Answer::Choice),
            (_, Draft::Order(order)) => Some(Answer::Order(order.clone())),
            (Form::Intervals(reckoned), Draft::Intervals(chosen)) => chosen
                .and_then(|place| offered_lists(reckoned).get(place).map(|list| Answer::Intervals((*list).clone()))),
            (Form::Time(_), _) => seen.probe_t.map(Answer::Number),
            _ => None,
        })
    }

    /// Shows an answer as if it had been given by hand.
    pub fn fill_in(&mut self, answer: &Answer) {
        self.draft = draft_of(&self.posed.form, Some(answer));
    }

    /// Notes what came of an answer.
    pub fn take(&mut self, verdict: Verdict, answer: Option<Answer>) {
        let record = &mut self.record;
        record.tries += 1;
        record.solved |= verdict.is_right;
        if let Some(which) = verdict.misconception.filter(|which| !record.misconceptions.contains(which)) {
            record.misconceptions.push(which);
        }
        record.last = answer;
        self.problem = None;
        self.say(verdict);
    }

    /// Says something about an answer that is still being worked on; it counts for nothing.
    pub fn say(&mut self, verdict: Verdict) {
        self.verdict = Some(verdict);
        self.news = Some(News::Outcome);
    }

    /// Says why an answer cannot be judged.
    pub fn refuse(&mut self, problem: String) {
        self.problem = Some(problem);
        self.news = Some(News::Outcome);
    }

    /// Shows one hint more.
    pub fn hint(&mut self) {
        self.record.hints = (self.record.hints + 1).min(self.posed.hints.len());
        self.news = Some(News::Hint);
    }

    /// Whether what is shown is the answer as the lesson gives it, not one that was found.
    #[must_use]
    pub const fn is_told(&self) -> bool {
        self.record.revealed && !self.record.solved
    }

    /// Puts the right answer in.
    pub fn reveal(&mut self) {
        self.record.revealed |= !self.record.solved;
        self.draft = self.right();
        self.problem = None;
        self.news = Some(News::Outcome);
        self.verdict = match &self.draft {
            Draft::Choice(Some(right)) => Some(self.posed.judge(&Answer::Choice(*right))),
            _ => None,
        };
    }

    fn right(&self) -> Draft {
        match &self.posed.form {
            Form::Number(reckoned) => Draft::Number(format_number(reckoned.answer)),
            Form::Choice(choices) => Draft::Choice(choices.iter().position(|choice| choice.is_right)),
            Form::Order { right, .. } => Draft::Order(right.clone()),
            Form::Intervals(reckoned) => {
                Draft::Intervals(offered_lists(reckoned).iter().position(|list| **list == reckoned.answer))
            }
            Form::Place(..) => Draft::Place { is_armed: false, at: None },
            Form::Time(_) | Form::Edit(_) => Draft::Elsewhere,
        }
    }
}

fn draft_of(form: &Form, last: Option<&Answer>) -> Draft {
    match (form, last) {
        (Form::Number(_), Some(Answer::Number(number))) => Draft::Number(format_number(*number)),
        (Form::Number(_), _) => Draft::Number(String::new()),
        (Form::Choice(choices), Some(Answer::Choice(place))) => {
            Draft::Choice(Some(*place).filter(|place| *place < choices.len()))
        }
        (Form::Choice(_), _) => Draft::Choice(None),
        (Form::Order { items, .. }, Some(Answer::Order(order))) if order.len() == items.len() => {
            Draft::Order(order.clone())
        }
        (Form::Order { offered, .. }, _) => Draft::Order(offered.clone()),
        (Form::Intervals(reckoned), Some(Answer::Intervals(list))) => {
            Draft::Intervals(offered_lists(reckoned).iter().position(|other| *other == list))
        }
        (Form::Intervals(_), _) => Draft::Intervals(None),
        (Form::Place(..), _) => Draft::Place { is_armed: false, at: None },
        (Form::Time(_) | Form::Edit(_), _) => Draft::Elsewhere,
    }
}
