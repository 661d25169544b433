//! The state of the workbench: what is open, what is recorded, what is selected.

use crate::app::accuracy::pane::{AccuracyPane, Wish};
use crate::app::command::Command;
use crate::app::compare::pane::ComparePane;
use crate::app::dock::Dock;
use crate::app::drawings::all::Drawings;
use crate::app::drawings::plots::PlotsPanel;
use crate::app::drawings::side::SidePanel;
use crate::app::edit::dialog::Then;
use crate::app::edit::editing::Editing;
use crate::app::effects::pane::EffectsPane;
use crate::app::frame::file_dialog::FileDialog;
use crate::app::frame::scene_menu::SceneMenu;
use crate::app::frame::theme;
use crate::app::frame::words::say;
use crate::app::help::Help;
use crate::app::kept::{self, Kept};
use crate::app::lesson::LessonPane;
use crate::app::opening::{After, Opening, Source, unreadable};
use crate::app::pane::Pane;
use crate::app::picture::panel::ImagePanel;
use crate::app::picture::renderer::Renderer;
use crate::app::search::pane::{Place, SearchPane};
use crate::app::settings::Settings;
use crate::app::share::Sharing;
use crate::app::story::recording::Recording;
use crate::app::story::stepping::Stepping;
use crate::app::story::timeline::Timeline;
use crate::app::system::{Picked, Unread};
use crate::folder::Outside;
use crate::record::EventId;
use crate::scene::{Effects, Profile, Scene};
use crate::trace::record_ray;
use egui::Context;
use std::sync::Arc;

/// The scene that is open.
pub struct OpenScene {
    /// Its name, or its file's.
    pub name: String,
    /// The scene, with the effects that are switched on.
    pub scene: Arc<Scene>,
    /// The scene as it was loaded, with all effects that it calls for.
    pub whole: Arc<Scene>,
    /// How it is looked at, if not as it stands.
    pub look: Option<Look>,
}

/// A way to look at a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Look {
    /// Its settings in words.
    pub name: String,
    /// Its settings.
    pub profile: Profile,
}

/// Why a scene could not be opened.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// What could not be done, as a message of the catalogue that takes the name.
    pub title: &'static str,
    /// The scene's name, or its file's.
    pub name: String,
    /// Everything that is wrong with it.
    pub text: String,
}

impl OpenScene {
    /// The whole scene in the way that it is looked at.
    #[must_use]
    pub fn looked_at(&self) -> Scene {
        self.look.as_ref().map_or_else(|| Scene::clone(&self.whole), |look| self.whole.with_profile(&look.profile))
    }
}

/// The state of the workbench.
pub struct Workbench {
    pub(in crate::app) open: Option<OpenScene>,
    pub(in crate::app) problem: Option<Problem>,
    pub(in crate::app) recording: Option<Recording>,
    pub(in crate::app) stepping: Stepping,
    pub(in crate::app) timeline: Timeline,
    pub(in crate::app) renderer: Renderer,
    pub(in crate::app) menu: SceneMenu,
    pub(in crate::app) dialog: FileDialog,
    pub(in crate::app) image: ImagePanel,
    pub(in crate::app) side: SidePanel,
    pub(in crate::app) plots: PlotsPanel,
    pub(in crate::app) drawings: Drawings,
    pub(in crate::app) effects: EffectsPane,
    pub(in crate::app) accuracy: AccuracyPane,
    pub(in crate::app) search: SearchPane,
    pub(in crate::app) compare: ComparePane,
    pub(in crate::app) dock: Dock,
    pub(in crate::app) settings: Settings,
    pub(in crate::app) editing: Editing,
    pub(in crate::app) outside: Outside,
    pub(in crate::app) help: Help,
    pub(in crate::app) sharing: Sharing,
    pub(in crate::app) opening: Opening,
    pub(in crate::app) lesson: LessonPane,
    /// Whether it stands in the frame of another page, which says what is seen.
    pub(in crate::app) is_embedded: bool,
    ctx: Context,
}

impl Workbench {
    /// A workbench that opens a scene. If the scene has errors, they are shown beside the scene for the first visit.
    #[must_use]
    pub fn new(ctx: &Context, name: &str, text: &str, outside: Outside) -> Self {
        theme::install(ctx);
        let mut workbench = Self {
            open: None,
            problem: None,
            recording: None,
            stepping: Stepping::default(),
            timeline: Timeline::default(),
            renderer: Renderer::default(),
            menu: SceneMenu::default(),
            dialog: FileDialog::default(),
            image: ImagePanel::default(),
            side: SidePanel::default(),
            plots: PlotsPanel::default(),
            drawings: Drawings::default(),
            effects: EffectsPane::default(),
            accuracy: AccuracyPane::default(),
            search: SearchPane::default(),
            compare: ComparePane::default(),
            dock: Dock::default(),
            settings: Settings::default(),
            editing: Editing::default(),
            help: Help::default(),
            sharing: Sharing::default(),
            opening: Opening::default(),
            lesson: LessonPane::default(),
            is_embedded: false,
            outside,
            ctx: ctx.clone(),
        };
        workbench.begin_opening(ctx, name, Source::Text(text.to_owned()), After::Nothing);
        workbench
    }

    /// Opens a file, or the embedded scene of that name; until it is there, the old scene stays, and longer if the new one has
    /// errors, which are shown. If there are unsaved changes, it is asked first.
    pub fn open_scene(&mut self, ctx: &Context, name: &str) {
        if self.may_give_up(|| Then::Open(name.to_owned())) {
            self.begin_opening(ctx, name, Source::Named, After::Nothing);
        }
    }

    /// Opens the text of a scene file, likewise.
    pub fn open_text(&mut self, ctx: &Context, name: &str, text: &str) {
        if self.may_give_up(|| Then::OpenText(name.to_owned(), text.to_owned())) {
            self.begin_opening(ctx, name, Source::Text(text.to_owned()), After::Nothing);
        }
    }

    pub(in crate::app) fn refuse(&mut self, name: &str, text: String) {
        self.problem = Some(Problem { title: "problem-title", name: name.to_owned(), text });
    }

    /// Says why a file is not saved.
    pub(in crate::app) fn refuse_to_save(&mut self, name: &str, text: String) {
        self.problem = Some(Problem { title: "problem-unsaved", name: name.to_owned(), text });
    }

    /// Switches effects on and off: the picture is rendered and the pixel recorded anew.
    pub(in crate::app) fn switch(&mut self, ctx: &Context, effects: Effects) {
        let Some(open) = &mut self.open else { return };
        open.scene = Arc::new(open.looked_at().with_effects(effects));
        self.renew(ctx);
    }

    /// Looks at the scene in another way, or as it stands. All effects that it then calls for are on.
    pub fn look(&mut self, ctx: &Context, look: Option<Look>) {
        let Some(open) = &mut self.open else { return };
        open.look = look;
        open.scene = Arc::new(open.looked_at());
        self.renew(ctx);
    }

    /// Renders the picture and records the pixel anew.
    fn renew(&mut self, ctx: &Context) {
        let Some(open) = &self.open else { return };
        self.renderer.start(ctx, &open.scene);
        match self.recording.as_ref().map(|recording| (recording.pixel, recording.loose_ray())) {
            Some((pixel, Some([origin, direction]))) => {
                let scene = Arc::clone(&open.scene);
                let tree = Arc::new(record_ray(&scene, origin, direction));
                self.show_elsewhere(Recording::of_tree(scene, pixel, tree, None));
            }
            Some((pixel, None)) => self.record(pixel),
            None => {}
        }
    }

    /// Does what the accuracy window asks for.
    pub(in crate::app) fn grant(&mut self, ctx: &Context, wish: Wish) {
        match wish {
            Wish::Look(name, profile) => self.look(ctx, Some(Look { name, profile })),
            Wish::AsItStands => self.look(ctx, None),
            Wish::Story(method, tree, event) => {
                let Some(recording) = &self.recording else { return };
                let is_shown = recording.by == Some(method) && *recording.tree == *tree;
                if !is_shown {
                    let (scene, pixel) = (Arc::clone(&recording.scene), recording.pixel);
                    self.show_elsewhere(Recording::of_tree(scene, pixel, tree, Some(method)));
                }
                self.select(event);
            }
        }
    }

    /// Brings a panel to the front.
    pub fn reveal(&mut self, pane: Pane) {
        self.dock.reveal(pane);
    }

    /// Offers the tour, unless it was taken or passed over before.
    pub fn offer_tour(&mut self) {
        if !self.settings.is_toured {
            self.help = Help::tour();
        }
    }

    /// Runs a command, as its menu or key does.
    pub fn run(&mut self, command: Command) {
        let ctx = self.ctx();
        command.run(self, &ctx);
    }

    /// What the workbench is shown in.
    #[must_use]
    pub fn ctx(&self) -> Context {
        self.ctx.clone()
    }

    /// The scene that is open.
    #[must_use]
    pub fn scene(&self) -> Option<&OpenScene> {
        self.open.as_ref()
    }

    /// How the story is stepped through.
    #[must_use]
    pub const fn stepping(&self) -> &Stepping {
        &self.stepping
    }

    /// The recorded pixel.
    #[must_use]
    pub fn recording(&self) -> Option<&Recording> {
        self.recording.as_ref()
    }

    /// Why the last scene could not be opened.
    #[must_use]
    pub fn problem(&self) -> Option<&Problem> {
        self.problem.as_ref()
    }

    /// Whether the picture is complete.
    #[must_use]
    pub fn picture_finished(&self) -> bool {
        self.renderer.finished()
    }

    /// Where the panels lie.
    #[must_use]
    pub const fn dock(&self) -> &Dock {
        &self.dock
    }

    /// What a person has set.
    #[must_use]
    pub const fn settings(&self) -> Settings {
        self.settings
    }

    /// What is kept from one start to the next, as text.
    #[must_use]
    pub fn keep(&self) -> String {
        kept::write(&self.dock, self.settings, &self.lesson.progress)
    }

    /// Takes up what was kept. A text that makes no sense is passed over.
    pub fn take_up(&mut self, text: &str) {
        if let Some(Kept { dock, settings, progress }) = kept::read(text) {
            (self.dock, self.settings, self.lesson.progress) = (dock, settings, progress);
        }
    }

    /// Records the pixel of a place, if it is not the recorded one, and then selects its event.
    pub(in crate::app) fn go_to(&mut self, place: Place) {
        let is_there = self.recording.as_ref().is_some_and(|recording| recording.pixel == place.pixel);
        if !is_there || self.stepping.is_recording() {
            self.record(place.pixel);
        }
        self.search.awaited = Some(place);
        self.arrive();
    }

    /// Selects the event of the place that was gone to, once its pixel is there.
    pub(in crate::app) fn arrive(&mut self) {
        if self.stepping.is_recording() {
            return;
        }
        let Some(Place { pixel, event: Some(event) }) = self.search.awaited.take() else { return };
        if self.recording.as_ref().is_some_and(|recording| recording.pixel == pixel) {
            self.select(event);
        }
    }

    /// Finding pixels, and maps.
    #[must_use]
    pub const fn search(&self) -> &SearchPane {
        &self.search
    }

    /// Finds the pixels in whose stories a question holds of an event.
    pub fn find(&mut self, question: &str) {
        self.reveal(Pane::Search);
        self.search.ask(question);
    }

    /// Selects an event of the recorded pixel.
    pub fn select(&mut self, event: EventId) {
        if let Some(recording) = &mut self.recording {
            recording.select(event);
        }
    }

    /// Stands in the frame of another page from now on. What a step is shown for are its story and its drawings; a lesson needs more.
    pub fn embed(&mut self, shows_lesson: bool) {
        self.is_embedded = true;
        self.help = Help::None;
        if !shows_lesson {
            use Pane::{Accuracy, Compare, Editor, Effects, Lesson, Properties, Search};
            self.dock.leave_out(&[Lesson, Properties, Editor, Search, Compare, Effects, Accuracy]);
        }
    }

    /// Whether it shows a step within somebody's page, and nothing else: a lesson is worked through there, too.
    #[must_use]
    pub const fn is_read_only(&self) -> bool {
        self.is_embedded && self.lesson.open.is_none()
    }

    /// Opens what was dropped on the window or chosen in the dialogue.
    pub(in crate::app) fn take_files(&mut self, ctx: &Context) {
        let dropped = ctx.input(|input| input.raw.dropped_files.first().cloned());
        if let Some(file) = dropped.filter(|_| !self.is_read_only()) {
            self.dialog.take(ctx, &file);
        }
        if let Some(picked) = self.dialog.chosen() {
            self.open_picked(ctx, picked);
        }
        if self.compare.take_file() {
            self.dock.reveal(Pane::Compare);
        }
    }

    fn open_picked(&mut self, ctx: &Context, picked: Picked) {
        let is_foreign = picked.ends_in("jsonl");
        let Picked { name, text } = picked;
        match text {
            None => self.open_scene(ctx, &name),
            Some(Ok(text)) if is_foreign => self.open_foreign(&name, &text),
            Some(Ok(text)) => self.open_text(ctx, &name, &text),
            Some(Err(Unread::NoText)) => self.refuse(&name, say(ctx, "file-no-text")),
            Some(Err(Unread::System(error))) => self.refuse(&name, unreadable(ctx, &error)),
            Some(Err(Unread::NoDialogue)) => {
                let text = say(ctx, "file-no-dialogue-to-open");
                self.problem = Some(Problem { title: "problem-no-dialogue", name, text });
            }
        }
    }
}
