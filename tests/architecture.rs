//! The rules of ARCHITECTURE.md that a test can check: layers, who may use which crate, the size of files.

#[path = "architecture/locking.rs"]
mod locking;
#[path = "architecture/portable.rs"]
mod portable;

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Each module with the modules below it that it may use. `cli`, `app` and the two roots may use all.
const LAYERS: &[(&str, &[&str])] = &[
    ("record", &[]),
    ("math", &["record"]),
    ("shape", &["record", "math"]),
    ("optics", &["record", "math"]),
    ("texture", &["record", "math"]),
    ("sample", &["record", "math"]),
    ("csg", &["record", "math", "shape"]),
    ("scene", &["record", "math", "shape", "csg", "optics", "texture", "sample"]),
    ("trace", &["record", "math", "shape", "csg", "optics", "texture", "sample", "scene"]),
    ("view", &["record", "math", "shape", "csg", "optics", "texture", "sample", "scene", "trace"]),
    ("accuracy", &["record", "math", "shape", "csg", "optics", "texture", "sample", "scene", "trace", "view"]),
    (
        "laboratory",
        &["record", "math", "shape", "csg", "texture", "sample", "scene", "trace", "view", "accuracy", "ledger"],
    ),
    ("ledger", &["record", "scene", "trace"]),
    (
        "query",
        &[
            "record",
            "math",
            "shape",
            "csg",
            "optics",
            "texture",
            "sample",
            "scene",
            "trace",
            "view",
            "accuracy",
            "laboratory",
        ],
    ),
    (
        "compare",
        &[
            "record",
            "math",
            "shape",
            "csg",
            "optics",
            "texture",
            "sample",
            "scene",
            "trace",
            "view",
            "accuracy",
            "laboratory",
        ],
    ),
    ("document", &["record", "math", "shape", "csg", "optics", "texture", "sample", "scene", "trace", "view"]),
    ("story", &["record", "scene", "trace", "view", "query"]),
    (
        "share",
        &[
            "record",
            "math",
            "shape",
            "csg",
            "optics",
            "texture",
            "sample",
            "scene",
            "trace",
            "view",
            "accuracy",
            "laboratory",
            "query",
            "story",
        ],
    ),
    (
        "lesson",
        &[
            "record", "math", "shape", "csg", "optics", "texture", "sample", "scene", "trace", "view", "query",
            "story", "document",
        ],
    ),
    (
        "book",
        &[
            "record", "math", "shape", "csg", "optics", "texture", "sample", "scene", "trace", "view", "query",
            "story", "share", "lesson",
        ],
    ),
    ("words", &[]),
    ("peer", &["record", "math", "shape", "csg", "sample", "scene"]),
    (
        "cli",
        &[
            "query",
            "compare",
            "document",
            "story",
            "share",
            "lesson",
            "book",
            "words",
            "record",
            "math",
            "shape",
            "csg",
            "optics",
            "texture",
            "sample",
            "scene",
            "trace",
            "view",
            "accuracy",
            "laboratory",
            "ledger",
            "peer",
            "app",
        ],
    ),
    (
        "app",
        &[
            "query",
            "compare",
            "document",
            "story",
            "share",
            "lesson",
            "words",
            "record",
            "math",
            "shape",
            "csg",
            "optics",
            "texture",
            "sample",
            "scene",
            "trace",
            "view",
            "accuracy",
            "laboratory",
            "ledger",
        ],
    ),
];

/// Crates that only some places may use, and those places.
const CRATES: &[(&[&str], &[&str])] = &[
    // Whatever holds data may say how it is sent and kept; what form it then has is known here.
    (
        &["serde_json", "schemars"],
        &[
            "src/record/",
            "src/scene/",
            "src/trace/digest.rs",
            "src/trace/export.rs",
            "src/accuracy/oracle.rs",
            "src/peer/",
            "src/compare/",
            "src/share/",
            "src/document/",
            "src/lesson/",
            "src/cli/",
            "src/app/dock/",
            "src/app/edit/",
            "src/app/kept.rs",
            "src/app/system/",
        ],
    ),
    (&["postcard"], &["src/app/system/browser/"]),
    (&["jsonc_parser"], &["src/scene/"]),
    (&["include_dir"], &["src/scene/", "src/lesson/course.rs", "src/lesson_folder.rs"]),
    (&["pulldown_cmark", "toml"], &["src/lesson/source/"]),
    (&["fluent_bundle"], &["src/words/"]),
    (&["pdf_writer", "subsetter"], &["src/view/pdf.rs", "src/view/pdf/"]),
    (&["egui", "egui_tiles", "eframe", "winit", "rfd"], &["src/app/"]),
    (&["tiny_skia"], &["src/view/paint.rs"]),
    (&["ratex_parser", "ratex_layout", "ratex_types", "ratex_font"], &["src/view/formula/"]),
    (&["image_compare"], &["src/laboratory/errors.rs"]),
    (&["stacker"], &["src/trace/ray.rs"]),
    (&["clap", "ctrlc", "indicatif"], &["src/cli/"]),
];

/// What reads, writes or prints, and is therefore left to the command line and the workbench.
const INPUT_AND_OUTPUT: &[&str] = &[
    "std::fs",
    "fs::",
    "File::open",
    "std::process",
    "println!",
    "eprintln!",
    "print!",
    "eprint!",
    "dbg!",
    "std::env",
];

struct SourceFile {
    /// Path from the root of the repository, with `/` between its parts.
    path: String,
    text: String,
}

impl SourceFile {
    /// The module directly below `src/`; none for `lib.rs` and `main.rs`.
    fn module(&self) -> Option<&str> {
        self.path.strip_prefix("src/")?.split_once('/').map(|(module, _)| module)
    }

    /// Lines of code, comments cut off.
    fn code(&self) -> impl Iterator<Item = (usize, &str)> {
        self.text.lines().enumerate().map(|(number, line)| (number + 1, code_of(line)))
    }
}

/// The line up to its comment. `//` within a text in quotes stays.
fn code_of(line: &str) -> &str {
    let mut in_quotes = false;
    let mut previous = ' ';
    for (place, character) in line.char_indices() {
        if character == '"' && previous != '\\' {
            in_quotes = !in_quotes;
        }
        if !in_quotes && line[place..].starts_with("//") {
            return &line[..place];
        }
        previous = character;
    }
    line
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn rust_files(folder: &str) -> Vec<SourceFile> {
    let mut paths = Vec::new();
    collect(&root().join(folder), &mut paths);
    paths.sort();
    let read = |path: PathBuf| {
        let relative = path.strip_prefix(root()).unwrap().components();
        let parts: Vec<_> = relative.map(|part| part.as_os_str().to_str().unwrap().to_owned()).collect();
        SourceFile { path: parts.join("/"), text: fs::read_to_string(&path).unwrap() }
    };
    paths.into_iter().map(read).collect()
}

fn collect(folder: &Path, paths: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            collect(&path, paths);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            paths.push(path);
        }
    }
}

/// The modules named after `crate::`, also within braces: `crate::{math::Real, record}`.
fn modules_used(code: &str) -> BTreeSet<String> {
    let starts = code.match_indices("crate::").map(|(place, found)| &code[place + found.len()..]);
    starts.flat_map(first_names).collect()
}

fn first_names(after: &str) -> Vec<String> {
    let Some(group) = after.strip_prefix('{') else { return vec![first_word(after)] };
    let mut depth = 0_usize;
    let mut names = vec![String::new()];
    for character in group.chars() {
        match character {
            '}' if depth == 0 => break,
            '{' => depth += 1,
            '}' => depth -= 1,
            ',' if depth == 0 => names.push(String::new()),
            _ => {}
        }
        names.last_mut().unwrap().push(character);
    }
    names.iter().map(|name| first_word(name.trim_start_matches(|c: char| c == ',' || c.is_whitespace()))).collect()
}

fn first_word(text: &str) -> String {
    text.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect()
}

/// Whether the code names the crate, not merely a word that ends like it.
fn names_crate(code: &str, name: &str) -> bool {
    code.match_indices(name).any(|(place, _)| {
        let word_before = code[..place].chars().next_back().is_some_and(|c| c.is_alphanumeric() || c == '_');
        let after = &code[place + name.len()..];
        !word_before && (after.starts_with("::") || (code.contains("use ") && after.starts_with(';')))
    })
}

#[test]
fn every_module_uses_only_the_layers_below_it() {
    let known: BTreeSet<&str> = LAYERS.iter().map(|(module, _)| *module).collect();
    let mut broken = Vec::new();
    for file in rust_files("src") {
        let Some(module) = file.module() else { continue };
        let Some((_, allowed)) = LAYERS.iter().find(|(layer, _)| *layer == module) else {
            panic!("{}: the module `{module}` has no layer; give it one here and in ARCHITECTURE.md", file.path);
        };
        let code: String = file.code().map(|(_, line)| line.to_owned() + "\n").collect();
        for used in modules_used(&code) {
            if known.contains(used.as_str()) && used != module && !allowed.contains(&used.as_str()) {
                broken.push(format!("{}: {module} must not use {used}", file.path));
            }
        }
    }
    assert!(broken.is_empty(), "{}", broken.join("\n"));
}

#[test]
fn crates_stay_where_they_belong() {
    let mut broken = Vec::new();
    for file in rust_files("src") {
        for (crates, places) in CRATES {
            if places.iter().any(|place| file.path.starts_with(place)) {
                continue;
            }
            for (number, line) in file.code() {
                for name in crates.iter().filter(|name| names_crate(line, name)) {
                    broken.push(format!("{}:{number}: {name} belongs in {}", file.path, places.join(", ")));
                }
            }
        }
    }
    assert!(broken.is_empty(), "{}", broken.join("\n"));
}

#[test]
fn only_the_command_line_and_the_workbench_read_write_or_print() {
    let mut broken = Vec::new();
    for file in rust_files("src") {
        if matches!(file.module(), None | Some("cli" | "app")) {
            continue;
        }
        for (number, line) in file.code() {
            if let Some(found) = INPUT_AND_OUTPUT.iter().find(|name| line.contains(**name)) {
                broken.push(format!("{}:{number}: {found} has no place in this layer", file.path));
            }
        }
    }
    assert!(broken.is_empty(), "{}", broken.join("\n"));
}

#[test]
fn no_output_follows_the_order_of_a_hash() {
    for file in rust_files("src") {
        for (number, line) in file.code() {
            let hashed = line.contains("HashMap") || line.contains("HashSet");
            assert!(!hashed, "{}:{number}: take BTreeMap, BTreeSet or Vec, whose order is fixed", file.path);
        }
    }
}

#[test]
fn no_file_is_longer_than_500_lines() {
    let files = rust_files("src").into_iter().chain(rust_files("tests"));
    let long: Vec<_> = files
        .map(|file| (file.text.lines().count(), file.path))
        .filter(|(lines, _)| *lines > 500)
        .map(|(lines, path)| format!("{path} has {lines} lines"))
        .collect();
    assert!(long.is_empty(), "one idea, one file:\n{}", long.join("\n"));
}

#[test]
fn nothing_is_left_for_later() {
    // Put together here, so that this file does not find itself.
    let marks =
        ["TO".to_owned() + "DO", "FIX".to_owned() + "ME", "todo".to_owned() + "!", "unimplemented".to_owned() + "!"];
    let ignored = "#[ig".to_owned() + "nore";
    let mut broken = Vec::new();
    for file in rust_files("src").into_iter().chain(rust_files("tests")) {
        for (number, line) in file.text.lines().enumerate() {
            if let Some(found) = marks.iter().chain([&ignored]).find(|mark| line.contains(mark.as_str())) {
                broken.push(format!("{}:{}: {found}", file.path, number + 1));
            }
        }
    }
    assert!(broken.is_empty(), "{}", broken.join("\n"));
}

#[test]
fn the_reader_of_use_lines_sees_groups_and_passes_over_comments() {
    let code = "use crate::{math::{Real, dot}, record};\nuse crate::shape::Shape;\nlet x = crate::csg::Solid;";
    let names: Vec<_> = modules_used(code).into_iter().collect();
    assert_eq!(names, ["csg", "math", "record", "shape"]);
    assert_eq!(code_of("let a = \"http://x\"; // crate::app"), "let a = \"http://x\"; ");
    assert_eq!(code_of("/// crate::app"), "");
    assert!(names_crate("use egui::Ui;", "egui") && !names_crate("my_egui::Ui", "egui"));
    assert!(!names_crate("use serde_json::Value;", "serde"));
}
