//! Times every solver on the same ordinary rays, shape by shape: `cargo bench --bench solvers`.

mod common;

use common::{CONTESTANTS, RAYS, rays, shapes};
use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use rayscope::shape::Crossings;
use std::hint::black_box;

fn solvers(criterion: &mut Criterion) {
    for (name, shape) in shapes() {
        let rays = rays(&shape);
        let mut group = criterion.benchmark_group(name);
        group.throughput(Throughput::Elements(RAYS as u64));
        for (solver, call) in CONTESTANTS {
            let mut crossings = Crossings::new();
            group.bench_function(BenchmarkId::from_parameter(solver), |bencher| {
                bencher.iter(|| call(black_box(&shape), black_box(&rays), &mut crossings));
            });
        }
        group.finish();
    }
}

criterion_group!(benches, solvers);
criterion_main!(benches);
