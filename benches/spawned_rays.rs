//! Many random rays leave random surfaces: does any hit the surface that it left, or lose another?
//!
//!     cargo bench --bench spawned_rays -- --rays 1e8 --seed 7
//!
//! Ends with code 1 when any does.

use rayscope::accuracy::spawned::{Mishap, SCALES, SOLIDS, Soak, soak};
use std::process::ExitCode;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().collect();
    let after = |name: &str| arguments.iter().position(|word| word == name).and_then(|k| arguments.get(k + 1));
    // 1e8 is how people write it.
    let number = |name: &str, otherwise: f64| after(name).map_or(Some(otherwise), |text| text.parse::<f64>().ok());
    let (Some(rays), Some(seed)) = (number("--rays", 1e6), number("--seed", 1.0)) else {
        eprintln!("expected numbers, such as --rays 1e8 --seed 7");
        return ExitCode::from(2);
    };
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "counts, far below 2^53")]
    let (rays, seed) = (rays as u64, seed as u64);
    let began = Instant::now();
    let (done, shown) = (AtomicU64::new(0), AtomicU64::new(0));
    let progress = |count| {
        let done = done.fetch_add(count, Ordering::Relaxed) + count;
        let seconds = began.elapsed().as_secs();
        if shown.fetch_max(seconds, Ordering::Relaxed) < seconds {
            eprint!("\r{:.1} %, {:.1e} rays ", 100.0 * done as f64 / rays as f64, done as f64);
        }
    };
    match soak(seed, 0..rays, || false, progress) {
        Ok(soak) => report(&soak, seed, began.elapsed()),
        Err(error) => {
            eprintln!("{error}");
            ExitCode::from(2)
        }
    }
}

fn report(soak: &Soak, seed: u64, took: Duration) -> ExitCode {
    eprint!("\r");
    println!("{:24}{:>8}{:>12}{:>12}{:>12}{:>12}", "solid", "scale", "judged", "not judged", "self-hits", "leaks");
    for ((name, _), row) in SOLIDS.iter().zip(&soak.departures) {
        for (scale, counts) in SCALES.iter().zip(row) {
            let scale = format!("1e{scale}");
            println!(
                "{name:24}{scale:>8}{:>12}{:>12}{:>12}{:>12}",
                counts.judged, counts.not_judged, counts.self_hits, counts.leaks
            );
        }
    }
    let total = soak.total();
    println!("{:32}{:>12}{:>12}{:>12}{:>12}", "all", total.judged, total.not_judged, total.self_hits, total.leaks);
    println!("seed {seed}, {:.1} s", took.as_secs_f64());
    soak.mishaps.iter().for_each(print_mishap);
    if total.self_hits + total.leaks == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

fn print_mishap(mishap: &Mishap) {
    let what = if mishap.self_hit { "hits the surface that it left" } else { "loses or invents a boundary" };
    println!("\nray {} {what}: {} at scale 1e{}", mishap.number, SOLIDS[mishap.solid].0, SCALES[mishap.scale]);
    println!("  from {:?} along {:?}", mishap.origin.to_array(), mishap.direction.to_array());
    println!("  leaving {:?} along {:?}", mishap.point.to_array(), mishap.leaving.to_array());
    println!("  window {:e}, counted {:?}, exact {:?}", mishap.window, mishap.counted, mishap.exact);
}
