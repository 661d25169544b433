//! A pixel's ray in the generic coordinates of a primitive, from the very numbers that the program is given.

use super::number::{Number, dot};
use glam::{DAffine3, DVec3};

/// Half a unit in the last place, in proportion to the number.
const HALF_ULP: f64 = f64::EPSILON / 2.0;

/// A ray origin + direction t in world space; the numbers are exact.
#[derive(Clone, Copy, Debug)]
pub struct PixelRay {
    /// The eye.
    pub origin: DVec3,
    /// The direction through the pixel's centre.
    pub direction: DVec3,
}

/// The ray in generic coordinates: l + c δ with t = foot + δ · `per_delta`.
pub struct Line<N> {
    /// The point nearest to the origin of generic coordinates.
    pub l: [N; 3],
    /// The direction; its largest component is about 1.
    pub c: [N; 3],
    /// t at l.
    pub foot: N,
    /// A power of two.
    pub per_delta: f64,
    /// How far half-ulp changes of the ray's and the placement's numbers can move a point of the ray beside the solid.
    pub doubt: f64,
}

impl<N: Number> Line<N> {
    /// Carries the ray into the generic coordinates of what stands at `placement` (generic to world).
    pub fn new(ray: PixelRay, placement: &DAffine3) -> Self {
        let columns = [placement.x_axis, placement.y_axis, placement.z_axis].map(vector::<N>);
        let relative = sum(&vector(ray.origin), &vector(-placement.translation));
        let (rows, determinant) = cofactors(&columns);
        let inverse = |v: &[N; 3]| rows.each_ref().map(|row| dot(row, v) / determinant.clone());
        let (s, c) = (inverse(&relative), inverse(&vector(ray.direction)));
        let largest = c.iter().map(|x| x.nearest().abs()).fold(0.0, f64::max);
        let per_delta = 1.0 / largest.log2().floor().exp2();
        let c = c.map(|x| x * N::of(per_delta));
        let foot = -dot(&s, &c) / dot(&c, &c);
        let l = std::array::from_fn(|i| s[i].clone() + c[i].clone() * foot.clone());
        let doubt = doubt(ray, placement);
        Self { l, c, foot: foot * N::of(per_delta), per_delta, doubt }
    }

    /// l + c δ.
    pub fn at(&self, delta: &N) -> [N; 3] {
        std::array::from_fn(|i| self.l[i].clone() + self.c[i].clone() * delta.clone())
    }

    /// δ at the hit time t.
    pub fn delta(&self, t: f64) -> N {
        (N::of(t) - self.foot.clone()) / N::of(self.per_delta)
    }

    /// How far off δ may be where the surface has this gradient: what half-ulp changes of the inputs do, eight times
    /// over, and eight roundings of t itself.
    pub fn tolerance(&self, gradient: DVec3, t: f64) -> f64 {
        let largest = gradient.abs().max_element();
        let sharp = gradient.to_array().map(|x| if x.is_infinite() { x.signum() } else { 0.0 });
        let normal = if largest.is_infinite() { DVec3::from_array(sharp) } else { gradient / largest };
        let slope = (0..3).map(|i| normal[i] * self.c[i].nearest()).sum::<f64>().abs();
        8.0 * (self.doubt * normal.abs().element_sum() / slope + HALF_ULP * (t / self.per_delta).abs())
    }
}

/// An exact vector.
fn vector<N: Number>(v: DVec3) -> [N; 3] {
    v.to_array().map(N::of)
}

fn sum<N: Number>(a: &[N; 3], b: &[N; 3]) -> [N; 3] {
    std::array::from_fn(|i| a[i].clone() + b[i].clone())
}

/// The rows of the inverse times the determinant, and the determinant.
fn cofactors<N: Number>(columns: &[[N; 3]; 3]) -> ([[N; 3]; 3], N) {
    let [x, y, z] = columns;
    let rows = [cross(y, z), cross(z, x), cross(x, y)];
    let determinant = dot(&rows[0], x);
    (rows, determinant)
}

fn cross<N: Number>(a: &[N; 3], b: &[N; 3]) -> [N; 3] {
    std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        a[j].clone() * b[k].clone() - a[k].clone() * b[j].clone()
    })
}

/// Half an ulp of the origin, of the way to the solid, and of the placement's numbers, carried into generic coordinates.
fn doubt(ray: PixelRay, placement: &DAffine3) -> f64 {
    let size = placement.matrix3.abs() * DVec3::ONE;
    let way = (ray.origin - placement.translation).abs();
    let moved = HALF_ULP * (ray.origin.abs() + placement.translation.abs() + way + size);
    (placement.matrix3.inverse().abs() * moved).max_element()
}
