//! Animated PNG: all colours, and after the first frame only what changes.

use super::{AnimationError, FRAME, Film};
use png::{BitDepth, BlendOp, ColorType, Compression, DisposeOp, Encoder, Filter, Writer};

pub fn encode(film: &Film) -> Result<Vec<u8>, AnimationError> {
    let mut bytes = Vec::new();
    let mut writer = begin(&mut bytes, film).map_err(refused)?;
    let mut before: Option<Vec<u8>> = None;
    for place in 0..film.frames.len() {
        let rgb = opaque(&film.painted(place)?.rgba);
        let part = before.as_deref().map_or(Part::WHOLE, |before| Part::that_changes(before, &rgb));
        write_part(&mut writer, &part, film.milliseconds(place), &part.cut_from(&rgb), place > 0).map_err(refused)?;
        before = Some(rgb);
    }
    writer.finish().map_err(refused)?;
    Ok(bytes)
}

fn refused<E: std::fmt::Display>(error: E) -> AnimationError {
    AnimationError::Encoder(error.to_string())
}

fn begin<'a>(bytes: &'a mut Vec<u8>, film: &Film) -> Result<Writer<&'a mut Vec<u8>>, png::EncodingError> {
    let mut encoder = Encoder::new(bytes, FRAME[0], FRAME[1]);
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_compression(Compression::Balanced);
    // Flat colours pack best as they stand.
    encoder.set_filter(Filter::NoFilter);
    encoder.set_animated(u32::try_from(film.frames.len()).unwrap_or(u32::MAX), 0)?;
    encoder.set_blend_op(BlendOp::Source)?;
    encoder.set_dispose_op(DisposeOp::None)?;
    encoder.set_frame_delay(film.milliseconds(0), 1000)?;
    encoder.write_header()
}

fn write_part(
    writer: &mut Writer<&mut Vec<u8>>,
    part: &Part,
    milliseconds: u16,
    rgb: &[u8],
    may_be_smaller: bool,
) -> Result<(), png::EncodingError> {
    if may_be_smaller {
        writer.reset_frame_position()?;
        writer.set_frame_dimension(part.width, part.height)?;
        writer.set_frame_position(part.left, part.top)?;
        writer.set_frame_delay(milliseconds, 1000)?;
    }
    writer.write_image_data(rgb)
}

fn opaque(rgba: &[u8]) -> Vec<u8> {
    rgba.as_chunks::<4>().0.iter().flat_map(|&[r, g, b, _]| [r, g, b]).collect()
}

/// A part of a frame, in pixels.
struct Part {
    left: u32,
    top: u32,
    width: u32,
    height: u32,
}

const STRIDE: usize = FRAME[0] as usize * 3;

impl Part {
    const WHOLE: Self = Self { left: 0, top: 0, width: FRAME[0], height: FRAME[1] };

    /// The smallest part that holds every pixel in which the two differ; a single pixel where there is none.
    fn that_changes(before: &[u8], after: &[u8]) -> Self {
        let rows = || before.chunks(STRIDE).zip(after.chunks(STRIDE)).enumerate().filter(|(_, (a, b))| a != b);
        let Some((first, _)) = rows().next() else { return Self { left: 0, top: 0, width: 1, height: 1 } };
        let last = rows().next_back().map_or(first, |(row, _)| row);
        let differs = |(a, b): (&u8, &u8)| a != b;
        let left = rows().filter_map(|(_, (a, b))| a.iter().zip(b).position(differs)).min().unwrap_or(0) / 3;
        let right = rows().filter_map(|(_, (a, b))| a.iter().zip(b).rposition(differs)).max().unwrap_or(0) / 3;
        let [left, top, width, height] =
            [left, first, right - left + 1, last - first + 1].map(|x| u32::try_from(x).unwrap_or(u32::MAX));
        Self { left, top, width, height }
    }

    fn cut_from(&self, rgb: &[u8]) -> Vec<u8> {
        let [left, top, width, height] = [self.left, self.top, self.width, self.height].map(|x| x as usize);
        let row = |row: &[u8]| row[3 * left..3 * (left + width)].to_vec();
        rgb.chunks(STRIDE).skip(top).take(height).flat_map(row).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_part_that_changes_is_written_again() {
        let before = vec![0; STRIDE * FRAME[1] as usize];
        let mut after = before.clone();
        for (x, y) in [(100, 20), (300, 25)] {
            after[y * STRIDE + 3 * x + 1] = 9;
        }
        let part = Part::that_changes(&before, &after);
        assert_eq!((part.left, part.top, part.width, part.height), (100, 20, 201, 6));
        let cut = part.cut_from(&after);
        assert_eq!(cut.len(), 201 * 6 * 3);
        assert_eq!((cut[1], cut[cut.len() - 2]), (9, 9));
        let none = Part::that_changes(&before, &before);
        assert_eq!((none.width, none.height), (1, 1));
    }
}
