//! Pictures of the hard kinds, where other ray tracers go wrong, against exact answers: not one pixel may differ.
//!
//! The exact answers are worked out in `hard/` with 256 binary digits from the very numbers that the program is given:
//! the pixel's ray and the placements. A pixel whose answer changes when these numbers change by half a unit in the
//! last place has no answer; such pixels are counted apart, and there may be a handful of them at most.

mod hard;

use hard::picture::{Case, View, assert_exact, scene};
use hard::set::{Part, Sets, Surface, cube, part, tapered_cylinder};
use hard::superellipsoid::SuperellipsoidAlone;
use hard::torus::TorusAlone;
use hard::truth::Truth;
use serde_json::{Value, json};

/// In most pictures no pixel is undetermined. A few may be where a row of pixels runs along an edge.
const HANDFUL: usize = 8;

const ABOVE: View = View::new([3.0, -5.0, 4.0], [0.0, 0.0, 0.0], 34.0);

fn case(name: &str, view: View, objects: &[Value], truth: impl Truth + 'static) -> Case {
    Case { name: name.to_owned(), scene: scene(view, objects), truth: Box::new(truth) }
}

/// A shape with a material and a transform.
fn solid(shape: &str, material: usize, transform: &Value) -> Value {
    json!({"shape": shape, "material": material.to_string(), "transform": transform})
}

fn compound(operator: &str, of: &[Value], transform: &Value) -> Value {
    json!({"shape": operator, "of": of, "transform": transform})
}

/// The pose as it is, and turned by an angle that has no exact matrix.
fn poses() -> [(&'static str, Value); 2] {
    [("plain", json!([])), ("rotated", json!([{"rotate": {"axis": [1, 2, 3], "degrees": 37}}]))]
}

#[test]
fn a_sphere_intersected_with_itself_is_the_sphere() {
    for (name, pose) in poses() {
        let balls = [0, 1].map(|k| solid("sphere", k, &json!([{"scale": 1.3}])));
        let truth = Sets::one(part(0, vec![Surface::Ball]));
        let object = compound("intersection", &balls, &pose);
        assert_exact(&case(&format!("S ∩ S, {name}"), ABOVE, &[object], truth), HANDFUL);
    }
}

#[test]
fn a_sphere_united_with_itself_is_the_sphere() {
    for (name, pose) in poses() {
        let balls = [0, 1].map(|k| solid("sphere", k, &json!([{"scale": 1.3}])));
        let truth = Sets::one(part(0, vec![Surface::Ball]));
        assert_exact(&case(&format!("S ∪ S, {name}"), ABOVE, &[compound("union", &balls, &pose)], truth), HANDFUL);
    }
}

#[test]
fn nothing_is_left_of_a_solid_without_itself() {
    let shapes = [
        json!({"shape": "sphere"}),
        json!({"shape": "cube"}),
        json!({"shape": "torus", "d": 2}),
        json!({"shape": "superellipsoid", "n": 0.5, "m": 0.5}),
        json!({"shape": "superellipsoid", "n": 4, "m": 4}),
        json!({"shape": "cone"}),
        json!({"shape": "cylinder"}),
    ];
    for (name, pose) in poses() {
        for shape in &shapes {
            let mut shape = shape.clone();
            shape["material"] = json!("0");
            let object = compound("difference", &[shape.clone(), shape.clone()], &pose);
            let name = format!("A − A of {shape}, {name}");
            assert_exact(&case(&name, ABOVE, &[object], Sets::empty()), 0);
        }
    }
}

#[test]
fn boxes_that_only_touch_have_nothing_in_common() {
    for (name, pose) in poses() {
        for size in [1.0, 0.7] {
            let sides = [(0, -size), (1, size)];
            let boxes = sides.map(|(k, x)| solid("cube", k, &json!([{"scale": size}, {"translate": [x, 0, 0]}])));
            let object = compound("intersection", &boxes, &pose);
            assert_exact(&case(&format!("touching boxes, {name}"), ABOVE, &[object], Sets::empty()), 0);
        }
    }
}

#[test]
fn boxes_that_touch_unite_without_a_seam() {
    let boxes = [-1.0, 1.0].map(|x| solid("cube", 0, &json!([{"translate": [x, 0, 0]}])));
    let sides = [(0, 1.0, 3.0), (0, -1.0, 1.0), (1, 1.0, 1.0), (1, -1.0, 1.0), (2, 1.0, 1.0), (2, -1.0, 1.0)];
    let surfaces = sides.map(|(axis, sign, offset)| Surface::Side { axis, sign, offset }).to_vec();
    for (name, pose) in poses() {
        let object = compound("union", &boxes, &pose);
        let truth = Sets::one(part(0, surfaces.clone()));
        assert_exact(&case(&format!("united boxes, {name}"), ABOVE, &[object], truth), HANDFUL);
    }
}

#[test]
fn a_pipe_is_open_at_both_ends() {
    for (name, pose) in poses() {
        for bore in [0.5, 0.7] {
            let outer = solid("cylinder", 0, &json!([]));
            let inner = solid("cylinder", 1, &json!([{"scale": [bore, bore, 1]}]));
            let truth = Sets::difference(part(0, tapered_cylinder(1.0)), part(1, vec![Surface::Wall { s: 1.0 }]));
            let object = compound("difference", &[outer, inner], &pose);
            let view = View::new([0.9, -1.5, 4.5], [0.0, 0.0, 0.5], 30.0);
            assert_exact(&case(&format!("pipe {bore}, {name}"), view, &[object], truth), HANDFUL);
        }
    }
}

#[test]
fn a_notch_cut_flush_leaves_no_skin() {
    let inwards = [(0, -1.0), (1, 1.0), (2, -1.0)];
    let surfaces = inwards.map(|(axis, sign)| Surface::Side { axis, sign, offset: 1.0 }).to_vec();
    for (name, pose) in poses() {
        for size in [0.5, 0.3] {
            let rest = 1.0 - size;
            let cutter = json!([{"scale": size}, {"translate": [rest, -rest, rest]}]);
            let of = [solid("cube", 0, &json!([])), solid("cube", 1, &cutter)];
            let truth = Sets::difference(part(0, cube()), part(1, surfaces.clone()));
            let object = compound("difference", &of, &pose);
            assert_exact(&case(&format!("notch {size}, {name}"), ABOVE, &[object], truth), HANDFUL);
        }
    }
}

#[test]
fn a_cone_sunk_flush_leaves_no_skin() {
    let turned = |depth: f64| {
        json!([
            {"scale": [0.8, 0.8, depth]},
            {"rotate": {"axis": [1, 0, 0], "degrees": 180}},
            {"translate": [0, 0, 1]}
        ])
    };
    for (name, pose) in poses() {
        for depth in [0.5, 0.7] {
            let of = [solid("cylinder", 0, &json!([])), solid("cone", 1, &turned(depth))];
            let truth = Sets::difference(part(0, tapered_cylinder(1.0)), part(1, vec![Surface::Wall { s: 0.0 }]));
            let object = compound("difference", &of, &pose);
            let view = View::new([1.0, -2.0, 4.0], [0.0, 0.0, 0.5], 32.0);
            assert_exact(&case(&format!("countersink {depth}, {name}"), view, &[object], truth), HANDFUL);
        }
    }
}

#[test]
fn slivers_are_seen_however_thin() {
    for shift in [1e-2, 1e-6, 1e-10] {
        let of = [solid("sphere", 0, &json!([])), solid("sphere", 1, &json!([{"translate": [shift, 0, 0]}]))];
        let truth = Sets::difference(part(0, vec![Surface::Ball]), part(1, vec![Surface::Ball]));
        let view = View { size: [160, 120], ..View::new([-1.5, -6.0, 1.0], [0.0, 0.0, 0.0], 26.0) };
        let name = format!("sliver of {shift:e}");
        assert_exact(&case(&name, view, &[compound("difference", &of, &json!([]))], truth), HANDFUL);
    }
}

/// The shapes that pictures at other scales and places are made of, with what is known of them.
fn kinds() -> Vec<(&'static str, Value, Box<dyn Truth>)> {
    let one = |surfaces: Vec<Surface>| -> Box<dyn Truth> { Box::new(Sets::one(part(0, surfaces))) };
    let superellipsoid = |n: f64, m: f64| -> Box<dyn Truth> { Box::new(SuperellipsoidAlone { n, m }) };
    vec![
        ("sphere", json!({"shape": "sphere"}), one(vec![Surface::Ball])),
        ("cube", json!({"shape": "cube"}), one(cube())),
        ("cylinder", json!({"shape": "cylinder"}), one(tapered_cylinder(1.0))),
        ("cone", json!({"shape": "cone"}), one(tapered_cylinder(0.0))),
        ("tapered cylinder", json!({"shape": "tapered_cylinder", "s": 0.99}), one(tapered_cylinder(0.99))),
        ("torus", json!({"shape": "torus", "d": 2}), Box::new(TorusAlone { d: 2.0 })),
        ("hollow superellipsoid", json!({"shape": "superellipsoid", "n": 0.5, "m": 0.5}), superellipsoid(0.5, 0.5)),
        ("full superellipsoid", json!({"shape": "superellipsoid", "n": 6, "m": 6}), superellipsoid(6.0, 6.0)),
    ]
}

/// All kinds, each alone in a small picture, scaled and then moved together with the camera.
fn assert_all_kinds(scale: f64, place: [f64; 3]) {
    let at = |p: [f64; 3]| std::array::from_fn(|i| p[i] * scale + place[i]);
    let view = View { size: [160, 120], ..View::new(at([4.0, -6.5, 4.5]), at([0.0, 0.0, 0.2]), 40.0) };
    for (name, mut shape, truth) in kinds() {
        shape["material"] = json!("0");
        shape["transform"] =
            json!([{"rotate": {"axis": [1, -1, 2], "degrees": 25}}, {"scale": scale}, {"translate": place}]);
        let name = format!("{name} at scale {scale:e}, place {:e}", place[0]);
        assert_exact(&Case { name, scene: scene(view, &[shape]), truth }, HANDFUL);
    }
}

#[test]
fn pictures_at_tiny_scales_are_right() {
    for scale in [1e-6, 1e-5, 1e-3] {
        assert_all_kinds(scale, [0.0; 3]);
    }
}

#[test]
fn pictures_at_huge_scales_are_right() {
    for scale in [1e4, 1e7, 1e8] {
        assert_all_kinds(scale, [0.0; 3]);
    }
}

#[test]
fn pictures_far_from_the_origin_are_right() {
    for place in [1e7, 1e8] {
        assert_all_kinds(1.0, [place, -place, place]);
    }
}

#[test]
fn tori_seen_from_afar_are_right() {
    for distance in [1e4, 1e6] {
        let eye = [0.6 * distance, -0.64 * distance, 0.48 * distance];
        let view = View::new(eye, [0.0; 3], 420.0 / distance);
        let torus = json!({"shape": "torus", "d": 2, "material": "0"});
        let thin = json!({"shape": "torus", "d": 40, "material": "0", "transform": [{"scale": 0.07}]});
        assert_exact(&case(&format!("torus at {distance:e}"), view, &[torus], TorusAlone { d: 2.0 }), HANDFUL);
        assert_exact(&case(&format!("thin torus at {distance:e}"), view, &[thin], TorusAlone { d: 40.0 }), HANDFUL);
    }
}

/// The field of view in degrees that shows `height` at `distance`.
fn field(height: f64, distance: f64) -> f64 {
    (height / distance).to_degrees()
}

#[test]
fn rays_that_graze_a_torus_hit_it_or_miss_it_as_they_should() {
    let torus = json!({"shape": "torus", "d": 2, "material": "0"});
    let looks = [
        ("top", [2.0, -6.0, 1.0], [2.0, 0.0, 1.0], [0.0, 0.0, 1.0]),
        ("outside", [3.0, -6.0, 0.25], [3.0, 0.0, 0.0], [1.0, 0.0, 0.0]),
        ("hole", [1.0, 0.5, -6.0], [1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]),
    ];
    for (name, eye, look_at, out) in looks {
        for (away, shown) in [(0.0, "half"), (1.2e-10, "missed")] {
            let moved = |p: [f64; 3]| std::array::from_fn(|i| p[i] + away * out[i]);
            let view = View { size: [64, 48], ..View::new(moved(eye), moved(look_at), field(1.6e-10, 6.0)) };
            let name = format!("torus grazed at its {name}, {shown}");
            assert_exact(&case(&name, view, std::slice::from_ref(&torus), TorusAlone { d: 2.0 }), HANDFUL);
        }
    }
}

#[test]
fn superellipsoids_of_all_exponents_are_right() {
    let all = [(50.0, 50.0), (8.0, 8.0), (4.0, 4.0), (2.0, 7.0), (1.5, 2.0), (0.5, 0.5), (0.2, 0.2)];
    for (n, m) in all {
        let shape = json!({"shape": "superellipsoid", "n": n, "m": m, "material": "0"});
        let view = View::new([2.0, -5.0, 1.7], [0.0; 3], 30.0);
        let truth = SuperellipsoidAlone { n, m };
        assert_exact(&case(&format!("superellipsoid {n}, {m}"), view, &[shape], truth), HANDFUL);
    }
}

#[test]
fn hits_on_the_heart_of_a_thorn_lie_on_its_surface() {
    let shape = json!({"shape": "superellipsoid", "n": 0.1, "m": 0.1, "material": "0", "transform": [{"scale": 600}]});
    let view = View { size: [160, 120], ..View::new([2.0, -5.0, 1.7], [0.0; 3], 2.5) };
    assert_exact(&case("heart of a thorn", view, &[shape], SuperellipsoidAlone { n: 0.1, m: 0.1 }), HANDFUL);
}

#[test]
fn rays_that_graze_a_superellipsoid_hit_it_or_miss_it_as_they_should() {
    for (n, m) in [(50.0, 50.0), (4.0, 4.0), (2.0, 7.0)] {
        let shape = json!({"shape": "superellipsoid", "n": n, "m": m, "material": "0"});
        for (eye, look_at) in [([-6.0, 0.0, 1.0], [0.0, 0.0, 1.0]), ([1.0, -6.0, 0.0], [1.0, 0.0, 0.0])] {
            let view = View { size: [64, 48], ..View::new(eye, look_at, field(2e-10, 6.0)) };
            let name = format!("superellipsoid {n}, {m} grazed from {eye:?}");
            assert_exact(&case(&name, view, std::slice::from_ref(&shape), SuperellipsoidAlone { n, m }), HANDFUL);
        }
    }
}

#[test]
fn the_apex_of_a_cone_is_right_in_a_field_of_a_millionth() {
    let slim = json!({"scale": [0.8, 0.7, 1]});
    let poses =
        [json!([slim]), json!([slim, {"rotate": {"axis": [0, 1, 0], "degrees": 30}}, {"translate": [-0.5, 0, 0.125]}])];
    for pose in poses {
        let cone = solid("cone", 0, &pose);
        let apex = scene(ABOVE, std::slice::from_ref(&cone)).objects[0].solid.leaves[0].placement.world_from_generic();
        let apex = apex.transform_point3(glam::DVec3::Z).to_array();
        for eye in [[apex[0] + 0.5, -6.0, apex[2]], [apex[0], -4.0, apex[2] + 3.5]] {
            let view = View { size: [160, 120], ..View::new(eye, apex, field(1e-6, 6.0)) };
            let truth = Sets::one(part(0, tapered_cylinder(0.0)));
            assert_exact(&case(&format!("apex from {eye:?}"), view, std::slice::from_ref(&cone), truth), HANDFUL);
        }
    }
}

#[test]
fn a_ray_between_two_balls_that_touch_hits_neither() {
    let balls = [-1.0, 1.0].map(|x| solid("sphere", 0, &json!([{"translate": [x, 0, 0]}])));
    let ball = |object: usize| Part { stands_as: [object, 0], material: 0, surfaces: vec![Surface::Ball] };
    let set = hard::set::Set::Either(Box::new(hard::set::Set::Part(0)), Box::new(hard::set::Set::Part(1)));
    let truth = Sets { parts: vec![ball(0), ball(1)], set };
    let view = View { size: [321, 241], ..View::new([0.0, -8.0, 0.0], [0.0; 3], 20.0) };
    let case = case("two balls", view, &balls, truth);
    // Only the ray through the very middle touches, and there the answer is a matter of the last bit.
    assert_exact(&case, 1);
    let middle = rayscope::trace::trace_pixel(&case.scene, 160, 120, &mut rayscope::record::NullRecorder);
    assert_eq!(middle, glam::DVec3::ZERO, "a touched ball is not hit");
}

#[test]
fn a_blade_is_hit_where_it_is_thinner_than_the_last_digit_of_a_hit_time() {
    // A ray that crosses a coordinate plane inside of |x|ⁿ + |z|ⁿ = 1 is inside the solid there, if only for 10⁻²⁰.
    let shape = |n: f64, scale: f64| json!({"shape": "superellipsoid", "n": n, "m": n, "material": "0", "transform": [{"scale": scale}]});
    let thorn = View { size: [160, 120], ..View::new([2.0, -5.0, 1.7], [0.0; 3], 30.0) };
    // Seen along y the outline of the other one is √x + √z = 1, which passes through (1/4, 1/4).
    let crease = View { size: [160, 120], ..View::new([0.25, -6.0, 0.25], [0.25, 0.0, 0.25], field(2e-10, 6.0)) };
    assert_exact(&case("thorn", thorn, &[shape(0.1, 600.0)], SuperellipsoidAlone { n: 0.1, m: 0.1 }), HANDFUL);
    assert_exact(&case("crease", crease, &[shape(0.5, 1.0)], SuperellipsoidAlone { n: 0.5, m: 0.5 }), 120);
}
