//! Colours, spacing and fonts.

use crate::view;
use egui::{
    Color32, Context, CornerRadius, FontData, FontDefinitions, FontFamily, FontId, Margin, Shadow, Stroke, Style,
    TextStyle, Theme, Visuals,
};
use std::sync::Arc;

/// Padding inside a panel, in points.
pub const PADDING: i8 = 10;

/// The colours that are not part of egui's own style.
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
    /// Behind the picture.
    pub backdrop: Color32,
    /// Behind the selected row.
    pub selected: Color32,
    /// Behind the row under the pointer.
    pub hovered: Color32,
    /// Text.
    pub text: Color32,
    /// Text beside the point.
    pub weak: Color32,
    /// Numbers.
    pub number: Color32,
    /// The one colour that draws the eye.
    pub accent: Color32,
    /// What went wrong.
    pub problem: Color32,
}

const LIGHT: Palette = Palette {
    window: Color32::from_rgb(0xe6, 0xe8, 0xec),
    panel: Color32::from_rgb(0xff, 0xff, 0xff),
    header: Color32::from_rgb(0xf5, 0xf6, 0xf8),
    edge: Color32::from_rgb(0xcf, 0xd3, 0xda),
    backdrop: Color32::from_rgb(0xee, 0xf0, 0xf3),
    selected: Color32::from_rgb(0xd6, 0xe6, 0xfb),
    hovered: Color32::from_rgb(0xef, 0xf3, 0xf9),
    text: Color32::from_rgb(0x1f, 0x24, 0x2c),
    weak: Color32::from_rgb(0x5e, 0x67, 0x74),
    number: Color32::from_rgb(0x3a, 0x46, 0x57),
    accent: Color32::from_rgb(0x1b, 0x62, 0xb8),
    problem: Color32::from_rgb(0xa8, 0x2a, 0x22),
};

const DARK: Palette = Palette {
    window: Color32::from_rgb(0x14, 0x16, 0x1a),
    panel: Color32::from_rgb(0x1e, 0x21, 0x27),
    header: Color32::from_rgb(0x25, 0x29, 0x30),
    edge: Color32::from_rgb(0x36, 0x3b, 0x45),
    backdrop: Color32::from_rgb(0x18, 0x1b, 0x20),
    selected: Color32::from_rgb(0x2a, 0x42, 0x62),
    hovered: Color32::from_rgb(0x28, 0x2d, 0x36),
    text: Color32::from_rgb(0xe4, 0xe7, 0xec),
    weak: Color32::from_rgb(0x9a, 0xa3, 0xb0),
    number: Color32::from_rgb(0xc3, 0xcb, 0xd6),
    accent: Color32::from_rgb(0x6f, 0xb0, 0xf5),
    problem: Color32::from_rgb(0xf2, 0x8b, 0x82),
};

impl Palette {
    /// The colours of a theme.
    #[must_use]
    pub const fn of(theme: Theme) -> &'static Self {
        match theme {
            Theme::Light => &LIGHT,
            Theme::Dark => &DARK,
        }
    }

    /// The colours of the theme that is on.
    #[must_use]
    pub fn current(ctx: &Context) -> &'static Self {
        Self::of(ctx.theme())
    }
}

/// The theme that is on, as drawings call it.
#[must_use]
pub fn drawing_theme(ctx: &Context) -> view::Theme {
    match ctx.theme() {
        Theme::Light => view::Theme::Light,
        Theme::Dark => view::Theme::Dark,
    }
}

/// Installs fonts and styles.
pub fn install(ctx: &Context) {
    ctx.set_fonts(fonts());
    for theme in [Theme::Light, Theme::Dark] {
        ctx.style_mut_of(theme, |style| restyle(style, theme));
    }
}

/// egui's own fonts, with those of the drawings behind them for the mathematical signs that they lack.
fn fonts() -> FontDefinitions {
    let mut fonts = FontDefinitions::default();
    for (i, bytes) in view::fonts().iter().enumerate() {
        let name = format!("rayscope {i}");
        fonts.font_data.insert(name.clone(), Arc::new(FontData::from_static(bytes)));
        for family in [FontFamily::Proportional, FontFamily::Monospace] {
            fonts.families.entry(family).or_default().push(name.clone());
        }
    }
    fonts
}

fn restyle(style: &mut Style, theme: Theme) {
    let sizes = [
        (TextStyle::Small, FontId::proportional(11.0)),
        (TextStyle::Body, FontId::proportional(13.5)),
        (TextStyle::Button, FontId::proportional(13.0)),
        (TextStyle::Heading, FontId::proportional(16.0)),
        (TextStyle::Monospace, FontId::monospace(12.5)),
    ];
    style.text_styles.extend(sizes);
    style.spacing.item_spacing = egui::vec2(8.0, 6.0);
    style.spacing.button_padding = egui::vec2(9.0, 4.0);
    style.spacing.menu_margin = Margin::same(8);
    style.spacing.interact_size.y = 24.0;
    style.spacing.scroll = egui::style::ScrollStyle::thin();
    style.spacing.tooltip_width = 360.0;
    style.visuals = visuals(theme);
}

fn visuals(theme: Theme) -> Visuals {
    let palette = Palette::of(theme);
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
