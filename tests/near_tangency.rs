//! Rays that pass a curved surface, or go through it, by a hair: from a tenth of the solid's size down to 10⁻¹⁵ of it, from
//! distances of 1 to 10⁸. And pairs of solids that overlap by a hair.

#[path = "independent/mod.rs"]
mod reference;

use glam::DVec3;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use rayscope::csg::IntervalList;
use rayscope::record::{NullRecorder, Sense};
use rayscope::scene::compile_solid;
use rayscope::shape::{Crossing, Shape};
use reference::big::Line;
use reference::exact::Exact;
use reference::random::Random;
use reference::rays::surface_point;
use reference::{determined, doubt, solids, solve};
use serde_json::{Value, json};
use std::f64::consts::TAU;

/// A line that would touch the surface in a point, if it were not moved by a gap.
#[derive(Clone, Copy, Debug)]
struct Graze {
    /// Which point of the surface.
    point: u64,
    /// Which tangent.
    turn: f64,
    /// The gap is ten to this power.
    gap: f64,
    /// The distance is ten to this power.
    distance: f64,
    /// The direction has the length two to this power.
    length: i32,
}

/// The point, its outward normal and the tangent.
struct Place {
    point: DVec3,
    normal: DVec3,
    tangent: DVec3,
}

impl Graze {
    fn place(&self, solid: &Exact) -> Place {
        let (point, normal) = surface_point(solid, &mut Random(self.point));
        let (sin, cos) = self.turn.sin_cos();
        let first = normal.any_orthonormal_vector();
        Place { point, normal, tangent: first * cos + normal.cross(first) * sin }
    }

    /// The ray whose line runs at the distance `outside` from the surface, beneath it where that is negative.
    fn ray(&self, place: &Place, outside: f64) -> (DVec3, DVec3) {
        let back = place.tangent * 10.0_f64.powf(self.distance);
        (place.point + place.normal * outside - back, place.tangent * f64::from(self.length).exp2())
    }
}

fn grazes() -> impl Strategy<Value = Graze> {
    (any::<u64>(), 0.0..TAU, -15.0..-1.0, 0.0..8.0, -40..40).prop_map(|(point, turn, gap, distance, length)| Graze {
        point,
        turn,
        gap,
        distance,
        length,
    })
}

fn curved() -> Vec<(Shape, Exact)> {
    let tapered = [0.0, 0.4, 1.0, 2.5].map(solids::tapered);
    let tori = [0.3, 1.0, 1.6, 40.0].map(solids::torus);
    let convex = [(2.0, 4.0), (1.5, 3.0)].map(|(n, m)| solids::superellipsoid(n, m));
    let other = [(0.5, 0.5), (0.5, 2.0), (4.0, 0.5)].map(|(n, m)| solids::superellipsoid(n, m));
    [vec![solids::sphere()], tapered.to_vec(), tori.to_vec(), convex.to_vec(), other.to_vec()].concat()
}

fn alternate(crossings: &[Crossing]) -> bool {
    crossings.len().is_multiple_of(2)
        && crossings.windows(2).all(|pair| pair[0].t < pair[1].t && pair[0].sense != pair[1].sense)
        && crossings.first().is_none_or(|first| first.sense == Sense::Enter)
}

/// The curvature of the surface along the tangent, where the chord's length tells it: positive, and not next to nothing.
fn curvature(solid: &Exact, place: &Place) -> Option<f64> {
    let around = DVec3::new(-place.point.y, place.point.x, 0.0).normalize();
    let share = place.tangent.dot(around).powi(2);
    let from_axis = place.point.truncate().length();
    let curvature = match solid {
        Exact::Sphere => 1.0,
        // Meusnier: the circle about the axis has the curvature 1 / radius, seen askew.
        Exact::Tapered(_) => share * place.normal.truncate().length() / from_axis,
        Exact::Torus(d) => share * (from_axis - d) / from_axis + (1.0 - share),
        _ => return None,
    };
    (curvature > 0.1).then_some(curvature)
}

/// Whether the surface bends as it does at the point for the length of the chord, and ends nowhere near.
fn is_plain(solid: &Exact, place: &Place, half: f64) -> bool {
    let from_axis = place.point.truncate().length();
    match solid {
        Exact::Tapered(_) => {
            let to_disc = place.point.z.min(1.0 - place.point.z);
            half < 0.1 * from_axis && half * place.tangent.z.abs() * 1.5 < to_disc
        }
        Exact::Torus(_) => half < 0.03 * from_axis.min(1.0),
        _ => true,
    }
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 160,
        rng_seed: RngSeed::Fixed(1),
        failure_persistence: None,
        ..ProptestConfig::default()
    })]

    #[test]
    fn a_graze_is_a_hit_or_a_miss_as_its_gap_says_and_never_odd(graze in grazes(), within in any::<bool>()) {
        for (shape, solid) in curved() {
            let place = graze.place(&solid);
            let gap = 10.0_f64.powf(graze.gap);
            let (origin, direction) = graze.ray(&place, if within { -gap } else { gap });
            let found = solve::<f64>(&shape, origin, direction);
            prop_assert!(alternate(&found), "{:?}: S = {:?}, c = {:?}: {:?}", shape, origin, direction, found);
            let line = Line::new(origin, direction);
            if let Some(exact) = determined(&solid, &line, doubt(origin)) {
                prop_assert_eq!(found.len(), exact.len(), "{:?}: S = {:?}, c = {:?}: {:?}", shape, origin, direction, found);
            }
        }
    }

    #[test]
    fn a_shallow_chord_is_as_long_as_the_curvature_says(graze in grazes()) {
        for (shape, solid) in curved() {
            let place = graze.place(&solid);
            let depth = 10.0_f64.powf(graze.gap).min(1e-3);
            let (origin, direction) = graze.ray(&place, -depth);
            let Some(curvature) = curvature(&solid, &place).filter(|_| depth > 100.0 * doubt(origin)) else { continue };
            let half = (2.0 * depth / curvature).sqrt();
            if !is_plain(&solid, &place, half) {
                continue;
            }
            let expected = 10.0_f64.powf(graze.distance) / direction.length();
            let chord = solve::<f64>(&shape, origin, direction)
                .chunks_exact(2)
                .map(|pair| (pair[1].t - pair[0].t, 0.5 * (pair[0].t + pair[1].t)))
                .min_by(|a, b| (a.1 - expected).abs().total_cmp(&(b.1 - expected).abs()));
            let length = chord.map_or(0.0, |(length, _)| length * direction.length());
            prop_assert!(
                (length / (2.0 * half) - 1.0).abs() < 0.08,
                "{:?}: S = {:?}, c = {:?}: a chord of {:e} for {:e}", shape, origin, direction, length, 2.0 * half
            );
        }
    }

    #[test]
    fn going_deeper_into_a_convex_solid_never_loses_its_hits(graze in grazes(), share in 0.0..1.0) {
        for (shape, solid) in curved() {
            let convex = match solid {
                Exact::Sphere | Exact::Planes(_) => true,
                Exact::Tapered(s) => s > 0.0,
                Exact::Torus(_) => false,
                Exact::Super(n, m) => n >= 1.0 && m >= 1.0,
            };
            if !convex {
                continue;
            }
            let place = graze.place(&solid);
            let deep = 10.0_f64.powf(graze.gap);
            let [deeper, shallower] = [deep, deep * share].map(|depth| graze.ray(&place, -depth));
            if deep * (1.0 - share) < 2.0 * doubt(deeper.0) {
                continue;
            }
            let [deeper, shallower] = [deeper, shallower].map(|(origin, direction)| solve::<f64>(&shape, origin, direction));
            prop_assert!(deeper.len() >= shallower.len(), "{:?}: {:?}: {:?} {:?}", shape, graze, deeper, shallower);
        }
    }

    #[test]
    fn two_balls_that_overlap_by_a_hair_share_a_lens(pair in pairs()) {
        check_pair(&json!({"shape": "sphere"}), &pair, 0.0)?;
    }

    #[test]
    fn two_boxes_that_overlap_by_a_hair_share_a_plate(pair in pairs(), slant in 0.0..0.4) {
        check_pair(&json!({"shape": "cube"}), &pair, slant)?;
    }
}

/// Two copies of a solid of width 2, side by side, with an overlap, turned and looked at along the line of their centres.
#[derive(Clone, Debug)]
struct Pair {
    overlap: f64,
    distance: f64,
    axis: DVec3,
    degrees: f64,
}

fn pairs() -> impl Strategy<Value = Pair> {
    let axis = (-1.0..1.0, -1.0..1.0, 0.2..1.0).prop_map(|(x, y, z)| DVec3::new(x, y, z));
    (-15.0..-1.0, any::<bool>(), 0.0..6.0, axis, 0.0..360.0).prop_map(|(size, apart, distance, axis, degrees)| Pair {
        overlap: 10.0_f64.powf(size) * if apart { -1.0 } else { 1.0 },
        distance: 10.0_f64.powf(distance),
        axis,
        degrees,
    })
}

fn inside(solid: &Value, (origin, direction): (DVec3, DVec3)) -> IntervalList {
    compile_solid(solid).unwrap().inside::<f64>(origin, direction, &mut NullRecorder)
}

fn lengths(list: &IntervalList) -> Vec<f64> {
    list.intervals().map(|span| span.leave.unwrap().t - span.enter.unwrap().t).collect()
}

fn check_pair(shape: &Value, pair: &Pair, slant: f64) -> Result<(), TestCaseError> {
    let turn = json!({"rotate": {"axis": pair.axis.to_array(), "degrees": pair.degrees}});
    let mut near = shape.clone();
    near["transform"] = json!([turn]);
    let mut far = shape.clone();
    far["transform"] = json!([{"translate": [2.0 - pair.overlap, 0, 0]}, turn]);
    let rotation = glam::DQuat::from_axis_angle(pair.axis.normalize(), pair.degrees.to_radians());
    let direction = rotation * DVec3::new(1.0, slant, 0.3 * slant).normalize();
    let ray = (rotation * DVec3::X - direction * pair.distance, direction);
    let along = pair.overlap / (rotation * DVec3::X).dot(direction);
    // What the two solids say of the places where the first is left and the second entered.
    let [first, second] = [&near, &far].map(|solid| inside(solid, ray).intervals().next().unwrap());
    let doubt = first.leave.unwrap().error + second.enter.unwrap().error + 4.0 * f64::EPSILON * pair.distance;
    prop_assert!(doubt < 64.0 * f64::EPSILON * (pair.distance + 3.0), "{:?}: {}", pair, doubt);
    let [both, either, rest] = ["intersection", "union", "difference"]
        .map(|operator| lengths(&inside(&json!({"shape": operator, "of": [near, far]}), ray)));
    for spans in [&both, &either, &rest] {
        prop_assert!(spans.iter().all(|length| *length > 0.0), "{:?}: {:?}", pair, spans);
    }
    if along > doubt {
        prop_assert_eq!((both.len(), either.len(), rest.len()), (1, 1, 1), "{:?}", pair);
        prop_assert!((both[0] - along).abs() < doubt, "{:?}: {}", pair, both[0]);
    } else if along < -doubt {
        prop_assert_eq!((both.len(), either.len(), rest.len()), (0, 2, 1), "{:?}", pair);
    } else {
        prop_assert!(both.len() < 2 && [1, 2].contains(&either.len()) && rest.len() == 1, "{:?}", pair);
    }
    Ok(())
}
