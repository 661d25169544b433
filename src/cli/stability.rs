//! `rayscope stability`: how right the solvers are, as a table, as data, or as plots.

use super::drawn::{Ending, Theme};
use super::failure::Failure;
use super::output::Output;
use super::progress::{stop_on_ctrl_c, with_bar};
use super::stability_plots::{PlotKind, Watch, plotted, write_all};
use crate::accuracy::{self, Row, SHAPES, Subject, subject};
use crate::shape::Method;
use clap::{Args, ValueEnum};
use serde::Serialize;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// Judge every solver by rays whose hits are known with 40 digits
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  rayscope stability                                   the table
  rayscope stability --shape torus --shape csg         of these shapes alone
  rayscope stability --format json                     as data: {\"rows\": [{\"shape\", \"kind\", \"solver\", \"cases\",
                                                       \"missed\", \"extra\", \"worst_ulp\", …}, …]}
  rayscope stability --shape torus --plot distance -o torus.png
                                                       error and wrong answers from 1 to 10⁸ sizes away
  rayscope stability --plots plots --theme dark        all plots, as SVG files in the folder plots

Solvers:
  f32            the program's solver in single precision, with nothing to fall back on
  f64            the same in double precision
  adaptive       what the program renders with: f64, and 32 digits where these leave the answer open
  double-double  32 digits from the start
  textbook       the solver that textbooks print, in double precision

worst_ulp is the largest error of a hit in units of the attainable floor: what half a last digit of the ray's own numbers
can move the hit by, and half a last digit of the hit time itself. About 1 is as good as can be. f32 is judged by the same
exact hits, with a floor that is as much coarser as its last digits are (2²⁹ times), and is not asked to tell apart what
rounding to its numbers has merged; but a hit that it reports for a near miss is extra.")]
pub struct Stability {
    /// Only this shape, or csg; more than one may be given
    #[arg(long, value_name = "NAME", value_parser = SHAPES.map(|(name, _)| name))]
    shape: Vec<String>,
    /// How to write the table
    #[arg(long, value_enum, default_value_t = Format::Table, conflicts_with_all = ["plot", "plots"])]
    format: Format,
    /// Instead of the table a plot of one shape; -o says by its ending whether as .svg, .png or .pdf
    #[arg(long, value_enum, value_name = "KIND", requires = "shape", conflicts_with = "plots")]
    plot: Option<PlotKind>,
    /// Instead of the table all plots of all shapes, as SVG files in this folder
    #[arg(long, value_name = "FOLDER", conflicts_with = "output")]
    plots: Option<PathBuf>,
    /// Colours of plots
    #[arg(long, value_enum, default_value_t = Theme::Light)]
    theme: Theme,
    /// Where to write it [default: the standard output]
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Format {
    /// A table for reading
    Table,
    /// A JSON object with all rows
    Json,
}

/// A row as data. The first seven members are a contract.
#[derive(Serialize)]
struct RowData<'a> {
    shape: &'a str,
    kind: &'a str,
    solver: &'a str,
    cases: usize,
    missed: usize,
    extra: usize,
    worst_ulp: f64,
    p99_ulp: f64,
    wrong: usize,
    undecidable: usize,
}

impl<'a> RowData<'a> {
    fn new(row: &'a Row) -> Self {
        Self {
            shape: row.shape,
            kind: &row.kind,
            solver: row.solver.name(),
            cases: row.cases,
            missed: row.missed,
            extra: row.extra,
            worst_ulp: row.worst,
            p99_ulp: row.p99,
            wrong: row.wrong,
            undecidable: row.undecidable,
        }
    }
}

#[derive(Serialize)]
struct TableData<'a> {
    rows: Vec<RowData<'a>>,
}

impl Stability {
    /// Judges or plots, and writes.
    pub fn run(&self) -> Result<(), Failure> {
        let stopped = Arc::new(AtomicBool::new(false));
        let stopping = Arc::clone(&stopped);
        stop_on_ctrl_c(move || stopping.swap(true, Ordering::Relaxed));
        let done = AtomicUsize::new(0);
        let watch = Watch { done: &done, stopped: &stopped };
        match (self.plot, &self.plots) {
            (Some(kind), _) => self.write_plot(kind, &watch),
            (None, Some(folder)) => self.write_plots(folder, &watch),
            (None, None) => self.write_table(&watch),
        }
    }

    fn write_table(&self, watch: &Watch) -> Result<(), Failure> {
        let output = Output::create(self.output.as_deref())?;
        let total = SHAPES.iter().filter(|(shape, _)| self.wants(shape)).map(|_| TYPICAL).sum();
        let stopped = || watch.stopped.load(Ordering::Relaxed);
        let count = || {
            watch.done.fetch_add(1, Ordering::Relaxed);
        };
        let judge = || accuracy::stability(|shape| self.wants(shape), stopped, count);
        let rows = with_bar(total, || watch.done.load(Ordering::Relaxed), judge).map_err(Failure::refused)?;
        if stopped() {
            return Err(Failure::interrupted("interrupted; nothing was written"));
        }
        let text = match self.format {
            Format::Table => table(&rows),
            Format::Json => json(&rows)?,
        };
        output.write(text.as_bytes())
    }

    fn write_plot(&self, kind: PlotKind, watch: &Watch) -> Result<(), Failure> {
        let subjects = self.subjects();
        let [subject] = subjects.as_slice() else {
            return Err(Failure::usage("a plot is of one primitive: give one --shape that is not csg"));
        };
        let ending = Ending::of(self.output.as_deref());
        let output = Output::create(self.output.as_deref())?;
        let work = || plotted(kind, subject, self.theme, ending, watch);
        output.write(&with_bar(kind.places(), || watch.done.load(Ordering::Relaxed), work)?)
    }

    fn write_plots(&self, folder: &Path, watch: &Watch) -> Result<(), Failure> {
        let subjects = self.subjects();
        let places = PlotKind::ALL.iter().map(|kind| kind.places()).sum::<usize>() * subjects.len();
        let work = || write_all(folder, &subjects, self.theme, watch);
        with_bar(places, || watch.done.load(Ordering::Relaxed), work)
    }

    fn wants(&self, shape: &str) -> bool {
        self.shape.is_empty() || self.shape.iter().any(|wanted| wanted == shape)
    }

    /// What can be plotted: every primitive that is asked for.
    fn subjects(&self) -> Vec<Subject> {
        SHAPES.iter().filter(|(shape, _)| self.wants(shape)).filter_map(|(shape, _)| subject(shape)).collect()
    }
}

/// About how many cases a shape has: good enough for a bar.
const TYPICAL: usize = 520;

fn json(rows: &[Row]) -> Result<String, Failure> {
    let data = TableData { rows: rows.iter().map(RowData::new).collect() };
    serde_json::to_string_pretty(&data).map(|text| text + "\n").map_err(|error| Failure::refused(error.to_string()))
}

const LEGEND: &str = "\
missed, extra: hits that should have been reported, and that should not.
error: the largest error of a hit, in units of what half a last digit of the input can do; about 1 is as good as can be.
f32 is judged with a floor 2²⁹ times higher, as much as its last digits are coarser.
Cases in which half a last digit changes what is hit count as right either way.
";

/// One block for each shape: a line for each kind, two columns for each solver, and the sum.
fn table(rows: &[Row]) -> String {
    let mut text = String::new();
    for (shape, _) in SHAPES {
        let own: Vec<&Row> = rows.iter().filter(|row| row.shape == shape).collect();
        if own.is_empty() {
            continue;
        }
        let mut kinds: Vec<&str> = own.iter().map(|row| row.kind.as_str()).collect();
        kinds.dedup();
        let _ = write!(text, "{shape:18}{:>6}", "cases");
        for solver in Method::ALL {
            let _ = write!(text, "{:>25}", solver.name());
        }
        let _ = write!(text, "\n{:24}", "");
        text.push_str(&format!("{:>9}{:>7}{:>9}", "missed", "extra", "error").repeat(Method::ALL.len()));
        text.push('\n');
        for kind in kinds {
            let of_kind: Vec<&Row> = own.iter().copied().filter(|row| row.kind == kind).collect();
            text.push_str(&line(kind, &of_kind));
        }
        text.push_str(&line("all", &own));
        text.push('\n');
    }
    text + LEGEND
}

/// The line of some rows, summed over each solver.
fn line(name: &str, rows: &[&Row]) -> String {
    let of = |solver: Method| rows.iter().filter(move |row| row.solver == solver);
    let cases: usize = of(Method::Adaptive).map(|row| row.cases).sum();
    let mut text = format!("  {name:16}{cases:>6}");
    for solver in Method::ALL {
        let missed: usize = of(solver).map(|row| row.missed).sum();
        let extra: usize = of(solver).map(|row| row.extra).sum();
        let worst = of(solver).map(|row| row.worst).fold(0.0, f64::max);
        let _ = write!(text, "{missed:>9}{extra:>7}{:>9}", short(worst));
    }
    text + "\n"
}

/// An error in few characters.
fn short(error: f64) -> String {
    if error == 0.0 {
        "0".to_owned()
    } else if error < 1_000.0 {
        format!("{error:.2}")
    } else {
        format!("{error:.0e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_are_short_at_any_size() {
        assert_eq!([0.0, 0.5, 12.345, 123_456.0].map(short), ["0", "0.50", "12.35", "1e5"]);
        assert_eq!(short(f64::INFINITY), "inf");
    }
}
