//! POV-Ray as a program: is it there, what does it draw, and how long does it say that it took.

use super::scenes::PeerScene;
use crate::cli::failure::{Failure, reason};
use crate::trace::Progress;
use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, ErrorKind};
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::thread;
use std::time::Duration;

/// What to do where it is not installed.
pub const HOW_TO_GET_IT: &str = "rayscope: there is no program `povray`, so only rayscope is timed. On Debian and Ubuntu \
     `apt-get install povray` installs it; https://www.povray.org/download/ has it for other systems.";

/// How often it is asked whether it has ended. Its own time is not measured by this clock.
const LOOK: Duration = Duration::from_millis(20);

/// How much of what it said is shown where it failed: its complaint is in the last few lines.
const LAST_LINES: usize = 4;

/// How POV-Ray finds the objects that a ray may hit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bounding {
    /// Its bounding slabs.
    Default,
    /// `+BM2`: its BSP tree.
    Tree,
}

/// What it drew.
pub struct Drawn {
    /// The CPU time of the tracing, as it prints it.
    pub time: Duration,
    /// Three bytes a pixel.
    pub picture: Vec<u8>,
}

/// The version of the program; none if it is not installed.
pub fn installed_version() -> Result<Option<String>, Failure> {
    match Command::new("povray").arg("--version").stdin(Stdio::null()).output() {
        Ok(output) => {
            let said = [output.stdout, output.stderr].concat();
            Ok(Some(version(&String::from_utf8_lossy(&said)).unwrap_or("of an unknown version").to_owned()))
        }
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(None),
        Err(error) => Err(cannot_run(&error)),
    }
}

/// Draws the scene on one thread; none if it was interrupted.
pub fn draw(scene: &PeerScene, bounding: Bounding, progress: &Progress) -> Result<Option<Drawn>, Failure> {
    let folder = tempfile::tempdir().map_err(|error| cannot_run(&error))?;
    let (picture, log) = (folder.path().join("picture.png"), folder.path().join("log"));
    let child = start(scene, bounding, &picture, &log).map_err(|error| cannot_run(&error))?;
    let Some(status) = wait(child, progress).map_err(|error| cannot_run(&error))? else { return Ok(None) };
    let said = fs::read(&log).map(|bytes| String::from_utf8_lossy(&bytes).into_owned()).unwrap_or_default();
    let failed = |why: &str| {
        let said: Vec<&str> = said.lines().filter(|line| !line.trim().is_empty()).collect();
        let end = said[said.len().saturating_sub(LAST_LINES)..].join("\n  ");
        Failure::refused(format!("povray {why} {}; it ended with\n  {end}", scene.sdl.display()))
    };
    if !status.success() {
        return Err(failed("did not draw"));
    }
    let time = trace_time(&said).ok_or_else(|| failed("did not say how long it traced"))?;
    let picture = image::open(&picture).map_err(|error| failed(&format!("left no picture ({error}) of")))?;
    Ok(Some(Drawn { time, picture: picture.to_rgb8().into_raw() }))
}

fn start(scene: &PeerScene, bounding: Bounding, picture: &Path, log: &Path) -> io::Result<Child> {
    let joined = |option: &str, path: &Path| {
        let mut argument = OsString::from(option);
        argument.push(path);
        argument
    };
    let (width, height) = (scene.scene.image.width, scene.scene.image.height);
    let mut command = Command::new("povray");
    command
        .args([joined("+I", &scene.sdl), joined("+O", picture)])
        .args([format!("+W{width}"), format!("+H{height}")])
        .args(["+WT1", "-D", "-V", "+FN8"])
        .args((bounding == Bounding::Tree).then_some("+BM2"));
    command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(File::create(log)?).spawn()
}

fn wait(mut child: Child, progress: &Progress) -> io::Result<Option<ExitStatus>> {
    loop {
        if progress.cancelled() {
            // It may have ended by itself: then there is nothing to end.
            let _ = child.kill();
            child.wait()?;
            return Ok(None);
        }
        if let Some(status) = child.try_wait()? {
            return Ok(Some(status));
        }
        thread::sleep(LOOK);
    }
}

fn cannot_run(error: &io::Error) -> Failure {
    Failure::refused(format!("cannot run povray: {}", reason(error)))
}

/// The word after `POV-Ray` on a line of its own.
fn version(said: &str) -> Option<&str> {
    said.lines().find_map(|line| line.strip_prefix("POV-Ray "))?.split_whitespace().next()
}

/// The CPU seconds on the line after `Trace Time`.
fn trace_time(said: &str) -> Option<Duration> {
    let (_, after) = said.split_once("Trace Time:")?;
    let (before, _) = after.lines().nth(1)?.split_once(" CPU-seconds")?;
    let seconds: f64 = before.rsplit(' ').next()?.parse().ok()?;
    Duration::try_from_secs_f64(seconds).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    const SAID: &str = "\
Parser Time
  Parse Time:       0 hours  0 minutes  0 seconds (0.001 seconds)
              using 1 thread(s) with 0.250 CPU-seconds total
Render Time:
  Photon Time:      No photons
  Trace Time:       0 hours  0 minutes  1 seconds (1.118 seconds)
              using 1 thread(s) with 1.058 CPU-seconds total
POV-Ray finished
";

    #[test]
    fn the_time_is_the_cpu_time_of_the_tracing_alone() {
        assert_eq!(trace_time(SAID), Some(Duration::from_millis(1_058)));
        assert_eq!(trace_time("Trace Time: none"), None);
    }

    #[test]
    fn the_version_is_read_past_complaints() {
        assert_eq!(version("povray: cannot open a file\nPOV-Ray 3.7.0.10.unofficial\n\n"), Some("3.7.0.10.unofficial"));
        assert_eq!(version(""), None);
    }
}
