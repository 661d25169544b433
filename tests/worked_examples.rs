//! The recorded traces in `snapshots/`: worked examples that can be read without running the program.

use rayscope::scene::{embedded_scenes, load};
use rayscope::trace::record_pixel;
use rayscope::view::tree_text;

/// The text with two samples of a pixel told as a whole, and of the others what they are.
fn with_two_samples(text: &str) -> String {
    let mut is_told = true;
    let mut told = String::new();
    for line in text.lines() {
        if let Some(rest) = line.strip_prefix("  ⊙ sample ") {
            is_told = matches!(rest.split_whitespace().next(), Some("1" | "2"));
            told += line;
            told.push('\n');
            continue;
        }
        is_told |= !line.starts_with("   ");
        if is_told {
            told += line;
            told.push('\n');
        }
    }
    told
}

#[test]
fn every_scene_tells_the_story_of_its_telling_pixels() {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path("../snapshots");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    for embedded in embedded_scenes() {
        let scene = load(embedded.text, &embedded.name).unwrap_or_else(|errors| panic!("{errors}"));
        assert!(!scene.pixels.is_empty(), "{} names no pixel worth looking at", embedded.name);
        for (number, [x, y]) in scene.pixels.iter().enumerate() {
            settings.set_snapshot_suffix(format!("{}_ray_{}", embedded.name.replace('/', "__"), number + 1));
            settings.set_description(format!("{}, pixel {x},{y}", embedded.name));
            let text = with_two_samples(&tree_text(&record_pixel(&scene, *x, *y)));
            settings.bind(|| insta::assert_snapshot!("trace", text));
        }
    }
}
