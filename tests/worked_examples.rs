//! The recorded traces in `snapshots/`: worked examples that can be read without running the program.

use rayscope::scene::{embedded_scenes, load};
use rayscope::trace::record_pixel;
use rayscope::view::tree_text;

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
            let text = tree_text(&record_pixel(&scene, *x, *y));
            settings.bind(|| insta::assert_snapshot!("trace", text));
        }
    }
}
