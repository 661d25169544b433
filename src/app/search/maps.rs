//! Maps: a quantity of every pixel, over the picture and with its legend in the panel.

use super::found::Place;
use super::layer::{self, Layer, Pixels};
use crate::app::drawings::canvas::{Canvas, put};
use crate::app::frame::background::Background;
use crate::app::frame::task::{self, Task};
use crate::app::frame::theme::drawing_theme;
use crate::app::frame::ticks;
use crate::app::frame::words::{say, say_with};
use crate::query::{FIRST_SIDE, Quantity, Survey, survey};
use crate::scene::Scene;
use crate::trace::Progress;
use crate::view::{HeatMap, Theme, heat_map};
use egui::{Color32, Context, RichText, Role, ScrollArea, Sense, Slider, TextureHandle, Ui, WidgetInfo, vec2};
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use web_time::Instant;

/// The least height in which the map and its legend can be read, in points: lower, they are scrolled.
const LEAST: f32 = 200.0;

/// The maps' panel.
pub struct Maps {
    quantity: Option<Quantity>,
    job: Option<Job>,
    known: Option<Known>,
    /// The layer over the picture, for a theme.
    over: Option<(Theme, TextureHandle)>,
    canvas: Canvas<DrawnKey>,
    /// How opaque the map lies over the picture; nothing of it is seen at 0.
    opacity: f32,
}

/// A survey that is at work.
struct Job {
    quantity: Quantity,
    scene: Arc<Scene>,
    work: Background<Mapped>,
}

/// What is known of a quantity.
struct Known {
    scene: Arc<Scene>,
    survey: Survey,
    map: Arc<HeatMap>,
}

/// To survey a scene.
#[derive(Serialize, Deserialize)]
pub struct Map {
    quantity: Quantity,
    theme: Theme,
}

/// What is known of a quantity, with the layer over the picture.
#[derive(Serialize, Deserialize)]
pub struct Mapped {
    survey: Survey,
    map: HeatMap,
    pixels: Pixels,
    theme: Theme,
}

impl Task for Map {
    const NAME: &'static str = "map";
    type News = Mapped;

    fn run(self, scene: &Arc<Scene>, progress: &Progress, publish: &mut dyn FnMut(Mapped)) {
        let (began, theme) = (Instant::now(), self.theme);
        survey(scene, self.quantity, FIRST_SIDE, &|| began.elapsed(), progress, |survey| {
            let map = survey.map(scene);
            let pixels = layer::map(&map, theme);
            publish(Mapped { survey, map, pixels, theme });
        });
    }
}

/// What the drawing depends on.
#[derive(Clone)]
struct DrawnKey {
    map: Arc<HeatMap>,
    size: [u32; 2],
    theme: Theme,
    pixels_per_point: f32,
}

impl PartialEq for DrawnKey {
    fn eq(&self, other: &Self) -> bool {
        let look = |key: &Self| (key.size, key.theme, key.pixels_per_point);
        Arc::ptr_eq(&self.map, &other.map) && look(self) == look(other)
    }
}

impl Default for Maps {
    fn default() -> Self {
        Self { quantity: None, job: None, known: None, over: None, canvas: Canvas::default(), opacity: 0.85 }
    }
}

impl Maps {
    /// Chooses a quantity, or none.
    pub fn choose(&mut self, quantity: Option<Quantity>) {
        self.quantity = quantity;
        if quantity.is_none() {
            (self.job, self.known, self.over) = (None, None, None);
        }
    }

    /// The quantity that is shown.
    pub const fn quantity(&self) -> Option<Quantity> {
        self.quantity
    }

    /// Stops what is at work.
    pub fn pause(&mut self) {
        self.job = None;
    }

    /// Begins a survey where one is wanted.
    pub fn begin(&mut self, ctx: &Context, scene: &Arc<Scene>) {
        let Some(quantity) = self.quantity else { return };
        let is_known = |known: &Known| known.survey.quantity == quantity && Arc::ptr_eq(&known.scene, scene);
        let is_at_work =
            self.job.as_ref().is_some_and(|job| job.quantity == quantity && Arc::ptr_eq(&job.scene, scene));
        let is_complete = self.known.as_ref().is_some_and(|known| is_known(known) && known.survey.is_complete());
        if !is_complete && !is_at_work {
            self.job = start(ctx, quantity, scene);
        }
    }

    /// Takes what is known of a survey that is at work.
    pub fn update(&mut self, ctx: &Context) {
        let Some(job) = &self.job else { return };
        let is_finished = job.work.is_finished();
        if let Some(Mapped { survey, map, pixels, theme }) = job.work.take() {
            self.over = Some((theme, layer::upload(ctx, "map", &pixels)));
            let known = Known { scene: Arc::clone(&job.scene), survey, map: Arc::new(map) };
            layer::drop_elsewhere(self.known.replace(known));
        }
        if is_finished {
            self.job = None;
        } else {
            ctx.request_repaint_after(std::time::Duration::from_millis(100));
        }
    }

    /// Whether the map that is wanted is all there.
    pub fn is_finished(&self) -> bool {
        self.job.is_none() && self.known.as_ref().is_some_and(|known| known.survey.is_complete())
    }

    /// What lies over the picture of a scene: a map of that scene, and of no other.
    pub fn layer(&mut self, ctx: &Context, scene: &Arc<Scene>) -> Option<Layer> {
        let theme = drawing_theme(ctx);
        let map = &self.known_of(scene)?.map;
        if self.over.as_ref().is_none_or(|(of, _)| *of != theme) {
            self.over = Some((theme, layer::upload(ctx, "map", &layer::map(map, theme))));
        }
        let tint = Color32::WHITE.gamma_multiply(self.opacity);
        self.over.as_ref().map(|(_, texture)| Layer { texture: texture.clone(), tint })
    }

    /// What is known of a scene.
    fn known_of(&self, scene: &Arc<Scene>) -> Option<&Known> {
        self.known.as_ref().filter(|known| Arc::ptr_eq(&known.scene, scene))
    }

    /// What the map says of a pixel of a scene.
    pub fn told(&self, scene: &Arc<Scene>, pixel: [u32; 2]) -> Option<String> {
        let known = self.known_of(scene)?;
        known.survey.told(&known.scene, pixel)
    }

    /// Shows the quantities and the map; returns the pixel that was clicked in it.
    pub fn ui(&mut self, ui: &mut Ui, scene: &Arc<Scene>) -> Option<Place> {
        let room = ui.available_height();
        let scroll = ScrollArea::vertical().auto_shrink(false).id_salt("maps");
        scroll.show(ui, |ui| self.contents(ui, scene, room)).inner
    }

    fn contents(&mut self, ui: &mut Ui, scene: &Arc<Scene>, room: f32) -> Option<Place> {
        let top = ui.cursor().top();
        ui.horizontal_wrapped(|ui| {
            let mut chosen = self.quantity;
            ui.selectable_value(&mut chosen, None, say(ui.ctx(), "map-none"))
                .on_hover_text(say(ui.ctx(), "map-none-about"));
            for quantity in Quantity::ALL {
                let word = word(quantity);
                let about = say(ui.ctx(), &format!("{word}-about"));
                ui.selectable_value(&mut chosen, Some(quantity), say(ui.ctx(), word)).on_hover_text(about);
            }
            if chosen != self.quantity {
                self.choose(chosen);
            }
        });
        if self.quantity.is_none() {
            ui.label(RichText::new(say(ui.ctx(), "map-invitation")).weak());
            return None;
        }
        ui.horizontal(|ui| {
            let label = ui.label(say(ui.ctx(), "map-opacity"));
            ticks::slider(ui, Slider::new(&mut self.opacity, 0.0..=1.0).show_value(false)).labelled_by(label.id);
            if let Some(job) = &self.job {
                let all = job.quantity.work_per_pixel() * scene.image.width as usize * scene.image.height as usize;
                let percent = format!("{:.0} %", 100.0 * job.work.done() as f64 / all.max(1) as f64);
                ui.weak(say_with(ui.ctx(), "map-running", &[("percent", (&percent).into())]));
            }
        });
        // A little less than there is room for: what just fits would be scrolled for a rounding error.
        let height = (room - (ui.cursor().top() - top) - 1.0).max(LEAST);
        self.drawing(ui, scene, height)
    }

    /// The map with its legend; hovering reads a pixel.
    fn drawing(&mut self, ui: &mut Ui, scene: &Arc<Scene>, height: f32) -> Option<Place> {
        let map = Arc::clone(&self.known_of(scene)?.map);
        let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::click());
        let (description, name) = (map.title.clone(), say_with(ui.ctx(), "map-name", &[("map", (&map.title).into())]));
        response.widget_info(|| WidgetInfo::labeled(Role::Image, true, &name));
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a window is a few thousand points"
        )]
        let size = [rect.width().max(1.0) as u32, rect.height().max(1.0) as u32];
        let (theme, pixels_per_point) = (drawing_theme(ui.ctx()), ui.pixels_per_point());
        let key = DrawnKey { map, size, theme, pixels_per_point };
        let wanted = key.clone();
        let draw = move || Some(heat_map(&wanted.map, wanted.size.map(f64::from), wanted.theme));
        let shown = self.canvas.update(ui.ctx(), &key, draw)?;
        let told = shown.drawing.as_ref().map_or(description, |drawing| drawing.description.clone());
        ui.ctx().accesskit_node_builder(response.id, |node| node.set_description(told));
        let texture = shown.texture.as_ref()?;
        let place = put(&ui.painter_at(rect), texture, rect.min);
        let (map, size) = (Arc::clone(&shown.key.map), shown.key.size.map(f64::from));
        let at = response.hover_pos()? - place.min;
        let pixel = map.pixel_at(size, [f64::from(at.x), f64::from(at.y)])?;
        let [x, y] = pixel;
        let value = self.told(scene, pixel).unwrap_or_default();
        let clicked = response.clicked();
        response.on_hover_text_at_pointer(format!("({x}, {y}): {value}"));
        clicked.then_some(Place { pixel, event: None })
    }
}

fn start(ctx: &Context, quantity: Quantity, scene: &Arc<Scene>) -> Option<Job> {
    let work = task::begin(ctx, scene, Map { quantity, theme: drawing_theme(ctx) })?;
    Some(Job { quantity, scene: Arc::clone(scene), work })
}

/// The name of a quantity in the catalogue of words; with `-about` behind it, that of what it is.
pub const fn word(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::Rays => "map-rays",
        Quantity::Tests => "map-tests",
        Quantity::Depth => "map-depth",
        Quantity::Time => "map-time",
        Quantity::Error => "map-error",
        Quantity::Object => "map-object",
        Quantity::Normal => "map-normal",
        Quantity::Digits => "map-digits",
    }
}
