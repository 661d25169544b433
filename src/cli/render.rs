//! `rayscope render`: a picture as a PNG file.

use super::failure::Failure;
use super::output::Output;
use super::progress::{stop_on_ctrl_c, with_bar};
use super::scene_argument::{SceneArgument, SizeArguments};
use super::stats::{self, Seconds, Stats};
use crate::scene::{Scene, Shortcuts};
use crate::trace::{Picture, Progress, Tally, render};
use clap::{Args, ValueEnum};
use image::ImageEncoder;
use image::codecs::png::PngEncoder;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Render a scene to a PNG file
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  rayscope render csg/bowl -o bowl.png
  rayscope render csg/bowl -o large.png --width 1920
  rayscope render my-scene.json -o picture.png --threads 1 --stats stats.json
  rayscope render csg/bowl -o slow.png --without boxes,hierarchy --stats slow.json

Ctrl-C writes the pixels that are finished and ends with exit code 130; a second Ctrl-C ends at once.
A picture is written whole or not at all: a file that was there before is replaced only at the end.")]
pub struct Render {
    #[command(flatten)]
    scene: SceneArgument,
    /// The PNG file to write
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
    #[command(flatten)]
    size: SizeArguments,
    /// Threads to render with [default: one for each core]; the picture is the same for any number
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
    /// Leave out what spares rays their tests, to see what it saves; the picture is the same
    #[arg(long, value_name = "KIND,…", value_delimiter = ',', value_enum)]
    without: Vec<Shortcut>,
    /// Also write what the picture took: rays by kind, tests by shape, seconds by phase, effects called for
    #[arg(long, value_name = "FILE")]
    stats: Option<PathBuf>,
}

/// Something that spares rays their tests.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Shortcut {
    /// The boxes around solids and their parts
    Boxes,
    /// The balls around those for which they are much smaller than boxes
    Balls,
    /// The rectangles of objects in the picture
    Projections,
    /// The trees of boxes over the objects, and over what large unions are made of
    Hierarchy,
    /// The grids of what the eye and the lights see
    Sights,
}

/// What came of the rendering, with what it took.
struct Rendered {
    picture: Picture,
    tally: Tally,
    threads: usize,
    load: Duration,
    render: Duration,
    interrupted: bool,
}

impl Render {
    /// Renders and writes.
    pub fn run(&self) -> Result<(), Failure> {
        let began = Instant::now();
        let mut scene = self.scene.load_sized(self.size)?;
        scene.shortcuts = self.shortcuts();
        let load = began.elapsed();
        let output = Output::create(Some(&self.output))?;
        if output.is_terminal() {
            return Err(Failure::usage("a PNG is no text for a terminal; name a file with -o"));
        }
        let stats = self.stats.as_deref().map(|path| Output::create(Some(path))).transpose()?;
        let rendered = self.render(&scene, load)?;
        if rendered.picture.computed() == 0 {
            return Err(Failure::interrupted("interrupted before a pixel was finished; nothing was written"));
        }
        let began = Instant::now();
        output.write(&png(&rendered.picture)?)?;
        let write = began.elapsed();
        if let Some(stats) = stats {
            stats.write(self.stats_text(&scene, &rendered, write)?.as_bytes())?;
        }
        if rendered.interrupted { Err(self.interrupted(&rendered.picture)) } else { Ok(()) }
    }

    fn shortcuts(&self) -> Shortcuts {
        let keeps = |kind| !self.without.contains(&kind);
        Shortcuts {
            boxes: keeps(Shortcut::Boxes),
            balls: keeps(Shortcut::Balls),
            projections: keeps(Shortcut::Projections),
            hierarchy: keeps(Shortcut::Hierarchy),
            sights: keeps(Shortcut::Sights),
        }
    }

    fn render(&self, scene: &Scene, load: Duration) -> Result<Rendered, Failure> {
        let progress = Arc::new(Progress::new());
        let stopping = Arc::clone(&progress);
        stop_on_ctrl_c(move || {
            let again = stopping.cancelled();
            stopping.cancel();
            again
        });
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(self.threads.map_or(0, usize::from))
            .build()
            .map_err(|error| Failure::refused(format!("cannot start the threads: {error}")))?;
        let began = Instant::now();
        let (picture, tally) =
            with_bar(pixels(scene), || progress.done(), || pool.install(|| render(scene, &progress)));
        Ok(Rendered {
            interrupted: progress.cancelled() && picture.computed() < pixels(scene),
            picture,
            tally,
            threads: pool.current_num_threads(),
            load,
            render: began.elapsed(),
        })
    }

    fn stats_text(&self, scene: &Scene, rendered: &Rendered, write: Duration) -> Result<String, Failure> {
        let stats = Stats {
            scene: self.scene.name(),
            width: rendered.picture.width,
            height: rendered.picture.height,
            pixels: rendered.picture.computed(),
            interrupted: rendered.interrupted,
            threads: rendered.threads,
            rays: stats::rays(&rendered.tally),
            tests: stats::tests(&rendered.tally),
            extents: stats::extents(&rendered.tally),
            seconds: Seconds::new(rendered.load, rendered.render, write),
            effects: stats::effects(scene),
        };
        let text = serde_json::to_string_pretty(&stats).map_err(|error| Failure::refused(error.to_string()))?;
        Ok(text + "\n")
    }

    fn interrupted(&self, picture: &Picture) -> Failure {
        let whole = u64::from(picture.width) * u64::from(picture.height);
        Failure::interrupted(format!(
            "interrupted: {} holds the {} pixels of {whole} that were finished, and background for the rest",
            self.output.display(),
            picture.computed(),
        ))
    }
}

fn pixels(scene: &Scene) -> usize {
    scene.image.width as usize * scene.image.height as usize
}

fn png(picture: &Picture) -> Result<Vec<u8>, Failure> {
    let mut bytes = Vec::new();
    PngEncoder::new(&mut bytes)
        .write_image(&picture.to_rgb8(), picture.width, picture.height, image::ExtendedColorType::Rgb8)
        .map_err(|error| Failure::refused(format!("the picture cannot be encoded: {error}")))?;
    Ok(bytes)
}
