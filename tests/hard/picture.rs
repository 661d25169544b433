//! A picture of ours against the exact answer, pixel by pixel.

use super::line::PixelRay;
use super::truth::{Seen, Truth};
use glam::DVec3;
use rayon::prelude::*;
use rayscope::record::NullRecorder;
use rayscope::scene::{Scene, load};
use rayscope::trace::trace_pixel;
use serde_json::{Value, json};

/// A scene with the truth about it.
pub struct Case {
    /// Its name.
    pub name: String,
    /// The scene: material k is `"k"`, and its pixels have the colour `(k + 1) / 16`.
    pub scene: Scene,
    /// What is right.
    pub truth: Box<dyn Truth>,
}

/// Where the eye is, what it looks at, and the vertical field of view in degrees.
#[derive(Clone, Copy, Debug)]
pub struct View {
    /// Where the eye is.
    pub eye: [f64; 3],
    /// What it looks at.
    pub look_at: [f64; 3],
    /// Degrees.
    pub field: f64,
    /// Columns and rows.
    pub size: [u32; 2],
}

impl View {
    /// A picture of 320 × 240.
    pub const fn new(eye: [f64; 3], look_at: [f64; 3], field: f64) -> Self {
        Self { eye, look_at, field, size: [320, 240] }
    }
}

/// A scene without lights, whose pixels say which material is seen.
pub fn scene(view: View, objects: &[Value]) -> Scene {
    let level = |k: u32| f64::from(k + 1) / 16.0;
    let materials: serde_json::Map<String, Value> =
        (0..8).map(|k| (k.to_string(), json!({"ambient": [level(k), 0, 0], "diffuse": [0, 0, 0]}))).collect();
    let file = json!({
        "camera": {"eye": view.eye, "look_at": view.look_at, "field_of_view": view.field},
        "image": {"width": view.size[0], "height": view.size[1]},
        "background": [0, 0, 0],
        "materials": materials,
        "objects": objects,
    });
    load(&file.to_string(), "case.json").unwrap_or_else(|errors| panic!("{errors}"))
}

/// How the pixels of a case came out.
#[derive(Clone, Debug, Default)]
pub struct Outcome {
    /// Pixels that show something by the exact answer.
    pub shown: usize,
    /// Pixels whose exact answer half-ulp changes of the inputs would change.
    pub undetermined: usize,
    /// Hit times that were compared.
    pub timed: usize,
    /// What is wrong, one line for each pixel.
    pub wrong: Vec<String>,
}

impl Outcome {
    fn and(mut self, other: Self) -> Self {
        self.shown += other.shown;
        self.undetermined += other.undetermined;
        self.timed += other.timed;
        self.wrong.extend(other.wrong);
        self
    }
}

/// Judges every pixel, and the hit time of every seventh in both directions.
pub fn judge(case: &Case) -> Outcome {
    let rows = (0..case.scene.image.height).into_par_iter();
    rows.map(|y| (0..case.scene.image.width).map(|x| pixel(case, x, y)).fold(Outcome::default(), Outcome::and))
        .reduce(Outcome::default, Outcome::and)
}

fn pixel(case: &Case, x: u32, y: u32) -> Outcome {
    let scene = &case.scene;
    let direction = scene.camera.ray_direction(scene.image, f64::from(x) + 0.5, f64::from(y) + 0.5);
    let ray = PixelRay { origin: scene.camera.eye, direction };
    let ours = seen(scene, x, y);
    let exact = case.truth.verdict(scene, ray);
    let mut outcome = Outcome { shown: usize::from(exact.seen.is_some()), ..Outcome::default() };
    if !exact.sure {
        outcome.undetermined = 1;
    } else if ours != exact.seen {
        outcome.wrong.push(report(x, y, ray, &format!("shows {ours:?}, exact {:?}", exact.seen)));
    } else if ours.is_some() && x % 7 == 3 && y % 7 == 3 {
        outcome.timed = 1;
        let t = first_time(scene, ray);
        if let Err(reason) = case.truth.time(scene, ray, t) {
            outcome.wrong.push(report(x, y, ray, &format!("t = {t:e}, exact {reason}")));
        }
    }
    outcome
}

fn report(x: u32, y: u32, ray: PixelRay, what: &str) -> String {
    format!("pixel {x},{y} of the ray {:?} + {:?} t: {what}", ray.origin.to_array(), ray.direction.to_array())
}

/// The material that the picture shows.
fn seen(scene: &Scene, x: u32, y: u32) -> Seen {
    let colour = trace_pixel(scene, x, y, &mut NullRecorder);
    if colour == DVec3::ZERO {
        return None;
    }
    let place = (0..8_u32).position(|k| colour.x == f64::from(k + 1) / 16.0);
    Some(place.unwrap_or_else(|| panic!("the pixel {x},{y} has a colour of no material: {colour}")))
}

/// The hit time of the first boundary in front.
fn first_time(scene: &Scene, ray: PixelRay) -> f64 {
    let lists = scene.objects.iter().map(|o| o.solid.inside::<f64>(ray.origin, ray.direction, &mut NullRecorder));
    let times = lists.flat_map(|list| list.boundaries()).map(|(boundary, _)| boundary.t);
    times.filter(|t| *t > 0.0).fold(f64::INFINITY, f64::min)
}

/// Asserts that no pixel is wrong, that there is something to be wrong about, and that little is undetermined.
pub fn assert_exact(case: &Case, most_undetermined: usize) {
    let outcome = judge(case);
    println!(
        "{}: {} of {} pixels shown, {} undetermined, {} wrong, {} hit times compared",
        case.name,
        outcome.shown,
        case.scene.image.width * case.scene.image.height,
        outcome.undetermined,
        outcome.wrong.len(),
        outcome.timed
    );
    let first = outcome.wrong.iter().take(10).cloned().collect::<Vec<_>>().join("\n");
    assert!(outcome.wrong.is_empty(), "{}: {} wrong:\n{first}", case.name, outcome.wrong.len());
    assert!(
        outcome.undetermined <= most_undetermined,
        "{}: {} pixels are undetermined",
        case.name,
        outcome.undetermined
    );
}
