//! Wood (§ 6.3.5): rings(r) = ⌊r⌋ mod 2, light or dark, about any axis, wobbling and twisting.
//!
//! With h the height along the log's axis, r the distance from it and θ the angle about it, the ring is
//! q = r / M + K sin(k θ + t h) + A turb(p): M is the width of a ring, K the wobble in rings, k its lobes, t the twist in
//! radians for a unit of length, and A stirs the radius, in rings. ⌊q⌋ rounds down, so that rings below zero (a wobble in the
//! middle of the log) alternate as well; the chapter's `(int)` is right for r ≥ 0 only.
//!
//! sin kθ comes from the k-th power of (x + i y) / r: no angle is ever worked out.
//!
//! **Source** Hill, Computer Graphics Using OpenGL, the grain in wood: rings(r / M + K sin(θ / N + f z)).

use super::noise::fade;
use super::turbulence::Turbulence;
use crate::math::{portable, sine_cosine};
use crate::record::{Binding, Entry, Recorder, Rings, What};
use glam::DVec3;
use std::f64::consts::PI;

/// How a log is grown.
#[derive(Clone, Debug, PartialEq)]
pub struct WoodGrain {
    /// A point of the log's axis.
    pub point: DVec3,
    /// Where the axis goes; any length but zero.
    pub axis: DVec3,
    /// M: the width of a ring.
    pub ring_width: f64,
    /// K: how far the rings wobble, in rings.
    pub wobble: f64,
    /// k: how often they do so around the log.
    pub lobes: u32,
    /// t: how far the wobble turns in a unit of length along the axis, in radians.
    pub twist: f64,
    /// A turbulence that stirs the rings, and by how many rings.
    pub stirring: Option<(Turbulence, f64)>,
    /// The colour of rings with an even number.
    pub light: DVec3,
    /// The colour of rings with an odd number.
    pub dark: DVec3,
    /// How wide the change from one to the other is, in rings: 0 is a jump, 1 changes all the way.
    pub edge: f64,
}

/// A log, with its axis made ready.
#[derive(Clone, Debug, PartialEq)]
pub struct Wood {
    grain: WoodGrain,
    /// Two unit vectors across the axis, and the axis.
    frame: [DVec3; 3],
}

/// The point in the log's own coordinates.
struct Place {
    x: f64,
    y: f64,
    height: f64,
    radius: f64,
    /// sin(k θ + t h).
    wave: f64,
}

impl Wood {
    /// A log.
    ///
    /// # Errors
    /// Where the axis is zero, the width not positive, there are more than 64 lobes, or the edge is not from 0 to 1.
    pub fn new(grain: WoodGrain) -> Result<Self, String> {
        let axis = grain.axis.normalize_or_zero();
        if axis == DVec3::ZERO || !grain.point.is_finite() {
            return Err(format!("the axis of wood needs a direction, not {}", grain.axis));
        }
        if !(grain.ring_width > 0.0 && grain.ring_width.is_finite()) {
            return Err(format!("the width of a ring must be more than 0, not {}", grain.ring_width));
        }
        if grain.lobes > 64 {
            return Err(format!("wood wobbles at most 64 times around, not {}", grain.lobes));
        }
        if !(0.0..=1.0).contains(&grain.edge) {
            return Err(format!("the edge of a ring is from 0 to 1 ring wide, not {}", grain.edge));
        }
        if !(grain.wobble.is_finite() && grain.twist.is_finite() && grain.light.is_finite() && grain.dark.is_finite()) {
            return Err("the wobble, the twist and the colours of wood must be finite".to_owned());
        }
        let (across, up) = axis.any_orthonormal_pair();
        Ok(Self { grain, frame: [across, up, axis] })
    }

    /// What stirs the rings, if anything does.
    pub fn turbulence_mut(&mut self) -> Option<&mut Turbulence> {
        self.grain.stirring.as_mut().map(|(turbulence, _)| turbulence)
    }

    /// Stirs the noise to another time.
    pub fn at_time(&mut self, time: f64) {
        if let Some((turbulence, _)) = &mut self.grain.stirring {
            turbulence.noise.at_time(time);
        }
    }

    /// The colour at a point.
    pub fn colour(&self, p: DVec3, recorder: &mut impl Recorder) -> DVec3 {
        recorder.begin();
        let place = self.place(p);
        let turbulence = self.grain.stirring.as_ref().map(|(turbulence, share)| (turbulence.told(p, recorder), *share));
        let stirred = place.radius / self.grain.ring_width
            + self.grain.wobble * place.wave
            + turbulence.map_or(0.0, |(turbulence, share)| share * turbulence);
        let (ring, colour) = self.ring(stirred);
        recorder.end(|| self.describe(p, &place, turbulence, [stirred, ring], colour));
        colour
    }

    fn place(&self, p: DVec3) -> Place {
        let [x, y, height] = self.frame.map(|axis| axis.dot(p - self.grain.point));
        let radius = (x * x + y * y).sqrt();
        let (cosine, sine) = if radius > 0.0 { (x / radius, y / radius) } else { (1.0, 0.0) };
        let (sine_phase, cosine_phase) = sine_cosine(self.grain.twist * height);
        let (mut c, mut s) = (cosine_phase, sine_phase);
        for _ in 0..self.grain.lobes {
            (c, s) = (c * cosine - s * sine, s * cosine + c * sine);
        }
        Place { x, y, height, radius, wave: s }
    }

    /// ⌊q⌋, and the colour.
    fn ring(&self, stirred: f64) -> (f64, DVec3) {
        let ring = stirred.floor();
        let (light, dark, edge) = (self.grain.light, self.grain.dark, self.grain.edge);
        if edge == 0.0 {
            return (ring, if is_odd(ring) { dark } else { light });
        }
        let [boundary, across] = self.boundary(stirred);
        let (below, above) = if is_odd(boundary) { (light, dark) } else { (dark, light) };
        (ring, below + (above - below) * fade(across))
    }

    /// The nearest boundary between two rings, and how far its edge is crossed, from 0 to 1.
    fn boundary(&self, stirred: f64) -> [f64; 2] {
        let boundary = (stirred + 0.5).floor();
        [boundary, (0.5 + (stirred - boundary) / self.grain.edge).clamp(0.0, 1.0)]
    }

    fn describe(
        &self,
        p: DVec3,
        place: &Place,
        turbulence: Option<(f64, f64)>,
        [stirred, ring]: [f64; 2],
        colour: DVec3,
    ) -> Entry {
        let Place { x, y, height, radius, wave } = *place;
        let grain = &self.grain;
        let (angle, degrees) = angle_about_axis(place);
        let (noise, share) = turbulence.unwrap_or_default();
        let bindings: Vec<Binding> = vec![
            ("p", p.to_array().into()),
            ("c", grain.point.to_array().into()),
            ("e₁", self.frame[0].to_array().into()),
            ("e₂", self.frame[1].to_array().into()),
            ("a", self.frame[2].to_array().into()),
            ("x", x.into()),
            ("y", y.into()),
            ("h", height.into()),
            ("r", radius.into()),
            ("θ", degrees.into()),
            ("k", f64::from(grain.lobes).into()),
            ("t", grain.twist.into()),
            ("π", PI.into()),
            ("w", wave.into()),
            ("M", grain.ring_width.into()),
            ("K", grain.wobble.into()),
            ("A", share.into()),
            ("T", noise.into()),
            ("q", stirred.into()),
        ];
        let rings = Rings { radius, stirred, ring, dark: is_odd(ring) };
        let entry = Entry::new(What::Rings(rings))
            .line("x", "(p − c) · e₁", &bindings, x)
            .line("y", "(p − c) · e₂", &bindings, y)
            .line("h", "(p − c) · a", &bindings, height)
            .line("r", "√(x² + y²)", &bindings, radius);
        let is_turned = radius > 0.0 && grain.lobes > 0;
        let entry = if is_turned { entry.line("θ", angle, &bindings, degrees) } else { entry };
        let wave_formula = if is_turned { "sin(k θ + 180 t h / π)" } else { "sin(180 t h / π)" };
        let entry = entry
            .line("w", wave_formula, &bindings, wave)
            .line("q", if turbulence.is_some() { "r / M + K w + A T" } else { "r / M + K w" }, &bindings, stirred)
            .line("⌊q⌋", "⌊q⌋", &bindings, ring)
            .line("dark", "⌊q⌋ mod 2 = 1", &bindings, is_odd(ring));
        if grain.edge == 0.0 { entry } else { self.describe_edge(entry, stirred, colour) }
    }

    fn describe_edge(&self, entry: Entry, stirred: f64, colour: DVec3) -> Entry {
        let [boundary, across] = self.boundary(stirred);
        let bindings: Vec<Binding> = vec![
            ("q", stirred.into()),
            ("b", boundary.into()),
            ("E", self.grain.edge.into()),
            ("f", across.into()),
            ("s", fade(across).into()),
            ("L", self.grain.light.to_array().into()),
            ("D", self.grain.dark.to_array().into()),
        ];
        let mix = if is_odd(boundary) { "L + s (D − L)" } else { "D + s (L − D)" };
        entry
            .line("b", "⌊q + 0.5⌋", &bindings, boundary)
            .line("f", "min(1, max(0, 0.5 + (q − b) / E))", &bindings, across)
            .line("s", "6 f⁵ − 15 f⁴ + 10 f³", &bindings, fade(across))
            .line("C", mix, &bindings, colour.to_array())
    }
}

/// The angle about the axis in degrees, for the reader alone. Half angles have no jump within either half of the log.
fn angle_about_axis(place: &Place) -> (&'static str, f64) {
    let Place { x, y, radius, .. } = *place;
    if x < 0.0 {
        ("180 − 2 arctan(y / (r − x))", 180.0 - 2.0 * portable::atan(y / (radius - x)).to_degrees())
    } else {
        ("2 arctan(y / (r + x))", 2.0 * portable::atan(y / (radius + x)).to_degrees())
    }
}

/// Whether a whole number is odd, also where it is negative or very large.
pub(super) fn is_odd(whole: f64) -> bool {
    whole - 2.0 * (whole * 0.5).floor() == 1.0
}

#[cfg(test)]
mod tests {
    use super::super::noise::{Noise, NoiseKind};
    use super::super::testing::{Kept, assert_every_line_holds, points};
    use super::*;
    use crate::record::NullRecorder;

    fn plain() -> WoodGrain {
        WoodGrain {
            point: DVec3::ZERO,
            axis: DVec3::Z,
            ring_width: 1.0,
            wobble: 0.0,
            lobes: 0,
            twist: 0.0,
            stirring: None,
            light: DVec3::ONE,
            dark: DVec3::ZERO,
            edge: 0.0,
        }
    }

    fn stirred() -> WoodGrain {
        let turbulence = Turbulence::new(Noise::new(NoiseKind::Gradient, 2), 0.7, 3, 0.5, false).unwrap();
        let axis = DVec3::new(0.2, -1.0, 0.4);
        WoodGrain { axis, wobble: 0.2, lobes: 5, twist: 0.8, stirring: Some((turbulence, 0.6)), ..plain() }
    }

    fn colour(grain: &WoodGrain, p: [f64; 3]) -> f64 {
        Wood::new(grain.clone()).unwrap().colour(p.into(), &mut NullRecorder).x
    }

    #[test]
    fn rings_alternate_from_light_in_the_middle() {
        for (x, expected) in [(0.0, 1.0), (0.5, 1.0), (0.999, 1.0), (1.0, 0.0), (-1.5, 0.0), (2.5, 1.0), (-3.5, 0.0)] {
            assert_eq!(colour(&plain(), [x, 0.0, 7.0]), expected, "{x}");
        }
        assert_eq!(colour(&plain(), [0.9, 0.9, 0.0]), 0.0);
    }

    #[test]
    fn rings_below_zero_alternate_as_well() {
        // In the middle q = K sin(t h): −1.5 rings, which truncation would call ring −1 and leave without a remainder of 1.
        let grain = WoodGrain { wobble: 1.5, twist: 1.0, ..plain() };
        assert_eq!(colour(&grain, [0.0, 0.0, -PI / 2.0]), 1.0);
        assert_eq!(colour(&WoodGrain { wobble: 0.5, ..grain }, [0.0, 0.0, -PI / 2.0]), 0.0);
        assert!(is_odd(-1.0) && is_odd(-3.0) && is_odd(5.0) && !is_odd(0.0) && !is_odd(-2.0) && !is_odd(1e300));
    }

    #[test]
    fn the_wobble_is_the_sine_of_the_angle() {
        let wood = Wood::new(WoodGrain { lobes: 7, twist: 0.3, ..plain() }).unwrap();
        for p in points(1000, 5.0) {
            let [x, y] = [wood.frame[0].dot(p), wood.frame[1].dot(p)];
            let expected = (7.0 * y.atan2(x) + 0.3 * p.z).sin();
            assert!((wood.place(p).wave - expected).abs() < 1e-14);
        }
    }

    #[test]
    fn twisted_wood_repeats_along_its_axis_when_a_lobe_has_come_round() {
        let grain = WoodGrain { wobble: 0.4, lobes: 6, twist: 2.0, edge: 1.0, ..plain() };
        for p in points(200, 5.0) {
            let (here, there) = (colour(&grain, p.into()), colour(&grain, (p + DVec3::Z * PI).into()));
            assert!((here - there).abs() < 1e-12);
        }
    }

    #[test]
    fn a_soft_edge_is_half_way_where_the_hard_one_jumps() {
        let soft = WoodGrain { edge: 0.2, ..plain() };
        for (x, expected) in [(0.5, 1.0), (0.89, 1.0), (1.0, 0.5), (1.11, 0.0), (2.0, 0.5), (1.95, 0.103_515_625)] {
            assert!((colour(&soft, [x, 0.0, 0.0]) - expected).abs() < 1e-12, "{x}");
        }
    }

    #[test]
    fn its_working_holds_and_watching_changes_nothing() {
        for edge in [0.0, 0.3] {
            for grain in [plain(), stirred()] {
                let wood = Wood::new(WoodGrain { edge, ..grain }).unwrap();
                let mut kept = Kept::default();
                let special = [DVec3::ZERO, DVec3::NEG_X, DVec3::new(-2.0, 1e-7, 0.0), DVec3::Y];
                for p in points(200, 5.0).chain(special) {
                    assert_eq!(wood.colour(p, &mut kept), wood.colour(p, &mut NullRecorder));
                }
                assert_every_line_holds(&kept);
            }
        }
    }

    #[test]
    fn wrong_parameters_are_named() {
        for (grain, word) in [
            (WoodGrain { axis: DVec3::ZERO, ..plain() }, "axis"),
            (WoodGrain { ring_width: 0.0, ..plain() }, "width"),
            (WoodGrain { lobes: 65, ..plain() }, "64"),
            (WoodGrain { edge: 1.5, ..plain() }, "edge"),
            (WoodGrain { twist: f64::NAN, ..plain() }, "finite"),
        ] {
            assert!(Wood::new(grain).unwrap_err().contains(word));
        }
    }
}
