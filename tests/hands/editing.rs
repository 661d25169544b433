//! Hands for the editor: putting the cursor somewhere, typing, dragging, waiting for the scene to follow.

use super::{Bench, open_at, reveal, settle, wait_until, workbench, workbench_mut};
use egui::{Event, Modifiers, PointerButton, Pos2, Vec2};
use rayscope::app::Pane;

pub const SIZE: Vec2 = Vec2::new(1600.0, 1000.0);

pub fn open_editor<'a>(scene: &str) -> Bench<'a> {
    let mut bench = open_at(scene, SIZE);
    reveal(&mut bench, Pane::Editor);
    bench
}

pub fn text(bench: &Bench) -> String {
    workbench(bench).document().text().to_owned()
}

/// Puts the cursor before or behind a part of the text.
pub fn put_cursor(bench: &mut Bench, part: &str, behind: bool) {
    let at = text(bench).find(part).unwrap_or_else(|| panic!("no {part} in the text"));
    workbench_mut(bench).put_cursor(if behind { at + part.len() } else { at });
    settle(bench);
}

pub fn type_text(bench: &mut Bench, letters: &str) {
    for letter in letters.chars() {
        bench.event(Event::Text(letter.to_string()));
        bench.step();
    }
    settle(bench);
}

pub fn follow(bench: &mut Bench) {
    wait_until(bench, "the scene to follow its text", |bench| !workbench(bench).is_stale());
    settle(bench);
}

pub fn camera_height(bench: &Bench) -> f64 {
    workbench(bench).scene().expect("open").scene.camera.eye.z
}

pub fn shift(modifiers: Modifiers) -> Modifiers {
    modifiers.plus(Modifiers::SHIFT)
}

/// Moves the pointer from one place to another with the button down, in a few steps.
pub fn drag(bench: &mut Bench, from: Pos2, to: Pos2) {
    bench.hover_at(from);
    settle(bench);
    bench.drag_at(from);
    settle(bench);
    for i in 1..=4_u8 {
        bench.hover_at(from + (to - from) * (f32::from(i) / 4.0));
        settle(bench);
    }
    bench.event(Event::PointerButton {
        pos: to,
        button: PointerButton::Primary,
        pressed: false,
        modifiers: Modifiers::default(),
    });
    settle(bench);
}
