//! The random numbers of one sample of one pixel: the same ones whenever and wherever they are asked for.

use super::sobol::{scrambled, sobol_point};

/// What a random number is for. Numbers for different purposes are independent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// The place in the pixel.
    Pixel,
    /// The place on the lens.
    Lens,
    /// The place on a light, by the light's number.
    Light(u32),
    /// The first of the wavelengths that a ray is split into.
    Wavelength,
    /// How far a ray comes in a medium.
    Distance,
    /// By how much it is turned there.
    Phase,
    /// Which of several rays is sent where not all can be.
    Way,
}

impl Purpose {
    const fn key(self) -> u32 {
        match self {
            Self::Pixel => 0,
            Self::Lens => 1,
            Self::Wavelength => 2,
            Self::Distance => 3,
            Self::Phase => 4,
            Self::Light(light) => 5_u32.wrapping_add(light),
            Self::Way => u32::MAX,
        }
    }
}

/// Where a ray stands in the sequence of samples: the number of its pixel's sample, and a key of its own.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Stream {
    number: u32,
    key: u32,
}

impl Stream {
    /// The stream of a pixel's first sample.
    #[must_use]
    pub const fn of_pixel([x, y]: [u32; 2], seed: u32) -> Self {
        Self { number: 0, key: mixed(x ^ mixed(y ^ mixed(seed ^ 0x9e37_79b9))) }
    }

    /// The stream of another sample of the same pixel.
    #[must_use]
    pub const fn sample(self, number: u32) -> Self {
        Self { number, key: self.key }
    }

    /// The stream of the `branch`-th ray that is spawned by the ray with this one.
    #[must_use]
    pub const fn branch(self, branch: u32) -> Self {
        Self { number: self.number, key: mixed(self.key ^ mixed(branch.wrapping_add(0x9e37_79b9))) }
    }

    /// The stream of one of `of` parts of the sample, such as one of several points of a light: all parts of all samples
    /// together are as even as so many samples.
    #[must_use]
    pub const fn part(self, part: u32, of: u32) -> Self {
        Self { number: self.number.wrapping_mul(of).wrapping_add(part), key: self.key }
    }

    /// A point of the unit square, [0, 1) each.
    ///
    /// Over the samples of a pixel the points for one purpose are a scrambled Sobol' sequence in a random order of its own:
    /// any 2ᵏ samples that begin at a multiple of 2ᵏ are spread as evenly as can be, and what they are for one purpose says
    /// nothing about what they are for another.
    #[inline]
    #[must_use]
    pub fn square(self, purpose: Purpose) -> [f64; 2] {
        let seed = mixed(self.key ^ mixed(purpose.key().wrapping_add(0x2c1b_3c6d)));
        let [x, y] = sobol_point(scrambled(self.number, seed));
        [fraction(scrambled(x, mixed(seed ^ 0xa511_e9b3))), fraction(scrambled(y, mixed(seed ^ 0x63d8_3595)))]
    }

    /// A number in [0, 1).
    #[must_use]
    pub fn number(self, purpose: Purpose) -> f64 {
        self.square(purpose)[0]
    }
}

/// A numerator over 2³² as a number.
#[inline]
fn fraction(bits: u32) -> f64 {
    f64::from(bits) / 4_294_967_296.0
}

/// A hash of 32 bits in which every bit of the input turns half of the output's (C. Wellons, hash prospector, 2018).
#[inline]
const fn mixed(mut bits: u32) -> u32 {
    bits ^= bits >> 16;
    bits = bits.wrapping_mul(0x7feb_352d);
    bits ^= bits >> 15;
    bits = bits.wrapping_mul(0x846c_a68b);
    bits ^ (bits >> 16)
}

#[cfg(test)]
mod tests {
    use super::*;

    const PURPOSES: [Purpose; 8] = [
        Purpose::Pixel,
        Purpose::Lens,
        Purpose::Light(0),
        Purpose::Light(1),
        Purpose::Wavelength,
        Purpose::Distance,
        Purpose::Phase,
        Purpose::Way,
    ];

    fn points(stream: Stream, purpose: Purpose, count: u32) -> Vec<[f64; 2]> {
        (0..count).map(|number| stream.sample(number).square(purpose)).collect()
    }

    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "places from 0 to the number of cells")]
    /// Whether each rectangle of every shape 2⁻ⁱ × 2⁻ʲ with i + j = k holds one of 2ᵏ points.
    fn is_net(points: &[[f64; 2]]) -> bool {
        let k = points.len().ilog2();
        (0..=k).all(|i| {
            let (columns, rows) = (1 << i, 1 << (k - i));
            let mut counts = vec![0; columns * rows];
            for [x, y] in points {
                counts[(x * columns as f64) as usize + columns * (y * rows as f64) as usize] += 1;
            }
            counts.iter().all(|&count| count == 1)
        })
    }

    #[test]
    fn every_power_of_two_of_samples_is_a_net_for_every_purpose() {
        for (purpose, k) in PURPOSES.into_iter().flat_map(|purpose| (0..=10).map(move |k| (purpose, k))) {
            for pixel in [[0, 0], [17, 3], [319, 239]] {
                let stream = Stream::of_pixel(pixel, 5);
                assert!(is_net(&points(stream, purpose, 1 << k)), "{purpose:?}, {k}");
                let next: Vec<_> = (1 << k..2 << k).map(|n| stream.sample(n).square(purpose)).collect();
                assert!(is_net(&next), "{purpose:?}, the second {k}");
            }
        }
    }

    #[test]
    fn the_parts_of_all_samples_are_one_net() {
        let stream = Stream::of_pixel([4, 9], 0);
        let parts = (0..16).flat_map(|n| (0..4).map(move |k| stream.sample(n).part(k, 4).square(Purpose::Light(0))));
        assert!(is_net(&parts.collect::<Vec<_>>()));
    }

    /// The correlation of independent even numbers over n points has the standard deviation 1/√n; of nets it is smaller.
    #[test]
    fn different_purposes_pixels_seeds_and_branches_are_not_correlated() {
        const COUNT: u32 = 4096;
        let stream = Stream::of_pixel([100, 50], 0);
        let mut sets: Vec<Vec<[f64; 2]>> = PURPOSES.map(|purpose| points(stream, purpose, COUNT)).to_vec();
        for other in [
            Stream::of_pixel([101, 50], 0),
            Stream::of_pixel([100, 51], 0),
            Stream::of_pixel([50, 100], 0),
            Stream::of_pixel([100, 50], 1),
            stream.branch(1),
            stream.branch(2),
            stream.branch(1).branch(2),
        ] {
            sets.push(points(other, Purpose::Lens, COUNT));
        }
        let axes: Vec<Vec<f64>> =
            sets.iter().flat_map(|set| [0, 1].map(|k| set.iter().map(|p| p[k]).collect())).collect();
        for (i, a) in axes.iter().enumerate() {
            for (j, b) in axes.iter().enumerate().skip(i + 1) {
                let sum: f64 = a.iter().zip(b).map(|(a, b)| (a - 0.5) * (b - 0.5)).sum();
                let correlation = 12.0 * sum / f64::from(COUNT);
                assert!(correlation.abs() < 5.0 / 64.0, "{i} and {j}: {correlation}");
            }
        }
    }

    /// The root mean square error of a mean over n points, over many pixels.
    fn error(count: u32, exact: f64, f: impl Fn([f64; 2]) -> f64) -> f64 {
        const PIXELS: u32 = 256;
        let squared = |pixel: u32| {
            let points = points(Stream::of_pixel([pixel, 7], 3), Purpose::Lens, count);
            (points.into_iter().map(&f).sum::<f64>() / f64::from(count) - exact).powi(2)
        };
        ((0..PIXELS).map(squared).sum::<f64>() / f64::from(PIXELS)).sqrt()
    }

    /// The power of n with which the error falls from 16 to 1,024 points.
    fn slope(exact: f64, f: impl Fn([f64; 2]) -> f64) -> f64 {
        (error(1024, exact, &f) / error(16, exact, &f)).ln() / 64.0_f64.ln()
    }

    #[test]
    fn means_of_a_smooth_function_err_by_about_n_to_the_minus_three_halves() {
        let e = 1.0_f64.exp();
        let slope = slope((e - 1.0).powi(2), |[x, y]| (x + y).exp());
        assert!((-1.75..-1.35).contains(&slope), "{slope}");
    }

    #[test]
    fn means_over_an_edge_err_by_less_than_those_of_random_points() {
        let disc = |[x, y]: [f64; 2]| f64::from(u8::from(x * x + y * y < 1.0));
        let slope = slope(std::f64::consts::FRAC_PI_4, disc);
        assert!(slope < -0.7, "{slope}");
    }
}
