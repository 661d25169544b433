//! Finding pixels and maps in the workbench, through the names that a screen reader reads out.
#![cfg(feature = "workbench")]

mod hands;

use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::kittest::{NodeT, Queryable};
use hands::*;
use rayscope::app::{Command, Pane, SearchCommand, ViewCommand};
use rayscope::query::{Quantity, Query};
use rayscope::record::What;
use rayscope::scene::embedded_scene;

/// The scene in a small picture, so that tests need not wait for all of a large one.
fn small<'a>(name: &str) -> Bench<'a> {
    let text = embedded_scene(name).expect("the scene is embedded").text;
    let mut scene: serde_json::Value = serde_json::from_str(text).expect("embedded scenes are plain JSON");
    scene["image"] = serde_json::json!({ "width": 32, "height": 24 });
    scene["pixels"] = serde_json::json!([[16, 12]]);
    let text = scene.to_string();
    let mut bench = open_text(name, &text, egui::Vec2::new(1280.0, 800.0));
    reveal(&mut bench, Pane::Search);
    bench
}

fn type_into_field(bench: &mut Bench, text: &str) {
    run(bench, Command::Search(SearchCommand::Find));
    bench.get_by_role_and_label(Role::TextInput, "Find pixels").type_text(text);
    settle(bench);
}

fn field(bench: &Bench) -> String {
    bench.get_by_role_and_label(Role::TextInput, "Find pixels").accesskit_node().value().unwrap_or_default()
}

fn wait(bench: &mut Bench) {
    wait_until(bench, "the search", |bench| workbench(bench).search().is_finished());
    settle(bench);
}

#[test]
fn what_is_typed_is_found_listed_and_stepped_through() {
    let mut bench = small("optics/glass_cube");
    type_into_field(&mut bench, "tir");
    wait(&mut bench);
    let count = workbench(&bench).search().count().expect("something was asked");
    assert!(count > 3);
    assert!(bench.query_by_label(&format!("{count} of {} pixels", 32 * 24)).is_some());
    let query = Query::parse("tir").unwrap();
    let mut seen = Vec::new();
    for _ in 0..3 {
        press(&mut bench, Key::F3);
        let recording = workbench(&bench).recording().expect("a result is recorded");
        assert_eq!(
            query.first(&recording.tree),
            Some(recording.selected()),
            "the event is selected for which it was found"
        );
        assert!(matches!(recording.tree.event(recording.selected()).what, What::Snell { .. }));
        seen.push(recording.pixel);
    }
    assert!(seen.is_sorted_by_key(|[x, y]| [*y, *x]) && seen[0] != seen[2], "{seen:?} are in reading order");
    bench.key_press_modifiers(Modifiers::SHIFT, Key::F3);
    settle(&mut bench);
    assert_eq!(pixel(&bench), seen[1]);
    bench.get_by_role_and_label(Role::Button, "Next result").click();
    settle(&mut bench);
    assert_eq!(pixel(&bench), seen[2]);
}

#[test]
fn a_row_of_the_list_is_recorded_by_a_click() {
    let mut bench = small("csg/bowl");
    type_into_field(&mut bench, "hit=bowl");
    wait(&mut bench);
    let row = bench.query_all_by_role(Role::ListItem).nth(2).expect("there are results").rect().center();
    click(&mut bench, row);
    let recording = workbench(&bench).recording().expect("recorded");
    assert!(matches!(&recording.tree.event(recording.selected()).what, What::Hit { object, .. } if object == "bowl"));
    let chosen =
        bench.query_all_by_role(Role::ListItem).position(|row| row.accesskit_node().is_selected() == Some(true));
    assert_eq!(chosen, Some(2));
}

#[test]
fn a_tab_takes_the_first_completion() {
    let mut bench = small("csg/bowl");
    type_into_field(&mut bench, "csg.ea");
    press(&mut bench, Key::Tab);
    assert_eq!(field(&bench), "csg.early_out");
    assert!(workbench(&bench).search().count().is_some(), "it is asked at once");
}

#[test]
fn values_of_the_scene_are_offered_and_taken_by_arrow_and_enter() {
    let mut bench = small("optics/glass_cube");
    type_into_field(&mut bench, "kind=ref");
    press(&mut bench, Key::ArrowDown);
    press(&mut bench, Key::Enter);
    assert_eq!(field(&bench), "kind=refracted");
}

#[test]
fn what_cannot_be_read_is_said_with_its_column() {
    let mut bench = small("csg/bowl");
    type_into_field(&mut bench, "hit & undecidible ");
    assert!(bench.query_by_label_contains("column 7").is_some());
    assert!(bench.query_by_label_contains("did you mean `undecidable`?").is_some());
    assert_eq!(workbench(&bench).search().count(), None);
}

#[test]
fn a_name_that_the_scene_lacks_is_said() {
    let mut bench = small("csg/bowl");
    workbench_mut(&mut bench).find("hit=bwl");
    wait(&mut bench);
    assert!(bench.query_by_label_contains("did you mean `bowl`?").is_some());
    assert_eq!(workbench(&bench).search().count(), Some(0));
}

#[test]
fn forgetting_the_search_clears_field_and_marks() {
    let mut bench = small("csg/bowl");
    workbench_mut(&mut bench).find("hit");
    wait(&mut bench);
    run(&mut bench, Command::Search(SearchCommand::Clear));
    assert_eq!(workbench(&bench).search().count(), None);
    assert_eq!(field(&bench), "");
}

#[test]
fn each_map_is_drawn_and_read_out() {
    let mut bench = small("optics/glass_cube");
    for (quantity, name) in [
        (Quantity::Rays, "Map: Rays"),
        (Quantity::Object, "Map: Objects"),
        (Quantity::Normal, "Map: Normals"),
        (Quantity::Time, "Map: Time"),
    ] {
        run(&mut bench, Command::Search(SearchCommand::Map(quantity)));
        wait(&mut bench);
        assert!(bench.query_by_role_and_label(Role::Image, name).is_some(), "{name}");
    }
    run(&mut bench, Command::Search(SearchCommand::NoMap));
    assert_eq!(workbench(&bench).search().map(), None);
}

#[test]
fn the_pixel_under_the_pointer_is_read_from_the_map() {
    let mut bench = small("optics/glass_cube");
    run(&mut bench, Command::Search(SearchCommand::Map(Quantity::Depth)));
    wait(&mut bench);
    let at = place_of(&bench, [16, 12]);
    bench.hover_at(at);
    settle(&mut bench);
    assert!(bench.query_by_label_contains("· depth ").is_some());
}

#[test]
fn every_word_of_the_language_can_be_asked_by_a_click() {
    let mut bench = small("csg/bowl");
    bench.get_by_role_and_label(Role::Button, "Words").click();
    settle(&mut bench);
    bench.get_by_role_and_label(Role::Button, "csg.empty").click_accesskit();
    settle(&mut bench);
    assert_eq!(field(&bench), "csg.empty");
}

/// Whether nothing asks for another frame.
fn is_still(bench: &Bench) -> bool {
    bench.output().viewport_output.values().all(|view| view.repaint_delay == std::time::Duration::MAX)
}

#[test]
fn a_map_lies_over_its_own_scene_alone_and_none_is_made_while_its_panel_is_hidden() {
    let mut bench = small("optics/glass_cube");
    run(&mut bench, Command::Search(SearchCommand::Map(Quantity::Rays)));
    wait(&mut bench);
    let told = |bench: &Bench| {
        let scene = &workbench(bench).scene().expect("a scene is open").scene;
        workbench(bench).search().told(scene, [16, 12])
    };
    assert!(told(&bench).is_some());
    run(&mut bench, Command::View(ViewCommand::Pane(Pane::Search)));
    assert!(!workbench(&bench).dock().shows(Pane::Search));
    assert!(told(&bench).is_some(), "what is known stays over the picture");
    let ctx = bench.ctx.clone();
    workbench_mut(&mut bench).open_scene(&ctx, "hello/sphere");
    settle(&mut bench);
    wait_until(&mut bench, "the picture", |bench| workbench(bench).picture_finished());
    wait_until(&mut bench, "stillness", is_still);
    assert_eq!(told(&bench), None, "the map is of another scene");
    reveal(&mut bench, Pane::Search);
    wait(&mut bench);
    assert!(told(&bench).is_some());
}

#[test]
fn what_is_typed_after_the_palette_led_to_the_search_is_in_its_field() {
    let mut bench = small("csg/bowl");
    bench.key_press_modifiers(Modifiers::COMMAND, Key::K);
    settle(&mut bench);
    bench.event(egui::Event::Text("find pixels".to_owned()));
    settle(&mut bench);
    press(&mut bench, Key::Enter);
    bench.event(egui::Event::Text("tir".to_owned()));
    settle(&mut bench);
    assert_eq!(field(&bench), "tir");
}
