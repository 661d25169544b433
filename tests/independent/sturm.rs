//! Real roots of a polynomial by Sturm's theorem.

use super::big::{Big, big, size};

/// The number of roots between `low` and `high` and the means to separate them.
pub struct Sturm {
    sequence: Vec<Vec<Big>>,
}

/// Bisections after which two roots count as one: 2⁻²⁰⁰ of the interval.
const DEEPEST: u32 = 200;

impl Sturm {
    /// For the polynomial with these coefficients, constant term first.
    pub fn new(coefficients: Vec<Big>) -> Self {
        let slope = coefficients.iter().enumerate().skip(1).map(|(k, x)| x * big(k as f64)).collect();
        let mut sequence = vec![coefficients, slope];
        while let [.., before, last] = &sequence[..]
            && last.len() > 1
        {
            let rest = minus_remainder(before, last);
            if rest.is_empty() {
                break;
            }
            sequence.push(rest);
        }
        Self { sequence }
    }

    pub fn value(&self, x: &Big) -> Big {
        evaluate(&self.sequence[0], x)
    }

    fn variations(&self, x: &Big) -> usize {
        let values: Vec<_> = self.sequence.iter().map(|p| evaluate(p, x)).filter(|value| *value != Big::ZERO).collect();
        values.windows(2).filter(|pair| (pair[0] < Big::ZERO) != (pair[1] < Big::ZERO)).count()
    }

    /// How many different roots there are.
    pub fn count(&self, low: &Big, high: &Big) -> usize {
        self.variations(low) - self.variations(high)
    }

    /// All roots, ascending; none where two of them cannot be told apart.
    pub fn roots(&self, low: Big, high: Big) -> Option<Vec<Big>> {
        let mut roots = Vec::new();
        self.search(low, high, 0, &mut roots)?;
        Some(roots)
    }

    fn search(&self, low: Big, high: Big, depth: u32, roots: &mut Vec<Big>) -> Option<()> {
        match self.count(&low, &high) {
            0 => Some(()),
            1 => {
                roots.push(root_between(low, high, |x| self.value(x)));
                Some(())
            }
            _ if depth == DEEPEST => None,
            _ => {
                // Not the very middle: there symmetric rays have a root.
                let middle = &low + (&high - &low) * big(0.507);
                self.search(low, middle.clone(), depth + 1, roots)?;
                self.search(middle, high, depth + 1, roots)
            }
        }
    }
}

/// Where the value changes its sign, to 2⁻¹²⁰ of the interval: false position, as mended at the University of Illinois
/// (Dowell and Jarratt, BIT 11, 1971), which never leaves the interval.
pub fn root_between(mut low: Big, mut high: Big, value: impl Fn(&Big) -> Big) -> Big {
    let enough = (&high - &low) * big(2.0_f64.powi(-120));
    let (mut at_low, mut at_high) = (value(&low), value(&high));
    let mut last = low.clone();
    let mut kept_low = None;
    loop {
        let mut next = &low - &at_low * (&high - &low) / (&at_high - &at_low);
        if !(low < next && next < high) {
            next = (&low + &high) * big(0.5);
        }
        let at_next = value(&next);
        if at_next == Big::ZERO || size(&(&next - &last)) < enough || &high - &low < enough {
            return next;
        }
        let goes_low = (at_next < Big::ZERO) == (at_low < Big::ZERO);
        if goes_low {
            (low, at_low) = (next.clone(), at_next);
            if kept_low == Some(false) {
                at_high *= big(0.5);
            }
        } else {
            (high, at_high) = (next.clone(), at_next);
            if kept_low == Some(true) {
                at_low *= big(0.5);
            }
        }
        kept_low = Some(!goes_low);
        last = next;
    }
}

fn evaluate(coefficients: &[Big], x: &Big) -> Big {
    coefficients.iter().rev().fold(big(0.0), |sum, coefficient| sum * x + coefficient)
}

/// −(a mod b), without leading coefficients that are nothing but rounding.
fn minus_remainder(a: &[Big], b: &[Big]) -> Vec<Big> {
    let mut rest = a.to_vec();
    while rest.len() >= b.len() {
        let shift = rest.len() - b.len();
        let factor = &rest[rest.len() - 1] / &b[b.len() - 1];
        for (k, coefficient) in b.iter().enumerate() {
            rest[k + shift] -= coefficient * &factor;
        }
        rest.pop();
    }
    let largest = a.iter().map(size).fold(big(0.0), |x, y| if y > x { y } else { x });
    let noise = largest * big(2.0_f64.powi(-150));
    while rest.last().is_some_and(|x| size(x) < noise) {
        rest.pop();
    }
    rest.into_iter().map(|x| -x).collect()
}
