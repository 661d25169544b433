//! Sharing as a person does it: links, copies, files, the menus in the panels' headers.
#![cfg(feature = "workbench")]

mod hands;

use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, OutputCommand, Vec2};
use egui_kittest::kittest::Queryable;
use hands::editing::type_text;
use hands::*;
use rayscope::app::{Aim, Command, Ending, Pane, Preset, Product, ShareCommand, ViewCommand};
use rayscope::record::What;
use rayscope::share::link::{EventPlace, Link};
use rayscope::story::Level;
use rayscope::view::View;
use rayscope::words::Language;
use std::path::PathBuf;

fn copied(bench: &Bench) -> Vec<OutputCommand> {
    bench.output().platform_output.commands.clone()
}

/// Shares and waits; what was put on the clipboard meanwhile.
fn shared(bench: &mut Bench, command: ShareCommand) -> Vec<OutputCommand> {
    workbench_mut(bench).run(command.into());
    let mut commands = copied(bench);
    let begin = std::time::Instant::now();
    loop {
        bench.step();
        commands.extend(copied(bench));
        if !workbench(bench).is_sharing() && workbench(bench).shared().is_some() {
            return commands;
        }
        assert!(begin.elapsed() < PATIENCE, "waited in vain for {command:?}");
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
}

fn saved(bench: &mut Bench, product: Product, path: PathBuf) -> Vec<u8> {
    workbench_mut(bench).share(product, Aim::File(path.clone()));
    wait_until(bench, "the file", |bench| !workbench(bench).is_sharing());
    settle(bench);
    let told = workbench(bench).shared().expect("the end is told").to_owned();
    assert!(told.contains(path.to_str().unwrap()), "{told}");
    std::fs::read(path).unwrap()
}

fn link_of(bench: &Bench) -> String {
    workbench(bench).link().expect("an embedded scene has a link")
}

#[test]
fn a_link_that_is_copied_brings_back_all_that_is_seen() {
    let mut bench = open("csg/bowl");
    workbench_mut(&mut bench).record([300, 200]);
    settle(&mut bench);
    tell(&mut bench, Level::Everything);
    let event = find(&bench, |what| matches!(what, What::Colour { .. } | What::Nothing { .. }));
    workbench_mut(&mut bench).select(event);
    run(&mut bench, ViewCommand::Layout(Preset::Inspect));
    run(&mut bench, ViewCommand::Language(Language::German));
    let commands = shared(&mut bench, ShareCommand::CopyLink);
    let link = link_of(&bench);
    assert!(commands.iter().any(|command| *command == OutputCommand::CopyText(link.clone())), "{commands:?}");

    let mut other = open("hello/sphere");
    let ctx = workbench(&other).ctx();
    workbench_mut(&mut other).follow(&ctx, &link.parse().unwrap());
    settle(&mut other);
    assert_eq!(link_of(&other), link);
    assert_eq!((pixel(&other), selected(&other)), ([300, 200], event));
    assert_eq!(workbench(&other).scene().unwrap().name, "csg/bowl");
    assert_eq!(workbench(&other).settings().language, Language::German);
    assert_eq!(workbench(&other).shared(), None);
}

/// Another workbench in which a link was opened.
fn follow<'a>(link: &str) -> Bench<'a> {
    let mut other = open("hello/sphere");
    let ctx = workbench(&other).ctx();
    workbench_mut(&mut other).follow(&ctx, &link.parse().unwrap());
    settle(&mut other);
    other
}

#[test]
fn a_link_brings_back_t_the_turned_overview_and_the_panels_that_are_seen() {
    let mut bench = open("csg/bowl");
    run(&mut bench, ViewCommand::Layout(Preset::Inspect));
    for pane in [Pane::Overview, Pane::Signs, Pane::Properties] {
        reveal(&mut bench, pane);
    }
    wait_until(&mut bench, "the drawings", |bench| {
        bench.query_by_role_and_label(Role::Slider, "t on the ray").is_some()
            && bench.query_by_role_and_label(Role::Image, "Overview").is_some()
    });
    let plot = bench.get_by_role_and_label(Role::Slider, "t on the ray").rect().center();
    click(&mut bench, plot);
    let corner = bench.get_by_role_and_label(Role::Image, "Overview").rect().left_top() + Vec2::splat(3.0);
    click(&mut bench, corner);
    press(&mut bench, Key::ArrowRight);
    let link = link_of(&bench);
    for part in ["&t=", "&orbit=", "overview", "signs", "properties"] {
        assert!(link.contains(part), "{part}: {link}");
    }
    let other = follow(&link);
    assert_eq!(link_of(&other), link);
    let t = |bench: &Bench| workbench(bench).recording().unwrap().probe_t;
    assert!(t(&other).is_some() && t(&other) == t(&bench));
    for pane in [Pane::Overview, Pane::Signs, Pane::Properties] {
        assert!(workbench(&other).dock().shows(pane), "{pane:?}");
    }
}

#[test]
fn the_link_of_an_edited_scene_carries_its_text_as_it_stands() {
    let mut bench = open("csg/bowl");
    assert!(!link_of(&bench).contains("text="), "everybody has this scene");
    let text = workbench(&bench).document().text().to_owned();
    let at = text.find("\"title\": \"").unwrap() + "\"title\": \"".len();
    workbench_mut(&mut bench).put_cursor(at);
    settle(&mut bench);
    type_text(&mut bench, "My ");
    wait_until(&mut bench, "the scene to follow its text", |bench| !workbench(bench).is_stale());
    let link = link_of(&bench);
    assert!(link.contains("text="), "{link}");
    let other = follow(&link);
    assert!(workbench(&other).scene().unwrap().scene.title.starts_with("My "));
    assert_eq!(workbench(&other).document().text(), workbench(&bench).document().text());
    type_text(&mut bench, "\"");
    wait_until(&mut bench, "the error", |bench| workbench(bench).link().is_err());
    assert!(workbench(&bench).link().unwrap_err().contains("has errors"));
}

#[test]
fn a_link_does_not_take_the_place_of_an_unsaved_edit_without_asking() {
    let mut bench = open("hello/sphere");
    workbench_mut(&mut bench).put_cursor(2);
    settle(&mut bench);
    type_text(&mut bench, " ");
    let ctx = workbench(&bench).ctx();
    workbench_mut(&mut bench).follow(&ctx, &"rayscope:csg/bowl?pixel=5,6".parse().unwrap());
    settle(&mut bench);
    assert_eq!(workbench(&bench).scene().unwrap().name, "hello/sphere");
    bench.get_by_role_and_label(Role::Button, "Don’t save").click();
    settle(&mut bench);
    assert_eq!((workbench(&bench).scene().unwrap().name.as_str(), pixel(&bench)), ("csg/bowl", [5, 6]));
}

#[test]
fn a_link_is_pasted_into_a_field_that_says_what_is_wrong_with_it() {
    let mut bench = open("hello/sphere");
    bench.key_press_modifiers(Modifiers::COMMAND, Key::L);
    settle(&mut bench);
    bench.event(Event::Paste("rayscope:csg/bowl?pixel=1".to_owned()));
    settle(&mut bench);
    assert!(bench.query_by_label_contains("is no pair such as").is_some());
    bench.event(Event::Paste("2,3".to_owned()));
    settle(&mut bench);
    let field = bench.get_by_role_and_label(Role::TextInput, "Link");
    assert_eq!(field.value().as_deref(), Some("rayscope:csg/bowl?pixel=12,3"));
    bench.key_press(Key::Enter);
    settle(&mut bench);
    assert_eq!(workbench(&bench).scene().unwrap().name, "csg/bowl");
    assert_eq!(pixel(&bench), [12, 3]);
    assert!(bench.query_by_role_and_label(Role::TextInput, "Link").is_none());
}

#[test]
fn what_a_link_asks_for_that_is_not_there_is_told_and_the_rest_is_shown() {
    let mut bench = open("hello/sphere");
    let ctx = workbench(&bench).ctx();
    let link: Link = "rayscope:csg/bowl?pixel=5,6&preset=gallery&event=1&path=Pixel.Gone".parse().unwrap();
    workbench_mut(&mut bench).follow(&ctx, &link);
    settle(&mut bench);
    assert_eq!(pixel(&bench), [5, 6]);
    wait_until(&mut bench, "what became of the place", |bench| {
        bench.query_by_label_contains("is not where it was").is_some()
    });
    let link: Link = "rayscope:csg/bowl?pixel=99999,6&preset=gallery".parse().unwrap();
    workbench_mut(&mut bench).follow(&ctx, &link);
    settle(&mut bench);
    assert!(bench.query_by_label_contains("gallery").is_some());
    assert!(bench.query_by_label_contains("lies outside the picture").is_some());
    bench.get_by_label("Close").click();
    settle(&mut bench);
    assert_eq!(workbench(&bench).shared(), None);
}

#[test]
fn a_ray_and_a_scene_that_came_in_a_link_are_shown() {
    let text = r#"{"title": "Sent", "materials": {"m": {}}, "objects": [{"shape": "sphere", "material": "m"}]}"#;
    let mut link: Link = "rayscope:sent?ray=0,0,9,0,0,-1".parse().unwrap();
    link.text = Some(text.to_owned());
    let mut bench = open("hello/sphere");
    let ctx = workbench(&bench).ctx();
    workbench_mut(&mut bench).follow(&ctx, &link);
    settle(&mut bench);
    assert_eq!(workbench(&bench).scene().unwrap().scene.title, "Sent");
    let tree = &workbench(&bench).recording().unwrap().tree;
    assert!(matches!(tree.event(0).what, What::LooseRay { .. }));
    assert!(link_of(&bench).contains("ray=0,0,9,0,0,-1"), "{}", link_of(&bench));
}

#[test]
fn the_story_is_copied_as_text_and_as_a_worked_example() {
    let mut bench = open("csg/bowl");
    let commands = shared(&mut bench, ShareCommand::CopyText);
    let tree = &workbench(&bench).recording().unwrap().tree;
    assert!(commands.contains(&OutputCommand::CopyText(rayscope::view::tree_text(tree))));
    settle(&mut bench);
    assert!(bench.query_by_label_contains("lines are on the clipboard").is_some());
    let commands = shared(&mut bench, ShareCommand::CopyMarkdown);
    // The copy before may still be among them.
    let text = commands.iter().rev().find_map(|command| match command {
        OutputCommand::CopyText(text) => Some(text),
        _ => None,
    });
    assert!(text.is_some_and(|text| text.starts_with("# ") && text.contains("rayscope open 'rayscope:csg/bowl")));
}

#[test]
fn the_drawing_of_the_panel_that_is_used_is_copied_as_an_image() {
    let mut bench = open("csg/bowl");
    let commands = shared(&mut bench, ShareCommand::CopyImage);
    let image = commands.iter().find_map(|command| match command {
        OutputCommand::CopyImage(image) => Some(image.size),
        _ => None,
    });
    assert_eq!(image, Some([1920, 1200]));
}

#[test]
fn every_kind_of_file_is_saved_and_the_path_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let mut bench = open("hello/sphere");
    let side = View::named("side").unwrap();
    for (product, begin) in [
        (Product::Text, "▣ Pixel"),
        (Product::Json, "{\"format\":\"rayscope-trace/1\""),
        (Product::Markdown, "# "),
        (Product::Slides, "<!DOCTYPE html>"),
        (Product::SlidesPdf, "%PDF-1.7"),
        (Product::Gif, "GIF89a"),
        (Product::View(side, Ending::Svg), "<svg "),
        (Product::View(side, Ending::Pdf), "%PDF-1.7"),
    ] {
        let name = product.file_name("hello/sphere");
        assert!(name.starts_with("sphere-") && name.ends_with(product.ending()), "{name}");
        let bytes = saved(&mut bench, product, folder.path().join(&name));
        assert!(bytes.starts_with(begin.as_bytes()), "{name}");
    }
    let png = saved(&mut bench, Product::Apng, folder.path().join("a.png"));
    assert!(png.starts_with(b"\x89PNG"));
}

#[test]
fn a_file_that_cannot_be_written_is_told_with_its_path() {
    let mut bench = open("hello/sphere");
    let path = PathBuf::from("/no such folder/trace.txt");
    workbench_mut(&mut bench).share(Product::Text, Aim::File(path));
    wait_until(&mut bench, "the refusal", |bench| workbench(bench).shared().is_some());
    settle(&mut bench);
    assert!(bench.query_by_label_contains("/no such folder/trace.txt").is_some());
}

#[test]
fn each_panel_with_a_drawing_offers_to_save_it() {
    let mut bench = open("csg/bowl");
    reveal(&mut bench, Pane::Side);
    let menus = bench.query_all_by_label("Save ⏷").count();
    assert!(menus >= 1, "{menus}");
    bench.query_all_by_label("Save ⏷").next().unwrap().click();
    settle(&mut bench);
    for choice in ["Copy drawing as image", "Save drawing as SVG…", "Save drawing as PNG…", "Save drawing as PDF…"]
    {
        assert!(bench.query_by_label(choice).is_some(), "{choice}");
    }
}

#[test]
fn the_menu_of_sharing_is_said_in_german_too() {
    // Wide enough for a menu of its own: German words are long.
    let mut bench = open_at("csg/bowl", Vec2::new(1600.0, 900.0));
    run(&mut bench, ViewCommand::Language(Language::German));
    bench.get_by_label("Teilen").click();
    settle(&mut bench);
    assert!(bench.query_by_label_contains("Link kopieren").is_some());
    let places =
        Command::areas().into_iter().find(|(menu, _)| *menu == "menu-share").map(|(_, commands)| commands.len());
    assert_eq!(places, Some(15));
}

#[test]
fn the_place_of_an_event_outlives_another_scene() {
    let bench = open("csg/bowl");
    let recording = workbench(&bench).recording().unwrap();
    let place = EventPlace::of(&recording.tree, recording.selected());
    let other = open("hello/sphere");
    let tree = &workbench(&other).recording().unwrap().tree;
    let found = place.find(tree);
    assert!(found.event < tree.end());
}
