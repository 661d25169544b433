//! Moving through a recorded tree, like a debugger moves through a program.

use crate::record::EventId;
use crate::trace::RayTree;
use egui::Key;

/// A move from one event to another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Step {
    /// To the first event.
    First,
    /// To the event before, in the order in which things happened.
    Back,
    /// To the event after, in the order in which things happened.
    Next,
    /// To the first part of this event.
    Into,
    /// To the first event that is not a part of this one.
    Over,
    /// To the event that this one is a part of.
    Out,
    /// To the last event.
    Last,
}

impl Step {
    /// All moves, in the order of the toolbar.
    pub const ALL: [Self; 7] = [Self::First, Self::Back, Self::Next, Self::Into, Self::Over, Self::Out, Self::Last];

    /// The word on its button.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::First => "First",
            Self::Back => "Back",
            Self::Next => "Next",
            Self::Into => "Into",
            Self::Over => "Over",
            Self::Out => "Out",
            Self::Last => "Last",
        }
    }

    /// What it does, in one sentence.
    #[must_use]
    pub const fn meaning(self) -> &'static str {
        match self {
            Self::First => "Go to the beginning of the story.",
            Self::Back => "Go back to the event before this one.",
            Self::Next => "Go on to the next event.",
            Self::Into => "Look inside this event: go to its first part.",
            Self::Over => "Step over this event: go on to the next one that is not a part of it.",
            Self::Out => "Step out: go to the event that this one is a part of.",
            Self::Last => "Go to the end of the story.",
        }
    }

    /// The key that makes it.
    #[must_use]
    pub const fn key(self) -> Key {
        match self {
            Self::First => Key::Home,
            Self::Back => Key::B,
            Self::Next => Key::N,
            Self::Into => Key::I,
            Self::Over => Key::V,
            Self::Out => Key::O,
            Self::Last => Key::End,
        }
    }

    /// Where the move leads from `at`; none if there is nothing there.
    #[must_use]
    pub fn target(self, tree: &RayTree, at: EventId) -> Option<EventId> {
        let last = tree.end().checked_sub(1)?;
        match self {
            Self::First => (at != 0).then_some(0),
            Self::Back => at.checked_sub(1),
            Self::Next => (at < last).then_some(at + 1),
            Self::Into => (at < last && tree.event(at + 1).parent == Some(at)).then_some(at + 1),
            Self::Over => Some(tree.subtree_end(at)).filter(|&after| after <= last),
            Self::Out => tree.event(at).parent,
            Self::Last => (at != last).then_some(last),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::{Entry, Recorder, What};
    use crate::trace::TreeRecorder;

    fn step(number: u8) -> Entry {
        Entry::new(What::Step { number, title: String::new() })
    }

    /// 0 ┬ 1 ┬ 2
    ///   │   └ 3
    ///   └ 4
    fn tree() -> RayTree {
        let mut recorder = TreeRecorder::new();
        recorder.begin();
        recorder.begin();
        recorder.note(|| step(2));
        recorder.note(|| step(3));
        recorder.end(|| step(1));
        recorder.note(|| step(4));
        recorder.end(|| step(0));
        recorder.finish()
    }

    fn targets(step: Step) -> Vec<Option<EventId>> {
        let tree = tree();
        (0..5).map(|at| step.target(&tree, at)).collect()
    }

    #[test]
    fn next_and_back_follow_the_order_of_events() {
        assert_eq!(targets(Step::Next), [Some(1), Some(2), Some(3), Some(4), None]);
        assert_eq!(targets(Step::Back), [None, Some(0), Some(1), Some(2), Some(3)]);
    }

    #[test]
    fn into_goes_to_the_first_part_and_out_to_the_whole() {
        assert_eq!(targets(Step::Into), [Some(1), Some(2), None, None, None]);
        assert_eq!(targets(Step::Out), [None, Some(0), Some(1), Some(1), Some(0)]);
    }

    #[test]
    fn over_skips_all_parts() {
        assert_eq!(targets(Step::Over), [None, Some(4), Some(3), Some(4), None]);
    }

    #[test]
    fn first_and_last_lead_to_the_ends() {
        assert_eq!(targets(Step::First), [None, Some(0), Some(0), Some(0), Some(0)]);
        assert_eq!(targets(Step::Last), [Some(4), Some(4), Some(4), Some(4), None]);
    }

    #[test]
    fn every_move_has_a_key_of_its_own() {
        for (i, step) in Step::ALL.iter().enumerate() {
            assert!(Step::ALL[i + 1..].iter().all(|other| other.key() != step.key()), "{step:?}");
        }
    }
}
