//! A small calculator for lines of working, written independently of the tracer: it reads `formula with numbers put in`
//! as a mathematician would, carries the error of the rounded numbers along, and says what comes out.

/// A number or vector with a bound on its error, component by component.
#[derive(Clone, Debug)]
pub struct Bounded(pub Vec<(f64, f64)>);

/// Numbers in working are shown with six significant digits, or four and a power of ten.
fn shown(value: f64, digits: i32) -> Bounded {
    Bounded(vec![(value, value.abs() * 0.5 * 10_f64.powi(1 - digits))])
}

impl Bounded {
    fn scalar(&self) -> Result<(f64, f64), String> {
        if let [only] = self.0[..] { Ok(only) } else { Err("a vector where a number is needed".to_owned()) }
    }

    fn map(self, f: impl Fn(f64) -> f64, slope: impl Fn(f64) -> f64) -> Self {
        Self(self.0.into_iter().map(|(x, e)| (f(x), (slope(x).abs() * e).min(1e300) + f(x).abs() * 1e-15)).collect())
    }

    /// Component by component; a number goes with every component of a vector.
    fn zip(&self, other: &Self, f: impl Fn((f64, f64), (f64, f64)) -> (f64, f64)) -> Self {
        let count = self.0.len().max(other.0.len());
        let at = |b: &Self, i: usize| if b.0.len() == 1 { b.0[0] } else { b.0[i] };
        Self((0..count).map(|i| f(at(self, i), at(other, i))).collect())
    }

    fn plus(&self, other: &Self) -> Self {
        self.zip(other, |(a, da), (b, db)| (a + b, da + db))
    }

    fn minus(&self, other: &Self) -> Self {
        self.zip(other, |(a, da), (b, db)| (a - b, da + db))
    }

    fn times(&self, other: &Self) -> Self {
        self.zip(other, |(a, da), (b, db)| (a * b, a.abs() * db + b.abs() * da + da * db))
    }

    fn over(&self, other: &Self) -> Self {
        self.zip(other, |(a, da), (b, db)| (a / b, (da + (a / b).abs() * db) / (b.abs() - db).max(1e-300)))
    }

    fn dot(&self, other: &Self) -> Self {
        if self.0.len() == 1 || other.0.len() == 1 {
            return self.times(other);
        }
        let products = self.times(other);
        Self(vec![products.0.iter().fold((0.0, 0.0), |(s, e), (x, d)| (s + x, e + d))])
    }

    fn cross(&self, other: &Self) -> Self {
        if self.0.len() == 1 || other.0.len() == 1 {
            return self.times(other);
        }
        let part = |b: &Self, i: usize| Self(vec![b.0[i % 3]]);
        let component = |i: usize| {
            let first = part(self, i + 1).times(&part(other, i + 2));
            first.minus(&part(self, i + 2).times(&part(other, i + 1))).0[0]
        };
        Self((0..3).map(component).collect())
    }

    fn magnitude(self) -> Self {
        if self.0.len() == 1 { self.map(f64::abs, |_| 1.0) } else { self.dot(&self).root() }
    }

    fn root(self) -> Self {
        // √(x ± e) moves by at most √e, however small x is.
        Self(self.0.into_iter().map(|(x, e)| (x.max(0.0).sqrt(), e.sqrt().min(e / x.max(0.0).sqrt()))).collect())
    }

    fn power(self, exponent: &Self) -> Result<Self, String> {
        let (n, dn) = exponent.scalar()?;
        let slope_in_n =
            self.0.iter().map(|(x, _)| (x.abs().powf(n) * x.abs().max(1e-300).ln()).abs() * dn).collect::<Vec<_>>();
        let mut result = self.map(|x| x.powf(n), |x| n * x.abs().powf(n - 1.0));
        result.0.iter_mut().zip(slope_in_n).for_each(|((_, e), more)| *e += more);
        Ok(result)
    }
}

/// Evaluates an expression of sums, products (by juxtaposition too), quotients, powers, roots, magnitudes and functions.
pub fn evaluate(text: &str) -> Result<Bounded, String> {
    let mut reader = Reader { rest: text.trim(), bars: 0 };
    let value = reader.sum()?;
    if reader.rest.is_empty() { Ok(value) } else { Err(format!("unread: `{}`", reader.rest)) }
}

struct Reader<'a> {
    rest: &'a str,
    /// Magnitude bars that are open: the next bar closes the last of them.
    bars: usize,
}

const FUNCTIONS: [&str; 11] = ["arccos", "arcsin", "arctan", "cos", "sin", "exp", "ln", "max", "min", "sign", "⌊"];

impl Reader<'_> {
    fn skip(&mut self) {
        self.rest = self.rest.trim_start();
    }

    fn take(&mut self, token: &str) -> bool {
        self.skip();
        match self.rest.strip_prefix(token) {
            Some(after) => {
                self.rest = after;
                true
            }
            None => false,
        }
    }

    fn sum(&mut self) -> Result<Bounded, String> {
        let mut value = self.product()?;
        loop {
            if self.take("+") {
                value = value.plus(&self.product()?);
            } else if self.take("−") {
                value = value.minus(&self.product()?);
            } else {
                return Ok(value);
            }
        }
    }

    fn product(&mut self) -> Result<Bounded, String> {
        let mut value = self.factor()?;
        loop {
            self.skip();
            if self.take("·") {
                value = value.dot(&self.factor()?);
            } else if self.take("×") {
                value = value.cross(&self.factor()?);
            } else if self.take("/") {
                value = value.over(&self.factor()?);
            } else if self.begins_factor() {
                value = value.times(&self.factor()?);
            } else {
                return Ok(value);
            }
        }
    }

    fn begins_factor(&self) -> bool {
        let opens_bar = self.rest.starts_with('|') && self.bars == 0;
        opens_bar
            || self.rest.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '(' | '√' | '∞'))
            || FUNCTIONS.iter().any(|name| self.rest.starts_with(name))
    }

    /// A signed value with its powers: −a² is −(a²).
    fn factor(&mut self) -> Result<Bounded, String> {
        if self.take("−") {
            let value = self.factor()?;
            return Ok(Bounded(vec![(0.0, 0.0)]).minus(&value));
        }
        let mut value = self.value()?;
        loop {
            if self.rest.starts_with(|c| superscript(c).is_some()) {
                let end = self.rest.find(|c| superscript(c).is_none()).unwrap_or(self.rest.len());
                let exponent: String = self.rest[..end].chars().filter_map(superscript).collect();
                self.rest = &self.rest[end..];
                let exponent = exponent.parse::<f64>().map_err(|e| e.to_string())?;
                value = value.power(&Bounded(vec![(exponent, 0.0)]))?;
            } else if self.rest.starts_with('^') {
                self.rest = &self.rest[1..];
                let exponent = self.factor()?;
                value = value.power(&exponent)?;
            } else {
                return Ok(value);
            }
        }
    }

    fn value(&mut self) -> Result<Bounded, String> {
        self.skip();
        if self.take("(") {
            return self.parenthesis();
        }
        if self.take("|") {
            self.bars += 1;
            let value = self.sum()?;
            self.bars -= 1;
            return if self.take("|") { Ok(value.magnitude()) } else { Err("a bar is not closed".to_owned()) };
        }
        if self.take("√") {
            return Ok(self.factor()?.root());
        }
        for name in FUNCTIONS {
            if self.take(name) {
                return self.function(name);
            }
        }
        self.number()
    }

    fn parenthesis(&mut self) -> Result<Bounded, String> {
        let bars = std::mem::take(&mut self.bars);
        let mut parts = self.sum()?.0;
        while self.take(",") {
            parts.extend(self.sum()?.0);
        }
        self.bars = bars;
        if self.take(")") { Ok(Bounded(parts)) } else { Err(format!("`)` expected before `{}`", self.rest)) }
    }

    fn function(&mut self, name: &str) -> Result<Bounded, String> {
        if matches!(name, "max" | "min") {
            let parts = self.value()?.0;
            let e = parts.iter().map(|(_, e)| *e).fold(0.0, f64::max);
            let pick = if name == "max" { f64::max } else { f64::min };
            return Ok(Bounded(vec![(parts.iter().map(|(x, _)| *x).reduce(pick).unwrap_or(f64::NAN), e)]));
        }
        if name == "⌊" {
            return self.floor();
        }
        let value = self.factor()?;
        Ok(match name {
            "arccos" => angle(&value, f64::acos)?,
            "arcsin" => angle(&value, f64::asin)?,
            "arctan" => angle(&value, f64::atan)?,
            "cos" => value.map(|x| x.to_radians().cos(), |_| 0.0175),
            "sin" => value.map(|x| x.to_radians().sin(), |_| 0.0175),
            "exp" => value.map(f64::exp, f64::exp),
            "ln" => value.map(f64::ln, f64::recip),
            other => return Err(format!("no function `{other}`")),
        })
    }

    /// Where a rounded number may lie on either side of a whole one, so may the result.
    fn floor(&mut self) -> Result<Bounded, String> {
        let floors = self.sum()?.0.into_iter().map(|(x, e)| (x.floor(), (x + e).floor() - (x - e).floor()));
        let floors = Bounded(floors.collect());
        if self.take("⌋") { Ok(floors) } else { Err(format!("`⌋` expected before `{}`", self.rest)) }
    }

    fn number(&mut self) -> Result<Bounded, String> {
        let end = self.rest.find(|c: char| !(c.is_ascii_digit() || c == '.')).unwrap_or(self.rest.len());
        let (digits, after) = self.rest.split_at(end);
        let value: f64 = digits.parse().map_err(|_| format!("no number at `{}`", self.rest))?;
        self.rest = after;
        let is_mantissa = after.starts_with("·10") && after[4..].starts_with(|c| superscript(c).is_some());
        Ok(shown(value, if is_mantissa { 4 } else { 6 }))
    }
}

/// An inverse function in degrees, with the error found by evaluating it at both ends.
fn angle(value: &Bounded, f: impl Fn(f64) -> f64) -> Result<Bounded, String> {
    let (x, e) = value.scalar()?;
    let inside = |x: f64| x.clamp(-1.0, 1.0);
    let ends = [f(inside(x - e)).to_degrees(), f(inside(x + e)).to_degrees()];
    Ok(Bounded(vec![(f(inside(x)).to_degrees(), (ends[0] - ends[1]).abs() + 1e-12)]))
}

fn superscript(c: char) -> Option<char> {
    Some(match c {
        '⁻' => '-',
        '⁰' => '0',
        '¹' => '1',
        '²' => '2',
        '³' => '3',
        '⁴' => '4',
        '⁵' => '5',
        '⁶' => '6',
        '⁷' => '7',
        '⁸' => '8',
        '⁹' => '9',
        _ => return None,
    })
}
