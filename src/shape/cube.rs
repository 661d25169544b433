//! The cube [−1, 1]³ by its plane table (§ 6.2.3).
//!
//! **Shape**
//! ```text
//!          y ↑  top
//!       +----|----+
//!      /|    |   /|
//!     +---------+ |      right: x = 1, left: x = −1
//!     | |    o--|-|--→ x top: y = 1, bottom: y = −1
//!     | +--/----|-+      front: z = 1, back: z = −1
//!     |/  z     |/
//!     +---------+
//! ```
//! **Equation** F = max(|x|, |y|, |z|) − 1.
//!
//! **Ray equation** For each plane m·p = m·spot: t = m·(spot − S) / m·c, entering where m·c < 0. The ray is inside from
//! the latest entering to the earliest leaving time.
//!
//! **Accuracy** Two roundings a plane, so 2u relative in t, at any distance. A hit is certain where the point halfway between
//! the two times is surely inside, a miss where one face is surely entered after another was left. Rays through edges and
//! corners leave both open, and decide by the order of nearly equal times; see the header of `planes.rs`.
//!
//! **Degenerate cases** A ray in a face runs inside the closed cube and has its two hits on other faces. A ray that only
//! touches an edge or a corner has none.
//!
//! **Source** Hill, Computer Graphics Using OpenGL, the generic cube; Williams et al., JGT 10(1), 2005, on the cases of
//! zero and signed zero in c.

use super::boundary::{Boundaries, Root};
use super::solver::{self, Attempt, Call, Solver};
use super::{Approach, Bounds, Crossing, Crossings, GenericRay, HalfSpace, Part, Primitive, plane_table};
use crate::math::{Pair, Real};
use crate::record::{Candidate, Entry, Recorder};
use glam::{DVec2, DVec3};

/// The cube from −1 to 1 in x, y and z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cube;

/// The six planes in the order of the plane table.
const PLANES: [HalfSpace; 6] = [
    HalfSpace { normal: DVec3::Y, offset: 1.0 },
    HalfSpace { normal: DVec3::NEG_Y, offset: 1.0 },
    HalfSpace { normal: DVec3::X, offset: 1.0 },
    HalfSpace { normal: DVec3::NEG_X, offset: 1.0 },
    HalfSpace { normal: DVec3::Z, offset: 1.0 },
    HalfSpace { normal: DVec3::NEG_Z, offset: 1.0 },
];

/// Their names.
const NAMES: [&str; 6] = ["top", "bottom", "right", "left", "front", "back"];

impl Cube {
    /// The generic cube.
    ///
    /// # Errors
    /// None: it has no parameters.
    pub const fn new() -> Result<Self, String> {
        Ok(Self)
    }
}

/// The stretch of the ray between the three pairs of parallel faces.
pub(super) struct Passage<A> {
    enter: Slab<A>,
    leave: Slab<A>,
    hits: bool,
}

/// The latest entering or earliest leaving time, and the axis across which it passes a face.
#[derive(Clone, Copy)]
struct Slab<A> {
    axis: usize,
    time: A,
}

impl<A: Real> Slab<A> {
    /// How far the coordinate moves when S and c are off by one part in one.
    #[inline]
    fn way(self, ray: &GenericRay<A>) -> f64 {
        ray.origin_size[self.axis] + self.time.abs().to_f64() * ray.direction_size[self.axis]
    }

    /// |c| along the axis.
    #[inline]
    fn speed(self, ray: &GenericRay<A>) -> f64 {
        ray.direction[self.axis].abs().to_f64()
    }

    /// How far the time moves when S and c are off by one part in one.
    #[inline]
    fn moved(self, ray: &GenericRay<A>) -> f64 {
        self.way(ray) / self.speed(ray)
    }

    /// The face through which the ray goes there.
    #[inline]
    fn part(self, ray: &GenericRay<A>, enters: bool) -> Part {
        let is_positive = (ray.direction[self.axis] < A::ZERO) == enters;
        Cube::FACES[self.axis][usize::from(is_positive)]
    }
}

impl<A: Real> Passage<A> {
    /// From the last time at which the ray enters a pair of faces to the first at which it leaves one.
    #[inline]
    fn new(ray: &GenericRay<A>) -> Self {
        let [x, y, z] = [times(ray, 0), times(ray, 1), times(ray, 2)];
        let (enter, leave) = (x[0].max(y[0]).max(z[0]), x[1].min(y[1]).min(z[1]));
        let axis = |is_on: [bool; 2]| match is_on {
            [true, _] => 0,
            [_, true] => 1,
            _ => 2,
        };
        let enter = Slab { axis: axis([x[0] >= enter, y[0] >= enter]), time: enter };
        let leave = Slab { axis: axis([x[1] <= leave, y[1] <= leave]), time: leave };
        Self { enter, leave, hits: enter.time < leave.time }
    }

    /// Whether no rounding error could turn a hit into a miss, or a miss into a hit.
    ///
    /// A hit is beyond doubt where the point halfway between the two times is. Whatever the ray does not enter or leave first
    /// need not be known for that, nor for a miss.
    #[inline]
    fn is_beyond_doubt(&self, ray: &GenericRay<A>) -> bool {
        let Self { enter, leave, hits } = *self;
        let doubt = 4.0 * A::UNIT_ROUNDOFF;
        if hits {
            let middle = A::from_f64(0.5) * (enter.time + leave.time);
            let (point, sway) = (ray.at(middle), ray.sway(middle.to_f64()));
            let is_within = |axis: usize| point[axis].abs().to_f64() + doubt * sway[axis] < 1.0;
            // All three at once: it is hardly ever the first that decides.
            is_within(0) & is_within(1) & is_within(2)
        } else {
            let moves = |slab: Slab<A>| is_moving(ray, slab.axis);
            let doubt = doubt * (enter.moved(ray) + leave.moved(ray));
            moves(enter) && moves(leave) && (enter.time - leave.time).to_f64() > doubt
        }
    }
}

/// When the ray enters and leaves the pair of faces across an axis; where it does not move these may be anything.
#[inline]
fn times<A: Real>(ray: &GenericRay<A>, axis: usize) -> [A; 2] {
    let [a, b] = ((Pair([-A::ONE, A::ONE]) - ray.origin[axis]) / ray.direction[axis]).0;
    [a.min(b), a.max(b)]
}

/// Whether c is more than rounding along an axis.
#[inline]
fn is_moving<A: Real>(ray: &GenericRay<A>, axis: usize) -> bool {
    ray.direction[axis].abs().to_f64() > 4.0 * A::UNIT_ROUNDOFF * ray.direction_size[axis]
}

/// All pairs of faces, with the errors of all times: for rays of which a closer look has to be taken.
struct CloseLook<A> {
    passage: Passage<A>,
    decided: bool,
    /// Bound on the error of the time between the two.
    doubt: f64,
    beside: Beside,
}

impl<A: Real> CloseLook<A> {
    #[cold]
    fn new(ray: &GenericRay<A>) -> Self {
        let infinity = A::from_f64(f64::INFINITY);
        let (mut enter, mut leave) = (Slab { axis: 0, time: -infinity }, Slab { axis: 0, time: infinity });
        // The first and the last time at which it may enter last, and those at which it may leave first.
        let (mut in_low, mut in_high, mut out_low, mut out_high) = (-infinity, -infinity, infinity, infinity);
        let (mut beside, mut cancels) = (Beside::NONE, false);
        for axis in 0..3 {
            let (s, c) = (ray.origin[axis], ray.direction[axis]);
            if !is_moving(ray, axis) {
                let room = (A::ONE - s.abs()).to_f64();
                beside = beside.or_closer(axis, room, 4.0 * A::UNIT_ROUNDOFF * ray.origin_size[axis]);
                // What is zero only by cancellation is not known to be zero.
                cancels |= ray.direction_size[axis] > 0.0;
                continue;
            }
            let [near, far] = times(ray, axis);
            let farthest = near.abs().max(far.abs()).to_f64();
            let moved = ray.origin_size[axis] + farthest * ray.direction_size[axis];
            let error = A::from_f64(4.0 * A::UNIT_ROUNDOFF * moved) / c.abs();
            if near > enter.time {
                enter = Slab { axis, time: near };
            }
            if far < leave.time {
                leave = Slab { axis, time: far };
            }
            (in_low, in_high) = (in_low.max(near - error), in_high.max(near + error));
            (out_low, out_high) = (out_low.min(far - error), out_high.min(far + error));
        }
        let surely = in_high < out_low;
        let between = if A::DOUBT_IS_ZERO { surely } else { enter.time < leave.time };
        let decided = (surely || in_low > out_high) && beside.is_beyond_doubt() && !cancels;
        let hits = between && (beside.room >= 0.0 || A::DOUBT_IS_ZERO && !beside.is_beyond_doubt());
        let doubt = (in_high - enter.time + (leave.time - out_low)).to_f64();
        Self { passage: Passage { enter, leave, hits }, decided, doubt, beside }
    }
}

/// 1 − |S| across the axis along which the ray does not move, where that is smallest.
#[derive(Clone, Copy)]
struct Beside {
    axis: usize,
    room: f64,
    doubt: f64,
}

impl Beside {
    /// The ray moves along every axis.
    const NONE: Self = Self { axis: 0, room: f64::INFINITY, doubt: 0.0 };

    fn is_beyond_doubt(&self) -> bool {
        self.room.abs() > self.doubt
    }

    fn or_closer(self, axis: usize, room: f64, doubt: f64) -> Self {
        if room < self.room { Self { axis, room, doubt } } else { self }
    }
}

impl Cube {
    /// The face on the negative and on the positive side of each axis.
    const FACES: [[Part; 2]; 3] = [[3, 2], [1, 0], [5, 4]];
}

impl Solver for Cube {
    type Found<A: Real> = Passage<A>;

    #[inline]
    fn solve<A: Real>(&self, ray: &GenericRay<A>) -> Attempt<Passage<A>> {
        let passage = Passage::new(ray);
        if passage.is_beyond_doubt(ray) {
            return Attempt { found: passage, decided: true };
        }
        let CloseLook { passage, decided, .. } = CloseLook::new(ray);
        Attempt { found: passage, decided }
    }

    fn closest_call<A: Real>(&self, ray: &GenericRay<A>, _: &Passage<A>) -> Call {
        let CloseLook { passage: Passage { enter, leave, .. }, doubt, beside, .. } = CloseLook::new(ray);
        let order = Call {
            question: "Does the ray enter the last face before it leaves the first?",
            value: (leave.time - enter.time).to_f64(),
            doubt,
            input_doubt: f64::UNIT_ROUNDOFF * (enter.moved(ray) + leave.moved(ray)),
            near: 0.5 * (enter.time + leave.time).to_f64(),
        };
        let side = Call {
            question: "Does the ray run between the faces that it does not approach?",
            value: beside.room,
            doubt: beside.doubt,
            input_doubt: f64::UNIT_ROUNDOFF * ray.origin_size[beside.axis],
            near: order.near,
        };
        order.closer(side)
    }

    #[inline]
    fn roots<A: Real>(&self, ray: &GenericRay<A>, passage: &Passage<A>) -> impl Boundaries {
        let Passage { enter, leave, hits } = *passage;
        hits.then(|| {
            let ends = Pair([enter, leave]);
            let moved = ends.map(|end| end.way(ray)).with(ends.map(|end| end.speed(ray)), |way, speed| way / speed);
            let root = |end: Slab<A>, moved: f64, enters: bool| {
                let tau = end.time.to_f64();
                Root { tau, error: ray.error_of_time(moved, tau), part: end.part(ray, enters) }
            };
            [root(enter, moved.0[0], true), root(leave, moved.0[1], false)]
        })
    }

    fn working<A: Real>(&self, ray: &GenericRay<A>, _: &Passage<A>) -> Vec<Entry> {
        vec![plane_table::table(&PLANES, &self.parts(), ray)]
    }

    fn rejected<A: Real>(&self, ray: &GenericRay<A>, _: &Passage<A>, crossings: &[Crossing]) -> Vec<Candidate> {
        plane_table::rejected(self, &PLANES, ray, crossings)
    }
}

impl Primitive for Cube {
    #[inline]
    fn crossings<A: Real>(&self, ray: &GenericRay<A>, recorder: &mut impl Recorder, crossings: &mut Crossings) {
        solver::crossings(self, ray, recorder, crossings);
    }

    #[inline]
    fn first_crossing<A: Real>(&self, approach: &impl Approach) -> Option<Crossing> {
        solver::first_crossing::<A>(self, approach)
    }

    fn normal(&self, _point: DVec3, part: Part) -> DVec3 {
        PLANES.get(usize::from(part)).map_or(DVec3::Y, |plane| plane.normal)
    }

    /// Each face seen from outside, u to the right and v up; the top and bottom with the front below and above.
    fn uv(&self, point: DVec3, part: Part) -> DVec2 {
        let DVec3 { x, y, z } = point;
        let (right, up) = match part {
            0 => (x, -z),
            1 => (x, z),
            2 => (-z, y),
            3 => (z, y),
            4 => (x, y),
            _ => (-x, y),
        };
        ((DVec2::new(right, up) + 1.0) * 0.5).clamp(DVec2::ZERO, DVec2::ONE)
    }

    fn tangents(&self, _point: DVec3, part: Part) -> [DVec3; 2] {
        let [x, y, z] = [DVec3::X, DVec3::Y, DVec3::Z].map(|axis| axis * 2.0);
        match part {
            0 => [x, -z],
            1 => [x, z],
            2 => [-z, y],
            3 => [z, y],
            4 => [x, y],
            _ => [-x, y],
        }
    }

    fn is_flat(&self, _part: Part) -> bool {
        true
    }

    fn bounds(&self) -> Bounds {
        Bounds { low: DVec3::NEG_ONE, high: DVec3::ONE }
    }

    /// Front, back, and the four edges between.
    fn outline(&self) -> Vec<Vec<DVec3>> {
        let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
        let ring = |z| (0..5).map(|k: usize| corners[k % 4]).map(|(x, y)| DVec3::new(x, y, z)).collect();
        let edges = corners.map(|(x, y)| vec![DVec3::new(x, y, -1.0), DVec3::new(x, y, 1.0)]);
        [ring(1.0), ring(-1.0)].into_iter().chain(edges).collect()
    }

    fn implicit(&self, point: DVec3) -> f64 {
        point.abs().max_element() - 1.0
    }

    fn equation(&self) -> String {
        "max(|x|, |y|, |z|) − 1".to_owned()
    }

    fn parts(&self) -> Vec<String> {
        NAMES.map(str::to_owned).to_vec()
    }
}

#[cfg(test)]
mod tests {
    use super::super::testing::*;
    use super::*;
    use crate::record::{PlaneSense, What};

    impl Samples for Cube {
        fn samples() -> Vec<Self> {
            vec![Self::new().unwrap()]
        }
    }

    #[test]
    fn hit_behind_and_inside() {
        expect(&Cube, [-3.0, 0.5, 0.0], [1.0, 0.0, 0.0], &[(2.0, Enter, "left"), (4.0, Leave, "right")]);
        expect(&Cube, [-3.0, 0.5, 0.0], [-2.0, 0.0, 0.0], &[(-2.0, Enter, "right"), (-1.0, Leave, "left")]);
        expect(&Cube, [0.0, 0.0, 0.5], [0.0, 0.0, 1.0], &[(-1.5, Enter, "back"), (0.5, Leave, "front")]);
        expect(&Cube, [0.0, 2.0, 0.0], [0.0, -1.0, 0.0], &[(1.0, Enter, "top"), (3.0, Leave, "bottom")]);
    }

    #[test]
    fn a_ray_that_touches_an_edge_or_a_corner_has_no_hits() {
        expect(&Cube, [2.0, 0.0, 0.0], [-1.0, 1.0, 0.0], &[]);
        expect(&Cube, [2.0, 0.0, 1.0], [-1.0, 1.0, 0.0], &[]);
    }

    #[test]
    fn a_ray_in_a_face_runs_inside_the_closed_cube() {
        expect(&Cube, [-3.0, 1.0, 0.25], [1.0, 0.0, 0.0], &[(2.0, Enter, "left"), (4.0, Leave, "right")]);
        expect(&Cube, [-3.0, 1.0_f64.next_up(), 0.25], [1.0, 0.0, 0.0], &[]);
    }

    #[test]
    fn the_plane_table_is_filled_in_as_on_paper() {
        let (reports, hits) = record(&Cube, DVec3::new(-3.0, 1.5, 0.0), DVec3::new(2.0, -1.0, 0.25));
        let What::Planes { rows, stopped } = &reports[0] else { panic!("{reports:?}") };
        let (entering, leaving) = (PlaneSense::Entering, PlaneSense::Leaving);
        let expected = [
            ("top", -0.5, -1.0, 0.5, entering, Some(0.5), None),
            ("bottom", 2.5, 1.0, 2.5, leaving, Some(0.5), Some(2.5)),
            ("right", 4.0, 2.0, 2.0, leaving, Some(0.5), Some(2.0)),
            ("left", -2.0, -2.0, 1.0, entering, Some(1.0), Some(2.0)),
            ("front", 1.0, 0.25, 4.0, leaving, Some(1.0), Some(2.0)),
            ("back", 1.0, -0.25, -4.0, entering, Some(1.0), Some(2.0)),
        ];
        assert_eq!(rows.len(), 6);
        for (number, (row, (name, numerator, denominator, t, sense, t_in, t_out))) in
            rows.iter().zip(expected).enumerate()
        {
            assert_eq!((row.plane, row.name.as_str()), (number, name));
            assert_eq!((row.numerator, row.denominator, row.t), (numerator, denominator, Some(t)));
            assert_eq!((row.sense, row.t_in, row.t_out), (sense, t_in, t_out));
        }
        assert_eq!(*stopped, None);
        assert_eq!(hits.iter().map(|hit| hit.t).collect::<Vec<_>>(), [1.0, 2.0]);
    }

    #[test]
    fn the_table_stops_as_soon_as_the_ray_leaves_before_it_enters() {
        // Top is entered at 8, right is left at 4.
        let (reports, hits) = record(&Cube, DVec3::new(-3.0, 3.0, 0.0), DVec3::new(1.0, -0.25, 0.0));
        let What::Planes { rows, stopped } = &reports[0] else { panic!("{reports:?}") };
        assert_eq!(rows.len(), 3);
        assert_eq!(stopped.as_deref(), Some("t_in = 8 > t_out = 4, so the ray misses"));
        assert!(hits.is_empty());
    }

    #[test]
    fn the_table_stops_at_a_plane_that_the_ray_runs_beside_outside() {
        let (reports, _) = record(&Cube, DVec3::new(-3.0, 2.0, 0.0), DVec3::X);
        let What::Planes { rows, stopped } = &reports[0] else { panic!("{reports:?}") };
        assert_eq!((rows.len(), rows[0].sense, rows[0].t), (1, PlaneSense::ParallelOutside, None));
        assert_eq!(stopped.as_deref(), Some("the ray runs beside top on its outside, so it misses"));
    }

    #[test]
    fn faces_are_upright_from_outside() {
        assert_eq!(Cube.uv(DVec3::new(1.0, 1.0, 1.0), 4), DVec2::ONE);
        assert_eq!(Cube.uv(DVec3::new(1.0, 1.0, 1.0), 2), DVec2::new(0.0, 1.0));
        assert_eq!(Cube.uv(DVec3::new(-1.0, 1.0, 1.0), 0), DVec2::ZERO);
    }
}
