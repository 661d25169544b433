//! What accuracy costs in time: of the whole image, and of the selected ray.

use crate::app::accuracy::image::ImageScope;
use crate::app::accuracy::ray::RayScope;
use crate::app::frame::words::{say, say_with};
use crate::app::story::recording::Recording;
use crate::app::workbench::OpenScene;
use crate::record::EventId;
use crate::scene::Profile;
use crate::shape::Method;
use crate::trace::RayTree;
use egui::{RichText, Ui};
use std::sync::Arc;

/// What the panel looks at.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Scope {
    #[default]
    Image,
    Ray,
}

/// What is asked of the workbench.
pub enum Wish {
    /// To show the scene with these settings; of this name.
    Look(String, Profile),
    /// To show the scene as it stands.
    AsItStands,
    /// To show what the ray did by a method, from this event on.
    Story(Method, Arc<RayTree>, EventId),
}

/// What the panel remembers between frames.
#[derive(Default)]
pub struct AccuracyPane {
    scope: Scope,
    image: ImageScope,
    ray: RayScope,
}

impl AccuracyPane {
    /// Forgets everything: the scene has changed.
    pub fn reset(&mut self) {
        *self = Self { scope: self.scope, ..Self::default() };
    }

    /// Stops measuring: nobody looks.
    pub fn pause(&mut self) {
        self.image.pause();
        self.ray.pause();
    }

    /// Shows the panel; returns what is asked for.
    pub fn ui(&mut self, ui: &mut Ui, open: &OpenScene, recording: Option<&Recording>) -> Option<Wish> {
        let mut wish = None;
        ui.horizontal(|ui| {
            ui.selectable_value(&mut self.scope, Scope::Image, say(ui.ctx(), "accuracy-image"));
            ui.selectable_value(&mut self.scope, Scope::Ray, say(ui.ctx(), "accuracy-ray"));
            ui.separator();
            let state = match self.scope {
                Scope::Image => self.image.state(ui.ctx()),
                Scope::Ray => self.ray.state(ui.ctx(), recording),
            };
            ui.label(RichText::new(state).weak());
            if let Some(look) = &open.look {
                ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                    let tip = say_with(ui.ctx(), "accuracy-shown-with", &[("name", (&look.name).into())]);
                    if ui.button(say(ui.ctx(), "accuracy-back")).on_hover_text(tip).clicked() {
                        wish = Some(Wish::AsItStands);
                    }
                });
            }
        });
        ui.add_space(2.0);
        let asked = match self.scope {
            Scope::Image => self.image.ui(ui, open),
            Scope::Ray => self.ray.ui(ui, open, recording),
        };
        wish.or(asked)
    }
}
