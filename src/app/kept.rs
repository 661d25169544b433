//! What is kept from one start to the next, as JSON.

use super::dock::Dock;
use super::settings::Settings;
use crate::words::Language;
use serde::{Deserialize, Serialize};

#[derive(Serialize, Deserialize)]
struct Kept<D> {
    dock: D,
    language: String,
    zoom: f32,
    high_contrast: bool,
    reduced_motion: bool,
    toured: bool,
}

/// The text that is kept.
#[must_use]
pub fn write(dock: &Dock, settings: Settings) -> String {
    let kept = Kept {
        dock,
        language: settings.language.tag().to_owned(),
        zoom: settings.zoom,
        high_contrast: settings.is_high_contrast,
        reduced_motion: settings.is_reduced_motion,
        toured: settings.is_toured,
    };
    // Layouts and settings are plain data; if they could not be written, nothing would be kept, and nothing lost.
    serde_json::to_string(&kept).unwrap_or_default()
}

/// What was kept. None of a text that an older program wrote, or somebody changed.
#[must_use]
pub fn read(text: &str) -> Option<(Dock, Settings)> {
    let kept: Kept<Dock> = serde_json::from_str(text).ok()?;
    let zoom = if kept.zoom.is_finite() { kept.zoom.clamp(0.5, 3.0) } else { 1.0 };
    let settings = Settings {
        language: Language::of_tag(&kept.language).unwrap_or_default(),
        zoom,
        is_high_contrast: kept.high_contrast,
        is_reduced_motion: kept.reduced_motion,
        is_toured: kept.toured,
    };
    Some((kept.dock, settings))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::dock::Preset;

    #[test]
    fn what_was_kept_is_taken_up() {
        let mut dock = Dock::default();
        dock.choose(Preset::Inspect);
        let settings =
            Settings { language: Language::German, zoom: 1.25, is_high_contrast: true, ..Settings::default() };
        let (read_dock, read_settings) = read(&write(&dock, settings)).expect("it was just written");
        assert_eq!((read_dock.preset(), read_settings), (Preset::Inspect, settings));
    }

    #[test]
    fn what_makes_no_sense_is_passed_over() {
        for text in ["", "{}", "0.35 0.52 0.5 0.48", "[1, 2", "{\"dock\": 3}"] {
            assert!(read(text).is_none(), "{text}");
        }
    }
}
