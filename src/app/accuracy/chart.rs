//! The large drawing of the accuracy window: the plot, or a map.

use crate::app::drawings::canvas::{Canvas, put};
use crate::app::frame::background::Background;
use crate::app::frame::task::{self, Task};
use crate::app::frame::theme::{Palette, drawing_theme};
use crate::app::frame::words::{say, say_with};
use crate::laboratory::{MapKind, Point, Study, digits_map, error_map, plot, tier_map, time_map};
use crate::scene::{Image, Scene};
use crate::trace::{Picture, Progress};
use crate::view::{Drawing, Form, HeatMap, Spot, Theme, frontier_plot, heat_map};
use egui::{Pos2, Rect, Role, Sense, Stroke, Ui, WidgetInfo, vec2};
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use web_time::Instant;

/// How far from a mark a click still counts, in points.
const REACH: f64 = 6.0;

/// What is drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum View {
    /// Error against seconds.
    #[default]
    Plot,
    /// A map of the chosen setting.
    Map(MapKind),
}

/// Which map of which setting.
#[derive(Clone)]
pub struct MapOf {
    /// What is mapped.
    pub kind: MapKind,
    /// The study.
    pub study: Arc<Study>,
    /// The setting, by its place in the study.
    pub place: usize,
}

impl MapOf {
    fn point(&self) -> Option<&Point> {
        self.study.all().nth(self.place)
    }
}

/// A study that goes on brings new times, but the same pictures.
impl PartialEq for MapOf {
    fn eq(&self, other: &Self) -> bool {
        let profile = |of: &Self| of.point().map(|point| (point.plain_name(), point.profile));
        let size = |of: &Self| (of.study.standard.picture.width, of.study.standard.picture.height);
        self.kind == other.kind && size(self) == size(other) && profile(self) == profile(other)
    }
}

/// Everything that a drawing depends on, but for what is drawn.
#[derive(Clone, Copy, PartialEq)]
struct Look {
    size: [u32; 2],
    theme: Theme,
    pixels_per_point: f32,
}

#[derive(Clone)]
struct PlotKey {
    study: Arc<Study>,
    look: Look,
}

impl PartialEq for PlotKey {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.study, &other.study) && self.look == other.look
    }
}

#[derive(Clone)]
struct MapKey {
    map: Arc<HeatMap>,
    look: Look,
}

impl PartialEq for MapKey {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.map, &other.map) && self.look == other.look
    }
}

/// What is remembered of the drawing between frames.
#[derive(Default)]
pub struct Chart {
    plot: Canvas<PlotKey>,
    map: Canvas<MapKey>,
    job: Option<(MapOf, Background<HeatMap>)>,
    known: Option<(MapOf, Arc<HeatMap>)>,
}

impl Chart {
    /// Stops what is running.
    pub fn pause(&mut self) {
        self.job = None;
    }

    /// Shows the plot with the chosen point marked; returns the point that was clicked.
    pub fn plot(&mut self, ui: &mut Ui, rect: Rect, study: &Arc<Study>, name: &str, chosen: usize) -> Option<usize> {
        let key = PlotKey { study: Arc::clone(study), look: look(ui, rect) };
        let (wanted, name) = (key.clone(), name.to_owned());
        let response = ui.allocate_rect(rect, Sense::click());
        let title = say(ui.ctx(), "accuracy-plot");
        response.widget_info(|| WidgetInfo::labeled(Role::Image, true, &title));
        let draw = move || Some(frontier_plot(&plot(&wanted.study, &name), points_of(wanted.look), wanted.look.theme));
        let shown = self.plot.update(ui.ctx(), &key, draw)?;
        let (Some(texture), Some(drawing)) = (&shown.texture, &shown.drawing) else { return None };
        let place = put(&ui.painter_at(rect), texture, rect.min);
        if let Some(at) = marker(drawing, chosen) {
            mark(ui, place, at);
        }
        let clicked = response.interact_pointer_pos().filter(|_| response.clicked());
        let found = drawing.event_at(local(place, clicked.or(response.hover_pos())?), REACH);
        if found.is_some() {
            ui.ctx().set_cursor_icon(egui::CursorIcon::PointingHand);
        }
        clicked.and(found).map(|event| event as usize)
    }

    /// Shows a map, working it out where it is not known yet.
    pub fn map(&mut self, ui: &mut Ui, rect: Rect, of: &MapOf, whole: &Arc<Scene>) {
        self.work_out(ui, of, whole);
        let response = ui.allocate_rect(rect, Sense::hover());
        let Some((_, map)) = self.known.as_ref().filter(|(known, _)| known == of) else {
            let done = self.job.as_ref().map_or(0, |(_, job)| job.done());
            let share = 100.0 * done as f64 / of.kind.work(&looked_at(of, whole)).max(1) as f64;
            let percent = format!("{share:.0}");
            let words = say_with(ui.ctx(), "accuracy-mapping", &[("percent", (&percent).into())]);
            let weak = Palette::current(ui.ctx()).weak;
            ui.painter().text(
                rect.center(),
                egui::Align2::CENTER_CENTER,
                words,
                egui::FontId::proportional(13.5),
                weak,
            );
            return;
        };
        let title = say_with(ui.ctx(), "accuracy-map", &[("title", (&map.title).into())]);
        response.widget_info(|| WidgetInfo::labeled(Role::Image, true, &title));
        let key = MapKey { map: Arc::clone(map), look: look(ui, rect) };
        let wanted = key.clone();
        let draw = move || Some(heat_map(&wanted.map, points_of(wanted.look), wanted.look.theme));
        if let Some(shown) = self.map.update(ui.ctx(), &key, draw)
            && let Some(texture) = &shown.texture
        {
            put(&ui.painter_at(rect), texture, rect.min);
        }
    }

    fn work_out(&mut self, ui: &Ui, of: &MapOf, whole: &Arc<Scene>) {
        let is_known = self.known.as_ref().is_some_and(|(known, _)| known == of);
        let is_asked = self.job.as_ref().is_some_and(|(asked, _)| asked == of);
        if !is_known && !is_asked {
            let scene = Arc::new(looked_at(of, whole));
            let job = of.task().and_then(|task| task::begin(ui.ctx(), &scene, task));
            self.job = job.map(|job| (of.clone(), job));
        }
        let Some((asked, job)) = &self.job else { return };
        match job.take() {
            Some(map) => {
                self.known = Some((asked.clone(), Arc::new(map)));
                self.job = None;
            }
            None => ui.ctx().request_repaint_after(std::time::Duration::from_millis(100)),
        }
    }
}

/// The scene as the map's setting looks at it, in the size of the study's pictures.
fn looked_at(of: &MapOf, whole: &Scene) -> Scene {
    let mut scene = of.point().map_or_else(|| whole.clone(), |point| whole.with_profile(&point.profile));
    let picture = &of.study.standard.picture;
    scene.image = Image { width: picture.width, height: picture.height };
    scene
}

/// To work out a map of a scene.
#[derive(Serialize, Deserialize)]
pub struct MapAccuracy {
    kind: MapKind,
    /// The setting that the scene is looked at with.
    name: String,
    /// Its picture and the reference, where they are compared.
    pictures: Option<[Picture; 2]>,
}

impl MapOf {
    fn task(&self) -> Option<MapAccuracy> {
        let point = self.point()?;
        let pictures = || [point.picture.clone(), self.study.reference.picture.clone()];
        let pictures = (self.kind == MapKind::Error).then(pictures);
        Some(MapAccuracy { kind: self.kind, name: point.plain_name(), pictures })
    }
}

impl Task for MapAccuracy {
    const NAME: &'static str = "accuracy map";
    type News = HeatMap;

    fn run(self, scene: &Arc<Scene>, progress: &Progress, publish: &mut dyn FnMut(HeatMap)) {
        let map = match self.kind {
            MapKind::Error => self.pictures.and_then(|[picture, reference]| error_map(&picture, &reference)),
            MapKind::Digits => digits_map(scene, progress),
            MapKind::Tier => tier_map(scene, progress),
            MapKind::Time => {
                let began = Instant::now();
                time_map(scene, &|| began.elapsed(), progress)
            }
        };
        if let Some(map) = map {
            publish(HeatMap { title: format!("{}: {}", map.title, self.name), ..map });
        }
    }
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a window is a few thousand points")]
fn look(ui: &Ui, rect: Rect) -> Look {
    let size = [rect.width().max(1.0) as u32, rect.height().max(1.0) as u32];
    Look { size, theme: drawing_theme(ui.ctx()), pixels_per_point: ui.pixels_per_point() }
}

fn points_of(look: Look) -> [f64; 2] {
    look.size.map(f64::from)
}

fn local(place: Rect, at: Pos2) -> Spot {
    let at = at - place.min;
    [f64::from(at.x), f64::from(at.y)]
}

/// The middle of a point's marker.
fn marker(drawing: &Drawing, point: usize) -> Option<Spot> {
    let own = drawing.marks.iter().filter(|mark| mark.event.is_some_and(|event| event as usize == point));
    own.filter_map(|mark| match &mark.form {
        Form::Area { rings, .. } => rings.first(),
        _ => None,
    })
    .map(|ring| std::array::from_fn(|i| ring.iter().map(|corner| corner[i]).sum::<f64>() / ring.len().max(1) as f64))
    .next()
}

/// A ring about the chosen point.
fn mark(ui: &Ui, place: Rect, [x, y]: Spot) {
    #[expect(clippy::cast_possible_truncation, reason = "points on a screen")]
    let at = place.min + vec2(x as f32, y as f32);
    let accent = Palette::current(ui.ctx()).accent;
    ui.painter().circle_stroke(at, 11.5, Stroke::new(2.5, accent));
}
