//! What the tests of solid textures share.

use super::random::Random;
pub(crate) use crate::record::Kept;
use crate::record::Value;
use glam::DVec3;

/// Points from −`size` to `size`, always the same.
pub(crate) fn points(count: usize, size: f64) -> impl Iterator<Item = DVec3> {
    let mut random = Random::new(99);
    std::iter::repeat_with(move || DVec3::from_array(std::array::from_fn(|_| random.signed() * size))).take(count)
}

#[path = "../../../tests/formula/mod.rs"]
mod formula;

/// Asserts that every line of working comes to its result when it is calculated from the numbers that it shows.
pub(crate) fn assert_every_line_holds(kept: &Kept) {
    let numbers = |value: &Value| match value {
        Value::Number(x) => vec![*x],
        Value::Vector(v) => v.to_vec(),
        Value::Truth(_) => Vec::new(),
    };
    for line in kept.0.iter().flat_map(|entry| &entry.working) {
        let result = numbers(&line.result);
        if result.is_empty() {
            continue;
        }
        let shown = format!("{} = {} = {} = {}", line.symbol, line.formula, line.numbers, line.result);
        let found = formula::evaluate(&line.numbers.to_string()).unwrap_or_else(|e| panic!("{shown}: {e}")).0;
        let agrees = found.len() == result.len()
            && found.iter().zip(&result).all(|((x, error), y)| (x - y).abs() <= 2.0 * error + 1e-12 * y.abs());
        assert!(agrees, "{shown} comes to {found:?}");
    }
}
