//! The whole window on `egui` alone: what is open, what is selected, and where the panels lie.

use super::file_dialog::FileDialog;
use super::image_panel::{ImagePanel, ImageView};
use super::panel::panel;
use super::plots_panel::PlotsPanel;
use super::recording::Recording;
use super::renderer::Renderer;
use super::scene_menu::{Choice, SceneMenu};
use super::side_panel::SidePanel;
use super::split::{Direction, GAP, split};
use super::theme::Palette;
use super::{detail_panel, problem, theme, toolbar, top_bar, tree_panel};
use crate::record::EventId;
use crate::scene::{EmbeddedScene, Scene, embedded_scene, embedded_scenes, load};
use egui::{Context, Rect, RichText, Ui, UiBuilder};
use std::path::Path;
use std::sync::Arc;

/// The scene that is open.
pub struct OpenScene {
    /// Its name, or its file's.
    pub name: String,
    /// The scene.
    pub scene: Arc<Scene>,
}

/// Why a scene could not be opened.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// The scene's name, or its file's.
    pub name: String,
    /// Everything that is wrong with it.
    pub text: String,
}

/// The state of the workbench.
pub struct Workbench {
    open: Option<OpenScene>,
    problem: Option<Problem>,
    recording: Option<Recording>,
    renderer: Renderer,
    menu: SceneMenu,
    dialog: FileDialog,
    image: ImagePanel,
    side: SidePanel,
    plots: PlotsPanel,
    shares: Shares,
}

/// How the window is divided: shares from 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shares {
    /// The left column's share of the width.
    pub left: f32,
    /// The outline's share of what is left.
    pub outline: f32,
    /// The picture's share of the left column's height.
    pub picture: f32,
    /// The detail's share of the right column's height.
    pub detail: f32,
}

impl Default for Shares {
    fn default() -> Self {
        Self { left: 0.35, outline: 0.52, picture: 0.5, detail: 0.48 }
    }
}

impl Workbench {
    /// A workbench with a scene open. If the scene has errors, they are shown beside the scene for the first visit.
    #[must_use]
    pub fn new(ctx: &Context, name: &str, text: &str) -> Self {
        theme::install(ctx);
        let mut workbench = Self {
            open: None,
            problem: None,
            recording: None,
            renderer: Renderer::default(),
            menu: SceneMenu::default(),
            dialog: FileDialog::default(),
            image: ImagePanel::default(),
            side: SidePanel::default(),
            plots: PlotsPanel::default(),
            shares: Shares::default(),
        };
        workbench.open_text(ctx, name, text);
        if workbench.open.is_none() {
            let problem = workbench.problem.take();
            if let Some(first) = first_scene() {
                workbench.open_text(ctx, &first.name, first.text);
            }
            workbench.problem = problem.or(workbench.problem);
        }
        workbench
    }

    /// Opens a file, or the embedded scene of that name. If it has errors, they are shown and the old scene stays.
    pub fn open_scene(&mut self, ctx: &Context, name: &str) {
        let path = Path::new(name);
        if let Some(embedded) = embedded_scene(name).filter(|_| !path.is_file()) {
            self.open_text(ctx, name, embedded.text);
            return;
        }
        match std::fs::read_to_string(path) {
            Ok(text) => self.open_text(ctx, name, &text),
            Err(error) => self.refuse(name, format!("The file cannot be read: {error}.")),
        }
    }

    /// Opens the text of a scene file. If it has errors, they are shown and the old scene stays.
    pub fn open_text(&mut self, ctx: &Context, name: &str, text: &str) {
        let scene = match load(text, name) {
            Ok(scene) => Arc::new(scene),
            Err(diagnostics) => {
                self.refuse(name, diagnostics.to_string());
                return;
            }
        };
        self.problem = None;
        self.image.reset();
        self.side.fit();
        self.renderer.start(ctx, &scene);
        let middle = [scene.image.width / 2, scene.image.height / 2];
        let pixel = scene.pixels.first().copied().unwrap_or(middle);
        self.open = Some(OpenScene { name: name.to_owned(), scene });
        self.record(pixel);
    }

    fn refuse(&mut self, name: &str, text: String) {
        self.problem = Some(Problem { name: name.to_owned(), text });
    }

    /// Records a pixel and shows its story.
    pub fn record(&mut self, pixel: [u32; 2]) {
        let Some(open) = &self.open else { return };
        let mut recording = Recording::new(&open.scene, pixel);
        recording.select_outcome();
        self.recording = Some(recording);
    }

    /// The scene that is open.
    #[must_use]
    pub fn scene(&self) -> Option<&OpenScene> {
        self.open.as_ref()
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

    /// How the window is divided.
    #[must_use]
    pub fn shares(&self) -> Shares {
        self.shares
    }

    /// Divides the window.
    pub fn set_shares(&mut self, shares: Shares) {
        self.shares = shares;
    }

    /// Selects an event of the recorded pixel.
    pub fn select(&mut self, event: EventId) {
        if let Some(recording) = &mut self.recording {
            recording.select(event);
        }
    }

    /// Shows the workbench in all of `ui` and lets it be used.
    pub fn ui(&mut self, ui: &mut Ui) {
        self.take_files(ui.ctx());
        let palette = Palette::current(ui.ctx());
        let whole = ui.max_rect();
        ui.painter().rect_filled(whole, 0.0, palette.window);
        let (bar, below) = whole.split_top_bottom_at_y(whole.top() + top_bar::height(self.open.as_ref()));
        self.top_bar(ui, bar);
        let mut below = below.shrink(GAP);
        if let Some(problem) = &self.problem {
            let (band, rest) = below.split_top_bottom_at_y(below.top() + problem::height(problem, below.height()));
            if problem::ui(ui, band, problem, self.open.as_ref()) {
                self.problem = None;
            }
            below = rest.with_min_y(rest.top() + GAP);
        }
        self.panels(ui, below);
    }

    fn top_bar(&mut self, ui: &mut Ui, bar: Rect) {
        let pixel = self.recording.as_ref().map(|recording| recording.pixel);
        let builder = UiBuilder::new().id_salt("top bar").max_rect(bar);
        let action = ui.scope_builder(builder, |ui| top_bar::ui(ui, &self.menu, self.open.as_ref(), pixel)).inner;
        match action {
            Some(top_bar::Action::Choose(Choice::Embedded(name))) => self.open_scene(ui.ctx(), &name),
            Some(top_bar::Action::Choose(Choice::OpenFile)) => self.dialog.open(ui.ctx()),
            Some(top_bar::Action::Record(pixel)) => self.record(pixel),
            None => {}
        }
    }

    fn panels(&mut self, ui: &mut Ui, rect: Rect) {
        let (beside, below) = (Direction::Beside, Direction::Below);
        let mut shares = self.shares;
        let (left, rest) = split(ui, "Width of the picture", rect, beside, &mut shares.left, 280.0);
        let (middle, right) = split(ui, "Width of the outline", rest, beside, &mut shares.outline, 280.0);
        let (picture, side) = split(ui, "Height of the picture", left, below, &mut shares.picture, 140.0);
        let (detail, plots) = split(ui, "Height of the detail", right, below, &mut shares.detail, 140.0);
        self.shares = shares;
        self.picture_panel(ui, picture);
        self.side_panel(ui, side);
        self.outline_panel(ui, middle);
        panel(ui, detail, "Selected event", |_| {}, |ui| detail_panel::ui(ui, self.recording.as_ref()));
        let mut clicked = None;
        panel(ui, plots, "Along the ray", |_| {}, |ui| clicked = self.plots.ui(ui, self.recording.as_ref()));
        if let Some(event) = clicked {
            self.select(event);
        }
    }

    fn picture_panel(&mut self, ui: &mut Ui, rect: Rect) {
        let Some(open) = &self.open else {
            panel(ui, rect, "Picture", |_| {}, |ui| super::panel::empty(ui, "No scene is open."));
            return;
        };
        let texture = self.renderer.texture(ui.ctx()).cloned();
        let state = progress(ui.ctx(), &self.renderer, &open.scene);
        let mut chosen = None;
        let view = ImageView { scene: &open.scene, texture, recording: self.recording.as_ref() };
        let tools = |ui: &mut Ui| {
            ui.label(RichText::new(state).small().weak());
        };
        panel(ui, rect, "Picture", tools, |ui| chosen = self.image.ui(ui, &view));
        if let Some(pixel) = chosen {
            self.record(pixel);
        }
    }

    fn side_panel(&mut self, ui: &mut Ui, rect: Rect) {
        let Some(open) = &self.open else {
            panel(ui, rect, "Side view", |_| {}, |ui| super::panel::empty(ui, "No scene is open."));
            return;
        };
        let mut clicked = None;
        // Both closures need the panel, so the header's tools are shown first, in a panel of their own making.
        let side = std::cell::RefCell::new(&mut self.side);
        panel(
            ui,
            rect,
            "Side view",
            |ui| side.borrow_mut().tools(ui),
            |ui| clicked = side.borrow_mut().ui(ui, &open.scene, self.recording.as_ref()),
        );
        if let Some(event) = clicked {
            self.select(event);
        }
    }

    fn outline_panel(&mut self, ui: &mut Ui, rect: Rect) {
        let position = toolbar::position(self.recording.as_ref());
        let tools = |ui: &mut Ui| {
            ui.label(RichText::new(position).small().weak());
        };
        panel(ui, rect, "The ray's story", tools, |ui| {
            let (bar, rows) = toolbar::cut(ui.available_rect_before_wrap());
            let builder = UiBuilder::new().id_salt("stepper").max_rect(bar.shrink2(egui::vec2(8.0, 4.0)));
            ui.scope_builder(builder, |ui| toolbar::ui(ui, self.recording.as_mut()));
            let edge = egui::Stroke::new(1.0, Palette::current(ui.ctx()).edge);
            ui.painter().hline(bar.x_range(), bar.bottom(), edge);
            let builder = UiBuilder::new().id_salt("rows").max_rect(rows.with_min_y(rows.top() + 1.0));
            ui.scope_builder(builder, |ui| tree_panel::ui(ui, self.recording.as_mut()));
        });
    }

    /// Opens what was dropped on the window or chosen in the dialogue.
    fn take_files(&mut self, ctx: &Context) {
        if let Some(path) = self.dialog.chosen() {
            self.open_scene(ctx, &path.display().to_string());
        }
        let dropped = ctx.input(|input| input.raw.dropped_files.first().cloned());
        if let Some(file) = dropped {
            let name = file.path().display().to_string();
            match file.bytes().map(String::from_utf8) {
                Ok(Ok(text)) => self.open_text(ctx, &name, &text),
                Ok(Err(_)) => self.refuse(&name, "The file is not text, so it is no scene.".to_owned()),
                Err(error) => self.refuse(&name, format!("The file cannot be read: {error}.")),
            }
        }
    }
}

/// How far the picture is, in words.
fn progress(ctx: &Context, renderer: &Renderer, scene: &Scene) -> String {
    let size = format!("{} × {}", scene.image.width, scene.image.height);
    if renderer.finished() {
        return size;
    }
    ctx.request_repaint_after(std::time::Duration::from_millis(100));
    format!("{size} · rendering, {:.0} %", 100.0 * renderer.share_done())
}

/// The scene for the first visit.
fn first_scene() -> Option<EmbeddedScene> {
    let mut scenes = embedded_scenes();
    let hello = scenes.iter().position(|scene| scene.name.starts_with("hello/")).unwrap_or(0);
    (hello < scenes.len()).then(|| scenes.swap_remove(hello))
}
