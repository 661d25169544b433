//! Tests of the plane table: it is filled in up to the cursor, and the bars end where its numbers say.

use super::*;
use crate::scene::{embedded_scene, load};
use crate::trace::record_pixel;
use crate::view::readable::assert_readable;

fn cube() -> (RayTree, EventId) {
    let name = "primitives/cube";
    let scene = load(embedded_scene(name).unwrap().text, name).unwrap();
    let [x, y] = scene.pixels[0];
    let tree = record_pixel(&scene, x, y);
    let event = tree.events.iter().find(|event| matches!(event.what, What::Planes { .. })).unwrap().id;
    (tree, event)
}

fn rows_of(tree: &RayTree, event: EventId) -> Vec<PlaneRow> {
    let What::Planes { rows, .. } = &tree.event(event).what else { unreachable!() };
    rows.clone()
}

#[test]
fn rows_are_filled_in_up_to_the_cursor_and_no_farther() {
    let (tree, event) = cube();
    let all = rows_of(&tree, event);
    for cursor in 0..all.len() {
        let table = plane_table(&tree, event, Some(cursor), [800.0, 300.0], Theme::Light).unwrap();
        assert_eq!((table.rows.len(), table.count), (cursor + 1, all.len()));
        for (index, row) in all.iter().enumerate() {
            let sentence = format!("Plane {}:", row.name);
            assert_eq!(table.drawing.description.contains(&sentence), index <= cursor, "{sentence} at {cursor}");
        }
    }
}

#[test]
fn what_is_left_lies_between_the_latest_entry_and_the_earliest_exit() {
    let (tree, event) = cube();
    let last = rows_of(&tree, event).pop().unwrap();
    let table = plane_table(&tree, event, None, [800.0, 300.0], Theme::Light).unwrap();
    let colour = Theme::Light.palette().combined;
    let bar = table.drawing.marks.iter().find_map(|mark| match mark.form {
        Form::Rect { frame, fill: Some(fill), .. } if fill == colour => Some(frame),
        _ => None,
    });
    let bar = bar.expect("the ray meets the cube");
    // The dashed lines stand at t_in and t_out; their places are those of the bar's ends.
    let dashed: Vec<f64> = table
        .drawing
        .marks
        .iter()
        .filter_map(|mark| match &mark.form {
            Form::Line { points, stroke } if stroke.colour == colour => Some(points[0][0]),
            _ => None,
        })
        .collect();
    assert!(last.t_in.unwrap() < last.t_out.unwrap());
    assert_eq!(dashed, [bar.low[0], bar.high[0]]);
}

#[test]
fn a_hit_shows_the_table_of_the_cube_that_was_hit() {
    let (tree, event) = cube();
    let hit = tree.events.iter().find(|event| matches!(event.what, What::Hit { .. })).unwrap().id;
    let of_hit = plane_table(&tree, hit, None, [500.0, 300.0], Theme::Light);
    assert_eq!(of_hit, plane_table(&tree, event, None, [500.0, 300.0], Theme::Light));
}

#[test]
fn nothing_covers_anything_at_any_size() {
    let (tree, event) = cube();
    for size in [[300.0, 200.0], [420.0, 300.0], [560.0, 360.0], [900.0, 600.0], [120.0, 500.0], [20.0, 20.0]] {
        for cursor in [Some(0), Some(3), None] {
            let table = plane_table(&tree, event, cursor, size, Theme::Dark).unwrap();
            assert_readable(&table.drawing, &format!("{size:?} at {cursor:?}"));
        }
    }
}
