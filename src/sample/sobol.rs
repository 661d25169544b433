//! Sobol' points in the unit square, scrambled after Owen.
//!
//! The first 2ᵏ points of the sequence, and every further 2ᵏ, form a (0, k, 2)-net: each of the 2ᵏ rectangles of any one
//! shape 2⁻ⁱ × 2⁻ʲ with i + j = k holds exactly one of them. Scrambling keeps that and makes everything else random, so
//! that means over the points are right on average, and over smooth functions err by about n^−3/2.
//!
//! **Source** S. Joe and F. Kuo, Remark on Algorithm 659 (ACM TOMS 29(1), 2003), for the sequence; B. Burley, Practical
//! Hash-based Owen Scrambling (Journal of Computer Graphics Techniques 9(4), 2020), for scrambling by a hash of the
//! reversed bits, and for points of more dimensions by shuffling (padding); N. Vegdahl, Building a Better LK Hash (2021), for
//! the hash itself, after S. Laine and T. Karras, Stratified Sampling for Stochastic Transparency (EGSR 2011).

/// The point with this number in the Sobol' sequence's first two dimensions, as numerators over 2³².
///
/// Bit j of the number adds the j-th direction number. In the second dimension those are the rows of Pascal's triangle
/// modulo 2: a sum over all larger sets of bits, taken bit by bit.
#[inline]
#[must_use]
pub const fn sobol_point(number: u32) -> [u32; 2] {
    let mut sums = number;
    sums ^= (sums & 0xaaaa_aaaa) >> 1;
    sums ^= (sums & 0xcccc_cccc) >> 2;
    sums ^= (sums & 0xf0f0_f0f0) >> 4;
    sums ^= (sums & 0xff00_ff00) >> 8;
    sums ^= (sums & 0xffff_0000) >> 16;
    [number.reverse_bits(), sums.reverse_bits()]
}

/// Owen's nested scrambling of a numerator over 2³²: every bit is turned or not by what the bits before it and the seed say.
#[inline]
#[must_use]
pub const fn scrambled(bits: u32, seed: u32) -> u32 {
    laine_karras(bits.reverse_bits(), seed).reverse_bits()
}

/// A hash in which every bit depends on itself, on those below it and on the seed alone.
#[inline]
const fn laine_karras(mut bits: u32, seed: u32) -> u32 {
    bits ^= bits.wrapping_mul(0x3d20_adea);
    bits = bits.wrapping_add(seed);
    bits = bits.wrapping_mul(seed >> 16 | 1);
    bits ^= bits.wrapping_mul(0x0552_6c56);
    bits ^ bits.wrapping_mul(0x53a2_2864)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The beginning of the sequence in its natural order, by hand from the direction numbers 1/2, 3/4, 5/8, 15/16 of the
    /// second dimension (Joe and Kuo: s = 1, a = 0, m = 1).
    #[test]
    fn the_first_points_are_those_of_the_tables() {
        let expected = [
            [0.0, 0.0],
            [0.5, 0.5],
            [0.25, 0.75],
            [0.75, 0.25],
            [0.125, 0.625],
            [0.625, 0.125],
            [0.375, 0.375],
            [0.875, 0.875],
            [0.0625, 0.9375],
        ];
        for (number, point) in (0..).zip(expected) {
            assert_eq!(sobol_point(number).map(|bits| f64::from(bits) / 4_294_967_296.0), point, "{number}");
        }
    }

    #[test]
    fn direction_numbers_follow_from_one_another() {
        let mut direction = 1_u32 << 31;
        for bit in 0..32 {
            assert_eq!(sobol_point(1 << bit), [1 << (31 - bit), direction]);
            direction ^= direction >> 1;
        }
    }

    /// Numbers that agree in their first k bits still do when they are scrambled, and then differ in the next one.
    #[test]
    fn scrambling_is_nested() {
        for seed in [0, 1, 0x1234_5678, 0xdead_beef] {
            for (a, b) in [(0x8000_0000_u32, 0), (0x1234_5678, 0x1234_5778), (0xffff_ffff, 0xffff_fffe)] {
                let shared = (a ^ b).leading_zeros();
                assert_eq!((scrambled(a, seed) ^ scrambled(b, seed)).leading_zeros(), shared, "{a:x} {b:x} {seed:x}");
            }
        }
    }

    /// Each of the first bits is turned by half of all seeds, whatever the bits before it are: the share's standard
    /// deviation over 4,096 seeds is 1/128.
    #[test]
    fn every_bit_is_turned_by_half_of_the_seeds() {
        const SEEDS: u32 = 4096;
        for bits in [0, 0x4000_0000, 0xa000_0000, 0xe9c4_0000, 0x7777_7777] {
            for place in 0..12 {
                let turns = |&k: &u32| {
                    let turned = scrambled(bits, k.wrapping_mul(0x9e37_79b9)) ^ bits;
                    turned << place >> 31 == 1
                };
                let share = (0..SEEDS).filter(turns).count() as f64 / f64::from(SEEDS);
                assert!((share - 0.5).abs() < 5.0 / 128.0, "bit {place} of {bits:x}: {share}");
            }
        }
    }
}
