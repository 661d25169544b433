//! One battery of properties for all shapes. The tests do not compile until each row in the list has its samples, which
//! stand with the tests in the shape's own file.

use super::testing::{Samples, Straight, record, solve};
use super::*;
use crate::math::DoubleDouble;
use crate::record::{CandidateFate, Sense, What};
use glam::{DVec2, DVec3};
use proptest::prelude::*;

macro_rules! all_samples {
    ($($variant:ident $name:literal $about:literal { $($parameter:ident : $type:ty = $doc:literal,)* })*) => {
        fn all_samples() -> Vec<Shape> {
            let mut all = Vec::new();
            $(all.extend(<$variant as Samples>::samples().into_iter().map(Shape::$variant));)*
            all
        }
    };
}

crate::for_each_shape!(all_samples);

/// The part of the shape's box that rays are aimed at.
fn target(shape: &Shape, place: DVec3) -> DVec3 {
    let Bounds { low, high } = shape.bounds();
    let (low, high) = (low.max(DVec3::splat(-2.0)), high.min(DVec3::splat(2.0)));
    low + (high - low) * place
}

fn is_solid(shape: &Shape) -> bool {
    !matches!(shape, Shape::Square(_))
}

fn is_bounded(shape: &Shape) -> bool {
    shape.bounds().low.is_finite()
}

/// Rays from all around, aimed into the box of the shape.
fn rays() -> impl Strategy<Value = (DVec3, DVec3)> {
    let triple = |low: f64, high: f64| prop::array::uniform3(low..high).prop_map(DVec3::from_array);
    (triple(-6.0, 6.0), triple(0.0, 1.0))
}

fn direction_to(shape: &Shape, origin: DVec3, place: DVec3) -> DVec3 {
    let direction = target(shape, place) - origin;
    if direction.length() > 1e-3 { direction } else { DVec3::X }
}

/// Asserts that the signs of F agree with the list of crossings.
fn check_signs(shape: &Shape, origin: DVec3, direction: DVec3, crossings: &[Crossing]) {
    let at = |t: f64| shape.implicit(origin + direction * t);
    let ends: Vec<f64> = crossings.iter().map(|hit| hit.t).collect();
    let mut probes = vec![];
    probes.extend(ends.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])));
    probes.extend(ends.first().map(|t| t - 0.1));
    probes.extend(ends.last().map(|t| t + 0.1));
    for t in probes {
        // Too near to a crossing F itself is rounding.
        if crossings.iter().any(|hit| (hit.t - t).abs() < 1e-7 + 100.0 * hit.error) {
            continue;
        }
        let before = crossings.iter().take_while(|hit| hit.t < t).last();
        let inside = match (before, crossings.first()) {
            (Some(hit), _) => hit.sense == Sense::Enter,
            (None, Some(first)) => first.sense == Sense::Leave,
            (None, None) => false,
        };
        assert_eq!(at(t) < 0.0, inside, "{shape:?} at t = {t}: F = {}", at(t));
    }
}

fn check_crossing(shape: &Shape, origin: DVec3, direction: DVec3, hit: &Crossing) {
    let point = origin + direction * hit.t;
    let normal = shape.normal(point, hit.part);
    assert!(normal.is_finite() && normal.length() > 0.0, "{shape:?}: normal {normal} at {point}");
    let uv = shape.uv(point, hit.part);
    let Bounds { low, high } = shape.bounds();
    let within = uv.cmpge(DVec2::ZERO).all() && uv.cmple(DVec2::ONE).all();
    assert!(within || !low.is_finite(), "{shape:?}: uv {uv} at {point}");
    let slack = DVec3::splat(1e-14 * (origin.length() + 2.0));
    assert!(point.cmpge(low - slack).all() && point.cmple(high + slack).all(), "{shape:?}: {point} is out of bounds");
    assert!(hit.error >= 0.0 && hit.error.is_finite(), "{shape:?}: error {}", hit.error);
    assert!(usize::from(hit.part) < shape.parts().len());
    // The ray goes against the normal where it enters, and with it where it leaves.
    let rate = normal.normalize().dot(direction.normalize());
    let expected = match hit.sense {
        Sense::Enter => rate < 1e-6,
        Sense::Leave => rate > -1e-6,
        Sense::Touch => true,
    };
    assert!(expected, "{shape:?}: {:?} at {point} with the normal {normal} and the ray {direction}", hit.sense);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn every_crossing_lies_on_the_surface_and_in_the_box((origin, place) in rays()) {
        for shape in all_samples() {
            let direction = direction_to(&shape, origin, place);
            for hit in solve::<f64>(&shape, origin, direction) {
                check_crossing(&shape, origin, direction, &hit);
            }
        }
    }

    #[test]
    fn tangents_move_u_and_v_each_alone_and_lie_in_the_surface((origin, place) in rays()) {
        const H: f64 = 1e-6;
        for shape in all_samples() {
            let direction = direction_to(&shape, origin, place);
            for hit in solve::<f64>(&shape, origin, direction) {
                let point = origin + direction * hit.t;
                let normal = shape.normal(point, hit.part).normalize();
                let tangents = shape.tangents(point, hit.part);
                prop_assert!(tangents.iter().all(|tangent| tangent.is_finite()), "{shape:?} at {point}: {tangents:?}");
                let lengths = tangents.map(DVec3::length);
                for (k, tangent) in tangents.iter().enumerate() {
                    prop_assert!(normal.dot(*tangent).abs() <= 1e-6 * lengths[k], "{shape:?} at {point}: {tangents:?}");
                    // Next to a pole, an apex or a crease a step would lead too far.
                    if lengths.iter().any(|length| !(0.1..30.0).contains(length)) {
                        continue;
                    }
                    let [before, after] = [-H, H].map(|h| shape.uv(point + *tangent * h, hit.part));
                    let moved = (after - before) / (2.0 * H);
                    let expected = if k == 0 { DVec2::X } else { DVec2::Y };
                    // At the ends of u and v they stop, or begin again.
                    let is_inside = |uv: DVec2| uv.cmpgt(DVec2::splat(1e-4)).all() && uv.cmplt(DVec2::splat(1.0 - 1e-4)).all();
                    let whole = is_inside(before) && is_inside(after);
                    prop_assert!(!whole || (moved - expected).length() < 1e-4, "{shape:?} at {point}: {moved}");
                }
            }
        }
    }

    #[test]
    fn the_first_crossing_ahead_is_the_first_of_all_that_lie_ahead((origin, place) in rays(), back in 0.0..2.0_f64) {
        for shape in all_samples() {
            let direction = direction_to(&shape, origin, place);
            // From far outside, from within, and from behind.
            for start in [origin, origin + direction, origin + direction * back] {
                let expected = solve::<f64>(&shape, start, direction).into_iter().find(|crossing| crossing.t > 0.0);
                prop_assert_eq!(shape.first_crossing::<f64>(&Straight(start, direction)), expected);
            }
        }
    }

    #[test]
    fn crossings_alternate_and_agree_with_the_sign_of_the_function((origin, place) in rays()) {
        for shape in all_samples().iter().filter(|shape| is_solid(shape)) {
            let direction = direction_to(shape, origin, place);
            let crossings = solve::<f64>(shape, origin, direction);
            for pair in crossings.windows(2) {
                prop_assert!(pair[0].t < pair[1].t && pair[0].sense != pair[1].sense);
            }
            if is_bounded(shape) {
                prop_assert_eq!(crossings.len() % 2, 0);
                prop_assert!(crossings.first().is_none_or(|hit| hit.sense == Sense::Enter));
            }
            if shape.is_convex() {
                prop_assert!(crossings.len() <= 2, "{shape:?} is not convex");
            }
            check_signs(shape, origin, direction, &crossings);
        }
    }

    #[test]
    fn the_reversed_ray_has_the_negated_times((origin, place) in rays()) {
        for shape in all_samples() {
            let direction = direction_to(&shape, origin, place);
            let forth = solve::<f64>(&shape, origin, direction);
            let back = solve::<f64>(&shape, origin, -direction);
            prop_assert_eq!(forth.len(), back.len());
            for (a, b) in forth.iter().zip(back.iter().rev()) {
                prop_assert!((a.t + b.t).abs() <= a.error + b.error, "{:?}: {:?} {:?}", shape, a, b);
                prop_assert!(a.sense != b.sense || a.sense == Sense::Touch);
            }
        }
    }

    #[test]
    fn a_direction_of_another_length_scales_the_times_exactly((origin, place) in rays(), power in -300..300_i32) {
        let factor = 2.0_f64.powi(power);
        for shape in all_samples() {
            let direction = direction_to(&shape, origin, place);
            let once = solve::<f64>(&shape, origin, direction);
            let scaled = solve::<f64>(&shape, origin, direction * factor);
            prop_assert_eq!(once.len(), scaled.len());
            for (a, b) in once.iter().zip(&scaled) {
                prop_assert_eq!(a.t, b.t * factor);
                prop_assert_eq!((a.sense, a.part), (b.sense, b.part));
            }
        }
    }

    #[test]
    fn more_digits_find_the_same_hits_within_the_stated_error((origin, place) in rays()) {
        for shape in all_samples() {
            let direction = direction_to(&shape, origin, place);
            let (double, wide) = (solve::<f64>(&shape, origin, direction), solve::<DoubleDouble>(&shape, origin, direction));
            prop_assert_eq!(double.len(), wide.len());
            for (a, b) in double.iter().zip(&wide) {
                prop_assert!((a.t - b.t).abs() <= a.error, "{:?}: {:?} {:?}", shape, a, b);
            }
        }
    }

    #[test]
    fn single_precision_keeps_the_rules((origin, place) in rays()) {
        for shape in all_samples().iter().filter(|shape| is_bounded(shape) && is_solid(shape)) {
            let crossings = solve::<f32>(shape, origin, direction_to(shape, origin, place));
            prop_assert_eq!(crossings.len() % 2, 0);
            prop_assert!(crossings.windows(2).all(|pair| pair[0].t < pair[1].t && pair[0].sense != pair[1].sense));
        }
    }

    #[test]
    fn watching_changes_nothing_and_the_last_report_holds_the_hits((origin, place) in rays()) {
        for shape in all_samples() {
            let direction = direction_to(&shape, origin, place);
            let (reports, watched) = record(&shape, origin, direction);
            prop_assert_eq!(&watched, &solve::<f64>(&shape, origin, direction));
            let Some(What::Roots { candidates }) = reports.last() else { panic!("{shape:?}: {reports:?}") };
            let accepted: Vec<_> = candidates.iter().filter(|c| c.fate == CandidateFate::Accepted).collect();
            prop_assert_eq!(accepted.len(), watched.len());
            for (candidate, hit) in accepted.iter().zip(&watched) {
                prop_assert_eq!((candidate.t, candidate.sense), (hit.t, hit.sense));
            }
            prop_assert!(candidates.iter().all(|candidate| !candidate.reason.is_empty()));
        }
    }
}

#[test]
fn numbers_at_the_ends_of_their_range_do_no_harm() {
    let sizes = [0.0, -0.0, 5e-324, 1e-300, 1e-160, 1e-8, 1.0, 1e8, 1e160, 1e300, f64::MAX];
    for shape in all_samples() {
        for (i, &size) in (0..11).map(f64::from).zip(&sizes) {
            for (j, &length) in (0..11).map(f64::from).zip(&sizes).filter(|(_, length)| **length > 0.0) {
                let origin = DVec3::new(size, 0.3 * size, -0.7 * size + j * 0.1);
                let direction = DVec3::new(-length, -0.3 * length + i * 1e-3 * length, 0.6 * length);
                let crossings = solve::<f64>(&shape, origin, direction);
                assert!(crossings.iter().all(|hit| hit.t.is_finite()), "{shape:?} {origin} {direction}: {crossings:?}");
                assert!(crossings.windows(2).all(|pair| pair[0].t <= pair[1].t));
                assert!(
                    !is_bounded(&shape) || !is_solid(&shape) || crossings.len().is_multiple_of(2),
                    "{shape:?} {origin} {direction}: {crossings:?}"
                );
            }
        }
    }
}

#[test]
fn the_sign_plot_agrees_with_the_function() {
    let (origin, direction) = (DVec3::new(3.0, 0.4, 0.3), DVec3::new(-1.0, -0.1, 0.02));
    for shape in all_samples() {
        let (reports, _) = record(&shape, origin, direction);
        let found = reports.iter().find_map(|what| match what {
            What::Implicit { samples, roots, signs, .. } => Some((samples, roots, signs)),
            _ => None,
        });
        let (samples, roots, signs) = found.expect("every shape shows its d(t)");
        assert_eq!(signs.len(), roots.len() + 1);
        assert_eq!(samples.len(), 65);
        for [t, d] in samples {
            let span = signs
                .iter()
                .find(|span| span.from.is_none_or(|from| from <= *t) && span.to.is_none_or(|to| *t <= to))
                .expect("the spans leave no gap");
            let expected = if *d > 0.0 { crate::record::Sign::Positive } else { crate::record::Sign::Negative };
            let near_root = roots.iter().any(|root| (root - t).abs() < 1e-9);
            assert!(near_root || span.sign == expected, "{shape:?}: d({t}) = {d}, {span:?}");
        }
    }
}

#[test]
fn outlines_lie_on_the_surface() {
    for shape in all_samples() {
        let outline = shape.outline();
        assert!(!outline.is_empty());
        for point in outline.iter().flatten() {
            assert!(shape.implicit(*point).abs() < 1e-9, "{shape:?}: F = {} at {point}", shape.implicit(*point));
        }
    }
}

#[test]
fn a_ray_from_outside_against_the_normal_hits_the_outline() {
    for shape in all_samples() {
        let smooth = matches!(shape, Shape::Plane(_) | Shape::Sphere(_) | Shape::Torus(_));
        if !smooth {
            continue;
        }
        for point in shape.outline().iter().flatten() {
            let normal = shape.normal(*point, 0).normalize();
            let crossings = solve::<f64>(&shape, *point + normal, -normal);
            let tip = matches!(shape, Shape::Torus(_)) && point.truncate().length() < 1e-6;
            assert!(
                tip || crossings.iter().any(|hit| (hit.t - 1.0).abs() < 1e-9),
                "{shape:?} at {point}: {crossings:?}"
            );
        }
    }
}

#[test]
fn a_ray_to_the_middle_of_a_star_shaped_solid_enters_at_its_outline() {
    for shape in all_samples() {
        if !is_bounded(&shape) || matches!(shape, Shape::Square(_) | Shape::Torus(_)) {
            continue;
        }
        let middle = (shape.bounds().low + shape.bounds().high) * 0.5;
        for point in shape.outline().concat() {
            let start = middle + (point - middle) * 2.0;
            let crossings = solve::<f64>(&shape, start, middle - start);
            let found = crossings.iter().any(|hit| (hit.t - 0.5).abs() < 1e-6 && hit.sense == Sense::Enter);
            assert!(found, "{shape:?} at {point}: {crossings:?}");
        }
    }
}

#[test]
fn names_are_those_of_the_list() {
    let names: Vec<_> = all_samples().iter().map(|shape| Shape::NAMES[shape.index()]).collect();
    for (shape, name) in all_samples().iter().zip(names) {
        assert_eq!(shape.name(), name);
    }
    for name in Shape::NAMES {
        assert!(all_samples().iter().any(|shape| shape.name() == *name), "{name} has no samples");
    }
}
