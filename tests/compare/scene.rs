//! The scene of the sample ray tracer, read from a scene file by itself.

use super::Bug;
use glam::{DAffine3, DMat3, DQuat, DVec3};
use serde_json::Value;

/// A primitive in its place.
pub struct Leaf {
    pub name: String,
    pub shape: String,
    pub matrix: DAffine3,
    pub inverse: DAffine3,
    pub material: String,
}

/// A tree of Boolean operators over leaves, which are numbered.
pub enum Solid {
    Leaf(usize),
    Pair(String, Box<Solid>, Box<Solid>),
}

pub struct Object {
    pub name: String,
    pub material: String,
    pub leaves: Vec<Leaf>,
    pub solid: Solid,
}

pub struct Light {
    pub name: String,
    pub point: Option<DVec3>,
    pub towards: DVec3,
    pub colour: DVec3,
}

#[derive(Clone)]
pub struct Material {
    pub ambient: DVec3,
    pub diffuse: DVec3,
    pub specular: DVec3,
    pub exponent: f64,
    pub reflectivity: f64,
    pub transparency: f64,
    pub index: f64,
}

pub struct Scene {
    pub value: Value,
    pub objects: Vec<Object>,
    pub lights: Vec<Light>,
    pub ambient: DVec3,
    pub background: DVec3,
    pub size: [f64; 2],
    pub depth: u32,
    pub bug: Bug,
}

pub fn vector(value: &Value) -> DVec3 {
    let numbers: Vec<f64> = value.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect();
    DVec3::new(numbers[0], numbers[1], numbers[2])
}

impl Scene {
    pub fn read(text: &str, bug: Bug) -> Self {
        let value: Value = serde_json::from_str(text).unwrap();
        let lights = value["lights"].as_array().unwrap().iter().map(light).collect();
        let objects = value["objects"].as_array().unwrap().iter().map(|object| read_object(object, bug)).collect();
        let side = |name: &str, usual: u32| value["image"][name].as_f64().unwrap_or(f64::from(usual));
        Self {
            objects,
            lights,
            ambient: vector(&value["ambient"]),
            background: vector(&value["background"]),
            size: [side("width", 640), side("height", 480)],
            depth: u32::try_from(value["limits"]["depth"].as_u64().unwrap_or(8)).unwrap(),
            value,
            bug,
        }
    }

    pub fn material(&self, name: &str) -> Material {
        let material = &self.value["materials"][name];
        let colour = |name: &str| if material[name].is_array() { vector(&material[name]) } else { DVec3::ZERO };
        let number = |name: &str, usual: f64| material[name].as_f64().unwrap_or(usual);
        Material {
            ambient: colour("ambient"),
            diffuse: colour("diffuse"),
            specular: colour("specular"),
            exponent: number("exponent", 1.0),
            reflectivity: number("reflectivity", 0.0),
            transparency: number("transparency", 0.0),
            index: number("index_of_refraction", 1.0),
        }
    }
}

fn light(value: &Value) -> Light {
    let name = value["name"].as_str().unwrap().to_owned();
    let colour = vector(&value["colour"]);
    if value["point"].is_array() {
        return Light { name, point: Some(vector(&value["point"])), towards: DVec3::ZERO, colour };
    }
    Light { name, point: None, towards: vector(&value["directional"]).normalize(), colour }
}

fn read_object(value: &Value, bug: Bug) -> Object {
    let name = value["name"].as_str().unwrap().to_owned();
    let material = value["material"].as_str().unwrap_or("").to_owned();
    let mut leaves = Vec::new();
    let solid = read_solid(value, DAffine3::IDENTITY, &material, &name, bug, &mut leaves);
    let material = if material.is_empty() { leaves[0].material.clone() } else { material };
    Object { name, material, leaves, solid }
}

fn read_solid(value: &Value, outer: DAffine3, material: &str, name: &str, bug: Bug, leaves: &mut Vec<Leaf>) -> Solid {
    let matrix = outer * transform(&value["transform"], bug);
    let material = value["material"].as_str().unwrap_or(material);
    let shape = value["shape"].as_str().unwrap().to_owned();
    if let Some(parts) = value["of"].as_array() {
        let mut parts = parts.iter().map(|part| {
            let name = part["name"].as_str().unwrap_or("");
            read_solid(part, matrix, material, name, bug, leaves)
        });
        let first = parts.next().unwrap();
        return parts.fold(first, |left, right| Solid::Pair(shape.clone(), Box::new(left), Box::new(right)));
    }
    let material = material.to_owned();
    leaves.push(Leaf { name: name.to_owned(), shape, matrix, inverse: matrix.inverse(), material });
    Solid::Leaf(leaves.len() - 1)
}

fn transform(steps: &Value, bug: Bug) -> DAffine3 {
    let steps: Vec<DAffine3> = steps.as_array().into_iter().flatten().map(step).collect();
    let after = |map: DAffine3, step: &DAffine3| *step * map;
    match bug {
        Bug::TransformOrder => steps.iter().rev().fold(DAffine3::IDENTITY, after),
        _ => steps.iter().fold(DAffine3::IDENTITY, after),
    }
}

fn step(value: &Value) -> DAffine3 {
    if let Some(scale) = value.get("scale") {
        let scale = scale.as_f64().map_or_else(|| vector(scale), DVec3::splat);
        return DAffine3::from_mat3(DMat3::from_diagonal(scale));
    }
    if let Some(rotate) = value.get("rotate") {
        let axis = vector(&rotate["axis"]).normalize();
        return DAffine3::from_quat(DQuat::from_axis_angle(axis, rotate["degrees"].as_f64().unwrap().to_radians()));
    }
    DAffine3::from_translation(vector(&value["translate"]))
}
