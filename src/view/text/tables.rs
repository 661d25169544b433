//! The tables of the detail, and the polynomial in words.

use super::detail::DetailLine;
use super::format::{significant, vector};
use crate::record::{Candidate, CandidateFate, PlaneRow, PlaneSense, Sense, Tier, Triple, format_number};

/// `3 + 2 t − t⁴`, from the constant term up.
pub(super) fn polynomial(coefficients: &[f64; 5]) -> String {
    let powers = ["", " t", " t²", " t³", " t⁴"];
    let mut text = String::new();
    for (&coefficient, power) in coefficients.iter().zip(powers).filter(|(coefficient, _)| **coefficient != 0.0) {
        let sign = match (coefficient < 0.0, text.is_empty()) {
            (true, true) => "−",
            (true, false) => " − ",
            (false, true) => "",
            (false, false) => " + ",
        };
        text.push_str(sign);
        if coefficient.abs() == 1.0 && !power.is_empty() {
            text.push_str(power.trim_start());
        } else {
            text.push_str(&format_number(coefficient.abs()));
            text.push_str(power);
        }
    }
    if text.is_empty() { "0".to_owned() } else { text }
}

/// The hit times that were looked at; nothing where there were none.
pub(super) fn candidate_table(candidates: &[Candidate]) -> Option<DetailLine> {
    let rows = candidates.iter().map(|candidate| {
        let fate = match candidate.fate {
            CandidateFate::Accepted => "✓",
            CandidateFate::Rejected => "✗",
        };
        let sense = match candidate.sense {
            Sense::Enter => "enter",
            Sense::Leave => "leave",
            Sense::Touch => "touch",
        };
        let [part, reason] = [&candidate.part, &candidate.reason].map(Clone::clone);
        vec![fate.to_owned(), format_number(candidate.t), sense.to_owned(), part, vector(candidate.point), reason]
    });
    (!candidates.is_empty()).then(|| DetailLine::Table {
        title: "candidates".to_owned(),
        headers: vec!["", "t", "sense", "part", "S + c t", "why"],
        rows: rows.collect(),
    })
}

/// What each arithmetic made of the closest decision.
pub(super) fn tier_table(tiers: &[Tier]) -> DetailLine {
    let row = |tier: &Tier| {
        let sure = if tier.decided { "sure" } else { "open" };
        vec![
            tier.arithmetic.clone(),
            significant(tier.value, 4),
            significant(tier.doubt, 2),
            sure.to_owned(),
            tier.operations.to_string(),
            tier.f64_operations.to_string(),
        ]
    };
    DetailLine::Table {
        title: "attempts".to_owned(),
        headers: vec!["arithmetic", "number", "±", "sign", "operations", "in f64"],
        rows: tiers.iter().map(row).collect(),
    }
}

/// The plane table of § 6.2.3.
pub(super) fn plane_table(rows: &[PlaneRow]) -> DetailLine {
    let time = |t: Option<f64>, open: &str| t.map_or(open.to_owned(), format_number);
    let row = |row: &PlaneRow| {
        let sense = match row.sense {
            PlaneSense::Entering => "entering",
            PlaneSense::Leaving => "leaving",
            PlaneSense::ParallelInside => "parallel, inside",
            PlaneSense::ParallelOutside => "parallel, outside",
        };
        vec![
            row.plane.to_string(),
            row.name.clone(),
            vector(row.normal),
            vector(row.spot),
            format_number(row.numerator),
            format_number(row.denominator),
            time(row.t, "none"),
            sense.to_owned(),
            time(row.t_in, "−∞"),
            time(row.t_out, "∞"),
        ]
    };
    DetailLine::Table {
        title: "planes".to_owned(),
        headers: vec!["#", "plane", "m", "spot", "m·(spot − S)", "m·c", "t", "sense", "t_in", "t_out"],
        rows: rows.iter().map(row).collect(),
    }
}

/// Colours by their components.
pub(super) fn colour_table(terms: &[(&str, &Triple)]) -> DetailLine {
    let row = |(name, colour): &(&str, &Triple)| {
        let [r, g, b] = colour.map(format_number);
        vec![(*name).to_owned(), r, g, b]
    };
    DetailLine::Table {
        title: "components".to_owned(),
        headers: vec!["", "red", "green", "blue"],
        rows: terms.iter().map(row).collect(),
    }
}
