//! Going through the lines of a foreign ray tracer beside our own story of the same pixel.
//!
//! A `ray` line opens a ray, a `colour` line closes it. A ray is looked for among those that our ray has sent and that have no
//! partner yet: first by where it goes, then by its kind; below the innermost open ray first, then farther out, so that rays
//! which nobody closed are closed by the next one that cannot belong to them.

use super::allowance::Allowance;
use super::check::{Check, Subject, apart, unit};
use super::line::{Line, RayWord};
use super::ours::Ours;
use crate::compare::Said;
use crate::record::{EventId, RayKind, Triple, What};
use glam::DVec3;

/// A ray that is open.
#[derive(Clone, Copy, Debug)]
pub(super) struct Open {
    /// Ours, by its place in the list; none for one that ours does not send.
    pub ray: Option<usize>,
    /// Whether it goes to a light.
    pub is_shadow: bool,
    /// Their unit of t in ours: |their direction| / |our direction|; none while nobody has said.
    pub unit: Option<f64>,
    /// Whether they printed its direction, from which the unit follows.
    pub is_unit_told: bool,
    /// What is allowed along it.
    pub allowance: Allowance,
}

/// The way through the lines of one pixel.
pub(super) struct Walk<'a, 'b> {
    pub ours: &'b Ours<'a>,
    pub share: f64,
    pub checks: Vec<Check>,
    pub notes: Vec<String>,
    open: Vec<Open>,
    has_partner: Vec<bool>,
}

impl<'a, 'b> Walk<'a, 'b> {
    pub fn new(ours: &'b Ours<'a>, share: f64) -> Self {
        let has_partner = vec![false; ours.rays.len()];
        Self { ours, share, checks: Vec::new(), notes: Vec::new(), open: Vec::new(), has_partner }
    }

    /// Takes in one line.
    pub fn line(&mut self, line: &Line) {
        if let Some(word) = line.ray {
            self.begin_ray(line, word);
        }
        let on_shadow_ray = line.ray == Some(RayWord::Shadow)
            || (line.object.is_some() || line.hit.is_some()) && line.light.is_none() && line.colour.is_none();
        if !on_shadow_ray && self.open.last().is_some_and(|open| open.is_shadow) {
            self.open.pop();
        }
        let Some(open) = self.here() else {
            if line.colour.is_some() {
                self.open.pop();
            }
            return;
        };
        if let Some(ray) = open.ray {
            self.object(line, ray, open);
            self.hit(line, ray, open);
            if line.ray != Some(RayWord::Shadow) {
                self.light(line, ray, open);
            }
            self.bend(line, ray, open);
            self.colour(line, ray, open);
        }
        if line.colour.is_some() {
            self.open.pop();
        }
    }

    /// The innermost ray. Where none is open the line is about the camera ray.
    fn here(&mut self) -> Option<Open> {
        if self.open.is_empty() {
            let allowance = Allowance::new(self.share, 0, 0.0);
            self.open.push(Open { ray: Some(0), is_shadow: false, unit: None, is_unit_told: false, allowance });
        }
        self.open.last().copied().filter(|open| open.ray.is_some())
    }

    /// The innermost open ray.
    pub fn innermost(&mut self) -> Option<&mut Open> {
        self.open.last_mut()
    }

    /// Keeps something that is worth knowing and no departure, once.
    pub fn note(&mut self, note: String) {
        if !self.notes.contains(&note) {
            self.notes.push(note);
        }
    }

    fn begin_ray(&mut self, line: &Line, word: RayWord) {
        if self.open.last().is_some_and(|open| open.is_shadow) {
            self.open.pop();
        }
        if let Some(depth) = line.depth {
            self.open.truncate(depth as usize);
        }
        let direction = line.direction.map(DVec3::from_array);
        let partner = match word {
            RayWord::Camera => {
                self.open.clear();
                Some(0)
            }
            RayWord::Shadow => self.shadow_partner(line, direction),
            RayWord::Reflected => self.partner(line, RayKind::Reflected, direction),
            RayWord::Refracted => self.partner(line, RayKind::Refracted, direction),
        };
        let is_shadow = word == RayWord::Shadow;
        let depth = u32::try_from(self.open.len()).unwrap_or(u32::MAX);
        let Some(ray) = partner else {
            if !is_shadow {
                self.extra_ray(line, word);
            }
            let allowance = Allowance::new(self.share, depth, 0.0);
            self.open.push(Open { ray: None, is_shadow, unit: None, is_unit_told: false, allowance });
            return;
        };
        self.has_partner[ray] = true;
        let open = self.opened(line, ray, depth, is_shadow);
        self.open.push(open);
    }

    /// Compares the ray itself.
    fn opened(&mut self, line: &Line, ray: usize, depth: u32, is_shadow: bool) -> Open {
        let ours = &self.ours.rays[ray];
        let (event, origin, direction) = (ours.event, ours.origin, ours.direction);
        let mut moved = 0.0;
        if let Some(theirs) = line.origin {
            let distance = (DVec3::from_array(theirs) - origin).length();
            let before = Allowance::new(self.share, depth, self.open.last().map_or(0.0, |open| open.allowance.moved()));
            let allowed = if ray == 0 {
                before.point(origin, origin)
            } else {
                before.point(origin, origin).max(Allowance::start(origin))
            };
            moved = if distance <= allowed && distance > before.point(origin, origin) { distance } else { 0.0 };
            self.vector(line, [event, event], ray, Subject::RayOrigin, origin, theirs, allowed);
        }
        let inherited = self.open.last().map_or(0.0, |open| open.allowance.moved());
        let allowance = Allowance::new(self.share, depth, moved.max(inherited));
        let mut unit = None;
        if let Some(theirs) = line.direction {
            self.vector(line, [event, event], ray, Subject::RayDirection, direction, theirs, allowance.direction());
            unit = Some(DVec3::from_array(theirs).length() / direction.length());
        }
        Open { ray: Some(ray), is_shadow, unit, is_unit_told: unit.is_some(), allowance }
    }

    /// Our shadow ray that is meant: by the light's name, then by where it goes, then the next one.
    fn shadow_partner(&mut self, line: &Line, direction: Option<DVec3>) -> Option<usize> {
        let parent = self.open.last().map_or(Some(0), |open| open.ray)?;
        let free: Vec<usize> = self.free(parent, RayKind::Shadow).collect();
        if let Some(name) = &line.light {
            let is_named =
                |&&ray: &&usize| self.ours.rays[ray].light.as_ref().is_some_and(|light| same_name(light, name));
            return free.iter().find(is_named).copied();
        }
        let Some(direction) = direction else { return free.first().copied() };
        let along = |&&ray: &&usize| is_along(self.ours.rays[ray].direction, direction);
        free.iter().find(along).copied()
    }

    /// Our ray that is meant. Open rays that cannot have sent it are closed.
    fn partner(&mut self, line: &Line, kind: RayKind, direction: Option<DVec3>) -> Option<usize> {
        if self.open.last().is_some_and(|open| open.ray.is_none()) {
            return None;
        }
        let reach = if line.depth.is_some() { 1 } else { self.open.len() };
        let parents: Vec<(usize, usize)> =
            (0..self.open.len()).rev().take(reach).filter_map(|place| Some((place, self.open[place].ray?))).collect();
        let fits = |ray: usize| direction.is_none_or(|direction| is_along(self.ours.rays[ray].direction, direction));
        let find = |fits: &dyn Fn(usize) -> bool| {
            parents
                .iter()
                .find_map(|&(place, parent)| self.free(parent, kind).find(|&ray| fits(ray)).map(|ray| (place, ray)))
        };
        let (place, ray) = find(&fits).or_else(|| find(&|_| true))?;
        self.open.truncate(place + 1);
        Some(ray)
    }

    /// The rays of a kind that ours has sent and that have no partner yet.
    fn free(&self, parent: usize, kind: RayKind) -> impl Iterator<Item = usize> + '_ {
        let rays = self.ours.rays.iter().enumerate();
        rays.filter(move |(k, ray)| ray.parent == Some(parent) && ray.kind == kind && !self.has_partner[*k])
            .map(|(k, _)| k)
    }

    fn extra_ray(&mut self, line: &Line, word: RayWord) {
        let Some(ray) = self.open.last().and_then(|open| open.ray) else { return };
        let stopped = self.ours.of(ray).find_map(|event| match &event.what {
            What::Limit { limit, consequence, .. } if consequence.contains(word.name()) => {
                Some((event.id, format!("none: stopped by {limit}; {consequence}")))
            }
            _ => None,
        });
        let last = self.ours.of(ray).last().map_or(0, |event| event.id);
        let (event, ours) = stopped.unwrap_or((last, "none".to_owned()));
        let theirs = format!("a {} ray", word.name());
        self.words(line, [event, event], ray, Subject::ExtraRay, ours, theirs);
    }

    /// Compares two vectors; `places` are the event and its place in the order of the story.
    #[expect(clippy::too_many_arguments, reason = "one thing each, and all of them are needed")]
    pub fn vector(
        &mut self,
        line: &Line,
        places: [EventId; 2],
        ray: usize,
        subject: Subject,
        ours: DVec3,
        theirs: Triple,
        allowed: f64,
    ) {
        self.numbers(line, places, ray, subject, ours.to_array().to_vec(), theirs.to_vec(), allowed);
    }

    /// Compares two lists of numbers.
    #[expect(clippy::too_many_arguments, reason = "one thing each, and all of them are needed")]
    pub fn numbers(
        &mut self,
        line: &Line,
        [event, order]: [EventId; 2],
        ray: usize,
        subject: Subject,
        ours: Vec<f64>,
        theirs: Vec<f64>,
        allowed: f64,
    ) {
        let off = if subject.is_direction() { apart(&unit(&ours), &unit(&theirs)) } else { apart(&ours, &theirs) };
        let (ours, theirs) = (Said::Numbers(ours), Said::Numbers(theirs));
        let unit = self.told_unit();
        let (line, time) = (line.number, None);
        self.checks.push(Check { line, event, order, ray, unit, time, subject, ours, theirs, allowed, off });
    }

    /// Their unit of t, where they printed the direction of the innermost ray.
    fn told_unit(&self) -> Option<f64> {
        self.open.last().and_then(|open| open.unit.filter(|_| open.is_unit_told))
    }

    /// Compares two words.
    pub fn words(
        &mut self,
        line: &Line,
        [event, order]: [EventId; 2],
        ray: usize,
        subject: Subject,
        ours: String,
        theirs: String,
    ) {
        let off = if same_name(&ours, &theirs) { 0.0 } else { f64::INFINITY };
        let (ours, theirs) = (Said::Words(ours), Said::Words(theirs));
        let (unit, time, line, allowed) = (self.told_unit(), line.t, line.number, 0.0);
        self.checks.push(Check { line, event, order, ray, unit, time, subject, ours, theirs, allowed, off });
    }
}

/// Whether two directions are the same up to a length, roughly: to tell rays apart, not to judge them.
fn is_along(a: DVec3, b: DVec3) -> bool {
    a.normalize_or_zero().dot(b.normalize_or_zero()) > 1.0 - 1e-6
}

/// Whether two names are the same but for subscripts, which not everybody can type.
pub(super) fn same_name(a: &str, b: &str) -> bool {
    let plain = |name: &str| -> String {
        let digit = |c: char| match c {
            '₀'..='₉' => char::from_digit(u32::from(c) - u32::from('₀'), 10).unwrap_or(c),
            other => other,
        };
        name.trim().chars().map(digit).collect::<String>().to_lowercase()
    };
    plain(a) == plain(b)
}
