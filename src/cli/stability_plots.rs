//! The plots of `rayscope stability`: the solvers followed into the distance, towards tangents and to small objects.

use super::drawn::{Ending, Theme};
use super::failure::{Failure, reason};
use super::output::Output;
use crate::accuracy::{Place, Question, Subject, experiment, plot};
use crate::view::log_plot;
use clap::ValueEnum;
use std::fs;
use std::path::Path;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// Plots are this large, in points.
const SIZE: [f64; 2] = [760.0, 560.0];

/// What is plotted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum PlotKind {
    /// Error and wrong answers against the distance of the ray's start
    Distance,
    /// Error and wrong answers against the gap between the ray and a tangent or edge
    Tangency,
    /// Error and wrong answers against the size of the object, which stands one unit from the origin of the world
    Scale,
}

impl PlotKind {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Distance, Self::Tangency, Self::Scale];

    const fn question(self) -> Question {
        match self {
            Self::Distance => Question::Distance,
            Self::Tangency => Question::Tangency,
            Self::Scale => Question::Scale,
        }
    }

    /// How many places it has on its x axis.
    pub fn places(self) -> usize {
        self.question().places().len()
    }

    const fn name(self) -> &'static str {
        match self {
            Self::Distance => "distance",
            Self::Tangency => "tangency",
            Self::Scale => "scale",
        }
    }

    /// The file that it is written to in a folder of plots.
    pub fn file_name(self, subject: &Subject) -> String {
        format!("error_{}_{}.svg", self.name(), subject.name)
    }
}

/// How far the work is, and whether it is to stop.
pub struct Watch<'a> {
    /// Places that are finished.
    pub done: &'a AtomicUsize,
    /// Set by Ctrl-C.
    pub stopped: &'a AtomicBool,
}

/// The plot of one subject, as the ending says.
pub fn plotted(
    kind: PlotKind,
    subject: &Subject,
    theme: Theme,
    ending: Ending,
    watch: &Watch,
) -> Result<Vec<u8>, Failure> {
    let count = || {
        watch.done.fetch_add(1, Ordering::Relaxed);
    };
    let places: Vec<Place> = experiment(kind.question(), subject, || watch.stopped.load(Ordering::Relaxed), count);
    if watch.stopped.load(Ordering::Relaxed) {
        return Err(Failure::interrupted("interrupted; the plot that was being worked on was not written"));
    }
    let drawing = log_plot(&plot(kind.question(), subject, &places), SIZE, theme.into());
    Ok(ending.bytes(&format!("{}, {}", subject.name, kind.name()), &drawing))
}

/// All plots of the subjects as SVG files in a folder, which is made if it is not there.
pub fn write_all(folder: &Path, subjects: &[Subject], theme: Theme, watch: &Watch) -> Result<(), Failure> {
    fs::create_dir_all(folder).map_err(|error| {
        Failure::refused(format!("cannot make the folder {}: {}", folder.display(), reason(&error)))
    })?;
    for subject in subjects {
        for kind in PlotKind::ALL {
            let output = Output::create(Some(&folder.join(kind.file_name(subject))))?;
            output.write(&plotted(kind, subject, theme, Ending::Svg, watch)?)?;
        }
    }
    Ok(())
}
