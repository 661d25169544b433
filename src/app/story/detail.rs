//! The selected event in full: what it is, its formulas with this ray's numbers, its tables, and the line of source.

use crate::app::frame::empty::empty;
use crate::app::frame::theme::{PADDING, Palette};
use crate::app::frame::words::{say, say_with};
use crate::app::story::recording::Recording;
use crate::view::{DetailLine, detail};
use egui::style::ScrollStyle;
use egui::{Frame, Grid, Label, Margin, RichText, ScrollArea, TextStyle, Ui};

/// Shows the selected event.
pub fn ui(ui: &mut Ui, recording: Option<&Recording>) {
    let Some(recording) = recording else {
        empty(ui, &say(ui.ctx(), "detail-none"));
        return;
    };
    let detail = detail(recording.tree.event(recording.selected()));
    let salt = ("detail", recording.pixel, recording.selected());
    ScrollArea::vertical().id_salt(salt).auto_shrink(false).show(ui, |ui| {
        Frame::new().inner_margin(Margin::same(PADDING)).show(ui, |ui| {
            ui.set_width(ui.available_width());
            ui.add(Label::new(RichText::new(&detail.title).heading()).wrap());
            ui.add(Label::new(RichText::new(detail.explanation).weak()).wrap());
            ui.add_space(4.0);
            lines(ui, &detail.lines);
            ui.add_space(6.0);
            let palette = Palette::current(ui.ctx());
            let source = RichText::new(say_with(ui.ctx(), "detail-source", &[("source", (&detail.source).into())]))
                .small()
                .color(palette.weak);
            ui.add(Label::new(source).wrap());
        });
    });
}

/// Neighbouring pairs share a grid, so that their values line up.
fn lines(ui: &mut Ui, lines: &[DetailLine]) {
    let is_pair = |line: &DetailLine| matches!(line, DetailLine::Pair { .. });
    for (i, group) in lines.chunk_by(|a, b| is_pair(a) && is_pair(b)).enumerate() {
        match &group[0] {
            DetailLine::Pair { .. } => pairs(ui, group),
            DetailLine::Working { symbol, formula, numbers, result } => working(ui, symbol, formula, numbers, result),
            DetailLine::Table { title, headers, rows } => table(ui, i, title, headers, rows),
        }
    }
}

fn pairs(ui: &mut Ui, group: &[DetailLine]) {
    let palette = Palette::current(ui.ctx());
    let pairs = || {
        group.iter().filter_map(|line| match line {
            DetailLine::Pair { name, value } => Some((name, value)),
            _ => None,
        })
    };
    let font = TextStyle::Body.resolve(ui.style());
    let width = |name: &String| ui.painter().layout_no_wrap(name.clone(), font.clone(), palette.weak).size().x;
    let column = pairs().map(|(name, _)| width(name)).fold(0.0, f32::max).min(0.45 * ui.available_width()).ceil();
    ui.spacing_mut().interact_size.y = 0.0;
    for (name, value) in pairs() {
        ui.horizontal_top(|ui| {
            ui.spacing_mut().item_spacing.x = 14.0;
            ui.scope(|ui| {
                ui.set_width(column);
                ui.add(Label::new(RichText::new(name).color(palette.weak)).wrap());
            });
            ui.add(Label::new(RichText::new(value).color(palette.text)).wrap());
        });
    }
}

/// `symbol = formula`, below it the numbers put in, below it the result: as a student would write it.
fn working(ui: &mut Ui, symbol: &str, formula: &str, numbers: &str, result: &str) {
    let palette = Palette::current(ui.ctx());
    Frame::new().fill(palette.backdrop).corner_radius(5).inner_margin(Margin::symmetric(10, 6)).show(ui, |ui| {
        ui.set_width(ui.available_width());
        ui.spacing_mut().item_spacing.y = 3.0;
        let mono = |text: String| RichText::new(text).monospace();
        ui.add(Label::new(mono(format!("{symbol} = {formula}")).color(palette.text)).wrap());
        if numbers != formula && numbers != result {
            ui.add(Label::new(mono(format!("  = {numbers}")).color(palette.text)).wrap());
        }
        ui.add(Label::new(mono(format!("  = {result}")).color(palette.accent).strong()).wrap());
    });
}

fn table(ui: &mut Ui, salt: usize, title: &str, headers: &[&str], rows: &[Vec<String>]) {
    let palette = Palette::current(ui.ctx());
    ui.add(Label::new(RichText::new(title).strong()).wrap());
    // The bar has a place of its own, so that it does not lie on the last row.
    let bar = ScrollStyle { floating: false, bar_width: 5.0, bar_inner_margin: 3.0, ..ui.spacing().scroll };
    let before = std::mem::replace(&mut ui.spacing_mut().scroll, bar);
    ScrollArea::horizontal().id_salt(("table", salt)).auto_shrink([false, true]).show(ui, |ui| {
        Grid::new(("cells", salt)).striped(true).num_columns(headers.len()).spacing([12.0, 4.0]).show(ui, |ui| {
            for header in headers {
                ui.label(RichText::new(*header).size(12.0).color(palette.weak));
            }
            ui.end_row();
            for cell in rows.iter().flat_map(|row| row.iter().map(Some).chain([None])) {
                match cell {
                    Some(text) => {
                        ui.add(Label::new(RichText::new(text).size(12.5)).extend());
                    }
                    None => ui.end_row(),
                }
            }
        });
    });
    ui.spacing_mut().scroll = before;
}
