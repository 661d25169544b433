//! A few states of the workbench as pictures, compared with those in `snapshots/workbench`.
//!
//! `RAYSCOPE_PICTURES=update cargo test --test workbench_pictures` writes them anew; look at each before it is accepted.
#![cfg(feature = "workbench")]
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    clippy::cast_possible_wrap,
    reason = "numbers of pixels and shares of colours"
)]

#[path = "hands/camera.rs"]
mod camera;
mod hands;

use camera::Camera;
use egui::{ColorImage, ThemePreference, Vec2};
use hands::{Bench, PATIENCE, workbench, workbench_mut};
use rayscope::app::{Pane, Preset, ViewCommand, Workbench};
use rayscope::folder::Outside;
use rayscope::scene::embedded_scene;
use std::path::PathBuf;
use std::time::{Duration, Instant};

/// A pixel that differs by more than this in a channel is another one. Smaller steps come from rounding.
const STEP: u8 = 4;
/// More pixels than this, of a million, are a change. Fewer are edges that fall differently.
const MOST_CHANGED: usize = 200;

struct Photographer<'a> {
    bench: Bench<'a>,
    camera: Camera,
    size: [usize; 2],
}

impl Photographer<'_> {
    fn of(scene: &str, size: [u16; 2], commands: &[ViewCommand]) -> Self {
        let text = embedded_scene(scene).expect("the scene is embedded").text;
        let name = scene.to_owned();
        let show = move |ui: &mut egui::Ui, workbench: &mut Option<Workbench>| {
            workbench.get_or_insert_with(|| Workbench::new(ui.ctx(), &name, text, Outside::Refused)).ui(ui);
        };
        let camera = Camera::default();
        let points = Vec2::new(f32::from(size[0]), f32::from(size[1]));
        let harness = egui_kittest::Harness::builder().with_size(points).renderer(camera.clone());
        let mut photographer = Self { bench: harness.build_ui_state(show, None), camera, size: size.map(usize::from) };
        photographer.bench.step();
        for &command in commands {
            workbench_mut(&mut photographer.bench).run(command.into());
            photographer.bench.step();
        }
        photographer
    }

    /// A picture, once the scene is rendered and nothing on screen changes any more.
    fn picture(&mut self) -> ColorImage {
        let began = Instant::now();
        let (mut last, mut same) = (self.shot(), 0);
        while same < 8 {
            assert!(began.elapsed() < PATIENCE, "the screen does not come to rest");
            std::thread::sleep(Duration::from_millis(25));
            self.bench.step();
            let next = self.shot();
            let at_rest =
                next == last && workbench(&self.bench).picture_finished() && !workbench(&self.bench).is_busy();
            same = if at_rest { same + 1 } else { 0 };
            last = next;
        }
        last
    }

    fn shot(&self) -> ColorImage {
        self.camera.picture(&self.bench.ctx, self.bench.output(), self.size)
    }
}

fn compare(name: &str, picture: &ColorImage) {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("snapshots/workbench").join(format!("{name}.png"));
    let [width, height] = picture.size.map(|side| side as u32);
    let bytes: Vec<u8> = picture.pixels.iter().flat_map(|pixel| pixel.to_array()[..3].to_vec()).collect();
    let new = image::RgbImage::from_raw(width, height, bytes).expect("three bytes a pixel");
    if std::env::var("RAYSCOPE_PICTURES").is_ok_and(|wanted| wanted == "update") {
        std::fs::create_dir_all(path.parent().expect("it is in a folder")).expect("the folder can be made");
        new.save(&path).expect("the picture can be written");
        return;
    }
    let old = image::open(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display())).to_rgb8();
    assert_eq!(old.dimensions(), new.dimensions(), "{name}");
    let differs = |(a, b): &(&image::Rgb<u8>, &image::Rgb<u8>)| (0..3).any(|c| a[c].abs_diff(b[c]) > STEP);
    let changed = old.pixels().zip(new.pixels()).filter(differs).count();
    let allowed = MOST_CHANGED * picture.pixels.len() / 1_000_000;
    if changed > allowed {
        let actual = std::env::temp_dir().join(format!("rayscope-{name}.png"));
        new.save(&actual).expect("the picture can be written");
        panic!("{name}: {changed} pixels are others than in {}; see {}", path.display(), actual.display());
    }
}

fn check(name: &str, scene: &str, size: [u16; 2], commands: &[ViewCommand]) {
    let picture = Photographer::of(scene, size, commands).picture();
    compare(name, &picture);
}

const LIGHT: ViewCommand = ViewCommand::Theme(ThemePreference::Light);
const DARK: ViewCommand = ViewCommand::Theme(ThemePreference::Dark);

#[test]
fn learning_in_the_light() {
    check("learn_light", "csg/bowl", [1280, 800], &[LIGHT]);
}

#[test]
fn inspecting_in_the_dark() {
    check("inspect_dark", "optics/fishbowl", [1920, 1080], &[DARK, ViewCommand::Layout(Preset::Inspect)]);
}

#[test]
fn presenting_with_high_contrast() {
    let commands = [LIGHT, ViewCommand::HighContrast, ViewCommand::Layout(Preset::Present)];
    check("present_contrast", "csg/bowl", [1280, 800], &commands);
}

#[test]
fn editing_in_german() {
    let commands = [
        DARK,
        ViewCommand::Language(rayscope::words::Language::German),
        ViewCommand::Pane(Pane::Editor),
        ViewCommand::Pane(Pane::Properties),
    ];
    check("edit_german", "csg/lens", [1280, 800], &commands);
}
