//! What is looked for among the events: by ray, object, kind and words.

use crate::app::frame::menu;
use crate::app::frame::ticks;
use crate::app::frame::words::{say, say_with};
use crate::app::workbench::Workbench;
use crate::story::{Filter, Kind, Story};
use egui::{ScrollArea, TextEdit, TextWrapMode, Ui};
use std::collections::BTreeSet;

/// Shows the conditions, and looks for what they say.
pub fn ui(ui: &mut Ui, workbench: &mut Workbench) {
    let mut filter = workbench.stepping.filter.clone();
    let wants_focus = std::mem::take(&mut workbench.stepping.wants_focus);
    let mut clear = false;
    ui.horizontal_wrapped(|ui| {
        let label = ui.label(say(ui.ctx(), "step-filter-text"));
        let hint = say(ui.ctx(), "step-filter-hint");
        let field = TextEdit::singleline(&mut filter.text).desired_width(150.0).hint_text(hint);
        let field = ui.add(field).labelled_by(label.id);
        if wants_focus {
            field.request_focus();
        }
        if let Some(recording) = &workbench.recording {
            conditions(ui, recording.story(), &mut filter);
        }
        clear = ui.add_enabled(!filter.is_empty(), egui::Button::new(say(ui.ctx(), "step-filter-clear"))).clicked();
    });
    if clear {
        filter = Filter::default();
    }
    if filter != workbench.stepping.filter {
        workbench.set_filter(filter);
    }
    outcome(ui, workbench);
}

fn conditions(ui: &mut Ui, story: &Story, filter: &mut Filter) {
    let index = story.index();
    let rays = index.ray_kinds().map(|kind| (kind.name().to_owned(), kind));
    tick_menu(ui, "step-filter-rays", rays, &mut filter.rays);
    let objects = index.objects().map(|name| (name.to_owned(), name.to_owned()));
    tick_menu(ui, "step-filter-objects", objects, &mut filter.objects);
    let present = |kind: &&Kind| index.has(**kind);
    let kinds = Kind::ALL.iter().filter(present).map(|&kind| (kind.name().to_owned(), kind));
    tick_menu(ui, "step-filter-kinds", kinds, &mut filter.kinds);
}

/// A menu of things to tick. Its button says how many are ticked.
fn tick_menu<T: Ord + Clone>(
    ui: &mut Ui,
    word: &str,
    offered: impl Iterator<Item = (String, T)>,
    ticked: &mut BTreeSet<T>,
) {
    let name = say(ui.ctx(), word);
    let title = if ticked.is_empty() { name } else { format!("{name} {}", ticked.len()) };
    ui.menu_button(title, |ui| {
        ui.style_mut().wrap_mode = Some(TextWrapMode::Extend);
        let height = menu::height(ui.ctx());
        ScrollArea::vertical().max_height(height).min_scrolled_height(height).show(ui, |ui| {
            for (name, value) in offered {
                let mut is_on = ticked.contains(&value);
                if ticks::checkbox(ui, &mut is_on, name).changed() {
                    if is_on {
                        ticked.insert(value);
                    } else {
                        ticked.remove(&value);
                    }
                }
            }
        });
    });
}

/// What was found, and what is hidden.
fn outcome(ui: &mut Ui, workbench: &Workbench) {
    let Some(recording) = &workbench.recording else { return };
    if workbench.stepping.filter.is_empty() {
        return;
    }
    if recording.story().filter() != &workbench.stepping.filter {
        ui.label(say(ui.ctx(), "step-filter-working"));
        return;
    }
    let shown = recording.story().shown();
    let said = |word: &str, count: usize| say_with(ui.ctx(), word, &[("count", count.into())]);
    let mut parts =
        vec![said("step-filter-found", shown.steps().len()), said("step-filter-hidden", shown.hidden_by_filter())];
    if shown.found_deeper() > 0 {
        parts.push(said("step-filter-deeper", shown.found_deeper()));
    }
    ui.label(parts.join(" · "));
}
