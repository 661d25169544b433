//! An event's place that outlives changes of the program: its number, and the kinds of all events down to it as a check.

use crate::record::EventId;
use crate::story::Kind;
use crate::trace::RayTree;
use crate::view::row;

/// Where an event was.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct EventPlace {
    /// Its number.
    pub number: EventId,
    /// The kinds of the events above it, from the root down, and its own: `Pixel`, `Step`, `Hit`. Empty where the link says
    /// nothing of them.
    pub path: Vec<String>,
}

/// Where that event is now.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Found {
    /// Its number.
    pub event: EventId,
    /// What is to be said if it is not quite the event that was meant.
    pub notice: Option<String>,
}

impl EventPlace {
    /// The place of an event.
    #[must_use]
    pub fn of(tree: &RayTree, event: EventId) -> Self {
        Self { number: event, path: path_of(tree, event) }
    }

    /// The event there: the one of that number if its kinds are the same, else the nearest with as many of the same kinds above
    /// it as there are.
    #[must_use]
    pub fn find(&self, tree: &RayTree) -> Found {
        let last = tree.end().saturating_sub(1);
        if self.number <= last && (self.path.is_empty() || path_of(tree, self.number) == self.path) {
            return Found { event: self.number, notice: None };
        }
        let (event, alike) = nearest(tree, self);
        let now = tree.events.get(event as usize).map(|event| row(event).label).unwrap_or_default();
        let what = self.path.last().map_or_else(|| "event".to_owned(), |kind| format!("event ({kind})"));
        let how = if alike {
            "the nearest of its kind is shown"
        } else {
            "there is none of its kind at that place any more; the nearest one is shown"
        };
        let notice = format!(
            "the link's {what} {} is not where it was, because the scene or the program has changed since: {how}, {event}, “{now}”",
            self.number
        );
        Found { event, notice: Some(notice) }
    }
}

/// The nearest event with the most of the path in common, and whether that is all of it.
fn nearest(tree: &RayTree, place: &EventPlace) -> (EventId, bool) {
    // How many kinds each event's path shares with the wanted one from the root down.
    let mut shared: Vec<usize> = Vec::with_capacity(tree.events.len());
    let mut depths: Vec<usize> = Vec::with_capacity(tree.events.len());
    let mut best = (0, 0, false);
    for event in &tree.events {
        let above = event.parent.map(|parent| parent as usize).filter(|&parent| parent < depths.len());
        let depth = above.map_or(0, |parent| depths[parent] + 1);
        let before = above.map_or(0, |parent| shared[parent]);
        let fits = before == depth && place.path.get(depth).is_some_and(|kind| *kind == kind_name(tree, event.id));
        let now = before + usize::from(fits);
        depths.push(depth);
        shared.push(now);
        let whole = now == place.path.len() && depth + 1 == now;
        let distance = event.id.abs_diff(place.number);
        let is_better = (whole, now) > (best.2, best.0)
            || (whole, now) == (best.2, best.0) && distance < place.number.abs_diff(best.1);
        if is_better {
            best = (now, event.id, whole);
        }
    }
    (best.1, best.2 && !place.path.is_empty())
}

fn path_of(tree: &RayTree, event: EventId) -> Vec<String> {
    if event >= tree.end() {
        return Vec::new();
    }
    tree.path(event).into_iter().map(|id| kind_name(tree, id)).collect()
}

/// The name of an event's kind, as the program spells it: it changes with neither words nor language.
fn kind_name(tree: &RayTree, event: EventId) -> String {
    format!("{:?}", Kind::of(&tree.event(event).what))
}
