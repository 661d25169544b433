//! The palette of commands: type a few letters, choose by arrow keys and Enter. Scenes are in it too.

use super::Outcome;
use super::matching::score;
use crate::app::command::Command;
use crate::app::frame::key_names::key_name;
use crate::app::frame::theme;
use crate::app::frame::words::{say, say_with};
use crate::app::workbench::Workbench;
use crate::scene::embedded_scenes;
use egui::{Align, Button, Frame, Id, Key, Margin, Modal, RichText, ScrollArea, TextEdit, Ui};

/// Width of the palette, in points.
const WIDTH: f32 = 520.0;
/// Height of its list, in points.
const HEIGHT: f32 = 380.0;

/// What was typed, and which line is chosen.
#[derive(Default)]
pub struct Palette {
    typed: String,
    chosen: usize,
}

/// A line of the list.
struct Line {
    title: String,
    about: String,
    key: String,
    is_possible: bool,
    outcome: Outcome,
}

impl Palette {
    /// Shows the palette.
    pub fn ui(&mut self, ui: &Ui, workbench: &Workbench) -> Outcome {
        let mut lines = self.lines(ui, workbench);
        let mut taken = None;
        let modal = Modal::new(Id::unique("command palette")).show(ui.ctx(), |ui| {
            ui.set_width(WIDTH.min(ui.ctx().content_rect().width() - 60.0));
            self.field(ui);
            taken = self.keys(ui, lines.len());
            ui.add_space(4.0);
            // Without the least height it would stay as low as it was with the fewest lines.
            let scroll = ScrollArea::vertical().max_height(HEIGHT).min_scrolled_height(HEIGHT);
            scroll.auto_shrink([false, true]).show(ui, |ui| {
                for (place, line) in lines.iter().enumerate() {
                    if show(ui, line, place == self.chosen) {
                        taken = Some(place);
                    }
                }
                if lines.is_empty() {
                    ui.label(RichText::new(say(ui.ctx(), "palette-nothing")).weak());
                }
            });
        });
        match taken {
            Some(place) if lines.get(place).is_some_and(|line| line.is_possible) => lines.swap_remove(place).outcome,
            _ if modal.should_close() => Outcome::Close,
            _ => Outcome::Stay,
        }
    }

    fn field(&mut self, ui: &mut Ui) {
        let title = say(ui.ctx(), "palette-title");
        let field = TextEdit::singleline(&mut self.typed).hint_text(&title).desired_width(f32::INFINITY);
        let response = ui.add(field);
        response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::TextInput, true, &title));
        if response.changed() {
            self.chosen = 0;
        }
        response.request_focus();
    }

    /// Moves the choice; returns the line that Enter takes.
    fn keys(&mut self, ui: &Ui, count: usize) -> Option<usize> {
        let last = count.saturating_sub(1);
        ui.input(|input| {
            let presses = |key| input.num_presses(key);
            self.chosen = (self.chosen + presses(Key::ArrowDown)).saturating_sub(presses(Key::ArrowUp)).min(last);
            input.key_pressed(Key::Enter).then_some(self.chosen)
        })
    }

    /// What goes with what was typed, the best first.
    fn lines(&self, ui: &Ui, workbench: &Workbench) -> Vec<Line> {
        let ctx = ui.ctx();
        let commands = Command::areas().into_iter().flat_map(|(menu, commands)| {
            let menu = say(ctx, menu);
            commands.into_iter().map(move |command| of_command(ctx, workbench, &menu, command))
        });
        let scenes = embedded_scenes().into_iter().map(|scene| Line {
            title: say_with(ctx, "palette-scene", &[("name", (&scene.name).into())]),
            about: String::new(),
            key: String::new(),
            is_possible: true,
            outcome: Outcome::Open(scene.name),
        });
        let course = workbench.lesson().lessons().map(|lessons| &lessons.course);
        let lessons = course.into_iter().flat_map(|course| &course.lessons).map(|lesson| Line {
            title: say_with(ctx, "palette-lesson", &[("title", (&lesson.header.title).into())]),
            about: lesson.header.idea.clone(),
            key: String::new(),
            is_possible: true,
            outcome: Outcome::Lesson(lesson.id.clone()),
        });
        let mut lines: Vec<(i32, Line)> = commands
            .chain(scenes)
            .chain(lessons)
            .filter_map(|line| Some((score(&self.typed, &line.title)?, line)))
            .collect();
        if !self.typed.is_empty() {
            // What cannot be done now comes after what can, however well it goes with the letters.
            lines.sort_by_key(|(score, line)| (!line.is_possible, std::cmp::Reverse(*score)));
        }
        lines.into_iter().map(|(_, line)| line).collect()
    }
}

fn of_command(ctx: &egui::Context, workbench: &Workbench, menu: &str, command: Command) -> Line {
    Line {
        title: format!(
            "{}: {}",
            command.group().map_or_else(|| menu.to_owned(), |group| say(ctx, group)),
            say(ctx, command.word())
        ),
        about: say(ctx, &format!("{}-about", command.word())),
        key: command.key().map_or_else(String::new, |key| key_name(ctx, key)),
        is_possible: command.is_possible(workbench),
        outcome: Outcome::Run(command),
    }
}

/// Shows a line; returns whether it was clicked.
fn show(ui: &mut Ui, line: &Line, is_chosen: bool) -> bool {
    let width = ui.available_width();
    let button = Button::new(line.title.as_str())
        .selected(is_chosen)
        .frame_when_inactive(is_chosen)
        .shortcut_text(line.key.as_str())
        .min_size(egui::vec2(width, 0.0));
    let response = ui.add_enabled(line.is_possible, button);
    if is_chosen {
        response.scroll_to_me_animation(Some(Align::Center), ui.style().scroll_animation);
        if !line.about.is_empty() {
            let weak = theme::Palette::current(ui.ctx()).weak;
            // Below the title, which stands inside its button.
            #[expect(clippy::cast_possible_truncation, reason = "a few points")]
            let margin = Margin { left: ui.spacing().button_padding.x as i8, ..Margin::ZERO };
            Frame::new().inner_margin(margin).show(ui, |ui| {
                ui.label(RichText::new(&line.about).small().color(weak));
            });
        }
    }
    response.clicked()
}
