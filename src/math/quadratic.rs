//! Quadratic equations A x² + 2 B x + C = 0.

use super::Real;

/// A x² + 2 B x + C, with B half the linear coefficient.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quadratic<A> {
    /// A.
    pub a: A,
    /// B.
    pub b: A,
    /// C.
    pub c: A,
    /// B² − A C.
    pub discriminant: A,
}

impl<A: Real> Quadratic<A> {
    /// With B² − A C to 2 ulp.
    pub fn new(a: A, b: A, c: A) -> Self {
        Self { a, b, c, discriminant: A::difference_of_products(b, b, a, c) }
    }

    /// With a discriminant that is known better than the coefficients tell.
    pub fn with_discriminant(a: A, b: A, c: A, discriminant: A) -> Self {
        Self { a, b, c, discriminant }
    }

    /// Both roots, ascending, equal where the discriminant is 0; none where it is negative.
    ///
    /// q = −(B + sign(B) √disc) adds numbers of one sign; the roots are q / A and C / q (Numerical Recipes § 5.6). Where
    /// A is 0 one of them is infinite, and where B is 0 too there is none.
    pub fn roots(&self) -> Option<[A; 2]> {
        let real = self.discriminant >= A::ZERO;
        if !real {
            return None;
        }
        let root = self.discriminant.sqrt();
        let q = if self.b < A::ZERO { root - self.b } else { -(self.b + root) };
        if q == A::ZERO {
            // B = 0 and A C = 0: x² = 0, or nothing to solve.
            return (self.a != A::ZERO).then_some([A::ZERO, A::ZERO]);
        }
        let (first, second) = if root == A::ZERO && self.a != A::ZERO {
            (-self.b / self.a, -self.b / self.a)
        } else {
            (q / self.a, self.c / q)
        };
        Some(if second < first { [second, first] } else { [first, second] })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn simple_roots_come_in_order() {
        // (x − 3)(x + 2) = x² − x − 6.
        assert_eq!(Quadratic::new(1.0, -0.5, -6.0).roots(), Some([-2.0, 3.0]));
        assert_eq!(Quadratic::new(-1.0, 0.5, 6.0).roots(), Some([-2.0, 3.0]));
    }

    #[test]
    fn the_small_root_keeps_its_digits() {
        // x² − 2·10⁸ x + 1: the small root is 5·10⁻⁹ (1 + 2.5·10⁻¹⁷ + …).
        assert_eq!(Quadratic::new(1.0, -1e8, 1.0).roots(), Some([5e-9, 2e8]));
    }

    #[test]
    fn a_double_root_is_b_over_a() {
        assert_eq!(Quadratic::new(4.0, -2.0, 1.0).roots(), Some([0.5, 0.5]));
    }

    #[test]
    fn no_root_where_the_discriminant_is_negative() {
        assert_eq!(Quadratic::new(1.0, 0.0, 1.0).roots(), None);
    }

    #[test]
    fn without_a_square_one_root_is_infinite() {
        // 2·1·x − 4 = 0.
        let roots = Quadratic::new(0.0_f64, 1.0, -4.0).roots().unwrap();
        assert!(roots.contains(&2.0) && roots.iter().any(|x| x.is_infinite()));
        assert_eq!(Quadratic::new(0.0, 0.0, 1.0).roots(), None);
    }
}
