//! From what a file says about the eye to what the tracer asks.

use super::camera::{Adaptive, Camera, Lens, Sampling};
use super::camera_file::{ApertureFile, CameraFile, LensFile, PixelFilterFile, SamplingFile};
use super::coat_reader::CoatReader;
use super::compile::unit;
use super::problem::{Path, Problems};
use crate::math::portable;
use crate::sample::{Aperture, PixelFilter};
use glam::DVec3;

/// Sine of the angle between up and the view below which up has no direction in the picture: 1e-9 is far above what
/// rounding leaves of two parallel vectors and far below what anyone would choose.
const PARALLEL: f64 = 1e-9;

pub(super) fn camera(file: &CameraFile, problems: &mut Problems) -> Option<Camera> {
    let path = Path::Root.field("camera");
    let eye = DVec3::from_array(file.eye);
    let Some(forward) = unit(DVec3::from_array(file.look_at) - eye) else {
        problems
            .add(path.field("look_at"), "`look_at` is the same point as `eye`, so there is no direction to look in");
        return None;
    };
    let Some(up) = unit(DVec3::from_array(file.up)) else {
        problems.add(path.field("up"), "`up` must not be (0, 0, 0)");
        return None;
    };
    let across = forward.cross(up);
    if across.length() < PARALLEL {
        problems
            .add(path.field("up"), "`up` is parallel to the view from `eye` to `look_at`, so the picture has no top")
            .help("choose another `up`, such as [0, 0, 1] or [0, 1, 0]");
        return None;
    }
    let right = across.normalize();
    let half_height = portable::tan(file.field_of_view.to_radians() * 0.5);
    Some(Camera { eye, right, up: right.cross(forward), forward, half_height })
}

/// The lens in front of the eye.
pub(super) fn lens(file: &LensFile, pictures: &mut CoatReader) -> Option<Box<Lens>> {
    let aperture = match &file.aperture {
        ApertureFile::Disc => Aperture::Disc,
        ApertureFile::Polygon { sides, turn } => Aperture::Polygon { sides: *sides, turn: turn.to_radians() },
        ApertureFile::Image { file } => {
            let camera = Path::Root.field("camera");
            let lens = camera.field("lens");
            let aperture = lens.field("aperture");
            Aperture::Image(pictures.mask(file, aperture.field("file"))?)
        }
    };
    Some(Box::new(Lens { radius: file.radius, focus: file.focus, aperture }))
}

/// Samples of a pixel where the file does not say how many and something has to be sampled: enough to see what the effect
/// is, and too few to see it without noise.
const SAMPLES: u32 = 16;

/// How pixels are sampled; `calls_for_samples` says whether anything in the scene has to be.
pub(super) fn sampling(file: &SamplingFile, calls_for_samples: bool) -> Sampling {
    let filter = match file.filter {
        PixelFilterFile::Box => PixelFilter::Box,
        PixelFilterFile::Tent => PixelFilter::Tent,
        PixelFilterFile::Gaussian => PixelFilter::Gaussian,
        PixelFilterFile::Mitchell => PixelFilter::Mitchell,
    };
    Sampling {
        samples: file.samples.unwrap_or(if calls_for_samples { SAMPLES } else { 1 }),
        filter,
        adaptive: file.adaptive.map(|adaptive| Adaptive { most: adaptive.most, error: adaptive.error }),
        seed: file.seed,
        lens_samples: 1,
        wavelengths: file.wavelengths,
    }
}
