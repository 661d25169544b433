//! The colours of maps.
//!
//! Values have those of viridis, which grows lighter evenly, for people with any of the common colour vision deficiencies, too.
//!
//! **Source** S. van der Walt, N. Smith, viridis (Matplotlib, 2015), by the polynomial of degree six that M. Zucker fitted to it
//! (public domain, 2019), which is off by at most two hundredths.

use super::{HeatMap, HeatScale};
use crate::math::portable;
use crate::view::palette::{Colour, Palette};
use crate::view::scene_colour::is_dark;

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

/// Where the scale begins on a dark ground, from which the darkest colours of viridis could hardly be told.
const FIRST_ON_DARK: f64 = 0.24;

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

/// Kinds that are told apart by colour alone, by people with any of the common colour vision deficiencies; further ones have them
/// again, darker.
///
/// **Source** M. Okabe, K. Ito, Color Universal Design (2008).
const KINDS: [Colour; 8] = [
    Colour::hex(0xe6_9f_00),
    Colour::hex(0x56_b4_e9),
    Colour::hex(0x00_9e_73),
    Colour::hex(0xf0_e4_42),
    Colour::hex(0x00_72_b2),
    Colour::hex(0xd5_5e_00),
    Colour::hex(0xcc_79_a7),
    Colour::hex(0x40_40_40),
];

/// The colour of a kind.
pub fn kind(number: usize) -> Colour {
    let (again, number) = (number / KINDS.len(), number % KINDS.len());
    KINDS[number].mixed(Colour::hex(0), 1.0 - portable::powi(0.62, i32::try_from(again.min(4)).unwrap_or(4)))
}

/// Levels of a channel in the colours of directions. More would make larger files, fewer would show steps.
const LEVELS: u16 = 32;

/// What a square is painted with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Paint {
    /// A shade of the scale.
    Shade(usize),
    /// A class.
    Class(usize),
    /// A kind.
    Kind(usize),
    /// A direction: how far it goes to the right, up and towards the eye, each as a level.
    Direction([u16; 3]),
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
    /// What a value is painted with.
    pub fn of(map: &HeatMap, value: f64) -> Self {
        match &map.scale {
            _ if value.is_nan() => Self::Nothing,
            _ if value.is_infinite() => Self::Beyond,
            HeatScale::Classes(_) => Self::Class((0..CLASSES.len() - 1).find(|k| value < *k as f64 + 0.5).unwrap_or(2)),
            HeatScale::Kinds(_) => {
                #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a place in a list")]
                let kind = value.max(0.0).round() as usize;
                Self::Kind(kind)
            }
            HeatScale::Log(_) if value <= 0.0 && map.zero.is_some() => Self::Zero,
            scale => Self::Shade(scale.shade(value)),
        }
    }

    /// What the value in a place is painted with.
    pub fn at(map: &HeatMap, place: usize) -> Self {
        let value = map.values.get(place).copied().unwrap_or(f64::NAN);
        match &map.scale {
            HeatScale::Directions(directions) if !value.is_nan() => {
                directions.get(place).map_or(Self::Nothing, |&direction| Self::of_direction(direction))
            }
            _ => Self::of(map, value),
        }
    }

    /// The colour of a direction has its parts, from −1 to 1, as red, green and blue.
    pub fn of_direction(direction: [f64; 3]) -> Self {
        Self::Direction(direction.map(|part| {
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and the levels")]
            let level = (0.5 * (part.clamp(-1.0, 1.0) + 1.0) * f64::from(LEVELS - 1)).round() as u16;
            level
        }))
    }

    /// Its colour.
    pub fn colour(self, palette: &Palette) -> Colour {
        match self {
            Self::Shade(k) => {
                let first = if is_dark(palette.ground) { FIRST_ON_DARK } else { 0.0 };
                viridis(first + (1.0 - first) * k as f64 / (SHADES - 1) as f64)
            }
            Self::Class(k) => CLASSES[k.min(CLASSES.len() - 1)],
            Self::Kind(k) => kind(k),
            Self::Direction(levels) => {
                let [r, g, b] = levels.map(|level| u8::try_from(255 * level / (LEVELS - 1)).unwrap_or(255));
                Colour { r, g, b, a: 255 }
            }
            Self::Zero => palette.ground,
            Self::Nothing => palette.ground.mixed(palette.ink, 0.18),
            Self::Beyond => BEYOND,
        }
    }
}
