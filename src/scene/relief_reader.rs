//! From what a file says about bumps and grain to what the tracer asks.

use super::coat::GrainCoat;
use super::relief_file::{BumpFile, FrameFile};
use super::solid_texture_reader::{Fault, TIME_PER_STIR, turbulence};
use super::texture_file::TurbulenceFile;
use crate::texture::relief::{Bump, Facets, Grain};
use crate::texture::solid::{Noise, NoiseKind, Turbulence};
use glam::{DVec2, DVec3};

/// The bump, with its time in a frame; none where the file says a picture.
pub(super) fn bump(file: &BumpFile) -> Option<Result<(Bump, f64), Fault>> {
    Some(match *file {
        BumpFile::Image { .. } => return None,
        BumpFile::Noise { height, turbulence: ref sum, stir } => {
            turbulence(sum).map(|turbulence| (Bump::Noise { turbulence, height }, stir * TIME_PER_STIR))
        }
        BumpFile::Waves { height, length, centre, speed } => {
            let centre = DVec3::from_array(centre);
            Ok((Bump::Waves { centre, wavelength: length, height, phase: 0.0 }, speed / 1000.0))
        }
        BumpFile::Facets { size, tilt, seed } => Facets::new(size, tilt, u64::from(seed))
            .map(|facets| (Bump::Facets(facets), 0.0))
            .map_err(|message| ("tilt", message)),
    })
}

/// Noise along a streak changes this many times slower than across it.
const STREAK_LENGTH: f64 = 40.0;

/// How far streaks tilt the normal across themselves, beside how far they turn the grain: enough to be seen between
/// highlights.
const STREAK_TILT: f64 = 0.3;

/// The grain.
pub(super) fn grain(file: &FrameFile) -> Result<GrainCoat, Fault> {
    let gradient_noise = |seed: u32| Noise::new(NoiseKind::Gradient, u64::from(seed));
    Ok(match *file {
        FrameFile::Brushed { roughness, waver, streaks, seed } => {
            let scale = DVec2::new(streaks / STREAK_LENGTH, streaks);
            let tilt = STREAK_TILT * waver.to_radians();
            GrainCoat { grain: Grain::Brushed { noise: gradient_noise(seed), scale, turn: waver, tilt }, roughness }
        }
        FrameFile::Woven { roughness, threads, roundness } => {
            GrainCoat { grain: Grain::Woven { threads: DVec2::from_array(threads), tilt: roundness }, roughness }
        }
        FrameFile::Grain { roughness, axis, waver, size, seed } => {
            let sum = TurbulenceFile { size, octaves: 3, seed, ..TurbulenceFile::default() };
            let turbulence: Turbulence = turbulence(&sum)?;
            GrainCoat { grain: Grain::Fibre { axis: DVec3::from_array(axis), turbulence, turn: waver }, roughness }
        }
    })
}
