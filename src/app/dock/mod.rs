//! Where the panels lie: docked, behind each other as tabs, resized; one layout for each purpose, each kept as it was left.

mod behaviour;
mod beside;
mod header;
mod preset;
mod resize;

pub use behaviour::show;
pub use preset::Preset;

use crate::app::pane::Pane;
use egui::{Context, Id, Rect, Vec2};
use egui_tiles::{Container, SimplificationOptions, Tile, TileId, Tree};
use serde::{Deserialize, Serialize};

/// How many columns of panels there is room for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Room {
    /// One: on a phone, or on a tablet that is held upright.
    OneColumn,
    /// Two: on a phone that lies, or in a frame of a page.
    TwoColumns,
    /// As many as the layout has.
    #[default]
    Enough,
}

impl Room {
    /// In windows of this size, in points.
    #[must_use]
    pub fn of(window: Vec2) -> Self {
        let is_upright = window.y > window.x;
        match window.x {
            ..640.0 => Self::OneColumn,
            ..900.0 if is_upright => Self::OneColumn,
            ..900.0 => Self::TwoColumns,
            _ => Self::Enough,
        }
    }
}

/// All layouts.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Dock {
    preset: Preset,
    layouts: [Tree<Pane>; Preset::ALL.len()],
    /// For windows that are too narrow for any of them: in one column, and in two.
    #[serde(skip, default = "preset::few_columns")]
    few_columns: [Tree<Pane>; 2],
    #[serde(skip)]
    room: Room,
    /// The panel that has the window to itself.
    #[serde(skip)]
    alone: Option<Pane>,
    /// The panel that was used last.
    #[serde(skip)]
    current: Option<Pane>,
    /// What was asked for while the panels were being shown.
    #[serde(skip)]
    waiting: Vec<Wish>,
}

/// A change of the layout that a panel asks for.
#[derive(Clone, Debug)]
enum Wish {
    Choose(Preset),
    Reveal(Pane),
    Uncover(Pane, Pane),
    Beside(Vec<Pane>, Pane),
    ToggleAlone(Pane),
}

impl Default for Dock {
    fn default() -> Self {
        let layouts = Preset::ALL.map(Preset::layout);
        Self {
            preset: Preset::default(),
            layouts,
            few_columns: preset::few_columns(),
            room: Room::default(),
            alone: None,
            current: None,
            waiting: Vec::new(),
        }
    }
}

impl Dock {
    /// The layout that is shown.
    #[must_use]
    pub const fn preset(&self) -> Preset {
        self.preset
    }

    /// Says how much room there is: where there is little, another layout takes the place of all.
    pub const fn fit(&mut self, room: Room) {
        self.room = room;
    }

    /// How much room there is.
    #[must_use]
    pub const fn room(&self) -> Room {
        self.room
    }

    /// Shows another layout, as it was left.
    pub fn choose(&mut self, preset: Preset) {
        if self.is_being_shown() {
            self.waiting.push(Wish::Choose(preset));
            return;
        }
        self.preset = preset;
        self.alone = None;
    }

    /// Puts layouts without a panel back to what they were at first.
    #[must_use]
    pub fn mended(mut self) -> Self {
        let mend = |tree: &mut Tree<Pane>, first: Tree<Pane>| {
            if tree.is_empty() {
                *tree = first;
            }
        };
        std::iter::zip(&mut self.layouts, Preset::ALL).for_each(|(tree, preset)| mend(tree, preset.layout()));
        std::iter::zip(&mut self.few_columns, preset::few_columns()).for_each(|(tree, first)| mend(tree, first));
        self
    }

    /// Puts the layout that is shown back to what it was at first.
    pub fn reset(&mut self) {
        let [one, two] = preset::few_columns();
        *self.tree_mut() = match self.room {
            Room::OneColumn => one,
            Room::TwoColumns => two,
            Room::Enough => self.preset.layout(),
        };
        self.alone = None;
    }

    /// Leaves panels out of the layouts of few columns, until they are asked for.
    pub fn leave_out(&mut self, panes: &[Pane]) {
        for tree in &mut self.few_columns {
            for pane in panes {
                if let Some(tile) = tree.tiles.find_pane(pane) {
                    tree.remove_recursively(tile);
                }
            }
        }
    }

    /// Whether a panel is somewhere in the layout, if only as a tab behind another.
    #[must_use]
    pub fn holds(&self, pane: Pane) -> bool {
        self.tile_of(pane).is_some()
    }

    /// Whether a panel is seen.
    #[must_use]
    pub fn shows(&self, pane: Pane) -> bool {
        match self.alone {
            Some(alone) => alone == pane,
            None => self.visible().contains(&pane),
        }
    }

    /// The panels that are seen, in the order of the layout.
    #[must_use]
    pub fn visible(&self) -> Vec<Pane> {
        self.tree().active_tiles().into_iter().filter_map(|id| self.tree().tiles.get_pane(&id).copied()).collect()
    }

    /// Where a panel is seen.
    #[must_use]
    pub fn rect_of(&self, pane: Pane) -> Option<Rect> {
        let tile = self.tile_of(pane).filter(|_| self.shows(pane))?;
        self.tree().tiles.rect(tile)
    }

    /// The panel that was used last.
    #[must_use]
    pub const fn current(&self) -> Option<Pane> {
        self.current
    }

    /// Brings a panel to the front; one that is not in the layout becomes a tab beside the one that was used last.
    pub fn reveal(&mut self, pane: Pane) {
        if self.is_being_shown() {
            self.waiting.push(Wish::Reveal(pane));
            return;
        }
        if self.alone.is_some_and(|alone| alone != pane) {
            self.alone = None;
        }
        let tile = self.tile_of(pane).unwrap_or_else(|| self.add(pane));
        self.tree_mut().make_active(|id, _| id == tile);
        self.current = Some(pane);
    }

    /// Takes a panel out of the layout. The last one stays.
    pub fn close(&mut self, pane: Pane) {
        let panes = self.tree().tiles.tiles().filter(|tile| tile.is_pane()).count();
        if let Some(tile) = self.tile_of(pane).filter(|_| panes > 1) {
            self.tree_mut().remove_recursively(tile);
        }
        if self.alone == Some(pane) {
            self.alone = None;
        }
    }

    /// Gives a panel the window to itself, or takes it back.
    pub fn toggle_alone(&mut self, pane: Pane) {
        if self.is_being_shown() {
            self.waiting.push(Wish::ToggleAlone(pane));
            return;
        }
        self.alone = if self.alone == Some(pane) { None } else { Some(pane) };
    }

    /// Goes on to the next panel that is seen, or back to the one before.
    pub fn go_round(&mut self, ctx: &Context, forward: bool) {
        let visible = self.visible();
        let at = self.current.and_then(|pane| visible.iter().position(|&other| other == pane));
        let count = visible.len().max(1);
        let next = match (at, forward) {
            (Some(at), true) => (at + 1) % count,
            (Some(at), false) => (at + count - 1) % count,
            (None, _) => 0,
        };
        if let Some(&pane) = visible.get(next) {
            self.current = Some(pane);
            ctx.memory_mut(|memory| memory.request_focus(focus_of(pane)));
        }
    }

    /// Makes the panel that was used last wider (or higher), or narrower.
    pub fn resize_current(&mut self, direction: egui_tiles::LinearDir, by: f32) {
        if let Some(tile) = self.current.and_then(|pane| self.tile_of(pane)) {
            resize::grow(&mut self.tree_mut().tiles, tile, direction, by);
        }
    }

    /// The panels that are to be shown: they are taken out meanwhile, so that what they show may ask for other ones.
    pub(super) fn begin(&mut self) -> (Tree<Pane>, Option<Pane>) {
        let tree = std::mem::replace(self.tree_mut(), Tree::empty(dock_id()));
        (tree, self.alone)
    }

    /// Puts the panels back; `used` is the one that was used in this frame.
    pub(super) fn end(&mut self, mut tree: Tree<Pane>, used: Option<Pane>) {
        let options = SimplificationOptions { all_panes_must_have_tabs: true, ..SimplificationOptions::default() };
        tree.simplify(&options);
        *self.tree_mut() = tree;
        self.current = used.or(self.current);
        for wish in std::mem::take(&mut self.waiting) {
            match wish {
                Wish::Choose(preset) => self.choose(preset),
                Wish::Reveal(pane) => self.reveal(pane),
                Wish::Uncover(pane, kept) => self.uncover(pane, kept),
                Wish::Beside(panes, kept) => self.show_beside(&panes, kept),
                Wish::ToggleAlone(pane) => self.toggle_alone(pane),
            }
        }
    }

    fn is_being_shown(&self) -> bool {
        self.tree().is_empty()
    }

    const fn tree(&self) -> &Tree<Pane> {
        match self.room {
            Room::OneColumn => &self.few_columns[0],
            Room::TwoColumns => &self.few_columns[1],
            Room::Enough => &self.layouts[self.preset as usize],
        }
    }

    const fn tree_mut(&mut self) -> &mut Tree<Pane> {
        match self.room {
            Room::OneColumn => &mut self.few_columns[0],
            Room::TwoColumns => &mut self.few_columns[1],
            Room::Enough => &mut self.layouts[self.preset as usize],
        }
    }

    fn tile_of(&self, pane: Pane) -> Option<TileId> {
        self.tree().tiles.find_pane(&pane)
    }

    fn add(&mut self, pane: Pane) -> TileId {
        let beside = self.current.and_then(|current| self.tile_of(current));
        let tree = self.tree_mut();
        let tile = tree.tiles.insert_pane(pane);
        let home =
            beside.and_then(|beside| tree.tiles.parent_of(beside)).or_else(|| largest_tabs(tree)).or(tree.root());
        match home.and_then(|home| tree.tiles.get_mut(home)) {
            Some(Tile::Container(container)) => container.add_child(tile),
            // A layout is never without a container: its panels all have tabs.
            _ => *tree = Tree::new(dock_id(), tile, std::mem::take(&mut tree.tiles)),
        }
        tile
    }
}

/// The tabs with the most room.
fn largest_tabs(tree: &Tree<Pane>) -> Option<TileId> {
    let tabs = tree.tiles.iter().filter(|(_, tile)| matches!(tile, Tile::Container(Container::Tabs(_))));
    let area = |id: TileId| tree.tiles.rect(id).map_or(0.0, |rect| rect.area());
    // Ties go to the smaller number, whatever the order of the tiles.
    tabs.map(|(id, _)| *id).max_by(|a, b| area(*a).total_cmp(&area(*b)).then(b.0.cmp(&a.0)))
}

fn dock_id() -> Id {
    Id::unique("dock")
}

/// What has the focus when a panel as a whole has it.
#[must_use]
pub fn focus_of(pane: Pane) -> Id {
    Id::unique(("pane", pane.word()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_layout_has_each_panel_at_most_once() {
        for preset in Preset::ALL {
            let layout = preset.layout();
            let mut panes: Vec<_> = layout
                .tiles
                .tiles()
                .filter_map(|tile| match tile {
                    Tile::Pane(pane) => Some(pane.word()),
                    Tile::Container(_) => None,
                })
                .collect();
            let count = panes.len();
            panes.sort_unstable();
            panes.dedup();
            assert_eq!(panes.len(), count, "{preset:?}");
        }
    }

    #[test]
    fn narrow_windows_have_every_panel_once() {
        for (room, other) in [(Room::OneColumn, Room::TwoColumns), (Room::TwoColumns, Room::Enough)] {
            let mut dock = Dock::default();
            dock.fit(room);
            assert!(Pane::ALL.into_iter().all(|pane| dock.holds(pane)));
            dock.reveal(Pane::Lesson);
            assert!(dock.shows(Pane::Lesson) && dock.shows(Pane::Picture));
            dock.fit(other);
            assert!(!dock.shows(Pane::Lesson), "each is kept as it was left");
        }
        let windows = [[360.0, 740.0], [820.0, 1180.0], [740.0, 360.0], [1280.0, 800.0]];
        let rooms = [Room::OneColumn, Room::OneColumn, Room::TwoColumns, Room::Enough];
        assert_eq!(windows.map(|size| Room::of(size.into())), rooms);
    }

    #[test]
    fn what_is_left_out_of_narrow_windows_is_there_when_it_is_asked_for() {
        let mut dock = Dock::default();
        dock.leave_out(&[Pane::Editor, Pane::Accuracy]);
        assert!(dock.holds(Pane::Editor), "wide windows keep everything");
        for room in [Room::OneColumn, Room::TwoColumns] {
            dock.fit(room);
            assert!(!dock.holds(Pane::Editor) && !dock.holds(Pane::Accuracy) && dock.holds(Pane::Story));
            dock.reveal(Pane::Accuracy);
            assert!(dock.shows(Pane::Accuracy));
        }
    }

    #[test]
    fn another_layout_that_is_asked_for_within_a_frame_leaves_this_one_whole() {
        let mut dock = Dock::default();
        let (tree, _) = dock.begin();
        dock.choose(Preset::Lesson);
        dock.reveal(Pane::Lesson);
        dock.end(tree, None);
        assert!(dock.preset() == Preset::Lesson && dock.shows(Pane::Lesson));
        dock.choose(Preset::Learn);
        assert!(dock.shows(Pane::Picture) && dock.shows(Pane::Story) && dock.shows(Pane::Detail));
    }

    #[test]
    fn a_layout_that_was_kept_without_a_panel_is_as_at_first() {
        let mut dock = Dock::default();
        let (tree, _) = dock.begin();
        drop(tree);
        assert!(!dock.shows(Pane::Picture));
        assert!(dock.mended().shows(Pane::Picture));
    }

    #[test]
    fn a_panel_that_is_closed_can_be_brought_back() {
        let mut dock = Dock::default();
        dock.close(Pane::Side);
        assert!(!dock.holds(Pane::Side));
        dock.reveal(Pane::Side);
        assert!(dock.shows(Pane::Side));
    }

    #[test]
    fn each_layout_is_kept_as_it_was_left() {
        let mut dock = Dock::default();
        dock.close(Pane::Detail);
        dock.choose(Preset::Measure);
        dock.choose(Preset::Learn);
        assert!(!dock.holds(Pane::Detail));
        let text = serde_json::to_string(&dock).expect("a layout is plain data");
        let read: Dock = serde_json::from_str(&text).expect("it was just written");
        assert!(!read.holds(Pane::Detail));
        dock.reset();
        assert!(dock.shows(Pane::Detail));
    }

    #[test]
    fn the_last_panel_cannot_be_closed() {
        let mut dock = Dock::default();
        for pane in Pane::ALL {
            dock.close(pane);
        }
        assert_eq!(Pane::ALL.iter().filter(|pane| dock.holds(**pane)).count(), 1);
    }
}
