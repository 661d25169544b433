//! What a ray meets of a set that is written with spheres, cones, cylinders and planes, without coincident surfaces.
//!
//! The sets here are the sets of the scenes, written in another way: S ∩ S is S, and a pipe is a cylinder without a
//! longer one. Nothing has to be decided by rule then: an answer follows from the signs of polynomials.

use super::line::{Line, PixelRay};
use super::number::{Big, Number, dot, squared};
use super::truth::{Seen, Truth, Verdict};
use glam::DAffine3;
use rayscope::scene::Scene;

/// A surface in generic coordinates, with what is inside it.
#[derive(Clone, Copy, Debug)]
pub enum Surface {
    /// x² + y² + z² < 1.
    Ball,
    /// x² + y² < (1 + (s − 1) z)², where the radius is positive.
    Wall {
        /// The radius at z = 1.
        s: f64,
    },
    /// ±coordinate < offset.
    Side {
        /// Which coordinate: 0, 1 or 2.
        axis: usize,
        /// Its sign.
        sign: f64,
        /// The offset.
        offset: f64,
    },
}

/// A convex part: what lies inside all of its surfaces, in the generic coordinates of a leaf of the scene.
pub struct Part {
    /// Object and leaf whose placement it has.
    pub stands_as: [usize; 2],
    /// The material that is seen.
    pub material: usize,
    /// Its surfaces.
    pub surfaces: Vec<Surface>,
}

/// A set made of parts.
pub enum Set {
    /// Nothing.
    Empty,
    /// A part, by its number.
    Part(usize),
    /// The first without the second.
    Without(Box<Set>, Box<Set>),
    /// What is in either.
    Either(Box<Set>, Box<Set>),
}

/// The whole truth about a picture.
pub struct Sets {
    /// The parts.
    pub parts: Vec<Part>,
    /// What they make.
    pub set: Set,
}

/// An end of a span: t with the material there; none at infinity.
type End<N> = Option<(N, usize)>;
type Spans<N> = Vec<[End<N>; 2]>;

impl Sets {
    /// The set of one part.
    pub fn one(part: Part) -> Self {
        Self { parts: vec![part], set: Set::Part(0) }
    }

    /// The first part without the second.
    pub fn difference(first: Part, second: Part) -> Self {
        let set = Set::Without(Box::new(Set::Part(0)), Box::new(Set::Part(1)));
        Self { parts: vec![first, second], set }
    }

    /// Nothing is seen anywhere.
    pub const fn empty() -> Self {
        Self { parts: Vec::new(), set: Set::Empty }
    }

    fn lines<N: Number>(&self, scene: &Scene, ray: PixelRay) -> Vec<Line<N>> {
        self.parts.iter().map(|part| Line::new(ray, &placement(scene, part.stands_as))).collect()
    }

    /// The spans of each part, grown by `sign` times what `scale` makes of the doubt.
    fn spans<N: Number>(&self, lines: &[Line<N>], sign: f64, scale: impl Fn(f64) -> f64) -> Vec<Spans<N>> {
        let each = self.parts.iter().zip(lines);
        each.map(|(part, line)| part.spans(line, sign * scale(line.doubt))).collect()
    }

    /// The first hit in front.
    fn first<N: Number>(&self, spans: &[&Spans<N>]) -> End<N> {
        let zero = N::of(0.0);
        let ends = self.set.spans(spans).into_iter().flatten().flatten();
        ends.filter(|(t, _)| *t > zero).min_by(|a, b| a.0.partial_cmp(&b.0).expect("numbers"))
    }

    /// The first hits with each part a little smaller or larger, in all combinations.
    fn moved<N: Number>(&self, lines: &[Line<N>], scale: impl Fn(f64) -> f64) -> Vec<End<N>> {
        let [smaller, larger] = [-1.0, 1.0].map(|sign| self.spans(lines, sign, &scale));
        let choose = |bits: u32, i: usize| if bits >> i & 1 == 1 { &larger[i] } else { &smaller[i] };
        let pattern = |bits: u32| (0..self.parts.len()).map(|i| choose(bits, i)).collect::<Vec<_>>();
        (0..1_u32 << self.parts.len()).map(|bits| self.first(&pattern(bits))).collect()
    }

    fn exact<N: Number>(&self, lines: &[Line<N>]) -> End<N> {
        let spans = self.spans(lines, 0.0, |doubt| doubt);
        self.first(&spans.iter().collect::<Vec<_>>())
    }

    /// What is seen if that is the same in all combinations.
    fn agreed<N: Number>(&self, lines: &[Line<N>], scale: impl Fn(f64) -> f64) -> Option<Verdict> {
        let seen: Vec<Seen> = self.moved(lines, scale).iter().map(|end| material(end.as_ref())).collect();
        seen.iter().all(|other| *other == seen[0]).then(|| Verdict { seen: seen[0], sure: true })
    }
}

fn material<N>(end: Option<&(N, usize)>) -> Seen {
    end.map(|(_, material)| *material)
}

/// Beyond this a plain `f64` look cannot be wrong: its own errors are smaller by seven decimal digits.
const PLAIN: f64 = 1e-7;

impl Truth for Sets {
    fn verdict(&self, scene: &Scene, ray: PixelRay) -> Verdict {
        if let Some(quick) = self.agreed(&self.lines::<f64>(scene, ray), |doubt| PLAIN.max(1e6 * doubt)) {
            return quick;
        }
        let lines = self.lines::<Big>(scene, ray);
        let unsure = || Verdict { seen: material(self.exact(&lines).as_ref()), sure: false };
        self.agreed(&lines, |doubt| doubt).unwrap_or_else(unsure)
    }

    fn time(&self, scene: &Scene, ray: PixelRay, t: f64) -> Result<(), String> {
        let lines = self.lines::<Big>(scene, ray);
        let nearest = |end: &End<Big>| end.as_ref().map(|(t, _)| t.nearest());
        let exact = nearest(&self.exact(&lines)).ok_or("there is no hit")?;
        let moved = self.moved(&lines, |doubt| 4.0 * doubt);
        let away = moved.iter().filter_map(nearest).map(|moved| (moved - exact).abs());
        let room = away.fold(4.0 * f64::EPSILON * exact, f64::max);
        if (t - exact).abs() <= room { Ok(()) } else { Err(format!("t = {exact:e} ± {room:e}")) }
    }
}

/// The placement of a leaf of the scene, generic to world.
pub fn placement(scene: &Scene, [object, leaf]: [usize; 2]) -> DAffine3 {
    scene.objects[object].solid.leaves[leaf].placement.world_from_generic()
}

impl Set {
    fn spans<N: Number>(&self, parts: &[&Spans<N>]) -> Spans<N> {
        match self {
            Self::Empty => Vec::new(),
            Self::Part(i) => parts[*i].clone(),
            Self::Without(a, b) => common(&a.spans(parts), &outside(&b.spans(parts))),
            Self::Either(a, b) => outside(&common(&outside(&a.spans(parts)), &outside(&b.spans(parts)))),
        }
    }
}

impl Part {
    /// Where the ray is inside all surfaces, each moved outwards by `grown` in generic coordinates.
    fn spans<N: Number>(&self, line: &Line<N>, grown: f64) -> Spans<N> {
        let mut spans = vec![[None, None]];
        for surface in &self.surfaces {
            for inside in surface.inside(line, grown) {
                let time = |delta: Option<N>| {
                    delta.map(|delta| (line.foot.clone() + delta * N::of(line.per_delta), self.material))
                };
                let allowed: Spans<N> = inside.into_iter().map(|ends| ends.map(time)).collect();
                spans = common(&spans, &allowed);
            }
        }
        spans
    }
}

impl Surface {
    /// The conditions that the surface makes, each as the spans of δ where it holds.
    fn inside<N: Number>(self, line: &Line<N>, grown: f64) -> Vec<Vec<[Option<N>; 2]>> {
        let (l, c) = (&line.l, &line.c);
        match self {
            Self::Ball => {
                let radius = N::of(1.0) + N::of(grown);
                vec![below_zero(&dot(c, c), &dot(l, c), &(dot(l, l) - squared(&radius)))]
            }
            Self::Wall { s } => {
                let slope = N::of(s) - N::of(1.0);
                let radius =
                    N::of(1.0) + slope.clone() * l[2].clone() + N::of(grown * (1.0 + (s - 1.0).powi(2)).sqrt());
                let change = slope * c[2].clone();
                let a = squared(&c[0]) + squared(&c[1]) - squared(&change);
                let b = l[0].clone() * c[0].clone() + l[1].clone() * c[1].clone() - radius.clone() * change.clone();
                let constant = squared(&l[0]) + squared(&l[1]) - squared(&radius);
                vec![below_zero(&a, &b, &constant), linear_below_zero(&-change, &-radius)]
            }
            Self::Side { axis, sign, offset } => {
                let (speed, start) = (c[axis].clone() * N::of(sign), l[axis].clone() * N::of(sign));
                vec![linear_below_zero(&speed, &(start - N::of(offset) - N::of(grown)))]
            }
        }
    }
}

/// Where a δ² + 2 b δ + c < 0. Touched points are no spans.
fn below_zero<N: Number>(a: &N, b: &N, c: &N) -> Vec<[Option<N>; 2]> {
    let zero = N::of(0.0);
    if *a == zero {
        return linear_below_zero(&(N::of(2.0) * b.clone()), c);
    }
    let discriminant = squared(b) - a.clone() * c.clone();
    if discriminant <= zero {
        return if *a > zero { Vec::new() } else { vec![[None, None]] };
    }
    let root = discriminant.root();
    let q = if *b < zero { root - b.clone() } else { -(b.clone() + root) };
    let (first, second) = (q.clone() / a.clone(), c.clone() / q);
    let (low, high) = if first < second { (first, second) } else { (second, first) };
    if *a > zero { vec![[Some(low), Some(high)]] } else { vec![[None, Some(low)], [Some(high), None]] }
}

/// Where a δ + b < 0.
fn linear_below_zero<N: Number>(a: &N, b: &N) -> Vec<[Option<N>; 2]> {
    let zero = N::of(0.0);
    if *a == zero {
        return if *b < zero { vec![[None, None]] } else { Vec::new() };
    }
    let at = -b.clone() / a.clone();
    if *a > zero { vec![[None, Some(at)]] } else { vec![[Some(at), None]] }
}

/// What lies in both.
fn common<N: Number>(a: &Spans<N>, b: &Spans<N>) -> Spans<N> {
    let mut result = Vec::new();
    for [a_in, a_out] in a {
        for [b_in, b_out] in b {
            let enter = pick(a_in.as_ref(), b_in.as_ref(), |a, b| a >= b);
            let leave = pick(a_out.as_ref(), b_out.as_ref(), |a, b| a <= b);
            let empty = matches!((&enter, &leave), (Some((t_in, _)), Some((t_out, _))) if t_in >= t_out);
            if !empty {
                result.push([enter, leave]);
            }
        }
    }
    result
}

fn pick<N: Number>(a: Option<&(N, usize)>, b: Option<&(N, usize)>, first: impl Fn(&N, &N) -> bool) -> End<N> {
    match (a, b) {
        (Some((x, _)), Some((y, _))) if first(x, y) => a.cloned(),
        (Some(_), None) => a.cloned(),
        _ => b.cloned(),
    }
}

/// What lies between the spans, which are in order.
fn outside<N: Number>(spans: &Spans<N>) -> Spans<N> {
    let mut result = Vec::new();
    let mut from = Some(None);
    for [enter, leave] in spans {
        if let (Some(from), true) = (from, enter.is_some()) {
            result.push([from, enter.clone()]);
        }
        from = leave.clone().map(Some);
    }
    if let Some(from) = from {
        result.push([from, None]);
    }
    result
}

/// The surfaces of the generic cube.
pub fn cube() -> Vec<Surface> {
    (0..3).flat_map(|axis| [1.0, -1.0].map(|sign| Surface::Side { axis, sign, offset: 1.0 })).collect()
}

/// The surfaces of the generic tapered cylinder.
pub fn tapered_cylinder(s: f64) -> Vec<Surface> {
    let base = Surface::Side { axis: 2, sign: -1.0, offset: 0.0 };
    vec![Surface::Wall { s }, base, Surface::Side { axis: 2, sign: 1.0, offset: 1.0 }]
}

/// A part of the first object.
pub fn part(leaf: usize, surfaces: Vec<Surface>) -> Part {
    Part { stands_as: [0, leaf], material: leaf, surfaces }
}

#[test]
fn a_ray_along_x_meets_a_hollow_ball_twice() {
    let spans = |t_in: f64, t_out: f64| vec![[Some((t_in, 0)), Some((t_out, 0))]];
    let shell = common(&spans(1.0, 4.0), &outside(&spans(2.0, 3.0)));
    let ends: Vec<f64> = shell.into_iter().flatten().flatten().map(|(t, _)| t).collect();
    assert_eq!(ends, [1.0, 2.0, 3.0, 4.0]);
}

#[test]
fn what_is_seen_is_a_material() {
    let seen: Seen = Some(3);
    assert_eq!(Verdict { seen, sure: true }.seen, Some(3));
}
