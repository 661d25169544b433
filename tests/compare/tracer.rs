//! A small ray tracer of its own, as a student would write it, that prints what it does and has a switch for each mistake.

use super::scene::{Light, Object, Scene, vector};
use super::shapes::{Crossing, boundaries, crossings, generic};
use super::{Bug, Prints};
use glam::DVec3;
use serde_json::{Value, json};

/// Hits up to here are the surface that the ray starts on.
const EPSILON: f64 = 1e-6;

pub struct Tracer<'a> {
    scene: &'a Scene,
    prints: Prints,
    lines: Vec<Value>,
}

struct Hit<'a> {
    object: &'a Object,
    crossing: Crossing,
    point: DVec3,
    outward: DVec3,
    normal: DVec3,
}

/// The lines that the sample prints of some pixels.
pub fn print(scene: &Scene, pixels: &[[u32; 2]], prints: Prints) -> String {
    let mut tracer = Tracer { scene, prints, lines: Vec::new() };
    for &pixel in pixels {
        tracer.pixel(pixel);
    }
    let lines: Vec<String> = tracer.lines.iter().map(ToString::to_string).collect();
    lines.join("\n") + "\n"
}

fn list(v: DVec3) -> Value {
    json!(v.to_array())
}

fn reflect(d: DVec3, n: DVec3) -> DVec3 {
    d - 2.0 * d.dot(n) * n
}

impl<'a> Tracer<'a> {
    fn say(&mut self, level: Prints, line: Value) {
        if self.prints >= level {
            self.lines.push(line);
        }
    }

    fn has(&self, bug: Bug) -> bool {
        self.scene.bug == bug
    }

    fn pixel(&mut self, [x, y]: [u32; 2]) {
        self.say(Prints::Colours, json!({ "pixel": [x, y] }));
        let camera = &self.scene.value["camera"];
        let (eye, at) = (vector(&camera["eye"]), vector(&camera["look_at"]));
        let forward = (at - eye).normalize();
        let right = forward.cross(vector(&camera["up"])).normalize();
        let up = right.cross(forward);
        let angle = camera["field_of_view"].as_f64().unwrap().to_radians();
        let h = if self.has(Bug::FieldOfView) { angle.tan() } else { (angle / 2.0).tan() };
        let [width, height] = self.scene.size;
        let half = if self.has(Bug::PixelCorner) { 0.0 } else { 0.5 };
        let (px, mut py) = (f64::from(x) + half, f64::from(y) + half);
        if self.has(Bug::UpsideDown) {
            py = height - py;
        }
        let ratio = if self.has(Bug::Aspect) { 1.0 } else { width / height };
        let a = (2.0 * px / width - 1.0) * h * ratio;
        let b = (1.0 - 2.0 * py / height) * h;
        let direction = forward + right * a + up * b;
        let direction = if self.prints == Prints::Everything { direction } else { direction.normalize() };
        self.trace("camera", eye, direction, 0);
    }

    fn trace(&mut self, kind: &str, origin: DVec3, direction: DVec3, depth: u32) -> DVec3 {
        self.say(Prints::Hits, json!({ "ray": kind, "origin": list(origin), "direction": list(direction) }));
        let hit = self.closest(origin, direction);
        let colour = match &hit {
            None => {
                self.say(Prints::Hits, json!({ "hit": null }));
                self.scene.background
            }
            Some(hit) => self.shade(hit, direction, depth),
        };
        let colour = if self.has(Bug::Gamma) { colour.powf(1.0 / 2.2) } else { colour };
        let level = if kind == "camera" { Prints::Colours } else { Prints::Hits };
        self.say(level, json!({ "colour": list(colour) }));
        colour
    }

    fn all(&mut self, object: &Object, origin: DVec3, direction: DVec3) -> Vec<Crossing> {
        let bug = self.scene.bug;
        let of_leaf = |number: usize| {
            let leaf = &object.leaves[number];
            let [s, c] = generic(leaf, origin, direction, bug);
            crossings(leaf, number, s, c, bug)
        };
        for (number, leaf) in object.leaves.iter().enumerate() {
            let [s, c] = generic(leaf, origin, direction, bug);
            let hits: Vec<f64> = of_leaf(number).iter().map(|crossing| crossing.t).collect();
            self.say(
                Prints::Everything,
                json!({ "object": object.name, "leaf": leaf.name, "generic_origin": list(s), "generic_direction": list(c), "hits": hits }),
            );
        }
        boundaries(object, &of_leaf, bug)
    }

    fn closest(&mut self, origin: DVec3, direction: DVec3) -> Option<Hit<'a>> {
        let scene = self.scene;
        let mut best: Option<(&Object, Crossing)> = None;
        for object in &scene.objects {
            let found = self.all(object, origin, direction);
            let least = match scene.bug {
                Bug::NegativeT => f64::NEG_INFINITY,
                Bug::SelfHit => 0.0,
                _ => EPSILON,
            };
            let mut ahead = found.into_iter().filter(|crossing| crossing.t > least);
            let first = if self.has(Bug::FarRoot) { ahead.next_back() } else { ahead.next() };
            if let Some(first) = first.filter(|first| best.is_none_or(|(_, best)| first.t < best.t)) {
                best = Some((object, first));
            }
        }
        best.map(|(object, crossing)| self.hit(object, crossing, origin, direction))
    }

    fn hit(&mut self, object: &'a Object, crossing: Crossing, origin: DVec3, direction: DVec3) -> Hit<'a> {
        let leaf = &object.leaves[crossing.leaf];
        let point = origin + direction * crossing.t;
        let (matrix, inverse) = (leaf.matrix.matrix3, leaf.inverse.matrix3);
        let outward = match self.scene.bug {
            Bug::NormalByMatrix => matrix * crossing.normal,
            Bug::NormalGeneric => crossing.normal,
            _ => inverse.transpose() * crossing.normal,
        };
        let outward = if self.has(Bug::NormalNotUnit) { outward } else { outward.normalize() };
        let outward = if crossing.turned { -outward } else { outward };
        let is_away = outward.dot(direction) > 0.0 && !self.has(Bug::NormalNotFlipped);
        let normal = if is_away { -outward } else { outward };
        self.say(
            Prints::Hits,
            json!({ "hit": object.name, "leaf": leaf.name, "t": crossing.t, "point": list(point), "outward": list(outward), "normal": list(normal) }),
        );
        Hit { object, crossing, point, outward, normal }
    }

    fn shade(&mut self, hit: &Hit, direction: DVec3, depth: u32) -> DVec3 {
        let scene = self.scene;
        let material = scene.material(&hit.object.leaves[hit.crossing.leaf].material);
        let mut colour = material.ambient * scene.ambient;
        let (n, v) = (hit.normal, -direction.normalize());
        for light in &scene.lights {
            let to_light = light.point.map_or(light.towards, |point| point - hit.point);
            let l = if self.has(Bug::LightNotNormalised) { to_light } else { to_light.normalize() };
            let cosine = n.dot(l);
            let share = if cosine > 0.0 { self.arriving(light, hit.point, to_light) } else { 0.0 };
            let arriving = light.colour * share;
            let diffuse = arriving * material.diffuse * cosine.max(0.0);
            let exponent = if self.has(Bug::Exponent) { material.exponent / 2.0 } else { material.exponent };
            let shine = match scene.bug {
                Bug::HalfAngle => n.dot((l + v).normalize()),
                Bug::HighlightSign => -reflect(-l, n).dot(v),
                _ => reflect(-l, n).dot(v),
            };
            let specular = arriving * material.specular * shine.max(0.0).powf(exponent);
            self.say(
                Prints::Everything,
                json!({ "light": light.name, "towards": list(l), "diffuse": list(diffuse), "specular": list(specular) }),
            );
            colour += diffuse + specular;
        }
        colour + self.spawned(hit, direction, depth)
    }

    fn spawned(&mut self, hit: &Hit, direction: DVec3, depth: u32) -> DVec3 {
        let material = self.scene.material(&hit.object.material);
        if (material.reflectivity == 0.0 && material.transparency == 0.0) || depth == self.scene.depth {
            return DVec3::ZERO;
        }
        let refracted = if material.transparency > 0.0 { self.refract(hit, direction, material.index) } else { None };
        let is_total = material.transparency > 0.0 && refracted.is_none();
        let share = material.reflectivity + if is_total { material.transparency } else { 0.0 };
        let mut colour = DVec3::ZERO;
        if share > 0.0 {
            let mirrored = reflect(direction, hit.normal);
            let mirrored = if self.has(Bug::ReflectedSign) { -mirrored } else { mirrored };
            let back = self.trace("reflected", hit.point, mirrored, depth + 1);
            colour += if self.has(Bug::Unweighted) { back } else { back * share };
        }
        if let Some(refracted) = refracted {
            colour += self.trace("refracted", hit.point, refracted, depth + 1) * material.transparency;
        }
        colour
    }

    fn refract(&mut self, hit: &Hit, direction: DVec3, index: f64) -> Option<DVec3> {
        let is_entering = hit.outward.dot(direction) < 0.0 || self.has(Bug::IndicesOfEntering);
        let (mut n1, mut n2) = if is_entering { (1.0, index) } else { (index, 1.0) };
        if self.has(Bug::IndicesSwapped) {
            (n1, n2) = (n2, n1);
        }
        let (d, n) = (direction.normalize(), hit.normal);
        let (eta, cosine) = (n1 / n2, -d.dot(n));
        let w = 1.0 - eta * eta * (1.0 - cosine * cosine);
        let w = if self.has(Bug::TotalReflectionIgnored) { w.max(0.0) } else { w };
        let sign = if self.has(Bug::SnellSign) { 1.0 } else { -1.0 };
        let refracted = (w >= 0.0).then(|| (eta * d + (eta * cosine + sign * w.sqrt()) * n).normalize());
        self.say(Prints::Everything, json!({ "refracted": refracted.map(|r| r.to_array()), "n1": n1, "n2": n2 }));
        refracted
    }

    /// The share of a light that arrives.
    fn arriving(&mut self, light: &Light, point: DVec3, to_light: DVec3) -> f64 {
        let scene = self.scene;
        if self.has(Bug::ShadowIgnored) {
            return 1.0;
        }
        let limit = if light.point.is_some() && !self.has(Bug::BeyondLight) { 1.0 } else { f64::INFINITY };
        let least = if self.has(Bug::ShadowAcne) { -1e-9 } else { EPSILON };
        let mut share = 1.0;
        let mut blocker: Option<(&str, f64)> = None;
        self.say(
            Prints::Everything,
            json!({ "ray": "shadow", "light": light.name, "origin": list(point), "direction": list(to_light) }),
        );
        for object in &scene.objects {
            for crossing in self.all(object, point, to_light) {
                if crossing.t > least && crossing.t < limit {
                    let passes = scene.material(&object.material).transparency;
                    share *= passes;
                    if passes == 0.0 && blocker.is_none() {
                        blocker = Some((&object.name, crossing.t));
                    }
                }
            }
        }
        let mut line = json!({ "light": light.name, "lit": share > 0.0 });
        if let Some((name, t)) = blocker {
            line["blocked_by"] = json!(name);
            line["t"] = json!(t);
        }
        self.say(Prints::Everything, line);
        share
    }
}
