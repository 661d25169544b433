//! Scenes to begin with.

/// A scene to begin with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Template {
    /// A ball on a floor under a lamp.
    Ball,
    /// A solid that something is cut out of.
    Carved,
    /// A glass ball before a chequered wall.
    Glass,
}

impl Template {
    /// All of them, in the order of menus.
    pub const ALL: [Self; 3] = [Self::Ball, Self::Carved, Self::Glass];

    /// Its text: a scene without errors.
    #[must_use]
    pub fn text(self) -> String {
        let (materials, objects) = match self {
            Self::Ball => (
                r#""clay": { "ambient": [0.5, 0.2, 0.1], "diffuse": [0.5, 0.2, 0.1], "specular": [0.3, 0.3, 0.3] }"#,
                r#"{
      "shape": "sphere",
      "name": "ball",
      "material": "clay",
      "transform": [{ "translate": [0, 0, 1] }]
    }"#,
            ),
            Self::Carved => (
                r#""clay": { "ambient": [0.5, 0.2, 0.1], "diffuse": [0.5, 0.2, 0.1], "specular": [0.3, 0.3, 0.3] },
    "cut": { "ambient": [0.2, 0.3, 0.5], "diffuse": [0.2, 0.3, 0.5] }"#,
                r#"{
      "shape": "difference",
      "name": "carved",
      "transform": [{ "translate": [0, 0, 1] }],
      "of": [
        { "shape": "cube", "name": "block", "material": "clay" },
        {
          "shape": "sphere",
          "name": "hollow",
          "material": "cut",
          "transform": [{ "scale": 0.9 }, { "translate": [0.6, -0.8, 0.7] }]
        }
      ]
    }"#,
            ),
            Self::Glass => (
                r#""glass": {
      "ambient": [0, 0, 0],
      "diffuse": [0, 0, 0],
      "transparency": 1,
      "index_of_refraction": 1.5,
      "fresnel": { "kind": "dielectric" }
    },
    "wall": {
      "ambient": [1, 1, 1],
      "diffuse": [1, 1, 1],
      "texture": { "kind": "checker", "colours": [[0.1, 0.2, 0.4], [0.7, 0.7, 0.6]], "size": 0.5 }
    }"#,
                r#"{
      "shape": "sphere",
      "name": "lens",
      "material": "glass",
      "transform": [{ "translate": [0, 0, 1] }]
    },
    {
      "shape": "cube",
      "name": "wall",
      "material": "wall",
      "transform": [{ "scale": [4, 0.1, 2] }, { "translate": [0, 4, 2] }]
    }"#,
            ),
        };
        format!(
            r#"{{
  "title": "A new scene",
  "camera": {{ "eye": [3, -6, 3], "look_at": [0, 0, 0.8], "field_of_view": 35 }},
  "image": {{ "width": 640, "height": 480 }},
  "ambient": [0.2, 0.2, 0.2],
  "lights": [{{ "name": "lamp", "point": [-6, -8, 12] }}],
  "materials": {{
    "floor": {{ "ambient": [0.4, 0.4, 0.4], "diffuse": [0.4, 0.4, 0.4] }},
    {materials}
  }},
  "objects": [
    {{ "shape": "plane", "name": "floor", "material": "floor" }},
    {objects}
  ]
}}
"#
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::load;

    #[test]
    fn every_template_is_a_scene_in_which_something_is_hit() {
        for template in Template::ALL {
            let scene = load(&template.text(), "new").unwrap_or_else(|errors| panic!("{template:?}: {errors}"));
            let [x, y] = [scene.image.width / 2, scene.image.height / 2];
            let tree = crate::trace::record_pixel(&scene, x, y);
            assert!(tree.events.iter().any(|event| matches!(event.what, crate::record::What::Hit { .. })));
        }
    }
}
