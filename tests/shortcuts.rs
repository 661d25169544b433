//! What spares rays their tests changes no picture: each kind of shortcut can be left out, and so can all of them.

use rayscope::peer::import;
use rayscope::scene::{Image, Scene, Shortcuts, embedded_scenes, load};
use rayscope::trace::{Picture, Progress, record_pixel, render};
use std::fs;

/// Each kind left out alone, and all together.
fn without_some() -> Vec<(&'static str, Shortcuts)> {
    let all = Shortcuts::ALL;
    vec![
        ("boxes", Shortcuts { boxes: false, ..all }),
        ("projections", Shortcuts { projections: false, ..all }),
        ("the hierarchy", Shortcuts { hierarchy: false, ..all }),
        ("sights", Shortcuts { sights: false, ..all }),
        ("sights and the hierarchy", Shortcuts { sights: false, hierarchy: false, ..all }),
        ("everything", Shortcuts::NONE),
    ]
}

/// Every embedded scene, and those peer scenes whose objects can be asked one by one in a test's time.
fn scenes() -> Vec<(String, Scene)> {
    let peers = ["b_tori", "d_csg", "e_glass", "h_solids", "i_scaling_100"].map(|name| {
        let path = format!("{}/tests/peers/{name}.json", env!("CARGO_MANIFEST_DIR"));
        (name.to_owned(), import(&fs::read_to_string(path).unwrap()).unwrap())
    });
    let embedded = embedded_scenes().into_iter().map(|scene| (scene.name, scene.text.to_owned()));
    let sized = |(name, text): (String, String)| {
        let mut scene = load(&text, &name).unwrap_or_else(|errors| panic!("{errors}"));
        scene.image = Image { width: 47, height: 35 };
        (name, scene)
    };
    embedded.chain(peers).map(sized).collect()
}

fn picture(scene: &Scene) -> Picture {
    render(scene, &Progress::new()).0
}

#[test]
fn no_shortcut_changes_a_picture() {
    for (name, mut scene) in scenes() {
        let whole = picture(&scene);
        for (left_out, shortcuts) in without_some() {
            scene.shortcuts = shortcuts;
            assert_eq!(picture(&scene), whole, "{name} without {left_out}");
        }
    }
}

#[test]
fn recorded_rays_are_told_the_same_colour_without_shortcuts() {
    for (name, mut scene) in scenes() {
        let pixels = [[0, 0], [23, 17], [30, 20], [46, 34]];
        let told = pixels.map(|[x, y]| record_pixel(&scene, x, y).colour());
        scene.shortcuts = Shortcuts::NONE;
        assert_eq!(pixels.map(|[x, y]| record_pixel(&scene, x, y).colour()), told, "{name}");
    }
}

#[test]
fn shortcuts_spare_tests() {
    let (_, mut scene) = scenes().into_iter().find(|(name, _)| name == "h_solids").unwrap();
    let tests = |scene: &Scene| render(scene, &Progress::new()).1.shape_tests().iter().map(|(_, n)| n).sum::<u64>();
    let with_all = tests(&scene);
    scene.shortcuts = Shortcuts::NONE;
    assert!(20 * with_all < tests(&scene), "{with_all} of {}", tests(&scene));
}
