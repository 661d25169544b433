//! The hits of a recorded pixel's rays over the picture, as triangles that are kept from frame to frame.
//!
//! A deep tree has thousands of hits. Each step adds one at most, or takes one away; only those are worked out.

use super::placement::Placement;
use crate::app::frame::theme::colour;
use crate::app::story::recording::{HitMark, Recording};
use crate::record::RayKind;
use crate::scene::Scene;
use crate::trace::RayTree;
use egui::epaint::{CircleShape, Mesh, TessellationOptions, Tessellator};
use egui::{Color32, Painter, Rect, Shape, Stroke};
use std::sync::{Arc, Weak};

/// What the triangles were made for.
#[derive(Clone, Debug)]
struct Key {
    tree: Weak<RayTree>,
    rect: Rect,
    pixels_per_point: f32,
}

impl PartialEq for Key {
    fn eq(&self, other: &Self) -> bool {
        let rest = |key: &Self| (key.rect, key.pixels_per_point);
        Weak::ptr_eq(&self.tree, &other.tree) && rest(self) == rest(other)
    }
}

/// The triangles of the hits up to the selected event.
#[derive(Debug, Default)]
pub struct Hits {
    key: Option<Key>,
    mesh: Arc<Mesh>,
    /// For each hit that is in the mesh, how many vertices and indices there were before it.
    before: Vec<[usize; 2]>,
}

impl Hits {
    /// Draws the hits up to the selected event, and the spawned rays that led to them, as the camera sees them.
    pub fn draw(&mut self, painter: &Painter, scene: &Scene, place: &Placement, recording: &Recording) {
        let pixels_per_point = painter.pixels_per_point();
        let key = Key { tree: Arc::downgrade(&recording.tree), rect: place.rect, pixels_per_point };
        if self.key.as_ref() != Some(&key) {
            *self = Self { key: Some(key), ..Self::default() };
        }
        let selected = recording.selected();
        let wanted = recording.hits.partition_point(|hit| hit.event <= selected);
        self.bring_to(wanted, scene, place, recording, pixels_per_point);
        let painter = painter.with_clip_rect(painter.clip_rect().intersect(place.rect));
        painter.add(Shape::Mesh(Arc::clone(&self.mesh)));
    }

    fn bring_to(&mut self, wanted: usize, scene: &Scene, place: &Placement, recording: &Recording, scale: f32) {
        if wanted == self.before.len() {
            return;
        }
        let mesh = Arc::make_mut(&mut self.mesh);
        if let Some(&[vertices, indices]) = self.before.get(wanted) {
            mesh.vertices.truncate(vertices);
            mesh.indices.truncate(indices);
            self.before.truncate(wanted);
            return;
        }
        let mut tessellator = Tessellator::new(scale, TessellationOptions::default(), [1, 1], Vec::new());
        for hit in &recording.hits[self.before.len()..wanted] {
            self.before.push([mesh.vertices.len(), mesh.indices.len()]);
            for shape in shapes(hit, scene, place) {
                tessellator.tessellate_shape(shape, mesh);
            }
        }
    }
}

fn shapes(hit: &HitMark, scene: &Scene, place: &Placement) -> Vec<Shape> {
    let seen = |point| scene.camera.project(scene.image, point).map(|pixel| place.on_screen(pixel));
    let HitMark { kind, from, point, .. } = *hit;
    let Some(at) = seen(point) else { return Vec::new() };
    let mut shapes = Vec::with_capacity(3);
    if let Some(from) = from.and_then(seen) {
        shapes.push(Shape::line_segment([from, at], Stroke::new(3.0, Color32::from_black_alpha(150))));
        shapes.push(Shape::line_segment([from, at], Stroke::new(1.5, ray_colour(kind))));
    }
    if kind != RayKind::Camera {
        let rim = Stroke::new(1.0, Color32::from_black_alpha(200));
        shapes.push(Shape::Circle(CircleShape { center: at, radius: 3.5, fill: ray_colour(kind), stroke: rim }));
    }
    shapes
}

/// Rays have the colours of the drawings on dark ground: with a dark rim they are seen on any colour.
fn ray_colour(kind: RayKind) -> Color32 {
    let palette = crate::view::Theme::Dark.palette();
    colour(match kind {
        RayKind::Camera => palette.camera,
        RayKind::Reflected => palette.reflected,
        RayKind::Refracted => palette.refracted,
        RayKind::Shadow => palette.shadow,
        RayKind::Scattered => palette.scattered,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{embedded_scene, load};
    use egui::{pos2, vec2};

    #[test]
    fn going_on_and_back_leaves_the_triangles_of_a_fresh_start() {
        let scene = load(embedded_scene("optics/glass_cube").unwrap().text, "glass_cube").unwrap();
        let (pixel, scene) = (scene.pixels[0], Arc::new(scene));
        let recording = Recording::new(&scene, pixel);
        let place = Placement { rect: Rect::from_min_size(pos2(0.0, 0.0), vec2(640.0, 480.0)), size: [640, 480] };
        let of = |steps: &[usize]| {
            let mut hits = Hits::default();
            for &wanted in steps {
                hits.bring_to(wanted, &scene, &place, &recording, 1.0);
            }
            (hits.mesh.vertices.clone(), hits.mesh.indices.clone())
        };
        let all = recording.hits.len();
        assert!(all > 4);
        assert_eq!(of(&[1, all, 2, 4, 3]), of(&[3]));
        assert!(of(&[all]).0.len() > of(&[2]).0.len());
        assert_eq!(of(&[all, 0]), (Vec::new(), Vec::new()));
    }
}
