//! Numbers are the same on every machine: what the system's library works out comes from `math::portable` instead.

use super::{SourceFile, code_of, rust_files};
use std::collections::BTreeSet;

/// What `std` has from the system's library, or rounds as it pleases the compiler.
const OF_THE_SYSTEM: &[&str] = &[
    "sin", "cos", "tan", "sin_cos", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh", "asinh", "acosh", "atanh",
    "exp", "exp2", "exp_m1", "ln", "ln_1p", "log", "log2", "log10", "powf", "powi", "cbrt", "hypot",
];

/// What `glam` works out with these.
const OF_GLAM: &[&str] = &[
    "from_angle",
    "from_angle_translation",
    "from_scale_angle_translation",
    "from_axis_angle",
    "from_scaled_axis",
    "from_rotation_x",
    "from_rotation_y",
    "from_rotation_z",
    "from_rotation_arc",
    "from_euler",
    "to_euler",
    "to_angle",
    "to_axis_angle",
    "to_scaled_axis",
    "angle_between",
    "angle_to",
    "rotate_x",
    "rotate_y",
    "rotate_z",
    "rotate_axis",
    "rotate_towards",
    "slerp",
];

/// The forbidden functions that a line of code names: as a method, or as a function of a type other than `portable`.
fn named(code: &str) -> Vec<&'static str> {
    let all = OF_THE_SYSTEM
        .iter()
        .map(|name| (name, ["f64::", "f32::"]))
        .chain(OF_GLAM.iter().map(|name| (name, ["::", "::"])));
    all.filter(|(name, owners)| calls(code, ".", name) || owners.iter().any(|owner| calls(code, owner, name)))
        .map(|(name, _)| *name)
        .collect()
}

/// Whether `before` and the whole name stand there; behind a point it is a field unless it is called.
fn calls(code: &str, before: &str, name: &str) -> bool {
    let sought = format!("{before}{name}");
    code.match_indices(&sought).any(|(at, found)| {
        let next = code[at + found.len()..].chars().next();
        if before == "." { next == Some('(') } else { next.is_none_or(|next| !next.is_alphanumeric() && next != '_') }
    })
}

/// What is compiled for tests alone: the lines from which on a file holds its tests, and the files that are modules of tests.
struct Tests {
    begin: usize,
    modules: Vec<String>,
}

/// Reads the modules behind `#[cfg(test)]`; one in the file itself is its last part.
fn tests_of(file: &SourceFile) -> Tests {
    let lines: Vec<&str> = file.text.lines().map(str::trim).collect();
    let mut tests = Tests { begin: lines.len() + 1, modules: Vec::new() };
    for (index, _) in lines.iter().enumerate().filter(|(_, line)| **line == "#[cfg(test)]") {
        let attributes = lines[index..].iter().take_while(|line| line.starts_with("#["));
        let path = attributes.clone().find_map(|line| line.strip_prefix("#[path = \"")?.strip_suffix("\"]"));
        let Some(declared) = lines.get(index + attributes.count()) else { continue };
        let Some((_, name)) = declared.split_once("mod ").filter(|(before, _)| !before.contains("fn")) else {
            continue;
        };
        match name.strip_suffix(';') {
            Some(name) => {
                tests.modules.push(path.map_or_else(|| inside(&file.path, name), |path| beside(&file.path, path)));
            }
            None => tests.begin = tests.begin.min(index + 1),
        }
    }
    tests
}

/// Where a module's own module lies, without its ending: `a/b.rs` and `a/b/mod.rs` have theirs in `a/b/`.
fn inside(path: &str, name: &str) -> String {
    let folder = path.strip_suffix("/mod.rs").or(path.strip_suffix(".rs")).unwrap_or(path);
    format!("{folder}/{name}")
}

fn beside(path: &str, other: &str) -> String {
    let folder = path.rsplit_once('/').map_or("", |(folder, _)| folder);
    format!("{folder}/{}", other.strip_suffix(".rs").unwrap_or(other))
}

#[test]
fn no_number_comes_from_the_library_of_the_system() {
    let files = rust_files("src");
    let tests: Vec<Tests> = files.iter().map(tests_of).collect();
    let modules: BTreeSet<&str> = tests.iter().flat_map(|tests| &tests.modules).map(String::as_str).collect();
    let mut broken = Vec::new();
    for (file, tests) in files.iter().zip(&tests) {
        let place = file.path.strip_suffix(".rs").unwrap_or(&file.path);
        if modules.iter().any(|module| place == *module || place.starts_with(&format!("{module}/"))) {
            continue;
        }
        for (number, line) in file.code().take_while(|(number, _)| *number < tests.begin) {
            broken.extend(
                named(line).iter().map(|name| format!("{}:{number}: take math::portable, not {name}", file.path)),
            );
        }
    }
    assert!(broken.is_empty(), "{}", broken.join("\n"));
}

#[test]
fn the_reader_of_functions_tells_those_of_the_system_from_our_own() {
    assert_eq!(named("x.sin() + f64::hypot(a, b)"), ["sin", "hypot"]);
    assert_eq!(named("values.map(f64::log10)"), ["log10"]);
    assert_eq!(named("DQuat::from_axis_angle(axis, 1.0).slerp(q, 0.5)"), ["from_axis_angle", "slerp"]);
    assert!(named("portable::sin(probe.log) + x.sqrt() + exponent.pow(2) + own.power(3) + self.cosine()").is_empty());
    assert!(named(code_of("y // y.sin()")).is_empty());
}

#[test]
fn modules_of_tests_are_found_where_they_are_declared() {
    let source = |path: &str, text: &str| SourceFile { path: path.to_owned(), text: text.to_owned() };
    let found = |path: &str, text: &str| tests_of(&source(path, text)).modules;
    assert_eq!(found("src/a/mod.rs", "#[cfg(test)]\nmod tests;"), ["src/a/tests"]);
    assert_eq!(found("src/a/b.rs", "#[cfg(test)]\npub(super) mod testing;"), ["src/a/b/testing"]);
    assert_eq!(found("src/a/b.rs", "#[cfg(test)]\n#[path = \"b_tests.rs\"]\nmod tests;"), ["src/a/b_tests"]);
    assert_eq!(tests_of(&source("src/a.rs", "one\n#[cfg(test)]\nmod tests {\n}")).begin, 2);
}
