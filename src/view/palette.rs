//! The colours of everything that is drawn, for light and dark backgrounds.
//!
//! The hues of kinds and sides are those of Okabe and Ito (2008), which people with any of the common colour vision
//! deficiencies tell apart, darkened for white paper and lightened for black. Kind is also told by dash and sign, so
//! that nothing depends on colour alone.

use serde::{Deserialize, Serialize};

/// An sRGB colour with straight alpha.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Colour {
    /// Red.
    pub r: u8,
    /// Green.
    pub g: u8,
    /// Blue.
    pub b: u8,
    /// Opacity, 255 is opaque.
    pub a: u8,
}

impl Colour {
    /// An opaque colour from `0xrrggbb`.
    #[must_use]
    pub const fn hex(rgb: u32) -> Self {
        let [_, r, g, b] = rgb.to_be_bytes();
        Self { r, g, b, a: 255 }
    }

    /// The same colour with another opacity, 0 to 1.
    #[must_use]
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to the range of u8")]
    pub fn faded(self, opacity: f64) -> Self {
        Self { a: (f64::from(self.a) * opacity.clamp(0.0, 1.0)).round() as u8, ..self }
    }

    /// The colour on the way from `self` (0) to `other` (1).
    #[must_use]
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between two values of u8")]
    pub fn mixed(self, other: Self, share: f64) -> Self {
        let mix = |a: u8, b: u8| (f64::from(a) + (f64::from(b) - f64::from(a)) * share.clamp(0.0, 1.0)).round() as u8;
        Self { r: mix(self.r, other.r), g: mix(self.g, other.g), b: mix(self.b, other.b), a: mix(self.a, other.a) }
    }
}

/// Light or dark background, and how far what is drawn stands out from it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Theme {
    /// Dark ink on light ground.
    #[default]
    Light,
    /// Light ink on dark ground.
    Dark,
    /// Black and deep colours on white.
    LightContrast,
    /// White and pale colours on black.
    DarkContrast,
}

impl Theme {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Light, Self::Dark, Self::LightContrast, Self::DarkContrast];

    /// Whether the ground is dark.
    #[must_use]
    pub const fn is_dark(self) -> bool {
        matches!(self, Self::Dark | Self::DarkContrast)
    }

    /// Whether its colours are as far apart as can be.
    #[must_use]
    pub const fn is_high_contrast(self) -> bool {
        matches!(self, Self::LightContrast | Self::DarkContrast)
    }

    /// Its colours.
    #[must_use]
    pub const fn palette(self) -> &'static Palette {
        match self {
            Self::Light => &LIGHT,
            Self::Dark => &DARK,
            Self::LightContrast => &LIGHT_CONTRAST,
            Self::DarkContrast => &DARK_CONTRAST,
        }
    }
}

/// The colours of a theme, by what they stand for.
#[derive(Clone, Copy, Debug)]
pub struct Palette {
    /// The ground of a drawing.
    pub ground: Colour,
    /// The ground of panels around drawings.
    pub panel: Colour,
    /// Text and axes.
    pub ink: Colour,
    /// Secondary text and ticks.
    pub faint: Colour,
    /// Grid lines and borders.
    pub grid: Colour,
    /// What is selected.
    pub highlight: Colour,
    /// The camera ray.
    pub camera: Colour,
    /// Reflected rays.
    pub reflected: Colour,
    /// Refracted rays.
    pub refracted: Colour,
    /// Shadow rays.
    pub shadow: Colour,
    /// Rays that were turned in a medium.
    pub scattered: Colour,
    /// Normals.
    pub normal: Colour,
    /// Extents.
    pub extent: Colour,
    /// The left operand.
    pub left: Colour,
    /// The right operand.
    pub right: Colour,
    /// The combined result.
    pub combined: Colour,
    /// d(t) > 0.
    pub outside: Colour,
    /// d(t) < 0.
    pub inside: Colour,
    /// What is accepted.
    pub good: Colour,
    /// What is rejected, blocked or wrong.
    pub bad: Colour,
    /// For things that have no colour of their own, in order.
    pub categories: [Colour; 7],
}

static LIGHT: Palette = Palette {
    ground: Colour::hex(0xff_ff_ff),
    panel: Colour::hex(0xf6_f6_f4),
    ink: Colour::hex(0x1c_1f_24),
    faint: Colour::hex(0x6a_6f_78),
    grid: Colour::hex(0xd9_dc_e1),
    highlight: Colour::hex(0xf2_b7_05),
    camera: Colour::hex(0x00_62_a3),
    reflected: Colour::hex(0xc8_4e_00),
    refracted: Colour::hex(0x00_80_5e),
    shadow: Colour::hex(0x8a_6d_00),
    scattered: Colour::hex(0x9a_3f_a8),
    normal: Colour::hex(0xa8_4a_7f),
    extent: Colour::hex(0x7a_80_8a),
    left: Colour::hex(0x2b_8b_c9),
    right: Colour::hex(0xdb_8a_00),
    combined: Colour::hex(0x00_93_6b),
    outside: Colour::hex(0xd5_7a_00),
    inside: Colour::hex(0x00_6f_b5),
    good: Colour::hex(0x00_80_5e),
    bad: Colour::hex(0xc2_3b_22),
    categories: [
        Colour::hex(0x4a_9f_d8),
        Colour::hex(0xe0_9a_1a),
        Colour::hex(0x1f_9e_78),
        Colour::hex(0xc9_74_a3),
        Colour::hex(0xd0_62_1b),
        Colour::hex(0x9a_8f_1c),
        Colour::hex(0x6b_72_80),
    ],
};

static DARK: Palette = Palette {
    ground: Colour::hex(0x15_18_1d),
    panel: Colour::hex(0x1d_21_27),
    ink: Colour::hex(0xe6_e8_eb),
    faint: Colour::hex(0x96_9d_a8),
    grid: Colour::hex(0x35_3b_45),
    highlight: Colour::hex(0xff_d2_3f),
    camera: Colour::hex(0x62_bf_f5),
    reflected: Colour::hex(0xff_8f_4d),
    refracted: Colour::hex(0x35_cf_a2),
    shadow: Colour::hex(0xe2_c5_4a),
    scattered: Colour::hex(0xd9_8f_e6),
    normal: Colour::hex(0xea_9c_c8),
    extent: Colour::hex(0x8d_95_a1),
    left: Colour::hex(0x56_b4_e9),
    right: Colour::hex(0xf0_a8_30),
    combined: Colour::hex(0x2f_c2_97),
    outside: Colour::hex(0xf0_a0_3c),
    inside: Colour::hex(0x5a_b8_f0),
    good: Colour::hex(0x35_cf_a2),
    bad: Colour::hex(0xff_7a_66),
    categories: [
        Colour::hex(0x56_b4_e9),
        Colour::hex(0xe6_a1_2e),
        Colour::hex(0x2f_b8_8f),
        Colour::hex(0xd8_8a_b5),
        Colour::hex(0xe8_7a_3c),
        Colour::hex(0xc9_bd_45),
        Colour::hex(0x9a_a1_ad),
    ],
};

static LIGHT_CONTRAST: Palette = Palette {
    ground: Colour::hex(0xff_ff_ff),
    panel: Colour::hex(0xff_ff_ff),
    ink: Colour::hex(0x00_00_00),
    faint: Colour::hex(0x3a_3f_47),
    grid: Colour::hex(0x6a_6f_78),
    highlight: Colour::hex(0xb3_6b_00),
    camera: Colour::hex(0x00_3f_73),
    reflected: Colour::hex(0x8a_2f_00),
    refracted: Colour::hex(0x00_51_3a),
    shadow: Colour::hex(0x57_43_00),
    scattered: Colour::hex(0x6f_1f_80),
    normal: Colour::hex(0x7d_23_58),
    extent: Colour::hex(0x4a_4f_57),
    left: Colour::hex(0x0a_4f_86),
    right: Colour::hex(0x7a_46_00),
    combined: Colour::hex(0x00_54_3c),
    outside: Colour::hex(0x7a_43_00),
    inside: Colour::hex(0x00_4a_80),
    good: Colour::hex(0x00_51_3a),
    bad: Colour::hex(0x94_18_0a),
    categories: [
        Colour::hex(0x0a_4f_86),
        Colour::hex(0x7a_46_00),
        Colour::hex(0x00_51_3a),
        Colour::hex(0x7d_23_58),
        Colour::hex(0x8a_2f_00),
        Colour::hex(0x57_43_00),
        Colour::hex(0x3a_3f_47),
    ],
};

static DARK_CONTRAST: Palette = Palette {
    ground: Colour::hex(0x00_00_00),
    panel: Colour::hex(0x00_00_00),
    ink: Colour::hex(0xff_ff_ff),
    faint: Colour::hex(0xd5_d9_df),
    grid: Colour::hex(0x8d_95_a1),
    highlight: Colour::hex(0xff_e1_4d),
    camera: Colour::hex(0x8f_d6_ff),
    reflected: Colour::hex(0xff_b1_85),
    refracted: Colour::hex(0x5c_f0_c4),
    shadow: Colour::hex(0xff_e2_7a),
    scattered: Colour::hex(0xf0_b8_fa),
    normal: Colour::hex(0xff_c0_e0),
    extent: Colour::hex(0xc4_ca_d3),
    left: Colour::hex(0x8c_cd_f7),
    right: Colour::hex(0xff_c7_66),
    combined: Colour::hex(0x62_e8_c0),
    outside: Colour::hex(0xff_c0_70),
    inside: Colour::hex(0x8f_d2_ff),
    good: Colour::hex(0x5c_f0_c4),
    bad: Colour::hex(0xff_a5_98),
    categories: [
        Colour::hex(0x8c_cd_f7),
        Colour::hex(0xff_c7_66),
        Colour::hex(0x62_e8_c0),
        Colour::hex(0xff_c0_e0),
        Colour::hex(0xff_b1_85),
        Colour::hex(0xff_e2_7a),
        Colour::hex(0xd5_d9_df),
    ],
};

#[cfg(test)]
mod tests {
    use super::*;

    /// Relative luminance and contrast as WCAG 2 defines them.
    fn contrast(a: Colour, b: Colour) -> f64 {
        let linear = |x: u8| {
            let x = f64::from(x) / 255.0;
            if x <= 0.040_45 { x / 12.92 } else { ((x + 0.055) / 1.055).powf(2.4) }
        };
        let luminance = |c: Colour| 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b);
        let (a, b) = (luminance(a) + 0.05, luminance(b) + 0.05);
        a.max(b) / a.min(b)
    }

    #[test]
    fn texts_and_rays_stand_out_from_the_ground() {
        for theme in Theme::ALL {
            let p = theme.palette();
            for text in
                [p.ink, p.faint, p.camera, p.reflected, p.refracted, p.shadow, p.scattered, p.normal, p.bad, p.good]
            {
                assert!(contrast(text, p.ground) >= 4.5, "{theme:?} {text:?}: {}", contrast(text, p.ground));
            }
            for line in [p.left, p.combined, p.outside, p.inside, p.extent] {
                assert!(contrast(line, p.ground) >= 3.0, "{theme:?} {line:?}: {}", contrast(line, p.ground));
            }
        }
    }

    #[test]
    fn with_high_contrast_every_text_and_line_stands_out_seven_times() {
        for theme in [Theme::LightContrast, Theme::DarkContrast] {
            let p = theme.palette();
            let texts =
                [p.ink, p.faint, p.camera, p.reflected, p.refracted, p.shadow, p.scattered, p.normal, p.bad, p.good];
            let lines = [p.left, p.right, p.combined, p.outside, p.inside, p.extent];
            for colour in texts.into_iter().chain(lines).chain(p.categories) {
                assert!(contrast(colour, p.ground) >= 7.0, "{theme:?} {colour:?}: {}", contrast(colour, p.ground));
            }
            assert!(contrast(p.grid, p.ground) >= 3.0, "{theme:?}");
        }
    }
}
