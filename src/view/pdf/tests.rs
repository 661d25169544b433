//! What a PDF holds, read back by a small reader of its own: objects by the cross-reference table, streams unpacked.

use super::*;
use crate::view::{Anchor, Face, Form, Stroke, Text, Theme, sample};
use miniz_oxide::inflate::decompress_to_vec_zlib;

fn text_mark(text: &str, halo: bool) -> Drawing {
    let palette = Theme::Light.palette();
    let mut drawing = Drawing::new([200.0, 100.0], palette.ground);
    let halo = halo.then_some(palette.ground);
    let text = Text {
        at: [20.0, 40.0],
        text: text.to_owned(),
        anchor: Anchor::Start,
        size: 12.0,
        colour: palette.ink,
        face: Face::Sans,
        halo,
    };
    drawing.put(Form::Text(text), None);
    drawing
}

/// Where `startxref` says that the table is, the table is; where the table says that an object is, it is. The objects.
fn objects(file: &[u8]) -> Vec<&[u8]> {
    let find = |pattern: &[u8], from: usize| {
        file[from..].windows(pattern.len()).position(|at| at == pattern).map(|at| at + from)
    };
    let trailer = String::from_utf8_lossy(&file[file.len() - 40..]).into_owned();
    let start: usize = trailer.split("startxref\n").nth(1).unwrap().lines().next().unwrap().parse().unwrap();
    assert!(file[start..].starts_with(b"xref\n0 "));
    let table = String::from_utf8_lossy(&file[start..]).into_owned();
    let mut lines = table.lines().skip(1);
    let count: usize = lines.next().unwrap().split(' ').nth(1).unwrap().parse().unwrap();
    let entries: Vec<usize> = lines.skip(1).take(count - 1).map(|line| line[..10].parse().unwrap()).collect();
    let object = |(number, &at): (usize, &usize)| {
        assert!(file[at..].starts_with(format!("{} 0 obj", number + 1).as_bytes()), "object {}", number + 1);
        &file[at..find(b"endobj", at).unwrap()]
    };
    entries.iter().enumerate().map(object).collect()
}

/// The unpacked streams.
fn streams(file: &[u8]) -> Vec<Vec<u8>> {
    let unpacked = |object: &[u8]| {
        let begin = object.windows(7).position(|at| at == b"stream\n")? + 7;
        let end = object.windows(10).rposition(|at| at == b"\nendstream")?;
        Some(decompress_to_vec_zlib(&object[begin..end]).unwrap())
    };
    objects(file).into_iter().filter_map(unpacked).collect()
}

fn page_text(file: &[u8]) -> String {
    streams(file)
        .into_iter()
        .filter_map(|bytes| String::from_utf8(bytes).ok())
        .find(|text| text.contains(" cm"))
        .unwrap()
}

#[test]
fn every_object_lies_where_the_table_says_and_the_same_drawings_give_the_same_bytes() {
    let drawings = [sample::two_marks(), text_mark("θ₁ ≤ 41.8°", true)];
    let file = pdf("two", &drawings);
    assert!(file.starts_with(b"%PDF-1.7") && file.ends_with(b"%%EOF"));
    assert!(objects(&file).len() > 10);
    assert_eq!(file, pdf("two", &drawings));
    assert!(!file.windows(12).any(|at| at == b"CreationDate"));
}

#[test]
fn each_drawing_has_a_page_of_its_size() {
    let file = pdf("two", &[sample::two_marks(), text_mark("a", false)]);
    let text = String::from_utf8_lossy(&file);
    assert!(text.contains("/MediaBox [0 0 100 80]") && text.contains("/MediaBox [0 0 200 100]"));
    assert!(text.contains("/Count 2"));
}

#[test]
fn characters_can_be_found_again_from_the_codes_that_show_them() {
    let shown = "√θ₁ −1.5 √";
    let file = pdf("text", &[text_mark(shown, false)]);
    let maps: Vec<String> = streams(&file)
        .into_iter()
        .filter_map(|bytes| String::from_utf8(bytes).ok())
        .filter(|text| text.contains("begincmap"))
        .collect();
    let mut mapped: Vec<char> = maps
        .iter()
        .flat_map(|map| map.lines())
        .filter_map(|line| line.strip_prefix('<')?.split_once("> <")?.1.strip_suffix('>'))
        .filter_map(|hex| char::from_u32(u32::from_str_radix(hex, 16).ok()?))
        .collect();
    mapped.retain(|character| shown.contains(*character));
    mapped.sort_unstable();
    let mut wanted: Vec<char> = shown.chars().collect();
    wanted.sort_unstable();
    wanted.dedup();
    assert_eq!(mapped, wanted);
}

#[test]
fn only_the_letters_that_are_used_are_embedded() {
    let file = pdf("text", &[text_mark("Only these letters", true)]);
    assert!(
        file.len() < 12_000,
        "{} bytes, and the font alone has {}",
        file.len(),
        crate::view::fonts()[0].bytes.len()
    );
}

#[test]
fn a_halo_lies_below_its_text_and_is_not_read_twice() {
    let page = page_text(&pdf("halo", &[text_mark("t = 1", true)]));
    let (halo, text) = (page.find("1 Tr").unwrap(), page.find("0 Tr").unwrap());
    assert!(halo < text);
    let silent = page.find("/ActualText").unwrap();
    assert!(silent < halo && page[halo..text].contains("EMC"), "{page}");
}

#[test]
fn an_area_is_filled_by_even_and_odd_and_a_dash_is_set_and_taken_back() {
    let palette = Theme::Light.palette();
    let mut drawing = sample::two_marks();
    let points = vec![[0.0, 0.0], [10.0, 10.0]];
    drawing.put(Form::Line { points: points.clone(), stroke: Stroke::dashed(palette.ink, 1.0, [4.0, 3.0]) }, None);
    drawing.put(Form::Line { points, stroke: Stroke::solid(palette.ink.faded(0.5), 2.0) }, None);
    let file = pdf("marks", &[drawing]);
    let page = page_text(&file);
    assert!(page.contains("f*") && page.contains("[4 3] 0 d"), "{page}");
    assert!(page.rfind("[] 0 d") > page.find("[4 3] 0 d"));
    assert!(page.contains("/A128 gs") && String::from_utf8_lossy(&file).contains("/A128"));
}

#[test]
fn a_circle_of_curves_is_round() {
    let mut fonts = FontSet::default();
    let palette = Theme::Light.palette();
    let mut drawing = Drawing::new([400.0, 400.0], palette.ground);
    let (centre, radius) = ([200.0, 200.0], 150.0);
    drawing.put(Form::Circle { centre, radius, fill: None, stroke: Some(Stroke::solid(palette.ink, 1.0)) }, None);
    let page = String::from_utf8(content_of(&drawing, &mut fonts).bytes).unwrap();
    let mut pen = [0.0; 2];
    let mut curves = 0;
    for line in page.lines() {
        let numbers: Vec<f64> = line.split(' ').filter_map(|word| word.parse().ok()).collect();
        if line.ends_with(" m") {
            pen = [numbers[0], numbers[1]];
        }
        if line.ends_with(" c") {
            curves += 1;
            // The middle of a cubic: (p + 3 c + 3 d + q) / 8.
            let middle = |i: usize| (pen[i] + 3.0 * numbers[i] + 3.0 * numbers[2 + i] + numbers[4 + i]) / 8.0;
            let away = (middle(0) - centre[0]).hypot(middle(1) - centre[1]);
            assert!((away - radius).abs() < 0.005, "{away}");
            pen = [numbers[4], numbers[5]];
        }
    }
    assert_eq!(curves, 8);
}

#[test]
fn the_description_is_the_figures_alternative_text() {
    let mut drawing = text_mark("x", false);
    "A ray meets (a sphere)".clone_into(&mut drawing.description);
    let file = pdf("told", &[drawing]);
    let text = String::from_utf8_lossy(&file);
    assert!(text.contains("/Alt") && text.contains("A ray meets") && text.contains("/Figure"), "{text}");
}
