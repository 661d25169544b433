//! The scenes that come with the program.

use rayscope::scene::{embedded_scene, embedded_scenes, load, scene_schema};
use std::path::Path;

#[test]
fn every_embedded_scene_loads_without_an_error() {
    for scene in embedded_scenes() {
        if let Err(errors) = load(scene.text, &scene.name) {
            panic!("{errors}");
        }
    }
}

#[test]
fn every_scene_is_told_to_the_student_and_has_telling_pixels() {
    for scene in embedded_scenes() {
        let compiled = load(scene.text, &scene.name).unwrap();
        let name = &scene.name;
        assert!(!compiled.title.is_empty(), "{name} has no title");
        let sentences = compiled.about.matches(". ").count() + 1;
        assert!((2..=5).contains(&sentences), "{name} is described in {sentences} sentences");
        assert!(!compiled.sections.is_empty(), "{name} names no section");
        assert!(compiled.sections.iter().all(|section| section.starts_with("6.")), "{name} names a section not of § 6");
        assert!((1..=3).contains(&compiled.pixels.len()), "{name} has {} telling pixels", compiled.pixels.len());
    }
}

#[test]
fn each_primitive_has_a_scene_alone_and_one_in_a_skewed_pose() {
    for shape in rayscope::shape::Shape::NAMES {
        for topic in ["primitives", "skewed"] {
            let name = format!("{topic}/{shape}");
            let scene = embedded_scene(&name).unwrap_or_else(|| panic!("there is no scene {name}"));
            let scene = load(scene.text, &name).unwrap();
            let mut shown = scene.objects.iter().flat_map(|object| &object.solid.leaves);
            assert!(shown.any(|leaf| leaf.shape.name() == *shape), "{name} does not show it");
        }
    }
}

#[test]
fn scenes_are_named_by_topic_and_case_and_come_in_order() {
    let names: Vec<_> = embedded_scenes().into_iter().map(|scene| scene.name).collect();
    assert!(names.len() >= 20);
    assert!(names.is_sorted());
    assert!(names.iter().all(|name| name.split('/').count() == 2));
    for name in
        ["hello/sphere", "csg/lens", "csg/bowl", "csg/rocket", "csg/nested", "optics/fishbowl", "optics/mirrors"]
    {
        assert!(names.iter().any(|other| other == name), "there is no scene {name}");
    }
    assert_eq!(embedded_scene("scene.schema"), None);
    assert_eq!(embedded_scene("csg/no_such_scene"), None);
}

/// Run with `RAYSCOPE_UPDATE=1` to write the schema anew.
#[test]
fn the_committed_schema_is_the_one_that_the_types_give() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/scene.schema.json");
    let schema = format!("{}\n", serde_json::to_string_pretty(&scene_schema()).unwrap());
    if std::env::var_os("RAYSCOPE_UPDATE").is_some() {
        std::fs::write(&path, &schema).unwrap();
    }
    let committed = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(schema == committed, "scenes/scene.schema.json is out of date: `rayscope schema scene` prints the new one");
}

#[test]
fn every_scene_is_valid_by_the_committed_schema() {
    let schema = serde_json::to_value(scene_schema()).unwrap();
    let validator = jsonschema::validator_for(&schema).unwrap();
    for scene in embedded_scenes() {
        let value: serde_json::Value = serde_json::from_str(scene.text).unwrap();
        let errors: Vec<_> = validator.iter_errors(&value).map(|error| error.to_string()).collect();
        assert_eq!(errors, Vec::<String>::new(), "{}", scene.name);
    }
}
