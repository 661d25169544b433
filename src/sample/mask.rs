//! A picture as a density: points fall where it is bright, in proportion to its brightness.

/// A picture of weights over the unit square, row by row from the top, made for choosing points.
#[derive(Clone, Debug, PartialEq)]
pub struct Mask {
    columns: usize,
    rows: usize,
    /// For each row the sums of its weights up to each column, from 0 on.
    within_rows: Vec<f64>,
    /// The sums of the rows up to each row, from 0 on.
    over_rows: Vec<f64>,
}

impl Mask {
    /// The mask with `columns` weights in each row.
    ///
    /// # Errors
    /// There has to be a weight above 0, and none below.
    pub fn new(columns: usize, weights: &[f64]) -> Result<Self, String> {
        if columns == 0 || !weights.len().is_multiple_of(columns) {
            return Err(format!("{} weights are not rows of {columns}", weights.len()));
        }
        if weights.iter().any(|&weight| !(weight >= 0.0 && weight.is_finite())) {
            return Err("a weight is below 0 or not a number".to_owned());
        }
        let running = |weights: &[f64]| {
            let sums = weights.iter().scan(0.0, |sum, weight| {
                *sum += weight;
                Some(*sum)
            });
            std::iter::once(0.0).chain(sums).collect::<Vec<f64>>()
        };
        let lines: Vec<Vec<f64>> = weights.chunks(columns).map(running).collect();
        let totals: Vec<f64> = lines.iter().map(|line| line[columns]).collect();
        let over_rows = running(&totals);
        if over_rows[totals.len()] <= 0.0 {
            return Err("all of it is black".to_owned());
        }
        Ok(Self { columns, rows: totals.len(), within_rows: lines.concat(), over_rows })
    }

    /// The point of the unit square, y downwards, for another point of it: a row by the sums over the rows, and a column by
    /// the sums within the row.
    #[must_use]
    pub fn point(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let (row, down) = inverted(&self.over_rows, y);
        let line = &self.within_rows[row * (self.columns + 1)..][..=self.columns];
        let (column, across) = inverted(line, x);
        [(column as f64 + across) / self.columns as f64, (row as f64 + down) / self.rows as f64]
    }
}

/// The step of an ascending table in which `share` of its last entry is reached, and how far into the step.
fn inverted(sums: &[f64], share: f64) -> (usize, f64) {
    let wanted = share * sums[sums.len() - 1];
    // Steps of no height are passed by: the first entry above what is wanted ends a step that has one.
    let end = sums.partition_point(|&sum| sum <= wanted).clamp(1, sums.len() - 1);
    let (low, high) = (sums[end - 1], sums[end]);
    (end - 1, if high > low { (wanted - low) / (high - low) } else { 0.5 })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "places from 0 to 3")]
    fn points_fall_where_the_weights_are_and_as_often() {
        let weights = [0.0, 3.0, 1.0, 0.0, 0.0, 0.0, 2.0, 0.0, 10.0];
        let mask = Mask::new(3, &weights).unwrap();
        let mut counts = [0_u32; 9];
        for (x, y) in (0..160).flat_map(|x| (0..160).map(move |y| (x, y))) {
            let [across, down] = mask.point([x, y].map(|k| (f64::from(k) + 0.5) / 160.0));
            counts[(across * 3.0) as usize + 3 * (down * 3.0) as usize] += 1;
        }
        for (weight, count) in weights.iter().zip(counts) {
            let share = f64::from(count) / 25600.0;
            assert!((share - weight / 16.0).abs() < 0.01, "{weight}: {share}");
            assert!(*weight > 0.0 || count == 0, "{count} points where nothing is let through");
        }
    }

    #[test]
    fn a_plain_mask_leaves_points_where_they_are() {
        let mask = Mask::new(4, &[1.0; 12]).unwrap();
        for point in [[0.0, 0.0], [0.3, 0.7], [0.999, 0.5]] {
            let [x, y] = mask.point(point);
            assert!((x - point[0]).abs() < 1e-15 && (y - point[1]).abs() < 1e-15);
        }
    }

    #[test]
    fn masks_that_let_nothing_through_are_refused() {
        assert!(Mask::new(2, &[0.0; 4]).unwrap_err().contains("black"));
        assert!(Mask::new(2, &[1.0, -1.0]).unwrap_err().contains("below 0"));
        assert!(Mask::new(2, &[1.0; 3]).unwrap_err().contains("rows"));
    }
}
