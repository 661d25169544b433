//! `rayscope lesson`: the course, and lessons of one's own.

mod check;
mod exam;
mod list;
mod open;
mod show;
mod written;

use super::failure::Failure;
use clap::{Args, Subcommand};

/// List, read, check and open lessons
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  rayscope lesson list                           the lessons of the course
  rayscope lesson show 06_cube                   read one here
  rayscope lesson open 06_cube                   open one in the workbench
  rayscope lesson check my_lessons               run lessons of your own, and say what is wrong with them
  rayscope lesson exam --seed 7 --count 10       questions from the course, and with --answers the teacher's sheet

lessons/GUIDE.md says how a lesson is written; lessons/template is one to begin with.")]
pub struct Lesson {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    List(list::List),
    Show(show::Show),
    Check(check::Check),
    Open(open::Open),
    Exam(exam::Exam),
}

impl Lesson {
    /// Runs the command.
    pub fn run(&self) -> Result<(), Failure> {
        match &self.command {
            Command::List(list) => list.run(),
            Command::Show(show) => show.run(),
            Command::Check(check) => check.run(),
            Command::Open(open) => open.run(),
            Command::Exam(exam) => exam.run(),
        }
    }
}
