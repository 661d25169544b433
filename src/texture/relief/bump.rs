//! Bumps (§ 6.3.2): the normal of a surface that is raised by b(u, v), without raising it.
//!
//! P′ = P + b n with the outward unit normal n. Then P′_u = P_u + b_u n + b n_u, likewise P′_v, and
//! N′ = P′_u × P′_v = N + b_v (P_u × n) + b_u (n × P_v) + …, where N = P_u × P_v, the term b_u b_v (n × n) is zero, and the
//! rest has a factor b n_u or b n_v and is dropped. N′ is normalised. Where P_u × P_v points inwards the sign is turned.
//!
//! **How good that is** To first order b n_u and b n_v only lengthen N′: the normal's direction is off by the square of the
//! height, by the share b × curvature of the tilt. So they may be dropped while the bumps are low beside the radius of
//! curvature; b_u outweighs them where bumps are short beside it.
//!
//! **Source** J. Blinn, "Simulation of wrinkled surfaces", SIGGRAPH 1978. (The notes print + for × in N′ = P′_u × P′_v.)

use super::site::Site;
use crate::math::portable;
use crate::record::{Binding, Bump as Record, Entry, Recorder, What};
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// How a surface is raised at a place, from whatever source.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rise {
    /// b, in the world's units.
    pub height: f64,
    /// ∂b/∂u and ∂b/∂v.
    pub slopes: [f64; 2],
}

/// How the normal of a raised surface is worked out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum BumpDerivative {
    /// The terms b n_u and b n_v are dropped, as in Blinn's paper.
    #[default]
    Dropped,
    /// Nothing is dropped, where it is known how the normal turns.
    Exact,
}

/// The unit normal of the raised surface. `name` is the kind of bump, `turning` gives n_u and n_v where they are known (see
/// [`turning`](super::turning)); it is asked only when nothing is to be dropped, or when somebody records.
pub fn raised<R: Recorder>(
    (name, derivative): (&str, BumpDerivative),
    site: &Site,
    rise: Rise,
    turning: impl FnOnce() -> Option<[DVec3; 2]>,
    recorder: &mut R,
) -> DVec3 {
    let terms = Terms::new(site);
    let by_blinn = terms.normal(site.normal, rise);
    match derivative {
        BumpDerivative::Dropped => {
            recorder.note(|| terms.describe(name, site, rise, turning(), [by_blinn; 2]));
            by_blinn
        }
        BumpDerivative::Exact => {
            let turning = turning();
            let exact = turning.and_then(|turning| terms.exactly(site, rise, turning));
            let after = exact.map_or(by_blinn, |(_, unit)| unit);
            recorder.note(|| terms.describe(name, site, rise, turning, [by_blinn, after]));
            after
        }
    }
}

struct Terms {
    /// N = P_u × P_v.
    area: DVec3,
    /// P_u × n.
    p_u_cross_n: DVec3,
    /// n × P_v.
    n_cross_p_v: DVec3,
    /// Whether P_u × P_v points inwards.
    inwards: bool,
}

impl Terms {
    fn new(site: &Site) -> Self {
        let [p_u, p_v] = site.tangents;
        let area = p_u.cross(p_v);
        Self {
            area,
            p_u_cross_n: p_u.cross(site.normal),
            n_cross_p_v: site.normal.cross(p_v),
            inwards: area.dot(site.normal) < 0.0,
        }
    }

    /// N′ before it is normalised.
    fn sum(&self, rise: Rise) -> DVec3 {
        let [b_u, b_v] = rise.slopes;
        self.area + self.p_u_cross_n * b_v + self.n_cross_p_v * b_u
    }

    /// On the side of n. Where the surface has no (u, v), at a pole, the normal stays.
    fn normal(&self, before: DVec3, rise: Rise) -> DVec3 {
        if self.area == DVec3::ZERO {
            return before;
        }
        let sum = self.sum(rise);
        (if self.inwards { -sum } else { sum }).try_normalize().unwrap_or(before)
    }

    /// `by_blinn` is the normal without the terms that he drops, `used` the one that shading goes on with.
    fn describe(
        &self,
        name: &str,
        site: &Site,
        rise: Rise,
        turning: Option<[DVec3; 2]>,
        [after, used]: [DVec3; 2],
    ) -> Entry {
        let ([p_u, p_v], [b_u, b_v]) = (site.tangents, rise.slopes);
        let exact = turning.and_then(|turning| self.exactly(site, rise, turning));
        let dropped = exact.map(|(_, unit)| portable::atan2(after.cross(unit).length(), after.dot(unit)).to_degrees());
        let sum = self.sum(rise);
        let [n_u, n_v] = turning.unwrap_or_default();
        let mut bindings: Vec<Binding> = [
            ("P_u", p_u),
            ("P_v", p_v),
            ("n", site.normal),
            ("N", self.area),
            ("X", self.p_u_cross_n),
            ("Y", self.n_cross_p_v),
            ("N′", sum),
            ("n′", after),
            ("n_u", n_u),
            ("n_v", n_v),
        ]
        .map(|(symbol, vector)| (symbol, vector.to_array().into()))
        .to_vec();
        bindings.extend([("b", rise.height.into()), ("b_u", b_u.into()), ("b_v", b_v.into())]);
        let entry = Entry::new(What::Bump(Record {
            bump: name.to_owned(),
            p_u: p_u.to_array(),
            p_v: p_v.to_array(),
            height: rise.height,
            slopes: rise.slopes,
            p_u_cross_n: self.p_u_cross_n.to_array(),
            n_cross_p_v: self.n_cross_p_v.to_array(),
            dropped,
            before: site.normal.to_array(),
            after: used.to_array(),
        }))
        .line("N", "P_u × P_v", &bindings, self.area.to_array())
        .line("X", "P_u × n", &bindings, self.p_u_cross_n.to_array())
        .line("Y", "n × P_v", &bindings, self.n_cross_p_v.to_array())
        .line("N′", "N + b_v X + b_u Y", &bindings, sum.to_array());
        if self.area == DVec3::ZERO || sum == DVec3::ZERO {
            return entry;
        }
        let unit = if self.inwards { "−N′ / |N′|" } else { "N′ / |N′|" };
        let entry = entry.line("n′", unit, &bindings, after.to_array());
        let Some((whole, unit)) = exact else { return entry };
        bindings.extend([("E", whole.to_array().into()), ("m", unit.to_array().into())]);
        let unit_formula = if self.inwards { "−E / |E|" } else { "E / |E|" };
        let entry = entry.line("E", "(P_u + b_u n + b n_u) × (P_v + b_v n + b n_v)", &bindings, whole.to_array()).line(
            "m",
            unit_formula,
            &bindings,
            unit.to_array(),
        );
        match dropped {
            Some(angle) if angle < 90.0 => entry.line("δ", "arcsin(|n′ × m|)", &bindings, angle),
            _ => entry,
        }
    }

    /// P′_u × P′_v with nothing dropped, and its unit vector on the side of n.
    fn exactly(&self, site: &Site, rise: Rise, [n_u, n_v]: [DVec3; 2]) -> Option<(DVec3, DVec3)> {
        let ([p_u, p_v], [b_u, b_v], n, b) = (site.tangents, rise.slopes, site.normal, rise.height);
        let whole = (p_u + n * b_u + n_u * b).cross(p_v + n * b_v + n_v * b);
        Some((whole, (if self.inwards { -whole } else { whole }).try_normalize()?))
    }
}

#[cfg(test)]
#[path = "bump_tests.rs"]
mod tests;
