//! Menus made from the list of commands.

use crate::app::command::Command;
use crate::app::frame::key_names::key_name;
use crate::app::frame::words::{say, say_with};
use crate::app::workbench::Workbench;
use egui::{Button, Color32, Context, RichText, ScrollArea, TextStyle, Ui};

/// The least width of a menu, in points.
const WIDTH: f32 = 250.0;
/// Room for what stands beside a command's name and key: a tick, the gap between them, and the padding, in points.
const BESIDE: f32 = 68.0;
/// Between two columns, in points.
const BETWEEN: f32 = 28.0;
/// What a menu leaves free of the window's height: the bar that it hangs from, and its margins, in points.
const FREE: f32 = 64.0;

/// Height above which a menu scrolls, in points.
#[must_use]
pub fn height(ctx: &Context) -> f32 {
    (ctx.content_rect().height() - FREE).max(FREE)
}

/// One menu for each area, beside each other; returns what was chosen.
pub fn bar(ui: &mut Ui, workbench: &Workbench) -> Option<Command> {
    let mut chosen = None;
    for (title, commands) in Command::areas() {
        ui.menu_button(say(ui.ctx(), title), |ui| chosen = chosen.or(list(ui, workbench, &commands)));
    }
    chosen
}

/// All menus within one, where there is little room; returns what was chosen.
pub fn compact(ui: &mut Ui, workbench: &Workbench) -> Option<Command> {
    let mut chosen = None;
    ui.menu_button(say(ui.ctx(), "menu-all"), |ui| chosen = bar(ui, workbench));
    chosen
}

fn list(ui: &mut Ui, workbench: &Workbench, commands: &[Command]) -> Option<Command> {
    let mut chosen = None;
    let screen = ui.ctx().content_rect();
    let widest = commands.iter().map(|&command| width_of(ui, command)).fold(WIDTH, f32::max);
    let width = widest.min(screen.width() - BESIDE);
    ui.spacing_mut().item_spacing.y = 1.0;
    // Without the second, a menu would scroll as soon as it is higher than what areas are at first.
    let height = height(ui.ctx());
    let columns = columns(ui, commands, height, 2.0 * width + BETWEEN <= screen.width() - BESIDE);
    ui.set_width(width * columns.len() as f32 + BETWEEN * (columns.len() - 1) as f32);
    ScrollArea::vertical().max_height(height).min_scrolled_height(height).show(ui, |ui| {
        ui.horizontal_top(|ui| {
            ui.spacing_mut().item_spacing.x = BETWEEN;
            for commands in columns {
                let picked = ui.vertical(|ui| column(ui, workbench, commands, width)).inner;
                chosen = chosen.or(picked);
            }
        });
    });
    chosen
}

/// The commands in one column, or in two where one would be too high and there is room for them: parted where a group begins,
/// so that the higher one is as low as can be.
fn columns<'a>(ui: &Ui, commands: &'a [Command], height: f32, has_room: bool) -> Vec<&'a [Command]> {
    let line = ui.spacing().interact_size.y.max(ui.text_style_height(&TextStyle::Button)) + ui.spacing().item_spacing.y;
    if !has_room || commands.len() as f32 * line <= height {
        return vec![commands];
    }
    let starts = (1..commands.len()).filter(|&i| commands[i].group() != commands[i - 1].group());
    let start = starts.min_by_key(|&i| i.max(commands.len() - i));
    start.map_or_else(|| vec![commands], |i| vec![&commands[..i], &commands[i..]])
}

fn column(ui: &mut Ui, workbench: &Workbench, commands: &[Command], width: f32) -> Option<Command> {
    ui.set_width(width);
    let (mut chosen, mut group) = (None, None);
    for (i, &command) in commands.iter().enumerate() {
        if command.group() != group {
            group = command.group();
            begin_group(ui, group, i > 0);
        }
        if line(ui, workbench, command) {
            chosen = Some(command);
            ui.close();
        }
    }
    chosen
}

/// What stands before the commands of a group: its name, or a line between those that have none and what is above.
fn begin_group(ui: &mut Ui, group: Option<&str>, has_above: bool) {
    if let Some(group) = group {
        ui.label(RichText::new(say(ui.ctx(), group)).small().weak());
    } else if has_above {
        ui.separator();
    }
}

/// How wide a command with its key is.
fn width_of(ui: &Ui, command: Command) -> f32 {
    let font = TextStyle::Button.resolve(ui.style());
    let width = |text: String| ui.painter().layout_no_wrap(text, font.clone(), Color32::WHITE).size().x;
    let key = command.key().map_or(0.0, |key| width(key_name(ui.ctx(), key)));
    width(say(ui.ctx(), command.word())) + key + BESIDE
}

/// Shows a command with its key; returns whether it was chosen.
fn line(ui: &mut Ui, workbench: &Workbench, command: Command) -> bool {
    let name = say(ui.ctx(), command.word());
    let is_on = command.is_on(workbench) == Some(true);
    let key = command.key().map_or_else(String::new, |key| key_name(ui.ctx(), key));
    // A tick as well as a colour: the colour alone would not be seen by everyone.
    let title = if is_on { format!("✔ {name}") } else { name };
    let button = Button::new(title).selected(is_on).frame_when_inactive(false).shortcut_text(key);
    let about = say_with(ui.ctx(), &format!("{}-about", command.word()), &[]);
    let width = ui.available_width().max(WIDTH);
    let button = button.min_size(egui::vec2(width, 0.0));
    let response = ui.add_enabled(command.is_possible(workbench), button);
    response.on_hover_text(&about).clicked()
}
