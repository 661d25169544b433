//! A question with its values: what is right, what is wrong, and what is said about it.

use crate::lesson::expression::{Expression, Value};
use crate::lesson::model::{Choice, Condition, Edit, Quantity, Question, QuestionKind, Right, Sited, Surface};
use crate::lesson::place::{Finding, Place};
use crate::lesson::prose::{Line, Prose, Told};
use crate::lesson::stage::Stage;

/// A question about one recorded ray.
#[derive(Clone, Debug)]
pub struct Posed {
    /// Where it stands in the lesson.
    pub place: Place,
    /// What is asked.
    pub ask: Prose<Told>,
    /// Hints, the vaguest first.
    pub hints: Vec<Prose<Told>>,
    /// What is said with the right answer.
    pub explain: Option<Prose<Told>>,
    /// What kind of answer it asks for, and which one is right.
    pub form: Form,
}

/// What kind of answer a question asks for.
#[derive(Clone, Debug)]
pub enum Form {
    /// A number, typed.
    Number(Reckoned<f64>),
    /// One of several.
    Choice(Vec<PosedChoice>),
    /// Things put in order.
    Order {
        /// The things, as they are numbered.
        items: Vec<Line<Told>>,
        /// The order in which they are offered, which is not the right one.
        offered: Vec<usize>,
        /// The right order.
        right: Vec<usize>,
        /// Wrong orders that are expected.
        wrong: Vec<(Vec<usize>, Prose<Told>)>,
    },
    /// A place that is clicked.
    Place(Surface, Reckoned<Spot>),
    /// A time found by dragging t.
    Time(Reckoned<f64>),
    /// An interval list picked from several.
    Intervals(Reckoned<Vec<Stretch>>),
    /// A change to the scene.
    Edit(PosedEdit),
}

/// Something that was worked out.
#[derive(Clone, Debug)]
pub struct Reckoned<T> {
    /// The right answer.
    pub answer: T,
    /// How far from it an answer may be: in its own unit, of a place in pixels.
    pub tolerance: f64,
    /// The unit; empty where there is none.
    pub unit: String,
    /// Wrong answers that are expected, with what the student probably did.
    pub wrong: Vec<(T, Prose<Told>)>,
}

/// A place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Spot {
    /// A point in space.
    World([f64; 3]),
    /// A column and a row of the picture.
    Pixel([f64; 2]),
}

/// An inside interval; a missing end is unbounded.
pub type Stretch = [Option<f64>; 2];

/// One of several answers.
#[derive(Clone, Debug)]
pub struct PosedChoice {
    /// What it says.
    pub text: Line<Told>,
    /// Whether it is right.
    pub is_right: bool,
    /// What is said when it is chosen.
    pub because: Prose<Told>,
}

/// A change that the student makes.
#[derive(Clone, Debug)]
pub struct PosedEdit {
    /// What is asked of it, and of changes that do not do it.
    pub edit: Edit,
    /// What is said about each of those.
    pub because: Vec<Prose<Told>>,
}

/// Without a tolerance of its own a number may be off by this share of it.
const TOLERANCE: f64 = 0.01;
/// Without a tolerance of its own a place may be off by so many pixels.
const PIXELS: f64 = 8.0;

impl Posed {
    /// Works a question out about a stage.
    ///
    /// # Errors
    /// Everything in it that has no value.
    pub fn new(question: &Question, stage: &Stage) -> Result<Self, Vec<Finding>> {
        let mut poser = Poser { stage, findings: Vec::new() };
        let ask = poser.tell(&question.ask);
        let hints = question.hints.iter().map(|hint| poser.tell(hint)).collect();
        let explain = question.explain.as_ref().map(|explain| poser.tell(explain));
        let form = poser.form(question);
        match form {
            Some(form) if poser.findings.is_empty() => Ok(Self { place: question.place, ask, hints, explain, form }),
            _ => Err(poser.findings),
        }
    }
}

struct Poser<'a> {
    stage: &'a Stage,
    findings: Vec<Finding>,
}

impl Poser<'_> {
    fn tell(&mut self, prose: &Prose<crate::lesson::prose::Reference>) -> Prose<Told> {
        self.stage.tell(prose, &mut self.findings)
    }

    fn add(&mut self, place: Place, message: impl Into<String>) {
        self.findings.push(Finding { file: self.stage.file.clone(), place, message: message.into() });
    }

    fn value(&mut self, expression: &Sited<Expression>) -> Option<Value> {
        let value = expression.value.evaluate(&self.stage.known());
        value.map_err(|error| self.findings.push(self.stage.finding(expression, &error))).ok()
    }

    fn number(&mut self, expression: &Sited<Expression>) -> Option<f64> {
        let value = expression.value.number(&self.stage.known());
        value.map_err(|error| self.findings.push(self.stage.finding(expression, &error))).ok()
    }

    fn form(&mut self, question: &Question) -> Option<Form> {
        match &question.kind {
            QuestionKind::Number(quantity) => self.reckon(quantity, Self::number, share).map(Form::Number),
            QuestionKind::Time(quantity) => self.reckon(quantity, Self::number, share).map(Form::Time),
            QuestionKind::Intervals(quantity) => self.reckon(quantity, Self::stretches, |_| 0.0).map(Form::Intervals),
            QuestionKind::Place { surface, quantity } => {
                self.reckon(quantity, Self::spot, |_| PIXELS).map(|reckoned| Form::Place(*surface, reckoned))
            }
            QuestionKind::Choice(choices) => {
                Some(Form::Choice(choices.iter().filter_map(|choice| self.choice(choice)).collect()))
            }
            QuestionKind::Order { items, wrong } => self.order(items, wrong),
            QuestionKind::Edit(edit) => Some(Form::Edit(self.edit(edit))),
        }
    }

    fn reckon<T>(
        &mut self,
        quantity: &Quantity,
        read: fn(&mut Self, &Sited<Expression>) -> Option<T>,
        usual: fn(&T) -> f64,
    ) -> Option<Reckoned<T>> {
        let answer = read(self, &quantity.answer)?;
        let tolerance = match &quantity.tolerance {
            Some(tolerance) => self.number(tolerance)?,
            None => usual(&answer),
        };
        let mut wrong = Vec::new();
        for (expression, because) in &quantity.wrong {
            let because = self.tell(because);
            wrong.extend(read(self, expression).map(|value| (value, because)));
        }
        Some(Reckoned { answer, tolerance, unit: quantity.unit.clone(), wrong })
    }

    fn spot(&mut self, expression: &Sited<Expression>) -> Option<Spot> {
        let numbers = self.value(expression)?.numbers().unwrap_or_default();
        match numbers.as_slice() {
            [x, y, z] => Some(Spot::World([*x, *y, *z])),
            [x, y] => Some(Spot::Pixel([*x, *y])),
            _ => {
                let message = format!(
                    "`{}` is no place: a point in space or a column and a row are needed",
                    expression.value.text()
                );
                self.add(expression.place, message);
                None
            }
        }
    }

    fn stretches(&mut self, expression: &Sited<Expression>) -> Option<Vec<Stretch>> {
        let value = self.value(expression)?;
        let stretch = |item: &Value| match item.items() {
            Some([from, to]) => Some([from.number(), to.number()]),
            _ => None,
        };
        let list = value.items().and_then(|items| items.iter().map(stretch).collect());
        if list.is_none() {
            let message = format!(
                "`{}` is no interval list: write `spans(…)` around recorded intervals",
                expression.value.text()
            );
            self.add(expression.place, message);
        }
        list
    }

    fn choice(&mut self, choice: &Choice) -> Option<PosedChoice> {
        let is_right = match &choice.right {
            Right::Always(is_right) => *is_right,
            Right::If(expression) => match expression.value.holds(&self.stage.known()) {
                Ok(holds) => holds,
                Err(error) => {
                    self.findings.push(self.stage.finding(expression, &error));
                    return None;
                }
            },
        };
        let text = self.stage.line(&choice.text, &mut self.findings);
        Some(PosedChoice { text, is_right, because: self.tell(&choice.because) })
    }

    fn order(
        &mut self,
        items: &[(Line<crate::lesson::prose::Reference>, Sited<Expression>)],
        wrong: &[(Vec<usize>, Prose<crate::lesson::prose::Reference>)],
    ) -> Option<Form> {
        let keys: Option<Vec<f64>> = items.iter().map(|(_, key)| self.number(key)).collect();
        let keys = keys?;
        let mut right: Vec<usize> = (0..keys.len()).collect();
        right.sort_by(|&a, &b| keys[a].total_cmp(&keys[b]));
        if let Some(pair) = right.windows(2).find(|pair| keys[pair[0]] == keys[pair[1]]) {
            self.add(items[pair[1]].1.place, "two items have the same key, so that there is no right order");
        }
        let lines = items.iter().map(|(text, _)| self.stage.line(text, &mut self.findings)).collect();
        let wrong = wrong.iter().map(|(order, because)| (order.clone(), self.tell(because))).collect();
        Some(Form::Order { items: lines, offered: not_in(&right), right, wrong })
    }

    fn edit(&mut self, edit: &Edit) -> PosedEdit {
        let because = edit.wrong.iter().map(|wrong| self.tell(&wrong.because)).collect();
        if let Ok(true) = self.stage.fulfils(&edit.until.value) {
            self.add(edit.until.place, "the scene does this already, before it is changed");
        }
        if let Condition::Holds(expression) = &edit.until.value
            && let Err(error) = expression.holds(&self.stage.known())
            && !expression.refers()
        {
            self.add(edit.until.place, error.message);
        }
        PosedEdit { edit: edit.clone(), because }
    }
}

fn share(answer: &f64) -> f64 {
    TOLERANCE * answer.abs()
}

/// The things in the order of their numbers; turned by one where that is the right order.
fn not_in(right: &[usize]) -> Vec<usize> {
    let mut offered: Vec<usize> = (0..right.len()).collect();
    if offered == right {
        offered.rotate_left(1);
    }
    offered
}
