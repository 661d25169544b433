//! Two trees laid side by side, event by event.
//!
//! The roots belong together. Of the parts of two events that belong together, those do that tell of the same thing and stand
//! in the same order: the longest common subsequence of both lists.

use super::parting::{self, Parting};
use crate::record::{Event, EventId, What};
use crate::trace::RayTree;
use std::mem::{Discriminant, discriminant};

/// Longer lists are paired only as far as they begin and end alike: the table would have more entries than this.
const MOST_ENTRIES: usize = 1_000_000;

/// For each event of a tree the same one in the exact tree, and where they part.
pub fn pair(tree: &RayTree, exact: &RayTree) -> (Vec<Option<EventId>>, Option<Parting>) {
    let mut pairing = Pairing {
        trees: [tree, exact],
        children: [children(tree), children(exact)],
        twins: vec![None; tree.events.len()],
        parting: None,
    };
    if !tree.events.is_empty() && !exact.events.is_empty() {
        pairing.pair([0, 0]);
    }
    (pairing.twins, pairing.parting)
}

/// The parts of every event, in order.
fn children(tree: &RayTree) -> Vec<Vec<EventId>> {
    let mut children = vec![Vec::new(); tree.events.len()];
    for event in &tree.events {
        if let Some(parent) = event.parent {
            children[parent as usize].push(event.id);
        }
    }
    children
}

struct Pairing<'a> {
    trees: [&'a RayTree; 2],
    children: [Vec<Vec<EventId>>; 2],
    twins: Vec<Option<EventId>>,
    parting: Option<Parting>,
}

impl Pairing<'_> {
    fn pair(&mut self, ids: [EventId; 2]) {
        self.twins[ids[0] as usize] = Some(ids[1]);
        let [event, exact] = [self.trees[0].event(ids[0]), self.trees[1].event(ids[1])];
        if self.parting.is_none() {
            self.parting = parting::between(event, exact);
        }
        let lists: [Vec<EventId>; 2] = std::array::from_fn(|k| self.children[k][ids[k] as usize].clone());
        let keys: [Vec<Key>; 2] =
            std::array::from_fn(|k| lists[k].iter().map(|&id| Key::of(self.trees[k].event(id))).collect());
        for step in common(&keys[0], &keys[1]) {
            match step {
                [Some(a), Some(b)] => self.pair([lists[0][a], lists[1][b]]),
                [Some(a), None] => self.part(parting::only_here(self.trees[0].event(lists[0][a]))),
                [None, Some(b)] => self.part(parting::only_exactly(self.trees[1].event(lists[1][b]), ids[0])),
                [None, None] => {}
            }
        }
    }

    fn part(&mut self, parting: Option<Parting>) {
        if self.parting.is_none() {
            self.parting = parting;
        }
    }
}

/// What tells of the same thing: the kind of an event, and the name of what it is about.
#[derive(Clone, Copy, PartialEq)]
struct Key<'a> {
    kind: Discriminant<What>,
    about: &'a str,
    number: usize,
}

impl<'a> Key<'a> {
    fn of(event: &'a Event) -> Self {
        let (about, number) = match &event.what {
            What::Object { name, index, .. } => (name.as_str(), *index),
            What::Primitive { name, leaf, .. } => (name.as_str(), *leaf),
            What::Transform { of, .. } | What::Extent { of, .. } | What::Ball { of, .. } => (of.as_str(), 0),
            What::Combine { name, .. } | What::Light { name, .. } => (name.as_str(), 0),
            What::Rejected { leaf, part, .. } => (leaf.as_str(), part.len()),
            What::Shadow { object, .. } => (object.as_str(), 0),
            What::Ray { ray, .. } => (ray.name(), 0),
            What::Step { number, .. } => ("", usize::from(*number)),
            What::Sample(sample) => ("", sample.number as usize),
            _ => ("", 0),
        };
        Self { kind: discriminant(&event.what), about, number }
    }
}

/// Both lists in one, in order: places of what is common, and of what is in one list alone.
fn common<T: PartialEq>(a: &[T], b: &[T]) -> Vec<[Option<usize>; 2]> {
    let head = a.iter().zip(b).take_while(|(a, b)| a == b).count();
    let (rest_a, rest_b) = (&a[head..], &b[head..]);
    let tail = rest_a.iter().rev().zip(rest_b.iter().rev()).take_while(|(a, b)| a == b).count();
    let (middle_a, middle_b) = (&rest_a[..rest_a.len() - tail], &rest_b[..rest_b.len() - tail]);
    let mut steps: Vec<_> = (0..head).map(|k| [Some(k), Some(k)]).collect();
    steps.extend(common_middle(middle_a, middle_b).into_iter().map(|step| step.map(|k| k.map(|k| k + head))));
    steps.extend((0..tail).map(|k| [Some(a.len() - tail + k), Some(b.len() - tail + k)]));
    steps
}

fn common_middle<T: PartialEq>(a: &[T], b: &[T]) -> Vec<[Option<usize>; 2]> {
    let apart = || (0..b.len()).map(|k| [None, Some(k)]).chain((0..a.len()).map(|k| [Some(k), None])).collect();
    if a.is_empty() || b.is_empty() || a.len() * b.len() > MOST_ENTRIES {
        return apart();
    }
    // The length of what is common behind each pair of places.
    let width = b.len() + 1;
    let mut length = vec![0_u32; (a.len() + 1) * width];
    for i in (0..a.len()).rev() {
        for j in (0..b.len()).rev() {
            length[i * width + j] = if a[i] == b[j] {
                length[(i + 1) * width + j + 1] + 1
            } else {
                length[(i + 1) * width + j].max(length[i * width + j + 1])
            };
        }
    }
    let (mut i, mut j, mut steps) = (0, 0, Vec::new());
    while i < a.len() || j < b.len() {
        let is_common = i < a.len() && j < b.len() && a[i] == b[j];
        let only_b = j < b.len() && (i == a.len() || length[i * width + j + 1] >= length[(i + 1) * width + j]);
        if is_common {
            steps.push([Some(i), Some(j)]);
            (i, j) = (i + 1, j + 1);
        } else if only_b {
            steps.push([None, Some(j)]);
            j += 1;
        } else {
            steps.push([Some(i), None]);
            i += 1;
        }
    }
    steps
}

#[cfg(test)]
mod tests {
    use super::*;

    fn spelled(a: &str, b: &str) -> String {
        let (a, b): (Vec<char>, Vec<char>) = (a.chars().collect(), b.chars().collect());
        let steps = common(&a, &b);
        steps
            .into_iter()
            .map(|step| match step {
                [Some(i), Some(j)] => {
                    assert_eq!(a[i], b[j]);
                    a[i].to_string()
                }
                [Some(i), None] => format!("+{}", a[i]),
                [None, Some(j)] => format!("-{}", b[j]),
                [None, None] => panic!("a step to nowhere"),
            })
            .collect()
    }

    #[test]
    fn lists_are_laid_side_by_side_where_they_agree() {
        assert_eq!(spelled("abc", "abc"), "abc");
        assert_eq!(spelled("ac", "abc"), "a-bc");
        assert_eq!(spelled("axc", "abc"), "a-b+xc");
        assert_eq!(spelled("abcd", "bd"), "+ab+cd");
        assert_eq!(spelled("", "ab"), "-a-b");
        assert_eq!(spelled("xabcy", "zabc"), "-z+xabc+y");
    }
}
