//! A step of a lesson: what is looked at, what is told and asked, and the whole story of the ray below it.

use super::drawings::Drawn;
use super::links::{to_workbench, trace_command};
use super::page::{Page, escaped_lines};
use super::picture::Shown;
use super::prose::words_of;
use super::search::Entry;
use super::worked_example::told_tree;
use super::{BookFile, Pictures};
use crate::lesson::model::{Aim, At, Lesson, Part, Slip, Step};
use crate::lesson::{Posed, Scenes, Shelf, Stage};
use crate::view::{View, escaped};

/// The steps of a lesson, as they are written one after the other.
pub struct Steps<'a> {
    lesson: &'a Lesson,
    path: String,
    scenes: Scenes,
    shelf: &'a dyn Shelf,
    /// What was looked at before, with the number of the step that showed it.
    shown: Vec<(Aim, usize)>,
    /// The pictures that the page needs and that are not there yet.
    pub files: Vec<BookFile>,
}

impl<'a> Steps<'a> {
    /// None written yet.
    pub fn new(lesson: &'a Lesson, path: String, shelf: &'a dyn Shelf) -> Self {
        Self { lesson, path, scenes: Scenes::default(), shelf, shown: Vec::new(), files: Vec::new() }
    }

    /// The text before the first step; its values are those of the first step's ray.
    pub fn opening(&mut self, page: &mut Page) {
        let Some(stage) = self.lesson.steps.first().and_then(|step| self.stage(step, page)) else { return };
        let opening = stage.tell(&self.lesson.opening, &mut page.findings);
        page.put("<div class=\"opening\">\n");
        page.prose_with_terms(opening);
        page.put("</div>\n");
    }

    /// Writes a step, counted from 0.
    pub fn write(&mut self, number: usize, page: &mut Page, pictures: &mut Pictures) {
        let step = &self.lesson.steps[number];
        let shown = number + 1;
        page.put(format_args!(
            "<section class=\"step\" id=\"step-{shown}\" aria-labelledby=\"step-{shown}-title\">\n\
             <h2 id=\"step-{shown}-title\"><span class=\"number\">{shown}</span> {}</h2>\n",
            escaped(&step.title)
        ));
        if let Some(stage) = self.stage(step, page) {
            page.put("<div class=\"told\">\n");
            let words = told(step, &stage, shown, page);
            page.put("</div>\n<div class=\"seen\">\n");
            let is_new = self.seen(step, &stage, shown, page, pictures);
            page.put("</div>\n");
            live(step, &stage, page);
            if is_new {
                tree(&stage, page);
            }
            self.entry(step, shown, &words, page);
        }
        page.put("</section>\n");
    }

    fn stage(&self, step: &Step, page: &mut Page) -> Option<Stage> {
        Stage::new(self.lesson, step, &self.scenes, self.shelf).map_err(|finding| page.findings.push(finding)).ok()
    }

    /// The picture, the drawings and the links; whether this ray was not looked at before.
    fn seen(&mut self, step: &Step, stage: &Stage, number: usize, page: &mut Page, pictures: &mut Pictures) -> bool {
        let before = self.shown.iter().find(|(aim, _)| is_the_same(aim, &stage.aim)).map(|(_, before)| *before);
        if before.is_none() {
            self.shown.push((stage.aim.clone(), number));
            self.picture(stage, page, pictures);
        }
        let drawn = Drawn { scene: &stage.scene.scene, tree: &stage.tree, event: stage.event };
        let views = |views: &[crate::lesson::model::Sited<&'static View>]| -> Vec<&'static View> {
            views.iter().map(|view| view.value).collect()
        };
        for view in views(&step.views) {
            drawn.figure(page, view);
        }
        let after = views(&step.after);
        if !after.is_empty() {
            page.folded("Drawings that show the answers", |page| {
                for view in after {
                    drawn.figure(page, view);
                }
            });
        }
        self.aim(step, stage, before, page);
        before.is_none()
    }

    fn picture(&mut self, stage: &Stage, page: &mut Page, pictures: &mut Pictures) {
        let scene = &stage.scene.scene;
        let key = format!("{}{:?}", stage.scene.text, stage.aim.accuracy);
        let (path, file) = pictures.of(scene, &key);
        self.files.extend(file);
        let pixel = match stage.aim.at {
            Some(At::Pixel(pixel)) => Some(pixel),
            _ => None,
        };
        let words = match pixel {
            Some([x, y]) => format!("The scene {}, with pixel {x}, {y} marked", stage.aim.scene),
            None => format!("The scene {}", stage.aim.scene),
        };
        let size = [scene.image.width, scene.image.height];
        let picture = Shown { path: format!("{}{path}", page.root), size, pixel, words: &words };
        page.put(format_args!(
            "<figure class=\"scene\">{}<figcaption>{}</figcaption></figure>\n",
            picture.html(),
            escaped(&words)
        ));
    }

    /// What is looked at, and how to look at it oneself.
    fn aim(&self, step: &Step, stage: &Stage, before: Option<usize>, page: &mut Page) {
        page.put(format_args!("<div class=\"aim\"><p>Looked at: {}.", escaped(&stage.aim_in_words())));
        if let Some(before) = before {
            page.put(format_args!(
                " Its picture and whole story are with <a href=\"#step-{before}\">step {before}</a>."
            ));
        }
        if let Some(link) = to_workbench(step, stage) {
            let address = page.workbench.address(page.root, &link);
            page.put(format_args!(" <a class=\"workbench\" href=\"{}\">Open in the workbench</a>", escaped(&address)));
        }
        page.put("</p>\n");
        let command = trace_command(&stage.aim).unwrap_or_else(|| format!("rayscope lesson open {}", self.lesson.id));
        page.put(format_args!("<p>On the command line: <code>{}</code></p></div>\n", escaped(&command)));
    }

    fn entry(&self, step: &Step, number: usize, words: &str, page: &mut Page) {
        let title = format!("{}: {}", super::numbered_title(self.lesson), step.title);
        let terms = std::mem::take(&mut page.terms);
        page.entries.push(Entry {
            title,
            path: format!("{}#step-{number}", self.path),
            words: words.to_owned(),
            terms,
        });
    }
}

/// Two aims that show the same, wherever they are written.
fn is_the_same(one: &Aim, other: &Aim) -> bool {
    let key = |aim: &Aim| (aim.scene.clone(), format!("{:?}", aim.changes), format!("{:?}{:?}", aim.at, aim.accuracy));
    key(one) == key(other)
}

/// The parts of a step; its words.
fn told(step: &Step, stage: &Stage, number: usize, page: &mut Page) -> String {
    let mut words = String::new();
    let mut questions = 0;
    for part in &step.parts {
        match part {
            Part::Prose(prose) => {
                let prose = stage.tell(prose, &mut page.findings);
                words.push_str(&words_of(&prose));
                page.prose_with_terms(prose);
            }
            // What has to hold is for the check and for teachers.
            Part::Claims(_) => {}
            Part::Slip(slip) => self::slip(slip, stage, page),
            Part::Table(table) => {
                let told = stage.table(table, &mut page.findings);
                page.table(&told.head, &told.rows);
            }
            Part::Question(question) => match Posed::new(question, stage) {
                Ok(posed) => {
                    questions += 1;
                    words.push_str(&words_of(&posed.ask));
                    page.question(&posed, &format!("{number}.{questions}"));
                }
                Err(findings) => page.findings.extend(findings),
            },
        }
    }
    words
}

fn slip(slip: &Slip, stage: &Stage, page: &mut Page) {
    page.put("<aside class=\"slip\">\n<h3>A slip in the printed chapter</h3>\n<div class=\"printed\">\n<p class=\"who\">Printed</p>\n");
    let printed = stage.tell(&slip.printed, &mut page.findings);
    page.prose(&printed);
    page.put("</div>\n<div class=\"mended\">\n<p class=\"who\">Right</p>\n");
    let right = stage.tell(&slip.right, &mut page.findings);
    page.prose(&right);
    page.put("</div>\n");
    page.folded("What the recorded ray shows", |page| {
        page.put(format_args!("<p><code>{}</code> holds.</p>\n", escaped(slip.shown.value.text())));
    });
    page.put("</aside>\n");
}

fn live(step: &Step, stage: &Stage, page: &mut Page) {
    let link = to_workbench(step, stage);
    if let Some(live) = link.and_then(|link| page.workbench.live(page.root, &link, &step.title)) {
        page.put(live);
    }
}

fn tree(stage: &Stage, page: &mut Page) {
    let text = told_tree(&stage.tree);
    page.put("<div class=\"tree\">\n");
    page.folded("The ray's whole story as text", |page| {
        page.put(format_args!("<pre tabindex=\"0\">{}</pre>\n", escaped_lines(&text)));
    });
    page.put("</div>\n");
}
