//! The document that is open, with everything that is known of it and how it is being edited.

use crate::app::edit::analysis::Analysis;
use crate::app::edit::dialog::Guard;
use crate::app::edit::editor::Editor;
use crate::app::edit::live::Live;
use crate::app::edit::mover::Mover;
use crate::app::edit::properties::Properties;
use crate::app::edit::recovery::Recovery;
use crate::app::edit::saving::Saving;
use crate::document::{
    Cause, Document, Flaw, Place, Recovered, Selection, Structure, Target, flaws, object_and_leaf, object_at,
    place_of_leaf,
};
use crate::record::What;
use crate::scene::{Diagnostics, Scene};
use egui::Context;
use serde_json::Value;
use std::path::{Path, PathBuf};

/// The state of editing.
#[derive(Default)]
pub struct Editing {
    /// The text with its history.
    pub document: Document,
    /// The scene's name, or its file's.
    pub name: String,
    /// Whether it was opened by a lesson: then what is changed in it was only tried out.
    pub is_staged: bool,
    /// What is read of the text.
    pub analysis: Analysis,
    /// What is wrong with the text, and the revision that it is about.
    pub flaws: Vec<Flaw>,
    /// The revision that the picture and the story show.
    pub shown: u64,
    /// Whether a panel is seen in which things are edited: then the thing is marked in the picture.
    pub is_seen: bool,
    /// Where the thing stands that is being edited.
    pub target: Option<Place>,
    /// Whether that is a part which nobody chose, but which was hit: then the whole object is moved.
    pub is_guess: bool,
    /// Compiles the text.
    pub live: Live,
    /// The pane of the text.
    pub editor: Editor,
    /// The pane of properties.
    pub properties: Properties,
    /// Moving things in the picture.
    pub mover: Mover,
    /// Writing files.
    pub saving: Saving,
    /// A question that has to be answered first.
    pub guard: Option<Guard>,
    /// What is kept in case of a crash; none where nothing is to be written.
    pub recovery: Option<Recovery>,
}

impl Editing {
    /// Begins anew with a text that is compiled already.
    pub fn open(&mut self, name: &str, text: &str) {
        self.document = Document::new(text);
        name.clone_into(&mut self.name);
        self.is_staged = false;
        self.analysis.reset();
        self.analysis.follow(&self.document);
        self.flaws.clear();
        self.shown = self.document.revision();
        self.target = None;
        self.properties = Properties::default();
        self.live.reset(self.document.revision());
        self.editor.reset();
    }

    /// Takes up an edit that was left behind, over the text that is open.
    pub fn take_up(&mut self, recovered: &Recovered, cause: &str) {
        let name = std::mem::take(&mut self.name);
        self.open(&name, &recovered.saved);
        self.document.rewrite(&recovered.text, recovered.selection, Cause::new(cause));
        self.analysis.follow(&self.document);
    }

    /// Whether the picture and the story show an older text.
    #[must_use]
    pub fn is_stale(&self) -> bool {
        self.shown != self.document.revision()
    }

    /// Whether that has to be said: not in the moments in which a new text is being compiled.
    #[must_use]
    pub fn looks_stale(&self, ctx: &Context) -> bool {
        self.is_stale() && (!self.flaws.is_empty() || self.live.waits_long(ctx))
    }

    /// The file that the text is saved to; none for scenes that come with the program, and new ones.
    #[must_use]
    pub fn file(&self) -> Option<PathBuf> {
        let path = Path::new(&self.name);
        path.is_file().then(|| path.to_owned())
    }

    /// Changes values of the text, everything else staying as it is; returns whether anything changed.
    pub fn set(&mut self, settings: &[(Place, Value)], cause: &Cause) -> bool {
        let mut changed = false;
        for (place, value) in settings {
            changed |= self.restructure(cause.clone(), |structure| structure.set(place, value));
        }
        changed
    }

    /// Changes the structure of the text; returns whether anything changed.
    pub fn restructure(
        &mut self,
        cause: Cause,
        change: impl FnOnce(Structure) -> Option<Vec<crate::document::Replacement>>,
    ) -> bool {
        self.analysis.follow(&self.document);
        let structure = Structure { text: self.document.text(), syntax: &self.analysis.syntax };
        let Some(replacements) = change(structure) else { return false };
        let changed = self.document.replace(replacements, cause);
        self.analysis.follow(&self.document);
        changed
    }

    /// Takes the last change back.
    pub fn undo(&mut self) {
        self.document.undo();
        self.after_jump();
    }

    /// Makes the change again that was taken back.
    pub fn redo(&mut self) {
        self.document.redo();
        self.after_jump();
    }

    /// Goes back to the text as it was saved; that, too, can be taken back.
    pub fn revert(&mut self, cause: &str) {
        let saved = self.document.saved().to_owned();
        self.document.rewrite(&saved, Selection::at(0), Cause::new(cause));
        self.after_jump();
    }

    fn after_jump(&mut self) {
        self.analysis.follow(&self.document);
        self.editor.show_cursor();
    }

    /// Notes what is wrong with the text of this revision.
    pub fn blame(&mut self, revision: u64, diagnostics: &Diagnostics) {
        if revision == self.document.revision() {
            self.flaws = flaws(self.document.text(), &self.analysis.syntax, diagnostics);
        }
    }

    /// Puts the cursor on the next thing that is wrong, from the last one back to the first.
    pub fn next_flaw(&mut self) {
        let cursor = self.document.selection().head;
        let next = self.flaws.iter().find(|flaw| flaw.range.start > cursor).or_else(|| self.flaws.first());
        if let Some(flaw) = next {
            let selection = Selection { anchor: flaw.range.end, head: flaw.range.start };
            self.document.select(selection);
            self.editor.show_cursor();
            self.editor.wants_focus = true;
        }
    }

    /// The thing that is being edited.
    #[must_use]
    pub fn target(&self) -> Option<&Target> {
        let place = self.target.as_ref()?;
        self.analysis.targets.iter().find(|target| target.place == *place)
    }

    /// Edits the thing at a place; the editor shows it.
    pub fn choose(&mut self, place: Place) {
        if let Some(range) = self.analysis.syntax.range(&place) {
            self.document.select(Selection::at(range.start));
            self.editor.show_cursor();
        }
        (self.target, self.is_guess) = (Some(place), false);
    }

    /// What is moved: the thing that is being edited, or the object of a part that was only hit.
    #[must_use]
    pub fn movable(&self) -> Option<Place> {
        let target = self.target.as_ref()?;
        let object = object_at(target).filter(|_| self.is_guess);
        Some(object.map_or_else(|| target.clone(), |index| Place::ROOT.field("objects").item(index)))
    }

    /// Edits what the cursor is in.
    pub fn follow_cursor(&mut self) {
        let place = self.analysis.syntax.place_at(self.document.selection().head);
        if let Some(target) = self.analysis.target_of(&place) {
            (self.target, self.is_guess) = (Some(self.analysis.targets[target].place.clone()), false);
        }
    }

    /// Edits the object that an event is about, or the part of it that is meant.
    pub fn follow_event(&mut self, scene: &Scene, what: &What) {
        let (What::Hit { object, leaf, .. } | What::Rejected { object, leaf, .. }) = what else { return };
        if let Some((object, leaf)) = object_and_leaf(&scene.objects, object, leaf) {
            self.choose(place_of_leaf(&self.analysis.whole, object, leaf));
            self.is_guess = true;
        }
    }

    /// The values of the text.
    #[must_use]
    pub const fn whole(&self) -> &Value {
        &self.analysis.whole
    }
}
