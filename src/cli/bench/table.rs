//! What the turns took, for reading and as data.

use crate::cli::failure::Failure;
use crate::cpu_time::is_cpu_time;
use crate::peer::Agreement;
use clap::ValueEnum;
use serde::Serialize;
use std::fmt::Write as _;
use std::time::Duration;

/// How the result is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// A table for reading
    Table,
    /// A JSON object with all scenes
    Json,
}

/// What one scene took.
#[derive(Clone, Debug)]
pub struct Row {
    pub name: String,
    /// This program.
    pub ours: Duration,
    /// POV-Ray with its default bounding.
    pub by_default: Option<Duration>,
    /// POV-Ray with `+BM2`.
    pub by_tree: Option<Duration>,
    /// This program's rays, shadow rays among them.
    pub rays: u64,
    pub agreement: Option<Agreement>,
}

/// A row as data. The first five members are a contract.
#[derive(Serialize)]
struct RowData<'a> {
    name: &'a str,
    rayscope_s: f64,
    povray_s: Option<f64>,
    ratio: Option<f64>,
    agree: Option<f64>,
    worst: Option<u8>,
    povray_default_s: Option<f64>,
    povray_bm2_s: Option<f64>,
    rays: u64,
    ns_per_ray: f64,
}

#[derive(Serialize)]
struct TableData<'a> {
    povray: Option<&'a str>,
    cpu_time: bool,
    scenes: Vec<RowData<'a>>,
}

impl Row {
    /// POV-Ray's better time.
    fn theirs(&self) -> Option<Duration> {
        self.by_default.into_iter().chain(self.by_tree).min()
    }

    /// This program's time to POV-Ray's better one.
    fn ratio(&self) -> Option<f64> {
        self.theirs().filter(|time| !time.is_zero()).map(|time| self.ours.as_secs_f64() / time.as_secs_f64())
    }

    fn ns_per_ray(&self) -> f64 {
        self.ours.as_secs_f64() * 1e9 / self.rays.max(1) as f64
    }

    fn data(&self) -> RowData<'_> {
        let seconds = |time: Option<Duration>| time.as_ref().map(Duration::as_secs_f64);
        RowData {
            name: &self.name,
            rayscope_s: self.ours.as_secs_f64(),
            povray_s: seconds(self.theirs()),
            ratio: self.ratio(),
            agree: self.agreement.map(|agreement| agreement.share),
            worst: self.agreement.map(|agreement| agreement.worst),
            povray_default_s: seconds(self.by_default),
            povray_bm2_s: seconds(self.by_tree),
            rays: self.rays,
            ns_per_ray: self.ns_per_ray(),
        }
    }
}

impl Format {
    /// The result; `povray` is its version, if it was there.
    pub fn write(self, rows: &[Row], povray: Option<&str>) -> Result<String, Failure> {
        match self {
            Self::Table => Ok(table(rows, povray)),
            Self::Json => {
                let data = TableData { povray, cpu_time: is_cpu_time(), scenes: rows.iter().map(Row::data).collect() };
                let text = serde_json::to_string_pretty(&data).map_err(|error| Failure::refused(error.to_string()))?;
                Ok(text + "\n")
            }
        }
    }
}

fn table(rows: &[Row], povray: Option<&str>) -> String {
    let longest = rows.iter().map(|row| row.name.len()).max().unwrap_or(0).max(5);
    let mut text = format!(
        "{:longest$}{:>11}{:>11}{:>12}{:>8}{:>12}{:>10}{:>11}{:>7}\n",
        "scene", "POV-Ray s", "+BM2 s", "rayscope s", "ratio", "rays", "ns a ray", "agree", "worst"
    );
    let seconds = |time: Option<Duration>| time.map_or("–".to_owned(), |time| format!("{:.3}", time.as_secs_f64()));
    for row in rows {
        let ratio = row.ratio().map_or("–".to_owned(), |ratio| format!("{ratio:.2}"));
        let agree = row.agreement.map_or("–".to_owned(), |agreement| format!("{:.3} %", 100.0 * agreement.share));
        let worst = row.agreement.map_or("–".to_owned(), |agreement| agreement.worst.to_string());
        let _ = writeln!(
            text,
            "{:longest$}{:>11}{:>11}{:>12}{ratio:>8}{:>12}{:>10.0}{agree:>11}{worst:>7}",
            row.name,
            seconds(row.by_default),
            seconds(row.by_tree),
            seconds(Some(row.ours)),
            row.rays,
            row.ns_per_ray()
        );
    }
    let clock = if is_cpu_time() {
        "CPU seconds of the tracing alone, one thread."
    } else {
        "POV-Ray's are CPU seconds; rayscope's are those of the clock, for want of a CPU time on this system."
    };
    let povray = povray.map_or(String::new(), |version| format!(" POV-Ray {version}."));
    let _ = write!(
        text,
        "\n{clock}{povray}\nratio: rayscope's seconds to the better of POV-Ray's. rays: rayscope's, shadow rays among them.\n\
         agree: pixels with no channel more than {} of 255 apart; worst: the largest difference of a channel.\n",
        Agreement::CLOSE
    );
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row() -> Row {
        Row {
            name: "a".to_owned(),
            ours: Duration::from_millis(500),
            by_default: Some(Duration::from_secs(2)),
            by_tree: Some(Duration::from_secs(1)),
            rays: 1_000,
            agreement: Some(Agreement { share: 0.5, worst: 3 }),
        }
    }

    #[test]
    fn the_ratio_is_to_the_better_of_the_others_times() {
        assert_eq!(row().ratio(), Some(0.5));
        assert_eq!(Row { by_tree: None, ..row() }.ratio(), Some(0.25));
        assert_eq!(row().ns_per_ray(), 500_000.0);
    }

    #[test]
    fn without_the_other_program_its_columns_are_empty() {
        let alone = Row { by_default: None, by_tree: None, agreement: None, ..row() };
        let text = table(std::slice::from_ref(&alone), None);
        assert_eq!(text.lines().nth(1).unwrap().matches('–').count(), 5);
        assert!(alone.data().povray_s.is_none() && alone.data().ratio.is_none());
    }
}
