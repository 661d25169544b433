//! The thin lens against its equation, its focus against a pinhole, and how fast its noise goes away.

use rayscope::record::What;
use rayscope::scene::{Scene, load};
use rayscope::trace::{Picture, Progress, record_pixel, render};

fn picture(scene: &Scene) -> Picture {
    render(scene, &Progress::new()).0
}

const SIDE: u32 = 48;
const RADIUS: f64 = 0.2;
const HALF_HEIGHT: f64 = 0.05;

/// A ball that shines with a radius of 3 pixels, `depth` away on the axis of a lens in focus at `focus`.
fn bright_ball(depth: f64, focus: f64, aperture: &str) -> Scene {
    let half_angle_sine = ball_radius_on_plane() / ball_radius_on_plane().hypot(1.0);
    let (radius, angle) = (depth * half_angle_sine, 2.0 * HALF_HEIGHT.atan().to_degrees());
    let text = format!(
        r#"{{
            "camera": {{ "eye": [0, 0, 0], "look_at": [0, 1, 0], "up": [0, 0, 1], "field_of_view": {angle},
                "lens": {{ "radius": {RADIUS}, "focus": {focus}, "aperture": {aperture} }} }},
            "image": {{ "width": {SIDE}, "height": {SIDE} }},
            "sampling": {{ "samples": 128 }},
            "ambient": [1, 1, 1],
            "background": [0, 0, 0],
            "materials": {{ "bright": {{ "ambient": [1, 1, 1] }} }},
            "objects": [{{ "shape": "sphere", "material": "bright",
                "transform": [{{ "scale": {radius} }}, {{ "translate": [0, {depth}, 0] }}] }}]
        }}"#
    );
    load(&text, "ball").unwrap_or_else(|errors| panic!("{errors}"))
}

/// On the image plane at distance 1.
fn ball_radius_on_plane() -> f64 {
    3.0 * 2.0 * HALF_HEIGHT / f64::from(SIDE)
}

/// The variances of the brightness across and downwards, in pixels, of a picture whose light lies about its middle.
fn variances(picture: &Picture) -> [f64; 2] {
    let middle = 0.5 * (f64::from(SIDE) - 1.0);
    let (mut sum, mut moments) = (0.0, [0.0; 2]);
    for (x, y) in (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (x, y))) {
        let brightness = picture.pixel(x, y).x;
        sum += brightness;
        for (moment, at) in moments.iter_mut().zip([x, y]) {
            *moment += brightness * (f64::from(at) - middle).powi(2);
        }
    }
    moments.map(|moment| moment / sum)
}

/// A disc of diameter c has the variance c²/16 along each axis. To it come those of the ball's own disc and of the pixel.
fn measured_diameter(picture: &Picture) -> f64 {
    let [across, down] = variances(picture);
    4.0 * (0.5 * (across + down) - 9.0 / 4.0 - 1.0 / 12.0).sqrt()
}

/// c = 2 r |z − f| / (z f) on the image plane at distance 1.
fn diameter(depth: f64, focus: f64) -> f64 {
    2.0 * RADIUS * (depth - focus).abs() / (depth * focus) * f64::from(SIDE) / (2.0 * HALF_HEIGHT)
}

#[test]
fn a_ball_out_of_focus_is_as_large_as_the_lens_equation_says() {
    for (depth, focus) in [(8.0, 5.5), (8.0, 6.0), (8.0, 12.0), (8.0, 16.0), (5.0, 6.0), (20.0, 10.0)] {
        let (expected, measured) =
            (diameter(depth, focus), measured_diameter(&picture(&bright_ball(depth, focus, r#"{ "kind": "disc" }"#))));
        assert!(expected > 6.0 && expected < 40.0, "{expected} pixels do not suit the picture");
        assert!(
            (measured / expected - 1.0).abs() < 0.01,
            "at {depth} with focus {focus}: {measured} and not {expected}"
        );
    }
}

/// The second moment of a square on the unit circle is (2 + cos 90°)/12 = 1/6, so c²/4 · 1/6 in pixels, however it is turned.
#[test]
fn a_square_aperture_spreads_a_ball_over_a_square() {
    let mut scene = bright_ball(8.0, 16.0, r#"{ "kind": "polygon", "sides": 4, "turn": 45 }"#);
    scene.sampling.samples = 512;
    let expected = diameter(8.0, 16.0).powi(2) / 24.0;
    for variance in variances(&picture(&scene)) {
        let own = variance - 9.0 / 4.0 - 1.0 / 12.0;
        assert!((own / expected - 1.0).abs() < 0.02, "{own} and not {expected}");
    }
}

#[test]
fn a_ball_in_focus_is_as_small_as_through_a_pinhole() {
    let [across, down] = variances(&picture(&bright_ball(8.0, 8.0, r#"{ "kind": "disc" }"#)));
    let own = 9.0 / 4.0 + 1.0 / 12.0;
    assert!((across / own - 1.0).abs() < 0.02 && (down / own - 1.0).abs() < 0.02, "{across} and {down}, not {own}");
}

/// A wall of smooth stripes, 4 away, and a ball before it.
fn wall(lens: &str, samples: u32, seed: u32) -> Scene {
    let text = format!(
        r#"{{
            "camera": {{ "eye": [0, 0, 0], "look_at": [0, 1, 0], "up": [0, 0, 1], "field_of_view": 30{lens} }},
            "image": {{ "width": 16, "height": 16 }},
            "sampling": {{ "samples": {samples}, "seed": {seed} }},
            "ambient": [1, 1, 1],
            "materials": {{
                "stripes": {{ "ambient": [1, 1, 1], "texture": {{ "kind": "gradient", "axis": [1, 0, 2], "length": 3,
                    "transform": [{{ "translate": [-1, 0, -1] }}] }} }},
                "red": {{ "ambient": [0.9, 0.2, 0.1] }}
            }},
            "objects": [
                {{ "shape": "cube", "material": "stripes", "transform": [{{ "scale": [9, 0.5, 9] }}, {{ "translate": [0, 4.5, 0] }}] }}
            ]
        }}"#
    );
    load(&text, "wall").unwrap_or_else(|errors| panic!("{errors}"))
}

#[test]
fn a_wall_in_the_plane_of_focus_looks_as_through_a_pinhole() {
    let sharp = picture(&wall("", 16, 0));
    let focused = picture(&wall(r#", "lens": { "radius": 0.3, "focus": 4 }"#, 16, 0));
    let blurred = picture(&wall(r#", "lens": { "radius": 0.3, "focus": 2 }"#, 16, 0));
    let largest = |other: &Picture| {
        let places = (0..16).flat_map(|y| (0..16).map(move |x| (x, y)));
        places.map(|(x, y)| (sharp.pixel(x, y) - other.pixel(x, y)).abs().max_element()).fold(0.0, f64::max)
    };
    assert!(largest(&focused) < 1e-12, "{}", largest(&focused));
    assert!(largest(&blurred) > 1e-4, "{}", largest(&blurred));
}

/// The error of a picture, from the difference of two that differ in nothing but their seed.
fn error(scene: impl Fn(u32, u32) -> Scene, samples: u32) -> f64 {
    let [a, b] = [1, 2].map(|seed| picture(&scene(samples, seed)));
    let places = (0..16).flat_map(|y| (0..16).map(move |x| (x, y)));
    let squares: f64 = places.map(|(x, y)| (a.pixel(x, y) - b.pixel(x, y)).length_squared()).sum();
    (squares / (2.0 * 256.0)).sqrt()
}

#[test]
fn the_noise_of_a_smooth_blur_falls_faster_than_that_of_random_points() {
    let blurred = |samples, seed| wall(r#", "lens": { "radius": 0.3, "focus": 2 }"#, samples, seed);
    let errors: Vec<[f64; 2]> = [4, 16, 64, 256, 1024].map(|n| [f64::from(n).ln(), error(blurred, n).ln()]).to_vec();
    let mean = |k: usize| errors.iter().map(|point| point[k]).sum::<f64>() / errors.len() as f64;
    let (x, y) = (mean(0), mean(1));
    let covariance: f64 = errors.iter().map(|[a, b]| (a - x) * (b - y)).sum();
    let slope = covariance / errors.iter().map(|[a, _]| (a - x).powi(2)).sum::<f64>();
    println!("slope {slope:.3} of {errors:?}");
    assert!(slope < -0.7, "{slope} from {errors:?}");
}

#[test]
fn the_colour_of_a_pixel_outlives_the_limit_of_its_recording() {
    let mut scene = bright_ball(8.0, 6.0, r#"{ "kind": "disc" }"#);
    scene.sampling.samples = 20_000;
    let tree = record_pixel(&scene, SIDE / 2, SIDE / 2);
    assert!(
        tree.events.iter().any(|event| matches!(&event.what, What::Limit { limit, .. } if limit == "recording size"))
    );
    let mean = tree.children(0).find_map(|event| match &event.what {
        What::Average(average) => Some((average.samples, average.colour)),
        _ => None,
    });
    assert_eq!(mean, Some((20_000, tree.colour())));
    let mut alone = rayscope::record::NullRecorder;
    let traced = rayscope::trace::trace_pixel(&scene, SIDE / 2, SIDE / 2, &mut alone);
    assert_eq!(tree.colour(), traced.to_array());
}

#[test]
fn samples_are_doubled_until_the_pixel_is_sure_of_its_colour() {
    let mut scene = bright_ball(8.0, 6.0, r#"{ "kind": "disc" }"#);
    let adaptive = rayscope::scene::Adaptive { most: 256, error: 0.02 };
    (scene.sampling.samples, scene.sampling.adaptive) = (8, Some(adaptive));
    let average = |x, y| {
        let tree = record_pixel(&scene, x, y);
        let found = tree.events.into_iter().find_map(|event| match event.what {
            What::Average(average) => Some(average),
            _ => None,
        });
        found.unwrap()
    };
    let corner = average(0, 0);
    assert!(corner.samples == 8 && corner.error.unwrap() < 1e-12, "nothing but background: {corner:?}");
    let middle = average(SIDE / 2, SIDE / 2);
    assert!(middle.samples > 8 && middle.samples.is_power_of_two(), "{}", middle.samples);
    assert!(middle.error.unwrap() <= 0.02 || middle.samples == 256, "{middle:?}");
}
