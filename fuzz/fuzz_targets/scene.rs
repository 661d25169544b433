//! Bytes as a scene file, and one pixel of what it shows.

#![no_main]

#[path = "mutate.rs"]
mod mutate;
#[path = "../../tests/fuzz_seeds/scene_rules.rs"]
mod scene_rules;

use libfuzzer_sys::{fuzz_mutator, fuzz_target};

fuzz_target!(|data: &[u8]| {
    if let Err(problem) = scene_rules::check_scene(data) {
        panic!("{problem}");
    }
});

fuzz_mutator!(|data: &mut [u8], size: usize, max_size: usize, seed: u32| { mutate::json(data, size, max_size, seed) });
