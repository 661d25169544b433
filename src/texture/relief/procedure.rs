//! Bumps by procedure: noise, ripples and facets, all functions of the point in the texture's own space.
//!
//! A height b(q) over all space gives the slopes on a surface by the chain rule: b_u = ∇b · (M P_u), with M the linear part of
//! the map from world space to the texture's. So no (u, v) need be laid over the surface without seams.
//!
//! Facets are no height: each cube of space tilts the normal its own way, so that the surface looks beaten flat in places.

use super::super::solid::random::Random;
use super::super::solid::{Noise, Turbulence};
use super::bump::{BumpDerivative, Rise, raised};
use super::site::Site;
use crate::math::sine_cosine;
use crate::record::{Binding, Bump as Record, Entry, Recorder, What};
use glam::DVec3;
use std::f64::consts::TAU;

/// Bumps by procedure.
#[derive(Clone, Debug, PartialEq)]
pub enum Bump {
    /// Height by turbulence: b = `height` · turb(q).
    Noise {
        /// The turbulence.
        turbulence: Turbulence,
        /// The height for a turbulence of 1, in the world's units.
        height: f64,
    },
    /// Concentric ripples: b = `height` · cos(2π (|q − centre| / `wavelength` − `phase`)).
    Waves {
        /// Where they come from.
        centre: DVec3,
        /// The distance from crest to crest; more than 0.
        wavelength: f64,
        /// How high a crest is, in the world's units.
        height: f64,
        /// How many wavelengths the crests have moved outwards.
        phase: f64,
    },
    /// Flat places, tilted at random.
    Facets(Facets),
}

/// Cubes of space that each tilt the normal their own way.
#[derive(Clone, Debug, PartialEq)]
pub struct Facets {
    size: f64,
    /// The tangent of the largest tilt.
    slope: f64,
    seed: u64,
}

impl Facets {
    /// Cubes of this size, which tilt by up to `degrees`.
    ///
    /// # Errors
    /// Where the size is not positive, or the tilt is not from 0 to 80 degrees.
    pub fn new(size: f64, degrees: f64, seed: u64) -> Result<Self, String> {
        if !(size > 0.0 && size.is_finite()) {
            return Err(format!("facets must be larger than 0, not {size}"));
        }
        if !(0.0..=80.0).contains(&degrees) {
            return Err(format!("facets tilt by 0 to 80 degrees, not {degrees}"));
        }
        let (sine, cosine) = sine_cosine(degrees.to_radians());
        Ok(Self { size, slope: sine / cosine, seed })
    }

    /// The tilt of a point's cube: a vector of up to the length 1.
    fn tilt(&self, q: DVec3) -> DVec3 {
        let cell = (q / self.size).floor() + 0.0;
        let mixed = cell.to_array().iter().fold(self.seed, |seed, x| Random::new(seed ^ x.to_bits()).bits());
        DVec3::from_array(Random::new(mixed).in_ball())
    }

    fn normal<R: Recorder>(&self, site: &Site, recorder: &mut R) -> DVec3 {
        let n = site.normal;
        let tilt = self.tilt(site.texture_point);
        let across = tilt - n * n.dot(tilt);
        let sum = n + across * self.slope;
        let after = sum / sum.length();
        recorder.note(|| {
            let [p_u, p_v] = site.tangents;
            let bindings: [Binding; 5] = [
                ("n", n.to_array().into()),
                ("r", tilt.to_array().into()),
                ("t", across.to_array().into()),
                ("a", self.slope.into()),
                ("m", sum.to_array().into()),
            ];
            Entry::new(What::Bump(Record {
                bump: "facets".to_owned(),
                p_u: p_u.to_array(),
                p_v: p_v.to_array(),
                height: 0.0,
                slopes: [0.0; 2],
                p_u_cross_n: p_u.cross(n).to_array(),
                n_cross_p_v: n.cross(p_v).to_array(),
                dropped: None,
                before: n.to_array(),
                after: after.to_array(),
            }))
            .line("t", "r − (r · n) n", &bindings, across.to_array())
            .line("m", "n + a t", &bindings, sum.to_array())
            .line("n′", "m / |m|", &bindings, after.to_array())
        });
        after
    }
}

impl Bump {
    /// The name, as scene files spell it.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Noise { .. } => "noise",
            Self::Waves { .. } => "waves",
            Self::Facets(_) => "facets",
        }
    }

    /// The perturbed unit normal. `turning` gives n_u and n_v; it is asked only when nothing is to be dropped, and for the
    /// account of what is when somebody records.
    pub fn normal<R: Recorder>(
        &self,
        site: &Site,
        derivative: BumpDerivative,
        turning: impl FnOnce() -> Option<[DVec3; 2]>,
        recorder: &mut R,
    ) -> DVec3 {
        let (height, gradient) = match self {
            Self::Facets(facets) => return facets.normal(site, recorder),
            Self::Noise { turbulence, height } => {
                let (value, slope) = turbulence.value_and_slope(site.texture_point);
                (height * value, slope * *height)
            }
            Self::Waves { centre, wavelength, height, phase } => {
                wave(site.texture_point - *centre, *wavelength, *height, *phase)
            }
        };
        let slopes = site.tangents.map(|tangent| gradient.dot(site.texture_from_world * tangent));
        raised((self.name(), derivative), site, Rise { height, slopes }, turning, recorder)
    }

    /// The turbulence, if it is one.
    pub fn turbulence_mut(&mut self) -> Option<&mut Turbulence> {
        match self {
            Self::Noise { turbulence, .. } => Some(turbulence),
            Self::Waves { .. } | Self::Facets(_) => None,
        }
    }

    /// Stirs noise to another time.
    pub fn at_time(&mut self, time: f64) {
        if let Self::Noise { turbulence: Turbulence { noise, .. }, .. } = self {
            Noise::at_time(noise, time);
        }
    }
}

/// The height of a ripple at a place from its middle, and its gradient.
fn wave(from_centre: DVec3, wavelength: f64, height: f64, phase: f64) -> (f64, DVec3) {
    let distance = from_centre.length();
    let (sine, cosine) = sine_cosine(TAU * (distance / wavelength - phase));
    let outwards = if distance > 0.0 { from_centre / distance } else { DVec3::ZERO };
    (height * cosine, outwards * (-height * TAU / wavelength * sine))
}

#[cfg(test)]
mod tests {
    use super::super::super::solid::NoiseKind;
    use super::super::super::solid::testing::{Kept, assert_every_line_holds, points};
    use super::*;
    use crate::record::NullRecorder;
    use glam::{DMat3, DVec2};

    fn bumps() -> Vec<Bump> {
        let turbulence = Turbulence::new(Noise::new(NoiseKind::Gradient, 3), 1.3, 4, 0.5, false).unwrap();
        vec![
            Bump::Noise { turbulence, height: 0.1 },
            Bump::Waves { centre: DVec3::new(0.3, 0.1, 0.0), wavelength: 0.7, height: 0.05, phase: 0.2 },
            Bump::Facets(Facets::new(0.2, 25.0, 9).unwrap()),
        ]
    }

    /// A place of the plane z = 0 with the texture turned and scaled.
    fn place(p: DVec3) -> Site {
        let map = DMat3::from_rotation_x(0.7) * 1.5;
        let p = DVec3::new(p.x, p.y, 0.0);
        Site {
            texture_point: map * p,
            texture_from_world: map,
            uv: DVec2::ZERO,
            tangents: [DVec3::X * 2.0, DVec3::Y * 3.0],
            normal: DVec3::Z,
        }
    }

    #[test]
    fn on_a_plane_the_normal_is_that_of_the_height_field() {
        const H: f64 = 1e-6;
        for bump in &bumps()[..2] {
            let height = |p: DVec3| match bump {
                Bump::Noise { turbulence, height } => height * turbulence.value(place(p).texture_point),
                Bump::Waves { centre, wavelength, height, phase } => {
                    height * (TAU * ((place(p).texture_point - *centre).length() / wavelength - phase)).cos()
                }
                Bump::Facets(_) => 0.0,
            };
            for p in points(300, 4.0) {
                let slope = |axis: DVec3| (height(p + axis * H) - height(p - axis * H)) / (2.0 * H);
                let expected = DVec3::new(-slope(DVec3::X), -slope(DVec3::Y), 1.0).normalize();
                let found = bump.normal(&place(p), BumpDerivative::Dropped, || None, &mut NullRecorder);
                assert!((found - expected).length() < 1e-7, "{}: {found} {expected}", bump.name());
            }
        }
    }

    #[test]
    fn facets_are_flat_within_a_cube_and_tilt_no_further_than_said() {
        let facets = Facets::new(0.5, 20.0, 4).unwrap();
        let normal = |q: DVec3| facets.normal(&Site { texture_point: q, ..place(DVec3::ZERO) }, &mut NullRecorder);
        let (mut largest, mut sum) = (0.0_f64, DVec3::ZERO);
        for q in points(5000, 100.0) {
            let here = normal(q);
            assert_eq!(here, normal((q / 0.5).floor() * 0.5 + 0.01));
            largest = largest.max(here.angle_between(DVec3::Z).to_degrees());
            sum += here;
        }
        assert!(largest > 18.0 && largest < 20.0 + 1e-9, "{largest}");
        // No way is favoured: 5000 tilts of a slope of up to 0.36 add up to no more than 5 · 0.36 · √5000.
        assert!(sum.truncate().length() < 5.0 * 0.36 * 5000.0_f64.sqrt());
    }

    #[test]
    fn the_working_holds_and_watching_changes_nothing() {
        for bump in bumps() {
            let mut kept = Kept::default();
            for p in points(50, 4.0) {
                let told = bump.normal(&place(p), BumpDerivative::Dropped, || Some([DVec3::ZERO; 2]), &mut kept);
                assert_eq!(told, bump.normal(&place(p), BumpDerivative::Dropped, || None, &mut NullRecorder));
                assert!((told.length() - 1.0).abs() < 1e-15 && told.z > 0.0);
            }
            assert_every_line_holds(&kept);
        }
    }

    #[test]
    fn wrong_parameters_are_named() {
        assert!(Facets::new(0.0, 10.0, 1).unwrap_err().contains("larger"));
        assert!(Facets::new(1.0, 90.0, 1).unwrap_err().contains("80"));
    }
}
