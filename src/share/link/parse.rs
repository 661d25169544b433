//! Reading a link that anybody may have written.

use super::packed::unpack;
use super::percent::decoded;
use super::written::{NAMES, PACKED, SCHEME, effect_name, theme_name};
use super::{Accuracy, Aim, EventPlace, LessonPlace, Link, MOST_CHARACTERS};
use crate::record::Effect;
use crate::scene::Effects;
use crate::view::Theme;
use glam::DVec3;
use std::collections::BTreeMap;
use std::error::Error;
use std::fmt::{self, Display, Formatter};
use std::str::FromStr;

/// Words of a link are at most this long: names of presets, languages, kinds of events.
const LONGEST_WORD: usize = 64;

/// A list in a link has at most this many entries: a path of kinds is as deep as a tree, and no tree is deeper.
const LONGEST_LIST: usize = 1000;

/// What is wrong with a link, and what to do.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LinkError(String);

impl LinkError {
    pub(super) fn new(message: impl Into<String>) -> Self {
        Self(message.into())
    }
}

impl Display for LinkError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl Error for LinkError {}

impl Link {
    /// Whether a text is meant to be a link, and not the name of a scene.
    #[must_use]
    pub fn looks_like_one(text: &str) -> bool {
        let text = text.trim();
        text.starts_with(SCHEME) || (text.starts_with("http") && text.contains("://")) || text.starts_with('#')
    }
}

impl FromStr for Link {
    type Err = LinkError;

    fn from_str(text: &str) -> Result<Self, LinkError> {
        let text = text.trim();
        if text.len() > MOST_CHARACTERS {
            return Err(LinkError::new(format!(
                "the link has {} characters, and none has more than {MOST_CHARACTERS}; ask for the file of the scene",
                text.len()
            )));
        }
        let body = body_of(text)?;
        let (scene, query) = body.split_once('?').unwrap_or((body, ""));
        let scene = decoded(scene).map_err(|error| in_part("name of the scene", &error))?;
        if scene.is_empty() {
            return Err(LinkError::new("the link names no scene; one looks like rayscope:csg/bowl?pixel=310,240"));
        }
        let mut fields = Fields::read(query)?;
        let link = fields.link(scene)?;
        Ok(link)
    }
}

/// What follows the scheme, or the `#` of a web address.
fn body_of(text: &str) -> Result<&str, LinkError> {
    let is_web = text.starts_with('#') || text.starts_with("http://") || text.starts_with("https://");
    let body = if is_web { text.split_once('#').map_or("", |(_, body)| body) } else { text };
    match (body.strip_prefix(SCHEME), is_web) {
        (Some(rest), _) => Ok(rest),
        (None, true) if !body.is_empty() => Ok(body),
        (None, true) => Err(LinkError::new(
            "the web address has nothing behind a #, where the scene would stand: …#csg/bowl?pixel=310,240",
        )),
        (None, false) => {
            let shown: String = text.chars().take(40).collect();
            Err(LinkError::new(format!("`{shown}` is no link: one begins with {SCHEME}, such as rayscope:csg/bowl")))
        }
    }
}

fn in_part(part: &str, error: &str) -> LinkError {
    LinkError::new(format!("in the link's {part}: {error}"))
}

/// The values by their names.
struct Fields<'a>(BTreeMap<&'a str, &'a str>);

impl<'a> Fields<'a> {
    fn read(query: &'a str) -> Result<Self, LinkError> {
        let mut fields = BTreeMap::new();
        for part in query.split('&').filter(|part| !part.is_empty()) {
            let (name, value) = part
                .split_once('=')
                .ok_or_else(|| LinkError::new(format!("the link's part `{}` is no name=value", shortened(part))))?;
            if !NAMES.contains(&name) {
                return Err(LinkError::new(format!(
                    "the link says `{}`, which is none of what a link may say ({}); it may come from a newer rayscope, or was \
                     mistyped",
                    shortened(name),
                    NAMES.join(", ")
                )));
            }
            if fields.insert(name, value).is_some() {
                return Err(LinkError::new(format!("the link says `{name}` twice; leave one of them out")));
            }
        }
        Ok(Self(fields))
    }

    fn link(&mut self, scene: String) -> Result<Link, LinkError> {
        let path = self.read_as("path", path)?.unwrap_or_default();
        let number = self.read_as("event", whole)?;
        if number.is_none() && !path.is_empty() {
            return Err(LinkError::new("the link has a path of kinds without the event=NUMBER that it belongs to"));
        }
        Ok(Link {
            scene,
            text: self.read_as("text", unpack)?,
            aim: self.aim()?,
            size: self.read_as("size", size)?,
            event: number.map(|number| EventPlace { number, path }),
            level: self.read_as("level", word)?,
            preset: self.read_as("preset", word)?,
            views: self.read_as("views", words)?.unwrap_or_default(),
            theme: self.read_as("theme", theme)?,
            language: self.read_as("language", word)?,
            t: self.read_as("t", |text| numbers::<1>(text).map(|[t]| t))?,
            orbit: self.read_as("orbit", numbers::<3>)?,
            accuracy: self.read_as("accuracy", accuracy)?,
            effects: self.read_as("without", effects)?,
            lesson: self.read_as("lesson", lesson)?,
        })
    }

    fn read_as<T>(&self, name: &str, read: impl Fn(&str) -> Result<T, String>) -> Result<Option<T>, LinkError> {
        let value = self.0.get(name).map(|value| read(value));
        value.transpose().map_err(|error| in_part(name, &error))
    }

    fn aim(&self) -> Result<Option<Aim>, LinkError> {
        let pixel = self.read_as("pixel", pair)?.map(Aim::Pixel);
        let ray = self.read_as("ray", ray)?.map(Aim::Ray);
        if pixel.is_some() && ray.is_some() {
            return Err(LinkError::new("the link has a pixel and a ray; only one of them can be traced"));
        }
        Ok(pixel.or(ray))
    }
}

fn shortened(text: &str) -> String {
    text.chars().take(LONGEST_WORD).collect()
}

fn whole(text: &str) -> Result<u32, String> {
    let digits = !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    let number = digits.then(|| text.parse().ok()).flatten();
    number.ok_or_else(|| format!("`{}` is no whole number from 0 to {}", shortened(text), u32::MAX))
}

fn pair(text: &str) -> Result<[u32; 2], String> {
    let (x, y) = split_pair(text)?;
    Ok([whole(x)?, whole(y)?])
}

fn split_pair(text: &str) -> Result<(&str, &str), String> {
    text.split_once(',').ok_or_else(|| format!("`{}` is no pair such as 310,240", shortened(text)))
}

/// The name of a lesson and the number of its step, counted from 1.
fn lesson(text: &str) -> Result<LessonPlace, String> {
    let (lesson, step) = text
        .split_once(',')
        .ok_or_else(|| format!("`{}` is no lesson with the number of its step, such as 06_cube,3", shortened(text)))?;
    let step = whole(step)?.checked_sub(1).ok_or("steps are counted from 1")?;
    Ok(LessonPlace { lesson: word(lesson)?, step })
}

fn size(text: &str) -> Result<[u32; 2], String> {
    let size = pair(text)?;
    if size.contains(&0) {
        return Err("a picture has at least one column and one row".to_owned());
    }
    Ok(size)
}

fn numbers<const N: usize>(text: &str) -> Result<[f64; N], String> {
    let read = |word: &str| word.parse::<f64>().ok().filter(|number| number.is_finite());
    let numbers: Option<Vec<f64>> = text.split(',').take(N + 1).map(read).collect();
    let numbers = numbers.and_then(|numbers| <[f64; N]>::try_from(numbers).ok());
    numbers.ok_or_else(|| format!("`{}` is not {N} finite numbers with commas between them", shortened(text)))
}

fn ray(text: &str) -> Result<[DVec3; 2], String> {
    let [ox, oy, oz, dx, dy, dz] = numbers::<6>(text)?;
    let direction = DVec3::new(dx, dy, dz);
    if direction == DVec3::ZERO {
        return Err("the direction has no length, so it leads nowhere".to_owned());
    }
    Ok([DVec3::new(ox, oy, oz), direction])
}

fn word(text: &str) -> Result<String, String> {
    let word = decoded(text)?;
    if word.is_empty() || word.chars().count() > LONGEST_WORD {
        return Err(format!("`{}` is no word of 1 to {LONGEST_WORD} characters", shortened(&word)));
    }
    Ok(word)
}

fn words(text: &str) -> Result<Vec<String>, String> {
    listed(text, ',')
}

fn path(text: &str) -> Result<Vec<String>, String> {
    listed(text, '.')
}

fn listed(text: &str, separator: char) -> Result<Vec<String>, String> {
    if text.split(separator).nth(LONGEST_LIST).is_some() {
        return Err(format!("there are more than {LONGEST_LIST} entries"));
    }
    text.split(separator).map(word).collect()
}

fn theme(text: &str) -> Result<Theme, String> {
    let found = Theme::ALL.into_iter().find(|&theme| theme_name(theme) == text);
    found.ok_or_else(|| {
        let known = Theme::ALL.map(theme_name).join(", ");
        format!("`{}` is no theme; there are {known}", shortened(text))
    })
}

fn accuracy(text: &str) -> Result<Accuracy, String> {
    match text.strip_prefix(PACKED) {
        Some(packed) => unpack(packed).map(Accuracy::Text),
        None => word(text).map(Accuracy::Named),
    }
}

/// The effects that are left; an empty list leaves all.
fn effects(text: &str) -> Result<Effects, String> {
    let mut effects = Effects::ALL;
    for name in text.split(',').filter(|name| !name.is_empty()).take(LONGEST_LIST) {
        let effect = Effect::ALL.into_iter().find(|&effect| effect_name(effect) == name).ok_or_else(|| {
            let known: Vec<String> = Effect::ALL.into_iter().map(effect_name).collect();
            format!("`{}` is no effect; there are {}", shortened(name), known.join(", "))
        })?;
        effects = effects.without(effect);
    }
    Ok(effects)
}
