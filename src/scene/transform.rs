//! From the steps of a transform to an affine map.

use super::solid_file::{Scale, Transform};
use crate::math::portable;
use glam::{DAffine3, DMat3, DVec3};

impl Transform {
    /// The map of this step, object to world.
    ///
    /// # Errors
    /// Says why the step makes no sense, after the field that it is about (which may be empty).
    pub fn affine(&self) -> Result<DAffine3, (&'static str, String)> {
        match *self {
            Self::Scale(Scale::Uniform(factor)) => scale([factor; 3]),
            Self::Scale(Scale::PerAxis(factors)) => scale(factors),
            Self::Rotate { axis, degrees } => rotation(DVec3::from_array(axis), degrees)
                .map(DAffine3::from_mat3)
                .ok_or_else(|| ("axis", "the axis of a rotation must not be (0, 0, 0)".to_owned())),
            Self::Translate(by) => Ok(DAffine3::from_translation(DVec3::from_array(by))),
            Self::Matrix(rows) => matrix(rows),
        }
    }

    /// The name of the step, as files spell it.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Scale(_) => "scale",
            Self::Rotate { .. } => "rotate",
            Self::Translate(_) => "translate",
            Self::Matrix(_) => "matrix",
        }
    }
}

fn scale(factors: [f64; 3]) -> Result<DAffine3, (&'static str, String)> {
    if factors.contains(&0.0) {
        return Err((
            "",
            "a scale of 0 flattens the solid, so that the transform is singular (it has no inverse)".into(),
        ));
    }
    Ok(DAffine3::from_scale(DVec3::from_array(factors)))
}

fn matrix(rows: [[f64; 4]; 3]) -> Result<DAffine3, (&'static str, String)> {
    let column = |i: usize| DVec3::new(rows[0][i], rows[1][i], rows[2][i]);
    let linear = DMat3::from_cols(column(0), column(1), column(2));
    let determinant = linear.determinant();
    if determinant == 0.0 {
        return Err(("", "the matrix is singular: its determinant is 0, so it has no inverse".into()));
    }
    Ok(DAffine3 { matrix3: linear, translation: column(3) })
}

/// The rotation about `axis`, or none if the axis is zero.
///
/// Rodrigues' formula. Multiples of 90° use an exact sine and cosine, so that quarter turns about the coordinate axes
/// are exact matrices.
fn rotation(axis: DVec3, degrees: f64) -> Option<DMat3> {
    let scaled = axis * crate::math::scale_to_unit(axis.to_array());
    let unit = scaled.try_normalize()?;
    let (sine, cosine) = sine_and_cosine(degrees);
    let cross = DMat3::from_cols(
        DVec3::new(0.0, unit.z, -unit.y),
        DVec3::new(-unit.z, 0.0, unit.x),
        DVec3::new(unit.y, -unit.x, 0.0),
    );
    let along = DMat3::from_cols(unit * unit.x, unit * unit.y, unit * unit.z);
    Some(DMat3::IDENTITY * cosine + cross * sine + along * (1.0 - cosine))
}

fn sine_and_cosine(degrees: f64) -> (f64, f64) {
    let turn = degrees.rem_euclid(360.0);
    match turn {
        0.0 => (0.0, 1.0),
        90.0 => (1.0, 0.0),
        180.0 => (0.0, -1.0),
        270.0 => (-1.0, 0.0),
        _ => portable::sin_cos(turn.to_radians()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quarter_turn_about_z_takes_x_to_y_exactly() {
        let turn = Transform::Rotate { axis: [0.0, 0.0, 7.0], degrees: 90.0 }.affine().unwrap();
        assert_eq!(turn.transform_vector3(DVec3::X), DVec3::Y);
        assert_eq!(turn.transform_vector3(DVec3::Y), -DVec3::X);
        assert_eq!(turn.transform_vector3(DVec3::Z), DVec3::Z);
    }

    #[test]
    fn turns_by_multiples_of_90_degrees_are_exact_however_often_they_go_round() {
        for degrees in [-270.0, 450.0, 36090.0] {
            let turn = Transform::Rotate { axis: [1.0, 0.0, 0.0], degrees }.affine().unwrap();
            assert_eq!(turn.transform_vector3(DVec3::Y), DVec3::Z);
        }
    }

    #[test]
    fn a_third_of_a_turn_about_the_diagonal_permutes_the_axes() {
        let turn = Transform::Rotate { axis: [1.0, 1.0, 1.0], degrees: 120.0 }.affine().unwrap();
        assert!((turn.transform_vector3(DVec3::X) - DVec3::Y).length() < 1e-15);
        assert!((turn.transform_vector3(DVec3::Y) - DVec3::Z).length() < 1e-15);
    }

    #[test]
    fn a_matrix_is_read_by_rows_with_the_translation_in_the_last_column() {
        let rows = [[1.0, 2.0, 0.0, 10.0], [0.0, 1.0, 0.0, 20.0], [0.0, 0.0, 3.0, 30.0]];
        let map = Transform::Matrix(rows).affine().unwrap();
        assert_eq!(map.transform_point3(DVec3::ONE), DVec3::new(13.0, 21.0, 33.0));
    }

    #[test]
    fn steps_without_an_inverse_are_refused() {
        assert!(Transform::Scale(Scale::PerAxis([1.0, 0.0, 1.0])).affine().is_err());
        assert!(Transform::Rotate { axis: [0.0; 3], degrees: 10.0 }.affine().is_err());
        assert!(
            Transform::Matrix([[1.0, 2.0, 0.0, 0.0], [2.0, 4.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]]).affine().is_err()
        );
    }
}
