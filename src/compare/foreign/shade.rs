//! Lines about light: what the lights do, where mirrored and refracted rays go, and the colour.

use super::check::{Subject, Term};
use super::line::{Line, RayWord};
use super::walk::{Open, Walk, same_name};
use crate::record::{Event, EventId, RayKind, What};
use glam::DVec3;

impl Walk<'_, '_> {
    /// What a line says of a light.
    pub(super) fn light(&mut self, line: &Line, ray: usize, open: Open) {
        let Some(name) = &line.light else { return };
        let found = self.ours.of(ray).find_map(|event| match &event.what {
            What::Light { name: ours, towards, arriving, diffuse, specular, .. } if same_name(ours, name) => {
                Some((event.id, *towards, *arriving, *diffuse, *specular))
            }
            _ => None,
        });
        let Some((event, towards, arriving, diffuse, specular)) = found else {
            if !self.ours.scene.lights.iter().any(|light| same_name(&light.name, name)) {
                self.note(format!("line {}: the scene has no light `{name}`", line.number));
            }
            return;
        };
        if let Some(theirs) = line.towards {
            let allowed = open.allowance.direction();
            self.vector(line, [event, event], ray, Subject::Towards(event), towards.into(), theirs, allowed);
        }
        self.shadow(line, ray, event, arriving != [0.0; 3]);
        if line.colour.is_none() {
            let after = self.ours.tree.subtree_end(event).saturating_sub(1);
            for (theirs, ours, subject) in
                [(line.diffuse, diffuse, Subject::Diffuse(event)), (line.specular, specular, Subject::Specular(event))]
            {
                if let Some(theirs) = theirs {
                    let allowed = open.allowance.colour(ours.into());
                    self.vector(line, [event, after], ray, subject, ours.into(), theirs, allowed);
                }
            }
        }
    }

    /// Whether light arrives; said only where a shadow ray was sent, for behind the surface nobody need ask.
    fn shadow(&mut self, line: &Line, ray: usize, light: EventId, arrives: bool) {
        let sent = self.ours.rays.iter().find(|sent| {
            sent.parent == Some(ray)
                && sent.kind == RayKind::Shadow
                && self.ours.tree.event(sent.event).parent == Some(light)
        });
        let Some(sent) = sent else { return };
        // Whatever was found out on the way comes before what follows from it.
        let places = [sent.event, self.ours.tree.subtree_end(sent.event).saturating_sub(1)];
        if let Some(lit) = line.lit {
            let word = |lit: bool| if lit { "light arrives" } else { "no light arrives" }.to_owned();
            self.words(line, places, ray, Subject::Lit(light), word(arrives), word(lit));
        }
        if let Some(theirs) = &line.blocked_by {
            let below = self.ours.below(sent.event);
            let blocking = below.iter().find_map(|event| match &event.what {
                What::Shadow { object, passes, .. } if *passes == 0.0 => Some(object.clone()),
                _ => None,
            });
            let ours = blocking.unwrap_or_else(|| "nothing".to_owned());
            // Ours stops at the first object of the list that is in the way; others may as well be.
            if ours == "nothing" {
                self.words(line, places, ray, Subject::BlockedBy(light), ours, theirs.clone());
            }
        }
    }

    /// What a line says of mirrored and refracted light.
    pub(super) fn bend(&mut self, line: &Line, ray: usize, open: Open) {
        let is_begin = line.ray.is_some_and(|word| word != RayWord::Camera);
        if let Some(theirs) = line.reflected.filter(|_| !is_begin) {
            let found = self.ours.of(ray).find_map(|event| match &event.what {
                What::Reflection { direction, .. } => Some((event.id, *direction)),
                _ => None,
            });
            if let Some((event, ours)) = found {
                let allowed = open.allowance.direction();
                self.vector(line, [event, event], ray, Subject::Reflected, ours.into(), theirs, allowed);
            }
        }
        let snell = self.ours.of(ray).find_map(snell);
        if let Some((event, n1, n2, refracted)) = snell.filter(|_| !is_begin) {
            if line.n1.is_some() || line.n2.is_some() {
                let theirs = vec![line.n1.unwrap_or(n1), line.n2.unwrap_or(n2)];
                let allowed = open.allowance.vector(n1.max(n2));
                self.numbers(line, [event, event], ray, Subject::Indices, vec![n1, n2], theirs, allowed);
            }
            match (line.refracted, refracted) {
                (Some(Some(theirs)), Some(ours)) => {
                    let allowed = open.allowance.direction();
                    self.vector(line, [event, event], ray, Subject::Refracted, ours, theirs, allowed);
                }
                (Some(Some(theirs)), None) => {
                    let ours = vec![f64::NAN; 3];
                    let allowed = open.allowance.direction();
                    self.numbers(line, [event, event], ray, Subject::Refracted, ours, theirs.to_vec(), allowed);
                }
                (Some(None), Some(ours)) => {
                    let theirs = vec![f64::NAN; 3];
                    self.numbers(line, [event, event], ray, Subject::Refracted, ours.to_array().to_vec(), theirs, 0.0);
                }
                _ => {}
            }
        }
    }

    /// What a line says of the colour that comes back, and of the pixel.
    pub(super) fn colour(&mut self, line: &Line, ray: usize, open: Open) {
        if let Some(theirs) = line.colour {
            let told = self.ours.of(ray).filter_map(told_colour).last();
            if let Some((event, total, terms)) = told {
                let theirs_of = [line.ambient, line.diffuse, line.specular, line.mirrored, line.transmitted];
                let all = [Term::Ambient, Term::Diffuse, Term::Specular, Term::Mirrored, Term::Transmitted];
                for ((ours, theirs), term) in std::iter::zip(terms.unwrap_or_default(), theirs_of).zip(all) {
                    if let Some(theirs) = theirs.filter(|_| terms.is_some()) {
                        let allowed = open.allowance.colour(ours);
                        self.vector(line, [event, event], ray, Subject::Term(term), ours, theirs, allowed);
                    }
                }
                let allowed = open.allowance.colour(total);
                self.vector(line, [event, event], ray, Subject::Colour, total, theirs, allowed);
            }
        }
        if let Some(theirs) = line.written {
            self.written(line, theirs);
        }
    }

    fn written(&mut self, line: &Line, theirs: [u8; 3]) {
        let written = self.ours.tree.events.iter().rev().find_map(|event| match event.what {
            What::Written { srgb, .. } => Some((event.id, srgb)),
            _ => None,
        });
        let Some((event, ours)) = written else { return };
        let [ours, theirs] = [ours, theirs].map(|bytes| bytes.map(f64::from).to_vec());
        // A byte is rounded, or cut off.
        self.numbers(line, [event, event], 0, Subject::Written, ours, theirs, 1.0);
    }
}

fn snell(event: &Event) -> Option<(EventId, f64, f64, Option<DVec3>)> {
    match &event.what {
        What::Snell { n1, n2, refracted, .. } => Some((event.id, *n1, *n2, refracted.map(DVec3::from_array))),
        _ => None,
    }
}

/// The colour that a ray brings back, with its five terms where it hit something.
fn told_colour(event: &Event) -> Option<(EventId, DVec3, Option<[DVec3; 5]>)> {
    match &event.what {
        What::Colour { ambient, diffuse, specular, reflected, transmitted, total } => {
            let terms = [ambient, diffuse, specular, reflected, transmitted].map(|term| DVec3::from_array(*term));
            Some((event.id, (*total).into(), Some(terms)))
        }
        What::Nothing { background } => Some((event.id, (*background).into(), None)),
        What::Passage(passage) => Some((event.id, passage.colour.into(), None)),
        _ => None,
    }
}
