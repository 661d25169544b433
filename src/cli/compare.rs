//! `rayscope compare`: two stories side by side, or what another ray tracer says beside our own story.

use super::compare_json::{difference_json, foreign_json};
use super::drawn::with_newline;
use super::failure::{Failure, reason};
use super::output::Output;
use super::profile_argument::ProfileArgument;
use super::scene_argument::{SceneArgument, SizeArguments};
use super::trace::{check_pixel, pixel};
use crate::compare::foreign::{ForeignTrace, LineError, SHARE, compare_foreign, comparison_text};
use crate::compare::{Tolerance, difference, difference_text};
use crate::scene::Scene;
use crate::trace::{RayTree, record_pixel};
use clap::{Args, ValueEnum};
use std::fs;
use std::path::PathBuf;

/// Lay two stories side by side, or find where another ray tracer departs from this one and why
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  rayscope compare mine.jsonl compare/still_life                     what my own ray tracer printed, beside this one
  rayscope compare csg/bowl --pixel 312,313 --with-pixel 333,150     two pixels
  rayscope compare csg/bowl --with-scene csg/lens                    two scenes
  rayscope compare csg/bowl --with-accuracy draft --tolerance 1e-9   two settings
  python3 scenes/compare/tracer.py 235,285 | rayscope compare - compare/still_life

A ray tracer of your own prints JSON lines, as many as it likes; `rayscope schema compare` and scenes/compare/format.md
describe them. The exit code is 0 where nothing differs and 1 where something does.")]
pub struct Compare {
    /// What another ray tracer printed (JSON lines; - is the standard input), or a scene
    #[arg(value_name = "MINE.jsonl|SCENE")]
    first: String,
    /// The scene that the other ray tracer has traced
    #[arg(value_name = "SCENE")]
    scene: Option<String>,
    /// The pixel of the first story [default: the one that tells the scene's story best]
    #[arg(long, value_name = "X,Y", value_parser = pixel, conflicts_with = "scene")]
    pixel: Option<[u32; 2]>,
    /// The pixel of the second story [default: the same]
    #[arg(long, value_name = "X,Y", value_parser = pixel, conflicts_with = "scene")]
    with_pixel: Option<[u32; 2]>,
    /// The scene of the second story [default: the same]
    #[arg(long, value_name = "SCENE", conflicts_with = "scene")]
    with_scene: Option<String>,
    /// The accuracy profile of the second story: draft, standard or certified, or the file of one
    #[arg(long, value_name = "PROFILE", conflicts_with = "scene")]
    with_accuracy: Option<String>,
    #[command(flatten)]
    size: SizeArguments,
    /// The share by which a number may be off [default: 0 for two stories of ours, 1e-6 for another ray tracer's]
    #[arg(long, value_name = "SHARE", value_parser = share)]
    tolerance: Option<f64>,
    /// What to write
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    /// Where to write it [default: the standard output]
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Format {
    /// In words
    Text,
    /// As data
    Json,
}

impl Compare {
    /// Compares, and writes what differs.
    pub fn run(&self) -> Result<(), Failure> {
        let (text, is_same) = match &self.scene {
            Some(scene) => self.with_foreign(scene)?,
            None => self.with_another()?,
        };
        Output::create(self.output.as_deref())?.write(&with_newline(text.trim_end().to_owned()))?;
        if is_same { Ok(()) } else { Err(Failure::differs()) }
    }

    /// What another ray tracer printed.
    fn with_foreign(&self, scene: &str) -> Result<(String, bool), Failure> {
        let lines = self.lines()?;
        let trace = ForeignTrace::read(&lines).map_err(|errors| self.unreadable(&errors))?;
        let scene = SceneArgument::named(scene).load_sized(self.size)?;
        let share = self.tolerance.unwrap_or(SHARE);
        let comparison = compare_foreign(&scene, &trace, share).map_err(Failure::usage)?;
        let text = match self.format {
            Format::Text => comparison_text(&comparison),
            Format::Json => foreign_json(&comparison)?,
        };
        Ok((text, comparison.first_departure().is_none()))
    }

    fn lines(&self) -> Result<String, Failure> {
        let (name, bytes) = if self.first == "-" {
            let mut bytes = Vec::new();
            let read = std::io::Read::read_to_end(&mut std::io::stdin().lock(), &mut bytes);
            ("the standard input", read.map(|_| bytes))
        } else {
            (self.first.as_str(), fs::read(&self.first))
        };
        let bytes = bytes.map_err(|error| Failure::usage(format!("cannot read {name}: {}", reason(&error))))?;
        String::from_utf8(bytes).map_err(|error| {
            let place = error.utf8_error().valid_up_to();
            Failure::usage(format!("{name}: not a text file: byte {place} is not UTF-8"))
        })
    }

    fn unreadable(&self, errors: &[LineError]) -> Failure {
        let list: Vec<String> = errors.iter().map(|error| format!("{}: {error}", self.first)).collect();
        let help = "`rayscope schema compare` describes the lines";
        Failure::usage(format!("what the other ray tracer printed cannot be used\n{}\n{help}", list.join("\n")))
    }

    /// Another story of ours.
    fn with_another(&self) -> Result<(String, bool), Failure> {
        if self.with_pixel.is_none() && self.with_scene.is_none() && self.with_accuracy.is_none() {
            return Err(Failure::usage(format!(
                "with what is {} to be compared? Give a second story by --with-pixel, --with-scene or --with-accuracy, or \
                 the scene that a ray tracer of your own has traced",
                self.first
            )));
        }
        let left = SceneArgument::named(&self.first).load_sized(self.size)?;
        let right = match &self.with_scene {
            Some(name) => SceneArgument::named(name).load_sized(self.size)?,
            None => left.clone(),
        };
        let right = ProfileArgument::named(self.with_accuracy.clone()).apply(right)?;
        let here = self.pixel.unwrap_or_else(|| telling(&left));
        let usual = if self.with_scene.is_some() && self.pixel.is_none() { telling(&right) } else { here };
        let trees =
            [(&left, here), (&right, self.with_pixel.unwrap_or(usual))].map(|(scene, pixel)| record(scene, pixel));
        let [left, right] = trees;
        let (left, right) = (left?, right?);
        let tolerance = Tolerance { relative: self.tolerance.unwrap_or(0.0), absolute: 0.0 };
        let pairs = difference(&left, &right, &tolerance);
        let text = match self.format {
            Format::Text => difference_text(&pairs, [&left, &right], &tolerance),
            Format::Json => difference_json(&pairs, [&left, &right], &tolerance)?,
        };
        Ok((text, pairs.is_empty()))
    }
}

/// The pixel that tells a scene's story best.
fn telling(scene: &Scene) -> [u32; 2] {
    scene.pixels.first().copied().unwrap_or([scene.image.width / 2, scene.image.height / 2])
}

fn record(scene: &Scene, [x, y]: [u32; 2]) -> Result<RayTree, Failure> {
    check_pixel(scene, [x, y])?;
    Ok(record_pixel(scene, x, y))
}

/// A share from 0 to 1.
fn share(text: &str) -> Result<f64, String> {
    let number: Option<f64> = text.parse().ok();
    number
        .filter(|share| (0.0..=1.0).contains(share))
        .ok_or_else(|| "expected a share from 0 to 1, such as 1e-6".to_owned())
}
