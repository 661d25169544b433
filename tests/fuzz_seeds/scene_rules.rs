//! What holds for any bytes at all, taken as a scene file. The fuzz target and the tests share these rules.

use rayscope::scene::load;
use rayscope::trace::record_pixel;

/// Rays this far from the camera ray are followed, at most: a pixel's tree may double with every level.
const DEEPEST: u32 = 4;

/// Loads the bytes as a scene file and records one pixel of it; the error says which rule is broken.
pub fn check_scene(bytes: &[u8]) -> Result<(), String> {
    let Ok(text) = std::str::from_utf8(bytes) else { return Ok(()) };
    let mut scene = match load(text, "seed") {
        Ok(scene) => scene,
        Err(errors) if errors.to_string().is_empty() => return Err("refused without a reason".to_owned()),
        Err(_) => return Ok(()),
    };
    scene.limits.depth = scene.limits.depth.min(DEEPEST);
    let middle = [scene.image.width / 2, scene.image.height / 2];
    let [x, y] = scene.pixels.first().copied().unwrap_or(middle);
    let tree = record_pixel(&scene, x, y);
    if tree.colour().iter().any(|share| share.is_nan() || *share < 0.0) {
        return Err(format!("the colour of the pixel ({x}, {y}) is {:?}", tree.colour()));
    }
    Ok(())
}
