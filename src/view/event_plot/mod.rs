//! What happens to a ray as a drawing: what a surface carries (the pixel on the texels, a lattice cell, octaves, a spline, rings,
//! a bump, a frame, the environment, a detail), the lens that it is seen through, white light taken apart, what a medium does to
//! light on its way.
//!
//! One file for each kind of event, all of one signature: a [`Sheet`] and what the event holds.

mod bump;
mod detail;
mod environment;
mod fading;
mod fan;
#[cfg(test)]
mod fan_tests;
mod frame_map;
mod lattice;
mod lens;
mod lobe;
mod octaves;
mod picture;
mod rings;
mod telling;
#[cfg(test)]
mod tests;
mod texels;
mod undulate;

use super::drawing::Drawing;
use super::palette::Theme;
use super::sheet::Sheet;
use crate::record::{EventId, What};
use crate::scene::Scene;
use crate::trace::RayTree;
use telling::{footprint_of, lens_of, phases_of, point_of, telling, turned_on};

/// The drawing of a look-up, bump, frame or detail: that of `selected` itself, or of the most telling one that belongs to
/// it (to a texture: what is below it; to a hit: what its surface carries). Where the scene is given, the image of its
/// environment lies behind what the ray saw of it.
#[must_use]
pub fn event_plot(
    scene: Option<&Scene>,
    tree: &RayTree,
    selected: EventId,
    size: [f64; 2],
    theme: Theme,
) -> Option<Drawing> {
    let event = telling(tree, selected)?;
    let mut sheet = Sheet::new(size, theme, event);
    match &tree.event(event).what {
        What::Mapping(_) | What::Texels(_) => texels::draw(&mut sheet, &footprint_of(tree, event)),
        What::Lattice(lattice) => lattice::draw(&mut sheet, lattice),
        What::Octaves(octaves) => octaves::draw(&mut sheet, octaves),
        What::Undulate(undulate) => undulate::draw(&mut sheet, undulate),
        What::Rings(rings) => rings::draw(&mut sheet, rings, point_of(tree, event)),
        What::Bump(bump) => bump::draw(&mut sheet, bump),
        What::FrameMap(frame) => frame_map::draw(&mut sheet, frame),
        What::Environment(environment) => {
            let image = scene.and_then(|scene| scene.environment.as_ref()).map(|own| own.map.texels());
            environment::draw(&mut sheet, environment, image);
        }
        What::Detail(detail) => detail::draw(&mut sheet, detail),
        What::Lens(_) | What::Confusion(_) => lens::draw(&mut sheet, &lens_of(tree, event)?),
        What::Wavelength(_) => fan::draw(&mut sheet, &fan::sent_together(tree, event)),
        What::Segment(segment) => fading::draw(&mut sheet, segment, &turned_on(tree, event)),
        What::Scatter(_) | What::Phase(_) => lobe::draw(&mut sheet, &phases_of(tree, event)),
        _ => return None,
    }
    Some(sheet.finish())
}
