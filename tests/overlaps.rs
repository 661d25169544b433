//! Design policy 1 of § 6.4.1: transparent objects that fill the same space are found and named.

use rayscope::record::What;
use rayscope::scene::{Scene, load};
use rayscope::trace::{Progress, record_pixel, render};

/// Two unit balls about x = 0 and x = 0.5 that bend no light, seen along the x axis from x = −5.
fn balls(media: &str) -> Scene {
    let text = format!(
        r#"{{"image": {{"width": 3, "height": 3}}, "media": "{media}",
            "camera": {{"eye": [-5, 0, 0], "look_at": [0, 0, 0], "up": [0, 0, 1], "field_of_view": 1}},
            "materials": {{"clear": {{"transparency": 1, "ambient": [0, 0, 0], "diffuse": [0, 0, 0]}}}},
            "objects": [{{"name": "near", "shape": "sphere", "material": "clear"}},
                {{"name": "far", "shape": "sphere", "material": "clear", "transform": [{{"translate": [0.5, 0, 0]}}]}}]}}"#
    );
    load(&text, "made up").unwrap_or_else(|errors| panic!("{errors}"))
}

#[test]
fn an_overlap_is_recorded_with_its_objects_and_its_interval() {
    let tree = record_pixel(&balls("forbid"), 1, 1);
    let overlaps: Vec<_> = tree
        .events
        .iter()
        .filter_map(|event| match &event.what {
            What::Overlap(overlap) => Some(overlap.clone()),
            _ => None,
        })
        .collect();
    assert_eq!(overlaps.len(), 1);
    assert_eq!((overlaps[0].first.as_str(), overlaps[0].second.as_str()), ("near", "far"));
    // The ray inside the near ball starts at x = −1; the far one begins at x = −0.5, and the near one ends at x = 1.
    let [from, to] = overlaps[0].interval;
    assert!((from - 0.5).abs() < 1e-14 && (to - 2.0).abs() < 1e-14, "{from} to {to}");
}

#[test]
fn a_picture_reports_the_pixel_that_found_an_overlap_first() {
    let scene = balls("forbid");
    let (_, tally) = render(&scene, &Progress::new());
    let found: Vec<_> = tally.overlaps().named(&scene).collect();
    let [(names, overlap)] = found.as_slice() else { panic!("{found:?}") };
    assert_eq!(*names, ["near", "far"]);
    assert_eq!((overlap.rays, overlap.pixel), (9, [0, 0]));
    assert!(tally.overlaps().in_words(&scene)[0].starts_with("`near` and `far` fill the same space: 9 rays"));
}

#[test]
fn what_the_scene_allows_is_not_reported() {
    for media in ["most_recent", "priority"] {
        let scene = balls(media);
        assert_eq!(render(&scene, &Progress::new()).1.overlaps().named(&scene).count(), 0, "{media}");
    }
}
