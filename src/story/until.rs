//! Going through the pixels of a picture to the first at which something stops.

use crate::query::Query;
use crate::scene::Scene;
use crate::trace::{Progress, record_pixel};
use rayon::prelude::*;

/// So many pixels are recorded before the next ones are begun. More would be traced in vain behind the one that is found; fewer
/// would leave threads waiting for the slowest.
const AT_ONCE: u64 = 64;

/// The first pixel after `from` in reading order, going on at the top after the last, in whose story one of the questions holds;
/// none if there is none, or if it was cancelled. `from` itself comes last.
#[must_use]
pub fn next_pixel(scene: &Scene, from: [u32; 2], questions: &[Query], progress: &Progress) -> Option<[u32; 2]> {
    let (width, height) = (u64::from(scene.image.width), u64::from(scene.image.height));
    let (pixels, start) = (width * height, u64::from(from[1]) * width + u64::from(from[0]) + 1);
    let pixel = |k: u64| {
        let place = (start + k) % pixels;
        [place % width, place / width].map(|at| u32::try_from(at).unwrap_or(u32::MAX))
    };
    let stops = |&[x, y]: &[u32; 2]| {
        if progress.cancelled() {
            return false;
        }
        let tree = record_pixel(scene, x, y);
        progress.advance();
        questions.iter().any(|question| question.first(&tree).is_some())
    };
    let mut begin = 0;
    while begin < pixels && !progress.cancelled() {
        let end = (begin + AT_ONCE).min(pixels);
        if let Some(found) = (begin..end).into_par_iter().map(pixel).find_first(stops) {
            return Some(found);
        }
        begin = end;
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{embedded_scene, load};

    fn scene(name: &str, [width, height]: [u32; 2]) -> Scene {
        let mut scene = load(embedded_scene(name).unwrap().text, name).unwrap();
        (scene.image.width, scene.image.height) = (width, height);
        scene
    }

    fn first_from(scene: &Scene, from: [u32; 2], question: &str) -> Option<[u32; 2]> {
        next_pixel(scene, from, &[question.parse().unwrap()], &Progress::new())
    }

    #[test]
    fn the_first_pixel_that_sees_the_ball_is_found_in_reading_order() {
        let scene = scene("hello/sphere", [24, 18]);
        let question: Query = "hit=ball".parse().unwrap();
        let sees = |[x, y]: [u32; 2]| question.first(&record_pixel(&scene, x, y)).is_some();
        let all = (0..18).flat_map(|y| (0..24).map(move |x| [x, y]));
        let seen: Vec<[u32; 2]> = all.filter(|&pixel| sees(pixel)).collect();
        assert!(seen.len() > 5);
        assert_eq!(first_from(&scene, [23, 17], "hit=ball"), Some(seen[0]));
        assert_eq!(first_from(&scene, seen[0], "hit=ball"), Some(seen[1]));
        assert_eq!(first_from(&scene, seen[seen.len() - 1], "hit=ball"), Some(seen[0]), "it goes on at the top");
    }

    #[test]
    fn what_no_pixel_has_is_not_found_and_a_cancelled_search_finds_nothing() {
        let scene = scene("hello/sphere", [8, 6]);
        assert_eq!(first_from(&scene, [0, 0], "tir"), None);
        let progress = Progress::new();
        progress.cancel();
        assert_eq!(next_pixel(&scene, [0, 0], &["pixel".parse().unwrap()], &progress), None);
    }
}
