use super::super::testing::{Kept, assert_every_line_holds, points};
use super::*;

const POINTS: usize = 1_000_000;
const KINDS: [NoiseKind; 2] = [NoiseKind::Gradient, NoiseKind::Value];

/// The exact mean squares of the noise and of one component of its gradient, by integrals of the fade.
///
/// With d the offset from a corner and w its weight, n = Σ w v: so the mean of n² is Σ ∫ w² times the mean of v², and that of
/// (∂n/∂x)² for gradient noise (|g|² / 3) Σ ∫ (∂w/∂x)² |d|² + 2 w d_x ∂w/∂x + w².
fn mean_squares(kind: NoiseKind) -> [f64; 2] {
    let (a, b) = (181.0 / 231.0, 535.0 / 9009.0);
    // ∫ 2 s′², ∫ s′² (x² + (1 − x)²), ∫ Σ w d ∂w/∂x of one axis.
    let (c, d, e) = (20.0 / 7.0, 60.0 / 77.0, -181.0 / 462.0);
    match kind {
        NoiseKind::Gradient => {
            let third = 4.0 / 9.0;
            [third * 3.0 * a * a * b, third * (d * a * a + 2.0 * c * a * b + 2.0 * e * a * a + a * a * a)]
        }
        NoiseKind::Value => [a * a * a / 4.0, c * a * a / 4.0],
    }
}

/// The mean of numbers, and five times its standard error.
fn mean(numbers: impl Iterator<Item = f64>) -> (f64, f64) {
    let (count, sum, squares) = numbers.fold((0.0, 0.0, 0.0), |(n, s, q), x| (n + 1.0, s + x, q + x * x));
    let mean: f64 = sum / count;
    (mean, 5.0 * ((squares / count - mean * mean) / count).sqrt())
}

#[track_caller]
fn assert_mean(numbers: impl Iterator<Item = f64>, expected: f64, what: &str) {
    let (found, error) = mean(numbers);
    assert!((found - expected).abs() <= error, "the mean of {what} is {found} ± {error}, not {expected}");
}

#[test]
fn mean_and_variance_are_those_of_the_integrals() {
    for kind in KINDS {
        for (seed, time) in [(0, 0.0), (1, 0.0), (1, 37.5)] {
            let mut noise = Noise::new(kind, seed);
            noise.at_time(time);
            // So far apart that hardly any two points share a cell.
            let values: Vec<f64> = points(POINTS, 1e5).map(|p| noise.value(p)).collect();
            assert_mean(values.iter().copied(), 0.0, "n");
            assert_mean(values.iter().map(|n| n * n), mean_squares(kind)[0], "n²");
            assert!(values.iter().all(|n| n.abs() <= 1.0));
        }
    }
}

#[test]
fn no_axis_is_favoured() {
    for kind in KINDS {
        let noise = Noise::new(kind, 11);
        let slopes: Vec<DVec3> = points(POINTS, 1e5).map(|p| noise.value_and_slope(p).1).collect();
        for axis in 0..3 {
            assert_mean(slopes.iter().map(|v| v[axis] * v[axis]), mean_squares(kind)[1], "a slope's square");
            assert_mean(slopes.iter().map(|v| v[axis] * v[(axis + 1) % 3]), 0.0, "a product of slopes");
        }
        // Histograms of slopes along each axis, from points that are not shared.
        let histogram = |axis: usize| {
            let mut bins = [0.0_f64; 24];
            for v in slopes.iter().skip(axis).step_by(3) {
                bins[(0..23).filter(|k| v[axis] > f64::from(*k) / 4.0 - 2.75).count()] += 1.0;
            }
            bins
        };
        let [x, y, z] = [0, 1, 2].map(histogram);
        for bin in 0..24 {
            for (one, other) in [(x, y), (y, z), (z, x)] {
                // Counts are off by their roots.
                let allowed = 5.0 * (one[bin] + other[bin] + 1.0).sqrt();
                assert!((one[bin] - other[bin]).abs() <= allowed, "bin {bin}: {} {}", one[bin], other[bin]);
            }
        }
    }
}

#[test]
fn corners_near_each_other_have_nothing_in_common() {
    let noise = Noise::new(NoiseKind::Value, 3);
    let at = |p: DVec3| noise.value(p.floor());
    for step in
        CORNERS.into_iter().skip(1).map(vector).chain([DVec3::X * 2.0, DVec3::Y * 256.0, DVec3::new(1.0, -1.0, 0.0)])
    {
        assert_mean(points(POINTS / 4, 1e5).map(|p| at(p) * at(p + step)), 0.0, "a product of corners");
    }
    let square = |p: DVec3| [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::X + DVec3::Y].map(|d| at(p + d)).iter().product();
    assert_mean(points(POINTS / 4, 1e5).map(square), 0.0, "a product of four corners");
}

#[test]
fn every_gradient_is_drawn_equally_often() {
    let noise = Noise::new(NoiseKind::Gradient, 3);
    let mut drawn = [0.0_f64; 256];
    points(POINTS, 1e5).for_each(|p| drawn[Cell::new(p, &noise.keys).place([0, 0, 0])] += 1.0);
    let expected = POINTS as f64 / 256.0;
    // χ² of 255 degrees has the mean 255 and the variance 510.
    let chi_square: f64 = drawn.iter().map(|n| (n - expected).powi(2) / expected).sum();
    assert!((chi_square - 255.0).abs() < 5.0 * 510.0_f64.sqrt(), "{chi_square}");
}

#[test]
fn cubes_favour_no_direction_at_any_time() {
    for time in [0.0, 0.3, 1000.0] {
        let Table::Gradients(gradients) = Table::new(NoiseKind::Gradient, 5, time) else { panic!("gradients") };
        assert!(gradients.iter().sum::<DVec3>().length() < 1e-13);
        for (i, j, expected) in
            [(0, 0, 4.0 / 9.0), (1, 1, 4.0 / 9.0), (2, 2, 4.0 / 9.0), (0, 1, 0.0), (1, 2, 0.0), (2, 0, 0.0)]
        {
            let covariance = gradients.iter().map(|g| g[i] * g[j]).sum::<f64>() / 256.0;
            assert!((covariance - expected).abs() < 1e-14);
        }
        let Table::Values(values) = Table::new(NoiseKind::Value, 5, time) else { panic!("values") };
        assert!(values.iter().sum::<f64>().abs() < 1e-13);
        assert!((values.iter().map(|v| v * v).sum::<f64>() / 256.0 - 0.25).abs() < 1e-14);
    }
}

#[test]
fn the_gradient_is_that_of_the_differences() {
    const H: f64 = 1e-5;
    for kind in KINDS {
        let noise = Noise::new(kind, 12);
        for p in points(2000, 50.0) {
            let (value, slope) = noise.value_and_slope(p);
            assert!((value - noise.value(p)).abs() < 1e-15);
            let found = DVec3::AXES.map(|axis| (noise.value(p + axis * H) - noise.value(p - axis * H)) / (2.0 * H));
            assert!((DVec3::from_array(found) - slope).length() < 1e-8, "{found:?} {slope}");
        }
    }
}

#[test]
fn second_derivatives_go_on_across_the_faces_of_cells() {
    const H: f64 = 1e-6;
    for kind in KINDS {
        let noise = Noise::new(kind, 13);
        for p in points(1000, 50.0) {
            for (axis, step) in DVec3::AXES.iter().enumerate() {
                let mut face = p;
                face[axis] = p[axis].floor();
                let slope = |offset: f64| noise.value_and_slope(face + *step * offset).1;
                let (here, before, after) = (slope(0.0), slope(-H), slope(H));
                // The second derivatives are about 10, the third ones about 100.
                let jump = (after - here) / H - (here - before) / H;
                assert!(jump.length() < 1e-3, "{jump} at {face}");
            }
        }
    }
}

#[test]
fn time_stirs_without_a_jump() {
    for kind in KINDS {
        let at = |time: f64, p: DVec3| {
            let mut noise = Noise::new(kind, 14);
            noise.at_time(time);
            noise.value(p)
        };
        for (k, p) in (0..50).zip(points(50, 20.0)) {
            let time = f64::from(k) * 18.3;
            // No gradient turns by more than 1.5 radians in a unit of time, and none is longer than 2 / √3.
            assert!((at(time + 1e-4, p) - at(time, p)).abs() < 1.5 * 1.2 * 1e-4);
        }
        let moved = points(50, 20.0).map(|p| (at(1.0, p) - at(0.0, p)).abs()).fold(0.0, f64::max);
        assert!(moved > 0.1, "{moved}");
    }
}

#[test]
fn an_independent_program_comes_to_the_same_numbers() {
    // By a Python program of its own (products of weights instead of interpolation, matrices by the double cross product,
    // the library's sines), written from the description at the head of the file.
    let (g, v) = (NoiseKind::Gradient, NoiseKind::Value);
    for (kind, seed, time, p, expected) in [
        (g, 0, 0.0, [0.5, 0.25, 0.75], 0.316_306_220_419_163_8),
        (g, 7, 0.0, [-3.7, 12.1, 1000.3], -0.085_076_120_184_347_68),
        (g, u64::MAX, 0.0, [123_456.789, -0.001, -77.5], 0.173_214_807_316_797_7),
        (g, 7, 2.5, [-3.7, 12.1, 1000.3], 0.180_332_909_985_977_8),
        (g, 42, 900.0, [1.9, 2.8, -3.7], -0.233_665_144_599_949_05),
        (v, 0, 0.0, [0.5, 0.25, 0.75], 0.124_666_056_569_879_8),
        (v, 7, 0.0, [-3.7, 12.1, 1000.3], 0.235_599_069_463_584_1),
        (v, u64::MAX, 0.0, [123_456.789, -0.001, -77.5], 0.130_220_188_271_332_3),
        (v, 7, 2.5, [-3.7, 12.1, 1000.3], 0.001_162_929_308_603_863_4),
        (v, 42, 900.0, [1.9, 2.8, -3.7], -0.325_484_063_825_598_8),
    ] {
        let mut noise = Noise::new(kind, seed);
        noise.at_time(time);
        let found = noise.value(p.into());
        // Both round at every step, and angles of some hundred radians are themselves rounded to 10⁻¹³.
        let allowed = if time > 100.0 { 1e-12 } else { 1e-14 };
        assert!((found - expected).abs() <= allowed, "{kind:?} {seed} {time} {p:?}: {found} instead of {expected}");
    }
}

#[test]
fn gradient_noise_is_zero_at_the_points_of_the_lattice() {
    let noise = Noise::new(NoiseKind::Gradient, 1);
    assert!(points(1000, 1e6).all(|p| noise.value(p.round()) == 0.0));
}

#[test]
fn far_out_it_is_still_something() {
    for kind in KINDS {
        let noise = Noise::new(kind, 1);
        for x in [1e15, -1e16, 1e300, f64::MAX, f64::INFINITY, f64::NEG_INFINITY, f64::NAN, -0.0, 5e-324, -5e-324] {
            for p in [DVec3::splat(x), DVec3::new(0.5, x, 0.25), DVec3::new(x, 0.3, -x)] {
                let (value, slope) = noise.value_and_slope(p);
                assert!(value.abs() <= 1.0 && slope.is_finite() && noise.value(p) == value, "{kind:?} {p}: {value}");
                noise.told(p, &mut Kept::default());
            }
        }
    }
}

#[test]
fn its_working_holds_and_names_the_eight_corners() {
    for kind in KINDS {
        let noise = Noise::new(kind, 6);
        let mut kept = Kept::default();
        for p in points(200, 50.0) {
            assert_eq!(noise.told(p, &mut kept), noise.value(p));
        }
        assert_every_line_holds(&kept);
        for entry in &kept.0 {
            let What::Lattice(lattice) = &entry.what else { panic!("{entry:?}") };
            assert_eq!(lattice.corners.len(), 8);
            assert!((lattice.corners.iter().map(|corner| corner.weight).sum::<f64>() - 1.0).abs() < 1e-14);
            let low = lattice.corners[0].at;
            assert_eq!(low, DVec3::from_array(lattice.point).floor().to_array().map(whole));
            assert_eq!(lattice.corners[6].at, [low[0], low[1] + 1, low[2] + 1]);
        }
    }
}
