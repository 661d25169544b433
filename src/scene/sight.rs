//! What may be seen from a point, cell by cell: projection extents (§ 6.5.4) sorted into a grid over the image plane.
//!
//! A ray from the eye needs to ask only the objects whose rectangles overlap its cell, the nearest first. A light is an eye
//! as well: six image planes around it make a cube, and the objects in the cell in which it sees a point are all that
//! can cast a shadow there.
//!
//! **Source** E. Haines, D. Greenberg, "The light buffer: a shadow-testing accelerator", IEEE Computer Graphics and
//! Applications 6(9), 1986; the vista buffer is the same idea for the eye.

use super::projection::{Blur, View};
use super::{Camera, Light, LightKind, Object, ObjectIndex, Projection, Scene};
use crate::csg::{Ball, Course};
use glam::{DVec2, DVec3};

/// An object that may be seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Candidate {
    /// Its rectangle.
    pub projection: Projection,
    /// Its ball, where that is worthwhile.
    ball: Option<Ball>,
    /// No point of it is nearer, measured along the view.
    pub depth: f64,
    /// Its place in the object list.
    pub object: usize,
}

impl Candidate {
    /// None where the object is wholly behind the eye or beside the rectangle from −`half` to `half`.
    fn new(
        view: View,
        half: DVec2,
        objects: &[Object],
        index: &ObjectIndex,
        object: usize,
        blur: Blur,
    ) -> Option<Self> {
        let camera = view.camera;
        let corners = objects[object].solid.hull();
        let depths = corners.map(|corner| (corner - camera.eye).dot(camera.forward));
        let error = corners.iter().map(|&corner| blur.at(corner)).fold(0.0, f64::max);
        let [nearest, farthest] = depths
            .iter()
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], &depth| [low.min(depth), high.max(depth)]);
        let projection = Projection::new(view, &corners, blur);
        let picture = Projection { low: -half, high: half, slides: [0.0; 2] };
        let is_seen = farthest >= -error && projection.slid_all_ways(view.radius()).meets(&picture);
        is_seen.then_some(Self { projection, ball: index.balls[object], depth: nearest - error, object })
    }

    /// Whether a ray may meet it; `holds` says whether a rectangle holds the place of that ray. A ball tells more than a
    /// rectangle, and one answer is guessed wrong less often than two.
    #[must_use]
    #[inline(always)]
    #[expect(clippy::inline_always, reason = "measured: asked of every candidate")]
    pub fn may_be_met(&self, course: &Course, holds: impl FnOnce(&Projection) -> bool) -> bool {
        match &self.ball {
            Some(ball) => !course.passes_by(ball),
            None => holds(&self.projection),
        }
    }
}

/// A rectangle of the image plane at distance 1, and within it one that holds all that is seen, cut into cells.
#[derive(Clone, Debug, PartialEq)]
pub struct Sight {
    /// The whole rectangle reaches from minus this to this.
    half: DVec2,
    /// The corners of the one that is cut into cells.
    low: DVec2,
    high: DVec2,
    cells_per_unit: DVec2,
    columns: usize,
    rows: usize,
    /// The radius of the lens that is looked through; 0 for a pinhole.
    radius: f64,
    /// The nearest first.
    candidates: Vec<Candidate>,
    /// Where each cell's list begins, and where the last one's ends; then once more, for a list of nothing.
    starts: Vec<u32>,
    /// For each cell the places of its candidates, ascending.
    lists: Vec<u32>,
}

/// Cells for each object. Fewer put objects into one cell that are not behind one another; more take longer to fill than
/// they save.
const CELLS_PER_OBJECT: usize = 8;

/// Cells at least, and at most: a few objects fill few of many cells, and the grid should stay in the cache.
const CELLS: [usize; 2] = [1 << 10, 1 << 18];

/// Entries for each object above which the cells are made larger: objects that fill the view are in all of them.
const ENTRIES_PER_OBJECT: usize = 64;

impl Sight {
    /// What of the bounded objects is seen in the rectangle from −`half` to `half`.
    #[must_use]
    pub fn new(view: View, half: DVec2, objects: &[Object], index: &ObjectIndex, blur: Blur) -> Self {
        let bounded = index.bounded.iter();
        let mut candidates: Vec<Candidate> =
            bounded.filter_map(|&object| Candidate::new(view, half, objects, index, object, blur)).collect();
        candidates.sort_by(|a, b| a.depth.total_cmp(&b.depth));
        let most = ENTRIES_PER_OBJECT * index.bounded.len() + CELLS[0];
        let mut wanted = (candidates.len() * CELLS_PER_OBJECT).clamp(CELLS[0], CELLS[1]);
        let mut sight = Self::empty(half, wanted, candidates, view.radius());
        while wanted > 1 && sight.entries() > most {
            wanted /= 4;
            sight = Self::empty(half, wanted, sight.candidates, view.radius());
        }
        sight.fill();
        sight
    }

    /// The candidates in the cell of a place, the nearest first; none where the place lies outside the rectangle.
    #[must_use]
    #[inline(always)]
    #[expect(clippy::inline_always, reason = "measured: what it returns is large")]
    pub fn around(&self, place: [f64; 2]) -> Option<impl Iterator<Item = &Candidate>> {
        let place = DVec2::from_array(place);
        let is_within = |low: DVec2, high: DVec2| place.cmpge(low).all() && place.cmple(high).all();
        let cell = if is_within(self.low, self.high) {
            let [column, row] = self.cell(place);
            Self::index(column, self.columns) + Self::index(row, self.rows) * self.columns
        } else if is_within(-self.half, self.half) {
            self.columns * self.rows
        } else {
            return None;
        };
        let list = &self.lists[self.starts[cell] as usize..self.starts[cell + 1] as usize];
        Some(list.iter().map(|&k| &self.candidates[k as usize]))
    }

    /// About so many cells, none of them filled.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 1 and the most cells")]
    fn empty(half: DVec2, wanted: usize, candidates: Vec<Candidate>, radius: f64) -> Self {
        let [low, high] = all_seen(half, &candidates, radius);
        let (wanted, size) = (wanted as f64, high - low);
        let columns = (wanted * size.x / size.y).sqrt().clamp(1.0, wanted).round();
        let rows = (wanted / columns).max(1.0).round();
        let cells_per_unit = DVec2::new(columns, rows) / size;
        let (columns, rows) = (columns as usize, rows as usize);
        let (starts, lists) = (Vec::new(), Vec::new());
        Self { half, low, high, cells_per_unit, columns, rows, radius, candidates, starts, lists }
    }

    /// A place in units of cells.
    fn cell(&self, place: DVec2) -> [f64; 2] {
        ((place - self.low) * self.cells_per_unit).to_array()
    }

    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "the cast of a float saturates")]
    fn index(cell: f64, count: usize) -> usize {
        (cell as usize).min(count - 1)
    }

    /// The first and last column and row that a rectangle overlaps. Rounding cannot lose one: a place is taken to its cell
    /// by the same sum, which is monotonic.
    fn overlapped(&self, projection: &Projection) -> [[usize; 2]; 2] {
        let projection = projection.slid_all_ways(self.radius);
        let (low, high) = (self.cell(projection.low), self.cell(projection.high));
        let range = |axis: usize, count| [Self::index(low[axis], count), Self::index(high[axis], count)];
        [range(0, self.columns), range(1, self.rows)]
    }

    fn entries(&self) -> usize {
        let count = |candidate: &Candidate| {
            let [[left, right], [bottom, top]] = self.overlapped(&candidate.projection);
            (right - left + 1) * (top - bottom + 1)
        };
        self.candidates.iter().map(count).sum()
    }

    /// Sorts the candidates into their cells; each cell keeps their order.
    fn fill(&mut self) {
        let mut starts = vec![0_u32; self.columns * self.rows + 2];
        self.for_each_entry(|cell, _| starts[cell + 1] += 1);
        for cell in 1..starts.len() {
            starts[cell] += starts[cell - 1];
        }
        let mut lists = vec![0_u32; starts.last().map_or(0, |&end| end as usize)];
        let mut next = starts.clone();
        self.for_each_entry(|cell, candidate| {
            lists[next[cell] as usize] = candidate;
            next[cell] += 1;
        });
        (self.starts, self.lists) = (starts, lists);
    }

    fn for_each_entry(&self, mut visit: impl FnMut(usize, u32)) {
        for (k, candidate) in (0_u32..).zip(&self.candidates) {
            let [[left, right], [bottom, top]] = self.overlapped(&candidate.projection);
            for row in bottom..=top {
                (left..=right).for_each(|column| visit(column + row * self.columns, k));
            }
        }
    }
}

/// The corners of the part of the rectangle from −`half` to `half` that the candidates can be seen in; of all of it where that
/// part has no area.
fn all_seen(half: DVec2, candidates: &[Candidate], radius: f64) -> [DVec2; 2] {
    let corners = candidates.iter().map(|candidate| candidate.projection.slid_all_ways(radius));
    let none = [DVec2::INFINITY, DVec2::NEG_INFINITY];
    let [low, high] = corners.fold(none, |[low, high], seen| [low.min(seen.low), high.max(seen.high)]);
    let (low, high) = (low.max(-half), high.min(half));
    if low.cmplt(high).all() { [low, high] } else { [-half, half] }
}

/// What a point light sees, all around.
#[derive(Clone, Debug, PartialEq)]
pub struct LightSight {
    position: DVec3,
    /// Towards −x, x, −y, y, −z and z.
    faces: [Sight; 6],
    /// Bound on the coordinates of points for which it is right.
    reach: f64,
}

/// How much further than the objects and the light themselves shaded points may lie. More would blur rectangles near the
/// light; points that are further out (on a plane's horizon) ask the hierarchy.
const REACH: f64 = 256.0;

impl LightSight {
    /// The six grids around a light.
    #[must_use]
    pub fn new(position: DVec3, objects: &[Object], index: &ObjectIndex) -> Self {
        let size = index.bounded.iter().fold(position.abs().max_element(), |size, &object| {
            let extent = objects[object].solid.extent();
            size.max(extent.low.abs().max_element()).max(extent.high.abs().max_element())
        });
        let reach = size * REACH;
        let blur = Blur { skew: index.skew, reach };
        let face = |k: usize| {
            let camera = face(position, k);
            Sight::new(View { camera: &camera, lens: None }, DVec2::ONE, objects, index, blur)
        };
        Self { position, faces: std::array::from_fn(face), reach }
    }

    /// The objects that may stand between the light and a point, seen along the ray from the point to the light. None where that is
    /// not known.
    #[must_use]
    #[inline(always)]
    #[expect(clippy::inline_always, reason = "measured: what it returns is large")]
    pub fn before(&self, point: DVec3, course: &Course) -> Option<impl Iterator<Item = &Candidate>> {
        let offset = point - self.position;
        let sizes = offset.abs();
        let axis = if sizes.x >= sizes.y && sizes.x >= sizes.z { 0 } else { 1 + usize::from(sizes.z > sizes.y) };
        let depth = sizes[axis];
        let place = [offset[(axis + 1) % 3] / depth, offset[(axis + 2) % 3] / depth];
        let is_known = depth > 0.0 && point.abs().max_element() <= self.reach;
        let face = &self.faces[2 * axis + usize::from(offset[axis] > 0.0)];
        let seen = if is_known { face.around(place)? } else { return None };
        let seen = seen.take_while(move |candidate| candidate.depth <= depth);
        Some(seen.filter(move |seen| seen.may_be_met(course, |projection| projection.holds(place))))
    }
}

/// The camera that looks at a face of the cube around a light.
fn face(eye: DVec3, k: usize) -> Camera {
    let axis = k / 2;
    let forward = if k.is_multiple_of(2) { -DVec3::AXES[axis] } else { DVec3::AXES[axis] };
    Camera { eye, right: DVec3::AXES[(axis + 1) % 3], up: DVec3::AXES[(axis + 2) % 3], forward, half_height: 1.0 }
}

/// What the eye and the lights of a scene see.
#[derive(Clone, Debug, PartialEq)]
pub struct Sights {
    /// The picture.
    pub eye: Sight,
    /// For each light; none for a directional one.
    pub lights: Vec<Option<LightSight>>,
}

impl Sights {
    /// Looks at the scene from the eye and from all point lights.
    #[must_use]
    pub fn new(scene: &Scene) -> Self {
        let index = &scene.index;
        let view = View { camera: &scene.camera, lens: scene.lens.as_deref() };
        let blur = Blur { skew: index.skew, reach: view.reach() };
        let half = DVec2::from(scene.camera.half_size(scene.image));
        let of_light = |light: &Light| match light.kind {
            LightKind::Point(position) => Some(LightSight::new(position, &scene.objects, index)),
            LightKind::Directional(_) | LightKind::Area(_) => None,
        };
        Self {
            eye: Sight::new(view, half, &scene.objects, index, blur),
            lights: scene.lights.iter().map(of_light).collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{embedded_scenes, load};

    /// Places of which some lie in the cells, some beside them, and some outside the rectangle: steps that fill it evenly.
    fn places(half: DVec2) -> impl Iterator<Item = [f64; 2]> {
        let step = DVec2::new(0.754_877_666, 0.569_840_291);
        (0..500).map(move |k| ((step * f64::from(k)).fract() * 2.4 - 1.2) * half).map(|place| place.to_array())
    }

    fn agrees_with_every_rectangle(sight: &Sight) {
        for place in places(sight.half) {
            let is_known = DVec2::from_array(place).abs().cmple(sight.half).all();
            let objects = |seen: &mut dyn Iterator<Item = &Candidate>| {
                seen.filter(|seen| seen.projection.holds(place)).map(|seen| seen.object).collect::<Vec<_>>()
            };
            let expected = is_known.then(|| objects(&mut sight.candidates.iter()));
            let found = sight.around(place).map(|mut seen| objects(&mut seen));
            assert_eq!(found, expected, "at {place:?}");
        }
    }

    #[test]
    fn at_every_place_all_whose_rectangles_hold_it_are_found_the_nearest_first() {
        for embedded in embedded_scenes() {
            let sights = Sights::new(&load(embedded.text, &embedded.name).unwrap());
            agrees_with_every_rectangle(&sights.eye);
            sights.lights.iter().flatten().flat_map(|light| &light.faces).for_each(agrees_with_every_rectangle);
        }
    }
}
