//! Editing and saving the scene's text.

use super::Commands;
use crate::app::edit::editor::Editor;
use crate::app::pane::Pane;
use crate::app::workbench::Workbench;
use crate::document::Template;
use egui::{Context, Key, KeyboardShortcut, Modifiers};

/// A command about the scene's text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EditCommand {
    /// Takes the last change back.
    Undo,
    /// Makes the change again that was taken back.
    Redo,
    /// Writes the text to its file.
    Save,
    /// Writes the text to another file.
    SaveAs,
    /// Begins a new scene.
    New(Template),
    /// Goes back to the text as it was saved.
    Revert,
    /// Finds words in the text.
    Find,
    /// Shows what can be written at the cursor.
    Complete,
    /// Goes to the next error.
    NextError,
    /// Lets things be moved in the picture.
    Move,
}

impl Commands for EditCommand {
    const ALL: &'static [Self] = &[
        Self::Undo,
        Self::Redo,
        Self::Save,
        Self::SaveAs,
        Self::New(Template::Ball),
        Self::New(Template::Carved),
        Self::New(Template::Glass),
        Self::Revert,
        Self::Find,
        Self::Complete,
        Self::NextError,
        Self::Move,
    ];

    fn word(self) -> &'static str {
        match self {
            Self::Undo => "edit-undo",
            Self::Redo => "edit-redo",
            Self::Save => "edit-save",
            Self::SaveAs => "edit-save-as",
            Self::New(Template::Ball) => "edit-new-ball",
            Self::New(Template::Carved) => "edit-new-carved",
            Self::New(Template::Glass) => "edit-new-glass",
            Self::Revert => "edit-revert",
            Self::Find => "edit-find-words",
            Self::Complete => "edit-complete",
            Self::NextError => "edit-next-error",
            Self::Move => "edit-move",
        }
    }

    fn key(self) -> Option<KeyboardShortcut> {
        let with = |modifiers, key| Some(KeyboardShortcut::new(modifiers, key));
        let shifted = Modifiers::COMMAND.plus(Modifiers::SHIFT);
        match self {
            Self::Undo => with(Modifiers::COMMAND, Key::Z),
            Self::Redo => with(shifted, Key::Z),
            Self::Save => with(Modifiers::COMMAND, Key::S),
            Self::SaveAs => with(shifted, Key::S),
            Self::New(Template::Ball) => with(Modifiers::COMMAND, Key::N),
            Self::New(_) | Self::Revert => None,
            Self::Find => with(Modifiers::COMMAND, Key::F),
            Self::Complete => with(Modifiers::COMMAND, Key::Space),
            Self::NextError => with(Modifiers::NONE, Key::F8),
            Self::Move => with(Modifiers::NONE, Key::M),
        }
    }

    fn is_possible(self, workbench: &Workbench) -> bool {
        let editing = &workbench.editing;
        let ctx = workbench.ctx();
        // Other text fields take their own typing back.
        let is_free = !ctx.text_edit_focused() || Editor::has_focus(&ctx);
        let is_open = workbench.scene().is_some();
        match self {
            Self::Undo => is_free && editing.document.undo_name().is_some(),
            Self::Redo => is_free && editing.document.redo_name().is_some(),
            Self::Save | Self::Revert => editing.document.is_dirty(),
            Self::NextError => !editing.flaws.is_empty(),
            Self::New(_) => true,
            Self::SaveAs | Self::Find | Self::Complete | Self::Move => is_open,
        }
    }

    fn is_on(self, workbench: &Workbench) -> Option<bool> {
        (self == Self::Move).then_some(workbench.editing.mover.is_on)
    }

    fn run(self, workbench: &mut Workbench, ctx: &Context) {
        match self {
            Self::Undo => workbench.editing.undo(),
            Self::Redo => workbench.editing.redo(),
            Self::Save => workbench.save(ctx),
            Self::SaveAs => workbench.ask_where_to_save(ctx),
            Self::New(template) => workbench.begin_new(ctx, template),
            Self::Revert => workbench.revert(ctx),
            Self::Find => {
                workbench.reveal(Pane::Editor);
                workbench.editing.editor.finder.open();
            }
            Self::Complete => {
                workbench.reveal(Pane::Editor);
                workbench.editing.editor.ask_for_completion();
            }
            Self::NextError => {
                workbench.reveal(Pane::Editor);
                workbench.editing.next_flaw();
            }
            Self::Move => workbench.editing.mover.is_on = !workbench.editing.mover.is_on,
        }
    }
}
