//! Solid textures (§ 6.3.4): a colour at every point of space, out of which the object is carved.
//!
//! Points are in the texture's own space, which the caller moves with the object. Colours are linear RGB. Nothing here asks
//! the platform for a sine or a power, so a texture is the same to the last bit on every machine.

mod checker;
mod gradient;
mod marble;
mod mottled;
mod noise;
pub(super) mod random;
#[cfg(test)]
pub(super) mod testing;
mod turbulence;
mod undulate;
mod wood;

pub use checker::Checker;
pub use gradient::Gradient;
pub use marble::Marble;
pub use mottled::{Mottle, Mottled};
pub use noise::{Noise, NoiseKind};
pub use turbulence::Turbulence;
pub use undulate::ColourSpline;
pub use wood::{Wood, WoodGrain};

use crate::record::{Binding, Entry, NullRecorder, Recorder};
use glam::DVec3;

/// What a block is made of.
#[derive(Clone, Debug, PartialEq)]
pub enum Pattern {
    /// Cubes of two colours.
    Checker(Checker),
    /// Layers along an axis.
    Gradient(Gradient),
    /// The rings of a log.
    Wood(Wood),
    /// Noise or turbulence as a colour.
    Mottled(Mottled),
    /// Veins.
    Marble(Marble),
}

/// A solid texture: a pattern, and perhaps a warp before it.
#[derive(Clone, Debug, PartialEq)]
pub struct SolidTexture {
    /// The pattern.
    pub pattern: Pattern,
    /// What moves each point before the pattern is asked.
    pub warp: Option<Warp>,
}

/// A displacement by turbulence: p′ = p + A (T₁, T₂, T₃), each T the turbulence at another place far away from the others.
///
/// POV-Ray's `turbulence` is one with 6 octaves.
#[derive(Clone, Debug, PartialEq)]
pub struct Warp {
    /// The turbulence.
    pub turbulence: Turbulence,
    /// A: how far, along x, y and z, for a turbulence of 1.
    pub amount: DVec3,
}

impl Warp {
    /// Where a point is moved to, told component by component.
    pub fn moved(&self, p: DVec3, recorder: &mut impl Recorder) -> DVec3 {
        const LINES: [(&str, &str); 3] = [("p′_x", "p_x + A T"), ("p′_y", "p_y + A T"), ("p′_z", "p_z + A T")];
        const FROM: [&str; 3] = ["p_x", "p_y", "p_z"];
        let places = self.turbulence.places(p);
        DVec3::from_array(std::array::from_fn(|axis| {
            let (from, amount) = (p[axis], self.amount[axis]);
            let sum = self.turbulence.told_with(places[axis], recorder, |entry, sum| {
                let bindings: [Binding; 3] = [(FROM[axis], from.into()), ("A", amount.into()), ("T", sum.into())];
                entry.line(LINES[axis].0, LINES[axis].1, &bindings, from + amount * sum)
            });
            from + amount * sum
        }))
    }
}

impl SolidTexture {
    /// The colour at a point of the texture's space. The parts tell how it came about; the event around them is the
    /// caller's, who adds [`lines`](Self::lines) to it.
    pub fn colour(&self, p: DVec3, recorder: &mut impl Recorder) -> DVec3 {
        let p = self.place(p, recorder);
        match &self.pattern {
            Pattern::Checker(checker) => checker.colour(p),
            Pattern::Gradient(gradient) => gradient.colour(p, recorder),
            Pattern::Wood(wood) => wood.colour(p, recorder),
            Pattern::Mottled(mottled) => mottled.colour(p, recorder),
            Pattern::Marble(marble) => marble.colour(p, recorder),
        }
    }

    /// Adds the working of patterns without events of their own to the description of the look-up.
    #[must_use]
    pub fn lines(&self, p: DVec3, entry: Entry) -> Entry {
        match &self.pattern {
            Pattern::Checker(checker) => checker.lines(self.place(p, &mut NullRecorder), entry),
            _ => entry,
        }
    }

    /// Stirs all noise to another time.
    pub fn at_time(&mut self, time: f64) {
        if let Some(warp) = &mut self.warp {
            warp.turbulence.noise.at_time(time);
        }
        match &mut self.pattern {
            Pattern::Checker(_) | Pattern::Gradient(_) => {}
            Pattern::Wood(wood) => wood.at_time(time),
            Pattern::Mottled(mottled) => mottled.at_time(time),
            Pattern::Marble(marble) => marble.at_time(time),
        }
    }

    /// All turbulences in it.
    pub fn turbulences_mut(&mut self) -> impl Iterator<Item = &mut Turbulence> {
        let of_pattern = match &mut self.pattern {
            Pattern::Checker(_) | Pattern::Gradient(_) => None,
            Pattern::Wood(wood) => wood.turbulence_mut(),
            Pattern::Mottled(mottled) => mottled.turbulence_mut(),
            Pattern::Marble(marble) => Some(marble.turbulence_mut()),
        };
        self.warp.as_mut().map(|warp| &mut warp.turbulence).into_iter().chain(of_pattern)
    }

    fn place(&self, p: DVec3, recorder: &mut impl Recorder) -> DVec3 {
        self.warp.as_ref().map_or(p, |warp| warp.moved(p, recorder))
    }
}

#[cfg(test)]
mod tests {
    use super::testing::{Kept, assert_every_line_holds, points};
    use super::*;
    use crate::record::What;

    fn texture(warp: Option<Warp>) -> SolidTexture {
        let checker = Checker::new(DVec3::splat(0.1), 0.7, DVec3::ONE, DVec3::ZERO).unwrap();
        SolidTexture { pattern: Pattern::Checker(checker), warp }
    }

    fn warp() -> Warp {
        let noise = Noise::new(NoiseKind::Gradient, 4);
        Warp { turbulence: Turbulence::new(noise, 1.0, 6, 0.5, false).unwrap(), amount: DVec3::new(0.4, 0.8, 0.2) }
    }

    #[test]
    fn a_warp_moves_the_point_before_the_pattern_is_asked() {
        let (plain, warped, warp) = (texture(None), texture(Some(warp())), warp());
        for p in points(300, 6.0) {
            let moved = warp.moved(p, &mut NullRecorder);
            assert_eq!(warped.colour(p, &mut NullRecorder), plain.colour(moved, &mut NullRecorder));
        }
    }

    #[test]
    fn the_components_of_a_warp_have_nothing_in_common() {
        let warp = Warp { amount: DVec3::ONE, ..warp() };
        let moves: Vec<_> = points(20_000, 1000.0).map(|p| warp.moved(p, &mut NullRecorder) - p).collect();
        let mean = |f: &dyn Fn(&DVec3) -> f64| moves.iter().map(f).sum::<f64>() / moves.len() as f64;
        let variance = mean(&|v| v.length_squared()) / 3.0;
        // The mean of a product of two unrelated ones is off by variance / √n.
        for (i, j) in [(0, 1), (0, 2), (1, 2)] {
            assert!(mean(&|v| v[i] * v[j]).abs() < 5.0 * variance / (moves.len() as f64).sqrt());
        }
    }

    #[test]
    fn a_warps_working_holds_and_ends_in_the_moved_point() {
        let (warp, texture) = (warp(), texture(Some(warp())));
        for p in points(50, 6.0) {
            let mut kept = Kept::default();
            assert_eq!(texture.colour(p, &mut kept), texture.colour(p, &mut NullRecorder));
            let moved: Vec<_> = kept
                .0
                .iter()
                .filter(|entry| matches!(entry.what, What::Octaves(_)))
                .filter_map(|entry| entry.working.last().map(|line| line.result))
                .collect();
            assert_eq!(moved, warp.moved(p, &mut NullRecorder).to_array().map(Into::into));
            let entry = Entry::new(What::Ambient { colour: [0.0; 3] });
            kept.0.push(texture.lines(p, entry));
            assert_every_line_holds(&kept);
        }
    }

    #[test]
    fn time_stirs_what_has_noise_and_leaves_the_rest() {
        let (mut warped, mut plain) = (texture(Some(warp())), texture(None));
        let (before, unstirred) = (warped.clone(), plain.clone());
        warped.at_time(3.0);
        plain.at_time(3.0);
        assert_eq!(plain, unstirred);
        assert_ne!(warped, before);
        // The time counts, and not the way there.
        warped.at_time(0.0);
        assert_eq!(warped, before);
    }
}
