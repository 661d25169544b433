//! The picture, rendered on all cores behind the window's back, coarse to fine.

use crate::app::frame::background::Background;
use crate::app::frame::task::{self, Task};
use crate::app::system;
use crate::scene::Scene;
use crate::trace::{FIRST_BLOCK, Progress, Share, render_share};
use egui::{Color32, ColorImage, Context, TextureHandle, TextureOptions};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Single pixels stay visible when the picture is magnified, and lines stay whole when it is made smaller.
pub const SAMPLING: TextureOptions = TextureOptions {
    magnification: egui::TextureFilter::Nearest,
    minification: egui::TextureFilter::Linear,
    wrap_mode: egui::TextureWrapMode::ClampToEdge,
    mipmap_mode: None,
};

/// Renders one scene at a time. Starting another, or dropping it, cancels what is running.
#[derive(Default)]
pub struct Renderer {
    job: Option<Job>,
    texture: Option<TextureHandle>,
}

/// A picture with those who render it.
struct Job {
    parts: Vec<Part>,
    image: ColorImage,
}

/// Who renders a share, and how far it is.
struct Part {
    share: Share,
    work: Background<Strips>,
    /// The side of the blocks of its last pass; none before the first.
    block: Option<u32>,
}

/// To render a share of the picture.
#[derive(Serialize, Deserialize)]
pub struct Render {
    index: u32,
    of: u32,
}

/// The rows of a share after a pass.
#[derive(Serialize, Deserialize)]
pub struct Strips {
    block: u32,
    rgb: Vec<u8>,
}

impl Task for Render {
    const NAME: &'static str = "render";
    type News = Strips;

    fn run(self, scene: &Arc<Scene>, progress: &Progress, publish: &mut dyn FnMut(Strips)) {
        let share = Share { index: self.index, of: self.of };
        // What the rays cost is of no interest here; the last pass has published the picture.
        let _ = render_share(scene, FIRST_BLOCK, share, progress, |picture, block| {
            if !progress.cancelled() {
                publish(Strips { block, rgb: picture.share_to_rgb8(share, FIRST_BLOCK) });
            }
        });
    }
}

impl Renderer {
    /// Begins to render a scene; a running one is cancelled.
    pub fn start(&mut self, ctx: &Context, scene: &Arc<Scene>) {
        self.texture = None;
        self.follow(ctx, scene);
    }

    /// Begins to render a scene that is nearly the one before: that one's picture stays until there is a new one.
    pub fn follow(&mut self, ctx: &Context, scene: &Arc<Scene>) {
        self.job = None;
        let of = system::shares();
        let part = |index| {
            // Without a thread there is no picture, but everything else still works.
            let work = task::begin(ctx, scene, Render { index, of })?;
            Some(Part { share: Share { index, of }, work, block: None })
        };
        let parts: Option<Vec<Part>> = (0..of).map(part).collect();
        let size = [scene.image.width as usize, scene.image.height as usize];
        self.job = parts.map(|parts| Job { parts, image: ColorImage::filled(size, Color32::BLACK) });
    }

    /// The picture as far as it goes; none until the first pass is done.
    pub fn texture(&mut self, ctx: &Context) -> Option<&TextureHandle> {
        if let Some(image) = self.job.as_mut().and_then(Job::news) {
            match &mut self.texture {
                Some(texture) => texture.set(image, SAMPLING),
                None => self.texture = Some(ctx.load_texture("picture", image, SAMPLING)),
            }
        }
        self.texture.as_ref()
    }

    /// The share of the pixels that is done, from 0 to 1.
    #[must_use]
    pub fn share_done(&self) -> f32 {
        self.job.as_ref().map_or(0.0, |job| {
            let done: usize = job.parts.iter().map(|part| part.work.done()).sum();
            (done as f32 / job.image.pixels.len().max(1) as f32).min(1.0)
        })
    }

    /// Whether every pixel is there.
    #[must_use]
    pub fn finished(&self) -> bool {
        self.job.as_ref().is_some_and(|job| job.parts.iter().all(|part| part.block == Some(1)))
    }
}

impl Job {
    /// The picture, where it has changed and no part of it is missing.
    fn news(&mut self) -> Option<ColorImage> {
        let mut is_new = false;
        for part in &mut self.parts {
            if let Some(strips) = part.work.take() {
                part.block = Some(strips.block);
                put(&mut self.image, part.share, &strips.rgb);
                is_new = true;
            }
        }
        let is_whole = self.parts.iter().all(|part| part.block.is_some());
        (is_new && is_whole).then(|| self.image.clone())
    }
}

/// Puts the rows of a share where they belong.
fn put(image: &mut ColorImage, share: Share, rgb: &[u8]) {
    let width = image.size[0].max(1);
    let rows = image.pixels.chunks_mut(width).zip(0..).filter(|&(_, y)| share.has(y, FIRST_BLOCK));
    for ((row, _), bytes) in rows.zip(rgb.chunks(3 * width)) {
        for (pixel, [red, green, blue]) in row.iter_mut().zip(bytes.as_chunks().0) {
            *pixel = Color32::from_rgb(*red, *green, *blue);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{embedded_scenes, load};
    use crate::trace::render;

    fn scene() -> Arc<Scene> {
        let embedded = embedded_scenes().swap_remove(0);
        Arc::new(load(embedded.text, &embedded.name).expect("embedded scenes have no errors"))
    }

    #[test]
    fn starting_another_scene_begins_the_picture_anew() {
        let ctx = Context::default();
        let mut renderer = Renderer::default();
        renderer.start(&ctx, &scene());
        while !renderer.finished() {
            renderer.texture(&ctx);
        }
        assert_eq!(renderer.share_done(), 1.0);
        renderer.start(&ctx, &scene());
        assert!(renderer.texture.is_none());
        assert!(!renderer.finished());
    }

    #[test]
    fn a_picture_of_shares_is_the_picture() {
        let mut scene = Scene::clone(&scene());
        // Neither side is a multiple of a block.
        (scene.image.width, scene.image.height) = (61, 43);
        let scene = Arc::new(scene);
        let (whole, _) = render(&scene, &Progress::new());
        let mut image = ColorImage::filled([61, 43], Color32::BLACK);
        for index in 0..3 {
            let mut last = None;
            Render { index, of: 3 }.run(&scene, &Progress::new(), &mut |strips| last = Some(strips));
            let strips = last.expect("there are passes");
            assert_eq!(strips.block, 1);
            put(&mut image, Share { index, of: 3 }, &strips.rgb);
        }
        assert_eq!(image, ColorImage::from_rgb([61, 43], &whole.to_rgb8()));
    }
}
