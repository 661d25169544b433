//! Comparing in the workbench, as a person does it: pins, the first difference, pictures, another ray tracer.
#![cfg(feature = "workbench")]

mod hands;

use egui::Key;
use egui::accesskit::Role;
use egui_kittest::kittest::{NodeT, Queryable};
use hands::*;
use rayscope::app::{Command, CompareCommand, Pane};
use rayscope::record::What;

fn has(bench: &Bench, part: &str) -> bool {
    bench.query_all_by_label_contains(part).next().is_some()
}

fn compared_rows(bench: &Bench) -> Vec<String> {
    let words = ["same: ", "changed: ", "only here: ", "only in the pin: "];
    rows(bench).into_iter().filter(|row| words.iter().any(|word| row.starts_with(word))).collect()
}

fn tree(bench: &Bench) -> std::sync::Arc<rayscope::trace::RayTree> {
    std::sync::Arc::clone(&workbench(bench).recording().expect("a pixel is recorded").tree)
}

/// The bowl with its first pixel pinned and another pixel recorded.
fn pinned<'a>() -> Bench<'a> {
    let mut bench = open("csg/bowl");
    run(&mut bench, Command::Compare(CompareCommand::Pin));
    let scene = std::sync::Arc::clone(&workbench(&bench).scene().expect("a scene is open").scene);
    record(&mut bench, scene.pixels[1]);
    wait_until(&mut bench, "the comparison", |bench| has(bench, "First difference:"));
    settle(&mut bench);
    bench
}

fn record(bench: &mut Bench, pixel: [u32; 2]) {
    bench.state_mut().as_mut().expect("the workbench was shown").record(pixel);
    wait_until(bench, "the pixel", |bench| self::pixel(bench) == pixel);
    settle(bench);
}

#[test]
fn without_a_pin_the_panel_says_what_to_do_and_the_story_itself_does_not_differ() {
    let mut bench = open("hello/sphere");
    bench.state_mut().as_mut().expect("shown").reveal(Pane::Compare);
    settle(&mut bench);
    assert!(has(&bench, "Pin a story, then record another pixel"));
    run(&mut bench, Command::Compare(CompareCommand::Pin));
    wait_until(&mut bench, "the comparison", |bench| has(bench, "No difference in"));
    assert!(has(&bench, "compared with"));
}

#[test]
fn two_pixels_are_laid_side_by_side_with_words_for_what_differs() {
    let bench = pinned();
    let rows = compared_rows(&bench);
    assert!(rows.iter().any(|row| row.starts_with("changed: ")), "{rows:?}");
    // What is the same has a row only where something below it is not.
    let alike = rows.iter().filter(|row| row.starts_with("same: ")).count();
    assert!(alike < rows.len() && !rows.iter().any(|row| row.contains("ambient term")), "{rows:?}");
    assert!(has(&bench, "First that goes another way:"));
}

#[test]
fn the_buttons_go_to_the_first_difference_in_both_stories() {
    let mut bench = pinned();
    let ours = tree(&bench);
    bench.get_all_by_role_and_label(Role::Button, "Go there in the pin").next().expect("a button").click();
    settle(&mut bench);
    let theirs = tree(&bench);
    assert_ne!(*ours, *theirs);
    assert!(has(&bench, "First difference:"), "the comparison stays while the pin is looked at");
    bench.get_all_by_role_and_label(Role::Button, "Go there").next().expect("a button").click();
    settle(&mut bench);
    assert_eq!(*tree(&bench), *ours);
}

#[test]
fn the_keys_go_from_difference_to_difference() {
    let mut bench = pinned();
    let mut seen = Vec::new();
    for _ in 0..4 {
        press(&mut bench, Key::F7);
        seen.push(selected(&bench));
    }
    assert!(seen.is_sorted() && seen[0] < seen[3], "{seen:?}");
    bench.key_press_modifiers(egui::Modifiers::SHIFT, Key::F7);
    settle(&mut bench);
    assert_eq!(selected(&bench), seen[2]);
}

#[test]
fn a_pin_has_a_name_and_can_be_taken_away() {
    let mut bench = pinned();
    run(&mut bench, Command::Compare(CompareCommand::Pin));
    wait_until(&mut bench, "the comparison", |bench| has(bench, "No difference in"));
    run(&mut bench, Command::Compare(CompareCommand::Unpin));
    wait_until(&mut bench, "the first pin", |bench| has(bench, "First difference:"));
    run(&mut bench, Command::Compare(CompareCommand::Unpin));
    settle(&mut bench);
    assert!(has(&bench, "Pin a story, then record another pixel"));
}

#[test]
fn pictures_are_laid_over_each_other_with_a_slider_that_keys_move() {
    let mut bench = open("hello/sphere");
    run(&mut bench, Command::Compare(CompareCommand::Pin));
    let draft = rayscope::scene::Profile::NAMED.iter().find(|(name, _)| *name == "draft").expect("it is there").1;
    let look = rayscope::app::Look { name: "draft".to_owned(), profile: draft };
    let ctx = bench.ctx.clone();
    bench.state_mut().as_mut().expect("shown").look(&ctx, Some(look));
    settle(&mut bench);
    bench.get_by_label("Pictures").click();
    settle(&mut bench);
    wait_until(&mut bench, "both pictures", |bench| has(bench, "root mean square"));
    settle(&mut bench);
    let slider = |bench: &Bench| {
        bench.get_by_role_and_label(Role::Slider, "Between the two pictures").accesskit_node().numeric_value()
    };
    let before = slider(&bench).expect("it has a value");
    bench.get_by_role_and_label(Role::Slider, "Between the two pictures").focus();
    settle(&mut bench);
    press(&mut bench, Key::ArrowRight);
    assert!(slider(&bench).expect("it has a value") > before);
}

#[test]
fn another_ray_tracers_lines_are_compared_with_the_scene_that_is_open() {
    let mut bench = open("compare/still_life");
    let lines = std::fs::read_to_string("tests/compare/python.jsonl").expect("it is there");
    bench.state_mut().as_mut().expect("shown").open_foreign("python.jsonl", &lines);
    wait_until(&mut bench, "the comparison", |bench| has(bench, "python.jsonl: no difference in"));
    let wrong = lines.replacen("\"n1\": 1, \"n2\": 1.5", "\"n1\": 1.5, \"n2\": 1", 1);
    assert_ne!(wrong, lines);
    bench.state_mut().as_mut().expect("shown").open_foreign("mine.jsonl", &wrong);
    wait_until(&mut bench, "the comparison", |bench| has(bench, "Likely cause: n₁ and n₂ are swapped"));
    bench.get_by_role_and_label(Role::Button, "Show our story there").click();
    settle(&mut bench);
    let recording = workbench(&bench).recording().expect("a pixel is recorded");
    assert!(matches!(recording.tree.event(recording.selected()).what, What::Snell { .. }));
}

#[test]
fn what_cannot_be_read_is_told_with_line_and_column() {
    let mut bench = open("hello/sphere");
    bench.state_mut().as_mut().expect("shown").open_foreign("mine.jsonl", "{\"pixel\": [1, 2]}\n{\"t\": \"five\"}\n");
    settle(&mut bench);
    assert!(has(&bench, "line 2, column 2: `t`: expected a number"));
}

#[test]
fn all_of_the_comparison_stays_within_its_panel() {
    let bench = pinned();
    let panel = workbench(&bench).dock().rect_of(Pane::Compare).expect("it is seen");
    for part in ["compared with", "Name of the pin", "Take the pin away", "First difference:", "Show all rows"] {
        let shown = bench.get_all_by_label_contains(part).next().expect(part).rect();
        assert!(panel.x_range().contains(shown.left()) && panel.x_range().contains(shown.right()), "{part}: {shown}");
    }
}
