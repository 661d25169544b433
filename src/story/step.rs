//! Moving through a recorded tree, like a debugger moves through a program.

use super::index::Index;
use super::shown::Shown;
use crate::record::EventId;

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
    /// To the event before of the same kind as this one.
    PreviousSame,
    /// To the event after of the same kind as this one.
    NextSame,
    /// To the event before that a breakpoint stops at.
    PreviousStop,
    /// To the event after that a breakpoint stops at.
    NextStop,
}

impl Step {
    /// All moves, in the order of the toolbar.
    pub const ALL: [Self; 11] = [
        Self::First,
        Self::Back,
        Self::Next,
        Self::Into,
        Self::Over,
        Self::Out,
        Self::Last,
        Self::PreviousSame,
        Self::NextSame,
        Self::PreviousStop,
        Self::NextStop,
    ];

    /// A word for it, which is also its key in the catalogue of words.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::First => "first",
            Self::Back => "back",
            Self::Next => "next",
            Self::Into => "into",
            Self::Over => "over",
            Self::Out => "out",
            Self::Last => "last",
            Self::PreviousSame => "previous-same",
            Self::NextSame => "next-same",
            Self::PreviousStop => "previous-stop",
            Self::NextStop => "next-stop",
        }
    }

    /// Where the move leads from `at`; none if there is nothing there. `stops` are ascending.
    #[must_use]
    pub fn target(self, index: &Index, shown: &Shown, stops: &[EventId], at: EventId) -> Option<EventId> {
        let steps = shown.steps();
        match self {
            Self::First => steps.first().copied().filter(|&first| first != at),
            Self::Back => before(steps, at),
            Self::Next => after(steps, at),
            Self::Into => shown.rows_between(at, index.end(at)).first().copied(),
            Self::Over => after(shown.rows(), index.end(at) - 1),
            Self::Out => shown.parent(at),
            Self::Last => steps.last().copied().filter(|&last| last != at),
            Self::PreviousSame => before(shown.steps_of(index.kind(at)), at),
            Self::NextSame => after(shown.steps_of(index.kind(at)), at),
            Self::PreviousStop => before(stops, at),
            Self::NextStop => after(stops, at),
        }
    }
}

/// The last of an ascending list that comes before `at`.
pub(super) fn before(list: &[EventId], at: EventId) -> Option<EventId> {
    list.partition_point(|&id| id < at).checked_sub(1).map(|place| list[place])
}

/// The first of an ascending list that comes after `at`.
pub(super) fn after(list: &[EventId], at: EventId) -> Option<EventId> {
    list.get(list.partition_point(|&id| id <= at)).copied()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::story::filter::Filter;
    use crate::story::kind::Kind;
    use crate::story::level::Level;
    use crate::story::testing::{fishbowl, small};

    /// Where a move leads from each of these events of the small tree.
    fn targets<const N: usize>(step: Step, level: Level, from: [EventId; N]) -> [Option<EventId>; N] {
        let tree = small();
        let index = Index::of(&tree);
        let shown = Shown::with(&tree, &index, level, &Filter::default());
        from.map(|at| step.target(&index, &shown, &[4, 9], at))
    }

    #[test]
    fn next_and_back_follow_the_order_of_the_level() {
        assert_eq!(targets(Step::Next, Level::Everything, [0, 1, 11]), [Some(1), Some(2), None]);
        assert_eq!(targets(Step::Next, Level::Story, [0, 1, 7, 11]), [Some(1), Some(7), Some(10), None]);
        assert_eq!(targets(Step::Back, Level::Story, [11, 7, 0]), [Some(10), Some(1), None]);
    }

    #[test]
    fn a_move_from_an_event_without_a_row_leads_to_one_with_a_row() {
        assert_eq!(targets(Step::Next, Level::Story, [4]), [Some(7)]);
        assert_eq!(targets(Step::Back, Level::Story, [4]), [Some(1)]);
        assert_eq!(targets(Step::Out, Level::Story, [9]), [Some(7)]);
    }

    #[test]
    fn into_goes_to_the_first_part_and_out_to_the_whole() {
        assert_eq!(targets(Step::Into, Level::Everything, [0, 2, 3]), [Some(1), Some(3), None]);
        assert_eq!(targets(Step::Into, Level::Story, [7]), [Some(10)]);
        assert_eq!(targets(Step::Out, Level::Everything, [0, 4, 9]), [None, Some(2), Some(8)]);
    }

    #[test]
    fn over_skips_all_parts() {
        assert_eq!(targets(Step::Over, Level::Everything, [0, 2, 3, 9]), [None, Some(5), Some(4), Some(10)]);
        assert_eq!(targets(Step::Over, Level::Story, [7, 11]), [Some(11), None]);
    }

    #[test]
    fn first_and_last_lead_to_the_ends() {
        assert_eq!(targets(Step::First, Level::Story, [0, 11]), [None, Some(0)]);
        assert_eq!(targets(Step::Last, Level::Story, [0, 11]), [Some(11), None]);
    }

    #[test]
    fn the_same_kind_is_that_of_the_event_where_one_stands() {
        assert_eq!(targets(Step::NextSame, Level::Everything, [3, 4, 9]), [Some(4), Some(6), None]);
        assert_eq!(targets(Step::PreviousSame, Level::Everything, [11, 10]), [Some(10), None]);
    }

    #[test]
    fn stops_are_reached_at_every_level() {
        assert_eq!(targets(Step::NextStop, Level::Story, [0, 4, 9]), [Some(4), Some(9), None]);
        assert_eq!(targets(Step::PreviousStop, Level::Story, [11, 9, 4]), [Some(9), Some(4), None]);
    }

    #[test]
    fn every_move_from_everywhere_is_what_a_walk_from_event_to_event_finds() {
        let tree = fishbowl();
        let index = Index::of(&tree);
        for level in Level::ALL {
            let shown = Shown::with(&tree, &index, level, &Filter::default());
            let is_row: Vec<bool> = tree.events.iter().map(|event| shown.has_row(event.id)).collect();
            let row = |id: &EventId| is_row[*id as usize];
            for at in (0..tree.end()).step_by(7) {
                let target = |step: Step| step.target(&index, &shown, &[], at);
                assert_eq!(target(Step::Next), (at + 1..tree.end()).find(row));
                assert_eq!(target(Step::Back), (0..at).rev().find(row));
                assert_eq!(target(Step::Into), (at + 1..tree.subtree_end(at)).find(row));
                assert_eq!(target(Step::Over), (tree.subtree_end(at)..tree.end()).find(row));
                assert_eq!(target(Step::Out), tree.path(at).into_iter().rev().skip(1).find(row));
                let same = |id: &EventId| row(id) && Kind::of(&tree.event(*id).what) == index.kind(at);
                assert_eq!(target(Step::NextSame), (at + 1..tree.end()).find(same));
            }
        }
    }
}
