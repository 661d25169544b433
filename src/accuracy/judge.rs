//! When a solver is right: the rule of `tests/oracle/README.md`.
//!
//! **Coarser numbers.** An arithmetic with fewer digits than `f64` is judged by the same exact hits, but by a floor of its own:
//! where the last digits of its numbers are k times coarser, floor and last digit count k times, and each zone is stretched
//! about its middle: by k where the surface is crossed, by √k where it is touched, since there the hit moves with
//! the root of what moves the ray. Zones that overlap once stretched are one, and what the ray does within is not asked:
//! only whether it is inside or outside behind it. A near miss has no zone that could be stretched: a hit that is reported
//! there counts as invented.

use super::oracle::{Case, Zone};

/// How a solver did on a case.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Verdict {
    /// Hits that should have been reported.
    pub missed: usize,
    /// Hits that should not have been.
    pub extra: usize,
    /// The largest error of a hit that stands alone in its zone, over what half a last digit of the input can move it by, and
    /// half a last digit of the hit time: the attainable floor.
    pub error: f64,
}

/// Judges the hit times that a solver reported; its last digits are `coarseness` times those of `f64`.
#[must_use]
pub fn judge(case: &Case, ends: &[f64], coarseness: f64) -> Verdict {
    let stretched;
    let zones = if coarseness > 1.0 {
        stretched = stretch(&case.zones, coarseness);
        &stretched
    } else {
        &case.zones
    };
    let square = case.target.is_square();
    let length = 1.0 / case.direction.abs().max_element();
    let mut verdict = Verdict::default();
    let mut reported = vec![Vec::new(); zones.len()];
    for &t in ends {
        match zone_of(zones, length, coarseness, t) {
            Some(zone) => reported[zone].push(t),
            None => verdict.extra += 1,
        }
    }
    for (zone, reported) in zones.iter().zip(&reported) {
        let must = if square { zone.after == "in" } else { zone.before != zone.after };
        let count = reported.len();
        match (must, count) {
            (true, 0) => verdict.missed += 1,
            (true, _) if count.is_multiple_of(2) || square => verdict.extra += count - 1,
            (false, _) if !count.is_multiple_of(2) && !square => verdict.extra += 1,
            _ => {}
        }
        if must
            && zone.hits == 1
            && let Some(&first) = reported.first()
        {
            verdict.error = verdict.error.max(error(case, zone, first, coarseness));
        }
    }
    verdict
}

/// The error of a reported hit in units of the floor.
fn error(case: &Case, zone: &Zone, t: f64, coarseness: f64) -> f64 {
    let hit = case.hits.iter().find(|hit| zone.low <= hit.t && hit.t <= zone.high);
    hit.map_or(0.0, |hit| (t - hit.t).abs() / (coarseness * (hit.floor + 0.5 * ulp(hit.t))))
}

fn ulp(x: f64) -> f64 {
    x.abs().next_up() - x.abs()
}

/// How far `t` lies outside of a zone.
fn distance(zone: &Zone, t: f64) -> f64 {
    (zone.low - t).max(t - zone.high).max(0.0)
}

/// The zone that a reported t belongs to: the nearest one, if it is near enough. `length` is one size of the object in t.
fn zone_of(zones: &[Zone], length: f64, coarseness: f64, t: f64) -> Option<usize> {
    let nearest = (0..zones.len()).min_by(|&a, &b| distance(&zones[a], t).total_cmp(&distance(&zones[b], t)))?;
    let zone = &zones[nearest];
    let gap = (0..zones.len())
        .filter(|&k| k != nearest)
        .map(|k| (zones[k].low - zone.high).max(zone.low - zones[k].high).max(0.0))
        .fold(f64::INFINITY, f64::min);
    let width = 4.0 * (zone.high - zone.low) + 4.0 * coarseness * ulp(zone.high);
    (distance(zone, t) <= width.max((1e-3 * length).min(0.45 * gap))).then_some(nearest)
}

/// The zones of numbers whose last digits are `coarseness` times coarser.
fn stretch(zones: &[Zone], coarseness: f64) -> Vec<Zone> {
    let mut stretched: Vec<Zone> = Vec::with_capacity(zones.len());
    for zone in zones {
        let factor = if zone.before == zone.after { coarseness.sqrt() } else { coarseness };
        let (middle, half) = (f64::midpoint(zone.low, zone.high), 0.5 * (zone.high - zone.low) * factor);
        let mut next = Zone { low: middle - half, high: middle + half, ..zone.clone() };
        while let Some(last) = stretched.last()
            && last.high >= next.low
        {
            next = Zone {
                low: last.low.min(next.low),
                high: last.high.max(next.high),
                before: last.before.clone(),
                after: next.after,
                hits: last.hits + next.hits,
            };
            stretched.pop();
        }
        stretched.push(next);
    }
    stretched
}

#[cfg(test)]
mod tests {
    use super::super::oracle::{Hit, Target};
    use super::*;
    use crate::shape::{Shape, Sphere};
    use glam::DVec3;

    const FLOOR: f64 = 1e-15;

    fn zone(t: f64, half: f64, before: &str, after: &str, hits: u64) -> Zone {
        Zone { low: t - half, high: t + half, before: before.to_owned(), after: after.to_owned(), hits }
    }

    /// A ray that is in from 2 to 4, and touches at 6.
    fn case() -> Case {
        let hit = |t| Hit { t, floor: FLOOR, side: String::new(), surfaces: Vec::new(), normals: Vec::new() };
        Case {
            id: String::new(),
            kind: String::new(),
            target: Target::Shape(Shape::Sphere(Sphere)),
            origin: DVec3::ZERO,
            direction: DVec3::X,
            ambiguous: false,
            strict: false,
            hits: vec![hit(2.0), hit(4.0), hit(6.0)],
            zones: vec![
                zone(2.0, FLOOR, "out", "in", 1),
                zone(4.0, FLOOR, "in", "out", 1),
                zone(6.0, 1e-8, "out", "out", 1),
            ],
        }
    }

    fn verdict(ends: &[f64]) -> (usize, usize) {
        let verdict = judge(&case(), ends, 1.0);
        (verdict.missed, verdict.extra)
    }

    #[test]
    fn a_touch_may_be_reported_twice_or_not_at_all() {
        assert_eq!(verdict(&[2.0, 4.0]), (0, 0));
        assert_eq!(verdict(&[2.0, 4.0, 6.0, 6.0]), (0, 0));
        assert_eq!(verdict(&[2.0, 4.0, 6.0]), (0, 1));
    }

    #[test]
    fn what_is_lacking_is_missed_and_what_is_elsewhere_is_extra() {
        assert_eq!(verdict(&[4.0]), (1, 0));
        assert_eq!(verdict(&[2.0, 3.0, 4.0, 5.0]), (0, 2));
        assert_eq!(verdict(&[2.0, 2.0, 4.0]), (0, 1));
        assert_eq!(verdict(&[]), (2, 0));
    }

    #[test]
    fn errors_count_in_units_of_the_floor_and_half_a_last_digit() {
        let off = 2.0_f64.next_up();
        let expected = (off - 2.0) / (FLOOR + 0.5 * f64::EPSILON * 2.0);
        assert_eq!(judge(&case(), &[off, 4.0], 1.0).error, expected);
        assert_eq!(judge(&case(), &[off, 4.0], 4.0).error, expected / 4.0);
    }

    #[test]
    fn zones_that_a_coarser_arithmetic_cannot_tell_apart_are_one() {
        // k = 10¹⁵ stretches both crossings to half a unit and more about 2 and 4: they still are two; 10¹⁶ joins them.
        assert_eq!(stretch(&case().zones, 0.9e15).len(), 2 + usize::from(4.9 < 6.0 - 1e-8 * 0.9e15_f64.sqrt()));
        let joined = stretch(&case().zones, 1e16);
        assert_eq!((joined.len(), joined[0].before.as_str(), joined[0].after.as_str()), (1, "out", "out"));
    }
}
