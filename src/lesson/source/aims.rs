//! Step blocks: what is looked at, with what is left out taken from the step before.

use super::blocks::{AccuracyFile, AlsoFile, ChangeFile, LevelFile, StepFile, Text, VariantFile};
use super::lesson::Site;
use crate::document;
use crate::lesson::expression::Expression;
use crate::lesson::model::{Aim, At, Change, Condition, Sited, Step};
use crate::query::Query;
use crate::scene::Profile;
use crate::story::Level;
use crate::view::{ALL_VIEWS, View};

/// What the keys of an aim say.
struct Keys<'a> {
    scene: Option<&'a Text>,
    change: Option<&'a [ChangeFile]>,
    pixel: Option<[u32; 2]>,
    ray: Option<[f64; 6]>,
    accuracy: Option<&'a AccuracyFile>,
}

impl Site<'_, '_> {
    /// The step that a block describes, without its text.
    pub fn step(&mut self, file: &StepFile, title: String, before: &Aim) -> Step {
        let keys = Keys {
            scene: file.scene.as_ref(),
            change: file.change.as_deref(),
            pixel: file.pixel,
            ray: file.ray,
            accuracy: file.accuracy.as_ref(),
        };
        let mut aim = self.aim(&keys, before);
        if file.scene.is_none() && file.change.is_some() {
            // A step says all of its changes; only further traces and variants add to them.
            aim.changes = self.changes(file.change.as_deref().unwrap_or_default());
        }
        let event = file.event.as_ref().and_then(|text| self.query(text));
        let names: Vec<_> =
            file.names.iter().filter_map(|(name, text)| Some((name.clone(), self.expression(text)?))).collect();
        let also = file.also.iter().map(|(name, also)| (name.clone(), self.also(also, &aim))).collect();
        let variants = file.variants.iter().map(|variant| self.variant(variant, &aim)).collect();
        Step {
            title,
            place: self.place(),
            is_whole: !aim.is_lost && event.is_some() == file.event.is_some() && names.len() == file.names.len(),
            event,
            level: match file.level {
                Some(LevelFile::Working) => Level::Working,
                Some(LevelFile::Everything) => Level::Everything,
                Some(LevelFile::Story) | None => Level::Story,
            },
            views: file.views.iter().filter_map(|name| self.view(name)).collect(),
            after: file.after.iter().filter_map(|name| self.view(name)).collect(),
            highlight: file.highlight.iter().filter_map(|text| self.query(text)).collect(),
            t: file.t.as_ref().and_then(|text| self.expression(text)),
            names,
            also,
            variants,
            parts: Vec::new(),
            aim,
        }
    }

    fn also(&mut self, file: &AlsoFile, step: &Aim) -> Aim {
        let keys = Keys {
            scene: file.scene.as_ref(),
            change: file.change.as_deref(),
            pixel: file.pixel,
            ray: file.ray,
            accuracy: file.accuracy.as_ref(),
        };
        self.aim(&keys, step)
    }

    fn variant(&mut self, file: &VariantFile, step: &Aim) -> Aim {
        let keys =
            Keys { scene: None, change: file.change.as_deref(), pixel: file.pixel, ray: file.ray, accuracy: None };
        self.aim(&keys, step)
    }

    fn aim(&mut self, keys: &Keys, before: &Aim) -> Aim {
        let mut aim = before.clone();
        if let Some(scene) = keys.scene {
            aim = Aim { scene: scene.get_ref().clone(), ..Aim::default() };
        }
        // What is taken over stays where it was said, so that what is wrong with it is told once.
        let says = keys.scene.is_some() || keys.change.is_some() || keys.pixel.is_some() || keys.ray.is_some();
        if says || aim.scene.is_empty() {
            aim.place = self.place();
        }
        aim.changes.extend(self.changes(keys.change.unwrap_or_default()));
        match (keys.pixel, keys.ray) {
            (Some(_), Some(_)) => self.add("a step has a pixel or a ray, not both"),
            (Some(pixel), None) => aim.at = Some(At::Pixel(pixel)),
            (None, Some(ray)) => aim.at = Some(At::Ray(ray)),
            (None, None) => {}
        }
        if let Some(accuracy) = keys.accuracy {
            aim.accuracy = self.accuracy(accuracy);
        }
        aim
    }

    fn accuracy(&mut self, file: &AccuracyFile) -> Option<Profile> {
        let text = match file {
            AccuracyFile::Named(name) => {
                let found = Profile::NAMED.iter().find(|(known, _)| known == name);
                if found.is_none() {
                    let names = Profile::NAMED.map(|(name, _)| name).join(", ");
                    self.add(format!("there is no accuracy profile `{name}`: there are {names}"));
                }
                return found.map(|(_, profile)| *profile);
            }
            AccuracyFile::Table(table) => serde_json::to_string(table).unwrap_or_default(),
        };
        let profile = Profile::read(&text, "the accuracy");
        profile.map_err(|errors| self.add(format!("{errors}"))).ok()
    }

    /// The changes of a list.
    pub fn changes(&mut self, files: &[ChangeFile]) -> Vec<Change> {
        files.iter().filter_map(|file| self.change(file)).collect()
    }

    fn change(&mut self, file: &ChangeFile) -> Option<Change> {
        // A JSON pointer would be read as the name of one field.
        let place = document::Place::read(file.at.get_ref()).filter(|_| !file.at.get_ref().contains('/'));
        let Some(at) = place else {
            let message = format!(
                "`{}` is no place in a scene: write one such as `camera.eye` or `objects[0].transform[1].translate`",
                file.at.get_ref()
            );
            self.add_to(&file.at, message);
            return None;
        };
        let to = serde_json::to_value(&file.to).unwrap_or_default();
        Some(Change { at, to: whole(to) })
    }

    /// An expression.
    pub fn expression(&mut self, text: &Text) -> Option<Sited<Expression>> {
        let place = self.place_of(text);
        match Expression::parse(text.get_ref()) {
            Ok(expression) => Some(Sited::new(expression, place)),
            Err(error) => {
                self.add_to(text, format!("`{}`: {}", text.get_ref(), error.message));
                None
            }
        }
    }

    /// A question to the trace.
    pub fn query(&mut self, text: &Text) -> Option<Sited<Query>> {
        match Query::parse(text.get_ref()) {
            Ok(query) => Some(Sited::new(query, self.place_of(text))),
            Err(error) => {
                self.add_to(text, format!("`{}`: {error}", text.get_ref()));
                None
            }
        }
    }

    /// A question, or with `=` before it an expression.
    pub fn condition(&mut self, text: &Text) -> Option<Sited<Condition>> {
        let Some(expression) = text.get_ref().trim_start().strip_prefix('=') else {
            let query = self.query(text)?;
            return Some(Sited::new(Condition::Event(query.value), query.place));
        };
        match Expression::parse(expression) {
            Ok(expression) => Some(Sited::new(Condition::Holds(expression), self.place_of(text))),
            Err(error) => {
                self.add_to(text, format!("`{}`: {}", text.get_ref(), error.message));
                None
            }
        }
    }

    fn view(&mut self, name: &Text) -> Option<Sited<&'static View>> {
        let view = View::named(name.get_ref());
        if view.is_none() {
            let names: Vec<_> = ALL_VIEWS.iter().map(|view| view.name).collect();
            self.add_to(name, format!("there is no view `{}`: there are {}", name.get_ref(), names.join(", ")));
        }
        view.map(|view| Sited::new(view, self.place_of(name)))
    }
}

/// Whole numbers as scene files write them: TOML tells 5 from 5.0, JSON does not.
fn whole(value: serde_json::Value) -> serde_json::Value {
    use serde_json::Value;
    match value {
        Value::Array(items) => Value::Array(items.into_iter().map(whole).collect()),
        Value::Object(fields) => Value::Object(fields.into_iter().map(|(name, value)| (name, whole(value))).collect()),
        Value::Number(number) => match number.as_f64() {
            #[expect(clippy::cast_possible_truncation, reason = "a whole number of at most nine digits")]
            Some(x) if x.fract() == 0.0 && x.abs() < 1e9 => Value::from(x as i64),
            _ => Value::Number(number),
        },
        value => value,
    }
}
