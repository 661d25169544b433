//! What is true of any two related questions, whatever the answers: turned about, scaled, reversed, moved, cut in two, put
//! together again.

#[path = "metamorphic/primitives.rs"]
mod primitives;
#[path = "independent/random.rs"]
#[allow(dead_code, reason = "not all of it is needed here")]
mod random;
#[path = "metamorphic/sets.rs"]
mod sets;
#[path = "metamorphic/support.rs"]
mod support;
