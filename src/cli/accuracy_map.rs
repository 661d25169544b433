//! `rayscope accuracy SCENE --map KIND -o FILE`: what a picture's one number hides, pixel by pixel.

use super::drawn::{self, Theme};
use super::failure::Failure;
use super::progress::{stopped_by_ctrl_c, with_bar};
use crate::laboratory::{MapKind, Run, digits_map, error_map, narrowed, tier_map, time_map};
use crate::scene::Scene;
use crate::view::{HeatMap, heat_map};
use clap::ValueEnum;
use std::path::Path;
use std::time::Instant;

/// Maps are this large, in points.
const SIZE: [f64; 2] = [900.0, 640.0];

/// What is mapped.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Map {
    /// How far each pixel is from the reference
    Error,
    /// The digits that the hit time of each pixel's ray loses
    Digits,
    /// What it took to be sure of each pixel's hits
    Tier,
    /// The nanoseconds that each pixel takes
    Time,
}

impl Map {
    const fn kind(self) -> MapKind {
        match self {
            Self::Error => MapKind::Error,
            Self::Digits => MapKind::Digits,
            Self::Tier => MapKind::Tier,
            Self::Time => MapKind::Time,
        }
    }
}

/// The map of a scene as it stands, in at most so many columns. `compare` brings the scene's picture with its reference, which
/// only errors need.
pub fn mapped(
    map: Map,
    scene: &Scene,
    columns: u32,
    compare: impl FnOnce() -> Result<Run, Failure>,
) -> Result<HeatMap, Failure> {
    if map == Map::Error {
        let study = compare()?.study;
        return error_map(&study.standard.picture, &study.reference.picture).ok_or_else(interrupted);
    }
    let (scene, progress) = (narrowed(scene, columns), stopped_by_ctrl_c());
    let kind = map.kind();
    let work = || match kind {
        MapKind::Tier => tier_map(&scene, &progress),
        MapKind::Time => {
            let began = Instant::now();
            time_map(&scene, &|| began.elapsed(), &progress)
        }
        MapKind::Digits | MapKind::Error => digits_map(&scene, &progress),
    };
    with_bar(kind.work(&scene), || progress.done(), work).ok_or_else(interrupted)
}

fn interrupted() -> Failure {
    Failure::interrupted("interrupted: the map was not finished, and nothing was written")
}

/// The bytes of the map, as the file's ending says.
pub fn drawn(map: &HeatMap, theme: Theme, path: &Path) -> Vec<u8> {
    let drawing = heat_map(map, SIZE, theme.into());
    if path.extension().is_some_and(|ending| ending == "png") { drawn::png(&drawing) } else { drawn::svg(&drawing) }
}
