//! The workbench as a person uses it, found through the names that a screen reader reads out. No window, no GPU.
#![cfg(feature = "workbench")]

mod hands;

use egui::accesskit::Role;
use egui::{Key, Pos2, Vec2};
use egui_kittest::kittest::{NodeT, Queryable};
use hands::*;
use rayscope::app::Pane;
use rayscope::record::{Effect, RayKind, What};
use rayscope::scene::embedded_scene;
use rayscope::story::Level;

/// The names of the buttons that move.
const MOVES: [&str; 7] = ["First", "Back", "Next", "Into", "Over", "Out", "Last"];

#[test]
fn it_opens_with_a_story_on_screen() {
    let bench = open("hello/sphere");
    let scene = workbench(&bench).scene().expect("a scene is open");
    assert_eq!(scene.name, "hello/sphere");
    assert!(bench.query_by_label(&scene.scene.title).is_some());
    assert!(workbench(&bench).recording().is_some());
    assert!(!rows(&bench).is_empty());
}

#[test]
fn the_first_of_the_scenes_pixels_is_recorded_at_once() {
    let bench = open("csg/bowl");
    let scene = workbench(&bench).scene().expect("a scene is open");
    assert_eq!(pixel(&bench), scene.scene.pixels[0]);
}

#[test]
fn the_picture_is_rendered_in_the_background_until_it_is_complete() {
    let mut bench = open("hello/sphere");
    wait_until(&mut bench, "the picture", |bench| workbench(bench).picture_finished());
    settle(&mut bench);
    let image = workbench(&bench).scene().expect("a scene is open").scene.image;
    assert!(bench.query_by_label(&format!("{} × {}", image.width, image.height)).is_some());
}

#[test]
fn a_click_on_a_pixel_shows_its_six_steps() {
    let mut bench = open("csg/bowl");
    let target = [workbench(&bench).scene().expect("a scene is open").scene.pixels[0][0] + 7, 200];
    let at = place_of(&bench, target);
    click(&mut bench, at);
    let recorded = pixel(&bench);
    assert!(recorded[0].abs_diff(target[0]) <= 1 && recorded[1].abs_diff(target[1]) <= 1, "{recorded:?} {target:?}");
    let recording = workbench(&bench).recording().expect("a pixel is recorded");
    let steps = recording.tree.children(0).filter(|event| matches!(event.what, What::Step { .. })).count();
    assert_eq!(steps, 6);
    tell(&mut bench, Level::Working);
    let levels = bench.query_all_by_role(Role::TreeItem).filter(|row| row.accesskit_node().level() == Some(2)).count();
    assert!(levels >= 4, "the steps are rows of the second level; {levels} are on screen");
}

#[test]
fn the_arrow_keys_go_to_the_neighbouring_pixels() {
    let mut bench = open("hello/sphere");
    let at = place_of(&bench, [100, 100]);
    click(&mut bench, at);
    let [x, y] = pixel(&bench);
    press(&mut bench, Key::ArrowRight);
    press(&mut bench, Key::ArrowRight);
    press(&mut bench, Key::ArrowDown);
    assert_eq!(pixel(&bench), [x + 2, y + 1]);
    press(&mut bench, Key::ArrowLeft);
    press(&mut bench, Key::ArrowUp);
    assert_eq!(pixel(&bench), [x + 1, y]);
}

#[test]
fn the_arrow_keys_stop_at_the_edge_of_the_picture() {
    let mut bench = open("hello/sphere");
    let at = place_of(&bench, [0, 0]);
    click(&mut bench, at);
    press(&mut bench, Key::ArrowLeft);
    press(&mut bench, Key::ArrowUp);
    assert_eq!(pixel(&bench), [0, 0]);
}

#[test]
fn the_step_keys_move_the_selection() {
    let mut bench = open("csg/bowl");
    tell(&mut bench, Level::Everything);
    press(&mut bench, Key::Home);
    assert_eq!(selected(&bench), 0);
    press(&mut bench, Key::N);
    assert_eq!(selected(&bench), 1);
    press(&mut bench, Key::B);
    assert_eq!(selected(&bench), 0);
    press(&mut bench, Key::I);
    assert_eq!(selected(&bench), 1);
    press(&mut bench, Key::V);
    let second_step = find(&bench, |what| matches!(what, What::Step { number: 2, .. }));
    assert_eq!(selected(&bench), second_step);
    press(&mut bench, Key::O);
    assert_eq!(selected(&bench), 0);
    press(&mut bench, Key::End);
    assert_eq!(selected(&bench), workbench(&bench).recording().expect("recorded").tree.end() - 1);
}

#[test]
fn the_step_buttons_do_what_the_keys_do_and_say_where_they_are() {
    let mut bench = open("csg/bowl");
    tell(&mut bench, Level::Everything);
    let events = workbench(&bench).recording().expect("recorded").tree.end();
    for (name, place) in [("First", 1), ("Next", 2), ("Back", 1), ("Into", 2), ("Out", 1), ("Last", events)] {
        bench.get_by_role_and_label(Role::Button, name).click();
        settle(&mut bench);
        assert!(bench.query_by_label(&format!("step {place} of {events}")).is_some(), "after {name}");
    }
    assert!(bench.get_by_role_and_label(Role::Button, "Next").accesskit_node().is_disabled());
    for name in MOVES {
        assert!(bench.query_by_role_and_label(Role::Button, name).is_some(), "{name}");
    }
}

#[test]
fn selecting_a_row_shows_its_detail() {
    let mut bench = open("hello/sphere");
    press(&mut bench, Key::Home);
    let row = row_of(&bench, "as written");
    bench.get_by_label(&row).click();
    settle(&mut bench);
    let written = find(&bench, |what| matches!(what, What::Written { .. }));
    assert_eq!(selected(&bench), written);
    let source = workbench(&bench).recording().expect("recorded").tree.event(written).source;
    assert!(bench.query_by_label(&format!("Computed in {}:{}", source.file, source.line)).is_some());
    assert_eq!(bench.get_by_label(&row).accesskit_node().is_selected(), Some(true));
}

#[test]
fn a_formula_is_shown_with_its_result() {
    let mut bench = open("hello/sphere");
    let (id, line) = {
        let tree = &workbench(&bench).recording().expect("recorded").tree;
        let event = tree.events.iter().find(|event| !event.working.is_empty()).expect("something was worked out");
        (event.id, event.working[0].clone())
    };
    bench.state_mut().as_mut().expect("shown").select(id);
    settle(&mut bench);
    assert!(bench.query_all_by_label(&format!("{} = {}", line.symbol, line.formula)).count() >= 1);
    assert!(bench.query_all_by_label(&format!("  = {}", line.result)).count() >= 1);
}

#[test]
fn stepping_into_folded_working_opens_it() {
    let mut bench = open("hello/sphere");
    let inner = find(&bench, |what| matches!(what, What::Implicit { .. }));
    bench.state_mut().as_mut().expect("shown").select(inner);
    settle(&mut bench);
    assert!(rows(&bench).iter().any(|row| row.contains("d(t)")), "{:?}", rows(&bench));
}

#[test]
fn arrow_keys_fold_and_open_rows_and_move_between_them() {
    let mut bench = open("hello/sphere");
    tell(&mut bench, Level::Working);
    let first_step = row_of(&bench, "Build");
    bench.get_by_label(&first_step).click();
    settle(&mut bench);
    let count = rows(&bench).len();
    let here = selected(&bench);
    press(&mut bench, Key::ArrowLeft);
    assert!(rows(&bench).len() < count, "the step is folded");
    press(&mut bench, Key::ArrowRight);
    assert_eq!(rows(&bench).len(), count);
    press(&mut bench, Key::ArrowDown);
    assert!(selected(&bench) > here);
    press(&mut bench, Key::ArrowUp);
    assert_eq!(selected(&bench), here);
    press(&mut bench, Key::ArrowLeft);
    press(&mut bench, Key::ArrowLeft);
    assert_eq!(selected(&bench), 0, "a folded row leads to what it is a part of");
}

#[test]
fn folding_what_holds_the_selection_selects_the_fold() {
    let mut bench = open("hello/sphere");
    press(&mut bench, Key::End);
    let root = row_of(&bench, "Pixel");
    let rect = bench.get_by_label(&root).rect();
    click(&mut bench, rect.left_center() + Vec2::new(10.0, 0.0));
    assert_eq!(rows(&bench), [root]);
    assert_eq!(selected(&bench), 0);
}

#[test]
fn another_scene_brings_its_own_title_and_story() {
    let mut bench = open("csg/bowl");
    bench.get_by_label_contains("Scene: csg/bowl").click();
    settle(&mut bench);
    let title = {
        let text = embedded_scene("hello/sphere").expect("embedded").text;
        rayscope::scene::load(text, "hello/sphere").expect("a good scene").title
    };
    bench.get_by_role_and_label(Role::Button, &title).click();
    settle(&mut bench);
    assert_eq!(workbench(&bench).scene().expect("a scene is open").name, "hello/sphere");
    assert!(bench.query_by_label(&title).is_some());
    wait_until(&mut bench, "the new picture", |bench| workbench(bench).picture_finished());
}

#[test]
fn a_broken_scene_shows_all_its_errors_and_the_old_one_stays() {
    let mut bench = open("hello/sphere");
    let context = bench.ctx.clone();
    let broken = r#"{ "title": "Broken", "objects": [ { "shape": "shpere" }, { "shape": "torus", "d": -1 } ] }"#;
    bench.state_mut().as_mut().expect("shown").open_text(&context, "broken.json", broken);
    settle(&mut bench);
    assert!(bench.query_by_label_contains("broken.json cannot be opened. hello/sphere stays open.").is_some());
    let message = &workbench(&bench).problem().expect("a problem").text;
    assert!(message.contains("shpere") && message.contains("sphere"), "{message}");
    assert!(bench.query_by_label_contains("shpere").is_some());
    assert_eq!(workbench(&bench).scene().expect("a scene is open").name, "hello/sphere");
    bench.get_by_label("Close").click();
    settle(&mut bench);
    assert!(workbench(&bench).problem().is_none());
}

#[test]
fn a_scene_stays_open_until_the_next_one_is_there_and_another_takes_the_place_of_one_that_is_being_opened() {
    let mut bench = open("hello/sphere");
    let context = bench.ctx.clone();
    let name = |bench: &Bench| workbench(bench).scene().expect("a scene is open").name.clone();
    workbench_mut(&mut bench).open_scene(&context, "csg/bowl");
    assert!(workbench(&bench).is_opening());
    assert_eq!(name(&bench), "hello/sphere");
    workbench_mut(&mut bench).open_scene(&context, "optics/fishbowl");
    let mut names = vec![name(&bench)];
    while workbench(&bench).is_opening() {
        bench.step();
        names.push(name(&bench));
    }
    names.dedup();
    assert_eq!(names, ["hello/sphere", "optics/fishbowl"]);
}

#[test]
fn what_is_typed_while_another_scene_is_opened_is_not_lost() {
    let mut bench = open("hello/sphere");
    let context = bench.ctx.clone();
    workbench_mut(&mut bench).put_cursor(2);
    settle(&mut bench);
    // So much to read takes longer than typing.
    let long = " ".repeat(20_000_000) + embedded_scene("csg/bowl").expect("the scene is embedded").text;
    workbench_mut(&mut bench).open_text(&context, "csg/bowl", &long);
    bench.event(egui::Event::Text(" ".to_owned()));
    settle(&mut bench);
    assert!(bench.query_by_label("Save the changes to hello/sphere?").is_some());
    assert_eq!(workbench(&bench).scene().expect("a scene is open").name, "hello/sphere");
}

#[test]
fn a_missing_file_is_named_and_the_old_scene_stays() {
    let mut bench = open("hello/sphere");
    let context = bench.ctx.clone();
    bench.state_mut().as_mut().expect("shown").open_scene(&context, "no/such/file.json");
    settle(&mut bench);
    assert!(bench.query_by_label_contains("no/such/file.json cannot be opened").is_some());
}

#[derive(Debug)]
struct Dropped {
    path: std::path::PathBuf,
    bytes: Vec<u8>,
}

impl egui::DroppedFile for Dropped {
    fn path(&self) -> &std::path::Path {
        &self.path
    }

    fn bytes(&self) -> Result<Vec<u8>, String> {
        Ok(self.bytes.clone())
    }
}

fn drop_file(bench: &mut Bench, name: &str, bytes: &[u8]) {
    let file = Dropped { path: name.into(), bytes: bytes.to_vec() };
    bench.input_mut().dropped_files.push(std::sync::Arc::new(file));
    settle(bench);
}

#[test]
fn a_dropped_file_is_opened() {
    let mut bench = open("hello/sphere");
    let text = embedded_scene("csg/bowl").expect("embedded").text;
    drop_file(&mut bench, "mine.json", text.as_bytes());
    assert_eq!(workbench(&bench).scene().expect("a scene is open").name, "mine.json");
}

#[test]
fn a_dropped_file_that_is_no_text_is_refused() {
    let mut bench = open("hello/sphere");
    drop_file(&mut bench, "picture.png", &[0xff, 0xfe, 0x00]);
    assert!(bench.query_by_label_contains("picture.png cannot be opened").is_some());
    assert_eq!(workbench(&bench).scene().expect("a scene is open").name, "hello/sphere");
}

#[test]
fn hovering_reads_the_pixel() {
    let mut bench = open("hello/sphere");
    let image = workbench(&bench).scene().expect("a scene is open").scene.image;
    let middle = [image.width / 2, image.height / 2];
    let at = place_of(&bench, middle);
    bench.hover_at(at);
    settle(&mut bench);
    let text = format!("({}, {}) · ball · linear", middle[0], middle[1]);
    assert!(bench.query_by_label_contains(&text).is_some());
    let corner = place_of(&bench, [0, 0]);
    bench.hover_at(corner);
    settle(&mut bench);
    let readings: Vec<_> = bench.query_all_by_label_contains("· linear").filter_map(|node| node.value()).collect();
    assert!(readings.iter().any(|reading| reading.starts_with("(0, 0) · ")), "{readings:?}");
}

#[test]
fn the_side_view_and_the_plots_are_drawn() {
    let mut bench = open("csg/bowl");
    let node = find(&bench, |what| matches!(what, What::Combine { .. }));
    bench.state_mut().as_mut().expect("shown").select(node);
    wait_until(&mut bench, "the interval bars", |bench| bench.query_by_label("Interval bars").is_some());
    assert!(bench.query_by_role_and_label(Role::Image, "Side view").is_some());
}

#[test]
fn dragging_moves_the_side_view_and_fit_brings_it_back() {
    let mut bench = open("csg/bowl");
    let fit_is_offered =
        |bench: &Bench| !bench.get_by_role_and_label(Role::Button, "Fit").accesskit_node().is_disabled();
    assert!(!fit_is_offered(&bench));
    let middle = bench.get_by_role_and_label(Role::Image, "Side view").rect().center();
    bench.hover_at(middle);
    bench.drag_at(middle);
    settle(&mut bench);
    bench.hover_at(middle + Vec2::new(40.0, 10.0));
    settle(&mut bench);
    bench.drop_at(middle + Vec2::new(40.0, 10.0));
    settle(&mut bench);
    assert!(fit_is_offered(&bench));
    bench.get_by_role_and_label(Role::Button, "Fit").click();
    settle(&mut bench);
    assert!(!fit_is_offered(&bench));
}

#[test]
fn every_embedded_scene_can_be_stepped_through_without_a_missing_glyph() {
    for scene in rayscope::scene::embedded_scenes() {
        let mut bench = open(&scene.name);
        let end = workbench(&bench).recording().expect("recorded").tree.end();
        // A prime stride visits every kind of event in a few hundred frames.
        for id in (0..end).step_by((end as usize / 40).max(1)) {
            bench.state_mut().as_mut().expect("shown").select(id);
            bench.step();
        }
    }
}

#[test]
fn an_effect_that_is_switched_off_leaves_the_picture_and_the_story() {
    let mut bench = open("hello/sphere");
    let has_shadows = |bench: &Bench| {
        let recording = workbench(bench).recording().expect("recorded");
        let is_shadow = |what: &What| matches!(what, What::Ray { ray: RayKind::Shadow, .. });
        (
            workbench(bench).scene().expect("open").scene.effects.has(Effect::Shadows),
            recording.tree.events.iter().any(|event| is_shadow(&event.what)),
        )
    };
    assert_eq!(has_shadows(&bench), (true, true));
    reveal(&mut bench, Pane::Effects);
    settle(&mut bench);
    bench.get_by_role_and_label(Role::CheckBox, "shadows").click();
    settle(&mut bench);
    assert_eq!(has_shadows(&bench), (false, false));
    wait_until(&mut bench, "the picture without shadows", |bench| workbench(bench).picture_finished());
    assert!(bench.query_by_label_contains("without shadows").is_some());
    wait_until(&mut bench, "the ledger", |bench| bench.query_by_label_contains("each price is the median").is_some());
    bench.get_by_role_and_label(Role::CheckBox, "shadows").click();
    settle(&mut bench);
    assert_eq!(has_shadows(&bench), (true, true));
}

#[test]
fn no_panel_reaches_beyond_the_window_at_the_usual_sizes() {
    for size in [Vec2::new(1280.0, 800.0), Vec2::new(1920.0, 1080.0), Vec2::new(960.0, 600.0)] {
        let bench = open_at("csg/bowl", size);
        let window = egui::Rect::from_min_size(Pos2::ZERO, size);
        let picture = bench.get_by_label("Rendered image").rect();
        assert!(window.contains_rect(picture), "{size:?}: {picture:?}");
        for name in MOVES {
            let button = bench.get_by_role_and_label(Role::Button, name).rect();
            assert!(window.contains_rect(button) && !button.intersects(picture), "{size:?} {name}: {button:?}");
        }
    }
}

#[test]
fn a_scene_that_is_opened_again_has_its_hit_object_to_edit_again() {
    let mut bench = open("csg/bowl");
    let edited = workbench(&bench).edited();
    assert!(edited.is_some(), "the story stands at a hit");
    let ctx = bench.ctx.clone();
    workbench_mut(&mut bench).open_scene(&ctx, "csg/bowl");
    settle(&mut bench);
    assert_eq!(workbench(&bench).edited(), edited);
}
