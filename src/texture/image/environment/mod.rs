//! Environments (§ 6.3.0): an image all around, looked up by direction.
//!
//! The footprint of a pixel is the quadrilateral of great circles between its four corner directions, taken in two triangles. Each is
//! laid on the flat charts of the image, cut along columns and rows, and each texel counts by the solid angle of its piece.
//!
//! **Accuracy**: on the faces of a cube great circles are straight and the weights exact up to rounding; by latitude and
//! longitude they are curved and followed by straight pieces, to 10⁻⁴ of the footprint for each side. Footprints of more than `MOST_TOUCHED` texels
//! are averaged on smaller copies of the image, whose texels count as a whole along the footprint's edge. A footprint may be as large
//! as half of the sphere.

mod chart;
mod cross;
mod latitude_longitude;
mod pyramid;
mod sphere;

use super::sum::Sum;
use super::texels::Texels;
use super::wrap::{Wrap, Wraps};
use crate::math::portable;
use crate::record::{self, Entry, Recorder, What};
use chart::{Chart, Region};
use cross::Face;
use glam::{DVec2, DVec3};
use pyramid::Level;
use std::sync::{Arc, OnceLock};

/// The most texels that the rectangle about a footprint may hold before a smaller copy is taken. With fewer, texels at the edges of
/// a footprint would be seen as such; with more, a picture with a small mirror ball waits for it.
const MOST_TOUCHED: f64 = 65536.0;

/// Around the sphere columns begin again; rows end at the poles.
const WRAPS: Wraps = Wraps { columns: Wrap::Repeat, rows: Wrap::Clamp };

/// How an environment lies in its image; see the file of each for the directions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Layout {
    /// Longitude and latitude: column = (½ − φ / 360°) W, row = θ / 180° H, φ from +x towards +y and θ from +z.
    LatitudeLongitude,
    /// Six faces of a cube, four by three or three by four, with +x in the middle and +z above it.
    Cross,
}

impl Layout {
    /// Its name in scene files.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::LatitudeLongitude => "latitude_longitude",
            Self::Cross => "cross",
        }
    }
}

/// An image all around.
#[derive(Clone, Debug)]
pub struct Environment {
    texels: Arc<Texels>,
    /// The faces of a cross; none by latitude and longitude.
    faces: Option<[Face; 6]>,
    charts: Vec<Chart>,
    /// Cosine and sine of the turn.
    turn: DVec2,
    smaller: OnceLock<Vec<Level>>,
}

/// The image and its pose alone count, not whether smaller copies were asked for.
impl PartialEq for Environment {
    fn eq(&self, other: &Self) -> bool {
        (&self.texels, self.layout(), self.turn) == (&other.texels, other.layout(), other.turn)
    }
}

impl Environment {
    /// The environment of an image, turned about z by `turn_degrees` from +x towards +y.
    ///
    /// # Errors
    /// If the image of a cross does not have the shape of one, or the turn is no number.
    pub fn new(texels: Arc<Texels>, layout: Layout, turn_degrees: f64) -> Result<Self, String> {
        if !turn_degrees.is_finite() {
            return Err(format!("the environment is turned by {turn_degrees}°; a number was expected"));
        }
        let (faces, charts) = match layout {
            Layout::LatitudeLongitude => (None, vec![Chart::Globe { size: texels.size() }]),
            Layout::Cross => {
                let (faces, count) = cross::faces(texels.size())?;
                (Some(faces), faces.iter().map(|face| face.chart(count)).collect())
            }
        };
        let (sine, cosine) = portable::sin_cos(turn_degrees.to_radians());
        let turn = DVec2::new(cosine, sine);
        Ok(Self { texels, faces, charts, turn, smaller: OnceLock::new() })
    }

    /// Its image.
    #[must_use]
    pub fn texels(&self) -> &Texels {
        &self.texels
    }

    /// How it lies in its image.
    #[must_use]
    pub fn layout(&self) -> Layout {
        if self.faces.is_some() { Layout::Cross } else { Layout::LatitudeLongitude }
    }

    /// The solid angles of all texels that are part of the sphere, row by row within each face.
    pub fn solid_angles(&self) -> impl Iterator<Item = f64> {
        self.charts.iter().flat_map(|chart| {
            let [columns, rows] = [0, 1].map(|axis| i64::from(chart.count(axis)));
            (0..rows).flat_map(move |y| (0..columns).map(move |x| chart.texel_solid_angle([x, y])))
        })
    }

    /// Where a direction of any length lies in the image, in texels from the top left corner.
    #[must_use]
    pub fn at(&self, direction: DVec3) -> [f64; 2] {
        let (chart, place) = self.locate(self.in_image(direction));
        chart.in_image(place)
    }

    /// The colour in a direction: the average over the solid angle between the corner directions, in their order about the pixel, or the
    /// nearest texel where there are none or none that hold anything.
    pub fn towards<R: Recorder>(&self, direction: DVec3, corners: Option<[DVec3; 4]>, recorder: &mut R) -> DVec3 {
        recorder.begin();
        let own = self.in_image(direction);
        let (chart, place) = self.locate(own);
        let (at, texel) = (chart.in_image(place), chart.texel(place));
        let corners = corners.and_then(|corners| self.footprint(corners));
        let average = corners.and_then(|corners| self.average(&corners, recorder));
        let colour = average.map_or_else(|| self.nearest(texel, recorder), |(colour, _)| colour);
        recorder.end(|| {
            let footprint = average.and(corners).map(|corners| self.outline(own, &corners)).unwrap_or_default();
            let entry = Entry::new(What::Environment(record::Environment {
                layout: self.layout().name().to_owned(),
                direction: direction.to_array(),
                at,
                size: self.texels.size(),
                footprint,
                solid_angle: average.map_or(0.0, |(_, solid_angle)| solid_angle),
                nearest: self.texels.at(texel, WRAPS).to_array(),
                colour: colour.to_array(),
            }));
            self.working(entry, own, at)
        });
        colour
    }

    /// A direction as the image has it, unit: turned back.
    fn in_image(&self, direction: DVec3) -> DVec3 {
        let unit = direction.normalize_or_zero();
        let flat = DVec2::new(self.turn.x, -self.turn.y).rotate(unit.truncate());
        flat.extend(unit.z)
    }

    /// The corners as the image has them; none if one has no direction.
    fn footprint(&self, corners: [DVec3; 4]) -> Option<[DVec3; 4]> {
        let corners = corners.map(|corner| self.in_image(corner));
        corners.iter().all(|corner| corner.length_squared() > 0.5).then_some(corners)
    }

    /// The chart that a unit direction lies on, and where.
    fn locate(&self, own: DVec3) -> (&Chart, DVec2) {
        match &self.faces {
            None => (&self.charts[0], latitude_longitude::place(own)),
            Some(faces) => {
                let met = cross::met(faces, own);
                (&self.charts[met], faces[met].project(own))
            }
        }
    }

    fn nearest<R: Recorder>(&self, texel: [i64; 2], recorder: &mut R) -> DVec3 {
        let mut sum = Sum::new::<R>(&self.texels, WRAPS);
        sum.add(texel, 1.0);
        sum.finish("nearest", 0, recorder)
    }

    /// The average over a footprint, and its solid angle; none if it has none.
    fn average<R: Recorder>(&self, corners: &[DVec3; 4], recorder: &mut R) -> Option<(DVec3, f64)> {
        let [a, b, c, d] = *corners;
        let regions: Vec<Region> =
            [[a, b, c], [a, c, d]].into_iter().flat_map(|corners| self.regions(corners)).collect();
        let touched: f64 = regions.iter().map(|region| region.touched(&self.charts[region.chart])).sum();
        let (level, texels, charts) = self.level(touched);
        let mut sum = Sum::new::<R>(texels, WRAPS);
        let mut whole = 0.0;
        for region in &regions {
            let chart = &charts[region.chart];
            let solid_angle = chart.solid_angle(&region.polygon);
            whole += solid_angle.abs();
            chart.cut(&region.polygon, |at, part| sum.add(at, part * solid_angle.signum()));
        }
        (!sum.is_empty()).then(|| (sum.finish("area", level, recorder), whole))
    }

    /// A triangle of directions on the charts.
    fn regions(&self, corners: [DVec3; 3]) -> Vec<Region> {
        match &self.faces {
            None => vec![latitude_longitude::region(corners)],
            Some(faces) => faces.iter().enumerate().filter_map(|(i, face)| face.region(i, &corners)).collect(),
        }
    }

    /// The copy on which so many texels of the image become few enough.
    fn level(&self, touched: f64) -> (usize, &Texels, &[Chart]) {
        let own = (0, &*self.texels, &self.charts[..]);
        if touched <= MOST_TOUCHED {
            return own;
        }
        let smaller = self.smaller.get_or_init(|| {
            let mut levels: Vec<Level> = Vec::new();
            while let Some(level) = match levels.last() {
                Some(last) => pyramid::halved(&last.texels, &last.charts),
                None => pyramid::halved(&self.texels, &self.charts),
            } {
                levels.push(level);
            }
            levels
        });
        let mut left = touched;
        let mut level = 0;
        while left > MOST_TOUCHED && level < smaller.len() {
            left /= 4.0;
            level += 1;
        }
        smaller[..level].last().map_or(own, |chosen| (level, &chosen.texels, &chosen.charts[..]))
    }

    /// The outline of a footprint in texels; on a cross, of the part on the face that the direction meets.
    fn outline(&self, own: DVec3, corners: &[DVec3; 4]) -> Vec<[f64; 2]> {
        let (chart, polygon) = match &self.faces {
            None => {
                let [a, b, c, d] = *corners;
                let size = sphere::solid_angle([a, b, c]).abs() + sphere::solid_angle([a, c, d]).abs();
                (0, latitude_longitude::outline(corners, latitude_longitude::place(own).x, size / 1000.0))
            }
            Some(faces) => {
                let met = cross::met(faces, own);
                (met, faces[met].region(met, corners).map(|region| region.polygon).unwrap_or_default())
            }
        };
        polygon.iter().map(|place| self.charts[chart].in_image(*place)).collect()
    }

    /// The lines of working that lead to the place in the image.
    fn working(&self, entry: Entry, own: DVec3, [column, row]: [f64; 2]) -> Entry {
        let [width, height] = self.texels.size().map(f64::from);
        let Some(faces) = &self.faces else {
            let bindings = [
                ("φ", latitude_longitude::longitude(own).to_degrees().into()),
                ("d_z", own.z.into()),
                ("W", width.into()),
                ("H", height.into()),
            ];
            return entry.line("column", "(0.5 − φ / 360) W", &bindings, column).line(
                "row",
                "(arccos d_z) / 180 H",
                &bindings,
                row,
            );
        };
        let face = &faces[cross::met(faces, own)];
        let count = f64::from(self.charts[0].count(0));
        let bindings = [
            ("d", own.to_array().into()),
            ("n", face.ahead.to_array().into()),
            ("r", face.right.to_array().into()),
            ("m", face.down.to_array().into()),
            ("N", count.into()),
            ("i", f64::from(face.place[0]).into()),
            ("j", f64::from(face.place[1]).into()),
        ];
        entry.line("column", "i N + (1 + (r · d) / (n · d)) N / 2", &bindings, column).line(
            "row",
            "j N + (1 + (m · d) / (n · d)) N / 2",
            &bindings,
            row,
        )
    }
}
