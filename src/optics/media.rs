//! Which transparent objects a ray is inside, and which of them it travels in (§ 6.4.1).

use smallvec::SmallVec;

/// Objects kept without a visit to the allocator. Fewer would send a fishbowl with fish there; more would make every
/// ray larger to copy.
const INLINE: usize = 4;

/// Which object wins where transparent objects overlap.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Policy {
    /// The one that was entered last.
    MostRecent,
    /// The one with the highest priority; among equals the one that was entered last.
    Priority,
}

/// The transparent objects that a ray is inside, in the order in which it entered them.
#[derive(Debug, Default, PartialEq, Eq)]
pub struct MediaStack {
    objects: SmallVec<[usize; INLINE]>,
}

/// Every ray has one, so it is copied as a block and not object by object.
impl Clone for MediaStack {
    #[inline]
    fn clone(&self) -> Self {
        if self.objects.is_empty() { Self::default() } else { Self { objects: SmallVec::from_slice(&self.objects) } }
    }
}

impl MediaStack {
    /// A ray outside everything.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// The ray goes into an object. One that it is already inside keeps its place.
    pub fn enter(&mut self, object: usize) {
        if self.contains(object) {
            return;
        }
        self.objects.push(object);
    }

    /// The ray comes out of an object. Leaving one that was never entered changes nothing.
    pub fn leave(&mut self, object: usize) {
        self.objects.retain(|inside| *inside != object);
    }

    /// Whether the ray is inside the object.
    #[must_use]
    pub fn contains(&self, object: usize) -> bool {
        self.objects.contains(&object)
    }

    /// Whether the ray is outside everything.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.objects.is_empty()
    }

    /// Whether objects overlap here: the ray is inside two or more.
    #[must_use]
    pub fn overlap(&self) -> bool {
        self.objects.len() > 1
    }

    /// The objects, in the order of entering.
    pub fn iter(&self) -> impl Iterator<Item = usize> {
        self.objects.iter().copied()
    }

    /// The object that the ray travels in; none outside everything.
    #[must_use]
    pub fn current(&self, policy: Policy, priority: impl Fn(usize) -> i32) -> Option<usize> {
        match policy {
            Policy::MostRecent => self.objects.last().copied(),
            // Of several largest, `max_by_key` gives the last.
            Policy::Priority => self.iter().max_by_key(|&object| priority(object)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn stack(objects: &[usize]) -> MediaStack {
        let mut stack = MediaStack::new();
        for &object in objects {
            stack.enter(object);
        }
        stack
    }

    fn listed(stack: &MediaStack) -> Vec<usize> {
        stack.iter().collect()
    }

    #[test]
    fn a_ray_outside_everything_travels_in_nothing() {
        assert_eq!(MediaStack::new().current(Policy::MostRecent, |_| 0), None);
        assert_eq!(MediaStack::new().current(Policy::Priority, |_| 0), None);
        assert!(!MediaStack::new().overlap());
    }

    #[test]
    fn the_most_recently_entered_object_wins_under_that_policy() {
        let mut inside = stack(&[3, 8]);
        assert_eq!(inside.current(Policy::MostRecent, |_| 0), Some(8));
        assert!(inside.overlap());
        inside.leave(8);
        assert_eq!(inside.current(Policy::MostRecent, |_| 0), Some(3));
        assert!(!inside.overlap());
    }

    #[test]
    fn the_highest_priority_wins_and_among_equals_the_most_recent() {
        let priority = |object| if object == 2 { 5 } else { 1 };
        assert_eq!(stack(&[2, 7]).current(Policy::Priority, priority), Some(2));
        assert_eq!(stack(&[4, 7]).current(Policy::Priority, priority), Some(7));
        assert_eq!(stack(&[4, 7]).current(Policy::Priority, |_| i32::MIN), Some(7));
    }

    #[test]
    fn objects_may_be_left_in_any_order() {
        let mut inside = stack(&[1, 2, 3]);
        inside.leave(1);
        assert_eq!(listed(&inside), [2, 3]);
        inside.leave(3);
        assert_eq!(listed(&inside), [2]);
    }

    #[test]
    fn leaving_what_was_never_entered_changes_nothing() {
        let mut inside = stack(&[1]);
        inside.leave(9);
        assert_eq!(listed(&inside), [1]);
        let mut outside = MediaStack::new();
        outside.leave(9);
        assert!(outside.is_empty());
    }

    #[test]
    fn entering_twice_counts_once() {
        let mut inside = stack(&[1, 2, 1]);
        assert_eq!(listed(&inside), [1, 2]);
        inside.leave(1);
        assert_eq!(listed(&inside), [2]);
    }

    #[test]
    fn more_objects_than_fit_inline_keep_their_order() {
        let mut inside = stack(&[10, 11, 12, 13, 14, 15]);
        assert_eq!(listed(&inside), [10, 11, 12, 13, 14, 15]);
        inside.leave(11);
        assert_eq!(listed(&inside), [10, 12, 13, 14, 15]);
        inside.leave(15);
        inside.leave(14);
        inside.leave(10);
        assert_eq!(listed(&inside), [12, 13]);
        inside.enter(16);
        assert_eq!(inside, stack(&[12, 13, 16]));
    }
}
