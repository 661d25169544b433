//! Which ray is traced: a pixel's, or one of the user's own.

use crate::cli::failure::Failure;
use crate::scene::Scene;
use crate::share::link::Aim;
use crate::trace::{RayTree, record_pixel, record_ray};
use clap::Args;
use glam::DVec3;

/// A pixel, or a ray.
#[derive(Args, Clone, Copy, Debug)]
pub struct AimArguments {
    /// The pixel, counted from 0 at the top left
    #[arg(long, value_name = "X,Y", value_parser = pixel, conflicts_with = "ray")]
    pixel: Option<[u32; 2]>,
    /// A ray instead of a pixel: origin and direction; the direction's length is the unit of t
    #[arg(long, value_name = "OX,OY,OZ,DX,DY,DZ", value_parser = ray, allow_hyphen_values = true)]
    ray: Option<[DVec3; 2]>,
}

impl AimArguments {
    /// What is traced: where nothing is asked for, the pixel that tells the scene's story best.
    pub fn aim(self, scene: &Scene) -> Result<Aim, Failure> {
        if let Some(ray) = self.ray {
            return Ok(Aim::Ray(ray));
        }
        let (width, height) = (scene.image.width, scene.image.height);
        let telling = scene.pixels.first().copied().unwrap_or([width / 2, height / 2]);
        let pixel = self.pixel.unwrap_or(telling);
        check_pixel(scene, pixel)?;
        Ok(Aim::Pixel(pixel))
    }
}

/// Traces a ray and keeps everything.
pub fn recorded(scene: &Scene, aim: Aim) -> RayTree {
    match aim {
        Aim::Pixel([x, y]) => record_pixel(scene, x, y),
        Aim::Ray([origin, direction]) => record_ray(scene, origin, direction),
    }
}

/// Refuses a pixel that the scene's picture does not have.
pub fn check_pixel(scene: &Scene, [x, y]: [u32; 2]) -> Result<(), Failure> {
    let (width, height) = (scene.image.width, scene.image.height);
    if x < width && y < height {
        return Ok(());
    }
    Err(Failure::usage(format!(
        "pixel {x},{y} lies outside the picture of {width} × {height} pixels; the last one is {},{}",
        width - 1,
        height - 1
    )))
}

/// Column and row of a pixel.
pub fn pixel(text: &str) -> Result<[u32; 2], String> {
    let numbers: Option<Vec<u32>> = text.split(',').map(|number| number.trim().parse().ok()).collect();
    numbers
        .and_then(|numbers| numbers.try_into().ok())
        .ok_or_else(|| "expected a column and a row such as 320,240, counted from 0".to_owned())
}

/// Origin and direction of a ray.
pub fn ray(text: &str) -> Result<[DVec3; 2], String> {
    let numbers: Option<Vec<f64>> = text.split(',').map(|number| number.trim().parse().ok()).collect();
    let numbers: [f64; 6] = numbers
        .and_then(|numbers| numbers.try_into().ok())
        .ok_or("expected six numbers, origin and direction, such as 0,0,9,0,0,-1")?;
    if numbers.iter().any(|number| !number.is_finite()) {
        return Err("every number has to be finite".to_owned());
    }
    let [ox, oy, oz, dx, dy, dz] = numbers;
    let direction = DVec3::new(dx, dy, dz);
    if direction == DVec3::ZERO {
        return Err("the direction has no length, so it leads nowhere".to_owned());
    }
    Ok([DVec3::new(ox, oy, oz), direction])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pixel_is_a_column_and_a_row() {
        assert_eq!(pixel("320,240"), Ok([320, 240]));
        assert_eq!(pixel(" 0 , 7 "), Ok([0, 7]));
        for wrong in ["", "3", "3,4,5", "-1,2", "1.5,2", "x,y", "99999999999,0"] {
            assert!(pixel(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn a_ray_is_an_origin_and_a_direction_that_leads_somewhere() {
        assert_eq!(ray("0,0,9,0,0,-1"), Ok([DVec3::new(0.0, 0.0, 9.0), DVec3::NEG_Z]));
        for wrong in ["", "0,0,9", "0,0,9,0,0,0", "0,0,9,0,0,NaN", "inf,0,0,0,0,1", "0,0,9,0,0,-1,4"] {
            assert!(ray(wrong).is_err(), "{wrong}");
        }
    }
}
