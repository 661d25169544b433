//! From the text of a scene file to a scene with every default and reference resolved, or to all that is wrong.

use super::LeafCoat;
use super::camera::{Image, Sampling};
use super::camera_reader::{camera, lens, sampling};
use super::coat_reader::CoatReader;
use super::diagnostics::Diagnostics;
use super::effects::{Effects, Reason, reasons};
use super::file::{LimitsFile, MOST_PIXELS, MaterialFile, MediaFile, SceneFile, scene_schema};
use super::files::{EmbeddedFiles, Files};
use super::glass_reader::{check_materials, dispersion, medium, split};
use super::lenient::Lenient;
use super::light_reader::lights;
use super::model::{Limits, Material, MediaPolicy, Object, Scene, Shortcuts, needs_beams};
use super::object_index::ObjectIndex;
use super::origin::Origin;
use super::problem::{Path, Problems};
use super::projection::View;
use super::reading::read_checked;
use super::rules::Rules;
use super::solids::{Around, Cover, SolidReader, find_circles, place_of};
use crate::optics::YELLOW;
use crate::shape::Solving;
use glam::DVec3;
use serde_json::{Map, Value};
use std::collections::BTreeMap;
use std::sync::LazyLock;

/// Compiles the text of a scene that names no files but those that come with the program: those in the folder of the
/// embedded scene `origin`. Otherwise `origin` only names the scene in messages.
///
/// # Errors
/// Everything that is wrong with the scene, not only the first.
pub fn load(text: &str, origin: &str) -> Result<Scene, Diagnostics> {
    load_with(text, origin, &EmbeddedFiles::of_scene(origin))
}

/// Compiles the text of a scene whose pictures come from `files`; `origin` names the scene in messages.
///
/// # Errors
/// Everything that is wrong with the scene and with its pictures, not only the first.
pub fn load_with(text: &str, origin: &str, files: &dyn Files) -> Result<Scene, Diagnostics> {
    static RULES: LazyLock<Rules> = LazyLock::new(|| Rules::new(scene_schema().as_value()));
    read_checked(text, origin, &RULES, |file: SceneFile, problems| compile(file, files, problems))
        .map(|scene| Scene { origin: Origin::of(origin, text), ..scene })
}

/// Always `Some` where nothing is wrong.
fn compile(file: SceneFile, files: &dyn Files, problems: &mut Problems) -> Option<Scene> {
    let image = image(&file, problems);
    let camera_file = file.camera.clone().or_default();
    let camera = camera(&camera_file, problems);
    let pixels = pixels(&file, image, problems);
    let lights = lights(&file, problems);
    let mut coats = CoatReader::new(files, problems);
    let lens = camera_file.lens.as_ref().and_then(|file| lens(file, &mut coats));
    let environment = file.environment.as_ref().and_then(|file| coats.environment(file.0.as_ref()?));
    let materials = materials(file.materials.or_default(), &mut coats);
    let objects = objects(&file.solids.or_default(), &file.objects.or_default(), &materials, problems);
    check_materials(&materials, problems);
    require_environment(&materials, environment.is_some(), problems);
    let camera = camera?;
    if !problems.list.is_empty() {
        // What is wrong may be a material that does not exist; nothing may look it up.
        return None;
    }
    let index = ObjectIndex::new(&objects, &materials, View { camera: &camera, lens: lens.as_deref() });
    let needs_beams = needs_beams(environment.as_ref(), &materials);
    let scene = Scene {
        title: file.title.or_default(),
        about: file.about.or_default(),
        sections: file.sections.or_default().into_iter().map(Lenient::or_default).collect(),
        camera,
        lens,
        image,
        sampling: Sampling::CENTRE,
        ambient: DVec3::from_array(file.ambient.or_default().0.0),
        background: DVec3::from_array(file.background.or_default().0.0),
        environment,
        needs_beams,
        frame: 0.0,
        lights,
        materials,
        objects,
        index,
        shortcuts: Shortcuts::ALL,
        solving: Solving::STANDARD,
        effects: Effects::default(),
        media: match file.media.or_default() {
            MediaFile::Forbid => MediaPolicy::Forbid,
            MediaFile::MostRecent => MediaPolicy::MostRecent,
            MediaFile::Priority => MediaPolicy::Priority,
        },
        limits: limits(file.limits.or_default()),
        pixels,
        origin: Origin::of("", ""),
    };
    let calls_for_samples = Effects::of(&reasons(&scene)).meets(Effects::SAMPLED);
    let scene = Scene { sampling: sampling(&file.sampling.or_default(), calls_for_samples), ..scene };
    let reasons = reasons(&scene);
    refuse_what_is_left_out(&reasons, problems);
    let effects = Effects::of(&reasons);
    Some(Scene { effects, ..scene.at_frame(file.frame.or_default()) })
}

/// A build without effects cannot render what calls for them.
fn refuse_what_is_left_out(reasons: &[Reason], problems: &mut Problems) {
    let is_left_out = |reason: &&Reason| reason.called_for && !Effects::BUILT.has(reason.effect);
    for Reason { effect, why, .. } in reasons.iter().filter(is_left_out) {
        let message = format!("this build leaves {} out, and the scene calls for it ({why})", effect.name());
        problems.add(Path::Root, message).help("build without the feature `bare`");
    }
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

/// A unit vector; none for zero and for what overflows.
pub(super) fn unit(v: DVec3) -> Option<DVec3> {
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

/// The materials, in the order of their names.
fn materials(files: BTreeMap<String, Lenient<MaterialFile>>, coats: &mut CoatReader) -> Vec<Material> {
    let list = Path::Root.field("materials");
    let compiled = files.into_iter().map(|(name, file)| {
        let file = file.or_default();
        let coat = coats.coat(&file, list.field(&name));
        let dispersion = file.dispersion.as_ref().map(dispersion);
        Material {
            name,
            ambient: DVec3::from_array(file.ambient.0),
            diffuse: DVec3::from_array(file.diffuse.0),
            specular: DVec3::from_array(file.specular.0),
            exponent: file.exponent,
            reflectivity: file.reflectivity,
            transparency: file.transparency,
            index_of_refraction: dispersion.map_or(file.index_of_refraction, |dispersion| dispersion.index(YELLOW)),
            split: split(file.fresnel.as_ref()),
            dispersion,
            medium: file.medium.as_ref().and_then(medium),
            coat,
        }
    });
    compiled.collect()
}

/// A material that mirrors the environment needs one.
fn require_environment(materials: &[Material], is_there: bool, problems: &mut Problems) {
    for material in materials.iter().filter(|material| !is_there && material.mirrors_environment()) {
        problems
            .add(
                Path::Root.field("materials").field(&material.name).field("mirrors"),
                format!("`{}` mirrors the environment, and the scene has none", material.name),
            )
            .help("add an `environment` to the scene");
    }
}

fn objects(
    named: &Map<String, Value>,
    files: &[Value],
    materials: &[Material],
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
    let objects = each.filter_map(|((file, name), compiled)| {
        let compiled = compiled?;
        let own = file.get("material").and_then(Value::as_str).and_then(|name| place_of(materials, name));
        let material = own.or(compiled.covers.first().map(|cover| cover.material))?;
        let priority = file.get("priority").and_then(Value::as_i64).and_then(|p| i32::try_from(p).ok()).unwrap_or(0);
        let leaf_materials = compiled.covers.iter().map(|cover| cover.material).collect();
        let coats = leaf_coats(compiled.covers, materials);
        let solid = compiled.solid.with_wide_unions();
        Some(Object { name, solid, leaf_materials, material, priority, coats })
    });
    objects.collect()
}

/// What the leaves of an object need to know to carry something; none where nothing of it does.
fn leaf_coats(covers: Vec<Cover>, materials: &[Material]) -> Option<Box<[LeafCoat]>> {
    let is_coated = |material: usize| materials.get(material).is_some_and(|material| material.coat.is_some());
    let carries = |cover: &Cover| is_coated(cover.material) || !cover.details.is_empty();
    let leaf = |cover: Cover| LeafCoat { object_from_world: cover.world_from_object.inverse(), details: cover.details };
    covers.iter().any(carries).then(|| covers.into_iter().map(leaf).collect())
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
