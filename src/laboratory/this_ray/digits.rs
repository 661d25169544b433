//! How right a number is.

use crate::math::portable;
use crate::record::{Candidate, CandidateFate, Event, Value, What, Working};

/// A number of an event.
#[derive(Clone, Debug, PartialEq)]
pub struct Number {
    /// Its name in the event.
    pub name: String,
    /// The number, or the coordinates of a vector.
    pub parts: Vec<f64>,
    /// What its error is in proportion to.
    pub size: f64,
    /// Its distance from the true number; of a vector, that of the worst coordinate.
    pub error: f64,
}

/// Digits right of a number of this size with this error; infinite for none, 0 for an error as large as the number.
#[must_use]
pub fn digits_right(error: f64, size: f64) -> f64 {
    if error == 0.0 {
        return f64::INFINITY;
    }
    let digits = -portable::log10(error / size);
    if digits > 0.0 { digits } else { 0.0 }
}

impl Number {
    /// A number and the true one; its error counts in proportion to the number, or to `least` if that is more.
    #[must_use]
    pub fn compared(name: &str, parts: &[f64], truth: &[f64], least: f64) -> Self {
        let size = |parts: &[f64]| parts.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let error = |(x, y): (&f64, &f64)| if x == y || x.is_nan() && y.is_nan() { 0.0 } else { (x - y).abs() };
        let worst = parts.iter().zip(truth).map(error).fold(0.0, larger);
        let error = if parts.len() == truth.len() { worst } else { f64::INFINITY };
        Self { name: name.to_owned(), parts: parts.to_vec(), size: size(truth).max(least), error }
    }

    /// Digits right.
    #[must_use]
    pub fn digits(&self) -> f64 {
        digits_right(self.error, self.size)
    }
}

/// The larger of two errors; an undefined one is larger than all.
fn larger(a: f64, b: f64) -> f64 {
    if b.is_nan() || b > a { if b.is_nan() { f64::INFINITY } else { b } } else { a }
}

/// Whether an event is part of a solver's working, whose numbers have shadows.
pub const fn is_working(what: &What) -> bool {
    matches!(
        what,
        What::Planes { .. }
            | What::Quadratic { .. }
            | What::Quartic { .. }
            | What::Search { .. }
            | What::Transform { .. }
    )
}

/// Whether an event's numbers are no results: bounds, places of boxes, drawings.
const fn has_no_results(what: &What) -> bool {
    matches!(
        what,
        What::Extent { .. }
            | What::Ball { .. }
            | What::Projection { .. }
            | What::Decision { .. }
            | What::Implicit { .. }
            | What::Limit { .. }
            | What::Moved { .. }
    )
}

/// The numbers of an event with their errors, as far as they can be told.
///
/// `twin` is the same event in the exact tree. `is_inherited` says that the ray itself is not the exact one, so that there is
/// more to an error in a solver's working than what its shadow tells. Hit times count in proportion to `reach` at least.
pub fn numbers(event: &Event, twin: Option<&Event>, is_inherited: bool, reach: f64) -> Vec<Number> {
    if has_no_results(&event.what) {
        return Vec::new();
    }
    let mut numbers: Vec<_> =
        event.working.iter().filter_map(|line| of_line(line, twin, is_inherited, reach)).collect();
    if let (What::Roots { candidates }, Some(What::Roots { candidates: truths })) =
        (&event.what, twin.map(|twin| &twin.what))
    {
        numbers.extend(of_hits(candidates, truths, reach));
    } else if let Some(twin) = twin.filter(|_| !is_working(&event.what)) {
        let truths = twin.what.quantities();
        for quantity in event.what.quantities().into_iter().filter(|quantity| !quantity.name.ends_with("error")) {
            let Some(truth) = truths.iter().find(|truth| truth.name == quantity.name) else { continue };
            let least = if is_time(&quantity.name) { reach } else { 0.0 };
            numbers.push(Number::compared(&quantity.name, &quantity.parts, &truth.parts, least));
        }
    }
    numbers
}

/// The times that are kept and their points, in order. Which others were looked at is up to the solver.
fn of_hits(candidates: &[Candidate], truths: &[Candidate], reach: f64) -> Vec<Number> {
    let kept = |list: &[Candidate]| {
        let kept = list.iter().filter(|candidate| candidate.fate == CandidateFate::Accepted);
        kept.map(|candidate| (candidate.t, candidate.point)).collect::<Vec<_>>()
    };
    let pairs = kept(candidates).into_iter().zip(kept(truths));
    let numbers = (1..).zip(pairs).map(|(k, ((t, point), (true_t, true_point)))| {
        let time = Number::compared(&format!("hit {k} t"), &[t], &[true_t], reach);
        [time, Number::compared(&format!("hit {k} point"), &point, &true_point, 0.0)]
    });
    numbers.flatten().collect()
}

/// `t`, `t₁`, `t₂`, or one of several, such as `hit 2 t`.
fn is_time(name: &str) -> bool {
    name.rsplit(' ').next().is_some_and(|last| matches!(last, "t" | "t₁" | "t₂"))
}

fn of_line(line: &Working, twin: Option<&Event>, is_inherited: bool, reach: f64) -> Option<Number> {
    let parts = parts(&line.result)?;
    let truth = twin
        .and_then(|twin| twin.working.iter().find(|other| other.symbol == line.symbol))
        .and_then(|other| self::parts(&other.result));
    let least = if is_time(&line.symbol) { reach } else { 0.0 };
    let size = parts.iter().fold(least, |most, x| most.max(x.abs()));
    let shadow = line.accuracy.map(|accuracy| accuracy.error);
    let inherited = truth.filter(|_| is_inherited || shadow.is_none());
    let compared = inherited.map(|truth| Number::compared(&line.symbol, &parts, &truth, least));
    let error = match (shadow, compared) {
        (Some(shadow), Some(compared)) => larger(shadow, compared.error),
        (Some(shadow), None) => shadow,
        (None, Some(compared)) => return Some(compared),
        (None, None) => return None,
    };
    Some(Number { name: line.symbol.clone().into_owned(), parts, size, error })
}

fn parts(value: &Value) -> Option<Vec<f64>> {
    match value {
        Value::Number(x) => Some(vec![*x]),
        Value::Vector(v) => Some(v.to_vec()),
        Value::Truth(_) => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_are_counted_by_powers_of_ten_and_never_below_none() {
        assert_eq!(digits_right(1e-7, 1.0), 7.0);
        assert_eq!(digits_right(1e-7, 100.0), 9.0);
        assert_eq!((digits_right(0.0, 1.0), digits_right(0.0, 0.0)), (f64::INFINITY, f64::INFINITY));
        assert_eq!((digits_right(3.0, 1.0), digits_right(1.0, 0.0), digits_right(f64::INFINITY, 1.0)), (0.0, 0.0, 0.0));
    }

    #[test]
    fn a_vector_is_as_right_as_its_worst_coordinate_by_its_largest() {
        let number = Number::compared("P", &[100.0, 1e-3, 0.0], &[100.0, 2e-3, 0.0], 0.0);
        assert!((number.digits() - 5.0).abs() < 1e-12, "{number:?}");
    }

    #[test]
    fn what_is_undefined_is_right_only_where_the_truth_is_undefined_too() {
        let (nan, one) = ([f64::NAN], [1.0]);
        assert_eq!(Number::compared("x", &nan, &nan, 0.0).error, 0.0);
        assert_eq!(Number::compared("x", &nan, &one, 0.0).digits(), 0.0);
        assert_eq!(Number::compared("x", &one, &nan, 0.0).digits(), 0.0);
        assert_eq!(Number::compared("x", &one, &[1.0, 1.0], 0.0).digits(), 0.0);
    }

    #[test]
    fn hits_are_compared_in_their_order_whatever_else_a_solver_looked_at() {
        use CandidateFate::{Accepted, Rejected};
        let candidate = |t: f64, fate| Candidate {
            t,
            part: String::new(),
            sense: crate::record::Sense::Enter,
            point: [t, 1.0, 0.0],
            fate,
            reason: String::new(),
        };
        let found = [candidate(2.0, Accepted), candidate(4.0, Accepted)];
        let truths =
            [candidate(1.0, Rejected), candidate(2.0, Accepted), candidate(3.0, Rejected), candidate(4.4, Accepted)];
        let numbers = of_hits(&found, &truths, 0.0);
        let told: Vec<_> = numbers.iter().map(|number| (number.name.as_str(), number.digits() > 10.0)).collect();
        assert_eq!(told, [("hit 1 t", true), ("hit 1 point", true), ("hit 2 t", false), ("hit 2 point", false)]);
    }

    #[test]
    fn hit_times_are_told_from_other_numbers_by_their_name() {
        assert!(is_time("t") && is_time("t₂") && is_time("hit 2 t") && is_time("combined 1 enter t"));
        assert!(!is_time("point") && !is_time("n_t") && !is_time("st"));
    }
}
