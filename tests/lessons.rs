//! Lessons: the whole course is run, and what is false, stale or typed does not pass.

use rayscope::lesson::{Checked, Course, Exam, LessonText, NoShelf, Scenes, check_course, check_lesson, read};
use rayscope::lesson_folder::Lessons;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// The sections of the syllabus that a lesson is asked for, one for each of its rows.
const ROWS: [&str; 22] = [
    "6.1", "6.2.1", "6.2.2", "6.2.3", "6.2.4", "6.3.0", "6.3.1", "6.3.2", "6.3.3", "6.3.4", "6.3.5", "6.3.6", "6.3.7",
    "6.3.8", "6.4", "6.4.1", "6.5", "6.5.1", "6.5.2", "6.5.3", "6.5.4", "6.2",
];

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn wrong(checked: &Checked) -> String {
    checked.findings.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n")
}

#[test]
fn everything_that_the_course_says_holds() {
    let lessons = Lessons::embedded();
    let checked = check_course(&lessons.course, &lessons.shelf, &mut |_, _| true);
    assert!(checked.findings.is_empty(), "{}", wrong(&checked));
    assert!(checked.claims > 100 && checked.answers > 500, "{} claims, {} answers", checked.claims, checked.answers);
}

#[test]
fn there_is_a_lesson_for_every_section_and_every_slip_is_told() {
    let course = Course::embedded();
    assert!(course.lessons.len() >= 24, "{} lessons", course.lessons.len());
    let sections: BTreeSet<&str> = course.lessons.iter().map(|lesson| lesson.header.section.value.as_str()).collect();
    for row in ROWS.iter().filter(|row| **row != "6.2") {
        assert!(sections.contains(row), "no lesson is about § {row}");
    }
    let slips = |section: &str| {
        let lessons = course.lessons.iter().filter(|lesson| lesson.header.section.value == section);
        lessons
            .flat_map(|lesson| &lesson.steps)
            .flat_map(|step| &step.parts)
            .filter(|part| matches!(part, rayscope::lesson::Part::Slip(_)))
            .count()
    };
    // Where the syllabus says that the notes slip, and how often at least.
    for (section, least) in [
        ("6.2.1", 1),
        ("6.2.2", 2),
        ("6.2.3", 2),
        ("6.2.4", 2),
        ("6.3.2", 1),
        ("6.3.3", 1),
        ("6.3.5", 1),
        ("6.3.7", 1),
        ("6.3.8", 1),
        ("6.4", 1),
        ("6.4.1", 1),
        ("6.5.1", 1),
        ("6.5.3", 3),
    ] {
        assert!(slips(section) >= least, "§ {section} tells {} slips, and there are {least}", slips(section));
    }
}

#[test]
fn links_into_the_source_lead_to_files() {
    for lesson in Course::embedded().lessons {
        let text = fs::read_to_string(root().join(&lesson.file)).expect("the lesson is there");
        for path in text.split("](source:").skip(1).filter_map(|rest| rest.split(')').next()) {
            assert!(root().join(path).is_file(), "{}: there is no {path}", lesson.file);
        }
    }
}

#[test]
fn the_template_is_a_lesson_that_holds() {
    let lessons =
        Lessons::named(root().join("lessons/template").to_str().expect("the path is text")).expect("it is there");
    let lesson = lessons.course.lesson("template").expect("it was read");
    let checked = check_lesson(lesson, &Scenes::default(), &lessons.shelf);
    assert!(checked.findings.is_empty(), "{}", wrong(&checked));
    assert!(lessons.course.findings.is_empty());
}

/// A lesson that holds, with one line of it replaced.
fn broken(from: &str, to: &str) -> Vec<(usize, String)> {
    let text = fs::read_to_string(root().join("lessons/template/lesson.md")).expect("the template is there");
    assert!(text.contains(from), "the template has no `{from}`");
    let text = text.replacen(from, to, 1);
    let (lesson, mut findings) = read("01_broken", "lesson.md", &text);
    if let Some(lesson) = lesson {
        findings.extend(check_lesson(&lesson, &Scenes::default(), &NoShelf).findings);
    }
    findings.sort();
    findings.dedup();
    findings.into_iter().map(|finding| (finding.place.line, finding.message)).collect()
}

fn says(from: &str, to: &str, message: &str) {
    let text = fs::read_to_string(root().join("lessons/template/lesson.md")).expect("the template is there");
    let line = text[..text.find(from).expect("it is there")].matches('\n').count() + 1;
    let findings = broken(from, to);
    let found = findings.iter().find(|(_, found)| found.contains(message));
    let (at, _) = found.unwrap_or_else(|| panic!("`{to}`: nothing says `{message}`: {findings:?}"));
    assert!(at.abs_diff(line) <= 12, "`{to}` is in line {line}, and the message names {at}");
}

#[test]
fn a_false_claim_fails_with_both_sides() {
    says("hit.object == \"bowl\"", "hit.object == \"floor\"", "the left side is bowl, the right side floor");
}

#[test]
fn a_stale_reference_fails_with_what_there_is() {
    says("{{hit.t}}", "{{hit.time}}", "there is no field `time`");
    says("{{hit.leaf}}", "{{snell.n1}}", "no event of the trace answers `snell`");
}

#[test]
fn a_typed_number_fails_wherever_it_stands() {
    says("Tell what happens", "At t = 8.37", "`8.37` is a typed number");
    says("{{hit.t}}", "{{8.366}}", "is a typed number");
    says("$t = {{hit.t}}$", "$t = 8.366$", "`8.366` is a typed number");
    says("The point lies behind the eye.", "It lies 3 units behind.", "`3` is a typed number");
}

#[test]
fn questions_without_one_right_answer_fail() {
    says("right = \"rejected.t < 0\"", "right = true", "exactly one choice is to be right, and 2 are");
    says("right = \"rejected.t < hit.t\"", "right = false", "exactly one choice is to be right, and none is");
}

#[test]
fn a_solution_that_solves_nothing_fails_and_so_does_a_wrong_change_that_does() {
    says("to = [40, 0, 0]", "to = [0, 0, 0.4]", "the solution does not do what `until` asks");
    says(
        "at = \"camera.field_of_view\", to = 36",
        "at = \"camera.look_at\", to = [40, 0, 0]",
        "does what `until` asks",
    );
    says("at = \"camera.look_at\"", "at = \"camera.nonsense\"", "the solution");
}

#[test]
fn unknown_things_are_named_with_what_is_meant() {
    says("scene = \"csg/bowl\"", "scene = \"csg/bowel\"", "there is no scene `csg/bowel`");
    says("event = \"hit\"", "event = \"hti\"", "did you mean");
    says("views = [\"side\", \"intervals\"]", "views = [\"sideways\"]", "there is no view `sideways`");
    says("views = [\"side\", \"intervals\"]", "views = [\"snell\"]", "the view `snell` shows nothing of this ray");
    says("pixel = [333, 150]", "pixel = [333, 9999]", "lies outside the picture");
    says("section = \"6.5.1\"", "section = \"7.1\"", "is no section of the syllabus");
    says("minutes = 5", "minutes = 50", "a lesson takes 5 to 15 minutes");
    says("kind = \"choice\"", "kind = \"chioce\"", "choice");
    says("```claim", "```clam", "`clam` is no block");
    says("title = \"A ray through the bowl\"", "titel = \"A ray\"", "titel");
}

#[test]
fn a_lesson_that_ends_without_a_change_fails() {
    let text = fs::read_to_string(root().join("lessons/template/lesson.md")).expect("the template is there");
    let (lesson, findings) = read("01_longer", "lesson.md", &(text + "\n## One more\n\nNothing is changed here.\n"));
    assert_eq!(findings, []);
    let checked = check_lesson(&lesson.expect("it was read"), &Scenes::default(), &NoShelf);
    assert!(wrong(&checked).contains("the last step ends with a question of the kind `edit`"), "{}", wrong(&checked));
}

#[test]
fn a_broken_file_is_no_reason_to_panic() {
    let text = fs::read_to_string(root().join("lessons/template/lesson.md")).expect("the template is there");
    for cut in (0..text.len()).step_by(7).filter(|&cut| text.is_char_boundary(cut)) {
        let (lesson, findings) = read("01_cut", "lesson.md", &text[..cut]);
        assert!(lesson.is_some() || !findings.is_empty(), "cut at {cut}: neither a lesson nor a reason");
    }
}

#[test]
fn needs_that_are_missing_or_come_later_are_found() {
    let text = |needs: &str| {
        format!("+++\ntitle = \"A\"\nsection = \"6.1\"\nminutes = 5\nneeds = [{needs}]\nidea = \"B\"\n+++\n## One\n")
    };
    let lesson =
        |id: &str, needs: &str| LessonText { id: id.to_owned(), file: format!("{id}/lesson.md"), text: text(needs) };
    let course =
        Course::read(&[lesson("01_a", "\"02_b\""), lesson("02_b", "\"01_a\""), lesson("03_c", "\"09_z\"")], None);
    let messages: Vec<String> = course.unmet_needs().iter().map(ToString::to_string).collect();
    assert_eq!(messages.len(), 2, "{messages:?}");
    assert!(messages[0].contains("`02_b` does not come before") && messages[1].contains("there is no lesson `09_z`"));
}

#[test]
fn an_examination_follows_from_its_seed() {
    let lessons = Lessons::embedded();
    let drawn = |seed: u64| {
        let exam = Exam::draw(&lessons.course, &[], 6, seed, &Scenes::default(), &lessons.shelf);
        exam.questions
            .iter()
            .map(|question| format!("{}/{}/{:?}", question.lesson, question.step, question.posed))
            .collect::<Vec<_>>()
    };
    let (first, again, other) = (drawn(1), drawn(1), drawn(2));
    assert_eq!(first.len(), 6);
    let exam = Exam::draw(&lessons.course, &[], 6, 1, &Scenes::default(), &lessons.shelf);
    assert!(
        exam.questions.iter().any(|question| !question.before.is_empty()),
        "the questions lack what is told before them"
    );
    assert_eq!(first, again);
    assert_ne!(first, other);
}

#[test]
fn the_schema_of_blocks_is_the_one_beside_the_lessons() {
    let path = root().join("lessons/lesson.schema.json");
    let written = fs::read_to_string(&path).unwrap_or_default();
    let schema =
        serde_json::to_string_pretty(&rayscope::lesson::lesson_schema()).expect("a schema can be written") + "\n";
    assert!(
        written == schema,
        "lessons/lesson.schema.json is out of date: `rayscope schema lesson > lessons/lesson.schema.json` writes it anew"
    );
}

/// What a lesson says, its answers and what is said of wrong ones among it: a change of the tracer that changes what students read
/// is seen here, and read before it is accepted.
#[test]
fn every_lesson_reads_as_it_was_read_last() {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path("../snapshots");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    for lesson in &Lessons::embedded().course.lessons {
        let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_rayscope"));
        let output = command.args(["lesson", "show", &lesson.id, "--answers"]).output().unwrap();
        assert!(output.status.success(), "{}: {}", lesson.id, String::from_utf8_lossy(&output.stderr));
        settings.set_snapshot_suffix(&lesson.id);
        let text = String::from_utf8(output.stdout).unwrap();
        settings.bind(|| insta::assert_snapshot!("lesson", text));
    }
}
