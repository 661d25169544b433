//! Links to what is seen, and following them.

use super::Notice;
use super::menu::views_of;
use crate::app::dock::Preset;
use crate::app::frame::theme::drawing_theme;
use crate::app::frame::words::say_with;
use crate::app::pane::Pane;
use crate::app::story::recording::Recording;
use crate::app::workbench::{Look, OpenScene, Workbench};
use crate::record::Effect;
use crate::scene::{Effects, Profile, embedded_scene};
use crate::share::link::{Accuracy, Aim, EventPlace, Link};
use crate::story::Level;
use crate::trace::record_ray;
use crate::view::Theme;
use crate::words::Language;
use egui::{Context, ThemePreference};
use std::path::Path;
use std::sync::Arc;

/// What the names of layouts begin with in the catalogue of words.
const PRESET: &str = "preset-";

impl Workbench {
    /// A link to what is seen.
    ///
    /// # Errors
    /// Says why there is none: no scene, or one whose text is not at hand or too long.
    pub fn link(&self) -> Result<String, String> {
        let ctx = self.ctx();
        let open = self.open.as_ref().ok_or_else(|| crate::app::frame::words::say(&ctx, "no-scene"))?;
        let place = |recording: &Recording| EventPlace::of(&recording.tree, recording.selected());
        let link = Link {
            text: text_of(open)?,
            aim: self.recording.as_ref().map(|recording| Aim::Pixel(recording.pixel)),
            event: self.recording.as_ref().map(place),
            level: Some(self.stepping.level.name().to_owned()),
            preset: self.dock.preset().word().strip_prefix(PRESET).map(str::to_owned),
            theme: Some(drawing_theme(&ctx)),
            language: Some(self.settings.language.tag().to_owned()),
            accuracy: open.look.as_ref().map(accuracy_of).transpose()?,
            effects: switched_off(open),
            ..Link::to_scene(&open.name)
        };
        link.written().map_err(|error| error.to_string())
    }

    /// Restores what a link says. What it says of things that there are no longer is told and passed over.
    pub fn follow(&mut self, ctx: &Context, link: &Link) {
        self.problem = None;
        match &link.text {
            Some(text) => self.open_text(ctx, &link.scene, text),
            None => self.open_scene(ctx, &link.scene),
        }
        if self.problem.is_some() {
            return;
        }
        let mut notices = Vec::new();
        self.follow_look(ctx, link, &mut notices);
        self.follow_frame(ctx, link, &mut notices);
        self.follow_aim(link, &mut notices);
        self.sharing.notice = (!notices.is_empty()).then(|| Notice::bad(notices.join("\n")));
        self.find_awaited(ctx);
    }

    /// The accuracy that the scene is looked at with, and the effects that are on.
    fn follow_look(&mut self, ctx: &Context, link: &Link, notices: &mut Vec<String>) {
        match link.accuracy.as_ref().map(look_of) {
            Some(Ok(look)) => self.look(ctx, Some(look)),
            Some(Err(problem)) => notices.push(problem),
            None => {}
        }
        if let (Some(wanted), Some(open)) = (link.effects, &self.open) {
            let off = Effect::ALL.into_iter().filter(|&effect| !wanted.has(effect));
            let effects = off.fold(open.looked_at().effects, Effects::without);
            self.switch(ctx, effects);
        }
    }

    /// The layout, the panels, the level, the colours and the language.
    fn follow_frame(&mut self, ctx: &Context, link: &Link, notices: &mut Vec<String>) {
        let mut unknown = |name: &str| notices.push(say_with(ctx, "share-link-unknown", &[("name", name.into())]));
        if let Some(name) = &link.preset {
            let known = Preset::ALL.into_iter().find(|preset| preset.word().strip_prefix(PRESET) == Some(name));
            known.map_or_else(|| unknown(name), |preset| self.dock.choose(preset));
        }
        if let Some(name) = &link.level {
            let known = Level::ALL.into_iter().find(|level| level.name() == name);
            known.map_or_else(|| unknown(name), |level| self.set_level(level));
        }
        if let Some(tag) = &link.language {
            Language::of_tag(tag).map_or_else(|| unknown(tag), |language| self.settings.language = language);
        }
        for name in &link.views {
            let pane = Pane::ALL.into_iter().find(|&pane| views_of(pane).iter().any(|view| view.name == name));
            pane.map_or_else(|| unknown(name), |pane| self.dock.reveal(pane));
        }
        if let Some(theme) = link.theme {
            let is_dark = matches!(theme, Theme::Dark | Theme::DarkContrast);
            ctx.set_theme(if is_dark { ThemePreference::Dark } else { ThemePreference::Light });
            self.settings.is_high_contrast = matches!(theme, Theme::LightContrast | Theme::DarkContrast);
        }
    }

    /// The pixel or ray, and the event, which is selected once the pixel is recorded.
    fn follow_aim(&mut self, link: &Link, notices: &mut Vec<String>) {
        let ctx = self.ctx();
        let Some(open) = &self.open else { return };
        let (width, height) = (open.scene.image.width, open.scene.image.height);
        match link.aim {
            Some(Aim::Pixel(pixel)) => {
                let of = link.size.unwrap_or([width, height]);
                let pixel = [rescaled(pixel[0], of[0], width), rescaled(pixel[1], of[1], height)];
                if pixel[0] >= width || pixel[1] >= height {
                    let (x, y) = (pixel[0].to_string(), pixel[1].to_string());
                    notices.push(say_with(&ctx, "share-link-outside", &[("x", (&x).into()), ("y", (&y).into())]));
                    return;
                }
                self.record(pixel);
                self.sharing.awaited = link.event.clone().map(|event| (pixel, event));
            }
            Some(Aim::Ray([origin, direction])) => {
                let scene = Arc::clone(&open.scene);
                let pixel = self.recording.as_ref().map_or([0, 0], |recording| recording.pixel);
                let tree = Arc::new(record_ray(&scene, origin, direction));
                self.show_elsewhere(Recording::of_tree(scene, pixel, tree, None));
                self.sharing.awaited = link.event.clone().map(|event| (pixel, event));
            }
            None => {}
        }
    }

    /// Selects the event of a link once its pixel is recorded.
    pub(super) fn find_awaited(&mut self, _ctx: &Context) {
        let Some(recording) = self.recording.as_mut().filter(|_| !self.stepping.is_recording()) else { return };
        let Some((pixel, place)) = self.sharing.awaited.take() else { return };
        if recording.pixel != pixel {
            return;
        }
        let found = place.find(&recording.tree);
        recording.select(found.event);
        if let Some(notice) = found.notice {
            self.sharing.notice = Some(Notice::bad(notice));
        }
    }
}

/// The text of a scene that does not come with the program.
fn text_of(open: &OpenScene) -> Result<Option<String>, String> {
    let path = Path::new(&open.name);
    if embedded_scene(&open.name).is_some() && !path.is_file() {
        return Ok(None);
    }
    std::fs::read_to_string(path).map(Some).map_err(|error| format!("{}: {error}", open.name))
}

fn accuracy_of(look: &Look) -> Result<Accuracy, String> {
    let named = Profile::NAMED.iter().find(|(_, profile)| *profile == look.profile);
    named.map_or_else(
        || look.profile.to_json(&look.name).map(Accuracy::Text),
        |(name, _)| Ok(Accuracy::Named((*name).to_owned())),
    )
}

fn look_of(accuracy: &Accuracy) -> Result<Look, String> {
    match accuracy {
        Accuracy::Named(name) => {
            let named = Profile::NAMED.iter().find(|(known, _)| known == name);
            let (name, profile) = named.ok_or_else(|| format!("there is no accuracy profile {name}"))?;
            Ok(Look { name: (*name).to_owned(), profile: *profile })
        }
        Accuracy::Text(text) => {
            let profile = Profile::read(text, "link").map_err(|errors| errors.to_string())?;
            Ok(Look { name: "link".to_owned(), profile })
        }
    }
}

/// All effects but those that the scene calls for and that are switched off; none where none is.
fn switched_off(open: &OpenScene) -> Option<Effects> {
    let called = open.looked_at().effects;
    let off: Vec<Effect> =
        Effect::ALL.into_iter().filter(|&effect| called.has(effect) && !open.scene.effects.has(effect)).collect();
    (!off.is_empty()).then(|| off.into_iter().fold(Effects::ALL, Effects::without))
}

/// The pixel of a picture of another size that holds the middle of this one.
fn rescaled(pixel: u32, before: u32, after: u32) -> u32 {
    if before == after {
        return pixel;
    }
    let place = (2 * u64::from(pixel) + 1) * u64::from(after) / (2 * u64::from(before.max(1)));
    u32::try_from(place).unwrap_or(u32::MAX)
}
