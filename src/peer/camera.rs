//! A peer scene's camera: the ray through the picture's point (x, y), from 0 at the left and top to 1, has the direction
//! `direction + (x − ½) right + (½ − y) up`.

use super::import::Image;
use crate::math::portable;
use glam::DVec3;
use serde::Deserialize;
use serde_json::{Value, json};

#[derive(Deserialize)]
#[serde(tag = "type", rename_all = "snake_case", deny_unknown_fields)]
pub(super) enum Camera {
    /// A pinhole.
    Perspective {
        location: [f64; 3],
        direction: [f64; 3],
        right: [f64; 3],
        up: [f64; 3],
        #[serde(default, rename = "note")]
        _note: String,
    },
}

/// Lens radii in one of POV-Ray's apertures, whatever its documentation says of a diameter: a small bright ball out of focus
/// is spread over a disc of that size by POV-Ray 3.7.0.10, within 2 % (measured by second moments).
pub(super) const RADII_IN_APERTURE: f64 = 4.0;

/// Blur as POV-Ray says it.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Blur {
    /// Four radii of the lens.
    aperture: f64,
    /// A point of the plane of focus.
    focal_point: [f64; 3],
    /// Rays for each pixel.
    pub samples: u32,
}

/// How far out the point looked at is put, in lengths of the direction. Less, and adding it to the eye would round the
/// direction; the power of two itself rounds nothing.
const FAR: f64 = 1024.0;

/// The largest relative departure from a camera with an upright picture and square pixels. The peers' own numbers are
/// rounded to 1e-16; what a person would see begins above 1e-4.
const TOLERANCE: f64 = 1e-12;

impl Camera {
    /// The lens of the scene file.
    pub fn lens(&self, blur: &Blur) -> Result<Value, String> {
        let Self::Perspective { location, direction, .. } = self;
        let to_focus = DVec3::from_array(blur.focal_point) - DVec3::from_array(*location);
        let focus = to_focus.dot(DVec3::from_array(*direction).normalize_or_zero());
        if focus > 0.0 {
            Ok(json!({ "radius": blur.aperture / RADII_IN_APERTURE, "focus": focus }))
        } else {
            Err("dof: `focal_point` is not in front of the camera".into())
        }
    }

    /// The camera of the scene file.
    pub fn to_file(&self, image: Image) -> Result<Value, String> {
        let Self::Perspective { location, direction, right, up, .. } = self;
        let [eye, direction, right, up] = [location, direction, right, up].map(|v| DVec3::from_array(*v));
        let (width, height) = (f64::from(image.width), f64::from(image.height));
        let cosines = [direction.dot(right), direction.dot(up), right.dot(up)];
        let lengths = direction.length() * right.length().max(up.length());
        if cosines.iter().any(|cosine| cosine.abs() > TOLERANCE * lengths) {
            return Err("camera: direction, right and up are not at right angles, which a scene file cannot say".into());
        }
        if (right.length() * height - up.length() * width).abs() > TOLERANCE * up.length() * width {
            return Err("camera: its pixels are not square, which a scene file cannot say".into());
        }
        if direction.cross(up).dot(right) <= 0.0 {
            return Err("camera: the picture is mirrored, which a scene file cannot say".into());
        }
        let half_height = 0.5 * up.length() / direction.length();
        Ok(json!({
            "eye": location,
            "look_at": (eye + direction * FAR).to_array(),
            "up": up.to_array(),
            "field_of_view": 2.0 * portable::atan(half_height).to_degrees(),
        }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const IMAGE: Image = Image { width: 640, height: 480 };

    fn camera(right: [f64; 3], up: [f64; 3]) -> Result<Value, String> {
        Camera::Perspective { location: [0.0; 3], direction: [0.0, 0.0, 1.0], right, up, _note: String::new() }
            .to_file(IMAGE)
    }

    #[test]
    fn a_picture_as_high_as_twice_its_distance_is_seen_under_90_degrees() {
        let file = camera([-8.0 / 3.0, 0.0, 0.0], [0.0, 2.0, 0.0]).unwrap();
        assert!((file["field_of_view"].as_f64().unwrap() - 90.0).abs() < 1e-13);
    }

    #[test]
    fn an_aperture_is_four_radii_and_the_plane_of_focus_stands_across_the_view() {
        let camera = Camera::Perspective {
            location: [0.0, 0.0, -2.0],
            direction: [0.0, 0.0, 2.0],
            right: [-1.0, 0.0, 0.0],
            up: [0.0, 1.0, 0.0],
            _note: String::new(),
        };
        let lens = |focal_point| camera.lens(&Blur { aperture: 0.5, focal_point, samples: 4 });
        assert_eq!(lens([7.0, -3.0, 1.0]).unwrap(), json!({ "radius": 0.125, "focus": 3.0 }));
        assert!(lens([0.0, 0.0, -3.0]).unwrap_err().contains("in front"));
    }

    #[test]
    fn cameras_that_a_scene_file_cannot_say_are_refused() {
        assert!(camera([-0.8, 0.0, 0.0], [0.0, 0.8, 0.0]).unwrap_err().contains("square"));
        assert!(camera([0.8, 0.0, 0.0], [0.0, 0.6, 0.0]).unwrap_err().contains("mirrored"));
        assert!(camera([-0.8, 0.0, 0.0], [0.1, 0.6, 0.0]).unwrap_err().contains("right angles"));
    }
}
