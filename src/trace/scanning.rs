//! Texture scanning beside inverse scanning (§ 6.3.1): both orders in which the picture on a flat part of a surface can be
//! brought into the picture that the camera takes.
//!
//! Forward, (s, t) → (u, v) by M_T, (u, v) → the point → the pixel by M_VP. Back, the ray through the pixel's middle meets the
//! plane of the part at (u, v), which M_T⁻¹ takes to (s, t). The part is taken alone and whole: what stands before it, and what
//! is cut off it in a compound, is left out of account, and so are copies of the picture where it repeats.

use crate::csg::Leaf;
use crate::scene::{Image, Object, Scene, Texture, mapped_part};
use crate::shape::{FlatPart, Part, Primitive};
use crate::texture::image::{ImageTexture, Scan};
use glam::DVec2;

/// Both scans of one picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Scanning {
    /// The object.
    pub object: String,
    /// The part of its surface.
    pub part: String,
    /// Columns and rows of the picture that it carries.
    pub texels: [u32; 2],
    /// Columns and rows of the picture that is painted.
    pub pixels: [u32; 2],
    /// From the texels to the pixels.
    pub forward: Scan,
    /// From the pixels to the texels.
    pub inverse: Scan,
}

impl Scanning {
    /// Scans the picture on the named part of the named object. Without names these are the first object that has a picture on a
    /// flat part, and the first such part that is turned towards the eye.
    ///
    /// # Errors
    /// If there is no such object or part, or nothing of it is in the picture.
    pub fn new(scene: &Scene, size: Image, object: Option<&str>, part: Option<&str>) -> Result<Self, String> {
        let patch = Patch::choose(scene, object, part)?;
        let (texels, pixels) = (&patch.image.texels, [size.width, size.height]);
        let forward = Scan::forward(texels, pixels, |st| patch.picture_from_st(scene, size, st));
        let inverse = Scan::inverse(texels, pixels, |at| patch.st_from_picture(scene, size, at));
        let [object, part] = [patch.object.name.clone(), patch.part_name().to_owned()];
        if inverse.painted.iter().all(|times| *times == 0) {
            return Err(format!(
                "none of the {} × {} pixels shows the picture on `{object}` ({part}): it is beside or behind what the camera sees, \
                 or too small; a larger picture, another object or another part was expected",
                size.width, size.height
            ));
        }
        Ok(Self { object, part, texels: texels.size(), pixels, forward, inverse })
    }

    /// How many pixels the picture covers: those whose middle lies on it.
    #[must_use]
    pub fn covered(&self) -> usize {
        self.inverse.painted.iter().filter(|times| **times > 0).count()
    }

    /// How many of these texture scanning leaves out.
    #[must_use]
    pub fn holes(&self) -> usize {
        self.forward.holes(&self.inverse)
    }
}

/// A flat part that carries a picture.
struct Patch<'a> {
    object: &'a Object,
    leaf: &'a Leaf,
    part: Part,
    flat: FlatPart,
    image: &'a ImageTexture,
    /// The parts that have an M_T of their own.
    mapped: &'a [String],
}

impl<'a> Patch<'a> {
    /// All flat parts of an object that carry a picture.
    fn all(scene: &'a Scene, object: &'a Object) -> Vec<Self> {
        let mut patches = Vec::new();
        for (leaf, material) in object.solid.leaves.iter().zip(&object.leaf_materials) {
            let coat = scene.materials[*material].coat.as_deref();
            let Some(Texture::Image { image, parts: mapped }) = coat.and_then(|coat| coat.texture.as_ref()) else {
                continue;
            };
            let parts = (0..leaf.parts.len()).filter_map(|part| Part::try_from(part).ok());
            patches.extend(parts.filter_map(|part| {
                FlatPart::of(&leaf.shape, part).map(|flat| Self { object, leaf, part, flat, image, mapped })
            }));
        }
        patches
    }

    fn choose(scene: &'a Scene, object: Option<&str>, part: Option<&str>) -> Result<Self, String> {
        let mut known: Vec<Vec<Self>> = scene.objects.iter().map(|object| Self::all(scene, object)).collect();
        known.retain(|patches| !patches.is_empty());
        let names = || listed(known.iter().map(|patches| patches[0].object.name.as_str()));
        let place = match object {
            _ if known.is_empty() => {
                return Err(
                    "no object of the scene carries a picture on a flat part: an object with a texture of kind \
                            `image` and a flat face, such as a square or a cube, was expected"
                        .to_owned(),
                );
            }
            None => 0,
            Some(name) => known.iter().position(|patches| patches[0].object.name == name).ok_or_else(|| {
                let exists = scene.objects.iter().any(|object| object.name == name);
                let problem = if exists { "carries no picture on a flat part" } else { "is not in the scene" };
                format!("the object `{name}` {problem}; one of {} was expected", names())
            })?,
        };
        let mut patches = known.swap_remove(place);
        let place = match part {
            None => patches.iter().position(|patch| patch.faces_the_eye(scene)).unwrap_or(0),
            Some(name) => patches.iter().position(|patch| patch.part_name() == name).ok_or_else(|| {
                let (object, parts) = (&patches[0].object.name, listed(patches.iter().map(Self::part_name)));
                format!("`{object}` has no flat part `{name}` that carries a picture; one of {parts} was expected")
            })?,
        };
        Ok(patches.swap_remove(place))
    }

    fn part_name(&self) -> &'a str {
        &self.leaf.parts[usize::from(self.part)]
    }

    /// Whether the eye is on the side that the normal points to.
    fn faces_the_eye(&self, scene: &Scene) -> bool {
        let on_part = self.flat.point(DVec2::splat(0.5));
        let eye = self.leaf.placement.generic_point(scene.camera.eye);
        self.leaf.shape.normal(on_part, self.part).dot(eye - on_part) > 0.0
    }

    fn holds(&self, uv: DVec2) -> bool {
        self.flat.holds(&self.leaf.shape, self.part, uv)
    }

    /// M_T, then M_VP.
    fn picture_from_st(&self, scene: &Scene, size: Image, st: DVec2) -> Option<DVec2> {
        let uv = self.image.mapping.uv_from_st(self.mapped_part()).apply(st);
        let world = self.leaf.placement.world_from_generic().transform_point3(self.flat.point(uv));
        scene.camera.project(size, world).filter(|_| self.holds(uv)).map(DVec2::from)
    }

    /// M_VP⁻¹, then M_T⁻¹.
    fn st_from_picture(&self, scene: &Scene, size: Image, at: DVec2) -> Option<DVec2> {
        let generic_from_world = self.leaf.placement.generic_from_world();
        let eye = generic_from_world.transform_point3(scene.camera.eye);
        let direction = generic_from_world.transform_vector3(scene.camera.ray_direction(size, at.x, at.y));
        let (t, uv) = self.flat.meet(eye, direction)?;
        (t > 0.0 && self.holds(uv)).then(|| self.image.mapping.st_from_uv(self.mapped_part()).apply(uv))
    }

    fn mapped_part(&self) -> u16 {
        mapped_part(self.mapped, self.part_name())
    }
}

/// Names as they stand in a sentence, each once.
fn listed<'a>(names: impl Iterator<Item = &'a str>) -> String {
    let mut quoted: Vec<String> = Vec::new();
    for name in names.map(|name| format!("`{name}`")) {
        if !quoted.contains(&name) {
            quoted.push(name);
        }
    }
    quoted.join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{embedded_scene, load};

    fn scene(name: &str) -> Scene {
        load(embedded_scene(name).unwrap().text, name).unwrap()
    }

    #[test]
    fn the_way_forward_and_the_way_back_undo_each_other() {
        let scene = scene("textures/image_map");
        let size = Image { width: 48, height: 36 };
        for object in ["wall", "floor"] {
            let patch = Patch::choose(&scene, Some(object), None).unwrap();
            for st in [DVec2::splat(0.5), DVec2::new(0.1, 0.9), DVec2::new(0.75, 0.25)] {
                let Some(at) = patch.picture_from_st(&scene, size, st) else { panic!("{object}: {st} is not seen") };
                let back = patch.st_from_picture(&scene, size, at).unwrap();
                assert!((back - st).length() < 1e-9, "{object}: {st} comes back as {back}");
            }
        }
    }

    #[test]
    fn a_pixel_of_inverse_scanning_has_the_s_and_t_that_the_tracer_records_there() {
        use crate::record::What;
        let scene = scene("textures/image_map");
        let patch = Patch::choose(&scene, Some("wall"), None).unwrap();
        let tree = crate::trace::record_pixel(&scene, 180, 120);
        let recorded = (0..tree.end()).find_map(|id| match &tree.event(id).what {
            What::Mapping(mapping) => Some(DVec2::from(mapping.st)),
            _ => None,
        });
        let own = patch.st_from_picture(&scene, scene.image, DVec2::new(180.5, 120.5)).unwrap();
        assert!((own - recorded.unwrap()).length() < 1e-9);
    }

    #[test]
    fn without_a_part_the_one_that_the_eye_sees_is_taken() {
        let text = r#"{"camera": {"eye": [9, 0.5, 0.5], "look_at": [0, 0, 0]},
            "materials": {"m": {"texture": {"kind": "image", "file": "checker.png"}}},
            "objects": [{"shape": "sphere", "material": "m", "name": "ball"},
                        {"shape": "cube", "material": "m", "name": "box"}]}"#;
        let scene = load(text, "textures/here").unwrap();
        let size = Image { width: 40, height: 30 };
        let scanning = Scanning::new(&scene, size, None, None).unwrap();
        assert_eq!((scanning.object.as_str(), scanning.part.as_str()), ("box", "right"));
        let top = Scanning::new(&scene, size, Some("box"), Some("top")).unwrap();
        assert_eq!(top.part, "top");
        let wrong = |object, part| Scanning::new(&scene, size, Some(object), part).unwrap_err();
        assert!(wrong("ball", None).contains("carries no picture on a flat part; one of `box`"));
        assert!(wrong("bow", None).contains("`bow` is not in the scene; one of `box`"));
        assert!(wrong("box", Some("wall")).contains("one of `top`, `bottom`, `right`"));
    }
}
