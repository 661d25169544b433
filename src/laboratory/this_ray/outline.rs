//! The tree of a ray as an outline, with what every method has right.

use super::{Story, ThisRay, Told};
use crate::record::{Event, EventId, What};

/// A row: an event of the exact tree.
#[derive(Clone, Debug)]
pub struct OutlineRow<'a> {
    /// The event.
    pub event: &'a Event,
    /// How many events lie above it.
    pub depth: usize,
    /// By each method: the same event in its tree, and what there is to tell of it; none where it has none.
    pub by_method: Vec<Option<(EventId, &'a Told)>>,
}

impl ThisRay {
    /// The events of the exact tree whose numbers can be told to be right or wrong, and those above them, in order.
    #[must_use]
    pub fn outline(&self) -> Vec<OutlineRow<'_>> {
        let twins: Vec<_> = self.stories.iter().map(|story| of_exact(story, self.exact.events.len())).collect();
        let told = |story: usize, id: EventId| {
            twins[story][id as usize].map(|own| (own, &self.stories[story].told[own as usize]))
        };
        let mut is_shown = vec![false; self.exact.events.len()];
        // Descendants follow the event that they are part of.
        for event in self.exact.events.iter().rev() {
            let has_numbers =
                (0..self.stories.len()).any(|k| told(k, event.id).is_some_and(|(_, told)| told.right.is_some()));
            let is_missing =
                has_numbers_by_itself(event) && (0..self.stories.len()).any(|k| told(k, event.id).is_none());
            if has_numbers || is_missing || is_shown[event.id as usize] {
                is_shown[event.id as usize] = true;
                if let Some(parent) = event.parent {
                    is_shown[parent as usize] = true;
                }
            }
        }
        let shown = self.exact.events.iter().filter(|event| is_shown[event.id as usize]);
        shown
            .map(|event| OutlineRow {
                event,
                depth: self.exact.depth(event.id),
                by_method: (0..self.stories.len()).map(|k| told(k, event.id)).collect(),
            })
            .collect()
    }
}

/// For each event of the exact tree the same one in a story's tree.
fn of_exact(story: &Story, count: usize) -> Vec<Option<EventId>> {
    let mut own = vec![None; count];
    for (id, twin) in (0..).zip(&story.twins) {
        if let Some(twin) = twin {
            own[*twin as usize] = Some(id);
        }
    }
    own
}

/// Whether it would be missed: a hit or what follows from it.
fn has_numbers_by_itself(event: &Event) -> bool {
    matches!(
        event.what,
        What::Hit { .. } | What::Ray { .. } | What::Colour { .. } | What::Roots { .. } | What::Nothing { .. }
    )
}
