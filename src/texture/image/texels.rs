//! An image as numbers, and its pyramid of ever smaller copies.

use super::wrap::Wraps;
use crate::math::portable;
use glam::DVec3;
use std::sync::OnceLock;

/// The most texels that an image may have: 64 Mi, 768 MiB as stored.
pub const MOST_TEXELS: u64 = 64 << 20;

/// The image alone counts, not whether its pyramid was asked for.
impl PartialEq for Texels {
    fn eq(&self, other: &Self) -> bool {
        (self.width, self.height, &self.data) == (other.width, other.height, &other.data)
    }
}

/// What the bytes of an image mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Encoding {
    /// Colours: the curve of IEC 61966-2-1.
    Srgb,
    /// Plain numbers, such as heights: 0 is 0 and 255 is 1.
    Linear,
}

impl Encoding {
    /// The linear value of a stored one, both from 0 to 1, as it is kept in an image.
    #[must_use]
    pub fn linear(self, stored: f64) -> f32 {
        let linear = match self {
            Self::Linear => stored,
            // IEC 61966-2-1, 5.2: the straight piece up to 0.04045, and the power above it.
            Self::Srgb if stored <= 0.040_45 => stored / 12.92,
            Self::Srgb => portable::powf((stored + 0.055) / 1.055, 2.4),
        };
        #[expect(clippy::cast_possible_truncation, reason = "kept with 24 bits, where files have 8 or 16")]
        let kept = linear as f32;
        kept
    }

    /// The linear values of all bytes.
    fn table(self) -> [f32; 256] {
        std::array::from_fn(|byte| self.linear(byte as f64 / 255.0))
    }
}

/// An image in linear RGB; texel (0, 0) is the top left one.
#[derive(Clone, Debug)]
pub struct Texels {
    width: u32,
    height: u32,
    /// Row by row from the top.
    data: Vec<[f32; 3]>,
    /// The smaller copies, worked out when a filter first asks for one.
    pyramid: OnceLock<Vec<Texels>>,
}

impl Texels {
    /// An image from linear RGB, row by row from the top.
    ///
    /// # Errors
    /// If there are no texels, more than 64 Mi, or not as many as the size says, or if a value is no number.
    pub fn from_linear(width: u32, height: u32, data: Vec<[f32; 3]>) -> Result<Self, String> {
        check_size(width, height, data.len())?;
        let columns = width as usize;
        if let Some(bad) = data.iter().position(|texel| texel.iter().any(|value| !value.is_finite())) {
            let [r, g, b] = data[bad];
            let (x, y) = (bad % columns, bad / columns);
            return Err(format!("texel ({x}, {y}) is ({r}, {g}, {b}); finite numbers were expected"));
        }
        Ok(Self { width, height, data, pyramid: OnceLock::new() })
    }

    /// An image from bytes, three a texel, row by row from the top.
    ///
    /// # Errors
    /// If there are no texels, more than 64 Mi, or not as many as the size says.
    pub fn from_bytes(width: u32, height: u32, bytes: &[u8], encoding: Encoding) -> Result<Self, String> {
        if !bytes.len().is_multiple_of(3) {
            return Err(format!("{} bytes were given; three for each texel were expected", bytes.len()));
        }
        check_size(width, height, bytes.len() / 3)?;
        let table = encoding.table();
        let texel = |rgb: &[u8]| [0, 1, 2].map(|i| table[usize::from(rgb[i])]);
        let data = bytes.chunks_exact(3).map(texel).collect();
        Ok(Self { width, height, data, pyramid: OnceLock::new() })
    }

    /// Columns and rows.
    #[must_use]
    pub fn size(&self) -> [u32; 2] {
        [self.width, self.height]
    }

    /// The colour at a column and row, which may lie beyond the edges.
    #[must_use]
    pub fn at(&self, [column, row]: [i64; 2], wraps: Wraps) -> DVec3 {
        let column = wraps.columns.index(column, self.width);
        let row = wraps.rows.index(row, self.height);
        let [r, g, b] = self.data[row * self.width as usize + column];
        DVec3::new(f64::from(r), f64::from(g), f64::from(b))
    }

    /// How many levels the pyramid has, this image included.
    #[must_use]
    pub fn levels(&self) -> usize {
        self.pyramid().len() + 1
    }

    /// A level of the pyramid: 0 is this image, and those beyond the last are the last, of one texel.
    #[must_use]
    pub fn level(&self, level: usize) -> &Self {
        match level {
            0 => self,
            _ => self.pyramid().get(level - 1).or(self.pyramid().last()).unwrap_or(self),
        }
    }

    /// Level 1 and up, each half as wide and high as the one before, rounded up.
    fn pyramid(&self) -> &[Self] {
        self.pyramid.get_or_init(|| {
            let mut levels: Vec<Self> = Vec::new();
            while let Some(smaller) = levels.last().unwrap_or(self).halved() {
                levels.push(smaller);
            }
            levels
        })
    }

    /// The image with half as many columns and rows, rounded up; none if it has one texel. Each new texel is the average
    /// over the area that it covers, so that parts of texels count with their parts where a size is odd.
    fn halved(&self) -> Option<Self> {
        if self.size() == [1, 1] {
            return None;
        }
        let [width, height] = self.size().map(|count| count.div_ceil(2));
        let columns = shares(self.width, width);
        let rows = shares(self.height, height);
        let mut data = Vec::with_capacity(width as usize * height as usize);
        for row in &rows {
            for column in &columns {
                let mut sum = DVec3::ZERO;
                for (y, share_y) in row {
                    for (x, share_x) in column {
                        sum += self.at([*x, *y], Wraps::default()) * (share_x * share_y);
                    }
                }
                data.push(sum.as_vec3().to_array());
            }
        }
        Some(Self { width, height, data, pyramid: OnceLock::new() })
    }
}

fn check_size(width: u32, height: u32, texels: usize) -> Result<(), String> {
    let wanted = u64::from(width) * u64::from(height);
    if wanted == 0 || wanted > MOST_TEXELS {
        return Err(format!("the image has {width} × {height} texels; 1 to {MOST_TEXELS} were expected"));
    }
    if wanted != texels as u64 {
        return Err(format!("{texels} texels were given; {width} × {height} = {wanted} were expected"));
    }
    Ok(())
}

/// For each of `to` equal stretches of a line of `from` texels: the texels that it touches, and their shares of it.
pub(super) fn shares(from: u32, to: u32) -> Vec<Vec<(i64, f64)>> {
    // In units of 1/to of a texel all ends are whole numbers.
    let (from, to) = (i64::from(from), i64::from(to));
    let stretch = |i: i64| {
        let (start, end) = (i * from, (i + 1) * from);
        let share = |x: i64| ((x + 1) * to).min(end) - (x * to).max(start);
        (start / to..(end + to - 1) / to).map(|x| (x, share(x) as f64 / from as f64)).collect()
    };
    (0..to).map(stretch).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::texture::image::Wrap;

    fn mean(texels: &Texels) -> f64 {
        let [width, height] = texels.size().map(i64::from);
        let all = (0..height).flat_map(|y| (0..width).map(move |x| [x, y]));
        all.map(|at| texels.at(at, Wraps::default()).x).sum::<f64>() / (width * height) as f64
    }

    #[test]
    fn bytes_become_linear_as_the_standard_says() {
        let texels = Texels::from_bytes(2, 1, &[0, 255, 188, 10, 11, 128], Encoding::Srgb).unwrap();
        let at = |x| texels.at([x, 0], Wraps::default());
        assert_eq!(at(0).truncate().to_array(), [0.0, 1.0]);
        assert!((at(0).z - 0.502_886_5).abs() < 1e-6);
        // 10 lies on the straight piece, 11 on the curve; 128 is the middle grey of every table of sRGB.
        assert!((at(1) - DVec3::new(0.003_035_270, 0.003_346_536, 0.215_860_5)).abs().max_element() < 1e-7);
        let linear = Texels::from_bytes(1, 1, &[51, 102, 255], Encoding::Linear).unwrap();
        assert!((linear.at([0, 0], Wraps::default()) - DVec3::new(0.2, 0.4, 1.0)).abs().max_element() < 1e-7);
    }

    #[test]
    fn every_level_of_the_pyramid_has_the_same_mean() {
        for (width, height) in [(8, 8), (7, 5), (1, 9), (13, 1), (3, 2)] {
            let data = (0..width * height).map(|i: u32| [(i * 37 % 11) as f32; 3]).collect();
            let texels = Texels::from_linear(width, height, data).unwrap();
            for level in 0..texels.levels() {
                assert!((mean(texels.level(level)) - mean(&texels)).abs() < 1e-5, "{width}×{height}, level {level}");
            }
            assert_eq!(texels.level(99).size(), [1, 1]);
        }
    }

    #[test]
    fn a_texel_that_is_cut_counts_with_its_parts() {
        let texels = Texels::from_linear(3, 1, vec![[0.0; 3], [1.0; 3], [4.0; 3]]).unwrap();
        // 3 texels in 2 halves: the middle one is half in each.
        let half = texels.level(1);
        assert_eq!(half.size(), [2, 1]);
        assert!((half.at([0, 0], Wraps::default()).x - 1.0 / 3.0).abs() < 1e-7);
        assert!((half.at([1, 0], Wraps::default()).x - 3.0).abs() < 1e-7);
        assert_eq!(
            half.at([5, 0], Wraps { columns: Wrap::Clamp, rows: Wrap::Clamp }),
            half.at([1, 0], Wraps::default())
        );
    }

    #[test]
    fn what_is_no_image_is_said_to_be_none() {
        assert!(Texels::from_linear(0, 4, Vec::new()).unwrap_err().contains("0 × 4"));
        assert!(Texels::from_linear(2, 1, vec![[0.0; 3]]).unwrap_err().contains("2 × 1 = 2"));
        assert!(Texels::from_linear(1, 1, vec![[0.0, f32::NAN, 0.0]]).unwrap_err().contains("(0, 0)"));
        assert!(Texels::from_bytes(1, 1, &[1, 2], Encoding::Srgb).unwrap_err().contains("2 bytes"));
        assert!(Texels::from_bytes(100_000, 100_000, &[], Encoding::Srgb).is_err());
    }
}
