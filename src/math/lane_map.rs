//! Affine maps in columns of four lanes, the last of them empty: a processor with vector registers works on all of a column
//! at once.

use wide::f64x4;

/// p ↦ M p + T, as the columns of M and T.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LaneMap {
    columns: [f64x4; 4],
}

/// Three coordinates, and a lane of zeros.
pub type Lanes = f64x4;

impl LaneMap {
    /// The map with these three rows of four.
    #[must_use]
    pub fn from_rows([x, y, z]: [[f64; 4]; 3]) -> Self {
        Self { columns: std::array::from_fn(|column| f64x4::from([x[column], y[column], z[column], 0.0])) }
    }

    /// M p + T.
    #[must_use]
    #[inline]
    pub fn point(&self, p: [f64; 3]) -> Lanes {
        self.vector(p) + self.columns[3]
    }

    /// |M| p + |T|, for `p` without signs: the sizes of what is added up to M p + T.
    #[must_use]
    #[inline]
    pub fn point_size(&self, p: [f64; 3]) -> Lanes {
        self.vector_size(p) + self.columns[3].abs()
    }

    /// |M| v, likewise.
    #[must_use]
    #[inline]
    pub fn vector_size(&self, [x, y, z]: [f64; 3]) -> Lanes {
        let [a, b, c, _] = self.columns;
        a.abs() * f64x4::splat(x) + b.abs() * f64x4::splat(y) + c.abs() * f64x4::splat(z)
    }

    /// Mᵀ v.
    #[must_use]
    #[inline]
    pub fn transposed_vector(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|k| {
            let [a, b, c] = coordinates(self.columns[k]);
            a * x + b * y + c * z
        })
    }

    /// M v.
    #[must_use]
    #[inline]
    pub fn vector(&self, [x, y, z]: [f64; 3]) -> Lanes {
        let [a, b, c, _] = self.columns;
        a * f64x4::splat(x) + b * f64x4::splat(y) + c * f64x4::splat(z)
    }
}

/// The three coordinates.
#[must_use]
#[inline]
pub fn coordinates(lanes: Lanes) -> [f64; 3] {
    let [x, y, z, _] = lanes.to_array();
    [x, y, z]
}

#[cfg(test)]
mod tests {
    use super::*;

    const MAP: [[f64; 4]; 3] = [[1.0, -2.0, 0.5, 3.0], [0.0, 4.0, 1.0, -1.0], [2.0, 0.0, -8.0, 0.25]];

    #[test]
    fn rows_are_rows() {
        let map = LaneMap::from_rows(MAP);
        assert_eq!(map.point([1.0, 2.0, -4.0]).to_array(), [-2.0, 3.0, 34.25, 0.0]);
        assert_eq!(map.vector([1.0, 2.0, -4.0]).to_array(), [-5.0, 4.0, 34.0, 0.0]);
    }

    #[test]
    fn sizes_have_no_signs() {
        assert_eq!(LaneMap::from_rows(MAP).point_size([1.0, 1.0, 1.0]).to_array(), [6.5, 6.0, 10.25, 0.0]);
        assert_eq!(LaneMap::from_rows(MAP).vector_size([1.0, 1.0, 1.0]).to_array(), [3.5, 5.0, 10.0, 0.0]);
    }

    #[test]
    fn rows_of_the_transpose_are_columns() {
        assert_eq!(LaneMap::from_rows(MAP).transposed_vector([1.0, 2.0, 4.0]), [9.0, 6.0, -29.5]);
    }
}
