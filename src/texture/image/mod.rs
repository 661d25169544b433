//! Image textures and environments.
