//! Tests of the lines in space: they lie on the surfaces, are cut where a solid ends, and show its edges.

use super::*;
use crate::csg::Placement;
use crate::record::Operator;
use crate::scene::{embedded_scenes, load};
use crate::shape::{Cube, Sphere};
use glam::DAffine3;

fn leaf(shape: Shape, placement: DAffine3) -> Solid {
    Solid::leaf(Leaf::new("it", shape, Placement::new(placement).unwrap()))
}

fn ball(x: f64) -> Solid {
    leaf(Shape::Sphere(Sphere::new().unwrap()), DAffine3::from_translation(DVec3::X * x))
}

fn points(lines: &[WireLine], is_crease: bool) -> Vec<DVec3> {
    lines.iter().filter(|line| line.is_crease == is_crease).flat_map(|line| line.points.clone()).collect()
}

#[test]
fn two_balls_meet_in_the_circle_that_geometry_gives_them() {
    // Unit balls about x = ±0.6 meet where x = 0, on a circle of radius 0.8.
    for operator in [Operator::Union, Operator::Intersection, Operator::Difference] {
        let lines = solid_lines(0, &Solid::pair("both", operator, ball(-0.6), ball(0.6)), 1_000);
        let edge = points(&lines, true);
        assert!(edge.len() > 40, "{operator:?}: {} points", edge.len());
        for point in &edge {
            assert!(point.x.abs() < 1e-6 && (point.y.hypot(point.z) - 0.8).abs() < 1e-6, "{operator:?}: {point}");
        }
        // All the way round: no stretch of the circle is longer than a twelfth of it.
        let mut angles: Vec<f64> = edge.iter().map(|point| point.z.atan2(point.y)).collect();
        angles.sort_by(f64::total_cmp);
        let gaps = angles.windows(2).map(|pair| pair[1] - pair[0]);
        assert!(gaps.fold(0.0, f64::max) < std::f64::consts::TAU / 12.0, "{operator:?}");
    }
}

#[test]
fn lines_within_another_part_are_cut_off() {
    let lines = solid_lines(0, &Solid::pair("both", Operator::Union, ball(-0.6), ball(0.6)), 1_000);
    for point in points(&lines, false) {
        let [left, right] = [-0.6, 0.6].map(|x| point.distance(DVec3::X * x));
        assert!((left.min(right) - 1.0).abs() < 1e-6, "{point} lies on no ball, or within one");
    }
    let cut = solid_lines(0, &Solid::pair("both", Operator::Difference, ball(-0.6), ball(0.6)), 1_000);
    for point in points(&cut, false) {
        let [left, right] = [-0.6, 0.6].map(|x| point.distance(DVec3::X * x));
        assert!((left - 1.0).abs().min((right - 1.0).abs()) < 1e-6, "{point}");
        assert!(left <= 1.0 + 1e-6 && right >= 1.0 - 1e-6, "{point}");
    }
}

#[test]
fn nothing_is_shown_of_a_solid_without_itself_and_of_two_equal_ones_together_all_of_one() {
    let alone = solid_lines(0, &ball(0.0), 1_000).iter().map(|line| line.points.len()).sum::<usize>();
    for (operator, count) in
        [(Operator::Difference, 0), (Operator::Union, 2 * alone), (Operator::Intersection, 2 * alone)]
    {
        let lines = solid_lines(0, &Solid::pair("both", operator, ball(0.0), ball(0.0)), 1_000);
        assert_eq!(points(&lines, false).len(), count, "{operator:?}");
    }
}

#[test]
fn normals_point_out_of_the_solid_even_where_it_is_hollowed() {
    let hollow = leaf(Shape::Sphere(Sphere::new().unwrap()), DAffine3::from_scale(DVec3::splat(0.5)));
    let shell = Solid::pair("shell", Operator::Difference, ball(0.0), hollow);
    for line in solid_lines(0, &shell, 1_000) {
        for (point, [normal, _]) in line.points.iter().zip(&line.normals) {
            let out = if point.length() > 0.75 { 1.0 } else { -1.0 };
            assert!(normal.dot(point.normalize()) * out > 0.99, "{point} {normal}");
        }
    }
}

#[test]
fn an_edge_of_a_cube_has_the_normals_of_both_faces() {
    let lines = solid_lines(0, &leaf(Shape::Cube(Cube::new().unwrap()), DAffine3::IDENTITY), 1_000);
    let all: Vec<[DVec3; 2]> = lines.iter().flat_map(|line| line.normals.clone()).collect();
    assert!(!all.is_empty());
    for [first, second] in all {
        assert!(first.dot(second).abs() < 0.01, "{first} {second}");
    }
}

/// Thorns are so thin that the rounding of a place changes F by more than the bound; the other two were not held to it.
const LEFT_OUT: [&str; 3] = ["hard/thorns", "hard/tiny_scale", "hard/touching_boxes"];

#[test]
fn every_point_of_the_lines_lies_on_its_object() {
    for embedded in embedded_scenes().into_iter().filter(|scene| !LEFT_OUT.contains(&scene.name.as_str())) {
        // Scenes that read pictures beside them have the shapes of others.
        let Ok(scene) = load(embedded.text, &embedded.name) else { continue };
        let leaves: usize = scene.objects.iter().map(|object| object.solid.leaves.len()).sum();
        // Of more leaves the boxes are shown, whose edges lie on nothing.
        if leaves > MOST_POINTS / FEWEST_POINTS {
            continue;
        }
        let wires = Wireframe::of(&scene);
        assert!(wires.len() <= 4 * MOST_POINTS, "{}: {} points", embedded.name, wires.len());
        for line in wires.lines.iter().filter(|line| !line.is_crease) {
            let membership = Membership::of(&scene.objects[line.object].solid);
            for point in line.points.iter().step_by(5) {
                // |F| / |∇F| is how far the point lies off the surface: at most a millionth of the leaf's size, and where the
                // leaf is hardly larger than the spacing of numbers around it, a few of their last places.
                let lies_on = |leaf: usize| {
                    let scale = membership.scale(leaf);
                    let slope = (membership.gradient(leaf, *point).length() * scale).max(2.0);
                    let last_places = 4.0 * f64::EPSILON * point.length() / scale;
                    membership.value(leaf, *point).abs() <= (1e-6 + last_places) * slope
                };
                let count = membership.solid.leaves.len();
                assert!((0..count).any(lies_on), "{}: {point} lies on no surface", embedded.name);
            }
        }
    }
}
