//! Lattice noise (§ 6.3.6): smooth, without end, the same for the same seed on every machine.
//!
//! At each whole-numbered point stands a gradient g (gradient noise) or a value (value noise), drawn from a table of 256
//! by a hash of the three coordinates and the seed. Within a cell n(p) = Σ wᵢ vᵢ over its eight corners cᵢ with
//! vᵢ = gᵢ · (p − cᵢ), or the value that stands there, and wᵢ the product of three fades s(x) = 6 x⁵ − 15 x⁴ + 10 x³ or
//! 1 − s(x): first and second derivatives of s vanish at both ends, so that n is continuous to the second derivative.
//!
//! **The gradients** are the corners of 32 cubes, each turned at random. The corners of a cube add up to zero and
//! favour no direction (Σ g gᵀ is a multiple of the unit matrix), so the mean of the noise is 0 and its statistics are
//! the same along all axes, exactly and for every seed. |g| = 2 / √3: then |n| ≤ 1, for by Jensen's inequality
//! |n| ≤ |g| √(Σ wᵢ |p − cᵢ|²) ≤ |g| √¾, with equality where all eight corners point to the middle of their cell.
//!
//! **The values** are the coordinates ±x, ±y of 64 points of the unit disc, whose squared radii are spread evenly: mean 0 and
//! mean square ¼, exactly.
//!
//! **Variance** With A = ∫ (1 − s)² + s² = 181/231 and B = ∫ (1 − s)² x² + s² (1 − x)² = 535/9009 it is
//! (|g|² / 3) 3 A² B = 70108540/1442187747 ≈ 0.0486 for gradient noise, and A³ / 4 ≈ 0.1203 for value noise.
//!
//! **Time** Each cube turns about an axis of its own at a rate of its own, from ½ to 1½ radians in a unit of time, and each
//! of the 64 points about the middle of its disc: the noise is stirred, and its statistics stay exactly as they are.
//!
//! **Source** K. Perlin, "Improving noise", SIGGRAPH 2002 (the fade); K. Perlin and F. Neyret, "Flow noise", SIGGRAPH 2001
//! sketches (turning gradients); T. Gustavson and I. McEwan, "Tiling simplex noise and flow noise", JCGT 11 (2022).

use super::random::{Random, turned};
use crate::record::{Binding, Entry, Lattice, LatticeCorner, Recorder, What};
use glam::DVec3;
use std::ops::{Add, Mul, Sub};

/// What stands at the points of the lattice.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoiseKind {
    /// Gradients: zero at the points of the lattice, finer and more even.
    Gradient,
    /// Values: coarser blobs.
    Value,
}

impl NoiseKind {
    /// The name, as scene files spell it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Gradient => "gradient",
            Self::Value => "value",
        }
    }
}

#[derive(Clone, Debug, PartialEq)]
enum Table {
    Gradients(Box<[DVec3; 256]>),
    Values(Box<[f64; 256]>),
}

/// Noise of one seed at one time.
#[derive(Clone, Debug, PartialEq)]
pub struct Noise {
    kind: NoiseKind,
    seed: u64,
    /// What the three coordinates are mixed with.
    keys: [u64; 3],
    table: Table,
}

/// Adding 1.5 · 2⁵² rounds to a whole number, whose bits then stand at the end.
const ROUNDER: f64 = 6_755_399_441_055_744.0;

/// Coordinates are brought to within ±2⁵⁰: that far out neighbouring numbers are ¼ apart, and there is no cell to see.
const FAR: f64 = 1_125_899_906_842_624.0;

/// The cell of a point.
struct Cell {
    /// Its lowest corner.
    low: DVec3,
    /// The point from there.
    offset: DVec3,
    /// The mixed bits of the lower and the higher coordinate, axis by axis.
    bits: [[u64; 2]; 3],
}

impl Cell {
    #[inline]
    fn new(p: DVec3, keys: &[u64; 3]) -> Self {
        let axes: [(f64, f64, [u64; 2]); 3] = std::array::from_fn(|i| {
            let x = within_reach(p[i]);
            let near = x + ROUNDER;
            let rounded = near - ROUNDER;
            let (low, bits) = if rounded > x { (rounded - 1.0, near.to_bits() - 1) } else { (rounded, near.to_bits()) };
            (low, x - low, [mixed(bits ^ keys[i]), mixed((bits + 1) ^ keys[i])])
        });
        Self {
            low: DVec3::from_array(axes.map(|(low, ..)| low)),
            offset: DVec3::from_array(axes.map(|(_, offset, _)| offset)),
            bits: axes.map(|(.., bits)| bits),
        }
    }

    /// The place in the table of the corner that is low (0) or high (1) in x, y and z.
    #[inline]
    fn place(&self, [i, j, k]: [usize; 3]) -> usize {
        let bits = self.bits[0][i] ^ self.bits[1][j] ^ self.bits[2][k];
        // A last multiplication, or corners would depend on each other as the three coordinates do.
        usize::from(bits.wrapping_mul(0xd6e8_feb8_6659_fd93).to_be_bytes()[0])
    }
}

/// The number, brought to within ±2⁵⁰; what is not a number counts as far below.
#[inline]
fn within_reach(x: f64) -> f64 {
    let x = if x > -FAR { x } else { -FAR };
    if x < FAR { x } else { FAR }
}

#[inline]
fn mixed(bits: u64) -> u64 {
    let product = bits.wrapping_mul(0x9e37_79b9_7f4a_7c15);
    (product ^ (product >> 32)).wrapping_mul(0xff51_afd7_ed55_8ccd)
}

/// s(x) = 6 x⁵ − 15 x⁴ + 10 x³.
#[inline]
pub(super) fn fade(x: f64) -> f64 {
    x * x * x * (x * (x * 6.0 - 15.0) + 10.0)
}

/// s′(x) = 30 x² (x − 1)².
#[inline]
fn fade_slope(x: f64) -> f64 {
    30.0 * x * x * (x - 1.0) * (x - 1.0)
}

/// What the eight corners say (x fastest), by the fades of the three axes.
#[inline]
fn blended<T>(fades: [f64; 3], corners: &[T; 8]) -> T
where
    T: Copy + Add<Output = T> + Sub<Output = T> + Mul<f64, Output = T>,
{
    let between = |a: T, b: T, share: f64| a + (b - a) * share;
    let [a, b, c, d] = [0, 2, 4, 6].map(|k| between(corners[k], corners[k + 1], fades[0]));
    between(between(a, b, fades[1]), between(c, d, fades[1]), fades[2])
}

/// The eight corners in the order of the record, x fastest.
const CORNERS: [[usize; 3]; 8] =
    [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [0, 0, 1], [1, 0, 1], [0, 1, 1], [1, 1, 1]];

/// Where the lower and the higher corners lie, as numbers.
const END: [f64; 2] = [0.0, 1.0];

#[inline]
fn vector(corner: [usize; 3]) -> DVec3 {
    DVec3::from_array(corner.map(|end| END[end]))
}

impl Noise {
    /// The noise of a seed at the time 0.
    #[must_use]
    pub fn new(kind: NoiseKind, seed: u64) -> Self {
        let mut random = Random::new(seed);
        let keys = std::array::from_fn(|_| random.bits());
        Self { kind, seed, keys, table: Table::new(kind, seed, 0.0) }
    }

    /// Stirs it to another time; the time itself counts, not the way there.
    pub fn at_time(&mut self, time: f64) {
        self.table = Table::new(self.kind, self.seed, time);
    }

    /// What stands at the lattice's points.
    #[must_use]
    pub fn kind(&self) -> NoiseKind {
        self.kind
    }

    /// The noise at a point, from −1 to 1.
    #[must_use]
    #[inline]
    pub fn value(&self, p: DVec3) -> f64 {
        let cell = Cell::new(p, &self.keys);
        blended(cell.offset.to_array().map(fade), &self.corner_values(&cell))
    }

    /// The noise at a point, and its gradient.
    #[must_use]
    pub fn value_and_slope(&self, p: DVec3) -> (f64, DVec3) {
        let cell = Cell::new(p, &self.keys);
        let fades = cell.offset.to_array().map(fade);
        let values = self.corner_values(&cell);
        let from_fades = DVec3::from_array(std::array::from_fn(|axis| {
            // The sum is linear in each fade.
            let at = |end: f64| {
                let mut fades = fades;
                fades[axis] = end;
                blended(fades, &values)
            };
            fade_slope(cell.offset[axis]) * (at(1.0) - at(0.0))
        }));
        (blended(fades, &values), from_fades + blended(fades, &self.corner_gradients(&cell)))
    }

    /// The [`value`](Self::value), and how it came about.
    pub fn told<R: Recorder>(&self, p: DVec3, recorder: &mut R) -> f64 {
        let value = self.value(p);
        recorder.note(|| self.describe(p, value));
        value
    }

    #[inline]
    fn corner_values(&self, cell: &Cell) -> [f64; 8] {
        match &self.table {
            Table::Gradients(gradients) => {
                CORNERS.map(|corner| gradients[cell.place(corner)].dot(cell.offset - vector(corner)))
            }
            Table::Values(values) => CORNERS.map(|corner| values[cell.place(corner)]),
        }
    }

    fn corner_gradients(&self, cell: &Cell) -> [DVec3; 8] {
        match &self.table {
            Table::Gradients(gradients) => CORNERS.map(|corner| gradients[cell.place(corner)]),
            Table::Values(_) => [DVec3::ZERO; 8],
        }
    }

    fn describe(&self, p: DVec3, noise: f64) -> Entry {
        let cell = Cell::new(p, &self.keys);
        let fades = DVec3::from_array(cell.offset.to_array().map(fade));
        let (values, gradients) = (self.corner_values(&cell), self.corner_gradients(&cell));
        let told = |(n, corner): (usize, [usize; 3])| {
            let share = |axis: usize| if corner[axis] == 0 { 1.0 - fades[axis] } else { fades[axis] };
            LatticeCorner {
                at: (cell.low + vector(corner)).to_array().map(whole),
                gradient: gradients[n].to_array(),
                value: values[n],
                weight: share(0) * share(1) * share(2),
            }
        };
        let lattice = Lattice {
            method: self.kind.name().to_owned(),
            point: p.to_array(),
            offset: cell.offset.to_array(),
            fade: fades.to_array(),
            corners: CORNERS.into_iter().enumerate().map(told).collect(),
            noise,
        };
        working(&lattice, cell.low)
    }
}

#[expect(clippy::cast_possible_truncation, reason = "within ±2⁵⁰, and whole")]
fn whole(x: f64) -> i64 {
    x as i64
}

const CORNER: [&str; 8] = ["c₀", "c₁", "c₂", "c₃", "c₄", "c₅", "c₆", "c₇"];
const GRADIENT: [&str; 8] = ["g₀", "g₁", "g₂", "g₃", "g₄", "g₅", "g₆", "g₇"];
const VALUE: [&str; 8] = ["v₀", "v₁", "v₂", "v₃", "v₄", "v₅", "v₆", "v₇"];
const WEIGHT: [&str; 8] = ["w₀", "w₁", "w₂", "w₃", "w₄", "w₅", "w₆", "w₇"];
const VALUE_LINE: [&str; 8] = [
    "g₀ · (x − c₀)",
    "g₁ · (x − c₁)",
    "g₂ · (x − c₂)",
    "g₃ · (x − c₃)",
    "g₄ · (x − c₄)",
    "g₅ · (x − c₅)",
    "g₆ · (x − c₆)",
    "g₇ · (x − c₇)",
];
const WEIGHT_LINE: [&str; 8] = [
    "(1 − s_x) (1 − s_y) (1 − s_z)",
    "s_x (1 − s_y) (1 − s_z)",
    "(1 − s_x) s_y (1 − s_z)",
    "s_x s_y (1 − s_z)",
    "(1 − s_x) (1 − s_y) s_z",
    "s_x (1 − s_y) s_z",
    "(1 − s_x) s_y s_z",
    "s_x s_y s_z",
];
const SUM_LINE: &str = "w₀ v₀ + w₁ v₁ + w₂ v₂ + w₃ v₃ + w₄ v₄ + w₅ v₅ + w₆ v₆ + w₇ v₇";

fn working(lattice: &Lattice, low: DVec3) -> Entry {
    let [s_x, s_y, s_z] = lattice.fade;
    let mut bindings: Vec<Binding> = vec![
        ("p", lattice.point.into()),
        ("c₀", low.to_array().into()),
        ("x", lattice.offset.into()),
        ("s_x", s_x.into()),
        ("s_y", s_y.into()),
        ("s_z", s_z.into()),
    ];
    let is_gradient = lattice.corners.iter().any(|corner| corner.gradient != [0.0; 3]);
    // Beyond the reach of the lattice the offset is that of the last point that has one.
    let is_near = lattice.point.iter().all(|x| x.abs() < FAR);
    let mut entry = Entry::new(What::Lattice(lattice.clone()));
    if is_near {
        entry = entry.line("x", "p − c₀", &bindings, lattice.offset);
    }
    bindings[1] = ("c₀", [0.0; 3].into());
    for (n, (corner, told)) in CORNERS.into_iter().zip(&lattice.corners).enumerate() {
        if n > 0 {
            bindings.push((CORNER[n], vector(corner).to_array().into()));
        }
        bindings.extend([(GRADIENT[n], told.gradient.into()), (VALUE[n], told.value.into())]);
        bindings.push((WEIGHT[n], told.weight.into()));
    }
    entry = entry.line("s", "6 x⁵ − 15 x⁴ + 10 x³", &bindings, lattice.fade);
    for (n, told) in lattice.corners.iter().enumerate() {
        if is_gradient {
            entry = entry.line(VALUE[n], VALUE_LINE[n], &bindings, told.value);
        }
        entry = entry.line(WEIGHT[n], WEIGHT_LINE[n], &bindings, told.weight);
    }
    entry.line("n", SUM_LINE, &bindings, lattice.noise)
}

impl Table {
    fn new(kind: NoiseKind, seed: u64, time: f64) -> Self {
        // Not the stream of the keys.
        let mut random = Random::new(!seed);
        match kind {
            NoiseKind::Gradient => {
                let mut gradients = Box::new([DVec3::ZERO; 256]);
                gradients.chunks_exact_mut(8).for_each(|cube| cube.copy_from_slice(&cube_of(&mut random, time)));
                Self::Gradients(gradients)
            }
            NoiseKind::Value => {
                let mut values = Box::new([0.0; 256]);
                for (n, square) in values.chunks_exact_mut(4).enumerate() {
                    let radius = ((n as f64 + 0.5) / 64.0).sqrt();
                    square.copy_from_slice(&disc_point(&mut random, radius, time));
                }
                Self::Values(values)
            }
        }
    }
}

/// The eight corners of a cube with half the edge 2/3, turned at random and then stirred.
fn cube_of(random: &mut Random, time: f64) -> [DVec3; 8] {
    let frame = random.frame();
    let axis = random.direction();
    let angle = (1.0 + 0.5 * random.signed()) * time;
    let [x, y, z] = frame.map(|edge| turned(edge, axis, angle) * (2.0 / 3.0));
    CORNERS.map(|corner| vector(corner) * 2.0 - 1.0).map(|sign| x * sign.x + y * sign.y + z * sign.z)
}

/// ±x and ±y of a point at this distance from the middle, in a random direction and then stirred.
fn disc_point(random: &mut Random, radius: f64, time: f64) -> [f64; 4] {
    let [x, y]: [f64; 2] = random.in_ball();
    let point = DVec3::new(x, y, 0.0) * (radius / (x * x + y * y).sqrt());
    // As often one way round as the other.
    let axis = if random.signed() < 0.0 { DVec3::Z } else { DVec3::NEG_Z };
    let DVec3 { x, y, .. } = turned(point, axis, (1.0 + 0.5 * random.signed()) * time);
    [x, -x, y, -y]
}

#[cfg(test)]
#[path = "noise_tests.rs"]
mod tests;
