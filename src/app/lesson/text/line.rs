//! One paragraph: its words, values, formulas and links.

use super::flow::{Flow, Lines, Piece};
use super::formula::ink;
use super::{Reader, TextWish, running, strip};
use crate::app::frame::theme::{Palette, bold};
use crate::app::frame::words::{say, say_with};
use crate::lesson::prose::{Inline, Line, Target, Told, code, latex};
use egui::text::TextFormat;
use egui::{Color32, CursorIcon, FontId, Rect, Response, Role, Sense, Stroke, StrokeKind, Ui, WidgetInfo};

/// What is done when a part of a paragraph is clicked, and what is told when the pointer lies on it.
struct Deed {
    wish: TextWish,
    label: String,
    about: String,
}

/// A paragraph that is being put together.
struct Draft {
    flow: Flow,
    deeds: Vec<Deed>,
    words: String,
    width: f32,
    /// Whether a click in it is for what it stands in: then its values and links are words like others.
    is_option: bool,
}

impl Reader<'_> {
    /// Shows a paragraph, as wide as there is room.
    pub fn line(&mut self, ui: &mut Ui, line: &Line<Told>, font: &FontId) {
        let width = ui.available_width();
        let draft = self.draft(ui, line, font, width, false);
        self.show(ui, draft);
    }

    /// Shows an answer that can be chosen or moved. Its values lead nowhere: their events would tell which one is right.
    pub fn option(&mut self, ui: &mut Ui, line: &Line<Told>) {
        let width = ui.available_width();
        let draft = self.draft(ui, line, &running(), width, true);
        self.show(ui, draft);
    }

    /// Shows a line that is no wider than its column.
    pub fn cell(&mut self, ui: &mut Ui, line: &Line<Told>, font: &FontId, width: f32) {
        let Draft { flow, deeds, words, .. } = self.draft(ui, line, font, width, false);
        self.lines(ui, &flow.broken(), &deeds, &words);
    }

    /// How wide a line is that is not broken, and how wide the widest of what has no space in it is.
    pub fn widths(&mut self, ui: &Ui, line: &Line<Told>, font: &FontId) -> [f32; 2] {
        self.draft(ui, line, font, f32::INFINITY, false).flow.widths()
    }

    fn draft(&mut self, ui: &Ui, line: &Line<Told>, font: &FontId, width: f32, is_option: bool) -> Draft {
        let format = TextFormat::simple(font.clone(), ink(ui.ctx()));
        let flow = Flow::new(ui.ctx(), &format, width);
        let mut draft = Draft { flow, deeds: Vec::new(), words: String::new(), width, is_option };
        self.inlines(ui, line, &format, None, &mut draft);
        draft
    }

    /// Shows a paragraph; one with a formula that is wider than the room is scrolled.
    fn show(&mut self, ui: &mut Ui, draft: Draft) {
        let Draft { flow, deeds, words, width, .. } = draft;
        let lines = flow.broken();
        if lines.size.x > width + 1.0 {
            self.count += 1;
            let salt = ("wide", self.count);
            strip(ui, salt, |ui| self.lines(ui, &lines, &deeds, &words));
        } else {
            self.lines(ui, &lines, &deeds, &words);
        }
    }

    fn lines(&mut self, ui: &mut Ui, lines: &Lines, deeds: &[Deed], words: &str) {
        let (rect, _) = ui.allocate_exact_size(lines.size, Sense::hover());
        self.count += 1;
        let id = ui.scope_id().with(("paragraph", self.count));
        ui.interact(rect, id, Sense::hover()).widget_info(|| WidgetInfo::labeled(Role::Label, true, words));
        for (place, (deed, spot)) in lines.deeds(rect.min).into_iter().enumerate() {
            let response = ui.interact(spot.expand(1.0), id.with(place), Sense::click());
            self.link(ui, response, spot, &deeds[deed]);
        }
        if ui.is_rect_visible(rect) {
            lines.paint(ui, rect.min);
        }
    }

    /// Makes a part of a paragraph a link.
    fn link(&mut self, ui: &Ui, response: Response, spot: Rect, deed: &Deed) {
        response.widget_info(|| WidgetInfo::labeled(Role::Link, true, &deed.label));
        let palette = Palette::current(ui.ctx());
        let is_selected = matches!(deed.wish, TextWish::Select(event) if Some(event) == self.selected);
        if response.hovered() || is_selected {
            ui.painter().rect_filled(spot.expand(1.0), 3.0, palette.selected);
        }
        if response.has_focus() {
            ui.painter().rect_stroke(spot.expand(1.0), 3.0, Stroke::new(1.5, palette.accent), StrokeKind::Outside);
        }
        let response = response.on_hover_cursor(CursorIcon::PointingHand);
        if response.clicked() {
            self.wish = Some(deed.wish.clone());
        }
        response.on_hover_ui(|ui| self.tell_about(ui, deed));
    }

    fn tell_about(&mut self, ui: &mut Ui, deed: &Deed) {
        let meaning = match &deed.wish {
            TextWish::Term(name) => self.terms.get(name),
            _ => None,
        };
        match meaning {
            Some(meaning) => {
                ui.set_max_width(340.0);
                Reader::new(self.formulas, self.terms, None).prose(ui, meaning);
            }
            None => {
                ui.label(&deed.about);
            }
        }
    }

    fn inlines(&mut self, ui: &Ui, line: &Line<Told>, format: &TextFormat, deed: Option<usize>, draft: &mut Draft) {
        for inline in line {
            self.inline(ui, inline, format, deed, draft);
        }
    }

    fn inline(&mut self, ui: &Ui, inline: &Inline<Told>, format: &TextFormat, deed: Option<usize>, draft: &mut Draft) {
        match inline {
            Inline::Text(text) => draft.words(ui, text, format, deed),
            Inline::Value(told) => draft.value(ui, told, format),
            Inline::Emphasis(line) => {
                let format = TextFormat { italics: true, ..format.clone() };
                self.inlines(ui, line, &format, deed, draft);
            }
            Inline::Strong(line) => {
                let format = TextFormat { font_id: FontId::new(format.font_id.size, bold()), ..format.clone() };
                self.inlines(ui, line, &format, deed, draft);
            }
            Inline::Code(pieces) => {
                let backdrop = Palette::current(ui.ctx()).backdrop;
                let font_id = FontId::monospace(format.font_id.size - 1.0);
                let format = TextFormat { font_id, background: backdrop, ..format.clone() };
                draft.words(ui, &code(pieces), &format, deed);
            }
            Inline::Formula(pieces) => self.inline_formula(ui, &latex(pieces), format, draft),
            Inline::Link(_, line) if draft.is_option => self.inlines(ui, line, format, deed, draft),
            Inline::Link(target, line) => {
                let format = linked(ui, format);
                draft.deeds.push(deed_of(ui, target, line));
                let deed = Some(draft.deeds.len() - 1);
                self.inlines(ui, line, &format, deed, draft);
            }
            Inline::Break => {
                draft.flow.end_line();
                draft.words.push(' ');
            }
        }
    }

    fn inline_formula(&mut self, ui: &Ui, latex: &str, format: &TextFormat, draft: &mut Draft) {
        let em = format.font_id.size * 1.08;
        let Some(set) = self.formulas.formula(ui.ctx(), latex, false, em) else {
            let font_id = FontId::monospace(format.font_id.size - 1.0);
            draft.words(ui, latex, &TextFormat { font_id, ..format.clone() }, None);
            return;
        };
        draft.words.push_str(&set.words);
        draft.flow.piece(Piece::pixels(set.texture.id(), set.size, set.ascent, draft.width));
    }
}

impl Draft {
    fn words(&mut self, ui: &Ui, text: &str, format: &TextFormat, deed: Option<usize>) {
        self.words.push_str(text);
        self.flow.words(ui.ctx(), text, format, deed);
    }

    /// A recorded text: a reason names things between backticks.
    fn recorded(&mut self, ui: &Ui, text: &str, format: &TextFormat, deed: Option<usize>) {
        if text.matches('`').count() % 2 == 1 {
            return self.words(ui, text, format, deed);
        }
        let font_id = FontId::monospace(format.font_id.size - 1.0);
        let code = TextFormat { font_id, ..format.clone() };
        for (place, part) in text.split('`').enumerate() {
            self.words(ui, part, if place % 2 == 1 { &code } else { format }, deed);
        }
    }

    /// A value; one of an event can be clicked.
    fn value(&mut self, ui: &Ui, told: &Told, format: &TextFormat) {
        let event = told.event.filter(|_| !self.is_option);
        let Some(event) = event else { return self.recorded(ui, &told.text, format, None) };
        let about = say_with(ui.ctx(), "lesson-value-about", &[("from", (&told.from).into())]);
        let label =
            say_with(ui.ctx(), "lesson-value", &[("value", (&told.text).into()), ("from", (&told.from).into())]);
        self.deeds.push(Deed { wish: TextWish::Select(event), label, about });
        let colour = Palette::current(ui.ctx()).accent;
        let format = TextFormat { color: colour, ..format.clone() };
        self.recorded(ui, &told.text, &format, Some(self.deeds.len() - 1));
    }
}

fn linked(ui: &Ui, format: &TextFormat) -> TextFormat {
    let colour: Color32 = Palette::current(ui.ctx()).weak;
    TextFormat { underline: Stroke::new(1.0, colour), ..format.clone() }
}

fn deed_of(ui: &Ui, target: &Target, line: &Line<Told>) -> Deed {
    let label = crate::lesson::prose::plain(line);
    match target {
        Target::Term(name) => Deed { wish: TextWish::Term(name.clone()), label, about: name.clone() },
        Target::Lesson(id) => {
            let about = say_with(ui.ctx(), "lesson-link-about", &[("lesson", id.into())]);
            Deed { wish: TextWish::Lesson(id.clone()), label, about }
        }
        Target::Source(file) => {
            let about = format!("{file}\n{}", say(ui.ctx(), "lesson-source-about"));
            Deed { wish: TextWish::Source(file.clone()), label, about }
        }
    }
}
