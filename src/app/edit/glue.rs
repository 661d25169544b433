//! What editing and the rest of the workbench do to each other.

use crate::app::edit::dialog::{self, Answer, Choice, Guard, Then};
use crate::app::edit::editor::Editor;
use crate::app::edit::frame_box::{draw_box, draw_spot, place_of_light};
use crate::app::edit::live::{Followed, Order as CompileOrder};
use crate::app::edit::recovery::{Offer, Recovery};
use crate::app::edit::saving::{Order as SaveOrder, Place, Refusal, Written, pictures_of};
use crate::app::frame::words::{say, say_with};
use crate::app::opening::{After, Source};
use crate::app::pane::Pane;
use crate::app::picture::placement::Placement;
use crate::app::story::recording::Recording;
use crate::app::system::Journals;
use crate::app::workbench::Workbench;
use crate::document::{Document, Selection, Step, Template, object_at};
use crate::scene::embedded_scene;
use egui::{Context, Key, Modifiers, RichText, Ui, ViewportCommand};
use std::path::{Path, PathBuf};
use std::sync::Arc;

impl Workbench {
    /// Keeps what is edited in a folder, and offers what was left behind there.
    #[cfg(not(target_arch = "wasm32"))]
    pub fn keep_edits_in(&mut self, folder: &Path) {
        self.keep_edits(Journals::in_folder(folder));
    }

    /// Keeps what is edited in journals, and offers what was left behind there.
    pub(in crate::app) fn keep_edits(&mut self, journals: Journals) {
        self.editing.recovery = Some(Recovery::among(journals));
    }

    /// The text of the scene, with its history.
    #[must_use]
    pub const fn document(&self) -> &Document {
        &self.editing.document
    }

    /// Whether the picture and the story show an older text than the one in the editor.
    #[must_use]
    pub fn is_stale(&self) -> bool {
        self.editing.is_stale()
    }

    /// Where in the text the thing stands that is being edited, such as `objects[0].of[1]`.
    #[must_use]
    pub fn edited(&self) -> Option<String> {
        self.editing.target.as_ref().map(ToString::to_string)
    }

    /// Puts the cursor into the text, at an offset in bytes, ready to type.
    pub fn put_cursor(&mut self, offset: usize) {
        self.reveal(Pane::Editor);
        self.editing.document.select(Selection::at(offset));
        self.editing.editor.show_cursor();
        self.editing.editor.wants_focus = true;
        self.editing.follow_cursor();
    }

    /// Does what is due between two frames: compiles, saves, notes, asks.
    pub(in crate::app) fn follow_edits(&mut self, ctx: &Context) {
        self.take_undo_keys(ctx);
        // While panels are being shown, nobody knows which are.
        self.editing.is_seen = self.dock.shows(Pane::Editor) || self.dock.shows(Pane::Properties);
        self.editing.analysis.follow(&self.editing.document);
        self.follow_text(ctx);
        self.follow_selection();
        self.follow_saving(ctx);
        if let Some(mut recovery) = self.editing.recovery.take() {
            recovery.follow(ctx, &self.editing.document, &self.editing.name);
            self.editing.recovery = Some(recovery);
        }
        self.guard_closing(ctx);
    }

    /// The other key for redoing; and what is left of these keys where there is nothing to undo, so that the text field does not take
    /// back what it remembers by itself.
    fn take_undo_keys(&mut self, ctx: &Context) {
        if types_elsewhere(ctx) {
            return;
        }
        let pressed = |modifiers, key| ctx.input_mut(|input| input.consume_key(modifiers, key));
        if pressed(Modifiers::COMMAND, Key::Y) {
            self.editing.redo();
        }
        if Editor::has_focus(ctx) {
            pressed(Modifiers::COMMAND.plus(Modifiers::SHIFT), Key::Z);
            pressed(Modifiers::COMMAND, Key::Z);
        }
    }

    /// Asks what has to be asked, over everything else.
    pub(in crate::app) fn ask_questions(&mut self, ctx: &Context) {
        if let Some(guard) = self.editing.guard.clone() {
            if let Some(answer) = dialog::guard(ctx, &self.editing.name) {
                self.editing.guard = None;
                self.settle(ctx, guard.then, answer);
            }
            return;
        }
        if !self.is_asking() {
            return;
        }
        let choice = self.editing.recovery.as_ref().and_then(Recovery::offer).map(|offer| dialog::offer(ctx, offer));
        if let Some(Some(choice)) = choice {
            self.settle_offer(ctx, choice);
        }
    }

    /// Whether a question has to be answered before anything else. One edit at a time is offered back: what is left is offered when
    /// that one is saved, or at the next start.
    pub(in crate::app) fn is_asking(&self) -> bool {
        self.editing.guard.is_some() || (self.has_question() && !self.is_opening())
    }

    /// Whether there is a question to be answered, at once or as soon as the scene is open.
    pub(in crate::app) fn has_question(&self) -> bool {
        let has_offer = self.editing.recovery.as_ref().is_some_and(|recovery| recovery.offer().is_some());
        self.editing.guard.is_some() || (has_offer && !self.editing.document.is_dirty())
    }

    fn settle(&mut self, ctx: &Context, then: Then, answer: Answer) {
        match answer {
            Answer::Save => {
                self.editing.saving.then = Some(then);
                self.save(ctx);
            }
            Answer::Discard => {
                self.editing.document.mark_saved();
                self.go_on(ctx, then);
            }
            Answer::Cancel => {}
        }
    }

    fn settle_offer(&mut self, ctx: &Context, choice: Choice) {
        let Some(offer) = self.editing.recovery.as_mut().and_then(Recovery::later) else { return };
        match choice {
            Choice::Later => {}
            Choice::Discard => {
                if let Some(recovery) = &mut self.editing.recovery {
                    recovery.remove(&offer);
                }
            }
            Choice::Recover => {
                let source = Source::Text(offer.state.saved.clone());
                let name = offer.state.name.clone();
                self.begin_opening(ctx, &name, source, After::TakeUp(Box::new(offer)));
            }
        }
    }

    /// Takes up an edit that was left behind, over the scene as it was saved.
    pub(in crate::app) fn take_up_edit(&mut self, ctx: &Context, offer: &Offer) {
        self.editing.name.clone_from(&offer.state.name);
        self.editing.take_up(&offer.state, &say(ctx, "edit-cause-recover"));
        self.reveal(Pane::Editor);
        if let Some(mut recovery) = self.editing.recovery.take() {
            recovery.note(&self.editing.document, &self.editing.name);
            recovery.remove(offer);
            self.editing.recovery = Some(recovery);
        }
    }

    fn go_on(&mut self, ctx: &Context, then: Then) {
        match then {
            Then::Open(name) => self.open_scene(ctx, &name),
            Then::OpenText(name, text) => self.open_text(ctx, &name, &text),
            Then::Follow(link) => self.follow(ctx, &link),
            Then::Lesson => self.set_stage(ctx),
            Then::New(template) => self.begin_new(ctx, template),
            Then::Close => ctx.send_viewport_cmd(ViewportCommand::Close),
        }
    }

    /// Whether something may be done that gives up the text; if there are unsaved changes, it is asked first.
    pub(in crate::app) fn may_give_up(&mut self, then: impl FnOnce() -> Then) -> bool {
        let is_dirty = self.editing.document.is_dirty();
        if is_dirty {
            self.editing.guard = Some(Guard { then: then() });
        }
        !is_dirty
    }

    fn guard_closing(&mut self, ctx: &Context) {
        let asked = ctx.input(|input| input.viewport().close_requested());
        if asked && !self.may_give_up(|| Then::Close) {
            ctx.send_viewport_cmd(ViewportCommand::CancelClose);
        }
    }

    fn follow_text(&mut self, ctx: &Context) {
        let Some(open) = &self.open else { return };
        let (editing, recording) = (&mut self.editing, self.recording.as_ref());
        let revision = editing.document.revision();
        let order = || CompileOrder {
            text: editing.document.text().to_owned(),
            revision,
            name: editing.name.clone(),
            outside: self.outside,
            profile: open.look.as_ref().map(|look| look.profile),
            open: Some([Arc::clone(&open.whole), Arc::clone(&open.scene)]),
            pixel: recording.map(|recording| recording.pixel),
            before: recording
                .filter(|recording| Arc::ptr_eq(&recording.scene, &open.scene))
                .map(|recording| (Arc::clone(&recording.tree), recording.selected())),
        };
        editing.live.follow(ctx, revision, order);
        let Some(compiled) = editing.live.take() else { return };
        match compiled.outcome {
            Ok(followed) => {
                editing.shown = compiled.revision;
                if compiled.revision == revision {
                    editing.flaws.clear();
                }
                self.show_followed(ctx, followed);
            }
            Err(diagnostics) => editing.blame(compiled.revision, &diagnostics),
        }
    }

    /// The picture and the story follow the text; the selection and the views stay where they were.
    fn show_followed(&mut self, ctx: &Context, followed: Followed) {
        let Some(open) = &mut self.open else { return };
        (open.whole, open.scene) = (followed.whole, followed.scene);
        open.name.clone_from(&self.editing.name);
        self.renderer.follow(ctx, &open.scene);
        self.image.reset();
        self.effects.reset();
        self.accuracy.reset();
        // Another pixel may have been chosen meanwhile; then that one is recorded.
        let pixel = self.recording.as_ref().map_or(followed.pixel, |recording| recording.pixel);
        let size = [open.scene.image.width, open.scene.image.height];
        if pixel != followed.pixel && pixel[0] < size[0] && pixel[1] < size[1] {
            self.record(pixel);
            return;
        }
        let mut recording = Recording::of_tree(Arc::clone(&open.scene), followed.pixel, followed.tree, None);
        recording.changed = followed.changed;
        recording.select(followed.selected);
        self.show_elsewhere(recording);
        let selected = self.recording.as_ref().map_or(0, Recording::selected);
        self.editing.properties.event = Some((followed.pixel, selected));
    }

    /// What is selected in the story is edited.
    fn follow_selection(&mut self) {
        let (Some(open), Some(recording)) = (&self.open, &self.recording) else { return };
        if !Arc::ptr_eq(&open.scene, &recording.scene) {
            // It is of another scene, until the pixel is recorded anew.
            return;
        }
        let now = Some((recording.pixel, recording.selected()));
        if self.editing.properties.event != now {
            self.editing.properties.event = now;
            self.editing.follow_event(&open.scene, &recording.tree.event(recording.selected()).what);
        }
    }

    /// The pane of the text.
    pub(in crate::app) fn editor_pane(&mut self, ui: &mut Ui) {
        if self.editing.editor_ui(ui) {
            self.editing.follow_cursor();
        }
    }

    /// What the header of the text's pane says: whether it is saved, and whether the picture lags behind.
    pub(in crate::app) fn editor_state(&self, ctx: &Context) -> String {
        let saved = if self.editing.document.is_dirty() { "edit-unsaved" } else { "edit-saved" };
        let mut state = say(ctx, saved);
        if self.editing.looks_stale(ctx) {
            state = format!("{state} · {}", say(ctx, "edit-stale"));
        }
        let problem = self.editing.recovery.as_ref().and_then(Recovery::problem);
        problem.map_or(state.clone(), |why| {
            format!("{state} · {}", say_with(ctx, "edit-no-journal", &[("why", (&why).into())]))
        })
    }

    /// Before the picture takes keys: those that move things.
    pub(in crate::app) fn picture_keys(&mut self, ctx: &Context) {
        let (Some(open), Some((_, picture))) = (&self.open, self.image.seen) else { return };
        self.editing.move_by_keys(ctx, &open.scene, picture);
    }

    /// Over the picture: what is being edited, and the pointer that moves it.
    pub(in crate::app) fn picture_handles(&mut self, ui: &Ui) {
        let (Some(open), Some((place, _))) = (&self.open, self.image.seen) else { return };
        let scene = Arc::clone(&open.scene);
        let is_seen = self.editing.mover.is_on || self.editing.is_seen;
        if let Some(target) = self.editing.target.as_ref().filter(|_| is_seen) {
            if let Some(object) = object_at(target).and_then(|index| scene.objects.get(index)) {
                let extent = object.solid.extent();
                draw_box(ui.painter(), &scene, &place, extent.low, extent.high);
            }
            if let [Step::Field(list), Step::Item(index)] = &target.0[..]
                && list == "lights"
                && let Some(at) = place_of_light(&scene, *index)
            {
                draw_spot(ui.painter(), &scene, &place, at);
            }
        }
        self.editing.move_in_picture(ui, &scene, &place);
        if self.editing.looks_stale(ui.ctx()) {
            stale_mark(ui, &place);
        }
    }

    /// Over the side view: the pointer that moves things.
    pub(in crate::app) fn section_handles(&mut self, ui: &Ui) {
        if !self.editing.mover.is_on {
            return;
        }
        let (Some(open), Some((rect, plane))) = (&self.open, self.side.plane()) else { return };
        let scene = Arc::clone(&open.scene);
        self.editing.move_in_section(ui, &scene, rect, &plane);
    }

    /// The switch in the picture's header.
    pub(in crate::app) fn move_switch(&mut self, ui: &mut Ui) {
        let title = RichText::new(say(ui.ctx(), "edit-move"));
        let about = say(ui.ctx(), "edit-move-about");
        if ui.selectable_label(self.editing.mover.is_on, title).on_hover_text(about).clicked() {
            self.editing.mover.is_on = !self.editing.mover.is_on;
        }
    }

    /// Writes the text to its file, or asks where to.
    pub fn save(&mut self, ctx: &Context) {
        match self.editing.file() {
            Some(path) => {
                let expected = Some(self.editing.document.saved().to_owned());
                self.write(ctx, path, expected);
            }
            None => self.ask_where_to_save(ctx),
        }
    }

    /// Writes the text to a file, which it then belongs to.
    pub fn save_as(&mut self, ctx: &Context, path: PathBuf) {
        self.write(ctx, path, None);
    }

    fn write(&mut self, ctx: &Context, path: PathBuf, expected: Option<String>) {
        let copy_of = embedded_scene(&self.editing.name).filter(|_| self.editing.file().is_none());
        let pictures = copy_of.map(|scene| (scene.name, pictures_of(self.editing.whole())));
        let text = self.editing.document.text().to_owned();
        self.editing.saving.start(ctx, SaveOrder { path, text, expected, copy_of: pictures });
    }

    pub(in crate::app) fn ask_where_to_save(&mut self, ctx: &Context) {
        let name =
            Path::new(&self.editing.name).file_stem().map_or_else(String::new, |name| name.display().to_string());
        self.editing.saving.ask(ctx, say(ctx, "edit-save-as"), &format!("{name}.json"));
    }

    fn follow_saving(&mut self, ctx: &Context) {
        match self.editing.saving.chosen() {
            Place::File(path) => self.save_as(ctx, path),
            Place::Closed => self.editing.saving.then = None,
            Place::Missing => {
                self.editing.saving.then = None;
                let name = self.editing.name.clone();
                self.refuse_to_save(&name, say(ctx, "file-no-dialogue-to-save"));
            }
            Place::Waiting => {}
        }
        if let Some(written) = self.editing.saving.take() {
            self.note_written(ctx, written);
        }
    }

    fn note_written(&mut self, ctx: &Context, written: Written) {
        let name = written.path.display().to_string();
        match written.outcome {
            Ok(()) => {
                self.editing.document.mark_saved_as(&written.text);
                self.editing.is_staged = false;
                self.editing.name.clone_from(&name);
                if let Some(open) = &mut self.open {
                    open.name = name;
                }
                if let Some(then) = self.editing.saving.then.take() {
                    self.go_on(ctx, then);
                }
            }
            Err(refusal) => {
                self.editing.saving.then = None;
                let why = match refusal {
                    Refusal::Changed => say(ctx, "edit-changed-on-disk"),
                    Refusal::System(why) => say_with(ctx, "edit-not-saved", &[("why", (&why).into())]),
                };
                self.refuse_to_save(&name, why);
            }
        }
    }

    pub(in crate::app) fn begin_new(&mut self, ctx: &Context, template: Template) {
        if self.may_give_up(|| Then::New(template)) {
            self.begin_opening(ctx, &say(ctx, "edit-untitled"), Source::Text(template.text()), After::Nothing);
            self.reveal(Pane::Editor);
        }
    }

    pub(in crate::app) fn revert(&mut self, ctx: &Context) {
        self.editing.revert(&say(ctx, "edit-revert"));
    }
}

/// The mark on a picture of an older text, over all that lies on the picture.
fn stale_mark(ui: &Ui, place: &Placement) {
    let at = place.rect.left_top() + egui::vec2(6.0, 4.0);
    let text = say(ui.ctx(), "edit-stale");
    let galley = ui.painter().layout_no_wrap(text, egui::FontId::proportional(12.0), egui::Color32::WHITE);
    let back = egui::Rect::from_min_size(at, galley.size()).expand2(egui::vec2(5.0, 2.0));
    ui.painter().rect_filled(back, 3.0, egui::Color32::from_black_alpha(190));
    ui.painter().galley(at, galley, egui::Color32::WHITE);
}

/// Whether keys are typed into another field than the scene's text.
fn types_elsewhere(ctx: &Context) -> bool {
    ctx.text_edit_focused() && !Editor::has_focus(ctx)
}
