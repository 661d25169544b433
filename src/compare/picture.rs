//! Two pictures of one size: how far they lie apart, and a picture of that.

use crate::scene::Rgb;
use crate::trace::Picture;

/// How far two pictures lie apart. Colours are linear, cut off at 0 and 1.
#[derive(Clone, Debug, PartialEq)]
pub struct PictureDifference {
    /// The largest difference of a channel.
    pub largest: f64,
    /// The root mean square of all differences.
    pub rmse: f64,
    /// How many pixels differ at all.
    pub differing: usize,
    /// The differences, so much larger that the largest one is 1; 0 where nothing differs.
    pub amplified: Picture,
}

/// How far two pictures lie apart; none if they are not of one size.
#[must_use]
pub fn picture_difference(left: &Picture, right: &Picture) -> Option<PictureDifference> {
    if [left.width, left.height] != [right.width, right.height] {
        return None;
    }
    let stored = |colour: Rgb| colour.clamp(Rgb::ZERO, Rgb::ONE);
    let pairs = left.pixels().iter().zip(right.pixels());
    let differences: Vec<Rgb> = pairs.map(|(a, b)| (stored(*a) - stored(*b)).abs()).collect();
    let largest = differences.iter().map(|d| d.max_element()).fold(0.0, f64::max);
    let squares: f64 = differences.iter().map(|d| d.length_squared()).sum();
    let amplify = if largest > 0.0 { 1.0 / largest } else { 0.0 };
    let amplified = differences.iter().map(|d| *d * amplify).collect();
    Some(PictureDifference {
        largest,
        rmse: (squares / (3 * differences.len()).max(1) as f64).sqrt(),
        differing: differences.iter().filter(|d| **d != Rgb::ZERO).count(),
        amplified: Picture::from_pixels(left.width, left.height, amplified)?,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture(colours: [Rgb; 2]) -> Picture {
        Picture::from_pixels(2, 1, colours.to_vec()).unwrap()
    }

    #[test]
    fn one_channel_of_one_pixel_is_all_that_differs() {
        let left = picture([Rgb::ONE, Rgb::new(0.5, 0.0, 0.0)]);
        let right = picture([Rgb::splat(7.0), Rgb::new(0.25, 0.0, 0.0)]);
        let found = picture_difference(&left, &right).unwrap();
        assert_eq!((found.largest, found.differing), (0.25, 1));
        assert_eq!(found.rmse, (0.0625_f64 / 6.0).sqrt());
        assert_eq!(found.amplified.pixels(), [Rgb::ZERO, Rgb::new(1.0, 0.0, 0.0)]);
    }

    #[test]
    fn pictures_of_two_sizes_are_not_compared() {
        let one = Picture::from_pixels(1, 1, vec![Rgb::ONE]).unwrap();
        assert_eq!(picture_difference(&one, &picture([Rgb::ONE; 2])), None);
    }
}
