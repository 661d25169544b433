//! Sharing: links, copies, files; and what is said about them.

mod field;
mod menu;
mod notice;
mod product;
mod restore;
mod saving;

pub use menu::tools;
pub use product::{Ending, Product};
pub use restore::pane_named;

use crate::app::frame::words::{say, say_with};
use crate::app::workbench::Workbench;
use crate::share::link::Link;
use crate::view::View;
use egui::{Context, Ui};
use field::LinkField;
use notice::Notice;
use product::{Material, Result};
use restore::Awaited;
use saving::Saving;
use std::path::PathBuf;

/// What is being shared.
#[derive(Default)]
pub struct Sharing {
    /// Work that is going on.
    saving: Option<Saving>,
    /// What came of the last one.
    notice: Option<Notice>,
    /// The field for a link, while it is open.
    field: Option<LinkField>,
    /// What of a link waits for its pixel to be recorded.
    awaited: Option<Awaited>,
    /// The link to a lesson's step that is being set up.
    pub(in crate::app) after_stage: Option<Box<Link>>,
}

/// What becomes of what is made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Aim {
    /// A file that a dialogue asks for.
    Ask,
    /// This file.
    File(PathBuf),
    /// The clipboard.
    Clipboard,
}

impl Workbench {
    /// Makes something of the recorded ray, to be saved or copied.
    pub fn share(&mut self, product: Product, aim: Aim) {
        let ctx = self.ctx();
        let Some(material) = self.material() else { return };
        self.sharing.notice = None;
        self.sharing.saving = Saving::start(&ctx, material, product, aim);
    }

    /// Whether something is being made.
    #[must_use]
    pub fn is_sharing(&self) -> bool {
        self.sharing.saving.is_some()
    }

    /// What was said last about something shared.
    #[must_use]
    pub fn shared(&self) -> Option<&str> {
        self.sharing.notice.as_ref().map(|notice| notice.text.as_str())
    }

    /// Copies a link to what is seen.
    pub(in crate::app) fn copy_link(&mut self, ctx: &Context) {
        let notice = match self.link() {
            Ok(link) => {
                ctx.copy_text(link.clone());
                Notice::good(say_with(ctx, "share-link-copied", &[("link", (&link).into())]))
            }
            Err(problem) => Notice::bad(problem),
        };
        self.sharing.notice = Some(notice);
    }

    /// Whether the field for a link is open.
    pub(in crate::app) const fn asks_for_link(&self) -> bool {
        self.sharing.field.is_some()
    }

    /// Opens the field for a link.
    pub(in crate::app) fn ask_for_link(&mut self) {
        self.sharing.field = Some(LinkField::default());
    }

    /// The view that stands for the panel that is used, the side view where it has none.
    pub(in crate::app) fn current_view(&self) -> Option<&'static View> {
        let of_pane = self.dock.current().and_then(|pane| menu::views_of(pane).into_iter().next());
        of_pane.or_else(|| View::named("side"))
    }

    fn material(&self) -> Option<Material> {
        let (open, recording) = (self.open.as_ref()?, self.recording.as_ref()?);
        Some(Material {
            name: open.name.clone(),
            scene: recording.scene.clone(),
            tree: recording.tree.clone(),
            event: recording.selected(),
            level: self.stepping.level,
            theme: crate::app::frame::theme::drawing_theme(&self.ctx()),
            link: self.link().ok(),
        })
    }

    /// Once a frame: takes in what was made and what was asked for.
    pub(in crate::app) fn show_sharing(&mut self, ui: &mut Ui) {
        let ctx = ui.ctx().clone();
        self.find_awaited();
        if let Some(result) = self.sharing.saving.as_ref().and_then(Saving::take) {
            self.sharing.saving = None;
            self.sharing.notice = told(&ctx, result);
        }
        self.show_field(&ctx);
        notice::ui(&ctx, &mut self.sharing.saving, &mut self.sharing.notice);
    }

    fn show_field(&mut self, ctx: &Context) {
        let Some(field) = &mut self.sharing.field else { return };
        match field.ui(ctx) {
            field::Outcome::Stay => {}
            field::Outcome::Close => self.sharing.field = None,
            field::Outcome::Follow(link) => {
                self.sharing.field = None;
                self.follow(ctx, &link);
            }
        }
    }
}

/// What there is to say of a result; a copy is put on the clipboard.
fn told(ctx: &Context, result: Result) -> Option<Notice> {
    match result {
        Result::Saved(path) => {
            let path = path.display().to_string();
            Some(Notice::good(say_with(ctx, "share-saved", &[("path", (&path).into())])))
        }
        Result::Text(text) => {
            let lines = text.lines().count();
            ctx.copy_text(text);
            Some(Notice::good(say_with(ctx, "share-text-copied", &[("lines", lines.into())])))
        }
        Result::Image(image) => {
            ctx.copy_image(image);
            Some(Notice::good(say(ctx, "share-image-copied")))
        }
        Result::Given => None,
        Result::Failed(why) => Some(Notice::bad(why)),
    }
}
