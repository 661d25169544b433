//! Where the picture lies on screen, and which pixel is where.

use crate::scene::Scene;
use egui::{Pos2, Rect, pos2, vec2};

/// Where the picture lies on screen.
#[derive(Clone, Copy, Debug)]
pub struct Placement {
    /// Its place.
    pub rect: Rect,
    /// Its columns and rows.
    pub size: [u32; 2],
}

impl Placement {
    /// The largest picture that fits, in whole screen pixels per pixel if that costs no more than a fifth of its size.
    #[must_use]
    pub fn fit(scene: &Scene, room: Rect, pixels_per_point: f32) -> Self {
        let size = [scene.image.width, scene.image.height];
        let points = vec2(size[0] as f32, size[1] as f32) / pixels_per_point;
        let largest = (room.width() / points.x).min(room.height() / points.y).max(0.0);
        let whole = largest.floor();
        let scale = if whole >= 0.8 * largest && whole >= 1.0 { whole } else { largest };
        let min = room.center() - points * scale / 2.0;
        let min = pos2((min.x * pixels_per_point).round(), (min.y * pixels_per_point).round()) / pixels_per_point;
        Self { rect: Rect::from_min_size(min, points * scale), size }
    }

    /// The corner of a picture's pixel on screen; continuous, so that (0.5, 0.5) is the middle of the first.
    #[must_use]
    pub fn on_screen(&self, [x, y]: [f64; 2]) -> Pos2 {
        #[expect(clippy::cast_possible_truncation, reason = "screen coordinates are f32")]
        let share = vec2(x as f32 / self.size[0] as f32, y as f32 / self.size[1] as f32);
        self.rect.min + share * self.rect.size()
    }

    /// The place in the picture that lies there on screen: what [`on_screen`](Self::on_screen) undoes.
    #[must_use]
    pub fn in_pixels(&self, position: Pos2) -> [f64; 2] {
        let share = (position - self.rect.min) / self.rect.size();
        [f64::from(share.x) * f64::from(self.size[0]), f64::from(share.y) * f64::from(self.size[1])]
    }

    /// What a pixel covers on screen.
    #[must_use]
    pub fn pixel_rect(&self, [x, y]: [u32; 2]) -> Rect {
        let (x, y) = (f64::from(x), f64::from(y));
        Rect::from_min_max(self.on_screen([x, y]), self.on_screen([x + 1.0, y + 1.0]))
    }

    /// The pixel that is drawn at a place on screen.
    #[must_use]
    pub fn pixel_at(&self, position: Pos2) -> Option<[u32; 2]> {
        let share = (position - self.rect.min) / self.rect.size();
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "inside the picture, see below")]
        let pixel = [(share.x * self.size[0] as f32) as u32, (share.y * self.size[1] as f32) as u32];
        let inside = share.x >= 0.0 && share.y >= 0.0 && pixel[0] < self.size[0] && pixel[1] < self.size[1];
        inside.then_some(pixel)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn place() -> Placement {
        Placement { rect: Rect::from_min_size(pos2(10.0, 20.0), vec2(40.0, 20.0)), size: [4, 2] }
    }

    #[test]
    fn a_point_on_screen_belongs_to_the_pixel_drawn_there() {
        assert_eq!(place().pixel_at(pos2(10.0, 20.0)), Some([0, 0]));
        assert_eq!(place().pixel_at(pos2(49.9, 39.9)), Some([3, 1]));
        assert_eq!(place().pixel_at(pos2(9.9, 30.0)), None);
        assert_eq!(place().pixel_at(pos2(30.0, 40.1)), None);
    }

    #[test]
    fn a_pixel_covers_its_share_of_the_picture() {
        assert_eq!(place().pixel_rect([1, 1]), Rect::from_min_max(pos2(20.0, 30.0), pos2(30.0, 40.0)));
    }
}
