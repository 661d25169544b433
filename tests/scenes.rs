//! The scenes that come with the program.

use glam::DVec3;
use rayscope::csg::Node;
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

#[test]
fn objects_without_a_name_are_named_after_their_shape_and_numbered() {
    let text = r#"{"materials": {"m": {}}, "objects": [
        {"shape": "sphere", "material": "m"},
        {"shape": "cube", "material": "m", "name": "sphere 2"},
        {"shape": "sphere", "material": "m"},
        {"shape": "cone", "material": "m"}
    ]}"#;
    let scene = load(text, "names.json").unwrap();
    let names: Vec<_> = scene.objects.iter().map(|object| object.name.as_str()).collect();
    assert_eq!(names, ["sphere", "sphere 2", "sphere 3", "cone"]);
}

#[test]
fn materials_stand_on_leaves_or_are_taken_from_the_compound_around_them() {
    let text = r#"{"materials": {"clay": {}, "glass": {}}, "solids": {"ball": {"shape": "sphere", "material": "clay"}},
    "objects": [{"shape": "difference", "material": "glass", "of": [
        {"shape": "cube"}, {"shape": "union", "material": "clay", "of": [{"shape": "cone"}]}, {"shape": "copy", "solid": "ball"}
    ]}]}"#;
    let scene = load(text, "materials.json").unwrap();
    let object = &scene.objects[0];
    let names: Vec<_> = object.leaf_materials.iter().map(|&i| scene.materials[i].name.as_str()).collect();
    assert_eq!(names, ["glass", "clay", "clay"]);
    assert_eq!(scene.materials[object.material].name, "glass");
}

#[test]
fn transforms_are_applied_in_order_and_those_of_compounds_after_those_of_their_parts() {
    let text = r#"{"materials": {"m": {}}, "objects": [{"shape": "union", "material": "m",
        "transform": [{"rotate": {"axis": [0, 0, 1], "degrees": 90}}, {"translate": [0, 0, 5]}],
        "of": [{"shape": "sphere", "transform": [{"scale": [2, 1, 1]}, {"translate": [10, 0, 0]}]}]}]}"#;
    let scene = load(text, "transforms.json").unwrap();
    let placement = &scene.objects[0].solid.leaves[0].placement;
    // (1, 0, 0) is scaled to (2, 0, 0), moved to (12, 0, 0), turned to (0, 12, 0) and moved to (0, 12, 5).
    assert_eq!(placement.world_from_generic().transform_point3(DVec3::X), DVec3::new(0.0, 12.0, 5.0));
}

#[test]
fn operands_are_folded_from_the_left() {
    let text = r#"{"materials": {"m": {}}, "objects": [{"shape": "difference", "name": "abc", "material": "m",
        "of": [{"shape": "cube"}, {"shape": "sphere"}, {"shape": "cone"}]}]}"#;
    let scene = load(text, "fold.json").unwrap();
    let solid = &scene.objects[0].solid;
    let Node::Pair { name, left, right, .. } = solid.root() else { panic!("the root is not a pair") };
    assert_eq!(name, "abc");
    assert!(matches!(solid.nodes[*right], Node::Leaf { leaf: 2, .. }));
    let Node::Pair { name, left, right, .. } = &solid.nodes[*left] else { panic!("the left side is not a pair") };
    assert_eq!(name, "difference");
    assert!(matches!(
        (&solid.nodes[*left], &solid.nodes[*right]),
        (Node::Leaf { leaf: 0, .. }, Node::Leaf { leaf: 1, .. })
    ));
}

#[test]
fn an_empty_object_is_an_empty_scene_with_every_default() {
    let scene = load("{}", "empty.json").unwrap();
    assert_eq!((scene.image.width, scene.image.height), (640, 480));
    assert!(scene.objects.is_empty() && scene.lights.is_empty() && scene.pixels.is_empty());
    assert_eq!((scene.limits.depth, scene.limits.contribution), (8, 0.002));
    assert!((scene.camera.forward.length() - 1.0).abs() < 1e-15);
}
