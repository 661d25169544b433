//! From what a file says about a solid texture to the texture.

use super::coat::MovingTexture;
use super::texture_file::{NoiseFile, StopFile, TextureFile, TurbulenceFile, WarpFile};
use super::{Colour, Transform};
use crate::texture::solid::{
    Checker, ColourSpline, Gradient, Marble, Mottle, Mottled, Noise, NoiseKind, Pattern, SolidTexture, Turbulence,
    Warp, Wood, WoodGrain,
};
use glam::{DAffine3, DVec3};

/// What is wrong with a texture: the field that it is about, and the message.
pub(super) type Fault = (&'static str, String);

/// A stir of 1 turns the slowest gradients once in a thousand frames: noise turns by the radian in a unit of time.
pub(super) const TIME_PER_STIR: f64 = std::f64::consts::TAU / 1000.0;

/// The texture; none where the file says an image.
pub(super) fn solid_texture(file: &TextureFile) -> Option<Result<MovingTexture, Fault>> {
    let (pattern, place) = match file {
        TextureFile::Image { .. } => return None,
        TextureFile::Checker { colours: [even, odd], size, transform, warp, stir } => {
            (checker([*even, *odd], *size), (transform, warp, stir))
        }
        TextureFile::Gradient { axis, length, repeat, stops, transform, warp, stir } => {
            (gradient(*axis, *length, *repeat, stops), (transform, warp, stir))
        }
        TextureFile::Wood { transform, warp, stir, .. } => (wood(file), (transform, warp, stir)),
        TextureFile::Noise { size, noise, seed, bias, contrast, stops, transform, warp, stir } => {
            let mottle = Mottle::Noise(seeded(*noise, *seed), 1.0 / size);
            (mottled(mottle, [*bias, *contrast], stops), (transform, warp, stir))
        }
        TextureFile::Turbulence { turbulence: sum, bias, contrast, stops, transform, warp, stir } => {
            let mottle = turbulence(sum).map(Mottle::Turbulence);
            (mottle.and_then(|sum| mottled(sum, [*bias, *contrast], stops)), (transform, warp, stir))
        }
        TextureFile::Marble { axis, frequency, amount, turbulence, stops, transform, warp, stir } => {
            (marble(*axis, [*frequency, *amount], turbulence, stops), (transform, warp, stir))
        }
    };
    Some(pattern.and_then(|pattern| placed(pattern, place)))
}

/// The pattern in its place, with what moves it.
fn placed(
    pattern: Pattern,
    (transform, warp, stir): (&Vec<Transform>, &Option<WarpFile>, &f64),
) -> Result<MovingTexture, Fault> {
    let warp = warp.as_ref().map(|file| {
        let turbulence = turbulence(&file.turbulence).map_err(|(_, message)| ("warp", message))?;
        Ok(Warp { turbulence, amount: DVec3::splat(file.amount) })
    });
    let warp = warp.transpose()?;
    let mut object_from_texture = DAffine3::IDENTITY;
    for step in transform {
        let step = step.affine().map_err(|(_, message)| ("transform", message))?;
        object_from_texture = step * object_from_texture;
    }
    let texture_from_object = object_from_texture.inverse();
    if !texture_from_object.is_finite() {
        return Err(("transform", "the transform of the texture has no inverse that numbers can hold".to_owned()));
    }
    let texture = SolidTexture { pattern, warp };
    Ok(MovingTexture { texture, texture_from_object, time_per_frame: stir * TIME_PER_STIR })
}

/// A sum of noise of several sizes.
pub(super) fn turbulence(file: &TurbulenceFile) -> Result<Turbulence, Fault> {
    let TurbulenceFile { size, octaves, gain, absolute, noise, seed } = *file;
    Turbulence::new(seeded(noise, seed), 1.0 / size, octaves, gain, absolute).map_err(about("turbulence"))
}

fn seeded(kind: NoiseFile, seed: u32) -> Noise {
    let kind = match kind {
        NoiseFile::Gradient => NoiseKind::Gradient,
        NoiseFile::Value => NoiseKind::Value,
    };
    Noise::new(kind, u64::from(seed))
}

fn about(field: &'static str) -> impl Fn(String) -> Fault {
    move |message| (field, message)
}

fn rgb(colour: Colour) -> DVec3 {
    DVec3::from_array(colour.0)
}

fn spline(stops: &[StopFile]) -> Result<ColourSpline, Fault> {
    let stops: Vec<_> = stops.iter().map(|stop| (stop.at, rgb(stop.colour))).collect();
    ColourSpline::new(&stops).map_err(about("stops"))
}

fn checker([even, odd]: [Colour; 2], size: f64) -> Result<Pattern, Fault> {
    Checker::new(DVec3::ZERO, size, rgb(even), rgb(odd)).map(Pattern::Checker).map_err(about("size"))
}

fn gradient(axis: [f64; 3], length: f64, repeats: bool, stops: &[StopFile]) -> Result<Pattern, Fault> {
    let spline = spline(stops)?;
    let axis = DVec3::from_array(axis);
    Gradient::new(DVec3::ZERO, axis, length, repeats, spline).map(Pattern::Gradient).map_err(about("axis"))
}

fn wood(file: &TextureFile) -> Result<Pattern, Fault> {
    let TextureFile::Wood { light, dark, axis, ring_width, soft_edge, wobble, lobes, twist, uneven, .. } = file else {
        return Err(("kind", "this is no wood".to_owned()));
    };
    let stirring = uneven.as_ref().map(|file| Ok((turbulence(&file.turbulence)?, file.amount))).transpose()?;
    let grain = WoodGrain {
        point: DVec3::ZERO,
        axis: DVec3::from_array(*axis),
        ring_width: *ring_width,
        wobble: *wobble,
        lobes: *lobes,
        twist: twist.to_radians(),
        stirring,
        light: rgb(*light),
        dark: rgb(*dark),
        edge: *soft_edge,
    };
    Wood::new(grain).map(Pattern::Wood).map_err(about("axis"))
}

/// The colours of values from −1 to 1.
fn mottled(mottle: Mottle, [bias, contrast]: [f64; 2], stops: &[StopFile]) -> Result<Pattern, Fault> {
    Mottled::new(mottle, bias, contrast, spline(stops)?).map(Pattern::Mottled).map_err(about("stops"))
}

fn marble(
    axis: [f64; 3],
    [frequency, amount]: [f64; 2],
    sum: &TurbulenceFile,
    stops: &[StopFile],
) -> Result<Pattern, Fault> {
    let (axis, sum, spline) = (DVec3::from_array(axis), turbulence(sum)?, spline(stops)?);
    Marble::new(axis, frequency, amount, sum, spline).map(Pattern::Marble).map_err(about("axis"))
}
