//! The commands through the real binary: what they write, what they say, and how they end.

use serde_json::{Value, json};
use std::fs;
use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};

/// One ball and one light, straight ahead of the middle of a picture of 40 × 30 pixels.
const BALL: &str = r#"{
  "title": "A ball",
  "sections": ["6.1"],
  "camera": {"eye": [0, 0, 5], "look_at": [0, 0, 0], "up": [0, 1, 0], "field_of_view": 40},
  "image": {"width": 40, "height": 30},
  "lights": [{"name": "lamp", "point": [3, 4, 5]}],
  "materials": {"clay": {"diffuse": [0.8, 0.2, 0.2]}},
  "objects": [{"shape": "sphere", "name": "ball", "material": "clay"}],
  "pixels": [[20, 15]]
}"#;

fn command() -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_rayscope"));
    command.stdin(Stdio::null());
    command
}

fn rayscope(arguments: &[&str]) -> Output {
    command().args(arguments).output().unwrap()
}

/// What a command prints that has to go well.
fn printed(arguments: &[&str]) -> String {
    let output = rayscope(arguments);
    assert!(output.status.success(), "{arguments:?}: {}", complaint(&output));
    String::from_utf8(output.stdout).unwrap()
}

fn complaint(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

/// A folder of its own with the ball's scene in it.
struct Folder(tempfile::TempDir);

impl Folder {
    fn new() -> Self {
        let folder = Self(tempfile::tempdir().unwrap());
        fs::write(folder.0.path().join("ball.json"), BALL).unwrap();
        folder
    }

    fn path(&self, name: &str) -> String {
        self.0.path().join(name).to_str().unwrap().to_owned()
    }

    fn names(&self) -> Vec<String> {
        let mut names: Vec<_> = fs::read_dir(self.0.path())
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        names
    }
}

fn png_size(path: &str) -> (u32, u32) {
    let picture = image::open(path).unwrap();
    (picture.width(), picture.height())
}

#[test]
fn render_writes_a_picture_of_the_scenes_size() {
    let folder = Folder::new();
    let (scene, png) = (folder.path("ball.json"), folder.path("ball.png"));
    assert_eq!(printed(&["render", &scene, "-o", &png]), "");
    assert_eq!(png_size(&png), (40, 30));
    assert_eq!(folder.names(), ["ball.json", "ball.png"]);
    let picture = image::open(&png).unwrap().to_rgb8();
    let (ball, corner) = (picture.get_pixel(20, 15).0, picture.get_pixel(0, 0).0);
    assert!(ball[0] > ball[1] && ball[1] == ball[2], "the ball is red: {ball:?}");
    assert_ne!(ball, corner);
}

#[test]
fn render_takes_another_size_and_keeps_the_proportions() {
    let folder = Folder::new();
    let (scene, png) = (folder.path("ball.json"), folder.path("ball.png"));
    printed(&["render", &scene, "-o", &png, "--width", "20"]);
    assert_eq!(png_size(&png), (20, 15));
    printed(&["render", &scene, "-o", &png, "--width", "7", "--height", "50"]);
    assert_eq!(png_size(&png), (7, 50));
}

#[test]
fn the_number_of_threads_does_not_change_a_byte() {
    let folder = Folder::new();
    let scene = folder.path("ball.json");
    let bytes = |threads: &str| {
        let png = folder.path("threads.png");
        printed(&["render", &scene, "-o", &png, "--threads", threads]);
        fs::read(png).unwrap()
    };
    assert_eq!(bytes("1"), bytes("7"));
}

#[test]
fn stats_count_a_ray_for_each_pixel_and_name_the_effects_called_for() {
    let folder = Folder::new();
    let stats = folder.path("stats.json");
    printed(&[
        "render",
        &folder.path("ball.json"),
        "-o",
        &folder.path("ball.png"),
        "--stats",
        &stats,
        "--threads",
        "2",
    ]);
    let stats: Value = serde_json::from_str(&fs::read_to_string(stats).unwrap()).unwrap();
    assert_eq!((&stats["width"], &stats["height"], &stats["pixels"]), (&json!(40), &json!(30), &json!(1200)));
    assert_eq!((&stats["threads"], &stats["interrupted"]), (&json!(2), &json!(false)));
    assert_eq!(stats["rays"]["camera"], 1200);
    assert_eq!((&stats["rays"]["reflected"], &stats["rays"]["refracted"]), (&json!(0), &json!(0)));
    assert!(stats["rays"]["shadow"].as_u64().unwrap() > 0);
    assert!(stats["tests"]["sphere"].as_u64().unwrap() > 0);
    assert_eq!(stats["tests"]["torus"], 0);
    assert!(stats["extents"]["misses"].as_u64() <= stats["extents"]["tests"].as_u64());
    assert!(["load", "render", "write"].iter().all(|phase| stats["seconds"][phase].as_f64().unwrap() >= 0.0));
    let effects: Vec<_> =
        stats["effects"].as_array().unwrap().iter().map(|effect| (&effect["name"], &effect["called_for"])).collect();
    let called_for: Vec<_> = effects.iter().filter(|(_, called_for)| **called_for == json!(true)).collect();
    assert_eq!(called_for, [&(&json!("shadows"), &json!(true))]);
    for name in
        ["reflection", "refraction", "image textures", "solid textures", "bumps", "frames", "details", "environment"]
    {
        assert!(effects.contains(&(&json!(name), &json!(false))), "{name}");
    }
    let idle = stats["effects"].as_array().unwrap().iter().filter(|effect| effect["called_for"] == json!(false));
    assert!(idle.clone().count() > 5 && idle.into_iter().all(|e| e["calls"] == json!(0) && e["rays"] == json!(0)));
}

#[test]
fn effects_names_every_effect_with_its_reason_and_what_is_not_called_for_costs_nothing() {
    let folder = Folder::new();
    let ledger =
        |format| printed(&["effects", &folder.path("ball.json"), "--pairs", "1", "--width", "16", "--format", format]);
    let file: Value = serde_json::from_str(&ledger("json")).unwrap();
    assert_eq!((&file["width"], &file["height"], &file["pairs"]), (&json!(16), &json!(12), &json!(1)));
    let effects = file["effects"].as_array().unwrap();
    assert_eq!(effects.len(), 17);
    let text = ledger("text");
    for effect in effects {
        assert!(text.contains(effect["name"].as_str().unwrap()), "{effect}");
        if effect["name"] == "shadows" {
            assert_eq!((&effect["called_for"], &effect["calls"]), (&json!(true), &effect["rays"]), "{effect}");
            assert!(effect["rays"].as_u64().unwrap() > 0 && effect["ns_per_pixel"].is_f64(), "{effect}");
            continue;
        }
        assert_eq!(effect["called_for"], json!(false), "{effect}");
        assert!(effect["why"].as_str().unwrap().starts_with("no "), "{effect}");
        assert_eq!((&effect["calls"], &effect["rays"]), (&json!(0), &json!(0)), "{effect}");
        assert_eq!(effect["ns_per_pixel"], json!(0.0), "{effect}");
    }
}

#[test]
fn trace_prints_the_six_steps_of_a_pixel() {
    let folder = Folder::new();
    let text = printed(&["trace", &folder.path("ball.json"), "--pixel", "20,15"]);
    for step in ["①", "②", "③", "④", "⑤", "⑥"] {
        assert_eq!(text.matches(step).count(), 1, "step {step} in\n{text}");
    }
    assert!(text.contains("ball") && text.contains("lamp"));
    assert_eq!(text, printed(&["trace", &folder.path("ball.json")]), "the telling pixel is the one that is traced");
}

fn committed_schema(file: &str) -> Value {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(file);
    let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    serde_json::from_str(&text).unwrap()
}

#[test]
fn a_traced_pixel_is_valid_by_the_committed_schema_and_ends_in_the_pictures_colour() {
    let folder = Folder::new();
    let (scene, png) = (folder.path("ball.json"), folder.path("ball.png"));
    let trace: Value =
        serde_json::from_str(&printed(&["trace", &scene, "--pixel", "20,15", "--format", "json"])).unwrap();
    let validator = jsonschema::validator_for(&committed_schema("docs/trace.schema.json")).unwrap();
    let problems: Vec<_> = validator.iter_errors(&trace).map(|error| error.to_string()).collect();
    assert_eq!(problems, Vec::<String>::new());
    assert_eq!(
        (&trace["format"], &trace["pixel"], &trace["size"]),
        (&json!("rayscope-trace/1"), &json!([20, 15]), &json!([40, 30]))
    );
    printed(&["render", &scene, "-o", &png]);
    let pixel = image::open(&png).unwrap().to_rgb8().get_pixel(20, 15).0;
    assert_eq!(trace["srgb"], json!(pixel));
}

#[test]
fn every_embedded_scene_traces_to_valid_json() {
    let validator = jsonschema::validator_for(&committed_schema("docs/trace.schema.json")).unwrap();
    let scenes: Value = serde_json::from_str(&printed(&["scenes", "--format", "json"])).unwrap();
    for scene in scenes.as_array().unwrap() {
        let name = scene["name"].as_str().unwrap();
        // The telling pixel, and a ray whose length squared is more than any number.
        for which in ["--width=64", "--ray=0,0,1e300,0,0,1e300"] {
            let trace = serde_json::from_str(&printed(&["trace", name, which, "--format", "json"])).unwrap();
            let problems: Vec<_> = validator.iter_errors(&trace).map(|error| error.to_string()).collect();
            assert_eq!(problems, Vec::<String>::new(), "{name} {which}");
        }
    }
}

#[test]
fn the_committed_schemas_are_those_that_the_program_prints() {
    for (file, arguments) in [
        ("scenes/scene.schema.json", vec!["schema", "scene"]),
        ("docs/trace.schema.json", vec!["schema", "trace"]),
        ("scenes/profile.schema.json", vec!["schema", "profile"]),
    ] {
        let printed: Value = serde_json::from_str(&printed(&arguments)).unwrap();
        assert!(printed == committed_schema(file), "{file}: write it anew with `rayscope {}`", arguments.join(" "));
    }
}

#[test]
fn a_ray_of_ones_own_hits_the_ball_where_it_should() {
    let folder = Folder::new();
    let arguments = ["trace", &folder.path("ball.json"), "--ray", "0,0,-4,0,0,2", "--format", "json"];
    let trace: Value = serde_json::from_str(&printed(&arguments)).unwrap();
    assert_eq!((&trace["pixel"], &trace["size"]), (&Value::Null, &Value::Null));
    let hit = trace["events"].as_array().unwrap().iter().find(|event| event["kind"] == "hit").unwrap();
    // From z = −4 in steps of 2 to the near side at z = −1.
    assert_eq!((&hit["t"], &hit["point"]), (&json!(1.5), &json!([0.0, 0.0, -1.0])));
}

#[test]
fn a_trace_can_be_drawn() {
    let folder = Folder::new();
    let (scene, svg, png) = (folder.path("ball.json"), folder.path("ball.svg"), folder.path("side.png"));
    printed(&["trace", &scene, "--format", "svg", "-o", &svg]);
    assert!(fs::read_to_string(svg).unwrap().contains("<svg"));
    printed(&["trace", &scene, "--format", "png", "--theme", "dark", "-o", &png]);
    assert_eq!(png_size(&png), (1920, 1200));
}

#[test]
fn the_embedded_scenes_are_listed_with_their_titles() {
    let scenes: Value = serde_json::from_str(&printed(&["scenes", "--format", "json"])).unwrap();
    let scenes = scenes.as_array().unwrap();
    assert!(!scenes.is_empty());
    let text = printed(&["scenes"]);
    for scene in scenes {
        let keys: Vec<_> = scene.as_object().unwrap().keys().collect();
        assert_eq!(keys, ["name", "title", "sections"]);
        assert!(text.contains(scene["name"].as_str().unwrap()) && text.contains(scene["title"].as_str().unwrap()));
    }
}

#[test]
fn every_command_shows_examples() {
    for name in ["open", "render", "trace", "probe", "export", "scenes", "schema", "stability", "bench", "book"] {
        assert!(printed(&[name, "--help"]).contains("Examples:\n  "), "{name}");
    }
    assert!(printed(&["--help"]).contains("Exit codes:"));
}

#[test]
fn a_mistyped_scene_is_answered_with_the_nearest_name() {
    let output = rayscope(&["trace", "hello/shpere", "--pixel", "0,0"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(complaint(&output).contains("did you mean `hello/sphere`?"), "{}", complaint(&output));
}

#[test]
fn a_broken_scene_is_answered_with_all_of_its_errors_and_their_places() {
    let folder = Folder::new();
    let scene = folder.path("broken.json");
    fs::write(&scene, "{\n  \"objects\": [{\"shape\": \"shpere\"}, {\"shape\": \"torus\", \"d\": -1}]\n}\n").unwrap();
    let output = rayscope(&["render", &scene, "-o", &folder.path("x.png")]);
    assert_eq!(output.status.code(), Some(2));
    let said = complaint(&output);
    assert!(said.contains("broken.json:2:") && said.contains("shpere") && said.contains("`sphere`"), "{said}");
    assert!(said.contains("objects[1].d"), "{said}");
    assert!(!Path::new(&folder.path("x.png")).exists());
}

#[test]
fn arguments_that_make_no_sense_are_refused_with_exit_code_2() {
    let folder = Folder::new();
    let scene = folder.path("ball.json");
    fs::write(folder.path("bytes.json"), b"{\"title\": \"\xff\"}").unwrap();
    let png = folder.path("x.png");
    for (arguments, words) in [
        (vec!["fly"], "unrecognized subcommand"),
        (vec!["render", &scene], "--output"),
        (vec!["render", &scene, "-o", &png, "--width", "0"], "0"),
        (vec!["render", &scene, "-o", &png, "--width", "60000", "--height", "60000"], "too many"),
        (vec!["render", &scene, "-o", &png, "--threads", "0"], "0"),
        (vec!["trace", &scene, "--pixel", "40,0"], "the last one is 39,29"),
        (vec!["trace", &scene, "--pixel", "0,30"], "outside the picture of 40 × 30"),
        (vec!["trace", &scene, "--pixel", "a"], "such as 320,240"),
        (vec!["trace", &scene, "--ray", "0,0,0,0,0,0"], "no length"),
        (vec!["trace", &scene, "--ray", "0,0,0,0,0"], "six numbers"),
        (vec!["trace", &scene, "--pixel", "1,1", "--ray", "0,0,0,0,0,1"], "cannot be used with"),
        (vec!["trace", "no/such.json"], "there is no file"),
        (vec!["trace", &folder.path("")], "it is a folder"),
        (vec!["trace", &folder.path("bytes.json")], "byte 11 is not UTF-8"),
        (vec!["schema", "picture"], "picture"),
    ] {
        let output = rayscope(&arguments);
        let said = complaint(&output);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {said}");
        assert!(said.contains(words), "{arguments:?}: `{words}` is not in\n{said}");
        assert!(output.stdout.is_empty(), "{arguments:?}");
    }
}

#[test]
fn a_place_that_cannot_be_written_is_named_with_the_reason() {
    let folder = Folder::new();
    let scene = folder.path("ball.json");
    let missing = folder.path("no/such/folder/x.png");
    let below_a_file = format!("{scene}/x.png");
    for (place, words) in [
        (missing.as_str(), "there is no folder"),
        (folder.path("").as_str(), "it is a folder, not a file"),
        (&below_a_file, "not a folder"),
        ("/dev/full", "the disk is full"),
    ] {
        for arguments in [
            vec!["render", &scene, "-o", place],
            vec!["trace", &scene, "-o", place],
            vec!["render", &scene, "-o", &folder.path("x.png"), "--stats", place],
        ] {
            let output = rayscope(&arguments);
            let said = complaint(&output);
            assert_eq!(output.status.code(), Some(1), "{arguments:?}: {said}");
            assert!(said.starts_with("rayscope: cannot write") && said.contains(words), "{arguments:?}: {said}");
            assert_eq!(said.lines().count(), 1, "{said}");
        }
    }
}

#[test]
fn a_full_disk_behind_the_standard_output_is_told() {
    let full = fs::File::options().write(true).open("/dev/full").unwrap();
    let output = command().args(["scenes"]).stdout(full).stderr(Stdio::piped()).output().unwrap();
    assert_eq!(output.status.code(), Some(1));
    assert_eq!(complaint(&output), "rayscope: cannot write to the standard output: the disk is full\n");
}

#[test]
fn a_picture_that_was_there_before_survives_a_failed_rendering() {
    let folder = Folder::new();
    let png = folder.path("old.png");
    fs::write(&png, "precious").unwrap();
    let broken = folder.path("broken.json");
    fs::write(&broken, "{").unwrap();
    assert_eq!(rayscope(&["render", &broken, "-o", &png]).status.code(), Some(2));
    assert_eq!(fs::read_to_string(&png).unwrap(), "precious");
    assert_eq!(folder.names(), ["ball.json", "broken.json", "old.png"]);
}

#[cfg(unix)]
#[test]
fn a_picture_has_the_permissions_of_any_new_file_and_goes_through_links() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let folder = Folder::new();
    let (plain, target, link) = (folder.path("plain"), folder.path("target.png"), folder.path("link.png"));
    fs::write(&plain, "").unwrap();
    fs::write(&target, "").unwrap();
    symlink(&target, &link).unwrap();
    printed(&["render", &folder.path("ball.json"), "-o", &link]);
    assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
    assert_eq!(png_size(&target), (40, 30));
    let mode = |path: &str| fs::metadata(path).unwrap().permissions().mode();
    assert_eq!(mode(&target), mode(&plain));
}

#[cfg(unix)]
#[test]
fn ctrl_c_writes_what_is_finished_and_says_so() {
    let folder = Folder::new();
    let (png, stats) = (folder.path("large.png"), folder.path("stats.json"));
    // Minutes of work: glass in glass, 4 million pixels.
    let child = command()
        .args(["render", "optics/fishbowl", "-o", &png, "--stats", &stats, "--width", "2000", "--height", "2000"])
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let began = Instant::now();
    while folder.names().len() < 3 && began.elapsed() < Duration::from_secs(20) {
        std::thread::sleep(Duration::from_millis(20));
    }
    // The files are open: the work is about to begin.
    std::thread::sleep(Duration::from_secs(2));
    let interrupt = Command::new("sh").args(["-c", &format!("kill -INT {}", child.id())]).status().unwrap();
    assert!(interrupt.success());
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(130), "{}", complaint(&output));
    assert!(complaint(&output).starts_with("rayscope: interrupted: "), "{}", complaint(&output));
    assert_eq!(png_size(&png), (2000, 2000));
    let stats: Value = serde_json::from_str(&fs::read_to_string(stats).unwrap()).unwrap();
    let pixels = stats["pixels"].as_u64().unwrap();
    assert_eq!((&stats["interrupted"], &stats["rays"]["camera"]), (&json!(true), &json!(pixels)));
    assert!(pixels > 0 && pixels < 4_000_000);
    assert_eq!(folder.names(), ["ball.json", "large.png", "stats.json"]);
}

#[cfg(not(feature = "workbench"))]
#[test]
fn without_the_workbench_the_program_says_how_to_get_it() {
    let output = rayscope(&[]);
    assert_eq!(output.status.code(), Some(2));
    assert!(complaint(&output).contains("rayscope trace"), "{}", complaint(&output));
}

#[cfg(all(feature = "workbench", target_os = "linux"))]
#[test]
fn without_a_display_the_program_says_so_and_names_the_way_round() {
    let output =
        command().env_remove("DISPLAY").env_remove("WAYLAND_DISPLAY").env_remove("WAYLAND_SOCKET").output().unwrap();
    let said = complaint(&output);
    assert_eq!((output.status.code(), said.lines().count()), (Some(1), 1), "{said}");
    assert!(said.contains("display") && said.contains("rayscope trace"), "{said}");
}
