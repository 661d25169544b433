//! A link that restores what somebody looked at: the scene, the pixel, the event, and how all that was shown.
//!
//! `rayscope:csg/bowl?pixel=310,240&event=57&preset=inspect`, or the same behind the `#` of a web address. What follows the
//! `?` is a list of `name=value`, in any order and each at most once; signs that mean something in addresses are written as
//! `%` and two hexadecimal digits. A link never names a file on somebody's disk as the only source of a scene that others do
//! not have: the text of such a scene travels in the link, packed.

mod packed;
mod parse;
mod percent;
mod place;
#[cfg(test)]
mod tests;
mod written;

pub use parse::LinkError;
pub use place::{EventPlace, Found};

use crate::scene::Effects;
use crate::view::Theme;
use glam::DVec3;

/// The longest link, in characters. Longer ones are cut by mail programs and by the command lines of some systems
/// (32,767 characters on Windows).
pub const MOST_CHARACTERS: usize = 32_000;

/// The longest text that a link is unpacked to, in bytes: a short link could otherwise ask for all memory.
pub const MOST_TEXT: usize = 1 << 20;

/// Everything that a link restores. What it leaves out stays as it is.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Link {
    /// The name of the scene, or its file's.
    pub scene: String,
    /// The text of the scene, where it is not one that comes with the program, or was edited.
    pub text: Option<String>,
    /// What was traced.
    pub aim: Option<Aim>,
    /// Columns and rows of the picture that the pixel belongs to, where they are not the scene's own.
    pub size: Option<[u32; 2]>,
    /// The selected event.
    pub event: Option<EventPlace>,
    /// How much of the story has rows: `story`, `working`, `everything`.
    pub level: Option<String>,
    /// The arrangement of the panes.
    pub preset: Option<String>,
    /// The drawings and other panels that are shown, by their names.
    pub views: Vec<String>,
    /// The colours of everything.
    pub theme: Option<Theme>,
    /// The language of the interface, such as `de`.
    pub language: Option<String>,
    /// The time t at which the ray is probed.
    pub t: Option<f64>,
    /// How the overview is turned: yaw and pitch in degrees, and the zoom.
    pub orbit: Option<[f64; 3]>,
    /// The accuracy that the scene is looked at with.
    pub accuracy: Option<Accuracy>,
    /// Effects that are switched on, where not all that the scene calls for are.
    pub effects: Option<Effects>,
    /// The lesson that is open; its step then says which scene, pixel and panels are shown.
    pub lesson: Option<LessonPlace>,
}

/// A step of a lesson.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LessonPlace {
    /// The lesson's name.
    pub lesson: String,
    /// The step, counted from 0.
    pub step: u32,
}

/// What was traced.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Aim {
    /// The pixel [x, y]; (0, 0) is the top left one.
    Pixel([u32; 2]),
    /// A ray of its own: origin and direction.
    Ray([DVec3; 2]),
}

/// An accuracy profile.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Accuracy {
    /// By its name.
    Named(String),
    /// By the text of its file.
    Text(String),
}

impl Link {
    /// A link to a scene and nothing more.
    #[must_use]
    pub fn to_scene(name: impl Into<String>) -> Self {
        Self { scene: name.into(), ..Self::default() }
    }

    /// The link as text.
    ///
    /// # Errors
    /// If it is longer than [`MOST_CHARACTERS`], which only the text of a long scene makes it.
    pub fn written(&self) -> Result<String, LinkError> {
        let text = self.to_string();
        if text.len() <= MOST_CHARACTERS {
            return Ok(text);
        }
        Err(LinkError::new(format!(
            "the link to {} would have {} characters, and {MOST_CHARACTERS} are the most that pass through mail and command \
             lines unharmed: most of it is the text of the scene; save the scene and send its file",
            self.scene,
            text.len()
        )))
    }
}
