//! The table for reading: a block for each knob.

use super::Findings;
use super::data::knob_and_value;
use super::figures::{answer, duration, goal, short, time, unmet};
use crate::cpu_time;
use crate::laboratory::{Point, what_is_true};
use std::fmt::Write;

/// The table, with what has to be known to read it.
pub fn table(findings: &Findings) -> String {
    let study = &findings.run.study;
    let mut text = head(findings);
    let counts = !findings.instructions.is_empty();
    let instructions = if counts { "   instructions" } else { "" };
    let _ = writeln!(
        text,
        "{:24}{:>22}{:>8}{:>10}{:>11}{:>10}{:>8}{:>11}{instructions}",
        "", "time ± spread", "repeats", "× scene", "RMSE", "p99.9", "wrong", "1 − SSIM"
    );
    let mut block = String::new();
    for (k, point) in std::iter::once(&study.standard).chain(&study.points).enumerate() {
        let (knob, value) = knob_and_value(point);
        if block != knob && k > 0 {
            let control = if point.is_control() { " (a control: nothing may change)" } else { "" };
            let plural = if point.settings.len() > 1 { "s" } else { "" };
            let _ = writeln!(text, "\n{knob}{plural}{control}");
        }
        block = knob;
        text.push_str(&row(point, &value, study.standard.timing.told()));
        if let Some(Some(count)) = findings.instructions.get(k) {
            let _ = write!(text, "{count:>15}");
        }
        text.push('\n');
    }
    text + &foot(findings)
}

fn row(point: &Point, value: &str, standard: Option<f64>) -> String {
    let mark = if point.on_frontier { "*" } else { " " };
    let timing = &point.timing;
    let seconds = timing.noise.map_or_else(|| time(timing.seconds, timing.spread), |noise| noise.describe());
    let times = timing.told().zip(standard).map_or_else(String::new, |(time, standard)| short(time / standard));
    let errors = &point.errors;
    // A long name has a line of its own.
    let name =
        if value.chars().count() > 20 { format!("{mark} {value}\n{:24}", "") } else { format!("{mark} {value:22}") };
    let lost = timing.noise.is_some();
    let columns =
        if lost { format!("{seconds:<40}") } else { format!("{seconds:>22}{:>8}{times:>10}", timing.repeats) };
    format!(
        "{name}{columns}{:>11}{:>10}{:>8}{:>11}",
        short(errors.rmse),
        short(errors.p999),
        errors.wrong_pixels,
        short(errors.dissimilarity)
    )
}

fn head(findings: &Findings) -> String {
    let run = findings.run;
    let (study, picture) = (&run.study, &run.study.standard.picture);
    let clock = if cpu_time::is_cpu_time() { "its own working time" } else { "the clock on the wall" };
    let pinned = &run.pinned_timing;
    let steadiness = if pinned.seconds > 0.0 { 100.0 * pinned.spread / pinned.seconds } else { 0.0 };
    let mut text = format!(
        "{}: {} × {} pixels (of {} × {})\n",
        findings.scene_name, picture.width, picture.height, run.whole.width, run.whole.height
    );
    let _ = writeln!(
        text,
        "Times: one thread, by {clock}, which is read to {}; it waited {:.0} % of the time.",
        duration(study.resolution),
        100.0 * study.waiting
    );
    let _ = writeln!(
        text,
        "An unchanging piece of work between them took {} ({} times): the machine is steady to {steadiness:.1} %.",
        time(pinned.seconds, pinned.spread),
        pinned.repeats
    );
    let sure = match study.reference.error {
        0.0 => "there is no chance in it".to_owned(),
        error => format!("its own error is {}", short(error)),
    };
    let pictures = if study.reference.pictures == 1 {
        "1 picture".to_owned()
    } else {
        format!("the mean of {} pictures", study.reference.pictures)
    };
    let cached = if study.reference.cached { ", some of them from earlier runs" } else { "" };
    let _ = writeln!(text, "Reference: {}, {pictures}{cached}; {sure}.\n", what_is_true(findings.scene));
    text
}

fn foot(findings: &Findings) -> String {
    let run = findings.run;
    let mut text = "\n* on the frontier: nothing measured is both faster and closer. Errors are of linear RGB from 0 to 1; wrong counts pixels\n\
                    that are off by more than 5 of 255 steps.\n"
        .to_owned();
    for found in &run.answers {
        let words = if found.is_met { answer(found) } else { unmet(found) };
        let _ =
            writeln!(text, "\n{} for {} × {} pixels:\n  {words}", goal(found.goal), run.whole.width, run.whole.height);
    }
    text
}
