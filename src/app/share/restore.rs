//! Links to what is seen, and following them.

use super::Notice;
use super::menu::views_of;
use crate::app::dock::Preset;
use crate::app::edit::dialog::Then;
use crate::app::frame::theme::drawing_theme;
use crate::app::frame::words::{say, say_with};
use crate::app::opening::{After, Source};
use crate::app::pane::Pane;
use crate::app::story::recording::Recording;
use crate::app::workbench::{Look, OpenScene, Workbench};
use crate::record::Effect;
use crate::scene::{Effects, Profile, embedded_scene};
use crate::share::link::{Accuracy, Aim, EventPlace, LessonPlace, Link};
use crate::story::Level;
use crate::trace::record_ray;
use crate::view::View;
use crate::words::Language;
use egui::{Context, ThemePreference};
use std::path::Path;
use std::sync::Arc;

/// What the names of layouts begin with in the catalogue of words.
const PRESET: &str = "preset-";
/// And those of panels.
const PANE: &str = "pane-";

impl Workbench {
    /// A link to what is seen.
    ///
    /// # Errors
    /// Says why there is none: no scene, or one whose text has errors or is too long.
    pub fn link(&self) -> Result<String, String> {
        let ctx = self.ctx();
        let open = self.open.as_ref().ok_or_else(|| say(&ctx, "no-scene"))?;
        let lesson = self.lesson.place().map(place_in_lesson);
        // A lesson brings its scenes along.
        let needs_text = lesson.is_none() || self.editing.document.is_dirty();
        let place = |recording: &Recording| EventPlace::of(&recording.tree, recording.selected());
        let link = Link {
            text: if needs_text { self.text_for_link(&ctx, open)? } else { None },
            lesson,
            aim: self.recording.as_ref().map(aim_of),
            event: self.recording.as_ref().map(place),
            level: Some(self.stepping.level.name().to_owned()),
            preset: self.dock.preset().word().strip_prefix(PRESET).map(str::to_owned),
            views: self.dock.visible().into_iter().map(|pane| name_of(pane).to_owned()).collect(),
            theme: Some(drawing_theme(&ctx)),
            language: Some(self.settings.language.tag().to_owned()),
            t: self.recording.as_ref().and_then(|recording| recording.probe_t),
            orbit: self.drawings.orbit().filter(|_| self.dock.shows(Pane::Overview)),
            accuracy: open.look.as_ref().map(accuracy_of).transpose()?,
            effects: switched_off(open),
            ..Link::to_scene(&open.name)
        };
        link.written().map_err(|error| error.to_string())
    }

    /// The text of the scene as it stands in the editor; none where it is one that comes with the program.
    fn text_for_link(&self, ctx: &Context, open: &OpenScene) -> Result<Option<String>, String> {
        if !self.editing.flaws.is_empty() {
            return Err(say(ctx, "share-link-flawed"));
        }
        let text = self.document().text();
        let embedded = embedded_scene(&open.name).filter(|_| !Path::new(&open.name).is_file());
        let is_known = embedded.is_some_and(|scene| scene.text == text);
        Ok((!is_known).then(|| text.to_owned()))
    }

    /// Opens the scene of a link and restores what the link says; if there are unsaved changes, it is asked first.
    pub fn follow(&mut self, ctx: &Context, link: &Link) {
        if !self.may_give_up(|| Then::Follow(Box::new(link.clone()))) {
            return;
        }
        self.problem = None;
        if let Some(LessonPlace { lesson, step }) = &link.lesson {
            // The step brings its own scene; what else the link says comes on top of that.
            self.sharing.after_stage = Some(Box::new(Link { text: None, ..link.clone() }));
            self.open_lesson_at(lesson, *step as usize);
            return;
        }
        let source = link.text.clone().map_or(Source::Named, Source::Text);
        self.begin_opening(ctx, &link.scene, source, After::Restore(Box::new(link.clone())));
    }

    /// Restores what a link says of the scene that is open. What it says of things that there are no longer is told and passed over.
    pub(in crate::app) fn restore(&mut self, ctx: &Context, link: &Link) {
        let mut notices = Vec::new();
        self.follow_look(ctx, link, &mut notices);
        self.follow_frame(ctx, link, &mut notices);
        self.follow_aim(link, &mut notices);
        self.sharing.notice = (!notices.is_empty()).then(|| Notice::bad(notices.join("\n")));
        self.find_awaited();
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
            pane_named(name).map_or_else(|| unknown(name), |pane| self.dock.reveal(pane));
        }
        if let Some(orbit) = link.orbit {
            self.drawings.turn_to(orbit);
        }
        if let Some(theme) = link.theme {
            let is_dark = theme.is_dark();
            ctx.set_theme(if is_dark { ThemePreference::Dark } else { ThemePreference::Light });
            self.settings.is_high_contrast = theme.is_high_contrast();
        }
    }

    /// The pixel or ray; the event and t come once that is recorded.
    fn follow_aim(&mut self, link: &Link, notices: &mut Vec<String>) {
        let ctx = self.ctx();
        let Some(open) = &self.open else { return };
        let (width, height) = (open.scene.image.width, open.scene.image.height);
        let mut aimed_at = None;
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
                aimed_at = Some(pixel);
            }
            Some(Aim::Ray([origin, direction])) => {
                let scene = Arc::clone(&open.scene);
                let pixel = self.recording.as_ref().map_or([0, 0], |recording| recording.pixel);
                let tree = Arc::new(record_ray(&scene, origin, direction));
                self.show_elsewhere(Recording::of_tree(scene, pixel, tree, None));
            }
            None => {}
        }
        self.sharing.awaited = Some(Awaited { pixel: aimed_at, event: link.event.clone(), t: link.t });
    }

    /// Selects the event of a link, and marks its t, once its pixel is recorded.
    pub(super) fn find_awaited(&mut self) {
        let Some(recording) = self.recording.as_mut().filter(|_| !self.stepping.is_recording()) else { return };
        let Some(Awaited { pixel, event, t }) = self.sharing.awaited.take() else { return };
        if pixel.is_some_and(|pixel| pixel != recording.pixel) {
            return;
        }
        if let Some(found) = event.map(|place| place.find(&recording.tree)) {
            recording.select(found.event);
            if let Some(notice) = found.notice {
                self.sharing.notice = Some(Notice::bad(notice));
            }
        }
        recording.probe_t = t.or(recording.probe_t);
    }
}

fn place_in_lesson((lesson, step): (&str, usize)) -> LessonPlace {
    LessonPlace { lesson: lesson.to_owned(), step: u32::try_from(step).unwrap_or(u32::MAX - 1) }
}

/// What of a link waits for its pixel to be recorded.
pub(super) struct Awaited {
    /// The pixel; any where the link names none.
    pixel: Option<[u32; 2]>,
    event: Option<EventPlace>,
    t: Option<f64>,
}

/// What was traced.
fn aim_of(recording: &Recording) -> Aim {
    recording.loose_ray().map_or(Aim::Pixel(recording.pixel), Aim::Ray)
}

/// The name of a panel in links: that of the drawing that it is first of all, or its own.
fn name_of(pane: Pane) -> &'static str {
    let own = pane.word().strip_prefix(PANE).unwrap_or_default();
    views_of(pane).first().map_or(own, |view| view.name)
}

/// The panel of a name, or one that shows a drawing of that name besides others.
pub fn pane_named(name: &str) -> Option<Pane> {
    let is_first = |pane: &Pane| name_of(*pane) == name;
    // What else happens to a ray is drawn along it.
    let along = View::named(name).map(|_| Pane::Along);
    Pane::ALL.into_iter().find(is_first).or(along)
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::view::ALL_VIEWS;

    #[test]
    fn every_panel_has_a_name_of_its_own_and_every_drawing_a_panel() {
        for pane in Pane::ALL {
            assert_eq!(pane_named(name_of(pane)), Some(pane));
        }
        for view in ALL_VIEWS {
            assert!(pane_named(view.name).is_some(), "{}", view.name);
        }
        assert_eq!(pane_named("gallery"), None);
    }
}
