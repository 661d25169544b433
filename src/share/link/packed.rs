//! Longer texts within links: deflated (RFC 1951), then written with the 64 signs that addresses leave alone (RFC 4648, § 5).

use super::MOST_TEXT;
use miniz_oxide::deflate::compress_to_vec;
use miniz_oxide::inflate::{TINFLStatus, decompress_to_vec_with_limit};

const SIGNS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";

/// The slowest compression: links are short.
const COMPRESSION: u8 = 10;

/// A text as signs.
pub fn pack(text: &str) -> String {
    let bytes = compress_to_vec(text.as_bytes(), COMPRESSION);
    let mut out = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for three in bytes.chunks(3) {
        let bits = three.iter().fold(0_u32, |bits, &byte| bits << 8 | u32::from(byte)) << (8 * (3 - three.len()));
        let signs = [18, 12, 6, 0].map(|shift| char::from(SIGNS[(bits >> shift & 63) as usize]));
        out.extend(&signs[..=three.len()]);
    }
    out
}

/// The text that was packed.
///
/// # Errors
/// If the signs are not those that [`pack`] writes, or stand for too long a text.
pub fn unpack(signs: &str) -> Result<String, String> {
    let bytes = bytes_of(signs)?;
    let text = decompress_to_vec_with_limit(&bytes, MOST_TEXT).map_err(|error| match error.status {
        TINFLStatus::HasMoreOutput => format!("the packed text is longer than {MOST_TEXT} bytes, which no link's is"),
        _ => "the packed text is damaged; perhaps the link was cut off on its way".to_owned(),
    })?;
    String::from_utf8(text).map_err(|_| "the packed text is not UTF-8".to_owned())
}

fn bytes_of(signs: &str) -> Result<Vec<u8>, String> {
    let mut bytes = Vec::with_capacity(signs.len() / 4 * 3 + 3);
    let (mut bits, mut count) = (0_u32, 0);
    for sign in signs.chars() {
        let value = u8::try_from(sign).ok().and_then(|sign| SIGNS.iter().position(|&known| known == sign));
        let value = value.ok_or_else(|| format!("`{sign}` is none of the 64 signs of packed texts"))?;
        bits = bits << 6 | u32::try_from(value).unwrap_or(0);
        count += 6;
        if count >= 8 {
            count -= 8;
            bytes.push((bits >> count & 255) as u8);
        }
    }
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_signs_are_those_of_the_standard() {
        // RFC 4648, § 10, without the padding.
        for (signs, text) in [("Zg", "f"), ("Zm8", "fo"), ("Zm9v", "foo"), ("Zm9vYmFy", "foobar"), ("-_-_", "\u{fb}ÿ¿")]
        {
            let expected: Vec<u8> = text.chars().map(|c| u8::try_from(u32::from(c)).unwrap()).collect();
            assert_eq!(bytes_of(signs).unwrap(), expected);
        }
    }

    #[test]
    fn a_scene_shrinks_and_comes_back() {
        let text = crate::scene::embedded_scene("csg/bowl").unwrap().text;
        let packed = pack(text);
        assert!(packed.len() < text.len() * 2 / 3, "{} of {}", packed.len(), text.len());
        assert_eq!(unpack(&packed).as_deref(), Ok(text));
    }

    #[test]
    fn a_short_link_cannot_fill_the_memory() {
        let bomb = pack(&" ".repeat(50 * MOST_TEXT));
        assert!(bomb.len() < 100_000);
        assert!(unpack(&bomb).unwrap_err().contains("longer than"));
    }

    #[test]
    fn a_link_that_was_cut_off_is_told_from_a_whole_one() {
        let packed = pack("the text of a scene");
        assert!(unpack(&packed[..packed.len() - 6]).unwrap_err().contains("cut off"));
        assert!(unpack("a*b").unwrap_err().contains("64 signs"));
    }
}
