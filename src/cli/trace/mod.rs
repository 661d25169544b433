//! `rayscope trace`: the whole story of one pixel or ray, as text, data, drawing, worked example, slides or moving picture.

mod aim;
mod format;
mod paper;
mod shown;
mod told;

pub use aim::{check_pixel, pixel, ray};

use super::drawn::{self, with_newline};
use super::failure::Failure;
use super::output::Output;
use super::profile_argument::ProfileArgument;
use super::scene_argument::{SceneArgument, SizeArguments};
use crate::scene::Scene;
use crate::share::link::{Aim, EventPlace, Link};
use crate::share::trace_json;
use crate::trace::RayTree;
use crate::view::{pdf, tree_text};
use aim::{AimArguments, recorded};
use clap::Args;
use format::{Asked, Format};
use shown::ShownArguments;
use std::path::PathBuf;
use told::{Told, ToldArguments};

/// Show everything that the ray of one pixel did
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  rayscope trace csg/bowl                                 the pixel that tells the scene's story best
  rayscope trace csg/bowl --pixel 320,240                 (0,0) is the top left pixel
  rayscope trace csg/bowl --ray 0,0,9,0,0,-1              a ray of your own: origin, direction
  rayscope trace csg/bowl --format json -o bowl.json      as data; `rayscope schema trace` describes it
  rayscope trace csg/bowl --format svg -o bowl.svg        the side view
  rayscope trace csg/bowl --format pdf --view side,signs -o bowl.pdf    two drawings, searchable
  rayscope trace textures/filters --format png --view texture -o texels.png    the pixel on the texels
  rayscope trace csg/bowl --format markdown -o bowl.md    a worked example, its drawings beside it
  rayscope trace csg/bowl --format slides -o bowl.html    a slide for each step, for any browser
  rayscope trace csg/bowl --format gif --level working --seconds 0.5 -o bowl.gif")]
pub struct Trace {
    #[command(flatten)]
    scene: SceneArgument,
    #[command(flatten)]
    aim: AimArguments,
    #[command(flatten)]
    size: SizeArguments,
    #[command(flatten)]
    profile: ProfileArgument,
    /// What to write
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    #[command(flatten)]
    shown: ShownArguments,
    #[command(flatten)]
    told: ToldArguments,
    /// Where to write it; of a worked example also a folder [default: the standard output]
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

impl Trace {
    /// Records the ray and writes it out.
    pub fn run(&self) -> Result<(), Failure> {
        self.format.check(&self.asked())?;
        let scene = self.profile.apply(self.scene.load_sized(self.size)?)?;
        let aim = self.aim.aim(&scene)?;
        if self.format == Format::Markdown {
            let tree = recorded(&scene, aim);
            let link = self.link(&scene, aim, &tree).ok();
            return paper::write(&self.told(&scene, &tree, link.as_deref()), self.output.as_deref());
        }
        let output = Output::create(self.output.as_deref())?;
        if let Some(what) = self.format.binary() {
            drawn::check_has_a_file(&output, what)?;
        }
        let tree = recorded(&scene, aim);
        output.write(&self.written(&scene, aim, &tree)?)
    }

    fn asked(&self) -> Asked {
        Asked {
            views: self.shown.views().len(),
            level: self.told.level.is_some(),
            seconds: self.told.seconds.is_some(),
            event: self.shown.has_event(),
        }
    }

    fn written(&self, scene: &Scene, aim: Aim, tree: &RayTree) -> Result<Vec<u8>, Failure> {
        let first = || self.shown.drawn(scene, tree).map(|mut drawings| drawings.swap_remove(0));
        match self.format {
            Format::Text => Ok(with_newline(tree_text(tree))),
            Format::Json => trace_json(self.scene.name(), tree).map(String::into_bytes).map_err(Failure::refused),
            Format::Svg => Ok(drawn::svg(&first()?)),
            Format::Png => Ok(drawn::png(&first()?)),
            Format::Pdf => Ok(pdf(self.title(scene), &self.shown.drawn(scene, tree)?)),
            Format::Link => Ok(with_newline(self.link(scene, aim, tree)?)),
            _ => {
                let link = self.link(scene, aim, tree).ok();
                self.told(scene, tree, link.as_deref()).written(self.format)
            }
        }
    }

    fn title<'a>(&'a self, scene: &'a Scene) -> &'a str {
        if scene.title.is_empty() { self.scene.name() } else { &scene.title }
    }

    fn told<'a>(&'a self, scene: &'a Scene, tree: &'a RayTree, link: Option<&'a str>) -> Told<'a> {
        self.told.told(scene, self.scene.name(), tree, &self.shown, link)
    }

    /// A link to the same. The text of a scene that does not come with the program travels in it.
    fn link(&self, scene: &Scene, aim: Aim, tree: &RayTree) -> Result<String, Failure> {
        let event = self.shown.event(tree)?.map(|event| EventPlace::of(tree, event));
        let link = Link {
            aim: Some(aim),
            text: if self.scene.is_embedded() { None } else { Some(self.scene.text()?) },
            size: self.size.is_given().then_some([scene.image.width, scene.image.height]),
            event,
            views: self.shown.views().iter().map(|view| view.name.to_owned()).collect(),
            accuracy: self.profile.for_link()?,
            ..Link::to_scene(self.scene.name())
        };
        link.written().map_err(|error| Failure::refused(error.to_string()))
    }
}
