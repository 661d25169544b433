//! `rayscope stability` and the judge behind it.

use rayscope::accuracy::{Row, SHAPES, stability};
use rayscope::shape::Method;
use std::process::{Command, Output};
use std::sync::OnceLock;

/// All rows, judged once for all tests.
fn rows() -> &'static [Row] {
    static ROWS: OnceLock<Vec<Row>> = OnceLock::new();
    ROWS.get_or_init(|| stability(|_| true, || false, || {}).unwrap())
}

fn of(shape: &'static str, solver: Method) -> impl Iterator<Item = &'static Row> {
    rows().iter().filter(move |row| row.shape == shape && row.solver == solver)
}

fn wrong(shape: &'static str, solver: Method) -> usize {
    of(shape, solver).map(|row| row.wrong).sum()
}

fn run(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_rayscope")).arg("stability").args(arguments).output().unwrap()
}

const PRIMITIVES: [&str; 7] =
    ["sphere", "square", "tapered_cylinder", "cube", "convex_polyhedron", "torus", "superellipsoid"];

#[test]
fn every_case_is_judged_for_every_solver() {
    // As many as the files have lines.
    let lines = [475, 460, 550, 530, 515, 613, 635, 325];
    for ((shape, file), lines) in SHAPES.into_iter().zip(lines) {
        let cases = rayscope::accuracy::oracle::cases(file).unwrap().len();
        assert_eq!(cases, lines, "{shape}");
        for solver in Method::ALL {
            assert_eq!(of(shape, solver).map(|row| row.cases).sum::<usize>(), cases, "{shape} {}", solver.name());
        }
    }
}

#[test]
fn what_the_program_renders_with_is_right_about_every_primitive() {
    for shape in PRIMITIVES {
        for row in of(shape, Method::Adaptive).chain(of(shape, Method::DoubleDouble)) {
            assert_eq!((row.missed, row.extra), (0, 0), "{row:?}");
            assert!(row.worst <= 16.0, "{row:?}");
        }
    }
}

#[test]
fn the_textbook_is_wrong_about_every_shape_but_those_of_planes() {
    for (shape, _) in SHAPES {
        let planes_alone = ["cube", "convex_polyhedron"].contains(&shape);
        let [textbook, adaptive] = [Method::Textbook, Method::Adaptive].map(|solver| wrong(shape, solver));
        assert!(
            if planes_alone { textbook >= adaptive } else { textbook > adaptive },
            "{shape}: {textbook} {adaptive}"
        );
    }
}

#[test]
fn sixteen_digits_with_help_are_no_worse_than_sixteen_alone() {
    for (shape, _) in SHAPES {
        let [double, adaptive] = [Method::Double, Method::Adaptive].map(|solver| wrong(shape, solver));
        assert!(adaptive <= double, "{shape}: {adaptive} {double}");
    }
}

#[test]
fn json_keeps_to_the_contract_and_agrees_with_the_library() {
    let output = run(&["--format", "json", "--shape", "sphere"]);
    assert!(output.status.success());
    let data: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let printed = data["rows"].as_array().unwrap();
    let own: Vec<_> = rows().iter().filter(|row| row.shape == "sphere").collect();
    assert_eq!(printed.len(), own.len());
    for (printed, row) in printed.iter().zip(own) {
        let members: Vec<_> = printed.as_object().unwrap().keys().map(String::as_str).collect();
        assert_eq!(members[..7], ["shape", "kind", "solver", "cases", "missed", "extra", "worst_ulp"]);
        assert_eq!(printed["shape"], "sphere");
        assert_eq!(printed["kind"], row.kind);
        assert_eq!(printed["solver"], row.solver.name());
        assert_eq!(printed["cases"], row.cases);
        assert_eq!(printed["missed"], row.missed);
        assert_eq!(printed["extra"], row.extra);
        assert_eq!(printed["worst_ulp"], row.worst);
    }
}

#[test]
fn the_table_is_the_same_on_any_number_of_threads() {
    let table = |threads: &str| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_rayscope"));
        let output = command.args(["stability", "--shape", "cube"]).env("RAYON_NUM_THREADS", threads).output().unwrap();
        String::from_utf8(output.stdout).unwrap()
    };
    let one = table("1");
    assert_eq!(one, table("3"));
    for word in ["cube", "cases", "missed", "extra", "textbook", "double-double", "  all"] {
        assert!(one.contains(word), "{word} in\n{one}");
    }
    // Every line of numbers is as long as every other.
    let lengths: Vec<_> = one.lines().take_while(|line| !line.is_empty()).skip(1).map(|l| l.chars().count()).collect();
    assert!(lengths.windows(2).all(|pair| pair[0] == pair[1]), "{one}");
}

#[test]
fn a_plot_is_the_same_on_any_number_of_threads_and_says_what_it_shows() {
    let plot = |threads: &str| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_rayscope"));
        command.args(["stability", "--shape", "sphere", "--plot", "distance"]).env("RAYON_NUM_THREADS", threads);
        String::from_utf8(command.output().unwrap().stdout).unwrap()
    };
    let one = plot("1");
    assert_eq!(one, plot("3"));
    for words in ["<svg", "Sphere: error", "attainable floor", "wrong answers", "sizes", "10⁸", ">adaptive<", ">f32<"]
    {
        assert!(one.contains(words), "{words} in\n{one}");
    }
}

#[test]
fn a_plot_of_several_shapes_at_once_is_refused() {
    let output = run(&["--shape", "csg", "--plot", "distance"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8(output.stderr).unwrap().contains("one --shape"));
}

#[test]
fn a_shape_that_is_not_there_is_answered_with_those_that_are() {
    let output = run(&["--shape", "tapir"]);
    assert_eq!(output.status.code(), Some(2));
    let message = String::from_utf8(output.stderr).unwrap();
    assert!(message.contains("tapir") && message.contains("torus"), "{message}");
}
