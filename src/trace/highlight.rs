//! The highlight of a light: Phong's about the mirrored direction, or Ward's along a grain.

use super::finish::Finish;
use crate::math::{portable, power};
use crate::optics::reflect;
use crate::record::{Binding, Entry};
use crate::scene::Rgb;
use crate::texture::relief::Ward;
use glam::DVec3;

/// The factor of k_s and of the light that arrives.
pub(super) enum Highlight {
    /// (r · v)^f with r the direction of the light mirrored at n.
    Phong { mirrored: DVec3, eye: DVec3, r_dot_v: f64, exponent: f64 },
    /// By the grain of the surface.
    Ward(Ward),
}

impl Highlight {
    /// The highlight of a light in the direction `towards`, seen from the direction `eye`, both unit.
    pub fn new(finish: &Finish, normal: DVec3, towards: DVec3, eye: DVec3) -> Self {
        if let Some((frame, roughness)) = finish.grain {
            return Self::Ward(Ward::new(frame, towards, eye, roughness));
        }
        let mirrored = reflect(-towards, normal);
        let r_dot_v = mirrored.dot(eye).max(0.0);
        Self::Phong { mirrored, eye, r_dot_v, exponent: finish.material.exponent }
    }

    /// The factor itself.
    pub fn value(&self) -> f64 {
        match self {
            Self::Phong { r_dot_v, exponent, .. } => phong(*r_dot_v, *exponent),
            Self::Ward(ward) => ward.highlight,
        }
    }

    /// Adds the working of both terms of the light to its description; `bindings` are those of the diffuse term, k_s and
    /// I_l.
    pub fn lines(&self, entry: Entry, bindings: &[Binding], [diffuse, specular]: [Rgb; 2]) -> Entry {
        match self {
            Self::Phong { mirrored, eye, r_dot_v, exponent } => {
                let own = [
                    ("r", mirrored.to_array().into()),
                    ("v", eye.to_array().into()),
                    ("f", (*exponent).into()),
                    ("r_v", (*r_dot_v).into()),
                ];
                let bindings: Vec<_> = bindings.iter().copied().chain(own).collect();
                entry
                    .line("r·v", "max(0, r · v)", &bindings, *r_dot_v)
                    .line("I_diff", "I_l k_d n_l", &bindings, diffuse.to_array())
                    .line("I_spec", "I_l k_s (r_v)^f", &bindings, specular.to_array())
            }
            Self::Ward(ward) => {
                let own = [("S", ward.highlight.into())];
                let bindings: Vec<_> = bindings.iter().copied().chain(own).collect();
                let entry = entry.line("I_diff", "I_l k_d n_l", &bindings, diffuse.to_array());
                ward.lines(entry).line("I_spec", "I_l k_s S", &bindings, specular.to_array())
            }
        }
    }
}

/// (r · v)^f. Results too small for the fast power, and 0⁰, are left to the other one.
fn phong(r_dot_v: f64, exponent: f64) -> f64 {
    // So it is wherever the mirrored light goes away from the eye.
    if r_dot_v == 0.0 && exponent > 0.0 {
        return 0.0;
    }
    let fast = power(r_dot_v, exponent);
    if fast > 0.0 { fast } else { portable::powf(r_dot_v, exponent) }
}
