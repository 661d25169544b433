//! The working behind look-ups in images: an independent calculator must come to the results that stand beside it.

mod formula;
mod notes;

use formula::evaluate;
use glam::DVec2;
use notes::Notes;
use rayscope::record::Value;
use rayscope::texture::image::{Affine, Encoding, Filter, ImageTexture, Mapping, Place, Texels, Wraps};
use std::sync::Arc;

/// Checks every line, and says how many there were.
fn check(notes: &Notes) -> usize {
    let lines: Vec<_> = notes.0.iter().flat_map(|entry| &entry.working).collect();
    for line in &lines {
        let text = line.numbers.to_string();
        let worked_out = evaluate(&text).unwrap_or_else(|problem| panic!("{}: {text}: {problem}", line.formula)).0;
        let result = match line.result {
            Value::Number(x) => vec![x],
            Value::Vector(v) => v.to_vec(),
            Value::Truth(_) => Vec::new(),
        };
        assert_eq!(worked_out.len(), result.len(), "{text}");
        for ((x, error), y) in worked_out.iter().zip(&result) {
            assert!((x - y).abs() <= 2.0 * error + 1e-12 * y.abs(), "{} = {text} = {y}, not {x}", line.formula);
        }
    }
    lines.len()
}

#[test]
fn every_line_of_a_look_up_in_an_image_holds() {
    let bytes: Vec<u8> = (0..16 * 12 * 3_u32).map(|i| u8::try_from(i * 97 % 251).unwrap()).collect();
    let texels = Arc::new(Texels::from_bytes(16, 12, &bytes, Encoding::Srgb).unwrap());
    let map = Affine::new([[0.5, 0.1, -0.2], [-0.2, 0.75, 3.0]]);
    let mut lines = 0;
    for filter in [Filter::Nearest, Filter::Bilinear, Filter::Trilinear, Filter::Area, Filter::Ewa] {
        let texture = ImageTexture {
            texels: Arc::clone(&texels),
            mapping: Mapping::new(map).unwrap(),
            wraps: Wraps::default(),
            filter,
        };
        for i in 0..200 {
            let uv = DVec2::new(f64::from(i) * 0.0371, f64::from(i) * 0.0123 - 0.7);
            let size = 0.001 * f64::from(1 + i);
            let corners = [(-1.0, -1.0), (1.2, -0.9), (1.4, 1.0), (-1.1, 0.8)].map(|at| uv + DVec2::from(at) * size);
            let mut notes = Notes::default();
            texture.colour(
                &Place { uv, part: 2, part_name: "top", corners: Some(corners), off_the_surface: 0, period: [None; 2] },
                &mut notes,
            );
            lines += check(&notes);
        }
    }
    assert!(lines > 5 * 200 * 4 + 3 * 200, "only {lines} lines");
}
