//! Which drawings belong to a step.

use super::Account;
use crate::record::{EventId, What};
use crate::view::{Drawing, Subject, View};

/// A drawing of a step.
pub struct Figure {
    /// What it is a drawing of: the name of its view.
    pub name: &'static str,
    /// The drawing.
    pub drawing: Drawing,
}

/// The drawings of a step, those that were asked for or those that tell most: the scene, and what happened there.
pub fn figures_of(account: &Account, event: EventId, size: impl Fn(usize) -> [f64; 2]) -> Vec<Figure> {
    let subject = |size| Subject { scene: account.scene, tree: account.tree, event, size, theme: account.theme };
    let chosen =
        if account.views.is_empty() { telling(account, &subject([480.0, 300.0])) } else { account.views.to_vec() };
    let there: Vec<_> = chosen.into_iter().filter(|view| view.draw(&subject([480.0, 300.0])).is_some()).collect();
    let size = size(there.len());
    let figure = |view: &'static View| Some(Figure { name: view.name, drawing: view.draw(&subject(size))? });
    there.into_iter().filter_map(figure).collect()
}

/// The scene from the side, and the first of those that tell what happened.
fn telling(account: &Account, subject: &Subject) -> Vec<&'static View> {
    let own = close_look(account, subject);
    View::named("side").into_iter().chain(own).collect()
}

/// The drawing of what happened at the event, where there is one besides the scene's.
pub fn close_look(account: &Account, subject: &Subject) -> Option<&'static View> {
    let names = names_for(&account.tree.event(subject.event).what);
    names.iter().filter_map(|name| View::named(name)).find(|view| view.draw(subject).is_some())
}

/// The views that show a kind of event, the most telling first.
const fn names_for(what: &What) -> &'static [&'static str] {
    match what {
        What::Snell { .. } | What::Reflection { .. } | What::Medium { .. } => &["snell"],
        What::Colour { .. } | What::Light { .. } | What::Ambient { .. } => &["shading"],
        What::Object { .. } | What::Combine { .. } => &["csg", "intervals", "signs"],
        What::Planes { .. } => &["planes", "signs"],
        What::Transform { .. } => &["generic"],
        What::Primitive { .. }
        | What::Implicit { .. }
        | What::Roots { .. }
        | What::Search { .. }
        | What::Decision { .. }
        | What::Quadratic { .. }
        | What::Quartic { .. } => &["signs", "generic"],
        What::Hit { .. } | What::Rejected { .. } => &["intervals", "signs"],
        What::Pixel { .. } | What::LooseRay { .. } | What::Step { .. } | What::Ray { .. } | What::Written { .. } => &[],
        _ => &["event"],
    }
}
