//! Frames (§ 6.3.3): the grain of a surface, along which it scatters light otherwise than across.
//!
//! The frame is T along the grain, N outwards, and B = T × N. (T, B, N) is left-handed, then; a highlight, which takes
//! squares of what lies along T and along B, does not ask. (The notes print "B × T × N".)
//!
//! A procedure turns T about N by an angle and tilts N by slopes s_t and s_b: T₁ = T cos α + B sin α, B₁ = T₁ × N,
//! N′ = (N + s_t T₁ + s_b B₁) / |…|, T′ is T₁ made square to N′ again, and B′ = T′ × N′.
//!
//! **Source** J. Kajiya, "Anisotropic reflection models", SIGGRAPH 1985.

use super::super::solid::{Noise, Turbulence};
use super::site::Site;
use crate::math::sine_cosine;
use crate::record::{Binding, Entry, FrameMap, Recorder, What};
use glam::{DVec2, DVec3};

/// Tangent along the grain, T × N, and the normal, all unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// T.
    pub tangent: DVec3,
    /// B = T × N.
    pub binormal: DVec3,
    /// N.
    pub normal: DVec3,
}

impl Frame {
    /// The frame with T as near to `along` as the unit normal lets it be; where `along` is zero or along the normal, T is any
    /// direction across it.
    #[must_use]
    pub fn new(along: DVec3, normal: DVec3) -> Self {
        let across = along - normal * normal.dot(along);
        // What is left after such a cancellation has no digits.
        let is_lost = across.length_squared() <= 1e-24 * along.length_squared();
        let tangent = if is_lost { None } else { across.try_normalize() };
        let tangent = tangent.unwrap_or_else(|| normal.any_orthonormal_vector());
        Self { tangent, binormal: tangent.cross(normal), normal }
    }

    fn triples(&self) -> [[f64; 3]; 3] {
        [self.tangent, self.binormal, self.normal].map(|v| v.to_array())
    }
}

/// Where the grain comes from.
#[derive(Clone, Debug, PartialEq)]
pub enum Grain {
    /// Brushed metal: streaks along u, each turned a little by noise that is stretched along them.
    Brushed {
        /// The noise.
        noise: Noise,
        /// Cells of the noise to a unit of u and of v; the second is the larger one.
        scale: DVec2,
        /// How far the grain turns for a noise of 1, in degrees.
        turn: f64,
        /// How far the normal tilts across the grain for a noise of 1, as a slope.
        tilt: f64,
    },
    /// Cloth: threads along u and along v pass over each other in turn, each round like a cylinder.
    Woven {
        /// Threads to a unit of u and of v.
        threads: DVec2,
        /// The slope of a thread at its edges.
        tilt: f64,
    },
    /// Wood: the grain along an axis of the texture's space, turned by turbulence.
    Fibre {
        /// The axis, in the texture's space.
        axis: DVec3,
        /// The turbulence.
        turbulence: Turbulence,
        /// How far the grain turns for a turbulence of 1, in degrees.
        turn: f64,
    },
}

/// What a procedure asks for.
struct Change {
    /// Where T lies before.
    along: DVec3,
    /// α in degrees.
    turn: f64,
    /// s_t and s_b.
    tilt: [f64; 2],
}

impl Grain {
    /// The name, as scene files spell it.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Brushed { .. } => "brushed",
            Self::Woven { .. } => "woven",
            Self::Fibre { .. } => "grain",
        }
    }

    /// The turbulence, if there is one.
    pub fn turbulence_mut(&mut self) -> Option<&mut Turbulence> {
        match self {
            Self::Fibre { turbulence, .. } => Some(turbulence),
            Self::Brushed { .. } | Self::Woven { .. } => None,
        }
    }

    /// Stirs noise to another time.
    pub fn at_time(&mut self, time: f64) {
        match self {
            Self::Brushed { noise, .. } | Self::Fibre { turbulence: Turbulence { noise, .. }, .. } => {
                noise.at_time(time);
            }
            Self::Woven { .. } => {}
        }
    }

    /// The frame at a place. `roughness`, along the grain and across it, is only passed on to the record.
    pub fn frame<R: Recorder>(&self, site: &Site, roughness: [f64; 2], recorder: &mut R) -> Frame {
        recorder.begin();
        let change = self.change(site, recorder);
        let before = Frame::new(change.along, site.normal);
        let turned = turned(before, change.turn);
        let after = tilted(turned, change.tilt);
        recorder.end(|| describe(self.name(), &change, [before, turned, after], roughness));
        after
    }

    fn change(&self, site: &Site, recorder: &mut impl Recorder) -> Change {
        let along_u = site.tangents[0];
        match self {
            Self::Brushed { noise, scale, turn, tilt } => {
                let noise = noise.told((site.uv * *scale).extend(0.5), recorder);
                Change { along: along_u, turn: turn * noise, tilt: [0.0, tilt * noise] }
            }
            Self::Woven { threads, tilt } => {
                let place = site.uv * *threads;
                let thread = place.floor();
                let from_middle = place - thread - 0.5;
                let is_along_u = (thread.x + thread.y) * 0.5 == ((thread.x + thread.y) * 0.5).floor();
                // T × N points against v where T points along u, and along u where T points along v, if P_u × P_v does
                // outwards; otherwise the other way round.
                let side = if along_u.cross(site.tangents[1]).dot(site.normal) < 0.0 { -1.0 } else { 1.0 };
                let (along, offset) = if is_along_u {
                    (along_u, -side * from_middle.y)
                } else {
                    (site.tangents[1], side * from_middle.x)
                };
                Change { along, turn: 0.0, tilt: [0.0, 2.0 * tilt * offset] }
            }
            Self::Fibre { axis, turbulence, turn } => {
                let degrees = turn * turbulence.told(site.texture_point, recorder);
                let along = site.texture_from_world.inverse() * *axis;
                // End grain has no direction of its own.
                let is_end = along.normalize_or_zero().cross(site.normal).length_squared() < 1e-12;
                Change { along: if is_end { along_u } else { along }, turn: degrees, tilt: [0.0; 2] }
            }
        }
    }
}

/// The frame turned about its normal.
fn turned(frame: Frame, degrees: f64) -> Frame {
    let (sine, cosine) = sine_cosine(degrees.to_radians());
    let tangent = frame.tangent * cosine + frame.binormal * sine;
    Frame { tangent, binormal: tangent.cross(frame.normal), normal: frame.normal }
}

/// The frame with its normal tilted.
fn tilted(frame: Frame, [along, across]: [f64; 2]) -> Frame {
    if along == 0.0 && across == 0.0 {
        return frame;
    }
    let sum = frame.normal + frame.tangent * along + frame.binormal * across;
    Frame::new(frame.tangent, sum / sum.length())
}

fn describe(name: &str, change: &Change, [before, turned, after]: [Frame; 3], roughness: [f64; 2]) -> Entry {
    let [s_t, s_b] = change.tilt;
    let bindings: Vec<Binding> = vec![
        ("P", change.along.to_array().into()),
        ("T", before.tangent.to_array().into()),
        ("B", before.binormal.to_array().into()),
        ("N", before.normal.to_array().into()),
        ("α", change.turn.into()),
        ("s_t", s_t.into()),
        ("s_b", s_b.into()),
        ("T₁", turned.tangent.to_array().into()),
        ("B₁", turned.binormal.to_array().into()),
        ("N′", after.normal.to_array().into()),
        ("T′", after.tangent.to_array().into()),
    ];
    Entry::new(What::FrameMap(FrameMap {
        frame: name.to_owned(),
        turn: change.turn,
        tilt: change.tilt,
        before: before.triples(),
        after: after.triples(),
        roughness,
    }))
    .line("B", "T × N", &bindings, before.binormal.to_array())
    .line("T₁", "T cos(α) + B sin(α)", &bindings, turned.tangent.to_array())
    .line("B₁", "T₁ × N", &bindings, turned.binormal.to_array())
    .line("N′", "(N + s_t T₁ + s_b B₁) / |N + s_t T₁ + s_b B₁|", &bindings, after.normal.to_array())
    .line("T′", "(T₁ − (T₁ · N′) N′) / |T₁ − (T₁ · N′) N′|", &bindings, after.tangent.to_array())
    .line("B′", "T′ × N′", &bindings, after.binormal.to_array())
}

#[cfg(test)]
mod tests {
    use super::super::super::solid::NoiseKind;
    use super::super::super::solid::testing::{Kept, assert_every_line_holds, points};
    use super::*;
    use crate::record::NullRecorder;
    use glam::DMat3;

    fn grains() -> Vec<Grain> {
        let noise = Noise::new(NoiseKind::Gradient, 3);
        let turbulence = Turbulence::new(noise.clone(), 1.3, 4, 0.5, false).unwrap();
        vec![
            Grain::Brushed { noise, scale: DVec2::new(2.0, 90.0), turn: 20.0, tilt: 0.1 },
            Grain::Woven { threads: DVec2::new(30.0, 20.0), tilt: 0.6 },
            Grain::Fibre { axis: DVec3::new(0.1, 1.0, 0.2), turbulence, turn: 30.0 },
        ]
    }

    fn place(p: DVec3, flip: f64) -> Site {
        Site {
            texture_point: p,
            texture_from_world: DMat3::from_rotation_z(0.3) * 2.0,
            uv: p.truncate().abs(),
            tangents: [DVec3::new(2.0, 0.1, 0.0), DVec3::new(0.3, 1.5 * flip, 0.0)],
            normal: DVec3::Z,
        }
    }

    fn is_square(Frame { tangent: t, binormal: b, normal: n }: Frame) -> bool {
        [t, b, n].iter().all(|v| (v.length() - 1.0).abs() < 1e-14)
            && t.dot(n).abs() < 1e-14
            && (t.cross(n) - b).length() < 1e-14
    }

    #[test]
    fn frames_are_square_and_their_working_holds() {
        for grain in grains() {
            let mut kept = Kept::default();
            for p in points(100, 3.0) {
                let site = place(p, 1.0);
                let told = grain.frame(&site, [0.1, 0.4], &mut kept);
                assert_eq!(told, grain.frame(&site, [0.1, 0.4], &mut NullRecorder));
                assert!(is_square(told), "{}: {told:?}", grain.name());
            }
            assert_every_line_holds(&kept);
        }
    }

    #[test]
    fn a_thread_is_round_it_tilts_outwards_on_both_sides_of_its_middle() {
        let cloth = Grain::Woven { threads: DVec2::ONE, tilt: 0.5 };
        for flip in [1.0, -1.0] {
            let site = |u: f64, v: f64| Site {
                uv: DVec2::new(u, v),
                tangents: [DVec3::X, DVec3::Y * flip],
                ..place(DVec3::ZERO, flip)
            };
            let frame = |u: f64, v: f64| cloth.frame(&site(u, v), [0.1; 2], &mut NullRecorder);
            // Thread (0, 0) runs along u, thread (1, 0) along v.
            assert_eq!(frame(0.5, 0.5), Frame::new(DVec3::X, DVec3::Z));
            assert!(frame(0.5, 0.9).normal.y * flip > 0.1 && frame(0.5, 0.1).normal.y * flip < -0.1);
            assert!(frame(1.9, 0.5).normal.x > 0.1 && frame(1.1, 0.5).normal.x < -0.1);
            assert!((frame(1.5, 0.5).tangent - DVec3::Y * flip).length() < 1e-15);
        }
    }

    #[test]
    fn the_fibres_run_along_their_axis_and_end_grain_does_no_harm() {
        let Grain::Fibre { turbulence, .. } = grains().remove(2) else { panic!("fibre") };
        let site = place(DVec3::ZERO, 1.0);
        let along = |axis: DVec3| {
            Grain::Fibre { axis: site.texture_from_world * axis, turbulence: turbulence.clone(), turn: 0.0 }.frame(
                &site,
                [0.1; 2],
                &mut NullRecorder,
            )
        };
        assert!((along(DVec3::new(0.0, 2.0, 1.0)).tangent - DVec3::Y).length() < 1e-14);
        assert!(is_square(along(DVec3::Z)) && is_square(along(DVec3::ZERO)));
    }

    #[test]
    fn where_u_has_no_direction_there_is_a_frame_all_the_same() {
        for along in [DVec3::ZERO, DVec3::Z, DVec3::new(1e-20, 0.0, 1.0)] {
            assert!(is_square(Frame::new(along, DVec3::Z)));
        }
    }
}
