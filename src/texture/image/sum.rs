//! The weighted sum of texels, and what is said of it.

use super::texels::Texels;
use super::wrap::Wraps;
use crate::record::{self, Entry, Recorder, TexelShare, Value, What};
use glam::DVec3;

/// How many texels a report lists; a person does not read more, and a recording of a whole pixel must stay small.
const LISTED: usize = 32;

/// A weighted sum of texels of one level of a pyramid.
pub(super) struct Sum<'a> {
    texels: &'a Texels,
    wraps: Wraps,
    colour: DVec3,
    weight: f64,
    /// Every texel with its weight, where somebody listens.
    shares: Option<Vec<([i64; 2], f64)>>,
}

impl<'a> Sum<'a> {
    /// An empty sum over a level; `R` says whether somebody listens.
    pub fn new<R: Recorder>(texels: &'a Texels, wraps: Wraps) -> Self {
        Self { texels, wraps, colour: DVec3::ZERO, weight: 0.0, shares: R::RECORDING.then(Vec::new) }
    }

    /// Adds a texel.
    #[inline]
    pub fn add(&mut self, at: [i64; 2], weight: f64) {
        self.colour += self.texels.at(at, self.wraps) * weight;
        self.weight += weight;
        if let Some(shares) = &mut self.shares {
            shares.push((at, weight));
        }
    }

    /// Whether nothing was added that counts.
    pub fn is_empty(&self) -> bool {
        self.weight <= 0.0
    }

    /// The average, reported as what `filter` made of this level.
    pub fn finish<R: Recorder>(self, filter: &str, level: usize, recorder: &mut R) -> DVec3 {
        let colour = self.colour / self.weight;
        recorder.note(|| describe(self.listed(), filter, level, colour));
        colour
    }

    /// The texels with their shares of 1, the largest first and those of one size in the order of rows.
    fn listed(&self) -> Vec<TexelShare> {
        let mut shares = self.shares.clone().unwrap_or_default();
        shares.sort_by_key(|([x, y], _)| (*y, *x));
        // A footprint that is taken in two triangles meets some texels twice.
        shares.dedup_by(|next, kept| {
            let is_same = next.0 == kept.0;
            kept.1 += if is_same { next.1 } else { 0.0 };
            is_same
        });
        shares.retain(|(_, weight)| *weight > 0.0);
        shares.sort_by(|a, b| b.1.total_cmp(&a.1));
        let share = |&(at, weight): &([i64; 2], f64)| TexelShare {
            at,
            weight: weight / self.weight,
            colour: self.texels.at(at, self.wraps).to_array(),
        };
        shares.iter().map(share).collect()
    }
}

/// The event of an average over these texels.
fn describe(mut texels: Vec<TexelShare>, filter: &str, level: usize, colour: DVec3) -> Entry {
    let left_out = texels.len().saturating_sub(LISTED);
    texels.truncate(LISTED);
    let bindings: Vec<_> = [("w₁", "c₁"), ("w₂", "c₂"), ("w₃", "c₃"), ("w₄", "c₄")]
        .into_iter()
        .zip(&texels)
        .flat_map(|((w, c), texel)| [(w, Value::from(texel.weight)), (c, Value::from(texel.colour))])
        .collect();
    let formula = match texels.len() {
        1 => Some("w₁ c₁"),
        2 => Some("w₁ c₁ + w₂ c₂"),
        3 => Some("w₁ c₁ + w₂ c₂ + w₃ c₃"),
        4 => Some("w₁ c₁ + w₂ c₂ + w₃ c₃ + w₄ c₄"),
        _ => None,
    };
    let entry = Entry::new(What::Texels(record::Texels {
        filter: filter.to_owned(),
        level: level as f64,
        texels,
        left_out,
        colour: colour.to_array(),
    }));
    match formula {
        Some(formula) => entry.line("colour", formula, &bindings, colour.to_array()),
        None => entry,
    }
}
