//! Everything that an event holds, arranged for reading: used by the workbench's detail panel and by the text tree.

use super::effect_detail::effect_lines;
use super::explain::explain;
use super::format::{accuracy, count, degrees, number_list, percent, quoted, significant, span_list, vector};
use super::row::{capitalised, row, surface, titled};
use super::tables::{candidate_table, colour_table, plane_table, polynomial, tier_table};
use super::texture_detail::texture_lines;
use crate::record::{Event, Sense, Sign, SignSpan, What, format_number};

/// What an event holds, for reading.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Detail {
    /// The row's label.
    pub title: String,
    /// What this event is, in plain words.
    pub explanation: &'static str,
    /// The numbers, in reading order.
    pub lines: Vec<DetailLine>,
    /// Where it was computed, as `file:line`.
    pub source: String,
}

/// A line of detail, or a table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum DetailLine {
    /// A name and its value.
    Pair {
        /// The name.
        name: String,
        /// The value.
        value: String,
    },
    /// `symbol = formula = numbers = result`.
    Working {
        /// What is worked out.
        symbol: String,
        /// The general formula.
        formula: String,
        /// The formula with this ray's numbers put in.
        numbers: String,
        /// What came out.
        result: String,
    },
    /// A table; every row is as long as `headers`.
    Table {
        /// What the table shows.
        title: String,
        /// The columns' names.
        headers: Vec<&'static str>,
        /// The cells.
        rows: Vec<Vec<String>>,
    },
}

/// Everything that an event holds, for reading.
#[must_use]
pub fn detail(event: &Event) -> Detail {
    let mut lines = ray_lines(&event.what)
        .or_else(|| search_lines(&event.what))
        .or_else(|| hit_lines(&event.what))
        .or_else(|| texture_lines(&event.what))
        .or_else(|| effect_lines(&event.what))
        .unwrap_or_else(|| light_lines(&event.what));
    lines.extend(event.working.iter().map(|line| DetailLine::Working {
        symbol: line.symbol.to_string(),
        formula: line.formula.to_owned(),
        numbers: line.numbers.to_string(),
        result: line.result.to_string() + &line.accuracy.as_ref().map(accuracy).unwrap_or_default(),
    }));
    Detail {
        title: capitalised(&row(event).label),
        explanation: explain(&event.what),
        lines,
        source: format!("{}:{}", event.source.file, event.source.line),
    }
}

pub(super) fn pair(name: &str, value: impl Into<String>) -> DetailLine {
    DetailLine::Pair { name: name.to_owned(), value: value.into() }
}

/// The ray, and how it comes to a shape.
fn ray_lines(what: &What) -> Option<Vec<DetailLine>> {
    Some(match what {
        What::Pixel { x, y, width, height } => {
            vec![
                pair("column, row", format!("{x}, {y} (from the top left)")),
                pair("picture", format!("{width} × {height}")),
            ]
        }
        What::LooseRay { origin, direction } => {
            vec![pair("origin", vector(*origin)), pair("direction", vector(*direction))]
        }
        What::Step { .. } => Vec::new(),
        What::Ray { ray, origin, direction, depth, medium, weight, wavelength, left } => {
            let mut lines = vec![
                pair("kind", ray.name()),
                pair("origin", vector(*origin)),
                pair("direction", vector(*direction)),
                pair("depth", depth.to_string()),
                pair("medium", medium.clone()),
                pair("weight", format!("{} of the pixel", percent(*weight))),
            ];
            lines.extend(wavelength.map(|nanometres| pair("wavelength", format!("{} nm", format_number(nanometres)))));
            lines.extend(left.as_ref().map(|left| pair("leaves", left.clone())));
            lines
        }
        What::Object { index, intervals, .. } => {
            vec![pair("place in the list", index.to_string()), pair("inside", count(*intervals, "interval"))]
        }
        What::Extent { low, high, inside, .. } => vec![
            pair("corners", format!("{} and {}", vector(*low), vector(*high))),
            pair(
                "inside",
                inside.map_or("missed".to_owned(), |[a, b]| {
                    format!("t from {} to {}", format_number(a), format_number(b))
                }),
            ),
        ],
        What::Ball { centre, radius, distance, .. } => vec![
            pair("middle", vector(*centre)),
            pair("radius", format_number(*radius)),
            pair("the ray passes at", format_number(*distance)),
        ],
        What::Projection { low, high, at, .. } => {
            let point = |[x, y]: [f64; 2]| format!("({}, {})", format_number(x), format_number(y));
            vec![pair("corners", format!("{} and {}", point(*low), point(*high))), pair("the ray's pixel", point(*at))]
        }
        What::Transform { inverse, origin, direction, .. } => vec![
            DetailLine::Table {
                title: "inverse transform, world to generic".to_owned(),
                headers: vec!["x", "y", "z", "1"],
                rows: inverse.iter().map(|row| row.iter().map(|&x| format_number(x)).collect()).collect(),
            },
            pair("S", vector(*origin)),
            pair("c", vector(*direction)),
        ],
        _ => return None,
    })
}

/// What the solvers found.
fn search_lines(what: &What) -> Option<Vec<DetailLine>> {
    Some(match what {
        What::Primitive { shape, name, leaf, hits } => {
            vec![pair("shape", titled(shape, name)), pair("leaf", leaf.to_string()), pair("hits", hits.to_string())]
        }
        What::Roots { candidates } => candidate_table(candidates).into_iter().collect(),
        What::Planes { rows, stopped } => {
            let mut lines = vec![plane_table(rows)];
            lines.extend(stopped.as_ref().map(|why| pair("stopped", why.clone())));
            lines
        }
        What::Quadratic { about, a, b, c, discriminant, recentred_at, roots } => vec![
            pair("equation", format!("A t² + 2 B t + C = 0 for {about}")),
            pair("A", format_number(*a)),
            pair("B", format_number(*b)),
            pair("C", format_number(*c)),
            pair("B² − A C", format_number(*discriminant)),
            pair("t is measured from", format_number(*recentred_at)),
            pair("roots", number_list(roots)),
        ],
        What::Quartic { coefficients, recentred_at, roots } => vec![
            pair("polynomial", polynomial(coefficients)),
            pair("t is measured from", format_number(*recentred_at)),
            pair("roots", number_list(roots)),
        ],
        What::Search { range, stretches, undecided, roots } => vec![
            pair(
                "range",
                range
                    .map_or("none".to_owned(), |[a, b]| format!("t from {} to {}", format_number(a), format_number(b))),
            ),
            pair("stretches bounded", stretches.to_string()),
            pair("undecided to the last bit", undecided.to_string()),
            pair("roots", number_list(roots)),
        ],
        What::Decision { question, tiers, input_doubt, certificate, .. } => vec![
            pair("question", question.clone()),
            tier_table(tiers),
            pair("last places of the ray's numbers", format!("move it by {}", significant(*input_doubt, 2))),
            pair("certificate", certificate.name()),
        ],
        What::Implicit { equation, samples, roots, signs } => vec![
            pair("F(x, y, z)", equation.clone()),
            pair("samples", samples.len().to_string()),
            pair("zeros", number_list(roots)),
            pair("signs", signs.iter().map(sign_span).collect::<Vec<_>>().join(", ")),
        ],
        What::Combine { operator, left, right, combined, early_out, .. } => {
            let mut lines = vec![
                pair("left", span_list(left)),
                pair("right", right.as_ref().map_or("not asked".to_owned(), |right| span_list(right))),
                pair(&format!("left {} right", operator.sign()), span_list(combined)),
            ];
            lines.extend(early_out.as_ref().map(|why| pair("early out", why.clone())));
            lines
        }
        _ => return None,
    })
}

/// The hit, or why there is none.
fn hit_lines(what: &What) -> Option<Vec<DetailLine>> {
    Some(match what {
        What::Moved { object, by } => vec![pair("object", object.clone()), pair("moved by", format_number(*by))],
        What::Rejected { object, leaf, part, t, reason } => {
            vec![
                pair("surface", surface(object, leaf, part)),
                pair("t", format_number(*t)),
                pair("reason", quoted(reason)),
            ]
        }
        What::Hit {
            object,
            leaf,
            shape,
            part,
            material,
            t,
            t_error,
            certificate,
            sense,
            point,
            generic_point,
            n_geometric,
            n_shading,
            uv,
        } => vec![
            pair("surface", format!("{} (a {})", surface(object, leaf, part), shape.replace('_', " "))),
            pair("material", material.clone()),
            pair("t", format!("{} ± {}", format_number(*t), significant(*t_error, 2))),
            pair("known", certificate.name()),
            pair("the ray", sense_in_words(*sense)),
            pair("point", vector(*point)),
            pair("point, generic", vector(*generic_point)),
            pair("normal, geometric", vector(*n_geometric)),
            pair("normal, shading", vector(*n_shading)),
            pair("u, v", format!("{}, {}", format_number(uv[0]), format_number(uv[1]))),
        ],
        What::Nothing { background } => vec![pair("background", vector(*background))],
        _ => return None,
    })
}

/// What light does at the hit.
fn light_lines(what: &What) -> Vec<DetailLine> {
    match what {
        What::Ambient { colour } => vec![pair("colour", vector(*colour))],
        What::Light { towards, distance, arriving, diffuse, specular, .. } => vec![
            pair("towards", vector(*towards)),
            pair("distance", distance.map_or("infinite (a direction)".to_owned(), format_number)),
            pair("share that arrives", vector(*arriving)),
            pair("diffuse", vector(*diffuse)),
            pair("specular", vector(*specular)),
        ],
        What::Shadow { object, t, passes, reason } => vec![
            pair("in the way", object.clone()),
            pair("t on the shadow ray", format_number(*t)),
            pair("passes", percent(*passes)),
            pair("rule", reason.clone()),
        ],
        What::Reflection { direction, share, shares } => {
            let share = shares.map_or_else(|| format_number(*share), vector);
            vec![pair("r", vector(*direction)), pair("share", share)]
        }
        What::Snell { .. } => snell_lines(what),
        What::Medium { object, before, after, decided, interpenetration, hidden } => {
            let mut lines = vec![
                pair("boundary of", object.clone()),
                pair("before", before.clone()),
                pair("after", after.clone()),
                pair("decided by", decided.clone()),
            ];
            lines.extend(interpenetration.then(|| pair("overlap", "two transparent objects share this place")));
            lines.extend(hidden.then(|| pair("effect", "none: the boundary is hidden in another medium")));
            lines
        }
        What::Limit { limit, at, value, consequence } => vec![
            pair("limit", format!("{limit}, {}", format_number(*at))),
            pair("met by", format_number(*value)),
            pair("therefore", consequence.clone()),
        ],
        What::Colour { ambient, diffuse, specular, reflected, transmitted, total } => {
            let terms = [
                ("ambient", ambient),
                ("diffuse", diffuse),
                ("specular", specular),
                ("reflected", reflected),
                ("transmitted", transmitted),
                ("sum", total),
            ];
            vec![colour_table(&terms)]
        }
        What::Written { linear, srgb: [r, g, b] } => {
            vec![pair("linear", vector(*linear)), pair("sRGB", format!("{r}, {g}, {b} (#{r:02x}{g:02x}{b:02x})"))]
        }
        _ => Vec::new(),
    }
}

fn snell_lines(what: &What) -> Vec<DetailLine> {
    let What::Snell { n1, n2, theta1, theta2, critical, refracted, reflectance, .. } = what else {
        return Vec::new();
    };
    let none = || "none".to_owned();
    vec![
        pair("n₁, n₂", format!("{}, {}", format_number(*n1), format_number(*n2))),
        pair("θ₁", degrees(*theta1)),
        pair("θ₂", theta2.map_or("none: total internal reflection".to_owned(), degrees)),
        pair("critical angle", critical.map_or("none: n₁ < n₂".to_owned(), degrees)),
        pair("refracted", refracted.map_or_else(none, vector)),
        pair("Fresnel reflectance", percent(*reflectance)),
    ]
}

fn sense_in_words(sense: Sense) -> &'static str {
    match sense {
        Sense::Enter => "goes in",
        Sense::Leave => "comes out",
        Sense::Touch => "meets a surface that bounds nothing",
    }
}

fn sign_span(span: &SignSpan) -> String {
    let end = |t: Option<f64>, open: &str| t.map_or(open.to_owned(), format_number);
    let sign = match span.sign {
        Sign::Positive => "+",
        Sign::Negative => "−",
    };
    format!("{sign} from {} to {}", end(span.from, "−∞"), end(span.to, "∞"))
}
