//! Lines about the search for hits: rays in generic coordinates, hit times, intervals, the hit.

use super::check::{Subject, apart};
use super::line::Line;
use super::ours::OurHit;
use super::walk::{Open, Walk, same_name};
use crate::record::{CandidateFate, Event, EventId, Sense, Span, What};
use glam::DVec3;

/// Times up to this, in units of |t| + |origin| / |direction|, count as the ray's own start, which may be left out.
const START: f64 = 1e-9;

impl Walk<'_, '_> {
    /// What a line says of an object.
    pub(super) fn object(&mut self, line: &Line, ray: usize, open: Open) {
        let Some(name) = &line.object else { return };
        let Some((object, leaf)) = self.meant(line, name, ray) else { return };
        let primitives: Vec<(&Event, &str)> = self.ours.primitives(object.id).collect();
        let wanted = leaf.or(line.leaf.as_deref());
        let primitive = match wanted {
            Some(leaf) => primitives.iter().find(|(_, name)| same_name(name, leaf)),
            None => primitives.first().filter(|_| primitives.len() == 1),
        };
        if let Some((primitive, _)) = primitive {
            self.generic(line, ray, open, primitive.id);
            self.hits(line, ray, open, primitive.id);
        } else if wanted.is_none()
            && let Some(theirs) = &line.hits
        {
            let edges = self.ours.combined(object.id).map(|node| edges(node.result)).unwrap_or_default();
            self.times(line, ray, open, (Subject::Edges(object.id), object.id), &edges, theirs);
        }
        if wanted.is_none() {
            self.inside(line, ray, open, object);
        }
    }

    /// The object that a name stands for; where it is that of a primitive, that too.
    fn meant<'n>(&mut self, line: &Line, name: &'n str, ray: usize) -> Option<(&'n Event, Option<&'n str>)>
    where
        Self: 'n,
    {
        let asked = |walk: &Self, wanted: &str| {
            walk.ours.of(ray).find(|event| matches!(&event.what, What::Object { name, .. } if same_name(name, wanted)))
        };
        let object = asked(self, name).map(|event| (event.id, None)).or_else(|| {
            let owner = self.ours.scene.objects.iter().find(|object| {
                object.solid.leaves.len() > 1 && object.solid.leaves.iter().any(|leaf| same_name(&leaf.name, name))
            })?;
            asked(self, &owner.name).map(|event| (event.id, Some(name)))
        });
        if object.is_none() && !self.ours.scene.objects.iter().any(|object| same_name(&object.name, name)) {
            self.note(format!("line {}: the scene has no object `{name}`", line.number));
        }
        let tree = self.ours.tree;
        object.map(|(id, leaf)| (tree.event(id), leaf))
    }

    fn generic(&mut self, line: &Line, ray: usize, open: Open, primitive: EventId) {
        let Some((event, s, c)) = self.ours.transform(primitive) else { return };
        if let Some(theirs) = line.generic_origin {
            let allowed = open.allowance.vector(1.0 + s.abs().max_element());
            self.vector(line, [event, event], ray, Subject::GenericOrigin(primitive), s, theirs, allowed);
        }
        if let Some(theirs) = line.generic_direction {
            let allowed = open.allowance.vector(c.abs().max_element());
            let scaled = |unit: f64| (DVec3::from_array(theirs) / unit).to_array();
            let units = units(open, self.ours.rays[ray].direction);
            let off = |unit: f64| apart(&scaled(unit), &c.to_array());
            let unit = nearest(&units, off);
            self.learn(unit);
            let subject = Subject::GenericDirection(primitive);
            self.vector(line, [event, event], ray, subject, c, scaled(unit), allowed);
        }
    }

    fn hits(&mut self, line: &Line, ray: usize, open: Open, primitive: EventId) {
        let Some(theirs) = &line.hits else { return };
        let (event, ours) = match self.ours.candidates(primitive) {
            Some((event, candidates)) => (
                event,
                candidates.iter().filter(|c| c.fate == CandidateFate::Accepted).map(|c| c.t).collect::<Vec<_>>(),
            ),
            None => (primitive, Vec::new()),
        };
        self.times(line, ray, open, (Subject::Hits(primitive), event), &ours, theirs);
    }

    /// Compares hit times. Those that are not in front of the ray may be left out.
    fn times(
        &mut self,
        line: &Line,
        ray: usize,
        open: Open,
        (subject, event): (Subject, EventId),
        ours: &[f64],
        theirs: &[f64],
    ) {
        let our_ray = &self.ours.rays[ray];
        let ends = [our_ray.origin, our_ray.direction];
        let largest = ours.iter().chain(theirs).fold(0.0_f64, |most, t| most.max(t.abs()));
        let allowed = open.allowance.time(largest, 0.0, ends);
        let start = START * (largest + ends[0].abs().max_element() / ends[1].length());
        let units = units(open, ends[1]);
        let paired = |unit: f64| {
            let mut theirs: Vec<f64> = theirs.iter().map(|t| t * unit).collect();
            theirs.sort_by(f64::total_cmp);
            (required(ours, &theirs, start.max(allowed)), theirs)
        };
        let unit = nearest(&units, |unit| {
            let (ours, theirs) = paired(unit);
            apart(&ours, &theirs)
        });
        self.learn(unit);
        let (ours, theirs) = paired(unit);
        self.numbers(line, [event, event], ray, subject, ours, theirs, allowed);
    }

    fn inside(&mut self, line: &Line, ray: usize, open: Open, object: &Event) {
        let Some(theirs) = &line.inside else { return };
        let (event, ours) = match self.ours.combined(object.id) {
            Some(node) => (node.event, intervals(node.result)),
            None => (object.id, self.crossings(object.id)),
        };
        let our_ray = &self.ours.rays[ray];
        let (direction, origin) = (our_ray.direction, our_ray.origin);
        let units = units(open, direction);
        let scaled = |unit: f64| {
            let end = |t: Option<f64>, open: f64| t.map_or(open, |t| t * unit);
            let mut list: Vec<[f64; 2]> =
                theirs.iter().map(|[a, b]| [end(*a, f64::NEG_INFINITY), end(*b, f64::INFINITY)]).collect();
            list.sort_by(|a, b| a[0].total_cmp(&b[0]));
            list
        };
        let start = START * origin.abs().max_element() / direction.length();
        let in_front = |list: &[[f64; 2]]| -> Vec<f64> {
            // A program that looks ahead alone begins an interval that holds the start at 0 or behind it.
            let ahead = list.iter().filter(|[_, to]| *to > start);
            ahead.flat_map(|[from, to]| [from.max(0.0), *to]).collect()
        };
        let ours = in_front(&ours);
        let unit = nearest(&units, |unit| apart(&ours, &in_front(&scaled(unit))));
        let theirs = in_front(&scaled(unit));
        let largest = ours.iter().chain(&theirs).filter(|t| t.is_finite()).fold(0.0_f64, |most, t| most.max(t.abs()));
        let allowed = open.allowance.time(largest, 0.0, [origin, direction]);
        self.numbers(line, [event, event], ray, Subject::Inside(object.id), ours, theirs, allowed);
    }

    /// Inside intervals of an object that is one primitive.
    fn crossings(&self, object: EventId) -> Vec<[f64; 2]> {
        let Some((primitive, _)) = self.ours.primitives(object).next() else { return Vec::new() };
        let Some((_, candidates)) = self.ours.candidates(primitive.id) else { return Vec::new() };
        let mut list: Vec<[f64; 2]> = Vec::new();
        let mut inside = None;
        for candidate in candidates.iter().filter(|c| c.fate == CandidateFate::Accepted) {
            match candidate.sense {
                Sense::Enter => inside = Some(candidate.t),
                Sense::Leave => list.push([inside.take().unwrap_or(f64::NEG_INFINITY), candidate.t]),
                Sense::Touch => {}
            }
        }
        list.extend(inside.map(|from| [from, f64::INFINITY]));
        list
    }

    /// What a line says of the closest hit.
    pub(super) fn hit(&mut self, line: &Line, ray: usize, open: Open) {
        let Some(theirs) = &line.hit else { return self.place(line, ray, open) };
        if open.is_shadow {
            return;
        }
        let ours = self.ours.hit(ray);
        let nothing = || "nothing".to_owned();
        let event = ours.map(|hit| hit.event).or_else(|| self.ours.nothing(ray).map(|event| event.id));
        let Some(event) = event else { return };
        let object = ours.map_or_else(nothing, |hit| hit.object.to_owned());
        let said = theirs.clone().unwrap_or_else(nothing);
        let leaf_is_meant = ours.is_some_and(|hit| same_name(hit.leaf, &said));
        let is_same = same_name(&object, &said) || leaf_is_meant;
        let said = if leaf_is_meant { object.clone() } else { said };
        self.words(line, [event, event], ray, Subject::HitObject, object, said);
        if let (true, Some(hit)) = (is_same, ours) {
            if let Some(leaf) = &line.leaf {
                self.words(line, [event, event], ray, Subject::HitLeaf, hit.leaf.to_owned(), leaf.clone());
            }
            self.hit_numbers(line, ray, open, &hit);
        } else {
            self.time_of_other(line, ray, open, event);
        }
    }

    /// A line that says where the hit is and not what is hit.
    fn place(&mut self, line: &Line, ray: usize, open: Open) {
        let says = line.t.is_some() || line.point.is_some() || line.normal.is_some() || line.outward.is_some();
        if let Some(hit) =
            self.ours.hit(ray).filter(|_| says && line.object.is_none() && line.light.is_none() && !open.is_shadow)
        {
            self.hit_numbers(line, ray, open, &hit);
        }
    }

    fn hit_numbers(&mut self, line: &Line, ray: usize, open: Open, hit: &OurHit) {
        let our_ray = &self.ours.rays[ray];
        let (origin, direction) = (our_ray.origin, our_ray.direction);
        let event = hit.event;
        if let Some(theirs) = line.t {
            let units = units(open, direction);
            let unit = nearest(&units, |unit| (theirs * unit - hit.t).abs());
            self.learn(unit);
            let allowed = open.allowance.time(hit.t, hit.t_error, [origin, direction]);
            self.numbers(line, [event, event], ray, Subject::HitTime, vec![hit.t], vec![theirs * unit], allowed);
        }
        if let Some(theirs) = line.point {
            let allowed = open.allowance.point(hit.point, origin) + hit.t_error * direction.length();
            self.vector(line, [event, event], ray, Subject::Point, hit.point, theirs, allowed);
        }
        let allowed = open.allowance.direction();
        if let Some(theirs) = line.outward {
            self.vector(line, [event, event], ray, Subject::Outward, hit.n_geometric, theirs, allowed);
        }
        if let Some(theirs) = line.normal {
            let ours = self.shading_normal(ray, hit);
            self.vector(line, [event, event], ray, Subject::Normal, ours, theirs, allowed);
        }
    }

    /// The normal that shading uses, after bumps.
    fn shading_normal(&self, ray: usize, hit: &OurHit) -> DVec3 {
        let bumped = self.ours.of(ray).find_map(|event| match &event.what {
            What::Bump(bump) => Some(DVec3::from_array(bump.after)),
            _ => None,
        });
        bumped.map_or(hit.n_shading, |normal| if normal.dot(hit.n_shading) < 0.0 { -normal } else { normal })
    }

    /// Where another object is hit than ours, the time is what explains it.
    fn time_of_other(&mut self, line: &Line, ray: usize, open: Open, event: EventId) {
        let Some(theirs) = line.t else { return };
        let our_ray = &self.ours.rays[ray];
        let t = self.ours.hit(ray).map_or(f64::NAN, |hit| hit.t);
        let unit = open.unit.unwrap_or(1.0);
        let allowed = open.allowance.time(theirs * unit, 0.0, [our_ray.origin, our_ray.direction]);
        self.numbers(line, [event, event], ray, Subject::HitTime, vec![t], vec![theirs * unit], allowed);
    }

    /// Keeps the unit of t that fits, where no direction was printed.
    fn learn(&mut self, unit: f64) {
        if let Some(open) = self.innermost() {
            open.unit.get_or_insert(unit);
        }
    }
}

/// The units of t that are possible: that of the direction which was printed, or else ours and that of a unit direction.
fn units(open: Open, direction: DVec3) -> Vec<f64> {
    open.unit.map_or_else(|| vec![1.0, 1.0 / direction.length()], |unit| vec![unit])
}

fn nearest(units: &[f64], off: impl Fn(f64) -> f64) -> f64 {
    units.iter().copied().min_by(|a, b| off(*a).total_cmp(&off(*b))).unwrap_or(1.0)
}

/// Our times without those that may be left out and were: none of theirs is near.
fn required(ours: &[f64], theirs: &[f64], near: f64) -> Vec<f64> {
    let is_told = |t: f64| theirs.iter().any(|other| (other - t).abs() <= near);
    ours.iter().copied().filter(|&t| t > near || is_told(t)).collect()
}

fn edges(spans: &[Span]) -> Vec<f64> {
    spans.iter().flat_map(|span| [&span.enter, &span.leave]).flatten().map(|edge| edge.t).collect()
}

/// The intervals of a list, unbounded ends infinite.
pub(super) fn intervals(spans: &[Span]) -> Vec<[f64; 2]> {
    let one = |span: &Span| {
        let from = span.enter.as_ref().map_or(f64::NEG_INFINITY, |edge| edge.t);
        [from, span.leave.as_ref().map_or(f64::INFINITY, |edge| edge.t)]
    };
    spans.iter().map(one).collect()
}
