//! The layouts that the workbench comes with.

use super::dock_id;
use crate::app::pane::Pane;
use egui::Vec2;
use egui_tiles::{Container, Linear, LinearDir, TileId, Tiles, Tree};
use serde::{Deserialize, Serialize};

/// The window, in points, up to which what is presented is no larger than it has to be.
const PRESENTED: Vec2 = Vec2::new(1280.0, 720.0);

/// A layout for a purpose.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Preset {
    /// The picture, the story, one event and what can be drawn of it.
    #[default]
    Learn,
    /// Everything at once, for whoever looks for a reason.
    Inspect,
    /// Few things, large, to be seen from the back of a room.
    Present,
    /// Maps, search, accuracy and effects.
    Measure,
    /// A lesson beside what it is about.
    Lesson,
}

impl Preset {
    /// All of them, in the order of the top bar.
    pub const ALL: [Self; 5] = [Self::Learn, Self::Inspect, Self::Present, Self::Measure, Self::Lesson];

    /// The name of its title in the catalogue of words; with `-about` behind it, that of what it is for.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Learn => "preset-learn",
            Self::Inspect => "preset-inspect",
            Self::Present => "preset-present",
            Self::Measure => "preset-measure",
            Self::Lesson => "preset-lesson",
        }
    }

    /// How much larger everything is than elsewhere in a window of this size, in points. What is presented grows with the window: on
    /// a large one that is seen from the same place, more room is no reason for small letters.
    #[must_use]
    pub fn magnification(self, window: Vec2) -> f32 {
        match self {
            Self::Present => 1.5 * (window / PRESENTED).min_elem().max(1.0),
            _ => 1.0,
        }
    }

    /// The layout, as it is at first.
    #[must_use]
    pub fn layout(self) -> Tree<Pane> {
        use Pane::{
            Accuracy, Along, Compare, Detail, Editor, Effects, Generic, Intervals, Lesson, Overview, Picture, Planes,
            Properties, Search, Shading, Side, Signs, Snell, Story,
        };
        let mut plan = Plan::default();
        let root = match self {
            Self::Learn => {
                let left = plan.below(0.5, &[Picture], &[Side, Overview]);
                let right = plan.below(0.48, &[Detail, Properties, Compare], &[Along]);
                let middle = plan.tabs(&[Story, Editor, Lesson]);
                let reading = plan.split(LinearDir::Horizontal, 0.52, middle, right);
                plan.split(LinearDir::Horizontal, 0.35, left, reading)
            }
            Self::Inspect => {
                let left = plan.below(0.48, &[Picture], &[Side, Overview, Compare, Search]);
                let middle = plan.below(0.62, &[Story, Editor], &[Detail, Properties]);
                let right = plan.below(0.5, &[Generic, Snell, Shading], &[Intervals, Signs, Planes, Along]);
                let reading = plan.split(LinearDir::Horizontal, 0.5, middle, right);
                plan.split(LinearDir::Horizontal, 0.33, left, reading)
            }
            Self::Present => {
                let left = plan.below(0.5, &[Picture], &[Story]);
                let right = plan.below(0.62, &[Side, Overview, Along], &[Detail]);
                plan.split(LinearDir::Horizontal, 0.42, left, right)
            }
            Self::Measure => {
                let left = plan.below(0.56, &[Picture], &[Search]);
                let right = plan.tabs(&[Accuracy, Effects, Compare, Story]);
                plan.split(LinearDir::Horizontal, 0.4, left, right)
            }
            Self::Lesson => {
                let left = plan.tabs(&[Lesson]);
                let middle = plan.below(0.48, &[Picture], &[Side, Signs, Planes]);
                // What else a step shows is put beside these when it is needed.
                let right = plan.below(0.5, &[Story, Editor, Properties], &[Detail, Along, Generic]);
                let seen = plan.split(LinearDir::Horizontal, 0.5, middle, right);
                plan.split(LinearDir::Horizontal, 0.34, left, seen)
            }
        };
        Tree::new(dock_id(), root, plan.tiles)
    }
}

/// The layouts of narrow windows: the picture or a drawing, and below or beside it what is said of it.
pub(super) fn few_columns() -> [Tree<Pane>; 2] {
    use Pane::{
        Accuracy, Along, Compare, Detail, Editor, Effects, Generic, Intervals, Lesson, Overview, Picture, Planes,
        Properties, Search, Shading, Side, Signs, Snell, Story,
    };
    let seen = [Picture, Side, Along, Overview, Intervals, Signs, Generic, Planes, Snell, Shading];
    let said = [Story, Detail, Lesson, Properties, Editor, Search, Compare, Effects, Accuracy];
    [LinearDir::Vertical, LinearDir::Horizontal].map(|direction| {
        let mut plan = Plan::default();
        let (first, second) = (plan.tabs(&seen), plan.tabs(&said));
        let root = plan.split(direction, 0.45, first, second);
        Tree::new(dock_id(), root, plan.tiles)
    })
}

/// A layout that is being put together.
#[derive(Default)]
struct Plan {
    tiles: Tiles<Pane>,
}

impl Plan {
    /// Panels behind each other; the first one is seen.
    fn tabs(&mut self, panes: &[Pane]) -> TileId {
        let children = panes.iter().map(|&pane| self.tiles.insert_pane(pane)).collect();
        self.tiles.insert_tab_tile(children)
    }

    fn below(&mut self, share: f32, upper: &[Pane], lower: &[Pane]) -> TileId {
        let (upper, lower) = (self.tabs(upper), self.tabs(lower));
        self.split(LinearDir::Vertical, share, upper, lower)
    }

    fn split(&mut self, direction: LinearDir, share: f32, first: TileId, second: TileId) -> TileId {
        let linear = Linear::new_binary(direction, [first, second], share);
        self.tiles.insert_container(Container::Linear(linear))
    }
}
