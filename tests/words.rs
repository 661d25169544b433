//! What the interface says comes from the catalogue, and all that is in the catalogue is said.
#![cfg(feature = "workbench")]

use rayscope::query::PRESETS;
use rayscope::scene::embedded_scenes;
use rayscope::words::{Language, known, say};
use std::fs;
use std::path::Path;

/// Names that the program puts together: the kinds of lights, the channels of colours, questions with names, folders of scenes.
const MADE: [&str; 6] = ["edit-light-", "edit-red", "edit-green", "edit-blue", "asked-", "scenes-"];

fn sources(folder: &Path, texts: &mut Vec<(String, String)>) {
    let mut paths: Vec<_> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    for path in paths {
        if path.is_dir() {
            sources(&path, texts);
        } else {
            texts.push((path.display().to_string(), fs::read_to_string(&path).unwrap()));
        }
    }
}

fn app() -> Vec<(String, String)> {
    let mut texts = Vec::new();
    sources(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src/app"), &mut texts);
    texts
}

#[test]
fn every_message_is_said_somewhere() {
    let app = app();
    let unsaid: Vec<_> = known(Language::English)
        .into_iter()
        .filter(|id| {
            // What a thing is about is asked for by the thing's name.
            let name = format!("\"{}\"", id.strip_suffix("-about").unwrap_or(id));
            let whole = format!("\"{id}\"");
            let is_made = MADE.iter().any(|begin| id.starts_with(begin));
            !is_made && !app.iter().any(|(_, text)| text.contains(&name) || text.contains(&whole))
        })
        .collect();
    assert!(unsaid.is_empty(), "{unsaid:?}");
}

#[test]
fn questions_with_names_and_folders_of_scenes_have_words() {
    for preset in PRESETS {
        assert_eq!(say(Language::English, &preset.word()), preset.title);
    }
    let words = known(Language::English);
    for scene in embedded_scenes() {
        let folder = scene.name.split('/').next().expect("a name has a first part");
        assert!(words.iter().any(|word| *word == format!("scenes-{folder}")), "{folder}");
    }
}

#[test]
fn no_control_has_words_of_its_own() {
    let shown =
        ["button(\"", "label(\"", "hover_text(\"", "Button::new(\"", "RichText::new(\"", "heading(\"", "empty(ui, \""];
    let mut own = Vec::new();
    for (path, text) in app() {
        for (number, line) in text.lines().enumerate() {
            let words = shown.iter().filter_map(|begin| line.split_once(begin)).map(|(_, rest)| rest);
            for rest in words {
                let is_sentence = rest.starts_with(char::is_alphabetic);
                let is_name = line.contains("\"rayscope\"");
                if is_sentence && !is_name {
                    own.push(format!("{path}:{}: {}", number + 1, line.trim()));
                }
            }
        }
    }
    assert!(own.is_empty(), "these belong in assets/words:\n{}", own.join("\n"));
}
