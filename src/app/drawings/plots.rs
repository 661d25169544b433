//! Interval bars, the sign plot of d(t), and the drawing of what else happened: what a surface carries, a lens, wavelengths, a medium;
//! all for the selected event.

use crate::app::drawings::canvas::{Canvas, put};
use crate::app::drawings::seen::describe;
use crate::app::frame::empty::empty;
use crate::app::frame::theme::drawing_theme;
use crate::app::frame::words::say;
use crate::app::story::recording::Recording;
use crate::record::EventId;
use crate::scene::Scene;
use crate::trace::RayTree;
use crate::view::{Drawing, Theme, event_plot, probed_interval_bars, probed_sign_plot};
use egui::{Rect, ScrollArea, Sense, Ui, pos2, vec2};
use std::sync::Arc;

/// How far from a mark a click still counts, in points. Less makes thin lines hard to hit.
const REACH: f64 = 5.0;

/// The plots' heights as parts of each other: three lists with labels need more than one curve, and a drawing
/// with its caption and its legend needs most.
const HEIGHTS: [f32; 3] = [1.27, 1.0, 1.8];

/// The least heights in which they can be read, in points: lower, they are scrolled.
const LEAST: [f32; 3] = [138.0, 100.0, 165.0];
/// In a narrower panel the bars' caption needs two lines, in points.
const NARROW: f32 = 420.0;
/// Height of a line of a caption, in points.
const LINE: f32 = 18.0;

/// What there is to plot of an event.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Plot {
    Bars,
    Signs,
    Event,
}

impl Plot {
    /// Its name in the catalogue of words.
    const fn word(self) -> &'static str {
        match self {
            Self::Bars => "drawings-bars",
            Self::Signs => "drawings-sign-plot",
            Self::Event => "drawings-event",
        }
    }

    fn draw(self, key: &Key) -> Option<Drawing> {
        let size = key.size.map(f64::from);
        match self {
            Self::Bars => probed_interval_bars(&key.tree, key.selected, key.probe_t, size, key.theme),
            Self::Signs => probed_sign_plot(&key.scene, &key.tree, key.selected, key.probe_t, size, key.theme)
                .map(|plot| plot.drawing),
            Self::Event => event_plot(Some(&key.scene), &key.tree, key.selected, size, key.theme),
        }
    }
}

/// Everything that a plot depends on.
#[derive(Clone)]
struct Key {
    scene: Arc<Scene>,
    tree: Arc<RayTree>,
    selected: EventId,
    probe_t: Option<f64>,
    size: [u32; 2],
    theme: Theme,
    pixels_per_point: f32,
}

impl PartialEq for Key {
    fn eq(&self, other: &Self) -> bool {
        let rest = |key: &Self| (key.selected, key.probe_t, key.size, key.theme, key.pixels_per_point);
        Arc::ptr_eq(&self.tree, &other.tree) && rest(self) == rest(other)
    }
}

/// The plots, one above the other.
#[derive(Default)]
pub struct PlotsPanel {
    bars: Canvas<Key>,
    signs: Canvas<Key>,
    event: Canvas<Key>,
    /// Which of the three there is, as far as is known.
    present: [bool; 3],
}

impl PlotsPanel {
    /// Shows what there is to plot of the selected event; returns the event whose mark was clicked.
    pub fn ui(&mut self, ui: &mut Ui, recording: Option<&Recording>) -> Option<EventId> {
        let nothing = "drawings-along-none";
        let Some(recording) = recording else {
            empty(ui, &say(ui.ctx(), nothing));
            return None;
        };
        let whole = ui.available_rect_before_wrap();
        let least = least(self.present, whole.width() < NARROW);
        if whole.height() >= least {
            let clicked = self.plots(ui, recording, whole);
            if self.present == [false; 3] {
                empty(ui, &say(ui.ctx(), nothing));
            }
            return clicked;
        }
        let scroll = ScrollArea::vertical().auto_shrink(false).id_salt("along");
        let shown = scroll.show(ui, |ui| {
            let (whole, _) = ui.allocate_exact_size(vec2(ui.available_width(), least), Sense::hover());
            self.plots(ui, recording, whole)
        });
        shown.inner
    }

    fn plots(&mut self, ui: &Ui, recording: &Recording, whole: Rect) -> Option<EventId> {
        let [upper, middle, lower] = rows(whole, self.present);
        let plotted = recording.plotted();
        let look = |canvas: &mut Canvas<Key>, plot, event, rect| show(ui, canvas, plot, recording, event, rect);
        let bars = look(&mut self.bars, Plot::Bars, plotted.intervals, upper);
        let signs = look(&mut self.signs, Plot::Signs, plotted.signs, middle);
        let event = look(&mut self.event, Plot::Event, recording.selected(), lower);
        let present = [bars.present, signs.present, event.present];
        if present != self.present {
            self.present = present;
            ui.ctx().request_repaint();
        }
        bars.clicked.or(signs.clicked).or(event.clicked)
    }
}

/// Where the plots go, one below the other: what is present shares the height, and what is not takes none of it. Until
/// something is known to be present, all have room.
fn rows(whole: Rect, present: [bool; 3]) -> [Rect; 3] {
    let all = present == [false; 3];
    let parts: [f32; 3] = std::array::from_fn(|i| if all || present[i] { HEIGHTS[i] } else { 0.0 });
    let height = whole.height() / parts.iter().sum::<f32>();
    let mut top = whole.top();
    std::array::from_fn(|i| {
        // What is not present now is drawn as large as it may become, not in a row of no height.
        if parts[i] == 0.0 {
            return whole;
        }
        let bottom = (top + parts[i] * height).round();
        let row = Rect::from_min_max(pos2(whole.left(), top), pos2(whole.right(), bottom.min(whole.bottom())));
        top = bottom;
        row
    })
}

/// The least height of what is present, so that each plot has its own.
fn least(present: [bool; 3], is_narrow: bool) -> f32 {
    let plots = (0..3).filter(|i| present[*i]);
    let parts: f32 = plots.clone().map(|i| HEIGHTS[i]).sum();
    let more = if is_narrow { [LINE, 0.0, 0.0] } else { [0.0; 3] };
    parts * plots.map(|i| (LEAST[i] + more[i]) / HEIGHTS[i]).fold(0.0, f32::max)
}

/// What became of a plot.
struct Shown {
    /// Whether there is one, or was one when it was last drawn.
    present: bool,
    clicked: Option<EventId>,
}

fn show(ui: &Ui, canvas: &mut Canvas<Key>, plot: Plot, recording: &Recording, selected: EventId, rect: Rect) -> Shown {
    let inside = rect.shrink(4.0);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a panel is a few thousand points")]
    let size = [inside.width().max(1.0) as u32, inside.height().max(1.0) as u32];
    let key = Key {
        scene: Arc::clone(&recording.scene),
        tree: Arc::clone(&recording.tree),
        selected,
        probe_t: recording.probe_t,
        size,
        theme: drawing_theme(ui.ctx()),
        pixels_per_point: ui.pixels_per_point(),
    };
    let wanted = key.clone();
    let mut outcome = Shown { present: false, clicked: None };
    let Some(shown) = canvas.update(ui.ctx(), &key, move || plot.draw(&wanted)) else { return outcome };
    let (Some(texture), Some(drawing)) = (&shown.texture, &shown.drawing) else { return outcome };
    outcome.present = true;
    let response = ui.interact(rect, ui.scope_id().with(plot.word()), Sense::click());
    describe(ui, &response, plot.word(), drawing);
    let place = put(&ui.painter_at(rect), texture, inside.min);
    if let (true, Some(at)) = (response.clicked() && shown.key == key, response.interact_pointer_pos()) {
        let local = at - place.min;
        outcome.clicked = drawing.event_at([f64::from(local.x), f64::from(local.y)], REACH);
    }
    outcome
}
