//! Drawings of the selected event that are no more than that: looked at, clicked, described.

use super::canvas::{Canvas, put};
use super::seen::{REACH, Seen, choice, describe, focus_ring};
use crate::app::frame::empty::empty;
use crate::app::frame::words::say;
use crate::app::story::recording::Recording;
use crate::record::EventId;
use crate::view::{
    Drawing, GenericLook, GenericViewOptions, csg_bars, generic_view, plane_table, shading_bars, snell_diagram,
};
use egui::{EventFilter, Key as KeyName, Response, Sense, Ui, Vec2};

/// What is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Linked {
    /// The primitive in its own space.
    Generic,
    /// The CSG tree of the object.
    Intervals,
    /// Snell's law.
    Snell,
    /// The terms of the colour.
    Shading,
    /// The plane table.
    Planes,
}

/// A drawing and what it was made for.
#[derive(Clone, PartialEq)]
struct Key {
    what: Linked,
    seen: Seen,
    look: GenericLook,
    row: Option<usize>,
}

impl Key {
    fn draw(&self) -> Option<Drawing> {
        let Seen { scene, tree, selected, probe_t, theme, .. } = &self.seen;
        let (selected, theme, size) = (*selected, *theme, self.seen.size());
        match self.what {
            Linked::Generic => {
                let options = GenericViewOptions { size, theme, look: self.look, probe_t: *probe_t };
                generic_view(scene, tree, selected, &options)
            }
            Linked::Intervals => csg_bars(scene, tree, selected, *probe_t, size, theme),
            Linked::Snell => snell_diagram(tree, selected, size, theme),
            Linked::Shading => shading_bars(tree, selected, size, theme),
            Linked::Planes => plane_table(tree, selected, self.row, size, theme).map(|table| table.drawing),
        }
    }

    const fn title(&self) -> &'static str {
        match self.what {
            Linked::Generic => "pane-generic",
            Linked::Intervals => "pane-intervals",
            Linked::Snell => "pane-snell",
            Linked::Shading => "pane-shading",
            Linked::Planes => "pane-planes",
        }
    }

    const fn nothing(&self) -> &'static str {
        match self.what {
            Linked::Generic => "drawings-no-generic",
            Linked::Intervals => "drawings-no-intervals",
            Linked::Snell => "drawings-no-snell",
            Linked::Shading => "drawings-no-shading",
            Linked::Planes => "drawings-no-planes",
        }
    }
}

/// A panel with one drawing.
pub struct LinkedPane {
    what: Linked,
    look: GenericLook,
    /// The last row of the plane table that is filled in; all of them where it is none.
    row: Option<usize>,
    canvas: Canvas<Key>,
}

impl LinkedPane {
    /// A panel for this drawing.
    #[must_use]
    pub fn new(what: Linked) -> Self {
        Self { what, look: GenericLook::default(), row: None, canvas: Canvas::default() }
    }

    /// Shows the drawing; returns the event whose mark was clicked.
    pub fn ui(&mut self, ui: &mut Ui, recording: &Recording) -> Option<EventId> {
        let rect = ui.available_rect_before_wrap();
        let seen = Seen::of(ui, recording, rect);
        let key = Key { what: self.what, seen, look: self.look, row: self.row };
        let wanted = key.clone();
        let shown = self.canvas.update(ui.ctx(), &key, move || wanted.draw())?;
        let (Some(texture), Some(drawing)) = (&shown.texture, &shown.drawing) else {
            empty(ui, &say(ui.ctx(), key.nothing()));
            return None;
        };
        let response = ui.interact(rect, ui.scope_id().with(key.title()), Sense::click());
        describe(ui, &response, key.title(), drawing);
        let place = put(&ui.painter_at(rect), texture, rect.min);
        focus_ring(ui, &response);
        let clicked = response.clicked().then(|| response.interact_pointer_pos()).flatten();
        if clicked.is_some() {
            response.request_focus();
        }
        let local = clicked.filter(|_| shown.key == key).map(|at| at - place.min);
        let event = local.and_then(|at: Vec2| drawing.event_at([f64::from(at.x), f64::from(at.y)], REACH));
        if self.what == Linked::Planes {
            self.choose_row(ui, &response, &key, local);
        }
        event
    }

    /// The row of the plane table that is clicked, or that the arrow keys lead to.
    fn choose_row(&mut self, ui: &Ui, response: &Response, key: &Key, local: Option<Vec2>) {
        let (asks, moves) = (local.is_some(), response.has_focus());
        if !(asks || moves) {
            return;
        }
        let Seen { tree, selected, theme, .. } = &key.seen;
        let Some(table) = plane_table(tree, *selected, None, key.seen.size(), *theme) else { return };
        let last = table.count.saturating_sub(1);
        if let Some(at) = local {
            let at = [f64::from(at.x), f64::from(at.y)];
            self.row = table.rows.iter().position(|row| row.contains(at)).or(self.row);
        }
        if moves {
            let filter = EventFilter { vertical_arrows: true, ..EventFilter::default() };
            ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
            let row = self.row.unwrap_or(last).min(last);
            let [up, down] = [KeyName::ArrowUp, KeyName::ArrowDown].map(|key| ui.input(|input| input.key_pressed(key)));
            match (up, down) {
                (true, false) => self.row = Some(row.saturating_sub(1)),
                (false, true) => self.row = Some((row + 1).min(last)),
                _ => {}
            }
        }
    }

    /// The choices at the right end of the header, from right to left.
    pub fn tools(&mut self, ui: &mut Ui) {
        match self.what {
            Linked::Generic => {
                let looks = [(GenericLook::Section, "drawings-section"), (GenericLook::Space, "drawings-space")];
                choice(ui, &mut self.look, &looks);
            }
            Linked::Planes => {
                let all = ui.add_enabled(self.row.is_some(), egui::Button::new(say(ui.ctx(), "drawings-all-rows")));
                if all.on_hover_text(say(ui.ctx(), "drawings-all-rows-about")).clicked() {
                    self.row = None;
                }
            }
            Linked::Intervals | Linked::Snell | Linked::Shading => {}
        }
    }
}
