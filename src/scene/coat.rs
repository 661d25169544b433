//! What surfaces carry besides their plain colours, compiled.

use super::Detail;
use crate::record::Effect;
use crate::texture::image::ImageTexture;
use crate::texture::relief::{Bump, BumpDerivative, Grain};
use crate::texture::solid::{Pattern, SolidTexture, Turbulence};
use glam::DAffine3;

/// What a material carries besides its plain colours.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Coat {
    /// What its ambient and diffuse colours are multiplied by.
    pub texture: Option<Texture>,
    /// What turns its normal.
    pub bump: Option<Bumps>,
    /// How the normal that it turns is worked out.
    pub bump_derivative: BumpDerivative,
    /// What turns its frame, and draws out its highlights.
    pub frame: Option<GrainCoat>,
    /// Whether mirrored and refracted directions are looked up in the environment and not followed.
    pub mirrors_environment: bool,
}

/// A colour for each point of a surface.
#[derive(Clone, Debug, PartialEq)]
pub enum Texture {
    /// A picture on each part of the surface.
    Image {
        /// The picture, and how it lies on the parts.
        image: ImageTexture,
        /// The names of parts that it lies on in a way of its own: part k of the mapping, counted from 1, has name k − 1.
        parts: Vec<String>,
    },
    /// A colour for each point of space.
    Solid(Box<MovingTexture>),
}

impl Texture {
    /// What it is called for as.
    #[must_use]
    pub const fn effect(&self) -> Effect {
        match self {
            Self::Image { .. } => Effect::ImageTextures,
            Self::Solid(_) => Effect::SolidTextures,
        }
    }
}

/// What turns a normal as if the surface were raised.
#[derive(Clone, Debug, PartialEq)]
pub enum Bumps {
    /// A function of the point.
    Procedure {
        /// The function.
        bump: Bump,
        /// How far it is stirred, or runs, in a frame.
        time_per_frame: f64,
    },
    /// A picture of heights.
    Image {
        /// The picture, and how it lies on the parts.
        image: ImageTexture,
        /// The names of parts that it lies on in a way of its own.
        parts: Vec<String>,
        /// The height of white, in the world's units.
        height: f64,
    },
}

/// A grain with its roughness.
#[derive(Clone, Debug, PartialEq)]
pub struct GrainCoat {
    /// What turns the frame.
    pub grain: Grain,
    /// Roughness along the grain and across it.
    pub roughness: [f64; 2],
}

/// A solid texture with its place in the object, which may be stirred from frame to frame.
#[derive(Clone, Debug, PartialEq)]
pub struct MovingTexture {
    /// The colour at each point.
    pub texture: SolidTexture,
    /// From the object's space to the texture's own.
    pub texture_from_object: DAffine3,
    /// How far its noise is stirred in a frame.
    pub time_per_frame: f64,
}

impl MovingTexture {
    /// The kind of texture, as scene files spell it.
    #[must_use]
    pub const fn kind(&self) -> &'static str {
        match &self.texture.pattern {
            Pattern::Checker(_) => "checker",
            Pattern::Gradient(_) => "gradient",
            Pattern::Wood(_) => "wood",
            Pattern::Mottled(_) => "noise",
            Pattern::Marble(_) => "marble",
        }
    }
}

/// What the surface of a leaf needs to know to carry something.
#[derive(Clone, Debug, PartialEq)]
pub struct LeafCoat {
    /// From the world to the space that the solid textures of its material live in: that of the solid that names the
    /// material, so that what is carved out of one block shows one block.
    pub object_from_world: DAffine3,
    /// Polygons on its flat parts.
    pub details: Vec<Detail>,
}

impl Coat {
    /// Whether anything of it asks what part of the surface a pixel covers.
    #[must_use]
    pub fn needs_footprints(&self) -> bool {
        matches!(&self.texture, Some(Texture::Image { image, .. }) if image.needs_footprint())
    }

    /// All sums of noise in it.
    pub fn turbulences_mut(&mut self) -> impl Iterator<Item = &mut Turbulence> {
        let texture = match &mut self.texture {
            Some(Texture::Solid(moving)) => Some(moving.texture.turbulences_mut()),
            _ => None,
        };
        let bump = match &mut self.bump {
            Some(Bumps::Procedure { bump, .. }) => bump.turbulence_mut(),
            _ => None,
        };
        let grain = self.frame.as_mut().and_then(|frame| frame.grain.turbulence_mut());
        texture.into_iter().flatten().chain(bump).chain(grain)
    }

    /// Brings everything that moves to a frame.
    pub fn set_frame(&mut self, frame: f64) {
        if let Some(Texture::Solid(moving)) = &mut self.texture
            && moving.time_per_frame != 0.0
        {
            moving.texture.at_time(frame * moving.time_per_frame);
        }
        if let Some(Bumps::Procedure { bump, time_per_frame }) = &mut self.bump
            && *time_per_frame != 0.0
        {
            match bump {
                Bump::Waves { phase, .. } => *phase = frame * *time_per_frame,
                _ => bump.at_time(frame * *time_per_frame),
            }
        }
    }
}

impl Bumps {
    /// The kind of bump, as scene files spell it.
    #[must_use]
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Procedure { bump, .. } => bump.name(),
            Self::Image { .. } => "image",
        }
    }
}

/// The number by which an image's mapping knows a part.
#[must_use]
pub fn mapped_part(parts: &[String], name: &str) -> u16 {
    let place = parts.iter().position(|part| part == name).map_or(0, |place| place + 1);
    u16::try_from(place).unwrap_or(0)
}
