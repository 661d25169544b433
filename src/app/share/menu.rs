//! The small menu in a panel's header: its drawing as a file, or as an image to paste elsewhere.

use super::{Aim, Ending, Product};
use crate::app::frame::words::say;
use crate::app::pane::Pane;
use crate::app::workbench::Workbench;
use crate::view::View;
use egui::{RichText, Ui};

/// The views that a panel shows, as far as there are any.
pub fn views_of(pane: Pane) -> Vec<&'static View> {
    let names: &[&str] = match pane {
        Pane::Side => &["side"],
        Pane::Overview => &["overview"],
        Pane::Generic => &["generic"],
        Pane::Along => &["intervals", "signs", "event"],
        Pane::Intervals => &["csg", "intervals"],
        Pane::Signs => &["signs"],
        Pane::Snell => &["snell"],
        Pane::Shading => &["shading"],
        Pane::Planes => &["planes"],
        _ => &[],
    };
    names.iter().filter_map(|name| View::named(name)).collect()
}

/// Shows the menu, if the panel shows anything that can be saved.
pub fn tools(ui: &mut Ui, workbench: &mut Workbench, pane: Pane) {
    let views = views_of(pane);
    if views.is_empty() || workbench.recording().is_none() {
        return;
    }
    let mut chosen = None;
    let title = RichText::new(format!("{} ⏷", say(ui.ctx(), "share-view"))).small();
    let button = ui.menu_button(title, |ui| {
        if let [view] = views[..] {
            chosen = choices(ui, view);
            return;
        }
        for view in views {
            ui.menu_button(view.about, |ui| chosen = chosen.take().or(choices(ui, view)));
        }
    });
    button.response.on_hover_text(say(ui.ctx(), "share-view-about"));
    if let Some((product, aim)) = chosen {
        workbench.share(product, aim);
    }
}

fn choices(ui: &mut Ui, view: &'static View) -> Option<(Product, Aim)> {
    let mut chosen = None;
    let copy = (Product::View(view, Ending::Png), Aim::Clipboard);
    let save = |ending| (Product::View(view, ending), Aim::Ask);
    let choices = [
        ("share-copy-image", copy),
        ("share-save-svg", save(Ending::Svg)),
        ("share-save-png", save(Ending::Png)),
        ("share-save-pdf", save(Ending::Pdf)),
    ];
    for (word, choice) in choices {
        if ui.button(say(ui.ctx(), word)).clicked() {
            chosen = Some(choice);
            ui.close();
        }
    }
    chosen
}
