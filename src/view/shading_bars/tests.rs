//! Tests of the shading bars: lengths that add up, and every number told.

use super::*;
use crate::view::readable::assert_readable;
use crate::view::sample::every_kind;

fn colour_event(tree: &RayTree) -> EventId {
    tree.events.iter().find(|event| matches!(event.what, What::Colour { .. })).unwrap().id
}

/// The filled rectangles of an event in rows, from the top down: height at which they lie, and their length together.
fn rows(drawing: &Drawing, event: EventId, left: f64, right: f64) -> Vec<(f64, f64)> {
    let mut rows: Vec<(f64, f64)> = Vec::new();
    for mark in drawing.marks.iter().filter(|mark| mark.event == Some(event)) {
        let Form::Rect { frame, fill: Some(_), .. } = mark.form else { continue };
        if frame.low[0] < left || frame.high[0] > right {
            continue;
        }
        match rows.iter_mut().find(|(y, _)| *y == frame.low[1]) {
            Some((_, length)) => *length += frame.size()[0],
            None => rows.push((frame.low[1], frame.size()[0])),
        }
    }
    rows
}

#[test]
fn the_bars_of_a_channel_are_as_long_together_as_its_total() {
    let tree = every_kind();
    let event = colour_event(&tree);
    let drawing = shading_bars(&tree, event, [900.0, 400.0], Theme::Light).unwrap();
    // The table stands at the right; the bars' axis ends before it.
    let bars = rows(&drawing, event, 0.0, 900.0 - table::WIDTH - 20.0);
    let lengths: Vec<f64> = bars.iter().take(3).map(|(_, length)| *length).collect();
    // The sample's total is (0.25, 0.5, 0.75).
    for (length, total) in lengths.iter().zip([0.25, 0.5, 0.75]) {
        assert!((length / lengths[2] - total / 0.75).abs() < 1e-9, "{lengths:?}");
    }
}

#[test]
fn each_light_has_bars_of_its_own_that_lead_to_it() {
    let tree = every_kind();
    let drawing = shading_bars(&tree, colour_event(&tree), [700.0, 400.0], Theme::Dark).unwrap();
    let lamp =
        tree.events.iter().find(|event| matches!(&event.what, What::Light { name, .. } if name == "lamp")).unwrap();
    assert!(drawing.marks.iter().any(|mark| mark.event == Some(lamp.id) && matches!(mark.form, Form::Rect { .. })));
}

#[test]
fn the_description_holds_every_component_and_every_light() {
    let tree = every_kind();
    let told = shading_bars(&tree, colour_event(&tree), [300.0, 200.0], Theme::Light).unwrap().description;
    for part in ["(0.25, 0.5, 0.75)", "ambient (0.05", "transmitted (0, 0.15, 0.3)", "light lamp", "light sun"] {
        assert!(told.contains(part), "{part}: {told}");
    }
}

#[test]
fn looks_are_told_apart_without_colours() {
    for theme in [Theme::Light, Theme::Dark] {
        let looks = Look::all(theme.palette());
        for (i, look) in looks.iter().enumerate() {
            assert!(looks[..i].iter().all(|other| other.pattern != look.pattern));
        }
    }
}

#[test]
fn nothing_covers_anything_at_any_size() {
    let tree = every_kind();
    for size in [
        [300.0, 200.0],
        [420.0, 300.0],
        [560.0, 360.0],
        [900.0, 600.0],
        [386.0, 150.0],
        [700.0, 130.0],
        [120.0, 500.0],
        [20.0, 20.0],
    ] {
        let drawing = shading_bars(&tree, colour_event(&tree), size, Theme::Light).unwrap();
        assert_readable(&drawing, &format!("{size:?}"));
    }
}

fn texts(size: [f64; 2]) -> Vec<String> {
    let tree = every_kind();
    let drawing = shading_bars(&tree, colour_event(&tree), size, Theme::Light).unwrap();
    drawing.texts().map(|text| text.text.clone()).collect()
}

#[test]
fn every_component_that_has_a_bar_is_named_however_low_the_drawing_is() {
    for height in [140.0, 150.0, 170.0, 190.0, 200.0, 240.0, 330.0] {
        for width in [300.0, 386.0, 600.0] {
            let texts = texts([width, height]);
            for name in ["red", "green", "blue", "ambient", "diffuse", "reflected", "transmitted"] {
                assert!(texts.iter().any(|text| text == name), "{name} at {width} × {height}: {texts:?}");
            }
        }
    }
}

#[test]
fn lights_that_there_is_no_room_for_are_not_left_out_in_silence() {
    for height in [130.0, 150.0, 200.0, 260.0, 330.0, 500.0] {
        let texts = texts([386.0, height]);
        let lights = ["lamp", "sun"].iter().filter(|name| texts.iter().any(|text| text == *name)).count();
        let says_so = texts.iter().any(|text| text.contains("too low for all lights"));
        assert_eq!(says_so, lights < 2, "{height}: {texts:?}");
    }
}
