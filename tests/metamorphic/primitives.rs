//! Single shapes: symmetry, scale, direction and place.

use crate::random::Random;
use crate::support::{agree, compile, placed, ray_at, same, shapes, spans, transform};
use glam::DVec3;
use rayscope::math::{DoubleDouble, Real};
use rayscope::record::{NullRecorder, Sense};
use rayscope::shape::{
    Crossing, Crossings, Cube, GenericRay, Primitive, Shape, Sphere, Superellipsoid, TaperedCylinder, Torus,
};
use serde_json::json;

const RAYS: usize = 400;

fn solve<A: Real>(shape: &Shape, origin: DVec3, direction: DVec3) -> Crossings {
    let mut crossings = Crossings::new();
    shape.crossings(&GenericRay::<A>::new(origin, direction), &mut NullRecorder, &mut crossings);
    crossings
}

fn times(crossings: &[Crossing]) -> Vec<(f64, Sense)> {
    crossings.iter().map(|crossing| (crossing.t, crossing.sense)).collect()
}

/// Within the errors that both state.
fn expect_same(shape: &Shape, found: &[Crossing], expected: &[Crossing], ray: (DVec3, DVec3)) {
    let alike = found.len() == expected.len()
        && found.iter().zip(expected).all(|(a, b)| a.sense == b.sense && agree((a.t, a.error), (b.t, b.error)));
    assert!(alike, "{shape:?}, {ray:?}: {found:?} for {expected:?}");
}

fn generic_ray(random: &mut Random) -> (DVec3, DVec3) {
    let direction = random.direction();
    let target = random.vector(-1.2, 1.2);
    (target - direction * 10.0_f64.powf(random.between(0.0, 5.0)), direction * random.between(0.5, 2.0))
}

/// x y z, y z x, z x y and their mirror images.
const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [1, 0, 2], [0, 2, 1], [2, 1, 0]];

fn permuted(v: DVec3, order: [usize; 3]) -> DVec3 {
    DVec3::from_array(order.map(|i| v[i]))
}

#[test]
fn the_cube_is_the_same_along_all_axes_to_the_last_bit() {
    let cube = Shape::Cube(Cube::new().unwrap());
    let mut random = Random(1);
    for _ in 0..4 * RAYS {
        let (origin, direction) = generic_ray(&mut random);
        let first = times(&solve::<f64>(&cube, origin, direction));
        for order in ORDERS {
            let turned = solve::<f64>(&cube, permuted(origin, order), permuted(direction, order));
            assert_eq!(times(&turned), first, "{origin:?} {direction:?} {order:?}");
        }
    }
}

#[test]
fn the_sphere_is_the_same_along_all_axes() {
    let sphere = Shape::Sphere(Sphere::new().unwrap());
    let mut random = Random(2);
    for _ in 0..4 * RAYS {
        let (origin, direction) = generic_ray(&mut random);
        let first = solve::<f64>(&sphere, origin, direction);
        for order in ORDERS {
            let turned = solve::<f64>(&sphere, permuted(origin, order), permuted(direction, order));
            expect_same(&sphere, &turned, &first, (origin, direction));
        }
        // x² + y² is y² + x² to the last bit.
        let swapped = solve::<f64>(&sphere, permuted(origin, [1, 0, 2]), permuted(direction, [1, 0, 2]));
        assert_eq!(times(&swapped), times(&first), "{origin:?} {direction:?}");
        // With 32 digits only the last rounding is left.
        let [a, b] = [[0, 1, 2], [2, 0, 1]]
            .map(|order| times(&solve::<DoubleDouble>(&sphere, permuted(origin, order), permuted(direction, order))));
        assert_eq!(a, b, "{origin:?} {direction:?}");
    }
}

#[test]
fn shapes_of_revolution_are_the_same_along_x_and_y_and_in_a_mirror() {
    let mut random = Random(3);
    let mut shapes = vec![Shape::Sphere(Sphere::new().unwrap()), Shape::Cube(Cube::new().unwrap())];
    shapes.extend([0.0, 0.4, 1.0, 2.0].map(|s| Shape::TaperedCylinder(TaperedCylinder::new(s).unwrap())));
    shapes.extend([0.3, 1.0, 3.0].map(|d| Shape::Torus(Torus::new(d).unwrap())));
    let exponents = [(4.0, 2.0), (0.5, 0.7), (0.6, 3.0), (3.0, 0.6)];
    shapes.extend(exponents.map(|(n, m)| Shape::Superellipsoid(Superellipsoid::new(n, m).unwrap())));
    for shape in &shapes {
        for _ in 0..RAYS {
            let ray @ (origin, direction) = generic_ray(&mut random);
            let first = solve::<f64>(shape, origin, direction);
            let swapped = solve::<f64>(shape, permuted(origin, [1, 0, 2]), permuted(direction, [1, 0, 2]));
            expect_same(shape, &swapped, &first, ray);
            let mirror = DVec3::new(-1.0, 1.0, 1.0);
            let mirrored = solve::<f64>(shape, origin * mirror, direction * mirror);
            assert_eq!(times(&mirrored), times(&first), "{shape:?}, {ray:?}: negating a number rounds nothing");
        }
    }
}

#[test]
fn scaling_ray_and_solid_by_a_power_of_two_scales_nothing_else() {
    let mut random = Random(4);
    for shape in shapes() {
        for _ in 0..RAYS {
            let steps = transform(&mut random);
            let solid = compile(&placed(&shape, &steps));
            let (origin, direction) = ray_at(&solid, &mut random);
            let scale = 2.0_f64.powi(i32::try_from(random.below(80)).unwrap() - 40);
            let scaled = compile(&placed(&placed(&shape, &steps), &[json!({"scale": scale})]));
            let expected: Vec<_> = spans(&solid, (origin, direction)).iter().map(|s| s.map(|end| end.0)).collect();
            // The same points in the same times.
            let both = spans(&scaled, (origin * scale, direction * scale));
            let times: Vec<_> = both.iter().map(|span| span.map(|end| end.0)).collect();
            assert_eq!(times, expected, "{shape} {steps:?} {origin:?} {direction:?} {scale:e}");
            // A direction that is not scaled takes longer in proportion.
            let longer = spans(&scaled, (origin * scale, direction));
            let times: Vec<_> = longer.iter().map(|span| span.map(|end| end.0 / scale)).collect();
            assert_eq!(times, expected, "{shape} {steps:?} {origin:?} {direction:?} {scale:e}");
        }
    }
}

#[test]
fn a_reversed_ray_meets_the_same_places_in_reverse() {
    let mut random = Random(5);
    for shape in shapes() {
        for _ in 0..RAYS {
            let solid = compile(&placed(&shape, &transform(&mut random)));
            let (origin, direction) = ray_at(&solid, &mut random);
            let forth = spans(&solid, (origin, direction));
            let mut back: Vec<_> =
                spans(&solid, (origin, -direction)).iter().map(|[a, b]| [(-b.0, b.1), (-a.0, a.1)]).collect();
            back.reverse();
            same(&back, &forth).unwrap_or_else(|problem| panic!("{shape} {origin:?} {direction:?}: {problem}"));
        }
    }
}

#[test]
fn moving_ray_and_solid_by_whole_numbers_changes_nothing() {
    let mut random = Random(6);
    let whole = |v: DVec3| v.round();
    for shape in shapes() {
        for _ in 0..RAYS {
            // Sixteenths, so that the sums are exact.
            let direction = random.direction();
            let target = random.vector(-1.0, 1.0);
            let origin = ((target - direction * random.between(1.0, 50.0)) * 16.0).round() / 16.0;
            let by = whole(random.vector(-1000.0, 1000.0));
            let here = spans(&compile(&shape), (origin, direction));
            let there = compile(&placed(&shape, &[json!({"translate": by.to_array()})]));
            let there = spans(&there, (origin + by, direction));
            if shape["shape"] == "superellipsoid" {
                // A search takes its last step or not by how well it knows the ray.
                same(&there, &here).unwrap_or_else(|problem| panic!("{shape} {origin:?} {direction:?}: {problem}"));
                continue;
            }
            let [there, here] =
                [there, here].map(|spans| spans.iter().map(|span| span.map(|end| end.0)).collect::<Vec<_>>());
            assert_eq!(there, here, "{shape} {origin:?} {direction:?} {by:?}");
        }
    }
}

#[test]
fn starting_further_along_the_ray_takes_the_same_off_all_times() {
    let mut random = Random(7);
    for shape in shapes() {
        for _ in 0..RAYS {
            let solid = compile(&shape);
            // Eighths and whole steps: the new origin is exact.
            let eighths = |v: DVec3| (v * 8.0).round() / 8.0;
            let direction = eighths(random.vector(-2.0, 2.0)) + DVec3::new(0.125, 0.0, 0.0);
            if direction == DVec3::ZERO {
                continue;
            }
            let (origin, steps) = (eighths(random.vector(-3.0, 3.0)), random.between(-1000.0, 1000.0).round());
            let here = spans(&solid, (origin, direction));
            let shifted = spans(&solid, (origin - direction * steps, direction));
            let back: Vec<_> = shifted.iter().map(|s| s.map(|(t, error)| (t - steps, error))).collect();
            // Subtracting rounds once more.
            let wider: Vec<_> =
                back.iter().map(|s| s.map(|(t, e)| (t, e + 2.0 * f64::EPSILON * steps.abs()))).collect();
            same(&wider, &here).unwrap_or_else(|problem| panic!("{shape} {origin:?} {direction:?} {steps}: {problem}"));
        }
    }
}
