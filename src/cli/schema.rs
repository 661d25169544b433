//! `rayscope schema`: the JSON Schemas of the files that the program reads and writes.

use super::failure::Failure;
use super::output::Output;
use crate::compare::foreign::line_schema;
use crate::lesson::lesson_schema;
use crate::scene::{profile_schema, scene_schema};
use crate::trace::trace_schema;
use clap::{Args, ValueEnum};

/// Print the JSON Schema of scene files, of recorded traces, of accuracy profiles, of compared lines or of lessons
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  rayscope schema > scene.schema.json
  rayscope schema trace > trace.schema.json
  rayscope schema profile > profile.schema.json
  rayscope schema compare > compare.schema.json
  rayscope schema lesson > lesson.schema.json

With \"$schema\": \"scene.schema.json\" as its first member, an editor completes and checks a scene file.")]
pub struct Schema {
    /// Of which file
    #[arg(value_enum, default_value_t = Of::Scene)]
    of: Of,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Of {
    /// Scene files
    Scene,
    /// What `rayscope trace --format json` writes
    Trace,
    /// What `rayscope accuracy --profile` writes and `rayscope render --accuracy` reads
    Profile,
    /// One line of what `rayscope compare` reads of another ray tracer
    Compare,
    /// The header and the blocks of a lesson
    Lesson,
}

impl Schema {
    /// Prints the schema.
    pub fn run(&self) -> Result<(), Failure> {
        let schema = match self.of {
            Of::Scene => scene_schema(),
            Of::Trace => trace_schema(),
            Of::Profile => profile_schema(),
            Of::Compare => line_schema(),
            Of::Lesson => lesson_schema(),
        };
        let text = serde_json::to_string_pretty(&schema).map_err(|error| Failure::refused(error.to_string()))?;
        Output::Standard.write((text + "\n").as_bytes())
    }
}
