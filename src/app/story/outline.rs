//! Which events of a tree are shown as rows: children, depths, and what is folded away.

use crate::record::{Event, EventId, What};
use crate::trace::RayTree;

/// A recorded tree as an outline whose branches open and close.
///
/// A tree holds up to hundreds of thousands of events, so the children are listed once, and the rows are listed again
/// only when a branch opens or closes.
#[derive(Debug, Default)]
pub struct Outline {
    children: Vec<Vec<EventId>>,
    depths: Vec<u16>,
    open: Vec<bool>,
    rows: Vec<EventId>,
}

impl Outline {
    /// The outline of a tree, the six steps open and the working behind them folded away.
    #[must_use]
    pub fn new(tree: &RayTree) -> Self {
        let mut children = vec![Vec::new(); tree.events.len()];
        let mut depths = vec![0; tree.events.len()];
        for event in &tree.events {
            if let Some(parent) = event.parent {
                children[parent as usize].push(event.id);
                depths[event.id as usize] = depths[parent as usize] + 1;
            }
        }
        let open = tree.events.iter().map(is_open_at_first).collect();
        let mut outline = Self { children, depths, open, rows: Vec::new() };
        outline.list_rows();
        outline
    }

    /// The rows that are shown, from the top.
    #[must_use]
    pub fn rows(&self) -> &[EventId] {
        &self.rows
    }

    /// The place of an event among the rows; none while it is folded away.
    #[must_use]
    pub fn row_of(&self, id: EventId) -> Option<usize> {
        // Rows ascend: an event's parts follow it, in order.
        self.rows.binary_search(&id).ok()
    }

    /// How many events lie above this one.
    #[must_use]
    pub fn depth(&self, id: EventId) -> u16 {
        self.depths[id as usize]
    }

    /// The parts of an event.
    #[must_use]
    pub fn children(&self, id: EventId) -> &[EventId] {
        &self.children[id as usize]
    }

    /// Whether an event's parts are shown; none if it has no parts.
    #[must_use]
    pub fn is_open(&self, id: EventId) -> Option<bool> {
        (!self.children(id).is_empty()).then_some(self.open[id as usize])
    }

    /// Opens or closes an event.
    pub fn set_open(&mut self, id: EventId, open: bool) {
        if self.open[id as usize] != open {
            self.open[id as usize] = open;
            self.list_rows();
        }
    }

    /// Opens everything above an event, so that it has a row.
    pub fn reveal(&mut self, tree: &RayTree, id: EventId) {
        let mut changed = false;
        for above in std::iter::successors(tree.event(id).parent, |&above| tree.event(above).parent) {
            changed |= !std::mem::replace(&mut self.open[above as usize], true);
        }
        if changed {
            self.list_rows();
        }
    }

    /// Opens every event.
    pub fn open_all(&mut self) {
        self.open.fill(true);
        self.list_rows();
    }

    /// Goes back to what was open at first.
    pub fn close_working(&mut self, tree: &RayTree) {
        self.open = tree.events.iter().map(is_open_at_first).collect();
        self.list_rows();
    }

    fn list_rows(&mut self) {
        self.rows.clear();
        let mut waiting: Vec<EventId> = if self.children.is_empty() { Vec::new() } else { vec![0] };
        while let Some(id) = waiting.pop() {
            self.rows.push(id);
            if self.open[id as usize] {
                waiting.extend(self.children[id as usize].iter().rev());
            }
        }
    }
}

/// A story of five to nine lines at first: the steps, and the objects that the ray goes through.
fn is_open_at_first(event: &Event) -> bool {
    match &event.what {
        What::Pixel { .. } | What::LooseRay { .. } | What::Step { .. } => true,
        What::Object { intervals, .. } => *intervals > 0,
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::{Entry, Recorder};
    use crate::trace::TreeRecorder;

    fn object(name: &str, intervals: usize) -> Entry {
        Entry::new(What::Object { index: 0, name: name.to_owned(), intervals })
    }

    /// Pixel ┬ hit ┬ part
    ///       │     └ part
    ///       └ missed ─ part
    fn tree() -> RayTree {
        let mut recorder = TreeRecorder::new();
        let part = || object("part", 0);
        recorder.begin();
        recorder.begin();
        recorder.note(part);
        recorder.note(part);
        recorder.end(|| object("hit", 1));
        recorder.begin();
        recorder.note(part);
        recorder.end(|| object("missed", 0));
        recorder.end(|| Entry::new(What::Pixel { x: 0, y: 0, width: 1, height: 1 }));
        recorder.finish()
    }

    #[test]
    fn what_was_hit_is_open_and_what_was_missed_is_folded() {
        let outline = Outline::new(&tree());
        assert_eq!(outline.rows(), [0, 1, 2, 3, 4]);
        assert_eq!(outline.is_open(1), Some(true));
        assert_eq!(outline.is_open(4), Some(false));
        assert_eq!(outline.is_open(2), None);
    }

    #[test]
    fn revealing_an_event_gives_it_a_row() {
        let tree = tree();
        let mut outline = Outline::new(&tree);
        assert_eq!(outline.row_of(5), None);
        outline.reveal(&tree, 5);
        assert_eq!(outline.row_of(5), Some(5));
    }

    #[test]
    fn closing_an_event_takes_its_parts_away_and_nothing_else() {
        let mut outline = Outline::new(&tree());
        outline.set_open(1, false);
        assert_eq!(outline.rows(), [0, 1, 4]);
        outline.open_all();
        assert_eq!(outline.rows(), [0, 1, 2, 3, 4, 5]);
        assert_eq!([0, 1, 2].map(|id| outline.depth(id)), [0, 1, 2]);
    }
}
