//! A search of the picture in the background, and the list of what it has found.

use super::layer::{self, Pixels};
use crate::app::frame::background::Background;
use crate::app::frame::task::{self, Task};
use crate::app::frame::theme::Palette;
use crate::app::frame::words::{say, say_with};
use crate::query::{FIRST_SIDE, Found, Query, Search, scan};
use crate::record::EventId;
use crate::scene::Scene;
use crate::trace::Progress;
use egui::text::{LayoutJob, TextWrapping};
use egui::{Align2, Button, Context, FontId, Rect, Role, ScrollArea, Sense, TextureHandle, Ui, WidgetInfo, vec2};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Height of a row, in points.
const ROW: f32 = 22.0;

/// A question that is being asked, or was asked, of a scene.
pub struct Asked {
    query: Query,
    scene: Arc<Scene>,
    job: Option<Background<News>>,
    search: Option<Search>,
    texture: Option<TextureHandle>,
    /// The result that was gone to last.
    at: Option<usize>,
    /// Whether the list is to scroll to it.
    has_moved: bool,
}

/// To ask every pixel of a scene.
#[derive(Serialize, Deserialize)]
pub struct Find {
    query: Query,
}

/// What was found so far, with the layer over the picture.
#[derive(Serialize, Deserialize)]
pub struct News {
    search: Search,
    pixels: Pixels,
}

impl Task for Find {
    const NAME: &'static str = "search";
    type News = News;

    fn run(self, scene: &Arc<Scene>, progress: &Progress, publish: &mut dyn FnMut(News)) {
        scan(scene, &self.query, FIRST_SIDE, progress, |search| {
            let pixels = layer::found(&search);
            publish(News { search, pixels });
        });
    }
}

/// A pixel to be recorded, and the event in it to be selected.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// The pixel.
    pub pixel: [u32; 2],
    /// The event, where one is meant.
    pub event: Option<EventId>,
}

impl Drop for Asked {
    fn drop(&mut self) {
        layer::drop_elsewhere(self.search.take());
    }
}

impl Asked {
    /// Begins to search.
    pub fn start(ctx: &Context, query: &Query, scene: &Arc<Scene>) -> Self {
        let job = task::begin(ctx, scene, Find { query: query.clone() });
        let (query, scene) = (query.clone(), Arc::clone(scene));
        Self { query, scene, job, search: None, texture: None, at: None, has_moved: false }
    }

    /// Whether it is this question about this scene.
    pub fn is(&self, query: &Query, scene: &Arc<Scene>) -> bool {
        self.query == *query && Arc::ptr_eq(&self.scene, scene)
    }

    /// Whether it is about this scene.
    pub fn is_of(&self, scene: &Arc<Scene>) -> bool {
        Arc::ptr_eq(&self.scene, scene)
    }

    /// Takes what was found meanwhile.
    pub fn update(&mut self, ctx: &Context) {
        let Some(job) = &self.job else { return };
        let is_finished = job.is_finished();
        if let Some(News { search, pixels }) = job.take() {
            // What was gone to keeps its place in the list, which grows.
            let pixel = self.at.and_then(|at| self.results().get(at)).map(|found| found.pixel);
            self.at = pixel.and_then(|pixel| search.found.iter().position(|found| found.pixel == pixel));
            self.texture = Some(layer::upload(ctx, "found", &pixels));
            layer::drop_elsewhere(self.search.replace(search));
        }
        if is_finished {
            self.job = None;
        } else {
            ctx.request_repaint_after(std::time::Duration::from_millis(100));
        }
    }

    /// Whether all pixels were asked.
    pub const fn is_finished(&self) -> bool {
        self.job.is_none()
    }

    /// What lies over the picture.
    pub fn texture(&self) -> Option<&TextureHandle> {
        self.texture.as_ref()
    }

    /// The pixels that were found so far.
    pub fn results(&self) -> &[Found] {
        self.search.as_ref().map_or(&[], |search| &search.found)
    }

    /// The next result, or the one before; round from the last to the first.
    pub fn go(&mut self, forward: bool) -> Option<Place> {
        let count = self.results().len();
        let at = match (self.at, forward) {
            _ if count == 0 => return None,
            (None, true) => 0,
            (None, false) => count - 1,
            (Some(at), true) => (at + 1) % count,
            (Some(at), false) => (at + count - 1) % count,
        };
        self.choose(at)
    }

    fn choose(&mut self, at: usize) -> Option<Place> {
        (self.at, self.has_moved) = (Some(at), true);
        self.results().get(at).map(|found| Place { pixel: found.pixel, event: Some(found.event) })
    }

    /// Shows how much was found, and buttons to go from one to the next.
    pub fn summary(&mut self, ui: &mut Ui) -> Option<Place> {
        let (count, all) = (self.results().len(), self.scene.image.width as usize * self.scene.image.height as usize);
        let mut place = None;
        ui.horizontal_wrapped(|ui| {
            for (word, forward) in [("search-previous", false), ("search-next", true)] {
                let button = ui.add_enabled(count > 0, Button::new(say(ui.ctx(), word)));
                let about = say(ui.ctx(), &format!("{word}-about"));
                if button.on_hover_text(about).clicked() {
                    place = self.go(forward);
                }
            }
            ui.label(say_with(ui.ctx(), "search-count", &[("count", count.into()), ("all", all.into())]));
            if let Some(at) = self.at {
                ui.label(say_with(ui.ctx(), "search-at", &[("at", (at + 1).into()), ("count", count.into())]));
            }
            if let Some(job) = &self.job {
                let percent = format!("{:.0} %", 100.0 * job.done() as f64 / all.max(1) as f64);
                ui.weak(say_with(ui.ctx(), "search-running", &[("percent", (&percent).into())]));
            }
        });
        place
    }

    /// The list of results, laid out only where it is seen; returns the one that was clicked.
    pub fn list(&mut self, ui: &mut Ui) -> Option<Place> {
        ui.spacing_mut().item_spacing.y = 0.0;
        let mut area = ScrollArea::vertical().id_salt("search results").auto_shrink(false);
        if let (true, Some(at)) = (std::mem::take(&mut self.has_moved), self.at) {
            area = area.vertical_scroll_offset((at as f32 * ROW - ui.available_height() / 3.0).max(0.0));
        }
        let clicked = area.show_rows(ui, ROW, self.results().len(), |ui, range| {
            let rows = range.filter(|&at| self.row(ui, at));
            rows.last()
        });
        self.choose(clicked.inner?)
    }

    /// One result; returns whether it was clicked.
    fn row(&self, ui: &mut Ui, at: usize) -> bool {
        let Some(found) = self.results().get(at) else { return false };
        let palette = Palette::current(ui.ctx());
        let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), ROW), Sense::click());
        let [x, y] = found.pixel;
        let place = format!("({x}, {y})");
        let text = [found.row.label.as_str(), found.row.numbers.as_str()].join("   ");
        let is_chosen = self.at == Some(at);
        let name = format!("{place} {}", text.trim_end());
        response.widget_info(|| WidgetInfo::labeled(Role::ListItem, true, &name));
        ui.ctx().accesskit_node_builder(response.id, |node| node.set_selected(is_chosen));
        let painter = ui.painter_at(rect);
        if is_chosen {
            painter.rect_filled(rect, 0.0, palette.selected);
            painter.rect_filled(Rect::from_min_size(rect.min, vec2(3.0, ROW)), 0.0, palette.accent);
        } else if response.hovered() || response.has_focus() {
            painter.rect_filled(rect, 0.0, palette.hovered);
        }
        let left = rect.left_center() + vec2(8.0, 0.0);
        painter.text(
            left,
            Align2::LEFT_CENTER,
            &place,
            FontId::monospace(12.0),
            if is_chosen { palette.text } else { palette.weak },
        );
        let left = left + vec2(84.0, 0.0);
        painter.text(left, Align2::LEFT_CENTER, found.row.icon, FontId::proportional(13.0), palette.accent);
        let left = left + vec2(22.0, 0.0);
        let mut job = LayoutJob::simple_singleline(text, FontId::proportional(13.0), palette.text);
        job.wrap = TextWrapping::truncate_at_width((rect.right() - 8.0 - left.x).max(0.0));
        let line = ui.ctx().fonts_mut(|fonts| fonts.layout_job(job));
        painter.galley(left - vec2(0.0, 0.5 * line.size().y), line, palette.text);
        response.on_hover_text(name).clicked()
    }
}
