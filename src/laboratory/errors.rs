//! How far a picture is from another one: four ways to say it.
//!
//! The root mean square is what estimates converge in; the 99.9th percentile finds what a mean hides, such as a missing
//! highlight; wrong pixels are what a person could point at; structural similarity is nearest to what a person judges.
//!
//! **Source** Z. Wang, A. Bovik, H. Sheikh, E. Simoncelli, Image Quality Assessment: From Error Visibility to Structural
//! Similarity (IEEE Transactions on Image Processing, 2004). Windows are squares of 8 × 8 pixels that do not overlap, as
//! the crate `image_compare` takes them; its covariances are sums over a window, so that it forgives flat noise less than
//! the paper's.

use super::Errors;
use crate::scene::Rgb;
use crate::trace::Picture;
use image_compare::Algorithm;

/// Steps of sRGB by which a channel may be off and nobody sees it, even beside the right one.
const VISIBLE: u8 = 5;

/// The share of pixels that the 99.9th percentile covers, in thousandths.
const MOST: usize = 999;

/// How far a picture is from another one of the same size; as far as can be where sizes differ.
#[must_use]
pub fn errors(picture: &Picture, truth: &Picture) -> Errors {
    if [picture.width, picture.height] != [truth.width, truth.height] || truth.pixels().is_empty() {
        return Errors { rmse: 1.0, p999: 1.0, wrong_pixels: truth.pixels().len(), dissimilarity: 1.0 };
    }
    if picture.pixels() == truth.pixels() {
        return Errors::default();
    }
    let differences: Vec<[f64; 3]> =
        picture.pixels().iter().zip(truth.pixels()).map(|(&a, &b)| difference(a, b)).collect();
    let mut largest: Vec<f64> = differences.iter().map(|d| d.iter().copied().fold(0.0, f64::max)).collect();
    largest.sort_by(f64::total_cmp);
    let covered = (largest.len() * MOST).div_ceil(1000).max(1);
    let bytes = [picture.to_rgb8(), truth.to_rgb8()];
    let is_wrong = |(a, b): &(&[u8], &[u8])| a.iter().zip(*b).any(|(a, b)| a.abs_diff(*b) > VISIBLE);
    let wrong_pixels = bytes[0].chunks(3).zip(bytes[1].chunks(3)).filter(is_wrong).count();
    Errors {
        rmse: root_mean_square(&differences),
        p999: largest[covered - 1],
        wrong_pixels,
        dissimilarity: dissimilarity(&bytes, [picture.width, picture.height]),
    }
}

/// The root mean square error alone, which is quickly found.
#[must_use]
pub fn rmse(picture: &Picture, truth: &Picture) -> f64 {
    let pairs = picture.pixels().iter().zip(truth.pixels());
    root_mean_square(&pairs.map(|(&a, &b)| difference(a, b)).collect::<Vec<_>>())
}

fn root_mean_square(differences: &[[f64; 3]]) -> f64 {
    let squares: f64 = differences.iter().flatten().map(|d| d * d).sum();
    (squares / (3 * differences.len()).max(1) as f64).sqrt()
}

/// By channel, of what is stored: colours lighter than 1 are 1. What is no number differs from every number by all there is.
pub(super) fn difference(a: Rgb, b: Rgb) -> [f64; 3] {
    let stored = |x: f64| x.clamp(0.0, 1.0);
    let channel = |a: f64, b: f64| match [a.is_nan(), b.is_nan()] {
        [false, false] => (stored(a) - stored(b)).abs(),
        [true, true] => 0.0,
        _ => 1.0,
    };
    [channel(a.x, b.x), channel(a.y, b.y), channel(a.z, b.z)]
}

/// The mean over the channels.
fn dissimilarity(bytes: &[Vec<u8>; 2], [width, height]: [u32; 2]) -> f64 {
    let channel = |k: usize| {
        let [a, b] = [0, 1].map(|picture: usize| {
            let values = bytes[picture].iter().skip(k).step_by(3).copied().collect();
            image::GrayImage::from_raw(width, height, values)
        });
        let compared = image_compare::gray_similarity_structure(&Algorithm::MSSIMSimple, &a?, &b?);
        compared.ok().map(|compared| 1.0 - compared.score)
    };
    (0..3).filter_map(channel).sum::<f64>() / 3.0
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture(pixels: Vec<Rgb>) -> Picture {
        let width = u32::try_from(pixels.len()).unwrap();
        Picture::from_pixels(width, 1, pixels).unwrap()
    }

    #[test]
    fn equal_pictures_have_no_error_at_all() {
        let one = picture(vec![Rgb::new(0.1, 0.7, 3.0); 50]);
        assert_eq!(errors(&one, &one.clone()), Errors::default());
    }

    #[test]
    fn one_channel_of_one_pixel_among_a_thousand_counts_by_its_share() {
        let truth = vec![Rgb::splat(0.5); 1000];
        let mut off = truth.clone();
        off[7].y = 0.8;
        let found = errors(&picture(off), &picture(truth));
        assert!((found.rmse - 0.3 / 3000.0_f64.sqrt()).abs() < 1e-12, "{found:?}");
        assert_eq!((found.p999, found.wrong_pixels), (0.0, 1));
        assert!(found.dissimilarity > 0.0 && found.dissimilarity < 0.02, "{found:?}");
    }

    #[test]
    fn two_pixels_among_a_thousand_show_in_the_percentile() {
        let truth = vec![Rgb::ZERO; 1000];
        let mut off = truth.clone();
        (off[1].x, off[2].x) = (0.25, 0.5);
        assert_eq!(errors(&picture(off), &picture(truth)).p999, 0.25);
    }

    #[test]
    fn what_is_lighter_than_white_is_white() {
        let light = |value| picture(vec![Rgb::splat(value); 16]);
        assert_eq!(errors(&light(7.0), &light(1.0)).rmse, 0.0);
        assert_eq!(errors(&light(f64::INFINITY), &light(0.0)).rmse, 1.0);
        assert_eq!(errors(&light(f64::NAN), &light(1.0)).rmse, 1.0);
        assert_eq!(errors(&light(f64::NAN), &light(f64::NAN)).rmse, 0.0);
    }

    #[test]
    fn a_step_that_nobody_sees_is_not_a_wrong_pixel() {
        let grey = |value: f64| picture(vec![Rgb::splat(value); 16]);
        assert_eq!(errors(&grey(0.5), &grey(0.505)).wrong_pixels, 0);
        assert_eq!(errors(&grey(0.5), &grey(0.6)).wrong_pixels, 16);
    }

    #[test]
    fn pictures_of_different_sizes_have_nothing_in_common() {
        let found = errors(&picture(vec![Rgb::ONE; 4]), &picture(vec![Rgb::ONE; 5]));
        assert_eq!((found.rmse, found.wrong_pixels), (1.0, 5));
    }
}
