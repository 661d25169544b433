//! A place in the JSON, such as `objects[2].of[0].s`: written as the messages about scene files write it.

use std::fmt::{self, Display};

/// A step from a JSON value to one inside it.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Step {
    /// To the value of a field.
    Field(String),
    /// To an item of a list, counted from 0.
    Item(usize),
}

/// The steps from the whole of the file to a value. The whole itself has none.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Place(pub Vec<Step>);

impl Place {
    /// The whole file.
    pub const ROOT: Self = Self(Vec::new());

    /// The value of a field of what is here.
    #[must_use]
    pub fn field(&self, name: &str) -> Self {
        self.with(Step::Field(name.to_owned()))
    }

    /// An item of the list that is here.
    #[must_use]
    pub fn item(&self, index: usize) -> Self {
        self.with(Step::Item(index))
    }

    fn with(&self, step: Step) -> Self {
        let mut steps = self.0.clone();
        steps.push(step);
        Self(steps)
    }

    /// What this is inside of, with the last step; none for the whole.
    #[must_use]
    pub fn parent(&self) -> Option<(Self, &Step)> {
        let (last, before) = self.0.split_last()?;
        Some((Self(before.to_vec()), last))
    }

    /// Whether `other` is this place, or lies inside it.
    #[must_use]
    pub fn holds(&self, other: &Self) -> bool {
        other.0.starts_with(&self.0)
    }

    /// The name of the last field on the way; none for the whole.
    #[must_use]
    pub fn last_field(&self) -> Option<&str> {
        self.0.iter().rev().find_map(|step| match step {
            Step::Field(name) => Some(name.as_str()),
            Step::Item(_) => None,
        })
    }

    /// Reads what [`Display`] writes; none where the text is no place.
    #[must_use]
    pub fn read(text: &str) -> Option<Self> {
        let mut steps = Vec::new();
        let mut rest = text;
        while !rest.is_empty() {
            let (step, after) = if let Some(quoted) = rest.strip_prefix("[\"") {
                let end = closing_quote(quoted)?;
                let name: String = serde_json::from_str(&format!("\"{}\"", &quoted[..end])).ok()?;
                (Step::Field(name), quoted[end + 1..].strip_prefix(']')?)
            } else if let Some(item) = rest.strip_prefix('[') {
                let (index, after) = item.split_once(']')?;
                (Step::Item(index.parse().ok()?), after)
            } else {
                let name = if steps.is_empty() { rest } else { rest.strip_prefix('.')? };
                let end = name.find(['.', '[']).unwrap_or(name.len());
                (Step::Field(name[..end].to_owned()), &name[end..])
            };
            if matches!(&step, Step::Field(name) if name.is_empty() && !rest.starts_with("[\"")) {
                return None;
            }
            steps.push(step);
            rest = after;
        }
        Some(Self(steps))
    }
}

fn closing_quote(text: &str) -> Option<usize> {
    let mut escaped = false;
    text.char_indices().find_map(|(at, character)| {
        let closes = character == '"' && !escaped;
        escaped = character == '\\' && !escaped;
        closes.then_some(at)
    })
}

impl Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, step) in self.0.iter().enumerate() {
            match step {
                Step::Item(index) => write!(f, "[{index}]")?,
                Step::Field(name) if !is_plain(name) => write!(f, "[{}]", serde_json::Value::from(name.as_str()))?,
                Step::Field(name) if i == 0 => f.write_str(name)?,
                Step::Field(name) => write!(f, ".{name}")?,
            }
        }
        Ok(())
    }
}

fn is_plain(name: &str) -> bool {
    !name.is_empty() && name.chars().all(|c| c.is_alphanumeric() || matches!(c, '_' | '$'))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_place_is_read_as_it_is_written() {
        let place = Place::ROOT.field("materials").field("blue \"glass\"").item(3).field("s");
        assert_eq!(place.to_string(), r#"materials["blue \"glass\""][3].s"#);
        assert_eq!(Place::read(&place.to_string()), Some(place));
        assert_eq!(Place::read(""), Some(Place::ROOT));
        assert_eq!(Place::read("objects[2].of[0]"), Some(Place::ROOT.field("objects").item(2).field("of").item(0)));
    }

    #[test]
    fn what_is_no_place_is_refused() {
        for text in ["[", "a.", "a[x]", "a[1", "a[\"b", ".a", "a..b"] {
            assert_eq!(Place::read(text), None, "{text}");
        }
    }

    #[test]
    fn an_object_holds_its_parts_and_not_its_neighbours() {
        let object = Place::ROOT.field("objects").item(1);
        assert!(object.holds(&object) && object.holds(&object.field("s")));
        assert!(!object.holds(&Place::ROOT.field("objects").item(10)));
    }
}
