//! Two trees laid side by side: what is the same in both, what changed, what happened in one of them alone.
//!
//! Events are paired from the root down. Below a pair, the two lists of children are aligned by kind and name, in order
//! ([`align`](super::align)), so that an event which was put in or taken out moves nothing else. Time and memory are in proportion
//! to the number of events, but for lists of siblings that differ, which take a table.

use super::align::align;
use super::fields::{Change, agree, changes};
use super::name::{Name, name};
use super::{Departure, Tolerance};
use crate::record::{Event, EventId};
use crate::trace::RayTree;

/// How an event of one tree stands to the other tree.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Standing {
    /// It says the same in both.
    Same,
    /// It is in both, and something that it says is not the same.
    Changed,
    /// It happens in the left tree alone.
    OnlyLeft,
    /// It happens in the right tree alone.
    OnlyRight,
}

impl Standing {
    /// The mark before a row.
    #[must_use]
    pub const fn mark(self) -> &'static str {
        match self {
            Self::Same => "=",
            Self::Changed => "~",
            Self::OnlyLeft => "-",
            Self::OnlyRight => "+",
        }
    }

    /// The word for it.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Same => "same",
            Self::Changed => "changed",
            Self::OnlyLeft => "only left",
            Self::OnlyRight => "only right",
        }
    }
}

/// A row of two trees side by side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pair {
    /// The event of the left tree.
    pub left: Option<EventId>,
    /// The event of the right tree.
    pub right: Option<EventId>,
    /// How they stand to each other.
    pub standing: Standing,
    /// How many rows lie above it in the tree.
    pub depth: u32,
    /// The row after the last one below it: its subtree is the rows from its own up to this one.
    pub end: u32,
    /// Rows of its subtree, itself included, that are not the same.
    pub different: u32,
}

/// Two trees side by side, in the order of the story.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TreeDifference {
    /// The rows: every event of either tree once.
    pub pairs: Vec<Pair>,
}

/// Lays two trees side by side. Numbers are the same where `tolerance` says so.
#[must_use]
pub fn difference(left: &RayTree, right: &RayTree, tolerance: &Tolerance) -> TreeDifference {
    let mut weaver = Weaver { left: Side::new(left), right: Side::new(right), tolerance, pairs: Vec::new() };
    match (left.events.is_empty(), right.events.is_empty()) {
        (false, false) => weaver.pair(0, 0, 0),
        (false, true) => weaver.alone(0, 0, Standing::OnlyLeft),
        (true, false) => weaver.alone(0, 0, Standing::OnlyRight),
        (true, true) => {}
    }
    TreeDifference { pairs: weaver.pairs }
}

impl TreeDifference {
    /// Whether nothing differs.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.pairs.first().is_none_or(|root| root.different == 0)
    }

    /// How many rows are the same, changed, only left and only right.
    #[must_use]
    pub fn counts(&self) -> [usize; 4] {
        [Standing::Same, Standing::Changed, Standing::OnlyLeft, Standing::OnlyRight]
            .map(|standing| self.pairs.iter().filter(|pair| pair.standing == standing).count())
    }

    /// The first row, in the order of the story, that is not the same.
    #[must_use]
    pub fn first_different(&self) -> Option<usize> {
        self.pairs.iter().position(|pair| pair.standing != Standing::Same)
    }

    /// The first event that differs, and why.
    #[must_use]
    pub fn first_departure(&self, left: &RayTree, right: &RayTree, tolerance: &Tolerance) -> Option<Departure> {
        Departure::at(self, self.first_different()?, [left, right], tolerance)
    }

    /// The first event at which something else happens, not only with other numbers: another surface is hit, a ray is sent or
    /// not.
    #[must_use]
    pub fn first_parting(&self, left: &RayTree, right: &RayTree, tolerance: &Tolerance) -> Option<Departure> {
        let parts = |pair: &Pair| match (pair.left, pair.right) {
            (Some(a), Some(b)) => super::departure::parts(&left.event(a).what, &right.event(b).what),
            (Some(a), None) => super::departure::matters(&left.event(a).what),
            (None, Some(b)) => super::departure::matters(&right.event(b).what),
            (None, None) => false,
        };
        let different = |pair: &Pair| pair.standing != Standing::Same && parts(pair);
        Departure::at(self, self.pairs.iter().position(different)?, [left, right], tolerance)
    }

    /// What a row says differently in the two trees; nothing where it is in one of them alone.
    #[must_use]
    pub fn changes(&self, row: usize, [left, right]: [&RayTree; 2], tolerance: &Tolerance) -> Vec<Change> {
        match self.pairs.get(row) {
            Some(Pair { left: Some(a), right: Some(b), .. }) => changes(left.event(*a), right.event(*b), tolerance),
            _ => Vec::new(),
        }
    }

    /// The row of an event of the left tree (0) or the right one (1).
    #[must_use]
    pub fn row_of(&self, side: usize, event: EventId) -> Option<usize> {
        self.pairs.iter().position(|pair| [pair.left, pair.right][side.min(1)] == Some(event))
    }
}

/// A tree, ready to be walked down.
struct Side<'a> {
    events: &'a [Event],
    names: Vec<Name>,
    /// The children of event k are `children[starts[k]..starts[k + 1]]`.
    children: Vec<EventId>,
    starts: Vec<usize>,
}

impl<'a> Side<'a> {
    fn new(tree: &'a RayTree) -> Self {
        let events = &tree.events;
        let mut starts = vec![0; events.len() + 1];
        for parent in events.iter().filter_map(|event| event.parent) {
            starts[parent as usize + 1] += 1;
        }
        for k in 0..events.len() {
            starts[k + 1] += starts[k];
        }
        let mut next = starts.clone();
        let mut children = vec![0; starts[events.len()]];
        for event in events {
            if let Some(parent) = event.parent {
                children[next[parent as usize]] = event.id;
                next[parent as usize] += 1;
            }
        }
        Self { events, names: events.iter().map(|event| name(&event.what)).collect(), children, starts }
    }

    fn event(&self, id: EventId) -> &'a Event {
        &self.events[id as usize]
    }

    fn children(&self, id: EventId) -> Vec<EventId> {
        self.children[self.starts[id as usize]..self.starts[id as usize + 1]].to_vec()
    }
}

struct Weaver<'a> {
    left: Side<'a>,
    right: Side<'a>,
    tolerance: &'a Tolerance,
    pairs: Vec<Pair>,
}

impl Weaver<'_> {
    fn pair(&mut self, left: EventId, right: EventId, depth: u32) {
        let same = agree(self.left.event(left), self.right.event(right), self.tolerance);
        let standing = if same { Standing::Same } else { Standing::Changed };
        let row = self.push(Some(left), Some(right), standing, depth);
        let (ours, theirs) = (self.left.children(left), self.right.children(right));
        for (a, b) in self.aligned(&ours, &theirs) {
            match (a, b) {
                (Some(a), Some(b)) => self.pair(ours[a], theirs[b], depth + 1),
                (Some(a), None) => self.alone(ours[a], depth + 1, Standing::OnlyLeft),
                (None, Some(b)) => self.alone(theirs[b], depth + 1, Standing::OnlyRight),
                (None, None) => {}
            }
        }
        self.close(row);
    }

    fn aligned(&self, ours: &[EventId], theirs: &[EventId]) -> Vec<super::align::Aligned> {
        let names = |side: &Side, ids: &[EventId]| -> Vec<Name> {
            ids.iter().map(|&id| side.names[id as usize].clone()).collect()
        };
        let equal = |a: usize, b: usize| self.left.event(ours[a]).what == self.right.event(theirs[b]).what;
        align(&names(&self.left, ours), &names(&self.right, theirs), &equal)
    }

    /// An event of one tree alone, with all that is below it.
    fn alone(&mut self, id: EventId, depth: u32, standing: Standing) {
        let is_left = standing == Standing::OnlyLeft;
        let row = self.push(is_left.then_some(id), (!is_left).then_some(id), standing, depth);
        let children = if is_left { self.left.children(id) } else { self.right.children(id) };
        for child in children {
            self.alone(child, depth + 1, standing);
        }
        self.close(row);
    }

    fn push(&mut self, left: Option<EventId>, right: Option<EventId>, standing: Standing, depth: u32) -> usize {
        let different = u32::from(standing != Standing::Same);
        self.pairs.push(Pair { left, right, standing, depth, end: 0, different });
        self.pairs.len() - 1
    }

    /// Everything below a row is there: it is counted up.
    fn close(&mut self, row: usize) {
        let end = self.pairs.len();
        let depth = self.pairs[row].depth + 1;
        let mut below = row + 1;
        while below < end {
            if self.pairs[below].depth == depth {
                self.pairs[row].different += self.pairs[below].different;
            }
            below = (self.pairs[below].end as usize).max(below + 1);
        }
        self.pairs[row].end = u32::try_from(end).unwrap_or(u32::MAX);
    }
}
