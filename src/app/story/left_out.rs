//! What was skipped, cut off or rejected, each with its name and its reason.

use crate::app::frame::code::with_code;
use crate::app::frame::words::{say, say_with};
use crate::app::workbench::Workbench;
use crate::record::{Effect, EventId};
use crate::story::{Cut, Story, skips};
use egui::text::TextWrapping;
use egui::{Response, Role, ScrollArea, Sense, StrokeKind, TextStyle, Ui, WidgetInfo, pos2, vec2};

/// What stands above the list, in points.
const ABOVE: f32 = 44.0;

/// No list is lower than this, in points.
const LOWEST: f32 = 90.0;

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
    // What, and below it why: beside each other, one of them would be cut off in most panels.
    let height = 2.0 * ui.text_style_height(&egui::TextStyle::Body) + 4.0;
    let mut clicked = None;
    ScrollArea::vertical()
        .id_salt(("left out", cut.name()))
        .max_height((most - ABOVE).max(LOWEST))
        .auto_shrink([false, true])
        .show_rows(ui, height, events.len(), |ui, range| {
            for &event in &events[range] {
                let told = skips(story.tree().event(event));
                let what = told.iter().map(|skip| skip.what.as_str()).collect::<Vec<_>>().join("; ");
                let why = told.iter().map(|skip| skip.reason.as_str()).collect::<Vec<_>>().join("; ");
                if row(ui, height, &what, &why, story.selected() == event).clicked() {
                    clicked = Some(event);
                }
            }
        });
    clicked
}

/// What was left out, and below it why, each in one line.
fn row(ui: &mut Ui, height: f32, what: &str, why: &str, is_selected: bool) -> Response {
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::click());
    let told = format!("{what}: {why}");
    response.widget_info(|| WidgetInfo::selected(Role::Button, true, is_selected, &told));
    let look = ui.style().interact_selectable(&response, is_selected);
    if is_selected || response.hovered() || response.has_focus() {
        ui.painter().rect(rect, look.corner_radius, look.weak_bg_fill, look.bg_stroke, StrokeKind::Inside);
    }
    let size = TextStyle::Body.resolve(ui.style()).size;
    let inside = rect.shrink2(vec2(ui.spacing().button_padding.x, 2.0));
    let lines = [(what, ui.visuals().text_color()), (why, ui.visuals().weak_text_color())];
    for (line, (text, colour)) in lines.into_iter().enumerate() {
        let mut job = with_code(text, size, colour);
        job.wrap = TextWrapping::truncate_at_width(inside.width());
        let galley = ui.painter().layout_job(job);
        let top = inside.top() + 0.5 * inside.height() * line as f32;
        ui.painter().galley(pos2(inside.left(), top), galley, colour);
    }
    response.on_hover_text(told)
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
