//! The book: every page of the course holds together, asks for nothing from outside, and can be read without a script.

use rayscope::book::{Book, BookFile, BookOptions, lesson_pdf};
use rayscope::lesson_folder::Lessons;
use rayscope::view::FONTS_IN_BROWSERS;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::sync::OnceLock;

/// Small pictures and a few worked examples: what is tested does not depend on how many there are.
const SMALL: BookOptions = BookOptions { picture_width: 12, most_examples: 5, workbench: None };

/// The files of a book by their paths, and what is wrong with its lessons.
struct Made {
    files: BTreeMap<String, Vec<u8>>,
    findings: Vec<String>,
}

impl Made {
    fn of(lessons: &Lessons) -> Self {
        let mut book = Book::new(&lessons.course, &lessons.shelf, &SMALL);
        let mut files = BTreeMap::new();
        for leaf in book.leaves() {
            for BookFile { path, bytes } in book.make(&leaf) {
                assert!(files.insert(path.clone(), bytes).is_none(), "{path} is made twice");
            }
        }
        Self { files, findings: book.findings().iter().map(ToString::to_string).collect() }
    }

    fn text(&self, path: &str) -> &str {
        let bytes = self.files.get(path).unwrap_or_else(|| panic!("there is no {path}"));
        std::str::from_utf8(bytes).unwrap()
    }

    /// All pages with their paths.
    fn pages(&self) -> impl Iterator<Item = (&str, &str)> {
        self.files
            .keys()
            .filter(|path| Path::new(path).extension().is_some_and(|ending| ending == "html"))
            .map(|path| (path.as_str(), self.text(path)))
    }
}

/// The course that comes with the program, made once for all tests.
fn course() -> &'static Made {
    static MADE: OnceLock<Made> = OnceLock::new();
    MADE.get_or_init(|| Made::of(&Lessons::embedded()))
}

/// A lesson in which everything that a page may hold is there once.
const BOWL: &str = r#"+++
title = "A ray through the bowl"
section = "6.5.1"
minutes = 5
needs = []
idea = "The first hit with a part need not be a hit with the whole."
+++

The bowl is a [compound](term:compound): two balls and a cone.

## A worked example

```step
scene = "csg/bowl"
pixel = [333, 150]
event = "hit"
views = ["side", "intervals"]
after = ["signs"]
```

The ray hits {{hit.object}} at $t = {{hit.t}}$, on *the surface* of {{hit.leaf}}:

$$t_{\mathrm{hit}} = \frac{ {{2 * hit.t}} }{2}$$

```table
of = "all('rejected')"
columns = [{ head = "part", cell = "item.leaf" }, { head = "$t$", cell = "item.t", format = "4" }]
```

```slip
printed = "The first hit with a *part* is what is seen."
right = "The first hit with the *whole* is."
shown = "rejected.t < hit.t"
```

```question
kind = "choice"
ask = "Why is the hit at $t = {{rejected.t}}$ not the one that is seen?"
hints = ["Look at the interval lists of the whole tree."]
[[choice]]
text = "The point lies in what is taken away."
right = "rejected.t < hit.t"
because = "There the boundary of a part is none of the whole."
[[choice]]
text = "The point lies behind the eye."
because = "Its time is positive, so it lies in front."
```

## Now you

```step
event = "hit"
```

Another story.

```question
kind = "edit"
ask = "Turn the camera away, until the ray misses the bowl."
until = "pixel & !has(hit=bowl)"
solution = [{ at = "camera.look_at", to = [40, 0, 0] }]
```
"#;

/// A folder of two lessons: the one above and a copy of the template.
fn own_lessons() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let template = Path::new(env!("CARGO_MANIFEST_DIR")).join("lessons/template/lesson.md");
    for (name, text) in [("01_bowl", BOWL), ("02_template", &fs::read_to_string(template).unwrap())] {
        fs::create_dir(folder.path().join(name)).unwrap();
        fs::write(folder.path().join(name).join("lesson.md"), text).unwrap();
    }
    fs::write(folder.path().join("glossary.md"), "## compound\n\nA solid that is made of solids.\n").unwrap();
    folder
}

/// The book of that folder.
fn own() -> &'static Made {
    static MADE: OnceLock<Made> = OnceLock::new();
    MADE.get_or_init(|| Made::of(&Lessons::named(own_lessons().path().to_str().unwrap()).unwrap()))
}

/// The page of the lesson above.
fn bowl() -> &'static str {
    own().text("lessons/01_bowl.html")
}

fn both() -> [&'static Made; 2] {
    [course(), own()]
}

/// The values of an attribute, wherever it stands in a page.
fn values<'a>(page: &'a str, attribute: &str) -> Vec<&'a str> {
    let start = format!(" {attribute}=\"");
    page.split(&start).skip(1).filter_map(|rest| rest.split('"').next()).collect()
}

/// A path from the folder of a page, resolved; none where it leaves the book.
fn resolved(page: &str, path: &str) -> Option<String> {
    let mut parts: Vec<&str> = page.split('/').collect();
    parts.pop();
    for part in path.split('/') {
        match part {
            ".." => {
                parts.pop()?;
            }
            part => parts.push(part),
        }
    }
    Some(parts.join("/"))
}

#[test]
fn every_link_within_the_book_leads_somewhere() {
    for made in both() {
        for (path, page) in made.pages() {
            for link in ["href", "src"].into_iter().flat_map(|attribute| values(page, attribute)) {
                if link.starts_with("rayscope:") {
                    continue;
                }
                let (file, place) = link.split_once('#').unwrap_or((link, ""));
                let file = if file.is_empty() { path.to_owned() } else { resolved(path, file).unwrap() };
                assert!(made.files.contains_key(&file), "{path} leads to {link}, which is not there");
                if !place.is_empty() {
                    let there = format!(" id=\"{place}\"");
                    assert!(made.text(&file).contains(&there), "{path} leads to {link}: no such place in {file}");
                }
            }
        }
    }
}

#[test]
fn no_two_places_of_a_page_have_the_same_name() {
    for made in both() {
        for (path, page) in made.pages() {
            let names = values(page, "id");
            let different: BTreeSet<_> = names.iter().collect();
            assert_eq!(names.len(), different.len(), "{path}");
        }
    }
}

#[test]
fn every_page_has_a_language_a_title_of_its_own_and_one_main_heading() {
    for made in both() {
        let mut titles = BTreeSet::new();
        for (path, page) in made.pages() {
            assert!(page.starts_with("<!DOCTYPE html>\n<html lang=\"en\">"), "{path}");
            let title = page.split("<title>").nth(1).and_then(|rest| rest.split("</title>").next()).unwrap();
            assert!(title.len() > 12 && titles.insert(title), "{path}: {title}");
            assert_eq!(page.matches("<h1").count(), 1, "{path}");
            assert!(page.contains("name=\"viewport\"") && page.contains("class=\"skip\" href=\"#content\""), "{path}");
        }
    }
}

#[test]
fn nothing_is_asked_for_from_outside_and_only_the_search_has_a_script() {
    for made in both() {
        for (path, page) in made.pages() {
            assert!(!page.contains("http://") && !page.contains("https://") && !page.contains("=\"//"), "{path}");
            assert_eq!(page.contains("<script"), path == "search.html", "{path}");
        }
        assert!(!made.text("book.css").contains("http") && !made.text("search.js").contains("http"));
    }
}

#[test]
fn beside_the_workbench_steps_come_alive_when_they_are_unfolded() {
    let lessons = Lessons::named(own_lessons().path().to_str().unwrap()).unwrap();
    let options = BookOptions { workbench: Some("..".to_owned()), most_examples: 0, ..SMALL };
    let mut book = Book::new(&lessons.course, &lessons.shelf, &options);
    let files: Vec<BookFile> = book.leaves().iter().flat_map(|leaf| book.make(leaf)).collect();
    let page = files.iter().find(|file| file.path == "lessons/01_bowl.html").unwrap();
    let page = std::str::from_utf8(&page.bytes).unwrap();
    let folded = "<details class=\"live\"><summary>Step through it here</summary>\n<iframe title=\"";
    assert_eq!(page.matches(folded).count(), page.matches("<iframe").count());
    assert!(page.contains("loading=\"lazy\" src=\"../../index.html?embed=view#rayscope:csg/bowl?"), "{page}");
    assert!(page.contains("class=\"workbench\" href=\"../../index.html#rayscope:csg/bowl?"), "{page}");
    assert!(!page.contains("<script") && !page.contains("href=\"rayscope:"));
}

#[test]
fn every_element_that_is_opened_is_closed() {
    let with_end = [
        "p", "a", "div", "section", "details", "figure", "svg", "ol", "ul", "dl", "table", "td", "em", "data", "nav",
        "h2", "h3", "g",
    ];
    for made in both() {
        for (path, page) in made.pages() {
            for tag in with_end {
                let opened: usize = [" ", ">"].iter().map(|end| page.matches(&format!("<{tag}{end}")).count()).sum();
                let alone = page.matches(&format!("<{tag}/>")).count();
                assert_eq!(opened, page.matches(&format!("</{tag}>")).count() + alone, "<{tag}> in {path}");
            }
        }
    }
}

#[test]
fn all_values_are_put_in_and_all_formulas_are_set() {
    for made in both() {
        assert!(made.findings.is_empty(), "{}", made.findings.join("\n"));
        for (path, page) in made.pages() {
            assert!(!page.contains("{{") && !page.contains("class=\"latex\""), "{path}");
        }
    }
    let page = bowl();
    let formula = "<svg class=\"formula\" role=\"img\" aria-label=";
    assert!(page.contains(&format!("{formula}\"t equals 8.36646\"")));
    assert!(page.contains(&format!("<div class=\"formula-line\" tabindex=\"0\">{formula}\"t sub hit equals ")));
}

#[test]
fn the_course_has_no_formula_in_a_font_that_browsers_lack() {
    let all: BTreeSet<usize> = course()
        .pages()
        .flat_map(|(_, page)| values(page, "id"))
        .filter_map(|id| id.strip_prefix('k')?.split_once('-')?.0.parse().ok())
        .collect();
    assert!(all.contains(&0), "{all:?}");
    assert!(all.iter().all(|font| *font < FONTS_IN_BROWSERS || *font > FONTS_IN_BROWSERS + 4), "{all:?}");
}

#[test]
fn every_lesson_has_a_page_with_all_its_steps_and_questions() {
    let lessons = Lessons::embedded();
    for lesson in &lessons.course.lessons {
        let page = course().text(&format!("lessons/{}.html", lesson.id));
        assert_eq!(page.matches("<section class=\"step\"").count(), lesson.steps.len(), "{}", lesson.id);
        assert_eq!(page.matches("<section class=\"question\"").count(), lesson.questions().count(), "{}", lesson.id);
        assert_eq!(page.matches("<summary>Answer</summary>").count(), lesson.questions().count(), "{}", lesson.id);
        let contents = course().text("index.html");
        assert!(contents.contains(&format!("href=\"lessons/{}.html\"", lesson.id)), "{}", lesson.id);
    }
}

#[test]
fn a_step_shows_its_drawings_its_picture_and_the_whole_story_of_its_ray() {
    let page = bowl();
    assert!(page.contains("<svg class=\"picture\" viewBox=\"0 0 640 480\""));
    assert!(page.contains("<circle cx=\"333.5\" cy=\"150.5\""), "the pixel that is looked at is marked");
    assert_eq!(page.matches("<figure class=\"drawing\">").count(), 3, "side, intervals, and with the answers signs");
    assert!(page.contains("href=\"rayscope:csg/bowl?pixel=333,150&amp;event="));
    assert!(page.contains("<code>rayscope trace csg/bowl --pixel 333,150</code>"));
    assert_eq!(
        page.matches("<summary>The ray&#39;s whole story as text</summary>").count(),
        1,
        "all steps look at the same ray"
    );
    assert!(page.contains("③ Identify the closest intersection in front of the eye"));
}

#[test]
fn what_gives_an_answer_away_is_folded_and_a_slip_is_set_apart() {
    let page = bowl();
    let (before, after) = page.split_once("<details><summary>Answer</summary>").unwrap();
    assert!(!before.contains("There the boundary of a part") && after.contains("There the boundary of a part"));
    let (_, after) = page.split_once("<summary>Drawings that show the answers</summary>").unwrap();
    assert!(after.contains("Where the ray is outside and inside"));
    assert!(page.contains("<aside class=\"slip\">") && page.contains("<code>rejected.t &lt; hit.t</code>"));
    assert!(page.contains("<a class=\"term\" href=\"../glossary.html#term-compound\">compound</a>"));
}

#[test]
fn a_drawing_has_the_colours_of_light_and_dark_by_one_picture() {
    let page = bowl();
    assert!(page.contains("fill=\"var(--c") && !page.contains("class=\"dark\""));
    assert!(page.contains("@media screen and (prefers-color-scheme:dark){:root{--c"));
}

#[test]
fn the_search_knows_every_step() {
    let index = course().text("index.js");
    for lesson in &Lessons::embedded().course.lessons {
        for number in 1..=lesson.steps.len() {
            assert!(index.contains(&format!("\"lessons/{}.html#step-{number}\"", lesson.id)), "{} {number}", lesson.id);
        }
    }
}

#[test]
fn the_same_lessons_give_the_same_bytes() {
    let again = Made::of(&Lessons::named(own_lessons().path().to_str().unwrap()).unwrap());
    assert_eq!(again.files, own().files);
}

#[test]
fn a_lesson_on_paper_is_a_pdf_of_several_pages() {
    let lessons = Lessons::named(own_lessons().path().to_str().unwrap()).unwrap();
    let lesson = &lessons.course.lessons[0];
    let (bytes, findings) = lesson_pdf(&lessons.course, lesson, &lessons.shelf);
    assert!(findings.is_empty(), "{findings:?}");
    assert!(bytes.starts_with(b"%PDF-1.7"));
    let text = String::from_utf8_lossy(&bytes);
    assert!(text.matches("/MediaBox [0 0 595 842]").count() >= 3, "text with drawings, and the answers");
    assert_eq!(bytes, lesson_pdf(&lessons.course, lesson, &lessons.shelf).0);
}

fn rayscope(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_rayscope")).args(arguments).stdin(Stdio::null()).output().unwrap()
}

#[test]
fn the_command_writes_the_site_and_says_how_far_it_is() {
    let folder = own_lessons();
    let lessons = folder.path().to_str().unwrap();
    let place = folder.path().join("book");
    let output = rayscope(&["book", lessons, "-o", place.to_str().unwrap(), "--no-examples"]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    for file in ["index.html", "lessons/01_bowl.html", "book.css", "search.html", "fonts/NotoSans-Regular.ttf"] {
        assert!(place.join(file).is_file(), "{file}");
    }
    assert!(String::from_utf8_lossy(&output.stdout).contains("A ray through the bowl\n"));
    let pdf = folder.path().join("bowl.pdf");
    let output = rayscope(&["book", "--pdf", &format!("{lessons}/01_bowl"), "-o", pdf.to_str().unwrap()]);
    assert!(output.status.success() && Path::new(&pdf).is_file(), "{}", String::from_utf8_lossy(&output.stderr));
}

#[test]
fn a_lesson_that_is_not_there_is_said_so() {
    let output = rayscope(&["book", "--pdf", "99_nothing", "-o", "nothing.pdf"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("there is no lesson 99_nothing"));
}
