//! Solids put together: the laws of sets hold for the spans of a ray, coincident faces included.

use crate::random::Random;
use crate::support::{End, agree, compile, compound, placed, ray_at, rotation, same, shapes, spans, transform};
use glam::{DQuat, DVec3};
use rayscope::csg::Solid;
use serde_json::{Value, json};

const RAYS: usize = 120;

/// Asks both solids with rays towards the first.
fn expect_same(left: &Value, right: &Value, random: &mut Random, rays: usize) {
    let (first, second) = (compile(left), compile(right));
    for _ in 0..rays {
        let ray = ray_at(&first, random);
        same(&spans(&second, ray), &spans(&first, ray))
            .unwrap_or_else(|problem| panic!("{ray:?}: {problem}\nfirst {left}\nsecond {right}"));
    }
}

fn expect_nothing(solid: &Value, towards: &Solid, random: &mut Random, rays: usize) {
    let nothing = compile(solid);
    for _ in 0..rays {
        let ray = ray_at(towards, random);
        let found = spans(&nothing, ray);
        assert!(found.is_empty(), "{ray:?}: {found:?}\n{solid}");
    }
}

#[test]
fn a_solid_with_itself_is_itself_and_without_itself_nothing() {
    let mut random = Random(1);
    for shape in shapes() {
        for _ in 0..4 {
            let solid = placed(&shape, &transform(&mut random));
            expect_same(&solid, &compound("union", &[&solid, &solid]), &mut random, RAYS / 2);
            expect_same(&solid, &compound("intersection", &[&solid, &solid]), &mut random, RAYS / 2);
            let alone = compile(&solid);
            expect_nothing(&compound("difference", &[&solid, &solid]), &alone, &mut random, RAYS / 2);
        }
    }
}

/// The same place by two ways whose roundings differ: one turn about an axis, and the same in three parts.
fn twins(shape: &Value, random: &mut Random) -> [Value; 2] {
    let axis = random.direction().to_array();
    let (degrees, moved) = (random.between(10.0, 350.0), random.vector(-3.0, 3.0));
    let turn = |degrees: f64| json!({"rotate": {"axis": axis, "degrees": degrees}});
    let third = degrees / 3.0;
    let shift = json!({"translate": moved.to_array()});
    let one = placed(shape, &[turn(degrees), shift.clone()]);
    let three = placed(shape, &[turn(third), turn(third), turn(degrees - third - third), shift]);
    [one, three]
}

#[test]
fn a_solid_without_its_twin_that_was_turned_in_three_parts_is_nothing() {
    let mut random = Random(2);
    // A half-space has no end, and far out the two turns are as far apart as one likes.
    for shape in shapes().into_iter().filter(|shape| shape["shape"] != "plane") {
        for _ in 0..12 {
            let [one, twin] = twins(&shape, &mut random);
            let alone = compile(&one);
            expect_nothing(&compound("difference", &[&one, &twin]), &alone, &mut random, RAYS);
            expect_same(&one, &compound("union", &[&one, &twin]), &mut random, RAYS);
            expect_same(&one, &compound("intersection", &[&twin, &one]), &mut random, RAYS);
        }
    }
}

/// The half-space below a plane through the point, and the one above.
fn halves(point: DVec3, normal: DVec3) -> [Value; 2] {
    [normal, -normal].map(|normal| {
        let turn = DQuat::from_rotation_arc(DVec3::Z, normal);
        let (axis, angle) = turn.to_axis_angle();
        json!({"shape": "plane", "transform": [
            {"rotate": {"axis": axis.to_array(), "degrees": angle.to_degrees()}},
            {"translate": point.to_array()},
        ]})
    })
}

#[test]
fn a_box_cut_in_two_and_put_together_has_no_seam() {
    let mut random = Random(3);
    for _ in 0..40 {
        let steps = [rotation(&mut random), json!({"translate": random.vector(-2.0, 2.0).to_array()})];
        let whole = placed(&json!({"shape": "cube"}), &steps);
        let middle = compile(&whole);
        let centre = (middle.extent().low + middle.extent().high) * 0.5;
        let [below, above] = halves(centre + random.vector(-0.5, 0.5), random.direction());
        let [first, second] = [&below, &above].map(|half| compound("intersection", &[&whole, half]));
        expect_same(&whole, &compound("union", &[&first, &second]), &mut random, RAYS);
        // What is not below is above.
        expect_same(&second, &compound("difference", &[&whole, &below]), &mut random, RAYS);
        expect_nothing(&compound("intersection", &[&first, &second]), &middle, &mut random, RAYS);
    }
}

#[test]
fn boxes_that_share_a_face_are_one_box_however_they_are_turned() {
    let mut random = Random(4);
    for _ in 0..40 {
        let steps = [rotation(&mut random), json!({"translate": random.vector(-2.0, 2.0).to_array()})];
        // From −1 to a, and from a to 3, in x.
        let a = random.between(-0.5, 2.5);
        let slab = |low: f64, high: f64| {
            let own = json!({"scale": [(high - low) * 0.5, 1, 1]});
            let shift = json!({"translate": [(high + low) * 0.5, 0, 0]});
            placed(&placed(&json!({"shape": "cube"}), &[own, shift]), &steps)
        };
        let (whole, left, right) = (slab(-1.0, 3.0), slab(-1.0, a), slab(a, 3.0));
        expect_same(&whole, &compound("union", &[&left, &right]), &mut random, RAYS);
        expect_same(&left, &compound("difference", &[&whole, &right]), &mut random, RAYS);
        expect_nothing(&compound("intersection", &[&left, &right]), &compile(&whole), &mut random, RAYS);
    }
}

/// A solid of one of the bounded shapes near the origin, and its kind.
fn any_solid(random: &mut Random) -> Value {
    let all: Vec<_> = shapes().into_iter().filter(|shape| shape["shape"] != "plane").collect();
    let shape = &all[random.below(all.len())];
    let moved = random.vector(-0.8, 0.8).to_array();
    placed(shape, &[rotation(random), json!({"translate": moved})])
}

#[test]
fn the_laws_of_sets_hold_along_every_ray() {
    let mut random = Random(5);
    for _ in 0..60 {
        let [a, b, c] = std::array::from_fn(|_| any_solid(&mut random));
        let or = |x: &Value, y: &Value| compound("union", &[x, y]);
        let and = |x: &Value, y: &Value| compound("intersection", &[x, y]);
        let less = |x: &Value, y: &Value| compound("difference", &[x, y]);
        for (left, right) in [
            (or(&or(&a, &b), &c), or(&a, &or(&b, &c))),
            (and(&and(&a, &b), &c), and(&a, &and(&b, &c))),
            (or(&a, &b), or(&b, &a)),
            (and(&a, &b), and(&b, &a)),
            // De Morgan.
            (less(&less(&a, &b), &c), less(&a, &or(&b, &c))),
            (less(&a, &and(&b, &c)), or(&less(&a, &b), &less(&a, &c))),
            (and(&a, &or(&b, &c)), or(&and(&a, &b), &and(&a, &c))),
            (or(&a, &and(&b, &c)), and(&or(&a, &b), &or(&a, &c))),
            // What is left and what was taken make the whole again.
            (a.clone(), or(&less(&a, &b), &and(&a, &b))),
            (and(&a, &b), less(&a, &less(&a, &b))),
        ] {
            expect_same(&left, &right, &mut random, RAYS / 4);
        }
    }
}

#[test]
fn a_chain_of_twelve_differences_is_the_difference_from_all() {
    let mut random = Random(6);
    for _ in 0..12 {
        let block = json!({"shape": "cube", "transform": [{"scale": 1.5}]});
        let cutters: Vec<Value> = (0..12).map(|_| placed(&any_solid(&mut random), &[json!({"scale": 0.7})])).collect();
        let mut chain = block.clone();
        for cutter in &cutters {
            chain = compound("difference", &[&chain, cutter]);
        }
        let all = compound("union", &cutters.iter().collect::<Vec<_>>());
        expect_same(&compound("difference", &[&block, &all]), &chain, &mut random, RAYS);
        let flat: Vec<&Value> = std::iter::once(&block).chain(&cutters).collect();
        expect_same(&compound("difference", &flat), &chain, &mut random, RAYS);
    }
}

#[test]
fn a_nest_of_twelve_differences_holds_every_other_shell() {
    // Balls of radius 13, 12 … 1, each taken from the next larger: S₁₃ − (S₁₂ − (S₁₁ − …)).
    let ball = |radius: f64| json!({"shape": "sphere", "transform": [{"scale": radius}]});
    let mut nest = ball(1.0);
    for radius in 2..=13 {
        nest = compound("difference", &[&ball(f64::from(radius)), &nest]);
    }
    let solid = compile(&nest);
    let mut random = Random(7);
    for _ in 0..200 {
        let direction = random.direction();
        let beside = direction.any_orthonormal_vector() * random.between(0.0, 14.0);
        let found = spans(&solid, (beside - direction * 50.0, direction));
        // The ray is within 13, 12 … from one time to another; what is left is between 13 and 12, 11 and 10 …
        let half = |radius: f64| (radius * radius - beside.length_squared()).max(0.0).sqrt();
        let mut ends: Vec<f64> = (1..=13).map(f64::from).map(half).filter(|half| *half > 0.0).collect();
        ends.reverse();
        let expected: Vec<f64> = ends.iter().map(|h| 50.0 - h).chain(ends.iter().rev().map(|h| 50.0 + h)).collect();
        // Within an odd number of balls the middle belongs to the innermost.
        let times: Vec<f64> = found.iter().flatten().map(|end: &End| end.0).collect();
        assert_eq!(times.len(), expected.len(), "{beside:?}: {times:?} for {expected:?}");
        let close = times.iter().zip(&expected).all(|(a, b)| agree((*a, 1e-6), (*b, 1e-6)));
        assert!(close, "{beside:?}: {times:?} for {expected:?}");
    }
}
