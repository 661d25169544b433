//! Links as text.

use super::packed::pack;
use super::percent::{encoded, encoded_path};
use super::{Accuracy, Aim, EventPlace, Link};
use crate::record::Effect;
use crate::scene::Effects;
use crate::view::Theme;
use std::fmt::{self, Display, Formatter};

/// What every link begins with.
pub(super) const SCHEME: &str = "rayscope:";

/// The names of what a link may say, in the order in which they are written.
pub(super) const NAMES: [&str; 16] = [
    "pixel", "ray", "size", "event", "path", "level", "preset", "views", "theme", "language", "t", "orbit", "accuracy",
    "without", "lesson", "text",
];

/// What stands before a packed text where a name could stand too.
pub(super) const PACKED: char = '*';

impl Display for Link {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "{SCHEME}{}", encoded_path(&self.scene))?;
        for (i, (name, value)) in self.fields().iter().enumerate() {
            write!(f, "{}{name}={value}", if i == 0 { '?' } else { '&' })?;
        }
        Ok(())
    }
}

impl Link {
    fn fields(&self) -> Vec<(&'static str, String)> {
        let (pixel, ray) = match self.aim {
            Some(Aim::Pixel([x, y])) => (Some(format!("{x},{y}")), None),
            Some(Aim::Ray([origin, direction])) => {
                (None, Some(numbers(&[origin.to_array(), direction.to_array()].concat())))
            }
            None => (None, None),
        };
        let of_event = |text: fn(&EventPlace) -> String| self.event.as_ref().map(text);
        let values = [
            pixel,
            ray,
            self.size.map(|[width, height]| format!("{width},{height}")),
            of_event(|event| event.number.to_string()),
            of_event(|event| event.path.join(".")).filter(|path| !path.is_empty()),
            self.level.as_deref().map(encoded),
            self.preset.as_deref().map(encoded),
            Some(list(self.views.iter().map(String::as_str))).filter(|list| !list.is_empty()),
            self.theme.map(|theme| theme_name(theme).to_owned()),
            self.language.as_deref().map(encoded),
            self.t.map(number),
            self.orbit.map(|orbit| numbers(&orbit)),
            self.accuracy.as_ref().map(accuracy),
            self.effects.map(without),
            self.lesson.as_ref().map(|place| format!("{},{}", encoded(&place.lesson), place.step + 1)),
            self.text.as_deref().map(pack),
        ];
        NAMES.into_iter().zip(values).filter_map(|(name, value)| Some((name, value?))).collect()
    }
}

pub(super) const fn theme_name(theme: Theme) -> &'static str {
    match theme {
        Theme::Light => "light",
        Theme::Dark => "dark",
        Theme::LightContrast => "light-contrast",
        Theme::DarkContrast => "dark-contrast",
    }
}

/// An effect's name without spaces.
pub(super) fn effect_name(effect: Effect) -> String {
    effect.name().replace(' ', "-").to_lowercase()
}

fn without(effects: Effects) -> String {
    let off: Vec<String> = Effect::ALL.into_iter().filter(|&effect| !effects.has(effect)).map(effect_name).collect();
    list(off.iter().map(String::as_str))
}

fn accuracy(accuracy: &Accuracy) -> String {
    match accuracy {
        Accuracy::Named(name) => encoded(name),
        Accuracy::Text(text) => format!("{PACKED}{}", pack(text)),
    }
}

fn list<'a>(words: impl Iterator<Item = &'a str>) -> String {
    words.map(encoded).collect::<Vec<_>>().join(",")
}

fn numbers(numbers: &[f64]) -> String {
    numbers.iter().copied().map(number).collect::<Vec<_>>().join(",")
}

/// The shortest form that reads back as the same number.
fn number(x: f64) -> String {
    let text = format!("{x:?}");
    text.strip_suffix(".0").map_or(text.clone(), str::to_owned)
}
