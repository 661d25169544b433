//! Pigments and normals of peer scenes, as textures and bumps.
//!
//! The patterns are POV-Ray's in kind: rings, veins, noise and cracks, displaced by six octaves of noise of half the strength
//! each. The noise itself is this program's, so the pictures are alike and not the same, and so is the work.

use serde::Deserialize;
use serde_json::{Value, json};

/// Colours at values from 0 to 1.
type Stops = Vec<(f64, [f64; 3])>;

/// The colour of a surface.
#[derive(Deserialize)]
#[serde(tag = "type", rename_all = "snake_case", deny_unknown_fields)]
pub(super) enum Pigment {
    /// One colour.
    Solid { rgb: [f64; 3] },
    /// Rings about the z axis, one to a unit.
    Wood { stops: Stops, turbulence: f64, scale: f64 },
    /// Veins across the x axis, one to a unit.
    Marble { stops: Stops, turbulence: f64, scale: f64 },
    /// Noise.
    Bozo { stops: Stops, turbulence: f64, scale: f64 },
    /// Noise of six sizes without signs.
    Granite { stops: Stops, turbulence: f64, scale: f64 },
}

/// What turns the normal.
#[derive(Deserialize)]
#[serde(tag = "type", rename_all = "snake_case", deny_unknown_fields)]
pub(super) enum Normal {
    /// Noise of one size.
    Bumps { amount: f64, scale: f64 },
}

impl Pigment {
    /// The colour that the texture is multiplied by.
    pub fn flat_colour(&self) -> [f64; 3] {
        match self {
            Self::Solid { rgb } => *rgb,
            _ => [1.0; 3],
        }
    }

    /// The texture; none for one colour.
    pub fn texture(&self) -> Option<Value> {
        Some(match self {
            Self::Solid { .. } => return None,
            Self::Wood { stops, turbulence, scale } => json!({
                "kind": "wood",
                "dark": colour_at(stops, 0.0),
                "light": colour_at(stops, 0.5),
                "ring_width": 0.5 * scale,
                "soft_edge": 1.0,
                "warp": warp(*turbulence, *scale),
            }),
            // A vein of the pattern goes up and down once where the sine does.
            Self::Marble { stops, turbulence, scale } => json!({
                "kind": "marble",
                "axis": [1.0, 0.0, 0.0],
                "frequency": std::f64::consts::TAU / scale,
                "amount": std::f64::consts::TAU * turbulence,
                "turbulence": { "size": scale, "octaves": OCTAVES },
                "stops": spread(stops, 0.5),
            }),
            Self::Bozo { stops, turbulence, scale } => json!({
                "kind": "noise",
                "size": scale,
                "stops": spread(stops, 1.0),
                "warp": warp(*turbulence, *scale),
            }),
            Self::Granite { stops, scale, .. } => json!({
                "kind": "turbulence",
                "turbulence": { "size": scale, "octaves": OCTAVES, "absolute": true },
                "bias": -1.0,
                "contrast": 4.0,
                "stops": spread(stops, 1.0),
            }),
        })
    }
}

impl Normal {
    /// The bump: a slope of up to `amount` on cells of the size `scale`.
    pub fn bump(&self) -> Value {
        let Self::Bumps { amount, scale } = self;
        json!({ "kind": "noise", "height": amount * scale, "turbulence": { "size": scale, "octaves": 1 } })
    }
}

/// POV-Ray's default.
const OCTAVES: u32 = 6;

fn warp(turbulence: f64, scale: f64) -> Value {
    json!({ "amount": turbulence * scale, "turbulence": { "size": scale, "octaves": OCTAVES } })
}

fn colour_at(stops: &Stops, value: f64) -> [f64; 3] {
    stops.iter().rfind(|(at, _)| *at <= value).map_or([0.0; 3], |(_, colour)| *colour)
}

/// The stops from 0 to `last`, spread over −1 to 1.
fn spread(stops: &Stops, last: f64) -> Vec<Value> {
    let within = stops.iter().filter(|(at, _)| *at <= last);
    within.map(|(at, colour)| json!({ "at": 2.0 * at / last - 1.0, "colour": colour })).collect()
}
