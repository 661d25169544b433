//! Recording pixels behind the window's back, so that no click makes it wait, however much its ray does.

use super::recording::Recording;
use crate::app::system;
use crate::scene::Scene;
use crate::story::{Breakpoints, Filter, Level};
use crate::trace::RayTree;
use egui::Context;
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::sync::{Arc, Weak};
use std::time::Duration;

/// A pixel to be recorded, and how it is to be told.
pub struct Wanted {
    /// The scene.
    pub scene: Arc<Scene>,
    /// The pixel.
    pub pixel: [u32; 2],
    /// How much is told.
    pub level: Level,
    /// What is looked for.
    pub filter: Filter,
    /// What is asked of every event.
    pub breakpoints: Breakpoints,
}

/// A pixel that was recorded.
pub struct Recorded {
    /// What happened, with the outcome selected.
    pub recording: Recording,
    /// The breakpoints with their answers.
    pub breakpoints: Breakpoints,
}

/// Records one pixel at a time. Of those that are asked for meanwhile only the newest is recorded.
#[derive(Default)]
pub struct Recorder {
    running: Option<(Arc<Scene>, Receiver<Recorded>)>,
    next: Option<Wanted>,
    /// The scene that was recorded last.
    seen: Weak<Scene>,
    /// Trees that nobody should see any more; dropping a large one takes longer than a frame has.
    retired: Vec<Arc<RayTree>>,
}

impl Recorder {
    /// Asks for a pixel. What was asked for in another scene is forgotten.
    pub fn ask(&mut self, ctx: &Context, wanted: Wanted) {
        let is_other = |(scene, _): &(Arc<Scene>, _)| !Arc::ptr_eq(scene, &wanted.scene);
        if self.running.as_ref().is_some_and(is_other) {
            self.running = None;
        }
        if self.running.is_some() {
            self.next = Some(wanted);
        } else {
            self.next = None;
            self.start(ctx, wanted);
        }
    }

    /// Forgets what was asked for.
    pub fn forget(&mut self) {
        (self.running, self.next) = (None, None);
    }

    /// Whether something is being recorded.
    #[must_use]
    pub fn is_busy(&self) -> bool {
        self.running.is_some()
    }

    /// What was recorded, if it is done within `patience`.
    pub fn receive(&mut self, ctx: &Context, patience: Duration) -> Option<Recorded> {
        let (_, receiver) = self.running.as_ref()?;
        let recorded = match system::receive_within(receiver, patience) {
            Ok(recorded) => Some(recorded),
            Err(RecvTimeoutError::Timeout) => return None,
            Err(RecvTimeoutError::Disconnected) => None,
        };
        self.running = None;
        if let Some(next) = self.next.take() {
            self.start(ctx, next);
        }
        recorded
    }

    /// Takes a tree that is no longer shown, to be dropped when nobody looks at it any more.
    pub fn retire(&mut self, tree: Arc<RayTree>) {
        self.retired.push(tree);
    }

    /// Drops what nobody looks at any more, in a thread of its own.
    pub fn bury(&mut self) {
        let gone: Vec<_> = self.retired.extract_if(.., |tree| Arc::strong_count(tree) == 1).collect();
        if !gone.is_empty() {
            // Where no thread can be started it is dropped here.
            system::begin("drop", move || drop(gone));
        }
    }

    fn start(&mut self, ctx: &Context, wanted: Wanted) {
        let (sender, receiver) = channel();
        let (scene, ctx) = (Arc::clone(&wanted.scene), ctx.clone());
        let work = move || {
            // Whoever asked may have gone away meanwhile.
            let _ = sender.send(record(wanted));
            ctx.request_repaint();
        };
        // Whoever clicks waits for it; a new scene brings so much else that its first recording has a turn of its own.
        let is_click = self.seen.ptr_eq(&Arc::downgrade(&scene));
        let has_begun = if is_click { system::begin_at_once("record", work) } else { system::begin("record", work) };
        self.seen = Arc::downgrade(&scene);
        self.running = has_begun.then_some((scene, receiver));
    }
}

fn record(wanted: Wanted) -> Recorded {
    let Wanted { scene, pixel, level, filter, mut breakpoints } = wanted;
    let mut recording = Recording::told(&scene, pixel, level, filter);
    breakpoints.ask(&recording.tree);
    recording.select_outcome();
    Recorded { recording, breakpoints }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{embedded_scene, load};

    const PATIENCE: Duration = Duration::from_mins(1);

    fn scene() -> Arc<Scene> {
        Arc::new(load(embedded_scene("hello/sphere").unwrap().text, "hello/sphere").unwrap())
    }

    fn wanted(scene: &Arc<Scene>, pixel: [u32; 2]) -> Wanted {
        let (level, filter, breakpoints) = (Level::Story, Filter::default(), Breakpoints::default());
        Wanted { scene: Arc::clone(scene), pixel, level, filter, breakpoints }
    }

    #[test]
    fn of_what_is_asked_for_meanwhile_only_the_newest_is_recorded() {
        let (ctx, scene, mut recorder) = (Context::default(), scene(), Recorder::default());
        for x in 0..5 {
            recorder.ask(&ctx, wanted(&scene, [x, 0]));
        }
        let mut pixels = Vec::new();
        while let Some(recorded) = recorder.receive(&ctx, PATIENCE) {
            pixels.push(recorded.recording.pixel);
        }
        assert_eq!(pixels, [[0, 0], [4, 0]]);
        assert!(!recorder.is_busy());
    }

    #[test]
    fn a_pixel_of_another_scene_is_forgotten() {
        let (ctx, mut recorder) = (Context::default(), Recorder::default());
        recorder.ask(&ctx, wanted(&scene(), [1, 1]));
        let second = scene();
        recorder.ask(&ctx, wanted(&second, [2, 2]));
        let recorded = recorder.receive(&ctx, PATIENCE).unwrap();
        assert_eq!(recorded.recording.pixel, [2, 2]);
        assert!(Arc::ptr_eq(&recorded.recording.scene, &second));
        assert!(recorder.receive(&ctx, Duration::ZERO).is_none());
    }

    #[test]
    fn a_retired_tree_stays_as_long_as_somebody_looks_at_it() {
        let (ctx, mut recorder) = (Context::default(), Recorder::default());
        recorder.ask(&ctx, wanted(&scene(), [1, 1]));
        let tree = Arc::clone(&recorder.receive(&ctx, PATIENCE).unwrap().recording.tree);
        recorder.retire(Arc::clone(&tree));
        recorder.bury();
        assert_eq!(recorder.retired.len(), 1);
        drop(tree);
        recorder.bury();
        assert!(recorder.retired.is_empty());
    }
}
