//! Prints what a frame costs while a story of more than 100,000 events is stepped through, beside one of 1,000: layout and shape
//! building, without a graphics card, in milliseconds of the thread's own working time. `cargo bench --bench stepping`.

#[path = "../tests/large/mod.rs"]
mod large;

use egui::Vec2;
use large::{Frame, Show, Spread, fishbowl_with};
use rayscope::app::{Command, Preset, StepCommand, ViewCommand};
use rayscope::cpu_time::cpu_time;
use rayscope::story::{Filter, Index, Level, Step, Story};
use rayscope::view::{Theme, Timed, timeline};

/// Milliseconds for 95 of 100 frames: 60 frames a second.
const BOUND: f64 = 16.0;

/// Frames for each line.
const FRAMES: usize = 120;

fn main() {
    println!("milliseconds a frame while stepping, 1280 × 800; the bound for 95 % is {BOUND}");
    println!(
        "{:>9} {:11} {:8} {:8} {:>7} {:>7} {:>7} {:>7}",
        "events", "level", "moves", "layout", "50 %", "95 %", "most", "shapes"
    );
    for events in [1_000, 100_000] {
        let mut show = Show::open("fishbowl", &fishbowl_with(events), Vec2::new(1280.0, 800.0));
        for preset in [Preset::Learn, Preset::Inspect] {
            show.workbench.run(Command::View(ViewCommand::Layout(preset)));
            for level in Level::ALL {
                show.workbench.set_level(level);
                show.workbench.run(Command::Step(StepCommand::OpenAll));
                for step in [Step::Next, Step::Over, Step::Back] {
                    print_steps(&mut show, preset, level, step);
                }
            }
        }
        print_parts(&show);
    }
}

fn print_steps(show: &mut Show, preset: Preset, level: Level, step: Step) {
    let events = show.workbench.recording().expect("recorded").tree.end();
    show.wait();
    let frames: Vec<Frame> = (0..FRAMES)
        .map(|turn| {
            if turn % (FRAMES / 10) == 0 {
                let part = u32::try_from(turn / (FRAMES / 10)).expect("few turns");
                show.workbench.select(events / 10 * part + events / 20);
            }
            show.workbench.run(Command::Step(StepCommand::Move(step)));
            show.frame()
        })
        .collect();
    let total = Spread::of(frames.iter().map(Frame::total));
    let shapes = Spread::of(frames.iter().map(|frame| frame.shapes)).at(0.95);
    let over = if total.at(0.95) > BOUND { "over" } else { "" };
    println!(
        "{events:>9} {:11} {:8} {:8} {:>7.2} {:>7.2} {:>7.2} {shapes:>7.2} {over}",
        level.name(),
        step.name(),
        format!("{preset:?}"),
        total.at(0.5),
        total.at(0.95),
        total.at(1.0),
    );
}

/// What is done once for a tree, a level or a filter.
fn print_parts(show: &Show) {
    let recording = show.workbench.recording().expect("recorded");
    let tree = &recording.tree;
    let time = |name: &str, work: &mut dyn FnMut()| {
        let taken = Spread::of((0..20).map(|_| 1e3 * cpu_time(&mut *work).0.as_secs_f64()));
        println!("{:>9} {name:50} {:>7.2}", tree.events.len(), taken.at(0.5));
    };
    let mut story = Story::new(std::sync::Arc::clone(tree), Level::Story, Filter::default());
    time("index of a tree", &mut || drop(Index::of(tree)));
    time("from story to everything and back", &mut || {
        story.set_level(Level::Everything);
        story.set_level(Level::Story);
    });
    story.set_level(Level::Everything);
    time("unfold and fold all", &mut || {
        story.set_all_open(true);
        story.set_all_open(false);
    });
    time("close and open the first row of a full outline", &mut || {
        story.set_open(0, false);
        story.set_open(0, true);
    });
    let words = Filter { text: "extent missed".to_owned(), ..Filter::default() };
    time("look for words, in the background", &mut || drop(words.matches(story.tree(), story.index())));
    time("marks of the timeline, in the background", &mut || {
        let timed = Timed { tree, told: tree.end(), stops: &[], selected: None };
        drop(timeline(timed, [600.0, 84.0], Theme::Light));
    });
}
