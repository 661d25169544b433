//! Question blocks: what each kind of question needs.

use super::blocks::{ChoiceFile, KindFile, QuestionFile, RightFile, SurfaceFile, Text};
use super::lesson::Site;
use crate::lesson::expression::Expression;
use crate::lesson::model::{
    Choice, Edit, Quantity, Question, QuestionKind, Right, Sited, Surface, WrongEdit, first_line,
};

impl Site<'_, '_> {
    /// The question that a block holds.
    pub fn question(&mut self, file: &QuestionFile) -> Option<Question> {
        let place = self.place();
        let ask = self.prose(&file.ask);
        let hints = file.hints.iter().map(|hint| self.prose(hint)).collect();
        let explain = file.explain.as_ref().map(|text| self.prose(text));
        let kind = match file.kind {
            KindFile::Number => QuestionKind::Number(self.quantity(file)?),
            KindFile::Time => QuestionKind::Time(self.quantity(file)?),
            KindFile::Intervals => QuestionKind::Intervals(self.quantity(file)?),
            KindFile::Choice => QuestionKind::Choice(self.choices(&file.choice, !file.wrong.is_empty())?),
            KindFile::Order => self.order(file)?,
            KindFile::Place => QuestionKind::Place { surface: self.surface(file)?, quantity: self.quantity(file)? },
            KindFile::Edit => QuestionKind::Edit(self.edit(file)?),
        };
        Some(Question { place, ask, hints, explain, kind })
    }

    fn needed<'a, T>(&mut self, value: Option<&'a T>, name: &str) -> Option<&'a T> {
        if value.is_none() {
            self.add(format!("a question of this kind needs `{name}`"));
        }
        value
    }

    fn quantity(&mut self, file: &QuestionFile) -> Option<Quantity> {
        let answer: &Text = self.needed(file.answer.as_ref(), "answer")?;
        let answer = self.expression(answer)?;
        let mut wrong = Vec::new();
        for expected in &file.wrong {
            let Some(text) = self.needed(expected.answer.as_ref(), "answer") else { continue };
            let because = self.prose(&expected.because);
            wrong.extend(self.expression(text).map(|answer| (answer, because)));
        }
        Some(Quantity {
            answer,
            tolerance: file.tolerance.as_ref().and_then(|text| self.expression(text)),
            unit: file.unit.as_ref().map(|unit| unit.get_ref().clone()).unwrap_or_default(),
            wrong,
        })
    }

    fn choices(&mut self, files: &[ChoiceFile], has_wrong: bool) -> Option<Vec<Choice>> {
        if has_wrong {
            self.add("a choice has no `[[wrong]]`: each wrong `[[choice]]` has its own `because`");
        }
        if files.len() < 2 {
            self.add("a choice needs two `[[choice]]` at least");
            return None;
        }
        let choices = files.iter().map(|file| {
            let right = match &file.right {
                None => Right::Always(false),
                Some(RightFile::Always(is_right)) => Right::Always(*is_right),
                Some(RightFile::If(text)) => match Expression::parse(text) {
                    Ok(expression) => Right::If(Sited::new(expression, self.place_of(&file.text))),
                    Err(error) => {
                        self.add_to(&file.text, format!("`{text}`: {}", error.message));
                        Right::Always(false)
                    }
                },
            };
            let text = first_line(self.prose(&file.text));
            Choice { text, right, because: self.prose(&file.because) }
        });
        Some(choices.collect())
    }

    fn order(&mut self, file: &QuestionFile) -> Option<QuestionKind> {
        if file.item.len() < 2 {
            self.add("an order needs two `[[item]]` at least");
            return None;
        }
        let mut items = Vec::new();
        for item in &file.item {
            let text = first_line(self.prose(&item.text));
            items.push((text, self.expression(&item.key)?));
        }
        let mut wrong = Vec::new();
        for expected in &file.wrong {
            let Some(order) = self.needed(expected.order.as_ref(), "order") else { continue };
            let mut sorted = order.clone();
            sorted.sort_unstable();
            if sorted != (1..=items.len()).collect::<Vec<_>>() {
                self.add_to(&expected.because, "`order` holds the number of each item once, counted from 1");
                continue;
            }
            wrong.push((order.iter().map(|number| number - 1).collect(), self.prose(&expected.because)));
        }
        Some(QuestionKind::Order { items, wrong })
    }

    fn surface(&mut self, file: &QuestionFile) -> Option<Surface> {
        self.needed(file.surface.as_ref(), "in").map(|surface| match surface {
            SurfaceFile::Image => Surface::Image,
            SurfaceFile::Side => Surface::Side,
        })
    }

    fn edit(&mut self, file: &QuestionFile) -> Option<Edit> {
        let until = self.needed(file.until.as_ref(), "until")?;
        let until = self.condition(until)?;
        if file.solution.is_empty() {
            self.add("a question of this kind needs a `solution`, so that it is known that there is one");
        }
        let solution = self.changes(&file.solution);
        let mut wrong = Vec::new();
        for expected in &file.wrong {
            let Some(change) = self.needed(expected.change.as_ref(), "change") else { continue };
            let Some(when) = self.needed(expected.when.as_ref(), "when") else { continue };
            let (change, because) = (self.changes(change), self.prose(&expected.because));
            wrong.extend(self.condition(when).map(|when| WrongEdit { change, when, because }));
        }
        Some(Edit { until, solution, wrong })
    }
}
