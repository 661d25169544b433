//! A lesson as it was understood: nothing in it has been traced yet.

use super::expression::Expression;
use super::expression::Format;
use super::place::Place;
use super::prose::{Inline, Line, Prose, Reference, Target};
use crate::document;
use crate::query::Query;
use crate::record::format_number;
use crate::scene::Profile;
use crate::story::Level;
use crate::view::View;
use serde_json::Value as Json;
use std::fmt;

/// A lesson.
#[derive(Clone, Debug)]
pub struct Lesson {
    /// The name of its folder.
    pub id: String,
    /// The file, as messages name it.
    pub file: String,
    /// What is above the text.
    pub header: Header,
    /// The text before the first step.
    pub opening: Prose<Reference>,
    /// The steps, in order.
    pub steps: Vec<Step>,
    /// The links in it, with their places.
    pub links: Vec<(Target, Place)>,
    /// Whether everything in it could be read.
    pub is_whole: bool,
}

/// What is said of a lesson as a whole.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Header {
    /// What it is called.
    pub title: String,
    /// The section of the syllabus.
    pub section: Sited<String>,
    /// How long it takes, in minutes.
    pub minutes: Sited<u32>,
    /// The lessons that come before it.
    pub needs: Vec<Sited<String>>,
    /// The one thing that a student takes along.
    pub idea: String,
}

/// Something with its place in the file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sited<T> {
    /// What it is.
    pub value: T,
    /// Where it stands.
    pub place: Place,
}

/// A step: one idea, and what is looked at.
#[derive(Clone, Debug)]
pub struct Step {
    /// Its heading.
    pub title: String,
    /// Where it begins.
    pub place: Place,
    /// Whether its block could be read. Where not, nothing can be said of what it would look at.
    pub is_whole: bool,
    /// What is traced.
    pub aim: Aim,
    /// The question whose first event is selected.
    pub event: Option<Sited<Query>>,
    /// How much the tree shows.
    pub level: Level,
    /// The drawings that are open.
    pub views: Vec<Sited<&'static View>>,
    /// The drawings that open once the step's questions are answered: they would give the answers away.
    pub after: Vec<Sited<&'static View>>,
    /// Questions whose events are marked.
    pub highlight: Vec<Sited<Query>>,
    /// Where the probe stands on the ray.
    pub t: Option<Sited<Expression>>,
    /// Names for expressions.
    pub names: Vec<(String, Sited<Expression>)>,
    /// Further traces, by name.
    pub also: Vec<(String, Aim)>,
    /// Other aims with which the questions hold too.
    pub variants: Vec<Aim>,
    /// What is told, asked and claimed, in order.
    pub parts: Vec<Part>,
}

/// What is traced.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Aim {
    /// An embedded scene, or a file beside the lesson.
    pub scene: String,
    /// Changes to it.
    pub changes: Vec<Change>,
    /// The pixel or the ray; none where the lesson has not said it yet.
    pub at: Option<At>,
    /// The accuracy that the scene is looked at with.
    pub accuracy: Option<Profile>,
    /// Where it is said.
    pub place: Place,
    /// Whether a block that it depends on could not be read.
    pub is_lost: bool,
}

/// A pixel or a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum At {
    /// Column and row.
    Pixel([u32; 2]),
    /// Origin and direction.
    Ray([f64; 6]),
}

/// In words: `pixel 333, 150`.
impl fmt::Display for At {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Pixel([x, y]) => write!(f, "pixel {x}, {y}"),
            Self::Ray(ray) => {
                let numbers = ray.map(format_number);
                write!(f, "the ray from ({}) along ({})", numbers[..3].join(", "), numbers[3..].join(", "))
            }
        }
    }
}

/// A change to a scene's file.
#[derive(Clone, Debug, PartialEq)]
pub struct Change {
    /// Where.
    pub at: document::Place,
    /// The value that it gets.
    pub to: Json,
}

/// A part of a step.
#[derive(Clone, Debug)]
pub enum Part {
    /// Text.
    Prose(Prose<Reference>),
    /// What has to hold.
    Claims(Vec<Sited<Expression>>),
    /// Where the source chapter slips.
    Slip(Slip),
    /// A table of what was recorded.
    Table(Table),
    /// A question.
    Question(Box<Question>),
}

/// Where the source chapter slips.
#[derive(Clone, Debug)]
pub struct Slip {
    /// What it prints.
    pub printed: Prose<Reference>,
    /// What is right.
    pub right: Prose<Reference>,
    /// What shows it.
    pub shown: Sited<Expression>,
}

/// A row for each item of a list.
#[derive(Clone, Debug)]
pub struct Table {
    /// The list.
    pub of: Sited<Expression>,
    /// The columns.
    pub columns: Vec<Column>,
}

/// A column of a table.
#[derive(Clone, Debug)]
pub struct Column {
    /// What stands above it.
    pub head: Line<Reference>,
    /// An expression of `item`.
    pub cell: Sited<Expression>,
    /// How it is written.
    pub format: Format,
}

/// A question.
#[derive(Clone, Debug)]
pub struct Question {
    /// Where it stands.
    pub place: Place,
    /// What is asked.
    pub ask: Prose<Reference>,
    /// Hints, the vaguest first.
    pub hints: Vec<Prose<Reference>>,
    /// What is said with the right answer.
    pub explain: Option<Prose<Reference>>,
    /// What kind of answer it asks for, and which one is right.
    pub kind: QuestionKind,
}

/// What kind of answer a question asks for.
#[derive(Clone, Debug)]
pub enum QuestionKind {
    /// A number.
    Number(Quantity),
    /// One of several.
    Choice(Vec<Choice>),
    /// Things put in order.
    Order {
        /// The things, each with the number that it is ordered by.
        items: Vec<(Line<Reference>, Sited<Expression>)>,
        /// Wrong orders that are expected.
        wrong: Vec<(Vec<usize>, Prose<Reference>)>,
    },
    /// A place that is clicked.
    Place {
        /// Where.
        surface: Surface,
        /// The place and wrong ones; its tolerance is in pixels.
        quantity: Quantity,
    },
    /// A time found by dragging t.
    Time(Quantity),
    /// An interval list picked from several.
    Intervals(Quantity),
    /// A change to the scene.
    Edit(Edit),
}

/// Something that is worked out, and what comes of mistakes.
#[derive(Clone, Debug)]
pub struct Quantity {
    /// The right answer.
    pub answer: Sited<Expression>,
    /// How far from it an answer may be.
    pub tolerance: Option<Sited<Expression>>,
    /// The unit; empty where there is none.
    pub unit: String,
    /// Wrong answers that are expected, with what the student probably did.
    pub wrong: Vec<(Sited<Expression>, Prose<Reference>)>,
}

/// One of several answers.
#[derive(Clone, Debug)]
pub struct Choice {
    /// What it says.
    pub text: Line<Reference>,
    /// Whether it is right.
    pub right: Right,
    /// What is said when it is chosen.
    pub because: Prose<Reference>,
}

/// Whether a choice is right.
#[derive(Clone, Debug)]
pub enum Right {
    /// Once and for all.
    Always(bool),
    /// If this holds.
    If(Sited<Expression>),
}

/// Where a place is clicked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Surface {
    /// In the picture.
    Image,
    /// In the side view.
    Side,
}

/// A change that the student makes.
#[derive(Clone, Debug)]
pub struct Edit {
    /// When it is made.
    pub until: Sited<Condition>,
    /// A change that does it.
    pub solution: Vec<Change>,
    /// Changes that do not, how they are recognised, and what is said.
    pub wrong: Vec<WrongEdit>,
}

/// A change that does not do it.
#[derive(Clone, Debug)]
pub struct WrongEdit {
    /// The change.
    pub change: Vec<Change>,
    /// By what it is recognised.
    pub when: Sited<Condition>,
    /// What is said.
    pub because: Prose<Reference>,
}

/// What is asked of an edited scene.
#[derive(Clone, Debug)]
pub enum Condition {
    /// An event that answers this question.
    Event(Query),
    /// That this holds.
    Holds(Expression),
}

impl Lesson {
    /// All questions, each with the step that it stands in, counted from 0.
    pub fn questions(&self) -> impl Iterator<Item = (usize, &Question)> {
        self.steps
            .iter()
            .enumerate()
            .flat_map(|(number, step)| step.questions().map(move |question| (number, question)))
    }
}

impl Step {
    /// Its questions.
    pub fn questions(&self) -> impl Iterator<Item = &Question> {
        self.parts.iter().filter_map(|part| match part {
            Part::Question(question) => Some(question.as_ref()),
            _ => None,
        })
    }
}

impl<T> Sited<T> {
    /// Something at a place.
    pub const fn new(value: T, place: Place) -> Self {
        Self { value, place }
    }
}

/// The words of the first paragraph, for what holds one line.
#[must_use]
pub fn first_line(prose: Prose<Reference>) -> Line<Reference> {
    prose
        .into_iter()
        .find_map(|block| match block {
            super::prose::Block::Paragraph(line) => Some(line),
            super::prose::Block::Formula(pieces) => Some(vec![Inline::Formula(pieces)]),
            _ => None,
        })
        .unwrap_or_default()
}
