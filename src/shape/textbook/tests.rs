//! Right on easy rays, and wrong where the heads of the files say so.

use super::super::testing::{Samples, solve};
use super::*;
use crate::for_each_shape;
use crate::math::{DoubleDouble, Real};
use crate::shape::*;
use glam::DVec3;
use proptest::prelude::*;

fn textbook(shape: &Shape, origin: [f64; 3], direction: [f64; 3]) -> Crossings {
    let mut found = Crossings::new();
    crossings(shape, &GenericRay::new(origin.into(), direction.into()), &mut found);
    found
}

fn times(shape: &Shape, origin: [f64; 3], direction: [f64; 3]) -> Vec<f64> {
    textbook(shape, origin, direction).iter().map(|hit| hit.t).collect()
}

fn real(shape: &Shape, origin: [f64; 3], direction: [f64; 3]) -> Vec<f64> {
    solve::<f64>(shape, origin.into(), direction.into()).iter().map(|hit| hit.t).collect()
}

macro_rules! all_samples {
    ($($variant:ident $name:literal $about:literal { $($parameter:ident : $type:ty = $doc:literal,)* })*) => {
        fn all_samples() -> Vec<Shape> {
            let mut all = Vec::new();
            $(all.extend(<$variant as Samples>::samples().into_iter().map(Shape::$variant));)*
            all
        }
    };
}

for_each_shape!(all_samples);

/// Shapes on which the textbook's solver is right even close to the axis: not hollow, nearly square or overlapping itself.
fn is_easy(shape: &Shape) -> bool {
    match shape {
        Shape::Torus(torus) => torus.d > 1.0 && torus.d < 10.0,
        Shape::Superellipsoid(solid) => [solid.exponents.n, solid.exponents.m].iter().all(|e| (1.5..8.0).contains(e)),
        Shape::TaperedCylinder(solid) => solid.s < 4.0,
        _ => true,
    }
}

/// Whether F turns back close to zero, on either side of it: two hit times, or two roots that are not real, are close together.
fn touches(shape: &Shape, origin: DVec3, direction: DVec3) -> bool {
    let values: Vec<f64> = (0..=2000).map(|i| shape.implicit(origin + direction * (f64::from(i) / 1000.0))).collect();
    let turns = |three: &[f64]| (three[1] - three[0]) * (three[2] - three[1]) <= 0.0;
    values.windows(3).any(|three| turns(three) && three[1].abs() < 0.02)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    /// Rays at the inner half of the shape from 3 to 5 sizes away.
    #[test]
    fn easy_rays_have_the_real_hits(
        from in prop::array::uniform3(-1.0..1.0_f64), to in prop::array::uniform3(-0.3..0.3_f64),
    ) {
        let from = DVec3::from(from);
        prop_assume!(from.length() > 0.3 && from.abs().min_element() > 0.05);
        for shape in all_samples().iter().filter(|shape| is_easy(shape)) {
            let bounds = shape.bounds();
            let [low, high] = [bounds.low.max(DVec3::splat(-5.0)), bounds.high.min(DVec3::splat(5.0))];
            let half = 0.5 * (high - low);
            let aim = 0.5 * (low + high) + half * DVec3::from(to);
            let origin = aim + from.normalize() * 4.0 * half.length();
            let wanted = real(shape, origin.into(), (aim - origin).into());
            let found = times(shape, origin.into(), (aim - origin).into());
            // A torus may be touched wherever the ray goes.
            if touches(shape, origin, aim - origin) {
                continue;
            }
            prop_assert_eq!(found.len(), wanted.len(), "{:?}: {:?} {:?}", shape, found, wanted);
            for (found, wanted) in found.iter().zip(&wanted) {
                prop_assert!((found - wanted).abs() < 1e-9, "{:?}: {} {}", shape, found, wanted);
            }
        }
    }
}

#[test]
fn a_torus_that_is_passed_closely_moves_the_other_hits() {
    // The ray passes the tube a second time at a distance of a hundredth of it: the quartic has the roots below and
    // 0.99308 ± 0.00214 i, by 60 digits. The resolvent cubic has two roots that are nearly equal, and takes them for one.
    let torus = Shape::Torus(Torus::new(1.6).unwrap());
    let [from, to] = [
        [0.716_653_135_942_433_1, 0.433_419_057_473_422_35, -0.896_965_707_638_704_9],
        [-0.154_784_969_410_769_05, 0.176_341_860_488_118_4, 0.131_571_168_963_398_38],
    ];
    let half = DVec3::new(2.6, 2.6, 1.0);
    let aim = half * DVec3::from(to);
    let origin = aim + DVec3::from(from).normalize() * 4.0 * half.length();
    let exact = [0.921_754_418_527_722_5, 1.047_661_397_301_241_4];
    let found = times(&torus, origin.into(), (aim - origin).into());
    assert_eq!(found.len(), 2);
    assert!((found[0] - exact[0]).abs() > 1e-8, "{found:?}");
    for (found, exact) in real(&torus, origin.into(), (aim - origin).into()).iter().zip(exact) {
        assert!((found - exact).abs() < 1e-14, "{found}");
    }
}

#[test]
fn a_sphere_from_afar_loses_its_depth() {
    // Exactly 10⁸ ∓ √(3/4); but 10¹⁶ + 1/4 − 1 rounds to 10¹⁶, the discriminant to 0.
    let sphere = Shape::Sphere(Sphere);
    let (origin, direction) = ([0.5, 0.0, 1e8], [0.0, 0.0, -1.0]);
    assert_eq!(times(&sphere, origin, direction), [1e8, 1e8]);
    let half = 0.75_f64.sqrt();
    for (found, exact) in real(&sphere, origin, direction).iter().zip([1e8 - half, 1e8 + half]) {
        assert!((found - exact).abs() <= 2e-8, "{found}");
    }
}

#[test]
fn a_square_loses_a_slanting_ray_through_its_middle() {
    let (square, slope) = (Shape::Square(Square), 2.0_f64.powi(-14));
    let (origin, direction) = ([-1.0, 0.0, -slope], [1.0, 0.0, slope]);
    assert_eq!(real(&square, origin, direction), [1.0]);
    assert_eq!(times(&square, origin, direction), [] as [f64; 0]);
}

#[test]
fn a_cylinder_misses_the_ray_from_rim_to_rim() {
    // From (−1, 0, 1) to (1, 0, 0), straight through the middle.
    let cylinder = Shape::Cylinder(Cylinder::new().unwrap());
    let (origin, direction) = ([0.0, 0.0, 0.5], [2.0, 0.0, -1.0]);
    assert_eq!(real(&cylinder, origin, direction), [-0.5, 0.5]);
    assert_eq!(times(&cylinder, origin, direction), [] as [f64; 0]);
}

#[test]
fn a_cube_is_missed_within_a_last_digit_of_its_edge() {
    let (origin, direction) = ([-4.1, -3.262_499_999_999_999_7, 0.0], [0.8, 1.1, 0.0]);
    // It enters x ≥ −1 before it leaves y ≤ 1: (−1 − S_x) c_y < (1 − S_y) c_x, both exact with 32 digits.
    let wide = DoubleDouble::from_f64;
    let enters = (wide(-1.0) - wide(origin[0])) * wide(direction[1]);
    let leaves = (wide(1.0) - wide(origin[1])) * wide(direction[0]);
    assert!(enters < leaves);
    assert_eq!(times(&Shape::Cube(Cube), origin, direction), [] as [f64; 0]);
}

#[test]
fn a_plate_is_misplaced_when_n_dot_s_cancels() {
    // |x + y + z| ≤ 1, cut off very far away. At S the sum is 1/2 exactly, but 10¹⁶ + 1/2 rounds to 10¹⁶.
    let plane = |x: f64, y: f64, z: f64, offset| HalfSpace { normal: DVec3::new(x, y, z), offset };
    let mut planes = vec![plane(1.0, 1.0, 1.0, 1.0), plane(-1.0, -1.0, -1.0, 1.0)];
    planes.extend([(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)].map(|(x, z)| plane(x, 0.0, z, 1e17)));
    let plate = Shape::ConvexPolyhedron(ConvexPolyhedron::new(planes).unwrap());
    let (origin, direction) = ([1e16, 0.5, -1e16], [0.0, 1.0, 0.0]);
    assert_eq!(times(&plate, origin, direction), [-1.0, 1.0]);
    assert_eq!(real(&plate, origin, direction), [-1.5, 0.5]);
}

#[test]
fn a_torus_from_afar_is_lost_or_misplaced() {
    let torus = Shape::Torus(Torus::new(3.0).unwrap());
    let mut wrong = 0;
    for k in 0..20 {
        // Through both walls of the tube, four hits.
        let aim = 0.03 * f64::from(k);
        let (origin, direction) = ([1e5, 3e4 + aim, 2e4], [-1.0, -0.3, -0.2]);
        let exact = real(&torus, origin, direction);
        assert_eq!(exact.len(), 4);
        let found = times(&torus, origin, direction);
        let close = found.len() == 4 && found.iter().zip(&exact).all(|(a, b)| (a - b).abs() < 0.01);
        wrong += u32::from(!close);
    }
    assert!(wrong >= 15, "{wrong} of 20");
}

#[test]
fn the_overlap_of_a_spindle_counts_as_outside() {
    // d = 1/2: along the x axis the tube reaches from −3/2 to 3/2, and overlaps itself from −1/2 to 1/2.
    let spindle = Shape::Torus(Torus::new(0.5).unwrap());
    let (origin, direction) = ([-4.0, 0.0, 0.0], [1.0, 0.0, 0.0]);
    let round = |t: &f64| (t * 1e6).round() / 1e6;
    assert_eq!(real(&spindle, origin, direction).iter().map(round).collect::<Vec<_>>(), [2.5, 5.5]);
    assert_eq!(times(&spindle, origin, direction).iter().map(round).collect::<Vec<_>>(), [2.5, 3.5, 4.5, 5.5]);
}

#[test]
fn a_short_chord_of_a_superellipsoid_lies_between_two_samples() {
    // n = m = 2 is the sphere; at y = 0.9999 the chord is 2 √(1 − y²) = 0.028 long, a step 2/33 = 0.061.
    let sphere = Shape::Superellipsoid(Superellipsoid::new(2.0, 2.0).unwrap());
    let (origin, direction) = ([-3.0, 0.9999, 0.0], [1.0, 0.0, 0.0]);
    let half = (1.0 - 0.9999_f64 * 0.9999).sqrt();
    let exact = real(&sphere, origin, direction);
    assert!(exact.len() == 2 && (exact[0] - (3.0 - half)).abs() < 1e-12, "{exact:?}");
    assert_eq!(times(&sphere, origin, direction), [] as [f64; 0]);
}

#[test]
fn lists_combine_as_sets_do_but_coincident_faces_leave_slivers() {
    let hit = |t, sense| Crossing { t, error: 1e-15, sense, part: 0, certificate: Certificate::Certain };
    let list = |a, b| [hit(a, Sense::Enter), hit(b, Sense::Leave)];
    let minus = |in_left: bool, in_right: bool| in_left && !in_right;
    let spans =
        |left: &[Crossing], right: &[Crossing]| combine(minus, left, right).iter().map(|hit| hit.t).collect::<Vec<_>>();
    assert_eq!(spans(&list(0.0, 4.0), &list(1.0, 2.0)), [0.0, 1.0, 2.0, 4.0]);
    // A − A has nothing in it. Its near face is taken for two, one after the other.
    assert_eq!(spans(&list(0.0, 1.0), &list(0.0, 1.0)), [0.0, 0.0]);
}
