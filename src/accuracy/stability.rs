//! The table of `rayscope stability`: every solver on every exact case, counted by shape and kind.

use super::hits::hits;
use super::judge::{Verdict, judge};
use super::oracle::{self, Case};
use crate::shape::Method;
use rayon::prelude::*;
use std::collections::BTreeMap;

/// The shapes of the table with the files that hold their cases.
pub const SHAPES: [(&str, &str); 8] = [
    ("sphere", "sphere"),
    ("square", "square"),
    ("tapered_cylinder", "tapered"),
    ("cube", "cube"),
    ("convex_polyhedron", "polyhedron"),
    ("torus", "torus"),
    ("superellipsoid", "superellipsoid"),
    ("csg", "csg"),
];

/// How one solver did on all cases of one shape and kind.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The shape, or `csg`.
    pub shape: &'static str,
    /// What the cases come to: `hit`, `miss`, `tangent-touch` and so on.
    pub kind: String,
    /// The solver.
    pub solver: Method,
    /// How many cases there are.
    pub cases: usize,
    /// Hits that it missed.
    pub missed: usize,
    /// Hits that it invented.
    pub extra: usize,
    /// The largest error of a hit, in units of the attainable floor.
    pub worst: f64,
    /// The error that 99 of 100 cases do not exceed, in the same units.
    pub p99: f64,
    /// Cases in which anything was missed or invented.
    pub wrong: usize,
    /// Cases in which half a last digit of the input can change what is hit.
    pub undecidable: usize,
}

/// Judges all solvers on the shapes whose names are asked for, with the cores of the current rayon pool. `stopped` is asked
/// before each case: once it says yes, the rest is left out.
///
/// # Errors
/// Says so where the cases cannot be read.
pub fn stability(
    wanted: impl Fn(&str) -> bool,
    stopped: impl Fn() -> bool + Sync,
    done: impl Fn() + Sync,
) -> Result<Vec<Row>, String> {
    let mut rows = Vec::new();
    for (shape, file) in SHAPES.into_iter().filter(|(shape, _)| wanted(shape)) {
        let cases = oracle::cases(file)?;
        let verdicts: Vec<_> = cases
            .par_iter()
            .filter(|_| !stopped())
            .map(|case| {
                let verdicts = Method::ALL.map(|solver| verdict(solver, case));
                done();
                (case, verdicts)
            })
            .collect();
        rows.extend(table(shape, &verdicts));
    }
    Ok(rows)
}

fn verdict(solver: Method, case: &Case) -> Verdict {
    judge(case, &hits(solver, &case.target, case.origin, case.direction), solver.coarseness())
}

/// One row for each kind and solver, kinds in the order of the alphabet.
fn table(shape: &'static str, verdicts: &[(&Case, [Verdict; 5])]) -> Vec<Row> {
    let mut kinds: BTreeMap<&str, Vec<(&Case, [Verdict; 5])>> = BTreeMap::new();
    for judged in verdicts {
        kinds.entry(&judged.0.kind).or_default().push(*judged);
    }
    let row = |kind: &str, judged: &[(&Case, [Verdict; 5])], k: usize| {
        let mut errors: Vec<f64> = judged.iter().map(|(_, verdicts)| verdicts[k].error).collect();
        errors.sort_by(f64::total_cmp);
        let own = || judged.iter().map(|(_, verdicts)| verdicts[k]);
        Row {
            shape,
            kind: kind.to_owned(),
            solver: Method::ALL[k],
            cases: judged.len(),
            missed: own().map(|verdict| verdict.missed).sum(),
            extra: own().map(|verdict| verdict.extra).sum(),
            worst: errors.last().copied().unwrap_or(0.0),
            p99: errors.get(errors.len().saturating_sub(1) * 99 / 100).copied().unwrap_or(0.0),
            wrong: own().filter(|verdict| verdict.missed + verdict.extra > 0).count(),
            undecidable: judged.iter().filter(|(case, _)| case.ambiguous).count(),
        }
    };
    kinds
        .iter()
        .flat_map(|(kind, judged)| (0..Method::ALL.len()).map(move |k| (kind, judged, k)))
        .map(|(kind, judged, k)| row(kind, judged, k))
        .collect()
}
