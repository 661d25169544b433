//! What is found out about one pixel.

use super::Quantity;
use crate::laboratory::digits_lost;
use crate::record::{RayKind, What};
use crate::scene::Glance;
use crate::trace::{Ray, Surface, Tally, Tracer, TreeRecorder, trace_pixel_with};

/// A number, with two zeros behind it; or a unit vector in world space.
pub type Cell = [f64; 3];

/// Nothing to tell.
pub const NOTHING: Cell = [f64::NAN; 3];

/// The quantity at a pixel. Times are taken elsewhere.
pub fn of(quantity: Quantity, tracer: &Tracer, pixel: [u32; 2]) -> Cell {
    let number = |number: f64| [number, 0.0, 0.0];
    match quantity {
        Quantity::Rays => number(rays(&tally(tracer, pixel)) as f64),
        Quantity::Tests => number(tests(&tally(tracer, pixel)) as f64),
        Quantity::Depth => number(f64::from(depth(tracer, pixel))),
        Quantity::Digits => number(digits_lost(tracer.scene, pixel)),
        Quantity::Error => seen(tracer, pixel).map_or(NOTHING, |surface| number(surface.boundary.error)),
        Quantity::Object => seen(tracer, pixel).map_or(NOTHING, |surface| number(surface.object as f64)),
        Quantity::Normal => seen(tracer, pixel).map_or(NOTHING, |surface| surface.n_geometric.to_array()),
        Quantity::Time => NOTHING,
    }
}

fn tally(tracer: &Tracer, [x, y]: [u32; 2]) -> Tally {
    let mut tally = Tally::default();
    let _ = trace_pixel_with(tracer, x, y, &mut tally);
    tally
}

fn rays(tally: &Tally) -> u64 {
    RayKind::ALL.into_iter().map(|kind| tally.rays(kind)).sum()
}

fn tests(tally: &Tally) -> u64 {
    tally.extent_tests() + tally.shape_tests().into_iter().map(|(_, count)| count).sum::<u64>()
}

/// Only a pixel that spawns rays has to be recorded for this.
fn depth(tracer: &Tracer, pixel: [u32; 2]) -> u32 {
    let counted = tally(tracer, pixel);
    if [RayKind::Reflected, RayKind::Refracted, RayKind::Scattered].into_iter().all(|kind| counted.rays(kind) == 0) {
        return 0;
    }
    let mut recorder = TreeRecorder::new();
    let _ = trace_pixel_with(tracer, pixel[0], pixel[1], &mut recorder);
    let depth = |what: &What| match what {
        What::Ray { ray, depth, .. } if *ray != RayKind::Shadow => Some(*depth),
        _ => None,
    };
    recorder.finish().events.iter().filter_map(|event| depth(&event.what)).max().unwrap_or(0)
}

/// What the ray from the middle of the lens through the middle of the pixel sees.
fn seen(tracer: &Tracer, [x, y]: [u32; 2]) -> Option<Surface> {
    let (camera, image) = (&tracer.scene.camera, tracer.scene.image);
    let place = camera.place(image, f64::from(x) + 0.5, f64::from(y) + 0.5);
    let ray = tracer.camera_ray(camera.eye, camera.direction_through(place));
    tracer.first_surface(&Ray { place: Some(Glance { place, on_lens: None }), ..ray })
}
