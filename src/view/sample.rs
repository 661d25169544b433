//! Things made up for tests: a tree with every kind of event once, and a drawing, with numbers that a person can check.

use super::sample_effects::{average, confusion, lens, light_on_its_way, light_sample, second_sample};
use super::sample_texture::{carried, environment};
use crate::record::{
    Candidate, CandidateFate, Certificate, Edge, Entry, Operator, PlaneRow, PlaneSense, RayKind, Recorder, Sense, Sign,
    SignSpan, Span, What,
};
use crate::trace::{RayTree, TreeRecorder};
use crate::view::{Drawing, Form, Stroke, Theme};

/// An end of an interval.
pub fn edge(t: f64, leaf: usize, name: &str, part: &str, flipped: bool) -> Edge {
    Edge { t, leaf, name: name.to_owned(), part: part.to_owned(), flipped, certificate: Certificate::Certain }
}

/// A bounded interval.
pub fn span(enter: Edge, leave: Edge) -> Span {
    Span { enter: Some(enter), leave: Some(leave) }
}

/// Describes a tree by nesting.
pub struct Sketch(TreeRecorder);

impl Sketch {
    pub fn new() -> Self {
        Self(TreeRecorder::new())
    }

    pub fn with(&mut self, what: What, below: impl FnOnce(&mut Self)) {
        self.0.begin();
        below(self);
        self.0.end(|| Entry::new(what));
    }

    pub fn note(&mut self, what: What) {
        self.with(what, |_| {});
    }

    pub fn entry(&mut self, entry: Entry, below: impl FnOnce(&mut Self)) {
        self.0.begin();
        below(self);
        self.0.end(|| entry);
    }

    pub fn finish(self) -> RayTree {
        self.0.finish()
    }
}

pub fn step(number: u8, title: &str) -> What {
    What::Step { number, title: title.to_owned() }
}

/// A ray from (0, 0, 4) towards −z meets a bowl: the sphere `outer` of radius 1 less the sphere `inner`, all of it a
/// made-up story with every kind of event in it.
pub fn every_kind() -> RayTree {
    let mut sketch = Sketch::new();
    sketch.with(What::Pixel { x: 32, y: 24, width: 64, height: 48 }, |s| {
        let built = Entry::new(step(1, "Build the rc-th ray")).line(
            "dir_rc",
            "−n + x r",
            &[("x", 0.0.into())],
            [0.0, 0.0, -1.0],
        );
        s.note(second_sample());
        s.entry(built, |s| s.note(lens()));
        s.with(step(2, "Find all intersections with objects"), search);
        s.with(step(3, "Identify the closest intersection in front of the eye"), |s| {
            s.note(What::Rejected {
                object: "bowl".into(),
                leaf: "outer".into(),
                part: "surface".into(),
                t: 3.0,
                reason: "not a boundary of the difference: it lies inside inner".into(),
            });
        });
        s.with(step(4, "Compute the hit point"), |s| {
            s.with(hit(), carried);
            s.note(confusion());
        });
        s.with(step(5, "Find the colour of the light returning along the ray"), colour);
        s.note(average());
        s.with(step(6, "Place the colour in the rc-th pixel"), |s| {
            s.note(What::Written { linear: [0.25, 0.5, 0.75], srgb: [137, 188, 225] });
        });
    });
    sketch.finish()
}

fn search(s: &mut Sketch) {
    s.with(What::Object { index: 0, name: "bowl".into(), intervals: 1 }, |s| {
        let [low, high, at] = [[100.0, 80.0], [540.0, 400.0], [320.5, 240.5]];
        s.note(What::Projection { of: "bowl".into(), low, high, at, holds: true });
        s.note(What::Extent { of: "bowl".into(), low: [-1.0; 3], high: [1.0; 3], inside: Some([3.0, 5.0]) });
        let left = vec![span(edge(3.0, 0, "outer", "surface", false), edge(5.0, 0, "outer", "surface", false))];
        let right = vec![span(edge(2.5, 1, "inner", "surface", false), edge(4.5, 1, "inner", "surface", false))];
        let combined = vec![span(edge(4.5, 1, "inner", "surface", true), edge(5.0, 0, "outer", "surface", false))];
        let operator = Operator::Difference;
        let name = "bowl".to_owned();
        s.with(What::Combine { name, operator, left, right: Some(right), combined, early_out: None }, |s| {
            s.note(What::Transform {
                of: "outer".into(),
                inverse: [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]],
                origin: [0.0, 0.0, 4.0],
                direction: [0.0, 0.0, -1.0],
            });
            s.with(What::Primitive { shape: "sphere".into(), name: "outer".into(), leaf: 0, hits: 2 }, primitive);
        });
    });
    s.with(What::Object { index: 1, name: "pin".into(), intervals: 0 }, |s| {
        let [low, high, at] = [[600.0, 20.0], [640.0, 60.0], [320.5, 240.5]];
        s.note(What::Projection { of: "pin".into(), low, high, at, holds: false });
        s.note(What::Ball { of: "lid".into(), centre: [0.0; 3], radius: 1.5, distance: 0.75, is_met: true });
        s.note(What::Ball { of: "pin".into(), centre: [2.5, 2.5, 0.5], radius: 0.5, distance: 2.0, is_met: false });
        s.note(What::Extent { of: "pin".into(), low: [2.0, 2.0, 0.0], high: [3.0, 3.0, 1.0], inside: None });
        s.note(What::Combine {
            name: "pin".into(),
            operator: Operator::Intersection,
            left: vec![],
            right: None,
            combined: vec![],
            early_out: Some("left is empty, so nothing can be inside both".into()),
        });
    });
}

fn primitive(s: &mut Sketch) {
    s.note(What::Planes { rows: plane_rows(), stopped: Some("t_in > t_out".into()) });
    s.note(What::Quadratic {
        about: "the sphere".into(),
        a: 1.0,
        b: -4.0,
        c: 15.0,
        discriminant: 1.0,
        recentred_at: 4.0,
        roots: vec![3.0, 5.0],
    });
    s.note(What::Quartic { coefficients: [-2.0, 0.0, 3.0, 0.0, 1.0], recentred_at: 4.0, roots: vec![3.0, 5.0] });
    s.note(What::Search { range: Some([2.0, 6.0]), stretches: 17, undecided: 0, roots: vec![3.0, 5.0] });
    let d = |t: f64| (t - 3.0) * (t - 5.0);
    s.note(What::Implicit {
        equation: "x² + y² + z² − 1".into(),
        samples: (0..=40).map(|i| 2.0 + f64::from(i) * 0.1).map(|t| [t, d(t)]).collect(),
        roots: vec![3.0, 5.0],
        signs: vec![
            SignSpan { from: None, to: Some(3.0), sign: Sign::Positive },
            SignSpan { from: Some(3.0), to: Some(5.0), sign: Sign::Negative },
            SignSpan { from: Some(5.0), to: None, sign: Sign::Positive },
        ],
    });
    let candidate = |t: f64, sense, fate, reason: &str| Candidate {
        t,
        part: "surface".into(),
        sense,
        point: [0.0, 0.0, 4.0 - t],
        fate,
        reason: reason.into(),
    };
    s.note(What::Roots {
        candidates: vec![
            candidate(3.0, Sense::Enter, CandidateFate::Accepted, "d changes from + to −"),
            candidate(5.0, Sense::Leave, CandidateFate::Accepted, "d changes from − to +"),
            candidate(7.0, Sense::Touch, CandidateFate::Rejected, "the ray only touches"),
        ],
    });
}

fn plane_rows() -> Vec<PlaneRow> {
    let row = |plane, name: &str, normal, numerator, denominator: f64, sense, t_in, t_out| PlaneRow {
        plane,
        name: name.into(),
        normal,
        spot: normal,
        numerator,
        denominator,
        t: (denominator != 0.0).then(|| numerator / denominator),
        sense,
        t_in,
        t_out,
    };
    vec![
        row(0, "top", [0.0, 1.0, 0.0], 1.0, 0.0, PlaneSense::ParallelInside, None, None),
        row(4, "front", [0.0, 0.0, 1.0], -3.0, -1.0, PlaneSense::Entering, Some(3.0), None),
        row(5, "back", [0.0, 0.0, -1.0], 5.0, 1.0, PlaneSense::Leaving, Some(3.0), Some(5.0)),
    ]
}

fn hit() -> What {
    What::Hit {
        object: "bowl".into(),
        leaf: "inner".into(),
        shape: "sphere".into(),
        part: "surface".into(),
        material: "glass".into(),
        t: 4.5,
        t_error: 1e-15,
        certificate: Certificate::Certain,
        sense: Sense::Enter,
        point: [0.0, 0.0, -0.5],
        generic_point: [0.0, 0.0, -1.0],
        n_geometric: [0.0, 0.0, 1.0],
        n_shading: [0.0, 0.0, 1.0],
        uv: [0.25, 0.5],
    }
}

fn colour(s: &mut Sketch) {
    s.note(What::Ambient { colour: [0.05, 0.05, 0.05] });
    let arriving = [0.25; 3];
    let light = |name: &str, arriving| What::Light {
        name: name.into(),
        towards: [0.0, 0.6, 0.8],
        distance: Some(5.0),
        arriving,
        diffuse: [0.2, 0.2, 0.2],
        specular: [0.0; 3],
    };
    s.with(light("lamp", arriving), |s| {
        s.with(ray(RayKind::Shadow, [0.0, 0.6, 0.8], 1), |s| {
            s.note(What::Shadow {
                object: "pin".into(),
                t: 2.0,
                passes: 0.25,
                reason: "transparent: 25 % pass".into(),
            });
        });
    });
    s.note(light("sun", [0.0; 3]));
    s.note(light_sample());
    s.note(What::Medium {
        object: "bowl".into(),
        before: "air".into(),
        after: "glass".into(),
        decided: "the most recently entered object".into(),
        interpenetration: false,
        hidden: false,
    });
    light_on_its_way(s);
    s.note(What::Reflection { direction: [0.0, 0.0, 1.0], share: 0.04, shares: None });
    s.note(What::Snell {
        n1: 1.0,
        n2: 1.5,
        theta1: 30.0,
        theta2: Some(19.471_220_634_490_69),
        critical: None,
        total_internal_reflection: false,
        refracted: Some([0.0, 0.0, -1.0]),
        reflectance: 0.04,
    });
    s.with(ray(RayKind::Reflected, [0.0, 0.0, 1.0], 1), |s| {
        s.note(What::Environment(environment()));
        s.note(What::Nothing { background: [0.1, 0.2, 0.3] });
    });
    s.with(ray(RayKind::Scattered, [0.0, 0.6, 0.8], 1), |s| {
        s.note(What::Nothing { background: [0.1, 0.2, 0.3] });
    });
    s.with(ray(RayKind::Refracted, [0.0, -0.1, -1.0], 1), |s| {
        s.note(What::Nothing { background: [0.1, 0.2, 0.3] });
        s.note(What::Limit {
            limit: "depth".into(),
            at: 1.0,
            value: 2.0,
            consequence: "the reflected ray is not sent".into(),
        });
    });
    s.note(What::Colour {
        ambient: [0.05; 3],
        diffuse: [0.2; 3],
        specular: [0.0; 3],
        reflected: [0.0, 0.1, 0.2],
        transmitted: [0.0, 0.15, 0.3],
        total: [0.25, 0.5, 0.75],
    });
}

fn ray(kind: RayKind, direction: [f64; 3], depth: u32) -> What {
    What::Ray {
        ray: kind,
        origin: [0.0, 0.0, -0.5],
        direction,
        depth,
        medium: "air".into(),
        weight: 0.5,
        wavelength: None,
        left: Some("surface of inner".into()),
    }
}

/// An area with a hole, for event 1, and a line across it, for event 2.
pub fn two_marks() -> Drawing {
    let palette = Theme::Light.palette();
    let mut drawing = Drawing::new([100.0, 80.0], palette.ground);
    let square = |low: f64, high: f64| vec![[low, low], [high, low], [high, high], [low, high]];
    drawing.put(Form::Area { rings: vec![square(10.0, 60.0), square(30.0, 40.0)], fill: palette.left }, 1);
    drawing.put(Form::Line { points: vec![[0.0, 20.0], [100.0, 20.0]], stroke: Stroke::solid(palette.ink, 1.0) }, 2);
    drawing
}
