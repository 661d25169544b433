//! White light, taken apart by wavelength.
//!
//! **Colour.** The colour matching functions are linear between the entries of their table, and the matrix of sRGB takes
//! them to linear RGB. Each channel is then divided by its integral, so that light of equal energy at all wavelengths is
//! (1, 1, 1): a scene's white is white, whatever the white of the CIE would be.
//!
//! **Shares.** The share of white in a band is the exact integral of these functions over the band, a difference of two
//! cumulative sums; so the shares of bands that lie end to end add up to white. A band that runs over one end of the range
//! goes on at the other end. Channels may be negative, for most pure colours lie outside sRGB.
//!
//! **Source.** The matrix from XYZ to linear RGB is that of IEC 61966-2-1:1999, with its four digits.

use super::colour_matching::MATCHING;
use glam::DVec3;

/// The shortest wavelength in nanometres.
pub const SHORTEST: f64 = 380.0;
/// The longest wavelength in nanometres.
pub const LONGEST: f64 = 780.0;
/// The wavelength of the yellow line of helium in nanometres, at which indices of glass are told.
pub const YELLOW: f64 = 587.5618;

const STEPS: usize = MATCHING.len() - 1;

/// From XYZ to linear sRGB, by rows.
const RGB_FROM_XYZ: [[f64; 3]; 3] = [[3.2406, -1.5372, -0.4986], [-0.9689, 1.8758, 0.0415], [0.0557, -0.2040, 1.0570]];

/// The colour of each entry of the table, for an integral of 1 over the whole range, whose length counts as 1.
static DENSITY: [[f64; 3]; STEPS + 1] = densities();

/// The integrals of the densities up to each entry.
static CUMULATIVE: [[f64; 3]; STEPS + 1] = integrals(&densities());

const fn densities() -> [[f64; 3]; STEPS + 1] {
    let mut colours = [[0.0; 3]; STEPS + 1];
    let mut step = 0;
    while step <= STEPS {
        let [x, y, z] = MATCHING[step];
        let mut channel = 0;
        while channel < 3 {
            let [from_x, from_y, from_z] = RGB_FROM_XYZ[channel];
            colours[step][channel] = from_x * x + from_y * y + from_z * z;
            channel += 1;
        }
        step += 1;
    }
    let whole = integrals(&colours)[STEPS];
    step = 0;
    while step <= STEPS {
        let [r, g, b] = colours[step];
        colours[step] = [r / whole[0], g / whole[1], b / whole[2]];
        step += 1;
    }
    colours
}

/// By the trapezium rule, which is exact for what is linear between its entries.
const fn integrals(colours: &[[f64; 3]; STEPS + 1]) -> [[f64; 3]; STEPS + 1] {
    let mut sums = [[0.0; 3]; STEPS + 1];
    let mut step = 1;
    while step <= STEPS {
        let mut channel = 0;
        while channel < 3 {
            let mean = 0.5 * (colours[step - 1][channel] + colours[step][channel]);
            sums[step][channel] = sums[step - 1][channel] + mean / STEPS as f64;
            channel += 1;
        }
        step += 1;
    }
    sums
}

/// One of several wavelengths that white light is taken apart into.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Band {
    /// Its number, from 0.
    pub number: u32,
    /// How many there are.
    pub of: u32,
    /// λ, in the middle of the band, in nanometres.
    pub nanometres: f64,
    /// Where the band begins and ends, in nanometres; it may run over the ends of the range.
    pub edges: [f64; 2],
    /// The share of white light in it, linear sRGB.
    pub share: DVec3,
}

impl Band {
    /// The width of the band in nanometres.
    #[must_use]
    pub fn width(&self) -> f64 {
        (LONGEST - SHORTEST) / f64::from(self.of)
    }
}

/// Takes white light apart into `count` wavelengths, evenly spread: the first is the share `offset` of a band's width from
/// the shortest one. Their shares of white add up to (1, 1, 1), whatever the offset in [0, 1) is.
pub fn bands(count: u32, offset: f64) -> impl Iterator<Item = Band> {
    let of = count.max(1);
    let place = move |k: f64| (k + offset) / f64::from(of);
    (0..of).map(move |number| {
        let middle = f64::from(number);
        let [from, to] = [place(middle - 0.5), place(middle + 0.5)];
        let nanometres = |place: f64| SHORTEST + place * (LONGEST - SHORTEST);
        Band {
            number,
            of,
            nanometres: nanometres(place(middle)),
            edges: [nanometres(from), nanometres(to)],
            share: up_to(to) - up_to(from),
        }
    })
}

/// The share of white light, linear sRGB, that has wavelengths up to this one, in nanometres. Beyond the ends of the range
/// it begins again: it is 1 higher or lower.
#[must_use]
pub fn white_up_to(nanometres: f64) -> DVec3 {
    up_to((nanometres - SHORTEST) / (LONGEST - SHORTEST))
}

/// The share of white light, linear sRGB, between two wavelengths in nanometres.
#[must_use]
pub fn share(from: f64, to: f64) -> DVec3 {
    white_up_to(to) - white_up_to(from)
}

/// The colour of light of one wavelength in nanometres, linear sRGB: its mean over all wavelengths of the range is
/// (1, 1, 1). Black beyond the range.
#[must_use]
pub fn pure(nanometres: f64) -> DVec3 {
    let place = (nanometres - SHORTEST) / (LONGEST - SHORTEST);
    if !(0.0..=1.0).contains(&place) {
        return DVec3::ZERO;
    }
    let (step, within) = entry(place);
    DVec3::from_array(DENSITY[step]).lerp(DVec3::from_array(DENSITY[step + 1]), within)
}

/// The entry of the table before a place in [0, 1], and how far the place is beyond it.
fn entry(place: f64) -> (usize, f64) {
    let at = place * STEPS as f64;
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and the number of steps")]
    let step = (at.floor().max(0.0) as usize).min(STEPS - 1);
    (step, at - step as f64)
}

/// The same as [`white_up_to`] for a place in the range, whose length is 1.
fn up_to(place: f64) -> DVec3 {
    let rounds = place.floor();
    let (step, within) = entry(place - rounds);
    let [low, high] = [step, step + 1].map(|step| DVec3::from_array(DENSITY[step]));
    let part = (low + (high - low) * (0.5 * within)) * (within / STEPS as f64);
    DVec3::splat(rounds) + DVec3::from_array(CUMULATIVE[step]) + part
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn is_near(a: DVec3, b: DVec3, tolerance: f64) -> bool {
        (a - b).abs().max_element() <= tolerance
    }

    #[test]
    fn all_of_white_is_white() {
        assert!(is_near(share(SHORTEST, LONGEST), DVec3::ONE, 1e-15));
        assert!(is_near(CUMULATIVE[STEPS].into(), DVec3::ONE, 1e-15));
    }

    #[test]
    fn a_share_is_the_integral_of_the_pure_colours() {
        // Of 437.3 to 611.9 nm, by 200 000 strips: an integral that knows nothing of cumulative sums.
        let (from, to, strips) = (437.3, 611.9, 200_000);
        let width = (to - from) / f64::from(strips);
        let strip = |i: i32| pure(from + (f64::from(i) + 0.5) * width) * (width / (LONGEST - SHORTEST));
        let sum: DVec3 = (0..strips).map(strip).sum();
        assert!(is_near(share(from, to), sum, 1e-9), "{} and {sum}", share(from, to));
    }

    #[test]
    fn a_band_over_the_end_goes_on_at_the_beginning() {
        let (over, pieces) = (share(760.0, 800.0), share(760.0, 780.0) + share(380.0, 400.0));
        assert!(is_near(over, pieces, 1e-15));
        assert!(is_near(share(360.0, 400.0), share(760.0, 780.0) + share(380.0, 400.0), 1e-15));
    }

    #[test]
    fn red_green_and_blue_light_are_strongest_in_their_own_channels() {
        for (nanometres, strongest) in [(460.0, 2), (530.0, 1), (620.0, 0)] {
            let colour = pure(nanometres).to_array();
            let found = (0..3).max_by(|&a, &b| colour[a].total_cmp(&colour[b]));
            assert_eq!(found, Some(strongest), "{nanometres} nm is {colour:?}");
        }
        assert!(pure(500.0).x < 0.0, "cyan light lies outside sRGB");
    }

    #[test]
    fn one_sample_of_four_wavelengths_stands_in_the_middles_of_the_quarters() {
        let all: Vec<_> = bands(4, 0.5).map(|band| (band.nanometres, band.edges)).collect();
        assert_eq!(
            all,
            [(430.0, [380.0, 480.0]), (530.0, [480.0, 580.0]), (630.0, [580.0, 680.0]), (730.0, [680.0, 780.0])]
        );
    }

    proptest! {
        #[test]
        fn the_shares_of_all_bands_are_white_whatever_the_offset(count in 1..257_u32, offset in 0.0..1.0_f64) {
            let sum: DVec3 = bands(count, offset).map(|band| band.share).sum();
            prop_assert!(is_near(sum, DVec3::ONE, 2e-14), "{count} bands from {offset}: {sum}");
            for band in bands(count, offset) {
                prop_assert!((SHORTEST..LONGEST).contains(&band.nanometres));
                prop_assert!(is_near(band.share, share(band.edges[0], band.edges[1]), 1e-13));
            }
        }
    }
}
