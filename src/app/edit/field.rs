//! The widget that changes a property.

use crate::app::frame::ticks;
use crate::app::frame::words::say;
use crate::document::{Control, Property, Range, decimals_for, rounded};
use egui::{Color32, ComboBox, DragValue, Response, RichText, Slider, TextEdit, Ui, color_picker};
use serde_json::{Value, json};

/// Width of a field for a text, in points: names are short.
const TEXT: f32 = 320.0;

/// What was done with the widget.
#[derive(Debug, Default)]
pub struct Change {
    /// The new value.
    pub value: Option<Value>,
    /// Whether a gesture ended: what comes next is another change.
    pub ended: bool,
}

impl Change {
    fn note(&mut self, response: &Response) -> bool {
        self.ended |= response.drag_stopped() || response.lost_focus();
        response.changed()
    }
}

/// Shows the widget of a property; its name is read out by the label before it.
pub fn ui(ui: &mut Ui, property: &Property, label: egui::Id) -> Change {
    let mut change = Change::default();
    match &property.control {
        Control::Number(value, range) => number(ui, *value, *range, &property.name, label, &mut change),
        Control::Numbers(values, range) => numbers(ui, values, *range, &property.name, &mut change),
        Control::Colour(colour) => self::colour(ui, *colour, &property.name, &mut change),
        Control::Choice(word, words) => choice(ui, property, word, words, label, &mut change),
        Control::Name(name, names) => {
            let names: Vec<_> = names.iter().map(|name| (name.clone(), String::new())).collect();
            choice(ui, property, name, &names, label, &mut change);
        }
        Control::Switch(on) => {
            let mut on = *on;
            let response = ticks::checkbox(ui, &mut on, "").labelled_by(label);
            if change.note(&response) {
                change.value = Some(json!(on));
            }
        }
        Control::Text(text) => {
            let mut text = text.clone();
            let edit = TextEdit::singleline(&mut text).desired_width(TEXT).id_salt(property.place.to_string());
            let response = ui.add(edit).labelled_by(label);
            if change.note(&response) {
                change.value = Some(json!(text));
            }
        }
    }
    change
}

fn number(ui: &mut Ui, value: f64, range: Range, name: &str, label: egui::Id, change: &mut Change) {
    let mut new = value;
    let step = if range.whole { 1.0 } else { step_of(value) };
    if range.low.is_some() && range.high.is_some() {
        let [low, high] = range.for_slider(value);
        let mut slider = Slider::new(&mut new, low..=high).suffix(range.unit);
        slider = if range.whole { slider.integer() } else { slider.max_decimals(4) };
        // Wide ranges of whole numbers, such as samples, are used at their lower end.
        slider = slider.logarithmic(range.whole && high > 200.0);
        let response = ui.add(slider).labelled_by(label);
        if change.note(&response) && new != value {
            change.value = Some(json!(tidy(&range, new, (high - low) / 200.0)));
        }
        return;
    }
    let response = drag(ui, &mut new, range, step, name).labelled_by(label);
    if change.note(&response) && new != value {
        change.value = Some(json!(tidy(&range, new, step)));
    }
}

fn drag(ui: &mut Ui, value: &mut f64, range: Range, step: f64, name: &str) -> Response {
    let low = range.nearest(f64::NEG_INFINITY).max(-1e9);
    let high = range.nearest(f64::INFINITY).min(1e9);
    let decimals = if range.whole { 0 } else { 6 };
    let widget = DragValue::new(value).range(low..=high).clamp_existing_to_range(false).speed(step);
    let response = ui.add(widget.suffix(range.unit).max_decimals(decimals));
    let hint = say(ui.ctx(), "edit-drag-about");
    response.on_hover_text(format!("{name}. {hint}"))
}

fn numbers(ui: &mut Ui, values: &[f64], range: Range, name: &str, change: &mut Change) {
    const AXES: [&str; 4] = ["x", "y", "z", "w"];
    ui.spacing_mut().item_spacing.x = 4.0;
    let mut new = values.to_vec();
    let mut changed = false;
    for (i, value) in new.iter_mut().enumerate() {
        let (old, step) = (*value, step_of(*value));
        let axis = AXES.get(i).copied().unwrap_or_default();
        let named = format!("{name} {axis}");
        let response = drag(ui, value, range, step, &named);
        ui.ctx().accesskit_node_builder(response.id, |node| node.set_label(named));
        if change.note(&response) && *value != old {
            *value = tidy(&range, *value, step);
            changed = true;
        }
    }
    if changed {
        change.value = Some(json!(new));
    }
}

/// Linear components, as the file holds them, with a swatch that opens a picker.
fn colour(ui: &mut Ui, colour: [f64; 3], name: &str, change: &mut Change) {
    const PARTS: [&str; 3] = ["red", "green", "blue"];
    ui.spacing_mut().item_spacing.x = 4.0;
    let mut new = colour;
    let mut changed = false;
    #[expect(clippy::cast_possible_truncation, reason = "a swatch shows a few hundred shades")]
    let linear = colour.map(|part| part.clamp(0.0, 1.0) as f32);
    let mut swatch = egui::Rgba::from_rgb(linear[0], linear[1], linear[2]);
    let response = color_picker::color_edit_button_rgba(ui, &mut swatch, color_picker::Alpha::Opaque);
    let picker = format!("{name} {}", say(ui.ctx(), "edit-picker"));
    ui.ctx().accesskit_node_builder(response.id, |node| node.set_label(picker));
    if change.note(&response) {
        new = [swatch.r(), swatch.g(), swatch.b()].map(|part| rounded(f64::from(part), 3));
        changed = true;
    }
    for (i, value) in new.iter_mut().enumerate() {
        let old = *value;
        let range = Range { low: Some(0.0), ..Range::default() };
        let named = format!("{name} {}", say(ui.ctx(), &format!("edit-{}", PARTS[i])));
        let response = drag(ui, value, range, 0.005, &named);
        ui.ctx().accesskit_node_builder(response.id, |node| node.set_label(named));
        if change.note(&response) && *value != old {
            *value = rounded(*value, 3);
            changed = true;
        }
    }
    if changed {
        change.value = Some(json!(new));
    }
}

fn choice(
    ui: &mut Ui,
    property: &Property,
    word: &str,
    words: &[(String, String)],
    label: egui::Id,
    change: &mut Change,
) {
    let shown = if word.is_empty() { RichText::new(say(ui.ctx(), "property-inherited")).weak() } else { word.into() };
    let combo = ComboBox::from_id_salt(property.place.to_string()).selected_text(shown).width(140.0).height(360.0);
    let shown = combo.show_ui(ui, |ui| {
        for (name, about) in words {
            let line = ui.selectable_label(name == word, name);
            let line = if about.is_empty() { line } else { line.on_hover_text(about) };
            if line.clicked() {
                change.value = Some(json!(name));
                change.ended = true;
            }
        }
    });
    // Its own name would be the chosen word.
    let name = property.name.replace('_', " ");
    let response = shown.response.labelled_by(label);
    ui.ctx().accesskit_node_builder(response.id, |node| node.set_label(name));
}

/// How much a point of dragging changes a value of this size.
fn step_of(value: f64) -> f64 {
    (value.abs() * 0.01).clamp(0.005, 10.0)
}

/// An allowed value with no more digits than the step calls for.
fn tidy(range: &Range, value: f64, step: f64) -> f64 {
    range.nearest(rounded(value, decimals_for(step)))
}

/// A property that is not written looks fainter: it has its default.
#[must_use]
pub fn label(property: &Property, weak: Color32) -> RichText {
    let name = property.name.replace('_', " ");
    if property.is_written { RichText::new(name) } else { RichText::new(name).color(weak) }
}
