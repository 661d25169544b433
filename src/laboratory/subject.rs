//! What is measured: the settings of a scene, each different look at it once.

use super::timing::Repeat;
use super::{Errors, Knob, Setting, Timing};
use crate::record::RayKind;
use crate::scene::{Image, Profile, Scene};
use crate::trace::{Picture, Progress, Tally, render};

/// One look at the scene, with every setting that asks for it.
#[derive(Clone, Debug)]
pub struct Subject {
    /// The settings, each a list: none in it for the scene as it stands, several for a combination.
    pub names: Vec<Vec<Setting>>,
    /// The scene looked at so.
    pub scene: Scene,
    /// Its picture, once it was rendered.
    pub picture: Option<Picture>,
    /// How far that is from the reference, and from the picture of the scene as it stands, once there are these.
    pub errors: Option<[Errors; 2]>,
    /// What it took each time.
    pub repeats: Vec<Repeat>,
    /// How many pictures are rendered at a time, so that the clock can tell their time.
    pub batch: u32,
}

impl Subject {
    /// A scene in its own size, with a profile.
    #[must_use]
    pub fn new(scene: &Scene, names: Vec<Setting>) -> Self {
        let profile = names.iter().fold(Profile::STANDARD, |profile, setting| profile.or(setting.profile));
        let scene = scene.with_profile(&profile);
        Self { names: vec![names], scene, picture: None, errors: None, repeats: Vec::new(), batch: 1 }
    }

    /// Its time, as far as it is known by now; `resolution` is what the clock can tell, in seconds.
    #[must_use]
    pub fn timing(&self, resolution: f64) -> Timing {
        let batch = f64::from(self.batch);
        Timing::of(&self.repeats, |seconds| if resolution > 0.0 { seconds * batch / resolution } else { f64::INFINITY })
    }

    /// Renders its picture; none if that was interrupted.
    #[must_use]
    pub fn render(&self, progress: &Progress) -> Option<(Picture, u64)> {
        let (picture, tally) = render(&self.scene, progress);
        (!progress.cancelled()).then(|| (picture, work_of(&tally)))
    }
}

/// How much work a picture was: its rays and their tests.
pub(super) fn work_of(tally: &Tally) -> u64 {
    let rays: u64 = RayKind::ALL.iter().map(|&kind| tally.rays(kind)).sum();
    let tests: u64 = tally.shape_tests().iter().map(|(_, count)| count).sum();
    rays + tests + tally.extent_tests()
}

/// The scene as it stands, then every setting of these knobs that matters to it. Settings that ask for the same look are one
/// subject with several names.
#[must_use]
pub fn subjects(scene: &Scene, knobs: &[Knob]) -> Vec<Subject> {
    let mut subjects = vec![Subject::new(scene, Vec::new())];
    let asked = Knob::ALL.into_iter().filter(|knob| knobs.contains(knob) && knob.matters_to(scene));
    for setting in asked.flat_map(Knob::settings) {
        add(&mut subjects, Subject::new(scene, vec![setting]));
    }
    subjects
}

/// Adds a subject, or its name where the same look is there.
pub fn add(subjects: &mut Vec<Subject>, subject: Subject) {
    match subjects.iter_mut().find(|known| known.scene == subject.scene) {
        Some(known) => {
            for name in subject.names.into_iter().filter(|name| !name.is_empty()) {
                if !known.names.contains(&name) {
                    known.names.push(name);
                }
            }
        }
        None => subjects.push(subject),
    }
}

/// The scene with at most so many columns, in its own shape.
#[must_use]
pub fn narrowed(scene: &Scene, columns: u32) -> Scene {
    let Image { width, height } = scene.image;
    let mut smaller = scene.clone();
    if width > columns {
        let rows = (2 * u64::from(height) * u64::from(columns) + u64::from(width)) / (2 * u64::from(width));
        smaller.image = Image { width: columns, height: u32::try_from(rows).unwrap_or(height).max(1) };
    }
    smaller
}

/// The setting of this name and value, if there is one. Counts may be others than those that are tried.
#[must_use]
pub fn setting_named(knob: &str, value: &str) -> Option<Setting> {
    let knob = Knob::ALL.into_iter().find(|known| known.name() == knob)?;
    let tried = knob.settings().into_iter().find(|setting| setting.value == value);
    tried.or_else(|| counted(knob, value.parse().ok()?))
}

/// A setting of a knob that counts something.
#[must_use]
pub fn counted(knob: Knob, count: u32) -> Option<Setting> {
    let plain = Profile::STANDARD;
    let profile = match knob {
        Knob::Samples if count > 0 => Profile { samples: Some(count), ..plain },
        Knob::LensSamples if count > 0 => Profile { lens_samples: Some(count), ..plain },
        Knob::Wavelengths if count > 0 => Profile { wavelengths: Some(count), ..plain },
        Knob::Depth => Profile { depth: Some(count), ..plain },
        _ => return None,
    };
    Some(Setting { knob, value: count.to_string(), profile })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{embedded_scene, load};

    fn scene(name: &str) -> Scene {
        load(embedded_scene(name).unwrap().text, name).unwrap()
    }

    #[test]
    fn equal_looks_are_measured_once_under_all_their_names() {
        let scene = scene("hello/sphere");
        let subjects = subjects(&scene, &Knob::ALL);
        let names = |subject: &Subject| -> Vec<String> {
            let name = |settings: &Vec<Setting>| match settings.as_slice() {
                [] => "as it stands".to_owned(),
                [setting, ..] => format!("{} {}", setting.knob.name(), setting.value),
            };
            subject.names.iter().map(name).collect()
        };
        assert_eq!(names(&subjects[0]), ["as it stands", "arithmetic adaptive", "roots certified", "shortcuts all"]);
        assert!(subjects.iter().any(|subject| names(subject) == ["arithmetic f64", "roots recentred"]));
        for (k, subject) in subjects.iter().enumerate() {
            assert!(subjects[..k].iter().all(|other| other.scene != subject.scene));
        }
    }

    #[test]
    fn settings_are_found_by_their_names_and_counts_need_not_be_tried_ones() {
        for setting in Knob::ALL.into_iter().flat_map(Knob::settings) {
            assert_eq!(setting_named(setting.knob.name(), &setting.value), Some(setting));
        }
        assert_eq!(setting_named("samples", "23").unwrap().profile.samples, Some(23));
        for (knob, value) in [("samples", "0"), ("samples", "many"), ("filter", "3"), ("focus", "1")] {
            assert_eq!(setting_named(knob, value), None, "{knob} {value}");
        }
    }

    #[test]
    fn a_narrowed_scene_keeps_its_shape_and_a_small_one_its_size() {
        let scene = scene("hello/sphere");
        let [width, height] = [scene.image.width, scene.image.height];
        let half = narrowed(&scene, width / 2).image;
        assert_eq!([half.width, half.height], [width / 2, height / 2]);
        assert_eq!(narrowed(&scene, 10 * width).image, scene.image);
        assert_eq!(narrowed(&scene, 1).image.height, 1);
    }
}
