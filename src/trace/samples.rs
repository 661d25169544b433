//! Several samples of a pixel: a ray for each, and the mean of what they bring back.

use super::calls::Repertoire;
use super::lens::LENS_POINTS;
use super::pixel::Aim;
use super::ray::Tracer;
use crate::record::{Average, Counter, Effect, Entry, Recorder, Sample, What};
use crate::sample::{PixelFilter, Purpose, Stream};
use crate::scene::{Adaptive, Rgb, Sampling};
use smallvec::SmallVec;

/// What came back so far: weights and colours, in the order of the samples.
#[derive(Default)]
struct Gathered {
    samples: SmallVec<[(f64, Rgb); 64]>,
    weights: f64,
    sum: Rgb,
}

/// Why no more samples were taken.
enum Stop {
    /// The scene does not ask for more.
    AllTaken,
    /// The standard error is small enough.
    SureEnough(Adaptive),
    /// It is not, and there may be no more.
    MostTaken(Adaptive),
}

impl Gathered {
    fn add(&mut self, weight: f64, colour: Rgb) {
        self.samples.push((weight, colour));
        self.weights += weight;
        self.sum += colour * weight;
    }

    fn count(&self) -> u32 {
        u32::try_from(self.samples.len()).unwrap_or(u32::MAX)
    }

    /// The weights as they count: where too many of a few samples happen to lie where the filter is below zero for it to be
    /// told what it lets through, all count alike.
    fn weight(&self, weight: f64) -> f64 {
        if self.weights > 0.0 { weight } else { 1.0 }
    }

    fn mean(&self) -> Rgb {
        if self.weights > 0.0 {
            return self.sum / self.weights;
        }
        self.samples.iter().map(|&(_, colour)| colour).sum::<Rgb>() / self.samples.len() as f64
    }

    /// The sum of the squares of what the samples differ from their mean by, each by its weight.
    fn squares(&self) -> Rgb {
        let mean = self.mean();
        let difference = |&(weight, colour): &(f64, Rgb)| (colour - mean) * self.weight(weight);
        self.samples.iter().map(difference).map(|d| d * d).sum()
    }

    /// The standard error of the mean, by channel: that of independent samples. Even samples err by less.
    fn error(&self) -> Option<Rgb> {
        let count = self.samples.len() as f64;
        let weights = if self.weights > 0.0 { self.weights } else { count };
        let deviation = |squares: f64| (count * squares / (count - 1.0)).sqrt() / weights;
        (count > 1.0).then(|| Rgb::from_array(self.squares().to_array().map(deviation)))
    }

    fn describe(&self, filter: PixelFilter, stop: &Stop) -> Entry {
        let (count, mean, error) = (self.samples.len() as f64, self.mean(), self.error());
        let weights = if self.weights > 0.0 { self.weights } else { count };
        let sum = if self.weights > 0.0 { self.sum } else { mean * count };
        let bindings = [
            ("S", sum.to_array().into()),
            ("W", weights.into()),
            ("n", count.into()),
            ("Q", self.squares().to_array().into()),
        ];
        let entry = Entry::new(What::Average(Average {
            samples: self.count(),
            filter: filter.name().to_owned(),
            weights,
            error: error.map(Rgb::max_element),
            stopped: stop.describe(self.count()),
            colour: mean.to_array(),
        }))
        .line("I", "S / W", &bindings, mean.to_array());
        match error {
            Some(error) => entry.line("e", "√(n Q / (n − 1)) / W", &bindings, error.to_array()),
            None => entry,
        }
    }
}

impl Stop {
    fn describe(&self, taken: u32) -> String {
        match self {
            Self::AllTaken if taken == 1 => "the scene asks for one sample".to_owned(),
            Self::AllTaken => format!("the scene asks for {taken} samples"),
            Self::SureEnough(Adaptive { error, .. }) => format!("the standard error is at most {error}"),
            Self::MostTaken(Adaptive { most, error }) => {
                format!("{most} samples are the most that the scene allows; the standard error is above {error}")
            }
        }
    }
}

impl<E: Repertoire> Tracer<'_, E> {
    /// Whether pixels are sampled, and not looked at through their centres alone.
    pub(super) fn takes_samples(&self) -> bool {
        self.takes_several() || self.lens().is_some()
    }

    fn takes_several(&self) -> bool {
        self.calls_for(Effect::Antialiasing) && self.scene.sampling.is_many()
    }

    /// The mean colour of the samples of a pixel; `stream` is that of its first one.
    #[inline(never)]
    pub(super) fn trace_samples<R: Recorder>(&self, pixel: [u32; 2], stream: Stream, recorder: &mut R) -> Rgb {
        let several = self.takes_several();
        let sampling = if several {
            self.scene.sampling
        } else {
            Sampling { lens_samples: self.scene.sampling.lens_samples, ..Sampling::CENTRE }
        };
        let mut gathered = Gathered::default();
        // Rays that go through one place of the pixel, each through another point of the lens.
        let together = if self.lens().is_some() { sampling.lens_samples.max(1) } else { 1 };
        let mut target = sampling.samples;
        let stop = loop {
            // Each stands for its part of the pixel, as many as there will be.
            let beam_side = 1.0 / f64::from(target).sqrt();
            for first in (gathered.count()..target.saturating_mul(together)).step_by(LENS_POINTS) {
                let on_lens = self.lens().map(|lens| self.lens_points(lens, stream, first));
                for (number, k) in (first..target.saturating_mul(together)).zip(0..LENS_POINTS) {
                    let on_lens = on_lens.map(|points| points[k]);
                    let aim = Aim { beam_side, on_lens, ..Aim::centre(pixel, stream.sample(number)) };
                    let place = several.then(|| stream.sample(number / together));
                    let (weight, colour) = self.trace_sample(aim, number, place, recorder);
                    gathered.add(weight, colour);
                }
            }
            match stop(&gathered, sampling.adaptive) {
                Some(stop) => break stop,
                None => target = target.saturating_mul(2).min(sampling.adaptive.map_or(target, |a| a.most)),
            }
        };
        recorder.note(|| gathered.describe(sampling.filter, &stop));
        gathered.mean()
    }

    /// The weight and the colour of one sample, whose aim is the pixel's centre as yet; `place` has the random numbers that
    /// move it from there, if it is to be moved.
    fn trace_sample<R: Recorder>(
        &self,
        mut aim: Aim,
        number: u32,
        place: Option<Stream>,
        recorder: &mut R,
    ) -> (f64, Rgb) {
        recorder.begin();
        let (mut offset, mut weight) = ([0.0; 2], 1.0);
        if let Some(place) = place {
            Self::enter(Effect::Antialiasing, recorder);
            if number > 0 {
                recorder.count(Counter::Sent(Effect::Antialiasing));
            }
            (offset, weight) = self.scene.sampling.filter.place(place.square(Purpose::Pixel));
            aim.at = [aim.at[0] + offset[0], aim.at[1] + offset[1]];
        }
        let ray = self.build_ray(&aim, recorder);
        let colour = self.trace(&ray, recorder);
        recorder.end(|| Entry::new(What::Sample(Sample { number, at: aim.at, offset, weight })));
        (weight, colour)
    }
}

/// Whether enough samples were taken, and why.
fn stop(gathered: &Gathered, adaptive: Option<Adaptive>) -> Option<Stop> {
    let Some(adaptive) = adaptive else { return Some(Stop::AllTaken) };
    if gathered.error().is_some_and(|error| error.max_element() <= adaptive.error) {
        return Some(Stop::SureEnough(adaptive));
    }
    (gathered.count() >= adaptive.most).then_some(Stop::MostTaken(adaptive))
}
