//! What may be seen from a point, cell by cell: projection extents (§ 6.5.4) sorted into a grid over the image plane.
//!
//! A ray from the eye needs to ask only the objects whose rectangles overlap its cell, the nearest first. A light is an eye
//! as well: six image planes around it make a cube, and the objects in the cell in which it sees a point are all that
//! can cast a shadow there.
//!
//! **Source** E. Haines, D. Greenberg, "The light buffer: a shadow-testing accelerator", IEEE Computer Graphics and
//! Applications 6(9), 1986; the vista buffer is the same idea for the eye.

use super::projection::{Blur, View};
use super::{Camera, Light, LightKind, Object, Projection, Scene};
use glam::{DVec2, DVec3};

/// An object that may be seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Candidate {
    /// Its rectangle.
    pub projection: Projection,
    /// No point of it is nearer, measured along the view.
    pub depth: f64,
    /// Its place in the object list.
    pub object: usize,
}

impl Candidate {
    /// None where the object is wholly behind the eye or beside the rectangle from −`half` to `half`.
    fn new(view: View, half: DVec2, objects: &[Object], object: usize, blur: Blur) -> Option<Self> {
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
        is_seen.then_some(Self { projection, depth: nearest - error, object })
    }
}

/// A rectangle of the image plane at distance 1, cut into cells.
#[derive(Clone, Debug, PartialEq)]
pub struct Sight {
    low: DVec2,
    cells_per_unit: DVec2,
    columns: usize,
    rows: usize,
    /// The radius of the lens that is looked through; 0 for a pinhole.
    radius: f64,
    /// The nearest first.
    candidates: Vec<Candidate>,
    /// Where each cell's list begins, and where the last one's ends.
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
    /// The grid over the rectangle from −`half` to `half`, with the bounded objects in it.
    #[must_use]
    pub fn new(view: View, half: DVec2, objects: &[Object], bounded: &[usize], blur: Blur) -> Self {
        let mut candidates: Vec<Candidate> =
            bounded.iter().filter_map(|&object| Candidate::new(view, half, objects, object, blur)).collect();
        candidates.sort_by(|a, b| a.depth.total_cmp(&b.depth));
        let most = ENTRIES_PER_OBJECT * bounded.len() + CELLS[0];
        let mut wanted = (candidates.len() * CELLS_PER_OBJECT).clamp(CELLS[0], CELLS[1]);
        let mut sight = Self::empty(half, wanted, candidates, view.radius());
        while wanted > 1 && sight.entries() > most {
            wanted /= 4;
            sight = Self::empty(half, wanted, sight.candidates, view.radius());
        }
        sight.fill();
        sight
    }

    /// The candidates at a place, the nearest first; none where the place lies outside the grid.
    #[must_use]
    #[inline]
    pub fn at(&self, place: [f64; 2]) -> Option<impl Iterator<Item = &Candidate>> {
        Some(self.in_cell(place)?.filter(move |seen| seen.projection.holds(place)))
    }

    /// The same from a point of a lens.
    #[must_use]
    #[inline]
    pub fn through_lens(&self, place: [f64; 2], on_lens: [f64; 2]) -> Option<impl Iterator<Item = &Candidate>> {
        Some(self.in_cell(place)?.filter(move |seen| seen.projection.slid(on_lens).holds(place)))
    }

    /// The candidates in the cell of a place.
    #[inline]
    fn in_cell(&self, place: [f64; 2]) -> Option<impl Iterator<Item = &Candidate>> {
        let [column, row] = self.cell(DVec2::from_array(place));
        if !(column >= 0.0 && row >= 0.0 && column <= self.columns as f64 && row <= self.rows as f64) {
            return None;
        }
        let cell = Self::index(column, self.columns) + Self::index(row, self.rows) * self.columns;
        let list = &self.lists[self.starts[cell] as usize..self.starts[cell + 1] as usize];
        Some(list.iter().map(|&k| &self.candidates[k as usize]))
    }

    /// About so many cells, none of them filled.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 1 and the most cells")]
    fn empty(half: DVec2, wanted: usize, candidates: Vec<Candidate>, radius: f64) -> Self {
        let wanted = wanted as f64;
        let columns = (wanted * half.x / half.y).sqrt().clamp(1.0, wanted).round();
        let rows = (wanted / columns).max(1.0).round();
        let cells_per_unit = DVec2::new(columns, rows) / (2.0 * half);
        let (columns, rows) = (columns as usize, rows as usize);
        let (starts, lists) = (Vec::new(), Vec::new());
        Self { low: -half, cells_per_unit, columns, rows, radius, candidates, starts, lists }
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
        let mut starts = vec![0_u32; self.columns * self.rows + 1];
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
    pub fn new(position: DVec3, objects: &[Object], bounded: &[usize], skew: f64) -> Self {
        let size = bounded.iter().fold(position.abs().max_element(), |size, &object| {
            let extent = objects[object].solid.extent();
            size.max(extent.low.abs().max_element()).max(extent.high.abs().max_element())
        });
        let reach = size * REACH;
        let blur = Blur { skew, reach };
        let face = |k: usize| {
            let camera = face(position, k);
            Sight::new(View { camera: &camera, lens: None }, DVec2::ONE, objects, bounded, blur)
        };
        Self { position, faces: std::array::from_fn(face), reach }
    }

    /// The objects that may stand between the light and a point. None where that is not known.
    #[must_use]
    #[inline(always)]
    #[expect(clippy::inline_always, reason = "measured: what it returns is large")]
    pub fn before(&self, point: DVec3) -> Option<impl Iterator<Item = &Candidate>> {
        let offset = point - self.position;
        let sizes = offset.abs();
        let axis = if sizes.x >= sizes.y && sizes.x >= sizes.z { 0 } else { 1 + usize::from(sizes.z > sizes.y) };
        let depth = sizes[axis];
        let [across, upwards] = [offset[(axis + 1) % 3] / depth, offset[(axis + 2) % 3] / depth];
        let is_known = depth > 0.0 && point.abs().max_element() <= self.reach;
        let face = &self.faces[2 * axis + usize::from(offset[axis] > 0.0)];
        let seen = if is_known { face.at([across, upwards])? } else { return None };
        Some(seen.take_while(move |candidate| candidate.depth <= depth))
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
            LightKind::Point(position) => Some(LightSight::new(position, &scene.objects, &index.bounded, index.skew)),
            LightKind::Directional(_) | LightKind::Area(_) => None,
        };
        Self {
            eye: Sight::new(view, half, &scene.objects, &index.bounded, blur),
            lights: scene.lights.iter().map(of_light).collect(),
        }
    }
}
