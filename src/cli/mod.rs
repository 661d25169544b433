//! The command line: one file for each command.

mod accuracy;
mod accuracy_ray;
mod bench;
mod book;
mod compare;
mod compare_json;
mod digest;
mod drawn;
mod effects;
mod export;
mod failure;
mod find;
mod frames;
mod lesson;
mod map;
mod open;
mod output;
mod probe;
mod profile_argument;
mod progress;
mod render;
mod scan;
mod scene_argument;
mod scenes;
mod schema;
mod stability;
mod stability_plots;
mod stats;
mod trace;

pub use probe::answers;

use clap::{Parser, Subcommand};
use std::process::ExitCode;

const EXAMPLES: &str = "\
Examples:
  rayscope                                      open the workbench
  rayscope open scenes/csg/bowl.json            open it on a scene of your own
  rayscope render csg/bowl -o bowl.png          render a picture
  rayscope trace csg/bowl --pixel 320,240       print everything that a pixel's ray did
  rayscope find optics/fishbowl tir             list the pixels with total internal reflection
  rayscope map optics/fishbowl --of rays -o rays.png    show how many rays each pixel sends
  rayscope compare mine.jsonl csg/bowl          say where your own ray tracer departs from this one
  rayscope lesson list                          the lessons of the course
  rayscope book -o book                         write the course as a site to read
  rayscope effects optics/fishbowl              say what each effect of a scene costs
  rayscope accuracy lights/soft_shadows         say what accuracy costs in time
  rayscope scan textures/scanning               texture scanning beside inverse scanning
  rayscope export --povray csg/bowl             write a scene for POV-Ray
  rayscope scenes                               list the scenes that come with the program
  rayscope bench --peer povray                  time the benchmark scenes beside POV-Ray
  rayscope stability                            judge every solver by hits with 40 digits

SCENE is a file, or the name of a scene that comes with the program, such as csg/bowl.

Exit codes:
    0  everything went well
    1  a request was refused, a result could not be written, or `compare` found a difference
    2  the command line or a scene is wrong
  130  interrupted by Ctrl-C; what was finished is kept
  141  whoever was reading the output stopped";

/// Shows the whole story of a ray: every number, every hit, every reason.
#[derive(Debug, Parser)]
#[command(name = "rayscope", version, after_help = EXAMPLES)]
struct Arguments {
    #[command(subcommand)]
    command: Option<Command>,
}

#[derive(Debug, Subcommand)]
enum Command {
    Open(open::Open),
    Render(render::Render),
    Trace(trace::Trace),
    Find(find::Find),
    Lesson(lesson::Lesson),
    Book(book::Book),
    Map(map::Map),
    Scan(scan::Scan),
    Effects(effects::Effects),
    Accuracy(accuracy::Accuracy),
    Probe(probe::Probe),
    Compare(compare::Compare),
    Export(export::Export),
    Scenes(scenes::Scenes),
    Schema(schema::Schema),
    Stability(stability::Stability),
    Digest(digest::Digest),
    Bench(bench::Bench),
}

/// Runs the program on the arguments that it was started with.
#[must_use]
pub fn run() -> ExitCode {
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) => return failure::report_usage(&error),
    };
    let outcome = match arguments.command {
        None => open::Open::default().run(),
        Some(Command::Open(open)) => open.run(),
        Some(Command::Render(render)) => render.run(),
        Some(Command::Trace(trace)) => trace.run(),
        Some(Command::Find(find)) => find.run(),
        Some(Command::Lesson(lesson)) => lesson.run(),
        Some(Command::Book(book)) => book.run(),
        Some(Command::Map(map)) => map.run(),
        Some(Command::Scan(scan)) => scan.run(),
        Some(Command::Effects(effects)) => effects.run(),
        Some(Command::Accuracy(accuracy)) => accuracy.run(),
        Some(Command::Probe(probe)) => probe.run(),
        Some(Command::Compare(compare)) => compare.run(),
        Some(Command::Export(export)) => export.run(),
        Some(Command::Scenes(scenes)) => scenes.run(),
        Some(Command::Schema(schema)) => schema.run(),
        Some(Command::Stability(stability)) => stability.run(),
        Some(Command::Digest(digest)) => digest.run(),
        Some(Command::Bench(bench)) => bench.run(),
    };
    outcome.map_or_else(failure::Failure::report, |()| ExitCode::SUCCESS)
}
