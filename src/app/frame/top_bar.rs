//! The bar at the top: which scene, what it shows, which pixels to try, light or dark.

use crate::app::frame::scene_menu::{Choice, SceneMenu};
use crate::app::frame::theme::{Palette, bold};
use crate::app::workbench::OpenScene;
use egui::text::LayoutJob;
use egui::{
    Align, Button, Color32, FontId, Galley, Label, Layout, RichText, Stroke, TextStyle, ThemePreference, Ui, UiBuilder,
    vec2,
};
use std::sync::Arc;

/// Height of its upper line, in points.
const UPPER: f32 = 42.0;
/// Margin to the left and to the right, in points.
const MARGIN: f32 = 14.0;
/// No more pixels than this are offered, so that there is room for the text.
const MOST_PIXELS: usize = 4;
/// Lines of the scene's own words that are shown; longer ones are for the tooltip.
const MOST_LINES: usize = 4;

/// Height of the bar, in points: as many lines as the scene has to say at this width.
#[must_use]
pub fn height(ui: &Ui, open: Option<&OpenScene>) -> f32 {
    let Some(scene) = open.map(|open| &open.scene) else { return UPPER };
    if scene.about.is_empty() && scene.pixels.is_empty() {
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
    let button = |&pixel: &[u32; 2]| width(name(pixel)) + 2.0 * ui.spacing().button_padding.x + 2.0;
    let spaces = 24.0 + ui.spacing().item_spacing.x * (pixels.len() + 2) as f32;
    pixels.iter().take(MOST_PIXELS).map(button).sum::<f32>() + width("Try:".to_owned()) + spaces
}

/// The scene's own words, laid out in at most a few lines.
fn words(ui: &Ui, about: &str, width: f32) -> Arc<Galley> {
    let weak = Palette::current(ui.ctx()).weak;
    let mut job = LayoutJob::simple(about.to_owned(), FontId::proportional(12.5), weak, width.max(100.0));
    job.wrap.max_rows = MOST_LINES;
    ui.ctx().fonts_mut(|fonts| fonts.layout_job(job))
}

fn name([x, y]: [u32; 2]) -> String {
    format!("pixel ({x}, {y})")
}

/// What was chosen in the bar.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Action {
    /// A scene.
    Choose(Choice),
    /// A pixel.
    Record([u32; 2]),
    /// The window of the effects, to be shown or hidden.
    Effects,
    /// The window of what accuracy costs, likewise.
    Accuracy,
}

/// Shows the bar.
pub fn ui(ui: &mut Ui, menu: &SceneMenu, open: Option<&OpenScene>, recorded: Option<[u32; 2]>) -> Option<Action> {
    let palette = Palette::current(ui.ctx());
    let bar = ui.max_rect();
    ui.painter().rect_filled(bar, 0.0, palette.panel);
    ui.painter().hline(bar.x_range(), bar.bottom(), Stroke::new(1.0, palette.edge));
    let (upper, lower) = bar.split_top_bottom_at_y(bar.top() + UPPER);
    let line = |salt: &str, rect: egui::Rect| {
        UiBuilder::new().id_salt(salt.to_owned()).max_rect(rect).layout(Layout::left_to_right(Align::Center))
    };
    let mut window = None;
    let chosen = ui
        .scope_builder(line("upper", upper.shrink2(vec2(MARGIN, 4.0))), |ui| {
            ui.label(RichText::new("rayscope").size(17.0).family(bold()).color(palette.accent));
            ui.add_space(8.0);
            let chosen = menu.ui(ui, open.map_or("none", |open| &open.name));
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                theme_menu(ui);
                let button =
                    ui.button("Effects").on_hover_text("What the scene calls for, and what each effect costs.");
                window = button.clicked().then_some(Action::Effects);
                let button =
                    ui.button("Accuracy").on_hover_text("What accuracy costs in time, of this image and of this ray.");
                window = button.clicked().then_some(Action::Accuracy).or(window.take());
                ui.with_layout(Layout::left_to_right(Align::Center), |ui| title(ui, open));
            });
            chosen
        })
        .inner;
    let pixel = ui
        .scope_builder(line("lower", lower.shrink2(vec2(MARGIN, 0.0)).with_max_y(lower.bottom() - 6.0)), |ui| {
            open.and_then(|open| about(ui, open, recorded))
        })
        .inner;
    chosen.map(Action::Choose).or(pixel.map(Action::Record)).or(window)
}

fn title(ui: &mut Ui, open: Option<&OpenScene>) {
    let Some(open) = open else { return };
    let sections = match open.scene.sections.as_slice() {
        [] => String::new(),
        sections => format!("§ {}", sections.join(", ")),
    };
    ui.add_space(6.0);
    ui.add(Label::new(RichText::new(&open.scene.title).family(bold()).size(14.5)).truncate());
    ui.add(Label::new(RichText::new(sections).weak()).truncate());
}

/// The scene in its own words, and the pixels that tell its story best.
fn about(ui: &mut Ui, open: &OpenScene, recorded: Option<[u32; 2]>) -> Option<[u32; 2]> {
    let mut chosen = None;
    let width = ui.available_width() - pixels_width(ui, &open.scene.pixels);
    ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
        for &pixel in open.scene.pixels.iter().take(MOST_PIXELS).rev() {
            let button = ui.add(Button::new(name(pixel)).selected(recorded == Some(pixel)));
            if button.on_hover_text("Record this pixel: it shows what the scene is about.").clicked() {
                chosen = Some(pixel);
            }
        }
        if !open.scene.pixels.is_empty() {
            ui.label(RichText::new("Try:").weak());
        }
        ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
            let words = words(ui, &open.scene.about, width);
            let elided = words.elided;
            let label = ui.label(words);
            if elided {
                label.on_hover_text(&open.scene.about);
            }
        });
    });
    chosen
}

fn theme_menu(ui: &mut Ui) {
    let mut preference = ui.ctx().options(|options| options.theme_preference);
    let before = preference;
    let name = match preference {
        ThemePreference::System => "Theme: system",
        ThemePreference::Light => "Theme: light",
        ThemePreference::Dark => "Theme: dark",
    };
    ui.menu_button(name, |ui| {
        ui.selectable_value(&mut preference, ThemePreference::System, "As the system");
        ui.selectable_value(&mut preference, ThemePreference::Light, "Light");
        ui.selectable_value(&mut preference, ThemePreference::Dark, "Dark");
    });
    if preference != before {
        ui.ctx().set_theme(preference);
    }
}
