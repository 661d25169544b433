//! What is wrong with a file, and where in the JSON.

use std::fmt::{self, Display, Write};

/// A step from a JSON value to one inside it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Step {
    /// To the value of a field.
    Field(String),
    /// To an item of a list.
    Item(usize),
}

/// A place in the JSON, as a chain of borrowed steps: costs nothing until something is wrong.
#[derive(Clone, Copy)]
pub(super) enum Path<'a> {
    /// The whole.
    Root,
    /// The value of a field.
    Field(&'a Path<'a>, &'a str),
    /// An item of a list.
    Item(&'a Path<'a>, usize),
}

impl<'a> Path<'a> {
    /// The value of a field of what is here.
    pub fn field(&'a self, name: &'a str) -> Self {
        Self::Field(self, name)
    }

    /// An item of the list that is here.
    pub fn item(&'a self, index: usize) -> Self {
        Self::Item(self, index)
    }

    fn steps(&self) -> Vec<Step> {
        let (mut steps, mut here) = (Vec::new(), self);
        loop {
            match here {
                Self::Root => break,
                Self::Field(outer, name) => {
                    steps.push(Step::Field((*name).to_owned()));
                    here = outer;
                }
                Self::Item(outer, index) => {
                    steps.push(Step::Item(*index));
                    here = outer;
                }
            }
        }
        steps.reverse();
        steps
    }
}

/// Something wrong.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Problem {
    /// Where.
    pub steps: Vec<Step>,
    /// Whether it is the name of the last field that is wrong, not its value.
    pub at_name: bool,
    /// What was read and what is wrong with it.
    pub message: String,
    /// What to do.
    pub help: Vec<String>,
}

impl Problem {
    /// The place as text, such as `objects[2].of[0].s`; empty for the whole.
    pub fn path(&self) -> String {
        path_text(&self.steps)
    }
}

impl Display for Problem {
    /// On one line.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let path = self.path();
        if !path.is_empty() {
            write!(f, "{path}: ")?;
        }
        f.write_str(&self.message)?;
        self.help.iter().try_for_each(|help| write!(f, "; {help}"))
    }
}

fn path_text(steps: &[Step]) -> String {
    let mut text = String::new();
    for step in steps {
        // Writing to a string cannot fail.
        let _ = match step {
            Step::Item(index) => write!(text, "[{index}]"),
            Step::Field(name) if !is_plain(name) => write!(text, "[{name:?}]"),
            Step::Field(name) if text.is_empty() => write!(text, "{name}"),
            Step::Field(name) => write!(text, ".{name}"),
        };
    }
    text
}

fn is_plain(name: &str) -> bool {
    !name.is_empty() && name.chars().all(|c| c.is_alphanumeric() || matches!(c, '_' | '$'))
}

/// Problems that are kept. Nobody reads more, and a megabyte of nonsense must not make as many messages.
const MOST_PROBLEMS: usize = 500;

/// The list that problems are gathered in.
#[derive(Debug, Default)]
pub(super) struct Problems {
    pub list: Vec<Problem>,
    /// How many more there were.
    pub left_out: usize,
}

impl Problems {
    /// Whether something was already found to be wrong with the value at `path`.
    pub fn mention(&self, path: Path) -> bool {
        let steps = path.steps();
        self.list.iter().any(|problem| problem.steps == steps)
    }

    /// Notes that something is wrong with the value at `path`; help may be added to what is returned.
    pub fn add(&mut self, path: Path, message: impl Into<String>) -> Help<'_> {
        self.push(Problem { steps: path.steps(), at_name: false, message: message.into(), help: Vec::new() })
    }

    /// Notes that something is wrong with the name of the field at `path`.
    pub fn add_at_name(&mut self, path: Path, message: impl Into<String>) -> Help<'_> {
        self.push(Problem { steps: path.steps(), at_name: true, message: message.into(), help: Vec::new() })
    }

    /// All problems, each once: a named solid's come up again with every copy of it.
    pub fn distinct(self) -> Vec<Problem> {
        let mut distinct: Vec<Problem> = Vec::new();
        for problem in self.list {
            if !distinct.contains(&problem) {
                distinct.push(problem);
            }
        }
        distinct
    }

    fn push(&mut self, problem: Problem) -> Help<'_> {
        if self.list.len() == MOST_PROBLEMS {
            self.left_out += 1;
            return Help(None);
        }
        self.list.push(problem);
        Help(self.list.last_mut())
    }
}

/// Adds help to the problem that was just noted.
pub(super) struct Help<'a>(Option<&'a mut Problem>);

impl Help<'_> {
    /// Says what to do.
    pub fn help(self, text: impl Into<String>) -> Self {
        if let Self(Some(problem)) = self {
            problem.help.push(text.into());
            return Self(Some(problem));
        }
        self
    }

    /// Names the nearest of the `known` names, or all of them where none is near.
    pub fn suggest<'n>(self, what: &str, name: &str, known: impl Iterator<Item = &'n str> + Clone) -> Self {
        if let Some(near) = nearest(name, known.clone()) {
            return self.help(format!("did you mean `{near}`?"));
        }
        let all: Vec<_> = known.map(|name| format!("`{name}`")).collect();
        match all.len() {
            0 => self.help(format!("there are no {what} here")),
            _ => self.help(format!("the {what} here are {}", all.join(", "))),
        }
    }
}

/// The known name that `name` is most likely a slip of: at most a third of its letters differ.
pub(super) fn nearest<'n>(name: &str, known: impl Iterator<Item = &'n str>) -> Option<&'n str> {
    let distance = |other: &str| strsim::damerau_levenshtein(&name.to_lowercase(), &other.to_lowercase());
    known
        .map(|other| (distance(other), other))
        .filter(|(distance, other)| *distance <= (other.chars().count() / 3).max(1))
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, other)| other)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_read_like_code() {
        let root = Path::Root;
        let objects = root.field("objects");
        let second = objects.item(2);
        let path = second.field("blue glass");
        assert_eq!(path_text(&path.steps()), "objects[2][\"blue glass\"]");
    }

    #[test]
    fn the_nearest_name_forgives_slips_but_not_other_words() {
        let known = ["sphere", "square", "cone"];
        assert_eq!(nearest("shpere", known.into_iter()), Some("sphere"));
        assert_eq!(nearest("Cone", known.into_iter()), Some("cone"));
        assert_eq!(nearest("banana", known.into_iter()), None);
    }
}
