//! From the text of a scene file to a scene with every default and reference resolved, or to all that is wrong.

use super::check::check;
use super::diagnostics::Diagnostics;
use super::file::{CameraFile, LightFile, LimitsFile, MOST_PIXELS, MaterialFile, MediaFile, SceneFile, scene_schema};
use super::lenient::Lenient;
use super::model::{Camera, Image, Light, LightKind, Limits, Material, MediaPolicy, Object, Scene, Shortcuts};
use super::object_index::ObjectIndex;
use super::problem::{Path, Problem, Problems};
use super::rules::Rules;
use super::solids::{Around, SolidReader, find_circles};
use super::source::{locate, parse, to_value};
use glam::DVec3;
use serde::Deserialize;
use serde_json::{Map, Value};
use std::collections::BTreeMap;
use std::sync::LazyLock;

/// Compiles the text of a scene file; `origin` names the file in messages.
///
/// # Errors
/// Everything that is wrong with the file, not only the first.
pub fn load(text: &str, origin: &str) -> Result<Scene, Diagnostics> {
    static RULES: LazyLock<Rules> = LazyLock::new(|| Rules::new(scene_schema().as_value()));
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let ast = parse(text).map_err(|(range, message)| {
        let problem = Problem { steps: Vec::new(), at_name: false, message, help: Vec::new() };
        Diagnostics::new(origin, text, vec![(range, problem)], 0)
    })?;
    let mut problems = Problems::default();
    let value = to_value(&ast, Path::Root, &mut problems);
    check(&RULES, &RULES.root, &value, Path::Root, &mut problems);
    let scene = SceneFile::deserialize(&value).ok().and_then(|file| compile(file, &mut problems));
    match scene {
        Some(scene) if problems.list.is_empty() => Ok(scene),
        _ => {
            let place = |problem: Problem| (locate(&ast, &problem.steps, problem.at_name), problem);
            let left_out = problems.left_out;
            Err(Diagnostics::new(origin, text, problems.distinct().into_iter().map(place).collect(), left_out))
        }
    }
}

/// Always `Some` where nothing is wrong.
fn compile(file: SceneFile, problems: &mut Problems) -> Option<Scene> {
    let image = image(&file, problems);
    let camera = camera(file.camera.or_default(), problems);
    let pixels = pixels(&file, image, problems);
    let lights = lights(&file, problems);
    let materials = file.materials.or_default();
    let places: BTreeMap<_, _> = materials.keys().enumerate().map(|(i, name)| (name.as_str(), i)).collect();
    let objects = objects(&file.solids.or_default(), &file.objects.or_default(), &places, problems);
    let camera = camera?;
    let materials: Vec<_> = materials.into_iter().map(|(name, file)| material(name, &file.or_default())).collect();
    if !problems.list.is_empty() {
        // What is wrong may be a material that does not exist; nothing may look it up.
        return None;
    }
    let index = ObjectIndex::new(&objects, &materials, &camera);
    Some(Scene {
        title: file.title.or_default(),
        about: file.about.or_default(),
        sections: file.sections.or_default().into_iter().map(Lenient::or_default).collect(),
        camera,
        image,
        ambient: DVec3::from_array(file.ambient.or_default().0.0),
        background: DVec3::from_array(file.background.or_default().0.0),
        lights,
        materials,
        objects,
        index,
        shortcuts: Shortcuts::ALL,
        media: match file.media.or_default() {
            MediaFile::Forbid => MediaPolicy::Forbid,
            MediaFile::MostRecent => MediaPolicy::MostRecent,
            MediaFile::Priority => MediaPolicy::Priority,
        },
        limits: limits(file.limits.or_default()),
        pixels,
    })
}

fn limits(file: LimitsFile) -> Limits {
    Limits { depth: file.depth, contribution: file.contribution }
}

fn image(file: &SceneFile, problems: &mut Problems) -> Image {
    let size = file.image.or_default();
    let pixels = u64::from(size.width) * u64::from(size.height);
    if pixels > MOST_PIXELS {
        let message = format!("an image of {} × {} has too many pixels", size.width, size.height);
        problems.add(Path::Root.field("image"), message).help(format!("at most {MOST_PIXELS} pixels can be computed"));
    }
    Image { width: size.width, height: size.height }
}

/// Sine of the angle between up and the view below which up has no direction in the picture: 1e-9 is far above what
/// rounding leaves of two parallel vectors and far below what anyone would choose.
const PARALLEL: f64 = 1e-9;

fn camera(file: CameraFile, problems: &mut Problems) -> Option<Camera> {
    let path = Path::Root.field("camera");
    let eye = DVec3::from_array(file.eye);
    let Some(forward) = unit(DVec3::from_array(file.look_at) - eye) else {
        problems
            .add(path.field("look_at"), "`look_at` is the same point as `eye`, so there is no direction to look in");
        return None;
    };
    let Some(up) = unit(DVec3::from_array(file.up)) else {
        problems.add(path.field("up"), "`up` must not be (0, 0, 0)");
        return None;
    };
    let across = forward.cross(up);
    if across.length() < PARALLEL {
        problems
            .add(path.field("up"), "`up` is parallel to the view from `eye` to `look_at`, so the picture has no top")
            .help("choose another `up`, such as [0, 0, 1] or [0, 1, 0]");
        return None;
    }
    let right = across.normalize();
    let half_height = (file.field_of_view.to_radians() * 0.5).tan();
    Some(Camera { eye, right, up: right.cross(forward), forward, half_height })
}

/// A unit vector; none for zero and for what overflows.
fn unit(v: DVec3) -> Option<DVec3> {
    (v * crate::math::scale_to_unit(v.to_array())).try_normalize()
}

fn pixels(file: &SceneFile, image: Image, problems: &mut Problems) -> Vec<[u32; 2]> {
    let list = Path::Root.field("pixels");
    let pixels: Vec<_> = file.pixels.clone().or_default().into_iter().map(Lenient::or_default).collect();
    for (i, [x, y]) in pixels.iter().enumerate() {
        if *x >= image.width || *y >= image.height {
            problems.add(list.item(i), format!("the pixel ({x}, {y}) lies outside the image")).help(format!(
                "the image has columns 0 to {} and rows 0 to {}",
                image.width.saturating_sub(1),
                image.height.saturating_sub(1)
            ));
        }
    }
    pixels
}

fn lights(file: &SceneFile, problems: &mut Problems) -> Vec<Light> {
    let list = Path::Root.field("lights");
    let files = file.lights.clone().or_default().into_iter().enumerate();
    files.filter_map(|(i, light)| compile_light(light.0?, i, list.item(i), problems)).collect()
}

fn compile_light(file: LightFile, index: usize, path: Path, problems: &mut Problems) -> Option<Light> {
    let (name, kind, colour) = match file {
        LightFile::Point { name, point, colour } => (name, LightKind::Point(DVec3::from_array(point)), colour),
        LightFile::Directional { name, directional, colour } => {
            let Some(towards) = unit(DVec3::from_array(directional)) else {
                problems.add(path.field("directional"), "the direction towards a light must not be (0, 0, 0)");
                return None;
            };
            (name, LightKind::Directional(towards), colour)
        }
    };
    let name = if name.is_empty() { format!("light {}", index + 1) } else { name };
    Some(Light { name, kind, colour: DVec3::from_array(colour.0) })
}

fn material(name: String, file: &MaterialFile) -> Material {
    Material {
        name,
        ambient: DVec3::from_array(file.ambient.0),
        diffuse: DVec3::from_array(file.diffuse.0),
        specular: DVec3::from_array(file.specular.0),
        exponent: file.exponent,
        reflectivity: file.reflectivity,
        transparency: file.transparency,
        index_of_refraction: file.index_of_refraction,
    }
}

fn objects(
    named: &Map<String, Value>,
    files: &[Value],
    materials: &BTreeMap<&str, usize>,
    problems: &mut Problems,
) -> Vec<Object> {
    let in_circles = find_circles(named, problems);
    SolidReader::look_at_named(named, problems);
    let object_names = object_names(files, problems);
    let list = Path::Root.field("objects");
    let mut reader = SolidReader::new(named, Some(materials), problems);
    reader.follow_copies = !in_circles;
    let compiled: Vec<_> =
        files.iter().enumerate().map(|(i, file)| reader.solid(file, list.item(i), Around::NOTHING)).collect();
    let each = files.iter().zip(object_names).zip(compiled);
    each.filter_map(|((file, name), compiled)| {
        let compiled = compiled?;
        let own = file.get("material").and_then(Value::as_str).and_then(|name| materials.get(name)).copied();
        let material = own.or(compiled.leaf_materials.first().copied())?;
        let priority = file.get("priority").and_then(Value::as_i64).and_then(|p| i32::try_from(p).ok()).unwrap_or(0);
        Some(Object {
            name,
            solid: compiled.solid.with_wide_unions(),
            leaf_materials: compiled.leaf_materials.into(),
            material,
            priority,
        })
    })
    .collect()
}

/// The names of the objects: their own, or their shape's with a number from the second on.
fn object_names(files: &[Value], problems: &mut Problems) -> Vec<String> {
    let list = Path::Root.field("objects");
    let mut first_of: BTreeMap<&str, usize> = BTreeMap::new();
    for (i, name) in files.iter().map(|file| text(file, "name")).enumerate().filter(|(_, name)| !name.is_empty()) {
        let first = *first_of.entry(name).or_insert(i);
        if first != i {
            let message = format!("objects[{first}] has the name `{name}` too");
            problems.add(list.item(i).field("name"), message).help("give each object a name of its own");
        }
    }
    let mut numbers: BTreeMap<&str, usize> = BTreeMap::new();
    let mut name_of = |file| {
        let (name, shape) = (text(file, "name"), text(file, "shape"));
        if !name.is_empty() {
            return name.to_owned();
        }
        let number = numbers.entry(shape).or_insert(0);
        loop {
            *number += 1;
            let name = if *number == 1 { shape.to_owned() } else { format!("{shape} {number}") };
            if !first_of.contains_key(name.as_str()) {
                return name;
            }
        }
    };
    files.iter().map(&mut name_of).collect()
}

fn text<'a>(file: &'a Value, field: &str) -> &'a str {
    file.get(field).and_then(Value::as_str).unwrap_or_default()
}
