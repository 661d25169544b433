//! Environments against what can be known of them: constant and linear ones by their integrals, all others by many rays.

#![expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "numbers of faces and shades of grey, all small"
)]

mod formula;
mod notes;

use formula::evaluate;
use glam::DVec3;
use notes::Notes;
use rayscope::record::{NullRecorder, Value, What};
use rayscope::texture::image::{Environment, Layout, Texels};
use std::f64::consts::PI;
use std::sync::Arc;

/// One step of an sRGB byte's 255.
const STEP: f64 = 1.0 / 255.0;

/// The shapes that are tried: by latitude and longitude, and both crosses.
const SHAPES: [(Layout, [u32; 2]); 3] =
    [(Layout::LatitudeLongitude, [128, 64]), (Layout::Cross, [128, 96]), (Layout::Cross, [96, 128])];

/// An environment with these texels by column and row.
fn environment((layout, [width, height]): (Layout, [u32; 2]), texel: impl Fn(u32, u32) -> [f32; 3]) -> Environment {
    let data = (0..width * height).map(|i| texel(i % width, i / width)).collect();
    Environment::new(Arc::new(Texels::from_linear(width, height, data).unwrap()), layout, 0.0).unwrap()
}

/// A checkerboard of single texels in three colours of their own.
fn checker(x: u32, y: u32) -> [f32; 3] {
    [(x + y) % 2, (x / 3 + y / 2) % 2, (x / 5) % 2].map(|bit| if bit == 1 { 1.0 } else { 0.0 })
}

/// A quadrilateral about a direction, turned about it, with sides of about `size`.
fn footprint(middle: DVec3, turn: f64, [wide, high]: [f64; 2]) -> [DVec3; 4] {
    let right = middle.any_orthonormal_vector();
    let down = middle.cross(right);
    let (sin, cos) = turn.sin_cos();
    let (along, across) = (right * cos + down * sin, down * cos - right * sin);
    [(-1.0, -1.0), (1.0, -1.1), (0.9, 1.0), (-1.0, 0.8)]
        .map(|(x, y)| middle + along * (x * wide / 2.0) + across * (y * high / 2.0))
}

/// Directions evenly over a footprint, with their weights: a plane quadrilateral of unit square coordinates, whose pieces have solid
/// angles like (area seen from the eye) / distance³.
fn rays(corners: [DVec3; 4], count: u32) -> Vec<(DVec3, f64)> {
    let [a, b, c, d] = corners;
    let mut rays = Vec::new();
    for [o, p, q] in [[a, b, c], [a, c, d]] {
        let facing = (p - o).cross(q - o).dot(o).abs();
        for i in 0..count {
            let place = |step: f64| (0.5 + step * f64::from(i)).fract();
            let (x, y) = (place(0.754_877_666_246_693), place(0.569_840_290_998_053));
            let (x, y) = if x + y > 1.0 { (1.0 - x, 1.0 - y) } else { (x, y) };
            let direction = o + (p - o) * x + (q - o) * y;
            rays.push((direction, facing / 2.0 / f64::from(count) / direction.length().powi(3)));
        }
    }
    rays
}

/// The mean over a footprint by many rays, and its solid angle.
fn mean(corners: [DVec3; 4], colour: impl Fn(DVec3) -> DVec3) -> (DVec3, f64) {
    let (mut sum, mut whole) = (DVec3::ZERO, 0.0);
    for (direction, weight) in rays(corners, 1 << 14) {
        sum += colour(direction) * weight;
        whole += weight;
    }
    (sum / whole, whole)
}

/// Directions where something happens: poles, the seam, edges and corners of the cube, and others.
fn places() -> Vec<DVec3> {
    [
        (0.0, 0.0, 1.0),
        (0.0, 0.0, -1.0),
        (0.003, -0.002, 1.0),
        (0.05, 0.02, -1.0),
        (-1.0, 0.0, 0.0),
        (-1.0, 0.004, 0.3),
        (1.0, 0.0, 0.0),
        (1.0, 1.0, 0.1),
        (1.0, -1.0, 0.0),
        (1.0, 0.2, 1.0),
        (-1.0, 0.1, 1.0),
        (-1.0, 0.1, -1.0),
        (0.3, -1.0, -1.0),
        (1.0, 1.0, 1.0),
        (-1.0, -1.0, -1.0),
        (0.3, 0.5, -0.2),
        (-0.7, -0.1, 0.9),
    ]
    .map(|(x, y, z)| DVec3::new(x, y, z).normalize())
    .to_vec()
}

const SIZES: [[f64; 2]; 5] = [[0.01, 0.01], [0.03, 0.08], [0.2, 0.2], [0.6, 0.15], [1.4, 1.2]];

fn solid_angle(environment: &Environment, middle: DVec3, corners: [DVec3; 4]) -> f64 {
    let mut notes = Notes::default();
    environment.towards(middle, Some(corners), &mut notes);
    let Some(What::Environment(event)) = notes.0.last().map(|entry| &entry.what) else { panic!("{:?}", notes.0) };
    event.solid_angle
}

#[test]
fn all_texels_together_make_the_sphere() {
    for shape in SHAPES {
        let whole: f64 = environment(shape, |_, _| [0.0; 3]).solid_angles().sum();
        assert!((whole - 4.0 * PI).abs() < 1e-12, "{shape:?}: {whole}");
    }
}

#[test]
fn a_constant_environment_is_the_same_everywhere() {
    for shape in SHAPES {
        let grey = environment(shape, |_, _| [0.25, 0.5, 2.0]);
        for middle in places() {
            for size in SIZES {
                let colour = grey.towards(middle, Some(footprint(middle, 0.4, size)), &mut NullRecorder);
                assert!(
                    (colour - DVec3::new(0.25, 0.5, 2.0)).abs().max_element() < 1e-12,
                    "{shape:?} {middle} {size:?}"
                );
            }
        }
    }
}

#[test]
fn each_footprint_is_the_mean_of_many_rays() {
    let (mut worst, mut of_nearest) = (0.0_f64, 0.0_f64);
    for shape in SHAPES {
        let environment = environment(shape, checker);
        for (i, middle) in places().into_iter().enumerate() {
            for (j, size) in SIZES.into_iter().enumerate() {
                let corners = footprint(middle, 0.3 + 0.7 * (i + 2 * j) as f64, size);
                let nearest = |direction| environment.towards(direction, None, &mut NullRecorder);
                let (wanted, whole) = mean(corners, nearest);
                let found = environment.towards(middle, Some(corners), &mut NullRecorder);
                let difference = (found - wanted).abs().max_element();
                assert!(difference < STEP, "{shape:?} {middle} {size:?}: {} steps", difference / STEP);
                let ratio = solid_angle(&environment, middle, corners) / whole;
                assert!((ratio - 1.0).abs() < 6e-4, "{shape:?} {middle} {size:?}: {ratio} of the solid angle");
                worst = worst.max(difference / STEP);
                of_nearest = of_nearest.max((nearest(middle) - wanted).abs().max_element() / STEP);
            }
        }
    }
    println!("average: max {worst:.2} steps; nearest: max {of_nearest:.0} steps");
    assert!(of_nearest > 100.0);
}

/// Where the image shows what lies in a direction, the other way round: the unit direction of a place in texels; none off the cross.
fn look(layout: Layout, [width, height]: [u32; 2], [x, y]: [f64; 2]) -> Option<DVec3> {
    if layout == Layout::LatitudeLongitude {
        let (azimuth, polar) = (PI - 2.0 * PI * x / f64::from(width), PI * y / f64::from(height));
        return Some(DVec3::new(polar.sin() * azimuth.cos(), polar.sin() * azimuth.sin(), polar.cos()));
    }
    let n = f64::from(width.min(height) / 3);
    let (a, b) = (2.0 * (x / n).fract() - 1.0, 2.0 * (y / n).fract() - 1.0);
    let direction = match ((x / n).floor() as u8, (y / n).floor() as u8) {
        (1, 0) => DVec3::new(b, -a, 1.0),
        (0, 1) => DVec3::new(a, 1.0, -b),
        (1, 1) => DVec3::new(1.0, -a, -b),
        (2, 1) => DVec3::new(-a, -1.0, -b),
        (3, 1) => DVec3::new(-1.0, a, -b),
        (1, 2) => DVec3::new(-b, -a, -1.0),
        (1, 3) => DVec3::new(-1.0, -a, b),
        _ => return None,
    };
    Some(direction.normalize())
}

/// Colours that are linear in the direction average to the mean direction: ∮ ½ p × dp over the outline, by Stokes' theorem, which
/// for a great circle from a to b is ½ angle(a, b) · unit(a × b).
#[test]
fn an_environment_linear_in_the_direction_gives_the_mean_direction() {
    for (layout, size) in
        [(Layout::LatitudeLongitude, [1024, 512]), (Layout::Cross, [768, 576]), (Layout::Cross, [576, 768])]
    {
        let linear = environment((layout, size), |x, y| {
            let looks = look(layout, size, [f64::from(x) + 0.5, f64::from(y) + 0.5]);
            (0.5 + looks.unwrap_or_default() * 0.5).as_vec3().to_array()
        });
        for (i, middle) in places().into_iter().enumerate() {
            for size in &SIZES[2..] {
                let corners = footprint(middle, i as f64, *size).map(DVec3::normalize);
                let side = |i: usize| {
                    let normal = corners[i].cross(corners[(i + 1) % 4]);
                    normal.normalize() * normal.length().atan2(corners[i].dot(corners[(i + 1) % 4])) / 2.0
                };
                let integral = side(0) + side(1) + side(2) + side(3);
                let whole = solid_angle(&linear, middle, corners);
                let towards = integral * integral.dot(middle).signum() / whole;
                let found = linear.towards(middle, Some(corners), &mut NullRecorder);
                let difference = (found - (0.5 + towards * 0.5)).abs().max_element();
                assert!(difference < STEP, "{layout:?} {middle} {size:?}: {} steps", difference / STEP);
            }
        }
    }
}

/// Half a million texels and more in the footprint: smaller copies stand in for the image.
#[test]
fn smaller_copies_are_good_enough_for_large_footprints() {
    for shape in [(Layout::LatitudeLongitude, [2048, 1024]), (Layout::Cross, [2044, 1533])] {
        let environment = environment(shape, |x, y| {
            let [x, y] = [f64::from(x) * 0.011, f64::from(y) * 0.013];
            [0.5 + 0.5 * x.sin(), 0.5 + 0.5 * (x + y * y * 0.1).cos(), f64::from(u8::from((x + y).sin() > 0.0))]
                .map(|value| value as f32)
        });
        for middle in places() {
            let corners = footprint(middle, 1.0, [1.5, 1.5]);
            let (wanted, _) = mean(corners, |direction| environment.towards(direction, None, &mut NullRecorder));
            let mut notes = Notes::default();
            let found = environment.towards(middle, Some(corners), &mut notes);
            let difference = (found - wanted).abs().max_element();
            assert!(difference < STEP, "{shape:?} {middle}: {} steps", difference / STEP);
            let What::Texels(texels) = &notes.0[0].what else { panic!("{:?}", notes.0) };
            assert!(texels.level >= 1.0 && texels.texels.len() == 32 && texels.left_out > 1000);
        }
    }
}

#[test]
fn faces_of_a_cross_meet_where_the_cube_has_its_edges() {
    for (layout, size) in &SHAPES[1..] {
        let environment = environment((*layout, *size), |_, _| [0.0; 3]);
        // Across the edges that the cross does not cut, the image goes on.
        for (from, to) in
            [(DVec3::X, DVec3::Z), (DVec3::X, DVec3::NEG_Z), (DVec3::X, DVec3::Y), (DVec3::X, DVec3::NEG_Y)]
        {
            let side = from.cross(to);
            for shift in [-0.8, -0.1, 0.5] {
                let [a, b] = [1e-7, -1e-7].map(|more| environment.at(from * (1.0 + more) + to + side * shift));
                assert!((a[0] - b[0]).hypot(a[1] - b[1]) < 1e-4, "{layout:?}: {a:?}, {b:?}");
            }
        }
        let n = f64::from(size[0].min(size[1]) / 3);
        assert_eq!(environment.at(DVec3::X * 3.0), [1.5 * n, 1.5 * n]);
        assert_eq!(environment.at(DVec3::NEG_Y), [2.5 * n, 1.5 * n]);
        assert_eq!(environment.at(DVec3::Z), [1.5 * n, 0.5 * n]);
        let back = if size[0] > size[1] { [3.5 * n, 1.5 * n] } else { [1.5 * n, 3.5 * n] };
        assert_eq!(environment.at(DVec3::NEG_X), back);
    }
}

#[test]
fn right_in_the_image_is_right_of_who_looks_along_x() {
    let at = |environment: &Environment, direction| environment.at(direction);
    let globe = environment(SHAPES[0], |_, _| [0.0; 3]);
    assert_eq!(at(&globe, DVec3::X), [64.0, 32.0]);
    assert_eq!(at(&globe, DVec3::NEG_Y), [96.0, 32.0]);
    assert!((at(&globe, DVec3::new(1.0, 0.0, 1.0))[1] - 16.0).abs() < 1e-12);
    let texels = Arc::new(Texels::from_linear(128, 64, vec![[0.0; 3]; 128 * 64]).unwrap());
    let turned = Environment::new(texels, Layout::LatitudeLongitude, 90.0).unwrap();
    // What looked along +x now looks along +y.
    assert!((at(&turned, DVec3::Y)[0] - 64.0).abs() < 1e-12);
}

#[test]
fn what_is_no_footprint_gives_the_nearest_texel() {
    for shape in SHAPES {
        let environment = environment(shape, checker);
        for direction in places().into_iter().chain([DVec3::ZERO, DVec3::NAN, DVec3::splat(1e300)]) {
            let nearest = environment.towards(direction, None, &mut NullRecorder);
            assert!(nearest.is_finite());
            for corners in
                [[DVec3::ZERO; 4], [direction; 4], [DVec3::NAN; 4], [DVec3::X, DVec3::NEG_X, DVec3::X, DVec3::NEG_X]]
            {
                let colour = environment.towards(direction, Some(corners), &mut NullRecorder);
                assert!(
                    (DVec3::ZERO.cmple(colour) & colour.cmple(DVec3::ONE)).all(),
                    "{shape:?} {direction} {corners:?}"
                );
            }
        }
    }
    let no_cross = Arc::new(Texels::from_linear(4, 4, vec![[0.0; 3]; 16]).unwrap());
    assert!(Environment::new(Arc::clone(&no_cross), Layout::Cross, 0.0).unwrap_err().contains("4 × 4"));
    assert!(Environment::new(no_cross, Layout::LatitudeLongitude, f64::NAN).is_err());
}

#[test]
fn every_line_of_a_look_up_in_an_environment_holds() {
    for shape in SHAPES {
        let environment = environment(shape, checker);
        for middle in places() {
            let mut notes = Notes::default();
            let corners = footprint(middle, 0.2, [0.02, 0.03]);
            let colour = environment.towards(middle, Some(corners), &mut notes);
            assert_eq!(colour, environment.towards(middle, Some(corners), &mut NullRecorder));
            let lines: Vec<_> = notes.0.iter().flat_map(|entry| &entry.working).collect();
            assert!(lines.len() >= 2);
            for line in lines {
                let text = line.numbers.to_string();
                let found = evaluate(&text).unwrap_or_else(|problem| panic!("{}: {text}: {problem}", line.formula)).0;
                let result = match line.result {
                    Value::Number(x) => vec![x],
                    Value::Vector(v) => v.to_vec(),
                    Value::Truth(_) => Vec::new(),
                };
                let holds = |((x, error), y): (&(f64, f64), &f64)| (x - y).abs() <= 2.0 * error + 1e-12 * y.abs();
                assert!(
                    found.len() == result.len() && found.iter().zip(&result).all(holds),
                    "{text} = {result:?}, not {found:?}"
                );
            }
            let What::Environment(event) = &notes.0[1].what else { panic!("{:?}", notes.0) };
            assert!(event.footprint.len() >= 3 && event.solid_angle > 0.0);
        }
    }
}
