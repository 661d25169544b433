//! Pictures by every method: the record tells what the picture shows, the sure methods agree, and the others fail where they
//! are known to.

use rayscope::record::{NullRecorder, What};
use rayscope::scene::{Image, Profile, Scene, embedded_scene, embedded_scenes, load};
use rayscope::shape::{Method, Search};
use rayscope::texture::relief::BumpDerivative;
use rayscope::trace::{Picture, Progress, TreeRecorder, render, trace_pixel};

fn scene(name: &str) -> Scene {
    load(embedded_scene(name).unwrap().text, name).unwrap()
}

/// The scene with so many columns, in its own shape.
fn small(mut scene: Scene, width: u32) -> Scene {
    let height = (width * scene.image.height / scene.image.width).max(1);
    scene.image = Image { width, height };
    scene
}

fn by(method: Method) -> Profile {
    Profile { method: Some(method), ..Profile::STANDARD }
}

fn picture(scene: &Scene, profile: &Profile) -> Picture {
    render(&scene.with_profile(profile), &Progress::new()).0
}

/// The share of pixels in which a channel differs by more than `bound`.
fn differing(a: &Picture, b: &Picture, bound: f64) -> f64 {
    let pixels = (0..a.height).flat_map(|y| (0..a.width).map(move |x| (x, y)));
    let off = pixels.filter(|&(x, y)| (a.pixel(x, y) - b.pixel(x, y)).abs().max_element() > bound).count();
    off as f64 / f64::from(a.width * a.height)
}

#[test]
fn what_is_recorded_by_a_method_is_what_its_picture_shows() {
    for embedded in embedded_scenes() {
        let scene = small(scene(&embedded.name), 24);
        for method in Method::ALL {
            let scene = scene.with_profile(&by(method));
            for place in 0..4 {
                let [x, y] = [place * 7 % scene.image.width, (place * 5 + 3) % scene.image.height];
                let mut recorder = TreeRecorder::new();
                let recorded = trace_pixel(&scene, x, y, &mut recorder);
                let plain = trace_pixel(&scene, x, y, &mut NullRecorder);
                assert_eq!(recorded, plain, "{} by {} at {x},{y}", embedded.name, method.name());
            }
        }
    }
}

#[test]
fn sixteen_digits_with_a_certificate_show_what_thirty_two_show() {
    for embedded in embedded_scenes() {
        let scene = small(scene(&embedded.name), 40);
        let [adaptive, wide] = [Method::Adaptive, Method::DoubleDouble].map(|method| picture(&scene, &by(method)));
        // In hard scenes the last digit of a hit time turns normals, and edges pass exactly through pixels' centres.
        let (bound, most) = if embedded.name.starts_with("hard/") { (1e-4, 0.02) } else { (1e-6, 0.01) };
        let share = differing(&adaptive, &wide, bound);
        assert!(share <= most, "{}: {share}", embedded.name);
    }
}

#[test]
fn from_nearby_the_textbook_is_right_about_all_but_the_torus_and_the_superellipsoid() {
    // Of the torus it loses hits of rays that start on it.
    for name in ["sphere", "cube", "cone", "cylinder", "tapered_cylinder", "square", "plane", "convex_polyhedron"] {
        let scene = small(scene(&format!("primitives/{name}")), 60);
        let [adaptive, textbook] = [Method::Adaptive, Method::Textbook].map(|method| picture(&scene, &by(method)));
        let share = differing(&adaptive, &textbook, 1e-3);
        assert!(share < 0.001, "{name}: {share}");
    }
}

#[test]
fn single_precision_and_the_textbook_lose_the_far_torus_and_the_program_does_not() {
    let scene = small(scene("hard/far_torus"), 80);
    let exact = picture(&scene, &by(Method::DoubleDouble));
    let wrong = |method| differing(&exact, &picture(&scene, &by(method)), 0.02);
    assert!(wrong(Method::Single) > 0.02, "{}", wrong(Method::Single));
    assert!(wrong(Method::Textbook) > 0.05, "{}", wrong(Method::Textbook));
    assert_eq!([Method::Double, Method::Adaptive].map(wrong), [0.0; 2]);
}

#[test]
fn a_finer_search_loses_fewer_chords() {
    let scene = small(scene("primitives/superellipsoid"), 80);
    let certified = picture(&scene, &Profile::STANDARD);
    let lost = |stretches| {
        let search = Profile { search: Some(Search::Stretches(stretches)), ..Profile::STANDARD };
        differing(&certified, &picture(&scene, &search), 1e-3)
    };
    let shares = [4, 16, 64].map(lost);
    assert!(shares[0] > shares[1] && shares[1] >= shares[2] && shares[0] > 0.0, "{shares:?}");
}

#[test]
fn exact_bumps_differ_where_the_dropped_terms_count() {
    let scene = small(scene("textures/bumps"), 60);
    let exact = Profile { bump: Some(BumpDerivative::Exact), ..Profile::STANDARD };
    assert!(differing(&picture(&scene, &Profile::STANDARD), &picture(&scene, &exact), 1e-4) > 0.01);
}

#[test]
fn each_place_in_a_pixel_gets_as_many_points_on_the_lens_as_the_profile_says() {
    let scene = small(scene("lens/focus"), 24);
    let scene = scene.with_profile(&Profile { samples: Some(2), lens_samples: Some(3), ..Profile::STANDARD });
    let mut recorder = TreeRecorder::new();
    trace_pixel(&scene, 12, 9, &mut recorder);
    let places: Vec<[f64; 2]> = recorder
        .finish()
        .events
        .iter()
        .filter_map(|event| if let What::Sample(sample) = &event.what { Some(sample.at) } else { None })
        .collect();
    assert_eq!(places.len(), 6);
    assert!(places[0] == places[1] && places[1] == places[2] && places[2] != places[3] && places[3] == places[5]);
}
