//! Drawings of a recorded ray as figures of a page.

use super::BookFile;
use super::page::Page;
use super::picture::fingerprint;
use crate::record::EventId;
use crate::scene::Scene;
use crate::trace::RayTree;
use crate::view::{Drawing, Subject, Theme, View, escaped, png, svg};

/// Width and height of a drawing in points.
const SIZE: [f64; 2] = [620.0, 390.0];

/// An SVG of more bytes is slower to show than a picture, and of more marks than anybody tells apart.
const MOST_BYTES: usize = 300_000;

/// Pictures in place of drawings are sharp on fine screens too.
const PIXELS_PER_POINT: f32 = 2.0;

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
        let drawing = |theme| {
            let subject = Subject { scene: self.scene, tree: self.tree, event: self.event, size: SIZE, theme };
            view.draw(&subject).or_else(|| view.draw_telling(&subject))
        };
        let (Some(light), Some(dark)) = (drawing(Theme::Light), drawing(Theme::Dark)) else { return false };
        let words = escaped(&light.in_words());
        let [of_light, of_dark] = [&light, &dark].map(|drawing| plain(&svg(drawing)));
        let shown = if of_light.len() > MOST_BYTES {
            painted(page, &light, &dark)
        } else {
            page.colours.of_both(&of_light, &of_dark)
        };
        page.put(format_args!(
            "<figure class=\"drawing\"><div class=\"scroll\" role=\"img\" aria-label=\"{words}\" tabindex=\"0\">{shown}</div>\
             <figcaption>{}</figcaption></figure>\n",
            escaped(view.about)
        ));
        true
    }
}

/// A drawing of very many marks as pictures, light and dark: files of their own, named for what is in them.
fn painted(page: &mut Page, light: &Drawing, dark: &Drawing) -> String {
    let [light, dark] = [light, dark].map(|drawing| {
        let bytes = png(drawing, PIXELS_PER_POINT);
        let path = format!("pictures/{:016x}.png", fingerprint(&bytes));
        page.files.push(BookFile { path: path.clone(), bytes });
        format!("{}{path}", page.root)
    });
    format!(
        "<picture><source media=\"screen and (prefers-color-scheme: dark)\" srcset=\"{dark}\"><img src=\"{light}\" alt=\"\" \
         width=\"{}\" height=\"{}\"></picture>",
        SIZE[0], SIZE[1]
    )
}

/// SVG within a page: it needs no name space, and its description is the label of the figure already.
fn plain(svg: &str) -> String {
    let svg = svg.replace(" xmlns=\"http://www.w3.org/2000/svg\"", "");
    match svg.split_once("<desc>") {
        Some((before, after)) => before.to_owned() + after.split_once("</desc>\n").map_or("", |(_, after)| after),
        None => svg,
    }
}
