//! The texture map M_T, from the image's space (s, t) to the surface's (u, v), and its inverse.

use glam::{DMat2, DVec2};

/// An affine map of the plane: (a x + b y + c, d x + e y + f), its rows being [a, b, c] and [d, e, f].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Affine {
    rows: [[f64; 3]; 2],
}

impl Affine {
    /// The map that leaves everything where it is.
    pub const IDENTITY: Self = Self { rows: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]] };

    /// The map with these rows.
    #[must_use]
    pub fn new(rows: [[f64; 3]; 2]) -> Self {
        Self { rows }
    }

    /// Its rows.
    #[must_use]
    pub fn rows(&self) -> [[f64; 3]; 2] {
        self.rows
    }

    /// Where a point goes.
    #[must_use]
    pub fn apply(&self, point: DVec2) -> DVec2 {
        let along = |[a, b, c]: [f64; 3]| a * point.x + b * point.y + c;
        DVec2::new(along(self.rows[0]), along(self.rows[1]))
    }

    /// The map without its shift, by columns.
    #[must_use]
    pub fn linear(&self) -> DMat2 {
        let [[a, b, _], [d, e, _]] = self.rows;
        DMat2::from_cols(DVec2::new(a, d), DVec2::new(b, e))
    }

    /// The map back; none if the map brings the plane onto a line or a point.
    #[must_use]
    pub fn inverse(&self) -> Option<Self> {
        let [[a, b, c], [d, e, f]] = self.rows;
        let determinant = a * e - b * d;
        let [x, y] = [[e, -b], [-d, a]].map(|row| row.map(|value| value / determinant));
        let rows = [[x[0], x[1], -(x[0] * c + x[1] * f)], [y[0], y[1], -(y[0] * c + y[1] * f)]];
        let is_finite = rows.as_flattened().iter().all(|value| value.is_finite());
        (determinant != 0.0 && is_finite).then_some(Self { rows })
    }
}

/// M_T and its inverse, for a whole surface or with parts that have their own.
#[derive(Clone, Debug, PartialEq)]
pub struct Mapping {
    everywhere: [Affine; 2],
    parts: Vec<(u16, [Affine; 2])>,
}

impl Default for Mapping {
    /// The image fills (u, v) from 0 to 1.
    fn default() -> Self {
        Self { everywhere: [Affine::IDENTITY; 2], parts: Vec::new() }
    }
}

impl Mapping {
    /// The mapping with this M_T, (s, t) to (u, v).
    ///
    /// # Errors
    /// If M_T has no inverse.
    pub fn new(uv_from_st: Affine) -> Result<Self, String> {
        Ok(Self { everywhere: with_inverse(uv_from_st)?, parts: Vec::new() })
    }

    /// The same with another M_T for one part of the surface.
    ///
    /// # Errors
    /// If M_T has no inverse.
    pub fn with_part(mut self, part: u16, uv_from_st: Affine) -> Result<Self, String> {
        let pair = with_inverse(uv_from_st)?;
        self.parts.retain(|(known, _)| *known != part);
        self.parts.push((part, pair));
        Ok(self)
    }

    fn of(&self, part: u16) -> &[Affine; 2] {
        self.parts.iter().find(|(known, _)| *known == part).map_or(&self.everywhere, |(_, pair)| pair)
    }

    /// M_T of a part.
    #[must_use]
    pub fn uv_from_st(&self, part: u16) -> &Affine {
        &self.of(part)[0]
    }

    /// M_T⁻¹ of a part.
    #[must_use]
    pub fn st_from_uv(&self, part: u16) -> &Affine {
        &self.of(part)[1]
    }
}

fn with_inverse(map: Affine) -> Result<[Affine; 2], String> {
    let [[a, b, c], [d, e, f]] = map.rows;
    let problem = || {
        format!(
            "u = {a} s + {b} t + {c}, v = {d} s + {e} t + {f} cannot be undone, as it brings the whole image onto a line or \
             a point; a map with finite numbers and {a} · {e} − {b} · {d} ≠ 0 was expected"
        )
    };
    Ok([map, map.inverse().ok_or_else(problem)?])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_map_and_its_inverse_undo_each_other() {
        let map = Affine::new([[2.0, 0.5, -0.25], [-1.0, 3.0, 0.125]]);
        let back = map.inverse().unwrap();
        for point in [DVec2::ZERO, DVec2::new(0.3, 0.9), DVec2::new(-7.0, 4.0)] {
            assert!((back.apply(map.apply(point)) - point).length() < 1e-14);
            assert!((map.apply(back.apply(point)) - point).length() < 1e-14);
        }
    }

    #[test]
    fn a_map_onto_a_line_is_refused() {
        let error = Mapping::new(Affine::new([[1.0, 2.0, 0.0], [2.0, 4.0, 1.0]])).unwrap_err();
        assert!(error.contains("u = 1 s + 2 t + 0, v = 2 s + 4 t + 1"), "{error}");
        assert!(Mapping::new(Affine::new([[1.0, 0.0, f64::NAN], [0.0, 1.0, 0.0]])).is_err());
    }

    #[test]
    fn a_part_may_have_a_map_of_its_own() {
        let twice = Affine::new([[2.0, 0.0, 0.0], [0.0, 2.0, 0.0]]);
        let mapping = Mapping::default().with_part(3, twice).unwrap();
        let corner = DVec2::ONE;
        assert_eq!(mapping.st_from_uv(3).apply(corner), DVec2::splat(0.5));
        assert_eq!(mapping.st_from_uv(2).apply(corner), corner);
        assert_eq!(*mapping.uv_from_st(3), twice);
    }
}
