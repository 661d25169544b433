//! What to choose instead of a setting: as fast, but closer; as close, but faster.

use super::{Point, Study};

/// Times that differ by no more than this share count as equal: less than that is hardly ever more than noise.
const AS_FAST: f64 = 0.10;
/// Errors likewise: nobody sees a tenth of an error.
const AS_CLOSE: f64 = 0.10;

impl Study {
    /// The scene as it stands, then all others.
    pub fn all(&self) -> impl Iterator<Item = &Point> {
        std::iter::once(&self.standard).chain(&self.points)
    }

    /// Of the points that take no more time than this one, the closest to the reference, if it is closer; by its place in
    /// [`all`](Self::all).
    #[must_use]
    pub fn as_fast_but_closer(&self, point: &Point) -> Option<usize> {
        let seconds = (1.0 + AS_FAST) * point.timing.told()?;
        let error = (1.0 - AS_CLOSE) * point.errors.rmse;
        let closer = self.choices().filter(|(_, time, other)| *time <= seconds && other.errors.rmse < error);
        closer.min_by(|a, b| a.2.errors.rmse.total_cmp(&b.2.errors.rmse).then(a.1.total_cmp(&b.1))).map(|(k, ..)| k)
    }

    /// Of the points that are no farther from the reference than this one, the fastest, if it is faster; likewise.
    #[must_use]
    pub fn as_close_but_faster(&self, point: &Point) -> Option<usize> {
        let seconds = (1.0 - AS_FAST) * point.timing.told()?;
        let error = (1.0 + AS_CLOSE) * point.errors.rmse;
        let faster = self.choices().filter(|(_, time, other)| *time < seconds && other.errors.rmse <= error);
        faster.min_by(|a, b| a.1.total_cmp(&b.1).then(a.2.errors.rmse.total_cmp(&b.2.errors.rmse))).map(|(k, ..)| k)
    }

    /// The points that may be chosen, with their places and times: no controls, and nothing that is lost in noise.
    fn choices(&self) -> impl Iterator<Item = (usize, f64, &Point)> {
        let all = self.all().enumerate().filter(|(_, point)| !point.is_control());
        all.filter_map(|(k, point)| Some((k, point.timing.told()?, point)))
    }
}

impl Point {
    /// The settings in words; of none, that the scene is as it stands.
    #[must_use]
    pub fn plain_name(&self) -> String {
        if self.settings.is_empty() { "as it stands".to_owned() } else { self.name() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::laboratory::{Errors, Noise, Reference, Timing, setting_named};
    use crate::scene::{Profile, Rgb};
    use crate::trace::Picture;

    fn point(samples: &str, seconds: f64, error: f64) -> Point {
        let errors = Errors { rmse: error, ..Errors::default() };
        Point {
            settings: setting_named("samples", samples).into_iter().collect(),
            profile: Profile::STANDARD,
            timing: Timing { seconds, spread: 0.0, repeats: 5, noise: None },
            errors,
            change: errors,
            on_frontier: false,
            picture: Picture::from_pixels(1, 1, vec![Rgb::ZERO]).unwrap(),
        }
    }

    fn study() -> Study {
        let standard = Point { settings: Vec::new(), ..point("4", 1.0, 0.02) };
        let picture = standard.picture.clone();
        let reference = Reference { profile: Profile::STANDARD, picture, pictures: 1, error: 0.0, cached: false };
        // The closest of the equally fast, a fast one, a slow one, and one that only differs by noise.
        let points =
            vec![point("1", 1.05, 0.01), point("16", 0.25, 0.021), point("64", 9.0, 0.001), point("5", 0.99, 0.0199)];
        Study { reference, standard, points, resolution: 1e-6, waiting: 0.0 }
    }

    #[test]
    fn the_closest_of_the_equally_fast_and_the_fastest_of_the_equally_close_are_found() {
        let study = study();
        assert_eq!(study.as_fast_but_closer(&study.standard), Some(1));
        assert_eq!(study.as_close_but_faster(&study.standard), Some(2));
    }

    #[test]
    fn what_nothing_beats_has_no_pair() {
        let study = study();
        assert_eq!(study.as_fast_but_closer(&study.points[2]), None);
        assert_eq!(study.as_close_but_faster(&study.points[2]), None);
    }

    #[test]
    fn noise_is_no_choice_and_has_none() {
        let mut study = study();
        study.points[0].timing.noise = Some(Noise::Spread(0.5));
        assert_eq!(study.as_fast_but_closer(&study.standard), None);
        assert_eq!(study.as_fast_but_closer(&study.points[0]), None);
    }
}
