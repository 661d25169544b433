//! One pixel: the six steps of § 6.1 in their order.

use super::beam::Beam;
use super::calls::Repertoire;
use super::encoding::srgb;
use super::ray::{Ray, Tracer, describe_step};
use super::tree::{RayTree, TreeRecorder};
use crate::record::{Binding, Entry, Recorder, What};
use crate::sample::Stream;
use crate::scene::{Camera, Glance, Image, Rgb, Scene};
use glam::DVec3;

/// The linear colour of a pixel; (0, 0) is the top left one.
pub fn trace_pixel(scene: &Scene, x: u32, y: u32, recorder: &mut impl Recorder) -> Rgb {
    trace_pixel_with(&Tracer::new(scene), x, y, recorder)
}

/// The same with a tracer that is there.
pub fn trace_pixel_with<R: Recorder>(tracer: &Tracer, x: u32, y: u32, recorder: &mut R) -> Rgb {
    match tracer.opaque() {
        // What is told does not depend on it, and one copy of the code that tells is enough.
        Some(opaque) if !R::RECORDING => trace_pixel_as(&opaque, [x, y], recorder),
        _ => trace_pixel_as(tracer, [x, y], recorder),
    }
}

/// The same with the effects of a repertoire.
fn trace_pixel_as<E: Repertoire>(tracer: &Tracer<E>, [x, y]: [u32; 2], recorder: &mut impl Recorder) -> Rgb {
    let scene = tracer.scene;
    recorder.begin();
    let stream = Stream::of_pixel([x, y], scene.sampling.seed);
    let colour = if tracer.takes_samples() {
        tracer.trace_samples([x, y], stream, recorder)
    } else {
        let ray = tracer.build_ray(&Aim::centre([x, y], stream), recorder);
        tracer.trace(&ray, recorder)
    };
    place_colour(colour, recorder);
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
    trace_ray(scene, origin, direction, &mut recorder);
    recorder.finish()
}

/// The linear colour that a ray brings back which is given instead of a pixel.
pub fn trace_ray(scene: &Scene, origin: DVec3, direction: DVec3, recorder: &mut impl Recorder) -> Rgb {
    recorder.begin();
    let tracer = Tracer::new(scene);
    let colour = tracer.trace(&tracer.camera_ray(origin, direction), recorder);
    let (origin, direction) = (origin.to_array(), direction.to_array());
    recorder.end(|| Entry::new(What::LooseRay { origin, direction }));
    colour
}

/// What a ray from the eye is to pass through.
#[derive(Clone, Copy, Debug)]
pub(super) struct Aim {
    /// The point of the picture, in pixels from its top left corner.
    pub at: [f64; 2],
    /// The side of the square about it that is this ray's share of the picture, in pixels.
    pub beam_side: f64,
    /// The point of the lens's opening that it starts from, in units of the lens's radius, where there is a lens.
    pub on_lens: Option<[f64; 2]>,
    /// The random numbers.
    pub stream: Stream,
}

impl Aim {
    /// The centre of a pixel, for all of the pixel.
    pub fn centre([x, y]: [u32; 2], stream: Stream) -> Self {
        Self { at: [f64::from(x) + 0.5, f64::from(y) + 0.5], beam_side: 1.0, on_lens: None, stream }
    }
}

impl<E: Repertoire> Tracer<'_, E> {
    /// Step 1: the ray from the eye through a point of the picture.
    #[inline(always)]
    pub(super) fn build_ray(&self, aim: &Aim, recorder: &mut impl Recorder) -> Ray {
        recorder.event(|recorder| self.build_ray_within(aim, recorder), |_| Entry::new(describe_step(1)))
    }

    #[inline(always)]
    fn build_ray_within(&self, aim: &Aim, recorder: &mut impl Recorder) -> Ray {
        let (camera, image) = (&self.scene.camera, self.scene.image);
        let place = camera.place(image, aim.at[0], aim.at[1]);
        let direction = camera.direction_through(place);
        let beam = self.scene.needs_beams.then(|| {
            let corner = aim.at.map(|middle| middle - 0.5 * aim.beam_side);
            Beam::through_square(camera, image, corner, aim.beam_side)
        });
        if let (Some(lens), Some(at)) = (self.lens(), aim.on_lens) {
            return self.ray_through_lens(lens, at, aim, place, beam, recorder);
        }
        let ray = Ray {
            place: Some(Glance { place, on_lens: None }),
            beam: beam.map(Box::new),
            stream: aim.stream,
            ..self.camera_ray(camera.eye, direction)
        };
        recorder.note(|| {
            let [a, b] = place;
            let frame = [("a", a.into()), ("b", b.into())].into_iter().chain(frame_bindings(camera));
            let bindings: Vec<_> = frame.collect();
            place_lines(self.describe_ray(&ray), camera, image, aim.at).line(
                "dir",
                "forward + a right + b up",
                &bindings,
                direction.to_array(),
            )
        });
        ray
    }
}

/// The axes of the camera, for lines of working.
pub(super) fn frame_bindings(camera: &Camera) -> [Binding; 3] {
    [
        ("right", camera.right.to_array().into()),
        ("up", camera.up.to_array().into()),
        ("forward", camera.forward.to_array().into()),
    ]
}

/// Adds how a point of the picture is taken to the image plane.
pub(super) fn place_lines(entry: Entry, camera: &Camera, image: Image, [x, y]: [f64; 2]) -> Entry {
    let (width, height) = (f64::from(image.width), f64::from(image.height));
    let h = camera.half_height;
    let a = (2.0 * x / width - 1.0) * h * width / height;
    let b = (1.0 - 2.0 * y / height) * h;
    let bindings = [("W", width.into()), ("H", height.into()), ("h", h.into()), ("x", x.into()), ("y", y.into())];
    entry.line("a", "(2 x / W − 1) h W / H", &bindings, a).line("b", "(1 − 2 y / H) h", &bindings, b)
}

/// Step 6: the colour as it is stored.
fn place_colour(colour: Rgb, recorder: &mut impl Recorder) {
    let written = |recorder: &mut _| write_colour(colour, recorder);
    recorder.event(written, |()| Entry::new(describe_step(6)));
}

fn write_colour(colour: Rgb, recorder: &mut impl Recorder) {
    recorder.note(|| Entry::new(What::Written { linear: colour.to_array(), srgb: srgb(colour) }));
}
