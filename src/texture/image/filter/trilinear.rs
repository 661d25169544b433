//! Bilinear look-ups in two levels of the pyramid, and the way between them.
//!
//! Source: L. Williams, Pyramidal Parametrics, SIGGRAPH 1983.

use super::{Ground, bilinear};
use crate::math::portable;
use crate::record::{Entry, Recorder, Texels, What};
use crate::texture::image::footprint::Footprint;
use glam::{DVec2, DVec3};

/// The colour at `point` at the level λ = log₂ of the footprint's longest side. The two look-ups are the parts of this event,
/// which itself lists no texels.
pub(super) fn colour(ground: Ground, point: DVec2, footprint: &Footprint, recorder: &mut impl Recorder) -> DVec3 {
    let side = footprint.longest_side();
    let level = portable::log2(side.max(1.0)).min((ground.texels.levels() - 1) as f64);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and the number of levels")]
    let fine = level as usize;
    let share = level - level.floor();
    recorder.begin();
    let first = bilinear::colour(ground, fine, point, recorder);
    let second = if share > 0.0 { bilinear::colour(ground, fine + 1, point, recorder) } else { first };
    let colour = first * (1.0 - share) + second * share;
    recorder.end(|| {
        let bindings = [("f", share.into()), ("c₀", first.to_array().into()), ("c₁", second.to_array().into())];
        Entry::new(What::Texels(Texels {
            filter: "trilinear".to_owned(),
            level,
            texels: Vec::new(),
            left_out: 0,
            colour: colour.to_array(),
        }))
        .line("colour", "(1 − f) c₀ + f c₁", &bindings, colour.to_array())
    });
    colour
}
