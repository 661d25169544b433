//! Tests of the side view: exact areas, nothing from the future, no colliding texts.

use super::section::section;
use super::*;
use crate::csg::{Leaf, Placement, Solid};
use crate::record::Operator;
use crate::scene::{embedded_scene, embedded_scenes, load};
use crate::shape::{Cube, Cylinder, Plane, Shape, Sphere, Torus};
use crate::trace::record_pixel;
use crate::view::{Frame, Text};
use glam::{DAffine3, DVec3};

/// Looks along y at the xz plane, 40 points for a unit, the origin in the middle of 400 × 300 points.
fn view() -> PlaneView {
    let [across, up] = [DVec3::X, DVec3::Z];
    PlaneView { origin: DVec3::ZERO, across, up, normal: across.cross(up), scale: 40.0, centre: [200.0, 150.0] }
}

const CANVAS: Frame = Frame { low: [0.0, 0.0], high: [400.0, 300.0] };

fn solid(shape: Shape, placement: DAffine3) -> Solid {
    Solid::leaf(Leaf::new("it", shape, Placement::new(placement).unwrap()))
}

/// The area in square units, by Gauss's formula.
fn area(rings: &[Vec<Spot>]) -> f64 {
    let twice = |ring: &Vec<Spot>| {
        let next = ring.iter().cycle().skip(1);
        ring.iter().zip(next).map(|(a, b)| a[0] * b[1] - b[0] * a[1]).sum::<f64>().abs()
    };
    rings.iter().map(twice).sum::<f64>() / 2.0 / (40.0 * 40.0)
}

fn assert_area(solid: &Solid, expected: f64) {
    let got = area(&section(solid, &view(), CANVAS).rings);
    assert!((got - expected).abs() < 2e-3 * expected, "{got} instead of {expected}");
}

#[test]
fn sections_have_the_areas_that_geometry_gives_them() {
    let pi = std::f64::consts::PI;
    let sphere = || solid(Shape::Sphere(Sphere::new().unwrap()), DAffine3::IDENTITY);
    assert_area(&sphere(), pi);
    assert_area(&solid(Shape::Cube(Cube::new().unwrap()), DAffine3::IDENTITY), 4.0);
    // A cube turned by 45° about z is cut along a diagonal.
    let turned = DAffine3::from_axis_angle(DVec3::Z, std::f64::consts::FRAC_PI_4);
    assert_area(&solid(Shape::Cube(Cube::new().unwrap()), turned), 2.0 * 8.0_f64.sqrt());
    // A torus about z shows two discs of radius 1.
    assert_area(&solid(Shape::Torus(Torus::new(2.0).unwrap()), DAffine3::IDENTITY), 2.0 * pi);
    // A shell: the unit ball without the ball of half its size.
    let inner = solid(Shape::Sphere(Sphere::new().unwrap()), DAffine3::from_scale(DVec3::splat(0.5)));
    assert_area(&Solid::pair("shell", Operator::Difference, sphere(), inner), 0.75 * pi);
}

#[test]
fn a_box_is_outlined_by_its_four_sides_alone() {
    let cube = solid(Shape::Cube(Cube::new().unwrap()), DAffine3::IDENTITY);
    let section = section(&cube, &view(), CANVAS);
    let length = |line: &Vec<Spot>| line.windows(2).map(|w| (w[0][0] - w[1][0]).hypot(w[0][1] - w[1][1])).sum::<f64>();
    let total: f64 = section.outline.iter().map(length).sum();
    assert!((total - 8.0 * 40.0).abs() < 0.1, "{total}");
    for &[x, y] in section.outline.iter().flatten() {
        let (dx, dy) = ((x - 200.0).abs(), (y - 150.0).abs());
        assert!((dx.max(dy) - 40.0).abs() < 0.02, "{x} {y}");
    }
}

#[test]
fn where_two_solids_join_no_seam_is_outlined() {
    // Two balls that overlap: the union's outline has no line within either.
    let ball = |x: f64| solid(Shape::Sphere(Sphere::new().unwrap()), DAffine3::from_translation(DVec3::X * x));
    let both = Solid::pair("both", Operator::Union, ball(-0.6), ball(0.6));
    for &[x, y] in section(&both, &view(), CANVAS).outline.iter().flatten() {
        let (x, z) = ((x - 200.0) / 40.0, (150.0 - y) / 40.0);
        let nearest = (x - 0.6).hypot(z).min((x + 0.6).hypot(z));
        assert!(nearest > 0.995, "({x}, {z}) lies within");
    }
}

#[test]
fn an_unbounded_solid_fills_its_side_of_the_canvas() {
    let ground = solid(Shape::Plane(Plane::new().unwrap()), DAffine3::IDENTITY);
    let rings = section(&ground, &view(), CANVAS).rings;
    let covers = |at: Spot| {
        let mut drawing = Drawing::new([400.0, 300.0], Theme::Light.palette().ground);
        drawing.put(Form::Area { rings: rings.clone(), fill: Theme::Light.palette().left }, 1);
        drawing.event_at(at, 1.0).is_some()
    };
    assert!(covers([1.0, 299.0]) && covers([399.0, 151.0]));
    assert!(!covers([1.0, 149.0]) && !covers([399.0, 1.0]));
}

#[test]
fn a_thin_slice_lies_where_it_is_however_thin() {
    // A cylinder of radius 2 and height 1/160: a quarter of a point.
    let placement = DAffine3::from_scale(DVec3::new(2.0, 2.0, 1.0 / 160.0));
    let slice = solid(Shape::Cylinder(Cylinder::new().unwrap()), placement);
    let section = section(&slice, &view(), CANVAS);
    assert!(section.rings.iter().flatten().all(|[_, y]| (149.0..151.0).contains(y)));
}

#[test]
fn places_of_the_drawing_and_points_of_the_plane_belong_together() {
    let view = view();
    assert_eq!(view.spot(DVec3::new(1.0, 7.0, 2.0)), [240.0, 70.0]);
    assert_eq!(view.world([240.0, 70.0]), DVec3::new(1.0, 0.0, 2.0));
    assert!((view.distance(DVec3::new(1.0, 7.0, 2.0)) - 280.0).abs() < 1e-9);
}

fn recorded(name: &str) -> (Scene, RayTree) {
    let scene = load(embedded_scene(name).unwrap().text, name).unwrap();
    let [x, y] = scene.pixels[0];
    let tree = record_pixel(&scene, x, y);
    (scene, tree)
}

#[test]
fn the_camera_ray_lies_in_the_plane_and_floors_lie_level() {
    let (scene, tree) = recorded("csg/bowl");
    let plane = side_view_plane(&scene, &tree, 0, &SideViewOptions::default());
    let flights = Flights::of(&tree);
    assert!(plane.normal.dot(flights.all[0].direction).abs() < 1e-12);
    assert!(plane.distance(flights.all[0].origin) < 1e-9);
    assert_eq!(plane.up, DVec3::Z);
    assert!(plane.across.dot(flights.all[0].direction) > 0.0);
}

#[test]
fn the_plane_of_incidence_holds_ray_and_normal() {
    let (scene, tree) = recorded("optics/glass_cube");
    for event in &tree.events {
        let What::Hit { n_geometric, .. } = &event.what else { continue };
        let options = SideViewOptions { plane: SectionPlane::Incidence, ..Default::default() };
        let plane = side_view_plane(&scene, &tree, event.id, &options);
        let direction = Flights::of(&tree).ray_of(event.id).direction;
        assert!(plane.normal.dot(direction.normalize()).abs() < 1e-9);
        let across = DVec3::from_array(*n_geometric).cross(direction.normalize());
        assert!(across.length() < 1e-6 || plane.normal.dot(DVec3::from_array(*n_geometric)).abs() < 1e-9);
    }
}

#[test]
fn nothing_is_drawn_before_it_happens() {
    let (scene, tree) = recorded("optics/glass_ball");
    for step in (0..tree.end()).step_by(7) {
        let drawing = side_view(&scene, &tree, step, &SideViewOptions::default());
        assert!(drawing.marks.iter().filter_map(|mark| mark.event).all(|event| event <= step), "at {step}");
    }
}

#[test]
fn a_click_on_the_hit_finds_it() {
    let (scene, tree) = recorded("csg/bowl");
    let options = SideViewOptions::default();
    let hit = tree.events.iter().find(|event| matches!(event.what, What::Hit { .. })).unwrap();
    let What::Hit { point, .. } = &hit.what else { unreachable!() };
    let at = side_view_plane(&scene, &tree, hit.id, &options).spot(DVec3::from_array(*point));
    assert_eq!(side_view(&scene, &tree, hit.id, &options).event_at(at, 4.0), Some(hit.id));
}

#[test]
fn zoom_enlarges_and_pan_shifts() {
    let (scene, tree) = recorded("csg/bowl");
    let plain = SideViewOptions::default();
    let plane = side_view_plane(&scene, &tree, 0, &plain);
    let changed = side_view_plane(&scene, &tree, 0, &SideViewOptions { zoom: 2.0, pan: [30.0, -5.0], ..plain });
    assert!((changed.scale - 2.0 * plane.scale).abs() < 1e-9);
    let shifted = side_view_plane(&scene, &tree, 0, &SideViewOptions { pan: [30.0, -5.0], ..plain });
    let [before, after] = [plane, shifted].map(|plane| plane.spot(DVec3::ONE));
    assert!((after[0] - before[0] - 30.0).abs() < 1e-9 && (after[1] - before[1] + 5.0).abs() < 1e-9);
}

/// Whether no text covers another and none is cut off.
fn assert_readable(drawing: &Drawing, what: &str) {
    let texts: Vec<(Frame, &Text)> = drawing.texts().map(|text| (text.frame(), text)).collect();
    for (i, (frame, text)) in texts.iter().enumerate() {
        assert!(drawing.frame().holds(frame), "{what}: “{}” is cut off", text.text);
        for (other, below) in &texts[..i] {
            assert!(!frame.overlaps(other), "{what}: “{}” covers “{}”", text.text, below.text);
        }
    }
}

#[test]
fn texts_never_collide_and_are_never_cut_off() {
    for embedded in embedded_scenes() {
        let (scene, tree) = recorded(&embedded.name);
        for size in [[420.0, 300.0], [1200.0, 700.0]] {
            for step in (0..tree.end()).rev().step_by(tree.events.len() / 5 + 1) {
                let what = format!("{} at {step} in {size:?}", embedded.name);
                for plane in [SectionPlane::RayAndUp, SectionPlane::Incidence] {
                    let options = SideViewOptions { size, plane, ..Default::default() };
                    assert_readable(&side_view(&scene, &tree, step, &options), &what);
                }
                for drawing in [
                    crate::view::interval_bars(&tree, step, size, Theme::Dark),
                    crate::view::sign_plot(&tree, step, size, Theme::Light),
                ] {
                    if let Some(drawing) = &drawing {
                        assert_readable(drawing, &what);
                    }
                }
            }
        }
    }
}

#[test]
fn strange_sizes_zooms_and_steps_do_no_harm() {
    let (scene, tree) = recorded("csg/bowl");
    let sizes = [[f64::NAN, 100.0], [0.0, 0.0], [1.0, 5_000.0]];
    let zooms = [f64::NAN, 0.0, -1.0, 1e300];
    for size in sizes {
        for zoom in zooms {
            let options = SideViewOptions { size, zoom, pan: [f64::INFINITY, 1e9], ..Default::default() };
            let drawing = side_view(&scene, &tree, EventId::MAX, &options);
            assert!(drawing.texts().all(|text| drawing.frame().holds(&text.frame())));
        }
    }
}
