//! Layouts, panels, commands, keys, help and settings, as a person uses them.
#![cfg(feature = "workbench")]

mod hands;

use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, Vec2};
use egui_kittest::kittest::{NodeT, Queryable};
use hands::*;
use rayscope::app::{Command, EditCommand, HelpCommand, Pane, Preset, SceneCommand, ViewCommand};
use rayscope::words::Language;

fn press_with(bench: &mut Bench, modifiers: Modifiers, key: Key) {
    bench.key_press_modifiers(modifiers, key);
    settle(bench);
}

fn type_text(bench: &mut Bench, text: &str) {
    bench.event(Event::Text(text.to_owned()));
    settle(bench);
}

fn click_button(bench: &mut Bench, name: &str) {
    bench.get_by_role_and_label(Role::Button, name).click();
    settle(bench);
}

#[test]
fn each_layout_shows_its_panels_and_is_kept_as_it_was_left() {
    let mut bench = open("hello/sphere");
    assert!(workbench(&bench).dock().shows(Pane::Story));
    click_button(&mut bench, "Measure");
    assert_eq!(workbench(&bench).dock().preset(), Preset::Measure);
    assert!(workbench(&bench).dock().shows(Pane::Accuracy));
    click_button(&mut bench, "Learn");
    assert!(workbench(&bench).dock().shows(Pane::Detail));
    run(&mut bench, ViewCommand::Pane(Pane::Detail));
    assert!(!workbench(&bench).dock().holds(Pane::Detail));
    let kept = workbench(&bench).keep();
    let mut next = open("hello/sphere");
    workbench_mut(&mut next).take_up(&kept);
    settle(&mut next);
    assert!(!workbench(&next).dock().holds(Pane::Detail));
    run(&mut next, ViewCommand::ResetLayout);
    assert!(workbench(&next).dock().shows(Pane::Detail));
}

#[test]
fn every_panel_can_be_shown_in_every_language_without_a_missing_glyph() {
    // The harness panics where a glyph is missing or two things have one name.
    for language in Language::ALL {
        let mut bench = open("csg/bowl");
        run(&mut bench, ViewCommand::Language(language));
        for pane in Pane::ALL {
            reveal(&mut bench, pane);
            assert!(workbench(&bench).dock().shows(pane), "{pane:?}");
        }
        for preset in Preset::ALL {
            run(&mut bench, ViewCommand::Layout(preset));
        }
    }
}

#[test]
fn f6_goes_round_the_panels_and_f11_gives_one_the_window() {
    let mut bench = open("hello/sphere");
    press(&mut bench, Key::F6);
    let first = workbench(&bench).dock().current().expect("F6 chose a panel");
    press(&mut bench, Key::F6);
    let second = workbench(&bench).dock().current().expect("F6 chose a panel");
    assert_ne!(first, second);
    press_with(&mut bench, Modifiers::SHIFT, Key::F6);
    assert_eq!(workbench(&bench).dock().current(), Some(first));
    press(&mut bench, Key::F11);
    assert!(workbench(&bench).dock().shows(first) && !workbench(&bench).dock().shows(second));
    click_button(&mut bench, "Back to all panels");
    assert!(workbench(&bench).dock().shows(second));
}

#[test]
fn the_palette_finds_a_command_by_a_few_letters_and_enter_runs_it() {
    let mut bench = open("hello/sphere");
    press_with(&mut bench, Modifiers::COMMAND, Key::K);
    type_text(&mut bench, "high contrast");
    press(&mut bench, Key::Enter);
    assert!(workbench(&bench).settings().is_high_contrast);
    press_with(&mut bench, Modifiers::COMMAND, Key::K);
    type_text(&mut bench, "csg/lens");
    press(&mut bench, Key::Enter);
    assert_eq!(workbench(&bench).scene().expect("a scene is open").name, "csg/lens");
}

#[test]
fn escape_closes_the_palette_and_nothing_happens() {
    let mut bench = open("hello/sphere");
    let before = selected(&bench);
    press_with(&mut bench, Modifiers::COMMAND, Key::K);
    assert!(bench.query_by_role(Role::TextInput).is_some());
    press(&mut bench, Key::Escape);
    assert!(bench.query_by_label_contains("Type a few letters").is_none());
    assert_eq!(selected(&bench), before);
}

#[test]
fn the_table_of_keys_shows_every_command_that_has_one() {
    let mut bench = open_at("hello/sphere", Vec2::new(1280.0, 2400.0));
    press(&mut bench, Key::F1);
    for command in Command::all().into_iter().filter(|command| command.key().is_some()) {
        let about = rayscope::words::say(Language::English, &format!("{}-about", command.word()));
        assert!(bench.query_all_by_label(&about).next().is_some(), "{about}");
    }
    click_button(&mut bench, "Close");
    assert!(bench.query_by_label("Within panels").is_none());
}

#[test]
fn the_tour_is_offered_once_and_leads_to_the_end() {
    let mut bench = open("hello/sphere");
    workbench_mut(&mut bench).offer_tour();
    settle(&mut bench);
    assert!(bench.query_by_label("Stop 1 of 6").is_some());
    for stop in 2..=6 {
        press(&mut bench, Key::Enter);
        assert!(bench.query_by_label(&format!("Stop {stop} of 6")).is_some(), "{stop}");
    }
    click_button(&mut bench, "Begin");
    assert!(workbench(&bench).settings().is_toured);
    workbench_mut(&mut bench).offer_tour();
    settle(&mut bench);
    assert!(bench.query_by_label("Stop 1 of 6").is_none());
    run(&mut bench, HelpCommand::Tour);
    assert!(bench.query_by_label("Stop 1 of 6").is_some());
}

#[test]
fn the_interface_speaks_german_when_told_to() {
    let mut bench = open("hello/sphere");
    run(&mut bench, ViewCommand::Language(Language::German));
    assert!(bench.query_by_role_and_label(Role::Button, "Lernen").is_some());
    assert!(bench.query_by_role_and_label(Role::Button, "Learn").is_none());
}

#[test]
fn everything_grows_and_shrinks_between_half_and_three_times() {
    let mut bench = open("hello/sphere");
    for _ in 0..12 {
        press_with(&mut bench, Modifiers::COMMAND, Key::Plus);
    }
    assert_eq!(workbench(&bench).settings().zoom, 3.0);
    for _ in 0..24 {
        press_with(&mut bench, Modifiers::COMMAND, Key::Minus);
    }
    assert_eq!(workbench(&bench).settings().zoom, 0.5);
    press_with(&mut bench, Modifiers::COMMAND, Key::Num0);
    assert_eq!(workbench(&bench).settings().zoom, 1.0);
}

#[test]
fn every_command_of_the_menus_can_be_run_without_harm() {
    let mut bench = open("csg/bowl");
    // The dialogue of the system is not for tests.
    let opens_dialogue = |command: &Command| command.word().starts_with("scene-");
    for command in Command::all().into_iter().filter(|command| !opens_dialogue(command)) {
        if command.is_possible(workbench(&bench)) {
            run(&mut bench, command);
        }
        press(&mut bench, Key::Escape);
    }
    assert!(workbench(&bench).scene().is_some());
}

#[test]
fn within_another_page_a_step_can_be_looked_at_but_not_changed() {
    let mut bench = open("csg/bowl");
    workbench_mut(&mut bench).embed(false);
    settle(&mut bench);
    let is_possible = |bench: &Bench, command: Command| command.is_possible(workbench(bench));
    let changes = [SceneCommand::Open.into(), EditCommand::SaveAs.into(), ViewCommand::Pane(Pane::Editor).into()];
    assert!(changes.iter().all(|command| !is_possible(&bench, *command)));
    assert!(is_possible(&bench, ViewCommand::Pane(Pane::Signs).into()));
    for tab in ["Scene file", "Properties"] {
        assert!(bench.query_by_label(tab).is_none(), "{tab}");
    }
    press_with(&mut bench, Modifiers::NONE, Key::F2);
    assert!(!workbench(&bench).dock().shows(Pane::Lesson));
}

#[test]
fn no_layout_hides_a_tab_behind_the_tools_of_a_panel() {
    let mut bench = open("csg/bowl");
    for preset in Preset::ALL {
        run(&mut bench, ViewCommand::Layout(preset));
        settle(&mut bench);
        assert!(bench.query_by_label("Scroll tabs right").is_none(), "{preset:?}");
    }
}

#[test]
fn tools_that_do_not_fit_beside_the_tabs_are_in_a_menu() {
    let mut bench = open("csg/bowl");
    run(&mut bench, ViewCommand::Layout(Preset::Present));
    settle(&mut bench);
    assert!(bench.query_by_label("Fit").is_none());
    click_button(&mut bench, "Tools");
    assert!(bench.query_by_label("Fit").is_some());
}

#[test]
fn each_key_stands_before_what_it_does() {
    let mut bench = open("csg/bowl");
    run(&mut bench, Command::Help(HelpCommand::Keys));
    for (key, does) in [("F8", "Go to the next thing that is wrong"), ("Home", "Go to the beginning of the story")] {
        let key = bench.get_all_by_label(key).last().expect("it has a key").rect();
        let does = bench.get_by_label_contains(does).rect();
        assert!(key.right() < does.left() && key.y_range().intersects(does.y_range()), "{key} {does}");
    }
}

#[test]
fn a_menu_is_not_wider_than_its_longest_line() {
    let mut bench = open("csg/bowl");
    click_button(&mut bench, "Share");
    let line = bench.get_by_label_contains("Save steps as animated PNG").rect();
    assert!(line.width() < 360.0, "{line}");
}

#[test]
fn what_stands_below_a_broken_text_stays_inside_its_panel() {
    for language in Language::ALL {
        let mut bench = open("hello/sphere");
        reveal(&mut bench, Pane::Editor);
        run(&mut bench, ViewCommand::Language(language));
        hands::editing::put_cursor(&mut bench, "\"field_of_view\": 32", true);
        type_text(&mut bench, "0");
        let panel = workbench(&bench).dock().rect_of(Pane::Editor).expect("it is seen");
        let about = rayscope::words::say(language, "edit-stale-about");
        wait_until(&mut bench, "the error", |bench| bench.query_by_label(&about).is_some());
        let words = bench.get_by_label(&about).rect();
        assert!(panel.x_range().contains(words.right()), "{words} of {panel}");
    }
}

#[test]
fn a_menu_is_as_high_as_its_lines_where_the_window_has_room_for_them() {
    let mut bench = open("csg/bowl");
    for menu in ["Step", "Share"] {
        click_button(&mut bench, menu);
        let (_, commands) = Command::areas()
            .into_iter()
            .find(|(word, _)| rayscope::words::say(Language::English, word) == menu)
            .expect("there is such a menu");
        let last = rayscope::words::say(Language::English, commands.last().expect("it has commands").word());
        let line = bench.get_by_label_contains(&last).rect();
        bench.event(Event::PointerMoved(line.center()));
        settle(&mut bench);
        let about = commands.last().expect("it has commands").word();
        let about = rayscope::words::say(Language::English, &format!("{about}-about"));
        wait_until(&mut bench, "what the line under the pointer says", |bench| {
            bench.query_by_label_contains(&about).is_some()
        });
        press(&mut bench, Key::Escape);
    }
}

#[test]
fn layouts_and_panels_of_one_name_are_told_apart() {
    let mut bench = open("hello/sphere");
    press_with(&mut bench, Modifiers::COMMAND, Key::K);
    type_text(&mut bench, "lesson");
    for title in ["Layout: Lesson", "Panel: Lesson"] {
        assert_eq!(bench.query_all_by_label_contains(title).count(), 1, "{title}");
    }
}

#[test]
fn what_is_presented_grows_with_the_window() {
    for (size, zoom) in [((1280.0, 800.0), 1.5), ((1920.0, 1080.0), 2.25), ((960.0, 600.0), 1.5)] {
        let mut bench = open_at("csg/bowl", Vec2::from(size));
        run(&mut bench, ViewCommand::Layout(Preset::Present));
        for _ in 0..8 {
            settle(&mut bench);
        }
        assert_eq!(bench.ctx.zoom_factor(), zoom, "{size:?}");
        run(&mut bench, ViewCommand::Layout(Preset::Learn));
        assert_eq!(bench.ctx.zoom_factor(), 1.0, "{size:?}");
    }
}

#[test]
fn the_tab_of_a_panel_that_comes_to_the_front_is_in_sight() {
    let mut bench = open("csg/bowl");
    run(&mut bench, ViewCommand::Layout(Preset::Lesson));
    reveal(&mut bench, Pane::Detail);
    for pane in [Pane::Overview, Pane::Shading, Pane::Detail] {
        reveal(&mut bench, pane);
        settle(&mut bench);
        let panel = workbench(&bench).dock().rect_of(pane).expect("it is seen");
        let name = rayscope::words::say(Language::English, pane.word());
        let tab = bench.get_by_role_and_label(Role::Button, &name).rect();
        assert!(panel.x_range().contains(tab.left()) && panel.x_range().contains(tab.right()), "{name}: {tab} {panel}");
    }
}

#[test]
fn names_in_the_words_of_a_scene_are_shown_without_backticks() {
    let bench = open("lens/focus");
    assert!(bench.query_by_label_contains("Change focus and see").is_some());
}

#[test]
fn a_menu_that_is_too_high_for_one_column_has_two_and_need_not_scroll() {
    let mut bench = open("csg/bowl");
    click_button(&mut bench, "View");
    let (_, commands) =
        Command::areas().into_iter().find(|(word, _)| *word == "menu-view").expect("there is such a menu");
    for command in commands {
        let name = rayscope::words::say(Language::English, command.word());
        let is_seen = bench.query_all_by_label_contains(&name).any(|line| line.rect().bottom() <= 800.0);
        assert!(is_seen, "{name}");
    }
}

#[test]
fn the_palette_offers_what_can_be_done_before_what_cannot() {
    let mut bench = open("hello/sphere");
    press_with(&mut bench, Modifiers::COMMAND, Key::K);
    type_text(&mut bench, "save");
    let lines = bench.query_all_by_label_contains("ave").filter(|line| line.accesskit_node().role() == Role::Button);
    let mut lines: Vec<_> = lines.map(|line| (line.rect().top(), line.accesskit_node().is_disabled())).collect();
    lines.sort_by(|a, b| a.0.total_cmp(&b.0));
    assert!(lines.is_sorted_by_key(|(_, is_disabled)| *is_disabled), "{lines:?}");
}

#[test]
fn keys_are_named_as_on_a_keyboard_of_the_language() {
    let mut bench = open_at("hello/sphere", Vec2::new(1280.0, 2400.0));
    press(&mut bench, Key::F1);
    assert!(bench.query_all_by_label("Ctrl+K").next().is_some());
    run(&mut bench, ViewCommand::Language(Language::German));
    assert!(bench.query_all_by_label("Strg+K").next().is_some());
    assert!(bench.query_all_by_label_contains("Ctrl").next().is_none());
}
