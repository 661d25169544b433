//! Prints what every solver takes for a ray, and its ratio to the textbook's: `cargo bench --bench ratios`, or of some shapes
//! alone: `cargo bench --bench ratios -- cube torus`.
//!
//! The solvers take turns, so that what slows the machine down slows all of them; the median of many turns is taken, with
//! the middle half of the turns beside it.

mod common;

use common::{CONTESTANTS, RAYS, rays, shapes};
use rayscope::shape::Crossings;
use std::hint::black_box;
use std::time::{Duration, Instant};

/// How long the solvers of one shape take turns. Shorter is noisier; longer only takes longer.
const TURNS_TAKE: Duration = Duration::from_millis(600);

fn main() {
    let wanted: Vec<String> = std::env::args().skip(1).filter(|word| !word.starts_with("--")).collect();
    let is_wanted = |name: &str| wanted.is_empty() || wanted.iter().any(|word| name.contains(word.as_str()));
    println!("ns a ray (a quarter of all turns was faster, a quarter slower), and the ratio to the textbook's");
    print!("{:24}", "");
    for (solver, _) in CONTESTANTS {
        print!("{solver:>32}");
    }
    println!("{:>12}{:>12}", "adaptive /", "hits a ray");
    println!("{:152}{:>12}", "", "textbook");
    for (name, shape) in shapes().into_iter().filter(|(name, _)| is_wanted(name)) {
        let rays = rays(&shape);
        let mut crossings = Crossings::new();
        let mut nanoseconds = CONTESTANTS.map(|_| Vec::new());
        let began = Instant::now();
        while began.elapsed() < TURNS_TAKE || nanoseconds[0].len() < 9 {
            for ((_, call), taken) in CONTESTANTS.iter().zip(&mut nanoseconds) {
                let start = Instant::now();
                black_box(call(black_box(&shape), black_box(&rays), &mut crossings));
                taken.push(start.elapsed().as_secs_f64() * 1e9 / RAYS as f64);
            }
        }
        let hits = CONTESTANTS[0].1(&shape, &rays, &mut crossings) as f64 / RAYS as f64;
        print!("{name:24}");
        for taken in &mut nanoseconds {
            taken.sort_by(f64::total_cmp);
            let at = |share: usize| taken[taken.len() * share / 4];
            print!("{:>32}", format!("{:.1} ({:.1} … {:.1})", at(2), at(1), at(3)));
        }
        let median = |k: usize| nanoseconds[k][nanoseconds[k].len() / 2];
        println!("{:>12.2}{hits:>12.2}", median(0) / median(1));
    }
}
