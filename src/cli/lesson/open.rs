//! `rayscope lesson open`: a lesson in the workbench.

use crate::cli::failure::Failure;
use crate::lesson_folder::Lessons;
use clap::Args;

/// Open a lesson in the workbench; it is read anew whenever its file is saved
#[derive(Args, Debug)]
pub struct Open {
    /// A lesson's name, its folder or its file
    #[arg(value_name = "LESSON")]
    lesson: String,
}

impl Open {
    /// Runs the workbench until its window is closed.
    #[cfg(feature = "workbench")]
    pub fn run(&self) -> Result<(), Failure> {
        let lessons = Lessons::named(&self.lesson).map_err(Failure::usage)?;
        crate::app::run_lesson(lessons).map_err(Failure::refused)
    }

    /// Says how to get the workbench.
    #[cfg(not(feature = "workbench"))]
    pub fn run(&self) -> Result<(), Failure> {
        Lessons::named(&self.lesson).map_err(Failure::usage)?;
        Err(Failure::usage(format!(
            "this rayscope was built without the workbench; build it with `cargo build --release` (its default features), or \
             use `rayscope lesson show {}`",
            self.lesson
        )))
    }
}
