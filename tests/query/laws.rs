//! Laws that hold of every question and every tree.

use proptest::prelude::*;
use rayscope::query::{PRESETS, Query, TermKind, terms};
use rayscope::record::EventId;
use rayscope::scene::{embedded_scene, load};
use rayscope::trace::{RayTree, record_pixel};
use std::collections::BTreeSet;
use std::sync::LazyLock;

/// Recorded pixels with most kinds of events among them.
static TREES: LazyLock<Vec<RayTree>> = LazyLock::new(|| {
    let names = ["csg/bowl", "optics/glass_cube", "optics/fishbowl", "spectrum/prism", "media/smoke", "lens/focus"];
    let record = |name| {
        let scene = load(embedded_scene(name).unwrap().text, name).unwrap();
        let [x, y] = scene.pixels[0];
        record_pixel(&scene, x, y)
    };
    names.into_iter().map(record).collect()
});

fn events(question: &str, tree: &RayTree) -> BTreeSet<EventId> {
    Query::parse(question).unwrap_or_else(|error| panic!("{question}: {error}")).matches(tree).collect()
}

/// Questions of all shapes.
fn questions() -> impl Strategy<Value = String> {
    let simple: Vec<String> = terms()
        .map(|term| term.example.to_owned())
        .chain(["object=*".to_owned(), "t!=3".to_owned(), "depth<1".to_owned(), "part!=\"a b\\*\"".to_owned()])
        .collect();
    let leaf = prop::sample::select(simple).prop_map(|question| format!("({question})"));
    leaf.prop_recursive(4, 24, 3, |inner| {
        prop_oneof![
            inner.clone().prop_map(|a| format!("!{a}")),
            inner.clone().prop_map(|a| format!("has({a})")),
            (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("({a} & {b})")),
            (inner.clone(), inner).prop_map(|(a, b)| format!("({a} | {b})")),
        ]
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn what_is_written_down_reads_the_same(question in questions()) {
        let read = Query::parse(&question).unwrap();
        let written = read.to_string();
        prop_assert_eq!(Query::parse(&written), Ok(read), "{}", written);
    }

    #[test]
    fn the_signs_are_those_of_sets_of_events(a in questions(), b in questions()) {
        for tree in TREES.iter() {
            let [of_a, of_b] = [&a, &b].map(|question| events(question, tree));
            let all: BTreeSet<EventId> = (0..tree.end()).collect();
            prop_assert_eq!(events(&format!("{a} & {b}"), tree), &of_a & &of_b);
            prop_assert_eq!(events(&format!("{a} | {b}"), tree), &of_a | &of_b);
            prop_assert_eq!(events(&format!("!{a}"), tree), &all - &of_a);
            prop_assert_eq!(events(&format!("!!{a}"), tree), of_a);
            let [left, right] = [format!("!({a} & {b})"), format!("!{a} | !{b}")].map(|question| events(&question, tree));
            prop_assert_eq!(left, right, "De Morgan");
        }
    }

    #[test]
    fn has_holds_of_an_event_and_of_all_above_it(a in questions()) {
        for tree in TREES.iter() {
            let above: BTreeSet<EventId> = events(&a, tree).into_iter().flat_map(|id| tree.path(id)).collect();
            prop_assert_eq!(events(&format!("has({a})"), tree), above);
        }
    }

    #[test]
    fn no_text_makes_it_panic(text in "[a-z.=<>!&|()\"\\\\* 0-9äθ₁≤¬-]{0,40}") {
        match Query::parse(&text) {
            Ok(query) => prop_assert_eq!(Query::parse(&query.to_string()), Ok(query)),
            Err(error) => prop_assert!(error.column >= 1 && error.column <= text.chars().count() + 1, "{:?}", error),
        }
    }
}

#[test]
fn every_term_has_a_meaning_and_an_example_that_names_it() {
    let mut seen = BTreeSet::new();
    for term in terms() {
        assert!(seen.insert((term.name, term.is_field())), "{} is there twice", term.name);
        assert!(!term.meaning.is_empty() && !term.meaning.ends_with('.'), "{}", term.name);
        assert!(term.example.contains(term.name), "{}: {}", term.name, term.example);
        Query::parse(term.example).unwrap_or_else(|error| panic!("{}: {error}", term.example));
    }
}

#[test]
fn every_preset_can_be_asked() {
    for preset in PRESETS {
        Query::parse(preset.query).unwrap_or_else(|error| panic!("{}: {error}", preset.query));
    }
    let keys: BTreeSet<&str> = PRESETS.iter().map(|preset| preset.key).collect();
    assert_eq!(keys.len(), PRESETS.len());
}

#[test]
fn a_comparison_and_its_opposite_hold_together_where_the_field_has_a_value() {
    for field in terms().filter(|term| term.kind() == TermKind::Numbers).map(|term| term.name) {
        for tree in TREES.iter() {
            let by_order = events(&format!("{field}<1 | {field}>=1"), tree);
            let by_sameness = events(&format!("{field}=1 | {field}!=1"), tree);
            assert_eq!(by_order, by_sameness, "{field}");
        }
    }
}

#[test]
fn errors_name_the_column_and_the_nearest_word() {
    for (text, column, nearest) in [
        ("tri", 1, Some("tir")),
        ("hit & undecidible", 7, Some("undecidable")),
        ("kind=refrcted", 6, Some("refracted")),
        ("objct=lens", 1, Some("object")),
        ("", 1, None),
        ("tir &", 6, None),
        ("tir hit", 5, None),
        ("(tir", 5, None),
        ("tir)", 4, None),
        ("depth", 1, None),
        ("depth>=deep", 8, None),
        ("depth>=", 8, None),
        ("object<lens", 7, None),
        ("tir=3", 4, None),
        ("= 3", 1, None),
        ("object=\"lens", 8, None),
        ("& tir", 1, None),
        ("has", 1, None),
        ("tir & \\", 7, None),
    ] {
        let error = Query::parse(text).expect_err(text);
        assert_eq!((error.column, error.nearest.as_deref()), (column, nearest), "{text}: {error}");
    }
}

#[test]
fn deep_nesting_is_refused_and_not_followed() {
    let text = format!("{}tir{}", "(".repeat(100_000), ")".repeat(100_000));
    assert!(Query::parse(&text).is_err());
    assert!(Query::parse(&format!("{}tir", "!".repeat(100_000))).is_err());
}
