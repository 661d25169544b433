//! `--map`: error, lost digits, certainty or time, pixel by pixel.

use super::super::drawn::{DrawingOutput, MAP_SIZE, Theme};
use super::super::failure::Failure;
use super::super::progress::{stopped_by_ctrl_c, with_bar};
use crate::laboratory::{MapKind, Sums, digits_map, error_map, is_random, reference_scene, tier_map, time_map};
use crate::scene::Scene;
use crate::trace::{Progress, render};
use crate::view::{HeatMap, heat_map};
use std::path::Path;
use std::time::Instant;

/// Pictures of the reference of an error map where chance decides: with four it errs by half of what one does.
const PICTURES: u32 = 4;

/// The map of a scene; `plain` is the scene as it stands, which says what is true.
pub fn write(kind: MapKind, [scene, plain]: [&Scene; 2], theme: Theme, output: Option<&Path>) -> Result<(), Failure> {
    let output = DrawingOutput::create(output)?;
    let progress = stopped_by_ctrl_c();
    let pictures = if kind == MapKind::Error { 1 + reference_pictures(plain) as usize } else { 1 };
    let map = with_bar(pictures * kind.work(scene), || progress.done(), || map(kind, [scene, plain], &progress));
    let map = map.ok_or_else(|| Failure::interrupted("interrupted: nothing was written"))?;
    output.write(&scene.title, &heat_map(&map, MAP_SIZE, theme.into()))
}

fn map(kind: MapKind, [scene, plain]: [&Scene; 2], progress: &Progress) -> Option<HeatMap> {
    match kind {
        MapKind::Error => {
            let mut sums = Sums::new(plain.image.width, plain.image.height);
            for number in 0..reference_pictures(plain) {
                sums.add(&render(&reference_scene(plain, number), progress).0);
            }
            let picture = render(scene, progress).0;
            sums.mean().filter(|_| !progress.cancelled()).and_then(|reference| error_map(&picture, &reference))
        }
        MapKind::Digits => digits_map(scene, progress),
        MapKind::Tier => tier_map(scene, progress),
        MapKind::Time => {
            let began = Instant::now();
            time_map(scene, &|| began.elapsed(), progress)
        }
    }
}

fn reference_pictures(scene: &Scene) -> u32 {
    if is_random(scene) { PICTURES } else { 1 }
}
