//! `rayscope find`: the pixels in whose stories something happens.

use super::drawn::{self, MAP_SIZE, Theme, with_newline};
use super::failure::{Failure, warn};
use super::output::Output;
use super::profile_argument::ProfileArgument;
use super::progress::{stopped_by_ctrl_c, with_bar};
use super::scene_argument::{SceneArgument, SizeArguments};
use crate::query::{Found, Query, Search, TermKind, Vocabulary, scan, terms};
use crate::scene::Scene;
use crate::view::{HeatMap, HeatScale, heat_map};
use clap::{Args, ValueEnum};
use serde::Serialize;
use std::fmt::Write;
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  rayscope find optics/fishbowl tir                        pixels with a total internal reflection
  rayscope find csg/bowl 'object=bowl & csg.early_out'     an early out in the search for hits with the bowl
  rayscope find optics/fishbowl 'kind=refracted & depth>=2' --format json -o deep.json
  rayscope find optics/fishbowl 'pixel & !has(shadowed)' --format png -o lit.png

QUERY asks for an event; a pixel is found if one of its events is such. `&` is and, `|` is or, `!` is not;
`rayscope find --help` lists all words. `rayscope trace SCENE --pixel X,Y` then tells the whole story.";

/// Find the pixels in whose stories something happens
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES, after_long_help = words())]
pub struct Find {
    #[command(flatten)]
    scene: SceneArgument,
    /// What is asked for, such as `tir` or `object=lens & csg.early_out`
    #[arg(value_name = "QUERY")]
    query: String,
    #[command(flatten)]
    size: SizeArguments,
    #[command(flatten)]
    profile: ProfileArgument,
    /// What to write
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    /// Colours of the drawing
    #[arg(long, value_enum, default_value_t = Theme::Light)]
    theme: Theme,
    /// Where to write it [default: the standard output]
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Format {
    /// A line for each pixel, with its first such event
    Text,
    /// The same as JSON
    Json,
    /// Where they lie in the picture
    Png,
}

/// What was found, as data.
#[derive(Serialize)]
struct Written<'a> {
    scene: &'a str,
    /// The question in its plainest spelling.
    query: String,
    /// Columns and rows of the picture.
    size: [u32; 2],
    pixels: Vec<WrittenPixel<'a>>,
}

/// One pixel.
#[derive(Serialize)]
struct WrittenPixel<'a> {
    pixel: [u32; 2],
    /// The number of the first such event.
    event: u32,
    label: &'a str,
    numbers: &'a str,
}

impl Find {
    /// Searches the picture and writes what was found.
    pub fn run(&self) -> Result<(), Failure> {
        let query = Query::parse(&self.query).map_err(|error| {
            let mark = format!("{}{}", " ".repeat(error.column - 1), "^".repeat(error.length));
            Failure::usage(format!("the query cannot be understood\n  {}\n  {mark}\n{error}", self.query))
        })?;
        let scene = self.profile.apply(self.scene.load_sized(self.size)?)?;
        query.unknown_names(&Vocabulary::of(&scene)).iter().for_each(|problem| warn(&problem.to_string()));
        let output = Output::create(self.output.as_deref())?;
        if self.format == Format::Png {
            drawn::check_has_a_file(&output, "a PNG")?;
        }
        let progress = stopped_by_ctrl_c();
        let pixels = scene.image.width as usize * scene.image.height as usize;
        let found = with_bar(pixels, || progress.done(), || scan(&scene, &query, 1, &progress, |_| {}));
        let found = found.ok_or_else(|| Failure::interrupted("interrupted: nothing was written"))?;
        output.write(&self.written(&scene, &query, &found)?)
    }

    fn written(&self, scene: &Scene, query: &Query, search: &Search) -> Result<Vec<u8>, Failure> {
        match self.format {
            Format::Text => Ok(text(scene, query, search).into_bytes()),
            Format::Json => {
                let size = search.grid.size;
                let pixels = search.found.iter().map(WrittenPixel::from).collect();
                let written = Written { scene: self.scene.name(), query: query.to_string(), size, pixels };
                serde_json::to_string(&written).map(with_newline).map_err(|error| Failure::refused(error.to_string()))
            }
            Format::Png => Ok(drawn::png(&heat_map(&map(query, search), MAP_SIZE, self.theme.into()))),
        }
    }
}

impl<'a> From<&'a Found> for WrittenPixel<'a> {
    fn from(found: &'a Found) -> Self {
        Self { pixel: found.pixel, event: found.event, label: &found.row.label, numbers: &found.row.numbers }
    }
}

fn text(scene: &Scene, query: &Query, search: &Search) -> String {
    let all = u64::from(scene.image.width) * u64::from(scene.image.height);
    let mut text = format!("{query}: {} of {all} pixels\n", search.found.len());
    for Found { pixel: [x, y], event, row } in &search.found {
        let numbers = if row.numbers.is_empty() { String::new() } else { format!("   {}", row.numbers) };
        let place = format!("{x},{y}");
        let _ = writeln!(text, "{place:>9}  event {event}: {}{numbers}", row.label);
    }
    text
}

/// The pixels that were found, as a map of one kind.
fn map(query: &Query, search: &Search) -> HeatMap {
    HeatMap {
        title: format!("Pixels with {query}"),
        size: search.grid.size.map(|side| side as usize),
        scale: HeatScale::Kinds(vec!["found".to_owned()]),
        nothing: Some("not found".to_owned()),
        values: search.grid.cells.iter().map(|&matches| if matches { 0.0 } else { f64::NAN }).collect(),
        ..HeatMap::default()
    }
}

/// The examples, and all words of the language.
fn words() -> String {
    let mut text = format!("{EXAMPLES}\n\nWords of QUERY:\n");
    let widest = terms().map(|term| term.name.len()).max().unwrap_or(0);
    for (kind, title) in [
        (TermKind::Word, "what an event is"),
        (TermKind::Names, "fields with names (`*` stands for anything), compared with = or !="),
        (TermKind::Numbers, "fields with numbers, compared with = != < <= > >="),
        (TermKind::Group, "with a question in parentheses"),
    ] {
        let _ = writeln!(text, "\n  {title}:");
        for term in terms().filter(|term| term.kind() == kind) {
            let example = if term.is_field() { format!(": {}", term.example) } else { String::new() };
            let _ = writeln!(text, "  {:widest$}  {}{example}", term.name, term.meaning);
        }
    }
    text
}
