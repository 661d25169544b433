//! What stands in the header and in the fenced blocks of a lesson, as TOML holds it.

use schemars::JsonSchema;
use serde::Deserialize;
use std::collections::BTreeMap;
use toml::Spanned;

/// A text with the bytes of the block that it stands in.
pub type Text = Spanned<String>;

/// The header of a lesson.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HeaderFile {
    /// What the lesson is called.
    #[schemars(with = "String")]
    pub title: Text,
    /// The section of the syllabus, such as `6.2.3`.
    #[schemars(with = "String")]
    pub section: Text,
    /// How long it takes, 5 to 15 minutes.
    #[schemars(with = "u32")]
    pub minutes: Spanned<u32>,
    /// The lessons that come before it: the names of their folders.
    #[schemars(with = "Vec<String>")]
    #[serde(default)]
    pub needs: Vec<Text>,
    /// The one thing that a student takes along.
    #[schemars(with = "String")]
    pub idea: Text,
}

/// A `step` block: what is looked at.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StepFile {
    /// An embedded scene, or a file beside the lesson.
    #[schemars(with = "Option<String>")]
    pub scene: Option<Text>,
    /// Changes to it.
    pub change: Option<Vec<ChangeFile>>,
    /// The pixel that is traced: column and row.
    pub pixel: Option<[u32; 2]>,
    /// The ray that is traced instead: origin and direction.
    pub ray: Option<[f64; 6]>,
    /// The accuracy that the scene is looked at with: the name of a profile, or what one holds.
    pub accuracy: Option<AccuracyFile>,
    /// A question: its first event is selected.
    #[schemars(with = "Option<String>")]
    pub event: Option<Text>,
    /// How much the tree shows.
    pub level: Option<LevelFile>,
    /// Drawings to open, by name.
    #[schemars(with = "Vec<String>")]
    #[serde(default)]
    pub views: Vec<Text>,
    /// Drawings that would give an answer away: they open with the answers.
    #[schemars(with = "Vec<String>")]
    #[serde(default)]
    pub after: Vec<Text>,
    /// Questions; what answers them is marked in the tree.
    #[schemars(with = "Vec<String>")]
    #[serde(default)]
    pub highlight: Vec<Text>,
    /// An expression: where the probe stands on the ray.
    #[schemars(with = "Option<String>")]
    pub t: Option<Text>,
    /// Names for expressions.
    #[schemars(with = "BTreeMap<String, String>")]
    #[serde(default, rename = "let")]
    pub names: BTreeMap<String, Text>,
    /// Further traces, by name.
    #[serde(default)]
    pub also: BTreeMap<String, AlsoFile>,
    /// Other aims with which the questions of the step hold too.
    #[serde(default)]
    pub variants: Vec<VariantFile>,
}

/// A change to a scene.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ChangeFile {
    /// The place, such as `camera.eye` or `objects[0].transform[1].translate`.
    #[schemars(with = "String")]
    pub at: Text,
    /// The value that it gets.
    #[schemars(with = "serde_json::Value")]
    pub to: toml::Value,
}

/// A further trace. What is left out is as in the step.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AlsoFile {
    /// An embedded scene, or a file beside the lesson.
    #[schemars(with = "Option<String>")]
    pub scene: Option<Text>,
    /// Changes to it.
    pub change: Option<Vec<ChangeFile>>,
    /// The pixel that is traced.
    pub pixel: Option<[u32; 2]>,
    /// The ray that is traced instead.
    pub ray: Option<[f64; 6]>,
    /// The accuracy that the scene is looked at with.
    pub accuracy: Option<AccuracyFile>,
}

/// Another aim of a step.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct VariantFile {
    /// Changes to the scene.
    pub change: Option<Vec<ChangeFile>>,
    /// The pixel that is traced.
    pub pixel: Option<[u32; 2]>,
    /// The ray that is traced instead.
    pub ray: Option<[f64; 6]>,
}

/// An accuracy: a profile's name, or what a profile's file holds.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum AccuracyFile {
    /// By its name.
    Named(String),
    /// As a table.
    Table(#[schemars(with = "serde_json::Value")] toml::Table),
}

/// How much the tree shows.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum LevelFile {
    /// A few rows.
    Story,
    /// With the working.
    Working,
    /// Everything.
    Everything,
}

/// A `slip` block: where the source chapter slips.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SlipFile {
    /// What the chapter prints, in Markdown.
    #[schemars(with = "String")]
    pub printed: Text,
    /// What is right, in Markdown.
    #[schemars(with = "String")]
    pub right: Text,
    /// An expression that holds of the recorded ray, and would not if the chapter were right.
    #[schemars(with = "String")]
    pub shown: Text,
}

/// A `table` block: a row for each item of a list.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TableFile {
    /// The list.
    #[schemars(with = "String")]
    pub of: Text,
    /// The columns.
    pub columns: Vec<ColumnFile>,
}

/// A column of a table.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ColumnFile {
    /// What stands above it, in Markdown.
    #[schemars(with = "String")]
    pub head: Text,
    /// An expression of `item`.
    #[schemars(with = "String")]
    pub cell: Text,
    /// How it is written, as after the colon of a value.
    #[schemars(with = "Option<String>")]
    pub format: Option<Text>,
}

/// A `question` block.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct QuestionFile {
    /// What kind of answer it asks for.
    pub kind: KindFile,
    /// The question, in Markdown.
    #[schemars(with = "String")]
    pub ask: Text,
    /// Hints, in Markdown, the vaguest first.
    #[schemars(with = "Vec<String>")]
    #[serde(default)]
    pub hints: Vec<Text>,
    /// What is said with the right answer, in Markdown.
    #[schemars(with = "Option<String>")]
    pub explain: Option<Text>,
    /// Of a number, a place, a time and an interval list: the right answer, an expression.
    #[schemars(with = "Option<String>")]
    pub answer: Option<Text>,
    /// How far from it an answer may be: an expression; of a place, pixels.
    #[schemars(with = "Option<String>")]
    pub tolerance: Option<Text>,
    /// The unit of a number.
    #[schemars(with = "Option<String>")]
    pub unit: Option<Text>,
    /// Of a place: where it is clicked.
    #[serde(rename = "in")]
    pub surface: Option<SurfaceFile>,
    /// Of a choice: the choices.
    #[serde(default)]
    pub choice: Vec<ChoiceFile>,
    /// Of an order: the items.
    #[serde(default)]
    pub item: Vec<ItemFile>,
    /// Of an edit: a question that the edited scene's trace is to answer.
    #[schemars(with = "Option<String>")]
    pub until: Option<Text>,
    /// Of an edit: a change that does it.
    #[serde(default)]
    pub solution: Vec<ChangeFile>,
    /// Wrong answers that are expected.
    #[serde(default)]
    pub wrong: Vec<WrongFile>,
}

/// The kinds of questions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum KindFile {
    /// A number.
    Number,
    /// One of several.
    Choice,
    /// Things put in order.
    Order,
    /// A place that is clicked.
    Place,
    /// A time found by dragging t.
    Time,
    /// An interval list picked from several.
    Intervals,
    /// A change to the scene.
    Edit,
}

/// Where a place is clicked.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum SurfaceFile {
    /// In the picture.
    Image,
    /// In the side view.
    Side,
}

/// A choice.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ChoiceFile {
    /// The choice, in Markdown.
    #[schemars(with = "String")]
    pub text: Text,
    /// Whether it is right: true, false, or an expression.
    pub right: Option<RightFile>,
    /// What is said when it is chosen, in Markdown.
    #[schemars(with = "String")]
    pub because: Text,
}

/// Whether a choice is right.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum RightFile {
    /// Once and for all.
    Always(bool),
    /// If this holds.
    If(String),
}

/// Something to be put in order.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ItemFile {
    /// What it is, in Markdown.
    #[schemars(with = "String")]
    pub text: Text,
    /// A number: the items are ordered by it, the smallest first.
    #[schemars(with = "String")]
    pub key: Text,
}

/// A wrong answer that is expected.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WrongFile {
    /// The answer, an expression.
    #[schemars(with = "Option<String>")]
    pub answer: Option<Text>,
    /// Of an order: the numbers of the items, counted from 1 as they stand in the block.
    pub order: Option<Vec<usize>>,
    /// Of an edit: a change that does not do it.
    pub change: Option<Vec<ChangeFile>>,
    /// Of an edit: a question by which such a change is recognised.
    #[schemars(with = "Option<String>")]
    pub when: Option<Text>,
    /// What the student probably did, in Markdown.
    #[schemars(with = "String")]
    pub because: Text,
}
