//! What a scene was made from, so that it can be made again where no memory is shared: in a worker of a browser.

use super::{Diagnostics, Effects, Files, Image, Profile, Scene, load_with};
use serde::{Deserialize, Serialize};
use std::fmt;
use std::sync::Arc;

/// The text of a scene, and how it is looked at.
#[derive(Clone)]
pub struct Origin {
    source: Arc<Source>,
    looks: Vec<Look>,
}

struct Source {
    name: String,
    text: String,
}

/// A change of how a scene is looked at, as data.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
enum Look {
    /// A profile, as the text of its file.
    Profile(String),
    /// The effects that are on.
    Effects(Effects),
}

/// Everything from which a scene can be made again.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Recipe {
    /// The scene's name, or its file's.
    pub name: String,
    text: String,
    looks: Vec<Look>,
    frame: f64,
    size: [u32; 2],
}

impl Origin {
    pub(super) fn of(name: &str, text: &str) -> Self {
        Self { source: Arc::new(Source { name: name.to_owned(), text: text.to_owned() }), looks: Vec::new() }
    }

    /// Looked at by a profile besides. Every profile that a scene can be looked at by can be written down.
    pub(super) fn by_profile(&self, profile: &Profile) -> Self {
        self.with(profile.to_json("").ok().map(Look::Profile))
    }

    /// With these effects on.
    pub(super) fn by_effects(&self, effects: Effects) -> Self {
        self.with(Some(Look::Effects(effects)))
    }

    fn with(&self, look: Option<Look>) -> Self {
        Self { source: Arc::clone(&self.source), looks: self.looks.iter().cloned().chain(look).collect() }
    }
}

/// Where it comes from makes a scene no other one: texts that differ in spaces alone are the same scene.
impl PartialEq for Origin {
    fn eq(&self, _other: &Self) -> bool {
        true
    }
}

impl fmt::Debug for Origin {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_tuple("Origin").field(&self.source.name).finish()
    }
}

impl Scene {
    /// From what it can be made again.
    #[must_use]
    pub fn recipe(&self) -> Recipe {
        let Origin { source, looks } = &self.origin;
        let (name, text) = (source.name.clone(), source.text.clone());
        Recipe { name, text, looks: looks.clone(), frame: self.frame, size: [self.image.width, self.image.height] }
    }
}

impl Recipe {
    /// Makes the scene again, with its pictures from `files`.
    ///
    /// # Errors
    /// Where the files are not those that it was made with the first time.
    pub fn make(&self, files: &dyn Files) -> Result<Scene, Diagnostics> {
        let mut scene = load_with(&self.text, &self.name, files)?.at_frame(self.frame);
        for look in &self.looks {
            scene = match look {
                Look::Profile(text) => scene.with_profile(&Profile::read(text, &self.name)?),
                Look::Effects(effects) => scene.with_effects(*effects),
            };
        }
        let [width, height] = self.size;
        scene.image = Image { width, height };
        Ok(scene)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::Effect;
    use crate::scene::{EmbeddedFiles, embedded_scenes, load};

    fn made_again(scene: &Scene) -> Scene {
        let recipe = scene.recipe();
        let told: Recipe = serde_json::from_str(&serde_json::to_string(&recipe).unwrap()).unwrap();
        assert_eq!(told, recipe);
        told.make(&EmbeddedFiles::of_scene(&recipe.name)).unwrap()
    }

    #[test]
    fn every_scene_is_made_again_however_it_is_looked_at() {
        for embedded in embedded_scenes() {
            let scene = load(embedded.text, &embedded.name).unwrap();
            assert_eq!(made_again(&scene), scene, "{}", embedded.name);
            let mut other = scene.with_profile(&Profile::DRAFT).with_effects(scene.effects.without(Effect::Shadows));
            other.image = Image { width: 40, height: 30 };
            assert_eq!(made_again(&other), other, "{}", embedded.name);
        }
    }

    #[test]
    fn a_text_that_is_written_otherwise_is_the_same_scene() {
        let embedded = embedded_scenes().swap_remove(0);
        let scene = load(embedded.text, "here").unwrap();
        assert_eq!(load(&format!("{}\n\n", embedded.text), "there").unwrap(), scene);
    }
}
