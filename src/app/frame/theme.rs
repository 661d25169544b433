//! Colours, spacing and fonts.

use crate::view::{self, FontRole};
use egui::{
    Color32, Context, CornerRadius, FontData, FontDefinitions, FontFamily, FontId, Id, Margin, Shadow, Stroke, Style,
    TextStyle, Theme, Visuals, style::ScrollAnimation, style::ScrollStyle,
};
use std::sync::Arc;

/// Padding inside a panel, in points.
pub const PADDING: i8 = 10;

/// How long it takes until a thing that moves has moved, in seconds: long enough to be seen, too short to be waited for.
const ANIMATION: f32 = 0.1;

/// The colours of the window, taken from those of the drawings.
#[derive(Clone, Copy, Debug)]
pub struct Palette {
    /// Behind the panels.
    pub window: Color32,
    /// A panel.
    pub panel: Color32,
    /// A panel's header.
    pub header: Color32,
    /// A panel's edge.
    pub edge: Color32,
    /// Behind the picture, formulas and tables.
    pub backdrop: Color32,
    /// Behind the selected row.
    pub selected: Color32,
    /// Behind the row under the pointer.
    pub hovered: Color32,
    /// Text.
    pub text: Color32,
    /// Text beside the point.
    pub weak: Color32,
    /// The one colour that draws the eye.
    pub accent: Color32,
    /// What went wrong.
    pub problem: Color32,
}

impl Palette {
    /// The colours of a theme.
    #[must_use]
    pub fn of(theme: view::Theme) -> Self {
        let palette = theme.palette();
        let shade = |share| colour(palette.ground.mixed(palette.ink, share));
        let dark = theme.is_dark();
        Self {
            window: if dark { colour(palette.ground.mixed(view::Colour::hex(0), 0.35)) } else { shade(0.09) },
            panel: colour(palette.ground),
            header: colour(palette.panel),
            edge: colour(palette.grid),
            backdrop: shade(0.035),
            selected: colour(palette.ground.mixed(palette.camera, if dark { 0.32 } else { 0.17 })),
            hovered: shade(0.06),
            text: colour(palette.ink),
            weak: colour(palette.faint),
            accent: colour(palette.camera),
            problem: colour(palette.bad),
        }
    }

    /// The colours of the theme that is on.
    #[must_use]
    pub fn current(ctx: &Context) -> Self {
        Self::of(drawing_theme(ctx))
    }
}

/// A drawing's colour on screen.
#[must_use]
pub fn colour(colour: view::Colour) -> Color32 {
    Color32::from_rgba_unmultiplied(colour.r, colour.g, colour.b, colour.a)
}

/// The theme that is on, as drawings call it.
#[must_use]
pub fn drawing_theme(ctx: &Context) -> view::Theme {
    as_in_drawings(ctx.theme(), ctx.data(|data| data.get_temp(contrast_place())).unwrap_or(false))
}

const fn as_in_drawings(theme: Theme, is_high_contrast: bool) -> view::Theme {
    match (theme, is_high_contrast) {
        (Theme::Light, false) => view::Theme::Light,
        (Theme::Dark, false) => view::Theme::Dark,
        (Theme::Light, true) => view::Theme::LightContrast,
        (Theme::Dark, true) => view::Theme::DarkContrast,
    }
}

fn contrast_place() -> Id {
    Id::unique("high contrast")
}

fn motion_place() -> Id {
    Id::unique("reduced motion")
}

/// Puts contrast and motion into effect, where they have changed.
pub fn set(ctx: &Context, is_high_contrast: bool, is_reduced_motion: bool) {
    let wanted = (is_high_contrast, is_reduced_motion);
    let before = ctx.data(|data| (data.get_temp(contrast_place()), data.get_temp(motion_place())));
    if before == (Some(wanted.0), Some(wanted.1)) {
        return;
    }
    ctx.data_mut(|data| {
        data.insert_temp(contrast_place(), is_high_contrast);
        data.insert_temp(motion_place(), is_reduced_motion);
    });
    for theme in [Theme::Light, Theme::Dark] {
        ctx.style_mut_of(theme, |style| {
            style.visuals = visuals(theme, is_high_contrast);
            style.animation_time = if is_reduced_motion { 0.0 } else { ANIMATION };
            style.scroll_animation =
                if is_reduced_motion { ScrollAnimation::none() } else { ScrollAnimation::default() };
        });
    }
}

/// Installs fonts and styles.
pub fn install(ctx: &Context) {
    ctx.set_fonts(fonts());
    for theme in [Theme::Light, Theme::Dark] {
        ctx.style_mut_of(theme, |style| restyle(style, theme));
    }
}

/// The family of headings.
#[must_use]
pub fn bold() -> FontFamily {
    FontFamily::Name("bold".into())
}

/// The fonts of the drawings, with egui's own behind them for what is typed into files in other scripts.
fn fonts() -> FontDefinitions {
    let mut fonts = FontDefinitions::default();
    let own = fonts.families.get(&FontFamily::Proportional).cloned().unwrap_or_default();
    let families = [
        (FontFamily::Proportional, [FontRole::Sans, FontRole::Fallback]),
        (FontFamily::Monospace, [FontRole::Mono, FontRole::Fallback]),
        (bold(), [FontRole::Bold, FontRole::Sans]),
    ];
    for font in view::fonts() {
        fonts.font_data.insert(font.name.to_owned(), Arc::new(FontData::from_static(font.bytes)));
    }
    for (family, roles) in families {
        let of_role = |role| view::fonts().iter().filter(move |font| font.role == role);
        let all_roles = roles.into_iter().chain([FontRole::Sans, FontRole::Fallback]);
        let mut names: Vec<String> = Vec::new();
        for name in all_roles.flat_map(of_role).map(|font| font.name.to_owned()).chain(own.iter().cloned()) {
            if !names.contains(&name) {
                names.push(name);
            }
        }
        fonts.families.insert(family, names);
    }
    fonts
}

fn restyle(style: &mut Style, theme: Theme) {
    let sizes = [
        (TextStyle::Small, FontId::proportional(11.0)),
        (TextStyle::Body, FontId::proportional(13.5)),
        (TextStyle::Button, FontId::proportional(13.0)),
        (TextStyle::Heading, FontId::new(15.5, bold())),
        (TextStyle::Monospace, FontId::monospace(12.5)),
    ];
    style.text_styles.extend(sizes);
    style.spacing.item_spacing = egui::vec2(8.0, 6.0);
    style.spacing.button_padding = egui::vec2(9.0, 4.0);
    style.spacing.menu_margin = Margin::same(8);
    style.spacing.interact_size.y = 24.0;
    style.spacing.scroll = scroll_bars();
    style.spacing.tooltip_width = 360.0;
    style.visuals = visuals(theme, false);
}

/// Scroll bars in the colour of the text, fainter where the pointer is not on them: thin ones, but seen on every panel.
fn scroll_bars() -> ScrollStyle {
    ScrollStyle {
        foreground_color: true,
        floating_width: 4.0,
        dormant_handle_opacity: 0.5,
        active_handle_opacity: 0.5,
        interact_handle_opacity: 0.7,
        ..ScrollStyle::thin()
    }
}

fn visuals(theme: Theme, is_high_contrast: bool) -> Visuals {
    let palette = Palette::of(as_in_drawings(theme, is_high_contrast));
    let mut visuals = theme.default_visuals();
    visuals.override_text_color = None;
    visuals.weak_text_color = Some(palette.weak);
    visuals.panel_fill = palette.window;
    visuals.window_fill = palette.panel;
    visuals.window_stroke = Stroke::new(1.0, palette.edge);
    visuals.window_corner_radius = CornerRadius::same(8);
    visuals.menu_corner_radius = CornerRadius::same(8);
    visuals.popup_shadow = Shadow { offset: [0, 4], blur: 16, spread: 0, color: Color32::from_black_alpha(48) };
    visuals.extreme_bg_color = palette.backdrop;
    visuals.faint_bg_color = palette.header;
    visuals.code_bg_color = palette.backdrop;
    visuals.hyperlink_color = palette.accent;
    visuals.error_fg_color = palette.problem;
    visuals.selection.bg_fill = palette.selected;
    visuals.selection.stroke = Stroke::new(1.0, palette.accent);
    let widgets = &mut visuals.widgets;
    let states = [
        (&mut widgets.noninteractive, palette.panel, palette.edge, palette.text),
        (&mut widgets.inactive, palette.header, palette.edge, palette.text),
        (&mut widgets.hovered, palette.hovered, palette.accent, palette.text),
        (&mut widgets.active, palette.selected, palette.accent, palette.text),
        (&mut widgets.open, palette.hovered, palette.edge, palette.text),
    ];
    for (state, fill, edge, text) in states {
        state.bg_fill = fill;
        state.weak_bg_fill = fill;
        state.bg_stroke = Stroke::new(1.0, edge);
        state.fg_stroke = Stroke::new(1.0, text);
        state.corner_radius = CornerRadius::same(5);
        state.expansion = 0.0;
    }
    visuals
}
