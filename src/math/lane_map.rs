//! Affine maps in columns of four lanes, the last of them empty: a processor with vector registers works on all of a column
//! at once.

/// p ↦ M p + T, as the columns of M and T.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LaneMap {
    columns: [Lanes; 4],
}

/// Three coordinates, and a lane of zeros.
pub type Lanes = [f64; 4];

impl LaneMap {
    /// The map with these three rows of four.
    #[must_use]
    pub fn from_rows([x, y, z]: [[f64; 4]; 3]) -> Self {
        Self { columns: std::array::from_fn(|column| [x[column], y[column], z[column], 0.0]) }
    }

    /// The map with the sizes of this one's numbers, times `factor`.
    #[must_use]
    pub fn sizes(&self, factor: f64) -> Self {
        Self { columns: self.columns.map(|column| column.map(|x| x.abs() * factor)) }
    }

    /// M p + T.
    #[must_use]
    #[inline]
    pub fn point(&self, p: [f64; 3]) -> Lanes {
        let v = self.vector(p);
        std::array::from_fn(|lane| v[lane] + self.columns[3][lane])
    }

    /// M v.
    #[must_use]
    #[inline]
    pub fn vector(&self, [x, y, z]: [f64; 3]) -> Lanes {
        let [a, b, c, _] = &self.columns;
        std::array::from_fn(|lane| a[lane] * x + b[lane] * y + c[lane] * z)
    }
}

/// The three coordinates.
#[must_use]
#[inline]
pub const fn coordinates([x, y, z, _]: Lanes) -> [f64; 3] {
    [x, y, z]
}

#[cfg(test)]
mod tests {
    use super::*;

    const MAP: [[f64; 4]; 3] = [[1.0, -2.0, 0.5, 3.0], [0.0, 4.0, 1.0, -1.0], [2.0, 0.0, -8.0, 0.25]];

    #[test]
    fn rows_are_rows() {
        let map = LaneMap::from_rows(MAP);
        assert_eq!(map.point([1.0, 2.0, -4.0]), [-2.0, 3.0, 34.25, 0.0]);
        assert_eq!(map.vector([1.0, 2.0, -4.0]), [-5.0, 4.0, 34.0, 0.0]);
    }

    #[test]
    fn sizes_have_no_signs() {
        assert_eq!(LaneMap::from_rows(MAP).sizes(2.0).point([1.0, 1.0, 1.0]), [13.0, 12.0, 20.5, 0.0]);
    }
}
