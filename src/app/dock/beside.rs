//! Panels beside one that stays in front: what a lesson shows must not hide the lesson, nor one drawing the other.

use super::{Dock, Wish};
use crate::app::pane::Pane;
use egui_tiles::TileId;

/// Beside these panels there is room for drawings; the first that is there comes first.
const HOSTS: [Pane; 9] = [
    Pane::Along,
    Pane::Side,
    Pane::Overview,
    Pane::Signs,
    Pane::Intervals,
    Pane::Generic,
    Pane::Detail,
    Pane::Properties,
    Pane::Story,
];

impl Dock {
    /// Brings panels to the front, each in a place of its own as far as there are places, and none in that of `kept`.
    pub fn show_beside(&mut self, panes: &[Pane], kept: Pane) {
        if self.is_being_shown() {
            self.waiting.push(Wish::Beside(panes.to_vec(), kept));
            return;
        }
        if self.alone.is_some_and(|alone| alone != kept && !panes.is_empty()) {
            self.alone = None;
        }
        let mut taken: Vec<TileId> = self.home_of(kept).into_iter().collect();
        for &pane in panes {
            let own = self.home_of(pane).filter(|home| !taken.contains(home));
            let free = || HOSTS.into_iter().filter_map(|host| self.home_of(host)).find(|home| !taken.contains(home));
            let Some(home) = own.or_else(free) else { continue };
            self.put(pane, home);
            taken.push(home);
        }
    }

    /// Brings a panel to the front where it lies, unless it would cover `kept`. One that is not in the layout stays away.
    pub fn uncover(&mut self, pane: Pane, kept: Pane) {
        if self.is_being_shown() {
            self.waiting.push(Wish::Uncover(pane, kept));
            return;
        }
        let Some(home) = self.home_of(pane).filter(|home| Some(*home) != self.home_of(kept)) else { return };
        self.put(pane, home);
    }

    /// The tabs that a panel is one of.
    fn home_of(&self, pane: Pane) -> Option<TileId> {
        self.tree().tiles.parent_of(self.tile_of(pane)?)
    }

    /// Makes a panel the seen one of these tabs.
    fn put(&mut self, pane: Pane, home: TileId) {
        let is_there = self.home_of(pane) == Some(home);
        let known = self.tile_of(pane);
        let tree = self.tree_mut();
        let tile = known.unwrap_or_else(|| tree.tiles.insert_pane(pane));
        if !is_there {
            tree.move_tile_to_container(tile, home, usize::MAX, false);
        }
        tree.make_active(|id, _| id == tile);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::dock::Preset;

    #[test]
    fn drawings_are_seen_together_and_the_lesson_stays() {
        for preset in [Preset::Learn, Preset::Lesson, Preset::Inspect] {
            let mut dock = Dock::default();
            dock.choose(preset);
            dock.reveal(Pane::Lesson);
            for panes in [[Pane::Side, Pane::Signs], [Pane::Generic, Pane::Along], [Pane::Overview, Pane::Side]] {
                dock.show_beside(&panes, Pane::Lesson);
                assert!(dock.shows(Pane::Lesson), "{preset:?} {panes:?}");
                for pane in panes {
                    assert!(dock.shows(pane), "{preset:?} {pane:?}");
                }
            }
        }
    }

    #[test]
    fn a_panel_is_uncovered_where_it_lies_but_never_covers_the_lesson() {
        let mut dock = Dock::default();
        dock.choose(Preset::Lesson);
        dock.reveal(Pane::Editor);
        dock.uncover(Pane::Story, Pane::Lesson);
        assert!(dock.shows(Pane::Story) && dock.shows(Pane::Lesson));
        dock.choose(Preset::Learn);
        dock.reveal(Pane::Lesson);
        dock.uncover(Pane::Story, Pane::Lesson);
        assert!(dock.shows(Pane::Lesson) && !dock.shows(Pane::Story), "both lie in the same tabs");
    }

    #[test]
    fn a_panel_that_was_closed_comes_back_beside_the_lesson() {
        let mut dock = Dock::default();
        dock.choose(Preset::Lesson);
        dock.reveal(Pane::Lesson);
        dock.close(Pane::Side);
        dock.show_beside(&[Pane::Side], Pane::Lesson);
        assert!(dock.shows(Pane::Side) && dock.shows(Pane::Lesson));
    }
}
