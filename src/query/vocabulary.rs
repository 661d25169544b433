//! The names that a scene gives to things.

use crate::csg::Node;
use crate::scene::Scene;
use std::collections::BTreeSet;

/// The names in a scene, each list in the order of the alphabet.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Vocabulary {
    /// Objects.
    pub objects: Vec<String>,
    /// Primitives within objects.
    pub leaves: Vec<String>,
    /// Pairs in Boolean trees.
    pub nodes: Vec<String>,
    /// Parts of surfaces.
    pub parts: Vec<String>,
    /// Materials.
    pub materials: Vec<String>,
    /// Lights.
    pub lights: Vec<String>,
    /// What a ray can travel in: air, and every object.
    pub media: Vec<String>,
}

impl Vocabulary {
    /// All names of a scene.
    #[must_use]
    pub fn of(scene: &Scene) -> Self {
        let leaves = || scene.objects.iter().flat_map(|object| &object.solid.leaves);
        let nodes = scene.objects.iter().flat_map(|object| &object.solid.nodes);
        let objects = sorted(scene.objects.iter().map(|object| object.name.clone()));
        Self {
            leaves: sorted(leaves().map(|leaf| leaf.name.clone())),
            nodes: sorted(nodes.filter_map(|node| match node {
                Node::Pair { name, .. } => Some(name.clone()),
                Node::Leaf { .. } => None,
            })),
            parts: sorted(leaves().flat_map(|leaf| leaf.parts.clone())),
            materials: sorted(scene.materials.iter().map(|material| material.name.clone())),
            lights: sorted(scene.lights.iter().map(|light| light.name.clone())),
            media: sorted(objects.iter().cloned().chain(["air".to_owned()])),
            objects,
        }
    }
}

fn sorted(names: impl Iterator<Item = String>) -> Vec<String> {
    names.collect::<BTreeSet<_>>().into_iter().collect()
}
