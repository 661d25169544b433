//! What was skipped, cut off or rejected, each with its name and its reason.

use crate::app::frame::words::{say, say_with};
use crate::app::workbench::Workbench;
use crate::record::{Effect, EventId};
use crate::story::{Cut, Story, skips};
use egui::{RichText, ScrollArea, Ui};

/// Height above which the list scrolls, in points.
const HEIGHT: f32 = 170.0;

/// Shows the list, no higher than this; what is clicked is selected.
pub fn ui(ui: &mut Ui, workbench: &mut Workbench, height: f32) {
    if let Some(open) = &workbench.open {
        let off = |effect: &Effect| open.whole.effects.has(*effect) && !open.scene.effects.has(*effect);
        let names: Vec<&str> = Effect::ALL.into_iter().filter(off).map(Effect::name).collect();
        if !names.is_empty() {
            ui.label(say_with(ui.ctx(), "step-left-out-effects", &[("effects", (&names.join(", ")).into())]));
        }
    }
    let Some(recording) = &workbench.recording else { return };
    let story = recording.story();
    let mut cut = workbench.stepping.cut;
    let all = Cut::ALL.map(|cut| (cut, story.index().cut_events(cut).len()));
    if all.iter().all(|(_, count)| *count == 0) {
        ui.label(say(ui.ctx(), "step-left-out-nothing"));
        return;
    }
    // The first kind that there is stands for none chosen.
    let first = all.into_iter().find(|(_, count)| *count > 0).map(|(one, _)| one);
    let chosen = cut.filter(|one| !story.index().cut_events(*one).is_empty()).or(first);
    ui.horizontal_wrapped(|ui| {
        for (one, count) in all.into_iter().filter(|(_, count)| *count > 0) {
            let name = say_with(ui.ctx(), word(one), &[("count", count.into())]);
            if ui.selectable_label(chosen == Some(one), name).clicked() {
                cut = Some(one);
            }
        }
    });
    workbench.stepping.cut = cut;
    let clicked = chosen.and_then(|one| list(ui, story, one, height));
    if let (Some(event), Some(recording)) = (clicked, &mut workbench.recording) {
        recording.select(event);
    }
}

/// The events of one kind, laid out only where they are seen.
fn list(ui: &mut Ui, story: &Story, cut: Cut, most: f32) -> Option<EventId> {
    let events = story.index().cut_events(cut);
    let height = ui.text_style_height(&egui::TextStyle::Body) + 4.0;
    let mut clicked = None;
    ScrollArea::vertical()
        .id_salt(("left out", cut.name()))
        .max_height(HEIGHT.min(most))
        .auto_shrink([false, true])
        .show_rows(ui, height, events.len(), |ui, range| {
            for &event in &events[range] {
                let told: Vec<String> = skips(story.tree().event(event))
                    .iter()
                    .map(|skip| format!("{}: {}", skip.what, skip.reason))
                    .collect();
                let told = told.join("; ");
                let label = egui::Button::selectable(story.selected() == event, RichText::new(&told)).truncate();
                if ui.add(label).on_hover_text(&told).clicked() {
                    clicked = Some(event);
                }
            }
        });
    clicked
}

const fn word(cut: Cut) -> &'static str {
    match cut {
        Cut::Missed => "step-cut-missed",
        Cut::Early => "step-cut-early-out",
        Cut::Rejected => "step-cut-rejected",
        Cut::Limited => "step-cut-limited",
        Cut::Undecidable => "step-cut-undecidable",
        Cut::Passed => "step-cut-passed",
    }
}
