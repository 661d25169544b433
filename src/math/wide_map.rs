//! Affine maps with 32 digits, for the one step that stands before every solver: the inverse transform of the ray.

use super::{DoubleDouble, Precise, Real, dot};

/// Three rows of four: p ↦ M p + T.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WideMap {
    rows: [[DoubleDouble; 4]; 3],
    /// The map that it is the inverse of.
    inverse_of: [[f64; 4]; 3],
}

impl WideMap {
    /// The map that changes nothing.
    pub const IDENTITY: Self = {
        const O: DoubleDouble = DoubleDouble::ZERO;
        const I: DoubleDouble = DoubleDouble::ONE;
        let inverse_of = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]];
        Self { rows: [[I, O, O, O], [O, I, O, O], [O, O, I, O]], inverse_of }
    };

    /// The inverse of the map with these rows; its numbers are not finite where there is none.
    #[must_use]
    pub fn inverse_of(rows: [[f64; 4]; 3]) -> Self {
        Self { rows: inverse(rows), inverse_of: rows }
    }

    /// M p + T and M v, with the inverse worked out once more in exact arithmetic.
    #[must_use]
    pub fn exact_line(&self, p: [f64; 3], v: [f64; 3]) -> [[Precise; 3]; 2] {
        let rows = inverse::<Precise>(self.inverse_of);
        let [p, v] = [p, v].map(|v| v.map(Precise::from_f64));
        [rows.map(|[a, b, c, t]| dot([a, b, c], p) + t), rows.map(|[a, b, c, _]| dot([a, b, c], v))]
    }

    /// M p + T.
    #[must_use]
    pub fn point(&self, p: [f64; 3]) -> [DoubleDouble; 3] {
        let v = self.vector(p);
        std::array::from_fn(|i| v[i] + self.rows[i][3])
    }

    /// M v.
    #[must_use]
    pub fn vector(&self, v: [f64; 3]) -> [DoubleDouble; 3] {
        let v = v.map(DoubleDouble::from_f64);
        self.rows.map(|[a, b, c, _]| dot([a, b, c], v))
    }

    /// The rows, rounded.
    #[must_use]
    pub fn to_f64(&self) -> [[f64; 4]; 3] {
        self.rows.map(|row| row.map(Real::to_f64))
    }
}

/// The rows of the inverse, by the adjugate.
///
/// The given rows are first brought to the same size by a power of two, so that determinants neither overflow nor vanish.
fn inverse<A: Real>(rows: [[f64; 4]; 3]) -> [[A; 4]; 3] {
    let largest = rows.iter().flat_map(|row| &row[..3]).fold(0.0_f64, |most, x| most.max(x.abs()));
    let scale = super::scale_to_unit([largest, 0.0, 0.0]);
    let m = rows.map(|row| std::array::from_fn::<_, 3, _>(|k| A::from_f64(row[k] * scale)));
    let translation = rows.map(|row| A::from_f64(row[3]));
    let minor = |i: usize, j: usize| {
        let ([r, s], [p, q]) = (others(i), others(j));
        A::difference_of_products(m[r][p], m[s][q], m[r][q], m[s][p])
    };
    let cofactor = |i: usize, j: usize| if (i + j).is_multiple_of(2) { minor(i, j) } else { -minor(i, j) };
    let determinant = dot(m[0], std::array::from_fn(|j| cofactor(0, j)));
    let scale = A::from_f64(scale);
    let inverse: [[A; 3]; 3] = std::array::from_fn(|i| std::array::from_fn(|j| cofactor(j, i) / determinant * scale));
    inverse.map(|row| {
        let [a, b, c] = row;
        [a, b, c, -dot(row, translation)]
    })
}

/// The two indices that are not `i`, ascending.
const fn others(i: usize) -> [usize; 2] {
    match i {
        0 => [1, 2],
        1 => [0, 2],
        _ => [0, 1],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_inverse_takes_images_back_with_32_digits() {
        let rows = [[3.0, 1.0, 0.0, 5.0], [0.1, -2.0, 0.7, -1e6], [0.0, 0.3, 1e-3, 0.25]];
        let inverse = WideMap::inverse_of(rows);
        let there = |p: [DoubleDouble; 3]| {
            rows.map(|[a, b, c, t]| dot([a, b, c].map(DoubleDouble::from_f64), p) + DoubleDouble::from_f64(t))
        };
        let point = [1.5, -2.25, 1e5];
        for (back, x) in there(inverse.point(point)).into_iter().zip(point) {
            assert!((back - DoubleDouble::from_f64(x)).to_f64().abs() < 1e-20, "{back:?} for {x}");
        }
    }

    #[test]
    fn sizes_at_the_ends_of_the_range_are_inverted_exactly() {
        for size in [1e-200, 1e200] {
            let rows = [[size, 0.0, 0.0, 0.0], [0.0, size, 0.0, 0.0], [0.0, 0.0, size, 0.0]];
            assert_eq!(WideMap::inverse_of(rows).to_f64()[1][1], 1.0 / size);
        }
    }

    #[test]
    fn a_singular_map_has_no_finite_inverse() {
        let rows = [[1.0, 2.0, 0.0, 0.0], [2.0, 4.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]];
        assert!(!WideMap::inverse_of(rows).to_f64()[0][0].is_finite());
    }
}
