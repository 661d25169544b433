//! Makes the reference: takes it from where an earlier run left it, and adds pictures until it is sure enough.

use super::bench::Bench;
use super::errors::rmse;
use super::reference::{FEWEST_PICTURES, Sums, best_profile, is_random, reference_scene};
use super::{Knob, Reference, Store};
use crate::scene::{Image, Scene};
use crate::trace::{Picture, render};

/// The reference is sure enough when its error is this share of the smallest that is compared with it: it adds 3 % to that.
const SURER: f64 = 0.25;

/// The reference of one scene in one size.
pub(super) struct Referee {
    scene: Scene,
    name: String,
    sums: Sums,
    was_cached: bool,
}

impl Referee {
    /// With what an earlier run left, if that can be used; otherwise with the reason why not.
    pub fn new(scene: &Scene, store: &mut dyn Store, warnings: &mut Vec<String>) -> Self {
        let Image { width, height } = scene.image;
        let name = format!("{width} × {height}, seed {}, {:?}", scene.sampling.seed, best_profile(scene));
        let mut sums = Sums::new(width, height);
        if let Some(bytes) = store.load(&name) {
            match Sums::from_bytes(&bytes, &name) {
                Ok(found) => sums = found,
                Err(why) => warnings.push(format!("the reference in the cache is of no use: {why}; it is made anew")),
            }
        }
        let was_cached = sums.count > 0;
        Self { scene: scene.clone(), name, sums, was_cached }
    }

    /// The pictures that it has to have.
    pub fn fewest(scene: &Scene) -> u32 {
        if is_random(scene) { FEWEST_PICTURES } else { 1 }
    }

    /// Adds the pictures that it has to have. None if that was interrupted.
    pub fn begin(&mut self, bench: &mut Bench) -> Option<()> {
        while self.sums.count < Self::fewest(&self.scene) {
            self.add_picture(bench)?;
        }
        Some(())
    }

    /// Adds pictures until it is much surer than what these are off by, or so many seconds are used.
    pub fn improve(&mut self, bench: &mut Bench, seconds: f64, pictures: &[&Picture]) {
        let mut used = 0.0;
        while is_random(&self.scene) && !self.is_surer_than(pictures) {
            let Some(taken) = self.add_picture(bench) else { return };
            used += taken;
            if used + taken > seconds {
                return;
            }
        }
    }

    fn is_surer_than(&self, pictures: &[&Picture]) -> bool {
        let Some(mean) = self.sums.mean() else { return false };
        let least = pictures.iter().map(|picture| rmse(picture, &mean)).fold(f64::INFINITY, f64::min);
        self.sums.error() <= SURER * least
    }

    /// Adds one picture, on all threads. Says what it took; none if it was interrupted.
    fn add_picture(&mut self, bench: &mut Bench) -> Option<f64> {
        let (picture, seconds) = rendered(&reference_scene(&self.scene, self.sums.count), bench)?;
        self.sums.add(&picture);
        Some(seconds)
    }

    /// Keeps it for later runs, and says what it is. None if that was interrupted.
    pub fn finish(&self, bench: &mut Bench, store: &mut dyn Store) -> Option<Reference> {
        store.save(&self.name, &self.sums.to_bytes(&self.name));
        let reference = self.sums.reference(&self.scene, self.was_cached)?;
        let error = reference.error.max(self.left_by_wavelengths(bench, &reference.picture)?);
        Some(Reference { error, ..reference })
    }

    /// By how much it would change with half of its wavelengths, where these stand evenly and nothing else is left to chance:
    /// more than with twice as many.
    fn left_by_wavelengths(&self, bench: &mut Bench, picture: &Picture) -> Option<f64> {
        if is_random(&self.scene) || !Knob::Wavelengths.matters_to(&self.scene) {
            return Some(0.0);
        }
        let mut coarser = reference_scene(&self.scene, 0);
        coarser.sampling.wavelengths = (coarser.sampling.wavelengths / 2).max(1);
        Some(rmse(&rendered(&coarser, bench)?.0, picture))
    }
}

/// The scene's picture, on all threads, and the seconds that it took; none if it was interrupted.
fn rendered(scene: &Scene, bench: &mut Bench) -> Option<(Picture, f64)> {
    let progress = bench.progress;
    let mut picture = None;
    let seconds = bench.spend(&mut || {
        let rendered = render(scene, progress).0;
        let work = rendered.computed() as u64;
        picture = Some(rendered);
        work
    });
    Some((picture.filter(|_| !progress.cancelled())?, seconds))
}
