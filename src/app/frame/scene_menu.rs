//! Choosing one of the embedded scenes, by topic.

use crate::app::frame::menu;
use crate::app::frame::theme::Palette;
use crate::app::frame::words::{say, say_with};
use crate::scene::embedded_scenes;
use egui::{RichText, ScrollArea, Ui};

/// An embedded scene that was chosen, by name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Choice(pub String);

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
        let title = say_with(ui.ctx(), "scene-menu", &[("scene", current.into())]);
        let button = ui.menu_button(title, |ui| {
            ui.set_min_width((ui.ctx().content_rect().width() - 40.0).min(360.0));
            let height = menu::height(ui.ctx());
            ScrollArea::vertical().max_height(height).min_scrolled_height(height).show(ui, |ui| {
                chosen = self.list(ui, current);
            });
        });
        button.response.on_hover_text(say(ui.ctx(), "scene-menu-about"));
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
            ui.label(RichText::new(heading(&topic[0].topic)).size(11.5).color(palette.weak).strong());
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

/// A folder's name as a heading: `csg` is an abbreviation, the others are words.
fn heading(topic: &str) -> String {
    if topic == "csg" { "CSG".to_owned() } else { capitalised(&topic.replace('_', " ")) }
}

fn capitalised(words: &str) -> String {
    let mut letters = words.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
