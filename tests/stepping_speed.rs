//! A story of a hundred thousand events is stepped through, told otherwise and looked through without a stall.
#![cfg(feature = "workbench")]

mod large;

use egui::Vec2;
use large::{Show, Spread, fishbowl_with};
use rayscope::app::{Command, StepCommand};
use rayscope::story::{Level, Step};

/// Frames that are timed of each story. Fewer would leave the median to chance, more would take long without optimisation.
const FRAMES: usize = 60;

fn show(events: usize) -> Show {
    let mut show = Show::open("fishbowl", &fishbowl_with(events), Vec2::new(1280.0, 800.0));
    let recorded = show.workbench.recording().expect("a pixel is recorded").tree.events.len();
    assert!(recorded >= events, "{recorded} events");
    show.workbench.set_level(Level::Everything);
    show.workbench.run(Command::Step(StepCommand::OpenAll));
    show.workbench.run(Command::Step(StepCommand::Move(Step::First)));
    show.wait();
    show
}

/// Steps that lead all over the story, with a frame after each.
fn step_through(show: &mut Show) -> Spread {
    let events = show.workbench.recording().expect("recorded").tree.end();
    Spread::of((0..FRAMES).map(|turn| {
        if turn % 10 == 0 {
            show.workbench.select(events / 10 * u32::try_from(turn / 10).expect("few turns"));
        }
        show.workbench.run(Command::Step(StepCommand::Move(Step::Next)));
        show.frame().total()
    }))
}

#[test]
fn a_frame_with_a_hundred_thousand_events_costs_at_most_three_times_one_with_a_thousand() {
    let [few, many] = [1_000, 100_000].map(|events| step_through(&mut show(events)).at(0.5));
    assert!(many <= 3.0 * few, "{few:.2} ms with a thousand events, {many:.2} ms with a hundred thousand");
}
