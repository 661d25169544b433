//! What stepping needs beside the recorded pixel: how much is told of it and of the next ones, where to stop, how fast to play.

use super::recorder::{Recorded, Recorder, Wanted};
use super::recording::Recording;
use super::until::Until;
use crate::app::frame::background::Background;
use crate::app::frame::task;
use crate::app::pane::Pane;
use crate::app::workbench::Workbench;
use crate::record::EventId;
use crate::story::{Breakpoints, Cut, Filter, Level, Player, Step};
use crate::trace::RayTree;
use egui::Context;
use std::sync::Arc;
use std::time::Duration;

/// So long a click waits for its tree, that it be there at once where it takes less than a frame.
const FRAME: Duration = Duration::from_millis(16);

/// From so many events on, words are looked for in the background.
const MANY_EVENTS: usize = 5_000;

/// What can be opened below the toolbar, one at a time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Drawer {
    /// Which events are looked for.
    Filter,
    /// Where stepping stops.
    Breakpoints,
    /// The number of the step to go to.
    Jump,
    /// What was skipped, cut off or rejected.
    LeftOut,
}

/// Which events meet a filter, worked out in the background.
struct Sifted {
    tree: Arc<RayTree>,
    filter: Filter,
    matches: Option<Vec<bool>>,
}

/// The state of stepping.
#[derive(Default)]
pub struct Stepping {
    pub(in crate::app) level: Level,
    pub(in crate::app) filter: Filter,
    pub(super) breakpoints: Breakpoints,
    pub(in crate::app) player: Player,
    pub(in crate::app) drawer: Option<Drawer>,
    /// The drawer was opened by a command, and its field wants the focus.
    pub(super) wants_focus: bool,
    /// What is being typed in the fields.
    pub(super) question: String,
    pub(super) question_problem: Option<String>,
    pub(super) jump: String,
    /// What is listed of what was left out, if one kind was chosen.
    pub(super) cut: Option<Cut>,
    /// A message to be shown, by its name in the catalogue of words.
    pub(super) note: Option<&'static str>,
    recorder: Recorder,
    sifting: Option<Background<Sifted>>,
    until: Option<Background<Option<[u32; 2]>>>,
    /// When it was last played on, by the clock of the frames.
    played_at: Option<f64>,
    /// The next pixel that is recorded stops at its first breakpoint.
    goes_to_stop: bool,
}

impl Stepping {
    /// How much of each story is told.
    #[must_use]
    pub const fn level(&self) -> Level {
        self.level
    }

    /// Where stepping stops.
    #[must_use]
    pub const fn breakpoints(&self) -> &Breakpoints {
        &self.breakpoints
    }

    /// Whether it plays.
    #[must_use]
    pub fn is_playing(&self) -> bool {
        self.player.is_playing()
    }

    /// Whether a pixel is being recorded, or events or pixels are looked for.
    #[must_use]
    pub fn is_busy(&self) -> bool {
        self.recorder.is_busy() || self.sifting.is_some() || self.until.is_some()
    }

    /// Whether a pixel is being recorded.
    #[must_use]
    pub fn is_recording(&self) -> bool {
        self.recorder.is_busy()
    }

    /// How many pixels the search for a stop has gone through; none if there is no such search.
    pub(super) fn pixels_searched(&self) -> Option<usize> {
        self.until.as_ref().map(Background::done)
    }

    /// Opens a drawer with its field focused, or closes it.
    pub(in crate::app) fn toggle(&mut self, drawer: Drawer) {
        self.drawer = (self.drawer != Some(drawer)).then_some(drawer);
        // What one drawer led to says nothing about the next.
        self.note = None;
        self.wants_focus = self.drawer.is_some();
    }

    /// Ends the search for a stop.
    pub(in crate::app) fn cancel_search(&mut self) {
        self.until = None;
    }
}

impl Workbench {
    /// Records a pixel and shows its story: at once, or as soon as it is there.
    pub fn record(&mut self, pixel: [u32; 2]) {
        let ctx = self.ctx();
        let Some(open) = &self.open else { return };
        let stepping = &mut self.stepping;
        let wanted = Wanted {
            scene: Arc::clone(&open.scene),
            pixel,
            level: stepping.level,
            filter: stepping.filter.clone(),
            breakpoints: stepping.breakpoints.clone(),
        };
        stepping.recorder.ask(&ctx, wanted);
        self.receive_recording(FRAME);
    }

    /// Whether a scene is being opened, a pixel recorded, or events or pixels are looked for.
    #[must_use]
    pub fn is_busy(&self) -> bool {
        self.is_opening() || self.stepping.is_busy()
    }

    /// Shows a recording in place of the one before.
    pub(in crate::app) fn show_recording(&mut self, mut recording: Recording) {
        let stops = self.stepping.breakpoints.stops();
        let first = stops.first().copied().filter(|_| std::mem::take(&mut self.stepping.goes_to_stop));
        recording.change(|story| {
            story.set_stops(stops);
            if let Some(event) = first {
                story.select(event);
            }
        });
        if let Some(old) = self.recording.replace(recording) {
            self.stepping.recorder.retire(Arc::clone(&old.tree));
        }
    }

    /// The same for a tree that was recorded elsewhere: the breakpoints are asked first.
    pub(in crate::app) fn show_elsewhere(&mut self, recording: Recording) {
        // A pixel that was asked for before would take its place.
        self.stepping.recorder.forget();
        self.stepping.breakpoints.ask(&recording.tree);
        let told = recording.told_as(self.stepping.level, self.stepping.filter.clone());
        self.show_recording(told);
    }

    fn receive_recording(&mut self, patience: Duration) {
        let ctx = self.ctx();
        if let Some(Recorded { mut recording, breakpoints }) = self.stepping.recorder.receive(&ctx, patience) {
            self.stepping.breakpoints.take_hits(breakpoints);
            // What was changed while it was recorded.
            if recording.story().level() != self.stepping.level || *recording.story().filter() != self.stepping.filter {
                recording = recording.told_as(self.stepping.level, self.stepping.filter.clone());
            }
            self.show_recording(recording);
        }
    }

    /// Once a frame: takes in what was done in the background, and plays on.
    pub(in crate::app) fn advance_story(&mut self, ctx: &Context) {
        self.receive_recording(Duration::ZERO);
        self.stepping.recorder.bury();
        self.receive_sifted();
        self.receive_found();
        self.play_on(ctx);
    }

    fn receive_sifted(&mut self) {
        let Some(sifting) = &self.stepping.sifting else { return };
        let (sifted, finished) = (sifting.take(), sifting.is_finished());
        if let (Some(sifted), Some(recording)) = (sifted, &mut self.recording)
            && Arc::ptr_eq(&sifted.tree, &recording.tree)
            && sifted.filter == self.stepping.filter
        {
            recording.change(|story| story.set_filter(sifted.filter, sifted.matches));
        }
        if finished {
            self.stepping.sifting = None;
        }
    }

    fn receive_found(&mut self) {
        let Some(found) = self.stepping.until.as_ref().and_then(Background::take) else { return };
        self.stepping.until = None;
        match found {
            Some(pixel) => {
                self.stepping.goes_to_stop = true;
                self.record(pixel);
            }
            None => self.stepping.note = Some("step-until-none"),
        }
    }

    fn play_on(&mut self, ctx: &Context) {
        let player = &mut self.stepping.player;
        let Some(recording) = self.recording.as_mut().filter(|_| player.is_playing()) else { return };
        // Frames come when something is to be done, so that only the time itself says how long ago the last one was.
        let now = ctx.input(|input| input.time);
        let passed = self.stepping.played_at.replace(now).map_or(0.0, |before| now - before);
        let steps = player.advance(passed);
        if steps > 0 && recording.change(|story| story.play(steps)) {
            player.set_playing(false);
        } else {
            ctx.request_repaint_after(Duration::from_secs_f64(player.wait()));
        }
    }

    /// Begins to play, or pauses. At the end it begins anew.
    pub(in crate::app) fn toggle_play(&mut self) {
        let Some(recording) = &mut self.recording else { return };
        let player = &mut self.stepping.player;
        player.set_playing(!player.is_playing());
        self.stepping.played_at = None;
        if player.is_playing() && recording.story().target(Step::Next).is_none() {
            recording.step(Step::First);
        }
    }

    /// Tells more or less of the story.
    pub fn set_level(&mut self, level: Level) {
        self.stepping.level = level;
        if let Some(recording) = &mut self.recording {
            recording.change(|story| story.set_level(level));
        }
    }

    /// Looks for events. The words of many rows are gone through in the background.
    pub fn set_filter(&mut self, filter: Filter) {
        self.stepping.filter = filter.clone();
        self.stepping.sifting = None;
        let Some(recording) = &mut self.recording else { return };
        if filter.text.trim().is_empty() || recording.tree.events.len() < MANY_EVENTS {
            let matches = filter.matches(&recording.tree, recording.story().index());
            recording.change(|story| story.set_filter(filter, matches));
            return;
        }
        let (tree, index) = (Arc::clone(&recording.tree), Arc::clone(recording.story().index()));
        self.stepping.sifting = Background::start(&self.ctx(), "filter", move |_, publish| {
            let matches = filter.matches(&tree, &index);
            publish(Sifted { tree, filter, matches });
        });
    }

    /// Changes the breakpoints; stepping stops by the new ones from now on.
    pub fn change_breakpoints<T>(&mut self, change: impl FnOnce(&mut Breakpoints, Option<&RayTree>) -> T) -> T {
        let tree = self.recording.as_ref().map(|recording| Arc::clone(&recording.tree));
        let outcome = change(&mut self.stepping.breakpoints, tree.as_deref());
        let stops = self.stepping.breakpoints.stops();
        if let Some(recording) = &mut self.recording {
            recording.change(|story| story.set_stops(stops));
        }
        outcome
    }

    /// Goes through the pixels after this one to the first at which a breakpoint stops.
    pub(in crate::app) fn record_until(&mut self) {
        let questions = self.stepping.breakpoints.questions();
        let (Some(open), Some(recording)) = (&self.open, &self.recording) else { return };
        if questions.is_empty() {
            self.stepping.note = Some("step-until-nothing-on");
            self.stepping.drawer = Some(Drawer::Breakpoints);
            return;
        }
        let until = Until { from: recording.pixel, questions };
        self.stepping.until = task::begin(&self.ctx(), &open.scene, until);
        self.stepping.note = None;
    }

    /// Goes to the n-th step of this level and filter, counted from 1; returns whether there is one.
    pub(in crate::app) fn jump_to(&mut self, n: usize) -> bool {
        let Some(recording) = &mut self.recording else { return false };
        let event: Option<EventId> = recording.story().nth(n);
        if let Some(event) = event {
            recording.select(event);
        }
        event.is_some()
    }

    /// Opens a drawer below the story's toolbar, or closes it.
    pub(in crate::app) fn toggle_drawer(&mut self, drawer: Drawer) {
        self.dock.reveal(Pane::Story);
        self.stepping.toggle(drawer);
    }
}
