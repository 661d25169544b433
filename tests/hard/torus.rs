//! What a ray meets of a torus, by Sturm's theorem on the quartic.

use super::line::{Line, PixelRay};
use super::number::{Big, Number, dot, squared};
use super::set::placement;
use super::truth::{Truth, Verdict};
use glam::DVec3;
use rayscope::scene::Scene;

/// The torus of the first leaf of the first object is all that there is.
pub struct TorusAlone {
    /// Distance from the axis to the middle of the tube, more than 1.
    pub d: f64,
}

/// Beyond this a walk in plain `f64` cannot be wrong.
const PLAIN: f64 = 1e-7;

impl TorusAlone {
    /// By walking: the distance from the torus says how far a step cannot miss it. None where the ray comes too near.
    fn walk(&self, line: &Line<f64>) -> Option<bool> {
        let near = PLAIN.max(1e4 * line.doubt);
        let ball = self.d + 1.0;
        let room = ball * ball - dot(&line.l, &line.l);
        if room <= 0.0 {
            return (room < -near * ball).then_some(false);
        }
        let speed = dot(&line.c, &line.c).sqrt();
        let end = room.sqrt() / speed;
        let distance = |delta: f64| {
            let [x, y, z] = line.at(&delta);
            (x.hypot(y) - self.d).hypot(z) - 1.0
        };
        let mut delta = -end;
        for _ in 0..200 {
            if delta >= end {
                return Some(false);
            }
            let away = distance(delta);
            if away < near {
                let probes = (1..64).map(|k| distance(delta + f64::from(k * k) * 1e-3 / speed));
                return probes.fold(away, f64::min).lt(&-near).then_some(true);
            }
            delta += away / speed;
        }
        None
    }

    /// The quartic along the ray with the tube's radius grown, lowest power first.
    fn quartic(&self, line: &Line<Big>, grown: f64) -> Vec<Big> {
        let (l, c) = (&line.l, &line.c);
        let (d_squared, radius) = (squared(&Big::of(self.d)), Big::of(1.0) + Big::of(grown));
        let two = || Big::of(2.0);
        let whole = [dot(l, l) + d_squared.clone() - squared(&radius), two() * dot(l, c), dot(c, c)];
        let round = [
            squared(&l[0]) + squared(&l[1]),
            two() * (l[0].clone() * c[0].clone() + l[1].clone() * c[1].clone()),
            squared(&c[0]) + squared(&c[1]),
        ];
        let mut result = vec![Big::of(0.0); 5];
        for i in 0..3 {
            for j in 0..3 {
                result[i + j] = result[i + j].clone() + whole[i].clone() * whole[j].clone();
            }
            result[i] = result[i].clone() - Big::of(4.0) * d_squared.clone() * round[i].clone();
        }
        result
    }

    fn hit(&self, line: &Line<Big>, grown: f64) -> bool {
        Sturm::new(self.quartic(line, grown)).all_roots() > 1
    }
}

impl Truth for TorusAlone {
    fn verdict(&self, scene: &Scene, ray: PixelRay) -> Verdict {
        let placement = placement(scene, [0, 0]);
        let seen = |hit: bool| hit.then_some(0);
        if let Some(hit) = self.walk(&Line::new(ray, &placement)) {
            return Verdict { seen: seen(hit), sure: true };
        }
        let line = Line::<Big>::new(ray, &placement);
        let [smaller, larger] = [-line.doubt, line.doubt].map(|grown| self.hit(&line, grown));
        if smaller == larger {
            return Verdict { seen: seen(larger), sure: true };
        }
        Verdict { seen: seen(self.hit(&line, 0.0)), sure: false }
    }

    fn time(&self, scene: &Scene, ray: PixelRay, t: f64) -> Result<(), String> {
        let line = Line::<Big>::new(ray, &placement(scene, [0, 0]));
        let delta = line.delta(t);
        let [x, y, z] = line.at(&delta).map(|x| x.nearest());
        let share = 1.0 - self.d / x.hypot(y);
        let room = line.tolerance(DVec3::new(x * share, y * share, z), t);
        let sturm = Sturm::new(self.quartic(&line, 0.0));
        let until = |delta: Big| sturm.roots_until(&delta);
        let before = until(delta.clone() - Big::of(room));
        let by_then = until(delta + Big::of(room));
        if before == 0 && by_then > 0 {
            return Ok(());
        }
        Err(format!("{before} roots before t − {0:e}, {by_then} before t + {0:e}", room * line.per_delta))
    }
}

/// A Sturm sequence: its changes of sign count the distinct real roots of its first polynomial.
struct Sturm {
    sequence: Vec<Vec<Big>>,
}

impl Sturm {
    fn new(polynomial: Vec<Big>) -> Self {
        let derivative =
            (1_u32..).zip(&polynomial[1..]).map(|(k, x)| Big::of(f64::from(k)) * x.clone()).collect::<Vec<_>>();
        let mut sequence = vec![scaled(polynomial), scaled(derivative)];
        loop {
            let [.., dividend, divisor] = sequence.as_slice() else { unreachable!("two to begin with") };
            if divisor.len() < 2 {
                return Self { sequence };
            }
            let rest = remainder(dividend, divisor);
            if rest.is_empty() {
                return Self { sequence };
            }
            sequence.push(scaled(rest.into_iter().map(|x| -x).collect()));
        }
    }

    fn all_roots(&self) -> usize {
        self.changes(|p| if p.len() % 2 == 0 { -p[p.len() - 1].clone() } else { p[p.len() - 1].clone() })
            - self.changes(|p| p[p.len() - 1].clone())
    }

    fn roots_until(&self, delta: &Big) -> usize {
        let value =
            |p: &[Big]| p.iter().rev().fold(Big::of(0.0), |sum, coefficient| sum * delta.clone() + coefficient.clone());
        self.changes(|p| if p.len() % 2 == 0 { -p[p.len() - 1].clone() } else { p[p.len() - 1].clone() })
            - self.changes(value)
    }

    fn changes(&self, value: impl Fn(&[Big]) -> Big) -> usize {
        let zero = Big::of(0.0);
        let signs: Vec<bool> =
            self.sequence.iter().map(|p| value(p)).filter(|x| *x != zero).map(|x| x > zero).collect();
        signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
    }
}

/// The polynomial with its largest coefficient brought near to 1 by a power of two.
fn scaled(polynomial: Vec<Big>) -> Vec<Big> {
    let zero = Big::of(0.0);
    let largest = polynomial.iter().map(Number::size).fold(zero.clone(), |a, b| if a > b { a } else { b });
    if largest == zero {
        return polynomial;
    }
    let power = Big::of(2.0_f64.powf(-largest.nearest().log2().floor()));
    polynomial.into_iter().map(|x| x * power.clone()).collect()
}

/// What a division leaves. A leading coefficient below 2⁻²⁰⁰ is what rounding leaves of zero.
fn remainder(dividend: &[Big], divisor: &[Big]) -> Vec<Big> {
    let mut rest = dividend.to_vec();
    let leading = divisor.last().expect("it is not empty");
    while rest.len() >= divisor.len() {
        let factor = rest.pop().expect("it is long enough") / leading.clone();
        let shift = rest.len() + 1 - divisor.len();
        for (i, coefficient) in divisor[..divisor.len() - 1].iter().enumerate() {
            rest[shift + i] = rest[shift + i].clone() - factor.clone() * coefficient.clone();
        }
    }
    while rest.last().is_some_and(|x| x.size() < Big::of(2.0_f64.powi(-200))) {
        rest.pop();
    }
    rest
}

#[test]
fn sturm_counts_the_roots_of_a_quartic() {
    // (δ − 1) (δ − 2) (δ + 3) δ = δ⁴ − 7 δ² + 6 δ.
    let numbers = |list: &[f64]| list.iter().map(|x| Big::of(*x)).collect::<Vec<_>>();
    let sturm = Sturm::new(numbers(&[0.0, 6.0, -7.0, 0.0, 1.0]));
    assert_eq!(sturm.all_roots(), 4);
    assert_eq!([-4.0, -1.0, 0.5, 1.5, 3.0].map(|x| sturm.roots_until(&Big::of(x))), [0, 1, 2, 3, 4]);
    assert_eq!(Sturm::new(numbers(&[1.0, 0.0, 2.0, 0.0, 1.0])).all_roots(), 0);
    assert_eq!(Sturm::new(numbers(&[1.0, 0.0, -2.0, 0.0, 1.0])).all_roots(), 2);
}
