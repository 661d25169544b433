//! What can be wrong with the ray through a pixel.

use super::{
    ASPECT, Case, FIELD_OF_VIEW, Guess, PICTURE_MIRRORED, PICTURE_UPSIDE_DOWN, PIXEL_CORNER, PIXEL_SHIFTED,
    VIEW_BACKWARDS, number,
};
use crate::math::portable;
use crate::record::What;
use glam::DVec3;

/// Guesses about the direction of the ray from the eye.
pub fn of_direction(case: Case, guesses: &mut Vec<Guess>) {
    let Some(What::Pixel { x, y, .. }) = case.ours.tree.events.first().map(|event| &event.what) else {
        return of_loose_ray(case, guesses);
    };
    let scene = case.ours.scene;
    let (camera, image) = (&scene.camera, scene.image);
    let (x, y) = (f64::from(*x), f64::from(*y));
    let (width, height) = (f64::from(image.width), f64::from(image.height));
    let through = |a: f64, b: f64| camera.ray_direction(image, a, b);
    let place = |a: f64, b: f64| format!("through ({}, {}): dir", number(a), number(b));
    for (cause, a, b) in [
        (&PIXEL_CORNER, x, y),
        (&PIXEL_CORNER, x + 1.0, y + 1.0),
        (&PIXEL_CORNER, x + 0.5, y),
        (&PIXEL_CORNER, x, y + 0.5),
        (&PIXEL_SHIFTED, x - 0.5, y - 0.5),
        (&PIXEL_SHIFTED, x + 1.5, y + 1.5),
        (&PIXEL_SHIFTED, y + 0.5, x + 0.5),
        (&PICTURE_UPSIDE_DOWN, x + 0.5, height - y - 0.5),
        (&PICTURE_UPSIDE_DOWN, x + 0.5, height - y + 0.5),
        (&PICTURE_UPSIDE_DOWN, x + 0.5, height - y - 1.5),
        (&PICTURE_MIRRORED, width - x - 0.5, y + 0.5),
        // A picture whose first and last columns lie on its edges.
        (&PIXEL_CORNER, x * width / (width - 1.0).max(1.0), y * height / (height - 1.0).max(1.0)),
    ] {
        guesses.push(Guess::vector(cause, place(a, b), through(a, b)));
    }
    of_frame(case, [x + 0.5, y + 0.5], guesses);
    let ours = case.direction();
    guesses.push(Guess::vector(&VIEW_BACKWARDS, "−dir", -ours));
    let beside = ours - 2.0 * ours.dot(camera.forward) * camera.forward;
    guesses.push(Guess::vector(&VIEW_BACKWARDS, "−forward + a right + b up", beside));
}

/// Guesses about how a point of the picture is taken to the image plane.
fn of_frame(case: Case, [x, y]: [f64; 2], guesses: &mut Vec<Guess>) {
    let scene = case.ours.scene;
    let camera = &scene.camera;
    let (width, height) = (f64::from(scene.image.width), f64::from(scene.image.height));
    let [across, up] = [2.0 * x / width - 1.0, 1.0 - 2.0 * y / height];
    let h = camera.half_height;
    let plane = |a: f64, b: f64| camera.forward + camera.right * a + camera.up * b;
    let whole = portable::tan(2.0 * portable::atan(h));
    let degrees = portable::atan(h).to_degrees();
    let ratio = width / height;
    for (cause, how, a, b) in [
        (&ASPECT, "a = (2 x / W − 1) h, without W / H: dir", across * h, up * h),
        (&ASPECT, "a = (2 x / W − 1) h H / W: dir", across * h / ratio, up * h),
        (&FIELD_OF_VIEW, "the angle taken horizontally, b = (1 − 2 y / H) h H / W: dir", across * h, up * h / ratio),
        (&FIELD_OF_VIEW, "h = tan of the whole angle: dir", across * whole * ratio, up * whole),
        (
            &FIELD_OF_VIEW,
            "h = tan of a number of degrees: dir",
            across * portable::tan(degrees) * ratio,
            up * portable::tan(degrees),
        ),
        (&FIELD_OF_VIEW, "h = the half angle itself: dir", across * portable::atan(h) * ratio, up * portable::atan(h)),
        (&FIELD_OF_VIEW, "h twice as large: dir", across * 2.0 * h * ratio, up * 2.0 * h),
        (&FIELD_OF_VIEW, "h half as large: dir", across * 0.5 * h * ratio, up * 0.5 * h),
    ] {
        guesses.push(Guess::vector(cause, how, plane(a, b)));
    }
}

fn of_loose_ray(case: Case, guesses: &mut Vec<Guess>) {
    let backwards: DVec3 = -case.direction();
    guesses.push(Guess::vector(&VIEW_BACKWARDS, "−dir", backwards));
}
