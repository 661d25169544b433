//! Layouts, panels, size and language of what is shown.

use super::Commands;
use crate::app::dock::Preset;
use crate::app::pane::Pane;
use crate::app::workbench::Workbench;
use crate::words::Language;
use egui::{Context, Key, KeyboardShortcut, Modifiers, ThemePreference};
use egui_tiles::LinearDir;

/// How far one command resizes a panel, as a part of the row or column that it is in.
const RESIZE: f32 = 0.04;

/// A command about what is shown, and how.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ViewCommand {
    /// Shows a layout.
    Layout(Preset),
    /// Puts the layout back to what it was at first.
    ResetLayout,
    /// Shows a panel, or closes it if it is seen.
    Pane(Pane),
    /// Goes on to the next panel.
    NextPane,
    /// Goes back to the panel before.
    PreviousPane,
    /// Gives the panel the window to itself, or takes it back.
    Alone,
    /// Closes the panel.
    Close,
    /// Resizes the panel.
    Wider,
    /// Resizes the panel.
    Narrower,
    /// Resizes the panel.
    Higher,
    /// Resizes the panel.
    Lower,
    /// Makes everything larger.
    ZoomIn,
    /// Makes everything smaller.
    ZoomOut,
    /// Makes everything as large as at first.
    ZoomReset,
    /// Chooses between light and dark.
    Theme(ThemePreference),
    /// Lets everything stand out as far as it can.
    HighContrast,
    /// Lets nothing move by itself.
    ReducedMotion,
    /// Chooses a language.
    Language(Language),
}

impl Commands for ViewCommand {
    const ALL: &'static [Self] = &[
        Self::Layout(Preset::Learn),
        Self::Layout(Preset::Inspect),
        Self::Layout(Preset::Present),
        Self::Layout(Preset::Measure),
        Self::Layout(Preset::Lesson),
        Self::ResetLayout,
        Self::Pane(Pane::Picture),
        Self::Pane(Pane::Side),
        Self::Pane(Pane::Overview),
        Self::Pane(Pane::Generic),
        Self::Pane(Pane::Story),
        Self::Pane(Pane::Detail),
        Self::Pane(Pane::Along),
        Self::Pane(Pane::Intervals),
        Self::Pane(Pane::Signs),
        Self::Pane(Pane::Snell),
        Self::Pane(Pane::Shading),
        Self::Pane(Pane::Planes),
        Self::Pane(Pane::Search),
        Self::Pane(Pane::Compare),
        Self::Pane(Pane::Editor),
        Self::Pane(Pane::Properties),
        Self::Pane(Pane::Accuracy),
        Self::Pane(Pane::Effects),
        Self::Pane(Pane::Lesson),
        Self::NextPane,
        Self::PreviousPane,
        Self::Alone,
        Self::Close,
        Self::Wider,
        Self::Narrower,
        Self::Higher,
        Self::Lower,
        Self::ZoomIn,
        Self::ZoomOut,
        Self::ZoomReset,
        Self::Theme(ThemePreference::System),
        Self::Theme(ThemePreference::Light),
        Self::Theme(ThemePreference::Dark),
        Self::HighContrast,
        Self::ReducedMotion,
        Self::Language(Language::English),
        Self::Language(Language::German),
    ];

    fn word(self) -> &'static str {
        match self {
            Self::Layout(preset) => preset.word(),
            Self::ResetLayout => "view-reset-layout",
            Self::Pane(pane) => pane.word(),
            Self::NextPane => "view-next-pane",
            Self::PreviousPane => "view-previous-pane",
            Self::Alone => "view-alone",
            Self::Close => "view-close",
            Self::Wider => "view-wider",
            Self::Narrower => "view-narrower",
            Self::Higher => "view-higher",
            Self::Lower => "view-lower",
            Self::ZoomIn => "view-zoom-in",
            Self::ZoomOut => "view-zoom-out",
            Self::ZoomReset => "view-zoom-reset",
            Self::Theme(ThemePreference::System) => "theme-system",
            Self::Theme(ThemePreference::Light) => "theme-light",
            Self::Theme(ThemePreference::Dark) => "theme-dark",
            Self::HighContrast => "view-high-contrast",
            Self::ReducedMotion => "view-reduced-motion",
            Self::Language(Language::English) => "language-english",
            Self::Language(Language::German) => "language-german",
        }
    }

    fn group(self) -> Option<&'static str> {
        match self {
            Self::Layout(_) | Self::ResetLayout => Some("view-layouts"),
            Self::Pane(_) => Some("view-panes"),
            _ => None,
        }
    }

    fn key(self) -> Option<KeyboardShortcut> {
        let command = |key| Some(KeyboardShortcut::new(Modifiers::COMMAND, key));
        let resize = |key| Some(KeyboardShortcut::new(Modifiers::COMMAND.plus(Modifiers::ALT), key));
        match self {
            Self::Layout(Preset::Learn) => command(Key::Num1),
            Self::Layout(Preset::Inspect) => command(Key::Num2),
            Self::Layout(Preset::Present) => command(Key::Num3),
            Self::Layout(Preset::Measure) => command(Key::Num4),
            Self::Layout(Preset::Lesson) => command(Key::Num5),
            Self::NextPane => Some(KeyboardShortcut::new(Modifiers::NONE, Key::F6)),
            Self::PreviousPane => Some(KeyboardShortcut::new(Modifiers::SHIFT, Key::F6)),
            Self::Alone => Some(KeyboardShortcut::new(Modifiers::NONE, Key::F11)),
            Self::Close => command(Key::W),
            Self::Wider => resize(Key::ArrowRight),
            Self::Narrower => resize(Key::ArrowLeft),
            Self::Higher => resize(Key::ArrowDown),
            Self::Lower => resize(Key::ArrowUp),
            Self::ZoomIn => command(Key::Plus),
            Self::ZoomOut => command(Key::Minus),
            Self::ZoomReset => command(Key::Num0),
            Self::ResetLayout
            | Self::Pane(_)
            | Self::Theme(_)
            | Self::HighContrast
            | Self::ReducedMotion
            | Self::Language(_) => None,
        }
    }

    fn is_possible(self, workbench: &Workbench) -> bool {
        let has_current = workbench.dock.current().is_some();
        match self {
            Self::Alone | Self::Close | Self::Wider | Self::Narrower | Self::Higher | Self::Lower => has_current,
            _ => true,
        }
    }

    fn is_on(self, workbench: &Workbench) -> Option<bool> {
        let theme = workbench.ctx().options(|options| options.theme_preference);
        match self {
            Self::Layout(preset) => Some(workbench.dock.preset() == preset),
            Self::Pane(pane) => Some(workbench.dock.shows(pane)),
            Self::Theme(preference) => Some(theme == preference),
            Self::HighContrast => Some(workbench.settings.is_high_contrast),
            Self::ReducedMotion => Some(workbench.settings.is_reduced_motion),
            Self::Language(language) => Some(workbench.settings.language == language),
            _ => None,
        }
    }

    fn run(self, workbench: &mut Workbench, ctx: &Context) {
        use LinearDir::{Horizontal, Vertical};
        let dock = &mut workbench.dock;
        match self {
            Self::Layout(preset) => dock.choose(preset),
            Self::ResetLayout => dock.reset(),
            Self::Pane(pane) if dock.shows(pane) => dock.close(pane),
            Self::Pane(pane) => dock.reveal(pane),
            Self::NextPane => dock.go_round(ctx, true),
            Self::PreviousPane => dock.go_round(ctx, false),
            Self::Alone => dock.current().into_iter().for_each(|pane| dock.toggle_alone(pane)),
            Self::Close => dock.current().into_iter().for_each(|pane| dock.close(pane)),
            Self::Wider => dock.resize_current(Horizontal, RESIZE),
            Self::Narrower => dock.resize_current(Horizontal, -RESIZE),
            Self::Higher => dock.resize_current(Vertical, RESIZE),
            Self::Lower => dock.resize_current(Vertical, -RESIZE),
            Self::ZoomIn => workbench.settings.zoom_by(1),
            Self::ZoomOut => workbench.settings.zoom_by(-1),
            Self::ZoomReset => workbench.settings.zoom = 1.0,
            Self::Theme(preference) => ctx.set_theme(preference),
            Self::HighContrast => workbench.settings.is_high_contrast ^= true,
            Self::ReducedMotion => workbench.settings.is_reduced_motion ^= true,
            Self::Language(language) => workbench.settings.language = language,
        }
    }
}
