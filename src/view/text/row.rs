//! The one-line description of an event.

use super::format::{brief, brief_vector, count, degrees, number_list, percent, quoted, times};
use super::{effect_row, texture_row};
use crate::record::{Candidate, CandidateFate, Certificate, Event, PlaneSense, RayKind, Tier, What};
use serde::{Deserialize, Serialize};

/// One line: an icon, what happened, and the numbers that matter most.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Row {
    /// What stands for its kind.
    pub icon: char,
    /// What happened.
    pub label: String,
    /// The key numbers; empty where there are none.
    pub numbers: String,
}

/// The one-line description of an event.
#[must_use]
pub fn row(event: &Event) -> Row {
    Row { icon: icon(&event.what), label: label(&event.what), numbers: numbers(event) }
}

/// The same without what came of the event: its name alone, and the ray that it begins with.
#[must_use]
pub fn untold_row(event: &Event) -> Row {
    let Row { icon, label, numbers } = row(event);
    // What came of it stands behind a colon.
    let label = label.rsplit_once(": ").map_or(label.as_str(), |(name, _)| name).to_owned();
    match &event.what {
        What::Pixel { .. }
        | What::LooseRay { .. }
        | What::Ray { ray: RayKind::Camera, .. }
        | What::Transform { .. } => Row { icon, label, numbers },
        What::Decision { .. } => Row { icon: '±', label, numbers: String::new() },
        _ => Row { icon, label, numbers: String::new() },
    }
}

fn icon(what: &What) -> char {
    match what {
        What::Pixel { .. } => '▣',
        What::LooseRay { .. } => '⇥',
        What::Step { number, .. } => *['•', '①', '②', '③', '④', '⑤', '⑥'].get(usize::from(*number)).unwrap_or(&'•'),
        What::Ray { ray, .. } => match ray {
            RayKind::Camera => '→',
            RayKind::Reflected => '↗',
            RayKind::Refracted => '↘',
            RayKind::Shadow => '⇢',
            RayKind::Scattered => '↝',
        },
        What::Sample(_) => '⊙',
        What::Average(_) => '∴',
        What::Lens(_) => '◊',
        What::Confusion(_) => '◯',
        What::LightSample(_) => '★',
        What::Wavelength(_) => 'λ',
        What::Conductor(_) => 'η',
        What::Segment(_) => '⊛',
        What::Scatter(_) => '⋆',
        What::Phase(_) => 'φ',
        What::Passage(_) => '◨',
        What::Overlap(_) => '∩',
        What::Object { .. } => '◆',
        What::Extent { .. } => '□',
        What::Ball { .. } => '○',
        What::Projection { .. } => '▭',
        What::Transform { .. } => '⇄',
        What::Primitive { .. } => '●',
        What::Planes { .. } => '▤',
        What::Quadratic { .. } => '²',
        What::Quartic { .. } => '⁴',
        What::Search { .. } => '≈',
        What::Decision { certificate: Certificate::Undecidable, .. } => '?',
        What::Decision { .. } => '±',
        What::Implicit { .. } => 'ƒ',
        What::Roots { .. } => '√',
        What::Combine { operator, .. } => operator.sign(),
        What::Moved { .. } => '↕',
        What::Rejected { .. } => '✗',
        What::Hit { .. } => '✓',
        What::Nothing { .. } => '∅',
        What::Detail(_) => '▱',
        What::Texture(_) => '▦',
        What::Mapping(_) => '⊞',
        What::Texels(_) => '▩',
        What::Lattice(_) => '⋰',
        What::Octaves(_) => '∿',
        What::Undulate(_) => '∽',
        What::Rings(_) => '◎',
        What::Bump(_) => '∡',
        What::FrameMap(_) => '⊥',
        What::Environment(_) => '◍',
        What::Ambient { .. } => '◌',
        What::Light { .. } => '☼',
        What::Shadow { .. } => '◐',
        What::Reflection { .. } => '∨',
        What::Snell { .. } => '∠',
        What::Medium { .. } => '◫',
        What::Limit { .. } => '⊘',
        What::Colour { .. } => 'Σ',
        What::Written { .. } => '■',
    }
}

fn label(what: &What) -> String {
    match what {
        What::Pixel { x, y, .. } => format!("Pixel ({x}, {y})"),
        What::LooseRay { .. } => "A given ray".to_owned(),
        What::Step { title, .. } => title.clone(),
        What::Ray { ray, depth, .. } if *depth == 0 => format!("{} ray", capitalised(ray.name())),
        What::Ray { ray, depth, .. } => format!("{} ray, depth {depth}", capitalised(ray.name())),
        What::Object { name, intervals, .. } => format!("{name}: {}", count(*intervals, "inside interval")),
        What::Extent { of, inside: Some(_), .. } => format!("extent of {of}: the ray may hit"),
        What::Extent { of, inside: None, .. } => format!("extent of {of}: missed"),
        What::Ball { of, is_met: true, .. } => format!("ball around {of}: the ray may hit"),
        What::Ball { of, is_met: false, .. } => format!("ball around {of}: missed"),
        What::Projection { of, holds: true, .. } => format!("rectangle of {of} in the picture: the ray may hit"),
        What::Projection { of, .. } => format!("rectangle of {of} in the picture: missed"),
        What::Transform { of, .. } => format!("ray into the generic coordinates of {of}"),
        What::Primitive { shape, name, hits, .. } => format!("{}: {}", titled(shape, name), count(*hits, "hit")),
        What::Planes { rows, stopped: None } => format!("plane table: {}", count(rows.len(), "row")),
        What::Planes { rows, stopped: Some(_) } => format!("plane table: stopped after {}", count(rows.len(), "row")),
        What::Quadratic { about, roots, .. } => format!("quadratic for {about}: {}", count(roots.len(), "root")),
        What::Quartic { roots, .. } => format!("quartic: {}", count(roots.len(), "root")),
        What::Search { roots, .. } => format!("search for the zeros of d(t): {}", count(roots.len(), "root")),
        What::Decision { certificate, tiers, .. } => {
            let by = tiers.last().map(|tier| tier.arithmetic.as_str()).unwrap_or_default();
            match certificate {
                Certificate::Undecidable => "closest decision: undecidable at input precision".to_owned(),
                certificate => format!("closest decision: {} in {by}", certificate_words(*certificate)),
            }
        }
        What::Implicit { roots, .. } => format!("d(t) along the ray: {}", count(roots.len(), "zero")),
        What::Roots { candidates } => {
            format!("hit times: {} of {} kept", accepted(candidates).count(), candidates.len())
        }
        What::Combine { name, operator, early_out, .. } => {
            let out = if early_out.is_some() { ": early out" } else { "" };
            let of = if name == operator.name() { String::new() } else { format!("{name} = ") };
            format!("{of}left {} right{out}", operator.sign())
        }
        What::Moved { object, .. } => format!("start moved off the surface of {object}"),
        What::Rejected { object, leaf, part, .. } => format!("not {}", surface(object, leaf, part)),
        What::Hit { object, leaf, part, .. } => format!("hit {}", surface(object, leaf, part)),
        What::Nothing { .. } => "nothing in front: the background".to_owned(),
        What::Detail(detail) => texture_row::detail_label(detail),
        What::Texture(texture) => format!("texture: {}", texture_row::spoken(&texture.texture)),
        What::Mapping(mapping) => texture_row::mapping_label(mapping),
        What::Texels(texels) => texture_row::texels_label(texels),
        What::Lattice(lattice) => texture_row::lattice_label(lattice),
        What::Octaves(octaves) => texture_row::octaves_label(octaves),
        What::Undulate(_) => "colour from the spline".to_owned(),
        What::Rings(rings) => texture_row::rings_label(rings),
        What::Bump(bump) => texture_row::bump_label(bump),
        What::FrameMap(frame) => texture_row::frame_label(frame),
        What::Environment(environment) => texture_row::environment_label(environment),
        What::Sample(sample) => format!("sample {}", sample.number + 1),
        What::Average(average) => effect_row::average_label(average),
        What::Lens(lens) => effect_row::lens_label(lens),
        What::Confusion(_) => "circle of confusion".to_owned(),
        What::LightSample(sample) => effect_row::light_sample_label(sample),
        What::Wavelength(wavelength) => effect_row::wavelength_label(wavelength),
        What::Conductor(_) => "Fresnel's equations for a metal".to_owned(),
        What::Segment(segment) => format!("through {}", segment.medium),
        What::Scatter(scatter) => effect_row::scatter_label(scatter),
        What::Phase(phase) => effect_row::phase_label(phase),
        What::Passage(passage) => format!("what comes out of {}", passage.medium),
        What::Overlap(overlap) => format!("{} and {} fill the same space", overlap.first, overlap.second),
        What::Ambient { .. } => "ambient term".to_owned(),
        What::Light { name, arriving, .. } if *arriving == [0.0; 3] => format!("light {name}: none arrives"),
        What::Light { name, .. } => format!("light {name}: diffuse and specular terms"),
        What::Shadow { object, passes, .. } if *passes == 0.0 => format!("in the shadow of {object}"),
        What::Shadow { object, .. } => format!("light passes through {object}"),
        What::Reflection { .. } => "mirrored direction".to_owned(),
        What::Snell { total_internal_reflection: true, .. } => "Snell's law: total internal reflection".to_owned(),
        What::Snell { .. } => "Snell's law".to_owned(),
        What::Medium { hidden: true, object, .. } => format!("boundary of {object}: passed as if it were not there"),
        What::Medium { before, after, .. } => format!("medium: {before} → {after}"),
        What::Limit { limit, consequence, .. } => format!("stopped by {limit}: {consequence}"),
        What::Colour { .. } => "colour: the sum of its five components".to_owned(),
        What::Written { .. } => "the pixel as written".to_owned(),
    }
}

fn numbers(event: &Event) -> String {
    match &event.what {
        What::Pixel { width, height, .. } => format!("of {width} × {height}"),
        What::LooseRay { origin, direction } => format!("{} + {} t", brief_vector(*origin), brief_vector(*direction)),
        What::Step { .. } => {
            event.working.last().map(|line| format!("{} = {}", line.symbol, line.result)).unwrap_or_default()
        }
        What::Ray { origin, direction, weight, .. } if *weight == 1.0 => {
            format!("{} + {} t", brief_vector(*origin), brief_vector(*direction))
        }
        What::Ray { origin, direction, weight, wavelength, .. } => {
            let line = format!("{} + {} t", brief_vector(*origin), brief_vector(*direction));
            let one = wavelength.map(|nanometres| format!(", {} nm", brief(nanometres))).unwrap_or_default();
            format!("{line}, weight {}{one}", brief(*weight))
        }
        What::Ball { radius, distance, is_met, .. } => {
            format!("{} {} {}", brief(*distance), if *is_met { "≤" } else { ">" }, brief(*radius))
        }
        What::Extent { inside: Some([near, far]), .. } => format!("t from {} to {}", brief(*near), brief(*far)),
        What::Projection { low: [left, top], high: [right, bottom], .. } => {
            let [left, top, right, bottom] = [left, top, right, bottom].map(|edge| brief(*edge));
            format!("x from {left} to {right}, y from {top} to {bottom}")
        }
        What::Transform { origin, direction, .. } => {
            format!("S = {}, c = {}", brief_vector(*origin), brief_vector(*direction))
        }
        What::Roots { candidates } => times_at(accepted(candidates).map(|candidate| candidate.t)),
        What::Planes { rows, .. } => planes_outcome(rows),
        What::Quadratic { discriminant, roots, .. } if roots.is_empty() => format!("D = {}", brief(*discriminant)),
        What::Quadratic { roots, .. }
        | What::Quartic { roots, .. }
        | What::Search { roots, .. }
        | What::Implicit { roots, .. } => times_at(roots.iter().copied()),
        What::Decision { tiers, .. } => tiers.last().map(margin).unwrap_or_default(),
        What::Combine { combined, .. } => times(combined),
        What::Moved { by, .. } => format!("by {}", brief(*by)),
        What::Rejected { t, reason, .. } => format!("t = {}: {}", brief(*t), quoted(reason)),
        What::Hit { t, point, .. } => format!("t = {} at {}", brief(*t), brief_vector(*point)),
        What::Nothing { background } => brief_vector(*background),
        What::Detail(detail) => format!("(u, v) = {}", texture_row::place(detail.uv)),
        What::Texture(texture) => brief_vector(texture.colour),
        What::Mapping(mapping) => texture_row::mapping_numbers(mapping),
        What::Texels(texels) => brief_vector(texels.colour),
        What::Lattice(lattice) => format!("noise = {}", brief(lattice.noise)),
        What::Octaves(octaves) => format!("sum = {}", brief(octaves.sum)),
        What::Undulate(undulate) => format!("at {}: {}", brief(undulate.argument), brief_vector(undulate.colour)),
        What::Rings(rings) => texture_row::rings_numbers(rings),
        What::Bump(bump) => texture_row::bump_numbers(bump),
        What::FrameMap(frame) => texture_row::frame_numbers(frame),
        What::Environment(environment) => brief_vector(environment.colour),
        What::Sample(sample) => format!("at {}", texture_row::place(sample.at)),
        What::Average(average) => brief_vector(average.colour),
        What::Lens(lens) => format!("from {} through {}", brief_vector(lens.point), brief_vector(lens.focus)),
        What::Confusion(confusion) => effect_row::confusion_numbers(confusion),
        What::LightSample(sample) => format!("at {}, {} away", brief_vector(sample.point), brief(sample.distance)),
        What::Wavelength(wavelength) => effect_row::wavelength_numbers(wavelength),
        What::Conductor(metal) => format!("at {}: {}", degrees(metal.theta), brief_vector(metal.reflectance)),
        What::Segment(segment) => effect_row::segment_numbers(segment),
        What::Scatter(scatter) => format!("after {}, at {}", brief(scatter.distance), brief_vector(scatter.point)),
        What::Passage(passage) => brief_vector(passage.colour),
        What::Phase(phase) => format!("cosθ = {}, p = {} per sr", brief(phase.cosine), brief(phase.value)),
        What::Overlap(overlap) => effect_row::overlap_numbers(overlap),
        What::Ambient { colour } => brief_vector(*colour),
        What::Light { diffuse, specular, .. } => brief_vector(std::array::from_fn(|i| diffuse[i] + specular[i])),
        What::Shadow { t, passes, .. } => format!("t = {}, passes {}", brief(*t), percent(*passes)),
        What::Reflection { direction, shares: Some(shares), .. } => {
            format!("r = {}, shares {}", brief_vector(*direction), brief_vector(*shares))
        }
        What::Reflection { direction, share, .. } => {
            format!("r = {}, share {}", brief_vector(*direction), brief(*share))
        }
        What::Snell { theta1, theta2, critical, .. } => snell_numbers(*theta1, *theta2, *critical),
        What::Medium { interpenetration: true, .. } => "objects overlap here".to_owned(),
        What::Limit { at, value, .. } => format!("{} met {}", number_list(&[*value]), number_list(&[*at])),
        What::Colour { total, .. } => brief_vector(*total),
        What::Written { srgb: [r, g, b], .. } => format!("sRGB {r}, {g}, {b}"),
        What::Object { .. } | What::Extent { .. } | What::Primitive { .. } | What::Medium { .. } => String::new(),
    }
}

const fn certificate_words(certificate: Certificate) -> &'static str {
    match certificate {
        Certificate::Certain => "certain",
        Certificate::Fallback => "decided by the fallback,",
        Certificate::Undecidable => "undecidable",
    }
}

/// `0.8 ± 3·10⁻¹⁵`.
fn margin(tier: &Tier) -> String {
    format!("{} ± {}", brief(tier.value), brief(tier.doubt))
}

fn accepted(candidates: &[Candidate]) -> impl Iterator<Item = &Candidate> {
    candidates.iter().filter(|candidate| candidate.fate == CandidateFate::Accepted)
}

fn snell_numbers(theta1: f64, theta2: Option<f64>, critical: Option<f64>) -> String {
    let second = theta2.map_or("no θ₂".to_owned(), |angle| format!("θ₂ = {}", degrees(angle)));
    let limit = critical.map(|angle| format!(", critical {}", degrees(angle))).unwrap_or_default();
    format!("θ₁ = {}, {second}{limit}", degrees(theta1))
}

fn planes_outcome(rows: &[crate::record::PlaneRow]) -> String {
    match rows.last() {
        Some(row) if row.sense == PlaneSense::ParallelOutside => {
            format!("parallel to {} on its outside: miss", row.name)
        }
        Some(row) => match (row.t_in, row.t_out) {
            (Some(t_in), Some(t_out)) if t_in > t_out => format!("t_in {} > t_out {}: miss", brief(t_in), brief(t_out)),
            (t_in, t_out) => {
                let one = |t: Option<f64>, open: &str| t.map_or(open.to_owned(), brief);
                format!("t_in {}, t_out {}", one(t_in, "−∞"), one(t_out, "∞"))
            }
        },
        None => String::new(),
    }
}

/// `t = 1.2, 3.4`, at most four of them.
fn times_at(all: impl Iterator<Item = f64>) -> String {
    let all: Vec<f64> = all.collect();
    let shown: Vec<_> = all.iter().take(4).map(|&t| brief(t)).collect();
    match all.len() {
        0 => String::new(),
        1..=4 => format!("t = {}", shown.join(", ")),
        more => format!("t = {} and {} more", shown.join(", "), more - 4),
    }
}

/// `torus ring`, or `torus` where the leaf is named for its shape.
pub(in crate::view) fn titled(shape: &str, name: &str) -> String {
    let shape = shape.replace('_', " ");
    if name == shape || name.is_empty() || name.replace('_', " ") == shape { shape } else { format!("{shape} {name}") }
}

/// `wall of shell in bowl`, without saying anything twice.
pub(super) fn surface(object: &str, leaf: &str, part: &str) -> String {
    if leaf == object || leaf.is_empty() {
        format!("{part} of {object}")
    } else {
        format!("{part} of {leaf} in {object}")
    }
}

pub(super) fn capitalised(word: &str) -> String {
    let mut letters = word.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().collect::<String>() + letters.as_str())
}
