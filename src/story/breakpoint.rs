//! Where stepping stops: questions that are asked of every event.

use crate::query::{PRESETS, Preset, Query, QueryError};
use crate::record::EventId;
use crate::trace::RayTree;

/// The questions that stand in the list from the beginning, by their keys.
const OFFERED: [&str; 6] = ["tir", "deep", "early-out", "rejected", "undecidable", "limit"];

/// A question with a switch.
#[derive(Clone, Debug, PartialEq)]
pub struct Breakpoint {
    /// What it is known as, if it is one of the questions that have names.
    pub preset: Option<Preset>,
    /// The question.
    pub query: Query,
    /// Whether stepping stops where it holds.
    pub enabled: bool,
    /// Where it holds in the tree that was asked last, ascending.
    pub hits: Vec<EventId>,
}

/// A list of breakpoints.
#[derive(Clone, Debug, PartialEq)]
pub struct Breakpoints {
    list: Vec<Breakpoint>,
}

impl Default for Breakpoints {
    /// The questions that are asked most, all of them off.
    fn default() -> Self {
        let offered = PRESETS.into_iter().filter(|preset| OFFERED.contains(&preset.key));
        let list = offered.filter_map(|preset| {
            let query = Query::parse(preset.query).ok()?;
            Some(Breakpoint { preset: Some(preset), query, enabled: false, hits: Vec::new() })
        });
        Self { list: list.collect() }
    }
}

impl Breakpoints {
    /// All of them.
    #[must_use]
    pub fn list(&self) -> &[Breakpoint] {
        &self.list
    }

    /// Adds a question, switched on, and asks it of a tree.
    ///
    /// # Errors
    /// Where the text is no question: the column and what was expected there.
    pub fn add(&mut self, text: &str, tree: Option<&RayTree>) -> Result<(), QueryError> {
        let query = Query::parse(text)?;
        if let Some(known) = self.list.iter_mut().find(|known| known.query == query) {
            known.enabled = true;
            return Ok(());
        }
        let hits = tree.map(|tree| query.matches(tree).collect()).unwrap_or_default();
        self.list.push(Breakpoint { preset: None, query, enabled: true, hits });
        Ok(())
    }

    /// Takes one away.
    pub fn remove(&mut self, place: usize) {
        if place < self.list.len() {
            self.list.remove(place);
        }
    }

    /// Switches one on or off.
    pub fn set_enabled(&mut self, place: usize, enabled: bool) {
        if let Some(breakpoint) = self.list.get_mut(place) {
            breakpoint.enabled = enabled;
        }
    }

    /// Whether any is switched on.
    #[must_use]
    pub fn any_enabled(&self) -> bool {
        self.list.iter().any(|breakpoint| breakpoint.enabled)
    }

    /// The questions of those that are switched on.
    #[must_use]
    pub fn questions(&self) -> Vec<Query> {
        self.list.iter().filter(|breakpoint| breakpoint.enabled).map(|breakpoint| breakpoint.query.clone()).collect()
    }

    /// Asks all questions of a tree.
    pub fn ask(&mut self, tree: &RayTree) {
        for breakpoint in &mut self.list {
            breakpoint.hits = breakpoint.query.matches(tree).collect();
        }
    }

    /// Takes over where the questions hold from the same list, asked elsewhere.
    pub fn take_hits(&mut self, asked: Self) {
        for answer in asked.list {
            if let Some(own) = self.list.iter_mut().find(|own| own.query == answer.query) {
                own.hits = answer.hits;
            }
        }
    }

    /// Where stepping stops: where one holds that is switched on, ascending.
    #[must_use]
    pub fn stops(&self) -> Vec<EventId> {
        let enabled = self.list.iter().filter(|breakpoint| breakpoint.enabled);
        let mut stops: Vec<EventId> = enabled.flat_map(|breakpoint| breakpoint.hits.iter().copied()).collect();
        stops.sort_unstable();
        stops.dedup();
        stops
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::story::testing::fishbowl;

    #[test]
    fn every_question_that_is_offered_is_understood() {
        assert_eq!(Breakpoints::default().list().len(), OFFERED.len());
        assert!(!Breakpoints::default().any_enabled());
    }

    #[test]
    fn stepping_stops_where_one_of_those_holds_that_are_on() {
        let tree = fishbowl();
        let mut breakpoints = Breakpoints::default();
        breakpoints.ask(&tree);
        assert!(breakpoints.stops().is_empty());
        let deep = breakpoints.list().iter().position(|one| one.query == "ray & depth>=3".parse().unwrap()).unwrap();
        breakpoints.set_enabled(deep, true);
        breakpoints.add("hit", Some(&tree)).unwrap();
        let stops = breakpoints.stops();
        let [rays, hits] = ["ray & depth>=3", "hit"].map(|text| text.parse::<Query>().unwrap());
        let mut expected: Vec<EventId> = rays.matches(&tree).chain(hits.matches(&tree)).collect();
        expected.sort_unstable();
        assert!(!expected.is_empty());
        assert_eq!(stops, expected);
    }

    #[test]
    fn a_question_that_is_in_the_list_is_switched_on_and_not_added_again() {
        let mut breakpoints = Breakpoints::default();
        breakpoints.add("tir", None).unwrap();
        assert_eq!(breakpoints.list().len(), OFFERED.len());
        assert!(breakpoints.any_enabled());
        assert!(breakpoints.add("kind=", None).is_err());
        breakpoints.remove(0);
        assert_eq!(breakpoints.list().len(), OFFERED.len() - 1);
    }
}
