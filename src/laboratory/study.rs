//! A whole study: what is measured first, what next, and when it is enough.
//!
//! 1. Every look at the scene is rendered once, very small, to learn how large pictures the budget allows.
//! 2. The reference is made, or taken from where an earlier run left it.
//! 3. All are rendered in their size: this gives their errors, and is not timed.
//! 4. The reference is made better, until it is much surer than what is compared with it, or its share of the budget is used.
//! 5. All are timed in turn, again and again.
//! 6. What should do well together is rendered and timed, too, until every time is sure or the budget is used.
//! 7. What answers the questions is looked at in the size of the whole picture.

use super::bench::Bench;
use super::proposal::proposals;
use super::referee::Referee;
use super::reference::reference_scene;
use super::results::{judge, results};
use super::subject::{Subject, add, narrowed, subjects};
use super::timing::{FEWEST_REPEATS, Repeat};
use super::whole::checked;
use super::{Answer, Earlier, Plan, Reference, Study, Timing, Tools};
use crate::scene::{Image, Scene};
use crate::trace::{Picture, render};

/// What came of a study.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// What was measured.
    pub study: Study,
    /// The repeats behind each time: those of the scene as it stands, then those of the points in their order.
    pub repeats: Vec<Vec<Repeat>>,
    /// The repeats of the pinned work.
    pub pinned: Vec<Repeat>,
    /// What they tell.
    pub pinned_timing: Timing,
    /// The size of the scene's own picture.
    pub whole: Image,
    /// What was asked, answered.
    pub answers: Vec<Answer>,
    /// The seconds on the wall that it took.
    pub spent: f64,
    /// Whether it was interrupted.
    pub is_cut_short: bool,
    /// What did not go as it should and yet did not stop it.
    pub warnings: Vec<String>,
}

/// Columns of the pictures that tell how dear everything is. Fewer would be mostly edges.
const PILOT: u32 = 20;

/// Sizes that are tried, in shares of the width that is asked for: few, so that another run finds the same one and its reference.
const SHARES: [f64; 7] = [1.0, 0.75, 0.5, 0.375, 0.25, 0.1875, 0.125];

/// Times that every look is rendered at least, for a size to fit the budget: once to warm up, and five times.
const RENDERINGS: f64 = 6.0;

/// The share of the budget that these may use.
const MEASURING: f64 = 0.5;

/// The share of the budget that the reference may use.
const REFERRING: f64 = 0.3;

/// The share of the budget after which combinations have their turn.
const SINGLES: f64 = 0.7;

/// The share of the budget in which answers are looked at in the whole picture's size.
const CHECKING: f64 = 0.3;

/// So many are looked at for each goal.
const TRIES: usize = 3;

/// How often combinations are proposed: each time more is known of how they do.
const PASSES: usize = 3;

struct Studying<'a, 'b> {
    scene: Scene,
    whole: Image,
    plan: &'a Plan,
    bench: Bench<'b>,
    subjects: Vec<Subject>,
    reference: Reference,
    watch: &'b mut dyn FnMut(&dyn Fn() -> Study),
}

/// Measures a scene. None if it was cancelled before the scene itself could be compared with a reference.
#[must_use]
pub fn study(scene: &Scene, plan: &Plan, earlier: Option<&Earlier>, tools: Tools) -> Option<Run> {
    let Tools { stopwatch, store, progress, watch } = tools;
    let mut bench = Bench::new(stopwatch, progress)?;
    let mut warnings = Vec::new();
    let mut sized = scene.clone();
    sized.sampling.seed = plan.seed.unwrap_or(scene.sampling.seed);
    sized.image = match earlier {
        Some(Earlier { size: [width, height], .. }) => Image { width: *width, height: *height },
        None => size_for_the_budget(&sized, plan, &mut bench),
    };
    let mut referee = Referee::new(&sized, store, &mut warnings);
    referee.begin(&mut bench)?;
    let mut subjects = subjects(&sized, &plan.knobs);
    if let Some(earlier) = earlier {
        take_over(earlier, &sized, &mut subjects);
        bench.pinned.clone_from(&earlier.pinned);
    }
    let rendered = subjects.iter_mut().map_while(|subject| bench.warm_up(subject)).count();
    subjects.truncate(rendered.max(1));
    let pictures: Vec<&Picture> = subjects.iter().filter_map(|subject| subject.picture.as_ref()).collect();
    pictures.first()?;
    referee.improve(&mut bench, REFERRING * plan.budget, &pictures);
    let reference = referee.finish(&mut bench, store)?;
    judge(&mut subjects, &reference);
    let mut studying = Studying { scene: sized, whole: scene.image, plan, bench, subjects, reference, watch };
    studying.measure();
    Some(studying.finish(warnings))
}

/// The largest size for which the budget should do, by pictures that are very small.
fn size_for_the_budget(scene: &Scene, plan: &Plan, bench: &mut Bench) -> Image {
    let small = narrowed(scene, plan.width.min(PILOT));
    let taken = |bench: &mut Bench, mut pilot| bench.warm_up(&mut pilot).map_or(0.0, |taken| taken.wall.as_secs_f64());
    let looks: f64 = subjects(&small, &plan.knobs).into_iter().map(|pilot| taken(bench, pilot)).sum();
    let (best, progress) = (reference_scene(&small, 0), bench.progress);
    let reference =
        f64::from(Referee::fewest(&small)) * bench.spend(&mut || render(&best, progress).0.computed() as u64);
    let fits = |size: &Image| {
        let times = pixels(*size) / pixels(small.image);
        RENDERINGS * times * looks <= MEASURING * plan.budget && times * reference <= REFERRING * plan.budget
    };
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most the width")]
    let columns = |share: f64| ((share * f64::from(plan.width)).round() as u32).max(1);
    let sizes = SHARES.map(|share| narrowed(scene, columns(share)).image);
    sizes.into_iter().find(fits).unwrap_or(sizes[sizes.len() - 1])
}

fn pixels(image: Image) -> f64 {
    f64::from(image.width) * f64::from(image.height)
}

/// Adds what an earlier run measured, and the combinations that it found.
fn take_over(earlier: &Earlier, scene: &Scene, subjects: &mut Vec<Subject>) {
    for (settings, repeats) in &earlier.repeats {
        let subject = Subject { repeats: repeats.clone(), ..Subject::new(scene, settings.clone()) };
        match subjects.iter_mut().find(|known| known.scene == subject.scene) {
            Some(known) if known.repeats.is_empty() => known.repeats = subject.repeats,
            Some(_) => {}
            None => subjects.push(subject),
        }
    }
}

impl Studying<'_, '_> {
    fn measure(&mut self) {
        self.time_until(if self.plan.combines { SINGLES } else { 1.0 });
        for _ in 0..PASSES {
            if !self.plan.combines || self.is_over() || !self.combine() {
                break;
            }
        }
        self.time_until(if self.plan.goals.is_empty() { 1.0 } else { 1.0 - CHECKING });
    }

    /// The best answers, looked at in the whole picture's size. Where the best one does not hold there, the next ones are tried.
    fn answers(&mut self, study: &Study) -> Vec<Answer> {
        let (scale, plan) = (self.scale(), self.plan);
        let seconds = CHECKING * plan.budget / plan.goals.len().max(1) as f64;
        let whole = Scene { image: self.whole, ..self.scene.clone() };
        let mut answers = Vec::new();
        for goal in &plan.goals {
            let mut tried: Vec<Answer> = Vec::new();
            for answer in goal.ranked(study, scale).into_iter().take(TRIES) {
                let checked = if scale > 1.0 { checked(answer, &whole, &mut self.bench, seconds) } else { answer };
                let is_met = checked.is_met;
                tried.push(checked);
                if is_met {
                    break;
                }
            }
            answers.extend(tried.into_iter().min_by(Answer::compare));
        }
        answers
    }

    fn is_over(&self) -> bool {
        self.bench.progress.cancelled() || self.bench.spent >= self.plan.budget
    }

    /// Rounds until every time is sure, or the share of the budget is used. A few rounds there are in any case.
    fn time_until(&mut self, share: f64) {
        loop {
            let fewest = self.subjects.iter().map(|subject| subject.repeats.len()).min().unwrap_or(0);
            let is_sure = |subject: &Subject| subject.timing(self.bench.resolution).is_sure();
            let price = self.bench.price(&self.subjects);
            let is_enough = self.subjects.iter().all(is_sure) || self.bench.spent + price > share * self.plan.budget;
            if self.bench.progress.cancelled() || (fewest >= FEWEST_REPEATS as usize && is_enough) {
                return;
            }
            self.bench.round(&mut self.subjects);
            self.show();
        }
    }

    /// Renders the combinations that promise most, and times them a few times. Says whether any of them is new.
    fn combine(&mut self) -> bool {
        let before = self.subjects.len();
        let mut left = self.plan.budget - self.bench.spent;
        for proposal in proposals(&self.study(), &self.plan.goals, self.scale()) {
            let price = f64::from(1 + FEWEST_REPEATS) * proposal.seconds;
            if price < left {
                left -= price;
                add(&mut self.subjects, Subject::new(&self.scene, proposal.settings));
            }
        }
        let mut rendered = before;
        while rendered < self.subjects.len() && !self.is_over() {
            if self.bench.warm_up(&mut self.subjects[rendered]).is_none() {
                break;
            }
            rendered += 1;
        }
        self.subjects.truncate(rendered);
        judge(&mut self.subjects, &self.reference);
        for _ in 0..FEWEST_REPEATS {
            self.bench.round(&mut self.subjects[before..]);
        }
        self.show();
        rendered > before
    }

    /// How many times as many pixels the scene's own picture has.
    fn scale(&self) -> f64 {
        pixels(self.whole) / pixels(self.scene.image)
    }

    fn show(&mut self) {
        let Self { watch, subjects, reference, bench, .. } = self;
        watch(&|| results(subjects, reference, bench).0);
    }

    fn study(&self) -> Study {
        results(&self.subjects, &self.reference, &self.bench).0
    }

    fn finish(mut self, warnings: Vec<String>) -> Run {
        let (study, repeats) = results(&self.subjects, &self.reference, &self.bench);
        Run {
            answers: self.answers(&study),
            study,
            repeats,
            pinned_timing: self.bench.pinned_timing(),
            whole: self.whole,
            spent: self.bench.spent,
            is_cut_short: self.bench.progress.cancelled(),
            warnings,
            pinned: self.bench.pinned,
        }
    }
}
