//! Pictures from bytes: PNG and JPEG, whose bytes follow the sRGB curve, and Radiance HDR and OpenEXR, which are linear.
//!
//! What the bytes are is read from their beginning; the name serves messages only. Transparency, colour profiles and the way up that
//! a camera notes are not taken into account: texels are the file's own numbers, row by row as stored.

use crate::texture::image::{Encoding, MOST_TEXELS, Texels};
use image::{DynamicImage, ImageDecoder, ImageFormat, ImageReader, Limits};
use std::io::Cursor;

const KNOWN: &str = "PNG, JPEG, Radiance HDR and OpenEXR can be read";

/// A picture of colours.
///
/// # Errors
/// If the bytes are no picture in one of the four formats, are damaged, or hold more than 64 Mi texels or values that are no
/// numbers.
pub fn decode(bytes: &[u8], name: &str) -> Result<Texels, String> {
    read(bytes, name, Encoding::Srgb)
}

/// A picture of plain numbers, such as heights: bytes from 0 to 255 become 0 to 1 in equal steps.
///
/// # Errors
/// As [`decode`].
pub fn decode_heights(bytes: &[u8], name: &str) -> Result<Texels, String> {
    read(bytes, name, Encoding::Linear)
}

fn read(bytes: &[u8], name: &str, encoding: Encoding) -> Result<Texels, String> {
    let format = format_of(bytes).ok_or_else(|| unknown(bytes, name))?;
    let broken = |error: image::ImageError| {
        format!("`{name}` begins as {} but cannot be read: {error}; a whole file was expected", format_name(format))
    };
    let mut reader = ImageReader::with_format(Cursor::new(bytes), format);
    let mut limits = Limits::default();
    // Sixteen bytes a texel: four floats, the most that a decoder needs.
    limits.max_alloc = Some(MOST_TEXELS * 16);
    reader.limits(limits);
    let decoder = reader.into_decoder().map_err(broken)?;
    let (width, height) = decoder.dimensions();
    if u64::from(width) * u64::from(height) > MOST_TEXELS {
        return Err(format!(
            "`{name}` has {width} × {height} texels; no more than {MOST_TEXELS} were expected: make the picture smaller"
        ));
    }
    let picture = DynamicImage::from_decoder(decoder).map_err(broken)?;
    texels(picture, encoding).map_err(|problem| format!("`{name}`: {problem}"))
}

/// The four formats by their first bytes.
fn format_of(bytes: &[u8]) -> Option<ImageFormat> {
    let format = image::guess_format(bytes).ok()?;
    let is_known = matches!(format, ImageFormat::Png | ImageFormat::Jpeg | ImageFormat::Hdr | ImageFormat::OpenExr);
    is_known.then_some(format)
}

fn format_name(format: ImageFormat) -> &'static str {
    match format {
        ImageFormat::Png => "a PNG",
        ImageFormat::Jpeg => "a JPEG",
        ImageFormat::Hdr => "a Radiance HDR",
        _ => "an OpenEXR",
    }
}

fn unknown(bytes: &[u8], name: &str) -> String {
    if bytes.is_empty() {
        return format!("`{name}` is empty; a picture was expected: {KNOWN}");
    }
    let beginning: Vec<_> = bytes.iter().take(8).map(|byte| format!("{byte:02x}")).collect();
    format!("`{name}` begins with the bytes {}, as no known picture does: {KNOWN}", beginning.join(" "))
}

/// The picture in linear RGB. Greys become three equal values.
fn texels(picture: DynamicImage, encoding: Encoding) -> Result<Texels, String> {
    let (width, height) = (picture.width(), picture.height());
    match picture {
        DynamicImage::ImageRgb32F(_) | DynamicImage::ImageRgba32F(_) => {
            let data = picture.into_rgb32f().pixels().map(|pixel| pixel.0).collect();
            Texels::from_linear(width, height, data)
        }
        DynamicImage::ImageLuma16(_)
        | DynamicImage::ImageLumaA16(_)
        | DynamicImage::ImageRgb16(_)
        | DynamicImage::ImageRgba16(_) => {
            let texel = |pixel: &image::Rgb<u16>| pixel.0.map(|value| encoding.linear(f64::from(value) / 65535.0));
            Texels::from_linear(width, height, picture.into_rgb16().pixels().map(texel).collect())
        }
        _ => Texels::from_bytes(width, height, picture.into_rgb8().as_raw(), encoding),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::texture::image::Wraps;
    use glam::DVec3;
    use image::{ImageBuffer, Luma, Rgb};

    fn encode(picture: impl Into<DynamicImage>, format: ImageFormat) -> Vec<u8> {
        let mut bytes = Cursor::new(Vec::new());
        picture.into().write_to(&mut bytes, format).unwrap();
        bytes.into_inner()
    }

    fn at(texels: &Texels, column: i64, row: i64) -> DVec3 {
        texels.at([column, row], Wraps::default())
    }

    #[test]
    fn a_png_is_decoded_by_the_curve_of_srgb_and_heights_are_not() {
        let picture = ImageBuffer::from_fn(3, 2, |x, y| Rgb([[0_u8, 128, 255][x as usize], 100, [0, 255][y as usize]]));
        let bytes = encode(picture, ImageFormat::Png);
        let texels = decode(&bytes, "three.png").unwrap();
        assert_eq!(texels.size(), [3, 2]);
        assert!((at(&texels, 1, 1) - DVec3::new(0.215_860_5, 0.127_437_7, 1.0)).abs().max_element() < 1e-6);
        let heights = decode_heights(&bytes, "three.png").unwrap();
        assert!((at(&heights, 1, 1) - DVec3::new(128.0 / 255.0, 100.0 / 255.0, 1.0)).abs().max_element() < 1e-7);
    }

    #[test]
    fn sixteen_bits_and_greys_are_read_too() {
        let picture: ImageBuffer<Luma<u16>, Vec<u16>> =
            ImageBuffer::from_fn(2, 1, |x, _| Luma([[257 * 128, 1][x as usize]]));
        let bytes = encode(picture, ImageFormat::Png);
        let texels = decode(&bytes, "grey.png").unwrap();
        assert!((at(&texels, 0, 0) - 0.215_860_5).abs().max_element() < 1e-6);
        assert!((at(&texels, 1, 0) - 1.0 / 65535.0 / 12.92).abs().max_element() < 1e-12);
    }

    #[test]
    fn linear_formats_keep_their_numbers() {
        let picture = ImageBuffer::from_fn(2, 2, |x, y| Rgb([x as f32 * 4.0, 0.25, y as f32 * 16.0]));
        for format in [ImageFormat::Hdr, ImageFormat::OpenExr] {
            let texels = decode(&encode(picture.clone(), format), "sky").unwrap();
            // Radiance keeps 8 bits and a common exponent: 1/256 of the largest of the three.
            assert!((at(&texels, 1, 1) - DVec3::new(4.0, 0.25, 16.0)).abs().max_element() < 0.07, "{format:?}");
            assert!((at(&texels, 0, 0) - DVec3::new(0.0, 0.25, 0.0)).abs().max_element() < 0.002, "{format:?}");
        }
    }

    #[test]
    fn a_jpeg_is_near_to_what_was_stored() {
        let picture = ImageBuffer::from_pixel(16, 16, Rgb([200_u8, 100, 50]));
        let texels = decode(&encode(picture, ImageFormat::Jpeg), "leaf.jpg").unwrap();
        let stored = [200.0, 100.0, 50.0].map(|byte| f64::from(Encoding::Srgb.linear(byte / 255.0)));
        assert!((at(&texels, 7, 7) - DVec3::from(stored)).abs().max_element() < 0.02);
    }

    #[test]
    fn what_cannot_be_read_is_named() {
        let error = |bytes: &[u8]| decode(bytes, "sky.bin").unwrap_err();
        assert_eq!(error(b""), format!("`sky.bin` is empty; a picture was expected: {KNOWN}"));
        assert!(error(b"{\"a\": 1}").contains("`sky.bin` begins with the bytes 7b 22 61 22 3a 20 31 7d"));
        assert!(error(b"GIF89a......").contains(KNOWN));
        let whole = encode(ImageBuffer::from_pixel(64, 64, Rgb([1_u8, 2, 3])), ImageFormat::Png);
        let cut = error(&whole[..whole.len() / 2]);
        assert!(cut.contains("`sky.bin` begins as a PNG but cannot be read"), "{cut}");
        // The header of a Radiance file may say any size.
        let huge = error(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 100000 +X 100000\n");
        assert!(huge.contains("100000 × 100000") && huge.contains("67108864"), "{huge}");
        let not_finite = encode(ImageBuffer::from_pixel(2, 2, Rgb([f32::NAN, 0.0, 0.0])), ImageFormat::OpenExr);
        assert!(error(&not_finite).contains("texel (0, 0) is (NaN, 0, 0)"), "{}", error(&not_finite));
    }
}
