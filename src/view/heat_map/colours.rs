//! The colours of maps.
//!
//! Values have those of viridis, which grows lighter evenly, for people with any of the common colour vision deficiencies, too.
//!
//! **Source** S. van der Walt, N. Smith, viridis (Matplotlib, 2015), by the polynomial of degree six that M. Zucker fitted to it
//! (public domain, 2019), which is off by at most two hundredths.

use super::{HeatMap, HeatScale};
use crate::view::palette::{Colour, Palette};

/// Shades of a scale: more could not be told apart, and make larger files.
pub const SHADES: usize = 64;

const VIRIDIS: [[f64; 3]; 7] = [
    [0.277_727_327_223_417_7, 0.005_407_344_544_966_578, 0.334_099_805_335_306_1],
    [0.105_093_043_108_577_4, 1.404_613_529_898_575, 1.384_590_162_594_685],
    [-0.330_861_828_725_556_3, 0.214_847_559_468_213, 0.095_095_163_028_236_59],
    [-4.634_230_498_983_486, -5.799_100_973_351_585, -19.332_440_956_279_87],
    [6.228_269_936_347_081, 14.179_933_366_805_09, 56.690_552_600_681_05],
    [4.776_384_997_670_288, -13.745_145_377_746_01, -65.353_032_633_372_34],
    [-5.435_455_855_934_631, 4.645_852_612_178_535, 26.312_435_249_583_2],
];

/// The colour of a share, from 0 (dark) to 1 (light).
pub fn viridis(share: f64) -> Colour {
    let channel = |k: usize| {
        let value = VIRIDIS.iter().rev().fold(0.0, |sum, coefficients| sum * share.clamp(0.0, 1.0) + coefficients[k]);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and 255")]
        let byte = (255.0 * value.clamp(0.0, 1.0)).round() as u8;
        byte
    };
    Colour { r: channel(0), g: channel(1), b: channel(2), a: 255 }
}

/// What a square is painted with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Paint {
    /// A shade of the scale.
    Shade(usize),
    /// A class.
    Class(usize),
    /// Exactly 0, on a logarithmic scale.
    Zero,
    /// No value.
    Nothing,
    /// Off the scale.
    Beyond,
}

/// From sure to unsure: light, middle and dark, so that they are told apart without any colour.
const CLASSES: [Colour; 3] = [Colour::hex(0xdc_e6_f0), Colour::hex(0xe6_9f_00), Colour::hex(0x5a_00_46)];

/// No colour of viridis is like it, nor looks like it to those who see no red or no green.
const BEYOND: Colour = Colour::hex(0xff_1f_c4);

impl Paint {
    /// How many there are.
    pub const COUNT: usize = SHADES + CLASSES.len() + 3;

    /// What a value is painted with.
    pub fn of(map: &HeatMap, value: f64) -> Self {
        match &map.scale {
            _ if value.is_nan() => Self::Nothing,
            _ if value.is_infinite() => Self::Beyond,
            HeatScale::Classes(_) => Self::Class((0..CLASSES.len() - 1).find(|k| value < *k as f64 + 0.5).unwrap_or(2)),
            HeatScale::Log(_) if value <= 0.0 && map.zero.is_some() => Self::Zero,
            scale => Self::Shade(scale.shade(value)),
        }
    }

    /// Its place among all of them.
    pub const fn index(self) -> usize {
        match self {
            Self::Shade(k) => k,
            Self::Class(k) => SHADES + k,
            Self::Zero => SHADES + CLASSES.len(),
            Self::Nothing => SHADES + CLASSES.len() + 1,
            Self::Beyond => SHADES + CLASSES.len() + 2,
        }
    }

    /// The one with this place.
    pub const fn from_index(index: usize) -> Self {
        const CLASS_END: usize = SHADES + CLASSES.len();
        const NOTHING: usize = CLASS_END + 1;
        match index {
            0..SHADES => Self::Shade(index),
            SHADES..CLASS_END => Self::Class(index - SHADES),
            CLASS_END => Self::Zero,
            NOTHING => Self::Nothing,
            _ => Self::Beyond,
        }
    }

    /// Its colour.
    pub fn colour(self, palette: &Palette) -> Colour {
        match self {
            Self::Shade(k) => viridis(k as f64 / (SHADES - 1) as f64),
            Self::Class(k) => CLASSES[k.min(CLASSES.len() - 1)],
            Self::Zero => palette.ground,
            Self::Nothing => palette.ground.mixed(palette.ink, 0.18),
            Self::Beyond => BEYOND,
        }
    }
}
