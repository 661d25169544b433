//! Prints what a person waits for in every scene that comes with the program, beside what is promised: from the scene's text
//! to its first coarse picture, and from a click on a pixel to the tree of its events. `cargo bench --bench latency`.

use rayscope::scene::{EmbeddedScene, Scene, embedded_scene, embedded_scenes, load};
use rayscope::trace::{FIRST_BLOCK, Progress, RayTree, record_pixel, render_rows};
use std::hint::black_box;
use std::time::Instant;

/// Milliseconds from a scene's text to its first coarse picture.
const PICTURE_BOUND: f64 = 50.0;

/// Milliseconds from a click to its tree, for 95 of 100 pixels: a frame of a 60 Hz screen.
const CLICK_BOUND: f64 = 16.0;

/// Milliseconds for the fishbowl's telling pixel with rays up to depth 5.
const FISHBOWL_BOUND: f64 = 1.0;

/// Pixels that are clicked: columns and rows.
const CLICKS: [u32; 2] = [20, 15];

/// How often a picture is begun and the fishbowl recorded; the median counts. Fewer are noisier, more take longer.
const TURNS: usize = 15;

fn main() {
    println!("milliseconds; the bound for each column stands below its name, and `over` behind what is beyond it");
    println!("{:28}{:>22}{:>42}{:>10}", "", "text to first picture", "click to tree", "most");
    println!("{:28}{:>22}{:>12}{:>16}{:>14}{:>10}", "scene", "median", "50 %", "95 %", "worst", "events");
    println!("{:28}{:>17}     {:>28}", "bound", PICTURE_BOUND, CLICK_BOUND);
    for embedded in embedded_scenes() {
        print_scene(&embedded);
    }
    let fishbowl = embedded_scene("optics/fishbowl").expect("the fishbowl comes with the program");
    print_fishbowl(compiled(&fishbowl));
}

fn compiled(embedded: &EmbeddedScene) -> Scene {
    load(black_box(embedded.text), &embedded.name).expect("embedded scenes have no errors")
}

fn print_scene(embedded: &EmbeddedScene) {
    let picture = Spread::of((0..TURNS).map(|_| first_picture(embedded)).collect());
    let (clicks, most_events) = clicks(&compiled(embedded));
    println!(
        "{:28}{:>17.2} {:4}{:>12.3}{:>11.3} {:4}{:>14.3}{most_events:>10}",
        embedded.name,
        picture.at(0.5),
        over(picture.at(0.5), PICTURE_BOUND),
        clicks.at(0.5),
        clicks.at(0.95),
        over(clicks.at(0.95), CLICK_BOUND),
        clicks.at(1.0),
    );
}

/// The depth-5 tree, and the one with the depth that the scene itself asks for.
fn print_fishbowl(mut scene: Scene) {
    let [x, y] = scene.pixels[0];
    println!("\nrecording the fishbowl at ({x}, {y})");
    for (depth, bound) in [(5, Some(FISHBOWL_BOUND)), (scene.limits.depth, None)] {
        scene.limits.depth = depth;
        let mut tree = record_pixel(&scene, x, y);
        let taken = Spread::of((0..20 * TURNS).map(|_| click(&scene, [x, y], &mut tree)).collect());
        let beside = bound.map(|bound| format!(" (bound {bound}) {}", over(taken.at(0.5), bound))).unwrap_or_default();
        let events = tree.events.len();
        println!("depth {depth:2}: {events} events, median {:.3}, 95 % {:.3}{beside}", taken.at(0.5), taken.at(0.95));
    }
}

/// What the workbench does between the text and the first picture that it shows.
fn first_picture(embedded: &EmbeddedScene) -> f64 {
    let start = Instant::now();
    let scene = compiled(embedded);
    let progress = Progress::new();
    let mut taken = 0.0;
    let _ = render_rows(&scene, FIRST_BLOCK, &progress, |picture, _| {
        black_box(picture.to_rgb8());
        taken = milliseconds_since(start);
        progress.cancel();
    });
    taken
}

/// Clicks all over the picture; what they took, and the number of events of the largest tree.
fn clicks(scene: &Scene) -> (Spread, usize) {
    let [columns, rows] = CLICKS;
    let middle = |k: u32, parts: u32, length: u32| (2 * k + 1) * length / (2 * parts);
    let across = |row: u32| (0..columns).map(move |column| (column, row));
    let mut tree = record_pixel(scene, 0, 0);
    let mut most = 0;
    let taken = (0..rows).flat_map(across).map(|(column, row)| {
        let pixel = [middle(column, columns, scene.image.width), middle(row, rows, scene.image.height)];
        let taken = click(scene, pixel, &mut tree);
        most = most.max(tree.events.len());
        taken
    });
    (Spread::of(taken.collect()), most)
}

/// A click replaces the tree before it, which takes its time too.
fn click(scene: &Scene, [x, y]: [u32; 2], tree: &mut RayTree) -> f64 {
    let start = Instant::now();
    *tree = record_pixel(scene, black_box(x), black_box(y));
    milliseconds_since(start)
}

fn milliseconds_since(start: Instant) -> f64 {
    start.elapsed().as_secs_f64() * 1e3
}

const fn over(milliseconds: f64, bound: f64) -> &'static str {
    if milliseconds > bound { "over" } else { "" }
}

/// Times, ascending.
struct Spread(Vec<f64>);

impl Spread {
    fn of(mut times: Vec<f64>) -> Self {
        times.sort_by(f64::total_cmp);
        Self(times)
    }

    /// The time that this share of all times does not exceed.
    fn at(&self, share: f64) -> f64 {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a place in the list")]
        let place = (share * (self.0.len() - 1) as f64).ceil() as usize;
        self.0[place]
    }
}
