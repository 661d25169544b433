//! The panel for finding pixels and for maps.

use super::field::{Field, Typed};
use super::found::Asked;
use super::help;
use super::maps::Maps;
use crate::app::frame::theme::Palette;
use crate::app::frame::words::say;
use crate::query::{PRESETS, Quantity, Vocabulary};
use crate::scene::Scene;
use egui::{Color32, Context, RichText, Ui};
use std::sync::Arc;

pub use super::found::Place;
pub use super::layer::Layer;
pub use super::maps::word as word_of_map;

/// What the panel remembers between frames.
#[derive(Default)]
pub struct SearchPane {
    field: Field,
    asked: Option<Asked>,
    maps: Maps,
    shown: Part,
    /// The place that was gone to, until its pixel is recorded.
    pub(in crate::app) awaited: Option<Place>,
    /// The names of a scene.
    names: Option<(Arc<Scene>, Vocabulary)>,
}

/// The part of the panel that is seen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Part {
    #[default]
    Results,
    Words,
    Maps,
}

impl SearchPane {
    /// Shows the field and lets it be typed into.
    pub fn focus(&mut self) {
        self.field.focus();
        if self.shown == Part::Maps {
            self.shown = Part::Results;
        }
    }

    /// Asks a question.
    pub fn ask(&mut self, question: &str) {
        self.field.set(question);
        self.shown = Part::Results;
    }

    /// Forgets what was found.
    pub fn clear(&mut self) {
        self.field.set("");
        self.asked = None;
    }

    /// Whether there is anything to be forgotten.
    #[must_use]
    pub fn has_question(&self) -> bool {
        !self.field.is_empty()
    }

    /// How many pixels were found so far; none where nothing was asked.
    #[must_use]
    pub fn count(&self) -> Option<usize> {
        self.asked.as_ref().map(|asked| asked.results().len())
    }

    /// Whether all that was asked is known.
    #[must_use]
    pub fn is_finished(&self) -> bool {
        self.asked.as_ref().is_none_or(Asked::is_finished)
            && (self.maps.quantity().is_none() || self.maps.is_finished())
    }

    /// Goes to the next result, or to the one before.
    pub fn go(&mut self, forward: bool) -> Option<Place> {
        self.asked.as_mut()?.go(forward)
    }

    /// Shows a map, or none.
    pub fn choose_map(&mut self, quantity: Option<Quantity>) {
        self.maps.choose(quantity);
        if quantity.is_some() {
            self.shown = Part::Maps;
        }
    }

    /// The map that is shown.
    #[must_use]
    pub const fn map(&self) -> Option<Quantity> {
        self.maps.quantity()
    }

    /// Lets work stop that nobody sees.
    pub fn pause(&mut self) {
        self.maps.pause();
    }

    /// Asks what is to be asked of the scene, and takes what is known. A map is begun only where the panel is seen.
    pub fn update(&mut self, ctx: &Context, scene: &Arc<Scene>) {
        match self.field.query() {
            Some(query) if !self.asked.as_ref().is_some_and(|asked| asked.is(query, scene)) => {
                self.asked = Some(Asked::start(ctx, query, scene));
            }
            None if self.field.is_empty() || self.asked.as_ref().is_some_and(|asked| !asked.is_of(scene)) => {
                self.asked = None;
            }
            _ => {}
        }
        if let Some(asked) = &mut self.asked {
            asked.update(ctx);
        }
        self.maps.update(ctx);
    }

    /// What lies over the picture, the lowest first.
    pub(in crate::app) fn layers(&mut self, ctx: &Context, scene: &Arc<Scene>) -> Vec<Layer> {
        let map = self.maps.layer(ctx, scene);
        let found = self.asked.as_ref().and_then(Asked::texture).cloned();
        let found = found.map(|texture| Layer { texture, tint: Color32::WHITE });
        map.into_iter().chain(found).collect()
    }

    /// What the map of a scene says of a pixel.
    #[must_use]
    pub fn told(&self, scene: &Arc<Scene>, pixel: [u32; 2]) -> Option<String> {
        self.maps.told(scene, pixel)
    }

    /// Shows the panel; returns the pixel that was chosen.
    pub fn ui(&mut self, ui: &mut Ui, scene: &Arc<Scene>) -> Option<Place> {
        self.maps.begin(ui.ctx(), scene);
        if !self.names.as_ref().is_some_and(|(of, _)| Arc::ptr_eq(of, scene)) {
            self.names = Some((Arc::clone(scene), Vocabulary::of(scene)));
        }
        let mut place = None;
        ui.horizontal(|ui| {
            self.examples(ui);
            let names = self.names.as_ref().map(|(_, names)| names);
            if let Some(typed) = names.and_then(|names| self.field.ui(ui, names)) {
                self.shown = Part::Results;
                if typed == Typed::Entered {
                    place = self.go(true);
                }
            }
        });
        self.field.problem(ui);
        self.unknown_names(ui);
        ui.horizontal(|ui| {
            let parts = [(Part::Results, "search-results"), (Part::Words, "search-words"), (Part::Maps, "search-maps")];
            for (part, word) in parts {
                ui.selectable_value(&mut self.shown, part, say(ui.ctx(), word));
            }
        });
        ui.separator();
        let chosen = match self.shown {
            Part::Results => self.results(ui),
            Part::Words => {
                if let Some(question) = help::ui(ui) {
                    self.ask(&question);
                }
                None
            }
            Part::Maps => self.maps.ui(ui, scene),
        };
        place.or(chosen)
    }

    /// Questions with names, in a menu.
    fn examples(&mut self, ui: &mut Ui) {
        let name = say(ui.ctx(), "search-presets");
        ui.menu_button(name, |ui| {
            for preset in PRESETS {
                if ui
                    .button(say(ui.ctx(), &preset.word()))
                    .on_hover_text(RichText::new(preset.query).monospace())
                    .clicked()
                {
                    self.ask(preset.query);
                    ui.close();
                }
            }
        });
    }

    fn unknown_names(&self, ui: &mut Ui) {
        let (Some(query), Some((_, names))) = (self.field.query(), &self.names) else { return };
        let colour = Palette::current(ui.ctx()).problem;
        for problem in query.unknown_names(names) {
            ui.label(RichText::new(problem.to_string()).small().color(colour));
        }
    }

    fn results(&mut self, ui: &mut Ui) -> Option<Place> {
        let Some(asked) = &mut self.asked else {
            ui.label(RichText::new(say(ui.ctx(), "search-invitation")).weak());
            return None;
        };
        let gone = asked.summary(ui);
        let clicked = asked.list(ui);
        gone.or(clicked)
    }
}
