//! Moving things in the picture, by the pointer and by keys.

use crate::app::edit::editing::Editing;
use crate::app::edit::frame_box::place_of_light;
use crate::app::frame::words::{say, say_with};
use crate::app::picture::placement::Placement;
use crate::document::{
    Cause, Place, Step, TargetKind, across_view, along_axis, decimals_for, depth, moved, object_and_leaf, object_at,
};
use crate::record::What;
use crate::scene::Scene;
use crate::trace::record_pixel;
use egui::{Context, CursorIcon, Id, Key, Modifiers, Pos2, Sense, Ui, Vec2};
use glam::DVec3;
use serde_json::Value;

/// How near to a light the pointer takes it, in points.
const REACH: f32 = 14.0;
/// A key moves a thing by this part of the picture's width.
const KEY_STEP: f64 = 0.02;

/// Whether things are being moved, and the one that is.
#[derive(Debug, Default)]
pub struct Mover {
    /// Whether a drag in the picture moves things.
    pub is_on: bool,
    drag: Option<Drag>,
    /// The number of the gesture, so that each is a change of its own.
    gesture: u32,
}

/// A thing on its way.
#[derive(Debug)]
struct Drag {
    place: Place,
    depth: f64,
    from: Pos2,
    /// The values before.
    whole: Value,
}

impl Editing {
    /// Lets things be dragged in the picture that is seen at `place`.
    pub fn move_by_pointer(&mut self, ui: &Ui, scene: &Scene, place: &Placement) {
        if !self.mover.is_on {
            self.mover.drag = None;
            return;
        }
        let response = ui.interact(place.rect, ui.scope_id().with("move"), Sense::drag());
        let response = response.on_hover_and_drag_cursor(CursorIcon::Move);
        if response.drag_started()
            && let Some(from) = ui.input(|input| input.pointer.press_origin())
        {
            self.take_hold(scene, place, from);
        }
        let (now, locked) = (response.interact_pointer_pos(), ui.input(|input| input.modifiers.shift));
        if let (Some(now), true) = (now, response.dragged()) {
            self.drag_to(ui.ctx(), scene, place, now, locked);
        }
        if response.drag_stopped() {
            self.mover.drag = None;
            self.document.seal();
        }
    }

    /// Takes hold of what lies under the pointer: the camera if that is being edited, a light, or an object.
    fn take_hold(&mut self, scene: &Scene, place: &Placement, from: Pos2) {
        let camera = self.target().filter(|target| target.kind == TargetKind::Camera);
        let held = match camera {
            Some(camera) => Some((camera.place.clone(), self.depth_of_view(scene))),
            None => light_at(scene, place, from).or_else(|| self.object_under(scene, place, from)),
        };
        self.mover.gesture += 1;
        self.mover.drag = held.map(|(place, depth)| {
            self.choose(place.clone());
            Drag { place, depth, from, whole: self.analysis.whole.clone() }
        });
    }

    /// The object at a place of the picture, or the part of it that is being edited, with how far away it is.
    fn object_under(&self, scene: &Scene, place: &Placement, at: Pos2) -> Option<(Place, f64)> {
        let [x, y] = place.pixel_at(at)?;
        let tree = record_pixel(scene, x, y);
        let hit = tree.events.iter().find_map(|event| match &event.what {
            What::Hit { object, leaf, point, .. } => Some((object.clone(), leaf.clone(), *point)),
            _ => None,
        });
        let (object, leaf, point) = hit?;
        let (index, _) = object_and_leaf(&scene.objects, &object, &leaf)?;
        let chosen = self.target.as_ref().filter(|target| object_at(target) == Some(index));
        let place = chosen.cloned().unwrap_or_else(|| Place::ROOT.field("objects").item(index));
        Some((place, depth(&scene.camera, DVec3::from_array(point))))
    }

    fn drag_to(&mut self, ctx: &Context, scene: &Scene, place: &Placement, now: Pos2, locked: bool) {
        let Some(drag) = &self.mover.drag else { return };
        let pixels = (now - drag.from) * place.size[0] as f32 / place.rect.width();
        let by = vector(scene, &drag.place, drag.depth, pixels, locked);
        let (whole, thing) = (drag.whole.clone(), drag.place.clone());
        let decimals = decimals_for(pixel_size(scene, drag.depth));
        let gesture = format!("move {}", self.mover.gesture);
        self.move_thing(ctx, &whole, &thing, by, gesture, decimals);
    }

    fn move_thing(&mut self, ctx: &Context, whole: &Value, thing: &Place, by: DVec3, gesture: String, decimals: i32) {
        let Some(settings) = moved(whole, thing, by, decimals) else { return };
        let name = self.target().map_or_else(|| thing.to_string(), |target| target.name.clone());
        let name = if name.is_empty() { say(ctx, "edit-camera") } else { name };
        let cause = say_with(ctx, "edit-cause-move", &[("thing", (&name).into())]);
        self.set(&settings, &Cause::part_of(cause, gesture));
    }

    /// Lets keys move what is being edited, while the picture has the focus: arrows across it, Page Up and Page Down away and nearer.
    pub fn move_by_keys(&mut self, ctx: &Context, scene: &Scene, picture: Id) {
        if !self.mover.is_on || ctx.memory(|memory| memory.focused()) != Some(picture) {
            return;
        }
        let Some(thing) = self.target.clone() else { return };
        let depth = self.depth_of(scene, &thing);
        for (key, right, down, away) in [
            (Key::ArrowLeft, -1.0, 0.0, 0.0),
            (Key::ArrowRight, 1.0, 0.0, 0.0),
            (Key::ArrowUp, 0.0, -1.0, 0.0),
            (Key::ArrowDown, 0.0, 1.0, 0.0),
            (Key::PageUp, 0.0, 0.0, 1.0),
            (Key::PageDown, 0.0, 0.0, -1.0),
        ] {
            let pressed = |modifiers| ctx.input_mut(|input| input.consume_key(modifiers, key));
            let locked = pressed(Modifiers::SHIFT);
            if !locked && !pressed(Modifiers::NONE) {
                continue;
            }
            let step = KEY_STEP * f64::from(scene.image.width);
            let across = across_view(&scene.camera, scene.image, depth, [right * step, down * step]);
            let size = pixel_size(scene, depth) * step;
            let by = across + scene.camera.forward * (away * size);
            let by = if locked { along_nearest_axis(scene, by) } else { by };
            let whole = self.analysis.whole.clone();
            self.move_thing(ctx, &whole, &thing, by, format!("keys {thing}"), decimals_for(size / 10.0));
        }
    }

    /// How far away the thing at a place is; of what is no object and no light, how far the camera looks.
    fn depth_of(&self, scene: &Scene, thing: &Place) -> f64 {
        let object = object_at(thing).and_then(|index| scene.objects.get(index));
        let middle = object.map(|object| {
            let extent = object.solid.extent();
            (extent.low + extent.high) * 0.5
        });
        let light = match &thing.0[..] {
            [Step::Field(list), Step::Item(index)] if list == "lights" => place_of_light(scene, *index),
            _ => None,
        };
        let found = middle.or(light).filter(|point| point.is_finite()).map(|point| depth(&scene.camera, point));
        found.filter(|depth| *depth > 0.0).unwrap_or_else(|| self.depth_of_view(scene))
    }

    /// How far away the point is that the camera looks at.
    fn depth_of_view(&self, scene: &Scene) -> f64 {
        let look_at = self.analysis.whole.pointer("/camera/look_at").and_then(|value| {
            let numbers: Vec<f64> = value.as_array()?.iter().map(Value::as_f64).collect::<Option<_>>()?;
            <[f64; 3]>::try_from(numbers).ok().map(DVec3::from_array)
        });
        depth(&scene.camera, look_at.unwrap_or(DVec3::ZERO)).max(1e-3)
    }
}

/// The vector of the world that a move across the picture is. The camera moves the other way, so that the scene follows the pointer.
fn vector(scene: &Scene, thing: &Place, depth: f64, pixels: Vec2, locked: bool) -> DVec3 {
    let by = across_view(&scene.camera, scene.image, depth, [f64::from(pixels.x), f64::from(pixels.y)]);
    let by = if locked { along_nearest_axis(scene, by) } else { by };
    if thing.last_field() == Some("camera") { -by } else { by }
}

/// The length that a pixel of the picture has at a depth.
fn pixel_size(scene: &Scene, depth: f64) -> f64 {
    across_view(&scene.camera, scene.image, depth.abs(), [1.0, 0.0]).length()
}

/// The light whose mark is under the pointer, with how far away it is.
fn light_at(scene: &Scene, place: &Placement, at: Pos2) -> Option<(Place, f64)> {
    (0..scene.lights.len()).find_map(|i| {
        let point = place_of_light(scene, i)?;
        let seen = place.on_screen(scene.camera.project(scene.image, point)?);
        let is_near = seen.distance(at) <= REACH;
        is_near.then(|| (Place::ROOT.field("lights").item(i), depth(&scene.camera, point)))
    })
}

/// The move along that axis of the world which goes most nearly the same way in the picture.
fn along_nearest_axis(scene: &Scene, by: DVec3) -> DVec3 {
    let across = |v: DVec3| v - scene.camera.forward * v.dot(scene.camera.forward);
    let likeness = |axis: DVec3| {
        let seen = across(axis);
        if seen.length() < 1e-3 { 0.0 } else { (across(by).dot(seen) / seen.length()).abs() }
    };
    let axes = [DVec3::X, DVec3::Y, DVec3::Z];
    let nearest = axes.into_iter().max_by(|a, b| likeness(*a).total_cmp(&likeness(*b))).unwrap_or(DVec3::X);
    along_axis(&scene.camera, by, nearest)
}
