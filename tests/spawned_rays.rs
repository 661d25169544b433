//! Spawned rays leave the surface that they started on, at every scale, and the media follow them.

use rayscope::accuracy::spawned::soak;
use rayscope::record::{RayKind, What};
use rayscope::scene::{Scene, load};
use rayscope::trace::{RayTree, record_pixel};

const MIRROR: &str = r#""mirror": {"ambient": [0,0,0], "diffuse": [0,0,0], "specular": [0,0,0], "reflectivity": 1}"#;
const GLASS: &str = r#""glass": {"ambient": [0,0,0], "diffuse": [0,0,0], "specular": [0,0,0], "transparency": 1,
                                  "index_of_refraction": 1.5}"#;

/// One object of the given size at the origin, seen from 6 sizes away; the object fills much of the picture.
fn scene(material: &str, name: &str, shape: &str, size: f64) -> Scene {
    let far = 6.0 * size;
    let text = format!(
        r#"{{
            "camera": {{"eye": [{far}, {far}, {half}], "look_at": [0, 0, 0], "up": [0, 0, 1], "field_of_view": 20}},
            "image": {{"width": 24, "height": 24}},
            "background": [0.25, 0.5, 0.75],
            "limits": {{"depth": 12, "contribution": 0}},
            "materials": {{{material}}},
            "objects": [{{{shape}, "material": "{name}", "transform": [{{"scale": {size}}}]}}]
        }}"#,
        half = far / 2.0
    );
    load(&text, "test").unwrap_or_else(|errors| panic!("{errors}"))
}

fn trees(scene: &Scene) -> impl Iterator<Item = RayTree> {
    let (width, height) = (scene.image.width, scene.image.height);
    (0..height).flat_map(move |y| (0..width).map(move |x| record_pixel(scene, x, y)))
}

fn rays_of(tree: &RayTree, kind: RayKind) -> usize {
    tree.events.iter().filter(|event| matches!(event.what, What::Ray { ray, .. } if ray == kind)).count()
}

/// Convex solids: a mirrored ray goes straight to the background.
const CONVEX: [&str; 6] = [
    r#""shape": "sphere""#,
    r#""shape": "cube""#,
    r#""shape": "cylinder""#,
    r#""shape": "cone""#,
    r#""shape": "superellipsoid", "n": 3, "m": 4"#,
    r#""shape": "tapered_cylinder", "s": 1.7"#,
];

#[test]
fn a_convex_mirror_never_sees_itself_at_any_scale() {
    for shape in CONVEX {
        for size in [1e-9, 1e-4, 1.0, 1e6, 1e9] {
            let scene = scene(MIRROR, "mirror", shape, size);
            let mut mirrored = 0;
            for tree in trees(&scene) {
                let reflected = rays_of(&tree, RayKind::Reflected);
                assert!(reflected <= 1, "{shape} of size {size}: a mirrored ray hit its own surface");
                mirrored += reflected;
                assert_eq!(tree.colour(), [0.25, 0.5, 0.75], "{shape} of size {size}");
            }
            assert!(mirrored > 50, "{shape} of size {size}: only {mirrored} pixels hit it");
        }
    }
}

#[test]
fn a_ray_through_a_convex_glass_enters_and_leaves_in_turn_at_any_scale() {
    for shape in CONVEX {
        for size in [1e-9, 1.0, 1e9] {
            let scene = scene(GLASS, "glass", shape, size);
            for tree in trees(&scene) {
                let media: Vec<(String, String)> = tree
                    .events
                    .iter()
                    .filter_map(|event| match &event.what {
                        What::Medium { before, after, .. } => Some((before.clone(), after.clone())),
                        _ => None,
                    })
                    .collect();
                let Some((first, rest)) = media.split_first() else { continue };
                assert_eq!(first.0, "air", "{shape} of size {size}: the ray comes from outside");
                assert_ne!(first.1, "air", "{shape} of size {size}: the ray goes in");
                // From then on the ray is inside, until it leaves; what is totally reflected stays inside.
                for crossing in rest {
                    assert_eq!((&crossing.0, crossing.1.as_str()), (&first.1, "air"), "{shape} of size {size}");
                }
                assert!(!rest.is_empty(), "{shape} of size {size}: the far side was lost");
            }
        }
    }
}

#[test]
fn a_thin_shell_keeps_both_its_sides() {
    let plate = r#""shape": "intersection", "of": [
        {"shape": "plane", "transform": [{"translate": [0, 0, 1e-13]}]},
        {"shape": "plane", "transform": [{"rotate": {"axis": [1, 0, 0], "degrees": 180}}]}]"#;
    let mut seen = 0;
    for tree in trees(&scene(GLASS, "glass", plate, 1.0)) {
        let through = rays_of(&tree, RayKind::Refracted);
        if through > 0 {
            assert_eq!(through, 2, "in on one side and out on the other");
            seen += 1;
        }
    }
    assert!(seen > 100);
}

/// The long version runs for hours, if asked to: `cargo bench --bench spawned_rays -- --rays 1e8`.
#[test]
fn no_spawned_ray_hits_the_surface_that_it_left_or_loses_another() {
    let soak = soak(1, 0..40_000, || false, |_| {}).unwrap();
    let total = soak.total();
    assert!(total.judged > 15_000 && total.not_judged * 1_000 < total.judged, "{total:?}");
    assert_eq!((total.self_hits, total.leaks), (0, 0), "{:#?}", soak.mishaps);
}
