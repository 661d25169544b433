//! The field that a question is typed into, with what may stand at the cursor and what is wrong.

use crate::app::frame::theme::Palette;
use crate::app::frame::words::say;
use crate::query::{Completion, Query, QueryError, Vocabulary, complete};
use egui::text::{LayoutJob, TextFormat};
use egui::{
    CompletionPopup, CompletionQuery, FontId, Id, RectAlign, RichText, Stroke, Suggestion, TextBuffer, TextEdit,
    TextStyle, Ui,
};

/// Letters between a completion and its meaning.
const GAP: usize = 6;
/// A meaning of fewer letters would tell nothing.
const LEAST: usize = 12;

/// The field with what was typed.
#[derive(Default)]
pub struct Field {
    text: String,
    /// What the text was read as.
    read: Option<Result<Query, QueryError>>,
    wants_focus: bool,
    /// Completions are offered for what is being typed: it is not yet to be judged.
    is_completing: bool,
}

/// What was done in the field.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Typed {
    /// The text has changed.
    Changed,
    /// Enter was pressed.
    Entered,
}

impl Field {
    /// Takes the focus when it is shown next.
    pub fn focus(&mut self) {
        self.wants_focus = true;
    }

    /// Puts another text there.
    pub fn set(&mut self, text: impl Into<String>) {
        self.text = text.into();
        self.read();
    }

    /// The question that was typed, if it is one.
    pub fn query(&self) -> Option<&Query> {
        self.read.as_ref()?.as_ref().ok()
    }

    /// Whether nothing was typed.
    pub fn is_empty(&self) -> bool {
        self.text.trim().is_empty()
    }

    fn read(&mut self) {
        self.read = (!self.is_empty()).then(|| Query::parse(&self.text));
    }

    /// Shows the field in what is left of the row.
    pub fn ui(&mut self, ui: &mut Ui, vocabulary: &Vocabulary) -> Option<Typed> {
        let id = Id::unique("search field");
        if self.wants_focus {
            ui.memory_mut(|memory| memory.request_focus(id));
        }
        let (hint, name) = (say(ui.ctx(), "search-hint"), say(ui.ctx(), "search-field"));
        let before = self.text.clone();
        let error =
            self.read.as_ref().and_then(|read| read.as_ref().err()).map(|error| (before.clone(), error.clone()));
        let mut layouter = |ui: &Ui, text: &dyn TextBuffer, _width: f32| {
            let job = marked(ui, text.as_str(), error.as_ref());
            ui.ctx().fonts_mut(|fonts| fonts.layout_job(job))
        };
        let edit = TextEdit::singleline(&mut self.text)
            .hint_text(hint)
            .desired_width(f32::INFINITY)
            .font(TextStyle::Monospace)
            .layouter(&mut layouter);
        let popup = CompletionPopup::new(id)
            .word_boundary(|c| c.is_whitespace() || "&|!()=<>≤≥≠".contains(c))
            .align(RectAlign::BOTTOM_START)
            .max_height(260.0);
        let columns = columns(ui);
        let mut is_completing = false;
        let output = popup.show(ui, edit, |query| {
            let offered = suggestions(query, vocabulary, columns);
            is_completing |= !query.word.is_empty() && !offered.is_empty();
            offered
        });
        let response = output.text_edit.response.response;
        // What lay over the window in the frame before, as the palette did, still keeps the focus to itself.
        self.wants_focus &= !response.has_focus();
        self.is_completing = is_completing && response.has_focus();
        ui.ctx().accesskit_node_builder(response.id, |node| node.set_label(name));
        if self.text != before {
            self.read();
            return Some(Typed::Changed);
        }
        let is_entered = response.lost_focus() && ui.input(|input| input.key_pressed(egui::Key::Enter));
        (is_entered || output.accepted.is_some()).then_some(Typed::Entered)
    }

    /// What is wrong with the text, in a line; nothing while nothing is wrong, or while it is being completed.
    pub fn problem(&self, ui: &mut Ui) {
        if let Some(Err(error)) = self.read.as_ref().filter(|_| !self.is_completing) {
            let colour = Palette::current(ui.ctx()).problem;
            ui.label(RichText::new(error.to_string()).small().color(colour));
        }
    }
}

/// The text with a line under what is wrong in it.
fn marked(ui: &Ui, text: &str, error: Option<&(String, QueryError)>) -> LayoutJob {
    let palette = Palette::current(ui.ctx());
    let font = FontId::monospace(TextStyle::Monospace.resolve(ui.style()).size);
    let plain = TextFormat { font_id: font, color: palette.text, ..TextFormat::default() };
    let wrong = TextFormat { color: palette.problem, underline: Stroke::new(1.5, palette.problem), ..plain.clone() };
    // A text that was typed on in this frame is read only after it is laid out.
    let range = error.filter(|(of, _)| of == text).map_or(0..0, |(_, error)| {
        let byte = |character: usize| text.char_indices().nth(character).map_or(text.len(), |(byte, _)| byte);
        byte(error.column - 1)..byte(error.column - 1 + error.length)
    });
    let mut job = LayoutJob { break_on_newline: false, ..LayoutJob::default() };
    job.append(&text[..range.start], 0.0, plain.clone());
    job.append(&text[range.clone()], 0.0, wrong);
    job.append(&text[range.end..], 0.0, plain);
    job
}

/// About how many letters stand beside each other in the list of completions.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a window is a few thousand points")]
fn columns(ui: &Ui) -> usize {
    let letter = 0.56 * TextStyle::Button.resolve(ui.style()).size;
    (ui.available_width().max(0.0) / letter) as usize
}

/// A completion with its meaning, as far as there is room beside it.
fn suggestion(completion: Completion, columns: usize) -> Suggestion {
    let room = columns.saturating_sub(completion.text.chars().count() + GAP);
    let meaning = match completion.meaning.chars().count() {
        count if count <= room => completion.meaning,
        _ if room < LEAST => String::new(),
        _ => completion.meaning.chars().take(room - 1).chain(['…']).collect(),
    };
    Suggestion::new(completion.text).description(meaning)
}

/// What may stand at the cursor; nothing where a whole question ends.
fn suggestions(query: &CompletionQuery, vocabulary: &Vocabulary, columns: usize) -> Vec<Suggestion> {
    let byte = |character: usize| query.text.char_indices().nth(character).map_or(query.text.len(), |(byte, _)| byte);
    let [start, cursor] = [query.word_range.start, query.word_range.end].map(|index| byte(index.0));
    if query.text.trim().is_empty() || (query.word.is_empty() && Query::parse(query.text).is_ok()) {
        return Vec::new();
    }
    let all = complete(query.text, cursor, vocabulary);
    let here = all.into_iter().filter(|completion| completion.replaces.start == start);
    let mut here: Vec<_> = here.collect();
    let is_whole = here.iter().any(|completion| completion.text == query.word);
    if is_whole && (here.len() == 1 || Query::parse(query.text).is_ok()) {
        here.clear();
    }
    here.into_iter().map(|completion| suggestion(completion, columns)).collect()
}
