//! What can be wrong with a normal.

use super::{
    Case, Cause, Guess, NORMAL_BY_INVERSE, NORMAL_BY_MATRIX, NORMAL_GENERIC, NORMAL_NOT_FLIPPED, NORMAL_NOT_UNIT,
    NORMAL_OTHER_PART, NORMAL_RADIAL, NORMAL_REVERSED, NORMAL_TRANSLATED, OPERAND_NORMAL, number, vector,
};
use crate::compare::foreign::check::Subject;
use crate::compare::foreign::ours::OurHit;
use crate::csg::Placement;
use crate::shape::{Part, Primitive};
use glam::DVec3;

/// Guesses about the normal at the hit of the ray that the check is about.
pub fn of_normal(case: Case, guesses: &mut Vec<Guess>) {
    let Some(hit) = case.ours.hit(case.check.ray) else { return };
    let is_outward = case.check.subject == Subject::Outward;
    let ours = if is_outward { hit.n_geometric } else { hit.n_shading };
    if let Some(theirs) = case.theirs() {
        // A direction that is right and a length that is not.
        let how = format!("n times its length {}", number(theirs.length()));
        if (theirs.length() - 1.0).abs() > case.check.allowed {
            guesses.push(Guess::vector(&NORMAL_NOT_UNIT, how, ours * theirs.length()));
        }
    }
    for (cause, how, normal) in told_wrong_normals(case, case.check.ray, is_outward) {
        // Whoever transforms a normal wrongly may leave its length as it comes.
        let length = case.theirs().map_or(1.0, DVec3::length);
        guesses.push(Guess::vector(cause, how, normal * length));
    }
}

/// Unit normals that come out of mistakes and would have gone unseen: none where the normal was told, and agrees.
pub(super) fn wrong_normals(case: Case, ray: usize) -> Vec<(&'static Cause, String, DVec3)> {
    if case.agrees(ray, |subject| subject == Subject::Normal) {
        return Vec::new();
    }
    told_wrong_normals(case, ray, false)
}

/// Unit normals that come out of mistakes, at the hit of a ray: on the side that the ray came from, or out of the solid.
fn told_wrong_normals(case: Case, ray: usize, is_outward: bool) -> Vec<(&'static Cause, String, DVec3)> {
    let Some(hit) = case.ours.hit(ray) else { return Vec::new() };
    let mut wrong = Vec::new();
    let is_turned = case.ours.is_turned_round(ray, &hit);
    if !is_outward && hit.n_geometric.dot(hit.n_shading) < 0.0 {
        let how = format!(
            "n out of the solid, with n · dir = {} > 0",
            number(hit.n_geometric.dot(case.ours.rays[ray].direction))
        );
        wrong.push((&NORMAL_NOT_FLIPPED, how, hit.n_geometric));
    }
    if is_turned {
        let how = format!("{} is subtracted; its own normal", hit.leaf);
        wrong.push((&OPERAND_NORMAL, how, -hit.n_geometric));
    }
    of_transform(case, ray, &hit, is_outward, &mut wrong);
    let ours = if is_outward { hit.n_geometric } else { hit.n_shading };
    wrong.push((&NORMAL_REVERSED, "−n".to_owned(), -ours));
    // Where a mistake changes nothing it explains nothing.
    wrong.retain(|(_, _, normal)| (*normal - ours).length() > 1e-9);
    wrong
}

fn of_transform(
    case: Case,
    ray: usize,
    hit: &OurHit,
    is_outward: bool,
    wrong: &mut Vec<(&'static Cause, String, DVec3)>,
) {
    let Some(leaf) = case.ours.leaf(hit.object, hit.leaf) else { return };
    let Some(part) = leaf.parts.iter().position(|part| part == hit.part) else { return };
    let normal_of = |part: usize| leaf.shape.normal(hit.generic_point, Part::try_from(part).unwrap_or(0));
    let direction = case.ours.rays[ray].direction;
    let ours = if is_outward { hit.n_geometric } else { hit.n_shading };
    // On the side of the ray, out of the solid, or as it comes: whichever a program does after its mistake.
    let sides = |n: DVec3| {
        let n = n.normalize_or_zero();
        let facing = if n.dot(direction) > 0.0 { -n } else { n };
        let beside = if n.dot(ours) < 0.0 { -n } else { n };
        [facing, beside, n]
    };
    for (cause, how, n) in mapped(&leaf.placement, normal_of(part), hit) {
        wrong.extend(sides(n).map(|n| (cause, how.clone(), n)));
    }
    let transposed = leaf.placement.generic_from_world().matrix3.transpose();
    for (other, name) in leaf.parts.iter().enumerate().filter(|(other, _)| *other != part) {
        wrong.extend(sides(transposed * normal_of(other)).map(|n| (&NORMAL_OTHER_PART, format!("n of {name}"), n)));
    }
}

/// What comes out where a generic normal is not taken to the world by the inverse transpose.
fn mapped(placement: &Placement, generic: DVec3, hit: &OurHit) -> [(&'static Cause, String, DVec3); 8] {
    let (world, inverse) = (placement.world_from_generic(), placement.generic_from_world().matrix3);
    let (matrix, transposed) = (world.matrix3, inverse.transpose());
    let (n, p) = (vector(generic), vector(hit.generic_point));
    [
        (&NORMAL_GENERIC, format!("n in generic coordinates {n}"), generic),
        (&NORMAL_BY_MATRIX, format!("M n / |M n| with n = {n}"), matrix * generic),
        (&NORMAL_BY_INVERSE, format!("M⁻¹ n / |M⁻¹ n| with n = {n}"), inverse * generic),
        (&NORMAL_BY_INVERSE, format!("Mᵀ n / |Mᵀ n| with n = {n}"), matrix.transpose() * generic),
        (&NORMAL_TRANSLATED, format!("M n as a point, n = {n}"), world.transform_point3(generic)),
        (&NORMAL_RADIAL, "(P − middle) / |P − middle|".to_owned(), hit.point - world.translation),
        (&NORMAL_RADIAL, format!("M⁻ᵀ p with p = {p}"), transposed * hit.generic_point),
        (&NORMAL_RADIAL, "M⁻ᵀ (p_x, p_y, 0)".to_owned(), transposed * hit.generic_point.truncate().extend(0.0)),
    ]
}
