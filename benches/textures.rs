//! Prints what a look-up in a solid texture takes: `cargo bench --bench textures`.
//!
//! The subjects take turns, so that what slows the machine down slows all of them; the median of many turns is taken, with
//! the middle half of the turns beside it.

use glam::DVec3;
use rayscope::record::NullRecorder;
use rayscope::texture::solid::{ColourSpline, Marble, Noise, NoiseKind, Turbulence, Wood, WoodGrain};
use std::hint::black_box;
use std::time::{Duration, Instant};

/// How long the subjects take turns. Shorter is noisier; longer only takes longer.
const TURNS_TAKE: Duration = Duration::from_secs(3);

/// Points of one turn: neighbours lie as far apart as the hits of neighbouring pixels do.
const POINTS: u32 = 4096;

type Subject = (&'static str, Box<dyn Fn(&[DVec3]) -> DVec3>);

/// A subject that sums up what it is given for all points.
fn subject(name: &'static str, look_up: impl Fn(DVec3) -> DVec3 + 'static) -> Subject {
    (name, Box::new(move |points| points.iter().map(|p| look_up(*p)).sum()))
}

fn subjects() -> Vec<Subject> {
    let gradient = || Noise::new(NoiseKind::Gradient, 1);
    let value = Noise::new(NoiseKind::Value, 1);
    let turbulence = |octaves| Turbulence::new(gradient(), 1.0, octaves, 0.5, false).expect("a turbulence");
    let spline = || ColourSpline::new(&[(-1.0, DVec3::ZERO), (0.2, DVec3::X), (1.0, DVec3::ONE)]).expect("a spline");
    let marble = Marble::new(DVec3::Z, 4.0, 6.0, turbulence(6), spline()).expect("a marble");
    let grain = WoodGrain {
        point: DVec3::ZERO,
        axis: DVec3::new(0.1, 0.2, 1.0),
        ring_width: 0.1,
        wobble: 0.3,
        lobes: 5,
        twist: 0.5,
        stirring: None,
        light: DVec3::ONE,
        dark: DVec3::X,
        edge: 0.2,
    };
    let wood = Wood::new(grain).expect("a wood");
    let (noise, sloped, six) = (gradient(), gradient(), turbulence(6));
    vec![
        subject("gradient noise", move |p| DVec3::splat(noise.value(p))),
        subject("gradient noise, slope", move |p| sloped.value_and_slope(p).1),
        subject("value noise", move |p| DVec3::splat(value.value(p))),
        subject("turbulence, 6 octaves", move |p| DVec3::splat(six.value(p))),
        subject("marble, 6 octaves", move |p| marble.colour(p, &mut NullRecorder)),
        subject("wood, 5 lobes, soft", move |p| wood.colour(p, &mut NullRecorder)),
    ]
}

fn main() {
    let points: Vec<DVec3> =
        (0..POINTS).map(f64::from).map(|k| DVec3::new(0.01 * k, (0.003 * k).sin() * 3.0, 1.7 - 0.002 * k)).collect();
    let mut subjects: Vec<_> = subjects().into_iter().map(|subject| (subject, Vec::new())).collect();
    let began = Instant::now();
    while began.elapsed() < TURNS_TAKE {
        for ((_, look_up), taken) in &mut subjects {
            let start = Instant::now();
            black_box(look_up(black_box(&points)));
            taken.push(start.elapsed().as_secs_f64() * 1e9 / f64::from(POINTS));
        }
    }
    println!("ns a look-up (a quarter of all turns was faster, a quarter slower)");
    for ((name, _), mut taken) in subjects {
        taken.sort_by(f64::total_cmp);
        let at = |share: usize| taken[taken.len() * share / 4];
        println!("{name:24}{:>32}", format!("{:.1} ({:.1} … {:.1})", at(2), at(1), at(3)));
    }
}
