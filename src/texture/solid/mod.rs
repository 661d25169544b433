//! Solid textures: a colour at every point of space, out of which the object is carved.
