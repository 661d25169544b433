//! The picture, rendered on all cores behind the window's back, coarse to fine.

use crate::scene::Scene;
use crate::trace::{FIRST_BLOCK, Picture, Progress, render_rows};
use egui::{ColorImage, Context, TextureHandle, TextureOptions};
use std::sync::{Arc, Mutex, PoisonError};

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

struct Job {
    progress: Arc<Progress>,
    latest: Arc<Mutex<Latest>>,
    pixels: usize,
}

/// What the background thread has brought so far.
#[derive(Default)]
struct Latest {
    picture: Option<ColorImage>,
    finished: bool,
}

impl Drop for Job {
    fn drop(&mut self) {
        self.progress.cancel();
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
        let job = Job {
            progress: Arc::new(Progress::new()),
            latest: Arc::default(),
            pixels: scene.image.width as usize * scene.image.height as usize,
        };
        let (ctx, scene) = (ctx.clone(), Arc::clone(scene));
        let (progress, latest) = (Arc::clone(&job.progress), Arc::clone(&job.latest));
        let work = move || {
            // What the rays cost is of no interest here; the last pass has published the picture.
            let _ = render_rows(&scene, FIRST_BLOCK, &progress, |picture, block| {
                if !progress.cancelled() {
                    publish(&latest, picture, block == 1);
                    ctx.request_repaint();
                }
            });
        };
        // Without a thread there is no picture, but everything else still works.
        let started = std::thread::Builder::new().name("render".to_owned()).spawn(work);
        self.job = started.is_ok().then_some(job);
    }

    /// The picture as far as it goes; none until the first pass is done.
    pub fn texture(&mut self, ctx: &Context) -> Option<&TextureHandle> {
        let news = self.job.as_ref().and_then(|job| lock(&job.latest).picture.take());
        if let Some(image) = news {
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
        self.job.as_ref().map_or(0.0, |job| (job.progress.done() as f32 / job.pixels.max(1) as f32).min(1.0))
    }

    /// Whether every pixel is there.
    #[must_use]
    pub fn finished(&self) -> bool {
        self.job.as_ref().is_some_and(|job| lock(&job.latest).finished)
    }
}

fn publish(latest: &Mutex<Latest>, picture: &Picture, finished: bool) {
    let size = [picture.width as usize, picture.height as usize];
    let image = ColorImage::from_rgb(size, &picture.to_rgb8());
    let mut latest = lock(latest);
    latest.picture = Some(image);
    latest.finished = finished;
}

/// A thread that died while it held the lock left a whole picture behind: each is put there in one move.
fn lock(latest: &Mutex<Latest>) -> std::sync::MutexGuard<'_, Latest> {
    latest.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{embedded_scenes, load};

    fn scene() -> Arc<Scene> {
        let embedded = embedded_scenes().swap_remove(0);
        Arc::new(load(embedded.text, &embedded.name).expect("embedded scenes have no errors"))
    }

    #[test]
    fn starting_another_scene_cancels_the_one_before() {
        let ctx = Context::default();
        let mut renderer = Renderer::default();
        renderer.start(&ctx, &scene());
        let before = Arc::clone(&renderer.job.as_ref().expect("it runs").progress);
        assert!(!before.cancelled());
        renderer.start(&ctx, &scene());
        assert!(before.cancelled());
        assert!(!renderer.finished());
    }

    #[test]
    fn closing_the_workbench_cancels_the_picture() {
        let mut renderer = Renderer::default();
        renderer.start(&Context::default(), &scene());
        let progress = Arc::clone(&renderer.job.as_ref().expect("it runs").progress);
        drop(renderer);
        assert!(progress.cancelled());
    }
}
