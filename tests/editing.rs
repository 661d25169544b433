//! Editing a scene's text: what is changed can be taken back, what is not changed stays, and what is offered is allowed.

use proptest::prelude::*;
use rayscope::document::{
    Cause, Completion, Document, Journal, Place, Recovered, Replacement, Selection, Structure, Syntax, Write, complete,
    written,
};
use rayscope::scene::{embedded_scenes, load, scene_schema};
use serde_json::{Value, json};

/// Something that a person does to a text.
#[derive(Clone, Debug)]
enum Deed {
    Type(usize, String),
    Delete(usize, usize),
    Set(u8, f64),
    Undo,
    Redo,
    Move(usize),
    Save,
}

fn deed() -> impl Strategy<Value = Deed> {
    prop_oneof![
        4 => (any::<usize>(), "[a-z{}\",: \\né∪]{1,3}").prop_map(|(at, text)| Deed::Type(at, text)),
        2 => (any::<usize>(), 1..5_usize).prop_map(|(at, count)| Deed::Delete(at, count)),
        2 => (0..3_u8, -5.0..5.0).prop_map(|(which, value)| Deed::Set(which, value)),
        1 => Just(Deed::Undo),
        1 => Just(Deed::Redo),
        1 => any::<usize>().prop_map(Deed::Move),
        1 => Just(Deed::Save),
    ]
}

fn border(text: &str, at: usize) -> usize {
    text.floor_char_boundary(at % (text.len() + 1))
}

fn edited(text: &str, range: std::ops::Range<usize>, with: &str) -> String {
    let mut text = text.to_owned();
    text.replace_range(range, with);
    text
}

fn change(document: &mut Document, place: &str, value: &Value) -> bool {
    let syntax = Syntax::of(document.text());
    let place = Place::read(place).expect("a place");
    let changes = Structure { text: document.text(), syntax: &syntax }.set(&place, value);
    changes.is_some_and(|changes| document.replace(changes, Cause::part_of("Change", place.to_string())))
}

fn act(document: &mut Document, deed: &Deed) {
    match deed {
        Deed::Type(at, letters) => {
            let at = border(document.text(), *at);
            let text = edited(document.text(), at..at, letters);
            document.typed(&text, Selection::at(at + letters.len()), "Type");
        }
        Deed::Delete(at, count) => {
            let at = border(document.text(), *at);
            let end = border(document.text(), (at + count).min(document.text().len()));
            let text = edited(document.text(), at..end.max(at), "");
            document.typed(&text, Selection::at(at), "Type");
        }
        Deed::Set(which, value) => {
            let place = ["camera.eye[1]", "lens.radius", "objects[0].transform[0].translate[2]"][usize::from(*which)];
            change(document, place, &json!(value));
        }
        Deed::Undo => drop(document.undo().map(str::to_owned)),
        Deed::Redo => drop(document.redo().map(str::to_owned)),
        Deed::Move(at) => document.select(Selection::at(border(document.text(), *at))),
        Deed::Save => document.mark_saved(),
    }
}

const SMALL: &str = "{\n  \"camera\": { \"eye\": [1, 2, 3] },\n  \"objects\": [{ \"shape\": \"sphere\", \"transform\": [{ \"translate\": [0, 0, 1] }] }]\n}\n";

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, ..ProptestConfig::default() })]

    #[test]
    fn undoing_everything_gives_the_text_back_bit_for_bit_and_redoing_the_last(deeds in prop::collection::vec(deed(), 0..40)) {
        let mut document = Document::new(SMALL);
        for deed in &deeds {
            act(&mut document, deed);
        }
        while document.redo().is_some() {}
        let (last, cursor) = (document.text().to_owned(), document.selection());
        let mut steps = 0;
        while document.undo().is_some() {
            steps += 1;
        }
        prop_assert_eq!(document.text(), SMALL);
        for _ in 0..steps {
            prop_assert!(document.redo().is_some());
        }
        prop_assert!(document.redo().is_none());
        prop_assert_eq!(document.text(), &last);
        prop_assert!(steps == 0 || document.selection() == cursor || deeds.iter().any(|deed| matches!(deed, Deed::Move(_) | Deed::Undo | Deed::Redo)));
    }

    #[test]
    fn a_document_is_dirty_exactly_where_its_text_is_not_the_saved_one(deeds in prop::collection::vec(deed(), 0..30)) {
        let mut document = Document::new(SMALL);
        for deed in &deeds {
            act(&mut document, deed);
            prop_assert_eq!(document.is_dirty(), document.text() != document.saved());
        }
    }

    #[test]
    fn a_journal_holds_what_was_last_noted_wherever_it_ends(deeds in prop::collection::vec(deed(), 1..20), end in any::<prop::sample::Index>()) {
        let (mut document, mut journal, mut file) = (Document::new(SMALL), Journal::default(), Vec::new());
        let mut states: Vec<(usize, String)> = Vec::new();
        for (when, deed) in deeds.iter().enumerate() {
            act(&mut document, deed);
            match journal.note(&document, "small", when as u64) {
                Some(Write::Anew(bytes)) => (file, states) = (bytes, Vec::new()),
                Some(Write::More(bytes)) => file.extend(bytes),
                None => {}
            }
            states.push((file.len(), document.text().to_owned()));
        }
        let read = Recovered::read(&file).expect("a whole journal");
        prop_assert_eq!((read.text.as_str(), read.saved.as_str()), (document.text(), document.saved()));
        let cut = end.index(file.len() + 1);
        let whole = states.iter().rev().find(|(end, _)| *end <= cut).map(|(_, text)| text.as_str());
        let read = Recovered::read(&file[..cut]);
        prop_assert_eq!(read.as_ref().map(|state| state.text.as_str()), whole);
    }

    #[test]
    fn any_text_has_a_tree_whose_places_lead_back_to_their_values(text in "[{}\\[\\]\",:a-c0-3 \\n/*-]{0,60}", at in any::<usize>()) {
        let syntax = Syntax::of(&text);
        let node = syntax.node_at(border(&text, at));
        prop_assert!(node.is_none_or(|node| syntax.nodes[node].range.end <= text.len()));
        for (id, node) in syntax.nodes.iter().enumerate() {
            let outer = node.parent.map_or(0..text.len(), |parent| syntax.nodes[parent].range.clone());
            prop_assert!(outer.start <= node.range.start && node.range.end <= outer.end);
            let place = syntax.place(id);
            let found = syntax.find(&place);
            // A field that stands twice is found where it counts; one without a name in an object cannot be found.
            prop_assert!(found.is_none_or(|found| syntax.place(found) == place));
        }
        let _ = complete(&text, &syntax, border(&text, at));
        prop_assert!(syntax.tokens.is_sorted_by(|a, b| a.range.end <= b.range.start));
    }

    #[test]
    fn where_a_text_is_json_its_tree_holds_the_same_values(value in json_value()) {
        for text in [written(&value), serde_json::to_string_pretty(&value).unwrap()] {
            let syntax = Syntax::of(&text);
            prop_assert_eq!(syntax.value(&text, syntax.root().unwrap()), value.clone());
        }
    }

    #[test]
    fn setting_a_value_sets_it_and_nothing_else(value in json_value(), new in json_value(), pick in any::<prop::sample::Index>()) {
        let text = serde_json::to_string_pretty(&value).unwrap();
        let syntax = Syntax::of(&text);
        let place = syntax.place(pick.index(syntax.nodes.len()));
        let changes = Structure { text: &text, syntax: &syntax }.set(&place, &new).unwrap();
        let mut document = Document::new(text.clone());
        document.replace(changes, Cause::new("Set"));
        let mut expected = value;
        *expected.pointer_mut(&pointer(&place)).unwrap() = new;
        prop_assert_eq!(serde_json::from_str::<Value>(document.text()).unwrap(), expected);
    }

    #[test]
    fn removing_a_value_removes_it_and_nothing_else(value in json_value(), pick in any::<prop::sample::Index>(), pretty in any::<bool>()) {
        let text = if pretty { serde_json::to_string_pretty(&value).unwrap() } else { written(&value) };
        let syntax = Syntax::of(&text);
        let place = syntax.place(pick.index(syntax.nodes.len()));
        let Some((above, step)) = place.parent() else { return Ok(()) };
        let changes = Structure { text: &text, syntax: &syntax }.remove(&place).unwrap();
        let mut document = Document::new(text.clone());
        document.replace(changes, Cause::new("Remove"));
        let mut expected = value;
        match (expected.pointer_mut(&pointer(&above)).unwrap(), step) {
            (Value::Object(map), rayscope::document::Step::Field(name)) => drop(map.shift_remove(name)),
            (Value::Array(list), rayscope::document::Step::Item(index)) => drop(list.remove(*index)),
            other => panic!("{other:?}"),
        }
        prop_assert_eq!(serde_json::from_str::<Value>(document.text()).unwrap(), expected, "{}", document.text());
    }
}

fn json_value() -> impl Strategy<Value = Value> {
    let leaf = prop_oneof![
        Just(Value::Null),
        any::<bool>().prop_map(Value::from),
        (-1000..1000_i32).prop_map(Value::from),
        (-1e3..1e3_f64).prop_map(Value::from),
        "[a-z \"\\\\é{]{0,5}".prop_map(Value::from),
    ];
    leaf.prop_recursive(4, 24, 4, |inner| {
        prop_oneof![
            prop::collection::vec(inner.clone(), 0..4).prop_map(Value::Array),
            prop::collection::btree_map("[a-z \"~/]{0,3}", inner, 0..4).prop_map(|map| map.into_iter().collect()),
        ]
    })
}

fn pointer(place: &Place) -> String {
    let step = |step: &rayscope::document::Step| match step {
        rayscope::document::Step::Field(name) => format!("/{}", name.replace('~', "~0").replace('/', "~1")),
        rayscope::document::Step::Item(index) => format!("/{index}"),
    };
    place.0.iter().map(step).collect()
}

/// A text after structured changes of it.
fn after(text: &str, changes: impl FnOnce(Structure) -> Option<Vec<Replacement>>) -> String {
    let mut document = Document::new(text);
    let syntax = Syntax::of(text);
    document.replace(changes(Structure { text, syntax: &syntax }).expect("possible"), Cause::new("Change"));
    document.text().to_owned()
}

fn place(text: &str) -> Place {
    Place::read(text).expect("a place")
}

const WITH_COMMENTS: &str = "{ // the head
  \"camera\": { \"eye\": [ 1,2 /* y */, 3 ] }, // the eye
  /* all of them */
  \"objects\": [
    { \"shape\": \"sphere\" }, // one
    { \"shape\": \"cube\" } // two
  ]
}
";

#[test]
fn comments_and_layout_stay_when_a_number_changes() {
    let changed = after(WITH_COMMENTS, |structure| structure.set(&place("camera.eye"), &json!([1, -2.5, 3])));
    assert_eq!(changed, WITH_COMMENTS.replace("1,2 /*", "1,-2.5 /*"));
}

#[test]
fn a_new_field_stands_where_the_others_stand() {
    let changed = after(WITH_COMMENTS, |structure| structure.set(&place("limits.depth"), &json!(3)));
    assert_eq!(changed, WITH_COMMENTS.replace("  ]\n}", "  ],\n  \"limits\": { \"depth\": 3 }\n}"));
    let changed = after(WITH_COMMENTS, |structure| structure.set(&place("objects[0].transform"), &json!([])));
    assert_eq!(changed, WITH_COMMENTS.replace("\"sphere\" }", "\"sphere\", \"transform\": [] }"));
    assert_eq!(after("{}", |structure| structure.set(&place("title"), &json!("x"))), "{ \"title\": \"x\" }");
}

#[test]
fn a_new_item_stands_on_a_line_of_its_own_where_the_others_do() {
    let new = json!({ "shape": "cone" });
    let changed = after(WITH_COMMENTS, |structure| structure.insert_item(&place("objects"), 1, &new));
    assert_eq!(
        changed,
        WITH_COMMENTS.replace("    { \"shape\": \"cube\"", "    { \"shape\": \"cone\" },\n    { \"shape\": \"cube\"")
    );
    let changed = after(WITH_COMMENTS, |structure| structure.insert_item(&place("objects"), 2, &new));
    assert_eq!(changed, WITH_COMMENTS.replace("\"cube\" } //", "\"cube\" },\n    { \"shape\": \"cone\" } //"));
}

#[test]
fn what_is_removed_takes_its_comma_and_no_comment_with_it() {
    for removed in ["objects[0]", "objects[1]", "camera", "camera.eye", "objects"] {
        let changed = after(WITH_COMMENTS, |structure| structure.remove(&place(removed)));
        for comment in ["// the head", "// the eye", "/* all of them */"] {
            assert!(changed.contains(comment), "{removed}: {changed}");
        }
        let plain: String = Syntax::of(&changed)
            .tokens
            .iter()
            .filter(|token| token.kind != rayscope::document::TokenKind::Comment)
            .map(|token| changed[token.range.clone()].to_owned() + " ")
            .collect();
        let value: Value = serde_json::from_str(&plain).unwrap_or_else(|error| panic!("{removed}: {error}: {changed}"));
        assert!(
            value.pointer(&pointer(&place(removed)))
                != serde_json::from_str::<Value>(&without_comments()).unwrap().pointer(&pointer(&place(removed)))
        );
    }
}

fn without_comments() -> String {
    let syntax = Syntax::of(WITH_COMMENTS);
    let words = syntax.tokens.iter().filter(|token| token.kind != rayscope::document::TokenKind::Comment);
    words.map(|token| WITH_COMMENTS[token.range.clone()].to_owned() + " ").collect()
}

#[test]
fn a_change_is_made_while_another_part_of_the_text_is_broken() {
    let broken = "{ \"camera\": { \"field_of_view\": 31 }, \"objects\": [ { \"shape\" ";
    let changed = after(broken, |structure| structure.set(&place("camera.field_of_view"), &json!(40)));
    assert_eq!(changed, broken.replace("31", "40"));
    let changed = after("{ \"title\"  }", |structure| structure.set(&place("title"), &json!("x")));
    assert_eq!(changed, "{ \"title\": \"x\"  }");
}

#[test]
fn a_word_before_the_first_bracket_is_wrong_by_itself() {
    let text = "x{ \"camera\": { \"field_of_view\": 31 } }";
    let syntax = Syntax::of(text);
    let wrong = syntax.tokens.iter().filter(|token| token.kind == rayscope::document::TokenKind::Error);
    assert_eq!(wrong.map(|token| &text[token.range.clone()]).collect::<Vec<_>>(), ["x"]);
    assert_eq!(syntax.value_at(text, &place("camera.field_of_view")), Some(json!(31)));
}

/// Offers at the place of `|`.
fn offered(marked: &str) -> (Completion, String, usize) {
    let offset = marked.find('|').expect("a cursor");
    let text = marked.replace('|', "");
    (complete(&text, &Syntax::of(&text), offset), text, offset)
}

fn labels(marked: &str) -> Vec<String> {
    offered(marked).0.items.into_iter().map(|item| item.label).collect()
}

#[test]
fn at_the_top_every_field_of_the_schema_is_offered_that_is_not_there_yet() {
    let schema = scene_schema();
    let all = schema.as_value()["properties"].as_object().expect("properties").keys();
    let expected: Vec<&String> = all.filter(|name| *name != "title").collect();
    let mut found = labels("{ \"title\": \"x\", | }");
    let mut expected: Vec<String> = expected.into_iter().cloned().collect();
    found.sort();
    expected.sort();
    assert_eq!(found, expected);
}

#[test]
fn a_solid_without_a_shape_is_first_asked_for_one_and_then_for_what_that_shape_has() {
    let shapes = labels("{ \"objects\": [{ | }] }");
    assert!(shapes.contains(&"shape: sphere".to_owned()) && shapes.iter().all(|label| label.starts_with("shape: ")));
    assert_eq!(shapes.len(), rayscope::shape::Shape::NAMES.len() + 4, "all primitives, three operators and copies");
    let torus = labels("{ \"objects\": [{ \"shape\": \"torus\", | }] }");
    assert_eq!(torus, ["d", "name", "material", "priority", "transform", "details"]);
    let sphere = labels("{ \"objects\": [{ \"shape\": \"sphere\", \"name\": \"x\", | }] }");
    assert_eq!(sphere, ["material", "priority", "transform", "details"]);
}

#[test]
fn what_is_typed_narrows_the_list_and_what_begins_with_it_comes_first() {
    assert_eq!(labels("{ \"am|")[..1], ["ambient"]);
    let words = labels("{ \"objects\": [{ \"shape\": \"sphere\", \"m|\" }] }");
    assert_eq!(words[0], "material");
    assert!(words.iter().all(|word| word.contains('m')));
}

#[test]
fn names_of_materials_and_solids_are_offered_where_they_are_meant() {
    let head =
        "{ \"materials\": { \"clay\": {}, \"glass\": {} }, \"solids\": { \"globe\": { \"shape\": \"sphere\" } }, ";
    assert_eq!(
        labels(&format!("{head}\"objects\": [{{ \"shape\": \"cube\", \"material\": | }}] }}")),
        ["clay", "glass"]
    );
    assert_eq!(labels(&format!("{head}\"objects\": [{{ \"shape\": \"copy\", \"solid\": \"g| }}] }}")), ["globe"]);
}

#[test]
fn words_of_a_choice_are_offered_with_what_they_mean() {
    let (completion, ..) = offered("{ \"media\": | }");
    let words: Vec<_> = completion.items.iter().map(|item| item.label.as_str()).collect();
    assert_eq!(words, ["forbid", "most_recent", "priority"]);
    assert!(completion.items.iter().all(|item| !item.about.is_empty()));
}

#[test]
fn nothing_is_offered_where_nothing_may_stand() {
    for marked in ["{ \"title\": \"x\" | }", "{ } |", "{ \"title\" | }", "// {| }\n{}", "{ \"unknown\": { | } }"] {
        assert_eq!(labels(marked), [""; 0], "{marked}");
    }
}

#[test]
fn every_field_that_is_offered_at_an_object_of_a_scene_can_be_taken_and_loads() {
    // What needs more than itself: a file, names that must exist, or a use for it elsewhere in the scene.
    let needs_more =
        ["file", "environment", "lens", "texture", "bump", "frame", "medium", "mirrors", "solid", "priority"];
    let mut taken = 0;
    for scene in embedded_scenes()
        .into_iter()
        .filter(|scene| ["csg", "hello", "optics"].iter().any(|topic| scene.name.starts_with(topic)))
    {
        let syntax = Syntax::of(scene.text);
        for node in &syntax.nodes {
            if node.kind != rayscope::document::NodeKind::Object || node.children.is_empty() {
                continue;
            }
            let end = syntax.nodes[*node.children.last().expect("not empty")].range.end;
            let text = edited(scene.text, end..end, ", ");
            for item in complete(&text, &Syntax::of(&text), end + 2).items {
                if needs_more.contains(&item.label.as_str()) {
                    continue;
                }
                let with = edited(&text, end + 2..end + 2, &item.text);
                if let Err(errors) = load(&with, &scene.name) {
                    let told: Vec<_> = errors.errors.iter().map(|error| error.message.clone()).collect();
                    assert!(
                        told.iter().all(|told| !told.contains("unknown field") && !told.contains("JSON")),
                        "{}: {}: {told:?}",
                        scene.name,
                        item.text
                    );
                    // Two fields may exclude each other; the schema knows nothing of that.
                    assert!(
                        told.iter().all(|told| is_about_the_whole(told)),
                        "{}: `{}`: {told:?}",
                        scene.name,
                        item.text
                    );
                }
                taken += 1;
            }
        }
    }
    assert!(taken > 500, "{taken}");
}

/// Rules between fields, which no schema states: the check of the scene as a whole does.
fn is_about_the_whole(message: &str) -> bool {
    ["only an object has a priority", "no faces of its own", "transparent", "fresnel", "dispersion"]
        .iter()
        .any(|part| message.contains(part))
}

#[test]
fn every_solid_light_and_step_that_is_offered_in_a_list_loads() {
    let frames = [
        "{ \"materials\": { \"m\": {} }, \"solids\": { \"s\": { \"shape\": \"cube\" } }, \"objects\": [| ] }",
        "{ \"lights\": [| ] }",
        "{ \"materials\": { \"m\": {} }, \"objects\": [{ \"shape\": \"cube\", \"material\": \"m\", \"transform\": [| ] }] }",
    ];
    for (frame, count) in frames.into_iter().zip([14, 3, 4]) {
        let (completion, text, _) = offered(frame);
        assert_eq!(completion.items.len(), count, "{frame}");
        for item in completion.items {
            let mut with = edited(&text, completion.word.clone(), &item.text);
            let refers = item.label == "copy" || item.text.contains("\"of\"");
            if frame.contains("solids") {
                // A solid of its own has a material, and a copy names what it is a copy of.
                with = with.replace("\"solid\": \"\"", "\"solid\": \"s\"");
                with = with.replacen("\"objects\": [{ ", "\"objects\": [{ \"material\": \"m\", ", 1);
            }
            assert!(load(&with, "x.json").is_ok() || refers, "{with}: {}", load(&with, "x.json").unwrap_err());
        }
    }
}
