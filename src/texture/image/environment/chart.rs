//! Flat pieces of an environment's image, their texels, and what these cover of the sphere.

use super::sphere::solid_angle;
use crate::math::portable;
use crate::texture::image::wrap::cell;
use glam::DVec2;
use std::f64::consts::{PI, TAU};

/// A rectangle of an image on which part of the sphere, or all of it, lies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Chart {
    /// All directions by longitude and latitude. Its coordinates are x, the share of a turn from the left edge, and y = −z, so that
    /// areas on it are solid angles over 2π (Archimedes).
    Globe {
        /// Columns and rows.
        size: [u32; 2],
    },
    /// A face of a cube about the eye, each of its coordinates from −1 to 1, so that great circles are straight lines.
    Face {
        /// Columns, and as many rows.
        count: u32,
        /// The texel at its top left corner.
        origin: [i64; 2],
    },
}

impl Chart {
    /// The texels along an axis.
    pub fn count(&self, axis: usize) -> u32 {
        match self {
            Self::Globe { size } => size[axis],
            Self::Face { count, .. } => *count,
        }
    }

    /// The chart with half as many columns and rows, rounded up.
    pub fn halved(&self) -> Self {
        match self {
            Self::Globe { size } => Self::Globe { size: size.map(|count| count.div_ceil(2)) },
            Self::Face { count, origin } => {
                let fewer = count.div_ceil(2);
                Self::Face { count: fewer, origin: origin.map(|at| at / i64::from(*count) * i64::from(fewer)) }
            }
        }
    }

    /// Where column or row `index` begins.
    pub fn line(&self, axis: usize, index: i64) -> f64 {
        let share = index as f64 / f64::from(self.count(axis));
        match (self, axis) {
            (Self::Globe { .. }, 0) => share,
            (Self::Globe { .. }, _) => -portable::cos(share * PI),
            (Self::Face { .. }, _) => 2.0 * share - 1.0,
        }
    }

    /// A coordinate in texels of the chart.
    pub fn texels(&self, axis: usize, place: f64) -> f64 {
        let share = match (self, axis) {
            (Self::Globe { .. }, 0) => place,
            (Self::Globe { .. }, _) => portable::acos((-place).clamp(-1.0, 1.0)) / PI,
            (Self::Face { .. }, _) => f64::midpoint(place, 1.0),
        };
        share * f64::from(self.count(axis))
    }

    /// A place in texels from the top left corner of the image.
    pub fn in_image(&self, place: DVec2) -> [f64; 2] {
        let origin = self.origin();
        [0, 1].map(|axis| origin[axis] as f64 + self.texels(axis, place[axis]))
    }

    /// The texel of the image at a place.
    pub fn texel(&self, place: DVec2) -> [i64; 2] {
        let origin = self.origin();
        [0, 1].map(|axis| origin[axis] + self.cell(axis, place[axis]))
    }

    /// The texel at the chart's top left corner.
    pub fn origin(&self) -> [i64; 2] {
        match self {
            Self::Globe { .. } => [0, 0],
            Self::Face { origin, .. } => *origin,
        }
    }

    /// The signed solid angle of a polygon.
    pub fn solid_angle(&self, corners: &[DVec2]) -> f64 {
        let Some((&first, rest)) = corners.split_first() else { return 0.0 };
        let triangles = rest.windows(2).map(|pair| [first, pair[0], pair[1]]);
        match self {
            Self::Globe { .. } => triangles.map(|[a, b, c]| (b - a).perp_dot(c - a) * PI).sum(),
            Self::Face { .. } => triangles.map(|corners| solid_angle(corners.map(|corner| corner.extend(1.0)))).sum(),
        }
    }

    /// The solid angle of a texel of the chart.
    pub fn texel_solid_angle(&self, [column, row]: [i64; 2]) -> f64 {
        let [left, right] = [column, column + 1].map(|index| self.line(0, index));
        let [top, bottom] = [row, row + 1].map(|index| self.line(1, index));
        match self {
            Self::Globe { .. } => (right - left) * (bottom - top) * TAU,
            Self::Face { .. } => {
                let corners = [(left, top), (right, top), (right, bottom), (left, bottom)].map(DVec2::from);
                self.solid_angle(&corners)
            }
        }
    }

    /// The texels that a polygon covers, with its signed solid angle in each: by columns within rows.
    pub fn cut(&self, polygon: &[DVec2], mut each: impl FnMut([i64; 2], f64)) {
        self.stripes(1, polygon.to_vec(), |row, stripe| {
            self.stripes(0, stripe, |column, piece| {
                let [x, y] = self.origin();
                each([x + column, y + row], self.solid_angle(&piece));
            });
        });
    }

    /// Cuts a polygon along columns (`axis` 0) or rows (`axis` 1). One that is not convex may come out with pieces that hang
    /// together by a line; their signed areas are right all the same.
    fn stripes(&self, axis: usize, polygon: Vec<DVec2>, mut each: impl FnMut(i64, Vec<DVec2>)) {
        let places = polygon.iter().map(|corner| corner[axis]);
        let (low, high) = places.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
        if low > high {
            return;
        }
        let [first, last] = [low, high].map(|place| self.cell(axis, place));
        let mut rest = polygon;
        for index in first..last {
            let (stripe, beyond) = split(&rest, axis, self.line(axis, index + 1));
            if stripe.len() > 2 {
                each(index, stripe);
            }
            rest = beyond;
        }
        if rest.len() > 2 {
            each(last, rest);
        }
    }

    /// The column or row that a coordinate lies in. Columns of the globe go on beyond its edges; all else ends there.
    fn cell(&self, axis: usize, place: f64) -> i64 {
        let index = cell(self.texels(axis, place));
        if matches!(self, Self::Globe { .. }) && axis == 0 {
            index
        } else {
            index.clamp(0, i64::from(self.count(axis)) - 1)
        }
    }
}

/// The parts of a polygon below and above a value of one coordinate.
fn split(polygon: &[DVec2], axis: usize, value: f64) -> (Vec<DVec2>, Vec<DVec2>) {
    let (mut below, mut above) = (Vec::with_capacity(polygon.len()), Vec::with_capacity(polygon.len()));
    let Some(mut from) = polygon.last() else { return (below, above) };
    for to in polygon {
        let [from_side, to_side] = [from, to].map(|corner| corner[axis] - value);
        if (from_side < 0.0) != (to_side < 0.0) {
            let crossing = from.lerp(*to, from_side / (from_side - to_side));
            below.push(crossing);
            above.push(crossing);
        }
        if to_side < 0.0 {
            below.push(*to);
        } else {
            above.push(*to);
        }
        from = to;
    }
    (below, above)
}

/// A triangle of directions, or the part of one, on a chart.
#[derive(Clone, Debug)]
pub(super) struct Region {
    /// The number of the chart.
    pub chart: usize,
    /// Its corners there.
    pub polygon: Vec<DVec2>,
}

impl Region {
    /// A bound on the number of texels that it touches: those of the rectangle about it.
    pub fn touched(&self, chart: &Chart) -> f64 {
        [0, 1]
            .map(|axis| {
                let places = self.polygon.iter().map(|corner| chart.texels(axis, corner[axis]));
                let ends = places.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
                (ends.1 - ends.0).max(0.0) + 1.0
            })
            .iter()
            .product()
    }
}
