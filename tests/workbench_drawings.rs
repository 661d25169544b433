//! The drawings of the workbench as a person uses them: seen, heard, clicked, dragged, and turned by keys.
#![cfg(feature = "workbench")]

mod hands;

use egui::accesskit::Role;
use egui::{Event, Key, Pos2, Rect, Vec2};
use egui_kittest::kittest::{NodeT, Queryable};
use hands::*;
use rayscope::app::Pane;
use rayscope::record::What;
use rayscope::view::{Drawing, Form, Theme, csg_bars, significant};

/// The name of a panel's drawing.
const fn drawing_of(pane: Pane) -> &'static str {
    match pane {
        Pane::Overview => "Overview",
        Pane::Generic => "Generic coordinates",
        Pane::Intervals => "Interval lists",
        Pane::Snell => "Snell",
        Pane::Shading => "Shading",
        Pane::Planes => "Plane table",
        _ => "Side view",
    }
}

/// Shows a panel and waits for its drawing; gives what is told of it.
fn told(bench: &mut Bench, pane: Pane) -> String {
    reveal(bench, pane);
    let name = drawing_of(pane);
    wait_until(bench, name, |bench| description(bench, name).is_some());
    settle(bench);
    description(bench, name).expect("it was there")
}

fn description(bench: &Bench, name: &str) -> Option<String> {
    bench.query_by_role_and_label(Role::Image, name)?.accesskit_node().description()
}

fn select(bench: &mut Bench, event: u32) {
    workbench_mut(bench).select(event);
    settle(bench);
}

/// Uses a tool of a panel, which is in a menu where there is no room for it beside the tabs.
fn use_tool(bench: &mut Bench, name: &str) {
    if bench.query_by_label(name).is_none() {
        bench.query_all_by_role_and_label(Role::Button, "Tools").last().expect("a menu of tools").click();
        settle(bench);
    }
    bench.get_by_label(name).click();
    settle(bench);
}

/// The first hit is what everything is about.
fn at_the_hit<'a>(scene: &str) -> Bench<'a> {
    let mut bench = open(scene);
    let hit = find(&bench, |what| matches!(what, What::Hit { .. }));
    select(&mut bench, hit);
    bench
}

#[test]
fn every_drawing_has_a_name_and_tells_its_numbers() {
    let mut bench = at_the_hit("optics/glass_cube");
    let hit = workbench(&bench).recording().expect("recorded").tree.event(selected(&bench)).what.clone();
    let What::Hit { t, .. } = hit else { panic!("the first hit is selected") };
    let time = significant(t, 4);
    for (pane, part) in [
        (Pane::Side, time.clone()),
        (Pane::Overview, time.clone()),
        (Pane::Generic, "c = ".to_owned()),
        (Pane::Intervals, time),
        (Pane::Snell, "1.5".to_owned()),
        (Pane::Shading, "transmitted".to_owned()),
        (Pane::Planes, "t_in".to_owned()),
    ] {
        let told = told(&mut bench, pane);
        assert!(told.contains(&part), "{pane:?}: {part}: {told}");
    }
}

#[test]
fn what_there_is_nothing_to_draw_of_says_what_to_select() {
    let mut bench = at_the_hit("hello/sphere");
    reveal(&mut bench, Pane::Snell);
    wait_until(&mut bench, "the sentence", |bench| {
        bench.query_by_label_contains("No light is refracted here").is_some()
    });
}

/// The slider of the sign plot with its rectangle.
fn slider(bench: &Bench) -> (Option<f64>, Rect) {
    let node = bench.get_by_role_and_label(Role::Slider, "t on the ray");
    (node.accesskit_node().numeric_value(), node.rect())
}

fn probe_t(bench: &Bench) -> Option<f64> {
    workbench(bench).recording().expect("recorded").probe_t
}

#[test]
fn t_is_dragged_or_moved_by_keys_and_every_drawing_marks_it() {
    let mut bench = at_the_hit("csg/bowl");
    reveal(&mut bench, Pane::Signs);
    let is_there = |bench: &Bench| bench.query_by_role_and_label(Role::Slider, "t on the ray").is_some();
    wait_until(&mut bench, "the plot", is_there);
    assert_eq!(probe_t(&bench), None);
    let (_, rect) = slider(&bench);
    click(&mut bench, rect.center());
    let first = probe_t(&bench).expect("a click marks a time");
    assert_eq!(slider(&bench).0, Some(first));
    press(&mut bench, Key::ArrowRight);
    let second = probe_t(&bench).expect("it stays marked");
    assert!(second > first, "{first} {second}");
    press(&mut bench, Key::ArrowLeft);
    let back = probe_t(&bench).expect("it stays marked");
    assert!((back - first).abs() < 1e-9 * first.abs().max(1.0));
    let told = told(&mut bench, Pane::Generic);
    assert!(told.contains(&format!("At the marked t = {}", significant(back, 4))), "{told}");
    reveal(&mut bench, Pane::Signs);
    use_tool(&mut bench, "Clear t");
    assert_eq!(probe_t(&bench), None);
}

/// The middle of the text in a drawing that stands for an event other than this one.
fn other_text(drawing: &Drawing, event: u32) -> (u32, Vec2) {
    let text = drawing.marks.iter().find_map(|mark| match (&mark.form, mark.event) {
        (Form::Text(text), Some(id)) if id > event => Some((id, text.frame().middle())),
        _ => None,
    });
    let (id, [x, y]) = text.expect("a node has a name");
    #[expect(clippy::cast_possible_truncation, reason = "screen coordinates are f32")]
    let place = Vec2::new(x as f32, y as f32);
    (id, place)
}

#[test]
fn a_click_on_a_mark_selects_its_event_everywhere() {
    let mut bench = at_the_hit("csg/bowl");
    let object = find(&bench, |what| matches!(what, What::Object { name, .. } if name == "bowl"));
    select(&mut bench, object);
    told(&mut bench, Pane::Intervals);
    let rect = bench.get_by_role_and_label(Role::Image, "Interval lists").rect();
    let recording = workbench(&bench).recording().expect("recorded");
    let size = [f64::from(rect.width().floor()), f64::from(rect.height().floor())];
    let drawing =
        csg_bars(&recording.scene, &recording.tree, object, None, size, Theme::Dark).expect("it is a compound");
    let (event, at) = other_text(&drawing, object);
    click(&mut bench, rect.min + at);
    assert_eq!(selected(&bench), event);
}

#[test]
fn the_plane_table_is_filled_in_row_by_row() {
    let mut bench = at_the_hit("primitives/cube");
    let all = told(&mut bench, Pane::Planes);
    assert!(all.contains("6 of 6 rows"), "{all}");
    let rect = bench.get_by_role_and_label(Role::Image, "Plane table").rect();
    click(&mut bench, rect.left_bottom() + Vec2::new(20.0, -4.0));
    press(&mut bench, Key::ArrowUp);
    press(&mut bench, Key::ArrowUp);
    wait_until(&mut bench, "the fourth row", |bench| {
        description(bench, "Plane table").is_some_and(|told| told.contains("4 of 6 rows"))
    });
    use_tool(&mut bench, "All rows");
    wait_until(&mut bench, "all rows", |bench| {
        description(bench, "Plane table").is_some_and(|told| told.contains("6 of 6 rows"))
    });
}

#[test]
fn the_overview_is_turned_by_dragging_and_by_keys_and_fitted_again() {
    let mut bench = at_the_hit("csg/bowl");
    told(&mut bench, Pane::Overview);
    let rect = bench.get_by_role_and_label(Role::Image, "Overview").rect();
    let is_moved =
        |bench: &Bench| !bench.get_all_by_label("Fit").last().expect("it can be fitted").accesskit_node().is_disabled();
    assert!(!is_moved(&bench));
    let corner: Pos2 = rect.left_top() + Vec2::splat(3.0);
    click(&mut bench, corner);
    press(&mut bench, Key::ArrowRight);
    assert!(is_moved(&bench), "an arrow key turns it");
    bench.get_all_by_label("Fit").last().expect("it can be fitted").click();
    settle(&mut bench);
    assert!(!is_moved(&bench));
    bench.drag_at(rect.center());
    bench.event(Event::PointerMoved(rect.center() + Vec2::new(20.0, 6.0)));
    bench.step();
    bench.drop_at(rect.center() + Vec2::new(40.0, 12.0));
    settle(&mut bench);
    assert!(is_moved(&bench), "dragging turns it");
}
