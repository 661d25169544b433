//! SCENE on the command line: a file, or the name of an embedded scene.

use super::failure::{Failure, reason};
use crate::folder::{Outside, files_of_scene};
use crate::scene::{Image, MOST_PIXELS, Scene, embedded_scene, embedded_scenes, load_with};
use clap::Args;
use std::fs;
use std::path::Path;

/// The scene that a command works on.
#[derive(Args, Clone, Debug)]
pub struct SceneArgument {
    /// A scene file, or the name of a scene that comes with the program (`rayscope scenes` lists them)
    #[arg(value_name = "SCENE")]
    name: String,
    /// Let the scene name pictures outside its own folder
    #[arg(long)]
    allow_outside_files: bool,
}

/// The picture's size, where it is not to be that of the scene file.
#[derive(Args, Clone, Copy, Debug, Default)]
pub struct SizeArguments {
    /// Columns of the picture [default: as in the scene, or in proportion to the height]
    #[arg(long, value_name = "PIXELS", value_parser = clap::value_parser!(u32).range(1..=LONGEST_SIDE))]
    width: Option<u32>,
    /// Rows of the picture [default: as in the scene, or in proportion to the width]
    #[arg(long, value_name = "PIXELS", value_parser = clap::value_parser!(u32).range(1..=LONGEST_SIDE))]
    height: Option<u32>,
}

/// A side as long as the most pixels of a square picture allow.
const LONGEST_SIDE: i64 = 65_535;

impl SceneArgument {
    /// The name as it was given.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Whether the scene comes with the program, and no file of that name stands before it.
    pub fn is_embedded(&self) -> bool {
        !Path::new(&self.name).is_file() && embedded_scene(&self.name).is_some()
    }

    /// Names a scene from within the program.
    pub fn named(name: impl Into<String>) -> Self {
        Self { name: name.into(), allow_outside_files: false }
    }

    /// Whether the scene may name files outside its folder.
    pub const fn outside(&self) -> Outside {
        if self.allow_outside_files { Outside::Allowed } else { Outside::Refused }
    }

    /// The text of the scene, wherever it lies.
    pub fn text(&self) -> Result<String, Failure> {
        match (fs::read(&self.name), embedded_scene(&self.name)) {
            (Ok(bytes), _) => String::from_utf8(bytes).map_err(|error| {
                let place = error.utf8_error().valid_up_to();
                Failure::usage(format!("{}: not a text file: byte {place} is not UTF-8", self.name))
            }),
            (Err(_), Some(embedded)) => Ok(embedded.text.to_owned()),
            (Err(error), None) => Err(self.not_found(&error)),
        }
    }

    /// The scene, compiled.
    pub fn load(&self) -> Result<Scene, Failure> {
        let files = files_of_scene(&self.name, self.outside());
        load_with(&self.text()?, &self.name, files.as_ref())
            .map_err(|errors| Failure::usage(format!("the scene {} cannot be used\n{errors}", self.name)))
    }

    /// The scene with the picture's size as asked for.
    pub fn load_sized(&self, size: SizeArguments) -> Result<Scene, Failure> {
        let mut scene = self.load()?;
        let before = scene.image;
        scene.image = size.apply(before)?;
        for [x, y] in &mut scene.pixels {
            *x = rescale(*x, before.width, scene.image.width);
            *y = rescale(*y, before.height, scene.image.height);
        }
        Ok(scene)
    }

    fn not_found(&self, error: &std::io::Error) -> Failure {
        if Path::new(&self.name).exists() {
            return Failure::usage(format!("cannot read {}: {}", self.name, reason(error)));
        }
        let nearest = nearest_scene(&self.name).map_or_else(String::new, |near| format!("; did you mean `{near}`?"));
        Failure::usage(format!(
            "there is no file and no embedded scene `{}`{nearest} (`rayscope scenes` lists them)",
            self.name
        ))
    }
}

impl SizeArguments {
    /// Whether any size is asked for.
    pub const fn is_given(self) -> bool {
        self.width.is_some() || self.height.is_some()
    }

    /// So many columns, and rows in proportion.
    pub const fn of_width(width: Option<u32>) -> Self {
        Self { width, height: None }
    }

    /// The size asked for, in proportion to the scene's where only one side is given.
    pub fn apply(self, scene: Image) -> Result<Image, Failure> {
        let (width, height) = match (self.width, self.height) {
            (Some(width), Some(height)) => (width, height),
            (Some(width), None) => (width, proportional(width, scene.height, scene.width)),
            (None, Some(height)) => (proportional(height, scene.width, scene.height), height),
            (None, None) => (scene.width, scene.height),
        };
        if u64::from(width) * u64::from(height) > MOST_PIXELS {
            let most = MOST_PIXELS / 1_000_000;
            return Err(Failure::usage(format!("{width} × {height} pixels are too many: at most {most} million")));
        }
        Ok(Image { width, height })
    }
}

/// `side` · `part` / `whole`, rounded, at least 1.
fn proportional(side: u32, part: u32, whole: u32) -> u32 {
    let (side, part, whole) = (u64::from(side), u64::from(part), u64::from(whole).max(1));
    u32::try_from((side * part + whole / 2) / whole).unwrap_or(u32::MAX).max(1)
}

/// The pixel of the new picture that holds the centre of this pixel of the old one.
fn rescale(pixel: u32, before: u32, after: u32) -> u32 {
    let place = (2 * u64::from(pixel) + 1) * u64::from(after) / (2 * u64::from(before).max(1));
    u32::try_from(place).unwrap_or(u32::MAX).min(after - 1)
}

/// The embedded scene whose name is most like this one, if any is.
fn nearest_scene(name: &str) -> Option<String> {
    let wanted = name.strip_suffix(".json").unwrap_or(name);
    let likeness = |candidate: &str| {
        let short = candidate.rsplit('/').next().unwrap_or(candidate);
        strsim::jaro_winkler(candidate, wanted).max(strsim::jaro_winkler(short, wanted))
    };
    embedded_scenes()
        .into_iter()
        .map(|scene| (likeness(&scene.name), scene.name))
        .filter(|(likeness, _)| *likeness > 0.8)
        .max_by(|(a, _), (b, _)| a.total_cmp(b))
        .map(|(_, name)| name)
}

#[cfg(test)]
mod tests {
    use super::*;

    const SCENE: Image = Image { width: 640, height: 480 };

    fn size(width: Option<u32>, height: Option<u32>) -> Result<Image, Failure> {
        SizeArguments { width, height }.apply(SCENE)
    }

    #[test]
    fn one_side_alone_keeps_the_pictures_proportions() {
        assert_eq!(size(Some(320), None), Ok(Image { width: 320, height: 240 }));
        assert_eq!(size(None, Some(48)), Ok(Image { width: 64, height: 48 }));
        assert_eq!(size(None, None), Ok(SCENE));
        assert_eq!(size(Some(10), Some(90)), Ok(Image { width: 10, height: 90 }));
    }

    #[test]
    fn a_thin_picture_still_has_a_row() {
        assert_eq!(size(Some(1), None), Ok(Image { width: 1, height: 1 }));
    }

    #[test]
    fn too_many_pixels_are_refused() {
        assert!(size(Some(65_535), Some(65_535)).is_err());
    }

    #[test]
    fn telling_pixels_follow_the_pictures_size() {
        assert_eq!(rescale(320, 640, 640), 320);
        assert_eq!(rescale(0, 640, 64), 0);
        assert_eq!(rescale(639, 640, 64), 63);
        assert_eq!(rescale(320, 640, 64), 32);
        assert_eq!(rescale(10, 20, 40), 21);
    }
}
