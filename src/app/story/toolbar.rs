//! The toolbar of the story: moves and play with a picture and a word each, and below them how much is told and what is looked for.

use super::icon::{Icon, draw};
use super::stepping::Drawer;
use crate::app::command::{Command, Commands, StepCommand};
use crate::app::dock::Preset;
use crate::app::frame::key_names::key_name;
use crate::app::frame::menu;
use crate::app::frame::theme::Palette;
use crate::app::frame::words::{say, say_with};
use crate::app::story::recording::Recording;
use crate::app::workbench::Workbench;
use crate::story::{Kind, Level, SPEEDS, Step};
use egui::{
    Align2, Button, Color32, Context, FontId, Response, Role, ScrollArea, Sense, Stroke, StrokeKind, Ui, WidgetInfo,
    vec2,
};

/// Height of a button with a picture, in points.
const HEIGHT: f32 = 40.0;
/// Size of the words below the pictures, in points.
const WORD: f32 = 11.0;
/// Gap between buttons, in points.
const GAP: f32 = 3.0;

/// The buttons of the upper line.
const BUTTONS: [StepCommand; 10] = [
    StepCommand::Move(Step::First),
    StepCommand::Move(Step::Back),
    StepCommand::Move(Step::Next),
    StepCommand::Move(Step::Into),
    StepCommand::Move(Step::Over),
    StepCommand::Move(Step::Out),
    StepCommand::Move(Step::Last),
    StepCommand::Play,
    StepCommand::Move(Step::PreviousStop),
    StepCommand::Move(Step::NextStop),
];

/// Shows both lines, or the upper one alone where everything is large, and does what is chosen.
pub fn ui(ui: &mut Ui, workbench: &mut Workbench) {
    let mut chosen = moves(ui, workbench);
    if workbench.dock.preset() == Preset::Present {
        if let Some(command) = chosen {
            workbench.run(Command::Step(command));
        }
        return;
    }
    ui.add_space(2.0);
    let mut kind = None;
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing = vec2(GAP, GAP);
        for level in Level::ALL {
            chosen = toggle(ui, workbench, StepCommand::Level(level), None).or(chosen);
        }
        ui.add_space(6.0);
        for (drawer, command) in [
            (Drawer::Filter, StepCommand::Filter),
            (Drawer::Breakpoints, StepCommand::Breakpoints),
            (Drawer::LeftOut, StepCommand::LeftOut),
        ] {
            chosen = toggle(ui, workbench, command, Some(drawer)).or(chosen);
        }
        kind = kinds(ui, workbench);
        chosen = toggle(ui, workbench, StepCommand::Jump, Some(Drawer::Jump)).or(chosen);
        if let Some(speed) = speeds(ui, workbench) {
            workbench.stepping.player.set_speed(speed);
        }
    });
    if let Some(command) = chosen {
        workbench.run(Command::Step(command));
    }
    if let (Some(kind), Some(recording)) = (kind, &mut workbench.recording) {
        let target =
            recording.story().of_kind(kind, true).or_else(|| recording.story().shown().steps_of(kind).first().copied());
        if let Some(event) = target {
            recording.select(event);
        }
    }
}

/// `step 3 of 9 · event 12 of 148`, counted from 1, and by which method, if not by the scene's own.
#[must_use]
pub fn position(ctx: &Context, recording: Option<&Recording>, is_recording: bool) -> String {
    if is_recording {
        return say(ctx, "step-recording");
    }
    let Some(recording) = recording else { return String::new() };
    let place = recording.story().place();
    let by =
        |method: crate::shape::Method| format!("{} · ", say_with(ctx, "step-by", &[("method", method.name().into())]));
    let (event, events) = (recording.selected() + 1, recording.tree.end());
    let word = if place.is_step { "step-place" } else { "step-place-between" };
    let step = say_with(ctx, word, &[("step", place.step.into()), ("steps", place.steps.into())]);
    let mut text = recording.by.map_or_else(String::new, by) + &step;
    if place.steps != recording.tree.events.len() {
        text += " · ";
        text += &say_with(ctx, "step-event", &[("event", event.into()), ("events", events.into())]);
    }
    text
}

fn moves(ui: &mut Ui, workbench: &Workbench) -> Option<StepCommand> {
    let count = BUTTONS.len() as f32;
    let width = ((ui.available_width() - (count - 1.0) * GAP) / count).clamp(20.0, 64.0);
    let has_words = BUTTONS.into_iter().filter(|&command| is_short(command)).all(|command| {
        let word = say(ui.ctx(), command.word());
        ui.painter().layout_no_wrap(word, FontId::proportional(WORD), Color32::WHITE).size().x <= width - 4.0
    });
    let mut chosen = None;
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = GAP;
        for command in BUTTONS {
            let possible = command.is_possible(workbench);
            let has_word = has_words && is_short(command);
            let response = ui.add_enabled_ui(possible, |ui| button(ui, command, workbench, width, has_word)).inner;
            if response.clicked() {
                chosen = Some(command);
            }
        }
    });
    chosen
}

/// The words of stops are sentences; their pictures stand alone.
const fn is_short(command: StepCommand) -> bool {
    !matches!(command, StepCommand::Move(Step::PreviousStop | Step::NextStop))
}

fn button(ui: &mut Ui, command: StepCommand, workbench: &Workbench, width: f32, has_word: bool) -> Response {
    let (rect, response) = ui.allocate_exact_size(vec2(width, HEIGHT), Sense::click());
    let enabled = ui.is_enabled();
    let is_playing = command == StepCommand::Play && workbench.stepping.is_playing();
    let name = say(ui.ctx(), if is_playing { "step-pause" } else { command.word() });
    response.widget_info(|| WidgetInfo::labeled(Role::Button, enabled, &name));
    let palette = Palette::current(ui.ctx());
    let style = ui.style().interact(&response);
    let painter = ui.painter();
    painter.rect(rect, style.corner_radius, style.weak_bg_fill, style.bg_stroke, StrokeKind::Inside);
    if response.has_focus() {
        painter.rect_stroke(rect.shrink(1.0), 4.0, Stroke::new(1.5, palette.accent), StrokeKind::Inside);
    }
    let icon = match command {
        StepCommand::Move(step) => Icon::Move(step),
        _ if is_playing => Icon::Pause,
        _ => Icon::Play,
    };
    let middle = if has_word { rect.top() + 13.0 } else { rect.center().y };
    draw(painter, icon, egui::pos2(rect.center().x, middle), palette.accent);
    if has_word {
        let place = egui::pos2(rect.center().x, rect.bottom() - 10.0);
        painter.text(place, Align2::CENTER_CENTER, &name, FontId::proportional(WORD), palette.text);
    }
    let tip = |ui: &mut Ui| {
        ui.label(tip(ui.ctx(), command, &name));
    };
    response.on_hover_ui(tip).on_disabled_hover_ui(tip)
}

fn tip(ctx: &Context, command: StepCommand, name: &str) -> String {
    let key = command.key().map_or_else(String::new, |key| format!(" ({})", key_name(ctx, key)));
    format!("{name}{key}\n{}", say(ctx, &format!("{}-about", command.word())))
}

/// A button that is switched on and off; a drawer's says how much is in it.
fn toggle(ui: &mut Ui, workbench: &Workbench, command: StepCommand, drawer: Option<Drawer>) -> Option<StepCommand> {
    let name = say(ui.ctx(), command.word());
    let is_on = match drawer {
        Some(drawer) => workbench.stepping.drawer == Some(drawer),
        None => command.is_on(workbench) == Some(true),
    };
    let text = match drawer.map_or(0, |drawer| amount(workbench, drawer)) {
        0 => name.clone(),
        amount => format!("{name} {amount}"),
    };
    let response = ui.add_enabled(command.is_possible(workbench), Button::new(text).selected(is_on));
    let enabled = response.enabled();
    response.widget_info(|| WidgetInfo::selected(Role::Button, enabled, is_on, &name));
    let response = response.on_hover_ui(|ui| {
        ui.label(tip(ui.ctx(), command, &name));
    });
    response.clicked().then_some(command)
}

/// How much a drawer holds that has an effect.
fn amount(workbench: &Workbench, drawer: Drawer) -> usize {
    let story = workbench.recording.as_ref().map(Recording::story);
    match drawer {
        Drawer::Filter if !workbench.stepping.filter.is_empty() => story.map_or(0, |story| story.shown().steps().len()),
        Drawer::Breakpoints => story.map_or(0, |story| story.stops().len()),
        Drawer::LeftOut => story.map_or(0, |story| story.index().skips(0, story.index().len()) as usize),
        Drawer::Filter | Drawer::Jump => 0,
    }
}

/// The menu of kinds that there are at this level; returns the one that was chosen.
fn kinds(ui: &mut Ui, workbench: &Workbench) -> Option<Kind> {
    let story = workbench.recording.as_ref()?.story();
    let mut chosen = None;
    let menu = ui.menu_button(say(ui.ctx(), "step-kind"), |ui| {
        ui.style_mut().wrap_mode = Some(egui::TextWrapMode::Extend);
        let height = menu::height(ui.ctx());
        ScrollArea::vertical().max_height(height).min_scrolled_height(height).show(ui, |ui| {
            for &kind in Kind::ALL {
                let count = story.shown().steps_of(kind).len();
                if count > 0 && ui.button(format!("{} · {count}", kind.name())).clicked() {
                    chosen = Some(kind);
                    ui.close();
                }
            }
        });
    });
    menu.response.on_hover_ui(|ui| {
        ui.label(say(ui.ctx(), "step-kind-about"));
    });
    chosen
}

fn speeds(ui: &mut Ui, workbench: &Workbench) -> Option<f64> {
    let current = workbench.stepping.player.speed();
    let name = |ctx: &Context, speed: f64| {
        say_with(ctx, "step-speed", &[("speed", (&speed.to_string().replace('.', &say(ctx, "decimal-sign"))).into())])
    };
    let mut chosen = None;
    let menu = ui.menu_button(name(ui.ctx(), current), |ui| {
        for speed in SPEEDS {
            if ui.selectable_label(speed == current, name(ui.ctx(), speed)).clicked() {
                chosen = Some(speed);
                ui.close();
            }
        }
    });
    menu.response.on_hover_ui(|ui| {
        ui.label(say(ui.ctx(), "step-speed-about"));
    });
    chosen
}
