//! Opening scenes: they are read and compiled on a thread, and the one that is open stays in use until the new one is there.

use crate::app::edit::dialog::Then;
use crate::app::edit::recovery::Offer;
use crate::app::frame::background::Background;
use crate::app::frame::words::{say, say_with};
use crate::app::workbench::{OpenScene, Workbench};
use crate::folder::{Outside, files_of_scene};
use crate::scene::{EmbeddedScene, Scene, embedded_scene, embedded_scenes, load_with};
use crate::share::link::Link;
use egui::{Align2, Context, Id, Window, vec2};
use std::path::Path;
use std::sync::Arc;
use std::time::Duration;

/// After so long it is said that a scene is being opened, in seconds. Sooner, it would flicker at every scene.
const LONG: f64 = 0.4;

/// Where the text of a scene comes from.
pub enum Source {
    /// This is it.
    Text(String),
    /// From the file of the scene's name, or from the program.
    Named,
}

/// What is to be done with a scene once it is open.
pub enum After {
    /// No more.
    Nothing,
    /// What else a link asks for.
    Restore(Box<Link>),
    /// An edit that was left behind is taken up.
    TakeUp(Box<Offer>),
}

/// At most one scene that is being opened: another one takes its place.
#[derive(Default)]
pub struct Opening(Option<Job>);

struct Job {
    name: String,
    work: Background<Outcome>,
    after: After,
}

/// A text with its scene, or why there is none.
type Outcome = Result<(String, Arc<Scene>), Failure>;

enum Failure {
    Unreadable(String),
    Wrong(String),
}

impl Workbench {
    /// Whether a scene is being opened.
    #[must_use]
    pub const fn is_opening(&self) -> bool {
        self.opening.0.is_some()
    }

    /// Begins to open a scene, whatever becomes of the one that is open.
    pub(in crate::app) fn begin_opening(&mut self, ctx: &Context, name: &str, source: Source, after: After) {
        let (wanted, outside) = (name.to_owned(), self.outside);
        let work = move |_: &_, publish: &mut dyn FnMut(Outcome)| publish(open(&wanted, source, outside));
        let work = Background::start(ctx, "open", work);
        self.opening.0 = work.map(|work| Job { name: name.to_owned(), work, after });
    }

    /// Opens nothing any more: another scene takes the place of what was being opened.
    pub(in crate::app) fn give_up_opening(&mut self) {
        self.opening = Opening::default();
    }

    /// Once a frame: shows the scene that was opened, or what is wrong with it.
    pub(in crate::app) fn receive_opened(&mut self, ctx: &Context) {
        let Some(job) = &self.opening.0 else { return };
        let outcome = job.work.take();
        if outcome.is_none() && !job.work.is_finished() {
            return;
        }
        let Some(Job { name, after, .. }) = self.opening.0.take() else { return };
        match outcome {
            Some(Ok((text, scene))) => self.arrive_at(ctx, &name, &text, scene, after),
            Some(Err(failure)) => self.stay(ctx, &name, failure, after),
            None => {}
        }
    }

    fn arrive_at(&mut self, ctx: &Context, name: &str, text: &str, scene: Arc<Scene>, after: After) {
        let again = || match &after {
            After::Restore(link) => Then::Follow(link.clone()),
            After::Nothing | After::TakeUp(_) => Then::OpenText(name.to_owned(), text.to_owned()),
        };
        // Something may have been typed meanwhile.
        if !self.may_give_up(again) {
            return;
        }
        self.problem = self.problem.take().filter(|_| self.open.is_none());
        self.show_opened(ctx, name, text, scene);
        match after {
            After::Nothing => {}
            After::Restore(link) => self.restore(ctx, &link),
            After::TakeUp(offer) => self.take_up_edit(ctx, &offer),
        }
    }

    fn stay(&mut self, ctx: &Context, name: &str, failure: Failure, after: After) {
        let why = match failure {
            Failure::Unreadable(error) => unreadable(ctx, &error),
            Failure::Wrong(text) => text,
        };
        self.refuse(name, why);
        if let After::TakeUp(offer) = after {
            self.take_up_edit(ctx, &offer);
        } else if let Some(first) = first_scene().filter(|first| self.open.is_none() && first.name != name) {
            self.begin_opening(ctx, &first.name, Source::Named, After::Nothing);
        }
    }

    fn show_opened(&mut self, ctx: &Context, name: &str, text: &str, scene: Arc<Scene>) {
        self.image.reset();
        self.side.fit();
        self.renderer.start(ctx, &scene);
        let middle = [scene.image.width / 2, scene.image.height / 2];
        let pixel = scene.pixels.first().copied().unwrap_or(middle);
        self.effects.reset();
        self.accuracy.reset();
        let whole = Arc::clone(&scene);
        self.open = Some(OpenScene { name: name.to_owned(), scene, whole, look: None });
        self.editing.open(name, text);
        self.record(pixel);
    }

    /// Says what is being opened, where that takes long.
    pub(in crate::app) fn show_opening(&mut self, ctx: &Context) {
        let Some(Job { name, work, .. }) = &self.opening.0 else { return };
        if work.seconds() < LONG {
            ctx.request_repaint_after(Duration::from_secs_f64(LONG / 2.0));
            return;
        }
        let said = say_with(ctx, "opening", &[("name", name.into())]);
        let mut is_given_up = false;
        let window = Window::new(&said).id(Id::unique("opening")).title_bar(false).resizable(false);
        window.anchor(Align2::LEFT_BOTTOM, vec2(14.0, -14.0)).show(ctx, |ui| {
            ui.horizontal(|ui| {
                ui.label(&said);
                is_given_up = ui.button(say(ctx, "opening-cancel")).clicked();
            });
        });
        if is_given_up {
            self.opening.0 = None;
        }
    }
}

fn open(name: &str, source: Source, outside: Outside) -> Outcome {
    let text = match source {
        Source::Text(text) => text,
        Source::Named => read(name).map_err(Failure::Unreadable)?,
    };
    let scene = load_with(&text, name, files_of_scene(name, outside).as_ref());
    scene.map(|scene| (text, Arc::new(scene))).map_err(|diagnostics| Failure::Wrong(diagnostics.to_string()))
}

/// A file comes before the embedded scene of the same name.
fn read(name: &str) -> Result<String, String> {
    let path = Path::new(name);
    match embedded_scene(name).filter(|_| !path.is_file()) {
        Some(embedded) => Ok(embedded.text.to_owned()),
        None => std::fs::read_to_string(path).map_err(|error| error.to_string()),
    }
}

/// Why a file cannot be read, in a sentence.
pub fn unreadable(ctx: &Context, error: &str) -> String {
    say_with(ctx, "file-unreadable", &[("error", error.into())])
}

/// The scene for the first visit.
pub fn first_scene() -> Option<EmbeddedScene> {
    let mut scenes = embedded_scenes();
    let hello = scenes.iter().position(|scene| scene.name.starts_with("hello/")).unwrap_or(0);
    (hello < scenes.len()).then(|| scenes.swap_remove(hello))
}
