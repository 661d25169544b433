//! The pane of properties: what the selected thing is made of, each number with a slider or to be dragged.

use crate::app::edit::editing::Editing;
use crate::app::edit::field;
use crate::app::frame::empty::empty;
use crate::app::frame::theme::{Palette, bold};
use crate::app::frame::words::{say, say_with};
use crate::document::{Cause, Guide, Place, Property, Section, Target, TargetKind, names_for, sheet, value_at};
use crate::record::EventId;
use crate::shape::Shape;
use egui::{Button, ComboBox, Grid, RichText, ScrollArea, Ui, UiBuilder, vec2};
use serde_json::{Value, json};

/// What the pane remembers between frames.
#[derive(Debug, Default)]
pub struct Properties {
    sections: Vec<Section>,
    of: Option<(u64, Place)>,
    /// The pixel and event that were followed last.
    pub event: Option<([u32; 2], EventId)>,
}

/// What a button of the pane asks for.
enum Wish {
    Set(Place, Value, String),
    Insert(Place, usize, Value, String),
    Remove(Place, String),
    Choose(Place),
    Undo,
    Redo,
    Seal,
}

impl Editing {
    /// Shows the pane.
    pub fn properties_ui(&mut self, ui: &mut Ui) {
        self.analysis.follow(&self.document);
        let rect = ui.available_rect_before_wrap().shrink2(vec2(10.0, 6.0));
        let mut child = ui.new_child(UiBuilder::new().id_salt("properties").max_rect(rect));
        let mut wishes = Vec::new();
        self.chooser(&mut child, &mut wishes);
        let Some(place) = self.target.clone() else {
            empty(&mut child, &say(ui.ctx(), "edit-nothing-chosen"));
            self.grant_all(wishes);
            return;
        };
        if self.target().is_none() && !self.flaws.is_empty() {
            empty(&mut child, &say(ui.ctx(), "edit-unreadable"));
            self.grant_all(wishes);
            return;
        }
        let wanted = (self.document.revision(), place.clone());
        if self.properties.of.as_ref() != Some(&wanted) {
            self.properties.sections = sheet(&self.analysis.whole, &place);
            self.properties.of = Some(wanted);
        }
        let owner = self.target().map_or_else(|| place.to_string(), |target| name_of(ui, target));
        ScrollArea::vertical().auto_shrink(false).id_salt("properties").show(&mut child, |ui| {
            let mut before: Option<&Section> = None;
            for (i, section) in self.properties.sections.iter().enumerate() {
                // What belongs to a step with nothing else in it stands under the step's own title.
                let is_titled = before.is_some_and(|it| !it.properties.is_empty() || it.name != section.name);
                show_section(ui, i, section, is_titled, &owner, &mut wishes);
                before = Some(section);
            }
            if is_solid(self.target()) {
                add_step(ui, &place, &self.properties.sections, &owner, &mut wishes);
            }
        });
        self.grant_all(wishes);
    }

    /// The list of all things, and buttons that add to it and take from it.
    fn chooser(&self, ui: &mut Ui, wishes: &mut Vec<Wish>) {
        ui.horizontal_wrapped(|ui| {
            let label = ui.label(say(ui.ctx(), "edit-thing"));
            let selected = self.target().map_or_else(|| say(ui.ctx(), "edit-none"), |target| name_of(ui, target));
            let combo = ComboBox::from_id_salt("thing").selected_text(selected).width(190.0).height(360.0);
            let shown = combo.show_ui(ui, |ui| {
                for target in &self.analysis.targets {
                    let indent = "    ".repeat(target.depth);
                    let is_chosen = self.target.as_ref() == Some(&target.place);
                    if ui.selectable_label(is_chosen, indent + &name_of(ui, target)).clicked() {
                        wishes.push(Wish::Choose(target.place.clone()));
                    }
                }
            });
            shown.response.labelled_by(label.id);
            add_menu(ui, &self.analysis.whole, wishes);
            let removable = self.target().filter(|target| is_removable(target));
            let button = ui.add_enabled(removable.is_some(), Button::new(say(ui.ctx(), "edit-remove")));
            if let Some(target) = removable.filter(|_| button.clicked()) {
                let name = name_of(ui, target);
                let cause = say_with(ui.ctx(), "edit-cause-remove", &[("thing", (&name).into())]);
                wishes.push(Wish::Remove(target.place.clone(), cause));
            }
        });
        self.history(ui, wishes);
        ui.separator();
    }

    /// What would be taken back, and what would be made again, by name. The line is there before there is anything to take back: if it
    /// came with the first key that is typed into a field below, the fields would move, and this one would lose the focus.
    fn history(&self, ui: &mut Ui, wishes: &mut Vec<Wish>) {
        let button = |ui: &mut Ui, [word, named]: [&str; 2], change: Option<&str>| {
            let named = |change: &str| say_with(ui.ctx(), named, &[("change", change.into())]);
            let title = change.map_or_else(|| say(ui.ctx(), word), named);
            ui.add_enabled(change.is_some(), Button::new(title).small()).clicked()
        };
        ui.horizontal_wrapped(|ui| {
            if button(ui, ["edit-undo", "edit-undo-named"], self.document.undo_name()) {
                wishes.push(Wish::Undo);
            }
            if button(ui, ["edit-redo", "edit-redo-named"], self.document.redo_name()) {
                wishes.push(Wish::Redo);
            }
        });
    }

    fn grant_all(&mut self, wishes: Vec<Wish>) {
        for wish in wishes {
            match wish {
                Wish::Set(place, value, cause) => {
                    let cause = Cause::part_of(cause, place.to_string());
                    if place.last_field() == Some("shape") {
                        self.exchange_parameters(&place, &value, &cause);
                    }
                    self.set(&[(place, value)], &cause);
                }
                Wish::Insert(list, index, value, cause) => {
                    self.restructure(Cause::new(cause), |structure| structure.insert_item(&list, index, &value));
                }
                Wish::Remove(place, cause) => {
                    self.restructure(Cause::new(cause), |structure| structure.remove(&place));
                    self.target = self.target.take().filter(|target| !place.holds(target) || *target != place);
                }
                Wish::Choose(place) => self.choose(place),
                Wish::Undo => self.undo(),
                Wish::Redo => self.redo(),
                Wish::Seal => self.document.seal(),
            }
        }
    }
}

impl Editing {
    /// Another shape has other parameters: those that it does not take go, those that it needs come.
    fn exchange_parameters(&mut self, tag: &Place, shape: &Value, cause: &Cause) {
        let Some((solid, _)) = tag.parent() else { return };
        let (guide, shape) = (Guide::scene(), shape.as_str().unwrap_or_default());
        let fields = |value: &Value| value.as_object().cloned().unwrap_or_default();
        let written = value_at(self.whole(), &solid).map(fields).unwrap_or_default();
        for name in written.keys().filter(|name| !guide.takes(shape, name)) {
            self.restructure(cause.clone(), |structure| structure.remove(&solid.field(name)));
        }
        for (name, value) in fields(&guide.solid(shape)).into_iter().filter(|(name, _)| !written.contains_key(name)) {
            let place = solid.field(&name);
            // What has to be the name of something else is the name of the first that there is.
            let first = names_for(self.whole(), &place).and_then(|names| names.into_iter().next());
            self.set(&[(place, first.map_or(value, Value::from))], cause);
        }
    }
}

fn is_solid(target: Option<&Target>) -> bool {
    target.is_some_and(|target| matches!(target.kind, TargetKind::Object | TargetKind::Part | TargetKind::Solid))
}

fn is_removable(target: &Target) -> bool {
    !matches!(target.kind, TargetKind::Camera | TargetKind::Image | TargetKind::Sampling | TargetKind::Limits)
}

/// What a thing is called: `Light: key light`.
pub fn name_of(ui: &Ui, target: &Target) -> String {
    let word = match target.kind {
        TargetKind::Camera => "edit-camera",
        TargetKind::Image => "edit-image",
        TargetKind::Sampling => "edit-sampling",
        TargetKind::Limits => "edit-limits",
        TargetKind::Light => "edit-light",
        TargetKind::Material => "edit-material",
        TargetKind::Object => "edit-object",
        TargetKind::Part => "edit-part",
        TargetKind::Solid => "edit-solid",
    };
    let kind = say(ui.ctx(), word);
    if target.name.is_empty() { kind } else { format!("{kind}: {}", target.name) }
}

/// What can be added: an object of each shape, and lights.
fn add_menu(ui: &mut Ui, whole: &Value, wishes: &mut Vec<Wish>) {
    let count = |list: &str| whole.get(list).and_then(Value::as_array).map_or(0, Vec::len);
    let material = whole.get("materials").and_then(Value::as_object).and_then(|all| all.keys().next()).cloned();
    ui.menu_button(say(ui.ctx(), "edit-add"), |ui| {
        for shape in Shape::NAMES {
            if ui.button(shape.replace('_', " ")).clicked() {
                let cause = say_with(ui.ctx(), "edit-cause-add", &[("thing", (*shape).into())]);
                let list = Place::ROOT.field("objects");
                wishes.push(Wish::Insert(list, count("objects"), new_solid(shape, material.as_deref()), cause));
                ui.close();
            }
        }
        ui.separator();
        for (word, light) in
            [("point", json!({ "point": [-4, -6, 8] })), ("directional", json!({ "directional": [1, -2, 3] }))]
        {
            let title = say(ui.ctx(), &format!("edit-light-{word}"));
            if ui.button(&title).clicked() {
                let cause = say_with(ui.ctx(), "edit-cause-add", &[("thing", (&title).into())]);
                wishes.push(Wish::Insert(Place::ROOT.field("lights"), count("lights"), light, cause));
                ui.close();
            }
        }
    });
}

/// A solid with what its shape needs, on the floor.
fn new_solid(shape: &str, material: Option<&str>) -> Value {
    let mut solid = Guide::scene().solid(shape);
    if let Some(material) = material {
        solid["material"] = json!(material);
    }
    solid["transform"] = json!([{ "translate": [0, 0, 1] }]);
    solid
}

fn show_section(ui: &mut Ui, index: usize, section: &Section, is_titled: bool, owner: &str, wishes: &mut Vec<Wish>) {
    let palette = Palette::current(ui.ctx());
    if is_titled {
        ui.add_space(6.0);
        ui.horizontal(|ui| {
            let number = section.step.map_or_else(String::new, |step| format!("{}. ", step + 1));
            let title = format!("{number}{}", section.name.replace('_', " "));
            ui.label(RichText::new(title).family(bold())).on_hover_text(&section.about);
            if section.step.is_some() && ui.button(say(ui.ctx(), "edit-remove-step")).clicked() {
                let cause = say_with(ui.ctx(), "edit-cause-remove", &[("thing", section.name.as_str().into())]);
                wishes.push(Wish::Remove(section.place.clone(), cause));
            }
        });
    }
    if section.properties.is_empty() {
        return;
    }
    Grid::new(("section", index)).num_columns(2).spacing(vec2(10.0, 5.0)).show(ui, |ui| {
        for property in &section.properties {
            show_property(ui, property, owner, palette.weak, wishes);
            ui.end_row();
        }
    });
}

fn show_property(ui: &mut Ui, property: &Property, owner: &str, weak: egui::Color32, wishes: &mut Vec<Wish>) {
    let label = ui.label(field::label(property, weak));
    let label = if property.about.is_empty() { label } else { label.on_hover_text(&property.about) };
    let change = ui.horizontal(|ui| field::ui(ui, property, label.id)).inner;
    if let Some(value) = change.value {
        let name = property.name.replace('_', " ");
        let cause = say_with(ui.ctx(), "edit-cause-set", &[("property", (&name).into()), ("thing", owner.into())]);
        wishes.push(Wish::Set(property.place.clone(), value, cause));
    }
    if change.ended {
        wishes.push(Wish::Seal);
    }
}

fn add_step(ui: &mut Ui, place: &Place, sections: &[Section], owner: &str, wishes: &mut Vec<Wish>) {
    let count = sections.iter().filter(|section| section.step.is_some()).count();
    let list = place.field("transform");
    let steps = [
        ("translate", json!({ "translate": [0, 0, 0] })),
        ("rotate", json!({ "rotate": { "axis": [0, 0, 1], "degrees": 30 } })),
        ("scale", json!({ "scale": [1, 1, 1] })),
    ];
    ui.add_space(8.0);
    ui.horizontal(|ui| {
        ui.label(say(ui.ctx(), "edit-add-step"));
        for (name, step) in steps {
            if ui.button(name).clicked() {
                let cause = say_with(ui.ctx(), "edit-cause-set", &[("property", name.into()), ("thing", owner.into())]);
                wishes.push(Wish::Insert(list.clone(), count, step, cause));
            }
        }
    });
}
