//! Questions that have to be answered first: what becomes of unsaved changes, and of an edit that a crash left behind.

use crate::app::edit::recovery::{Offer, minutes_since};
use crate::app::frame::theme::{Palette, bold};
use crate::app::frame::words::{say, say_with};
use crate::document::{Line, Template, compare_lines, with_context};
use crate::share::link::Link;
use egui::{Color32, Context, Id, Modal, RichText, Role, ScrollArea, Ui, WidgetInfo};

/// What is to be done once unsaved changes are settled.
#[derive(Clone, Debug, PartialEq)]
pub enum Then {
    /// Opens a scene by name, or a file.
    Open(String),
    /// Opens a text under a name.
    OpenText(String, String),
    /// Restores what a link says.
    Follow(Box<Link>),
    /// Sets the scene of a lesson's step.
    Lesson,
    /// Begins a new scene.
    New(Template),
    /// Closes the window.
    Close,
}

/// A question about unsaved changes.
#[derive(Clone, Debug, PartialEq)]
pub struct Guard {
    /// What was asked for.
    pub then: Then,
}

/// What to do with unsaved changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Answer {
    /// Save them, then go on.
    Save,
    /// Go on without them.
    Discard,
    /// Stay.
    Cancel,
}

/// What to do with an edit that was left behind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Choice {
    /// Take it up.
    Recover,
    /// Throw it away.
    Discard,
    /// Ask again at the next start.
    Later,
}

/// Asks what to do with unsaved changes of `name`.
pub fn guard(ctx: &Context, name: &str) -> Option<Answer> {
    let title = say_with(ctx, "edit-guard", &[("name", name.into())]);
    let answers = [
        (Answer::Save, "edit-guard-save"),
        (Answer::Discard, "edit-guard-discard"),
        (Answer::Cancel, "edit-guard-cancel"),
    ];
    let (answer, escaped) = question(ctx, "guard", &title, &answers, |ui| {
        ui.label(say(ui.ctx(), "edit-guard-about"));
    });
    answer.or(escaped.then_some(Answer::Cancel))
}

/// Offers an edit back that was left behind.
pub fn offer(ctx: &Context, offer: &Offer) -> Option<Choice> {
    let ago = say_with(ctx, "edit-ago", &[("minutes", minutes_since(offer.state.when).into())]);
    let title = say_with(ctx, "edit-recover", &[("name", offer.state.name.as_str().into()), ("time", (&ago).into())]);
    let answers = [
        (Choice::Recover, "edit-recover-yes"),
        (Choice::Discard, "edit-recover-no"),
        (Choice::Later, "edit-recover-later"),
    ];
    let (answer, escaped) = question(ctx, "offer", &title, &answers, |ui| {
        ui.label(say(ui.ctx(), "edit-recover-about"));
        ui.add_space(4.0);
        differences(ui, &offer.state.saved, &offer.state.text);
    });
    answer.or(escaped.then_some(Choice::Later))
}

/// Shows a question over everything else; returns the answer, and whether it was closed without one.
fn question<A: Copy>(
    ctx: &Context,
    id: &str,
    title: &str,
    answers: &[(A, &str)],
    contents: impl FnOnce(&mut Ui),
) -> (Option<A>, bool) {
    let shown = Modal::new(Id::unique(id)).show(ctx, |ui| {
        ui.set_max_width(560.0);
        let heading = ui.label(RichText::new(title).size(15.0).family(bold()));
        heading.widget_info(|| WidgetInfo::labeled(Role::Heading, true, title));
        ui.add_space(6.0);
        contents(ui);
        ui.add_space(10.0);
        let mut answer = None;
        ui.horizontal(|ui| {
            for (i, (value, word)) in answers.iter().enumerate() {
                let button = ui.button(say(ui.ctx(), word));
                if i == 0 && ui.memory(|memory| memory.focused().is_none()) {
                    button.request_focus();
                }
                if button.clicked() {
                    answer = Some(*value);
                }
            }
        });
        answer
    });
    let escaped = shown.should_close();
    (shown.inner, escaped)
}

/// The lines that differ, each with a sign before it.
fn differences(ui: &mut Ui, before: &str, after: &str) {
    let palette = Palette::current(ui.ctx());
    let all = compare_lines(before, after);
    let lines = with_context(&all, 2);
    ScrollArea::both().max_height(260.0).auto_shrink([false, true]).show(ui, |ui| {
        ui.spacing_mut().item_spacing.y = 1.0;
        for line in lines {
            let (text, colour): (String, Color32) = match line {
                Line::Same(text) => (format!("  {text}"), palette.weak),
                Line::Removed(text) => (format!("− {text}"), palette.problem),
                Line::Added(text) => (format!("+ {text}"), palette.accent),
                Line::Skipped(count) => {
                    (say_with(ui.ctx(), "edit-lines-same", &[("count", count.into())]), palette.weak)
                }
            };
            ui.add(egui::Label::new(RichText::new(text).monospace().color(colour)).extend());
        }
    });
}
