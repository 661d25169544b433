//! Moving things in the picture and in the side view, by the pointer and by keys.

use crate::app::edit::editing::Editing;
use crate::app::edit::frame_box::place_of_light;
use crate::app::edit::grasp::{self, Grasp};
use crate::app::frame::words::{say, say_with};
use crate::app::picture::placement::Placement;
use crate::document::{Cause, Place, Step, across_view, along_nearest_axis, decimals_for, depth, moved, object_at};
use crate::scene::{Camera, Image, Scene};
use crate::view::PlaneView;
use egui::{Context, CursorIcon, Id, Key, Modifiers, Pos2, Rect, Response, Sense, Ui, Vec2};
use glam::DVec3;
use serde_json::Value;

/// A key moves a thing by this part of the picture's width.
const KEY_STEP: f64 = 0.02;

/// Whether things are being moved, and the one that is.
#[derive(Debug, Default)]
pub struct Mover {
    /// Whether a drag moves things.
    pub is_on: bool,
    drag: Option<Drag>,
    /// The number of the gesture, so that each is a change of its own.
    gesture: u32,
}

/// A thing on its way.
#[derive(Clone, Debug)]
struct Drag {
    place: Place,
    way: Way,
    from: Pos2,
    /// The values before.
    whole: Value,
}

/// What a move of the pointer is in the world: as things were when it began.
#[derive(Clone, Debug)]
pub enum Way {
    /// Across the picture, at a depth.
    Picture {
        /// The eye.
        camera: Camera,
        /// The picture.
        image: Image,
        /// How far away along the view.
        depth: f64,
        /// Pixels of the picture for a point of the screen.
        pixels: f64,
        /// Whether the thing goes the other way: with the eye, all else is seen to move.
        opposite: bool,
    },
    /// In the plane of the side view.
    Section(PlaneView),
}

impl Way {
    fn vector(&self, points: Vec2) -> DVec3 {
        let [x, y] = [f64::from(points.x), f64::from(points.y)];
        match self {
            Self::Picture { camera, image, depth, pixels, opposite } => {
                let by = across_view(camera, *image, *depth, [x * pixels, y * pixels]);
                if *opposite { -by } else { by }
            }
            Self::Section(plane) => (plane.across * x - plane.up * y) / plane.scale,
        }
    }

    fn towards(&self) -> DVec3 {
        match self {
            Self::Picture { camera, .. } => camera.forward,
            Self::Section(plane) => plane.normal,
        }
    }
}

impl Editing {
    /// Lets things be dragged in the picture that is seen at `place`.
    pub fn move_in_picture(&mut self, ui: &Ui, scene: &Scene, place: &Placement) {
        let begin = |editing: &Self, from| grasp::in_picture(editing, scene, place, from);
        self.move_by_pointer(ui, "move in picture", place.rect, begin);
    }

    /// Lets things be dragged in the side view.
    pub fn move_in_section(&mut self, ui: &Ui, scene: &Scene, rect: Rect, plane: &PlaneView) {
        let begin = |editing: &Self, from: Pos2| grasp::in_section(editing, scene, plane, from - rect.min);
        self.move_by_pointer(ui, "move in side view", rect, begin);
    }

    fn move_by_pointer(&mut self, ui: &Ui, name: &str, rect: Rect, begin: impl FnOnce(&Self, Pos2) -> Option<Grasp>) {
        if !self.mover.is_on {
            self.mover.drag = None;
            return;
        }
        let response = ui.interact(rect, ui.scope_id().with(name), Sense::drag());
        let response = response.on_hover_and_drag_cursor(CursorIcon::Move);
        if response.drag_started()
            && let Some(from) = ui.input(|input| input.pointer.press_origin())
        {
            self.mover.gesture += 1;
            let held = begin(self, from);
            self.mover.drag = held.map(|Grasp { place, way }| {
                self.choose(place.clone());
                Drag { place, way, from, whole: self.analysis.whole.clone() }
            });
        }
        self.go_on_dragging(ui, &response);
        if response.drag_stopped() {
            self.mover.drag = None;
            self.document.seal();
        }
    }

    fn go_on_dragging(&mut self, ui: &Ui, response: &Response) {
        let (Some(now), Some(drag)) = (response.interact_pointer_pos(), self.mover.drag.clone()) else { return };
        if !response.dragged() {
            return;
        }
        let by = drag.way.vector(now - drag.from);
        let locked = ui.input(|input| input.modifiers.shift);
        let by = if locked { along_nearest_axis(drag.way.towards(), by) } else { by };
        let decimals = decimals_for(drag.way.vector(Vec2::X).length());
        let gesture = format!("move {}", self.mover.gesture);
        self.move_thing(ui.ctx(), &drag.whole, &drag.place, by, gesture, decimals);
    }

    fn move_thing(&mut self, ctx: &Context, whole: &Value, thing: &Place, by: DVec3, gesture: String, decimals: i32) {
        let Some(settings) = moved(whole, thing, by, decimals) else { return };
        let target = self.analysis.targets.iter().find(|target| target.place == *thing);
        let name = target.map_or_else(|| thing.to_string(), |target| target.name.clone());
        let name = if name.is_empty() { say(ctx, "edit-camera") } else { name };
        let cause = say_with(ctx, "edit-cause-move", &[("thing", (&name).into())]);
        self.set(&settings, &Cause::part_of(cause, gesture));
    }

    /// Lets keys move what is being edited, while the picture has the focus: arrows across it, Page Up and Page Down away and nearer.
    pub fn move_by_keys(&mut self, ctx: &Context, scene: &Scene, picture: Id) {
        if !self.mover.is_on || ctx.memory(egui::Memory::focused) != Some(picture) {
            return;
        }
        let Some(thing) = self.movable() else { return };
        let (camera, image) = (&scene.camera, scene.image);
        let step = KEY_STEP * f64::from(image.width);
        let across = |right: f64, down: f64| {
            across_view(camera, image, self.depth_of(scene, &thing), [right * step, down * step])
        };
        let size = across(1.0, 0.0).length();
        let moves = [
            (Key::ArrowLeft, across(-1.0, 0.0)),
            (Key::ArrowRight, across(1.0, 0.0)),
            (Key::ArrowUp, across(0.0, -1.0)),
            (Key::ArrowDown, across(0.0, 1.0)),
            (Key::PageUp, camera.forward * size),
            (Key::PageDown, camera.forward * -size),
        ];
        for (key, by) in moves {
            let pressed = |modifiers| ctx.input_mut(|input| input.consume_key(modifiers, key));
            let locked = pressed(Modifiers::SHIFT);
            if !locked && !pressed(Modifiers::NONE) {
                continue;
            }
            // Away from the eye, an axis is told by the direction itself.
            let by = if locked { along_nearest_axis(DVec3::ZERO, by) } else { by };
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
    pub fn depth_of_view(&self, scene: &Scene) -> f64 {
        let look_at = self.analysis.whole.pointer("/camera/look_at").and_then(|value| {
            let numbers: Vec<f64> = value.as_array()?.iter().map(Value::as_f64).collect::<Option<_>>()?;
            <[f64; 3]>::try_from(numbers).ok().map(DVec3::from_array)
        });
        depth(&scene.camera, look_at.unwrap_or(DVec3::ZERO)).max(1e-3)
    }
}
