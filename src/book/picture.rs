//! Rendered pictures of scenes, small, each once, with the pixel that is looked at marked above them.

use super::BookFile;
use crate::scene::{Image, Scene};
use crate::trace::{Progress, render};
use crate::view::escaped;
use image::ImageEncoder as _;
use image::codecs::png::PngEncoder;
use std::collections::BTreeSet;

/// The pictures of a book.
pub struct Pictures {
    width: u32,
    made: BTreeSet<String>,
}

/// A picture within a page.
pub struct Shown<'a> {
    /// Its path from the page.
    pub path: String,
    /// The scene's own columns and rows, in which pixels are counted.
    pub size: [u32; 2],
    /// The pixel that is marked.
    pub pixel: Option<[u32; 2]>,
    /// What is seen.
    pub words: &'a str,
}

impl Pictures {
    /// None yet; each is to be so many pixels wide.
    pub fn new(width: u32) -> Self {
        Self { width: width.max(1), made: BTreeSet::new() }
    }

    /// The path of a scene's picture from the root of the book, and the file, if it was not made before. `text` stands for the scene:
    /// two with the same text have the same picture.
    pub fn of(&mut self, scene: &Scene, text: &str) -> (String, Option<BookFile>) {
        let path = format!("pictures/{:016x}.png", fingerprint(text.as_bytes()));
        if !self.made.insert(path.clone()) {
            return (path, None);
        }
        let mut small = scene.clone();
        let Image { width, height } = scene.image;
        let wide = self.width.min(width);
        small.image = Image { width: wide, height: (height * wide).div_ceil(width.max(1)).max(1) };
        let (picture, _) = render(&small, &Progress::new());
        let mut bytes = Vec::new();
        let size = (picture.width, picture.height);
        let written =
            PngEncoder::new(&mut bytes).write_image(&picture.to_rgb8(), size.0, size.1, image::ExtendedColorType::Rgb8);
        // A picture in memory is not refused; if one were, the page would say in words what it shows.
        let file = written.ok().map(|()| BookFile { path: path.clone(), bytes });
        (path, file)
    }
}

/// FNV-1a: the same text has the same name on every machine.
pub fn fingerprint(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3))
}

impl Shown<'_> {
    /// The picture with its mark.
    pub fn html(&self) -> String {
        let [width, height] = self.size;
        let mark = self.pixel.map_or_else(String::new, |[x, y]| {
            let (x, y, r) = (f64::from(x) + 0.5, f64::from(y) + 0.5, f64::from(width) / 45.0);
            let ring = |colour: &str, wide: f64| {
                let wide = f64::from(width) * wide;
                format!("<circle cx=\"{x}\" cy=\"{y}\" r=\"{r:.1}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{wide:.1}\"/>")
            };
            // A dark ring around a light one is seen on any ground.
            format!("{}{}", ring("#000000", 0.014), ring("#ffffff", 0.006))
        });
        format!(
            "<svg class=\"picture\" viewBox=\"0 0 {width} {height}\" role=\"img\" aria-label=\"{}\">\
             <image href=\"{}\" width=\"{width}\" height=\"{height}\" preserveAspectRatio=\"none\"/>{mark}</svg>",
            escaped(self.words),
            escaped(&self.path),
        )
    }
}
