//! How many rays each of those that a hit spawns may spawn in turn, and which one is sent where there may be no more.
//!
//! Where the depth limit ends all branches before there are too many rays, all are sent. Else what a ray may spawn is divided as
//! its light is: faint branches of the tree end early, bright ones late. Where less is left than a hit asks for, chance
//! chooses one of its rays, each as often as its share says, and the share is divided by that probability. On average no
//! light is lost, and the tree goes on as a path.
//!
//! **Source** J. Arvo, D. Kirk, Particle Transport and Image Synthesis (SIGGRAPH 1990), for the choice.

use super::ray::{MOST_RAYS, Ray};
use crate::record::{Entry, RayKind, Recorder, What};
use crate::sample::Purpose;
use crate::scene::Rgb;

/// What the rays that a hit spawns may spawn in turn.
pub(super) struct Allotment {
    /// Rays that are left for all of them together.
    left: u32,
    /// What each may spawn, where that is enough for whatever it will meet.
    enough: Option<u32>,
    /// The sum of the sizes of their shares.
    total: f64,
    /// The one that is sent, by its number, where not all can be.
    chosen: Option<usize>,
}

/// What one of them may do.
#[derive(Clone, Copy)]
pub(super) enum Lot {
    /// It is sent, and may spawn so many rays.
    Sent(u32),
    /// It is sent in place of all of them, and was chosen with this probability.
    Chosen(f64),
    /// Another one is sent in its place.
    Replaced,
}

/// How much light a share is.
fn size(share: Rgb) -> f64 {
    share.abs().max_element()
}

impl Allotment {
    /// For rays with these shares of what they bring back, by colour; `deepest` is the depth limit.
    pub fn new(parent: &Ray, deepest: u32, shares: impl Iterator<Item = Rgb> + Clone) -> Self {
        let (mut count, mut total) = (0, 0.0);
        for share in shares.clone() {
            count += u32::from(share != Rgb::ZERO);
            total += size(share);
        }
        let left = parent.budget.checked_sub(count);
        let chosen = left.is_none().then(|| choose(parent, shares, total));
        let left = left.unwrap_or(0);
        let each = left / count.max(1);
        let enough = (u64::from(each) >= whole_tree(deepest.saturating_sub(parent.depth + 1))).then_some(each);
        Self { left, enough, total, chosen }
    }

    /// What the ray of this number and share may do.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a part of what is left")]
    pub fn lot(&self, number: usize, share: Rgb) -> Lot {
        let part = size(share) / self.total;
        match (self.chosen, self.enough) {
            (None, Some(enough)) => Lot::Sent(enough),
            (None, None) => Lot::Sent((f64::from(self.left) * part) as u32),
            (Some(chosen), _) if chosen == number => Lot::Chosen(part),
            (Some(_), _) => Lot::Replaced,
        }
    }
}

/// The rays that are spawned below one that may have so many levels below it, two at every hit.
const fn whole_tree(levels: u32) -> u64 {
    match 2_u64.checked_shl(levels) {
        Some(rays) if levels < 32 => rays - 2,
        _ => u64::MAX,
    }
}

/// The ray that chance chooses, by its number.
fn choose(parent: &Ray, shares: impl Iterator<Item = Rgb>, total: f64) -> usize {
    let (mut ahead, mut chosen) = (parent.stream.number(Purpose::Way) * total, 0);
    for (number, share) in shares.enumerate().filter(|(_, share)| *share != Rgb::ZERO) {
        chosen = number;
        ahead -= size(share);
        if ahead < 0.0 {
            break;
        }
    }
    chosen
}

impl Lot {
    /// By what the share of a ray that is sent is multiplied; none for one that is not sent.
    pub fn factor(self) -> Option<f64> {
        match self {
            Self::Sent(_) => Some(1.0),
            Self::Chosen(probability) => Some(1.0 / probability),
            Self::Replaced => None,
        }
    }

    /// How many rays it may spawn.
    pub const fn budget(self) -> u32 {
        match self {
            Self::Sent(budget) => budget,
            Self::Chosen(_) | Self::Replaced => 0,
        }
    }

    /// Tells what chance did, where it had to choose between several rays.
    pub fn tell(self, kind: RayKind, share: Rgb, recorder: &mut impl Recorder) {
        if matches!(self, Self::Replaced) || matches!(self, Self::Chosen(probability) if probability < 1.0) {
            recorder.note(|| self.describe(kind, share));
        }
    }

    fn describe(self, kind: RayKind, share: Rgb) -> Entry {
        let name = kind.name();
        let consequence = match self {
            Self::Replaced => format!("the {name} ray is not sent; one that chance has chosen stands for it"),
            _ => format!("the {name} ray is chosen by chance, and stands for those that are not sent"),
        };
        let (at, value) = (f64::from(MOST_RAYS), f64::from(MOST_RAYS));
        let entry = Entry::new(What::Limit { limit: "rays".to_owned(), at, value, consequence });
        let Self::Chosen(probability) = self else { return entry };
        let bindings = [("share", share.to_array().into()), ("p", probability.into())];
        entry.line("share of the chosen", "share / p", &bindings, (share / probability).to_array())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::Stream;
    use glam::DVec3;

    const SHARES: [Rgb; 4] = [Rgb::new(0.5, 0.1, 0.2), Rgb::ZERO, Rgb::new(0.02, 0.03, 0.01), Rgb::new(0.1, 0.3, 0.3)];

    fn parent(budget: u32, number: u32) -> Ray {
        let stream = Stream::of_pixel([3, 4], 0).sample(number);
        Ray { budget, stream, ..Ray::camera(DVec3::ZERO, DVec3::X) }
    }

    fn lots(parent: &Ray, deepest: u32) -> [Lot; 4] {
        let allotment = Allotment::new(parent, deepest, SHARES.into_iter());
        std::array::from_fn(|number| allotment.lot(number, SHARES[number]))
    }

    #[test]
    fn what_may_be_spawned_is_divided_as_the_light_is() {
        let budgets = lots(&parent(1003, 0), 50).map(Lot::budget);
        // Three are sent, which leaves 1,000 for shares whose sizes are 0.5, 0.03 and 0.3.
        assert_eq!(budgets, [602, 0, 36, 361]);
    }

    #[test]
    fn where_all_branches_end_soon_enough_all_are_sent() {
        // Below each ray of depth 1 there are two levels: 2 + 4 rays.
        assert_eq!(lots(&parent(3 + 18, 0), 3).map(Lot::budget), [6; 4]);
        assert_eq!(lots(&parent(3 + 17, 0), 3).map(Lot::budget), [10, 0, 0, 6]);
    }

    #[test]
    fn on_average_the_chosen_ray_stands_for_all() {
        let count = 1 << 12;
        let mut means = [0.0; 4];
        for number in 0..count {
            let factors = lots(&parent(2, number), 50).map(Lot::factor);
            assert_eq!(factors.iter().flatten().count(), 1, "one is sent");
            for (mean, factor) in means.iter_mut().zip(factors) {
                *mean += factor.unwrap_or(0.0) / f64::from(count);
            }
        }
        for (mean, share) in means.into_iter().zip(SHARES) {
            let expected = if share == Rgb::ZERO { 0.0 } else { 1.0 };
            // The numbers are even: a ray is chosen as often as it should be, but for a few times.
            assert!((mean - expected).abs() < 0.02, "{share} counts {mean}");
        }
    }
}
