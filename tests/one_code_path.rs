//! Watching does not change what is watched: pictures and recorded pixels come from one tracing function.

use rayscope::record::{NullRecorder, RayKind};
use rayscope::scene::{Image, Scene, embedded_scenes, load};
use rayscope::trace::{Progress, record_pixel, render, render_rows, trace_pixel};

/// Every embedded scene, small enough that each of its pixels can be recorded.
fn small_scenes() -> Vec<(String, Scene)> {
    let small = |text: &str, name: &str| {
        let mut scene = load(text, name).unwrap_or_else(|errors| panic!("{errors}"));
        scene.image = Image { width: 37, height: 28 };
        scene
    };
    embedded_scenes().into_iter().map(|scene| (scene.name.clone(), small(scene.text, &scene.name))).collect()
}

fn in_pool<T: Send>(threads: usize, work: impl FnOnce() -> T + Send) -> T {
    rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a thread pool").install(work)
}

#[test]
fn a_recorded_pixel_has_the_pictures_colour_bit_for_bit() {
    for (name, scene) in small_scenes() {
        let (picture, _) = render(&scene, &Progress::new());
        for y in 0..scene.image.height {
            for x in 0..scene.image.width {
                let unwatched = trace_pixel(&scene, x, y, &mut NullRecorder).to_array().map(f64::to_bits);
                let root = record_pixel(&scene, x, y).colour().map(f64::to_bits);
                let in_picture = picture.pixel(x, y).to_array().map(f64::to_bits);
                assert_eq!(root, unwatched, "{name}: the recorded colour at {x},{y}");
                assert_eq!(root, in_picture, "{name}: the picture's colour at {x},{y}");
            }
        }
    }
}

#[test]
fn the_number_of_threads_does_not_change_a_byte() {
    for (name, scene) in small_scenes() {
        let alone = in_pool(1, || render(&scene, &Progress::new()));
        for threads in [2, 7] {
            let together = in_pool(threads, || render(&scene, &Progress::new()));
            assert_eq!(alone, together, "{name} on {threads} threads");
        }
    }
}

#[test]
fn coarse_to_fine_ends_in_the_same_picture_and_traces_each_pixel_once() {
    for (name, scene) in small_scenes() {
        let (at_once, tally) = render(&scene, &Progress::new());
        let mut passes = Vec::new();
        let progress = Progress::new();
        let (in_passes, tally_in_passes) = render_rows(&scene, 8, &progress, |_, side| passes.push(side));
        assert_eq!(passes, [8, 4, 2, 1], "{name}");
        assert_eq!(at_once, in_passes, "{name}");
        assert_eq!(tally, tally_in_passes, "{name}");
        let pixels = (scene.image.width * scene.image.height) as usize;
        assert_eq!((progress.done(), in_passes.computed()), (pixels, pixels), "{name}");
        let (rays, least) = (tally.rays(RayKind::Camera), pixels as u64 * u64::from(scene.sampling.samples));
        assert!(rays == least || scene.sampling.adaptive.is_some() && rays > least, "{name}: {rays} rays");
    }
}

#[test]
fn a_cancelled_picture_stops_and_keeps_its_size() {
    let (_, scene) = small_scenes().remove(0);
    let progress = Progress::new();
    progress.cancel();
    let (picture, _) = render(&scene, &progress);
    assert_eq!((picture.computed(), picture.width), (0, scene.image.width));
}
