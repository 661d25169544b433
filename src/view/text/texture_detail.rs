//! Everything that the events of textures hold, as lines and tables, and what they mean.

use super::detail::{DetailLine, pair};
use super::format::{degrees, vector};
use super::texture_row::{angle_between, place, solid_angle, spoken};
use crate::record::{
    Bump, Detail, Environment, FrameMap, Lattice, Mapping, Octaves, Rings, Texels, Texture, Triple, Undulate, What,
    format_number,
};

/// The lines of an event of this kind.
pub(super) fn texture_lines(what: &What) -> Option<Vec<DetailLine>> {
    Some(match what {
        What::Detail(detail) => detail_lines(detail),
        What::Texture(Texture { texture, point, colour }) => vec![
            pair("kind", spoken(texture)),
            pair("point in the texture's space", vector(*point)),
            pair("colour", vector(*colour)),
        ],
        What::Mapping(mapping) => mapping_lines(mapping),
        What::Texels(texels) => texel_lines(texels),
        What::Lattice(lattice) => lattice_lines(lattice),
        What::Octaves(octaves) => vec![octave_table(octaves), pair("sum", format_number(octaves.sum))],
        What::Undulate(undulate) => undulate_lines(undulate),
        What::Rings(Rings { radius, stirred, ring, dark }) => vec![
            pair("distance from the log's axis", format_number(*radius)),
            pair("stirred, in rings", format_number(*stirred)),
            pair("ring", format!("{}, {}", format_number(*ring), if *dark { "odd: dark" } else { "even: light" })),
        ],
        What::Bump(bump) => bump_lines(bump),
        What::FrameMap(frame) => frame_lines(frame),
        What::Environment(environment) => environment_lines(environment),
        _ => return None,
    })
}

/// What an event of this kind means.
pub(super) fn explain_texture(what: &What) -> Option<&'static str> {
    Some(match what {
        What::Detail(_) => {
            "A polygon lies on the face and takes precedence over it where it covers it. Both are met at one and the \
             same hit time, so neither can shine through the other."
        }
        What::Texture(_) => "The colour of the surface at this point is not fixed: a texture gives it.",
        What::Mapping(_) => {
            "(u, v) says where on its surface the hit lies, and M_T⁻¹ says which place of the image that is. The \
             picture asks the image and not the other way round, so that no pixel is left out and none is met twice."
        }
        What::Texels(Texels { texels, .. }) if texels.is_empty() => {
            "The pixel is as large as the texels of a level between two of the pyramid. Both are looked up, and the \
             nearer a level, the more it counts."
        }
        What::Texels(Texels { texels, left_out: 0, .. }) if texels.len() == 1 => {
            "The nearest texel alone gives the colour. Where many texels fall on one pixel, all the others go unseen."
        }
        What::Texels(_) => {
            "The colour is a weighted average: each texel counts with its share, and all shares add up to 1."
        }
        What::Lattice(Lattice { method, .. }) if method == "value" => {
            "Each corner of the lattice cell around the point has a random number, always the same one. The eight \
             numbers are blended: the nearer a corner, the more it counts."
        }
        What::Lattice(_) => {
            "Each corner of the lattice cell around the point has a random direction, always the same one, and says \
             how far the point lies along it. The eight answers are blended: the nearer a corner, the more it counts."
        }
        What::Octaves(_) => {
            "Noise of several sizes is added up: each term is finer than the one before it and counts less, like \
             ripples on waves."
        }
        What::Undulate(_) => {
            "A smooth curve leads through the given colours. The argument, from −1 to 1, says where on it the colour \
             is taken."
        }
        What::Rings(Rings { dark: true, .. }) => {
            "A log is made of pipes, one in another. The distance from its axis, counted in rings, says which of them \
             holds the point; this one is odd, so it is dark."
        }
        What::Rings(_) => {
            "A log is made of pipes, one in another. The distance from its axis, counted in rings, says which of them \
             holds the point; this one is even, so it is light."
        }
        What::Bump(_) => {
            "The surface stays as smooth as it is; only its normal turns as if the surface were raised by b: \
             N′ = N + b_v (P_u × n) + b_u (n × P_v). Light and shade follow the turned normal, the outline does not."
        }
        What::FrameMap(_) => {
            "Not the normal alone but the whole frame is changed: T along the grain, B across it, and N. Brushed metal, \
             wood and cloth are smoother along the grain than across it, so that their highlight is drawn out across T."
        }
        What::Environment(Environment { footprint, .. }) if footprint.is_empty() => {
            "The surroundings are an image that is infinitely far away, so the direction alone says what is seen. The \
             nearest texel is taken, however much of the image the pixel covers."
        }
        What::Environment(_) => {
            "The surroundings are an image that is infinitely far away, so the direction alone says what is seen. All \
             that the pixel covers of it is averaged."
        }
        _ => return None,
    })
}

fn detail_lines(detail: &Detail) -> Vec<DetailLine> {
    vec![
        pair("u, v", place(detail.uv)),
        table("the polygon", vec!["corner", "u", "v"], numbered(&detail.polygon)),
        pair("inside it", detail.material.clone()),
        pair("around it", detail.below.clone()),
    ]
}

fn mapping_lines(mapping: &Mapping) -> Vec<DetailLine> {
    let matrix = |title: &str, headers, names: [&str; 2], rows: &[[f64; 3]; 2]| {
        let row = |(name, row): (&str, &[f64; 3])| named(name, row);
        table(title, headers, names.into_iter().zip(rows).map(row).collect())
    };
    let [columns, rows] = mapping.size;
    let mut lines = vec![
        matrix("M_T, from the image to the surface", vec!["M_T", "s", "t", "1"], ["u", "v"], &mapping.uv_from_st),
        matrix("M_T⁻¹, from the surface to the image", vec!["M_T⁻¹", "u", "v", "1"], ["s", "t"], &mapping.st_from_uv),
        pair("u, v", place(mapping.uv)),
        pair("s, t", place(mapping.st)),
        pair("image", format!("{columns} × {rows} texels")),
    ];
    if !mapping.footprint.is_empty() {
        let headers = vec!["corner of the pixel", "column", "row"];
        lines.push(table("the pixel on the image, in texels", headers, numbered(&mapping.footprint)));
    }
    if mapping.off_the_surface > 0 {
        let all = mapping.footprint.len();
        let said = format!("{} of {all}, taken to the plane that touches the surface", mapping.off_the_surface);
        lines.push(pair("corner rays that miss the surface", said));
    }
    lines
}

fn texel_lines(texels: &Texels) -> Vec<DetailLine> {
    let row = |share: &crate::record::TexelShare| {
        let [column, row] = share.at.map(|at| format_number(at as f64));
        let [r, g, b] = share.colour.map(format_number);
        vec![column, row, format_number(share.weight), r, g, b]
    };
    let mut lines = Vec::new();
    if !texels.texels.is_empty() {
        let headers = vec!["column", "row", "weight", "red", "green", "blue"];
        lines.push(table("texels", headers, texels.texels.iter().map(row).collect()));
    }
    if texels.left_out > 0 {
        lines.push(pair("not listed", format!("{} more, with smaller weights", texels.left_out)));
    }
    if texels.level != 0.0 {
        let said =
            format!("{} (each has half as many columns and rows as the one before)", format_number(texels.level));
        lines.push(pair("level of the pyramid", said));
    }
    lines.push(pair("weighted sum", vector(texels.colour)));
    lines
}

fn lattice_lines(lattice: &Lattice) -> Vec<DetailLine> {
    let has_gradients = lattice.method != "value";
    let headers = if has_gradients {
        vec!["corner", "gradient", "value", "weight", "value · weight"]
    } else {
        vec!["corner", "value", "weight", "value · weight"]
    };
    let row = |corner: &crate::record::LatticeCorner| {
        let mut row = vec![vector(corner.at.map(|at| at as f64))];
        row.extend(has_gradients.then(|| vector(corner.gradient)));
        row.extend([corner.value, corner.weight, corner.value * corner.weight].map(format_number));
        row
    };
    vec![
        pair("point on the lattice", vector(lattice.point)),
        pair("from the cell's lowest corner", vector(lattice.offset)),
        pair("fade, 6 x⁵ − 15 x⁴ + 10 x³ of each", vector(lattice.fade)),
        table("the eight corners", headers, lattice.corners.iter().map(row).collect()),
        pair("noise, the sum", format_number(lattice.noise)),
    ]
}

fn octave_table(octaves: &Octaves) -> DetailLine {
    let mut sum = 0.0;
    let rows = octaves.rows.iter().map(|octave| {
        sum += octave.term;
        let numbers = [octave.frequency, octave.weight, octave.noise, octave.term, sum].map(format_number);
        std::iter::once(octave.k.to_string()).chain(numbers).collect()
    });
    let headers = vec!["k", "frequency", "weight", "noise", "term", "sum so far"];
    table("the terms", headers, rows.collect())
}

fn undulate_lines(undulate: &Undulate) -> Vec<DetailLine> {
    let row = |(number, stop): (usize, &crate::record::Stop)| {
        let is_end = number == undulate.segment || number == undulate.segment + 1;
        let [at, r, g, b] = [stop.at, stop.colour[0], stop.colour[1], stop.colour[2]].map(format_number);
        vec![if is_end { "▸" } else { "" }.to_owned(), at, r, g, b]
    };
    let rows = undulate.stops.iter().enumerate().map(row).collect();
    vec![
        pair("argument", format_number(undulate.argument)),
        table(
            "the spline's stops; the argument lies between those marked",
            vec!["", "at", "red", "green", "blue"],
            rows,
        ),
        pair("colour", vector(undulate.colour)),
    ]
}

fn bump_lines(bump: &Bump) -> Vec<DetailLine> {
    let dropped = bump.dropped.map_or("not known: the surface does not say how its normal turns".to_owned(), |angle| {
        format!("would turn it by {} more", degrees(angle))
    });
    vec![
        pair("P_u", vector(bump.p_u)),
        pair("P_v", vector(bump.p_v)),
        pair("b", format_number(bump.height)),
        pair("b_u", format_number(bump.slopes[0])),
        pair("b_v", format_number(bump.slopes[1])),
        pair("P_u × n", vector(bump.p_u_cross_n)),
        pair("n × P_v", vector(bump.n_cross_p_v)),
        pair("unit normal before", vector(bump.before)),
        pair("unit normal after", vector(bump.after)),
        pair("angle between them", degrees(angle_between(bump.before, bump.after))),
        pair("terms left out, b n_u and b n_v", dropped),
    ]
}

fn frame_lines(frame: &FrameMap) -> Vec<DetailLine> {
    let rows = ["T", "B", "N"].iter().zip(frame.before.iter().zip(&frame.after));
    let row = |(name, (before, after)): (&&str, (&Triple, &Triple))| {
        let turned = degrees(angle_between(*before, *after));
        vec![(*name).to_owned(), vector(*before), vector(*after), turned]
    };
    vec![
        pair("turned about N", degrees(frame.turn)),
        pair("N tilted, as slopes along and across the grain", place(frame.tilt)),
        table("the frame", vec!["", "before", "after", "turned"], rows.map(row).collect()),
        pair("roughness along and across the grain", place(frame.roughness)),
    ]
}

fn environment_lines(environment: &Environment) -> Vec<DetailLine> {
    let [columns, rows] = environment.size;
    let mut lines = vec![
        pair("layout", spoken(&environment.layout)),
        pair("direction", vector(environment.direction)),
        pair("image", format!("{columns} × {rows} texels")),
        pair("place in texels, from the top left", place(environment.at)),
    ];
    if !environment.footprint.is_empty() {
        lines.push(pair("the pixel covers", solid_angle(environment.solid_angle)));
    }
    lines.push(pair("nearest texel", vector(environment.nearest)));
    lines.push(pair("what came out", vector(environment.colour)));
    lines
}

fn table(title: &str, headers: Vec<&'static str>, rows: Vec<Vec<String>>) -> DetailLine {
    DetailLine::Table { title: title.to_owned(), headers, rows }
}

fn named(name: &str, numbers: &[f64]) -> Vec<String> {
    std::iter::once(name.to_owned()).chain(numbers.iter().map(|&x| format_number(x))).collect()
}

/// Points with their numbers from 1.
fn numbered(points: &[[f64; 2]]) -> Vec<Vec<String>> {
    points.iter().zip(1_u32..).map(|(point, number)| named(&number.to_string(), point)).collect()
}
