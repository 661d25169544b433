//! The kinds of events: one row for each variant of [`What`], with the level of detail at which it is told, and why there.

use super::level::Level;
use crate::record::What;

macro_rules! kinds {
    ($($kind:ident $name:literal $level:ident $reason:literal;)*) => {
        /// A kind of event, without its numbers.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
        pub enum Kind {
            $(#[doc = $name] $kind,)*
        }

        impl Kind {
            /// All of them, in the order in which a ray meets them.
            pub const ALL: &'static [Self] = &[$(Self::$kind,)*];

            /// The kind of what happened.
            #[must_use]
            pub const fn of(what: &What) -> Self {
                match what {
                    $(What::$kind { .. } => Self::$kind,)*
                }
            }

            /// The words for it.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$kind => $name,)*
                }
            }

            /// The level at which it is told, unless something about it makes it tell more.
            #[must_use]
            pub const fn level(self) -> Level {
                match self {
                    $(Self::$kind => Level::$level,)*
                }
            }

            /// Why it is told at that level.
            #[must_use]
            pub const fn reason(self) -> &'static str {
                match self {
                    $(Self::$kind => $reason,)*
                }
            }
        }
    };
}

kinds! {
    Pixel "pixel" Story "it is what the story is about";
    LooseRay "given ray" Story "it is what the story is about";
    Sample "sample" Story "each sample has a story of its own";
    Step "step" Working "the six steps put the story in order; what happens in them tells it";
    Lens "lens" Working "where on the lens a ray starts is worked out";
    Ray "ray" Story "the rays are what the story follows";
    Object "object" Working "most objects are only asked and not hit";
    Extent "extent" Everything "a test that spares work and changes nothing";
    Ball "ball" Everything "a test that spares work and changes nothing";
    Projection "rectangle in the picture" Everything "a test that spares work and changes nothing";
    Transform "generic coordinates" Everything "the way to a primitive's own working";
    Primitive "primitive" Working "which primitives were asked, and what they answered";
    Planes "plane table" Everything "a primitive's own working";
    Quadratic "quadratic" Everything "a primitive's own working";
    Quartic "quartic" Everything "a primitive's own working";
    Search "search" Everything "a primitive's own working";
    Decision "closest decision" Everything "how a primitive came to be sure";
    Implicit "d(t)" Everything "a primitive's own working";
    Roots "hit times" Everything "a primitive's own working";
    Combine "CSG node" Working "how the solids of an object combine";
    Moved "moved start" Working "rounding had to be made good";
    Rejected "rejected hit" Working "what could have been seen, and why it is not";
    Hit "hit" Story "it is where the ray ends";
    Nothing "background" Story "it is where the ray ends";
    Confusion "circle of confusion" Working "how blurred the hit is";
    Detail "detail" Working "what lies over the surface";
    Texture "texture" Working "where the surface's colour comes from";
    Mapping "mapping" Everything "a texture's own working";
    Texels "texels" Everything "a texture's own working";
    Lattice "noise" Everything "a texture's own working";
    Octaves "turbulence" Everything "a texture's own working";
    Undulate "colour spline" Everything "a texture's own working";
    Rings "rings" Everything "a texture's own working";
    Bump "bump" Working "the normal is turned";
    FrameMap "frame" Working "the frame is turned";
    Environment "environment" Working "where the background's colour comes from";
    Segment "stretch of a medium" Working "how much light a medium lets pass";
    Scatter "scattering" Working "where light is turned";
    Phase "phase function" Everything "by how much light is turned there";
    Passage "out of a medium" Story "it is the colour that the ray brings back";
    Ambient "ambient term" Working "a term of the colour";
    Light "light" Story "light and shadow make most of the colour";
    LightSample "light's point" Working "one of the points that a light is looked at by";
    Shadow "shadow" Working "which object is in the way of a light";
    Reflection "reflection" Working "the direction of a ray that the story follows";
    Snell "Snell's law" Working "the direction of a ray that the story follows";
    Wavelength "wavelength" Working "one of the wavelengths that light is parted into";
    Conductor "metal" Working "how much a metal reflects";
    Overlap "overlap" Story "the scene forbids it";
    Medium "medium" Working "what is on both sides of the surface";
    Limit "limit" Story "something is missing from here on";
    Colour "colour" Story "it is what the ray brings back";
    Average "average" Story "it is what the samples make of the pixel";
    Written "pixel as written" Story "it is the end of the story";
}

impl Kind {
    /// Whether what is told below it needs it to be understood: its name says of which object, primitive or light that is.
    #[must_use]
    pub const fn names_what_is_below(self) -> bool {
        matches!(
            self,
            Self::Object | Self::Primitive | Self::Light | Self::LightSample | Self::Wavelength | Self::Scatter
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_has_a_name_of_its_own_and_a_reason() {
        for (i, kind) in Kind::ALL.iter().enumerate() {
            assert!(!kind.reason().is_empty(), "{kind:?}");
            assert!(Kind::ALL[i + 1..].iter().all(|other| other.name() != kind.name()), "{kind:?}");
        }
    }

    #[test]
    fn no_limit_and_no_hit_waits_for_a_finer_level() {
        for kind in [Kind::Limit, Kind::Hit, Kind::Nothing, Kind::Colour, Kind::Overlap] {
            assert_eq!(kind.level(), Level::Story);
        }
    }
}
