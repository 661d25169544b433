//! The pane of the scene's text.

use crate::app::edit::editing::Editing;
use crate::app::edit::finder::Finder;
use crate::app::edit::highlight::{Marks, highlighted};
use crate::app::edit::popup::Popup;
use crate::app::frame::code::with_code;
use crate::app::frame::theme::Palette;
use crate::app::frame::words::{say, say_with};
use crate::document::{Cause, Completion, Guide, Item, Selection, Syntax, bracket_pair};
use egui::scroll_area::ScrollAreaOutput;
use egui::text::{CCursor, CCursorRange, CharIndex, LayoutJob, TextWrapping};
use egui::text_edit::{TextEditOutput, TextEditState};
use egui::{
    Align2, Color32, Context, Event, EventFilter, FontId, Galley, Id, Rect, RichText, ScrollArea, TextBuffer, TextEdit,
    TextStyle, Ui, UiBuilder, Vec2, pos2, vec2,
};
use std::sync::Arc;

/// Height of the line below the text, in points.
const FOOT: f32 = 70.0;
/// Width of a digit of the line numbers, as a part of its height.
const DIGIT: f32 = 0.62;

/// What the pane remembers between frames.
#[derive(Default)]
pub struct Editor {
    /// Whether the text is to be typed into.
    pub wants_focus: bool,
    /// The bar that finds words.
    pub finder: Finder,
    popup: Popup,
    /// Whether the list is asked for.
    wants_popup: bool,
    /// The selection that the text field last had.
    seen: Option<Selection>,
    /// Whether the cursor has to be brought into sight.
    scroll: bool,
    /// How far to scroll for that.
    offset: Option<f32>,
}

/// The text field.
fn field() -> Id {
    Id::unique("text of the scene file")
}

impl Editor {
    /// Forgets what belonged to another text.
    pub fn reset(&mut self) {
        *self = Self { scroll: true, ..Self::default() };
    }

    /// Brings the cursor into sight.
    pub const fn show_cursor(&mut self) {
        (self.scroll, self.seen) = (true, None);
    }

    /// Asks for the list of what can be written.
    pub const fn ask_for_completion(&mut self) {
        (self.wants_popup, self.wants_focus) = (true, true);
    }

    /// Whether the text is being typed into.
    #[must_use]
    pub fn has_focus(ctx: &Context) -> bool {
        ctx.memory(egui::Memory::focused) == Some(field())
    }
}

impl Editing {
    /// Shows the pane; returns whether the cursor was moved by a person.
    pub fn editor_ui(&mut self, ui: &mut Ui) -> bool {
        self.analysis.follow(&self.document);
        let mut rect = ui.available_rect_before_wrap();
        let mut bar = ui.new_child(UiBuilder::new().id_salt("find").max_rect(rect.shrink2(vec2(8.0, 4.0))));
        if let Some(selection) = self.editor.finder.ui(&mut bar, &self.document) {
            self.document.select(selection);
            self.editor.show_cursor();
        }
        if self.editor.finder.is_open {
            rect.min.y = bar.min_rect().bottom() + 4.0;
        }
        let (above, foot) = rect.split_top_bottom_at_y((rect.bottom() - FOOT).max(rect.top()));
        let mut child = ui.new_child(UiBuilder::new().id_salt("text").max_rect(above));
        child.shrink_clip_rect(above);
        let moved = self.text_ui(&mut child);
        let mut child = ui.new_child(UiBuilder::new().id_salt("foot").max_rect(foot.shrink2(vec2(8.0, 2.0))));
        child.shrink_clip_rect(foot);
        self.foot_ui(&mut child);
        moved
    }

    fn text_ui(&mut self, ui: &mut Ui) -> bool {
        let font = TextStyle::Monospace.resolve(ui.style());
        let accepted = if Editor::has_focus(ui.ctx()) { self.editor.popup.keys(ui) } else { None };
        if let Some((completion, item)) = accepted {
            self.accept(ui.ctx(), &completion, &item);
        }
        self.push_selection(ui.ctx());
        let marks = self.marks();
        let job = highlighted(ui.ctx(), self.document.text(), &self.analysis.syntax, &marks, &font);
        let mut text = self.document.text().to_owned();
        let numbers = gutter_width(self.document.text(), &font);
        let mut area = ScrollArea::both().auto_shrink(false).id_salt("scene file");
        if let Some(offset) = self.editor.offset.take() {
            area = area.vertical_scroll_offset(offset);
        }
        let room = ui.available_size() - vec2(numbers + 6.0, 6.0);
        let output = area.show(ui, |ui| {
            ui.horizontal_top(|ui| {
                ui.spacing_mut().item_spacing.x = 0.0;
                ui.add_space(numbers);
                let output = show_text(ui, &mut text, &job, room, self.editor.popup.filter());
                self.line_numbers(ui, &output, &font);
                output
            })
            .inner
        });
        let before = self.document.selection();
        self.pull(ui.ctx(), &output.inner, &text);
        let at = cursor_rect(&output.inner, self.document.text(), self.document.selection().head);
        if std::mem::take(&mut self.editor.scroll) {
            self.editor.offset = offset_for(&output, at);
            ui.ctx().request_repaint();
        }
        if std::mem::take(&mut self.editor.wants_focus) {
            ui.memory_mut(|memory| memory.request_focus(field()));
        }
        if std::mem::take(&mut self.editor.wants_popup) {
            let offset = self.document.selection().head;
            self.editor.popup.open(self.document.text(), &self.analysis.syntax, offset);
        }
        if !Editor::has_focus(ui.ctx()) && !ui.input(|input| input.pointer.any_down()) {
            self.editor.popup.close();
        }
        if let Some((completion, item)) = self.editor.popup.ui(ui, at.left_bottom() + vec2(0.0, 4.0)) {
            self.accept(ui.ctx(), &completion, &item);
            ui.memory_mut(|memory| memory.request_focus(field()));
        }
        before != self.document.selection() && Editor::has_focus(ui.ctx())
    }

    /// Puts the document's cursor into the text field, where another than the person moved it.
    fn push_selection(&mut self, ctx: &Context) {
        let selection = self.document.selection();
        if self.editor.seen == Some(selection) {
            return;
        }
        let mut state = TextEditState::load(ctx, field()).unwrap_or_default();
        let cursor = |offset: usize| CCursor::new(CharIndex(self.document.text()[..offset].chars().count()));
        let mut range = CCursorRange::two(cursor(selection.anchor), cursor(selection.head));
        range.primary = cursor(selection.head);
        range.secondary = cursor(selection.anchor);
        state.cursor.set_char_range(Some(range));
        state.store(ctx, field());
        self.editor.seen = Some(selection);
    }

    /// Takes over what was typed and where the cursor went.
    fn pull(&mut self, ctx: &Context, output: &TextEditOutput, text: &str) {
        // Without the focus the text field knows no cursor, and the document keeps its own.
        let Some(range) = output.cursor_range.filter(|_| Editor::has_focus(ctx)) else { return };
        let offset = |cursor: CCursor| text.char_indices().nth(cursor.index.0).map_or(text.len(), |(at, _)| at);
        let selection = Selection { anchor: offset(range.secondary), head: offset(range.primary) };
        if text == self.document.text() {
            if self.editor.seen != Some(selection) {
                self.document.select(selection);
                self.editor.seen = Some(selection);
                self.editor.popup.close();
            }
            return;
        }
        let (text, selection) = indented(self.document.text(), text, selection);
        self.document.typed(&text, selection, &say(ctx, "edit-typing"));
        self.analysis.follow(&self.document);
        self.editor.seen = (text == output.galley.text()).then_some(selection);
        let typed = last_typed(ctx);
        let goes_on = typed.is_some_and(|letter| letter.is_alphanumeric() || matches!(letter, '"' | '_'));
        let opens =
            typed.is_some_and(|letter| matches!(letter, '{' | '[' | ':' | ',' | ' ')) && self.editor.popup.is_open();
        if goes_on || (self.editor.popup.is_open() && typed.is_none()) || opens {
            self.editor.popup.open(self.document.text(), &self.analysis.syntax, selection.head);
        } else {
            self.editor.popup.close();
        }
    }

    fn accept(&mut self, ctx: &Context, completion: &Completion, item: &Item) {
        let mut text = self.document.text().to_owned();
        if text.get(completion.word.clone()).is_none() {
            return;
        }
        text.replace_range(completion.word.clone(), &item.text);
        let end = completion.word.start + item.text.len();
        self.document.rewrite(&text, Selection::at(end), Cause::new(say(ctx, "edit-complete")));
        self.analysis.follow(&self.document);
        self.editor.popup.close();
    }

    fn marks(&self) -> Marks {
        let (text, syntax) = (self.document.text(), &self.analysis.syntax);
        let pair = bracket_pair(text, syntax, self.document.selection().head);
        let lit = self.target.as_ref().and_then(|place| syntax.range(place));
        let wrong = self.flaws.iter().map(|flaw| flaw.range.clone()).filter(|range| range.end <= text.len());
        Marks {
            wrong: wrong.collect(),
            found: self.editor.finder.found().to_vec(),
            brackets: pair.into_iter().flatten().map(|at| at..at + 1).collect(),
            lit,
        }
    }

    /// The numbers of the lines beside the text; those with errors have a mark.
    fn line_numbers(&self, ui: &Ui, output: &TextEditOutput, font: &FontId) {
        let palette = Palette::current(ui.ctx());
        let painter = ui.painter();
        let (mut line, mut begins) = (0, true);
        for row in &output.galley.rows {
            if begins {
                line += 1;
                let top = output.galley_pos.y + row.pos.y;
                let is_wrong = self.flaws.iter().any(|flaw| flaw.at[0] == line);
                let colour = if is_wrong { palette.problem } else { palette.weak };
                let number = if is_wrong { format!("! {line}") } else { line.to_string() };
                let at = pos2(output.galley_pos.x - 8.0, top);
                if ui.clip_rect().y_range().contains(top) || ui.clip_rect().y_range().contains(top + row.size.y) {
                    painter.text(at, Align2::RIGHT_TOP, number, font.clone(), colour);
                }
            }
            begins = row.ends_with_newline;
        }
        let x = output.galley_pos.x - 3.0;
        painter.vline(x, ui.clip_rect().y_range(), egui::Stroke::new(1.0, palette.edge));
    }

    /// The first error, or what the place at the cursor means.
    fn foot_ui(&mut self, ui: &mut Ui) {
        ui.spacing_mut().item_spacing.y = 2.0;
        let palette = Palette::current(ui.ctx());
        let cursor = self.document.selection().head;
        let here = self.flaws.iter().find(|flaw| flaw.range.start <= cursor && cursor <= flaw.range.end);
        let flaw = here.or_else(|| self.flaws.first()).cloned();
        if let Some(flaw) = flaw {
            ui.horizontal(|ui| {
                let count = say_with(ui.ctx(), "edit-errors", &[("count", self.flaws.len().into())]);
                ui.label(RichText::new(count).strong().color(palette.problem));
                if ui.small_button(say(ui.ctx(), "edit-next-error")).clicked() {
                    self.next_flaw();
                }
                if self.is_stale() {
                    let about = RichText::new(say(ui.ctx(), "edit-stale-about")).small().color(palette.weak);
                    ui.add(egui::Label::new(about).truncate());
                }
            });
            let [line, column] = flaw.at.map(|number| number.to_string());
            let arguments =
                [("line", (&line).into()), ("column", (&column).into()), ("message", (&flaw.message).into())];
            let message = say_with(ui.ctx(), "edit-error-at", &arguments);
            in_two_lines(ui, &message, &TextStyle::Body, palette.problem);
        } else {
            let place = self.analysis.syntax.place_at(cursor);
            let about = Guide::scene().at(&self.analysis.whole, &place).description(Guide::scene()).to_owned();
            ui.add(egui::Label::new(RichText::new(place.to_string()).monospace().small()).truncate());
            in_two_lines(ui, &about, &TextStyle::Small, palette.weak);
        }
    }
}

/// A sentence with as much of it as two lines hold; all of it under the pointer. Names in it stand out.
fn in_two_lines(ui: &mut Ui, text: &str, style: &TextStyle, colour: Color32) {
    let mut job = with_code(text, style.resolve(ui.style()).size, colour);
    job.wrap = TextWrapping { max_width: ui.available_width(), max_rows: 2, ..TextWrapping::default() };
    let galley = ui.painter().layout_job(job);
    ui.add(egui::Label::new(galley)).on_hover_text(text);
}

fn show_text(ui: &mut Ui, text: &mut String, job: &LayoutJob, room: Vec2, filter: EventFilter) -> TextEditOutput {
    let font = TextStyle::Monospace.resolve(ui.style());
    let mut layouter = |ui: &Ui, buffer: &dyn TextBuffer, _width: f32| -> Arc<Galley> {
        // What is typed in this frame is not in the job yet.
        let job = if buffer.as_str() == job.text {
            job.clone()
        } else {
            highlighted(ui.ctx(), buffer.as_str(), &Syntax::of(buffer.as_str()), &Marks::default(), &font)
        };
        ui.fonts_mut(|fonts| fonts.layout_job(job))
    };
    let output = TextEdit::multiline(text)
        .id(field())
        .code_editor()
        .frame(egui::Frame::NONE)
        .desired_width(room.x)
        .min_size(room)
        .event_filter(filter)
        .layouter(&mut layouter)
        .show(ui);
    let title = say(ui.ctx(), "edit-text");
    ui.ctx().accesskit_node_builder(field(), |node| node.set_label(title));
    output
}

/// Room for the numbers of the lines.
fn gutter_width(text: &str, font: &FontId) -> f32 {
    let digits = (text.matches('\n').count() + 1).to_string().len().max(2) + 2;
    digits as f32 * font.size * DIGIT + 10.0
}

/// Where the cursor is on screen.
fn cursor_rect(output: &TextEditOutput, text: &str, offset: usize) -> Rect {
    let index = text.get(..offset).map_or(0, |before| before.chars().count());
    let rect = output.galley.pos_from_cursor(CCursor::new(CharIndex(index)));
    rect.translate(output.galley_pos.to_vec2())
}

/// Where the text has to be scrolled to for the cursor to be seen; none where it is.
fn offset_for<R>(output: &ScrollAreaOutput<R>, at: Rect) -> Option<f32> {
    let inside = output.inner_rect;
    let is_seen = inside.y_range().contains(at.top()) && inside.y_range().contains(at.bottom());
    (!is_seen).then(|| (output.state.clamped_offset().y + at.center().y - inside.center().y).max(0.0))
}

/// The letter that was typed last in this frame; none where something was deleted or pasted.
fn last_typed(ctx: &Context) -> Option<char> {
    ctx.input(|input| {
        input.events.iter().rev().find_map(|event| match event {
            Event::Text(text) => text.chars().next_back(),
            _ => None,
        })
    })
}

/// A new line begins where the line before did, and deeper where that one opened a bracket.
fn indented(before: &str, after: &str, selection: Selection) -> (String, Selection) {
    let head = selection.head;
    let is_new_line = after.len() == before.len() + 1 && selection.anchor == head && after[..head].ends_with('\n');
    if !is_new_line {
        return (after.to_owned(), selection);
    }
    let line = after[..head - 1].rsplit('\n').next().unwrap_or_default();
    let spaces = &line[..line.len() - line.trim_start_matches([' ', '\t']).len()];
    let deeper = if line.trim_end().ends_with(['{', '[']) { "  " } else { "" };
    let mut text = after.to_owned();
    text.insert_str(head, &format!("{spaces}{deeper}"));
    (text, Selection::at(head + spaces.len() + deeper.len()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_new_line_is_indented_like_the_one_before_and_deeper_after_a_bracket() {
        let typed = |before: &str, at: usize| {
            let mut after = before.to_owned();
            after.insert(at, '\n');
            indented(before, &after, Selection::at(at + 1))
        };
        assert_eq!(typed("  \"a\": 1,", 9), ("  \"a\": 1,\n  ".to_owned(), Selection::at(12)));
        assert_eq!(typed("  {}", 3), ("  {\n    }".to_owned(), Selection::at(8)));
    }
}
