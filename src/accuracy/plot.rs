//! The experiments as plots.

use super::experiment::{Place, Question, RAYS};
use super::subject::Subject;
use crate::shape::Method;
use crate::view::{Curve, LogPlot, Panel, Scale};

/// The plot of an experiment.
#[must_use]
pub fn plot(question: Question, subject: &Subject, places: &[Place]) -> LogPlot {
    let curves = |of: &dyn Fn(&Place, usize) -> f64, skipped: &[Method]| {
        let own = Method::ALL.iter().enumerate().filter(|(_, solver)| !skipped.contains(solver));
        own.map(|(k, solver)| Curve {
            name: solver.name().to_owned(),
            colour: k,
            points: places.iter().map(|place| [place.x, of(place, k)]).collect(),
        })
        .collect()
    };
    let edges = ["cube", "convex_polyhedron", "square"].contains(&subject.name);
    let (title, x_name, x_powers) = match (question, edges) {
        (Question::Distance, _) => {
            ("error and wrong answers against distance", "distance of the ray's start, in sizes of the shape", [0, 8])
        }
        (Question::Scale, _) => (
            "error and wrong answers against size",
            "scale of the object, which stands one unit from the origin of the world",
            [0, -8],
        ),
        (Question::Tangency, true) => (
            "error and wrong answers near an edge",
            "gap between the ray and an edge, in sizes of the shape",
            [-1, -16],
        ),
        (Question::Tangency, false) => (
            "error and wrong answers near a tangent",
            "gap between the ray and a tangent, in sizes of the shape",
            [-1, -16],
        ),
    };
    LogPlot {
        title: format!("{}: {title}", subject.title),
        notes: vec![
            format!("{RAYS} rays for each place. Errors: 99 of 100 rays with right hits are below, in units of what half a last digit"),
            "of the ray, in f64, can do to the hit time. The exact hits are those of double-double, whose error is not shown.".to_owned(),
        ],
        x_name: x_name.to_owned(),
        x_powers,
        panels: vec![
            Panel {
                y_name: "error of the hit time, in units of the attainable floor".to_owned(),
                scale: Scale::Log(-1, 10),
                curves: curves(&|place, k| place.error[k], &[Method::DoubleDouble]),
            },
            Panel {
                y_name: "wrong answers: a hit is missing, or one too many".to_owned(),
                scale: Scale::Share,
                curves: curves(&|place, k| place.wrong[k], &[]),
            },
        ],
    }
}
