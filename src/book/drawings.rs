//! Drawings of a recorded ray as figures of a page.

use super::page::Page;
use crate::record::EventId;
use crate::scene::Scene;
use crate::trace::RayTree;
use crate::view::{Subject, Theme, View, escaped, svg};

/// Width and height of a drawing in points.
const SIZE: [f64; 2] = [620.0, 390.0];

/// A recorded ray that is drawn.
#[derive(Clone, Copy)]
pub struct Drawn<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// The ray.
    pub tree: &'a RayTree,
    /// The event that drawings are about, where they can be.
    pub event: EventId,
}

impl Drawn<'_> {
    /// The drawing as a figure; whether there is any.
    pub fn figure(&self, page: &mut Page, view: &View) -> bool {
        let [light, dark] = [Theme::Light, Theme::Dark].map(|theme| {
            let subject = Subject { scene: self.scene, tree: self.tree, event: self.event, size: SIZE, theme };
            view.draw(&subject).or_else(|| view.draw_telling(&subject))
        });
        let (Some(light), Some(dark)) = (light, dark) else { return false };
        let words = escaped(&light.in_words());
        let picture = page.colours.of_both(&svg(&light), &svg(&dark));
        // Within a page SVG needs no name space. The description is the label already, and would be said twice.
        let picture = without_description(&picture.replace(" xmlns=\"http://www.w3.org/2000/svg\"", ""));
        page.put(format_args!(
            "<figure class=\"drawing\"><div class=\"scroll\" role=\"img\" aria-label=\"{words}\" tabindex=\"0\">{picture}</div>\
             <figcaption>{}</figcaption></figure>\n",
            escaped(view.about)
        ));
        true
    }
}

fn without_description(svg: &str) -> String {
    let mut out = String::with_capacity(svg.len());
    let mut rest = svg;
    while let Some((before, after)) = rest.split_once("<desc>") {
        out.push_str(before);
        rest = after.split_once("</desc>\n").map_or("", |(_, after)| after);
    }
    out + rest
}
