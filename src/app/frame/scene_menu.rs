//! Choosing one of the embedded scenes, by topic.

use crate::app::frame::menu;
use crate::app::frame::theme::Palette;
use crate::app::frame::words::{say, say_with};
use crate::scene::embedded_scenes;
use egui::{RichText, ScrollArea, Ui};

/// An embedded scene that was chosen, by name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Choice(pub String);

/// As long as the longest name of a scene that comes with the program. Longer names push the menus behind them under the layouts
/// in a window of 1280 points; shorter ones would cut names that have room.
const MOST_LETTERS: usize = 28;

/// A line of the menu.
struct Entry {
    name: String,
    topic: String,
    title: String,
}

/// The embedded scenes with their titles, read when the menu is first built.
pub struct SceneMenu {
    entries: Vec<Entry>,
}

impl Default for SceneMenu {
    fn default() -> Self {
        let entry = |scene: crate::scene::EmbeddedScene| {
            let title = scene.title();
            let topic = scene.name.split_once('/').map_or("", |(topic, _)| topic).to_owned();
            Entry { name: scene.name, topic, title }
        };
        let mut entries: Vec<_> = embedded_scenes().into_iter().map(entry).collect();
        entries.sort_by_key(|entry| place(&entry.topic));
        Self { entries }
    }
}

/// The topics in the order in which they are learnt; others follow.
const TOPICS: [&str; 6] = ["hello", "primitives", "skewed", "csg", "optics", "hard"];

fn place(topic: &str) -> usize {
    TOPICS.iter().position(|known| *known == topic).unwrap_or(TOPICS.len())
}

impl SceneMenu {
    /// Shows the menu's button and, when it is open, the list; returns what was chosen.
    pub fn ui(&self, ui: &mut Ui, current: &str) -> Option<Choice> {
        let mut chosen = None;
        let shown = shortened(current);
        let title = say_with(ui.ctx(), "scene-menu", &[("scene", (&shown).into())]);
        let button = ui.menu_button(title, |ui| {
            ui.set_min_width((ui.ctx().content_rect().width() - 40.0).min(360.0));
            let height = menu::height(ui.ctx());
            ScrollArea::vertical().max_height(height).min_scrolled_height(height).show(ui, |ui| {
                chosen = self.list(ui, current);
            });
        });
        let about = say(ui.ctx(), "scene-menu-about");
        button.response.on_hover_text(if shown == current { about } else { format!("{current}\n{about}") });
        chosen
    }

    fn list(&self, ui: &mut Ui, current: &str) -> Option<Choice> {
        let palette = Palette::current(ui.ctx());
        let mut chosen = None;
        ui.spacing_mut().item_spacing.y = 2.0;
        for (i, topic) in self.entries.chunk_by(|a, b| a.topic == b.topic).enumerate() {
            if i > 0 {
                ui.add_space(6.0);
            }
            ui.label(
                RichText::new(say(ui.ctx(), &format!("scenes-{}", topic[0].topic)))
                    .size(11.5)
                    .color(palette.weak)
                    .strong(),
            );
            for entry in topic {
                let line = ui.selectable_label(entry.name == current, &entry.title).on_hover_text(&entry.name);
                if line.clicked() {
                    chosen = Some(Choice(entry.name.clone()));
                    ui.close();
                }
            }
        }
        chosen
    }
}

/// The end of a name that would push other menus out of the bar: what tells it from others stands there.
fn shortened(name: &str) -> String {
    let letters = name.chars().count();
    if letters <= MOST_LETTERS {
        return name.to_owned();
    }
    let end: String = name.chars().skip(letters + 1 - MOST_LETTERS).collect();
    format!("…{end}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_scene_of_the_program_keeps_its_name_and_a_long_path_keeps_its_end() {
        for scene in embedded_scenes() {
            assert_eq!(shortened(&scene.name), scene.name);
        }
        let short = shortened("lessons/05_every_case_of_the_tapered_cylinder/bucket.json");
        assert_eq!(short.chars().count(), MOST_LETTERS);
        assert!(short.starts_with('…') && short.ends_with("/bucket.json"), "{short}");
        assert_eq!(shortened(""), "");
    }
}
