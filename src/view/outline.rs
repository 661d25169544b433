//! Areas with curved edges, as letters have them.

use super::drawing::{Frame, Spot};
use super::sheet::bounds;
use ab_glyph::OutlineCurve;

/// A step of a pen that goes round an area.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Pen {
    /// Begins a contour there.
    Move(Spot),
    /// A straight line to there.
    Line(Spot),
    /// A parabola, with its control point and its end.
    Quad(Spot, Spot),
    /// A cubic curve, with its two control points and its end.
    Cubic(Spot, Spot, Spot),
    /// A straight line to where the contour began.
    Close,
}

impl Pen {
    /// The same step with all of its points taken elsewhere.
    #[must_use]
    pub fn moved(self, to: impl Fn(Spot) -> Spot) -> Self {
        match self {
            Self::Move(end) => Self::Move(to(end)),
            Self::Line(end) => Self::Line(to(end)),
            Self::Quad(control, end) => Self::Quad(to(control), to(end)),
            Self::Cubic(one, other, end) => Self::Cubic(to(one), to(other), to(end)),
            Self::Close => Self::Close,
        }
    }

    /// Its points, those that only pull at the curve included.
    pub fn spots(self) -> impl Iterator<Item = Spot> {
        let [one, other, end] = match self {
            Self::Move(end) | Self::Line(end) => [None, None, Some(end)],
            Self::Quad(control, end) => [None, Some(control), Some(end)],
            Self::Cubic(one, other, end) => [Some(one), Some(other), Some(end)],
            Self::Close => [None; 3],
        };
        [one, other, end].into_iter().flatten()
    }
}

/// A box that holds the outline: that of its points, which a curve never leaves.
#[must_use]
pub fn frame_of(steps: &[Pen]) -> Option<Frame> {
    bounds(steps.iter().flat_map(|step| step.spots())).map(|[low, high]| Frame { low, high })
}

/// A rectangle, gone round clockwise on screen as the outer edges of letters are.
#[must_use]
pub fn rectangle(Frame { low: [x0, y0], high: [x1, y1] }: Frame) -> [Pen; 5] {
    [Pen::Move([x0, y0]), Pen::Line([x1, y0]), Pen::Line([x1, y1]), Pen::Line([x0, y1]), Pen::Close]
}

/// The closed contours of a glyph; a new one begins wherever a curve does not start at the last one's end.
pub(super) fn steps_of(curves: &[OutlineCurve]) -> Vec<Pen> {
    let spot = |p: &ab_glyph::Point| [f64::from(p.x), f64::from(p.y)];
    let mut steps = Vec::with_capacity(curves.len() + 4);
    let mut pen = None;
    for curve in curves {
        let (start, step, end) = match curve {
            OutlineCurve::Line(a, b) => (a, Pen::Line(spot(b)), b),
            OutlineCurve::Quad(a, c, b) => (a, Pen::Quad(spot(c), spot(b)), b),
            OutlineCurve::Cubic(a, c, d, b) => (a, Pen::Cubic(spot(c), spot(d), spot(b)), b),
        };
        if pen != Some(*start) {
            if pen.is_some() {
                steps.push(Pen::Close);
            }
            steps.push(Pen::Move(spot(start)));
        }
        steps.push(step);
        pen = Some(*end);
    }
    if pen.is_some() {
        steps.push(Pen::Close);
    }
    steps
}
