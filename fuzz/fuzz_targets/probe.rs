//! Bytes as requests to `rayscope probe`.

#![no_main]

#[path = "mutate.rs"]
mod mutate;
#[path = "../../tests/fuzz_seeds/probe_rules.rs"]
mod probe_rules;

use libfuzzer_sys::{fuzz_mutator, fuzz_target};

fuzz_target!(|data: &[u8]| {
    if let Err(problem) = probe_rules::check_probe(data) {
        panic!("{problem}");
    }
});

fuzz_mutator!(|data: &mut [u8], size: usize, max_size: usize, seed: u32| { mutate::json(data, size, max_size, seed) });
