//! Examinations: questions of the course in an order and about rays that follow from a seed.

use super::course::Course;
use super::model::{Aim, Lesson, Part, Question, QuestionKind, Step};
use super::prose::{Prose, Told};
use super::question::{Form, Posed};
use super::scenes::{Scenes, Shelf};
use super::stage::Stage;
use super::table::ToldTable;

/// An examination.
pub struct Exam {
    /// What it follows from.
    pub seed: u64,
    /// Its questions.
    pub questions: Vec<ExamQuestion>,
}

/// One question of an examination.
pub struct ExamQuestion {
    /// The lesson that it is from.
    pub lesson: String,
    /// The title of the step that it is from.
    pub step: String,
    /// What is told before it, as a question on paper needs it.
    pub before: Vec<Before>,
    /// What it is about.
    pub stage: Stage,
    /// The question; choices and things to be ordered are shuffled.
    pub posed: Posed,
}

/// Something that is told before a question.
#[derive(Clone, Debug, PartialEq)]
pub enum Before {
    /// Text.
    Prose(Prose<Told>),
    /// A table.
    Table(ToldTable),
}

impl Exam {
    /// Draws an examination of `count` questions from some lessons of a course. Only what can be answered on paper is asked: no clicks and
    /// no changes of scenes.
    #[must_use]
    pub fn draw(
        course: &Course,
        lessons: &[&str],
        count: usize,
        seed: u64,
        scenes: &Scenes,
        shelf: &dyn Shelf,
    ) -> Self {
        let mut dice = Dice(seed);
        let mut all: Vec<(&Lesson, &Step, &Question)> = course
            .lessons
            .iter()
            .filter(|lesson| lessons.is_empty() || lessons.contains(&lesson.id.as_str()))
            .flat_map(|lesson| {
                lesson.steps.iter().flat_map(move |step| step.questions().map(move |q| (lesson, step, q)))
            })
            .filter(|(_, _, question)| is_on_paper(question))
            .collect();
        dice.shuffle(&mut all);
        let mut questions = Vec::new();
        for (lesson, step, question) in all {
            if questions.len() == count {
                break;
            }
            let aims: Vec<&Aim> = std::iter::once(&step.aim).chain(&step.variants).collect();
            let aim = aims[dice.below(aims.len())];
            let Ok(stage) = Stage::with_aim(lesson, step, aim, scenes, shelf) else { continue };
            let Ok(mut posed) = Posed::new(question, &stage) else { continue };
            let Some(before) = told_before(step, question, &stage) else { continue };
            dice.shuffle_form(&mut posed.form);
            let (lesson, step) = (lesson.id.clone(), step.title.clone());
            questions.push(ExamQuestion { lesson, step, before, stage, posed });
        }
        Self { seed, questions }
    }
}

/// The text and the tables of a step before one of its questions; none where something in them has no value for this ray.
fn told_before(step: &Step, question: &Question, stage: &Stage) -> Option<Vec<Before>> {
    let mut findings = Vec::new();
    let mut before = Vec::new();
    for part in &step.parts {
        match part {
            Part::Question(asked) if std::ptr::eq(asked.as_ref(), question) => break,
            Part::Prose(prose) => before.push(Before::Prose(stage.tell(prose, &mut findings))),
            Part::Table(table) => before.push(Before::Table(stage.table(table, &mut findings))),
            Part::Claims(_) | Part::Slip(_) | Part::Question(_) => {}
        }
    }
    findings.is_empty().then_some(before)
}

fn is_on_paper(question: &Question) -> bool {
    !matches!(question.kind, QuestionKind::Edit(_) | QuestionKind::Place { .. } | QuestionKind::Time(_))
}

/// SplitMix64 (Steele, Lea, Flood 2014, "Fast Splittable Pseudorandom Number Generators"): the same on every machine.
struct Dice(u64);

impl Dice {
    fn roll(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// A number below `end`; no one is preferred by more than 10⁻¹⁵.
    fn below(&mut self, end: usize) -> usize {
        #[expect(clippy::cast_possible_truncation, reason = "it is below `end`")]
        let number = (self.roll() % end.max(1) as u64) as usize;
        number
    }

    /// Fisher and Yates' shuffle.
    fn shuffle<T>(&mut self, items: &mut [T]) {
        for last in (1..items.len()).rev() {
            let other = self.below(last + 1);
            items.swap(last, other);
        }
    }

    fn shuffle_form(&mut self, form: &mut Form) {
        match form {
            Form::Choice(choices) => self.shuffle(choices),
            Form::Order { offered, right, .. } => {
                self.shuffle(offered);
                if offered == right {
                    offered.rotate_left(1);
                }
            }
            _ => {}
        }
    }
}
