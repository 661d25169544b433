//! Media against what is known of them: the exponential law, integrals of single scattering, and that fog which absorbs nothing
//! loses no light.

use glam::{DMat3, DVec3};
use rayscope::optics::HenyeyGreenstein;
use rayscope::record::{NullRecorder, RayKind, What};
use rayscope::sample::Stream;
use rayscope::scene::{Rgb, Scene, load};
use rayscope::trace::{Ray, Tally, Tracer, record_ray};

const ABSORPTION: DVec3 = DVec3::new(0.3, 0.7, 1.9);

/// A scene with this medium in material `fill`, before a white background.
fn scene(medium: &str, lights: &str, objects: &str) -> Scene {
    let text = format!(
        r#"{{
            "ambient": [0, 0, 0],
            "background": [1, 1, 1],
            "limits": {{ "depth": 30, "contribution": 0 }},
            "lights": [{lights}],
            "materials": {{
                "fill": {{ "ambient": [0, 0, 0], "diffuse": [0, 0, 0], "transparency": 1, "index_of_refraction": 1, "medium": {medium} }},
                "more": {{ "ambient": [0, 0, 0], "diffuse": [0, 0, 0], "transparency": 1, "index_of_refraction": 1,
                           "medium": {{ "absorption": [2, 2, 2] }} }},
                "white": {{ "ambient": [0, 0, 0], "diffuse": [1, 1, 1] }}
            }},
            "objects": [{objects}]
        }}"#
    );
    load(&text, "a test").unwrap_or_else(|errors| panic!("{errors}"))
}

fn absorbing(objects: &str) -> Scene {
    scene(r#"{ "absorption": [0.3, 0.7, 1.9] }"#, "", objects)
}

fn seen(scene: &Scene, origin: DVec3, direction: DVec3) -> Rgb {
    let tracer = Tracer::new(scene);
    tracer.trace(&tracer.camera_ray(origin, direction), &mut NullRecorder)
}

/// Beer's law with the library's exponential.
fn left_after(length: f64) -> Rgb {
    (-ABSORPTION * length).map(f64::exp)
}

fn assert_near(found: Rgb, expected: Rgb, bound: f64, what: &str) {
    assert!((found - expected).abs().max_element() <= bound, "{what}: {found}, not {expected}");
}

#[test]
fn a_slab_leaves_what_the_law_says_at_every_angle() {
    let slab = absorbing(r#"{ "shape": "cube", "material": "fill", "transform": [{ "scale": [1000, 1000, 0.75] }] }"#);
    for across in [0.0, 0.3, 1.0, 4.0] {
        let direction = DVec3::new(across, -0.5 * across, -2.0);
        let length = 1.5 * direction.length() / 2.0;
        let colour = seen(&slab, DVec3::new(0.0, 0.0, 5.0), direction);
        assert_near(colour, left_after(length), 1e-14, "a slab");
    }
}

#[test]
fn a_ball_leaves_what_the_law_says_for_its_chord() {
    let ball = absorbing(r#"{ "shape": "sphere", "material": "fill", "transform": [{ "scale": 1.25 }] }"#);
    for beside in [0.0_f64, 0.25, 0.75, 1.0, 1.2] {
        let chord = 2.0 * (1.25 * 1.25 - beside * beside).sqrt();
        let colour = seen(&ball, DVec3::new(beside, 0.0, 5.0), DVec3::NEG_Z);
        assert_near(colour, left_after(chord), 1e-14, "a ball");
    }
    assert_eq!(seen(&ball, DVec3::new(1.3, 0.0, 5.0), DVec3::NEG_Z), Rgb::ONE);
}

const SHELL: &str = r#"{ "shape": "difference", "name": "shell", "material": "fill", "of": [
    { "shape": "sphere", "transform": [{ "scale": 2 }] },
    { "shape": "sphere", "transform": [{ "scale": 1.5 }] }
] }"#;

#[test]
fn a_hollow_ball_takes_light_away_on_both_stretches_of_its_wall() {
    let shell = absorbing(SHELL);
    for beside in [0.0_f64, 0.5, 1.2, 1.6, 1.9] {
        let outer = 2.0 * (4.0 - beside * beside).sqrt();
        let inner = 2.0 * (2.25 - beside * beside).max(0.0).sqrt();
        let colour = seen(&shell, DVec3::new(0.0, beside, 5.0), DVec3::NEG_Z);
        assert_near(colour, left_after(outer - inner), 1e-14, "a hollow ball");
    }
    let tree = record_ray(&shell, DVec3::new(0.0, 0.5, 5.0), DVec3::NEG_Z);
    let stretches = tree.events.iter().filter(|event| matches!(event.what, What::Segment(_))).count();
    assert_eq!(stretches, 2, "one for each wall");
}

#[test]
fn an_eye_inside_a_medium_sees_through_the_rest_of_it() {
    let ball = absorbing(r#"{ "shape": "sphere", "material": "fill", "transform": [{ "scale": 2 }] }"#);
    assert_near(seen(&ball, DVec3::new(0.0, 0.0, 0.5), DVec3::NEG_Z), left_after(2.5), 1e-14, "from inside");
    assert_near(seen(&ball, DVec3::new(0.0, 0.0, 0.5), DVec3::Z * 7.0), left_after(1.5), 1e-14, "the other way");
    let shell = absorbing(SHELL);
    assert_near(seen(&shell, DVec3::ZERO, DVec3::Y), left_after(0.5), 1e-14, "from the hollow");
    assert_near(seen(&shell, DVec3::X * 1.75, DVec3::NEG_X), left_after(0.75), 1e-14, "from the wall");
}

#[test]
fn a_medium_without_end_hides_what_it_absorbs_and_nothing_else() {
    let sea = scene(r#"{ "absorption": [0, 0.1, 0] }"#, "", r#"{ "shape": "plane", "material": "fill" }"#);
    assert_eq!(seen(&sea, DVec3::NEG_Z, DVec3::NEG_Z), Rgb::new(1.0, 0.0, 1.0));
    let tree = record_ray(&sea, DVec3::NEG_Z, DVec3::NEG_Z);
    let segment = tree.events.iter().find_map(|event| match &event.what {
        What::Segment(segment) => Some(segment.clone()),
        _ => None,
    });
    let segment = segment.expect("the way is told");
    assert_eq!((segment.length, segment.to, segment.transmittance), (f64::INFINITY, None, [1.0, 0.0, 1.0]));
}

#[test]
fn the_medium_that_wins_is_the_one_that_takes_light_away() {
    let overlapping = r#"
        { "shape": "cube", "material": "fill", "priority": 1, "transform": [{ "scale": [50, 50, 1] }] },
        { "shape": "cube", "material": "more", "priority": 2, "transform": [{ "scale": [50, 50, 0.25] }] }"#;
    let mut both = absorbing(overlapping);
    both.media = rayscope::scene::MediaPolicy::Priority;
    let expected = left_after(1.5) * (-2.0 * 0.5_f64).exp();
    assert_near(seen(&both, DVec3::Z * 3.0, DVec3::NEG_Z), expected, 1e-14, "the inner one wins");
    both.objects[0].priority = 3;
    assert_near(seen(&both, DVec3::Z * 3.0, DVec3::NEG_Z), left_after(2.0), 1e-14, "the outer one wins");
}

#[test]
fn a_light_fades_on_its_way_to_a_floor_within_the_medium() {
    let floor = r#"{ "shape": "cube", "material": "fill", "transform": [{ "scale": [50, 50, 2] }, { "translate": [0, 0, 2] }] },
        { "shape": "square", "material": "white", "transform": [{ "scale": [20, 20, 1] }, { "translate": [0, 0, 1] }] }"#;
    let absorption = r#"{ "absorption": [0.3, 0.7, 1.9] }"#;
    let lights = r#"{ "directional": [3, 0, 4] }"#;
    let from_above = seen(&scene(absorption, lights, floor), DVec3::Z * 6.0, DVec3::NEG_Z);
    // 3 deep, at an angle whose cosine is 0.8; and 3 back to the eye.
    assert_near(from_above, 0.8 * left_after(3.0 / 0.8) * left_after(3.0), 1e-14, "a light outside");
    let lights = r#"{ "point": [0, 0, 2.5] }"#;
    let from_above = seen(&scene(absorption, lights, floor), DVec3::Z * 6.0, DVec3::NEG_Z);
    assert_near(from_above, left_after(1.5) * left_after(3.0), 1e-14, "a light inside");
}

/// The mean over many random numbers and its standard error, of the largest component.
fn mean(scene: &Scene, origin: DVec3, direction: DVec3, count: u32) -> (Rgb, f64) {
    let tracer = Tracer::new(scene);
    let (mut sum, mut squares) = (Rgb::ZERO, Rgb::ZERO);
    for number in 0..count {
        let ray = Ray { stream: Stream::of_pixel([7, 0], 0).sample(number), ..tracer.camera_ray(origin, direction) };
        let colour = tracer.trace(&ray, &mut NullRecorder);
        sum += colour;
        squares += colour * colour;
    }
    let n = f64::from(count);
    let mean = sum / n;
    (mean, ((squares / n - mean * mean).max(Rgb::ZERO) / n).max_element().sqrt())
}

const MIST: &str = r#"{ "absorption": [0.1, 0.2, 0.3], "scattering": [0.4, 0.3, 0.2], "anisotropy": 0.4 }"#;

fn assert_mean(scene: &Scene, [origin, direction]: [DVec3; 2], expected: Rgb, what: &str) {
    let (found, error) = mean(scene, origin, direction, 4096);
    assert!(error < 0.02 * expected.max_element(), "{what}: the error {error} proves nothing");
    assert_near(found, expected, 4.0 * error + 1e-12, what);
}

#[test]
fn light_from_the_sun_is_turned_in_a_slab_as_the_integral_says() {
    let slab = r#"{ "shape": "cube", "material": "fill", "transform": [{ "scale": [1000, 1000, 1] }, { "translate": [0, 0, -1] }] }"#;
    let phase = HenyeyGreenstein { anisotropy: 0.4 };
    for [sun, view] in [[DVec3::Z, DVec3::NEG_Z], [DVec3::new(3.0, 0.0, 4.0), DVec3::new(0.6, 0.3, -1.0)]] {
        let light = format!(r#"{{ "directional": [{}, {}, {}], "colour": [2, 2, 2] }}"#, sun.x, sun.y, sun.z);
        let mut mist = scene(MIST, &light, slab);
        mist.background = Rgb::ZERO;
        let (sun, view) = (sun.normalize(), view.normalize());
        // ∫ σ_s p exp(−σ_t s) exp(−σ_t s μ / μ_sun) ds over the slab, whose depth is s μ.
        let (mu, mu_sun) = (-view.z, sun.z);
        let rate = DVec3::splat(0.5) * (1.0 + mu / mu_sun);
        let length = 2.0 / mu;
        let scattering = DVec3::new(0.4, 0.3, 0.2);
        let expected =
            2.0 * scattering * phase.value(view.dot(sun)) * (DVec3::ONE - (-rate * length).map(f64::exp)) / rate;
        assert_mean(&mist, [DVec3::Z * 3.0, view], expected, "a slab in the sun");
    }
}

/// Simpson's rule.
fn integral(from: f64, to: f64, f: impl Fn(f64) -> DVec3) -> DVec3 {
    let h = (to - from) / 4000.0;
    let weight = |i: u32| if i == 0 || i == 4000 { 1.0 } else { 2.0 + 2.0 * f64::from(i % 2) };
    (0..=4000).map(|i| weight(i) * f(from + h * f64::from(i))).sum::<DVec3>() * h / 3.0
}

#[test]
fn light_of_a_lamp_in_a_ball_of_mist_is_turned_as_the_integral_says() {
    let ball = r#"{ "shape": "sphere", "material": "fill", "transform": [{ "scale": 2 }] }"#;
    let mut mist = scene(MIST, r#"{ "point": [0.5, 0, 0.75] }"#, ball);
    mist.background = Rgb::ZERO;
    let lamp = DVec3::new(0.5, 0.0, 0.75);
    let phase = HenyeyGreenstein { anisotropy: 0.4 };
    let turned = |depth: f64| {
        let way = lamp - DVec3::new(0.0, 0.0, 2.0 - depth);
        let cosine = way.normalize().dot(DVec3::NEG_Z);
        DVec3::new(0.4, 0.3, 0.2) * phase.value(cosine) * (-0.5 * (depth + way.length())).exp()
    };
    assert_mean(&mist, [DVec3::Z * 4.0, DVec3::NEG_Z], integral(0.0, 4.0, turned), "seen from outside");
    assert_mean(&mist, [DVec3::Z * 2.0 - DVec3::Z * 1e-9, DVec3::NEG_Z], integral(0.0, 4.0, turned), "from inside");
}

#[test]
fn colours_that_are_turned_at_other_distances_stay_right_on_the_mean() {
    let slab = r#"{ "shape": "cube", "material": "fill", "transform": [{ "scale": [1000, 1000, 1] }, { "translate": [0, 0, -1] }] }"#;
    let medium = r#"{ "absorption": [0, 0.1, 1], "scattering": [0.05, 0.9, 4] }"#;
    let mut mist = scene(medium, r#"{ "directional": [0, 0, 1] }"#, slab);
    mist.background = Rgb::ZERO;
    let (scattering, rate) = (DVec3::new(0.05, 0.9, 4.0), DVec3::new(0.05, 1.0, 5.0));
    let even = 0.25 / std::f64::consts::PI;
    let expected = scattering * even * (DVec3::ONE - (-4.0 * rate).map(f64::exp)) / (2.0 * rate);
    assert_mean(&mist, [DVec3::Z * 3.0, DVec3::NEG_Z], expected, "a coloured mist");
}

#[test]
fn fog_that_absorbs_nothing_loses_no_light() {
    let ball = r#"{ "shape": "sphere", "material": "fill" }"#;
    for (rate, anisotropy) in [(0.5, 0.0), (2.0, 0.7), (2.0, -0.5)] {
        let medium =
            format!(r#"{{ "scattering": [{rate}, {rate}, {rate}], "anisotropy": {anisotropy}, "multiple": true }}"#);
        let fog = scene(&medium, "", ball);
        let (found, error) = mean(&fog, DVec3::new(0.2, 0.1, 3.0), DVec3::NEG_Z, 2000);
        // All weights are 1: only a path that is turned more than 64 times is lost, which for these balls none is.
        assert!(error < 1e-12, "rate {rate}, g {anisotropy}: error {error}");
        assert_near(found, Rgb::ONE, 1e-12, "grey fog");
    }
    let fog = scene(r#"{ "scattering": [0.3, 1, 3], "anisotropy": 0.5, "multiple": true }"#, "", ball);
    let (found, error) = mean(&fog, DVec3::new(0.2, 0.1, 3.0), DVec3::NEG_Z, 20_000);
    assert!(error < 0.02, "coloured fog: error {error}");
    assert_near(found, Rgb::ONE, 4.0 * error, "coloured fog");
}

#[test]
fn a_thick_cloud_loses_only_the_paths_that_the_limit_ends() {
    let ball = r#"{ "shape": "sphere", "material": "fill" }"#;
    let cloud = scene(r#"{ "scattering": [12, 12, 12], "multiple": true }"#, "", ball);
    let tracer = Tracer::new(&cloud);
    let mut lost = 0;
    for number in 0..200 {
        let ray = Ray {
            stream: Stream::of_pixel([3, 0], 0).sample(number),
            ..tracer.camera_ray(DVec3::Z * 3.0, DVec3::NEG_Z)
        };
        let mut tally = Tally::default();
        let colour = tracer.trace(&ray, &mut tally).x;
        let turns = tally.rays(RayKind::Scattered);
        assert!(turns <= 64, "the limit ends paths after 64 turns");
        if (colour - 1.0).abs() > 1e-9 {
            assert!(turns == 64 && colour < 1e-9, "path {number} has {turns} turns and brings {colour}");
            lost += 1;
        }
    }
    // Light leaves a cloud of optical radius 12 after some dozens of turns; a few paths in a hundred take more than 64.
    assert!((5..40).contains(&lost), "{lost} of 200 paths are lost");
}

#[test]
fn a_single_turn_shows_lights_and_nothing_else() {
    let ball = r#"{ "shape": "sphere", "material": "fill" }"#;
    let fog = scene(r#"{ "scattering": [1, 1, 1] }"#, "", ball);
    let (found, error) = mean(&fog, DVec3::Z * 3.0, DVec3::NEG_Z, 16);
    assert_eq!(error, 0.0);
    assert_near(found, Rgb::splat((-2.0_f64).exp()), 1e-14, "only what comes straight through");
}

#[test]
fn turning_the_whole_scene_changes_nothing() {
    let turn = DMat3::from_axis_angle(DVec3::new(1.0, 2.0, 2.0) / 3.0, 0.9);
    let rows = turn.transpose().to_cols_array_2d();
    let steps = format!(
        r#"[{{ "scale": [1, 1.5, 0.75] }}, {{ "matrix": [[{}, {}, {}, 0], [{}, {}, {}, 0], [{}, {}, {}, 0]] }}]"#,
        rows[0][0], rows[0][1], rows[0][2], rows[1][0], rows[1][1], rows[1][2], rows[2][0], rows[2][1], rows[2][2]
    );
    let turned = absorbing(&format!(r#"{{ "shape": "sphere", "material": "fill", "transform": {steps} }}"#));
    let plain = absorbing(r#"{ "shape": "sphere", "material": "fill", "transform": [{ "scale": [1, 1.5, 0.75] }] }"#);
    for (origin, direction) in [(DVec3::new(0.3, 0.2, 4.0), DVec3::NEG_Z), (DVec3::new(4.0, 0.1, 0.2), DVec3::NEG_X)] {
        let expected = seen(&plain, origin, direction);
        assert_near(seen(&turned, turn * origin, turn * direction), expected, 1e-14, "a turned scene");
    }
}
