//! Filters of image textures against what they are to find: the average over a pixel, found here by sending many rays
//! through it.

#![expect(clippy::cast_possible_truncation, reason = "texel numbers and shades of grey, all small")]

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

/// How many of them a mean is taken over.
const PLACES: u32 = 1 << 17;

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
        (found - pixel.mean(even(PLACES), seen(checker(cell)))).abs()
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
fn the_filters_without_the_pixels_shape_are_far_from_its_average() {
    let pixels = pixels(&SLANTS, &[1.0, 2.3]);
    for filter in [Filter::Nearest, Filter::Bilinear, Filter::Trilinear, Filter::Ewa] {
        let [p50, p99, max] = quantiles(differences(filter, &pixels, &[1, 2]));
        println!("{}: p50 {p50:.1}, p99 {p99:.1}, max {max:.1} steps", filter.name());
        let bounds = match filter {
            // What a single texel says of many is up to chance; half of all pixels are off by half of black to white.
            Filter::Nearest => p50 > 100.0 && p99 > 127.0,
            Filter::Bilinear => p50 > 20.0 && p99 > 100.0,
            Filter::Trilinear => p50 < 6.0 && p99 < 90.0,
            _ => p50 < 6.0 && p99 < 45.0 && max < 60.0,
        };
        assert!(bounds, "{}: p50 {p50:.1}, p99 {p99:.1}, max {max:.1} steps", filter.name());
    }
}

#[test]
fn the_reference_itself_is_good_enough() {
    let pixels = pixels(&SLANTS, &[0.7, 2.3]);
    let twice = |pixel: &Pixel| {
        let seen = seen(checker(2));
        [pixel.mean(even(PLACES), &seen), pixel.mean(even(8 * PLACES), &seen), pixel.mean(grid(), &seen)]
    };
    let means: Vec<_> = pixels.iter().map(twice).collect();
    let own = quantiles(means.iter().map(|[a, b, _]| (a - b).abs()).collect());
    let coarse = quantiles(means.iter().map(|[_, b, c]| (c - b).abs()).collect());
    println!("{PLACES} places: {own:.3?} steps; 64 × 64: {coarse:.3?} steps");
    assert!(own[2] < 0.5, "{own:?}");
}

/// Where a pattern is fine enough to be averaged out, the Gaussian and the square agree.
#[test]
fn ewa_finds_the_average_where_a_pixel_holds_many_cells() {
    for (slants, size, bound) in [(&SLANTS[..], 12.0, 3.0), (&SLANTS[3..], 4.0, 3.0), (&SLANTS[..], 24.0, 1.0)] {
        let [p50, p99, max] = quantiles(differences(Filter::Ewa, &pixels(slants, &[size]), &[1]));
        println!("ewa, {size} cells to a pixel: p50 {p50:.2}, p99 {p99:.2}, max {max:.2} steps");
        assert!(max <= bound, "{size} cells from {}°: {max}", slants[0]);
    }
}

/// Where the pixel and all of the ellipse lie within a cell, there is nothing to be wrong about.
#[test]
fn ewa_sees_one_colour_where_there_is_one() {
    let pixel = Pixel::new(DVec2::new(0.25, 0.75) + 0.125, 1.0 / 64.0, 4.0, [60.0, 20.0, 10.0]);
    let found = image(checker(16), Filter::Ewa).colour(&place(&pixel), &mut NullRecorder).x;
    assert_eq!(found, pixel.mean(grid(), seen(checker(16))));
}

/// No round weight can agree with a square about an edge that passes through it: the square's answer depends on the direction
/// of the edge, by 5 steps either way. This Gaussian is off by no more than 12.
#[test]
fn ewa_is_off_by_a_few_steps_at_an_edge() {
    let edge = |column: i64, _| f64::from(u8::from(column.rem_euclid(64) >= 32));
    let mut worst = 0.0_f64;
    for turn in [0.0, 20.0, 45.0] {
        for shift in -24..24 {
            let target = DVec2::new(0.5 + f64::from(shift) / 64.0 / 4.0, 0.5);
            let pixel = Pixel::new(target, 8.0 / 64.0, 100.0, [0.0, 0.0, turn]);
            let found = image(edge, Filter::Ewa).colour(&place(&pixel), &mut NullRecorder).x;
            worst = worst.max((found - pixel.mean(even(PLACES), seen(edge))).abs() / STEP);
        }
    }
    println!("ewa at an edge: max {worst:.2} steps");
    assert!((5.0..12.5).contains(&worst), "{worst}");
}

/// Hundreds of thousands of texels to a pixel: levels of the pyramid stand in for the image.
#[test]
fn near_the_horizon_levels_of_the_pyramid_are_good_enough() {
    let pixels = pixels(&[88.0, 89.5], &[40.0, 100.0]);
    for filter in [Filter::Area, Filter::Ewa] {
        let [p50, p99, max] = quantiles(differences(filter, &pixels, &[1, 2, 8]));
        println!("{} of 10⁵ texels: p50 {p50:.2}, p99 {p99:.2}, max {max:.2} steps", filter.name());
        assert!(max <= if filter == Filter::Area { 1.0 } else { 3.0 }, "{}: {max}", filter.name());
    }
    let levels = |pixel: &Pixel| {
        let mut notes = Notes::default();
        image(checker(8), Filter::Area).colour(&place(pixel), &mut notes);
        notes.0.iter().find_map(|what| if let What::Texels(texels) = what { Some(texels.level) } else { None })
    };
    assert!(pixels.iter().any(|pixel| levels(pixel) > Some(1.0)));
}

#[test]
fn a_report_holds_the_largest_shares_and_they_add_up() {
    for filter in [Filter::Nearest, Filter::Bilinear, Filter::Area, Filter::Ewa] {
        for pixel in pixels(&SLANTS[..4], &[0.3, 2.3, 5.0]) {
            let mut notes = Notes::default();
            let texture = image(checker(2), filter);
            let colour = texture.colour(&place(&pixel), &mut notes);
            assert_eq!(colour, texture.colour(&place(&pixel), &mut NullRecorder));
            let [What::Mapping(mapping), What::Texels(texels)] = &notes.0[..] else { panic!("{:?}", notes.0) };
            assert_eq!(mapping.footprint.len(), if filter.needs_footprint() { 4 } else { 0 });
            assert_eq!(texels.filter, filter.name());
            assert!(texels.texels.len() <= 32 && (texels.left_out == 0 || texels.texels.len() == 32));
            assert!(texels.texels.windows(2).all(|pair| pair[0].weight >= pair[1].weight));
            let sum: f64 = texels.texels.iter().map(|texel| texel.weight).sum();
            let value: f64 = texels.texels.iter().map(|texel| texel.weight * texel.colour[0]).sum();
            if texels.left_out == 0 {
                assert!((sum - 1.0).abs() < 1e-12 && (value - colour.x).abs() < 1e-12, "{sum}, {value}");
            } else {
                assert!(sum < 1.0 + 1e-12 && value < colour.x + 1e-12);
            }
        }
    }
}

#[test]
fn a_texel_s_share_is_the_part_of_the_pixel_that_sees_it() {
    let pixel = Pixel::new(DVec2::new(0.507, 0.496), 1.0 / 64.0, 0.08, [62.0, 33.0, 12.0]);
    let mut notes = Notes::default();
    image(checker(1), Filter::Area).colour(&place(&pixel), &mut notes);
    let Some(What::Texels(texels)) = notes.0.last() else { panic!("{:?}", notes.0) };
    assert!(texels.texels.len() > 3);
    for texel in &texels.texels {
        let sees = |column: i64, row: i64| f64::from(u8::from([column, row] == texel.at));
        assert!((texel.weight - pixel.mean(even(PLACES), seen(sees))).abs() < 3e-4, "{texel:?}");
    }
}

#[test]
fn footprints_that_are_no_squares_in_perspective_still_give_a_colour() {
    let at = |corners: [(f64, f64); 4]| Place {
        uv: DVec2::new(0.3, 0.4),
        part: 0,
        part_name: "surface",
        corners: Some(corners.map(DVec2::from)),
        off_the_surface: 4,
        period: [Some(1.0), None],
    };
    let far = f64::MAX;
    let quads = [
        [(0.3, 0.4); 4],
        [(0.2, 0.4), (0.3, 0.4), (0.4, 0.4), (0.5, 0.4)],
        [(0.2, 0.3), (0.4, 0.5), (0.4, 0.3), (0.2, 0.5)],
        [(0.2, 0.2), (0.5, 0.3), (0.3, 0.3), (0.3, 0.5)],
        [(0.2, f64::NAN), (0.5, 0.3), (0.3, 0.3), (0.3, 0.5)],
        [(0.2, f64::INFINITY), (0.5, 0.3), (0.3, 0.3), (0.3, 0.5)],
        [(0.3, -far), (0.5, 0.3), (0.3, far), (0.3, 0.5)],
        [(0.3, -1e12), (0.3001, -1e12), (0.3001, 1e12), (0.3, 1e12)],
        [(0.3, -1e300), (1e-300, 1e300), (0.3001, 1e12), (0.3, 1e12)],
        [(0.3, 0.4), (0.3, 0.4), (0.3, 0.4), (0.3, 1e4)],
    ];
    for filter in [Filter::Nearest, Filter::Bilinear, Filter::Trilinear, Filter::Area, Filter::Ewa] {
        for quad in quads {
            let colour = image(checker(8), filter).colour(&at(quad), &mut NullRecorder);
            assert!((-1e-9..=1.0 + 1e-9).contains(&colour.x), "{} of {quad:?}: {colour}", filter.name());
            let place = Place { uv: DVec2::new(f64::NAN, far), ..at(quad) };
            assert!(image(checker(8), filter).colour(&place, &mut NullRecorder).x.is_finite());
        }
    }
}

#[test]
fn a_folded_footprint_counts_both_of_its_halves() {
    // The pixel lies as a dart: its two halves cover texels (0, 0) to (4, 4) in part, both within the light left half.
    let left = |column: i64, _| f64::from(u8::from(column.rem_euclid(64) < 32));
    let corners = [(0.1, 0.1), (0.4, 0.1), (0.2, 0.2), (0.1, 0.4)].map(DVec2::from);
    let place = |shift: f64| Place {
        uv: DVec2::new(0.2 + shift, 0.2),
        part: 0,
        part_name: "surface",
        corners: Some(corners.map(|corner| corner + DVec2::new(shift, 0.0))),
        off_the_surface: 0,
        period: [None, None],
    };
    let at = |shift| image(left, Filter::Area).colour(&place(shift), &mut NullRecorder).x;
    assert!((at(0.0) - 1.0).abs() < 1e-12 && at(0.5).abs() < 1e-12);
    // The edge at 0.5 passes the middle corner: of the half to the right, (0.1, 0.1)–(0.4, 0.1)–(0.2, 0.2), a third lies
    // left of its corner; all of the other half is there.
    assert!((at(0.3) - 2.0 / 3.0).abs() < 1e-12, "{}", at(0.3));
}

#[test]
fn a_pixel_on_the_seam_sees_both_ends_of_the_image_and_nothing_between() {
    let ends = |column: i64, _| [1.0, 0.0][usize::from((8..56).contains(&column.rem_euclid(64)))];
    let corners = [(0.98, 0.5), (0.02, 0.5), (0.02, 0.52), (0.98, 0.52)].map(DVec2::from);
    let place = Place {
        uv: DVec2::new(0.001, 0.51),
        part: 0,
        part_name: "wall",
        corners: Some(corners),
        off_the_surface: 0,
        period: [Some(1.0), None],
    };
    for filter in [Filter::Area, Filter::Ewa, Filter::Trilinear] {
        let colour = image(ends, filter).colour(&place, &mut NullRecorder).x;
        assert!((colour - 1.0).abs() < 1e-12, "{}: {colour}", filter.name());
    }
}

#[test]
fn bumps_slope_as_the_surface_sees_them() {
    let map = rayscope::texture::image::Affine::new([[0.5, 0.1, 0.2], [-0.2, 0.75, 0.0]]);
    let hills = |column: i64, row: i64| ((column * 7 + row * 5) % 13) as f64 / 13.0;
    let mut texture = image(hills, Filter::Nearest);
    texture.mapping = Mapping::new(map).unwrap();
    texture.wraps = Wraps { columns: Wrap::Mirror, rows: Wrap::Clamp };
    let height = |u: f64, v: f64| texture.height_and_slopes(DVec2::new(u, v), 0).0;
    for (u, v) in [(0.31, 0.42), (0.55, 0.2), (0.7, 0.6)] {
        let slopes = texture.height_and_slopes(DVec2::new(u, v), 0).1;
        let step = 1e-6;
        let found = [height(u + step, v) - height(u - step, v), height(u, v + step) - height(u, v - step)];
        assert!((0..2).all(|i| (slopes[i] - found[i] / (2.0 * step)).abs() < 1e-5), "{slopes:?}");
    }
}
