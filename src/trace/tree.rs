//! Keeps everything: the tree of a recorded pixel.

use crate::record::{Counter, Entry, Event, EventId, Recorder, Source, Triple, What};

/// Recordings end here, so that a hall of mirrors cannot fill the memory: about 100 MB of events. Smaller would cut
/// depth-12 glass scenes short; larger would make the workbench stall on a click.
const MOST_EVENTS: usize = 200_000;

/// The recorded events of one pixel (or loose ray): a flat arena in the order in which they happened.
#[derive(Clone, Debug, PartialEq)]
pub struct RayTree {
    /// The events; the first is the root, and each knows its parent.
    pub events: Vec<Event>,
}

impl RayTree {
    /// The linear colour that the root's ray brought back; of several samples their mean.
    #[must_use]
    pub fn colour(&self) -> Triple {
        let mean = self.children(0).find_map(|event| match &event.what {
            What::Average(average) => Some(average.colour),
            _ => None,
        });
        mean.unwrap_or_else(|| self.colour_of_ray())
    }

    fn colour_of_ray(&self) -> Triple {
        let steps = self.children(0).filter(|event| matches!(event.what, What::Step { .. }));
        let found = steps.flat_map(|step| self.children(step.id)).filter_map(|event| match &event.what {
            What::Colour { total, .. } => Some(*total),
            What::Nothing { background } => Some(*background),
            // Of a ray in a medium this comes last, and holds all of it.
            What::Passage(passage) => Some(passage.colour),
            _ => None,
        });
        found.last().unwrap_or_default()
    }

    /// The event with this number.
    #[must_use]
    pub fn event(&self, id: EventId) -> &Event {
        &self.events[id as usize]
    }

    /// The events directly below `id`, in order.
    pub fn children(&self, id: EventId) -> impl Iterator<Item = &Event> {
        self.events[id as usize + 1..].iter().filter(move |event| event.parent == Some(id))
    }

    /// The number after the last event below `id`: the events of its subtree are `id..end`.
    ///
    /// An event's descendants follow it directly, so the first later event whose parent comes before `id` ends them.
    #[must_use]
    pub fn subtree_end(&self, id: EventId) -> EventId {
        self.events[id as usize + 1..]
            .iter()
            .find(|event| event.parent.is_none_or(|parent| parent < id))
            .map_or(self.end(), |event| event.id)
    }

    /// The number after the last event.
    #[must_use]
    pub fn end(&self) -> EventId {
        EventId::try_from(self.events.len()).unwrap_or(EventId::MAX)
    }

    /// The events from the root down to `id`, `id` included.
    #[must_use]
    pub fn path(&self, id: EventId) -> Vec<EventId> {
        let mut path: Vec<_> = std::iter::successors(Some(id), |&id| self.event(id).parent).collect();
        path.reverse();
        path
    }

    /// How many events lie above `id`.
    #[must_use]
    pub fn depth(&self, id: EventId) -> usize {
        self.path(id).len() - 1
    }
}

/// A [`Recorder`] that keeps everything, up to a stated number of events.
#[derive(Debug, Default)]
pub struct TreeRecorder {
    events: Vec<Event>,
    open: Vec<Option<EventId>>,
    left_out: usize,
    is_measuring: bool,
}

impl TreeRecorder {
    /// A recorder that has heard nothing yet.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// The same, for lines of working that carry their true errors.
    #[must_use]
    pub fn measuring() -> Self {
        Self { is_measuring: true, ..Self::default() }
    }

    /// The tree. If the limit was met, the last event says what is missing.
    #[must_use]
    pub fn finish(mut self) -> RayTree {
        if self.left_out > 0 {
            self.report_left_out();
        }
        RayTree { events: self.events }
    }

    fn report_left_out(&mut self) {
        let (kept, met) = (self.events.len() as f64, (self.events.len() + self.left_out) as f64);
        let entry = Entry::new(What::Limit {
            limit: "recording size".to_owned(),
            at: kept,
            value: met,
            consequence: "later events were traced but not kept".to_owned(),
        });
        let id = EventId::try_from(self.events.len()).unwrap_or(EventId::MAX);
        self.events.push(Event { id, parent: Some(0), what: entry.what, working: entry.working, source: entry.source });
    }
}

/// Stands in for an event between its beginning and its description.
fn placeholder(id: EventId, parent: Option<EventId>) -> Event {
    let what = What::Step { number: 0, title: String::new() };
    Event { id, parent, what, working: Vec::new(), source: Source { file: "", line: 0 } }
}

impl Recorder for TreeRecorder {
    const RECORDING: bool = true;

    fn begin(&mut self) {
        // The first level says what came out, however little of the rest is kept.
        if self.events.len() >= MOST_EVENTS && self.open.len() > 1 {
            self.left_out += 1;
            self.open.push(None);
            return;
        }
        let id = EventId::try_from(self.events.len()).unwrap_or(EventId::MAX);
        let parent = self.open.iter().rev().find_map(|open| *open);
        self.events.push(placeholder(id, parent));
        self.open.push(Some(id));
    }

    fn end(&mut self, describe: impl FnOnce() -> Entry) {
        if let Some(Some(id)) = self.open.pop() {
            let entry = describe();
            let event = &mut self.events[id as usize];
            (event.what, event.working, event.source) = (entry.what, entry.working, entry.source);
        }
    }

    fn count(&mut self, _counter: Counter) {}

    fn is_measuring(&self) -> bool {
        self.is_measuring
    }
}
