//! What can be wrong with a ray in generic coordinates.

use super::{
    Case, DIRECTION_NORMALISED, DIRECTION_TRANSLATED, FORWARD_MATRIX, Guess, NOT_TRANSFORMED, ROTATION_BACKWARDS,
    TRANSFORM_ORDER, number, vector,
};
use crate::compare::foreign::check::Subject;
use crate::csg::Leaf;
use crate::record::{EventId, What};
use glam::{DAffine3, DMat3, DVec3};

/// Guesses about S or c of the primitive below an event.
pub fn of_transform(case: Case, primitive: EventId, guesses: &mut Vec<Guess>) {
    let Some((_, _, c)) = case.ours.transform(primitive) else { return };
    let (origin, direction) = (case.origin(), case.direction());
    let is_origin = matches!(case.check.subject, Subject::GenericOrigin(_));
    if !is_origin {
        for unit in case.units() {
            let how = format!("c / |c| with |c| = {}", number(c.length() * unit));
            guesses.push(Guess::vector(&DIRECTION_NORMALISED, how, c / (c.length() * unit)));
        }
    }
    let Some(leaf) = leaf(case, primitive) else { return };
    let (matrix, inverse) = (leaf.placement.world_from_generic(), leaf.placement.generic_from_world());
    let (from, symbol) = if is_origin { (origin, "origin") } else { (direction, "dir") };
    let by = |map: DAffine3| if is_origin { map.transform_point3(from) } else { map.transform_vector3(from) };
    if !is_origin {
        let how = format!("M⁻¹ dir with the translation {}", vector(inverse.translation));
        guesses.push(Guess::vector(&DIRECTION_TRANSLATED, how, inverse.transform_point3(direction)));
        let how = format!("dir − translation {}", vector(matrix.translation));
        let moved = inverse.matrix3 * (direction - matrix.translation);
        guesses.push(Guess::vector(&DIRECTION_TRANSLATED, how, moved));
    }
    guesses.push(Guess::vector(&NOT_TRANSFORMED, symbol, from));
    guesses.push(Guess::vector(&FORWARD_MATRIX, format!("M {symbol}"), by(matrix)));
    for (cause, how, wrong) in wrong_maps(matrix) {
        guesses.push(Guess::vector(cause, format!("{how}: M⁻¹ {symbol}"), by(wrong.inverse())));
    }
}

/// Maps that come out where scale, rotation and translation are put together wrongly.
pub(super) fn wrong_maps(matrix: DAffine3) -> Vec<(&'static super::Cause, &'static str, DAffine3)> {
    let (linear, translation) = (matrix.matrix3, matrix.translation);
    let first = DAffine3 { matrix3: linear, translation: linear * translation };
    let mut maps = vec![(&TRANSFORM_ORDER, "translated before it is scaled and turned", first)];
    let scales = DVec3::new(linear.x_axis.length(), linear.y_axis.length(), linear.z_axis.length());
    let rotation = DMat3::from_cols(linear.x_axis / scales.x, linear.y_axis / scales.y, linear.z_axis / scales.z);
    let is_rotation =
        (rotation.transpose() * rotation - DMat3::IDENTITY).to_cols_array().iter().all(|x| x.abs() < 1e-9);
    if is_rotation {
        let turned_first = DMat3::from_diagonal(scales) * rotation;
        let backwards = rotation.transpose() * DMat3::from_diagonal(scales);
        let with = |matrix3: DMat3| DAffine3 { matrix3, translation };
        maps.push((&TRANSFORM_ORDER, "turned before it is scaled", with(turned_first)));
        maps.push((&ROTATION_BACKWARDS, "turned by the opposite angle", with(backwards)));
        let all_reversed = DAffine3 { matrix3: turned_first, translation: turned_first * translation };
        maps.push((&TRANSFORM_ORDER, "translated, then turned, then scaled", all_reversed));
    }
    maps
}

/// The scene's primitive that an event below an object is about.
pub(super) fn leaf<'a>(case: Case<'a, '_>, primitive: EventId) -> Option<&'a Leaf> {
    let tree = case.ours.tree;
    let What::Primitive { name, leaf: place, .. } = &tree.event(primitive).what else { return None };
    let object = tree.path(primitive).into_iter().rev().find_map(|id| match &tree.event(id).what {
        What::Object { name, .. } => Some(name.clone()),
        _ => None,
    })?;
    let leaves = &case.ours.scene_object(&object)?.solid.leaves;
    leaves.get(*place).filter(|leaf| leaf.name == *name)
}
