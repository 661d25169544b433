//! Tests of the generic space: points on the surface, the same t as in the world, readable at every size.

use super::*;
use crate::record::What;
use crate::scene::{embedded_scene, embedded_scenes, load};
use crate::trace::record_pixel;
use crate::view::drawing::{Form, Mark};
use crate::view::readable::assert_readable;

fn recorded(name: &str) -> (Scene, RayTree, EventId) {
    let scene = load(embedded_scene(name).unwrap().text, name).unwrap();
    let [x, y] = scene.pixels[0];
    let tree = record_pixel(&scene, x, y);
    let hit = tree.events.iter().find(|event| matches!(event.what, What::Hit { .. })).map_or(0, |event| event.id);
    (scene, tree, hit)
}

fn shapes() -> Vec<String> {
    let all = embedded_scenes().into_iter().map(|scene| scene.name.clone());
    all.filter(|name| name.starts_with("primitives/") || name.starts_with("skewed/")).collect()
}

#[test]
fn what_is_marked_as_a_hit_lies_on_the_surface_and_is_the_worlds_hit() {
    for name in shapes() {
        let (scene, tree, hit) = recorded(&name);
        let at = PrimitiveAt::of(&scene, &tree, hit).unwrap();
        let What::Hit { t, generic_point, .. } = &tree.event(hit).what else { panic!("{name} is hit") };
        let nearest = at.hits().map(|other| (other - t).abs()).fold(f64::INFINITY, f64::min);
        assert!(nearest <= 1e-9 * t.abs().max(1.0), "{name}: the hit at {t} is none of the primitive's");
        let point = at.point(*t);
        assert!(point.distance(DVec3::from_array(*generic_point)) < 1e-9, "{name}: {point} {generic_point:?}");
        for t in at.hits() {
            assert!(at.d(t).abs() < 1e-6, "{name}: F = {} at t = {t}", at.d(t));
        }
    }
}

#[test]
fn normals_point_out_of_the_shape() {
    for name in shapes() {
        let (scene, tree, hit) = recorded(&name);
        let at = PrimitiveAt::of(&scene, &tree, hit).unwrap();
        for (_, candidate) in at.candidates().filter(|(_, candidate)| candidate.fate == CandidateFate::Accepted) {
            let point = DVec3::from_array(candidate.point);
            let normal = at.normal(candidate);
            assert!((normal.length() - 1.0).abs() < 1e-12, "{name}");
            let [within, beyond] = [-1e-4, 1e-4].map(|by| at.leaf.shape.implicit(point + normal * by));
            assert!(within < beyond, "{name} at {point}: {within} {beyond}");
        }
    }
}

#[test]
fn the_description_holds_the_ray_and_every_hit() {
    let (scene, tree, hit) = recorded("skewed/torus");
    let options =
        GenericViewOptions { size: [300.0, 200.0], theme: Theme::Light, look: GenericLook::Space, probe_t: Some(1.5) };
    let told = generic_view(&scene, &tree, hit, &options).unwrap().description;
    let at = PrimitiveAt::of(&scene, &tree, hit).unwrap();
    for t in at.hits() {
        assert!(told.contains(&format!("t = {}", format_number(t))), "{t}: {told}");
    }
    for part in [brief_vector(at.origin.to_array()), brief_vector(at.direction.to_array()), brief(at.d(1.5))] {
        assert!(told.contains(&part), "{part}: {told}");
    }
}

#[test]
fn nothing_covers_anything_at_any_size() {
    for name in shapes() {
        let (scene, tree, hit) = recorded(&name);
        for size in [[300.0, 200.0], [560.0, 360.0], [900.0, 600.0], [20.0, 20.0]] {
            for look in [GenericLook::Section, GenericLook::Space] {
                let options = GenericViewOptions { size, theme: Theme::Dark, look, probe_t: Some(5.0) };
                let drawing = generic_view(&scene, &tree, hit, &options).unwrap();
                assert_readable(&drawing, &format!("{name} in {size:?} as {look:?}"));
            }
        }
    }
}

#[test]
fn in_space_all_three_axes_of_a_cube_have_their_names() {
    let (scene, tree, hit) = recorded("primitives/cube");
    for size in [[400.0, 300.0], [300.0, 500.0]] {
        let options = GenericViewOptions { size, theme: Theme::Light, look: GenericLook::Space, probe_t: None };
        let drawing = generic_view(&scene, &tree, hit, &options).unwrap();
        for name in ["x", "y", "z"] {
            assert!(drawing.texts().any(|text| text.text == name), "{name} in {size:?}");
        }
    }
}

#[test]
fn a_tree_of_another_scene_shows_nothing() {
    let (_, tree, hit) = recorded("primitives/torus");
    let (other, ..) = recorded("primitives/cube");
    let options =
        GenericViewOptions { size: [300.0, 200.0], theme: Theme::Light, look: GenericLook::Space, probe_t: None };
    assert!(generic_view(&other, &tree, hit, &options).is_none());
}

#[test]
fn the_section_of_the_square_goes_from_edge_to_edge_through_the_place_of_the_hit() {
    let (scene, tree, hit) = recorded("primitives/square");
    let options =
        GenericViewOptions { size: [300.0, 300.0], theme: Theme::Light, look: GenericLook::Section, probe_t: None };
    let drawing = generic_view(&scene, &tree, hit, &options).unwrap();
    let primitive = PrimitiveAt::of(&scene, &tree, hit).unwrap().event;
    let inside = Theme::Light.palette().inside;
    let is_cut = |mark: &&Mark| {
        let Form::Line { points, stroke } = &mark.form else { return false };
        mark.event == Some(primitive) && stroke.colour == inside && points.len() == 2 && points[0] != points[1]
    };
    assert_eq!(drawing.marks.iter().filter(is_cut).count(), 1);
}
