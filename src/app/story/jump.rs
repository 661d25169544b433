//! Going to a step by its number.

use crate::app::frame::words::say;
use crate::app::workbench::Workbench;
use egui::{Key, TextEdit, Ui};

/// Shows the field, and goes where it says.
pub fn ui(ui: &mut Ui, workbench: &mut Workbench) {
    ui.horizontal(|ui| {
        let label = ui.label(say(ui.ctx(), "step-jump-label"));
        let stepping = &mut workbench.stepping;
        let field = TextEdit::singleline(&mut stepping.jump).desired_width(90.0);
        let field = ui.add(field).labelled_by(label.id);
        if std::mem::take(&mut stepping.wants_focus) {
            field.request_focus();
        }
        if field.changed() {
            stepping.note = None;
        }
        let entered = field.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
        let pressed = ui.button(say(ui.ctx(), "step-jump-go")).clicked();
        if entered || pressed {
            let number = stepping.jump.trim().parse::<usize>();
            let went = number.is_ok_and(|number| workbench.jump_to(number));
            let stepping = &mut workbench.stepping;
            stepping.note = (!went).then_some("step-jump-none");
            if went {
                stepping.drawer = None;
                stepping.jump.clear();
            } else {
                stepping.wants_focus = true;
            }
        }
    });
}
