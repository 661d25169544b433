//! What a student tries out in the scene of a step: looked at by the step's own ray, and given up.

use super::open::OpenLesson;
use super::staged::Staged;
use crate::app::story::recording::Recording;
use crate::app::workbench::Workbench;
use crate::lesson::model::At;
use crate::lesson::question::Form;
use crate::trace::record_ray;
use egui::Context;
use glam::DVec3;
use std::sync::Arc;

impl Workbench {
    /// Back to the ray of the step: in the scene as it was changed, where the step asks for a change; otherwise with its scene and
    /// its event.
    pub(in crate::app) fn back_to_ray(&mut self, ctx: &Context) {
        if self.is_tried() {
            self.aim_anew();
        } else {
            self.set_stage(ctx);
        }
    }

    /// The scene of the step as the step found it.
    pub(super) fn start_again(&mut self, ctx: &Context) {
        self.give_up_trials();
        self.set_stage(ctx);
    }

    /// What was tried out in the scene of one step is given up for the next one without a question: it belongs to nobody's file.
    pub(super) fn give_up_trials(&mut self) {
        if self.staged().is_some() && self.editing.is_staged && self.editing.file().is_none() {
            self.editing.document.mark_saved();
        }
    }

    /// Whether the step asks for a change, and its scene is open with one.
    pub(super) fn is_tried(&self) -> bool {
        let asks = |open: &OpenLesson| open.asked.iter().any(|asked| matches!(asked.posed.form, Form::Edit(_)));
        self.lesson.open.as_ref().is_some_and(asks)
            && self.staged().is_some_and(|staged| {
                self.editing.name == staged.scene_name && self.editing.document.text() != staged.stage.scene.text
            })
    }

    /// Whether the pixel or the ray of the step is what was recorded, in whatever scene.
    pub(super) fn is_aimed(&self) -> bool {
        let (Some(staged), Some(recording)) = (self.staged(), &self.recording) else { return false };
        match staged.stage.aim.at {
            Some(At::Pixel(pixel)) => recording.loose_ray().is_none() && recording.pixel == pixel,
            Some(At::Ray(ray)) => recording.loose_ray() == Some(parts_of(ray)),
            None => false,
        }
    }

    fn aim_anew(&mut self) {
        let Some(at) = self.staged().and_then(|staged| staged.stage.aim.at) else { return };
        let Some(scene) = self.open.as_ref().map(|open| Arc::clone(&open.scene)) else { return };
        let image = scene.image;
        match at {
            At::Pixel([x, y]) if x < image.width && y < image.height => self.record([x, y]),
            // The picture became smaller.
            At::Pixel(_) => {}
            At::Ray(ray) => {
                let [origin, direction] = parts_of(ray);
                let tree = Arc::new(record_ray(&scene, origin, direction));
                let mut recording = Recording::of_tree(scene, [image.width / 2, image.height / 2], tree, None);
                recording.select_outcome();
                self.show_elsewhere(recording);
            }
        }
    }

    fn staged(&self) -> Option<&Staged> {
        self.lesson.open.as_ref().and_then(OpenLesson::staged)
    }
}

fn parts_of([ox, oy, oz, dx, dy, dz]: [f64; 6]) -> [DVec3; 2] {
    [DVec3::new(ox, oy, oz), DVec3::new(dx, dy, dz)]
}
