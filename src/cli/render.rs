//! `rayscope render`: a picture as a PNG file.

use super::failure::{Failure, warn};
use super::frames::Frames;
use super::output::Output;
use super::profile_argument::ProfileArgument;
use super::progress::{stopped_by_ctrl_c, with_bar};
use super::scene_argument::{SceneArgument, SizeArguments};
use super::stats::{self, Seconds, Stats};
use crate::scene::{Image, Scene, Shortcuts};
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
  rayscope render lens/focus -o quick.png --accuracy draft
  rayscope render textures/marble -o marble.png --frames 1,225,450,900     marble_0001.png and so on
  rayscope render textures/marble -o marble.apng --frames 1..900:9         one animated picture

Ctrl-C writes the pixels that are finished and ends with exit code 130; a second Ctrl-C ends at once.
A picture is written whole or not at all: a file that was there before is replaced only at the end.")]
pub struct Render {
    #[command(flatten)]
    scene: SceneArgument,
    /// The PNG file to write; with frames and the ending .apng, an animated one
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
    /// Frames of what moves, such as 1..900, 1..900:9 for every 9th, or 1,225,450 [default: the scene's own]
    #[arg(long, value_name = "A..B", value_parser = Frames::parse, conflicts_with = "stats")]
    frames: Option<Frames>,
    /// Frames a second of an animated picture
    #[arg(long, value_name = "N", default_value_t = 25, value_parser = clap::value_parser!(u16).range(1..=240), requires = "frames")]
    rate: u16,
    #[command(flatten)]
    size: SizeArguments,
    #[command(flatten)]
    profile: ProfileArgument,
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

/// Rendering that shows how far it is and that Ctrl-C ends.
struct Work {
    pool: rayon::ThreadPool,
    progress: Arc<Progress>,
    /// Pixels of all pictures together.
    pixels: usize,
}

impl Work {
    fn start(threads: Option<u16>, pixels: usize) -> Result<Self, Failure> {
        let progress = stopped_by_ctrl_c();
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads.map_or(0, usize::from))
            .build()
            .map_err(|error| Failure::refused(format!("cannot start the threads: {error}")))?;
        Ok(Self { pool, progress, pixels })
    }

    /// Does all of the work while a bar shows the time left.
    fn watched<T>(&self, work: impl FnOnce() -> T) -> T {
        with_bar(self.pixels, || self.progress.done(), work)
    }

    fn render(&self, scene: &Scene) -> (Picture, Tally) {
        self.pool.install(|| render(scene, &self.progress))
    }

    fn interrupted(&self) -> bool {
        self.progress.cancelled()
    }
}

impl Render {
    /// Renders and writes.
    pub fn run(&self) -> Result<(), Failure> {
        let began = Instant::now();
        let mut scene = self.profile.apply(self.scene.load_sized(self.size)?)?;
        if !self.without.is_empty() {
            scene.shortcuts = self.shortcuts();
        }
        let load = began.elapsed();
        match &self.frames {
            Some(frames) if self.output.extension().is_some_and(|ending| ending == "apng") => {
                self.run_animated(&scene, frames)
            }
            Some(frames) => self.run_numbered(&scene, frames),
            None => self.run_one(&scene, load),
        }
    }

    /// One PNG file for each frame. What is finished when it is interrupted stays.
    fn run_numbered(&self, scene: &Scene, frames: &Frames) -> Result<(), Failure> {
        let work = Work::start(self.threads, pixels(scene) * frames.numbers().len())?;
        let write_all = || {
            for &frame in frames.numbers() {
                let path = frames.file_of(frame, &self.output);
                let output = Output::create(Some(&path))?;
                let (picture, _) = work.render(&scene.clone().at_frame(f64::from(frame)));
                if work.interrupted() {
                    let message = format!("interrupted: {} and the frames after it were not written", path.display());
                    return Err(Failure::interrupted(message));
                }
                output.write(&png(&picture)?)?;
            }
            Ok(())
        };
        work.watched(write_all)
    }

    /// One animated PNG file of all frames, or of those that were finished.
    fn run_animated(&self, scene: &Scene, frames: &Frames) -> Result<(), Failure> {
        let output = Output::create(Some(&self.output))?;
        let work = Work::start(self.threads, pixels(scene) * frames.numbers().len())?;
        let picture = |&frame: &u32| {
            let (picture, _) = work.render(&scene.clone().at_frame(f64::from(frame)));
            (!work.interrupted()).then(|| picture.to_rgb8())
        };
        let pictures: Vec<_> = work.watched(|| frames.numbers().iter().map_while(picture).collect());
        if pictures.is_empty() {
            return Err(Failure::interrupted("interrupted before a frame was finished; nothing was written"));
        }
        output.write(&animated_png(scene.image, &pictures, self.rate)?)?;
        if pictures.len() < frames.numbers().len() {
            let (done, all) = (pictures.len(), frames.numbers().len());
            let message = format!("interrupted: {} holds the first {done} of {all} frames", self.output.display());
            return Err(Failure::interrupted(message));
        }
        Ok(())
    }

    /// One picture, and what it took.
    fn run_one(&self, scene: &Scene, load: Duration) -> Result<(), Failure> {
        let output = Output::create(Some(&self.output))?;
        if output.is_terminal() {
            return Err(Failure::usage("a PNG is no text for a terminal; name a file with -o"));
        }
        let stats = self.stats.as_deref().map(|path| Output::create(Some(path))).transpose()?;
        let rendered = self.render(scene, load)?;
        if rendered.picture.computed() == 0 {
            return Err(Failure::interrupted("interrupted before a pixel was finished; nothing was written"));
        }
        for overlap in rendered.tally.overlaps().in_words(scene) {
            warn(&format!("{overlap}; the scene's media policy forbids that"));
        }
        let began = Instant::now();
        output.write(&png(&rendered.picture)?)?;
        let write = began.elapsed();
        if let Some(stats) = stats {
            stats.write(self.stats_text(scene, &rendered, write)?.as_bytes())?;
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
        let work = Work::start(self.threads, pixels(scene))?;
        let began = Instant::now();
        let (picture, tally) = work.watched(|| work.render(scene));
        Ok(Rendered {
            interrupted: work.interrupted() && picture.computed() < pixels(scene),
            picture,
            tally,
            threads: work.pool.current_num_threads(),
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
            effects: stats::effects(scene, &rendered.tally),
            overlaps: stats::overlaps(scene, &rendered.tally),
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

/// Frames of three sRGB bytes a pixel as one PNG that repeats without end.
fn animated_png(size: Image, frames: &[Vec<u8>], rate: u16) -> Result<Vec<u8>, Failure> {
    let count = u32::try_from(frames.len()).unwrap_or(u32::MAX);
    let encode = || -> Result<Vec<u8>, png::EncodingError> {
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, size.width, size.height);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_animated(count, 0)?;
        encoder.set_frame_delay(1, rate)?;
        let mut writer = encoder.write_header()?;
        for frame in frames {
            writer.write_image_data(frame)?;
        }
        writer.finish()?;
        Ok(bytes)
    };
    encode().map_err(|error| Failure::refused(format!("the frames cannot be encoded: {error}")))
}
