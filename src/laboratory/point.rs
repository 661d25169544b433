//! What is measured of a setting: its time, its error, and where it stands among the others.

use super::Setting;
use crate::scene::Profile;
use crate::trace::Picture;
use serde::{Deserialize, Serialize};

/// How long something took: the median of several times, measured in turn with others.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Timing {
    /// The median, in seconds of one thread.
    pub seconds: f64,
    /// Half the distance between the quartiles, in seconds.
    pub spread: f64,
    /// How often it was measured, not counting the first time and those in which the thread had to wait.
    pub repeats: u32,
    /// Why the median is not to be told, if it is not.
    pub noise: Option<Noise>,
}

impl Timing {
    /// The median, where it is not lost in noise.
    #[must_use]
    pub fn told(&self) -> Option<f64> {
        self.noise.is_none().then_some(self.seconds)
    }
}

/// Why a time is not to be told.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Noise {
    /// The times differ too much: by how much the median is uncertain, as a share of it.
    Spread(f64),
    /// The thread had to wait for others: the share of the time by the clock on the wall.
    Waiting(f64),
    /// The time is too short for the clock: how many of its steps.
    Clock(f64),
}

/// How far a picture is from another one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Errors {
    /// The root of the mean squared difference of all channels of all pixels, in linear RGB from 0 to 1 (lighter ones
    /// count as 1).
    pub rmse: f64,
    /// The largest channel's difference that 999 of 1,000 pixels do not exceed, in the same units.
    pub p999: f64,
    /// Pixels that anyone could see to be wrong: a channel is off by more than 5 of 255 steps of sRGB.
    pub wrong_pixels: usize,
    /// 1 − SSIM, the structural dissimilarity of the sRGB pictures: 0 for equal ones.
    pub dissimilarity: f64,
}

/// A setting, measured.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Point {
    /// What was set; several where a combination of knobs was measured.
    pub settings: Vec<Setting>,
    /// All of it together.
    pub profile: Profile,
    /// What it takes.
    pub timing: Timing,
    /// How far its picture is from the reference; for a control, from the picture that it must equal.
    pub errors: Errors,
    /// How far its picture is from that of the scene as it stands.
    pub change: Errors,
    /// Whether no other point is both faster and closer to the reference.
    pub on_frontier: bool,
    /// The picture.
    pub picture: Picture,
}

impl Point {
    /// The settings in words, such as `samples 16` or `samples 16, depth 4`.
    #[must_use]
    pub fn name(&self) -> String {
        let names = self.settings.iter().map(|setting| format!("{} {}", setting.knob.name(), setting.value));
        names.collect::<Vec<_>>().join(", ")
    }

    /// Whether it is there to show that nothing changes.
    #[must_use]
    pub fn is_control(&self) -> bool {
        !self.settings.is_empty() && self.settings.iter().all(|setting| setting.knob.is_control())
    }
}

/// What all pictures are compared with.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Reference {
    /// Every knob at its best.
    pub profile: Profile,
    /// The mean of several pictures, each with random numbers of its own; one where nothing is random.
    pub picture: Picture,
    /// How many.
    pub pictures: u32,
    /// By how much it may be off itself, as a root mean square in linear RGB: the standard error of the mean; 0 where nothing
    /// is random.
    pub error: f64,
    /// Whether it was found in the cache.
    pub cached: bool,
}

/// A scene, measured.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Study {
    /// What all points are compared with.
    pub reference: Reference,
    /// The scene as it stands.
    pub standard: Point,
    /// The others, in the order of the knobs, then combinations.
    pub points: Vec<Point>,
    /// The smallest difference of times that the clock can tell, in seconds.
    pub resolution: f64,
    /// The share of the time by the clock on the wall in which the thread had to wait.
    pub waiting: f64,
}
