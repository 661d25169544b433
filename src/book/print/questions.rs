//! Questions on paper, and their answers at the end.

use super::flow::{Flow, Look};
use super::line::{glued, glued_words};
use crate::book::questions::{kind_in_words, letter, spot, with_unit};
use crate::lesson::prose::{Block, Inline};
use crate::lesson::question::{Form, PosedEdit, Reckoned};
use crate::lesson::question::{list_text, offered_lists};
use crate::lesson::{Posed, Told};

/// How far what belongs to a question stands from the text.
const INDENT: f64 = 16.0;

impl Flow {
    /// A question with what there is to choose from.
    pub fn question(&mut self, number: &str, posed: &Posed) {
        self.gap(4.0);
        self.keep(60.0);
        self.words(&format!("Question {number}: {}", kind_in_words(&posed.form)), Look::LABEL);
        self.prose(&posed.ask, 0.0);
        match &posed.form {
            Form::Choice(choices) => {
                for (place, choice) in choices.iter().enumerate() {
                    self.signed(&format!("({})", letter(place)), glued(&choice.text, Look::TEXT), INDENT);
                }
            }
            Form::Order { items, offered, .. } => {
                for &place in offered {
                    self.signed("□", glued(&items[place], Look::TEXT), INDENT);
                }
            }
            Form::Intervals(reckoned) => {
                for (place, list) in offered_lists(reckoned).into_iter().enumerate() {
                    self.signed(&format!("({})", letter(place)), glued_words(&list_text(list), Look::TEXT), INDENT);
                }
            }
            Form::Number(_) | Form::Place(..) | Form::Time(_) | Form::Edit(_) => {}
        }
        self.gap(6.0);
    }

    /// The answer, hints, and what wrong answers come from.
    pub fn answer(&mut self, number: &str, posed: &Posed) {
        self.gap(4.0);
        self.keep(60.0);
        self.words(&format!("Question {number}"), Look::LABEL);
        for hint in &posed.hints {
            self.lines(glued_words("Hint", Look::SMALL), INDENT, Look { after: 0.0, ..Look::SMALL });
            self.prose(hint, INDENT);
        }
        self.right_and_wrong(&posed.form);
        if let Some(explain) = &posed.explain {
            self.prose(explain, INDENT);
        }
    }

    fn right_and_wrong(&mut self, form: &Form) {
        match form {
            Form::Number(reckoned) | Form::Time(reckoned) => {
                self.reckoned(reckoned, |value| with_unit(reckoned, *value));
            }
            Form::Place(_, reckoned) => self.reckoned(reckoned, spot),
            Form::Intervals(reckoned) => self.reckoned(reckoned, |list| list_text(list)),
            Form::Choice(choices) => {
                for (place, choice) in choices.iter().enumerate() {
                    let said = if choice.is_right { "right" } else { "wrong" };
                    self.wrong(&format!("({}) {said}", letter(place)), &choice.because);
                }
            }
            Form::Order { items, right, wrong, .. } => {
                self.order("Right: ", items, right);
                for (order, because) in wrong {
                    self.order("Wrong: ", items, order);
                    self.prose(because, 2.0 * INDENT);
                }
            }
            Form::Edit(posed) => self.changes(posed),
        }
    }

    fn reckoned<T>(&mut self, reckoned: &Reckoned<T>, written: impl Fn(&T) -> String) {
        self.right(&written(&reckoned.answer));
        for (value, because) in &reckoned.wrong {
            self.wrong(&format!("Wrong: {}", written(value)), because);
        }
    }

    fn right(&mut self, answer: &str) {
        self.lines(glued_words(&format!("Right: {answer}"), Look::LABEL), INDENT, Look::LABEL);
    }

    fn wrong(&mut self, answer: &str, because: &[Block<Told>]) {
        self.lines(glued_words(answer, Look::TEXT), INDENT, Look { after: 0.0, ..Look::TEXT });
        self.prose(because, 2.0 * INDENT);
    }

    fn order(&mut self, said: &str, items: &[Vec<Inline<Told>>], order: &[usize]) {
        let mut line = vec![Inline::Text(said.to_owned())];
        for (place, item) in order.iter().filter_map(|&place| items.get(place)).enumerate() {
            if place > 0 {
                line.push(Inline::Text(" → ".to_owned()));
            }
            line.extend(item.iter().cloned());
        }
        self.lines(glued(&line, Look::TEXT), INDENT, Look::TEXT);
    }

    fn changes(&mut self, posed: &PosedEdit) {
        for change in &posed.edit.solution {
            self.right(&format!("{} = {}", change.at, change.to));
        }
        for (wrong, because) in posed.edit.wrong.iter().zip(&posed.because) {
            for change in &wrong.change {
                self.wrong(&format!("Wrong: {} = {}", change.at, change.to), because);
            }
        }
    }
}
