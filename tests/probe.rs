//! `rayscope probe` through the real binary, against answers worked out by hand.

use serde_json::{Value, json};
use std::io::{BufRead, BufReader, Write};
use std::process::{Child, Command, ExitStatus, Stdio};

fn start() -> Child {
    Command::new(env!("CARGO_BIN_EXE_rayscope"))
        .arg("probe")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap()
}

/// Sends the text and gives the answers, the exit status and what was said on the standard error.
fn converse(input: &str) -> (Vec<Value>, ExitStatus, String) {
    let mut child = start();
    let mut stdin = child.stdin.take().unwrap();
    let input = input.to_owned();
    let sender = std::thread::spawn(move || stdin.write_all(input.as_bytes()).unwrap());
    let output = child.wait_with_output().unwrap();
    sender.join().unwrap();
    let text = String::from_utf8(output.stdout).unwrap();
    let answers = text.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    (answers, output.status, String::from_utf8(output.stderr).unwrap())
}

/// The answer to one request, which has to be a good one.
fn answer(request: &Value) -> Value {
    let (mut answers, status, complaint) = converse(&format!("{request}\n"));
    assert!(status.success(), "{request}: {complaint} {answers:?}");
    assert_eq!(answers.len(), 1);
    answers.remove(0)
}

fn hits(solid: &Value, origin: [f64; 3], direction: [f64; 3]) -> Value {
    answer(&json!({"solid": solid, "ray": {"origin": origin, "direction": direction}}))
}

/// The error of a request that has to be refused.
fn refusal(request: &Value) -> String {
    let (answers, status, _) = converse(&format!("{request}\n"));
    assert_eq!(status.code(), Some(1), "{request}: {answers:?}");
    answers[0]["error"].as_str().unwrap_or_else(|| panic!("{request}: {answers:?}")).to_owned()
}

#[test]
fn a_sphere_is_entered_and_left_with_normals_that_point_out() {
    let request =
        json!({"id": "a", "solid": {"shape": "sphere"}, "ray": {"origin": [0, 0, 3], "direction": [0, 0, -2]}});
    assert_eq!(
        answer(&request),
        json!({
            "id": "a",
            "hits": [
                {"t": 1.0, "kind": "enter", "part": "surface", "leaf": 0, "normal": [0.0, 0.0, 1.0]},
                {"t": 2.0, "kind": "leave", "part": "surface", "leaf": 0, "normal": [0.0, 0.0, -1.0]},
            ],
            "inside": [[1.0, 2.0]],
        })
    );
}

#[test]
fn hits_behind_the_origin_are_listed_too() {
    let answer = hits(&json!({"shape": "sphere"}), [0.0, 0.0, 0.0], [0.5, 0.0, 0.0]);
    assert_eq!(answer["inside"], json!([[-2.0, 2.0]]));
    assert_eq!(answer["id"], Value::Null);
}

#[test]
fn a_miss_has_no_hits() {
    let answer = hits(&json!({"shape": "sphere"}), [0.0, 2.0, 3.0], [0.0, 0.0, -1.0]);
    assert_eq!((&answer["hits"], &answer["inside"]), (&json!([]), &json!([])));
}

#[test]
fn a_square_is_touched_and_has_no_inside() {
    let answer = hits(&json!({"shape": "square"}), [0.25, 0.5, 4.0], [0.0, 0.0, -1.0]);
    assert_eq!(answer["hits"].as_array().unwrap().len(), 1);
    assert_eq!(answer["hits"][0]["kind"], "touch");
    assert_eq!(answer["hits"][0]["t"], 4.0);
    assert_eq!(answer["inside"], json!([]));
}

#[test]
fn a_half_space_has_no_end() {
    let down = hits(&json!({"shape": "plane"}), [0.0, 0.0, 3.0], [0.0, 0.0, -1.0]);
    assert_eq!(down["inside"], json!([[3.0, null]]));
    assert_eq!(down["hits"][0]["kind"], "enter");
    assert_eq!(down["hits"][0]["normal"], json!([0.0, 0.0, 1.0]));
    let up = hits(&json!({"shape": "plane"}), [0.0, 0.0, -3.0], [0.0, 0.0, 1.0]);
    assert_eq!(up["inside"], json!([[null, 3.0]]));
    let beside = hits(&json!({"shape": "plane"}), [0.0, 0.0, -3.0], [1.0, 0.0, 0.0]);
    assert_eq!((&beside["hits"], &beside["inside"]), (&json!([]), &json!([[null, null]])));
}

#[test]
fn a_solid_without_itself_is_nothing() {
    let sphere = json!({"shape": "sphere", "transform": [{"scale": [1.0, 2.0, 3.0]}, {"translate": [0.1, 0.2, 0.3]}]});
    let answer = hits(&json!({"shape": "difference", "of": [sphere, sphere]}), [0.1, 0.3, 9.0], [0.01, 0.02, -1.0]);
    assert_eq!((&answer["hits"], &answer["inside"]), (&json!([]), &json!([])));
}

#[test]
fn boxes_that_abut_unite_without_a_seam() {
    let boxes = json!({"shape": "union", "of": [
        {"shape": "cube"},
        {"shape": "cube", "transform": [{"translate": [2, 0, 0]}]},
    ]});
    let answer = hits(&boxes, [-3.0, 0.5, 0.25], [1.0, 0.0, 0.0]);
    assert_eq!(answer["inside"], json!([[2.0, 6.0]]));
    let ends: Vec<_> = answer["hits"].as_array().unwrap().iter().map(|hit| (&hit["part"], &hit["leaf"])).collect();
    assert_eq!(ends, [(&json!("left"), &json!(0)), (&json!("right"), &json!(1))]);
}

#[test]
fn the_subtracted_solid_turns_its_normal_round() {
    // A ball of radius 1 with a ball of radius 1/2 taken out: the wall is half a unit thick on either side.
    let shell = json!({"shape": "difference", "of": [
        {"shape": "sphere"},
        {"shape": "sphere", "transform": [{"scale": 0.5}]},
    ]});
    let answer = hits(&shell, [0.0, 0.0, 2.0], [0.0, 0.0, -1.0]);
    assert_eq!(answer["inside"], json!([[1.0, 1.5], [2.5, 3.0]]));
    assert_eq!(answer["hits"][1]["leaf"], 1);
    assert_eq!(answer["hits"][1]["normal"], json!([0.0, 0.0, -1.0]));
    assert_eq!(answer["hits"][2]["normal"], json!([0.0, 0.0, 1.0]));
}

#[test]
fn the_arithmetic_is_a_choice_and_more_digits_come_closer() {
    // x² + y² = 1 at y = 0.1: t = 3 − √0.99, whose nearest double is this.
    let exact = 2.005_012_562_893_38;
    let error = |arithmetic: &str| {
        let request = json!({
            "solid": {"shape": "sphere"},
            "ray": {"origin": [3, 0.1, 0], "direction": [-1, 0, 0]},
            "arithmetic": arithmetic,
        });
        (answer(&request)["hits"][0]["t"].as_f64().unwrap() - exact).abs()
    };
    let (single, double, quad) = (error("f32"), error("f64"), error("double-double"));
    assert!(single > 1e-9 && single < 1e-6, "f32 has about 7 digits, not {single}");
    assert!(double < 1e-14 && quad < 1e-14, "{double} {quad}");
}

#[test]
fn an_interface_splits_light_by_snell_and_fresnel() {
    let head_on =
        answer(&json!({"id": [1], "interface": {"direction": [0, 0, -3], "normal": [0, 0, 2], "n1": 1, "n2": 1.5}}));
    assert_eq!(head_on["id"], json!([1]));
    assert_eq!(head_on["reflected"], json!([0.0, 0.0, 3.0]));
    assert_eq!(head_on["refracted"], json!([0.0, 0.0, -1.0]));
    assert!((head_on["reflectance"].as_f64().unwrap() - 0.04).abs() < 1e-15);
    assert_eq!(head_on["critical_angle_degrees"], Value::Null);
}

#[test]
fn beyond_the_critical_angle_all_light_is_reflected() {
    let flat = answer(&json!({"interface": {"direction": [1, 0, -0.5], "normal": [0, 0, 1], "n1": 1.5, "n2": 1}}));
    assert_eq!((&flat["refracted"], &flat["cos_t"], &flat["reflectance"]), (&Value::Null, &Value::Null, &json!(1.0)));
    assert!((flat["critical_angle_degrees"].as_f64().unwrap() - 41.810_314_895_778_6).abs() < 1e-12);
    assert_eq!(flat["reflected"], json!([1.0, 0.0, 0.5]));
}

#[test]
fn a_bad_line_is_answered_and_the_rest_go_on() {
    let good = json!({"id": 1, "solid": {"shape": "sphere"}, "ray": {"origin": [0, 0, 3], "direction": [0, 0, -1]}});
    let bad =
        json!({"id": {"a": null}, "solid": {"shape": "shpere"}, "ray": {"origin": [0, 0, 3], "direction": [0, 0, -1]}});
    let (answers, status, complaint) = converse(&format!("{good}\n{{broken\n{bad}\n\n{good}"));
    assert_eq!(status.code(), Some(1));
    assert_eq!(complaint, "rayscope: 2 of 4 requests could not be answered\n");
    assert_eq!(answers.len(), 4);
    assert_eq!(answers[0], answers[3]);
    assert_eq!(answers[1]["id"], Value::Null);
    assert!(answers[1]["error"].as_str().unwrap().starts_with("line 2: column 2: this is not JSON"), "{}", answers[1]);
    assert_eq!(answers[2]["id"], json!({"a": null}));
    let error = answers[2]["error"].as_str().unwrap();
    assert!(error.starts_with("line 3: solid") && error.contains("shpere") && error.contains("sphere"), "{error}");
}

#[test]
fn a_request_that_makes_no_sense_is_refused_with_what_and_where() {
    let solid = json!({"shape": "sphere"});
    let ray = json!({"origin": [0, 0, 3], "direction": [0, 0, -1]});
    let face = json!({"direction": [0, 0, -1], "normal": [0, 0, 1], "n1": 1, "n2": 1.5});
    let with = |base: &Value, name: &str, value: Value| {
        let mut changed = base.clone();
        changed[name] = value;
        changed
    };
    for (request, words) in [
        (json!([]), vec!["the request", "expected an object", "found a list"]),
        (json!({}), vec!["expected `solid` and `ray`, or `interface`"]),
        (json!({"solid": solid}), vec!["`ray` is missing"]),
        (json!({"solid": solid, "ray": ray, "interface": face}), vec!["not both"]),
        (json!({"solid": solid, "ray": 7}), vec!["ray: expected an object", "found a number"]),
        (json!({"solid": solid, "ray": with(&ray, "direction", json!([0, 0, 0]))}), vec!["ray.direction", "length"]),
        (
            json!({"solid": solid, "ray": with(&ray, "origin", json!([0, 0]))}),
            vec!["ray.origin", "three numbers", "[0,0]"],
        ),
        (json!({"solid": solid, "ray": with(&ray, "origin", json!([0, "x", 0]))}), vec!["ray.origin", "three numbers"]),
        (json!({"solid": solid, "ray": {"origin": [0, 0, 3]}}), vec!["ray.direction is missing"]),
        (
            json!({"solid": solid, "ray": {"origin": [0, 0, 3], "directoin": [0, 0, 1]}}),
            vec!["ray.directoin", "`direction`"],
        ),
        (json!({"solid": solid, "ray": ray, "arithmetic": "f16"}), vec!["arithmetic", "\"f16\"", "\"double-double\""]),
        (json!({"solid": solid, "ray": ray, "arithmatic": "f32"}), vec!["arithmatic", "`arithmetic`"]),
        (json!({"solid": 3, "ray": ray}), vec!["solid"]),
        (json!({"solid": {"shape": "torus", "d": 0}, "ray": ray}), vec!["solid", "d"]),
        (json!({"interface": with(&face, "n1", json!(0))}), vec!["interface.n1", "greater than 0", "0"]),
        (json!({"interface": with(&face, "n2", json!(-1.5))}), vec!["interface.n2", "greater than 0", "-1.5"]),
        (json!({"interface": with(&face, "normal", json!([0, 0, 0]))}), vec!["interface.normal", "length"]),
        (
            json!({"interface": {"direction": [0, 0, -1], "normal": [0, 0, 1], "n1": 1}}),
            vec!["interface.n2 is missing"],
        ),
    ] {
        let error = refusal(&request);
        for word in words {
            assert!(error.contains(word), "{request}: `{word}` is not in `{error}`");
        }
    }
}

#[test]
fn other_members_are_the_senders_own_affair() {
    let request = json!({
        "id": 5, "comment": "down the axis", "solid": {"shape": "sphere"},
        "ray": {"origin": [0, 0, 3], "direction": [0, 0, -1], "seen from": "above"},
    });
    assert_eq!(answer(&request)["inside"], json!([[2.0, 4.0]]));
}

#[test]
fn a_person_at_a_terminal_is_answered_line_by_line() {
    let mut child = start();
    let mut stdin = child.stdin.take().unwrap();
    let mut answers = BufReader::new(child.stdout.take().unwrap());
    for id in 0..3 {
        let request =
            json!({"id": id, "solid": {"shape": "cube"}, "ray": {"origin": [0, 0, 3], "direction": [0, 0, -1]}});
        writeln!(stdin, "{request}").unwrap();
        stdin.flush().unwrap();
        let mut line = String::new();
        answers.read_line(&mut line).unwrap();
        assert_eq!(serde_json::from_str::<Value>(&line).unwrap()["id"], id);
    }
    drop(stdin);
    assert!(child.wait().unwrap().success());
}

#[test]
fn many_requests_in_one_pipe_come_back_in_order() {
    let request = |id: usize| {
        let ray = json!({"origin": [0, 0, 3], "direction": [0, 0, -1]});
        json!({"id": id, "solid": {"shape": "sphere"}, "ray": ray}).to_string()
    };
    let input: Vec<String> = (0..3000).map(request).collect();
    let (answers, status, _) = converse(&input.join("\n"));
    assert!(status.success());
    let ids: Vec<_> = answers.iter().map(|answer| answer["id"].as_u64().unwrap()).collect();
    assert!(ids.iter().copied().eq(0..3000));
}

#[test]
fn no_requests_no_answers() {
    let (answers, status, complaint) = converse("");
    assert_eq!((answers.len(), status.code(), complaint.as_str()), (0, Some(0), ""));
}

#[test]
fn a_reader_that_goes_away_ends_the_program_quietly() {
    let mut child = start();
    drop(child.stdout.take());
    let mut stdin = child.stdin.take().unwrap();
    let request = json!({"solid": {"shape": "sphere"}, "ray": {"origin": [0, 0, 3], "direction": [0, 0, -1]}});
    // The program may be gone before all of it is sent.
    let _ = writeln!(stdin, "{request}");
    drop(stdin);
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(141));
    assert_eq!(String::from_utf8(output.stderr).unwrap(), "");
}
