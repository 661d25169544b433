//! What a person has set for good: language, size, and how the panels lie.

use super::frame::{theme, words};
use crate::words::Language;
use egui::Context;

/// The sizes that everything can be shown in, in percent.
const ZOOMS: [u16; 11] = [50, 67, 80, 90, 100, 110, 125, 150, 200, 250, 300];

/// Settings that are kept from one start to the next.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// The language of the interface.
    pub language: Language,
    /// How much larger everything is than at first, from 0.5 to 3.
    pub zoom: f32,
    /// Whether everything stands out from the ground as far as it can.
    pub is_high_contrast: bool,
    /// Whether nothing moves by itself.
    pub is_reduced_motion: bool,
    /// Whether the tour of the first visit was taken or passed over.
    pub is_toured: bool,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            language: Language::English,
            zoom: 1.0,
            is_high_contrast: false,
            is_reduced_motion: false,
            is_toured: false,
        }
    }
}

impl Settings {
    /// Goes on by some of the sizes that everything can be shown in.
    pub fn zoom_by(&mut self, steps: isize) {
        let percent = self.zoom * 100.0;
        let nearest = (0..ZOOMS.len()).min_by(|&a, &b| {
            let distance = |i: usize| (f32::from(ZOOMS[i]) - percent).abs();
            distance(a).total_cmp(&distance(b))
        });
        let place = nearest.unwrap_or(4).saturating_add_signed(steps).min(ZOOMS.len() - 1);
        self.zoom = f32::from(ZOOMS[place]) / 100.0;
    }

    /// Puts them into effect. `magnification` is what the layout adds to the zoom.
    pub fn apply(&self, ctx: &Context, magnification: f32) {
        let zoom = (self.zoom * magnification).clamp(0.5, 3.0);
        if (ctx.zoom_factor() - zoom).abs() > 1e-3 {
            ctx.set_zoom_factor(zoom);
        }
        words::set_language(ctx, self.language);
        theme::set(ctx, self.is_high_contrast, self.is_reduced_motion);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zooming_in_and_out_comes_back_and_stays_between_half_and_three_times() {
        let mut settings = Settings::default();
        settings.zoom_by(1);
        settings.zoom_by(-1);
        assert_eq!(settings.zoom, 1.0);
        settings.zoom_by(100);
        assert_eq!(settings.zoom, 3.0);
        settings.zoom_by(-100);
        assert_eq!(settings.zoom, 0.5);
    }
}
