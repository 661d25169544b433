//! The list of breakpoints, and the search for the next pixel that stops at one.

use crate::app::frame::theme::Palette;
use crate::app::frame::ticks;
use crate::app::frame::words::{say, say_with};
use crate::app::workbench::Workbench;
use crate::story::Breakpoint;
use egui::{Align, Color32, Key, Label, Layout, RichText, TextEdit, TextStyle, TextWrapMode, Ui, vec2};

/// What was done with the list.
enum Change {
    Switch(usize, bool),
    Remove(usize),
}

/// Shows the field for a new one, the search, and below them the list, which may be long.
pub fn ui(ui: &mut Ui, workbench: &mut Workbench) {
    new(ui, workbench);
    search(ui, workbench);
    let mut change = None;
    for (place, breakpoint) in workbench.stepping.breakpoints.list().iter().enumerate() {
        change = line(ui, place, breakpoint).or(change.take());
    }
    match change {
        Some(Change::Switch(place, on)) => workbench.change_breakpoints(|list, _| list.set_enabled(place, on)),
        Some(Change::Remove(place)) => workbench.change_breakpoints(|list, _| list.remove(place)),
        None => {}
    }
}

fn line(ui: &mut Ui, place: usize, breakpoint: &Breakpoint) -> Option<Change> {
    let question = breakpoint.query.to_string();
    let name = breakpoint.preset.map_or_else(|| question.clone(), |preset| say(ui.ctx(), &preset.word()));
    let mut change = None;
    let height = ui.spacing().interact_size.y;
    // From the right, so that the name has the room that the others leave.
    ui.allocate_ui_with_layout(vec2(ui.available_width(), height), Layout::right_to_left(Align::Center), |ui| {
        let remove = say_with(ui.ctx(), "step-breakpoint-remove", &[("name", (&name).into())]);
        let button = ui.small_button("×");
        button.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, &remove));
        if button.on_hover_text(remove).clicked() {
            change = Some(Change::Remove(place));
        }
        let hits = say_with(ui.ctx(), "step-breakpoint-hits", &[("count", breakpoint.hits.len().into())]);
        ui.add(Label::new(RichText::new(hits).small().weak()).extend());
        ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
            ui.style_mut().wrap_mode = Some(TextWrapMode::Truncate);
            let mut enabled = breakpoint.enabled;
            let tick = ticks::checkbox(ui, &mut enabled, &name).on_hover_text(format!("{name}\n{question}"));
            if tick.changed() {
                change = Some(Change::Switch(place, enabled));
            }
        });
    });
    change
}

fn new(ui: &mut Ui, workbench: &mut Workbench) {
    let mut add = false;
    ui.horizontal(|ui| {
        let stepping = &mut workbench.stepping;
        let label = ui.label(say(ui.ctx(), "step-breakpoint-new"));
        let button = say(ui.ctx(), "step-breakpoint-add");
        let width = (ui.available_width() - beside(ui, &button)).max(60.0);
        let hint = say(ui.ctx(), "step-breakpoint-hint");
        let field = TextEdit::singleline(&mut stepping.question).desired_width(width).hint_text(hint);
        let field = ui.add(field).labelled_by(label.id);
        if std::mem::take(&mut stepping.wants_focus) {
            field.request_focus();
        }
        let entered = field.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
        add = entered | ui.button(button).clicked();
    });
    if add && !workbench.stepping.question.trim().is_empty() {
        let question = workbench.stepping.question.clone();
        let outcome = workbench.change_breakpoints(|list, tree| list.add(&question, tree));
        let stepping = &mut workbench.stepping;
        match outcome {
            Ok(()) => {
                stepping.question.clear();
                stepping.question_problem = None;
            }
            Err(error) => {
                stepping.question_problem = Some(error.to_string());
                stepping.wants_focus = true;
            }
        }
    }
    if let Some(problem) = &workbench.stepping.question_problem {
        ui.label(RichText::new(problem).color(Palette::current(ui.ctx()).problem));
    }
}

/// How much room a button takes beside a field, with the space between them and around the field's text.
fn beside(ui: &Ui, button: &str) -> f32 {
    let font = TextStyle::Button.resolve(ui.style());
    let text = ui.painter().layout_no_wrap(button.to_owned(), font, Color32::WHITE).size().x;
    let spacing = ui.spacing();
    text + 4.0 * spacing.button_padding.x + spacing.item_spacing.x
}

fn search(ui: &mut Ui, workbench: &mut Workbench) {
    let (mut begin, mut cancel) = (false, false);
    ui.horizontal_wrapped(|ui| match workbench.stepping.pixels_searched() {
        None => {
            let button = ui.button(say(ui.ctx(), "step-until"));
            begin = button.on_hover_text(say(ui.ctx(), "step-until-about")).clicked();
        }
        Some(count) => {
            ui.label(say_with(ui.ctx(), "step-until-searching", &[("count", count.into())]));
            cancel = ui.button(say(ui.ctx(), "step-until-cancel")).clicked();
        }
    });
    if begin {
        workbench.record_until();
    }
    if cancel {
        workbench.stepping.cancel_search();
    }
}
