//! The random numbers of one sample of one pixel: the same ones whenever and wherever they are asked for.

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
    /// The stream of a sample; each pixel and each seed has a key of its own.
    #[must_use]
    pub const fn new(number: u32, key: u32) -> Self {
        Self { number, key }
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
    #[must_use]
    pub fn square(self, purpose: Purpose) -> [f64; 2] {
        let bits = mixed(self.key ^ mixed(purpose.key()) ^ mixed(self.number.wrapping_mul(0x85eb_ca6b)));
        [bits, mixed(bits ^ 0xc2b2_ae35)].map(|bits| f64::from(bits) / 4_294_967_296.0)
    }

    /// A number in [0, 1).
    #[must_use]
    pub fn number(self, purpose: Purpose) -> f64 {
        self.square(purpose)[0]
    }
}

/// A hash of 32 bits in which every bit of the input turns half of the output's (C. Wellons, hash prospector, 2018).
const fn mixed(mut bits: u32) -> u32 {
    bits ^= bits >> 16;
    bits = bits.wrapping_mul(0x7feb_352d);
    bits ^= bits >> 15;
    bits = bits.wrapping_mul(0x846c_a68b);
    bits ^ (bits >> 16)
}
