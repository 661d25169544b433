//! Frames of an animation on the command line, and the files that they go to.

use std::path::{Path, PathBuf};

/// Frames that were asked for, in the order in which they are rendered.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Frames(Vec<u32>);

/// So many frames fill a folder, or a file that nothing plays any more.
const MOST_FRAMES: usize = 100_000;

impl Frames {
    /// Reads `1..900`, `1..900:225` (every 225th) or `1,225,450,900`; both ends belong to it.
    pub fn parse(text: &str) -> Result<Self, String> {
        let expected =
            || format!("`{text}` names no frames; expected 1..900, 1..900:225 for every 225th, or 1,225,450,900");
        let number = |part: &str| part.trim().parse::<u32>().map_err(|_| expected());
        let frames = match text.split_once("..") {
            Some((first, rest)) => {
                let (last, step) = rest.split_once(':').unwrap_or((rest, "1"));
                let (first, last, step) = (number(first)?, number(last)?, number(step)?);
                if first > last || step == 0 {
                    return Err(expected());
                }
                if (last - first) as usize / step as usize >= MOST_FRAMES {
                    return Err(format!("`{text}` are too many frames: at most {MOST_FRAMES} are rendered at a time"));
                }
                (first..=last).step_by(step as usize).collect()
            }
            None => text.split(',').map(number).collect::<Result<Vec<_>, _>>()?,
        };
        Ok(Self(frames))
    }

    /// The frames.
    pub fn numbers(&self) -> &[u32] {
        &self.0
    }

    /// The file of one frame: its number stands before the ending, with as many digits as the largest one needs and four
    /// at least, so that a folder lists them in order.
    pub fn file_of(&self, frame: u32, output: &Path) -> PathBuf {
        let digits = self.0.iter().max().map_or(1, |largest| largest.to_string().len()).max(4);
        let stem = output.file_stem().unwrap_or_default().to_string_lossy();
        let name = match output.extension() {
            Some(ending) => format!("{stem}_{frame:0digits$}.{}", ending.to_string_lossy()),
            None => format!("{stem}_{frame:0digits$}"),
        };
        output.with_file_name(name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn frames(text: &str) -> Result<Vec<u32>, String> {
        Frames::parse(text).map(|frames| frames.0)
    }

    #[test]
    fn frames_are_a_range_a_range_with_steps_or_a_list() {
        assert_eq!(frames("1..4"), Ok(vec![1, 2, 3, 4]));
        assert_eq!(frames("0..900:450"), Ok(vec![0, 450, 900]));
        assert_eq!(frames("1, 225,450,900"), Ok(vec![1, 225, 450, 900]));
        assert_eq!(frames("7"), Ok(vec![7]));
        for wrong in ["", "4..1", "1..", "1..9:0", "a", "1..4,7", "-1..3", "0..4000000000"] {
            assert!(frames(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn the_number_of_a_frame_stands_before_the_ending() {
        let frames = Frames::parse("1,225,12000").unwrap();
        assert_eq!(frames.file_of(225, Path::new("out/marble.png")), Path::new("out/marble_00225.png"));
        assert_eq!(Frames::parse("1").unwrap().file_of(1, Path::new("marble")), Path::new("marble_0001"));
    }
}
