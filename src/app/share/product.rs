//! What can be made of a recorded ray.

use crate::record::EventId;
use crate::scene::Scene;
use crate::share::{Account, Moving, Watch, animation, markdown, slides, slides_pdf, trace_json};
use crate::story::Level;
use crate::trace::RayTree;
use crate::view::{Drawing, Subject, Theme, View, paint, pdf, png, svg, tree_text};
use egui::ColorImage;
use std::path::PathBuf;
use std::sync::Arc;

/// Drawings are this large, in points.
const SIZE: [f64; 2] = [960.0, 600.0];

/// PNGs and copied images have two pixels a point.
const PIXELS_PER_POINT: f32 = 2.0;

/// How long a moving picture shows each step, in seconds.
const SECONDS: f64 = 1.5;

/// Something that can be saved or copied.
#[derive(Clone, Copy, Debug)]
pub enum Product {
    /// The trace as text.
    Text,
    /// The trace as data.
    Json,
    /// The worked example.
    Markdown,
    /// Slides for a browser.
    Slides,
    /// Slides as PDF.
    SlidesPdf,
    /// The steps as a GIF.
    Gif,
    /// The steps as an animated PNG.
    Apng,
    /// A drawing of the selected event.
    View(&'static View, Ending),
}

/// The format of a drawing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ending {
    /// Lines and texts.
    Svg,
    /// Pixels.
    Png,
    /// A page.
    Pdf,
}

/// What a product is made of.
pub struct Material {
    /// The scene's name, or its file's.
    pub name: String,
    /// The scene.
    pub scene: Arc<Scene>,
    /// What happened.
    pub tree: Arc<RayTree>,
    /// The selected event.
    pub event: EventId,
    /// How much is told.
    pub level: Level,
    /// Light or dark.
    pub theme: Theme,
    /// A link that opens the same.
    pub link: Option<String>,
}

/// What came of it.
pub enum Result {
    /// It lies in this file.
    Saved(PathBuf),
    /// It is for the clipboard.
    Text(String),
    /// It is for the clipboard.
    Image(ColorImage),
    /// Nobody wants it any more.
    Given,
    /// Why it could not be made or written.
    Failed(String),
}

/// A file, and files beside it by their names.
pub struct Files {
    /// The file.
    pub main: Vec<u8>,
    /// What it shows.
    pub beside: Vec<(String, String)>,
}

impl Product {
    /// The end of its file's name.
    #[must_use]
    pub const fn ending(self) -> &'static str {
        match self {
            Self::Text => "txt",
            Self::Json => "json",
            Self::Markdown => "md",
            Self::Slides => "html",
            Self::SlidesPdf | Self::View(_, Ending::Pdf) => "pdf",
            Self::Gif => "gif",
            Self::Apng | Self::View(_, Ending::Png) => "png",
            Self::View(_, Ending::Svg) => "svg",
        }
    }

    /// A name for its file: the scene's, and what it is.
    #[must_use]
    pub fn file_name(self, scene: &str) -> String {
        let short = scene.rsplit(['/', '\\']).next().unwrap_or(scene);
        let short = short.strip_suffix(".json").unwrap_or(short);
        let what = match self {
            Self::Text | Self::Json | Self::Markdown => "trace",
            Self::Slides | Self::SlidesPdf => "slides",
            Self::Gif | Self::Apng => "steps",
            Self::View(view, _) => view.name,
        };
        format!("{short}-{what}.{}", self.ending())
    }

    /// The bytes of its files; `stem` begins the names of those beside it. None if it was given up.
    ///
    /// # Errors
    ///
    /// Why the trace cannot be written so, in a sentence.
    pub fn files(self, material: &Material, stem: &str, watch: Watch) -> std::result::Result<Option<Files>, String> {
        let alone = |main: Vec<u8>| Files { main, beside: Vec::new() };
        let account = material.account();
        Ok(match self {
            Self::Text => Some(alone(tree_text(&material.tree).into_bytes())),
            Self::Json => Some(alone(trace_json(&material.name, &material.tree)?.into_bytes())),
            Self::Markdown => markdown(&account, Some(stem), watch)
                .ok()
                .map(|paper| Files { main: paper.text.into_bytes(), beside: paper.figures }),
            Self::Slides => slides(&account, watch).ok().map(String::into_bytes).map(alone),
            Self::SlidesPdf => slides_pdf(&account, watch).ok().map(alone),
            Self::Gif => moving(&account, Moving::Gif, watch)?.map(alone),
            Self::Apng => moving(&account, Moving::Apng, watch)?.map(alone),
            Self::View(view, ending) => {
                let drawing = material.drawn(view)?;
                Some(alone(match ending {
                    Ending::Svg => svg(&drawing).into_bytes(),
                    Ending::Png => png(&drawing, PIXELS_PER_POINT),
                    Ending::Pdf => pdf(&material.name, std::slice::from_ref(&drawing)),
                }))
            }
        })
    }

    /// What goes to the clipboard: an image of a drawing, a text of everything else.
    pub fn copy(self, material: &Material, watch: Watch) -> Result {
        if let Self::View(view, _) = self {
            return material.drawn(view).map_or_else(Result::Failed, |drawing| Result::Image(image(&drawing)));
        }
        let text = match self {
            Self::Markdown => markdown(&material.account(), None, watch).ok().map(|paper| paper.text),
            _ => Some(tree_text(&material.tree)),
        };
        text.map_or(Result::Given, Result::Text)
    }
}

impl Material {
    fn account(&self) -> Account<'_> {
        Account {
            scene: &self.scene,
            name: &self.name,
            tree: &self.tree,
            level: self.level,
            views: &[],
            theme: self.theme,
            link: self.link.as_deref(),
        }
    }

    /// The drawing of the selected event; where it has none of that kind, of the most telling one.
    fn drawn(&self, view: &View) -> std::result::Result<Drawing, String> {
        let subject =
            Subject { scene: &self.scene, tree: &self.tree, event: self.event, size: SIZE, theme: self.theme };
        let drawing = view.draw(&subject).or_else(|| view.draw_telling(&subject));
        drawing.ok_or_else(|| view.missing.to_owned())
    }
}

fn moving(account: &Account, moving: Moving, watch: Watch) -> std::result::Result<Option<Vec<u8>>, String> {
    use crate::share::AnimationError;
    match animation(account, moving, SECONDS, watch) {
        Ok(bytes) => Ok(Some(bytes)),
        Err(AnimationError::Cancelled) => Ok(None),
        Err(error) => Err(error.to_string()),
    }
}

fn image(drawing: &Drawing) -> ColorImage {
    let pixels = paint(drawing, PIXELS_PER_POINT);
    ColorImage::from_rgba_unmultiplied([pixels.width as usize, pixels.height as usize], &pixels.rgba)
}
