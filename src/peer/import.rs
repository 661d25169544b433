//! Reads a peer scene ("peer-scene/1", described in `tests/peers/gen_scenes.py`) as one of the program's own.
//!
//! The result is the text of a scene file: it goes through the same compiler as any other scene.

use super::camera::{Blur, Camera};
use super::pigment::{Normal, Pigment};
use super::solid::Solid;
use serde::Deserialize;
use serde_json::{Value, json};
use std::collections::BTreeMap;

/// The one version of the format that is read.
const FORMAT: &str = "peer-scene/1";

/// A peer scene as it stands in the file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct PeerScene {
    format: String,
    name: String,
    about: String,
    image: Image,
    camera: Camera,
    /// The lens, if it is not a pinhole.
    dof: Option<Blur>,
    /// Levels: 1 is the camera rays alone.
    max_depth: u32,
    /// A ray that would count less than this is not sent.
    adc_bailout: f64,
    background: [f64; 3],
    lights: Vec<Light>,
    materials: BTreeMap<String, Material>,
    objects: Vec<Solid>,
}

#[derive(Clone, Copy, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Image {
    pub width: u32,
    pub height: u32,
}

#[derive(Deserialize)]
#[serde(tag = "type", rename_all = "snake_case", deny_unknown_fields)]
enum Light {
    Point { position: [f64; 3], rgb: [f64; 3] },
}

/// pigment (1 − transmit) (ambient + diffuse max(0, n·l)) + phong max(0, r·l)^phong_size + reflection and transmit times
/// what these rays bring back.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Material {
    pigment: Pigment,
    ambient: f64,
    diffuse: f64,
    phong: f64,
    phong_size: f64,
    reflection: f64,
    #[serde(default)]
    transmit: f64,
    #[serde(default = "one")]
    ior: f64,
    normal: Option<Normal>,
}

fn one() -> f64 {
    1.0
}

/// The text of a scene file that says the same as this peer scene.
///
/// # Errors
/// Says what in the peer scene is not understood, or cannot be said in a scene file.
pub fn import(text: &str) -> Result<String, String> {
    let peer: PeerScene = serde_json::from_str(text).map_err(|error| format!("not a peer scene: {error}"))?;
    if peer.format != FORMAT {
        return Err(format!("its format is `{}`; only `{FORMAT}` is read", peer.format));
    }
    let levels = peer.max_depth.checked_sub(1).ok_or("max_depth is 0; the camera rays are level 1")?;
    let objects = peer
        .objects
        .iter()
        .enumerate()
        .map(|(k, solid)| solid.to_file().map_err(|message| format!("objects[{k}]: {message}")));
    let mut camera = peer.camera.to_file(peer.image)?;
    if let Some(blur) = &peer.dof {
        camera["lens"] = peer.camera.lens(blur)?;
    }
    let samples = peer.dof.as_ref().map_or(1, |blur| blur.samples);
    let scene = json!({
        "title": peer.name,
        "about": peer.about,
        "camera": camera,
        "sampling": { "samples": samples },
        "image": { "width": peer.image.width, "height": peer.image.height },
        "ambient": [1.0, 1.0, 1.0],
        "background": peer.background,
        "limits": { "depth": levels, "contribution": peer.adc_bailout },
        "lights": peer.lights.iter().map(Light::to_file).collect::<Vec<_>>(),
        "materials": peer.materials.iter().map(|(name, material)| (name, material.to_file())).collect::<BTreeMap<_, _>>(),
        "objects": objects.collect::<Result<Vec<_>, _>>()?,
    });
    serde_json::to_string_pretty(&scene).map(|text| text + "\n").map_err(|error| error.to_string())
}

impl Light {
    fn to_file(&self) -> Value {
        let Self::Point { position, rgb } = self;
        json!({ "point": position, "colour": rgb })
    }
}

impl Material {
    fn to_file(&self) -> Value {
        let rgb = self.pigment.flat_colour();
        let opaque = 1.0 - self.transmit;
        let mut file = json!({
            "ambient": rgb.map(|channel| channel * opaque * self.ambient),
            "diffuse": rgb.map(|channel| channel * opaque * self.diffuse),
            "specular": [self.phong, self.phong, self.phong],
            "exponent": self.phong_size,
            "reflectivity": self.reflection,
            "transparency": self.transmit,
            "index_of_refraction": self.ior,
        });
        if let Some(texture) = self.pigment.texture() {
            file["texture"] = texture;
        }
        if let Some(normal) = &self.normal {
            file["bump"] = normal.bump();
        }
        file
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::load;
    use glam::DVec3;

    fn peer(objects: &str) -> String {
        let camera = r#"{"type": "perspective", "location": [0, 0, -9], "direction": [0, 0, 1], "right": [-0.8, 0, 0],
            "up": [0, 0.6, 0], "note": ""}"#;
        format!(
            r#"{{"format": "peer-scene/1", "name": "n", "about": "a", "image": {{"width": 640, "height": 480}},
            "camera": {camera}, "max_depth": 5, "adc_bailout": 0.004, "background": [0.1, 0.2, 0.3],
            "lights": [{{"type": "point", "position": [1, 2, 3], "rgb": [0.5, 1, 1]}}],
            "materials": {{"m": {{"pigment": {{"type": "solid", "rgb": [0.5, 1, 0]}}, "ambient": 0.5, "diffuse": 0.25, "phong": 0.75,
                "phong_size": 40, "reflection": 0.125, "transmit": 0.5, "ior": 1.5}}}},
            "objects": [{objects}]}}"#
        )
    }

    #[test]
    fn a_pigment_is_weakened_by_what_passes_and_a_highlight_is_not() {
        let text = import(&peer(r#"{"shape": "sphere", "center": [1, 2, 3], "radius": 2, "material": "m"}"#)).unwrap();
        let scene = load(&text, "peer").unwrap();
        let material = &scene.materials[0];
        assert_eq!(material.ambient, DVec3::new(0.125, 0.25, 0.0));
        assert_eq!(material.diffuse, DVec3::new(0.0625, 0.125, 0.0));
        assert_eq!(material.specular, DVec3::splat(0.75));
        assert_eq!((material.reflectivity, material.transparency), (0.125, 0.5));
        assert_eq!((material.exponent, material.index_of_refraction), (40.0, 1.5));
    }

    #[test]
    fn five_levels_are_rays_up_to_four_away_from_the_camera_ray() {
        let scene = load(&import(&peer("")).unwrap(), "peer").unwrap();
        assert_eq!((scene.limits.depth, scene.limits.contribution), (4, 0.004));
    }

    #[test]
    fn what_is_not_understood_is_named() {
        let unknown = import(&peer(r#"{"shape": "blob", "material": "m"}"#)).unwrap_err();
        assert!(unknown.contains("unknown variant `blob`"), "{unknown}");
        let leopard = import(&peer("").replace(r#""type": "solid""#, r#""type": "leopard""#)).unwrap_err();
        assert!(leopard.contains("unknown variant `leopard`") && leopard.contains("line 5"), "{leopard}");
        let fog = import(&peer("").replacen('{', r#"{"fog": {},"#, 1)).unwrap_err();
        assert!(fog.contains("unknown field `fog`"), "{fog}");
        let newer = import(&peer("").replace("peer-scene/1", "peer-scene/2")).unwrap_err();
        assert!(newer.contains("`peer-scene/2`"), "{newer}");
    }
}
