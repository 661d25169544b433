//! `rayscope bench`: the same scenes by this program and by another, in turn, with what each took and how far they agree.

mod povray;
mod scenes;
mod table;

use super::failure::Failure;
use super::output::Output;
use super::progress::{stopped_by_ctrl_c, with_bar};
use super::scene_argument::SizeArguments;
use crate::cpu_time::cpu_time;
use crate::peer::Agreement;
use crate::record::RayKind;
use crate::scene::Scene;
use crate::trace::{Progress, render};
use clap::{Args, ValueEnum};
use povray::{Bounding, installed_version};
use scenes::{PeerScene, read};
use std::io::{self, Write};
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;
use table::{Format, Row};

/// Time the peer scenes beside another ray tracer, and compare the pictures
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  rayscope bench --peer povray                             all scenes in tests/peers
  rayscope bench --peer povray --scene d_csg --repeats 9   one scene, the median of nine turns
  rayscope bench --peer povray --format json -o bench.json
                          as data: {\"scenes\": [{\"name\", \"rayscope_s\", \"povray_s\", \"ratio\",
                          \"agree\", …}, …]}

The programs take turns on one thread each. Counted is the CPU time of the tracing alone: POV-Ray's
as it prints it, with its default bounding and with +BM2. The ratio is rayscope's seconds to the
better of these two. A pixel agrees if no channel differs by more than 2 of 255.")]
pub struct Bench {
    /// The other program
    #[arg(long, value_enum)]
    peer: Peer,
    /// The folder with the scenes, each as NAME.json and NAME.pov
    #[arg(long, value_name = "FOLDER", default_value = "tests/peers")]
    scenes: PathBuf,
    /// Only this scene; more than one may be given
    #[arg(long, value_name = "NAME")]
    scene: Vec<String>,
    /// Turns, of which the median counts
    #[arg(long, value_name = "N", default_value_t = 3, value_parser = clap::value_parser!(u16).range(1..=999))]
    repeats: u16,
    /// Columns of the pictures, in place of the scenes'; the rows follow in proportion
    #[arg(long, value_name = "PIXELS", value_parser = clap::value_parser!(u32).range(1..=4_096))]
    width: Option<u32>,
    /// How to write the result
    #[arg(long, value_enum, default_value_t = Format::Table)]
    format: Format,
    /// Where to write it [default: the standard output]
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Peer {
    /// POV-Ray 3.7, the program `povray`
    Povray,
}

/// What one turn of this program took.
struct Turn {
    time: Duration,
    rays: u64,
    picture: Vec<u8>,
}

/// What the turns share.
struct Watch {
    progress: Arc<Progress>,
    /// Pixels of the other program, for the bar.
    theirs: AtomicUsize,
}

impl Bench {
    /// Times and writes.
    pub fn run(&self) -> Result<(), Failure> {
        let scenes = read(&self.scenes, &self.scene, SizeArguments::of_width(self.width))?;
        let output = Output::create(self.output.as_deref())?;
        let povray = match self.peer {
            Peer::Povray => installed_version()?,
        };
        if povray.is_none() {
            let _ = writeln!(io::stderr(), "{}", povray::HOW_TO_GET_IT);
        }
        let watch = Watch { progress: stopped_by_ctrl_c(), theirs: AtomicUsize::new(0) };
        let turns = if povray.is_some() { 3 } else { 1 } * usize::from(self.repeats);
        let total = scenes.iter().map(|scene| pixels(&scene.scene) * turns).sum();
        let done = || watch.progress.done() + watch.theirs.load(Ordering::Relaxed);
        let rows = with_bar(total, done, || self.rows(&scenes, povray.is_some(), &watch))?;
        let text = self.format.write(&rows, povray.as_deref())?;
        if watch.progress.cancelled() && rows.is_empty() {
            return Err(Failure::interrupted("interrupted before a scene was finished; nothing was written"));
        }
        output.write(text.as_bytes())?;
        if watch.progress.cancelled() {
            return Err(Failure::interrupted(format!("interrupted after {} of {} scenes", rows.len(), scenes.len())));
        }
        Ok(())
    }

    /// The scenes that were finished.
    fn rows(&self, scenes: &[PeerScene], povray: bool, watch: &Watch) -> Result<Vec<Row>, Failure> {
        let mut rows = Vec::new();
        for scene in scenes {
            match self.row(scene, povray, watch)? {
                Some(row) => rows.push(row),
                None => break,
            }
        }
        Ok(rows)
    }

    /// One scene, or none if it was interrupted.
    fn row(&self, scene: &PeerScene, povray: bool, watch: &Watch) -> Result<Option<Row>, Failure> {
        let (mut ours, mut by_default, mut by_tree) = (Vec::new(), Vec::new(), Vec::new());
        let (mut rays, mut agreement) = (0, None);
        for _ in 0..self.repeats {
            let mut theirs = None;
            for (bounding, times) in [(Bounding::Default, &mut by_default), (Bounding::Tree, &mut by_tree)] {
                if !povray {
                    break;
                }
                let Some(drawn) = povray::draw(scene, bounding, &watch.progress)? else { return Ok(None) };
                watch.theirs.fetch_add(pixels(&scene.scene), Ordering::Relaxed);
                times.push(drawn.time);
                theirs = Some(drawn.picture);
            }
            let turn = draw(&scene.scene, watch)?;
            if watch.progress.cancelled() {
                return Ok(None);
            }
            ours.push(turn.time);
            rays = turn.rays;
            agreement = theirs.and_then(|theirs| Agreement::of(&turn.picture, &theirs));
        }
        let (name, ours) = (scene.name.clone(), median(ours).unwrap_or_default());
        Ok(Some(Row { name, ours, by_default: median(by_default), by_tree: median(by_tree), rays, agreement }))
    }
}

fn pixels(scene: &Scene) -> usize {
    scene.image.width as usize * scene.image.height as usize
}

/// Renders on one thread, and takes the time of that thread.
fn draw(scene: &Scene, watch: &Watch) -> Result<Turn, Failure> {
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(1)
        .build()
        .map_err(|error| Failure::refused(format!("cannot start a thread: {error}")))?;
    let (time, (picture, tally)) = pool.install(|| cpu_time(|| render(scene, &watch.progress)));
    let rays = RayKind::ALL.iter().map(|&kind| tally.rays(kind)).sum();
    Ok(Turn { time, rays, picture: picture.to_rgb8() })
}

fn median(mut times: Vec<Duration>) -> Option<Duration> {
    times.sort_unstable();
    times.get(times.len() / 2).copied()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_median_of_an_odd_number_of_turns_is_the_middle_one() {
        let seconds = |list: &[u64]| median(list.iter().copied().map(Duration::from_secs).collect());
        assert_eq!(seconds(&[9, 1, 5]), Some(Duration::from_secs(5)));
        assert_eq!(seconds(&[]), None);
    }
}
