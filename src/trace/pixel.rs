//! One pixel: the six steps of § 6.1 in their order.

use super::beam::Beam;
use super::picture::srgb;
use super::ray::{Ray, Tracer, step};
use super::tree::{RayTree, TreeRecorder};
use crate::record::{Entry, Recorder, What};
use crate::scene::{Rgb, Scene};
use glam::DVec3;

/// The linear colour of a pixel; (0, 0) is the top left one.
pub fn trace_pixel(scene: &Scene, x: u32, y: u32, recorder: &mut impl Recorder) -> Rgb {
    trace_pixel_with(&Tracer::new(scene), x, y, recorder)
}

/// The same with a tracer that is there.
pub(super) fn trace_pixel_with(tracer: &Tracer, x: u32, y: u32, recorder: &mut impl Recorder) -> Rgb {
    let scene = tracer.scene;
    recorder.begin();
    let ray = build_ray(tracer, x, y, recorder);
    let colour = tracer.trace(&ray, recorder);
    place_colour(&ray, colour, recorder);
    let (width, height) = (scene.image.width, scene.image.height);
    recorder.end(|| Entry::new(What::Pixel { x, y, width, height }));
    colour
}

/// The whole story of a pixel, and of nothing else: the pixel is traced again with everything kept.
#[must_use]
pub fn record_pixel(scene: &Scene, x: u32, y: u32) -> RayTree {
    let mut recorder = TreeRecorder::new();
    trace_pixel(scene, x, y, &mut recorder);
    recorder.finish()
}

/// The whole story of a ray that is given instead of a pixel: steps 2 to 5.
#[must_use]
pub fn record_ray(scene: &Scene, origin: DVec3, direction: DVec3) -> RayTree {
    let mut recorder = TreeRecorder::new();
    recorder.begin();
    let tracer = Tracer::new(scene);
    tracer.trace(&tracer.camera_ray(origin, direction), &mut recorder);
    let (origin, direction) = (origin.to_array(), direction.to_array());
    recorder.end(|| Entry::new(What::LooseRay { origin, direction }));
    recorder.finish()
}

/// Step 1: the ray from the eye through the pixel's centre.
fn build_ray(tracer: &Tracer, x: u32, y: u32, recorder: &mut impl Recorder) -> Ray {
    let (camera, image) = (&tracer.scene.camera, tracer.scene.image);
    let place = camera.place(image, f64::from(x) + 0.5, f64::from(y) + 0.5);
    let direction = camera.direction_through(place);
    let beam = tracer.scene.needs_beams.then(|| Box::new(Beam::through_pixel(camera, image, x, y)));
    let ray = Ray { place: Some(place), beam, ..tracer.camera_ray(camera.eye, direction) };
    step(&ray, 1, recorder, |recorder| {
        recorder.note(|| {
            let (across, down) = (f64::from(x) + 0.5, f64::from(y) + 0.5);
            let (width, height) = (f64::from(image.width), f64::from(image.height));
            let h = camera.half_height;
            let a = (2.0 * across / width - 1.0) * h * width / height;
            let b = (1.0 - 2.0 * down / height) * h;
            let size = [("W", width.into()), ("H", height.into()), ("h", h.into())];
            let place = [("x", across.into()), ("y", down.into()), ("a", a.into()), ("b", b.into())];
            let frame = [
                ("right", camera.right.to_array().into()),
                ("up", camera.up.to_array().into()),
                ("forward", camera.forward.to_array().into()),
            ];
            let bindings: Vec<_> = size.into_iter().chain(place).chain(frame).collect();
            tracer
                .describe_ray(&ray)
                .line("a", "(2 x / W − 1) h W / H", &bindings, a)
                .line("b", "(1 − 2 y / H) h", &bindings, b)
                .line("dir", "forward + a right + b up", &bindings, direction.to_array())
        });
    });
    ray
}

/// Step 6: the colour as it is stored.
fn place_colour(ray: &Ray, colour: Rgb, recorder: &mut impl Recorder) {
    step(ray, 6, recorder, |recorder| {
        recorder.note(|| Entry::new(What::Written { linear: colour.to_array(), srgb: srgb(colour) }));
    });
}
