//! Stepping through a story as a person does: levels, filters, breakpoints, playing, the timeline, and what was left out.
#![cfg(feature = "workbench")]

mod hands;

use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, Vec2};
use egui_kittest::kittest::{NodeT, Queryable};
use hands::*;
use rayscope::app::{Command, Pane, Preset, StepCommand, ViewCommand};
use rayscope::query::Query;
use rayscope::record::{RayKind, What};
use rayscope::story::{Filter, Kind, Level, Step};

fn story_rows(bench: &Bench) -> usize {
    workbench(bench).recording().expect("a pixel is recorded").story().outline().len()
}

fn go(bench: &mut Bench, step: Step) {
    run(bench, Command::Step(StepCommand::Move(step)));
}

fn type_text(bench: &mut Bench, text: &str) {
    bench.event(Event::Text(text.to_owned()));
    settle(bench);
}

fn press_with(bench: &mut Bench, modifiers: Modifiers, key: Key) {
    bench.key_press_modifiers(modifiers, key);
    settle(bench);
}

fn what(bench: &Bench) -> What {
    let recording = workbench(bench).recording().expect("a pixel is recorded");
    recording.tree.event(recording.selected()).what.clone()
}

#[test]
fn a_plain_ray_is_told_in_a_few_rows_and_each_level_tells_more() {
    let mut bench = open("hello/sphere");
    let story = story_rows(&bench);
    assert!((5..=9).contains(&story), "{:?}", rows(&bench));
    let mut before = story;
    for name in ["Working", "Everything"] {
        bench.get_by_role_and_label(Role::Button, name).click();
        settle(&mut bench);
        run(&mut bench, Command::Step(StepCommand::OpenAll));
        assert!(story_rows(&bench) > before, "{name}");
        before = story_rows(&bench);
    }
    assert_eq!(before, workbench(&bench).recording().expect("recorded").tree.events.len());
    press(&mut bench, Key::Num1);
    assert_eq!(story_rows(&bench), story);
}

#[test]
fn a_row_says_how_much_it_holds_that_has_no_row() {
    let bench = open("csg/bowl");
    let root = row_of(&bench, "Pixel");
    let node = bench.get_by_label(&root);
    let description = node.accesskit_node().description().expect("the pixel's events are not all told");
    assert!(description.contains("more inside"), "{description}");
}

#[test]
fn an_event_of_a_finer_level_gets_a_row_while_it_is_selected() {
    let mut bench = open("csg/bowl");
    let before = story_rows(&bench);
    let inner = find(&bench, |what| matches!(what, What::Quadratic { .. }));
    workbench_mut(&mut bench).select(inner);
    settle(&mut bench);
    assert_eq!(story_rows(&bench), before + 1);
    let row = row_of(&bench, "quadratic");
    let description = bench.get_by_label(&row).accesskit_node().description().expect("it says why it is there");
    assert!(description.contains("shown because it is selected"), "{description}");
    go(&mut bench, Step::Next);
    assert_eq!(story_rows(&bench), before);
}

#[test]
fn words_are_looked_for_and_hidden_rows_are_counted() {
    let mut bench = open("csg/bowl");
    tell(&mut bench, Level::Everything);
    press(&mut bench, Key::Slash);
    type_text(&mut bench, "extent missed");
    let story = || workbench(&bench).recording().expect("recorded").story();
    let missed = story().tree().events.iter().filter(|event| matches!(event.what, What::Extent { inside: None, .. }));
    let (missed, all) = (missed.count(), story().tree().events.len());
    let balls = story().shown().steps().len();
    assert!(missed > 0 || balls == 0);
    assert_eq!(balls, missed);
    let hidden = all - story().shown().rows().len();
    let words = format!("{hidden} rows hidden by the filter");
    assert!(bench.query_by_label_contains(&words).is_some(), "{words}");
    bench.get_by_role_and_label(Role::Button, "Clear the filter").click();
    settle(&mut bench);
    assert_eq!(workbench(&bench).recording().expect("recorded").story().shown().rows().len(), all);
}

#[test]
fn a_filter_by_ray_steps_from_one_reflected_event_to_the_next() {
    let mut bench = open("optics/glass_cube");
    tell(&mut bench, Level::Everything);
    let filter = Filter { rays: [RayKind::Reflected].into(), ..Filter::default() };
    workbench_mut(&mut bench).set_filter(filter);
    settle(&mut bench);
    press(&mut bench, Key::Home);
    for _ in 0..20 {
        let recording = workbench(&bench).recording().expect("recorded");
        assert_eq!(recording.story().index().scope(recording.selected()).kind, RayKind::Reflected);
        press(&mut bench, Key::N);
    }
}

#[test]
fn a_step_is_reached_by_its_number_and_one_that_there_is_not_is_refused() {
    let mut bench = open("csg/bowl");
    tell(&mut bench, Level::Everything);
    press_with(&mut bench, Modifiers::COMMAND, Key::G);
    type_text(&mut bench, "42");
    press(&mut bench, Key::Enter);
    assert_eq!(selected(&bench), 41);
    assert!(bench.query_by_label("Go to step").is_none(), "the field goes away");
    press_with(&mut bench, Modifiers::COMMAND, Key::G);
    type_text(&mut bench, "999999");
    press(&mut bench, Key::Enter);
    assert_eq!(selected(&bench), 41);
    assert!(bench.query_by_label("There is no step of that number.").is_some());
}

#[test]
fn the_same_kind_and_any_kind_are_reached() {
    let mut bench = open("csg/bowl");
    tell(&mut bench, Level::Everything);
    let first = find(&bench, |what| matches!(what, What::Primitive { .. }));
    workbench_mut(&mut bench).select(first);
    press(&mut bench, Key::K);
    assert!(selected(&bench) > first && matches!(what(&bench), What::Primitive { .. }));
    press_with(&mut bench, Modifiers::SHIFT, Key::K);
    assert_eq!(selected(&bench), first);
    bench.get_by_role_and_label(Role::Button, "To a kind").click();
    settle(&mut bench);
    bench.get_by_label_contains("primitive ·").click();
    settle(&mut bench);
    assert!(selected(&bench) > first && matches!(what(&bench), What::Primitive { .. }));
}

#[test]
fn a_breakpoint_stops_at_the_first_early_out_whatever_the_level() {
    let mut bench = open("csg/bowl");
    press_with(&mut bench, Modifiers::COMMAND, Key::B);
    bench.get_by_role_and_label(Role::CheckBox, "An early out in a Boolean tree").click();
    settle(&mut bench);
    press(&mut bench, Key::Home);
    press(&mut bench, Key::C);
    let first = find(&bench, |what| matches!(what, What::Combine { early_out: Some(_), .. }));
    assert_eq!(selected(&bench), first);
    let row = row_of(&bench, "early out");
    let description = bench.get_by_label(&row).accesskit_node().description().unwrap_or_default();
    assert!(description.contains("breakpoint"), "{description}");
}

#[test]
fn a_new_breakpoint_is_a_question_and_what_is_none_is_explained() {
    let mut bench = open("csg/bowl");
    press_with(&mut bench, Modifiers::COMMAND, Key::B);
    type_text(&mut bench, "hit & object=");
    press(&mut bench, Key::Enter);
    let problem = "hit & object=".parse::<Query>().expect_err("there is no name").to_string();
    assert!(bench.query_by_label(&problem).is_some(), "{problem}");
    for _ in 0.."hit & object=".len() {
        press(&mut bench, Key::Backspace);
    }
    type_text(&mut bench, "hit");
    bench.get_by_role_and_label(Role::Button, "Add").click();
    settle(&mut bench);
    assert!(workbench(&bench).stepping().breakpoints().any_enabled());
    bench.get_by_role_and_label(Role::Button, "Remove hit").scroll_to_me();
    settle(&mut bench);
    bench.get_by_role_and_label(Role::Button, "Remove hit").click();
    settle(&mut bench);
    assert!(!workbench(&bench).stepping().breakpoints().any_enabled());
}

#[test]
fn the_next_pixel_that_stops_is_found_and_stands_at_its_stop() {
    let mut bench = open("hello/sphere");
    let at = place_of(&bench, [0, 0]);
    click(&mut bench, at);
    workbench_mut(&mut bench).change_breakpoints(|list, tree| list.add("hit=ball", tree)).expect("a question");
    press(&mut bench, Key::U);
    wait_until(&mut bench, "the pixel", |bench| !workbench(bench).is_busy());
    settle(&mut bench);
    assert!(matches!(what(&bench), What::Hit { object, .. } if object == "ball"));
    let found = pixel(&bench);
    let scene = workbench(&bench).scene().expect("open").scene.clone();
    let question: Query = "hit=ball".parse().expect("a question");
    let before = (0..found[0]).map(|x| [x, found[1]]).chain([[0, found[1].saturating_sub(1)]]);
    for [x, y] in before {
        assert_eq!(question.first(&rayscope::trace::record_pixel(&scene, x, y)), None, "({x}, {y}) comes before");
    }
}

#[test]
fn without_a_breakpoint_that_is_on_the_search_says_what_to_do() {
    let mut bench = open("hello/sphere");
    press(&mut bench, Key::U);
    assert!(bench.query_by_label("Switch on a breakpoint first.").is_some());
    bench.get_by_role_and_label(Role::Button, "Close the message").click();
    settle(&mut bench);
    assert!(bench.query_by_label("Switch on a breakpoint first.").is_none());
}

#[test]
fn playing_makes_steps_by_itself_until_the_end() {
    let mut bench = open("hello/sphere");
    press(&mut bench, Key::Home);
    assert!(bench.query_by_label("2 a second").is_some());
    press(&mut bench, Key::Period);
    assert!(bench.query_by_label("5 a second").is_some());
    press(&mut bench, Key::Comma);
    bench.get_by_role_and_label(Role::Button, "Play").click();
    bench.step();
    bench.step();
    assert!(workbench(&bench).stepping().is_playing());
    assert!(bench.query_by_role_and_label(Role::Button, "Pause").is_some());
    let before = selected(&bench);
    for _ in 0..4 {
        bench.step();
    }
    assert!(selected(&bench) > before, "a second has passed in four frames, at two steps a second");
    wait_until(&mut bench, "the end", |bench| !workbench(bench).stepping().is_playing());
    let story = workbench(&bench).recording().expect("recorded").story();
    assert_eq!(Some(&selected(&bench)), story.shown().steps().last());
}

#[test]
fn playing_stops_at_a_breakpoint() {
    let mut bench = open("csg/bowl");
    workbench_mut(&mut bench).change_breakpoints(|list, tree| list.add("hit", tree)).expect("a question");
    press(&mut bench, Key::Home);
    press(&mut bench, Key::P);
    wait_until(&mut bench, "the stop", |bench| !workbench(bench).stepping().is_playing());
    assert_eq!(selected(&bench), find(&bench, |what| matches!(what, What::Hit { .. })));
}

#[test]
fn the_timeline_is_a_slider_that_is_clicked_dragged_and_stepped() {
    let mut bench = open("csg/bowl");
    let rect = bench.get_by_role_and_label(Role::Slider, "Timeline").rect();
    let at = rect.right_bottom() - Vec2::new(3.0, 6.0);
    click(&mut bench, at);
    let events = workbench(&bench).recording().expect("recorded").tree.end();
    assert_eq!(selected(&bench), events - 1);
    let node = bench.get_by_role_and_label(Role::Slider, "Timeline").accesskit_node().numeric_value();
    assert_eq!(node, Some(f64::from(events)));
    bench.drag_at(at);
    let middle = rect.center_bottom() - Vec2::new(0.0, 6.0);
    bench.hover_at(middle);
    settle(&mut bench);
    bench.drop_at(middle);
    settle(&mut bench);
    assert!(selected(&bench).abs_diff(events / 2) < events / 8, "{} of {events}", selected(&bench));
    wait_until(&mut bench, "the strip", |bench| {
        let strip = bench.get_by_role_and_label(Role::Slider, "Timeline");
        strip.accesskit_node().description().is_some_and(|words| words.starts_with("Timeline of"))
    });
}

#[test]
fn the_timeline_takes_no_more_room_than_there_is_something_in_it() {
    let [low, high] = ["hello/sphere", "spectrum/prism"].map(|scene| {
        let bench = open(scene);
        bench.get_by_role_and_label(Role::Slider, "Timeline").rect().height()
    });
    assert!(low < 75.0, "two lanes need little: {low}");
    assert!(high > low && high <= 108.0, "many lanes share what there is: {high}");
}

#[test]
fn what_was_left_out_is_listed_with_its_reason_and_leads_to_its_event() {
    let mut bench = open("csg/bowl");
    press(&mut bench, Key::L);
    bench.get_by_label_contains("ended early").click();
    settle(&mut bench);
    let event = find(&bench, |what| matches!(what, What::Combine { early_out: Some(_), .. }));
    let reason = {
        let recording = workbench(&bench).recording().expect("recorded");
        let What::Combine { early_out: Some(reason), .. } = &recording.tree.event(event).what else { unreachable!() };
        reason.clone()
    };
    bench.get_all_by_label_contains(&reason).next().expect("the reason is said").click();
    settle(&mut bench);
    assert_eq!(selected(&bench), event);
}

#[test]
fn the_level_and_the_filter_hold_for_the_next_pixel_too() {
    let mut bench = open("csg/bowl");
    tell(&mut bench, Level::Working);
    let filter = Filter { kinds: [Kind::Primitive].into(), ..Filter::default() };
    workbench_mut(&mut bench).set_filter(filter.clone());
    let at = place_of(&bench, [40, 400]);
    click(&mut bench, at);
    let story = workbench(&bench).recording().expect("recorded").story();
    assert_eq!((story.level(), story.filter()), (Level::Working, &filter));
}

#[test]
fn every_button_of_the_story_stays_inside_its_panel_at_every_size_and_in_both_languages() {
    for size in [Vec2::new(960.0, 600.0), Vec2::new(1280.0, 800.0), Vec2::new(1920.0, 1080.0)] {
        for language in rayscope::words::Language::ALL {
            let mut bench = open_at("csg/bowl", size);
            run(&mut bench, Command::View(rayscope::app::ViewCommand::Language(language)));
            let window = egui::Rect::from_min_size(egui::Pos2::ZERO, size);
            let names = [StepCommand::Play, StepCommand::Filter, StepCommand::Breakpoints, StepCommand::Jump];
            for command in names {
                use rayscope::app::Commands as _;
                let name = rayscope::words::say(language, command.word());
                let rect = bench.get_by_role_and_label(Role::Button, &name).rect();
                assert!(window.contains_rect(rect), "{size:?} {name}: {rect:?}");
            }
            assert!(!rows(&bench).is_empty());
        }
    }
}

#[test]
fn a_row_that_is_seen_whole_is_not_said_again_under_the_pointer() {
    let mut bench = open_at("csg/bowl", Vec2::new(1920.0, 1080.0));
    tell(&mut bench, Level::Working);
    let text = row_of(&bench, "Compute the hit point");
    let at = bench.get_by_role_and_label(Role::TreeItem, &text).rect().center();
    bench.event(Event::PointerMoved(at));
    for _ in 0..40 {
        bench.step();
    }
    assert_eq!(bench.query_all_by_label(&text).count(), 1, "the row alone says it");
}

#[test]
fn the_selected_row_stays_in_sight_when_the_story_gets_the_window_to_itself_and_gives_it_back() {
    let mut bench = open("optics/fishbowl");
    tell(&mut bench, Level::Working);
    let is_seen = |bench: &Bench| {
        let mut rows = bench.query_all_by_role(Role::TreeItem);
        rows.any(|row| row.accesskit_node().is_selected() == Some(true))
    };
    reveal(&mut bench, Pane::Story);
    press(&mut bench, Key::End);
    assert!(is_seen(&bench));
    run(&mut bench, Command::View(ViewCommand::Alone));
    assert!(!workbench(&bench).dock().shows(Pane::Picture));
    assert!(is_seen(&bench), "alone");
    press(&mut bench, Key::Home);
    assert!(is_seen(&bench), "at the beginning");
    run(&mut bench, Command::View(ViewCommand::Alone));
    assert!(workbench(&bench).dock().shows(Pane::Picture));
    assert!(is_seen(&bench), "together again");
}

#[test]
fn whatever_drawer_is_open_rows_of_the_story_are_seen() {
    for preset in Preset::ALL {
        let mut bench = open("optics/fishbowl");
        run(&mut bench, Command::View(ViewCommand::Layout(preset)));
        reveal(&mut bench, Pane::Story);
        for command in [StepCommand::Filter, StepCommand::Breakpoints, StepCommand::LeftOut, StepCommand::Jump] {
            run(&mut bench, Command::Step(command));
            assert!(!rows(&bench).is_empty(), "{preset:?}, {command:?}");
        }
    }
}
