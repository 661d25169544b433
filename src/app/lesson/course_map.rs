//! The course as a map: what a lesson needs stands above it.

use super::course_list::{Stand, stand, tools};
use super::pane::{LessonPane, Wish};
use crate::app::frame::empty::empty;
use crate::app::frame::theme::{PADDING, Palette};
use crate::app::frame::words::say;
use crate::lesson::{Course, Lesson};
use egui::{
    Color32, FontId, Frame, Margin, Rect, Role, ScrollArea, Sense, Stroke, StrokeKind, Ui, Vec2, WidgetInfo, pos2, vec2,
};
use std::collections::BTreeMap;

/// A lesson is at least so wide, and so high, in points.
const NARROWEST: f32 = 176.0;
const HEIGHT: f32 = 44.0;
/// Between lessons beside each other, between lines of a level, and between levels, in points.
const ASIDE: f32 = 14.0;
const BELOW: f32 = 10.0;
const LEVEL: f32 = 26.0;

/// Shows the map; returns the lesson that was chosen.
pub fn ui(ui: &mut Ui, pane: &mut LessonPane) -> Option<Wish> {
    let Some(lessons) = pane.lessons().cloned() else {
        empty(ui, &say(ui.ctx(), "lesson-reading"));
        return None;
    };
    let course = &lessons.course;
    let mut wish = None;
    ScrollArea::vertical().id_salt("map").auto_shrink(false).show(ui, |ui| {
        Frame::new().inner_margin(Margin::same(PADDING)).show(ui, |ui| {
            tools(ui, pane, course);
            let places = places(course, ui.available_width());
            let size = places.values().fold(Vec2::ZERO, |size, place| size.max(place.max.to_vec2()));
            let (whole, _) = ui.allocate_exact_size(size + vec2(0.0, 8.0), Sense::hover());
            let rect_of = |id: &str| places.get(id).map(|place| place.translate(whole.min.to_vec2()));
            let hovered = course
                .lessons
                .iter()
                .find(|lesson| rect_of(&lesson.id).is_some_and(|rect| ui.rect_contains_pointer(rect)));
            for lesson in &course.lessons {
                lines(ui, lesson, hovered, &rect_of);
            }
            for lesson in &course.lessons {
                let Some(rect) = rect_of(&lesson.id) else { continue };
                if node(ui, rect, lesson, stand(&pane.progress, &lesson.id)) {
                    wish = Some(Wish::Open(lesson.id.clone()));
                }
            }
        });
    });
    wish
}

/// Where each lesson lies: on its level, below those that come before it, in as many lines as the width asks for.
fn places(course: &Course, width: f32) -> BTreeMap<&str, Rect> {
    let levels = course.levels();
    let deepest = levels.values().copied().max().unwrap_or_default();
    let most = (1..=8).take_while(|&count| count as f32 * (NARROWEST + ASIDE) <= width + ASIDE).last().unwrap_or(1);
    let size = vec2((width + ASIDE) / most as f32 - ASIDE, HEIGHT);
    let (mut places, mut top) = (BTreeMap::new(), 0.0);
    for level in 0..=deepest {
        let lessons = course.lessons.iter().filter(|lesson| levels.get(lesson.id.as_str()) == Some(&level));
        let mut bottom = top;
        for (number, lesson) in lessons.enumerate() {
            let at = pos2((number % most) as f32 * (size.x + ASIDE), top + (number / most) as f32 * (HEIGHT + BELOW));
            places.insert(lesson.id.as_str(), Rect::from_min_size(at, size));
            bottom = at.y + HEIGHT;
        }
        top = bottom + LEVEL;
    }
    places
}

/// From what a lesson needs to the lesson.
fn lines(ui: &Ui, lesson: &Lesson, hovered: Option<&Lesson>, rect_of: &dyn Fn(&str) -> Option<Rect>) {
    let palette = Palette::current(ui.ctx());
    for need in &lesson.header.needs {
        let (Some(from), Some(to)) = (rect_of(&need.value), rect_of(&lesson.id)) else { continue };
        let is_lit = hovered.is_some_and(|hovered| hovered.id == lesson.id || hovered.id == need.value);
        let stroke =
            if is_lit { Stroke::new(2.0, palette.accent) } else { Stroke::new(1.0, palette.weak.gamma_multiply(0.7)) };
        let (start, end) = (from.center_bottom(), to.center_top());
        let bend = vec2(0.0, (end.y - start.y).max(20.0) / 2.0);
        let points = [start, start + bend, end - bend, end];
        ui.painter().add(egui::epaint::CubicBezierShape::from_points_stroke(
            points,
            false,
            Color32::TRANSPARENT,
            stroke,
        ));
    }
}

/// Shows a lesson; returns whether it was chosen.
fn node(ui: &Ui, rect: Rect, lesson: &Lesson, stand: Stand) -> bool {
    let palette = Palette::current(ui.ctx());
    let response = ui.interact(rect, ui.scope_id().with(("map", &lesson.id)), Sense::click());
    let name = format!("{}, {}", lesson.header.title, say(ui.ctx(), stand.word()));
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, &name));
    let fill = if response.hovered() { palette.hovered } else { palette.header };
    let is_marked = response.has_focus() || stand == Stand::Done;
    let edge = if is_marked { Stroke::new(1.5, palette.accent) } else { Stroke::new(1.0, palette.edge) };
    ui.painter().rect(rect, 5.0, fill, edge, StrokeKind::Inside);
    let text = format!("{} {}", stand.sign(), lesson.header.title);
    let mut job = egui::text::LayoutJob::simple(text, FontId::proportional(11.5), palette.text, rect.width() - 12.0);
    job.wrap.max_rows = 2;
    let galley = ui.ctx().fonts_mut(|fonts| fonts.layout_job(job));
    let at = egui::pos2(rect.left() + 6.0, rect.center().y - galley.size().y / 2.0);
    ui.painter().galley(at, galley, palette.text);
    response
        .on_hover_ui(|ui| {
            ui.set_max_width(300.0);
            ui.strong(&lesson.header.title);
            ui.label(&lesson.header.idea);
        })
        .clicked()
}
