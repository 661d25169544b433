//! Smaller copies of an environment, chart by chart: texels count by their solid angle, and no face mixes with another.

use super::chart::Chart;
use crate::texture::image::texels::{Texels, shares};
use crate::texture::image::wrap::Wraps;
use glam::DVec3;

/// A copy of an environment: its image and its charts.
#[derive(Clone, Debug)]
pub(super) struct Level {
    pub texels: Texels,
    pub charts: Vec<Chart>,
}

/// The copy with half as many columns and rows in each chart, rounded up; none where charts have one texel each.
pub(super) fn halved(texels: &Texels, charts: &[Chart]) -> Option<Level> {
    let first = charts.first()?;
    if first.count(0) == 1 && first.count(1) == 1 {
        return None;
    }
    let smaller: Vec<_> = charts.iter().map(Chart::halved).collect();
    let size = [0, 1].map(|axis| texels.size()[axis] / first.count(axis) * smaller[0].count(axis));
    let mut data = vec![[0.0_f32; 3]; size[0] as usize * size[1] as usize];
    for (from, to) in charts.iter().zip(&smaller) {
        let [columns, rows] = [0, 1].map(|axis| shares(from.count(axis), to.count(axis)));
        for (y, row) in rows.iter().enumerate() {
            for (x, column) in columns.iter().enumerate() {
                let place = |axis: usize, index: usize| usize::try_from(to.origin()[axis]).unwrap_or(0) + index;
                data[place(1, y) * size[0] as usize + place(0, x)] =
                    average(texels, from, column, row).as_vec3().to_array();
            }
        }
    }
    let texels = Texels::from_linear(size[0], size[1], data).ok()?;
    Some(Level { texels, charts: smaller })
}

/// The average over parts of columns and rows of a chart.
fn average(texels: &Texels, chart: &Chart, columns: &[(i64, f64)], rows: &[(i64, f64)]) -> DVec3 {
    let (mut sum, mut weight) = (DVec3::ZERO, 0.0);
    let [left, top] = chart.origin();
    for (y, share_y) in rows {
        for (x, share_x) in columns {
            let share = share_x * share_y * chart.texel_solid_angle([*x, *y]);
            sum += texels.at([left + x, top + y], Wraps::default()) * share;
            weight += share;
        }
    }
    sum / weight
}
