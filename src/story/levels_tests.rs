//! What the levels promise, in every scene that comes with the program.

use super::testing::every_telling_pixel;
use super::{Cut, Filter, Kind, Level, Story, cut};
use crate::record::What;
use std::sync::Arc;

#[test]
fn the_story_of_a_plain_ray_is_five_to_fifteen_rows() {
    let mut plain = 0;
    for (name, tree) in every_telling_pixel() {
        let story = Story::new(Arc::new(tree), Level::Story, Filter::default());
        let rows = story.outline().len();
        assert!(rows >= 4, "{name}: {rows} rows");
        let followed = story.shown().steps_of(Kind::Ray).len() + story.shown().steps_of(Kind::Sample).len();
        let lights = story.shown().steps_of(Kind::Light).len();
        // The camera ray, and at most one more with its lights.
        if followed <= 2 && lights <= 4 {
            plain += 1;
            assert!((4..=15).contains(&rows), "{name}: {rows} rows");
        }
    }
    assert!(plain > 30, "only {plain} rays are plain");
}

#[test]
fn a_hit_always_stands_below_its_ray_and_its_pixel() {
    for (name, tree) in every_telling_pixel() {
        let tree = Arc::new(tree);
        for level in Level::ALL {
            let story = Story::new(Arc::clone(&tree), level, Filter::default());
            for event in tree.events.iter().filter(|event| matches!(event.what, What::Hit { .. })) {
                let scope = story.index().scope(event.id).event;
                assert!(story.shown().has_row(event.id), "{name}: hit {}", event.id);
                assert!(story.shown().has_row(scope), "{name}: the ray of hit {}", event.id);
            }
        }
    }
}

#[test]
fn what_stops_a_ray_has_a_row_at_every_level() {
    for (name, tree) in every_telling_pixel() {
        let story = Story::new(Arc::new(tree), Level::Story, Filter::default());
        for event in story.tree().events.iter().filter(|event| cut(&event.what) == Some(Cut::Limited)) {
            assert!(story.shown().has_row(event.id), "{name}: {:?}", event.what);
        }
    }
}

#[test]
fn whatever_is_left_out_has_a_row_in_the_working_or_is_in_the_detail_of_one_below_it() {
    for (name, tree) in every_telling_pixel() {
        let story = Story::new(Arc::new(tree), Level::Working, Filter::default());
        for event in &story.tree().events {
            let Some(cut) = cut(&event.what) else { continue };
            // Candidates are listed with their reasons by their primitive's last event.
            let listed = matches!(event.what, What::Roots { .. });
            assert!(listed || story.shown().has_row(event.id), "{name}: {cut:?} {:?}", event.what);
        }
    }
}

#[test]
fn an_undecidable_answer_to_a_ray_that_is_followed_is_part_of_the_story_with_its_object() {
    let mut found = 0;
    for (name, tree) in every_telling_pixel() {
        let story = Story::new(Arc::new(tree), Level::Story, Filter::default());
        for event in &story.tree().events {
            let followed = story.index().scope(event.id).kind != crate::record::RayKind::Shadow;
            if followed && cut(&event.what) == Some(Cut::Undecidable) {
                found += 1;
                assert!(story.shown().has_row(event.id), "{name}: event {}", event.id);
                let above = story.shown().parent(event.id).map(|above| story.index().kind(above));
                assert_eq!(above, Some(Kind::Primitive), "{name}: event {}", event.id);
            }
        }
    }
    assert!(found > 0, "some scene is about what cannot be decided");
}
