//! Filters of image textures against what they are to find: the average over a pixel, found here by sending many rays
//! through it.

use glam::{DVec2, DVec3};
use rayscope::record::{Counter, Entry, NullRecorder, Recorder, What};
use rayscope::texture::image::{Filter, ImageTexture, Mapping, Place, Texels, Wrap, Wraps};
use std::sync::Arc;

/// One step of an sRGB byte's 255.
const STEP: f64 = 1.0 / 255.0;

/// A pixel that looks at the plane z = 0.
#[derive(Clone, Copy, Debug)]
struct Pixel {
    eye: DVec3,
    /// From the eye to the middle of the pixel, and along its sides.
    middle: DVec3,
    right: DVec3,
    down: DVec3,
}

impl Pixel {
    /// A pixel `size` wide, seen from `distance`, whose ray meets the plane at `target` at `slant` degrees from the normal;
    /// the picture is turned by `turn` about the ray and the ground by `azimuth`.
    fn new(target: DVec2, size: f64, distance: f64, [slant, azimuth, turn]: [f64; 3]) -> Self {
        let (slant, azimuth, turn) = (slant.to_radians(), azimuth.to_radians(), turn.to_radians());
        let along = DVec3::new(azimuth.cos(), azimuth.sin(), 0.0);
        let middle = along * slant.sin() - DVec3::Z * slant.cos();
        let side = DVec3::Z.cross(along);
        let up = side.cross(middle);
        let right = (side * turn.cos() + up * turn.sin()) * (size / distance);
        let down = (side * turn.sin() - up * turn.cos()) * (size / distance);
        Self { eye: target.extend(0.0) - middle * distance, middle, right, down }
    }

    /// Where the ray through a place of the pixel (0 to 1) meets the plane; none at and above the horizon.
    fn meets(&self, p: f64, q: f64) -> Option<DVec2> {
        let direction = self.middle + self.right * (p - 0.5) + self.down * (q - 0.5);
        (direction.z < 0.0).then(|| (self.eye - direction * (self.eye.z / direction.z)).truncate())
    }

    fn corners(&self) -> Option<[DVec2; 4]> {
        let [a, b, c, d] = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(p, q)| self.meets(p, q));
        Some([a?, b?, c?, d?])
    }

    /// The mean of `colour` over places of the pixel.
    fn mean(&self, places: impl Iterator<Item = [f64; 2]>, colour: impl Fn(DVec2) -> f64) -> f64 {
        let (sum, count) = places.fold((0.0, 0.0), |(sum, count), [p, q]| {
            (sum + colour(self.meets(p, q).expect("a pixel below the horizon")), count + 1.0)
        });
        sum / count
    }
}

/// The middles of 64 × 64 squares. Where an edge runs along them they are off by up to 1/128, two steps.
fn grid() -> impl Iterator<Item = [f64; 2]> {
    (0..4096).map(|i| [f64::from(i % 64) + 0.5, f64::from(i / 64) + 0.5].map(|x| x / 64.0))
}

/// Places that fill the pixel evenly in all directions (M. Roberts' R₂: multiples of the powers of the plastic number).
fn even(count: u32) -> impl Iterator<Item = [f64; 2]> {
    (0..count).map(|i| [0.754_877_666_246_693, 0.569_840_290_998_053].map(|step| (0.5 + step * f64::from(i)).fract()))
}

const TEXELS: u32 = 64;

/// A checkerboard on 64 × 64 texels, with cells of so many texels.
fn checker(cell: u32) -> impl Fn(i64, i64) -> f64 {
    move |column, row| ((column.rem_euclid(64) / i64::from(cell) + row.rem_euclid(64) / i64::from(cell)) % 2) as f64
}

fn image(pattern: impl Fn(i64, i64) -> f64, filter: Filter) -> ImageTexture {
    let texel = |i: u32| [pattern(i64::from(i % TEXELS), i64::from(i / TEXELS)) as f32; 3];
    let texels = Texels::from_linear(TEXELS, TEXELS, (0..TEXELS * TEXELS).map(texel).collect()).unwrap();
    ImageTexture { texels: Arc::new(texels), mapping: Mapping::default(), wraps: Wraps::default(), filter }
}

/// The pattern's value at a place of the plane: the image fills the square from 0 to 1, its top row at y = 1.
fn seen(pattern: impl Fn(i64, i64) -> f64) -> impl Fn(DVec2) -> f64 {
    move |at| pattern((at.x * 64.0).floor() as i64, ((1.0 - at.y) * 64.0).floor() as i64)
}

fn place(pixel: &Pixel) -> Place<'static> {
    Place {
        uv: pixel.meets(0.5, 0.5).unwrap(),
        part: 0,
        part_name: "surface",
        corners: pixel.corners(),
        off_the_surface: 0,
        period: [None, None],
    }
}

/// Keeps the events in the order in which they end.
#[derive(Default)]
struct Notes(Vec<What>);

impl Recorder for Notes {
    const RECORDING: bool = true;
    fn begin(&mut self) {}
    fn end(&mut self, describe: impl FnOnce() -> Entry) {
        self.0.push(describe().what);
    }
    fn count(&mut self, _counter: Counter) {}
}

/// Pixels over slants, directions, sizes and places. A pixel is 1/200 of the way to what it sees, so that at 89.5° its far
/// corner is almost twice as far away as its near one.
fn pixels(slants: &[f64], sizes_in_texels: &[f64]) -> Vec<Pixel> {
    let mut pixels = Vec::new();
    for (i, slant) in slants.iter().enumerate() {
        for (j, size) in sizes_in_texels.iter().enumerate() {
            for (k, [azimuth, turn]) in [[0.0, 0.0], [17.0, 0.0], [45.0, 30.0], [71.0, 58.0]].into_iter().enumerate() {
                for l in 0..3 {
                    let steps = (i * 7 + j * 31 + k * 5 + l) as f64;
                    let target = DVec2::new((0.5 + steps * 0.618_034).fract(), (0.5 + steps * 0.414_214).fract());
                    let size = size / 64.0;
                    pixels.push(Pixel::new(target, size, 200.0 * size, [*slant, azimuth, turn]));
                }
            }
        }
    }
    pixels
}

const SLANTS: [f64; 7] = [0.0, 30.0, 60.0, 75.0, 85.0, 88.0, 89.5];

/// Median, 99th percentile and largest of differences, in steps.
fn quantiles(mut differences: Vec<f64>) -> [f64; 3] {
    differences.sort_by(f64::total_cmp);
    let last = differences.len() - 1;
    [last / 2, last * 99 / 100, last].map(|i| differences[i] / STEP)
}

/// How far a filter is from the average over each pixel, for checkers of several cells.
fn differences(filter: Filter, pixels: &[Pixel], cells: &[u32]) -> Vec<f64> {
    let difference = |cell: u32, pixel: &Pixel| {
        let found = image(checker(cell), filter).colour(&place(pixel), &mut NullRecorder).x;
        (found - pixel.mean(even(16384), seen(checker(cell)))).abs()
    };
    cells.iter().flat_map(|cell| pixels.iter().map(move |pixel| difference(*cell, pixel))).collect()
}

#[test]
fn area_is_the_average_over_the_pixel_at_every_slant() {
    let pixels = pixels(&SLANTS, &[0.1, 0.7, 1.0, 2.3, 8.0]);
    let quantiles = quantiles(differences(Filter::Area, &pixels, &[1, 2, 8]));
    println!("area: p50 {:.3}, p99 {:.3}, max {:.3} steps", quantiles[0], quantiles[1], quantiles[2]);
    assert!(quantiles[2] <= 1.0, "{quantiles:?}");
}

#[test]
fn nearest_is_far_from_the_average_and_area_is_not() {
    let pixels = pixels(&SLANTS, &[1.0, 2.3]);
    for filter in [Filter::Nearest, Filter::Bilinear, Filter::Trilinear, Filter::Ewa] {
        let [p50, p99, max] = quantiles(differences(filter, &pixels, &[1, 2]));
        println!("{}: p50 {p50:.1}, p99 {p99:.1}, max {max:.1} steps", filter.name());
        if filter == Filter::Nearest {
            assert!(p50 > 60.0 && p99 > 120.0, "nearest sees one texel where the pixel sees many: {p50}, {p99}");
        }
    }
}

#[test]
fn the_reference_itself_is_good_enough() {
    let pixels = pixels(&SLANTS, &[0.7, 2.3]);
    let twice = |pixel: &Pixel| {
        let seen = seen(checker(2));
        [pixel.mean(even(16384), &seen), pixel.mean(even(262_144), &seen), pixel.mean(grid(), &seen)]
    };
    let means: Vec<_> = pixels.iter().map(twice).collect();
    let own = quantiles(means.iter().map(|[a, b, _]| (a - b).abs()).collect());
    let coarse = quantiles(means.iter().map(|[_, b, c]| (c - b).abs()).collect());
    println!("16384 places: {own:.3?} steps; 64 × 64: {coarse:.3?} steps");
    assert!(own[2] < 0.5, "{own:?}");
}
