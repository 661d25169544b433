//! The panel: pins, what is compared, and where it differs for the first time.

use super::foreign::{Foreign, Shown};
use super::pictures::Pictures;
use super::pin::Pin;
use super::rows;
use super::stories::{Stories, StoriesJob};
use crate::app::frame::empty::empty;
use crate::app::frame::file_dialog::FileDialog;
use crate::app::frame::ticks;
use crate::app::frame::words::{say, say_with};
use crate::app::story::recording::Recording;
use crate::app::workbench::{OpenScene, Workbench};
use crate::compare::Departure;
use crate::record::EventId;
use egui::{ComboBox, Context, RichText, ScrollArea, TextEdit, Ui};
use std::sync::Arc;

/// What is shown of a comparison.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Page {
    /// The events side by side.
    #[default]
    Stories,
    /// The pictures.
    Pictures,
    /// Another ray tracer's story.
    Foreign,
}

/// Names of pins are given no more width than this, in points.
const WIDEST_NAME: f32 = 240.0;

/// The rows are given no less height than this, in points: the panel scrolls instead.
const LOWEST_ROWS: f32 = 132.0;

/// What the panel remembers between frames.
#[derive(Default)]
pub struct ComparePane {
    pins: Vec<Pin>,
    chosen: usize,
    page: Page,
    stories: StoriesJob,
    pictures: Pictures,
    foreign: Foreign,
    dialog: FileDialog,
    shows_all: bool,
    row: Option<usize>,
    scroll: Option<usize>,
}

/// What the panel asks for.
pub enum Wish {
    /// Shows a story at an event.
    Show(Pin, EventId),
}

impl ComparePane {
    /// Keeps the story that is shown.
    pub fn pin(&mut self, recording: &Recording, open: &OpenScene) {
        let mut pin = Pin::of(recording, open);
        let name = pin.name.clone();
        let mut number = 2;
        while self.pins.iter().any(|other| other.name == pin.name) {
            pin.name = format!("{name} #{number}");
            number += 1;
        }
        self.pins.push(pin);
        self.chosen = self.pins.len() - 1;
        self.page = Page::Stories;
        self.row = None;
    }

    /// How many stories are pinned.
    pub const fn pins(&self) -> usize {
        self.pins.len()
    }

    /// Whether there is a comparison to go through.
    pub fn has_stories(&self) -> bool {
        self.stories.shown().is_some()
    }

    /// Takes away the pinned story that is compared with.
    pub fn unpin(&mut self) {
        if self.chosen < self.pins.len() {
            self.pins.remove(self.chosen);
        }
        self.chosen = self.chosen.min(self.pins.len().saturating_sub(1));
        self.stories.reset();
        self.row = None;
    }

    /// Opens the dialogue for what another ray tracer printed.
    pub fn ask_for_foreign(&mut self, ctx: &Context) {
        let (title, kind) = (say(ctx, "compare-open"), say(ctx, "compare-files"));
        self.dialog.open_for(ctx, title, kind, &["jsonl", "json", "txt"]);
    }

    /// Takes in what another ray tracer printed.
    pub fn open_foreign(&mut self, name: &str, text: &str) {
        self.page = Page::Foreign;
        self.foreign.open(name, text);
    }

    /// Reads the file that was chosen; returns whether there was one.
    pub fn take_file(&mut self) -> bool {
        let Some(picked) = self.dialog.chosen() else { return false };
        match picked.whole() {
            Ok(text) => self.open_foreign(&picked.name, &text),
            Err(error) => {
                self.page = Page::Foreign;
                self.foreign.refuse(&picked.name, error);
            }
        }
        true
    }

    /// Goes to the next difference, or back to the one before.
    pub fn go(&mut self, is_forward: bool) -> Option<Wish> {
        let stories = Arc::clone(self.stories.shown()?);
        let row = stories.neighbour(self.row, is_forward)?;
        self.page = Page::Stories;
        self.scroll = Some(row);
        self.choose(&stories, row)
    }

    /// Chooses a row: its event is shown, in our story if it has one there.
    fn choose(&mut self, stories: &Stories, row: usize) -> Option<Wish> {
        self.row = Some(row);
        let pair = stories.pairs.pairs.get(row)?;
        match (pair.left, pair.right) {
            (Some(event), _) => Some(Wish::Show(stories.left.clone(), event)),
            (None, Some(event)) => Some(Wish::Show(stories.right.clone(), event)),
            (None, None) => None,
        }
    }

    /// Shows the panel; returns what it asks for.
    pub fn ui(&mut self, ui: &mut Ui, open: &OpenScene, recording: Option<&Recording>) -> Option<Wish> {
        self.head(ui, open, recording);
        ui.separator();
        let here = recording.map(|recording| Pin::of(recording, open));
        match self.page {
            Page::Foreign => self.foreign.ui(ui, &open.scene).map(|shown| {
                let Shown { scene, pixel, tree, event } = shown;
                Wish::Show(Pin { name: String::new(), scene, pixel, tree: Arc::new(tree) }, event)
            }),
            Page::Stories | Page::Pictures => {
                let (Some(here), Some(pin)) = (here, self.pins.get(self.chosen).cloned()) else {
                    empty(ui, &say(ui.ctx(), "compare-nothing"));
                    return None;
                };
                let room = ui.available_height();
                let scroll = ScrollArea::vertical().id_salt("compare").auto_shrink(false);
                scroll.show(ui, |ui| self.pages_ui(ui, here, &pin, room)).inner
            }
        }
    }

    /// The pinned story or its picture beside the one that is shown, in a panel of this height. It scrolls where that is too low
    /// for it.
    fn pages_ui(&mut self, ui: &mut Ui, here: Pin, pin: &Pin, room: f32) -> Option<Wish> {
        if self.page == Page::Stories {
            return self.stories_ui(ui, &here, pin, room);
        }
        // While the pinned story is looked at, its picture is still compared with the one that was.
        let shown = self.stories.shown().filter(|shown| shown.right.is(&pin.tree) && pin.is(&here.tree));
        let left = shown.map_or(here, |shown| shown.left.clone());
        self.pictures.ui(ui, &left, pin, room);
        None
    }

    fn head(&mut self, ui: &mut Ui, open: &OpenScene, recording: Option<&Recording>) {
        ui.horizontal_wrapped(|ui| {
            if let Some(recording) = recording
                && ui.button(say(ui.ctx(), "compare-pin")).on_hover_text(say(ui.ctx(), "compare-pin-about")).clicked()
            {
                self.pin(recording, open);
            }
            if !self.pins.is_empty() && ui.button(say(ui.ctx(), "compare-unpin")).clicked() {
                self.unpin();
            }
            if ui.button(say(ui.ctx(), "compare-open")).on_hover_text(say(ui.ctx(), "compare-open-about")).clicked() {
                self.ask_for_foreign(&ui.ctx().clone());
            }
            for (page, word) in [
                (Page::Stories, "compare-page-stories"),
                (Page::Pictures, "compare-page-pictures"),
                (Page::Foreign, "compare-page-foreign"),
            ] {
                if page != Page::Foreign || self.foreign.is_open() {
                    let words = say(ui.ctx(), word);
                    ui.selectable_value(&mut self.page, page, words);
                }
            }
        });
        if !self.pins.is_empty() {
            self.choice(ui);
        }
    }

    /// Which pin, and its name: each in a line of its own, beside its label.
    fn choice(&mut self, ui: &mut Ui) {
        let before = self.chosen;
        ui.horizontal(|ui| {
            let label = ui.label(say(ui.ctx(), "compare-with"));
            let current = self.pins.get(self.chosen).map_or_else(String::new, |pin| pin.name.clone());
            let width = WIDEST_NAME.min(ui.available_width());
            let combo = ComboBox::from_id_salt("pins").selected_text(current).width(width).truncate();
            let shown = combo.show_ui(ui, |ui| {
                for (place, pin) in self.pins.iter().enumerate() {
                    ui.selectable_value(&mut self.chosen, place, &pin.name);
                }
            });
            shown.response.labelled_by(label.id);
        });
        if before != self.chosen {
            self.row = None;
        }
        if let Some(pin) = self.pins.get_mut(self.chosen) {
            ui.horizontal(|ui| {
                let label = ui.label(say(ui.ctx(), "compare-name"));
                ui.add(TextEdit::singleline(&mut pin.name).desired_width(WIDEST_NAME.min(ui.available_width() - 8.0)))
                    .labelled_by(label.id);
            });
        }
    }

    fn stories_ui(&mut self, ui: &mut Ui, here: &Pin, pin: &Pin, room: f32) -> Option<Wish> {
        let top = ui.cursor().top();
        let stories = self.stories.update(ui.ctx(), here, pin).map(Arc::clone);
        let Some(stories) = stories else {
            let word = if self.stories.is_running() { "compare-working" } else { "compare-nothing" };
            ui.label(say(ui.ctx(), word));
            return None;
        };
        let [same, changed, left, right] = stories.pairs.counts();
        if stories.pairs.is_empty() {
            ui.label(say_with(ui.ctx(), "compare-no-difference", &[("events", same.into())]));
        } else {
            let arguments =
                [("same", same.into()), ("changed", changed.into()), ("left", left.into()), ("right", right.into())];
            ui.label(say_with(ui.ctx(), "compare-counts", &arguments));
        }
        let mut wish = self.departure(ui, &stories, "compare-first", stories.first.as_ref());
        let parting = stories
            .parting
            .as_ref()
            .filter(|parting| stories.first.as_ref().is_none_or(|first| first.row != parting.row));
        wish = wish.or(self.departure(ui, &stories, "compare-parting", parting));
        let words = say(ui.ctx(), "compare-all-rows");
        ticks::checkbox(ui, &mut self.shows_all, words);
        let all: Vec<usize>;
        let list = if self.shows_all {
            all = (0..stories.pairs.pairs.len()).collect();
            &all
        } else {
            &stories.different
        };
        let scroll = self.scroll.take();
        let height = (room - (ui.cursor().top() - top) - 1.0).max(LOWEST_ROWS);
        let clicked = rows::ui(ui, &stories, list, self.row, scroll, height);
        clicked.and_then(|row| self.choose(&stories, row)).or(wish)
    }

    /// Where they differ, with buttons to go there in both; returns what they ask for.
    fn departure(&mut self, ui: &mut Ui, stories: &Stories, word: &str, departure: Option<&Departure>) -> Option<Wish> {
        let departure = departure?;
        let mut wish = None;
        ui.horizontal_wrapped(|ui| {
            ui.label(RichText::new(say_with(ui.ctx(), word, &[("event", (&departure.event).into())])).strong());
            ui.label(&departure.why);
            if ui.button(say(ui.ctx(), "compare-go-here")).clicked() {
                wish = Some(Wish::Show(stories.left.clone(), departure.left));
            }
            if ui.button(say(ui.ctx(), "compare-go-there")).clicked() {
                wish = Some(Wish::Show(stories.right.clone(), departure.right));
            }
        });
        if wish.is_some() {
            (self.row, self.scroll) = (Some(departure.row), Some(departure.row));
        }
        wish
    }
}

impl Workbench {
    /// Does what the panel asks for.
    pub(in crate::app) fn grant_comparison(&mut self, wish: Wish) {
        let Wish::Show(pin, event) = wish;
        if !self.recording.as_ref().is_some_and(|recording| pin.is(&recording.tree)) {
            self.show_elsewhere(pin.recording());
        }
        self.select(event);
    }

    /// Keeps the story that is shown, to be compared with.
    pub fn pin_story(&mut self) {
        if let (Some(recording), Some(open)) = (&self.recording, &self.open) {
            self.compare.pin(recording, open);
        }
    }

    /// Compares with what another ray tracer printed.
    pub fn open_foreign(&mut self, name: &str, text: &str) {
        self.compare.open_foreign(name, text);
        self.dock.reveal(crate::app::pane::Pane::Compare);
    }
}
