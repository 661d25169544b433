//! What the page asks of the workbench: for the mirror, for the page around an embedded one, and for tests.

use super::digest::Digests;
use crate::app::frame::background::Background;
use crate::app::frame::task;
use crate::app::workbench::Workbench;
use crate::record::EventId;
use crate::share::link::Link;
use crate::story::Step;
use serde::Deserialize;

/// A request, as JSON: `{"do": "select", "event": 12}`.
#[derive(Deserialize)]
#[serde(tag = "do", rename_all = "snake_case", deny_unknown_fields)]
enum Asked {
    /// Selects an event of the story.
    Select { event: EventId },
    /// Goes to the next event.
    Next,
    /// Goes to the event before.
    Back,
    /// Goes into the event.
    Into,
    /// Goes out of the event.
    Out,
    /// Records a pixel.
    Pixel { x: u32, y: u32 },
    /// Follows a link.
    Open { link: String },
    /// Answers a question of the lesson's step.
    Answer { question: usize, answer: Given },
    /// Works out the digests of the scene that is open, in a worker.
    Digests { width: u32 },
    /// Opens a lesson, at a step counted from 0.
    Lesson { lesson: String, step: Option<usize> },
}

/// An answer.
#[derive(Deserialize)]
#[serde(untagged)]
enum Given {
    /// A number, or the place of a choice, counted from 0.
    Number(f64),
    /// An order of items, counted from 0.
    Order(Vec<usize>),
}

/// Does what is asked; returns digests that are being worked out. What makes no sense is told in the page's console, where whoever wrote it looks.
pub fn carry_out(workbench: &mut Workbench, text: &str) -> Option<Background<Vec<String>>> {
    match serde_json::from_str(text) {
        Ok(Asked::Digests { width }) => {
            let open = workbench.scene()?;
            return task::begin(&workbench.ctx(), &open.whole, Digests { width });
        }
        Ok(asked) => asked_of(workbench, asked),
        Err(error) => log::warn!("rayscope was asked for something that it does not know: {error}: {text}"),
    }
    None
}

fn asked_of(workbench: &mut Workbench, asked: Asked) {
    let ctx = workbench.ctx();
    match asked {
        Asked::Select { event } => {
            let is_there = |recording: &crate::app::Recording| (event as usize) < recording.tree.events.len();
            if workbench.recording().is_some_and(is_there) {
                workbench.select(event);
            }
        }
        Asked::Digests { .. } => {}
        Asked::Answer { question, answer: Given::Number(value) } => workbench.answer_by_number(question, value),
        Asked::Answer { question, answer: Given::Order(order) } => workbench.answer_by_order(question, &order),
        Asked::Next => step(workbench, Step::Next),
        Asked::Back => step(workbench, Step::Back),
        Asked::Into => step(workbench, Step::Into),
        Asked::Out => step(workbench, Step::Out),
        Asked::Pixel { x, y } => {
            let image = workbench.scene().map(|open| open.scene.image);
            if image.is_some_and(|image| x < image.width && y < image.height) {
                workbench.record([x, y]);
            }
        }
        Asked::Open { link } => match link.parse::<Link>() {
            Ok(link) => workbench.follow(&ctx, &link),
            Err(error) => workbench.refuse("link", error.to_string()),
        },
        Asked::Lesson { lesson, step } => match step {
            Some(step) => workbench.open_lesson_at(&lesson, step),
            None => workbench.open_lesson(&lesson),
        },
    }
}

fn step(workbench: &mut Workbench, step: Step) {
    if let Some(recording) = &mut workbench.recording {
        recording.step(step);
    }
}
