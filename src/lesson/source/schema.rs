//! The JSON Schema of what stands in the header and in the fenced blocks of a lesson: TOML and JSON hold the same values.

use super::blocks::{HeaderFile, QuestionFile, SlipFile, StepFile, TableFile};
use schemars::{JsonSchema, Schema, schema_for};

/// The blocks of a lesson, by the word after their fence; claims are expressions, one on each line.
#[derive(JsonSchema)]
#[schemars(title = "rayscope lesson", description = "The header and the fenced blocks of a lesson, each as TOML.")]
#[expect(dead_code, reason = "only its schema is asked for")]
struct LessonBlocks {
    /// Between the two lines `+++` at the head of the file.
    header: HeaderFile,
    /// Below the heading of a step.
    step: StepFile,
    /// Where the source chapter slips.
    slip: SlipFile,
    /// A row for each item of a list.
    table: TableFile,
    /// A question.
    question: QuestionFile,
}

/// The JSON Schema of a lesson's blocks.
#[must_use]
pub fn lesson_schema() -> Schema {
    schema_for!(LessonBlocks)
}
