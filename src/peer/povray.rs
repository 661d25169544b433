//! Writes a scene for POV-Ray 3.7, in its scene description language (SDL).
//!
//! Every number has all of its digits, and every length its direction: the camera is given by vectors, so that it does
//! not matter that POV-Ray's axes are left-handed.
//!
//! **Source.** The POV-Ray 3.7 reference: sections on the camera, finishes, CSG and transformations.

use super::camera::RADII_IN_APERTURE;
use super::povray_material::texture;
use crate::csg::{Leaf, Node};
use crate::record::Operator;
use crate::sample::Aperture;
use crate::scene::{Image, Light, LightKind, MediaPolicy, Object, Scene};
use crate::shape::{ConvexPolyhedron, Shape};
use glam::{DAffine3, DMat3, DVec3};
use std::collections::BTreeSet;
use std::fmt::Write as _;

/// How far away a directional light is put. POV-Ray sees nothing beyond 10⁷, and objects behind the light throw no shadow.
const FAR_AWAY: f64 = 1e6;

/// The scene in SDL.
///
/// # Errors
/// Says which part of the scene cannot be said in SDL, and why.
pub fn to_povray(scene: &Scene) -> Result<String, String> {
    no_overlapping_media(scene)?;
    nothing_but_colours_around(scene)?;
    let Image { width, height } = scene.image;
    let mut sdl = format!("// {}\n// povray +W{width} +H{height} +ITHIS_FILE\n#version 3.7;\n", comment(&scene.title));
    let _ = writeln!(
        sdl,
        "global_settings {{ assumed_gamma 1.0 max_trace_level {} adc_bailout {:?} ambient_light rgb {} }}",
        scene.limits.depth + 1,
        scene.limits.contribution,
        vector(scene.ambient)
    );
    let _ = writeln!(sdl, "background {{ rgb {} }}", vector(scene.background));
    sdl += &camera(scene)?;
    for light in &scene.lights {
        sdl += &self::light(light)?;
    }
    for index in materials_in_use(scene) {
        let material = &scene.materials[index];
        let (name, texture) = (comment(&material.name), texture(material)?);
        let _ = writeln!(sdl, "#declare Texture_{index} = {texture} // {name}");
    }
    for object in &scene.objects {
        let _ = writeln!(sdl, "// {}", comment(&object.name));
        sdl += &self::object(scene, object)?;
    }
    Ok(sdl)
}

/// Pictures lie in other files, and details have no equal.
fn nothing_but_colours_around(scene: &Scene) -> Result<(), String> {
    if scene.environment.is_some() {
        return Err("environment: pictures are not written".to_owned());
    }
    let has_details = |object: &&Object| object.coats.iter().flatten().any(|coat| !coat.details.is_empty());
    match scene.objects.iter().find(has_details) {
        Some(object) => Err(format!("object `{}`: polygons on faces have no equal in POV-Ray's language", object.name)),
        None => Ok(()),
    }
}

/// POV-Ray takes the most recently entered medium for the one that a ray is in, and bends the ray at every boundary.
fn no_overlapping_media(scene: &Scene) -> Result<(), String> {
    let transparent = |object: &&Object| scene.materials[object.material].transparency > 0.0;
    let names: Vec<_> = scene.objects.iter().filter(transparent).map(|object| object.name.as_str()).collect();
    if scene.media == MediaPolicy::Forbid || names.len() < 2 {
        return Ok(());
    }
    Err(format!(
        "media: transparent objects may overlap ({}), and POV-Ray has no rule for which of them wins; it can be given \
         only scenes whose `media` is `forbid`",
        names.join(", ")
    ))
}

/// A vector with all of its digits.
pub(super) fn vector(v: DVec3) -> String {
    format!("<{:?}, {:?}, {:?}>", v.x, v.y, v.z)
}

/// A name or title on one line of ASCII, which is what POV-Ray is sure to read.
fn comment(text: &str) -> String {
    text.escape_default().to_string()
}

fn camera(scene: &Scene) -> Result<String, String> {
    let (camera, image) = (&scene.camera, scene.image);
    let height = 2.0 * camera.half_height;
    let width = height * f64::from(image.width) / f64::from(image.height);
    Ok(format!(
        "camera {{ perspective location {} direction {}\n  right {} up {}{} }}\n",
        vector(camera.eye),
        vector(camera.forward),
        vector(camera.right * width),
        vector(camera.up * height),
        lens(scene)?
    ))
}

/// POV-Ray's lens is a disc; without variance it sends as many rays as it is told.
fn lens(scene: &Scene) -> Result<String, String> {
    let Some(lens) = &scene.lens else { return Ok(String::new()) };
    if lens.aperture != Aperture::Disc {
        let kind = lens.aperture.name();
        return Err(format!("camera: POV-Ray's lens is a disc, and an aperture of the kind `{kind}` has no equal"));
    }
    let focus = vector(scene.camera.eye + scene.camera.forward * lens.focus);
    let (aperture, samples) = (RADII_IN_APERTURE * lens.radius, scene.sampling.samples);
    Ok(format!(
        "\n  aperture {aperture:?} focal_point {focus} blur_samples {samples}, {samples} variance 0 confidence 0.999"
    ))
}

fn light(light: &Light) -> Result<String, String> {
    let (place, parallel) = match light.kind {
        LightKind::Point(place) => (place, ""),
        LightKind::Area(_) => return Err(format!("light `{}`: it has a size, which is not written yet", light.name)),
        LightKind::Directional(towards) => (towards * FAR_AWAY, " parallel point_at <0, 0, 0>"),
    };
    let name = comment(&light.name);
    Ok(format!("light_source {{ {} rgb {}{parallel} }} // {name}\n", vector(place), vector(light.colour)))
}

fn materials_in_use(scene: &Scene) -> BTreeSet<usize> {
    scene.objects.iter().flat_map(|object| object.leaf_materials.iter().copied()).collect()
}

/// The tree of an object, with what fills it.
fn object(scene: &Scene, object: &Object) -> Result<String, String> {
    let material = &scene.materials[object.material];
    let interior = if material.transparency > 0.0 {
        format!(" interior {{ ior {:?} }}", material.index_of_refraction)
    } else {
        String::new()
    };
    let mut sdl = String::new();
    node(object, object.solid.root(), "", &interior, &mut sdl)
        .map_err(|message| format!("object `{}`: {message}", object.name))?;
    Ok(sdl)
}

fn node(object: &Object, node: &Node, indent: &str, tail: &str, sdl: &mut String) -> Result<(), String> {
    match node {
        Node::Leaf { leaf, .. } => {
            let (placed, texture) = (&object.solid.leaves[*leaf], object.leaf_materials[*leaf]);
            let _ = writeln!(sdl, "{indent}{} texture {{ Texture_{texture} }}{tail} }}", open_leaf(placed)?);
        }
        Node::Pair { operator, left, right, .. } => {
            // POV-Ray's union keeps the surfaces that lie inside the other part; its merge is what a union is here.
            let keyword = match operator {
                Operator::Union => "merge",
                Operator::Intersection => "intersection",
                Operator::Difference => "difference",
            };
            let _ = writeln!(sdl, "{indent}{keyword} {{");
            let inner = format!("{indent}  ");
            self::node(object, &object.solid.nodes[*left], &inner, "", sdl)?;
            self::node(object, &object.solid.nodes[*right], &inner, "", sdl)?;
            let _ = writeln!(sdl, "{indent}{tail} }}");
        }
    }
    Ok(())
}

/// A primitive in its place, up to its texture.
fn open_leaf(leaf: &Leaf) -> Result<String, String> {
    let shape = match &leaf.shape {
        Shape::TaperedCylinder(tapered) => format!("cone {{ <0, 0, 0>, 1, <0, 0, 1>, {:?}", tapered.s()),
        Shape::ConvexPolyhedron(polyhedron) => self::polyhedron(polyhedron),
        Shape::Torus(torus) => self::torus(torus.d()).map_err(|message| format!("`{}`: {message}", leaf.name))?,
        Shape::Superellipsoid(superellipsoid) => {
            let [n, m] = superellipsoid.exponents();
            format!("superellipsoid {{ <{:?}, {:?}>", 2.0 / n, 2.0 / m)
        }
        other => plain(other.name())
            .ok_or_else(|| format!("`{}`: POV-Ray has no shape for `{}`", leaf.name, other.name()))?
            .to_owned(),
    };
    Ok(format!("{shape} {}", matrix(&leaf.placement.world_from_generic())))
}

/// The shapes without parameters.
fn plain(name: &str) -> Option<&'static str> {
    Some(match name {
        "plane" => "plane { <0, 0, 1>, 0",
        "sphere" => "sphere { <0, 0, 0>, 1",
        "square" => "polygon { 5, <-1, -1, 0>, <1, -1, 0>, <1, 1, 0>, <-1, 1, 0>, <-1, -1, 0>",
        "cylinder" => "cylinder { <0, 0, 0>, <0, 0, 1>, 1",
        "cone" => "cone { <0, 0, 0>, 1, <0, 0, 1>, 0",
        "cube" => "box { <-1, -1, -1>, <1, 1, 1>",
        _ => return None,
    })
}

/// POV-Ray's planes have their distance along the unit normal.
fn polyhedron(polyhedron: &ConvexPolyhedron) -> String {
    let mut sdl = "intersection {".to_owned();
    for plane in polyhedron.planes() {
        let length = plane.normal.length();
        let _ = write!(sdl, " plane {{ {}, {:?} }}", vector(plane.normal / length), plane.offset / length);
    }
    sdl
}

/// POV-Ray's torus has the axis y: the axes change places in a circle, so that y becomes z.
fn torus(d: f64) -> Result<String, String> {
    if d < 1.0 {
        return Err(format!(
            "d is {d}; below 1 the tube overlaps itself, and POV-Ray counts the surface within the overlap"
        ));
    }
    let turn = DAffine3::from_mat3(DMat3::from_cols(DVec3::Y, DVec3::Z, DVec3::X));
    Ok(format!("torus {{ {d:?}, 1 {}", matrix(&turn)))
}

/// SDL lists an affine map by columns.
fn matrix(map: &DAffine3) -> String {
    let (linear, moved) = (map.matrix3, map.translation);
    let columns = [linear.x_axis, linear.y_axis, linear.z_axis, moved];
    let columns = columns.map(|v| format!("{:?}, {:?}, {:?}", v.x, v.y, v.z));
    format!("matrix <{}>", columns.join(", "))
}
