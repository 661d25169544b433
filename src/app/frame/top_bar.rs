//! The bar at the top: menus, layouts, which scene, what it shows, which pixels to try.

use crate::app::command::{Command, ViewCommand};
use crate::app::dock::{Preset, Room};
use crate::app::frame::code::with_code;
use crate::app::frame::menu;
use crate::app::frame::scene_menu::Choice;
use crate::app::frame::theme::{Palette, bold};
use crate::app::frame::words::{say, say_with};
use crate::app::workbench::{OpenScene, Workbench};
use crate::scene::Scene;
use egui::{Align, Button, Color32, Context, Galley, Label, Layout, RichText, Stroke, TextStyle, Ui, UiBuilder, vec2};
use std::sync::Arc;

/// Height of its upper line, in points.
const UPPER: f32 = 42.0;
/// Margin to the left and to the right, in points.
const MARGIN: f32 = 14.0;
/// What the program's name and the choice of scenes take beside menus and layouts, in points.
const BESIDES: f32 = 270.0;
/// With less room than this, in points, the title would be a few letters or none.
const TITLE: f32 = 60.0;
/// Less room than this is not worth the numbers of sections, in points.
const SECTIONS: f32 = 60.0;
/// No more pixels than this are offered, so that there is room for the text.
const MOST_PIXELS: usize = 4;
/// Lines of the scene's own words that are shown; longer ones are for the tooltip.
const MOST_LINES: usize = 4;

/// Height of the bar, in points: as many lines as the scene has to say at this width, and none where everything is large.
#[must_use]
pub fn height(ui: &Ui, workbench: &Workbench) -> f32 {
    if workbench.is_embedded {
        return 0.0;
    }
    let Some(scene) = workbench.scene().map(|open| &open.scene) else { return UPPER };
    if !has_words(workbench) {
        return UPPER;
    }
    let width = ui.max_rect().width() - 2.0 * MARGIN - pixels_width(ui, &scene.pixels);
    let words = words(ui, &scene.about, width).size().y.max(ui.spacing().interact_size.y);
    UPPER + words + 10.0
}

/// The width of the offered pixels with the space before them.
fn pixels_width(ui: &Ui, pixels: &[[u32; 2]]) -> f32 {
    let font = TextStyle::Button.resolve(ui.style());
    let width = |text: String| ui.painter().layout_no_wrap(text, font.clone(), Color32::WHITE).size().x;
    let button = |&pixel: &[u32; 2]| width(name(ui.ctx(), pixel)) + 2.0 * ui.spacing().button_padding.x + 2.0;
    let spaces = 24.0 + ui.spacing().item_spacing.x * (pixels.len() + 2) as f32;
    pixels.iter().take(MOST_PIXELS).map(button).sum::<f32>() + width(say(ui.ctx(), "try-pixels")) + spaces
}

/// The scene's own words, laid out in at most a few lines.
fn words(ui: &Ui, about: &str, width: f32) -> Arc<Galley> {
    let weak = Palette::current(ui.ctx()).weak;
    let mut job = with_code(about, 12.5, weak);
    job.wrap.max_width = width.max(100.0);
    job.wrap.max_rows = MOST_LINES;
    ui.ctx().fonts_mut(|fonts| fonts.layout_job(job))
}

fn name(ctx: &Context, [x, y]: [u32; 2]) -> String {
    say_with(ctx, "pixel", &[("x", x.into()), ("y", y.into())])
}

/// Whether there is a lower line.
fn has_words(workbench: &Workbench) -> bool {
    let says = |scene: &Scene| !scene.about.is_empty() || !scene.pixels.is_empty();
    let has_room = workbench.dock.preset() != Preset::Present && workbench.dock.room() == Room::Enough;
    has_room && workbench.scene().is_some_and(|open| says(&open.scene))
}

/// What was chosen in the bar.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Action {
    /// A scene.
    Choose(Choice),
    /// A pixel.
    Record([u32; 2]),
    /// Something else.
    Run(Command),
}

/// Shows the bar.
pub fn ui(ui: &mut Ui, workbench: &Workbench) -> Option<Action> {
    let palette = Palette::current(ui.ctx());
    let bar = ui.max_rect();
    ui.painter().rect_filled(bar, 0.0, palette.panel);
    ui.painter().hline(bar.x_range(), bar.bottom(), Stroke::new(1.0, palette.edge));
    let (upper, lower) = bar.split_top_bottom_at_y(bar.top() + UPPER);
    let line = |salt: &str, rect: egui::Rect| {
        UiBuilder::new().id_salt(salt.to_owned()).max_rect(rect).layout(Layout::left_to_right(Align::Center))
    };
    let builder = line("upper", upper.shrink2(vec2(MARGIN, 4.0)));
    let chosen = ui.scope_builder(builder, |ui| upper_line(ui, workbench)).inner;
    if !has_words(workbench) {
        return chosen;
    }
    let recorded = workbench.recording().map(|recording| recording.pixel);
    let builder = line("lower", lower.shrink2(vec2(MARGIN, 0.0)).with_max_y(lower.bottom() - 6.0));
    let pixel = ui.scope_builder(builder, |ui| workbench.scene().and_then(|open| about(ui, open, recorded))).inner;
    chosen.or(pixel.map(Action::Record))
}

/// The program's name, the menus, the scene's title and the layouts.
fn upper_line(ui: &mut Ui, workbench: &Workbench) -> Option<Action> {
    let open = workbench.scene();
    let is_narrow = ui.available_width() < BESIDES + buttons_width(ui);
    ui.spacing_mut().item_spacing.x = 4.0;
    if workbench.dock.room() != Room::Enough {
        let scene = workbench.menu.ui(ui, open.map_or("", |open| &open.name)).map(Action::Choose);
        return scene.or(menu::compact(ui, workbench).map(Action::Run));
    }
    ui.label(RichText::new("rayscope").size(17.0).family(bold()).color(Palette::current(ui.ctx()).accent));
    ui.add_space(8.0);
    let scene = workbench.menu.ui(ui, open.map_or("", |open| &open.name)).map(Action::Choose);
    let menu = if is_narrow { menu::compact(ui, workbench) } else { menu::bar(ui, workbench) };
    let layout = ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
        let chosen = layouts(ui, workbench);
        ui.with_layout(Layout::left_to_right(Align::Center), |ui| title(ui, open));
        chosen
    });
    scene.or(menu.or(layout.inner).map(Action::Run))
}

/// The width of all menus and layouts in the language that is spoken.
fn buttons_width(ui: &Ui) -> f32 {
    let font = TextStyle::Button.resolve(ui.style());
    let width = |word: &str| ui.painter().layout_no_wrap(say(ui.ctx(), word), font.clone(), Color32::WHITE).size().x;
    let menus = Command::areas().into_iter().map(|(word, _)| word);
    let words: Vec<f32> = menus.chain(Preset::ALL.map(Preset::word)).map(width).collect();
    let around = 2.0 * ui.spacing().button_padding.x + 4.0;
    words.iter().sum::<f32>() + around * words.len() as f32
}

/// A button for each layout, from right to left.
fn layouts(ui: &mut Ui, workbench: &Workbench) -> Option<Command> {
    let mut chosen = None;
    for preset in Preset::ALL.into_iter().rev() {
        let word = preset.word();
        let button = Button::new(say(ui.ctx(), word)).selected(workbench.dock.preset() == preset);
        if ui.add(button).on_hover_text(say(ui.ctx(), &format!("{word}-about"))).clicked() {
            chosen = Some(Command::View(ViewCommand::Layout(preset)));
        }
    }
    chosen
}

fn title(ui: &mut Ui, open: Option<&OpenScene>) {
    let Some(open) = open else { return };
    let sections = match open.scene.sections.as_slice() {
        [] => String::new(),
        sections => format!("§ {}", sections.join(", ")),
    };
    ui.add_space(6.0);
    if ui.available_width() < TITLE {
        return;
    }
    ui.add(Label::new(RichText::new(&open.scene.title).family(bold()).size(14.5)).truncate());
    // The beginning of a number would be another section's.
    if ui.available_width() > SECTIONS {
        ui.add(Label::new(RichText::new(sections).weak()).truncate());
    }
}

/// The scene in its own words, and the pixels that tell its story best.
fn about(ui: &mut Ui, open: &OpenScene, recorded: Option<[u32; 2]>) -> Option<[u32; 2]> {
    let mut chosen = None;
    let width = ui.available_width() - pixels_width(ui, &open.scene.pixels);
    ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
        for &pixel in open.scene.pixels.iter().take(MOST_PIXELS).rev() {
            let button = ui.add(Button::new(name(ui.ctx(), pixel)).selected(recorded == Some(pixel)));
            if button.on_hover_text(say(ui.ctx(), "try-pixel-about")).clicked() {
                chosen = Some(pixel);
            }
        }
        if !open.scene.pixels.is_empty() {
            ui.label(RichText::new(say(ui.ctx(), "try-pixels")).weak());
        }
        ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
            let words = words(ui, &open.scene.about, width);
            let elided = words.elided;
            let label = ui.label(words);
            if elided {
                let ink = Palette::current(&label.ctx).text;
                label.on_hover_text(with_code(&open.scene.about, 13.5, ink));
            }
        });
    });
    chosen
}
