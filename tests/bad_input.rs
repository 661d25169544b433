//! Broken scene files: each has to be refused with the place, what was read, what was expected and what to do.

use proptest::prelude::*;
use rayscope::scene::{compile_solid, embedded_scenes, load};

/// A text with one mistake, where it is (line, column, path in the JSON), and what has to be said about it.
struct Case {
    text: &'static str,
    place: &'static str,
    message: &'static str,
    help: &'static str,
}

/// Whole files.
const FILES: &[Case] = &[
    Case { text: "", place: "1:1", message: "the file is empty: expected a JSON object, `{ … }`", help: "" },
    Case { text: "   \n  ", place: "1:1", message: "the file is empty: expected a JSON object, `{ … }`", help: "" },
    Case { text: "{", place: "1:1", message: "this is not JSON: unterminated object", help: "" },
    Case {
        text: r#"{"title": "a" "about": "b"}"#,
        place: "1:14",
        message: "this is not JSON: expected comma",
        help: "",
    },
    Case {
        text: "{\n  \"title\": \"a\",\n}",
        place: "2:15",
        message: "this is not JSON: trailing commas are not allowed",
        help: "",
    },
    Case { text: "{} // the end", place: "1:4", message: "this is not JSON: comments are not allowed", help: "" },
    Case {
        text: "{'title': 1}",
        place: "1:2",
        message: "this is not JSON: single-quoted strings are not allowed",
        help: "",
    },
    Case {
        text: "{title: 1}",
        place: "1:2",
        message: "this is not JSON: the name of a field needs double quotes",
        help: "",
    },
    Case { text: r#"{"title": "a"#, place: "1:11", message: "this is not JSON: unterminated string literal", help: "" },
    Case { text: r#"{"title": "\q"}"#, place: "1:12", message: "this is not JSON: invalid escape", help: "" },
    Case {
        text: r#"{"ambient": [NaN, 0, 0]}"#,
        place: "1:14",
        message: "this is not JSON: `NaN` cannot stand here",
        help: "",
    },
    Case {
        text: r#"{"ambient": [+1, 0, 0]}"#,
        place: "1:14",
        message: "this is not JSON: unary plus on numbers is not allowed",
        help: "",
    },
    Case {
        text: r#"{"ambient": [1., 0, 0]}"#,
        place: "1:14",
        message: "this is not JSON: leading or trailing decimal points on numbers are not allowed",
        help: "",
    },
    Case { text: r#"{"ambient": [01, 0, 0]}"#, place: "1:15", message: "this is not JSON: expected comma", help: "" },
    Case {
        text: r#"{"ambient": [-, 0, 0]}"#,
        place: "1:15",
        message: "this is not JSON: expected digit following negative sign",
        help: "",
    },
    Case {
        text: "{} {}",
        place: "1:4",
        message: "this is not JSON: text cannot contain more than one JSON value",
        help: "",
    },
    Case { text: "[]", place: "1:1", message: "expected an object, `{ … }`, found an empty list", help: "" },
    Case {
        text: "{\"title\": \"a\",\n \"title\": \"b\"}",
        place: "2:2 at title",
        message: "`title` stands here more than once",
        help: "keep one of them",
    },
    Case {
        text: r#"{"colour": 1}"#,
        place: "1:2 at colour",
        message: "unknown field `colour`",
        help: "the fields here are `$schema`, `title`, `about`, `sections`, `camera`, `image`, `ambient`, `background`, `lights`, `materials`, `solids`, `objects`, `media`, `limits`, `pixels`",
    },
    Case {
        text: r#"{"camrea": {}}"#,
        place: "1:2 at camrea",
        message: "unknown field `camrea`",
        help: "did you mean `camera`?",
    },
    Case {
        text: r#"{"title": 5}"#,
        place: "1:11 at title",
        message: "expected a string, found the number 5",
        help: "",
    },
    Case {
        text: r#"{"sections": ["6.1", 6.2]}"#,
        place: "1:22 at sections[1]",
        message: "expected a string, found the number 6.2",
        help: "",
    },
    Case {
        text: r#"{"ambient": "red"}"#,
        place: "1:13 at ambient",
        message: r#"expected a list of 3 numbers of 0 or more, found the string "red""#,
        help: "",
    },
    Case {
        text: r#"{"ambient": [1, 1]}"#,
        place: "1:13 at ambient",
        message: "expected a list of 3 numbers of 0 or more, found 2",
        help: "",
    },
    Case {
        text: r#"{"ambient": [1, -0.5, 1]}"#,
        place: "1:17 at ambient[1]",
        message: "expected a number, 0 or more, found -0.5",
        help: "",
    },
    Case {
        text: r#"{"camera": {"eye": [0, 0, 1e999]}}"#,
        place: "1:27 at camera.eye[2]",
        message: "the number `1e999` is too large",
        help: "the largest number that can be held is about 1.8e308",
    },
    Case {
        text: r#"{"camera": {"field_of_view": 180}}"#,
        place: "1:30 at camera.field_of_view",
        message: "expected a number, more than 0 and less than 180, found 180",
        help: "",
    },
    Case {
        text: r#"{"camera": {"field_of_view": 0}}"#,
        place: "1:30 at camera.field_of_view",
        message: "expected a number, more than 0 and less than 180, found 0",
        help: "",
    },
    Case {
        text: r#"{"camera": {"eye": [1, 2, 3], "look_at": [1, 2, 3]}}"#,
        place: "1:42 at camera.look_at",
        message: "`look_at` is the same point as `eye`, so there is no direction to look in",
        help: "",
    },
    Case {
        text: "{\"camera\": {\"eye\": [0, 0, 9],\n  \"up\": [0, 0, 1]}}",
        place: "2:9 at camera.up",
        message: "`up` is parallel to the view from `eye` to `look_at`, so the picture has no top",
        help: "choose another `up`, such as [0, 0, 1] or [0, 1, 0]",
    },
    Case {
        text: r#"{"camera": {"up": [0, 0, 0]}}"#,
        place: "1:19 at camera.up",
        message: "`up` must not be (0, 0, 0)",
        help: "",
    },
    Case {
        text: r#"{"image": {"width": 0, "height": 480}}"#,
        place: "1:21 at image.width",
        message: "expected a whole number, 1 or more, found 0",
        help: "",
    },
    Case {
        text: r#"{"image": {"width": 640.5, "height": 480}}"#,
        place: "1:21 at image.width",
        message: "expected a whole number, 1 or more, found 640.5",
        help: "",
    },
    Case {
        text: r#"{"image": {"width": -640, "height": 480}}"#,
        place: "1:21 at image.width",
        message: "expected a whole number, 1 or more, found -640",
        help: "",
    },
    Case {
        text: r#"{"image": {"width": 100000, "height": 100000}}"#,
        place: "1:11 at image",
        message: "an image of 100000 × 100000 has too many pixels",
        help: "at most 64000000 pixels can be computed",
    },
    Case {
        text: r#"{"image": {"width": 5000000000, "height": 1}}"#,
        place: "1:21 at image.width",
        message: "expected a whole number, 1 or more and 4294967295 at most, found 5000000000",
        help: "",
    },
    Case {
        text: r#"{"pixels": [[0, 0], [640, 0]]}"#,
        place: "1:21 at pixels[1]",
        message: "the pixel (640, 0) lies outside the image",
        help: "the image has columns 0 to 639 and rows 0 to 479",
    },
    Case {
        text: r#"{"pixels": [[-1, 0]]}"#,
        place: "1:14 at pixels[0][0]",
        message: "expected a whole number, 0 or more, found -1",
        help: "",
    },
    Case {
        text: r#"{"lights": [{"colour": [1, 1, 1]}]}"#,
        place: "1:13 at lights[0]",
        message: "expected one of the fields `point`, `directional`",
        help: "",
    },
    Case {
        text: r#"{"lights": [{"pont": [1, 1, 1]}]}"#,
        place: "1:14 at lights[0].pont",
        message: "unknown field `pont`",
        help: "did you mean `point`?",
    },
    Case {
        text: r#"{"lights": [{"point": [0, 0, 1], "directional": [1, 1, 1]}]}"#,
        place: "1:13 at lights[0]",
        message: "`point` and `directional` cannot stand together",
        help: "keep one of `point`, `directional`",
    },
    Case {
        text: r#"{"lights": [{"directional": [0, 0, 0]}]}"#,
        place: "1:29 at lights[0].directional",
        message: "the direction towards a light must not be (0, 0, 0)",
        help: "",
    },
    Case {
        text: r#"{"materials": {"blue glass": {"reflectivity": 1.5}}}"#,
        place: r#"1:47 at materials["blue glass"].reflectivity"#,
        message: "expected a number from 0 to 1, found 1.5",
        help: "",
    },
    Case {
        text: r#"{"materials": {"glass": {"index_of_refraction": -1.5}}}"#,
        place: "1:49 at materials.glass.index_of_refraction",
        message: "expected a number, more than 0, found -1.5",
        help: "",
    },
    Case {
        text: r#"{"materials": {"glass": {"index_of_refraction": 0}}}"#,
        place: "1:49 at materials.glass.index_of_refraction",
        message: "expected a number, more than 0, found 0",
        help: "",
    },
    Case {
        text: r#"{"materials": {"clay": {"difuse": [1, 1, 1]}}}"#,
        place: "1:25 at materials.clay.difuse",
        message: "unknown field `difuse`",
        help: "did you mean `diffuse`?",
    },
    Case {
        text: r#"{"materials": {"clay": {"shininess": 20}}}"#,
        place: "1:25 at materials.clay.shininess",
        message: "unknown field `shininess`",
        help: "the fields here are `ambient`, `diffuse`, `specular`, `exponent`, `reflectivity`, `transparency`, `index_of_refraction`",
    },
    Case {
        text: r#"{"materials": []}"#,
        place: "1:15 at materials",
        message: "expected an object, `{ … }`, found an empty list",
        help: "",
    },
    Case {
        text: r#"{"media": "most-recent"}"#,
        place: "1:11 at media",
        message: r#"expected one of "forbid", "most_recent", "priority", found "most-recent""#,
        help: r#"did you mean "most_recent"?"#,
    },
    Case {
        text: r#"{"limits": {"depth": 1000}}"#,
        place: "1:22 at limits.depth",
        message: "expected a whole number from 0 to 50, found 1000",
        help: "",
    },
    Case {
        text: r#"{"limits": {"depth": null}}"#,
        place: "1:22 at limits.depth",
        message: "expected a whole number from 0 to 50, found null",
        help: "",
    },
    Case {
        text: "{\"solids\": {\"a\": {\"shape\": \"copy\", \"solid\": \"b\"},\n  \"b\": {\"shape\": \"union\", \"of\": [{\"shape\": \"copy\", \"solid\": \"a\"}]}}}",
        place: "2:61 at solids.b.of[0].solid",
        message: "the named solids are copies of themselves in a circle: a → b → a",
        help: "a solid cannot be a part of itself; make one of them without the other",
    },
    Case {
        text: r#"{"solids": {"a": {"shape": "copy", "solid": "a"}}}"#,
        place: "1:45 at solids.a.solid",
        message: "the named solids are copies of themselves in a circle: a → a",
        help: "a solid cannot be a part of itself; make one of them without the other",
    },
    Case {
        text: r#"{"solids": {"unused": {"shape": "torus", "d": -2}}}"#,
        place: "1:47 at solids.unused.d",
        message: "d is -2; the distance from the axis to the middle of the tube needs to be more than 0",
        help: "",
    },
    Case {
        text: r#"{"objects": {"shape": "sphere"}}"#,
        place: "1:13 at objects",
        message: "expected a list of objects, found an object",
        help: "",
    },
    Case {
        text: r#"{"objects": [{"shape": "sphere"}]}"#,
        place: "1:14 at objects[0]",
        message: "`sphere` has no material",
        help: "give it a `material`, or one of the solids around it",
    },
];

/// Objects; they stand in line 4 of a file that has the materials `clay` and `glass` and the named solid `globe`.
const OBJECTS: &[Case] = &[
    Case {
        text: r#""sphere""#,
        place: "4:1 at objects[0]",
        message: r#"expected an object with a `shape`, found the string "sphere""#,
        help: "",
    },
    Case {
        text: "{}",
        place: "4:1 at objects[0]",
        message: "the field `shape` is missing",
        help: "the shapes here are `plane`, `sphere`, `square`, `tapered_cylinder`, `cylinder`, `cone`, `cube`, `convex_polyhedron`, `torus`, `superellipsoid`, `union`, `intersection`, `difference`, `copy`",
    },
    Case {
        text: r#"{"shap": "sphere"}"#,
        place: "4:2 at objects[0].shap",
        message: "unknown field `shap`",
        help: "did you mean `shape`?",
    },
    Case {
        text: r#"{"shape": "shpere"}"#,
        place: "4:11 at objects[0].shape",
        message: "unknown shape `shpere`",
        help: "did you mean `sphere`?",
    },
    Case {
        text: r#"{"shape": "dodecahedron"}"#,
        place: "4:11 at objects[0].shape",
        message: "unknown shape `dodecahedron`",
        help: "the shapes here are `plane`, `sphere`, `square`, `tapered_cylinder`, `cylinder`, `cone`, `cube`, `convex_polyhedron`, `torus`, `superellipsoid`, `union`, `intersection`, `difference`, `copy`",
    },
    Case {
        text: r#"{"shape": 7}"#,
        place: "4:11 at objects[0].shape",
        message: "expected the name of a shape, found the number 7",
        help: "",
    },
    Case {
        text: r#"{"shape": "sphere", "material": "glas"}"#,
        place: "4:33 at objects[0].material",
        message: "unknown material `glas`",
        help: "did you mean `glass`?",
    },
    Case {
        text: r#"{"shape": "sphere", "material": "banana"}"#,
        place: "4:33 at objects[0].material",
        message: "unknown material `banana`",
        help: "the materials here are `clay`, `glass`",
    },
    Case {
        text: r#"{"shape": "sphere", "radius": 2, "material": "glass"}"#,
        place: "4:21 at objects[0].radius",
        message: "unknown field `radius`",
        help: "the fields here are `shape`, `name`, `material`, `priority`, `transform`",
    },
    Case {
        text: r#"{"shape": "union", "of": [{"shape": "sphere", "name": "left"}, {"shape": "cube", "material": "clay"}]}"#,
        place: "4:27 at objects[0].of[0]",
        message: "`left` has no material",
        help: "give it a `material`, or one of the solids around it",
    },
    Case {
        text: r#"{"shape": "tapered_cylinder", "material": "clay"}"#,
        place: "4:1 at objects[0]",
        message: "the field `s` is missing",
        help: "expected a number",
    },
    Case {
        text: r#"{"shape": "tapered_cylinder", "s": -0.5, "material": "clay"}"#,
        place: "4:36 at objects[0].s",
        message: "s is -0.5; the cap's radius needs to be 0 or more",
        help: "",
    },
    Case {
        text: r#"{"shape": "torus", "d": 0, "material": "clay"}"#,
        place: "4:25 at objects[0].d",
        message: "d is 0; the distance from the axis to the middle of the tube needs to be more than 0",
        help: "",
    },
    Case {
        text: r#"{"shape": "superellipsoid", "n": 0, "m": 2, "material": "clay"}"#,
        place: "4:34 at objects[0].n",
        message: "n is 0; an exponent needs to be more than 0",
        help: "",
    },
    Case {
        text: r#"{"shape": "superellipsoid", "n": 2, "m": -1, "material": "clay"}"#,
        place: "4:42 at objects[0].m",
        message: "m is -1; an exponent needs to be more than 0",
        help: "",
    },
    Case {
        text: r#"{"shape": "convex_polyhedron", "planes": [{"normal": [0, 0, 1], "offset": 1}], "material": "clay"}"#,
        place: "4:42 at objects[0].planes",
        message: "a convex polyhedron is unbounded with 1 planes; it needs 4 or more",
        help: "",
    },
    Case {
        text: r#"{"shape": "convex_polyhedron", "planes": [{"normal": [1, 0, 0], "offset": 1}, {"normal": [0, 1, 0], "offset": 1}, {"normal": [0, 0, 1], "offset": 1}, {"normal": [1, 1, 1], "offset": 1}], "material": "clay"}"#,
        place: "4:42 at objects[0].planes",
        message: "the polyhedron is unbounded: no plane closes it in the direction (0.000, 0.000, -1.000)",
        help: "",
    },
    Case {
        text: r#"{"shape": "convex_polyhedron", "planes": [{"normal": [1, 1, 1], "offset": -9}, {"normal": [-1, 0, 0], "offset": 1}, {"normal": [0, -1, 0], "offset": 1}, {"normal": [0, 0, -1], "offset": 1}], "material": "clay"}"#,
        place: "4:42 at objects[0].planes",
        message: "the planes leave no solid: no point lies strictly inside all of them",
        help: "",
    },
    Case {
        text: r#"{"shape": "convex_polyhedron", "planes": [{"normal": [0, 0, 0], "offset": 1}], "material": "clay"}"#,
        place: "4:42 at objects[0].planes",
        message: "plane 0 has the normal (0, 0, 0); a plane needs a direction",
        help: "",
    },
    Case {
        text: r#"{"shape": "convex_polyhedron", "planes": [{"normal": [0, 0, 1]}], "material": "clay"}"#,
        place: "4:43 at objects[0].planes[0]",
        message: "the field `offset` is missing",
        help: "expected a number",
    },
    Case {
        text: r#"{"shape": "union", "of": [], "material": "clay"}"#,
        place: "4:26 at objects[0].of",
        message: "expected a list of 1 or more objects, found 0",
        help: "",
    },
    Case {
        text: r#"{"shape": "difference", "of": [{"shape": "sphere"}, {"shape": "square"}], "material": "clay"}"#,
        place: "4:53 at objects[0].of[1]",
        message: "a square has no inside, so it cannot be part of a union, intersection or difference",
        help: "use a thin cube, or make the square an object of its own",
    },
    Case {
        text: r#"{"shape": "union", "of": [{"shape": "sphere", "priority": 2}], "material": "clay"}"#,
        place: "4:47 at objects[0].of[0].priority",
        message: "only an object has a priority, not a part of it",
        help: "put `priority` on the object in `objects`",
    },
    Case {
        text: r#"{"shape": "sphere", "priority": 1.5, "material": "clay"}"#,
        place: "4:33 at objects[0].priority",
        message: "expected a whole number, found 1.5",
        help: "",
    },
    Case {
        text: r#"{"shape": "copy", "solid": "glob", "material": "clay"}"#,
        place: "4:28 at objects[0].solid",
        message: "unknown solid `glob`",
        help: "did you mean `globe`?",
    },
    Case {
        text: r#"{"shape": "sphere", "material": "clay", "transform": {"scale": 2}}"#,
        place: "4:54 at objects[0].transform",
        message: "expected a list of objects, found an object",
        help: "",
    },
    Case {
        text: r#"{"shape": "sphere", "material": "clay", "transform": [{"scale": [1, 0, 1]}]}"#,
        place: "4:65 at objects[0].transform[0].scale",
        message: "a scale of 0 flattens the solid, so that the transform is singular (it has no inverse)",
        help: "",
    },
    Case {
        text: r#"{"shape": "sphere", "material": "clay", "transform": [{"scal": 2}]}"#,
        place: "4:56 at objects[0].transform[0].scal",
        message: "unknown field `scal`",
        help: "did you mean `scale`?",
    },
    Case {
        text: r#"{"shape": "sphere", "material": "clay", "transform": [{"scale": "2"}]}"#,
        place: "4:65 at objects[0].transform[0].scale",
        message: r#"expected a number or a list of 3 numbers, found the string "2""#,
        help: "",
    },
    Case {
        text: r#"{"shape": "sphere", "material": "clay", "transform": [{"scale": 2, "translate": [1, 0, 0]}]}"#,
        place: "4:55 at objects[0].transform[0]",
        message: "`scale` and `translate` cannot stand together",
        help: "keep one of `scale`, `rotate`, `translate`, `matrix`",
    },
    Case {
        text: r#"{"shape": "sphere", "material": "clay", "transform": [{"rotate": {"axis": [0, 0, 0], "degrees": 4}}]}"#,
        place: "4:75 at objects[0].transform[0].rotate.axis",
        message: "the axis of a rotation must not be (0, 0, 0)",
        help: "",
    },
    Case {
        text: r#"{"shape": "sphere", "material": "clay", "transform": [{"rotate": {"axis": [0, 0, 1]}}]}"#,
        place: "4:66 at objects[0].transform[0].rotate",
        message: "the field `degrees` is missing",
        help: "expected a number",
    },
    Case {
        text: r#"{"shape": "sphere", "material": "clay", "transform": [{"scale": 1e200}, {"scale": 1e200}]}"#,
        place: "4:54 at objects[0].transform",
        message: "the transform holds a number that is not finite",
        help: "",
    },
    Case {
        text: r#"{"shape": "sphere", "material": "clay", "transform": [{"matrix": [[1, 2, 3, 0], [2, 4, 6, 0], [0, 0, 1, 0]]}]}"#,
        place: "4:66 at objects[0].transform[0].matrix",
        message: "the matrix is singular: its determinant is 0, so it has no inverse",
        help: "",
    },
    Case {
        text: r#"{"shape": "sphere", "material": "clay", "name": "twin"}, {"shape": "cube", "material": "clay", "name": "twin"}"#,
        place: "4:104 at objects[1].name",
        message: "objects[0] has the name `twin` too",
        help: "give each object a name of its own",
    },
];

fn file_with_object(object: &str) -> String {
    format!(
        r#"{{"materials": {{"clay": {{}}, "glass": {{}}}},
"solids": {{"globe": {{"shape": "sphere"}}}},
"objects": [
{object}
]}}"#
    )
}

fn assert_refused(text: &str, case: &Case) {
    let errors = load(text, "bad.json").err().unwrap_or_else(|| panic!("accepted: {}", case.text)).errors;
    let [error] = &errors[..] else { panic!("{} errors instead of one in {}", errors.len(), case.text) };
    let place = format!("{}:{} at {}", error.line, error.column, error.path);
    assert_eq!(place.trim_end_matches(" at "), case.place, "{}", case.text);
    assert_eq!(error.message, case.message, "{}", case.text);
    assert_eq!(error.help.join("; "), case.help, "{}", case.text);
    assert_eq!(error.file, "bad.json");
}

#[test]
fn each_broken_file_is_refused_with_place_reason_and_help() {
    for case in FILES {
        assert_refused(case.text, case);
    }
}

#[test]
fn each_broken_object_is_refused_with_place_reason_and_help() {
    for case in OBJECTS {
        assert_refused(&file_with_object(case.text), case);
    }
}

#[test]
fn the_tables_hold_at_least_forty_files_and_no_file_twice() {
    let mut texts: Vec<_> = FILES.iter().chain(OBJECTS).map(|case| case.text).collect();
    texts.sort_unstable();
    texts.dedup();
    assert_eq!(texts.len(), FILES.len() + OBJECTS.len());
    assert!(texts.len() >= 40);
}

#[test]
fn all_errors_of_a_file_come_out_at_once_in_its_order() {
    let errors = load(include_str!("bad/many_errors.json"), "many_errors.json").unwrap_err();
    assert_eq!(format!("{errors}\n"), include_str!("bad/many_errors.txt"));
}

fn nested(depth: usize) -> String {
    let unions = r#"{"shape": "union", "of": ["#.repeat(depth);
    file_with_object(&format!(r#"{unions}{{"shape": "sphere", "material": "clay"}}{}"#, "]}".repeat(depth)))
}

#[test]
fn nesting_is_followed_as_deep_as_the_limit_and_refused_beyond_it() {
    assert!(load(&nested(98), "deep.json").is_ok());
    for depth in [99, 1_000, 100_000] {
        let errors = load(&nested(depth), "deep.json").unwrap_err().errors;
        assert_eq!(errors[0].message, "brackets are nested more than 200 deep");
    }
}

#[test]
fn a_list_of_operands_may_be_as_long_as_the_tree_may_be_deep() {
    let union_of = |count: usize| {
        let spheres = vec![r#"{"shape": "sphere"}"#; count].join(", ");
        file_with_object(&format!(r#"{{"shape": "union", "material": "clay", "of": [{spheres}]}}"#))
    };
    assert!(load(&union_of(256), "wide.json").is_ok());
    let errors = load(&union_of(257), "wide.json").unwrap_err().errors;
    assert_eq!(errors[0].message, "the tree of this solid has more than 256 levels");
}

#[test]
fn copies_of_copies_that_multiply_are_stopped() {
    let doubled = |i: usize| {
        let half = format!(r#"{{"shape": "copy", "solid": "s{}"}}"#, i - 1);
        format!(r#", "s{i}": {{"shape": "union", "of": [{half}, {half}]}}"#)
    };
    let text = format!(
        r#"{{"solids": {{"s0": {{"shape": "sphere"}}{}}}, "materials": {{"clay": {{}}}},
        "objects": [{{"shape": "copy", "solid": "s40", "material": "clay"}}]}}"#,
        (1..=40).map(doubled).collect::<String>()
    );
    let errors = load(&text, "copies.json").unwrap_err().errors;
    assert_eq!(errors[0].message, "the scene has more than 10000 primitives, copies counted");
}

#[test]
fn nonsense_without_end_is_answered_with_a_list_that_ends() {
    let text = format!(r#"{{"objects": [{}]}}"#, vec!["null"; 3_000].join(", "));
    let errors = load(&text, "nonsense.json").unwrap_err();
    assert_eq!((errors.errors.len(), errors.left_out), (500, 2_500));
    assert!(errors.to_string().ends_with("3000 errors in nonsense.json; the first 500 found are shown"));
}

#[test]
fn a_solid_of_a_probe_is_refused_in_one_line_with_every_reason() {
    let solid = serde_json::json!({"shape": "union", "of": [
        {"shape": "torus", "d": -1, "transform": [{"scale": 0}]},
        {"shape": "square"},
    ]});
    assert_eq!(
        compile_solid(&solid).unwrap_err(),
        "of[0].transform[0].scale: a scale of 0 flattens the solid, so that the transform is singular (it has no inverse) | \
         of[1]: a square has no inside, so it cannot be part of a union, intersection or difference; \
         use a thin cube, or make the square an object of its own"
    );
    let solid = serde_json::json!({"shape": "union", "of": [{"shape": "shpere"}, {"shape": "torus"}]});
    assert_eq!(
        compile_solid(&solid).unwrap_err(),
        "of[0].shape: unknown shape `shpere`; did you mean `sphere`? | of[1]: the field `d` is missing; expected a number"
    );
}

/// The places of errors lie in the file.
fn assert_never_panics(text: &str) {
    if let Err(errors) = load(text, "fuzz.json") {
        let _ = errors.to_string();
        let lines: Vec<_> = text.split('\n').collect();
        for error in errors.errors {
            assert!((1..=lines.len()).contains(&error.line));
            assert!((1..=lines[error.line - 1].chars().count() + 1).contains(&error.column));
        }
    }
}

proptest! {
    #[test]
    fn a_scene_with_a_piece_replaced_is_loaded_or_refused_but_never_panics(
        scene in 0..embedded_scenes().len(), from in 0.0..1.0_f64, length in 0_usize..40, piece in r#"[ -~é∪{}\[\]":,0-9]{0,12}"#,
    ) {
        let text: Vec<char> = embedded_scenes()[scene].text.chars().collect();
        let from = (from * text.len() as f64) as usize;
        let changed: String =
            text[..from].iter().copied().chain(piece.chars()).chain(text[from..].iter().copied().skip(length)).collect();
        assert_never_panics(&changed);
    }

    #[test]
    fn any_text_is_refused_without_a_panic(text in r#"[ -~é∪\n{}\[\]":,0-9]{0,60}"#) {
        assert_never_panics(&text);
    }
}
