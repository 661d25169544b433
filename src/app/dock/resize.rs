//! Resizing by keys: a panel takes room from its neighbours in the nearest row or column that it is in.

use crate::app::pane::Pane;
use egui_tiles::{Container, LinearDir, Tile, TileId, Tiles};

/// No part of a row or column becomes smaller than this, as a part of it.
const SMALLEST: f32 = 0.1;

/// Makes a tile's part of the nearest row or column larger by `by` (a part of all of it), or smaller.
pub fn grow(tiles: &mut Tiles<Pane>, tile: TileId, direction: LinearDir, by: f32) {
    let mut child = tile;
    while let Some(parent) = tiles.parent_of(child) {
        if let Some(Tile::Container(Container::Linear(linear))) = tiles.get_mut(parent)
            && linear.dir == direction
        {
            let total: f32 = linear.children.iter().map(|&id| linear.shares[id]).sum();
            let others = total - linear.shares[child];
            if others > 0.0 {
                let before = linear.shares[child] / total;
                let after = (before + by).clamp(SMALLEST, 1.0 - SMALLEST);
                // The others keep their proportions.
                linear.shares.set_share(child, others * after / (1.0 - after));
            }
            return;
        }
        child = parent;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::dock::Preset;

    fn share(layout: &egui_tiles::Tree<Pane>, pane: Pane) -> f32 {
        let mut child = layout.tiles.find_pane(&pane).expect("the layout has it");
        loop {
            let parent = layout.tiles.parent_of(child).expect("it is in a row");
            if let Some(Tile::Container(Container::Linear(linear))) = layout.tiles.get(parent)
                && linear.dir == LinearDir::Horizontal
            {
                let total: f32 = linear.children.iter().map(|&id| linear.shares[id]).sum();
                return linear.shares[child] / total;
            }
            child = parent;
        }
    }

    #[test]
    fn a_panel_grows_by_as_much_as_it_is_told_and_back() {
        let mut layout = Preset::Learn.layout();
        let tile = layout.tiles.find_pane(&Pane::Picture).expect("the layout has it");
        let before = share(&layout, Pane::Picture);
        grow(&mut layout.tiles, tile, LinearDir::Horizontal, 0.05);
        assert!((share(&layout, Pane::Picture) - before - 0.05).abs() < 1e-6);
        grow(&mut layout.tiles, tile, LinearDir::Horizontal, -0.05);
        assert!((share(&layout, Pane::Picture) - before).abs() < 1e-6);
    }

    #[test]
    fn nothing_is_squeezed_to_nothing() {
        let mut layout = Preset::Learn.layout();
        let tile = layout.tiles.find_pane(&Pane::Picture).expect("the layout has it");
        grow(&mut layout.tiles, tile, LinearDir::Horizontal, 5.0);
        assert!((share(&layout, Pane::Picture) - (1.0 - SMALLEST)).abs() < 1e-6);
    }
}
