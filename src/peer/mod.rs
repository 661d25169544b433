//! Other programs' scenes: read, written, and the pictures compared.

mod agreement;
mod camera;
mod import;
mod pigment;
mod povray;
mod povray_material;
mod solid;

pub use agreement::Agreement;
pub use import::import;
pub use povray::to_povray;
