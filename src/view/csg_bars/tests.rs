//! Tests of the bars of a whole tree: every node has a row, and what was never asked says why.

use super::*;
use crate::scene::{embedded_scene, load};
use crate::trace::{record_pixel, record_ray};
use crate::view::readable::assert_readable;
use glam::DVec3;

/// A ball without a cube that lies in it, in front of a cube without a ball.
const SCENE: &str = r#"{
  "title": "test", "about": "", "camera": { "eye": [0, 0, 9], "look_at": [0, 0, 0], "up": [0, 1, 0], "field_of_view": 30 },
  "image": { "width": 8, "height": 8 }, "ambient": [1, 1, 1], "background": [0, 0, 0], "lights": [],
  "materials": { "plain": { "ambient": [1, 1, 1], "diffuse": [1, 1, 1] } },
  "objects": [{ "shape": "difference", "name": "shell", "material": "plain", "of": [
    { "shape": "sphere", "name": "ball" },
    { "shape": "cube", "name": "hole", "transform": [{ "scale": 0.5 }] }
  ] }]
}"#;

fn scene() -> Scene {
    load(SCENE, "test").unwrap()
}

/// Down the z axis, this far beside it in x and in y.
fn tree(beside: f64) -> RayTree {
    record_ray(&scene(), DVec3::new(beside, beside, 9.0), DVec3::NEG_Z)
}

#[test]
fn every_node_has_the_intervals_that_geometry_gives_it() {
    let told = csg_bars(&scene(), &tree(0.0), 0, None, [600.0, 300.0], Theme::Light).unwrap().description;
    // The ball from z = 1 to −1, the hole from z = ½ to −½.
    for part in ["− shell: [8, 8.5] [9.5, 10]", "ball: [8, 10]", "hole: [8.5, 9.5]"] {
        assert!(told.contains(part), "{part}: {told}");
    }
}

#[test]
fn bars_end_at_the_axis_place_of_their_times() {
    let tree = tree(0.0);
    let drawing = csg_bars(&scene(), &tree, 0, Some(9.25), [600.0, 300.0], Theme::Light).unwrap();
    let palette = Theme::Light.palette();
    let bars = |colour: Colour| -> Vec<[f64; 2]> {
        drawing
            .marks
            .iter()
            .filter_map(|mark| match mark.form {
                Form::Rect { frame, fill: Some(fill), .. } if fill == colour => Some([frame.low[0], frame.high[0]]),
                _ => None,
            })
            .collect()
    };
    let [ball] = bars(palette.left)[..] else { panic!("one bar for the ball") };
    let at = |t: f64| ball[0] + (t - 8.0) / 2.0 * (ball[1] - ball[0]);
    let near = |a: f64, b: f64| (a - b).abs() < 1e-9;
    let [hole] = bars(palette.right)[..] else { panic!("one bar for the hole") };
    assert!(near(hole[0], at(8.5)) && near(hole[1], at(9.5)));
    let [first, second] = bars(palette.combined)[..] else { panic!("two bars for the shell") };
    assert!(near(first[0], at(8.0)) && near(first[1], at(8.5)));
    assert!(near(second[0], at(9.5)) && near(second[1], at(10.0)));
    let upright = |mark: &&crate::view::Mark| match &mark.form {
        Form::Line { points, .. } => near(points[0][0], at(9.25)) && near(points[1][0], at(9.25)),
        _ => false,
    };
    assert!(drawing.marks.iter().any(|mark| upright(&mark)), "the probed time is marked");
}

#[test]
fn no_number_stands_on_an_upright_line() {
    let (scene, tree) = (scene(), tree(0.0));
    for probe in [7.95, 8.45, 8.55, 9.55, 10.05] {
        let drawing = csg_bars(&scene, &tree, 0, Some(probe), [600.0, 300.0], Theme::Light).unwrap();
        let upright = |form: &Form| match form {
            Form::Line { points, .. } if points[0][0] == points[1][0] && points[1][1] - points[0][1] > 40.0 => {
                Some(points.clone())
            }
            _ => None,
        };
        let lines: Vec<Vec<Spot>> = drawing.marks.iter().filter_map(|mark| upright(&mark.form)).collect();
        assert!(lines.len() >= 2, "the hit and the probe");
        for text in drawing.texts() {
            let frame = text.frame();
            for line in &lines {
                let within = frame.low[0] < line[0][0] && line[0][0] < frame.high[0];
                let beside = frame.low[1] < line[1][1] && line[0][1] < frame.high[1];
                assert!(!(within && beside), "“{}” stands on a line, with {probe} probed", text.text);
            }
        }
    }
}

#[test]
fn what_was_never_asked_says_why() {
    // Through the corner of the ball's box, past the ball.
    let told = csg_bars(&scene(), &tree(0.9), 0, None, [600.0, 300.0], Theme::Light).unwrap().description;
    assert!(told.contains("hole: not asked, for the ray misses"), "{told}");
    assert!(told.contains("early out"), "{told}");
}

#[test]
fn the_row_of_the_selected_node_is_lit() {
    let tree = tree(0.0);
    let is_hole = |what: &What| matches!(what, What::Primitive { name, .. } if name == "hole");
    let hole = tree.events.iter().find(|event| is_hole(&event.what)).unwrap().id;
    let drawing = csg_bars(&scene(), &tree, hole, None, [600.0, 300.0], Theme::Light).unwrap();
    let lit = Theme::Light.palette().highlight.faded(0.26);
    let found: Vec<Option<EventId>> = drawing
        .marks
        .iter()
        .filter_map(|mark| match mark.form {
            Form::Rect { fill: Some(fill), .. } if fill == lit => Some(mark.event),
            _ => None,
        })
        .collect();
    assert_eq!(found, [Some(hole)]);
}

#[test]
fn nothing_covers_anything_at_any_size() {
    for name in ["csg/bowl", "csg/nested", "csg/rocket", "primitives/torus", "hard/thorns"] {
        let scene = load(embedded_scene(name).unwrap().text, name).unwrap();
        let [x, y] = scene.pixels[0];
        let tree = record_pixel(&scene, x, y);
        for size in [[300.0, 200.0], [560.0, 360.0], [900.0, 600.0], [120.0, 500.0], [20.0, 20.0]] {
            for selected in [0, tree.end() / 3, tree.end() - 1] {
                if let Some(drawing) = csg_bars(&scene, &tree, selected, Some(3.0), size, Theme::Dark) {
                    assert_readable(&drawing, &format!("{name} at {selected} in {size:?}"));
                }
            }
        }
    }
}
