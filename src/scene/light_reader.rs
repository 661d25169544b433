//! From what a file says about lights to what the tracer asks.

use super::compile::unit;
use super::file::{Colour, SceneFile};
use super::light::{Area, Light, LightKind};
use super::light_file::{AreaFile, LightFile};
use super::problem::{Path, Problems};
use glam::DVec3;

/// All lights that are right.
pub(super) fn lights(file: &SceneFile, problems: &mut Problems) -> Vec<Light> {
    let list = Path::Root.field("lights");
    let files = file.lights.clone().or_default().into_iter().enumerate();
    files.filter_map(|(i, light)| compile_light(light.0?, i, list.item(i), problems)).collect()
}

fn compile_light(file: LightFile, index: usize, path: Path, problems: &mut Problems) -> Option<Light> {
    let (name, kind, Colour(colour), samples) = match file {
        LightFile::Point { name, point, colour } => (name, LightKind::Point(DVec3::from_array(point)), colour, 1),
        LightFile::Directional { name, directional, colour } => {
            let Some(towards) = unit(DVec3::from_array(directional)) else {
                problems.add(path.field("directional"), "the direction towards a light must not be (0, 0, 0)");
                return None;
            };
            (name, LightKind::Directional(towards), colour, 1)
        }
        LightFile::Area { name, area, samples, colour } => {
            (name, LightKind::Area(compile_area(area, path.field("area"), problems)?), colour, samples)
        }
    };
    let name = if name.is_empty() { format!("light {}", index + 1) } else { name };
    Some(Light { name, kind, samples, colour: DVec3::from_array(colour) })
}

fn compile_area(file: AreaFile, path: Path, problems: &mut Problems) -> Option<Area> {
    Some(match file {
        AreaFile::Disc { centre, normal, radius } => {
            let Some(normal) = unit(DVec3::from_array(normal)) else {
                problems.add(path.field("normal"), "the direction that a disc faces must not be (0, 0, 0)");
                return None;
            };
            let (right, up) = normal.any_orthonormal_pair();
            Area::Disc { centre: DVec3::from_array(centre), radii: [right * radius, up * radius] }
        }
        AreaFile::Rectangle { corner, edges } => {
            Area::Rectangle { corner: DVec3::from_array(corner), edges: edges.map(DVec3::from_array) }
        }
        AreaFile::Sphere { centre, radius } => Area::Sphere { centre: DVec3::from_array(centre), radius },
    })
}
