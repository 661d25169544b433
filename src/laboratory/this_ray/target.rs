//! What is looked at: a pixel, or a ray of one's own.

use crate::record::NullRecorder;
use crate::scene::{Rgb, Scene};
use crate::trace::{RayTree, TreeRecorder, trace_pixel, trace_ray};
use glam::DVec3;

/// A pixel, or a ray that is given instead.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Target {
    /// Column and row, counted from the top left.
    Pixel([u32; 2]),
    /// Origin and direction, in world space.
    Ray([DVec3; 2]),
}

impl Target {
    /// Everything that happens, with lines of working that carry their true errors.
    #[must_use]
    pub fn record(&self, scene: &Scene) -> RayTree {
        let mut recorder = TreeRecorder::measuring();
        match *self {
            Self::Pixel([x, y]) => trace_pixel(scene, x, y, &mut recorder),
            Self::Ray([origin, direction]) => trace_ray(scene, origin, direction, &mut recorder),
        };
        recorder.finish()
    }

    /// The linear colour alone.
    #[must_use]
    pub fn trace(&self, scene: &Scene) -> Rgb {
        match *self {
            Self::Pixel([x, y]) => trace_pixel(scene, x, y, &mut NullRecorder),
            Self::Ray([origin, direction]) => trace_ray(scene, origin, direction, &mut NullRecorder),
        }
    }
}
