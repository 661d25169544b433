//! What an arithmetic loses of hit times.

use super::{of_each_pixel, size};
use crate::csg::Course;
use crate::math::portable;
use crate::record::NullRecorder;
use crate::scene::{Camera, Scene};
use crate::shape::{Method, Solving};
use crate::trace::Progress;
use crate::view::{HeatMap, HeatScale};

/// The digits that the scene's own method loses of the hit time of the ray through each pixel's middle, against the same with
/// 32 digits; none if it was cancelled.
#[must_use]
pub fn digits_map(scene: &Scene, progress: &Progress) -> Option<HeatMap> {
    of_each_pixel(scene.image, progress, |pixel| digits_lost(scene, pixel)).map(|values| map_of_digits(scene, values))
}

/// The same for one pixel: not a number where nothing is hit, infinite where a hit is lost or made up.
///
/// A method that has d digits and errs by the share e of the true time has lost d + log₁₀ e of them.
#[must_use]
pub fn digits_lost(scene: &Scene, pixel: [u32; 2]) -> f64 {
    let truth = Solving { method: Method::DoubleDouble, ..Solving::default() };
    let (origin, direction) = middle_ray(&scene.camera, scene, pixel);
    let hit = |solving| first_hit(scene, solving, origin, direction);
    lost(hit(scene.solving), hit(truth), digits_of(scene))
}

/// The map of such values, row by row from the top.
#[must_use]
pub fn map_of_digits(scene: &Scene, values: Vec<f64>) -> HeatMap {
    let digits = digits_of(scene);
    // As far as the worst pixel goes, so that it stands out.
    let worst = values.iter().copied().filter(|lost| lost.is_finite()).fold(0.0, f64::max);
    HeatMap {
        title: format!("Digits lost, {}", scene.solving.method.name()),
        notes: vec![format!(
            "Of the {digits:.1} digits of the hit time of the ray through each pixel's middle, against 32 digits."
        )],
        size: size(scene.image),
        scale: HeatScale::Linear([0.0, worst.ceil().max(1.0)]),
        unit: "digits".to_owned(),
        nothing: Some("nothing is hit".to_owned()),
        beyond: Some("a hit is lost or made up".to_owned()),
        values,
        ..HeatMap::default()
    }
}

/// The digits that the scene's method has.
fn digits_of(scene: &Scene) -> f64 {
    -portable::log10(scene.solving.method.coarseness() * 0.5 * f64::EPSILON)
}

/// The ray from the eye through the middle of a pixel.
fn middle_ray(camera: &Camera, scene: &Scene, [x, y]: [u32; 2]) -> (glam::DVec3, glam::DVec3) {
    let place = camera.place(scene.image, f64::from(x) + 0.5, f64::from(y) + 0.5);
    (camera.eye, camera.direction_through(place))
}

/// The smallest hit time in front of the ray's start.
fn first_hit(scene: &Scene, solving: Solving, origin: glam::DVec3, direction: glam::DVec3) -> Option<f64> {
    let course = Course::new(origin, direction, scene.index.skew).testing_boxes(true).solving(solving);
    let first = |object: &crate::scene::Object| {
        object.solid.first_in_front(&course, false, &mut NullRecorder).map(|(boundary, _)| boundary.t)
    };
    scene.objects.iter().filter_map(first).min_by(f64::total_cmp)
}

/// Not a number where neither hits anything, infinite where only one does.
fn lost(found: Option<f64>, truth: Option<f64>, digits: f64) -> f64 {
    match (found, truth) {
        (None, None) => f64::NAN,
        (Some(found), Some(truth)) if found == truth => 0.0,
        (Some(found), Some(truth)) => (digits + portable::log10(((found - truth) / truth).abs())).clamp(0.0, digits),
        _ => f64::INFINITY,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Image, Profile, embedded_scene, load};

    fn map(name: &str, method: Method) -> HeatMap {
        let mut scene = load(embedded_scene(name).unwrap().text, name).unwrap();
        scene.image = Image { width: 40, height: 30 };
        let scene = scene.with_profile(&Profile { method: Some(method), ..Profile::STANDARD });
        digits_map(&scene, &Progress::new()).unwrap()
    }

    #[test]
    fn digits_are_counted_from_the_relative_error() {
        assert_eq!(lost(Some(1.0 + 1e-10), Some(1.0), 16.0).round(), 6.0);
        assert_eq!(lost(Some(2.0), Some(2.0), 16.0), 0.0);
        assert_eq!(lost(Some(50.0), Some(2.0), 16.0), 16.0);
        assert!(lost(None, None, 16.0).is_nan());
        assert_eq!(lost(None, Some(1.0), 16.0), f64::INFINITY);
    }

    #[test]
    fn what_the_program_renders_with_loses_less_than_a_digit_and_double_double_none() {
        for (method, most) in [(Method::Adaptive, 1.0), (Method::DoubleDouble, 0.0)] {
            let map = map("csg/bowl", method);
            let hits: Vec<f64> = map.values.iter().copied().filter(|lost| !lost.is_nan()).collect();
            assert!(hits.len() > 100, "the bowl is seen");
            assert!(hits.iter().all(|lost| *lost <= most), "{method:?} {:?}", hits.iter().copied().fold(0.0, f64::max));
        }
    }
}
