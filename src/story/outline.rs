//! Which rows are listed: those whose branches are open, and the selected one whatever its level.

use super::index::Index;
use super::level::Level;
use super::shown::Shown;
use crate::record::{EventId, RayKind, What};
use crate::trace::RayTree;

/// Rays further than this from the camera ray are folded at first: a glass has hundreds of them.
const OPEN_RAYS: u32 = 2;

/// The rows of a tree, from the top, and which branches are open.
///
/// The rows are a flat ascending list. Opening or closing a branch moves what is below it and touches nothing else.
#[derive(Debug)]
pub struct Outline {
    open: Vec<bool>,
    listed: Vec<EventId>,
    /// A selected event that has no row of its own at this level, with its place among the rows.
    guest: Option<(usize, EventId)>,
}

impl Outline {
    /// The outline with those branches open that begin a story.
    #[must_use]
    pub fn new(tree: &RayTree, index: &Index, shown: &Shown, level: Level) -> Self {
        let open = tree.events.iter().map(|event| is_open_at_first(&event.what, level)).collect();
        let mut outline = Self { open, listed: Vec::new(), guest: None };
        outline.list(index, shown);
        outline
    }

    /// How many rows there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.listed.len() + usize::from(self.guest.is_some())
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The event of a row, from the top.
    #[must_use]
    pub fn row(&self, place: usize) -> Option<EventId> {
        match self.guest {
            Some((at, id)) if place == at => Some(id),
            Some((at, _)) if place > at => self.listed.get(place - 1).copied(),
            _ => self.listed.get(place).copied(),
        }
    }

    /// The place of an event among the rows; none while it is folded away.
    #[must_use]
    pub fn row_of(&self, id: EventId) -> Option<usize> {
        match self.guest {
            Some((at, guest)) if guest == id => Some(at),
            Some((at, _)) => self.listed.binary_search(&id).ok().map(|place| place + usize::from(place >= at)),
            None => self.listed.binary_search(&id).ok(),
        }
    }

    /// Whether an event has a row only because it is selected.
    #[must_use]
    pub fn is_guest(&self, id: EventId) -> bool {
        self.guest.is_some_and(|(_, guest)| guest == id)
    }

    /// Whether the rows below this one are shown; none if there are none.
    #[must_use]
    pub fn is_open(&self, index: &Index, shown: &Shown, id: EventId) -> Option<bool> {
        let has_rows = !self.is_guest(id) && !shown.rows_between(id, index.end(id)).is_empty();
        has_rows.then_some(self.open[id as usize])
    }

    /// How many events are told by this row alone: those without a row, and where it is closed all that is folded away.
    #[must_use]
    pub fn inside(&self, index: &Index, shown: &Shown, id: EventId) -> u32 {
        match self.is_open(index, shown, id) {
            Some(true) => shown.untold(id),
            _ => index.end(id) - id - 1,
        }
    }

    /// Opens or closes a row.
    pub fn set_open(&mut self, index: &Index, shown: &Shown, id: EventId, open: bool) {
        if std::mem::replace(&mut self.open[id as usize], open) == open {
            return;
        }
        self.guest = None;
        let Ok(place) = self.listed.binary_search(&id) else { return };
        let end = index.end(id);
        let below = place + 1..self.listed.partition_point(|&row| row < end);
        if open {
            let mut rows = Vec::new();
            self.collect(index, shown.rows_between(id, end), &mut rows);
            self.listed.splice(below, rows);
        } else {
            self.listed.drain(below);
        }
    }

    /// Opens everything above an event, and gives it a row even where the level or the filter does not.
    pub fn reveal(&mut self, index: &Index, shown: &Shown, id: EventId) {
        self.guest = None;
        let above = std::iter::successors(shown.parent(id), |&above| shown.parent(above));
        let closed: Vec<EventId> = above.filter(|&above| !self.open[above as usize]).collect();
        for &id in closed.iter().rev() {
            self.set_open(index, shown, id, true);
        }
        if let Err(place) = self.listed.binary_search(&id) {
            self.guest = Some((place, id));
        }
    }

    /// Opens or closes all rows.
    pub fn set_all(&mut self, index: &Index, shown: &Shown, open: bool) {
        self.open.fill(open);
        // An outline of one row would say nothing.
        self.open[..1].fill(true);
        self.list(index, shown);
    }

    /// Lists the rows anew: others are shown.
    pub fn list(&mut self, index: &Index, shown: &Shown) {
        let mut rows = std::mem::take(&mut self.listed);
        rows.clear();
        self.collect(index, shown.rows(), &mut rows);
        self.listed = rows;
        self.guest = None;
    }

    /// Of `rows`, those that no closed branch among them hides.
    fn collect(&self, index: &Index, mut rows: &[EventId], into: &mut Vec<EventId>) {
        while let [id, rest @ ..] = rows {
            into.push(*id);
            rows = if self.open[*id as usize] {
                rest
            } else {
                let end = index.end(*id);
                &rest[rest.partition_point(|&row| row < end)..]
            };
        }
    }
}

/// At first a story of five to nine rows is seen, and at the other levels the steps and the objects that the ray goes through.
fn is_open_at_first(what: &What, level: Level) -> bool {
    match what {
        What::Pixel { .. } | What::LooseRay { .. } | What::Step { .. } => true,
        What::Sample(sample) => sample.number == 0,
        What::Ray { ray, depth, .. } => level == Level::Story && *ray != RayKind::Camera && *depth <= OPEN_RAYS,
        What::Object { intervals, .. } => level == Level::Story || *intervals > 0,
        What::Wavelength(wavelength) => wavelength.number == 0,
        _ => level == Level::Story,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::story::filter::Filter;
    use crate::story::testing::{fishbowl, small};

    struct Fixture {
        index: Index,
        shown: Shown,
        outline: Outline,
    }

    impl Fixture {
        fn of(tree: &RayTree, level: Level) -> Self {
            let index = Index::of(tree);
            let shown = Shown::with(tree, &index, level, &Filter::default());
            let outline = Outline::new(tree, &index, &shown, level);
            Self { index, shown, outline }
        }

        fn rows(&self) -> Vec<EventId> {
            (0..self.outline.len()).filter_map(|place| self.outline.row(place)).collect()
        }

        fn set_open(&mut self, id: EventId, open: bool) {
            self.outline.set_open(&self.index, &self.shown, id, open);
        }

        fn reveal(&mut self, id: EventId) {
            self.outline.reveal(&self.index, &self.shown, id);
        }
    }

    #[test]
    fn what_was_hit_is_open_and_what_was_missed_is_folded() {
        let fixture = Fixture::of(&small(), Level::Everything);
        assert_eq!(fixture.rows(), [0, 1, 2, 3, 4, 5, 7, 11]);
        let is_open = |id| fixture.outline.is_open(&fixture.index, &fixture.shown, id);
        assert_eq!([2, 5, 3].map(is_open), [Some(true), Some(false), None]);
    }

    #[test]
    fn opening_and_closing_lists_the_same_rows_as_listing_anew() {
        let tree = fishbowl();
        for level in Level::ALL {
            let mut fixture = Fixture::of(&tree, level);
            for turn in 0..200_u32 {
                let id = turn.wrapping_mul(2_654_435_761) % tree.end();
                let open = fixture.outline.open[id as usize];
                fixture.set_open(id, !open);
                let before = fixture.rows();
                fixture.outline.list(&fixture.index, &fixture.shown);
                assert_eq!(fixture.rows(), before, "after {id} at {level:?}");
            }
        }
    }

    #[test]
    fn a_revealed_event_has_a_row_at_every_level_and_takes_it_along_when_it_goes() {
        for level in Level::ALL {
            let mut fixture = Fixture::of(&small(), level);
            for id in [6, 9, 3, 0] {
                fixture.reveal(id);
                let place = fixture.outline.row_of(id).expect("it has a row");
                assert_eq!(fixture.outline.row(place), Some(id));
                assert!(fixture.rows().is_sorted());
            }
            assert!(!fixture.rows().contains(&6) || level != Level::Story);
        }
    }

    #[test]
    fn a_closed_row_counts_all_that_it_folds_away_and_an_open_one_what_has_no_row() {
        let mut fixture = Fixture::of(&small(), Level::Story);
        let inside = |fixture: &Fixture, id| fixture.outline.inside(&fixture.index, &fixture.shown, id);
        assert_eq!((inside(&fixture, 7), inside(&fixture, 0)), (2, 5));
        fixture.set_open(7, false);
        assert_eq!(inside(&fixture, 7), 3);
    }

    #[test]
    fn closing_all_leaves_the_beginning() {
        let mut fixture = Fixture::of(&small(), Level::Everything);
        fixture.outline.set_all(&fixture.index, &fixture.shown, false);
        assert_eq!(fixture.rows(), [0, 1, 2, 5, 7, 11]);
        fixture.outline.set_all(&fixture.index, &fixture.shown, true);
        assert_eq!(fixture.rows().len(), 12);
    }
}
