//! The text of lessons on screen: paragraphs with values that can be clicked, formulas, lists, tables, terms with their meanings.

mod flow;
mod formula;
mod line;

pub use formula::Formulas;

use crate::app::frame::theme::{Palette, bold};
use crate::lesson::prose::{Block, Line, Prose, Told, code, latex};
use crate::record::EventId;
use egui::{FontFamily, FontId, Frame, Grid, Label, Margin, RichText, ScrollArea, Ui};
use std::collections::BTreeMap;

/// The size of running text, in points.
pub const SIZE: f32 = 14.0;

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

    /// A table, which is scrolled where it is wider than the room.
    pub fn table(&mut self, ui: &mut Ui, head: &[Line<Told>], rows: &[Vec<Line<Told>>]) {
        self.count += 1;
        let salt = self.count;
        ScrollArea::horizontal().id_salt(("table", salt)).auto_shrink([false, true]).show(ui, |ui| {
            let grid = Grid::new(("cells", salt)).striped(true).num_columns(head.len()).spacing([14.0, 4.0]);
            grid.show(ui, |ui| {
                for cell in head {
                    self.cell(ui, cell, &FontId::new(SIZE - 1.0, bold()));
                }
                ui.end_row();
                for row in rows {
                    for cell in row {
                        self.cell(ui, cell, &FontId::proportional(SIZE - 1.0));
                    }
                    ui.end_row();
                }
            });
            // Room for the scroll bar, so that it does not lie on the last row.
            ui.add_space(8.0);
        });
    }

    /// A formula on a line of its own, in the middle.
    fn formula(&mut self, ui: &mut Ui, latex: &str) {
        let em = SIZE * 1.15;
        let Some(set) = self.formulas.formula(ui.ctx(), latex, true, em) else {
            ui.vertical_centered(|ui| ui.label(RichText::new(latex).monospace()));
            return;
        };
        let room = ui.available_width();
        let size = set.size * (room / set.size.x.max(1.0)).min(1.0);
        let (rect, _) = ui.allocate_exact_size(egui::vec2(room, size.y + 8.0), egui::Sense::hover());
        self.count += 1;
        let response = ui.interact(rect, ui.scope_id().with(("formula", self.count)), egui::Sense::hover());
        response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Label, true, &set.words));
        let scale = ui.pixels_per_point();
        let corner = (rect.center() - size / 2.0).to_vec2() * scale;
        let place = egui::Rect::from_min_size((corner.round() / scale).to_pos2(), size);
        let unit = egui::Rect::from_min_max(egui::Pos2::ZERO, egui::pos2(1.0, 1.0));
        ui.painter().image(set.texture.id(), place, unit, egui::Color32::WHITE);
    }
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
