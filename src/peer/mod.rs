//! Other programs' scenes: read, written, and the pictures compared.

mod agreement;
mod camera;
mod import;
mod solid;

pub use agreement::Agreement;
pub use import::import;
