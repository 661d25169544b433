//! Lines and areas cut off at the sides of a frame.

use crate::view::labels::clip;
use crate::view::{Frame, Spot};

/// The pieces of a line from point to point that lie within a frame. Places that are no numbers are left out.
pub(in crate::view) fn clipped_line(within: &Frame, points: &[Spot]) -> Vec<Vec<Spot>> {
    let mut pieces: Vec<Vec<Spot>> = Vec::new();
    for ends in points.windows(2) {
        let Some([from, to]) = finite(ends).and_then(|()| clip(within, [ends[0], ends[1]])) else { continue };
        // Of places far out rounding leaves nothing.
        if ![from, to].iter().all(|end| within.grown(1.0).contains(*end)) {
            continue;
        }
        match pieces.last_mut() {
            Some(piece) if piece.last() == Some(&from) => piece.push(to),
            _ => pieces.push(vec![from, to]),
        }
    }
    pieces
}

fn finite(points: &[Spot]) -> Option<()> {
    points.iter().flatten().all(|x| x.is_finite()).then_some(())
}

/// The part of a ring within a frame, side after side (Sutherland and Hodgman, 1974).
pub(in crate::view) fn clipped_ring(within: &Frame, ring: &[Spot]) -> Vec<Spot> {
    if finite(ring).is_none() {
        return Vec::new();
    }
    let mut ring = ring.to_vec();
    for (axis, limit, sign) in
        [(0, within.low[0], 1.0), (0, within.high[0], -1.0), (1, within.low[1], 1.0), (1, within.high[1], -1.0)]
    {
        let depth = |at: &Spot| sign * (at[axis] - limit);
        let mut kept = Vec::with_capacity(ring.len() + 1);
        let next = ring.iter().cycle().skip(1);
        for (from, to) in ring.iter().zip(next) {
            let (near, far) = (depth(from), depth(to));
            if near >= 0.0 {
                kept.push(*from);
            }
            if (near < 0.0) != (far < 0.0) {
                let share = near / (near - far);
                let mut at: Spot = std::array::from_fn(|i| from[i] + (to[i] - from[i]) * share);
                at[axis] = limit;
                kept.push(at);
            }
        }
        ring = kept;
    }
    ring
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNIT: Frame = Frame { low: [0.0, 0.0], high: [1.0, 1.0] };

    fn area(ring: &[Spot]) -> f64 {
        let next = ring.iter().cycle().skip(1);
        ring.iter().zip(next).map(|(a, b)| a[0] * b[1] - b[0] * a[1]).sum::<f64>().abs() / 2.0
    }

    #[test]
    fn a_square_on_its_corner_loses_its_four_corners() {
        // |x − ½| + |y − ½| ≤ ¾ has the area 2 (¾)²; each of the corners cut off has (¼)².
        let diamond = [[0.5, -0.25], [1.25, 0.5], [0.5, 1.25], [-0.25, 0.5]];
        assert!((area(&clipped_ring(&UNIT, &diamond)) - (1.125 - 0.25)).abs() < 1e-12);
    }

    #[test]
    fn a_ring_around_everything_becomes_the_frame_and_one_outside_becomes_nothing() {
        let around = [[-9.0, -9.0], [9.0, -9.0], [9.0, 9.0], [-9.0, 9.0]];
        assert!((area(&clipped_ring(&UNIT, &around)) - 1.0).abs() < 1e-12);
        let outside = [[2.0, 2.0], [3.0, 2.0], [3.0, 3.0]];
        assert!(clipped_ring(&UNIT, &outside).is_empty());
    }

    #[test]
    fn a_line_that_leaves_and_comes_back_is_in_two_pieces() {
        let line = [[0.25, 0.5], [0.25, 2.0], [0.75, 2.0], [0.75, 0.5]];
        let expected = vec![vec![[0.25, 0.5], [0.25, 1.0]], vec![[0.75, 1.0], [0.75, 0.5]]];
        assert_eq!(clipped_line(&UNIT, &line), expected);
    }

    #[test]
    fn what_is_no_number_is_not_drawn() {
        assert!(clipped_line(&UNIT, &[[0.5, 0.5], [f64::NAN, 0.5]]).is_empty());
        assert!(clipped_ring(&UNIT, &[[0.0, 0.0], [1.0, 0.0], [0.5, f64::INFINITY]]).is_empty());
    }
}
