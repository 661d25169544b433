//! A thin lens in place of the pinhole (§ 6.1, step 1), and how far it blurs what is out of focus.
//!
//! All rays for one place of the picture meet in one point of the plane of focus, wherever on the lens they start. The
//! direction keeps the length at which t is the depth along the view, as for a pinhole.
//!
//! **Source** M. Potmesil, I. Chakravarty, A Lens and Aperture Camera Model for Synthetic Image Generation (SIGGRAPH 1981), for
//! the circle of confusion; R. Cook, T. Porter, L. Carpenter, Distributed Ray Tracing (SIGGRAPH 1984), for the rays.

use super::beam::Beam;
use super::calls::Repertoire;
use super::closest::Surface;
use super::pixel::{Aim, frame_bindings, place_lines};
use super::ray::{Ray, Tracer};
use crate::record::{Confusion, Effect, Entry, Recorder, What};
use crate::sample::{Aperture, Purpose, Stream, concentric_disc};
use crate::scene::{Glance, Lens};
use glam::DVec3;

/// Points of the lens that are worked out together. More would be idle where a pixel takes few samples.
pub(super) const LENS_POINTS: usize = 8;

impl<'a, E: Repertoire> Tracer<'a, E> {
    /// The lens, where the scene calls for one.
    pub(super) fn lens(&self) -> Option<&'a Lens> {
        let scene = self.scene;
        if self.calls_for(Effect::DepthOfField) { scene.lens.as_deref() } else { None }
    }

    /// The ray through a point of the lens and the place on the image plane. With d the direction from the middle of the
    /// lens, F = E + f d is in focus; L = E + r (x right + y up) is the point of the lens, and the direction is
    /// (F − L) / f = d − (L − E) / f.
    #[inline(never)]
    pub(super) fn ray_through_lens(
        &self,
        lens: &Lens,
        at: [f64; 2],
        aim: &Aim,
        place: [f64; 2],
        beam: Option<Beam>,
        recorder: &mut impl Recorder,
    ) -> Ray {
        let camera = &self.scene.camera;
        Self::enter(Effect::DepthOfField, recorder);
        if self.has_shape(lens) {
            Self::enter(Effect::ApertureShape, recorder);
        }
        let [across, upwards] = at.map(|x| x * lens.radius);
        let offset = camera.right * across + camera.up * upwards;
        let through = |direction: DVec3| direction - offset / lens.focus;
        let straight = camera.direction_through(place);
        let ray = Ray {
            place: Some(Glance { place, on_lens: Some([across, upwards]) }),
            beam: beam.map(|beam| Box::new(beam.map(|[eye, direction]| [eye + offset, through(direction)]))),
            stream: aim.stream,
            ..self.camera_ray(camera.eye + offset, through(straight))
        };
        recorder.note(|| self.describe_lens(lens, at, aim, straight));
        recorder.note(|| {
            let bindings = [
                ("d", straight.to_array().into()),
                ("L", ray.origin.to_array().into()),
                ("E", camera.eye.to_array().into()),
                ("f", lens.focus.into()),
            ];
            self.describe_ray(&ray).line("dir", "d − (L − E) / f", &bindings, ray.direction.to_array())
        });
        ray
    }

    /// The points of the lens's opening, in units of its radius, for the samples of a pixel from `first` on.
    ///
    /// Each takes its time, as every step of it waits for the one before; several side by side take hardly more.
    #[inline(never)]
    pub(super) fn lens_points(&self, lens: &Lens, stream: Stream, first: u32) -> [[f64; 2]; LENS_POINTS] {
        let mut points = [[0.0; 2]; LENS_POINTS];
        for (number, point) in (first..).zip(&mut points) {
            *point = stream.sample(number).square(Purpose::Lens);
        }
        if self.has_shape(lens) {
            return points.map(|square| lens.aperture.point(square));
        }
        for point in &mut points {
            *point = concentric_disc(*point);
        }
        points
    }

    /// Whether the lens's opening is other than a disc, and counts.
    fn has_shape(&self, lens: &Lens) -> bool {
        self.calls_for(Effect::ApertureShape) && lens.aperture != Aperture::Disc
    }

    fn describe_lens(&self, lens: &Lens, at: [f64; 2], aim: &Aim, straight: DVec3) -> Entry {
        let camera = &self.scene.camera;
        let [across, upwards] = at.map(|x| x * lens.radius);
        let point = camera.eye + (camera.right * across + camera.up * upwards);
        let focus = camera.eye + straight * lens.focus;
        let [a, b] = camera.place(self.scene.image, aim.at[0], aim.at[1]);
        let own = [
            ("a", a.into()),
            ("b", b.into()),
            ("d", straight.to_array().into()),
            ("E", camera.eye.to_array().into()),
            ("f", lens.focus.into()),
            ("r", lens.radius.into()),
            ("x", at[0].into()),
            ("y", at[1].into()),
        ];
        let bindings: Vec<_> = own.into_iter().chain(frame_bindings(camera)).collect();
        let entry = Entry::new(What::Lens(crate::record::Lens {
            aperture: lens.aperture.name().to_owned(),
            outline: lens.aperture.outline(),
            radius: lens.radius,
            focus_distance: lens.focus,
            at,
            eye: camera.eye.to_array(),
            forward: camera.forward.to_array(),
            point: point.to_array(),
            focus: focus.to_array(),
        }));
        place_lines(entry, camera, self.scene.image, aim.at)
            .line("d", "forward + a right + b up", &bindings, straight.to_array())
            .line("F", "E + f d", &bindings, focus.to_array())
            .line("L", "E + r (x right + y up)", &bindings, point.to_array())
    }

    /// Tells how far a hit of a ray from the eye is spread over the picture.
    #[inline(never)]
    pub(super) fn note_confusion(&self, ray: &Ray, surface: &Surface, recorder: &mut impl Recorder) {
        let Some(lens) = self.lens() else { return };
        if ray.place.is_none_or(|glance| glance.on_lens.is_none()) {
            return;
        }
        recorder.note(|| {
            let (camera, image) = (&self.scene.camera, self.scene.image);
            let depth = (surface.point - camera.eye).dot(camera.forward);
            let diameter = 2.0 * lens.radius * (depth - lens.focus).abs() / (depth * lens.focus);
            let height = f64::from(image.height);
            let pixels = diameter * height / (2.0 * camera.half_height);
            let bindings = [
                ("P", surface.point.to_array().into()),
                ("E", camera.eye.to_array().into()),
                ("forward", camera.forward.to_array().into()),
                ("r", lens.radius.into()),
                ("z", depth.into()),
                ("f", lens.focus.into()),
                ("c", diameter.into()),
                ("H", height.into()),
                ("h", camera.half_height.into()),
            ];
            Entry::new(What::Confusion(Confusion { depth, diameter, pixels }))
                .line("z", "(P − E) · forward", &bindings, depth)
                .line("c", "2 r |z − f| / (z f)", &bindings, diameter)
                .line("pixels", "c H / (2 h)", &bindings, pixels)
        });
    }
}
