//! Leaving a surface without hitting it again, and without an epsilon.
//!
//! A spawned ray starts on a boundary that is known, and it is known what the ray does there: from then on it is inside
//! the object, or outside. Among the object's boundaries along the new ray one is the boundary that was left, at t = 0 up to
//! rounding. It is picked out by what it does to the ray and by the *error bounds* of the start and of its own time, and
//! all that comes after it counts, however near: a shell 10⁻⁵ thick keeps its far side.
//!
//! A ray that leaves at a grazing angle may, by rounding, start beside the surface, and its line may miss the boundary
//! altogether. Where the list of boundaries says that the ray is on the wrong side, the object is asked once more, from
//! a start that is moved to the right side by the bound on its own error. Where even that does not help, the way between
//! the boundary and its neighbour is shorter than rounding, and the ray is turned back at once, at t = 0. So what a ray is
//! inside of always follows the boundaries that it was seen to cross.

use super::closest::Surface;
use crate::csg::{Boundary, IntervalList, Solid};
use crate::record::{Entry, Recorder, Sense, What};
use crate::scene::Object;
use glam::DVec3;

/// The boundary that a spawned ray started on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Departure {
    /// The object, by its place in the list.
    pub object: usize,
    /// The boundary as the ray before met it.
    boundary: Boundary,
    /// What crossing that boundary at t = 0 does to the new ray's line.
    sense: Sense,
    /// The outward unit normal there.
    normal: DVec3,
    /// Bound on how far the start lies from the surface.
    blur: f64,
}

/// The boundaries of an object that count for a ray.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Ahead {
    /// The boundary that the ray started on, which does not count.
    pub departed: Option<Boundary>,
    /// Those that count; the list begins where the ray does.
    pub list: IntervalList,
    /// How far the start had to be moved to the right side of the surface, if it had to be.
    pub moved: Option<f64>,
}

/// Roundings in a hit point's coordinates: the product, the sum, and the inverse transform on the way back.
const POINT_ROUNDINGS: f64 = 8.0 * f64::EPSILON;

/// Bound on how far the point where a ray meets a boundary may lie from the surface.
pub(super) fn blur(boundary: &Boundary, incoming: DVec3, normal: DVec3, point: DVec3) -> f64 {
    boundary.error * normal.dot(incoming).abs() + POINT_ROUNDINGS * normal.abs().dot(point.abs())
}

/// The most that [`blur`] can be, whichever way the surface lies.
pub(super) fn widest_blur(boundary: &Boundary, incoming: DVec3, point: DVec3) -> f64 {
    boundary.error * incoming.length() + POINT_ROUNDINGS * point.abs().element_sum()
}

impl Departure {
    /// Leaving `surface`, which was hit along `incoming`, in the given direction.
    #[must_use]
    pub fn new(surface: &Surface, incoming: DVec3, direction: DVec3) -> Self {
        let sense = match (surface.sense, direction.dot(surface.n_geometric) > 0.0) {
            (Sense::Touch, _) => Sense::Touch,
            (_, true) => Sense::Leave,
            (_, false) => Sense::Enter,
        };
        let (boundary, normal) = (surface.boundary, surface.n_geometric);
        let blur = blur(&boundary, incoming, normal, surface.point);
        Self { object: surface.object, boundary, sense, normal, blur }
    }

    /// Whether nothing of the object can lie ahead: the ray goes out of a convex solid, or has touched a flat surface.
    #[must_use]
    pub fn is_for_good(&self, solid: &Solid) -> bool {
        self.sense != Sense::Enter && solid.is_convex()
    }

    /// What lies ahead of the ray in the object that it started on; `list_from` gives all boundaries from an origin.
    #[must_use]
    pub fn ahead(
        &self,
        solid: &Solid,
        [origin, direction]: [DVec3; 2],
        list: &IntervalList,
        list_from: impl FnOnce(DVec3) -> IntervalList,
    ) -> Ahead {
        if solid.is_convex() && self.sense == Sense::Enter && !list.starts_inside() && !list.is_empty() {
            return Ahead::behind(0, list);
        }
        let first = self.behind_start(solid, [origin, direction], list);
        if self.is_for_good(solid) {
            return Ahead { departed: first.departed, ..Ahead::default() };
        }
        if self.agrees(&first) {
            return first;
        }
        let by = 2.0 * self.blur;
        let start = if self.sense == Sense::Leave { origin + self.normal * by } else { origin - self.normal * by };
        let list = list_from(start);
        let second = Ahead { moved: Some(by), ..self.behind_start(solid, [start, direction], &list) };
        if self.agrees(&second) { second } else { self.turned_back(second) }
    }

    /// The boundaries behind the one that the ray started on; where that is not among them, those behind t = 0.
    fn behind_start(&self, solid: &Solid, [origin, direction]: [DVec3; 2], list: &IntervalList) -> Ahead {
        let start = (0..list.crossed().len())
            .filter(|&k| list.sense(k) == self.sense && self.is_start(solid, [origin, direction], &list.crossed()[k]))
            .min_by(|&a, &b| list.crossed()[a].t.abs().total_cmp(&list.crossed()[b].t.abs()));
        match start {
            Some(start) => Ahead::behind(start, list),
            None => Ahead::of(list),
        }
    }

    /// Whether a boundary may be where the ray started.
    fn is_start(&self, solid: &Solid, [origin, direction]: [DVec3; 2], boundary: &Boundary) -> bool {
        let normal = solid.normal(boundary, origin + direction * boundary.t);
        let slope = normal.dot(direction).abs();
        boundary.t.abs() * slope <= 4.0 * self.blur + boundary.error * slope
    }

    /// What lies ahead of the ray in another object, which may have a boundary in the same place. Whether the ray is inside
    /// it behind that boundary is known from what it crossed, and says on which side of the start the boundary belongs.
    #[must_use]
    pub fn ahead_in_neighbour(
        &self,
        solid: &Solid,
        line: [DVec3; 2],
        list: &IntervalList,
        is_inside: bool,
        list_from: impl FnOnce(DVec3) -> IntervalList,
    ) -> Ahead {
        let first = self.on_known_side(solid, line, list, is_inside);
        if first.list.starts_inside() == is_inside {
            return first;
        }
        let by = 2.0 * self.blur;
        let [origin, direction] = line;
        let start = origin + self.normal * by.copysign(self.normal.dot(direction));
        let second = self.on_known_side(solid, [start, direction], &list_from(start), is_inside);
        if second.list.starts_inside() == is_inside { Ahead { moved: Some(by), ..second } } else { first }
    }

    /// The boundaries in front, with the one that is next to the start counted if it is still to come and left out if not.
    fn on_known_side(&self, solid: &Solid, line: [DVec3; 2], list: &IntervalList, is_inside: bool) -> Ahead {
        let ahead = Ahead::of(list);
        if ahead.list.starts_inside() == is_inside || list.ends().is_empty() {
            return ahead;
        }
        let next = list.ends().iter().take_while(|boundary| boundary.t <= 0.0).count();
        let is_near = |place: &usize| list.ends().get(*place).is_some_and(|end| self.is_start(solid, line, end));
        let candidates = [Some(next), next.checked_sub(1)].into_iter().flatten().filter(is_near);
        let start = candidates.min_by(|&a, &b| list.ends()[a].t.abs().total_cmp(&list.ends()[b].t.abs()));
        match start {
            Some(start) if start == next => Ahead::behind(start, list),
            Some(start) => {
                let mut still_to_come = list.after(next);
                still_to_come.begin_with(Boundary { t: 0.0, ..list.ends()[start] });
                Ahead { list: still_to_come, ..ahead }
            }
            None => ahead,
        }
    }

    /// Whether the boundaries ahead say that the ray is on the side to which it left.
    fn agrees(&self, ahead: &Ahead) -> bool {
        self.sense == Sense::Touch || ahead.list.starts_inside() == (self.sense == Sense::Enter)
    }

    /// Puts a ray right that rounding has set down on the wrong side of the boundary.
    fn turned_back(&self, mut ahead: Ahead) -> Ahead {
        ahead.list.begin_with(Boundary { t: 0.0, ..self.boundary });
        ahead
    }
}

impl Ahead {
    /// All boundaries behind the one that was left.
    fn behind(start: usize, list: &IntervalList) -> Self {
        Self { departed: Some(list.crossed()[start]), list: list.after(start + 1), moved: None }
    }

    /// All boundaries in front of the start of a ray that did not start on the object.
    #[must_use]
    pub fn of(list: &IntervalList) -> Self {
        Self { departed: None, list: list.in_front(), moved: None }
    }

    /// Tells of a start that had to be moved.
    pub(super) fn report(&self, object: &Object, recorder: &mut impl Recorder) {
        if let Some(by) = self.moved {
            recorder.note(|| Entry::new(What::Moved { object: object.name.clone(), by }));
        }
    }

    /// The surfaces that dim light on its way to `limit`. A way that lies inside as a whole crosses none; it is dimmed once,
    /// by what it lies inside of: by the boundary behind the light, or by nothing that is known.
    pub fn surfaces(&self, limit: f64) -> impl Iterator<Item = Option<&Boundary>> {
        let crossed = self.list.crossed().iter().take_while(move |boundary| boundary.t < limit);
        let confined = self.list.starts_inside() && crossed.clone().next().is_none();
        let around = self.list.crossed().first();
        confined.then_some(around).into_iter().chain(crossed.map(Some))
    }
}
