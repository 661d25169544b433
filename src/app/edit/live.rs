//! The scene follows its text: what is typed is compiled and the pixel recorded on a thread, and the window goes on.

use crate::app::frame::background::Background;
use crate::app::story::recording::loose_ray;
use crate::document::{changed_events, same_event};
use crate::folder::{Outside, files_of_scene};
use crate::record::EventId;
use crate::scene::{Diagnostics, Profile, Scene, load_with};
use crate::trace::{RayTree, record_pixel, record_ray};
use egui::Context;
use std::collections::BTreeSet;
use std::sync::Arc;
use std::time::Duration;

/// So long nothing has to be typed before the text is compiled, in seconds. Shorter, and every letter of a number is compiled; longer,
/// and the picture is felt to lag.
const QUIET: f64 = 0.05;

/// After so long it is said that the picture is of an older text, in seconds. Sooner, it would flicker at every letter.
const LONG: f64 = 0.6;

/// What a text became.
pub struct Compiled {
    /// The revision of the text.
    pub revision: u64,
    /// The scene with the recorded pixel, or what is wrong with the text.
    pub outcome: Result<Followed, Diagnostics>,
}

/// A scene that follows another.
pub struct Followed {
    /// The scene with all effects that it calls for.
    pub whole: Arc<Scene>,
    /// The scene as it is looked at.
    pub scene: Arc<Scene>,
    /// The pixel that was recorded.
    pub pixel: [u32; 2],
    /// What happened in it.
    pub tree: Arc<RayTree>,
    /// The event that stands where the selected one stood.
    pub selected: EventId,
    /// The events that are not what they were.
    pub changed: BTreeSet<EventId>,
}

/// What a text is compiled for.
pub struct Order {
    /// The text.
    pub text: String,
    /// Its revision.
    pub revision: u64,
    /// The scene's name, or its file's.
    pub name: String,
    /// Which files it may name.
    pub outside: Outside,
    /// How the scene is looked at.
    pub profile: Option<Profile>,
    /// The scene before, whole and as it is looked at: what was switched off in it stays off.
    pub open: Option<[Arc<Scene>; 2]>,
    /// The recorded pixel.
    pub pixel: Option<[u32; 2]>,
    /// What happened in it before, and which event is selected.
    pub before: Option<(Arc<RayTree>, EventId)>,
}

/// Compiles one text at a time, the newest as soon as the one before is done.
#[derive(Default)]
pub struct Live {
    job: Option<Background<Compiled>>,
    /// The revision that was last asked for.
    asked: Option<u64>,
    /// The revision that was last seen, and since when.
    seen: Option<(u64, f64)>,
}

impl Live {
    /// Forgets everything: this revision of another document is compiled already.
    pub fn reset(&mut self, revision: u64) {
        *self = Self { job: None, asked: Some(revision), seen: None };
    }

    /// Compiles the text if it is time to.
    pub fn follow(&mut self, ctx: &Context, revision: u64, order: impl FnOnce() -> Order) {
        if self.asked == Some(revision) {
            return;
        }
        let now = ctx.input(|input| input.time);
        let since = self.seen.filter(|(seen, _)| *seen == revision).map_or(now, |(_, since)| since);
        self.seen = Some((revision, since));
        let is_dragged = ctx.input(|input| input.pointer.any_down());
        let is_busy = self.job.as_ref().is_some_and(|job| !job.is_finished());
        if is_busy || (!is_dragged && now - since < QUIET) {
            ctx.request_repaint_after(Duration::from_secs_f64(QUIET / 2.0));
            return;
        }
        let order = order();
        self.asked = Some(revision);
        self.job = Background::start(ctx, "compile", move |_, publish| publish(order.compile()));
    }

    /// Whether the newest text has not been compiled for longer than a person overlooks.
    #[must_use]
    pub fn waits_long(&self, ctx: &Context) -> bool {
        let now = ctx.input(|input| input.time);
        self.seen.is_some_and(|(_, since)| now - since > LONG)
    }

    /// What the newest text became, once.
    pub fn take(&mut self) -> Option<Compiled> {
        let compiled = self.job.as_ref()?.take()?;
        self.job = None;
        Some(compiled)
    }
}

impl Order {
    fn compile(self) -> Compiled {
        let files = files_of_scene(&self.name, self.outside);
        let outcome = load_with(&self.text, &self.name, files.as_ref()).map(|whole| self.followed(whole));
        Compiled { revision: self.revision, outcome }
    }

    fn followed(&self, whole: Scene) -> Followed {
        let whole = Arc::new(whole);
        let look = |scene: &Arc<Scene>| {
            self.profile.as_ref().map_or_else(|| Scene::clone(scene), |profile| scene.with_profile(profile))
        };
        let looked_at = look(&whole);
        let off = self.open.as_ref().map(|[whole, shown]| look(whole).effects.apart_from(shown.effects));
        let effects = off.map_or(looked_at.effects, |off| looked_at.effects.apart_from(off));
        let scene = Arc::new(looked_at.with_effects(effects));
        let size = [scene.image.width, scene.image.height];
        let wanted = self.pixel.or_else(|| scene.pixels.first().copied()).unwrap_or(size.map(|pixels| pixels / 2));
        let pixel = [0, 1].map(|i| wanted[i].min(size[i].saturating_sub(1)));
        // A ray of its own stays the same ray.
        let ray = self.before.as_ref().and_then(|(before, _)| loose_ray(before));
        let tree = Arc::new(match ray {
            Some([origin, direction]) => record_ray(&scene, origin, direction),
            None => record_pixel(&scene, pixel[0], pixel[1]),
        });
        let (selected, changed) = match &self.before {
            Some((before, selected)) => (same_event(before, &tree, *selected), changed_events(before, &tree)),
            None => (0, BTreeSet::new()),
        };
        Followed { whole, scene, pixel, tree, selected, changed }
    }
}
