//! A reference as bytes, for whoever keeps references from one run to the next.
//!
//! A line of text says what it is, then follow numbers in little-endian order: width, height and count as 32 bits each, the sums
//! and then the sums of squares of all channels of all pixels as 64-bit floats, and a checksum of everything before it.

use super::reference::Sums;
use crate::scene::Rgb;

/// The first words of the line of text. Another version of the format is another reference.
const FORMAT: &str = "rayscope reference 1: ";

/// Bytes of one colour.
const COLOUR: usize = 3 * size_of::<f64>();

/// Where references are kept.
pub trait Store {
    /// What was saved under this name, if anything.
    fn load(&mut self, name: &str) -> Option<Vec<u8>>;
    /// Saves it, if that is possible.
    fn save(&mut self, name: &str, bytes: &[u8]);
}

/// Keeps nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoStore;

impl Store for NoStore {
    fn load(&mut self, _name: &str) -> Option<Vec<u8>> {
        None
    }

    fn save(&mut self, _name: &str, _bytes: &[u8]) {}
}

/// FNV-1a with 64 bits (G. Fowler, L. Noll, K.-P. Vo): finds files that were cut off or changed by accident.
#[must_use]
pub fn checksum(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, &byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

impl Sums {
    /// The bytes of a file that says what it is.
    #[must_use]
    pub fn to_bytes(&self, name: &str) -> Vec<u8> {
        let mut bytes = format!("{FORMAT}{name}\n").into_bytes();
        bytes.extend([self.width, self.height, self.count].iter().flat_map(|number| number.to_le_bytes()));
        let colours = self.colours.iter().chain(&self.squares);
        bytes.extend(colours.flat_map(Rgb::to_array).flat_map(f64::to_le_bytes));
        let sum = checksum(&bytes);
        bytes.extend(sum.to_le_bytes());
        bytes
    }

    /// Reads such a file.
    ///
    /// # Errors
    /// Says why it is not the file of this name.
    pub fn from_bytes(bytes: &[u8], name: &str) -> Result<Self, String> {
        let (body, end) = bytes.split_last_chunk::<8>().ok_or("it is too short")?;
        if checksum(body) != u64::from_le_bytes(*end) {
            return Err("its checksum is wrong: it was cut off or changed".to_owned());
        }
        let title = format!("{FORMAT}{name}\n");
        let mut rest = body.strip_prefix(title.as_bytes()).ok_or("it is of something else")?;
        let mut number = || {
            let (number, after) = rest.split_first_chunk::<4>().ok_or("it has no size")?;
            rest = after;
            Ok::<u32, String>(u32::from_le_bytes(*number))
        };
        let [width, height, count] = [number()?, number()?, number()?];
        let pixels = width as usize * height as usize;
        if Some(rest.len()) != pixels.checked_mul(2 * COLOUR) {
            return Err(format!("it has {} bytes of colours, which is not twice {width} × {height}", rest.len()));
        }
        let mut colours: Vec<Rgb> = rest.chunks_exact(COLOUR).map(colour).collect();
        let squares = colours.split_off(pixels);
        Ok(Self { width, height, count, colours, squares })
    }
}

fn colour(bytes: &[u8]) -> Rgb {
    let (channels, _) = bytes.as_chunks::<8>();
    Rgb::from_array([0, 1, 2].map(|k| f64::from_le_bytes(channels[k])))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trace::Picture;

    fn sums() -> Sums {
        let mut sums = Sums::new(3, 2);
        for seed in [0.1, 0.7, 1.3] {
            let pixels = (0..6).map(|k| Rgb::new(seed, seed * f64::from(k), 1.0 / (seed + f64::from(k)))).collect();
            sums.add(&Picture::from_pixels(3, 2, pixels).unwrap());
        }
        sums
    }

    #[test]
    fn what_is_written_is_read_again_bit_for_bit() {
        assert_eq!(Sums::from_bytes(&sums().to_bytes("ball"), "ball"), Ok(sums()));
    }

    #[test]
    fn a_file_of_something_else_is_refused() {
        let refused = Sums::from_bytes(&sums().to_bytes("ball"), "cube").unwrap_err();
        assert_eq!(refused, "it is of something else");
    }

    #[test]
    fn a_file_with_any_byte_changed_or_cut_off_anywhere_is_refused() {
        let bytes = sums().to_bytes("ball");
        for place in 0..bytes.len() {
            let mut changed = bytes.clone();
            changed[place] ^= 0x10;
            assert!(Sums::from_bytes(&changed, "ball").is_err(), "byte {place}");
            assert!(Sums::from_bytes(&bytes[..place], "ball").is_err(), "{place} bytes");
        }
    }
}
