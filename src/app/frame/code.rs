//! Texts of other layers in which names stand between backticks, as in Markdown: such names are shown in a fixed width instead.

use egui::text::{LayoutJob, TextFormat};
use egui::{Color32, FontId};

/// The text with what stands between backticks in a fixed width, without them. A text with one too many is shown as it is.
#[must_use]
pub fn with_code(text: &str, size: f32, colour: Color32) -> LayoutJob {
    let plain = TextFormat::simple(FontId::proportional(size), colour);
    let mut job = LayoutJob::default();
    if text.matches('`').count() % 2 == 1 {
        job.append(text, 0.0, plain);
        return job;
    }
    let code = TextFormat::simple(FontId::monospace(size * 0.94), colour);
    for (place, part) in text.split('`').enumerate().filter(|(_, part)| !part.is_empty()) {
        job.append(part, 0.0, if place % 2 == 1 { code.clone() } else { plain.clone() });
    }
    job
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_between_backticks_are_shown_without_them_and_a_single_backtick_stays() {
        let shown = |text: &str| with_code(text, 12.0, Color32::BLACK);
        let job = shown("Change `focus` and see");
        assert_eq!((job.text.as_str(), job.sections.len()), ("Change focus and see", 3));
        assert_ne!(job.sections[0].format.font_id.family, job.sections[1].format.font_id.family);
        assert_eq!(shown("a ` b").text, "a ` b");
        assert_eq!(shown("").text, "");
    }
}
