//! An image behind a drawing of its texels, in blocks that are large enough to be seen.

use crate::math::portable;
use crate::texture::image::{Texels, Wraps};
use crate::view::sheet::{Chart, Sheet, shown};

/// Points. Smaller blocks would make files large and show no more.
const SMALLEST_BLOCK: f64 = 6.0;

/// Points by which a block goes under the next one, so that no line of the ground is seen between them.
const UNDER: f64 = 0.5;

/// Fills what the chart shows of the image; its axes count texels from the top left corner, rows downwards.
pub(super) fn draw(sheet: &mut Sheet, chart: &Chart, texels: &Texels) {
    /// So many halvings bring any image to one texel.
    const MOST_HALVINGS: u32 = 32;
    let texel = chart.scale();
    let Some(halvings) =
        (0..MOST_HALVINGS).find(|&k| texel * portable::power_of_two(k.cast_signed()) >= SMALLEST_BLOCK)
    else {
        return;
    };
    let side = portable::power_of_two(halvings.cast_signed());
    let level = texels.level(halvings as usize);
    let range = |axis: usize, values: [f64; 2]| {
        let last = f64::from(level.size()[axis]) - 1.0;
        let [first, last] = [(values[0] / side).floor().max(0.0), (values[1] / side).floor().min(last)];
        // No chart has room for more blocks of the smallest size.
        (0..4_000).map(move |i| first + f64::from(i)).take_while(move |block| *block <= last)
    };
    for row in range(1, chart.y.values) {
        for column in range(0, chart.x.values) {
            let low = chart.at([column * side, row * side]);
            let high = chart.at([(column + 1.0) * side, (row + 1.0) * side]).map(|x| x + UNDER);
            #[expect(clippy::cast_possible_truncation, reason = "from 0 to the size of an image")]
            let colour = level.at([column as i64, row as i64], Wraps::default());
            let ring = vec![low, [high[0], low[1]], high, [low[0], high[1]]];
            sheet.area(&chart.frame, &[ring], shown(colour.to_array()));
        }
    }
}
