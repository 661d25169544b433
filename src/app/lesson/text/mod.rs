//! The text of lessons on screen: paragraphs with values that can be clicked, formulas, lists, tables, terms with their meanings.

mod columns;
mod flow;
mod formula;
mod line;

pub use formula::Formulas;

use crate::app::frame::theme::{Palette, bold};
use crate::lesson::prose::{Block, Line, Prose, Told, code, latex};
use crate::record::EventId;
use egui::style::ScrollStyle;
use egui::{AsIdSalt, FontFamily, FontId, Frame, Grid, Label, Margin, RichText, ScrollArea, Ui};
use flow::LEAST_SHARE;
use formula::SetFormula;
use std::collections::BTreeMap;

/// The size of running text, in points.
pub const SIZE: f32 = 14.0;

/// Room between two columns of a table, in points.
const CELL_GAP: f32 = 14.0;

/// What a click in a text asks for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum TextWish {
    /// The event that a value is a value of.
    Select(EventId),
    /// The meaning of a term.
    Term(String),
    /// Another lesson.
    Lesson(String),
    /// The name of a source file, to be copied.
    Source(String),
}

/// Shows texts one after the other, and keeps what was asked for in them.
pub struct Reader<'a> {
    formulas: &'a mut Formulas,
    terms: &'a BTreeMap<String, Prose<Told>>,
    selected: Option<EventId>,
    /// What was clicked.
    pub wish: Option<TextWish>,
    /// How many paragraphs there were, to tell them apart.
    count: usize,
}

impl<'a> Reader<'a> {
    /// A reader who knows these terms; values of the selected event are marked.
    pub fn new(
        formulas: &'a mut Formulas,
        terms: &'a BTreeMap<String, Prose<Told>>,
        selected: Option<EventId>,
    ) -> Self {
        Self { formulas, terms, selected, wish: None, count: 0 }
    }

    /// Shows a text.
    pub fn prose(&mut self, ui: &mut Ui, prose: &Prose<Told>) {
        for block in prose {
            self.block(ui, block);
        }
    }

    fn block(&mut self, ui: &mut Ui, block: &Block<Told>) {
        match block {
            Block::Paragraph(line) => self.line(ui, line, &running()),
            Block::Heading(line) => {
                ui.add_space(4.0);
                self.line(ui, line, &FontId::new(SIZE + 1.0, bold()));
            }
            Block::List { numbered, items } => self.list(ui, *numbered, items),
            Block::Quote(blocks) => {
                let edge = Palette::current(ui.ctx()).edge;
                barred(ui, edge, |ui| self.prose(ui, blocks));
            }
            Block::Code(pieces) => {
                let backdrop = Palette::current(ui.ctx()).backdrop;
                let text = code(pieces);
                self.count += 1;
                Frame::new().fill(backdrop).corner_radius(5).inner_margin(Margin::symmetric(10, 6)).show(ui, |ui| {
                    ScrollArea::horizontal().id_salt(("code", self.count)).show(ui, |ui| {
                        ui.add(Label::new(RichText::new(text.trim_end()).monospace()).extend());
                    });
                });
            }
            Block::Formula(pieces) => self.formula(ui, latex(pieces).trim()),
            Block::Table { head, rows } => self.table(ui, head, rows),
        }
    }

    fn list(&mut self, ui: &mut Ui, numbered: bool, items: &[Prose<Told>]) {
        for (place, item) in items.iter().enumerate() {
            let sign = if numbered { format!("{}.", place + 1) } else { "•".to_owned() };
            ui.horizontal_top(|ui| {
                ui.add_space(6.0);
                ui.label(RichText::new(sign).size(SIZE));
                ui.vertical(|ui| self.prose(ui, item));
            });
        }
    }

    /// A table, whose cells are broken where it is wider than the room; what even so is too wide is scrolled.
    pub fn table(&mut self, ui: &mut Ui, head: &[Line<Told>], rows: &[Vec<Line<Told>>]) {
        self.count += 1;
        let salt = self.count;
        let [head_font, font] = [FontId::new(SIZE - 1.0, bold()), FontId::proportional(SIZE - 1.0)];
        let mut columns = vec![[0.0_f32; 2]; head.len()];
        let heads = head.iter().zip(0..).map(|(cell, place)| (cell, place, &head_font));
        let cells = rows.iter().flat_map(|row| row.iter().zip(0..)).map(|(cell, place)| (cell, place, &font));
        for (cell, place, font) in heads.chain(cells) {
            let [whole, least] = self.widths(ui, cell, font);
            if let Some(column) = columns.get_mut(place) {
                *column = [column[0].max(whole), column[1].max(least)];
            }
        }
        let room = ui.available_width() - CELL_GAP * head.len().saturating_sub(1) as f32;
        let widths = columns::widths(&columns, room);
        let is_wide = widths.iter().sum::<f32>() > room + 1.0;
        let grid = Grid::new(("cells", salt)).striped(true).num_columns(head.len()).spacing([CELL_GAP, 4.0]);
        let show = |ui: &mut Ui| {
            grid.show(ui, |ui| {
                for (row, font) in [(head, &head_font)].into_iter().chain(rows.iter().map(|row| (&row[..], &font))) {
                    for (cell, &width) in row.iter().zip(&widths) {
                        self.cell(ui, cell, font, width + 0.5);
                    }
                    ui.end_row();
                }
            });
        };
        if is_wide {
            strip(ui, ("table", salt), show);
        } else {
            show(ui);
        }
    }

    /// A formula on a line of its own, in the middle.
    fn formula(&mut self, ui: &mut Ui, latex: &str) {
        let em = SIZE * 1.15;
        let Some(set) = self.formulas.formula(ui.ctx(), latex, true, em) else {
            ui.vertical_centered(|ui| ui.label(RichText::new(latex).monospace()));
            return;
        };
        let room = ui.available_width();
        let size = set.size * (room / set.size.x.max(1.0)).clamp(LEAST_SHARE, 1.0);
        self.count += 1;
        if size.x > room + 1.0 {
            strip(ui, ("wide formula", self.count), |ui| self.set_formula(ui, &set, size, size.x));
        } else {
            self.set_formula(ui, &set, size, room);
        }
    }

    fn set_formula(&self, ui: &mut Ui, set: &SetFormula, size: egui::Vec2, width: f32) {
        let (rect, _) = ui.allocate_exact_size(egui::vec2(width, size.y + 8.0), egui::Sense::hover());
        let response = ui.interact(rect, ui.scope_id().with(("formula", self.count)), egui::Sense::hover());
        response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Label, true, &set.words));
        let scale = ui.pixels_per_point();
        let corner = (rect.center() - size / 2.0).to_vec2() * scale;
        let place = egui::Rect::from_min_size((corner.round() / scale).to_pos2(), size);
        let unit = egui::Rect::from_min_max(egui::Pos2::ZERO, egui::pos2(1.0, 1.0));
        ui.painter().image(set.texture.id(), place, unit, egui::Color32::WHITE);
    }
}

/// Something that is scrolled sideways, with a bar that is always seen: nothing else tells that it goes on.
fn strip<T>(ui: &mut Ui, salt: impl AsIdSalt, contents: impl FnOnce(&mut Ui) -> T) -> T {
    ui.scope(|ui| {
        ui.spacing_mut().scroll = ScrollStyle::solid();
        let area = ScrollArea::horizontal().id_salt(salt).auto_shrink([false, true]);
        area.show(ui, contents).inner
    })
    .inner
}

/// The font of running text.
pub fn running() -> FontId {
    FontId::new(SIZE, FontFamily::Proportional)
}

/// Something set apart by a bar at its left.
pub fn barred<T>(ui: &mut Ui, colour: egui::Color32, contents: impl FnOnce(&mut Ui) -> T) -> T {
    let frame = Frame::new().inner_margin(Margin { left: 12, right: 0, top: 2, bottom: 2 });
    let shown = frame.show(ui, |ui| {
        ui.set_width(ui.available_width());
        contents(ui)
    });
    let rect = shown.response.rect;
    ui.painter().vline(rect.left() + 3.0, rect.y_range(), egui::Stroke::new(3.0, colour));
    shown.inner
}
