//! What the pointer takes hold of.

use crate::app::edit::editing::Editing;
use crate::app::edit::frame_box::place_of_light;
use crate::app::edit::mover::Way;
use crate::app::picture::placement::Placement;
use crate::document::{Place, TargetKind, depth, object_and_leaf, object_at};
use crate::record::{NullRecorder, What};
use crate::scene::Scene;
use crate::trace::record_pixel;
use crate::view::PlaneView;
use egui::{Pos2, Vec2, vec2};
use glam::DVec3;

/// How near to the mark of a light or of the eye the pointer takes it, in points.
const REACH: f32 = 14.0;

/// A thing that is held.
pub struct Grasp {
    /// Where it stands in the text.
    pub place: Place,
    /// What a move of the pointer does to it.
    pub way: Way,
}

/// The camera if that is being edited, else the light or the object under the pointer, or the part of it that is being edited.
pub fn in_picture(editing: &Editing, scene: &Scene, place: &Placement, at: Pos2) -> Option<Grasp> {
    let pixels = f64::from(place.size[0]) / f64::from(place.rect.width());
    let way = |depth, opposite| Way::Picture { camera: scene.camera, image: scene.image, depth, pixels, opposite };
    if let Some(camera) = editing.target().filter(|target| target.kind == TargetKind::Camera) {
        return Some(Grasp { place: camera.place.clone(), way: way(editing.depth_of_view(scene), true) });
    }
    let seen = |point| scene.camera.project(scene.image, point).map(|pixel| place.on_screen(pixel));
    if let Some((light, point)) = light_near(scene, |point| seen(point).map(|spot| spot.distance(at))) {
        return Some(Grasp { place: light, way: way(depth(&scene.camera, point), false) });
    }
    let [x, y] = place.pixel_at(at)?;
    let hit = record_pixel(scene, x, y).events.into_iter().find_map(|event| match event.what {
        What::Hit { object, leaf, point, .. } => Some((object, leaf, DVec3::from_array(point))),
        _ => None,
    });
    let (object, leaf, point) = hit?;
    let (index, _) = object_and_leaf(&scene.objects, &object, &leaf)?;
    Some(Grasp { place: chosen_part(editing, index), way: way(depth(&scene.camera, point), false) })
}

/// The eye, a light or an object under the pointer; the smallest of those that hold the point.
pub fn in_section(editing: &Editing, scene: &Scene, plane: &PlaneView, at: Vec2) -> Option<Grasp> {
    let way = Way::Section(*plane);
    #[expect(clippy::cast_possible_truncation, reason = "screen coordinates are f32")]
    let distance = |point: DVec3| {
        let [x, y] = plane.spot(point);
        (vec2(x as f32, y as f32) - at).length()
    };
    if distance(scene.camera.eye) <= REACH {
        return Some(Grasp { place: Place::ROOT.field("camera"), way });
    }
    if let Some((light, _)) = light_near(scene, |point| Some(distance(point))) {
        return Some(Grasp { place: light, way });
    }
    let point = plane.world([f64::from(at.x), f64::from(at.y)]);
    let holds = |index: &usize| {
        let solid = &scene.objects[*index].solid;
        solid.inside::<f64>(point, plane.normal, &mut NullRecorder).contains(0.0)
    };
    let size = |index: &usize| {
        let extent = scene.objects[*index].solid.extent();
        (extent.high - extent.low).length()
    };
    let index = (0..scene.objects.len()).filter(holds).min_by(|a, b| size(a).total_cmp(&size(b)))?;
    Some(Grasp { place: chosen_part(editing, index), way })
}

/// The object of this number, or the part of it that is being edited.
fn chosen_part(editing: &Editing, index: usize) -> Place {
    let part = editing.movable().filter(|target| object_at(target) == Some(index));
    part.unwrap_or_else(|| Place::ROOT.field("objects").item(index))
}

/// The light whose mark is near the pointer, with where it is.
fn light_near(scene: &Scene, distance: impl Fn(DVec3) -> Option<f32>) -> Option<(Place, DVec3)> {
    (0..scene.lights.len()).find_map(|i| {
        let point = place_of_light(scene, i)?;
        let is_near = distance(point)? <= REACH;
        is_near.then(|| (Place::ROOT.field("lights").item(i), point))
    })
}
