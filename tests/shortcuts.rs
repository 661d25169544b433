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
        ("balls", Shortcuts { balls: false, ..all }),
        ("projections", Shortcuts { projections: false, ..all }),
        ("the hierarchy", Shortcuts { hierarchy: false, ..all }),
        ("sights", Shortcuts { sights: false, ..all }),
        ("sights and the hierarchy", Shortcuts { sights: false, hierarchy: false, ..all }),
        ("everything", Shortcuts::NONE),
    ]
}

/// A bowl of many spheres in one solid, with a corner cut away and a stick at a slope, so that wide unions and balls are met.
fn many_in_one() -> String {
    let sphere = |k: u32| {
        let (turn, height) = (f64::from(k) * 2.4, f64::from(k) * 0.05);
        let [x, y] = [turn.cos(), turn.sin()].map(|x| x * (1.0 + height));
        format!(
            r#"{{ "shape": "sphere", "transform": [{{ "scale": 0.3 }}, {{ "translate": [{x}, {y}, {height}] }}] }}"#
        )
    };
    let spheres: Vec<String> = (0..40).map(sphere).collect();
    format!(
        r#"{{
            "title": "many in one",
            "camera": {{ "eye": [6, -7, 5], "look_at": [0, 0, 1], "up": [0, 0, 1], "field_of_view": 40 }},
            "lights": [{{ "name": "lamp", "point": [8, -3, 9], "colour": [1, 1, 1] }}],
            "materials": {{ "matt": {{ "diffuse": [0.8, 0.7, 0.6], "reflectivity": 0.3 }} }},
            "objects": [
                {{ "shape": "difference", "material": "matt", "of": [
                    {{ "shape": "union", "of": [{}] }},
                    {{ "shape": "cube", "transform": [{{ "translate": [1.5, -1.5, 1.5] }}] }}
                ] }},
                {{ "shape": "cube", "material": "matt", "transform": [
                    {{ "rotate": {{ "axis": [1, 1, 0], "degrees": 50 }} }}, {{ "translate": [-3, 0, 1] }}
                ] }}
            ]
        }}"#,
        spheres.join(", ")
    )
}

/// Every embedded scene, and those peer scenes whose objects can be asked one by one in a test's time.
fn scenes() -> Vec<(String, Scene)> {
    let peers = ["b_tori", "d_csg", "e_glass", "h_solids", "i_scaling_100"].map(|name: &str| {
        let path = format!("{}/tests/peers/{name}.json", env!("CARGO_MANIFEST_DIR"));
        let text = fs::read_to_string(path).unwrap();
        (name.to_owned(), import(&text).unwrap_or_else(|error| panic!("{error}")))
    });
    let embedded = embedded_scenes().into_iter().map(|scene| (scene.name, scene.text.to_owned()));
    let own = [("many_in_one".to_owned(), many_in_one())];
    let sized = |(name, text): (String, String)| {
        let mut scene = load(&text, &name).unwrap_or_else(|errors| panic!("{errors}"));
        scene.image = Image { width: 47, height: 35 };
        (name, scene)
    };
    embedded.chain(own).chain(peers).map(sized).collect()
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
