#!/usr/bin/env python3
"""Write the peer scenes twice from one description: POV-Ray 3.7 SDL (.pov) and JSON (.json).

    python3 gen_scenes.py [OUT_DIR]        (default: the folder of this file)

Only the standard library is used, the random numbers have a fixed seed, and every number appears with its full
double precision in both files, so the two files say the same scene.

JSON format ("peer-scene/1")
  image       {width, height}: one sample at the centre of each pixel unless "dof" is given
  camera      pinhole; the ray through pixel (i, j), i from the left and j from the TOP, starts at `location` and has
              direction  direction + ((i+.5)/width - .5) * right + (.5 - (j+.5)/height) * up   (not unit length).
              `right` = horizontal view width and `up` = view height at distance 1. The basis is right-handed
              (right x up points back to the viewer), but nothing depends on that.
  max_depth   number of levels: 1 = primary rays only. adc_bailout: a ray whose weight is below it is not traced
  background  rgb of a ray that hits nothing
  lights      point lights, no fall-off, casting shadows
  objects     {shape, ..., material, matrix?}. `matrix`: 3 rows of 4, column vectors: p_world = M[:, :3] p + M[:, 3]
    sphere          center, radius
    box             min, max                        (axis-parallel, closed solid)
    cylinder        base, cap, radius               (solid, with end discs)
    cone            base, base_radius, cap, cap_radius   (solid tapered cylinder with end discs; radius 0 = apex)
    torus           major, minor                    (axis: y)
    superellipsoid  e, n : (|x|^(2/e) + |y|^(2/e))^(e/n) + |z|^(2/n) = 1
    plane           normal (unit), distance: dot(p, normal) = distance; the solid is the half-space below it
    union | intersection | difference      children (first minus all the others for a difference)
  dof         {aperture, focal_point, samples}: POV-Ray's meaning: `aperture` is four times the lens's radius, and the plane of
              focus goes through `focal_point`, perpendicular to the view direction
  materials   {pigment, ambient, diffuse, phong, phong_size, reflection, transmit?, ior?}
              colour = pigment*(1-transmit)*(ambient + sum_lights diffuse*max(0,N.L)*light) + sum phong*max(0,R.L)^phong_size*light
                       + reflection * reflected ray + transmit * refracted ray (Snell; total reflection replaces it)
              colours are linear light. The PNG is encoded with the sRGB curve.
    pigment         {type: solid, rgb}
"""
import json
import math
import random
import sys
from pathlib import Path

# ------------------------------------------------------------------ small vector/matrix helpers

def sub(a, b): return [x - y for x, y in zip(a, b)]
def add(a, b): return [x + y for x, y in zip(a, b)]
def mul(a, s): return [x * s for x in a]
def cross(a, b): return [a[1]*b[2]-a[2]*b[1], a[2]*b[0]-a[0]*b[2], a[0]*b[1]-a[1]*b[0]]
def unit(a):
    n = math.sqrt(sum(x * x for x in a))
    return [x / n for x in a]


def rot(axis, degrees):
    """3x3 rotation matrix about a unit axis (column-vector convention)."""
    x, y, z = unit(axis)
    a = math.radians(degrees)
    c, s = math.cos(a), math.sin(a)
    t = 1 - c
    return [[t*x*x+c, t*x*y-s*z, t*x*z+s*y],
            [t*x*y+s*z, t*y*y+c, t*y*z-s*x],
            [t*x*z-s*y, t*y*z+s*x, t*z*z+c]]


def affine(rotation=None, scale=(1, 1, 1), translate=(0, 0, 0)):
    """scale, then rotate, then translate; 3x4, column vectors."""
    r = rotation or [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
    return [[r[i][j] * scale[j] for j in range(3)] + [float(translate[i])] for i in range(3)]


def random_rotation(rng):
    while True:
        v = [rng.uniform(-1, 1) for _ in range(3)]
        if 0.01 < sum(x * x for x in v) < 1:
            return rot(v, rng.uniform(0, 360))


def camera(location, look_at, hfov, width=640, height=480, up=(0, 1, 0)):
    d = unit(sub(look_at, location))
    r = unit(cross(d, up))
    u = cross(r, d)
    w = 2 * math.tan(math.radians(hfov) / 2)
    return {"type": "perspective", "location": list(map(float, location)), "direction": d,
            "right": mul(r, w), "up": mul(u, w * height / width),
            "note": f"look_at {list(look_at)}, horizontal field of view {hfov} degrees"}


def hue(i, n):
    """Evenly spread, mid-bright colours."""
    h = (i % n) / n * 2 * math.pi
    return [round(0.55 + 0.4 * math.cos(h + k * 2 * math.pi / 3), 3) for k in range(3)]


def solid(rgb, **kw):
    m = {"pigment": {"type": "solid", "rgb": list(rgb)}, "ambient": 0.1, "diffuse": 0.65, "phong": 0.5,
         "phong_size": 40, "reflection": 0.0}
    m.update(kw)
    return m


def scene(name, about, cam, objects, materials, max_depth=5, lights=None, background=(0.2, 0.3, 0.5),
          width=640, height=480, **extra):
    s = {"format": "peer-scene/1", "name": name, "about": about, "image": {"width": width, "height": height},
         "camera": cam, "max_depth": max_depth, "adc_bailout": 1 / 255, "background": list(background),
         "lights": lights or [{"type": "point", "position": [20.0, 30.0, -25.0], "rgb": [1.0, 1.0, 1.0]}],
         "materials": materials, "objects": objects}
    s.update(extra)
    return s

# ------------------------------------------------------------------ the scenes

PALETTE = 8

def palette(**kw):
    return {f"m{i}": solid(hue(i, PALETTE), **kw) for i in range(PALETTE)}


def sphere_grid(nx, ny, nz, extent=9.0, fill=0.8):
    """nx*ny*nz spheres filling a cube of side `extent`; radius = fill/2 of the smallest spacing."""
    step = [extent / n for n in (nx, ny, nz)]
    radius = fill / 2 * min(step)
    out = []
    for i in range(nx):
        for j in range(ny):
            for k in range(nz):
                c = [(a + 0.5) * s - extent / 2 for a, s in zip((i, j, k), step)]
                out.append({"shape": "sphere", "center": c, "radius": radius,
                            "material": f"m{(i + 2 * j + 3 * k) % PALETTE}"})
    return out


GRID_CAMERA = camera((11, 8, -15), (0, 0, 0), 40)


def spheres():
    return scene("a_spheres", "10x10x10 shiny spheres, reflection 0.3, one shadowing light, 5 levels",
                 GRID_CAMERA, sphere_grid(10, 10, 10), palette(reflection=0.3))


def tori():
    rng = random.Random(2)
    obj = [{"shape": "torus", "major": 0.32, "minor": 0.11, "material": f"m{(i+3*j) % PALETTE}",
            "matrix": affine(random_rotation(rng), translate=(i - 4.5, j - 4.5, 0))}
           for i in range(10) for j in range(10)]
    return scene("b_tori", "10x10 tori, random rotations, shadows, no reflection",
                 camera((0, 0, -16), (0, 0, 0), 46), obj, palette())


def superellipsoids():
    rng = random.Random(3)
    ex = [0.1, 0.25, 0.5, 1.0, 1.75, 2.5]
    obj = [{"shape": "superellipsoid", "e": e, "n": n, "material": f"m{(i+3*j) % PALETTE}",
            "matrix": affine(random_rotation(rng), (0.75,) * 3, ((i - 2.5) * 2.2, (j - 2.5) * 2.2, 0))}
           for i, e in enumerate(ex) for j, n in enumerate(ex)]
    return scene("c_superellipsoids", "6x6 superellipsoids, e and n from 0.1 to 2.5, random rotations, shadows",
                 camera((0, 0, -21), (0, 0, 0), 50), obj, palette())


def bowl(m):
    return {"shape": "difference", "material": m, "children": [
        {"shape": "difference", "children": [
            {"shape": "sphere", "center": [0.0, 0.0, 0.0], "radius": 1.0},
            {"shape": "sphere", "center": [0.0, 0.0, 0.0], "radius": 0.85}]},
        {"shape": "cone", "base": [0.0, 0.0, 0.0], "base_radius": 0.0, "cap": [0.0, 1.5, 0.0], "cap_radius": 2.0}]}


def lens(m):
    return {"shape": "intersection", "material": m, "children": [
        {"shape": "sphere", "center": [0.0, 0.0, -1.0], "radius": 1.4},
        {"shape": "sphere", "center": [0.0, 0.0, 1.0], "radius": 1.4}]}


def rocket(m):
    return {"shape": "union", "material": m, "children": [
        {"shape": "cone", "base": [0.0, 0.6, 0.0], "base_radius": 0.35, "cap": [0.0, 1.3, 0.0], "cap_radius": 0.0},
        {"shape": "cylinder", "base": [0.0, -0.6, 0.0], "cap": [0.0, 0.6, 0.0], "radius": 0.35},
        {"shape": "cone", "base": [0.0, -1.1, 0.0], "base_radius": 0.6, "cap": [0.0, -0.4, 0.0], "cap_radius": 0.2},
        {"shape": "cylinder", "base": [-0.7, -0.2, 0.0], "cap": [0.7, -0.2, 0.0], "radius": 0.12}]}


def csg():
    rng = random.Random(4)
    kinds = [bowl, lens, rocket]
    obj = []
    for i in range(5):
        for j in range(5):
            o = kinds[(i + j) % 3](f"m{(i + 3 * j) % PALETTE}")
            o["matrix"] = affine(random_rotation(rng), translate=((i - 2) * 2.6, (j - 2) * 2.6, 0))
            obj.append(o)
    return scene("d_csg", "5x5 bowls (S1-S2)-C, lenses S1*S2 and rockets (2 cones + 2 cylinders), random rotations, "
                 "shadows, reflection 0.2", camera((0, 0, -20), (0, 0, 0), 48), obj, palette(reflection=0.2))


def glass():
    # reflection and transmit make 1 together: where all light is reflected POV-Ray weighs it with 1, others with their sum.
    g = solid((1, 1, 1), ambient=0.0, diffuse=0.1, phong=0.6, phong_size=80, reflection=0.15, transmit=0.85, ior=1.5)
    floor = solid((0.9, 0.9, 0.9), phong=0.0)
    l = lens("glass")
    l["matrix"] = affine(rot((0, 1, 0), 35), (1.2,) * 3, (0.0, 1.25, -0.5))
    obj = [{"shape": "plane", "normal": [0.0, 1.0, 0.0], "distance": -0.001, "material": "floor"},
           l,
           {"shape": "sphere", "center": [-2.3, 1.0, 0.3], "radius": 1.0, "material": "glass"},
           {"shape": "box", "min": [-0.8, -0.8, -0.8], "max": [0.8, 0.8, 0.8], "material": "glass",
            "matrix": affine(rot((0, 1, 0), 28), translate=(2.3, 0.85, 0.4))},
           {"shape": "sphere", "center": [0.6, 0.6, 3.0], "radius": 0.6, "material": "red"}]
    return scene("e_glass", "refracting CSG lens, sphere and cube, ior 1.5, over a plain floor, 12 levels",
                 camera((0, 2.6, -7.5), (0, 0.9, 0), 50), obj,
                 {"glass": g, "floor": floor, "red": solid((0.9, 0.2, 0.15))}, max_depth=12,
                 lights=[{"type": "point", "position": [6.0, 10.0, -8.0], "rgb": [0.7, 0.7, 0.7]},
                         {"type": "point", "position": [-8.0, 7.0, -3.0], "rgb": [0.4, 0.4, 0.4]}])


def dof():
    w, h = 320, 240
    s = spheres()
    s.update(name="g_dof", about="scene a through a lens: 64 samples per pixel, 320x240",
             image={"width": w, "height": h},
             dof={"aperture": 0.8, "focal_point": [4.05, 4.05, -4.05], "samples": 64})
    return s


def solids():
    rng = random.Random(8)
    shapes = [{"shape": "box", "min": [-0.32] * 3, "max": [0.32] * 3},
              {"shape": "cone", "base": [0.0, -0.4, 0.0], "base_radius": 0.35, "cap": [0.0, 0.4, 0.0], "cap_radius": 0.1},
              {"shape": "cylinder", "base": [0.0, -0.4, 0.0], "cap": [0.0, 0.4, 0.0], "radius": 0.25}]
    obj = [{**shapes[(i + j + k) % 3], "material": f"m{(i + 2*j + 3*k) % PALETTE}",
            "matrix": affine(random_rotation(rng), translate=(i - 4.5, j - 4.5, 1.2 * (k - 1)))}
           for i in range(10) for j in range(10) for k in range(3)]
    return scene("h_solids", "10x10x3 boxes, tapered cylinders and cylinders, random rotations, shadows, no reflection",
                 camera((3, 2, -16), (0, 0, 0), 46), obj, palette())


def scaling(nx, ny, nz):
    n = nx * ny * nz
    return scene(f"i_scaling_{n}", f"{nx}x{ny}x{nz} shiny spheres in the same cube as scene a",
                 GRID_CAMERA, sphere_grid(nx, ny, nz), palette(reflection=0.3))


def all_scenes():
    return [spheres(), tori(), superellipsoids(), csg(), glass(), dof(), solids(),
            scaling(5, 5, 4), scaling(10, 10, 10), scaling(25, 20, 20)]

# ------------------------------------------------------------------ POV-Ray writer

def vec(v): return "<" + ",".join(repr(float(x)) for x in v) + ">"


def pov_matrix(m):
    return "matrix <" + ", ".join(",".join(repr(float(m[r][c])) for r in range(3)) for c in range(4)) + ">"


def pov_pigment(p, transmit):
    return f"pigment {{ rgbt <{','.join(map(repr, map(float, p['rgb'])))},{transmit!r}> }}"


def pov_material(name, m):
    t = float(m.get("transmit", 0.0))
    ior = f" interior {{ ior {m['ior']!r} }}" if "ior" in m else ""
    refl = f" reflection {m['reflection']!r}" if m["reflection"] else ""
    return (f"#declare MAT_{name} = material {{ texture {{ {pov_pigment(m['pigment'], t)} finish {{ "
            f"ambient {m['ambient']!r} diffuse {m['diffuse']!r} phong {m['phong']!r} phong_size {m['phong_size']!r}"
            f"{refl} }} }}{ior} }}")


def pov_object(o, indent=""):
    s = o["shape"]
    if s == "sphere": body = f"{vec(o['center'])}, {o['radius']!r}"
    elif s == "box": body = f"{vec(o['min'])}, {vec(o['max'])}"
    elif s == "cylinder": body = f"{vec(o['base'])}, {vec(o['cap'])}, {o['radius']!r}"
    elif s == "cone": body = f"{vec(o['base'])}, {o['base_radius']!r}, {vec(o['cap'])}, {o['cap_radius']!r}"
    elif s == "torus": body = f"{o['major']!r}, {o['minor']!r}"
    elif s == "superellipsoid": body = f"<{o['e']!r},{o['n']!r}>"
    elif s == "plane": body = f"{vec(o['normal'])}, {o['distance']!r}"
    else: body = "\n" + "\n".join(pov_object(c, indent + "  ") for c in o["children"]) + "\n" + indent
    tail = (f" material {{ MAT_{o['material']} }}" if "material" in o else "") + \
           (" " + pov_matrix(o["matrix"]) if "matrix" in o else "")
    return f"{indent}{s} {{ {body}{tail} }}"


def pov(s):
    c = s["camera"]
    dof_part = ""
    if "dof" in s:
        d = s["dof"]
        dof_part = (f"\n  aperture {d['aperture']!r} focal_point {vec(d['focal_point'])} blur_samples "
                    f"{d['samples']}, {d['samples']} variance 0 confidence 0.999")
    lines = [f"// {s['name']}: {s['about']}", "// written by gen_scenes.py; do not edit", "#version 3.7;",
             f"global_settings {{ assumed_gamma 1.0 max_trace_level {s['max_depth']} adc_bailout {s['adc_bailout']!r} }}",
             f"background {{ rgb {vec(s['background'])} }}",
             f"camera {{ perspective location {vec(c['location'])} direction {vec(c['direction'])}\n"
             f"  right {vec(c['right'])} up {vec(c['up'])}{dof_part} }}"]
    lines += [f"light_source {{ {vec(l['position'])} rgb {vec(l['rgb'])} }}" for l in s["lights"]]
    lines += [pov_material(n, m) for n, m in s["materials"].items()]
    lines += [pov_object(o) for o in s["objects"]]
    return "\n".join(lines) + "\n"


def main():
    out = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent
    out.mkdir(parents=True, exist_ok=True)
    for s in all_scenes():
        (out / f"{s['name']}.pov").write_text(pov(s))
        head = {k: v for k, v in s.items() if k != "objects"}
        text = json.dumps(head, indent=1)[:-2] + ',\n "objects": [\n' + \
            ",\n".join("  " + json.dumps(o) for o in s["objects"]) + "\n ]\n}\n"
        (out / f"{s['name']}.json").write_text(text)
        print(f"{s['name']:24} {len(s['objects']):7} objects")


if __name__ == "__main__":
    main()
