//! The language of questions: its laws, its errors, and its answers about scenes whose rays are known.

#[path = "query/answers.rs"]
mod answers;
#[path = "query/laws.rs"]
mod laws;
#[path = "query/pictures.rs"]
mod pictures;
