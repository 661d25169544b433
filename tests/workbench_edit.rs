//! Editing in the workbench, as a person does it: typing, dragging, undoing, saving, and coming back after a crash.
#![cfg(feature = "workbench")]

mod hands;

use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, Vec2, ViewportCommand, ViewportEvent, ViewportId};
use egui_kittest::kittest::Queryable;
use hands::editing::*;
use hands::*;
use rayscope::app::{EditCommand, Pane};
use rayscope::document::{Document, Journal, Selection, Template, Write};
use rayscope::record::What;
use rayscope::scene::embedded_scene;
use std::fs;

#[test]
fn the_picture_and_the_story_follow_what_is_typed_and_the_selection_stays() {
    let mut bench = open_editor("hello/sphere");
    let hit = selected(&bench);
    assert!(matches!(workbench(&bench).recording().expect("recorded").tree.event(hit).what, What::Hit { .. }));
    let before = workbench(&bench).recording().expect("recorded").tree.clone();
    put_cursor(&mut bench, "\"translate\": [0, 0, 1", true);
    type_text(&mut bench, ".2");
    assert!(text(&bench).contains("\"translate\": [0, 0, 1.2]"));
    follow(&mut bench);
    let recording = workbench(&bench).recording().expect("recorded");
    assert_ne!(*recording.tree, *before);
    assert!(matches!(recording.tree.event(recording.selected()).what, What::Hit { .. }));
    assert!(recording.changed.contains(&recording.selected()), "the hit moved");
    assert!(bench.query_by_label("• not saved").is_some());
    reveal(&mut bench, Pane::Story);
    assert!(rows(&bench).iter().any(|row| row.contains("• changed")), "{:?}", rows(&bench));
    wait_until(&mut bench, "the picture", |bench| workbench(bench).picture_finished());
}

#[test]
fn while_the_text_is_broken_the_old_scene_stays_with_a_mark_and_f8_goes_to_the_error() {
    let mut bench = open_editor("hello/sphere");
    let height = camera_height(&bench);
    put_cursor(&mut bench, "\"field_of_view\": 32", true);
    type_text(&mut bench, "0");
    wait_until(&mut bench, "the error", |bench| bench.query_by_label("1 error").is_some());
    assert!(workbench(&bench).is_stale());
    assert_eq!(camera_height(&bench), height);
    assert!(bench.query_by_label_contains("stale").is_some());
    assert!(bench.query_by_label_contains("Line 6, column").is_some(), "the message says where");
    workbench_mut(&mut bench).put_cursor(0);
    settle(&mut bench);
    press(&mut bench, Key::F8);
    let range = workbench(&bench).document().selection().range();
    assert_eq!(&text(&bench)[range], "320");
    bench.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    settle(&mut bench);
    follow(&mut bench);
    assert!(bench.query_by_label("1 error").is_none());
}

#[test]
fn a_dragged_number_changes_the_text_as_one_step_that_is_undone_at_once() {
    let mut bench = open_editor("hello/sphere");
    reveal(&mut bench, Pane::Properties);
    let before = text(&bench);
    put_cursor(&mut bench, "\"key light\"", false);
    reveal(&mut bench, Pane::Properties);
    assert_eq!(workbench(&bench).edited().as_deref(), Some("lights[0]"));
    let at = bench.get_by_label("point z").rect().center();
    drag(&mut bench, at, at + Vec2::new(60.0, 0.0));
    let after = text(&bench);
    assert_ne!(after, before);
    let light =
        |text: &str| serde_json::from_str::<serde_json::Value>(text).expect("JSON")["lights"][0]["point"].clone();
    assert_eq!(
        (light(&after)[0].clone(), light(&after)[1].clone()),
        (light(&before)[0].clone(), light(&before)[1].clone())
    );
    assert!(light(&after)[2].as_f64() > light(&before)[2].as_f64());
    let name = workbench(&bench).document().undo_name().expect("something to undo").to_owned();
    assert_eq!(name, "Change point of Light: key light");
    run(&mut bench, rayscope::app::Command::Edit(EditCommand::Undo));
    assert_eq!(text(&bench), before);
    assert_eq!(workbench(&bench).document().undo_name(), None);
    bench.key_press_modifiers(shift(Modifiers::COMMAND), Key::Z);
    settle(&mut bench);
    assert_eq!(text(&bench), after);
}

#[test]
fn the_list_of_what_can_be_written_is_opened_and_used_by_keys() {
    let mut bench = open_editor("hello/sphere");
    put_cursor(&mut bench, "{ \"shape\": \"plane\",", true);
    bench.key_press_modifiers(Modifiers::COMMAND, Key::Space);
    settle(&mut bench);
    assert!(bench.query_by_role_and_label(Role::ListBox, "What can be written here").is_some());
    assert!(bench.query_by_label("priority").is_some() && bench.query_by_label("shape").is_none());
    press(&mut bench, Key::ArrowDown);
    press(&mut bench, Key::ArrowUp);
    press(&mut bench, Key::Enter);
    assert!(text(&bench).contains("{ \"shape\": \"plane\",\"priority\": 0"), "{}", text(&bench));
    assert!(bench.query_by_role_and_label(Role::ListBox, "What can be written here").is_none());
}

#[test]
fn typing_offers_names_and_escape_closes_the_offer() {
    let mut bench = open_editor("hello/sphere");
    put_cursor(&mut bench, "\"material\": \"", true);
    press(&mut bench, Key::Backspace);
    type_text(&mut bench, "\"");
    let list = |bench: &Bench| bench.query_by_role_and_label(Role::ListBox, "What can be written here").is_some();
    assert!(list(&bench));
    press(&mut bench, Key::Escape);
    assert!(!list(&bench));
}

#[test]
fn what_is_clicked_in_the_picture_is_edited_and_the_cursor_in_an_object_chooses_it() {
    let mut bench = open_editor("csg/bowl");
    let wall = workbench(&bench).scene().expect("open").scene.pixels[0];
    let at = place_of(&bench, wall);
    click(&mut bench, at);
    assert_eq!(workbench(&bench).edited().as_deref(), Some("objects[0].of[0]"));
    let cursor = workbench(&bench).document().selection().head;
    assert!(text(&bench)[cursor..].starts_with('{'), "the editor shows the object");
    put_cursor(&mut bench, "\"scale\": [2.6", false);
    assert_eq!(workbench(&bench).edited().as_deref(), Some("objects[0].of[2]"));
}

#[test]
fn an_object_is_moved_by_dragging_it_in_the_picture_and_one_undo_takes_it_back() {
    let mut bench = open_editor("hello/sphere");
    let before = text(&bench);
    press(&mut bench, Key::M);
    let ball = place_of(&bench, workbench(&bench).scene().expect("open").scene.pixels[0]);
    drag(&mut bench, ball, ball + Vec2::new(40.0, 0.0));
    assert_eq!(workbench(&bench).edited().as_deref(), Some("objects[0]"));
    let value: serde_json::Value = serde_json::from_str(&text(&bench)).expect("JSON");
    let moved = value["objects"][0]["transform"][0]["translate"].clone();
    assert!(moved[0].as_f64() > Some(0.05), "it went to the right: {moved}");
    assert_eq!(value["objects"].as_array().map(Vec::len), Some(2));
    follow(&mut bench);
    assert_eq!(workbench(&bench).document().undo_name(), Some("Move ball"));
    run(&mut bench, rayscope::app::Command::Edit(EditCommand::Undo));
    assert_eq!(text(&bench), before);
}

#[test]
fn a_drag_moves_the_whole_object_unless_a_part_of_it_was_chosen() {
    let translate = |bench: &Bench, place: &str| {
        let value: serde_json::Value = serde_json::from_str(&text(bench)).expect("JSON");
        value.pointer(place).cloned()
    };
    let mut bench = open_editor("csg/bowl");
    let pixel = workbench(&bench).scene().expect("open").scene.pixels[0];
    let wall = place_of(&bench, pixel);
    click(&mut bench, wall);
    run(&mut bench, rayscope::app::Command::Edit(EditCommand::Move));
    drag(&mut bench, wall, wall + Vec2::new(10.0, 0.0));
    assert_eq!(workbench(&bench).document().undo_name(), Some("Move bowl"));
    assert_ne!(translate(&bench, "/objects/0/transform/0/translate"), Some(serde_json::json!([0, 0, 1.5])));
    run(&mut bench, rayscope::app::Command::Edit(EditCommand::Undo));
    follow(&mut bench);
    put_cursor(&mut bench, "\"S₁\"", false);
    drag(&mut bench, wall, wall + Vec2::new(10.0, 0.0));
    assert_eq!(workbench(&bench).document().undo_name(), Some("Move S₁"));
    assert!(translate(&bench, "/objects/0/of/0/transform/1/translate").is_some(), "a further step moves the part");
    assert_eq!(translate(&bench, "/objects/0/transform/0/translate"), Some(serde_json::json!([0, 0, 1.5])));
}

#[test]
fn in_the_side_view_an_object_is_moved_within_its_plane_and_along_an_axis_with_shift() {
    let mut bench = open_editor("hello/sphere");
    run(&mut bench, rayscope::app::Command::Edit(EditCommand::Move));
    let rect = bench.get_by_role_and_label(Role::Image, "Side view").rect();
    let ball = {
        let recording = workbench(&bench).recording().expect("recorded");
        let options = rayscope::view::SideViewOptions {
            size: [f64::from(rect.width().floor()), f64::from(rect.height().floor())],
            ..Default::default()
        };
        let tree = &recording.tree;
        let plane = rayscope::view::side_view_plane(&recording.scene, tree, recording.selected(), &options);
        let [x, y] = plane.spot(glam::DVec3::new(0.0, 0.0, 1.0));
        #[expect(clippy::cast_possible_truncation, reason = "a place on the screen")]
        let spot = Vec2::new(x as f32, y as f32);
        rect.min + spot
    };
    bench.event(Event::ModifiersChanged(Modifiers::SHIFT));
    drag(&mut bench, ball, ball - Vec2::new(3.0, 30.0));
    let value: serde_json::Value = serde_json::from_str(&text(&bench)).expect("JSON");
    let moved = value["objects"][0]["transform"][0]["translate"].clone();
    assert_eq!((moved[0].as_f64(), moved[1].as_f64()), (Some(0.0), Some(0.0)), "{moved}");
    assert!(moved[2].as_f64() > Some(1.05), "{moved}");
}

#[test]
fn keys_move_what_is_chosen_while_the_picture_has_the_focus() {
    let mut bench = open_editor("hello/sphere");
    let pixel_before = workbench(&bench).scene().expect("open").scene.pixels[0];
    let ball = place_of(&bench, pixel_before);
    click(&mut bench, ball);
    press(&mut bench, Key::M);
    let recorded = pixel(&bench);
    press(&mut bench, Key::ArrowRight);
    press(&mut bench, Key::ArrowRight);
    let value: serde_json::Value = serde_json::from_str(&text(&bench)).expect("JSON");
    assert!(value["objects"][0]["transform"][0]["translate"][0].as_f64() > Some(0.0));
    assert_eq!(pixel(&bench), recorded, "the recorded pixel stays");
    run(&mut bench, rayscope::app::Command::Edit(EditCommand::Undo));
    assert!(!workbench(&bench).document().is_dirty(), "two presses of a key are one move");
}

#[test]
fn another_shape_comes_with_its_own_parameters() {
    let mut bench = open_editor("primitives/torus");
    let before = text(&bench);
    put_cursor(&mut bench, "\"shape\": \"torus\"", false);
    reveal(&mut bench, Pane::Properties);
    bench.get_by_role_and_label(Role::ComboBox, "shape").click();
    settle(&mut bench);
    bench.get_by_role_and_label(Role::Button, "superellipsoid").click_accesskit();
    settle(&mut bench);
    follow(&mut bench);
    let after = text(&bench);
    assert!(after.contains("\"shape\": \"superellipsoid\"") && after.contains("\"n\": "), "{after}");
    assert!(!after.contains("\"d\":"), "{after}");
    assert_eq!(workbench(&bench).problem(), None);
    run(&mut bench, rayscope::app::Command::Edit(EditCommand::Undo));
    assert_eq!(text(&bench), before, "it is one change");
}

#[test]
fn words_are_found_and_gone_through() {
    let mut bench = open_editor("hello/sphere");
    workbench_mut(&mut bench).put_cursor(0);
    settle(&mut bench);
    bench.key_press_modifiers(Modifiers::COMMAND, Key::F);
    settle(&mut bench);
    type_text(&mut bench, "SPHERE");
    let count = text(&bench).to_lowercase().matches("sphere").count();
    assert!(bench.query_by_label(&format!("{count} matches")).is_some());
    bench.get_by_role_and_label(Role::Button, "Next match").click();
    settle(&mut bench);
    let first = workbench(&bench).document().selection().range();
    bench.get_by_role_and_label(Role::Button, "Next match").click();
    settle(&mut bench);
    let second = workbench(&bench).document().selection().range();
    assert_eq!(text(&bench)[first.clone()].to_lowercase(), "sphere");
    assert!(second.start > first.start);
}

fn edit_title(bench: &mut Bench) {
    put_cursor(bench, "\"title\": \"", true);
    type_text(bench, "My ");
}

#[test]
fn another_scene_is_not_opened_over_unsaved_changes_without_asking() {
    let mut bench = open_editor("hello/sphere");
    edit_title(&mut bench);
    let ctx = bench.ctx.clone();
    let ask = |bench: &mut Bench| {
        workbench_mut(bench).open_scene(&ctx, "csg/bowl");
        settle(bench);
        assert!(bench.query_by_label("Save the changes to hello/sphere?").is_some());
        assert_eq!(workbench(bench).scene().expect("open").name, "hello/sphere");
    };
    ask(&mut bench);
    bench.get_by_role_and_label(Role::Button, "Cancel").click();
    settle(&mut bench);
    assert!(text(&bench).contains("My Hello"));
    ask(&mut bench);
    press(&mut bench, Key::Escape);
    assert!(bench.query_by_label("Save the changes to hello/sphere?").is_none() && text(&bench).contains("My Hello"));
    ask(&mut bench);
    bench.get_by_role_and_label(Role::Button, "Don’t save").click();
    settle(&mut bench);
    assert_eq!(workbench(&bench).scene().expect("open").name, "csg/bowl");
    assert!(!workbench(&bench).document().is_dirty());
}

/// Whether the program told the window something in the last frame.
fn told(bench: &Bench, command: &ViewportCommand) -> bool {
    let output = &bench.output().viewport_output;
    output.get(&ViewportId::ROOT).is_some_and(|viewport| viewport.commands.contains(command))
}

fn ask_to_close(bench: &mut Bench) {
    let viewport = bench.input_mut().viewports.entry(ViewportId::ROOT).or_default();
    viewport.events.push(ViewportEvent::Close);
    bench.step();
}

#[test]
fn the_window_does_not_close_over_unsaved_changes() {
    let mut bench = open_editor("hello/sphere");
    ask_to_close(&mut bench);
    assert!(!told(&bench, &ViewportCommand::CancelClose), "nothing keeps it open");
    edit_title(&mut bench);
    ask_to_close(&mut bench);
    assert!(told(&bench, &ViewportCommand::CancelClose));
    settle(&mut bench);
    bench.get_by_role_and_label(Role::Button, "Don’t save").click();
    let mut closes = false;
    for _ in 0..4 {
        bench.step();
        closes |= told(&bench, &ViewportCommand::Close);
    }
    assert!(closes);
}

#[test]
fn a_scene_is_saved_to_its_file_and_a_file_changed_by_others_is_not_overwritten() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("mine.json");
    let mut bench = open_editor("hello/sphere");
    edit_title(&mut bench);
    let ctx = bench.ctx.clone();
    workbench_mut(&mut bench).save_as(&ctx, path.clone());
    wait_until(&mut bench, "the file", |bench| !workbench(bench).document().is_dirty());
    assert_eq!(fs::read_to_string(&path).expect("written"), text(&bench));
    assert_eq!(workbench(&bench).scene().expect("open").name, path.display().to_string());
    edit_title(&mut bench);
    bench.key_press_modifiers(Modifiers::COMMAND, Key::S);
    wait_until(&mut bench, "the file", |bench| !workbench(bench).document().is_dirty());
    assert!(fs::read_to_string(&path).expect("written").contains("My My Hello"));
    fs::write(&path, "theirs").expect("written");
    edit_title(&mut bench);
    bench.key_press_modifiers(Modifiers::COMMAND, Key::S);
    wait_until(&mut bench, "the refusal", |bench| workbench(bench).problem().is_some());
    assert_eq!(fs::read_to_string(&path).expect("still there"), "theirs");
    assert!(workbench(&bench).document().is_dirty());
}

#[test]
fn saving_first_goes_on_to_what_was_asked_for() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("mine.json");
    fs::write(&path, Template::Ball.text()).expect("written");
    let mut bench = open_editor("hello/sphere");
    let ctx = bench.ctx.clone();
    workbench_mut(&mut bench).open_scene(&ctx, &path.display().to_string());
    settle(&mut bench);
    put_cursor(&mut bench, "\"title\": \"", true);
    type_text(&mut bench, "My ");
    workbench_mut(&mut bench).open_scene(&ctx, "csg/bowl");
    settle(&mut bench);
    bench.get_by_role_and_label(Role::Button, "Save changes").click();
    wait_until(&mut bench, "the other scene", |bench| workbench(bench).scene().expect("open").name == "csg/bowl");
    assert!(fs::read_to_string(&path).expect("written").contains("My A new scene"));
}

/// A folder with the journal of a program that was killed while this text was edited.
fn left_behind(name: &str, saved: &str, edited: &str) -> tempfile::TempDir {
    let (mut document, mut journal) = (Document::new(saved), Journal::default());
    document.typed(edited, Selection::at(12), "Type");
    let Some(Write::Anew(bytes)) = journal.note(&document, name, 1) else { panic!("a first note holds everything") };
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("edit-killed.journal"), bytes).expect("written");
    fs::write(folder.path().join("edit-killed.lock"), "").expect("written");
    folder
}

#[test]
fn the_tour_of_the_first_visit_waits_until_the_offer_is_answered() {
    let saved = embedded_scene("hello/sphere").expect("embedded").text;
    let edited = saved.replace("\"translate\": [0, 0, 1]", "\"translate\": [0, 0, 1.5]");
    let folder = left_behind("hello/sphere", saved, &edited);
    let mut bench = open_at("csg/bowl", SIZE);
    workbench_mut(&mut bench).keep_edits_in(folder.path());
    workbench_mut(&mut bench).offer_tour();
    settle(&mut bench);
    assert!(bench.query_by_label_contains("Recover the edit of hello/sphere from").is_some());
    assert!(bench.query_by_label("Stop 1 of 6").is_none(), "it would lie over the question");
    // Enter and Escape belong to the question, too.
    press(&mut bench, Key::Escape);
    assert!(bench.query_by_label_contains("Recover the edit of hello/sphere from").is_none());
    assert!(bench.query_by_label("Stop 1 of 6").is_some(), "it was not passed over");
    assert!(!workbench(&bench).settings().is_toured);
}

#[test]
fn after_a_crash_the_next_start_offers_the_edit_back() {
    let saved = embedded_scene("hello/sphere").expect("embedded").text;
    let edited = saved.replace("\"translate\": [0, 0, 1]", "\"translate\": [0, 0, 1.5]");
    let folder = left_behind("hello/sphere", saved, &edited);
    let mut bench = open_at("csg/bowl", SIZE);
    workbench_mut(&mut bench).keep_edits_in(folder.path());
    settle(&mut bench);
    assert!(bench.query_by_label_contains("Recover the edit of hello/sphere from").is_some());
    assert!(bench.query_by_label_contains("+       \"transform\": [{ \"translate\": [0, 0, 1.5] }]").is_some());
    bench.get_by_role_and_label(Role::Button, "Recover").click();
    settle(&mut bench);
    follow(&mut bench);
    assert_eq!(text(&bench), edited);
    assert_eq!(workbench(&bench).scene().expect("open").name, "hello/sphere");
    assert!(workbench(&bench).document().is_dirty());
    let killed = folder.path().join("edit-killed.journal");
    wait_until(&mut bench, "the old journal to go", |_| !killed.exists());
    let journals = fs::read_dir(folder.path()).expect("a folder").flatten();
    assert_eq!(journals.filter(|entry| entry.path().extension().is_some_and(|e| e == "journal")).count(), 1);
    run(&mut bench, rayscope::app::Command::Edit(EditCommand::Undo));
    assert_eq!(text(&bench), saved);
}

#[test]
fn an_edit_that_is_broken_json_is_offered_too() {
    let saved = embedded_scene("hello/sphere").expect("embedded").text;
    let edited = saved.replace("\"objects\": [", "\"objects\": [ {");
    let folder = left_behind("hello/sphere", saved, &edited);
    let mut bench = open_at("csg/bowl", SIZE);
    workbench_mut(&mut bench).keep_edits_in(folder.path());
    settle(&mut bench);
    bench.get_by_role_and_label(Role::Button, "Recover").click();
    settle(&mut bench);
    assert_eq!(text(&bench), edited);
    assert_eq!(workbench(&bench).scene().expect("open").name, "hello/sphere");
}

#[test]
fn an_offer_that_is_put_off_stays_and_one_that_is_discarded_goes() {
    let saved = embedded_scene("hello/sphere").expect("embedded").text;
    let folder = left_behind("hello/sphere", saved, &saved.replace("Hello", "Bye"));
    let journal = folder.path().join("edit-killed.journal");
    for (button, stays) in [("Later", true), ("Discard", false)] {
        let mut bench = open_at("hello/sphere", SIZE);
        workbench_mut(&mut bench).keep_edits_in(folder.path());
        settle(&mut bench);
        bench.get_by_role_and_label(Role::Button, button).click();
        settle(&mut bench);
        assert!(bench.query_by_label_contains("Recover the edit").is_none());
        assert_eq!(text(&bench), saved);
        drop(bench);
        assert_eq!(journal.exists(), stays, "{button}");
    }
}

#[test]
fn within_a_second_of_typing_a_journal_holds_what_was_typed() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut bench = open_editor("hello/sphere");
    workbench_mut(&mut bench).keep_edits_in(folder.path());
    edit_title(&mut bench);
    let holds = |typed: &str| {
        let journals = fs::read_dir(folder.path()).expect("a folder").flatten().map(|entry| entry.path());
        let mut whole = journals.filter(|path| path.extension().is_some_and(|extension| extension == "journal"));
        let bytes = whole.next().and_then(|path| fs::read(path).ok()).unwrap_or_default();
        rayscope::document::Recovered::read(&bytes).is_some_and(|state| state.text.contains(typed))
    };
    wait_until(&mut bench, "the journal", |_| holds("My Hello"));
    type_text(&mut bench, "own ");
    wait_until(&mut bench, "the journal", |_| holds("My own Hello"));
    run(&mut bench, rayscope::app::Command::Edit(EditCommand::Revert));
    wait_until(&mut bench, "the journal to go", |_| !holds(""));
}

#[test]
fn a_new_scene_begins_from_a_template() {
    let mut bench = open_editor("hello/sphere");
    for template in Template::ALL {
        run(&mut bench, rayscope::app::Command::Edit(EditCommand::New(template)));
        assert_eq!(text(&bench), template.text());
        assert_eq!(workbench(&bench).scene().expect("open").name, "untitled");
        assert!(workbench(&bench).problem().is_none());
    }
}

#[test]
fn properties_of_everything_in_a_scene_are_shown_without_an_unnamed_control() {
    for scene in ["csg/bowl", "textures/every_surface", "lens/hexagon", "spectrum/prism"] {
        let mut bench = open_at(scene, SIZE);
        reveal(&mut bench, Pane::Properties);
        let whole: serde_json::Value = serde_json::from_str(&text(&bench)).expect("JSON");
        for target in rayscope::document::targets(&whole) {
            let place = target.place.to_string();
            let range = rayscope::document::Syntax::of(&text(&bench)).range(&target.place);
            let Some(range) = range else { continue };
            workbench_mut(&mut bench).put_cursor(range.start + 1);
            reveal(&mut bench, Pane::Properties);
            assert_eq!(workbench(&bench).edited().as_deref(), Some(place.as_str()));
        }
    }
}

#[test]
fn a_row_of_the_story_that_is_not_changed_has_no_mark() {
    let mut bench = open_editor("hello/sphere");
    edit_title(&mut bench);
    follow(&mut bench);
    reveal(&mut bench, Pane::Story);
    assert!(!rows(&bench).is_empty());
    assert!(rows(&bench).iter().all(|row| !row.contains("changed")), "a title changes no ray");
}
