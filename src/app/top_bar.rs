//! The bar at the top: which scene, what it shows, which pixels to try, light or dark.

use super::scene_menu::{Choice, SceneMenu};
use super::theme::{Palette, bold};
use super::workbench::OpenScene;
use egui::text::LayoutJob;
use egui::{Align, Label, Layout, RichText, Stroke, ThemePreference, Ui, UiBuilder, vec2};

/// Height of its upper line, in points.
const UPPER: f32 = 42.0;
/// Height of its lower line, in points: two lines of text.
const LOWER: f32 = 44.0;

/// Height of the bar, in points.
#[must_use]
pub fn height(open: Option<&OpenScene>) -> f32 {
    let says_something = |open: &OpenScene| !(open.scene.about.is_empty() && open.scene.pixels.is_empty());
    if open.is_some_and(says_something) { UPPER + LOWER } else { UPPER }
}

/// What was chosen in the bar.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Action {
    /// A scene.
    Choose(Choice),
    /// A pixel.
    Record([u32; 2]),
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
    let chosen = ui
        .scope_builder(line("upper", upper.shrink2(vec2(14.0, 4.0))), |ui| {
            ui.label(RichText::new("rayscope").size(17.0).family(bold()).color(palette.accent));
            ui.add_space(8.0);
            let chosen = menu.ui(ui, open.map_or("none", |open| &open.name));
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                theme_menu(ui);
                ui.with_layout(Layout::left_to_right(Align::Center), |ui| title(ui, open));
            });
            chosen
        })
        .inner;
    let pixel = ui
        .scope_builder(line("lower", lower.shrink2(vec2(14.0, 0.0)).with_max_y(lower.bottom() - 6.0)), |ui| {
            open.and_then(|open| about(ui, open, recorded))
        })
        .inner;
    chosen.map(Action::Choose).or(pixel.map(Action::Record))
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
    ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
        for &[x, y] in open.scene.pixels.iter().take(4).rev() {
            let name = format!("pixel ({x}, {y})");
            let button = ui.add(egui::Button::new(name).selected(recorded == Some([x, y])));
            if button.on_hover_text("Record this pixel: it shows what the scene is about.").clicked() {
                chosen = Some([x, y]);
            }
        }
        if !open.scene.pixels.is_empty() {
            ui.label(RichText::new("Try:").weak());
        }
        ui.add_space(12.0);
        ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
            let palette = Palette::current(ui.ctx());
            let font = egui::FontId::proportional(12.5);
            let mut job = LayoutJob::simple(open.scene.about.clone(), font, palette.weak, ui.available_width());
            job.wrap.max_rows = 2;
            let galley = ui.ctx().fonts_mut(|fonts| fonts.layout_job(job));
            let elided = galley.elided;
            let label = ui.label(galley);
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
