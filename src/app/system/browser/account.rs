//! What the page is told: the state of the workbench for whoever asks, the story for screen readers, and news for the page around an
//! embedded workbench.

use super::host;
use crate::app::story::recording::Recording;
use crate::app::workbench::Workbench;
use crate::lesson::LessonProgress;
use crate::trace::RayTree;
use crate::view::{DetailLine, detail, row};
use egui::Context;
use serde_json::{Value, json};
use std::cell::RefCell;
use std::rc::Rc;
use std::sync::{Arc, Weak};
use wasm_bindgen::JsValue;

/// The most rows that are mirrored, around the selected one: a page of a hundred thousand rows would stand still.
const MOST_ROWS: usize = 240;

/// What was told last.
pub struct Account {
    state: Rc<RefCell<String>>,
    mirrored: Option<Mirrored>,
    step: Value,
    answers: Option<(String, LessonProgress)>,
    is_ready: bool,
}

/// What the mirror was made of: while it is the same, nothing is told anew.
struct Mirrored {
    tree: Weak<RayTree>,
    selected: u32,
    rows: usize,
}

impl Mirrored {
    fn is_of(&self, recording: &Recording) -> bool {
        let is_same = self.tree.upgrade().is_some_and(|tree| Arc::ptr_eq(&tree, &recording.tree));
        is_same && self.selected == recording.selected() && self.rows == recording.rows_told()
    }
}

impl Account {
    /// An account that the page can ask for.
    pub fn offered() -> Self {
        let state = Rc::new(RefCell::new("{}".to_owned()));
        let shown = Rc::clone(&state);
        host::offer("state", move |_| JsValue::from_str(&shown.borrow()));
        Self { state, mirrored: None, step: Value::Null, answers: None, is_ready: false }
    }

    /// Tells what has changed since the last frame.
    pub fn give(&mut self, ctx: &Context, workbench: &mut Workbench) {
        let is_painted = workbench.renderer.texture(ctx).is_some();
        *self.state.borrow_mut() = state(workbench, is_painted).to_string();
        if let Some(recording) = workbench.recording()
            && !self.mirrored.as_ref().is_some_and(|mirrored| mirrored.is_of(recording))
        {
            self.mirrored = Some(Mirrored {
                tree: Arc::downgrade(&recording.tree),
                selected: recording.selected(),
                rows: recording.rows_told(),
            });
            host::mirror(&mirror(&place(workbench), recording).to_string());
        }
        if !self.is_ready && is_painted {
            self.is_ready = true;
            host::shown();
            tell(&json!({ "type": "ready" }));
        }
        self.tell_step(workbench);
        self.tell_answers(workbench);
    }

    fn tell_step(&mut self, workbench: &Workbench) {
        let (Some(open), Some(recording)) = (workbench.scene(), workbench.recording()) else { return };
        let lesson = workbench.lesson().place();
        let step = json!({
            "type": "step",
            "scene": open.name,
            "pixel": recording.pixel,
            "event": recording.selected(),
            "lesson": lesson.map(|(lesson, _)| lesson),
            "step": lesson.map(|(_, step)| step),
        });
        if self.is_ready && self.step != step {
            tell(&step);
            self.step = step;
        }
    }

    fn tell_answers(&mut self, workbench: &Workbench) {
        let lesson = workbench.lesson().place().map(|(lesson, _)| lesson.to_owned());
        let now = lesson.and_then(|lesson| {
            let known = workbench.lesson().progress.lessons.get(&lesson)?.clone();
            Some((lesson, known))
        });
        if now == self.answers {
            return;
        }
        if let (Some((lesson, known)), Some((before, told))) = (&now, &self.answers)
            && lesson == before
        {
            for (question, record) in &known.answers {
                if told.answers.get(question).is_none_or(|told| told.tries != record.tries) {
                    tell(&json!({
                        "type": "answer", "lesson": lesson, "question": question, "solved": record.solved,
                        "tries": record.tries, "revealed": record.revealed,
                    }));
                }
            }
            let solved = known.answers.values().filter(|record| record.solved && !record.revealed).count();
            tell(&json!({
                "type": "score", "lesson": lesson, "solved": solved, "answered": known.answers.len(),
                "finished": known.finished,
            }));
        }
        self.answers = now;
    }
}

fn tell(news: &Value) {
    host::tell(&news.to_string());
}

fn state(workbench: &Workbench, is_painted: bool) -> Value {
    let recording = workbench.recording();
    let lesson = workbench.lesson().place();
    json!({
        "scene": workbench.scene().map(|open| open.name.as_str()),
        "problem": workbench.problem().map(|problem| problem.text.as_str()),
        "opening": workbench.is_opening(),
        "recording": workbench.stepping().is_recording(),
        "painted": is_painted,
        "rendered": workbench.renderer.share_done(),
        "finished": workbench.picture_finished(),
        "picture": workbench.image.seen.map(|(place, _)| rect_of(&workbench.ctx(), place.rect)),
        "size": workbench.scene().map(|open| [open.scene.image.width, open.scene.image.height]),
        "pixel": recording.map(|recording| recording.pixel),
        "event": recording.map(Recording::selected),
        "events": recording.map(|recording| recording.tree.events.len()),
        "edited": workbench.document().is_dirty(),
        "stale": workbench.is_stale(),
        "lesson": lesson.map(|(lesson, _)| lesson),
        "step": lesson.map(|(_, step)| step),
        "questions": workbench.lesson().questions(),
        "views": workbench.dock().visible().into_iter().map(|pane| pane.word()).collect::<Vec<_>>(),
    })
}

/// Left, top, width and height on the page, in its own pixels.
fn rect_of(ctx: &Context, rect: egui::Rect) -> [f32; 4] {
    [rect.left(), rect.top(), rect.width(), rect.height()].map(|points| points * ctx.zoom_factor())
}

/// The scene and the pixel.
fn place(workbench: &Workbench) -> String {
    let name = workbench.scene().map_or("", |open| open.name.as_str());
    let pixel = workbench.recording().map(|recording| recording.pixel);
    pixel.map_or_else(|| name.to_owned(), |[x, y]| format!("{name}, pixel {x}, {y}"))
}

fn mirror(title: &str, recording: &Recording) -> Value {
    let (story, told) = (recording.story(), recording.rows_told());
    let selected = story.selected();
    let middle = story.outline().row_of(selected).unwrap_or(0);
    let first = middle.saturating_sub(MOST_ROWS / 2).min(told.saturating_sub(MOST_ROWS));
    let rows = (first..told.min(first + MOST_ROWS)).filter_map(|place| story.outline().row(place)).map(|event| {
        let line = row(recording.tree.event(event));
        json!({
            "event": event,
            "level": story.depth(event),
            "text": format!("{} {}", line.label, line.numbers).trim(),
            "selected": event == selected,
        })
    });
    let rows: Vec<Value> = rows.collect();
    let detail = detail(recording.tree.event(selected));
    json!({
        "title": title,
        "before": first,
        "of": told,
        "rows": rows,
        "event": {
            "title": detail.title,
            "explanation": detail.explanation,
            "lines": detail.lines.iter().flat_map(told_lines).collect::<Vec<_>>(),
        },
    })
}

/// A line of the detail, read out; of a table one for each row.
fn told_lines(line: &DetailLine) -> Vec<String> {
    match line {
        DetailLine::Pair { name, value } => vec![format!("{name}: {value}")],
        DetailLine::Working { symbol, formula, numbers, result } => {
            let parts = [symbol, formula, numbers, result].into_iter().filter(|part| !part.is_empty());
            vec![parts.map(String::as_str).collect::<Vec<_>>().join(" = ")]
        }
        DetailLine::Table { title, headers, rows } => {
            let cells = |row: &Vec<String>| {
                let named = headers.iter().zip(row).map(|(header, cell)| format!("{header} {cell}"));
                named.collect::<Vec<_>>().join(", ")
            };
            std::iter::once(title.clone()).chain(rows.iter().map(cells)).collect()
        }
    }
}
