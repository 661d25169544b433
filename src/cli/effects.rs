//! `rayscope effects`: the ledger of a scene as a table or as JSON.

use super::failure::Failure;
use super::output::Output;
use super::progress::{stopped_by_ctrl_c, with_bar};
use super::scene_argument::SceneArgument;
use crate::cpu_time::cpu_time;
use crate::ledger::{self, Ledger, Price, Row, Size};
use clap::{Args, ValueEnum};
use serde::Serialize;
use std::fmt::Write;
use std::path::PathBuf;

/// List the effects that a scene calls for and what each of them costs
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  rayscope effects optics/fishbowl
  rayscope effects lens/focus --pairs 9
  rayscope effects my-scene.json --format json -o effects.json

An effect that the scene does not call for runs no code: its counts are 0 and it costs nothing. The price of one that it calls
for is how much longer a picture takes with it than without it, on one thread, as the median of pairs measured in turn; behind
± stands half the distance between the quartiles. Prices need not add up to the whole: shadows cost more where there are
mirrors to see them in.")]
pub struct Effects {
    #[command(flatten)]
    scene: SceneArgument,
    /// The most columns of the pictures that are measured
    #[arg(long, value_name = "N", default_value_t = 160, value_parser = clap::value_parser!(u32).range(1..=4096))]
    width: u32,
    /// How many pairs of pictures, with and without, make a price
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = clap::value_parser!(u32).range(1..=1000))]
    pairs: u32,
    /// How the ledger is written
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    /// The file to write [default: the standard output]
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Format {
    /// A table
    Text,
    /// One JSON object
    Json,
}

/// The ledger as it is written.
#[derive(Serialize)]
struct LedgerFile<'a> {
    scene: &'a str,
    width: u32,
    height: u32,
    pairs: u32,
    /// Of the whole picture.
    ns_per_pixel: f64,
    spread: f64,
    effects: Vec<RowFile<'a>>,
}

#[derive(Serialize)]
struct RowFile<'a> {
    name: &'static str,
    called_for: bool,
    why: &'a str,
    calls: u64,
    rays: u64,
    ns_per_pixel: f64,
    spread: f64,
    share: f64,
}

impl Effects {
    /// Measures and writes.
    pub fn run(&self) -> Result<(), Failure> {
        let scene = self.scene.load()?;
        let output = Output::create(self.output.as_deref())?;
        let size = Size { width: self.width, pairs: self.pairs };
        let progress = stopped_by_ctrl_c();
        let measured = with_bar(
            size.pixels(&scene),
            || progress.done(),
            || ledger::measure(&scene, size, |work| cpu_time(work).0, &progress),
        );
        let ledger = measured.ok_or_else(|| Failure::interrupted("interrupted: nothing was written"))?;
        let text = match self.format {
            Format::Text => table(&ledger),
            Format::Json => self.json(&ledger)?,
        };
        output.write(text.as_bytes())
    }

    fn json(&self, ledger: &Ledger) -> Result<String, Failure> {
        let (width, height, pairs) = (ledger.picture.width, ledger.picture.height, ledger.pairs);
        let (ns_per_pixel, spread) = (ledger.ns_per_pixel, ledger.spread);
        let effects = ledger.rows.iter().map(RowFile::of).collect();
        let file = LedgerFile { scene: self.scene.name(), width, height, pairs, ns_per_pixel, spread, effects };
        let text = serde_json::to_string_pretty(&file).map_err(|error| Failure::refused(error.to_string()))?;
        Ok(text + "\n")
    }
}

impl<'a> RowFile<'a> {
    fn of(row: &'a Row) -> Self {
        let price = row.price.unwrap_or(Price { ns_per_pixel: 0.0, spread: 0.0, share: 0.0 });
        Self {
            name: row.reason.effect.name(),
            called_for: row.reason.called_for,
            why: &row.reason.why,
            calls: row.calls,
            rays: row.rays,
            ns_per_pixel: price.ns_per_pixel,
            spread: price.spread,
            share: price.share,
        }
    }
}

/// The ledger for reading.
fn table(ledger: &Ledger) -> String {
    let mut text = format!("{:<16} {:>10} {:>10} {:>20} {:>7}  why\n", "effect", "calls", "rays", "ns/pixel", "share");
    for row in &ledger.rows {
        let [price, share] = row.price.map_or([const { String::new() }; 2], |price| {
            let share = format!("{:.0} %", 100.0 * price.share);
            let unclear = if price.is_clear() { "" } else { "~ " };
            [format!("{unclear}{:.0} ± {:.0}", price.ns_per_pixel, price.spread), share]
        });
        let name = row.reason.effect.name();
        let counts = if row.reason.called_for {
            [row.calls, row.rays].map(|count| count.to_string())
        } else {
            ["–", "–"].map(str::to_owned)
        };
        let _ =
            writeln!(text, "{name:<16} {:>10} {:>10} {price:>20} {share:>7}  {}", counts[0], counts[1], row.reason.why);
    }
    let _ = writeln!(
        text,
        "\n{} × {} pixels at {:.0} ± {:.0} ns on one thread; each price is the median of {} pairs. ~ is a price within its own spread.",
        ledger.picture.width, ledger.picture.height, ledger.ns_per_pixel, ledger.spread, ledger.pairs
    );
    text
}
