//! Fields that are compared with a name or a number.

use super::context::View;
use super::term::{Names, Term, Test};
use crate::record::{Certificate, Operator, RayKind, Sense, What};
use crate::shape::Shape;

/// A test of a field's names.
pub(super) type OfName<'a> = &'a mut dyn FnMut(&str) -> bool;
/// A test of a field's numbers.
pub(super) type OfNumber<'a> = &'a mut dyn FnMut(f64) -> bool;

/// A field with numbers as values.
pub(super) type Numbers = fn(&View, OfNumber) -> bool;

const fn names(
    name: &'static str,
    meaning: &'static str,
    example: &'static str,
    from: Names,
    test: fn(&View, OfName) -> bool,
) -> Term {
    Term { name, meaning, example, test: Test::Names(test, from) }
}

const fn numbers(
    name: &'static str,
    meaning: &'static str,
    example: &'static str,
    test: fn(&View, OfNumber) -> bool,
) -> Term {
    Term { name, meaning, example, test: Test::Numbers(test) }
}

/// All fields.
pub(super) static FIELDS: &[Term] = &[
    names("kind", "the kind of the ray that it happens to", "kind=refracted", Names::Listed(ray_kinds), kind),
    numbers("depth", "how many rays that ray is away from the one from the eye", "depth>=2", depth),
    numbers("weight", "the share of that ray's colour in the pixel", "weight<0.1", weight),
    numbers("wavelength", "the one wavelength of that ray, in nanometres", "wavelength>600", wavelength),
    names("medium", "what that ray travels in", "medium=water", Names::OfScene(|v| &v.media), medium),
    names("left", "the object that that ray starts on", "left=bowl & hit", Names::OfScene(|v| &v.objects), left),
    names("hit", "of a hit: the object", "hit=glass*", Names::OfScene(|v| &v.objects), hit),
    names(
        "object",
        "the object that is asked or hit",
        "object=lens & csg.early_out",
        Names::OfScene(|v| &v.objects),
        object,
    ),
    names("leaf", "the primitive that is asked or hit", "leaf=handle & hit", Names::OfScene(|v| &v.leaves), leaf),
    names("shape", "its shape", "shape=torus & hit", Names::Listed(shapes), shape),
    names("part", "the part of its surface", "part=top & hit", Names::OfScene(|v| &v.parts), part),
    names(
        "material",
        "the material of the surface that is hit",
        "material=glass & tir",
        Names::OfScene(|v| &v.materials),
        material,
    ),
    names("sense", "what the boundary that is hit does to the ray", "sense=leave", Names::Listed(senses), sense),
    numbers("t", "the hit time", "hit & t<3", time),
    numbers("hits", "how many hits a primitive has on the whole line", "hits>2", hits),
    numbers("intervals", "how many stretches of the line are inside an object", "intervals>=2", intervals),
    names("certificate", "how surely it is known", "certificate=fallback", Names::Listed(certificates), certificate),
    names("reason", "why something does not count or was left out", "reason=*behind*", Names::Any, reason),
    names("node", "the node of a Boolean tree", "node=cut & csg.empty", Names::OfScene(|v| &v.nodes), node),
    names("operator", "how a node combines its operands", "operator=difference", Names::Listed(operators), operator),
    names(
        "light",
        "the light whose terms it is a part of",
        "light=key & shadowed",
        Names::OfScene(|v| &v.lights),
        light,
    ),
    numbers("passes", "the share of a light that an object lets through", "passes<0.5", passes),
    numbers("n1", "the index of refraction on the incoming side", "n1>1.3", |v, test| {
        snell(v).is_some_and(|s| test(s.n[0]))
    }),
    numbers("n2", "the index of refraction on the far side", "n2=1", |v, test| snell(v).is_some_and(|s| test(s.n[1]))),
    numbers("theta1", "the angle of incidence, in degrees", "theta1>40", theta1),
    numbers("theta2", "the angle of refraction, in degrees", "theta2<10", |v, test| {
        snell(v).and_then(|s| s.theta2).is_some_and(test)
    }),
    numbers("reflectance", "the share of light that a surface mirrors", "reflectance>0.5", reflectance),
    names("limit", "the limit that stops something", "limit=depth", Names::Listed(limits), limit),
    numbers("step", "the number of the step of § 6.1 that it is a part of", "step=3", step),
    numbers("x", "the pixel's column, from 0", "x<100 & hit", |v, test| pixel(v).is_some_and(|[x, _]| test(x))),
    numbers("y", "the pixel's row, from 0 at the top", "y>=240 & hit", |v, test| {
        pixel(v).is_some_and(|[_, y]| test(y))
    }),
];

fn ray_kinds() -> &'static [&'static str] {
    const NAMES: [&str; RayKind::ALL.len()] = {
        let mut names = [""; RayKind::ALL.len()];
        let mut k = 0;
        while k < names.len() {
            names[k] = RayKind::ALL[k].name();
            k += 1;
        }
        names
    };
    &NAMES
}

fn shapes() -> &'static [&'static str] {
    Shape::NAMES
}

fn senses() -> &'static [&'static str] {
    &["enter", "leave", "touch"]
}

fn certificates() -> &'static [&'static str] {
    &["certain", "fallback", "undecidable"]
}

fn operators() -> &'static [&'static str] {
    const { &[Operator::Union.name(), Operator::Intersection.name(), Operator::Difference.name()] }
}

fn limits() -> &'static [&'static str] {
    &["depth", "contribution", "rays", "turns", "recording size"]
}

fn kind(view: &View, test: OfName) -> bool {
    match view.ray() {
        Some(What::Ray { ray, .. }) => test(ray.name()),
        Some(What::LooseRay { .. }) => test(RayKind::Camera.name()),
        _ => false,
    }
}

fn depth(view: &View, test: OfNumber) -> bool {
    match view.ray() {
        Some(What::Ray { depth, .. }) => test(f64::from(*depth)),
        Some(What::LooseRay { .. }) => test(0.0),
        _ => false,
    }
}

fn weight(view: &View, test: OfNumber) -> bool {
    match view.ray() {
        Some(What::Ray { weight, .. }) => test(*weight),
        Some(What::LooseRay { .. }) => test(1.0),
        _ => false,
    }
}

fn wavelength(view: &View, test: OfNumber) -> bool {
    match (view.what(), view.ray()) {
        (What::Wavelength(one), _) => test(one.nanometres),
        (_, Some(What::Ray { wavelength: Some(nanometres), .. })) => test(*nanometres),
        _ => false,
    }
}

fn medium(view: &View, test: OfName) -> bool {
    match (view.what(), view.ray()) {
        (What::Segment(segment), _) => test(&segment.medium),
        (What::Scatter(scatter), _) => test(&scatter.medium),
        (What::Passage(passage), _) => test(&passage.medium),
        (_, Some(What::Ray { medium, .. })) => test(medium),
        _ => false,
    }
}

fn left(view: &View, test: OfName) -> bool {
    matches!(view.ray(), Some(What::Ray { left: Some(left), .. }) if test(left))
}

fn hit(view: &View, test: OfName) -> bool {
    matches!(view.what(), What::Hit { object, .. } if test(object))
}

/// Within a search the object that is asked, whose nodes have names of their own; elsewhere its own, or that of the hit.
fn object(view: &View, test: OfName) -> bool {
    if let Some(What::Object { name, .. }) = view.object() {
        return test(name);
    }
    match view.what() {
        What::Hit { object, .. }
        | What::Rejected { object, .. }
        | What::Moved { object, .. }
        | What::Shadow { object, .. } => test(object),
        What::Medium { object, .. } => test(object) || object.split(" and ").any(test),
        What::Overlap(overlap) => test(&overlap.first) || test(&overlap.second),
        _ => matches!(view.hit(), Some(What::Hit { object, .. }) if test(object)),
    }
}

fn leaf(view: &View, test: OfName) -> bool {
    match (view.what(), view.leaf()) {
        (What::Rejected { leaf, .. }, _) => test(leaf),
        (_, Some(What::Primitive { name, .. })) => test(name),
        _ => matches!(view.hit(), Some(What::Hit { leaf, .. }) if test(leaf)),
    }
}

fn shape(view: &View, test: OfName) -> bool {
    match (view.what(), view.leaf(), view.hit()) {
        (What::Rejected { .. }, ..) => false,
        (_, Some(What::Primitive { shape, .. }), _) | (_, None, Some(What::Hit { shape, .. })) => test(shape),
        _ => false,
    }
}

fn part(view: &View, test: OfName) -> bool {
    match view.what() {
        What::Rejected { part, .. } => test(part),
        What::Roots { candidates } => candidates.iter().any(|candidate| test(&candidate.part)),
        What::Planes { rows, .. } => rows.iter().any(|row| test(&row.name)),
        _ => matches!(view.hit(), Some(What::Hit { part, .. }) if test(part)),
    }
}

fn material(view: &View, test: OfName) -> bool {
    match view.what() {
        What::Detail(detail) => test(&detail.material) || test(&detail.below),
        What::Rejected { .. } => false,
        _ => matches!(view.hit(), Some(What::Hit { material, .. }) if test(material)),
    }
}

fn sense(view: &View, test: OfName) -> bool {
    let name = |sense: Sense| match sense {
        Sense::Enter => "enter",
        Sense::Leave => "leave",
        Sense::Touch => "touch",
    };
    match (view.what(), view.hit()) {
        (What::Roots { candidates }, _) => candidates.iter().any(|candidate| test(name(candidate.sense))),
        (What::Rejected { .. }, _) => false,
        (_, Some(What::Hit { sense, .. })) => test(name(*sense)),
        _ => false,
    }
}

fn time(view: &View, test: OfNumber) -> bool {
    match view.what() {
        What::Rejected { t, .. } | What::Shadow { t, .. } => test(*t),
        What::Roots { candidates } => candidates.iter().any(|candidate| test(candidate.t)),
        What::Quadratic { roots, .. } | What::Quartic { roots, .. } | What::Search { roots, .. } => {
            roots.iter().copied().any(test)
        }
        _ => matches!(view.hit(), Some(What::Hit { t, .. }) if test(*t)),
    }
}

fn hits(view: &View, test: OfNumber) -> bool {
    matches!(view.what(), What::Primitive { hits, .. } if test(*hits as f64))
}

fn intervals(view: &View, test: OfNumber) -> bool {
    matches!(view.what(), What::Object { intervals, .. } if test(*intervals as f64))
}

fn certificate(view: &View, test: OfName) -> bool {
    match view.what() {
        What::Decision { certificate, .. } | What::Hit { certificate, .. } => test(match certificate {
            Certificate::Certain => "certain",
            Certificate::Fallback => "fallback",
            Certificate::Undecidable => "undecidable",
        }),
        _ => false,
    }
}

fn reason(view: &View, test: OfName) -> bool {
    match view.what() {
        What::Rejected { reason, .. }
        | What::Shadow { reason, .. }
        | What::Combine { early_out: Some(reason), .. }
        | What::Planes { stopped: Some(reason), .. } => test(reason),
        What::Roots { candidates } => candidates.iter().any(|candidate| test(&candidate.reason)),
        What::Limit { consequence, .. } => test(consequence),
        What::Medium { decided, .. } => test(decided),
        What::Average(average) => test(&average.stopped),
        _ => false,
    }
}

fn node(view: &View, test: OfName) -> bool {
    match view.what() {
        What::Combine { name, .. } => test(name),
        // Of what a node takes away, the node stands where the object does.
        What::Rejected { object, .. } if view.object().is_some() => test(object),
        _ => false,
    }
}

fn operator(view: &View, test: OfName) -> bool {
    matches!(view.what(), What::Combine { operator, .. } if test(operator.name()))
}

fn light(view: &View, test: OfName) -> bool {
    match (view.what(), view.light()) {
        (_, Some(What::Light { name, .. })) => test(name),
        (What::Phase(phase), _) => test(&phase.towards),
        _ => false,
    }
}

fn passes(view: &View, test: OfNumber) -> bool {
    matches!(view.what(), What::Shadow { passes, .. } if test(*passes))
}

/// What Snell's law says at a surface.
struct Snell {
    n: [f64; 2],
    theta1: f64,
    theta2: Option<f64>,
    reflectance: f64,
}

fn snell(view: &View) -> Option<Snell> {
    match view.what() {
        What::Snell { n1, n2, theta1, theta2, reflectance, .. } => {
            Some(Snell { n: [*n1, *n2], theta1: *theta1, theta2: *theta2, reflectance: *reflectance })
        }
        What::Wavelength(one) => {
            Some(Snell { n: [one.n1, one.n2], theta1: one.theta1, theta2: one.theta2, reflectance: one.reflectance })
        }
        _ => None,
    }
}

fn theta1(view: &View, test: OfNumber) -> bool {
    match view.what() {
        What::Conductor(metal) => test(metal.theta),
        _ => snell(view).is_some_and(|snell| test(snell.theta1)),
    }
}

fn reflectance(view: &View, test: OfNumber) -> bool {
    match view.what() {
        What::Conductor(metal) => metal.reflectance.into_iter().any(test),
        _ => snell(view).is_some_and(|snell| test(snell.reflectance)),
    }
}

fn limit(view: &View, test: OfName) -> bool {
    matches!(view.what(), What::Limit { limit, .. } if test(limit))
}

fn step(view: &View, test: OfNumber) -> bool {
    matches!(view.step(), Some(What::Step { number, .. }) if test(f64::from(*number)))
}

fn pixel(view: &View) -> Option<[f64; 2]> {
    match view.root() {
        Some(What::Pixel { x, y, .. }) => Some([f64::from(*x), f64::from(*y)]),
        _ => None,
    }
}
