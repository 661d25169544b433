//! An image on a surface.

use super::filter::Filter;
use super::footprint::{Footprint, across_seams};
use super::height::height_and_slopes;
use super::mapping::Mapping;
use super::texels::Texels;
use super::wrap::Wraps;
use crate::record::{self, Entry, Recorder, What};
use glam::{DMat2, DVec2, DVec3};
use std::sync::Arc;

/// A place on a surface whose colour is asked for.
#[derive(Clone, Copy, Debug)]
pub struct Place<'a> {
    /// (u, v) of the hit.
    pub uv: DVec2,
    /// The number of the part of the surface.
    pub part: u16,
    /// Its name, for the report.
    pub part_name: &'a str,
    /// (u, v) where the pixel's corner rays meet the surface, in their order about the pixel; none where that is not known.
    pub corners: Option<[DVec2; 4]>,
    /// How many of them miss the part and were taken to its tangent plane, for the report.
    pub off_the_surface: usize,
    /// After how much u and v begin again, where they do.
    pub period: [Option<f64>; 2],
}

/// An image with the way that it lies on a surface.
#[derive(Clone, Debug, PartialEq)]
pub struct ImageTexture {
    /// The image.
    pub texels: Arc<Texels>,
    /// From the image to the surface.
    pub mapping: Mapping,
    /// What lies beyond the image's edges.
    pub wraps: Wraps,
    /// How texels are weighed.
    pub filter: Filter,
}

impl ImageTexture {
    /// Whether [`Place::corners`] are asked for.
    #[must_use]
    pub fn needs_footprint(&self) -> bool {
        self.filter.needs_footprint()
    }

    /// The colour at a place, with its two events: from the surface to the image, and from texels to the colour.
    pub fn colour(&self, place: &Place, recorder: &mut impl Recorder) -> DVec3 {
        let st = self.mapping.st_from_uv(place.part).apply(place.uv);
        let footprint = if self.needs_footprint() { self.footprint(place) } else { None };
        recorder.note(|| self.describe_mapping(place, st, footprint.as_ref()));
        self.filter.colour(&self.texels, self.wraps, self.texels_from_st(st), footprint.as_ref(), recorder)
    }

    /// The height at a place, the image's luminance, and its slopes along u and v.
    #[must_use]
    pub fn height_and_slopes(&self, uv: DVec2, part: u16) -> (f64, [f64; 2]) {
        let map = self.mapping.st_from_uv(part);
        let (height, slopes) = height_and_slopes(&self.texels, self.wraps, self.texels_from_st(map.apply(uv)));
        let [width, rows] = self.texels.size().map(f64::from);
        // By the chain rule: ∂/∂u = ∂/∂column · ∂column/∂u + ∂/∂row · ∂row/∂u.
        let texels_from_uv = DMat2::from_diagonal(DVec2::new(width, -rows)) * map.linear();
        (height, (texels_from_uv.transpose() * slopes).to_array())
    }

    /// The pixel's footprint in texels from the top left corner.
    fn footprint(&self, place: &Place) -> Option<Footprint> {
        let corners = across_seams(place.uv, place.corners?, place.period);
        let map = self.mapping.st_from_uv(place.part);
        Some(Footprint { corners: corners.map(|uv| self.texels_from_st(map.apply(uv)).to_array()) })
    }

    /// Column and row: t goes up, rows go down.
    fn texels_from_st(&self, st: DVec2) -> DVec2 {
        let [width, height] = self.texels.size().map(f64::from);
        DVec2::new(st.x * width, (1.0 - st.y) * height)
    }

    fn describe_mapping(&self, place: &Place, st: DVec2, footprint: Option<&Footprint>) -> Entry {
        let size = self.texels.size();
        let st_from_uv = self.mapping.st_from_uv(place.part).rows();
        let [[a_s, b_s, c_s], [a_t, b_t, c_t]] = st_from_uv;
        let at = self.texels_from_st(st);
        let bindings = [
            ("u", place.uv.x.into()),
            ("v", place.uv.y.into()),
            ("a_s", a_s.into()),
            ("b_s", b_s.into()),
            ("c_s", c_s.into()),
            ("a_t", a_t.into()),
            ("b_t", b_t.into()),
            ("c_t", c_t.into()),
            ("s", st.x.into()),
            ("t", st.y.into()),
            ("W", f64::from(size[0]).into()),
            ("H", f64::from(size[1]).into()),
        ];
        Entry::new(What::Mapping(record::Mapping {
            part: place.part_name.to_owned(),
            uv: place.uv.to_array(),
            uv_from_st: self.mapping.uv_from_st(place.part).rows(),
            st_from_uv,
            st: st.to_array(),
            size,
            footprint: footprint.map(|footprint| footprint.corners.to_vec()).unwrap_or_default(),
            off_the_surface: place.off_the_surface,
        }))
        .line("s", "a_s u + b_s v + c_s", &bindings, st.x)
        .line("t", "a_t u + b_t v + c_t", &bindings, st.y)
        .line("column", "s W", &bindings, at.x)
        .line("row", "(1 − t) H", &bindings, at.y)
    }
}
