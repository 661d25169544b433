//! Compresses what gets smaller by it.

use crate::names::Named;
use flate2::Compression;
use flate2::write::GzEncoder;
use std::io::Write as _;

/// A file with its compressed variants.
pub struct Packed {
    /// The file.
    pub named: Named,
    /// As gzip, if that is smaller.
    pub gzip: Option<Vec<u8>>,
    /// As Brotli, if that is smaller.
    pub brotli: Option<Vec<u8>>,
}

/// Smaller files travel in one packet either way, and a variant of each would only be clutter.
const LEAST: usize = 512;

/// Compresses all files, or none.
pub fn pack(named: Vec<Named>, is_compressed: bool) -> Vec<Packed> {
    named.into_iter().map(|named| if is_compressed { packed(named) } else { plain(named) }).collect()
}

const fn plain(named: Named) -> Packed {
    Packed { named, gzip: None, brotli: None }
}

fn packed(named: Named) -> Packed {
    let bytes = &named.file.bytes;
    // Pictures are compressed already: a per cent off them is not worth a variant.
    let is_worth_it = |variant: &Vec<u8>| bytes.len() >= LEAST && variant.len() < bytes.len() / 20 * 19;
    let gzip = gzip(bytes).filter(is_worth_it);
    let brotli = if gzip.is_some() { brotli(bytes).filter(is_worth_it) } else { None };
    Packed { named, gzip, brotli }
}

/// Nothing if it fails, which writing to memory does not.
fn gzip(bytes: &[u8]) -> Option<Vec<u8>> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(bytes).ok()?;
    encoder.finish().ok()
}

/// With the largest window that every browser takes.
fn brotli(bytes: &[u8]) -> Option<Vec<u8>> {
    let mut variant = Vec::new();
    let settings =
        brotli::enc::BrotliEncoderParams { quality: 11, lgwin: 24, size_hint: bytes.len(), ..Default::default() };
    brotli::BrotliCompress(&mut &bytes[..], &mut variant, &settings).ok()?;
    Some(variant)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sources::File;
    use std::io::Read as _;

    fn of(bytes: Vec<u8>) -> Packed {
        let file = File::new("files/a.js".to_owned(), bytes);
        packed(Named { source: file.path.clone(), file, refers_to: Vec::new() })
    }

    #[test]
    fn both_variants_unpack_to_the_file() {
        let text = "the story of a ray, ".repeat(100).into_bytes();
        let packed = of(text.clone());
        let mut unpacked = Vec::new();
        let gzip = packed.gzip.expect("a repeated text gets smaller");
        flate2::read::GzDecoder::new(&gzip[..]).read_to_end(&mut unpacked).expect("it was just packed");
        assert_eq!(unpacked, text);
        unpacked.clear();
        let brotli = packed.brotli.expect("a repeated text gets smaller");
        brotli::BrotliDecompress(&mut &brotli[..], &mut unpacked).expect("it was just packed");
        assert_eq!(unpacked, text);
    }

    #[test]
    fn what_does_not_get_smaller_has_no_variants() {
        // The digits of a linear congruential generator: nothing that a compressor finds.
        let mut state = 1_u32;
        let noise = std::iter::repeat_with(|| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            state.to_be_bytes()[0]
        });
        let packed = of(noise.take(4000).collect());
        assert!(packed.gzip.is_none() && packed.brotli.is_none());
        assert!(of(b"short".to_vec()).gzip.is_none());
    }
}
