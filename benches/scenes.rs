//! Times whole scenes: a ray of each peer scene, the recording of a pixel, and compiling against the number of objects.
//! `cargo bench --bench scenes`.

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use rayscope::peer::import;
use rayscope::record::RayKind;
use rayscope::scene::{Image, Scene, embedded_scene, load};
use rayscope::trace::{Progress, record_pixel, render};
use std::fs;
use std::hint::black_box;
use std::path::Path;

/// Columns and rows: enough for all that is in the scenes, few enough for the slowest of them.
const SIZE: Image = Image { width: 160, height: 120 };

const PEERS: [&str; 9] = [
    "a_spheres",
    "b_tori",
    "c_superellipsoids",
    "d_csg",
    "e_glass",
    "f_textures",
    "h_solids",
    "i_scaling_100",
    "i_scaling_10000",
];

/// What is compiled: the same cube with more and more spheres in it.
const SPHERES: [usize; 3] = [100, 1_000, 10_000];

fn text(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/peers/{name}.json"));
    let peer = fs::read_to_string(path).expect("the peer scenes are there");
    import(&peer).expect("the peer scenes are understood")
}

fn compiled(text: &str) -> Scene {
    load(text, "bench").expect("the scene is right")
}

/// All rays of a picture on one thread; criterion divides by their number.
fn rays(criterion: &mut Criterion) {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("one thread can be started");
    let mut group = criterion.benchmark_group("rays");
    group.sample_size(10);
    for name in PEERS {
        let mut scene = compiled(&text(name));
        scene.image = SIZE;
        let draw = || render(&scene, &Progress::new());
        let tally = pool.install(draw).1;
        group.throughput(Throughput::Elements(RayKind::ALL.iter().map(|&kind| tally.rays(kind)).sum()));
        group.bench_function(name, |bencher| bencher.iter(|| pool.install(|| black_box(draw()))));
    }
    group.finish();
}

/// The whole story of the fishbowl's telling pixel.
fn recording(criterion: &mut Criterion) {
    let embedded = embedded_scene("optics/fishbowl").expect("the fishbowl comes with the program");
    let scene = compiled(embedded.text);
    let [x, y] = scene.pixels[0];
    criterion.bench_function("recording the fishbowl", |bencher| {
        bencher.iter(|| black_box(record_pixel(&scene, black_box(x), black_box(y))));
    });
}

fn compiling(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("compiling");
    group.sample_size(10);
    for spheres in SPHERES {
        let text = text(&format!("i_scaling_{spheres}"));
        group.throughput(Throughput::Elements(spheres as u64));
        group.bench_function(BenchmarkId::from_parameter(spheres), |bencher| {
            bencher.iter(|| black_box(compiled(black_box(&text))));
        });
    }
    group.finish();
}

criterion_group!(benches, rays, recording, compiling);
criterion_main!(benches);
