//! How wide the columns of a table are.

/// A column is made narrower than what cannot be broken in it only where that is wider than this, in points: such a word is broken
/// anywhere.
const LEAST: f32 = 110.0;

/// The width of each column in so much room, from how wide it is where nothing is broken and how wide its widest word is: narrow ones
/// stay as they are, and what is left is shared among the others. They are wider than the room together only where their words are.
pub fn widths(columns: &[[f32; 2]], room: f32) -> Vec<f32> {
    let mut order: Vec<usize> = (0..columns.len()).collect();
    order.sort_by(|&a, &b| columns[a][0].total_cmp(&columns[b][0]));
    let mut widths = vec![0.0; columns.len()];
    let mut left = room;
    for (place, column) in order.into_iter().enumerate() {
        let share = left / (columns.len() - place) as f32;
        let [whole, least] = columns[column];
        widths[column] = whole.min(share.max(least.min(LEAST)));
        left -= widths[column];
    }
    widths
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_that_fit_are_as_wide_as_they_are() {
        assert_eq!(widths(&[[40.0, 40.0], [200.0, 60.0]], 300.0), [40.0, 200.0]);
    }

    #[test]
    fn what_is_too_wide_gets_what_the_narrow_ones_leave() {
        assert_eq!(widths(&[[500.0, 60.0], [40.0, 40.0], [400.0, 60.0]], 340.0), [150.0, 40.0, 150.0]);
    }

    #[test]
    fn words_are_not_broken_before_they_must_be() {
        let widths = widths(&[[100.0, 100.0]; 4], 200.0);
        assert_eq!(widths, [100.0; 4], "together they are scrolled");
    }
}
