//! Bumps, frames and facets: what turns a normal without moving the surface.
