//! Maps: what a picture's one number hides, pixel by pixel.
//!
//! **Error** is how far each pixel's colour is from the reference. **Digits** is what an arithmetic loses of the hit time of the
//! ray through the pixel's middle. **Tier** is the least sure answer that any solver gave to any ray of the pixel. **Time** is what
//! the pixel takes.

mod digits;
mod tier;
mod time;

use super::errors::difference;
use crate::scene::{Image, Scene};
use crate::trace::{Picture, Progress};
use crate::view::{HeatMap, HeatScale};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

pub use digits::{digits_lost, digits_map, map_of_digits};
pub use tier::tier_map;
pub use time::{Times, map_of_times, time_map, time_pixels};

/// How often each pixel is worked on for a map of times.
pub const TIMINGS: usize = 1 + time::PASSES;

/// What is mapped.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum MapKind {
    /// The distance from the reference.
    Error,
    /// The digits that the hit time loses.
    Digits,
    /// What it took to be sure.
    Tier,
    /// The time.
    Time,
}

impl MapKind {
    /// All of them, in the order in which they are shown.
    pub const ALL: [Self; 4] = [Self::Error, Self::Digits, Self::Tier, Self::Time];

    /// Its name, as it is shown and as the command line takes it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Error => "error",
            Self::Digits => "digits",
            Self::Tier => "tier",
            Self::Time => "time",
        }
    }

    /// How many pixels are worked on for it: what its progress counts up to.
    #[must_use]
    pub fn work(self, scene: &Scene) -> usize {
        let Image { width, height } = scene.image;
        let pixels = width as usize * height as usize;
        if self == Self::Time { pixels * TIMINGS } else { pixels }
    }
}

/// The largest difference of a channel of each pixel, in linear RGB from 0 to 1. Of pictures of different sizes there is no
/// map.
#[must_use]
pub fn error_map(picture: &Picture, reference: &Picture) -> Option<HeatMap> {
    if [picture.width, picture.height] != [reference.width, reference.height] {
        return None;
    }
    let largest = |(&a, &b)| difference(a, b).into_iter().fold(0.0, f64::max);
    let values: Vec<f64> = picture.pixels().iter().zip(reference.pixels()).map(largest).collect();
    let most = values.iter().copied().fold(0.0, f64::max);
    Some(HeatMap {
        title: "Error".to_owned(),
        notes: vec!["The largest difference of a channel from the reference, in linear RGB from 0 to 1.".to_owned()],
        size: [picture.width as usize, picture.height as usize],
        scale: HeatScale::Log([(1e-4 * most).clamp(1e-12, 1e-4), most.max(1e-4)]),
        unit: "error".to_owned(),
        zero: Some("no error at all".to_owned()),
        values,
        ..HeatMap::default()
    })
}

/// A value for each pixel, on all cores; none if it was cancelled.
fn of_each_pixel<T: Send>(
    image: Image,
    progress: &Progress,
    value: impl Fn([u32; 2]) -> T + Sync + Send,
) -> Option<Vec<T>> {
    let row = |y: u32| {
        let pixels = (0..image.width).map_while(|x| {
            (!progress.cancelled()).then(|| {
                let value = value([x, y]);
                progress.advance();
                value
            })
        });
        pixels.collect::<Vec<T>>()
    };
    let rows: Vec<Vec<T>> = (0..image.height).into_par_iter().with_max_len(1).map(row).collect();
    (!progress.cancelled()).then(|| rows.into_iter().flatten().collect())
}

fn size(image: Image) -> [usize; 2] {
    [image.width as usize, image.height as usize]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Rgb;

    #[test]
    fn the_error_of_a_pixel_is_that_of_its_worst_channel() {
        let truth = Picture::from_pixels(2, 1, vec![Rgb::splat(0.5); 2]).unwrap();
        let off = Picture::from_pixels(2, 1, vec![Rgb::splat(0.5), Rgb::new(0.5, 0.75, 0.4)]).unwrap();
        let map = error_map(&off, &truth).unwrap();
        assert_eq!(map.values, [0.0, 0.25]);
        assert_eq!(error_map(&off, &Picture::from_pixels(1, 2, vec![Rgb::ONE; 2]).unwrap()), None);
    }

    #[test]
    fn a_cancelled_map_is_none() {
        let progress = Progress::new();
        progress.cancel();
        assert_eq!(of_each_pixel(Image { width: 3, height: 2 }, &progress, |[x, _]| x), None);
        let all = of_each_pixel(Image { width: 3, height: 2 }, &Progress::new(), |[x, y]| 10 * y + x);
        assert_eq!(all, Some(vec![0, 1, 2, 10, 11, 12]));
    }
}
