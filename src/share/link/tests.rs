//! Links that come back as they went out, links that are wrong, and events that have moved.

use super::*;
use crate::record::Effect;
use crate::scene::{embedded_scene, load};
use crate::trace::{RayTree, record_pixel};
use proptest::prelude::*;

fn link(text: &str) -> Link {
    text.parse().unwrap_or_else(|error| panic!("{text}: {error}"))
}

fn error(text: &str) -> String {
    text.parse::<Link>().map(|link| link.to_string()).expect_err(text).to_string()
}

fn bowl() -> RayTree {
    let scene = load(embedded_scene("csg/bowl").unwrap().text, "csg/bowl").unwrap();
    record_pixel(&scene, scene.pixels[0][0], scene.pixels[0][1])
}

#[test]
fn a_link_reads_as_it_is_documented() {
    let read = link("rayscope:csg/bowl?pixel=310,240&event=57&preset=inspect");
    let expected = Link {
        aim: Some(Aim::Pixel([310, 240])),
        event: Some(EventPlace { number: 57, path: Vec::new() }),
        preset: Some("inspect".to_owned()),
        ..Link::to_scene("csg/bowl")
    };
    assert_eq!(read, expected);
    assert_eq!(read.to_string(), "rayscope:csg/bowl?pixel=310,240&event=57&preset=inspect");
}

#[test]
fn the_same_may_stand_behind_the_hash_of_a_web_address() {
    let plain = link("rayscope:csg/bowl?pixel=3,4");
    for text in [
        "https://example.org/rayscope/#csg/bowl?pixel=3,4",
        "http://localhost:8000/?embed=1#rayscope:csg/bowl?pixel=3,4",
        "#csg/bowl?pixel=3,4",
        "  rayscope:csg/bowl?pixel=3,4\n",
    ] {
        assert_eq!(link(text), plain, "{text}");
        assert!(Link::looks_like_one(text), "{text}");
    }
    assert!(!Link::looks_like_one("csg/bowl") && !Link::looks_like_one("C:\\scenes\\bowl.json"));
}

#[test]
fn what_is_wrong_is_named_with_its_place_and_what_to_do() {
    for (text, told) in [
        ("csg/bowl", "begins with rayscope:"),
        ("rayscope:", "names no scene"),
        ("https://example.org/", "nothing behind a #"),
        ("rayscope:a?pixel", "no name=value"),
        ("rayscope:a?pixel=1", "in the link's pixel: `1` is no pair"),
        ("rayscope:a?pixel=-1,2", "no whole number"),
        ("rayscope:a?pixel=+1,2", "no whole number"),
        ("rayscope:a?pixel=99999999999,2", "no whole number"),
        ("rayscope:a?pixel=1,2&pixel=1,2", "`pixel` twice"),
        ("rayscope:a?pixel=1,2&ray=0,0,9,0,0,-1", "a pixel and a ray"),
        ("rayscope:a?ray=0,0,9,0,0,0", "leads nowhere"),
        ("rayscope:a?ray=0,0,9,0,0,NaN", "finite numbers"),
        ("rayscope:a?t=inf", "finite number"),
        ("rayscope:a?size=0,4", "at least one column"),
        ("rayscope:a?theme=pink", "`pink` is no theme; there are light, dark"),
        ("rayscope:a?without=gravity", "`gravity` is no effect; there are antialiasing"),
        ("rayscope:a?colour=red", "newer rayscope"),
        ("rayscope:a?path=Pixel.Hit", "without the event"),
        ("rayscope:%zz", "in the link's name of the scene"),
        ("rayscope:a?text=@", "64 signs"),
        ("rayscope:a?preset=", "no word"),
    ] {
        assert!(error(text).contains(told), "{text}: {}", error(text));
    }
}

#[test]
fn effects_that_are_off_are_named_and_come_back() {
    let effects = Effects::ALL.without(Effect::Shadows).without(Effect::DepthOfField);
    let off = Link { effects: Some(effects), ..Link::to_scene("a") };
    assert_eq!(off.to_string(), "rayscope:a?without=depth-of-field,shadows");
    assert_eq!(link(&off.to_string()), off);
}

#[test]
fn a_scene_that_is_too_long_for_a_link_is_refused_with_the_way_out() {
    // Digits of a sequence that does not repeat, so that it cannot be packed to nothing.
    let text: String =
        (0..60_000_u64).map(|i| (i.wrapping_mul(i).wrapping_mul(2_654_435_761) >> 7).to_string()).collect();
    let long = Link { text: Some(text), ..Link::to_scene("mine") };
    let message = long.written().unwrap_err().to_string();
    assert!(message.contains("32000") && message.contains("send its file"), "{message}");
    assert!(error(&long.to_string()).contains("ask for the file"));
}

#[test]
fn an_event_is_found_where_it_was() {
    let tree = bowl();
    for id in 0..tree.end() {
        assert_eq!(EventPlace::of(&tree, id).find(&tree), Found { event: id, notice: None });
    }
}

#[test]
fn the_step_of_a_lesson_is_counted_from_one_as_people_do() {
    let place = LessonPlace { lesson: "06_cube".to_owned(), step: 2 };
    let written = Link { lesson: Some(place), ..Link::to_scene("csg/bowl") };
    assert_eq!(written.to_string(), "rayscope:csg/bowl?lesson=06_cube,3");
    assert_eq!(link(&written.to_string()), written);
    assert!(error("rayscope:a?lesson=06_cube,0").contains("counted from 1"));
    assert!(error("rayscope:a?lesson=06_cube").contains("such as 06_cube,3"));
}

#[test]
fn an_event_that_has_moved_is_found_by_its_kinds_with_a_notice() {
    let tree = bowl();
    let hit = tree.events.iter().find(|event| matches!(event.what, crate::record::What::Hit { .. })).unwrap().id;
    let place = EventPlace { number: hit + 5, ..EventPlace::of(&tree, hit) };
    let found = place.find(&tree);
    assert_eq!(found.event, hit);
    let notice = found.notice.unwrap();
    assert!(notice.contains("not where it was") && notice.contains("nearest of its kind"), "{notice}");
}

#[test]
fn an_event_of_a_kind_that_is_gone_falls_to_what_held_it() {
    let tree = bowl();
    let hit = tree.events.iter().find(|event| matches!(event.what, crate::record::What::Hit { .. })).unwrap();
    let mut place = EventPlace::of(&tree, hit.id);
    place.path.push("Gone".to_owned());
    place.number += 1;
    let found = place.find(&tree);
    assert_eq!(found.event, hit.id);
    assert!(found.notice.unwrap().contains("none of its kind"));
}

#[test]
fn a_number_past_the_end_without_kinds_falls_to_an_event_that_there_is() {
    let tree = bowl();
    let found = EventPlace { number: EventPlace::default().number + 1_000_000, path: Vec::new() }.find(&tree);
    assert_eq!(found.event, tree.end() - 1);
    assert!(found.notice.is_some());
}

fn word() -> impl Strategy<Value = String> {
    "\\PC{1,20}"
}

fn finite() -> impl Strategy<Value = f64> {
    any::<f64>().prop_filter("finite", |x| x.is_finite())
}

fn aims() -> impl Strategy<Value = Aim> {
    let ray = prop::array::uniform6(finite()).prop_filter("a direction", |ray| ray[3..].iter().any(|x| *x != 0.0));
    prop_oneof![
        any::<[u32; 2]>().prop_map(Aim::Pixel),
        ray.prop_map(|[a, b, c, d, e, f]| Aim::Ray([DVec3::new(a, b, c), DVec3::new(d, e, f)])),
    ]
}

fn places() -> impl Strategy<Value = EventPlace> {
    (any::<u32>(), prop::collection::vec("[A-Za-z]{1,12}", 0..9)).prop_map(|(number, path)| EventPlace { number, path })
}

prop_compose! {
    fn links()(
        scene in word(),
        text in prop::option::of("\\PC{0,200}"),
        aim in prop::option::of(aims()),
        size in prop::option::of([1..u32::MAX, 1..u32::MAX]),
        event in prop::option::of(places()),
        words in prop::array::uniform3(prop::option::of(word())),
        views in prop::collection::vec(word(), 0..4),
        theme in prop::option::of(prop::sample::select(Theme::ALL.to_vec())),
        t in prop::option::of(finite()),
        orbit in prop::option::of(prop::array::uniform3(finite())),
        accuracy in prop::option::of(prop_oneof![
            "[a-z]{1,9}".prop_map(Accuracy::Named),
            "\\PC{0,80}".prop_map(Accuracy::Text),
        ]),
        off in prop::option::of(prop::collection::vec(0..Effect::ALL.len(), 0..5)),
        lesson in prop::option::of((word(), 0..u32::MAX).prop_map(|(lesson, step)| LessonPlace { lesson, step })),
    ) -> Link {
        let [level, preset, language] = words;
        let effects = off.map(|off| off.into_iter().fold(Effects::ALL, |all, i| all.without(Effect::ALL[i])));
        Link { scene, text, aim, size, event, level, preset, views, theme, language, t, orbit, accuracy, effects, lesson }
    }
}

proptest! {
    #[test]
    fn every_link_comes_back_as_it_went_out(link in links()) {
        let text = link.to_string();
        prop_assert!(text.chars().all(|c| c.is_ascii_graphic()), "{}", text);
        prop_assert_eq!(text.parse::<Link>(), Ok(link));
    }

    #[test]
    fn no_text_makes_reading_a_link_fail_in_another_way_than_with_a_message(text in "\\PC{0,120}", tail in any::<Vec<u8>>()) {
        let _ = text.parse::<Link>();
        let _ = format!("rayscope:{text}?pixel={text}&text={text}").parse::<Link>();
        let tail = String::from_utf8_lossy(&tail);
        for name in ["pixel", "ray", "size", "event", "path", "t", "orbit", "accuracy", "without", "text", "views"] {
            if let Err(error) = format!("rayscope:a?{name}={tail}").parse::<Link>() {
                prop_assert!(error.to_string().len() > 20);
            }
        }
    }

    #[test]
    fn a_link_with_a_changed_character_is_read_or_refused(link in links(), at in any::<prop::sample::Index>(), with in any::<char>()) {
        let mut characters: Vec<char> = link.to_string().chars().collect();
        let at = at.index(characters.len());
        characters[at] = with;
        let _ = characters.into_iter().collect::<String>().parse::<Link>();
    }
}
