//! What is kept from one start to the next, as JSON.

use super::dock::Dock;
use super::settings::Settings;
use crate::lesson::Progress;
use crate::words::Language;
use serde::{Deserialize, Serialize};

/// What was kept.
pub struct Kept {
    /// Where the panels lie.
    pub dock: Dock,
    /// What a person has set.
    pub settings: Settings,
    /// What was done in lessons.
    pub progress: Progress,
}

#[derive(Serialize, Deserialize)]
struct File<D, P> {
    dock: D,
    language: String,
    zoom: f32,
    high_contrast: bool,
    reduced_motion: bool,
    toured: bool,
    /// Older programs had no lessons.
    #[serde(default)]
    progress: P,
}

/// The text that is kept.
#[must_use]
pub fn write(dock: &Dock, settings: Settings, progress: &Progress) -> String {
    let kept = File {
        dock,
        language: settings.language.tag().to_owned(),
        zoom: settings.zoom,
        high_contrast: settings.is_high_contrast,
        reduced_motion: settings.is_reduced_motion,
        toured: settings.is_toured,
        progress,
    };
    // Layouts and settings are plain data; if they could not be written, nothing would be kept, and nothing lost.
    serde_json::to_string(&kept).unwrap_or_default()
}

/// What was kept. None of a text that an older program wrote, or somebody changed.
#[must_use]
pub fn read(text: &str) -> Option<Kept> {
    let kept: File<Dock, Progress> = serde_json::from_str(text).ok()?;
    let zoom = if kept.zoom.is_finite() { kept.zoom.clamp(0.5, 3.0) } else { 1.0 };
    let settings = Settings {
        language: Language::of_tag(&kept.language).unwrap_or_default(),
        zoom,
        is_high_contrast: kept.high_contrast,
        is_reduced_motion: kept.reduced_motion,
        is_toured: kept.toured,
    };
    Some(Kept { dock: kept.dock.mended(), settings, progress: kept.progress })
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
        let mut progress = Progress::default();
        progress.of("06_cube").step = 3;
        let kept = read(&write(&dock, settings, &progress)).expect("it was just written");
        assert_eq!((kept.dock.preset(), kept.settings, kept.progress), (Preset::Inspect, settings, progress));
    }

    #[test]
    fn what_makes_no_sense_is_passed_over() {
        for text in ["", "{}", "0.35 0.52 0.5 0.48", "[1, 2", "{\"dock\": 3}"] {
            assert!(read(text).is_none(), "{text}");
        }
    }
}
