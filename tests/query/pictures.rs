//! Searches and surveys of whole pictures give what recording every pixel gives.

use rayscope::query::{Quantity, Query, scan, survey};
use rayscope::record::{RayKind, What};
use rayscope::scene::{Image, Scene, embedded_scene, load};
use rayscope::trace::{Progress, RayTree, record_pixel, render};
use rayscope::view::row;
use std::sync::Arc;
use std::time::Duration;

const SCENES: [&str; 11] = [
    "optics/fishbowl",
    "optics/fresnel",
    "optics/metals",
    "spectrum/prism",
    "media/smoke",
    "lens/focus",
    "textures/details",
    "textures/environment",
    "textures/bumps",
    "csg/lens",
    "lights/soft_shadows",
];

fn small(name: &str) -> Scene {
    let mut scene = load(embedded_scene(name).unwrap().text, name).unwrap();
    scene.image = Image { width: 13, height: 9 };
    scene
}

fn pixels(scene: &Scene) -> impl Iterator<Item = [u32; 2]> {
    let Image { width, height } = scene.image;
    (0..height).flat_map(move |y| (0..width).map(move |x| [x, y]))
}

#[test]
fn a_search_finds_what_recording_every_pixel_finds() {
    let questions = [
        "tir",
        "snell",
        "shadowed | dimmed",
        "reflected",
        "refracted & depth=1",
        "scattered | scatter",
        "wavelength | metal",
        "lens | sample",
        "texture | bump | detail",
        "environment",
        "kind=refracted & depth>=2",
        "kind=re* & hit",
        "depth!=0 & nothing",
        "theta1>40",
        "n1>1.2 | passes<1 | reflectance>0.1",
        "hit=nobody | refracted",
        "!refracted & ray",
        "has(tir) & step=5",
        "limit",
    ];
    let mut found = 0;
    for name in SCENES {
        let scene = small(name);
        let trees: Vec<_> = pixels(&scene).map(|[x, y]| ([x, y], record_pixel(&scene, x, y))).collect();
        for question in questions {
            let query = Query::parse(question).unwrap();
            let expected: Vec<_> = trees
                .iter()
                .filter_map(|(pixel, tree)| query.first(tree).map(|event| (*pixel, event, row(tree.event(event)))))
                .collect();
            let mut passes = 0;
            let search = scan(&scene, &query, 4, &Progress::new(), |_| passes += 1).unwrap();
            let got: Vec<_> = search.found.into_iter().map(|found| (found.pixel, found.event, found.row)).collect();
            assert_eq!(got, expected, "{question} in {name}");
            assert_eq!(passes, 3, "blocks of 4, of 2 and of 1");
            let marked: Vec<_> = search.grid.asked().filter(|(_, matches)| *matches).map(|(pixel, _)| pixel).collect();
            assert!(marked.into_iter().eq(expected.iter().map(|(pixel, ..)| *pixel)), "{question} in {name}");
            found += expected.len();
        }
    }
    assert!(found > 1000, "the questions are of what happens: {found}");
}

#[test]
fn the_sphere_is_found_where_geometry_says_that_it_is_seen() {
    let text = r#"{ "image": { "width": 41, "height": 41 },
        "camera": { "eye": [0, 0, 5], "look_at": [0, 0, 0], "up": [0, 1, 0], "field_of_view": 40 },
        "materials": { "clay": { "diffuse": [1, 1, 1] } },
        "objects": [ { "shape": "sphere", "name": "ball", "material": "clay" } ] }"#;
    let scene = load(text, "ball").unwrap_or_else(|errors| panic!("{errors}"));
    let search = scan(&scene, &Query::parse("hit=ball").unwrap(), 8, &Progress::new(), |_| {}).unwrap();
    // A ray at the angle α to the axis passes at 5 sin α from the middle.
    let half = 20_f64.to_radians().tan();
    let is_seen = |[x, y]: [u32; 2]| {
        let [a, b] = [x, y].map(|k| half * (2.0 * (f64::from(k) + 0.5) / 41.0 - 1.0));
        let tangent = a.hypot(b);
        5.0 * tangent / tangent.hypot(1.0) < 1.0
    };
    let expected: Vec<_> = pixels(&scene).filter(|&pixel| is_seen(pixel)).collect();
    assert!(expected.len() > 300);
    assert_eq!(search.found.iter().map(|found| found.pixel).collect::<Vec<_>>(), expected);
}

#[test]
fn a_search_that_is_cancelled_brings_nothing() {
    let progress = Progress::new();
    progress.cancel();
    let query = Query::parse("hit").unwrap();
    assert_eq!(scan(&small("csg/lens"), &query, 8, &progress, |_| {}), None);
}

fn values(scene: &Arc<Scene>, quantity: Quantity) -> Vec<f64> {
    survey(scene, quantity, 8, &|| Duration::ZERO, &Progress::new(), |_| {}).unwrap().values().collect()
}

#[test]
fn rays_and_tests_add_up_to_those_of_the_picture() {
    for name in SCENES {
        let scene = Arc::new(small(name));
        let (_, tally) = render(&scene, &Progress::new());
        let rays: u64 = RayKind::ALL.into_iter().map(|kind| tally.rays(kind)).sum();
        let tests: u64 = tally.extent_tests() + tally.shape_tests().into_iter().map(|(_, count)| count).sum::<u64>();
        assert_eq!(values(&scene, Quantity::Rays).iter().sum::<f64>(), rays as f64, "{name}");
        assert_eq!(values(&scene, Quantity::Tests).iter().sum::<f64>(), tests as f64, "{name}");
    }
}

fn deepest(tree: &RayTree) -> f64 {
    let depth = |what: &What| match what {
        What::Ray { ray, depth, .. } if *ray != RayKind::Shadow => Some(*depth),
        _ => None,
    };
    f64::from(tree.events.iter().filter_map(|event| depth(&event.what)).max().unwrap())
}

#[test]
fn depth_object_error_and_normal_are_those_of_the_recorded_rays() {
    // One ray a pixel, through its middle.
    for name in ["optics/fishbowl", "optics/metals", "csg/lens", "csg/bowl", "textures/bumps"] {
        let scene = Arc::new(small(name));
        let [depths, objects, errors] =
            [Quantity::Depth, Quantity::Object, Quantity::Error].map(|quantity| values(&scene, quantity));
        let normals = survey(&scene, Quantity::Normal, 1, &|| Duration::ZERO, &Progress::new(), |_| {}).unwrap();
        for (k, [x, y]) in pixels(&scene).enumerate() {
            let tree = record_pixel(&scene, x, y);
            assert_eq!(depths[k], deepest(&tree), "{name} {x},{y}");
            let first = Query::parse("hit & kind=camera").unwrap().first(&tree);
            let Some(What::Hit { object, t_error, n_geometric, .. }) = first.map(|id| &tree.event(id).what) else {
                assert!(objects[k].is_nan() && errors[k].is_nan(), "{name} {x},{y}");
                assert_eq!(normals.told(&scene, [x, y]).as_deref(), Some("nothing is hit"));
                continue;
            };
            let place = scene.objects.iter().position(|other| other.name == *object).unwrap();
            assert_eq!((objects[k], errors[k]), (place as f64, *t_error), "{name} {x},{y}");
            let told = format!("normal {}", rayscope::view::brief_vector(*n_geometric));
            assert_eq!(normals.told(&scene, [x, y]), Some(told), "{name} {x},{y}");
        }
    }
}

#[test]
fn every_survey_becomes_a_map_that_is_drawn_and_told() {
    let scene = Arc::new(small("optics/fishbowl"));
    for quantity in Quantity::ALL {
        let mut passes = 0;
        let clock = std::cell::Cell::new(0);
        let now = || {
            clock.set(clock.get() + 1);
            Duration::from_micros(clock.get())
        };
        let known = survey(&scene, quantity, 8, &now, &Progress::new(), |coarse| {
            passes += 1;
            assert_eq!(coarse.values().count(), 13 * 9);
        });
        let known = known.unwrap();
        assert_eq!(passes, 4, "{quantity:?}");
        let drawing = rayscope::view::heat_map(&known.map(&scene), [760.0, 480.0], rayscope::view::Theme::Light);
        assert!(drawing.description.contains("13 × 9 pixels"), "{}", drawing.description);
        assert!(known.told(&scene, [3, 3]).is_some() && known.told(&scene, [13, 0]).is_none());
    }
}
