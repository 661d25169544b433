//! Made-up events of textures for tests, with numbers that a person can check.

use super::sample::Sketch;
use crate::record::{
    Bump, Detail, Environment, FrameMap, Lattice, LatticeCorner, Mapping, Octave, Octaves, Rings, Stop, TexelShare,
    Texels, Texture, Triple, Undulate, What,
};

/// Everything that a surface can carry, as if it were all on one.
pub fn carried(s: &mut Sketch) {
    s.note(What::Detail(detail()));
    let texture = |name: &str, point, colour| What::Texture(Texture { texture: name.into(), point, colour });
    s.with(texture("image", [0.5, 0.375, 0.0], texels().colour), |s| {
        s.with(What::Mapping(mapping()), |s| s.note(What::Texels(texels())));
    });
    s.with(texture("marble", [2.25, 1.5, 0.5], undulate().colour), |s| {
        s.with(What::Octaves(octaves()), |s| s.note(What::Lattice(lattice())));
        s.note(What::Undulate(undulate()));
    });
    s.with(texture("wood", [0.28, 0.21, 0.7], [0.3, 0.2, 0.1]), |s| s.note(What::Rings(rings())));
    s.note(What::Bump(bump()));
    s.note(What::FrameMap(frame_map()));
}

/// A triangle in the middle of a face, with the hit inside it.
pub fn detail() -> Detail {
    Detail {
        part: "top".into(),
        uv: [0.5, 0.5],
        polygon: vec![[0.25, 0.25], [0.75, 0.25], [0.5, 0.75]],
        below: "silver".into(),
        material: "gold".into(),
    }
}

/// The pixel is a square that stands on a corner: |x − 4| + |y − 2.5| ≤ 1 in texels.
pub fn mapping() -> Mapping {
    Mapping {
        part: "top".into(),
        uv: [0.5, 0.4375],
        uv_from_st: [[0.5, 0.0, 0.25], [0.0, 0.5, 0.25]],
        st_from_uv: [[2.0, 0.0, -0.5], [0.0, 2.0, -0.5]],
        st: [0.5, 0.375],
        size: [8, 4],
        footprint: vec![[4.0, 1.5], [5.0, 2.5], [4.0, 3.5], [3.0, 2.5]],
        off_the_surface: 0,
    }
}

/// Its area is 2, of which 3/4 lie in each texel of the middle row and 1/8 in each of the four beside them.
pub fn texels() -> Texels {
    let share = |at, weight, colour| TexelShare { at, weight, colour };
    let white = [1.0; 3];
    Texels {
        filter: "footprint".into(),
        level: 0.0,
        texels: vec![
            share([3, 2], 0.375, [0.8, 0.2, 0.2]),
            share([4, 2], 0.375, [0.2, 0.2, 0.8]),
            share([3, 1], 0.0625, white),
            share([4, 1], 0.0625, white),
            share([3, 3], 0.0625, white),
            share([4, 3], 0.0625, white),
        ],
        left_out: 0,
        colour: [0.625, 0.4, 0.625],
    }
}

/// Gradients along the axes, so that each value is one coordinate of p − corner.
pub fn lattice() -> Lattice {
    let offset = [0.25, 0.5, 0.5];
    let fade: Triple = offset.map(|x: f64| 6.0 * x.powi(5) - 15.0 * x.powi(4) + 10.0 * x.powi(3));
    let gradients = [
        [1.0, 0.0, 0.0],
        [-1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, -1.0, 0.0],
        [0.0, 0.0, 1.0],
        [0.0, 0.0, -1.0],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
    ];
    let corner = |(number, gradient): (i64, Triple)| {
        let steps = [number & 1, number >> 1 & 1, number >> 2];
        let part = |i: usize| if steps[i] == 1 { fade[i] } else { 1.0 - fade[i] };
        LatticeCorner {
            at: [2 + steps[0], 1 + steps[1], steps[2]],
            gradient,
            value: (0..3).map(|i| gradient[i] * (offset[i] - steps[i] as f64)).sum(),
            weight: part(0) * part(1) * part(2),
        }
    };
    let corners: Vec<_> = (0..).zip(gradients).map(corner).collect();
    let noise = corners.iter().map(|corner| corner.value * corner.weight).sum();
    Lattice { method: "gradient".into(), point: [2.25, 1.5, 0.5], offset, fade, corners, noise }
}

/// 0.25 − 0.1 + 0.1 + 0.0125.
pub fn octaves() -> Octaves {
    let row = |(k, noise): (u32, f64)| {
        let weight = 0.5 * 0.5_f64.powi(i32::try_from(k).unwrap());
        Octave { k, frequency: f64::from(2_u32 << k), weight, noise, term: weight * noise }
    };
    Octaves { rows: (0..).zip([0.5, -0.4, 0.8, 0.2]).map(row).collect(), sum: 0.2625 }
}

/// Halfway from the middle stop to the last one.
pub fn undulate() -> Undulate {
    let stops = [(-1.0, [0.1; 3]), (0.0, [0.5, 0.4, 0.3]), (1.0, [0.9; 3])].map(|(at, colour)| Stop { at, colour });
    let at = |x: f64| {
        let [from, to] = if x < 0.0 { [stops[0], stops[1]] } else { [stops[1], stops[2]] };
        let part = x - from.at;
        let share = part * part * (3.0 - 2.0 * part);
        Stop { at: x, colour: std::array::from_fn(|i| from.colour[i] + share * (to.colour[i] - from.colour[i])) }
    };
    Undulate {
        argument: 0.5,
        stops: stops.to_vec(),
        segment: 1,
        curve: (0..=40).map(|i| at(-1.0 + f64::from(i) / 20.0)).collect(),
        colour: [0.7, 0.65, 0.6],
    }
}

/// Ten rings a unit, not stirred.
pub fn rings() -> Rings {
    Rings { radius: 0.35, stirred: 3.5, ring: 3.0, dark: true }
}

/// N = (0, 0, 4) becomes (−2, −4, 4).
pub fn bump() -> Bump {
    Bump {
        bump: "waves".into(),
        p_u: [2.0, 0.0, 0.0],
        p_v: [0.0, 2.0, 0.0],
        height: 0.125,
        slopes: [1.0, 2.0],
        p_u_cross_n: [0.0, -2.0, 0.0],
        n_cross_p_v: [-2.0, 0.0, 0.0],
        dropped: Some(0.5),
        before: [0.0, 0.0, 1.0],
        after: [-1.0 / 3.0, -2.0 / 3.0, 2.0 / 3.0],
    }
}

/// Turned by atan 3/4 about N, then tilted by as much along the grain.
pub fn frame_map() -> FrameMap {
    FrameMap {
        frame: "brushed".into(),
        turn: 0.75_f64.atan().to_degrees(),
        tilt: [0.75, 0.0],
        before: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        after: [[0.64, 0.48, 0.6], [-0.6, 0.8, 0.0], [-0.48, -0.36, 0.8]],
        roughness: [0.1, 0.4],
    }
}

/// An eighth of the way round, and as far up and down from the equator as one sixteenth of a half turn.
pub fn environment() -> Environment {
    let pi = std::f64::consts::PI;
    Environment {
        layout: "latitude_longitude".into(),
        direction: [1.0, 0.0, 0.0],
        at: [8.0, 4.0],
        size: [16, 8],
        footprint: vec![[7.0, 3.5], [9.0, 3.5], [9.0, 4.5], [7.0, 4.5]],
        solid_angle: pi / 4.0 * 2.0 * (pi / 16.0).sin(),
        nearest: [1.0, 1.0, 0.5],
        colour: [0.4, 0.5, 0.6],
    }
}
