// A small ray tracer that prints what it does, for `rayscope compare`. Node's standard library only.
//
//     node tracer.js 235,285 525,225 > mine.jsonl
//     rayscope compare mine.jsonl compare/still_life
"use strict";
const fs = require("fs");
const path = require("path");

const EPSILON = 1e-6; // hits up to here are the surface that the ray starts on

const add = (a, b) => a.map((x, i) => x + b[i]);
const sub = (a, b) => a.map((x, i) => x - b[i]);
const mul = (a, b) => a.map((x, i) => x * b[i]);
const scale = (a, s) => a.map((x) => x * s);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const unit = (a) => scale(a, 1 / Math.sqrt(dot(a, a)));
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const reflect = (d, n) => sub(d, scale(n, 2 * dot(d, n)));
const say = (line) => console.log(JSON.stringify(line));

// Affine maps: three rows of a matrix, and a translation.
const linear = (m, v) => m.rows.map((row) => dot(row, v));
const point = (m, p) => add(linear(m, p), m.move);
const transposed = (m, v) => [0, 1, 2].map((j) => m.rows[0][j] * v[0] + m.rows[1][j] * v[1] + m.rows[2][j] * v[2]);
const IDENTITY = { rows: [[1, 0, 0], [0, 1, 0], [0, 0, 1]], move: [0, 0, 0] };

function after(outer, inner) {
  const columns = [0, 1, 2].map((j) => inner.rows.map((row) => row[j]));
  return { rows: outer.rows.map((row) => columns.map((column) => dot(row, column))), move: point(outer, inner.move) };
}

function inverse(m) {
  const [a, b, c] = m.rows;
  const rows = [cross(b, c), cross(c, a), cross(a, b)];
  const determinant = dot(a, rows[0]);
  const inv = { rows: [0, 1, 2].map((i) => [0, 1, 2].map((j) => rows[j][i] / determinant)), move: [0, 0, 0] };
  inv.move = scale(linear(inv, m.move), -1);
  return inv;
}

function stepMap(step) {
  if ("scale" in step) {
    const [x, y, z] = Array.isArray(step.scale) ? step.scale : [step.scale, step.scale, step.scale];
    return { rows: [[x, 0, 0], [0, y, 0], [0, 0, z]], move: [0, 0, 0] };
  }
  if ("translate" in step) return { rows: IDENTITY.rows, move: step.translate };
  const [x, y, z] = unit(step.rotate.axis);
  const angle = (step.rotate.degrees * Math.PI) / 180;
  const c = Math.cos(angle), s = Math.sin(angle), k = 1 - c;
  return {
    rows: [
      [c + x * x * k, x * y * k - z * s, x * z * k + y * s],
      [y * x * k + z * s, c + y * y * k, y * z * k - x * s],
      [z * x * k - y * s, z * y * k + x * s, c + z * z * k],
    ],
    move: [0, 0, 0],
  };
}

/** A leaf, or { operator, left, right }. */
function build(data, outer, inherited, name) {
  const matrix = (data.transform || []).reduceRight((map, step) => after(map, stepMap(step)), outer);
  const material = data.material || inherited;
  if (!data.of) return { shape: data.shape, name, material, inverse: inverse(matrix) };
  const parts = data.of.map((part) => build(part, matrix, material, part.name));
  return parts.reduce((left, right) => ({ operator: data.shape, left, right }));
}

// Crossings of a line S + c t with generic shapes: { t, n }, in order.
function quadratic(a, b, c) {
  const d = b * b - a * c;
  return d > 0 && a > 0 ? [(-b - Math.sqrt(d)) / a, (-b + Math.sqrt(d)) / a] : [];
}

const SHAPES = {
  sphere: (s, c) =>
    quadratic(dot(c, c), dot(s, c), dot(s, s) - 1).map((t) => ({ t, n: add(s, scale(c, t)) })),
  plane: (s, c) => (c[2] === 0 ? [] : [{ t: -s[2] / c[2], n: [0, 0, 1] }]),
  cylinder: (s, c) => {
    const found = [];
    for (const t of quadratic(c[0] ** 2 + c[1] ** 2, s[0] * c[0] + s[1] * c[1], s[0] ** 2 + s[1] ** 2 - 1)) {
      const p = add(s, scale(c, t));
      if (p[2] >= 0 && p[2] <= 1) found.push({ t, n: [p[0], p[1], 0] });
    }
    for (const z of [0, 1]) {
      const t = (z - s[2]) / c[2];
      const p = add(s, scale(c, t));
      if (p[0] ** 2 + p[1] ** 2 <= 1) found.push({ t, n: [0, 0, 2 * z - 1] });
    }
    return found.sort((a, b) => a.t - b.t);
  },
  cube: (s, c) => {
    let enter = { t: -Infinity }, leave = { t: Infinity };
    for (let axis = 0; axis < 3; axis++) {
      for (const side of [-1, 1]) {
        const n = [0, 0, 0];
        n[axis] = side;
        if (c[axis] === 0 && Math.abs(s[axis]) > 1) return [];
        const t = (side - s[axis]) / c[axis];
        if (side * c[axis] < 0 && t > enter.t) enter = { t, n };
        if (side * c[axis] > 0 && t < leave.t) leave = { t, n };
      }
    }
    return enter.t < leave.t ? [enter, leave] : [];
  },
};

/** All { t, n, leaf, turned } of a solid along a ray. */
function boundaries(tree, object, o, d) {
  if (tree.shape) {
    const s = point(tree.inverse, o), c = linear(tree.inverse, d);
    const hits = SHAPES[tree.shape](s, c);
    say({ object, leaf: tree.name, generic_origin: s, generic_direction: c, hits: hits.map((hit) => hit.t) });
    return hits.map((hit) => ({ ...hit, leaf: tree, turned: false }));
  }
  const turns = tree.operator === "difference";
  const left = boundaries(tree.left, object, o, d).map((hit) => ({ hit, side: 0 }));
  const right = boundaries(tree.right, object, o, d).map((hit) => ({
    hit: { ...hit, turned: hit.turned !== turns },
    side: 1,
  }));
  const inside = [false, false];
  let was = false;
  return [...left, ...right].sort((a, b) => a.hit.t - b.hit.t).filter(({ side }) => {
    inside[side] = !inside[side];
    const [a, b] = inside;
    const now = { union: a || b, intersection: a && b, difference: a && !b }[tree.operator];
    const changes = now !== was;
    was = now;
    return changes;
  }).map(({ hit }) => hit);
}

const scene = JSON.parse(fs.readFileSync(path.join(__dirname, "still_life.json"), "utf8"));
const objects = scene.objects.map((o) => ({ name: o.name, tree: build(o, IDENTITY, o.material, o.name) }));

function pixel(x, y) {
  say({ pixel: [x, y] });
  const { eye, look_at, up, field_of_view } = scene.camera;
  const { width, height } = scene.image;
  const forward = unit(sub(look_at, eye));
  const right = unit(cross(forward, up));
  const above = cross(right, forward);
  const h = Math.tan((field_of_view * Math.PI) / 360);
  const a = ((2 * (x + 0.5)) / width - 1) * h * (width / height);
  const b = (1 - (2 * (y + 0.5)) / height) * h;
  trace("camera", eye, add(forward, add(scale(right, a), scale(above, b))), 0);
}

function trace(kind, o, d, depth) {
  say({ ray: kind, origin: o, direction: d });
  let best = null;
  for (const object of objects) {
    for (const hit of boundaries(object.tree, object.name, o, d)) {
      if (hit.t > EPSILON && (!best || hit.t < best.hit.t)) best = { object, hit };
    }
  }
  if (!best) say({ hit: null });
  const colour = best ? shade(best.object, best.hit, o, d, depth) : scene.background;
  say({ colour });
  return colour;
}

function shade(object, { t, n: generic, leaf, turned }, o, d, depth) {
  const p = add(o, scale(d, t));
  const outward = scale(unit(transposed(leaf.inverse, generic)), turned ? -1 : 1);
  const n = dot(outward, d) > 0 ? scale(outward, -1) : outward;
  say({ hit: object.name, leaf: leaf.name, t, point: p, outward, normal: n });
  const m = { specular: [0, 0, 0], exponent: 1, reflectivity: 0, transparency: 0, ...scene.materials[leaf.material] };
  const v = unit(scale(d, -1));
  let colour = mul(m.ambient, scene.ambient);
  for (const light of scene.lights) {
    const toLight = light.point ? sub(light.point, p) : unit(light.directional);
    const l = unit(toLight);
    const lit = dot(n, l) > 0 ? arriving(light, p, toLight) : 0;
    const light_here = scale(light.colour, lit);
    const diffuse = scale(mul(light_here, m.diffuse), Math.max(0, dot(n, l)));
    const shine = Math.max(0, dot(reflect(scale(l, -1), n), v)) ** m.exponent;
    const specular = scale(mul(light_here, m.specular), shine);
    say({ light: light.name, towards: l, diffuse, specular });
    colour = add(colour, add(diffuse, specular));
  }
  if (depth === scene.limits.depth || !(m.reflectivity || m.transparency)) return colour;
  const refracted = m.transparency ? refract(outward, n, d, m.index_of_refraction) : null;
  const mirrors = m.reflectivity + (m.transparency && !refracted ? m.transparency : 0);
  if (mirrors) colour = add(colour, scale(trace("reflected", p, reflect(d, n), depth + 1), mirrors));
  if (refracted) colour = add(colour, scale(trace("refracted", p, refracted, depth + 1), m.transparency));
  return colour;
}

function refract(outward, n, direction, index) {
  const [n1, n2] = dot(outward, direction) < 0 ? [1, index] : [index, 1];
  const d = unit(direction), eta = n1 / n2, cosine = -dot(d, n);
  const w = 1 - eta * eta * (1 - cosine * cosine);
  const refracted = w >= 0 ? unit(add(scale(d, eta), scale(n, eta * cosine - Math.sqrt(w)))) : null;
  say({ refracted, n1, n2 });
  return refracted;
}

/** The share of a light that comes to p: every surface in the way passes its transparency. */
function arriving(light, p, toLight) {
  say({ ray: "shadow", light: light.name, origin: p, direction: toLight });
  const end = light.point ? 1 : Infinity;
  let share = 1;
  for (const object of objects) {
    for (const { t, leaf } of boundaries(object.tree, object.name, p, toLight)) {
      if (t > EPSILON && t < end) share *= scene.materials[leaf.material].transparency || 0;
    }
  }
  say({ light: light.name, lit: share > 0 });
  return share;
}

const pixels = process.argv.length > 2 ? process.argv.slice(2) : ["235,285"];
for (const argument of pixels) pixel(...argument.split(",").map(Number));
