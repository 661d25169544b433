//! The properties of a thing of the scene, each with its value, what it may be, and what it means: from the schema.

use super::completion::{is_meant, names_for, value_at};
use super::guide::{Allowed, Guide, Rule};
use super::place::{Place, Step};
use crate::math::portable;
use serde_json::Value;

/// What a property is changed with.
#[derive(Clone, Debug, PartialEq)]
pub enum Control {
    /// A number.
    Number(f64, Range),
    /// Two to four numbers: a point, a direction, factors.
    Numbers(Vec<f64>, Range),
    /// A colour in linear RGB.
    Colour([f64; 3]),
    /// One of several words, each with what it means.
    Choice(String, Vec<(String, String)>),
    /// The name of something else in the file.
    Name(String, Vec<String>),
    /// Yes or no.
    Switch(bool),
    /// Free text.
    Text(String),
}

/// What a number may be.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Range {
    /// The least value.
    pub low: Option<f64>,
    /// The greatest value.
    pub high: Option<f64>,
    /// Whether the least and greatest values themselves are outside.
    pub open: [bool; 2],
    /// Whether it is whole.
    pub whole: bool,
    /// Its unit, as it is written behind numbers; empty where it has none.
    pub unit: &'static str,
}

/// A property.
#[derive(Clone, Debug, PartialEq)]
pub struct Property {
    /// Where it stands, or would stand.
    pub place: Place,
    /// The name of its field.
    pub name: String,
    /// What it means.
    pub about: String,
    /// Its value, or the one that counts where none is written.
    pub control: Control,
    /// Whether it is written.
    pub is_written: bool,
}

/// Properties that belong together: those of a thing itself, or of something in it.
#[derive(Clone, Debug, PartialEq)]
pub struct Section {
    /// What they belong to.
    pub place: Place,
    /// The name of the field, or of the kind: `transform`, `lens`; empty for the thing itself.
    pub name: String,
    /// What it means.
    pub about: String,
    /// The properties.
    pub properties: Vec<Property>,
    /// The number of the step, where the section is a step of a list that can be added to and taken from.
    pub step: Option<usize>,
}

/// Objects within objects are looked into no deeper: a texture's warp's turbulence is as deep as scenes go.
const MOST_DEPTH: usize = 6;

/// The properties of what stands at a place, its own first.
#[must_use]
pub fn sheet(whole: &Value, place: &Place) -> Vec<Section> {
    let mut sections = Vec::new();
    Sheet { guide: Guide::scene(), whole, sections: &mut sections }.object(place, "", None, MOST_DEPTH);
    sections
}

struct Sheet<'a> {
    guide: &'static Guide,
    whole: &'a Value,
    sections: &'a mut Vec<Section>,
}

impl Sheet<'_> {
    fn object(&mut self, place: &Place, name: &str, step: Option<usize>, depth: usize) {
        let Some(depth) = depth.checked_sub(1) else { return };
        let allowed = self.guide.at(self.whole, place);
        let here = value_at(self.whole, place);
        let fitting = self.guide.fitting(&allowed.rules, here, None);
        let Some(rule) = fitting.first().copied() else { return };
        let section = self.sections.len();
        let about = rule.get("description").and_then(Value::as_str).unwrap_or(allowed.description(self.guide));
        let about = about.to_owned();
        self.sections.push(Section {
            place: place.clone(),
            name: name.to_owned(),
            about,
            properties: Vec::new(),
            step,
        });
        let names = rule.get("properties").and_then(Value::as_object).into_iter().flatten().map(|(name, _)| name);
        for name in names.filter(|name| is_meant(place, name)) {
            let place = place.field(name);
            let written = value_at(self.whole, &place);
            let allowed = self.guide.at(self.whole, &place);
            if let Some(control) = self.control(&place, &allowed, written) {
                let about = allowed.description(self.guide).to_owned();
                let property = Property { place, name: name.clone(), about, control, is_written: written.is_some() };
                self.sections[section].properties.push(property);
            } else {
                self.inside(&place, name, written, depth);
            }
        }
        if self.sections[section].properties.is_empty() && step.is_none() && !name.is_empty() {
            self.sections.remove(section);
        }
    }

    /// What is written in an object, or in the steps of a transform. Parts are things of their own.
    fn inside(&mut self, place: &Place, name: &str, written: Option<&Value>, depth: usize) {
        match written {
            Some(Value::Object(_)) => self.object(place, name, None, depth),
            Some(Value::Array(steps)) if name == "transform" => {
                for (i, step) in steps.iter().enumerate() {
                    let kind = step.as_object().and_then(|step| step.keys().next()).cloned().unwrap_or_default();
                    self.object(&place.item(i), &kind, Some(i), depth);
                }
            }
            _ => {}
        }
    }

    fn control(&self, place: &Place, allowed: &Allowed, written: Option<&Value>) -> Option<Control> {
        let value = written.or_else(|| allowed.default());
        if let Some(shapes) = self.shapes(place, value) {
            return Some(shapes);
        }
        if let Some(names) = names_for(self.whole, place) {
            return Some(Control::Name(text_of(value), names));
        }
        let words: Vec<(String, String)> = allowed.rules.iter().filter_map(word).collect();
        if words.len() == allowed.rules.len() && !words.is_empty() {
            // The tag of a kind with a single value is not a choice.
            return (words.len() > 1).then(|| Control::Choice(text_of(value), words));
        }
        if let Some(Value::Array(items)) = value {
            return numbers(items, allowed, place);
        }
        match value {
            Some(Value::Number(number)) => Some(Control::Number(number.as_f64()?, range(allowed, place))),
            Some(Value::Bool(on)) => Some(Control::Switch(*on)),
            Some(Value::String(text)) => Some(Control::Text(text.clone())),
            None if allowed.takes("string") => Some(Control::Text(String::new())),
            None if allowed.takes("boolean") => Some(Control::Switch(false)),
            _ => None,
        }
    }

    /// Every shape that a solid can have, not only those that its parameters fit: another shape comes with its own.
    fn shapes(&self, place: &Place, shape: Option<&Value>) -> Option<Control> {
        let (solid, Step::Field(name)) = place.parent()? else { return None };
        if name != "shape" {
            return None;
        }
        let shape = text_of(shape);
        // A copy needs a solid to be a copy of.
        let has_solids = names_for(self.whole, &solid.field("solid")).is_some_and(|names| !names.is_empty());
        let shape_of = |rule: &&Rule| word(&rule.get("properties")?.get("shape")?.as_object()?);
        let allowed = self.guide.at(self.whole, &solid);
        let meant = allowed
            .rules
            .iter()
            .filter_map(shape_of)
            .filter(|(other, _)| has_solids || other != "copy" || *other == shape);
        let words: Vec<(String, String)> = meant.collect();
        (words.len() > 1).then_some(Control::Choice(shape, words))
    }
}

fn text_of(value: Option<&Value>) -> String {
    value.and_then(Value::as_str).unwrap_or_default().to_owned()
}

fn word(rule: &&Rule) -> Option<(String, String)> {
    let word = rule.get("const")?.as_str()?.to_owned();
    Some((word, rule.get("description").and_then(Value::as_str).unwrap_or_default().to_owned()))
}

fn numbers(items: &[Value], allowed: &Allowed, place: &Place) -> Option<Control> {
    let numbers: Vec<f64> = items.iter().map(Value::as_f64).collect::<Option<_>>()?;
    let is_colour = allowed.uses.iter().chain(&allowed.rules).any(|rule| {
        let is_reference = rule.get("$ref").and_then(Value::as_str).is_some_and(|name| name.ends_with("/Colour"));
        is_reference
            || rule
                .get("description")
                .and_then(Value::as_str)
                .is_some_and(|about| about.starts_with("A colour in linear RGB"))
    });
    match numbers[..] {
        [red, green, blue] if is_colour => Some(Control::Colour([red, green, blue])),
        [_, _] | [_, _, _] | [_, _, _, _] => Some(Control::Numbers(numbers, range(allowed, place))),
        _ => None,
    }
}

fn range(allowed: &Allowed, place: &Place) -> Range {
    let low = allowed.limit("minimum").or(allowed.limit("exclusiveMinimum"));
    let high = allowed.limit("maximum").or(allowed.limit("exclusiveMaximum"));
    let open = ["exclusiveMinimum", "exclusiveMaximum"].map(|word| allowed.limit(word).is_some());
    Range { low, high, open, whole: allowed.takes("integer"), unit: unit(place) }
}

/// Distances in a scene have no unit, angles are in degrees, sizes of the picture in pixels.
fn unit(place: &Place) -> &'static str {
    match place.last_field() {
        Some("field_of_view" | "degrees" | "turn") => "°",
        Some("width" | "height") if place.parent().is_some_and(|(above, _)| above.last_field() == Some("image")) => {
            " px"
        }
        _ => "",
    }
}

impl Range {
    /// The nearest value that is allowed; next to an end that is itself outside, a little inside.
    #[must_use]
    pub fn nearest(&self, value: f64) -> f64 {
        let value = if self.whole { value.round() } else { value };
        let inside = 1e-3;
        let low = self.low.map_or(f64::NEG_INFINITY, |low| if self.open[0] { low + inside } else { low });
        let high = self.high.map_or(f64::INFINITY, |high| if self.open[1] { high - inside } else { high });
        value.clamp(low, high.max(low))
    }

    /// A range for a slider: the allowed one, or where that has no end, up to twice as far as the value.
    #[must_use]
    pub fn for_slider(&self, value: f64) -> [f64; 2] {
        let reach = (2.0 * value.abs()).max(2.0);
        let reach = portable::power_of_ten(portable::log10(reach).ceil()).min((reach * 2.0).ceil());
        [
            self.nearest(self.low.unwrap_or(-reach)),
            self.nearest(self.high.unwrap_or(reach).max(self.low.unwrap_or(-reach))),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::embedded_scene;

    fn bowl() -> Value {
        serde_json::from_str(embedded_scene("csg/bowl").unwrap().text).unwrap()
    }

    fn property(sections: &[Section], place: &str) -> Property {
        let all = sections.iter().flat_map(|section| &section.properties);
        all.clone().find(|property| property.place.to_string() == place).unwrap_or_else(|| panic!("no {place}")).clone()
    }

    #[test]
    fn the_camera_has_its_numbers_with_units_and_limits_written_or_not() {
        let sections = sheet(&bowl(), &Place::ROOT.field("camera"));
        let field = property(&sections, "camera.field_of_view");
        let Control::Number(31.0, range) = field.control else { panic!("{field:?}") };
        assert_eq!((range.low, range.high, range.unit), (Some(0.0), Some(180.0), "°"));
        assert!(range.nearest(-3.0) > 0.0 && range.nearest(200.0) < 180.0);
        let limits = sheet(&bowl(), &Place::ROOT.field("limits"));
        let depth = property(&limits, "limits.depth");
        assert!(!depth.is_written && matches!(depth.control, Control::Number(8.0, range) if range.whole));
    }

    #[test]
    fn an_object_has_the_steps_of_its_transform_and_not_those_of_its_parts() {
        let sections = sheet(&bowl(), &Place::read("objects[0]").unwrap());
        let translate = property(&sections, "objects[0].transform[0].translate");
        assert_eq!(translate.control, Control::Numbers(vec![0.0, 0.0, 1.5], Range::default()));
        assert!(sections.iter().all(|section| !section.place.to_string().contains("of[")));
    }

    #[test]
    fn a_material_has_colours_and_numbers_and_a_part_names_its_material() {
        let sections = sheet(&bowl(), &Place::read("materials.glaze").unwrap());
        assert_eq!(property(&sections, "materials.glaze.diffuse").control, Control::Colour([0.09, 0.22, 0.36]));
        let part = sheet(&bowl(), &Place::read("objects[0].of[2]").unwrap());
        let Control::Name(name, names) = property(&part, "objects[0].of[2].material").control else { panic!() };
        assert_eq!((name.as_str(), names.len()), ("rim", 4));
    }

    #[test]
    fn every_solid_can_have_another_shape_whatever_its_parameters() {
        for scene in crate::scene::embedded_scenes() {
            let whole: Value = serde_json::from_str(scene.text).unwrap();
            for target in crate::document::targets(&whole) {
                let Some(shape) = value_at(&whole, &target.place.field("shape")) else { continue };
                let sections = sheet(&whole, &target.place);
                let place = format!("{}.shape", target.place);
                let Control::Choice(word, words) = property(&sections, &place).control else { panic!("{place}") };
                assert_eq!(*shape, word);
                let has = |name: &str| words.iter().any(|(word, _)| word == name);
                assert!(has("torus") && has("sphere") && has("union"), "{}: {place}", scene.name);
                assert_eq!(has("copy"), whole.get("solids").is_some(), "{}: {place}", scene.name);
            }
        }
    }

    #[test]
    fn every_thing_of_every_scene_has_properties() {
        for scene in crate::scene::embedded_scenes() {
            let whole: Value = serde_json::from_str(scene.text).unwrap();
            for target in crate::document::targets(&whole) {
                let sections = sheet(&whole, &target.place);
                assert!(
                    sections.iter().any(|section| !section.properties.is_empty()),
                    "{}: {}",
                    scene.name,
                    target.place
                );
            }
        }
    }
}
