//! `rayscope accuracy`: what accuracy costs in time, setting by setting.

mod cache;
mod csv;
mod data;
mod figures;
mod instructions;
mod map;
mod plot;
mod resume;
mod table;

use super::accuracy_ray;
use super::drawn::Theme;
use super::failure::{Failure, warn};
use super::output::Output;
use super::profile_argument::ProfileArgument;
use super::progress::{stopped_by_ctrl_c, with_bar};
use super::scene_argument::SceneArgument;
use super::trace;
use crate::cpu_time;
use crate::laboratory::{Answer, Earlier, Goal, Knob, MapKind, Plan, Run, Target, Tools, narrowed, study};
use crate::scene::Scene;
use cache::{Cache, load_identified};
use clap::{ArgGroup, Args, ValueEnum};
use glam::DVec3;
use std::path::PathBuf;
use std::time::Instant;

/// Show what accuracy costs in time: every setting with its seconds and its error
#[derive(Args, Debug)]
#[command(
    group = ArgGroup::new("drawing").args(["plot", "map"]).multiple(true),
    group = ArgGroup::new("goal").args(["for_time", "for_error"]).multiple(true),
    after_help = "\
Examples:
  rayscope accuracy lights/soft_shadows                        the table, within half a minute
  rayscope accuracy csg/bowl --knob arithmetic,roots --budget 5s
  rayscope accuracy lens/focus --plot focus.svg                and error against seconds as a plot
  rayscope accuracy lens/focus --for-time 10 --profile ten.json
  rayscope render lens/focus -o focus.png --accuracy ten.json  the closest picture within ten seconds of one thread
  rayscope accuracy lens/focus --format json -o run.json --budget 2m
  rayscope accuracy lens/focus --resume run.json --format json -o run.json
                                                               more repeats of the same
  rayscope accuracy hard/far_torus --pixel 160,120             one ray: the digits that each method has right
  rayscope accuracy csg/bowl --map tier -o tier.png            what it took to be sure, pixel by pixel

Each setting is one knob at one value, all else being as the scene says. Its picture is compared with a reference that has
every knob at its best; where chance decides, the reference is the mean of several pictures, and its own error is stated. Times are
of one thread: medians of repeats in turn with all others, ± half the distance between the quartiles. A time that is lost in
noise is not told. A point is on the frontier (*) if no other is both faster and closer to the reference. Controls
must change nothing: their error is what they differ from the scene as it stands.

Pictures have at most --width columns, and fewer where the budget would not do for enough repeats. Answers to --for-time and
--for-error are for the scene's whole picture. References are kept in a cache, and a later run makes them better.
Ctrl-C writes what is finished and ends with exit code 130.")]
pub struct Accuracy {
    #[command(flatten)]
    scene: SceneArgument,
    /// How long to measure, such as 30s, 2m or 30
    #[arg(long, value_name = "TIME", default_value = "30s", value_parser = seconds)]
    budget: f64,
    /// The most columns of the pictures that are measured
    #[arg(long, value_name = "N", default_value_t = 160, value_parser = clap::value_parser!(u32).range(8..=4096))]
    width: u32,
    /// Only these knobs [default: all that matter to the scene]
    #[arg(long, value_name = "NAME,…", value_delimiter = ',', value_parser = knob_parser())]
    knob: Vec<String>,
    /// Do not measure combinations of knobs
    #[arg(long, conflicts_with = "goal")]
    single: bool,
    /// The seed of the pictures that are measured [default: the scene's]
    #[arg(long, value_name = "N")]
    seed: Option<u32>,
    /// How the points are written
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    /// The file to write [default: the standard output]
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Also draw error against seconds; the ending says whether as .svg, .png or .pdf
    #[arg(long, value_name = "FILE", value_parser = plot::file)]
    plot: Option<PathBuf>,
    /// Colours of the plot or map
    #[arg(long, value_enum, default_value_t = Theme::Light, requires = "drawing")]
    theme: Theme,
    /// Ask for the closest whole picture within this time of one thread
    #[arg(long, value_name = "TIME", value_parser = seconds)]
    for_time: Option<f64>,
    /// Ask for the fastest whole picture with at most this error, a root mean square from 0 to 1
    #[arg(long, value_name = "ERROR", value_parser = error_share)]
    for_error: Option<f64>,
    /// Write the answer as an accuracy profile, for `rayscope render --accuracy`
    #[arg(long, value_name = "FILE", requires = "goal")]
    profile: Option<PathBuf>,
    /// Add to what an earlier run measured: its JSON
    #[arg(long, value_name = "FILE", conflicts_with = "width")]
    resume: Option<PathBuf>,
    /// Where references are kept [default: rayscope in the user's folder for caches]
    #[arg(long, value_name = "FOLDER")]
    cache: Option<PathBuf>,
    /// Keep no references
    #[arg(long, conflicts_with = "cache")]
    no_cache: bool,
    /// Also count the instructions of each setting, by running this program under perf or valgrind
    #[arg(long)]
    instructions: bool,
    /// Instead of all this: a map of the picture, as .svg, .png or .pdf by the ending of -o
    #[arg(long, value_name = "KIND", value_parser = map_parser(), conflicts_with_all = STUDY)]
    map: Option<String>,
    #[command(flatten)]
    profile_of_map: ProfileArgument,
    /// Instead of all this: one ray by every method, with the digits right of every number, through this pixel of the scene
    #[arg(long, value_name = "X,Y", value_parser = trace::pixel, conflicts_with_all = STUDY, conflicts_with_all = ["width", "map"])]
    pixel: Option<[u32; 2]>,
    /// The same for a ray of your own: origin and direction
    #[arg(long, value_name = "OX,OY,OZ,DX,DY,DZ", value_parser = trace::ray, allow_hyphen_values = true,
          conflicts_with_all = STUDY, conflicts_with_all = ["width", "map", "pixel"])]
    ray: Option<[DVec3; 2]>,
}

/// What is of a whole study, and means nothing for one ray or one map.
const STUDY: [&str; 12] = [
    "budget",
    "knob",
    "single",
    "seed",
    "plot",
    "for_time",
    "for_error",
    "profile",
    "resume",
    "cache",
    "no_cache",
    "instructions",
];

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Format {
    /// A table
    Text,
    /// One JSON object
    Json,
    /// A line for each point
    Csv,
}

/// What all ways of writing need to know.
pub struct Findings<'a> {
    /// The scene's name, as it was given.
    scene_name: &'a str,
    /// The scene.
    scene: &'a Scene,
    /// A number for the scene's text and files.
    identity: u64,
    /// The seed that was asked for.
    seed: Option<u32>,
    /// What was measured.
    run: &'a Run,
    /// Instructions of the scene as it stands and of each point, where they were counted.
    instructions: Vec<Option<u64>>,
}

impl Accuracy {
    /// Measures and writes.
    pub fn run(&self) -> Result<(), Failure> {
        let pixel = self.pixel.map(Target::Pixel);
        if self.map.is_none() && self.profile_of_map.is_given() {
            return Err(Failure::usage("--accuracy says what is mapped: give --map, too; a study tries all settings"));
        }
        let kind = self.map.as_deref().and_then(|name| MapKind::ALL.into_iter().find(|kind| kind.name() == name));
        match (pixel.or(self.ray.map(Target::Ray)), kind) {
            (Some(target), _) => self.run_ray(target),
            (None, Some(kind)) => self.run_map(kind),
            (None, None) => self.run_study(),
        }
    }

    fn run_map(&self, kind: MapKind) -> Result<(), Failure> {
        let plain = narrowed(&self.scene.load()?, self.width);
        let scene = self.profile_of_map.apply(plain.clone())?;
        map::write(kind, [&scene, &plain], self.theme, self.output.as_deref())
    }

    fn run_ray(&self, target: Target) -> Result<(), Failure> {
        let format = match self.format {
            Format::Text => accuracy_ray::Format::Text,
            Format::Json => accuracy_ray::Format::Json,
            Format::Csv => return Err(Failure::usage("one ray is written as text or json, not as csv")),
        };
        accuracy_ray::report(&self.scene.load()?, target, format, self.output.as_deref())
    }

    fn run_study(&self) -> Result<(), Failure> {
        let (scene, identity) = load_identified(&self.scene)?;
        let earlier = self.resume.as_deref().map(|path| resume::read(path, identity)).transpose()?;
        let output = Output::create(self.output.as_deref())?;
        let plot = self.plot.as_deref().map(|path| Output::create(Some(path))).transpose()?;
        let profile = self.profile.as_deref().map(|path| Output::create(Some(path))).transpose()?;
        let plan = self.plan(earlier.as_ref())?;
        let run = self.measure(&scene, identity, &plan, earlier.as_ref())?;
        run.warnings.iter().for_each(|warning| warn(warning));
        let mut findings = Findings {
            scene_name: self.scene.name(),
            scene: &scene,
            identity,
            seed: plan.seed,
            run: &run,
            instructions: Vec::new(),
        };
        if self.instructions && !run.is_cut_short {
            findings.instructions = instructions::count_all(&self.scene, &run)?;
        }
        let text = match self.format {
            Format::Text => table::table(&findings),
            Format::Json => data::json(&findings)?,
            Format::Csv => csv::csv(&findings),
        };
        output.write(text.as_bytes())?;
        if let (Some(output), Some(path)) = (plot, &self.plot) {
            output.write(&plot::plotted(&findings, self.theme, path))?;
        }
        if run.is_cut_short {
            return Err(Failure::interrupted("interrupted: what was finished until then was written"));
        }
        profile.map_or(Ok(()), |output| self.write_profile(output, &run))
    }

    fn plan(&self, earlier: Option<&Earlier>) -> Result<Plan, Failure> {
        let wanted = |knob: &Knob| self.knob.is_empty() || self.knob.iter().any(|name| name == knob.name());
        if let (Some(seed), Some(Earlier { seed: before, .. })) = (self.seed, earlier)
            && *before != Some(seed)
        {
            let before = before.map_or("the scene's own seed".to_owned(), |seed| format!("the seed {seed}"));
            return Err(Failure::usage(format!(
                "the run to be resumed has {before}; leave --seed out to go on with it"
            )));
        }
        Ok(Plan {
            width: self.width,
            budget: self.budget,
            knobs: Knob::ALL.into_iter().filter(wanted).collect(),
            seed: self.seed.or(earlier.and_then(|earlier| earlier.seed)),
            combines: !self.single,
            goals: self.goals(),
        })
    }

    fn goals(&self) -> Vec<Goal> {
        let time = self.for_time.map(Goal::Time);
        time.into_iter().chain(self.for_error.map(Goal::Error)).collect()
    }

    fn measure(&self, scene: &Scene, identity: u64, plan: &Plan, earlier: Option<&Earlier>) -> Result<Run, Failure> {
        let progress = stopped_by_ctrl_c();
        let mut store = Cache::open(self.cache.as_deref(), self.no_cache, identity);
        let mut stopwatch = cpu_time::taken;
        let tools = Tools { stopwatch: &mut stopwatch, store: &mut store, progress: &progress, watch: &mut |_| {} };
        let began = Instant::now();
        let passed = || milliseconds(began.elapsed().as_secs_f64().min(self.budget));
        let run = with_bar(milliseconds(self.budget), passed, || study(scene, plan, earlier, tools));
        run.ok_or_else(|| Failure::interrupted("interrupted before there was anything to compare; nothing was written"))
    }

    /// The profile of the first goal that was asked for.
    fn write_profile(&self, output: Output, run: &Run) -> Result<(), Failure> {
        let [answer, ..] = run.answers.as_slice() else {
            return Err(Failure::refused("no profile was written: all times were lost in noise"));
        };
        if !answer.is_met {
            let message = format!("no profile was written: {}", figures::unmet(answer));
            return Err(Failure::refused(message));
        }
        let note = self.note(answer);
        output.write(answer.profile.to_json(&note).map_err(Failure::refused)?.as_bytes())
    }

    fn note(&self, answer: &Answer) -> String {
        format!("{}, {}", self.scene.name(), figures::answer(answer))
    }
}

fn milliseconds(seconds: f64) -> usize {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a budget of years is cut off")]
    let milliseconds = (1000.0 * seconds).max(0.0) as usize;
    milliseconds
}

fn map_parser() -> clap::builder::PossibleValuesParser {
    MapKind::ALL.map(MapKind::name).into()
}

fn knob_parser() -> clap::builder::PossibleValuesParser {
    Knob::ALL.map(Knob::name).into()
}

/// A time as people write it: 30, 30s, 1.5m, 200ms.
fn seconds(text: &str) -> Result<f64, String> {
    const UNITS: [(&str, f64); 4] = [("ms", 1e-3), ("s", 1.0), ("m", 60.0), ("h", 3600.0)];
    let unit = UNITS.iter().find_map(|(unit, factor)| Some((text.strip_suffix(unit)?, *factor)));
    let (number, factor) = unit.unwrap_or((text, 1.0));
    let seconds = number.trim().parse::<f64>().ok().map(|number| number * factor);
    seconds
        .filter(|seconds| seconds.is_finite() && *seconds > 0.0)
        .ok_or_else(|| "expected a time above 0, such as 30, 30s, 1.5m or 200ms".to_owned())
}

fn error_share(text: &str) -> Result<f64, String> {
    let error = text.parse::<f64>().ok().filter(|error| (0.0..=1.0).contains(error));
    error.ok_or_else(|| "expected an error from 0 to 1, such as 0.01".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_read_as_people_write_them() {
        for (text, expected) in
            [("30", 30.0), ("30s", 30.0), ("1.5m", 90.0), ("200ms", 0.2), ("1h", 3600.0), ("2 s", 2.0)]
        {
            assert_eq!(seconds(text), Ok(expected), "{text}");
        }
        for text in ["", "s", "0", "-3s", "inf", "NaN", "soon"] {
            assert!(seconds(text).is_err(), "{text}");
        }
    }

    #[test]
    fn errors_are_shares() {
        assert_eq!(error_share("0.01"), Ok(0.01));
        assert!(["1.5", "-0.1", "NaN", ""].iter().all(|text| error_share(text).is_err()));
    }
}
