//! What lies beyond the edges of an image.

/// How an image goes on along one axis.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Wrap {
    /// It begins again.
    #[default]
    Repeat,
    /// It comes back mirrored.
    Mirror,
    /// Its last texels go on for ever.
    Clamp,
}

/// How an image goes on along its columns and along its rows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Wraps {
    /// Left and right.
    pub columns: Wrap,
    /// Above and below.
    pub rows: Wrap,
}

impl Wrap {
    /// The texel, of `count` along this axis, that stands at `index`.
    #[must_use]
    pub fn index(self, index: i64, count: u32) -> usize {
        let count = i64::from(count);
        let inside = match self {
            Self::Repeat => index.rem_euclid(count),
            Self::Mirror => {
                let place = index.rem_euclid(2 * count);
                place.min(2 * count - 1 - place)
            }
            Self::Clamp => index.clamp(0, count - 1),
        };
        usize::try_from(inside).unwrap_or(0)
    }
}

/// The texel that a coordinate lies in. Coordinates without bounds, and such as are no numbers, stay where sums of texel
/// numbers cannot overflow.
#[must_use]
pub(super) fn cell(coordinate: f64) -> i64 {
    #[expect(clippy::cast_possible_truncation, reason = "within 10¹⁵; NaN becomes 0")]
    let cell = coordinate.floor().clamp(-1e15, 1e15) as i64;
    cell
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_image_repeats_comes_back_mirrored_or_ends() {
        let row = |wrap: Wrap| (-4..7).map(|i| wrap.index(i, 3)).collect::<Vec<_>>();
        assert_eq!(row(Wrap::Repeat), [2, 0, 1, 2, 0, 1, 2, 0, 1, 2, 0]);
        assert_eq!(row(Wrap::Mirror), [2, 2, 1, 0, 0, 1, 2, 2, 1, 0, 0]);
        assert_eq!(row(Wrap::Clamp), [0, 0, 0, 0, 0, 1, 2, 2, 2, 2, 2]);
    }

    #[test]
    fn coordinates_that_are_no_places_have_a_cell_all_the_same() {
        for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300] {
            assert!(Wrap::Repeat.index(cell(x) + 1, 7) < 7);
        }
    }
}
