//! Which events are looked for: by the ray, the object and the kind that they belong to, and by the words of their rows.

use super::index::Index;
use super::kind::Kind;
use crate::record::{EventId, RayKind};
use crate::trace::RayTree;
use crate::view::row;
use std::collections::BTreeSet;

/// Conditions that events have to meet, all at once. An empty set asks nothing.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Filter {
    /// The ray that an event belongs to is of one of these kinds.
    pub rays: BTreeSet<RayKind>,
    /// The event is about one of these objects.
    pub objects: BTreeSet<String>,
    /// The event is of one of these kinds.
    pub kinds: BTreeSet<Kind>,
    /// The event's row holds each of these words, in any case.
    pub text: String,
}

impl Filter {
    /// Whether it asks nothing.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.rays.is_empty() && self.objects.is_empty() && self.kinds.is_empty() && self.text.trim().is_empty()
    }

    /// For each event whether it meets the conditions; none where nothing is asked.
    ///
    /// Words are looked for in rows, which have to be written for that: a large tree takes a good part of a second.
    #[must_use]
    pub fn matches(&self, tree: &RayTree, index: &Index) -> Option<Vec<bool>> {
        if self.is_empty() {
            return None;
        }
        let words: Vec<String> = self.text.split_whitespace().map(str::to_lowercase).collect();
        let meets = |id| self.meets(index, id) && (words.is_empty() || says(tree, id, &words));
        Some((0..index.len()).map(meets).collect())
    }

    fn meets(&self, index: &Index, id: EventId) -> bool {
        let ray = self.rays.is_empty() || self.rays.contains(&index.scope(id).kind);
        let object = self.objects.is_empty() || index.object(id).is_some_and(|name| self.objects.contains(name));
        let kind = self.kinds.is_empty() || self.kinds.contains(&index.kind(id));
        ray && object && kind
    }
}

fn says(tree: &RayTree, id: EventId, words: &[String]) -> bool {
    let row = row(tree.event(id));
    let text = format!("{} {}", row.label, row.numbers).to_lowercase();
    words.iter().all(|word| text.contains(word.as_str()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::story::testing::small;

    fn found(filter: &Filter) -> Vec<EventId> {
        let tree = small();
        let matches = filter.matches(&tree, &Index::of(&tree)).unwrap();
        (0..tree.end()).filter(|&id| matches[id as usize]).collect()
    }

    #[test]
    fn nothing_asked_is_no_filter() {
        let tree = small();
        assert!(Filter { text: "  ".to_owned(), ..Filter::default() }.is_empty());
        assert_eq!(Filter::default().matches(&tree, &Index::of(&tree)), None);
    }

    #[test]
    fn a_kind_of_ray_finds_all_that_happens_to_such_rays() {
        assert_eq!(found(&Filter { rays: [RayKind::Reflected].into(), ..Filter::default() }), [7, 8, 9, 10]);
    }

    #[test]
    fn conditions_hold_at_once() {
        let object_a = Filter { objects: ["a".to_owned()].into(), ..Filter::default() };
        assert_eq!(found(&object_a), [2, 3, 4, 8, 9]);
        let primitives_of_a = Filter { kinds: [Kind::Primitive].into(), ..object_a.clone() };
        assert_eq!(found(&primitives_of_a), [3, 4, 9]);
        assert_eq!(found(&Filter { text: "SPHERE p:".to_owned(), ..primitives_of_a }), [3, 9]);
    }
}
