//! `--instructions`: how many instructions each setting takes, by running this same program under a tool that counts them.
//!
//! Instructions do not depend on what else the machine does: the same picture takes the same number each time, give or take
//! what the loader does. Those of a picture of one pixel are taken off, so that what is left is the picture's own.

use super::super::failure::{Failure, reason};
use super::super::scene_argument::SceneArgument;
use crate::laboratory::{Point, Run};
use crate::scene::Profile;
use std::env;
use std::fs;
use std::path::Path;
use std::process::{Command, Output, Stdio};
use tempfile::TempDir;

/// What counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Tool {
    Perf,
    Callgrind,
}

impl Tool {
    /// The program under this tool.
    fn command(self, program: &Path) -> Command {
        let mut command = match self {
            Self::Perf => Command::new("perf"),
            Self::Callgrind => Command::new("valgrind"),
        };
        match self {
            Self::Perf => command.args(["stat", "-x,", "-e", "instructions:u"]),
            Self::Callgrind => command.args(["--tool=callgrind", "--callgrind-out-file=/dev/null"]),
        };
        command.arg(program).stdin(Stdio::null());
        command
    }

    /// The number in what the tool said.
    fn count(self, said: &str) -> Option<u64> {
        match self {
            Self::Perf => said.lines().find(|line| line.contains("instructions"))?.split(',').next()?.parse().ok(),
            Self::Callgrind => {
                let line = said.lines().find(|line| line.contains("Collected :"))?;
                line.rsplit(':').next()?.trim().parse().ok()
            }
        }
    }
}

/// The instructions of the scene as it stands and of each point, in their order.
pub fn count_all(scene: &SceneArgument, run: &Run) -> Result<Vec<Option<u64>>, Failure> {
    let program =
        env::current_exe().map_err(|error| Failure::refused(format!("this program cannot find itself: {error}")))?;
    let tool = find_tool(&program)?;
    let folder = tempfile::tempdir()
        .map_err(|error| Failure::refused(format!("no folder for temporary files: {}", reason(&error))))?;
    let study = &run.study;
    let picture = &study.standard.picture;
    let counting = Counting { tool, program: &program, scene, folder: &folder };
    let empty = counting.count(&study.standard.profile, [1, 1])?;
    let mut known: Vec<(&Profile, Option<u64>)> = Vec::new();
    let count = |point: &Point| {
        let counted = counting.count(&point.profile, [picture.width, picture.height])?;
        Ok::<_, Failure>(counted.zip(empty).map(|(all, empty)| all.saturating_sub(empty)))
    };
    let mut counts = Vec::new();
    for point in std::iter::once(&study.standard).chain(&study.points) {
        let found = known.iter().find(|(profile, _)| **profile == point.profile).map(|(_, count)| *count);
        let counted = match found {
            Some(counted) => counted,
            None => count(point)?,
        };
        known.push((&point.profile, counted));
        counts.push(counted);
    }
    Ok(counts)
}

struct Counting<'a> {
    tool: Tool,
    program: &'a Path,
    scene: &'a SceneArgument,
    folder: &'a TempDir,
}

impl Counting<'_> {
    fn count(&self, profile: &Profile, [width, height]: [u32; 2]) -> Result<Option<u64>, Failure> {
        let [file, picture] = ["profile.json", "picture.png"].map(|name| self.folder.path().join(name));
        let text = profile.to_json("").map_err(Failure::refused)?;
        fs::write(&file, text).map_err(|error| Failure::from_file(&file, &error))?;
        let mut command = self.tool.command(self.program);
        command.args(["render", self.scene.name(), "--threads", "1", "--width", &width.to_string()]);
        command.args(["--height", &height.to_string(), "--accuracy"]).arg(&file).arg("-o").arg(&picture);
        if self.scene.outside() == crate::folder::Outside::Allowed {
            command.arg("--allow-outside-files");
        }
        let output =
            command.output().map_err(|error| Failure::refused(format!("the counting tool: {}", reason(&error))))?;
        if !output.status.success() {
            let why = why_not(self.tool, &output);
            return Err(Failure::refused(format!("instructions cannot be counted here: {why}")));
        }
        Ok(self.tool.count(&said(&output)))
    }
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// The first tool that can count this program's instructions on this machine.
fn find_tool(program: &Path) -> Result<Tool, Failure> {
    let mut reasons = Vec::new();
    for tool in [Tool::Perf, Tool::Callgrind] {
        match tool.command(program).arg("--version").output() {
            Ok(output) if output.status.success() && tool.count(&said(&output)).is_some() => return Ok(tool),
            Ok(output) => reasons.push(why_not(tool, &output)),
            Err(error) => reasons.push(format!("{} cannot be started: {}", name(tool), reason(&error))),
        }
    }
    Err(Failure::refused(format!(
        "instructions cannot be counted here; leave out --instructions, or see to one of these\n  {}",
        reasons.join("\n  ")
    )))
}

fn name(tool: Tool) -> &'static str {
    match tool {
        Tool::Perf => "perf",
        Tool::Callgrind => "valgrind",
    }
}

fn why_not(tool: Tool, output: &Output) -> String {
    let said = said(output);
    match tool {
        Tool::Perf if said.contains("<not supported>") => {
            "perf: this machine's processor does not let instructions be counted (many virtual machines do not)"
                .to_owned()
        }
        Tool::Callgrind if said.contains("unhandled instruction") || said.contains("Illegal opcode") => {
            "valgrind does not know an instruction of this program; build it without -C target-cpu=native".to_owned()
        }
        _ => {
            let last = said.lines().rev().find(|line| !line.trim().is_empty()).unwrap_or("it said nothing");
            format!("{} counted nothing: {}", name(tool), last.trim())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_are_found_in_what_the_tools_say() {
        assert_eq!(Tool::Perf.count("123456,,instructions:u,999,100.00,,\n"), Some(123_456));
        assert_eq!(Tool::Perf.count("<not supported>,,instructions:u,0,100.00,,\n"), None);
        assert_eq!(Tool::Callgrind.count("==7== Events    : Ir\n==7== Collected : 7654321\n"), Some(7_654_321));
        assert_eq!(Tool::Callgrind.count("==7== Illegal instruction\n"), None);
    }
}
