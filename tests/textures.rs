//! What surfaces carry, through whole scenes: where look-ups happen, what they are told, and that nothing else pays for them.

use glam::{DMat3, DVec2, DVec3};
use rayscope::record::{Effect, What};
use rayscope::scene::{Image, Scene, load};
use rayscope::trace::{Progress, RayTree, record_pixel, render};

fn scene(text: &str) -> Scene {
    load(text, "textures/test").unwrap_or_else(|errors| panic!("{errors}"))
}

fn embedded(name: &str) -> Scene {
    let found = rayscope::scene::embedded_scene(name).unwrap_or_else(|| panic!("no scene {name}"));
    load(found.text, name).unwrap_or_else(|errors| panic!("{errors}"))
}

fn found<T>(tree: &RayTree, pick: impl Fn(&What) -> Option<T>) -> Vec<T> {
    tree.events.iter().filter_map(|event| pick(&event.what)).collect()
}

fn hits(tree: &RayTree) -> Vec<(DVec3, String)> {
    found(tree, |what| match what {
        What::Hit { point, leaf, .. } => Some((DVec3::from_array(*point), leaf.clone())),
        _ => None,
    })
}

/// The effects of surfaces, as against those of cameras, lights and media.
const SURFACES: [Effect; 6] =
    [Effect::Details, Effect::ImageTextures, Effect::SolidTextures, Effect::Bumps, Effect::Frames, Effect::Environment];

#[test]
fn a_scene_is_charged_for_what_it_carries_and_for_nothing_else() {
    for (name, expected) in [
        ("textures/wood", Effect::SolidTextures),
        ("textures/every_surface", Effect::ImageTextures),
        ("textures/details", Effect::Details),
        ("textures/environment", Effect::Environment),
    ] {
        let mut scene = embedded(name);
        scene.image = Image { width: 32, height: 24 };
        let (_, tally) = render(&scene, &Progress::new());
        for effect in SURFACES {
            assert_eq!(tally.calls(effect) > 0, effect == expected, "{name}: {}", effect.name());
        }
    }
}

/// A block with a hollow, both moved and turned, whose material is wood.
#[test]
fn the_grain_runs_through_a_cut_in_the_space_of_the_block() {
    let scene = embedded("textures/carved_block");
    let mut leaves = std::collections::BTreeSet::new();
    for [x, y] in [[320, 262], [215, 250], [262, 158], [420, 300], [340, 220]] {
        let tree = record_pixel(&scene, x, y);
        let point = found(&tree, |what| match what {
            What::Texture(texture) => Some(DVec3::from_array(texture.point)),
            _ => None,
        });
        let (hit, leaf) = hits(&tree)[0].clone();
        // The block stands at (0, 0, 1), and its texture at (0, 0.4, −0.9) in the block.
        assert!((point[0] - (hit - DVec3::Z - DVec3::new(0.0, 0.4, -0.9))).length() < 1e-12, "{x}, {y}");
        leaves.insert(leaf);
    }
    assert!(leaves.len() >= 2, "only {leaves:?} were hit");
}

const MIRROR: &str = r#"{
  "camera": {"eye": [0.3, -3, 2], "look_at": [0.1, 0.2, 0.4], "field_of_view": 50},
  "image": {"width": 64, "height": 48},
  "lights": [{"directional": [0, -1, 3]}],
  "materials": {
    "tiles": {"texture": {"kind": "image", "file": "checker.png", "uv_from_st": [[4, 1, 0.5], [-1, 3, 0]]}},
    "mirror": {"ambient": [0,0,0], "diffuse": [0,0,0], "reflectivity": 1}
  },
  "objects": [
    {"shape": "plane", "name": "floor", "material": "tiles"},
    {"shape": "square", "name": "mirror", "material": "mirror",
     "transform": [{"scale": [1.5, 1, 1]}, {"rotate": {"axis": [1, 0, 0], "degrees": 80}}, {"translate": [0, 1, 1]}]}
  ]
}"#;

/// Where the line from `eye` through `towards` meets z = 0.
fn on_the_floor(eye: DVec3, direction: DVec3) -> DVec2 {
    (eye - direction * (eye.z / direction.z)).truncate()
}

#[test]
fn a_pixels_footprint_on_a_plane_is_exact_and_so_is_the_one_seen_in_a_flat_mirror() {
    let scene = scene(MIRROR);
    let (camera, image) = (scene.camera, scene.image);
    // The mirror's plane, for the picture of the eye behind it.
    let normal = DMat3::from_rotation_x(80.0_f64.to_radians()) * DVec3::Z;
    let behind = |v: DVec3, at: DVec3| v - normal * (2.0 * normal.dot(v - at));
    let (mut straight, mut mirrored) = (0, 0);
    for (x, y) in (0..48).flat_map(|y| (0..64).map(move |x| (x, y))) {
        let tree = record_pixel(&scene, x, y);
        let mappings = found(&tree, |what| match what {
            What::Mapping(mapping) => Some(mapping.clone()),
            _ => None,
        });
        let Some(mapping) = mappings.first().filter(|mapping| mapping.off_the_surface == 0) else { continue };
        let in_mirror = hits(&tree)[0].1 == "mirror";
        *(if in_mirror { &mut mirrored } else { &mut straight }) += 1;
        let [left, top] = [f64::from(x), f64::from(y)];
        let corners = [[left, top], [left + 1.0, top], [left + 1.0, top + 1.0], [left, top + 1.0]];
        for ([x, y], footprint) in corners.into_iter().zip(&mapping.footprint) {
            let direction = camera.ray_direction(image, x, y);
            let (eye, direction) = if in_mirror {
                (behind(camera.eye, DVec3::new(0.0, 1.0, 1.0)), direction - normal * (2.0 * normal.dot(direction)))
            } else {
                (camera.eye, direction)
            };
            let uv = on_the_floor(eye, direction);
            // u = 4 s + t + ½, v = 3 t − s, solved for s and t; 16 × 16 texels, rows downwards.
            let [u, v] = [uv.x - 0.5, uv.y];
            let (s, t) = ((3.0 * u - v) / 13.0, (u + 4.0 * v) / 13.0);
            let expected = DVec2::new(16.0 * s, 16.0 * (1.0 - t));
            let far = 1.0 + expected.length();
            assert!(
                (DVec2::from_array(*footprint) - expected).length() < 1e-9 * far,
                "{x}, {y}: {footprint:?}, {expected}"
            );
        }
    }
    assert!(straight > 500 && mirrored > 100, "{straight} pixels straight, {mirrored} in the mirror");
}

#[test]
fn a_detail_takes_precedence_at_every_pixel_of_it_and_at_no_other() {
    let text = r#"{
      "camera": {"eye": [2.5, -4, 1.5], "look_at": [0, 0, 0], "field_of_view": 40},
      "image": {"width": 120, "height": 90},
      "materials": {"wall": {}, "paint": {"diffuse": [1, 0, 0]}, "dot": {"diffuse": [0, 1, 0]}},
      "objects": [{"shape": "square", "name": "wall", "material": "wall",
        "transform": [{"rotate": {"axis": [1, 0, 0], "degrees": 90}}],
        "details": [{"polygon": [[0.1, 0.2], [0.9, 0.1], [0.5, 0.95]], "material": "paint",
          "details": [{"polygon": [[0.4, 0.3], [0.6, 0.3], [0.6, 0.5], [0.4, 0.5]], "material": "dot"}]}]}]
    }"#;
    let scene = scene(text);
    let mut seen = std::collections::BTreeMap::new();
    for (x, y) in (0..90).flat_map(|y| (0..120).map(move |x| (x, y))) {
        let tree = record_pixel(&scene, x, y);
        let Some((hit, _)) = hits(&tree).first().cloned() else { continue };
        let (u, v) = (0.5 * (hit.x + 1.0), 0.5 * (hit.z + 1.0));
        let side = |a: [f64; 2], b: [f64; 2]| (b[0] - a[0]) * (v - a[1]) - (b[1] - a[1]) * (u - a[0]);
        let (a, b, c) = ([0.1, 0.2], [0.9, 0.1], [0.5, 0.95]);
        let in_triangle = side(a, b) > 0.0 && side(b, c) > 0.0 && side(c, a) > 0.0;
        let in_square = (0.4..0.6).contains(&u) && (0.3..0.5).contains(&v);
        let expected = if in_square {
            "dot"
        } else if in_triangle {
            "paint"
        } else {
            "wall"
        };
        let material = found(&tree, |what| match what {
            What::Hit { material, .. } => Some(material.clone()),
            _ => None,
        });
        assert_eq!(material[0], expected, "{x}, {y}");
        *seen.entry(expected).or_insert(0) += 1;
    }
    assert!(seen.values().all(|count| *count > 50) && seen.len() == 3, "{seen:?}");
}

#[test]
fn marble_is_stirred_by_the_frame_and_only_by_it() {
    let mut marble = embedded("textures/marble");
    marble.image = Image { width: 48, height: 48 };
    let at = |frame: f64| render(&marble.clone().at_frame(frame), &Progress::new()).0;
    let frames = [1.0, 225.0, 450.0, 900.0].map(at);
    for (i, first) in frames.iter().enumerate() {
        for second in &frames[i + 1..] {
            assert_ne!(first, second);
        }
    }
    assert_eq!(frames[1], at(225.0), "the way to a frame does not count");
    // From one frame to the next hardly anything moves.
    let bytes = |frame: f64| at(frame).to_rgb8();
    let moved =
        |a: &[u8], b: &[u8]| a.iter().zip(b).map(|(a, b)| f64::from(a.abs_diff(*b))).sum::<f64>() / a.len() as f64;
    let (near, far) = (moved(&bytes(225.0), &bytes(226.0)), moved(&bytes(225.0), &bytes(450.0)));
    assert!(near < 0.1 * far && far > 5.0, "{near} in one frame, {far} in 225");
}

#[test]
fn what_is_wrong_with_a_texture_is_said_with_its_place() {
    for (material, place, message) in [
        (r#""texture": {"kind": "image", "file": "gone.png"}"#, "materials.m.texture.file", "gone.png"),
        (r#""texture": {"kind": "image", "file": "image_map.json"}"#, "materials.m.texture.file", "image_map.json"),
        (
            r#""texture": {"kind": "image", "file": "checker.png", "uv_from_st": [[1, 2, 0], [2, 4, 0]]}"#,
            "materials.m.texture.uv_from_st",
            "cannot be undone",
        ),
        (r#""texture": {"kind": "marbel"}"#, "materials.m.texture.kind", "unknown kind `marbel`"),
        (r#""texture": {"kind": "wood", "axis": [0, 0, 0]}"#, "materials.m.texture.axis", "axis"),
        (r#""texture": {"kind": "noise", "size": 0}"#, "materials.m.texture.size", "more than 0"),
        (
            r#""texture": {"kind": "noise", "stops": [{"at": 0.5, "colour": [0,0,0]}, {"at": 0, "colour": [1,1,1]}]}"#,
            "materials.m.texture.stops",
            "ascend",
        ),
        (r#""mirrors": "environment""#, "materials.m.mirrors", "the scene has none"),
    ] {
        let text = format!(r#"{{"materials": {{"m": {{{material}}}}}}}"#);
        let errors = load(&text, "textures/test").expect_err(material).to_string();
        assert!(errors.contains(place) && errors.contains(message), "{material}\n{errors}");
    }
}

#[test]
fn what_is_wrong_with_a_detail_is_said_with_its_place() {
    let polygon = r#""polygon": [[0, 0], [1, 0], [1, 1]]"#;
    for (shape, detail, message) in [
        ("sphere", format!(r#"{polygon}, "material": "m""#), "no flat part"),
        ("cube", format!(r#"{polygon}, "material": "m""#), "does not say which part"),
        ("cube", format!(r#"{polygon}, "material": "m", "part": "tap""#), "unknown part `tap`"),
        ("cylinder", format!(r#"{polygon}, "material": "m", "part": "wall""#), "`wall` is not flat"),
        ("square", format!(r#"{polygon}, "material": "n""#), "unknown material `n`"),
        ("square", r#""polygon": [[0, 0], [1, 0]], "material": "m""#.to_owned(), "3 or more"),
        ("square", format!(r#"{polygon}, "material": "glass""#), "cannot be transparent"),
    ] {
        let text = format!(
            r#"{{"materials": {{"m": {{}}, "glass": {{"transparency": 1}}}},
            "objects": [{{"shape": "{shape}", "material": "m", "details": [{{{detail}}}]}}]}}"#
        );
        let errors = load(&text, "test").expect_err(&detail).to_string();
        assert!(errors.contains("objects[0].details") && errors.contains(message), "{detail}\n{errors}");
    }
    let compound = r#"{"materials": {"m": {}}, "objects": [{"shape": "union", "material": "m", "of": [{"shape": "cube"}],
        "details": [{"polygon": [[0, 0], [1, 0], [1, 1]], "material": "m"}]}]}"#;
    let errors = load(compound, "test").unwrap_err().to_string();
    assert!(errors.contains("no faces of its own"), "{errors}");
}
