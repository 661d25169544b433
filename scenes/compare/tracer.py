"""A small ray tracer that prints what it does, for `rayscope compare`. Standard library only.

    python3 tracer.py 235,285 525,225 > mine.jsonl
    rayscope compare mine.jsonl compare/still_life
"""
import json
import math
import os
import sys

EPSILON = 1e-6  # hits up to here are the surface that the ray starts on


def add(a, b): return [x + y for x, y in zip(a, b)]
def sub(a, b): return [x - y for x, y in zip(a, b)]
def mul(a, b): return [x * y for x, y in zip(a, b)]
def scale(a, s): return [x * s for x in a]
def dot(a, b): return sum(x * y for x, y in zip(a, b))
def unit(a): return scale(a, 1 / math.sqrt(dot(a, a)))
def cross(a, b): return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
def reflect(d, n): return sub(d, scale(n, 2 * dot(d, n)))
def say(**line): print(json.dumps(line))


# Affine maps: three rows of a matrix, and a translation.
def linear(m, v): return [dot(row, v) for row in m[0]]
def point(m, p): return add(linear(m, p), m[1])
def transposed(m, v): return [sum(m[0][i][j] * v[i] for i in range(3)) for j in range(3)]


def after(outer, inner):
    columns = list(zip(*inner[0]))
    return [[dot(row, column) for column in columns] for row in outer[0]], point(outer, inner[1])


def inverse(m):
    a, b, c = m[0]
    rows = [cross(b, c), cross(c, a), cross(a, b)]
    determinant = dot(a, rows[0])
    inv = [[rows[j][i] / determinant for j in range(3)] for i in range(3)]
    return inv, scale(linear((inv, None), m[1]), -1)


IDENTITY = ([[1, 0, 0], [0, 1, 0], [0, 0, 1]], [0, 0, 0])


def step_map(step):
    if "scale" in step:
        s = step["scale"]
        x, y, z = s if isinstance(s, list) else [s] * 3
        return [[x, 0, 0], [0, y, 0], [0, 0, z]], [0, 0, 0]
    if "translate" in step:
        return IDENTITY[0], step["translate"]
    x, y, z = unit(step["rotate"]["axis"])
    a = math.radians(step["rotate"]["degrees"])
    c, s, k = math.cos(a), math.sin(a), 1 - math.cos(a)
    return [[c + x * x * k, x * y * k - z * s, x * z * k + y * s],
            [y * x * k + z * s, c + y * y * k, y * z * k - x * s],
            [z * x * k - y * s, z * y * k + x * s, c + z * z * k]], [0, 0, 0]


class Leaf:
    def __init__(self, data, name, matrix, material):
        self.shape, self.name, self.material = data["shape"], name, material
        self.matrix, self.inverse = matrix, inverse(matrix)


def build(data, outer, material, name):
    """A leaf, or (operator, left, right)."""
    matrix = outer
    for step in reversed(data.get("transform", [])):
        matrix = after(matrix, step_map(step))
    material = data.get("material", material)
    if "of" not in data:
        return Leaf(data, name, matrix, material)
    parts = [build(part, matrix, material, part["name"]) for part in data["of"]]
    tree = parts[0]
    for part in parts[1:]:
        tree = (data["shape"], tree, part)
    return tree


# Crossings of a line S + c t with generic shapes: (t, normal), in order.
def quadratic(a, b, c):
    d = b * b - a * c
    return [(-b - math.sqrt(d)) / a, (-b + math.sqrt(d)) / a] if d > 0 and a > 0 else []


def cross_sphere(s, c):
    return [(t, add(s, scale(c, t))) for t in quadratic(dot(c, c), dot(s, c), dot(s, s) - 1)]


def cross_plane(s, c):
    return [(-s[2] / c[2], [0, 0, 1])] if c[2] else []


def cross_cylinder(s, c):
    found = []
    for t in quadratic(c[0] ** 2 + c[1] ** 2, s[0] * c[0] + s[1] * c[1], s[0] ** 2 + s[1] ** 2 - 1):
        p = add(s, scale(c, t))
        if 0 <= p[2] <= 1:
            found.append((t, [p[0], p[1], 0]))
    for z in (0, 1):
        if c[2]:
            t = (z - s[2]) / c[2]
            p = add(s, scale(c, t))
            if p[0] ** 2 + p[1] ** 2 <= 1:
                found.append((t, [0, 0, 2 * z - 1]))
    return sorted(found, key=lambda hit: hit[0])


def cross_cube(s, c):
    enter, leave = (-math.inf, None), (math.inf, None)
    for axis in range(3):
        for side in (-1, 1):
            normal = [side if k == axis else 0 for k in range(3)]
            if c[axis] == 0:
                if abs(s[axis]) > 1:
                    return []
                continue
            t = (side - s[axis]) / c[axis]
            if side * c[axis] < 0:
                enter = max(enter, (t, normal), key=lambda hit: hit[0])
            else:
                leave = min(leave, (t, normal), key=lambda hit: hit[0])
    return [enter, leave] if enter[0] < leave[0] else []


SHAPES = {"sphere": cross_sphere, "plane": cross_plane, "cylinder": cross_cylinder, "cube": cross_cube}


def boundaries(tree, name, o, d):
    """All (t, leaf, generic normal, turned round) of a solid along a ray."""
    if isinstance(tree, Leaf):
        s, c = point(tree.inverse, o), linear(tree.inverse, d)
        hits = SHAPES[tree.shape](s, c)
        say(object=name, leaf=tree.name, generic_origin=s, generic_direction=c, hits=[t for t, _ in hits])
        return [(t, tree, n, False) for t, n in hits]
    operator, left, right = tree
    sides = [[(hit, 0) for hit in boundaries(left, name, o, d)]]
    turn = operator == "difference"
    sides.append([((t, leaf, n, r != turn), 1) for t, leaf, n, r in boundaries(right, name, o, d)])
    inside, was, result = [False, False], False, []
    for hit, side in sorted(sides[0] + sides[1], key=lambda pair: pair[0][0]):
        inside[side] = not inside[side]
        now = {"union": inside[0] or inside[1], "intersection": inside[0] and inside[1],
               "difference": inside[0] and not inside[1]}[operator]
        if now != was:
            result.append(hit)
        was = now
    return result


class Tracer:
    def __init__(self, scene):
        self.scene = scene
        self.objects = [(o["name"], build(o, IDENTITY, o.get("material"), o["name"])) for o in scene["objects"]]

    def pixel(self, x, y):
        say(pixel=[x, y])
        camera, image = self.scene["camera"], self.scene["image"]
        forward = unit(sub(camera["look_at"], camera["eye"]))
        right = unit(cross(forward, camera["up"]))
        up = cross(right, forward)
        h = math.tan(math.radians(camera["field_of_view"]) / 2)
        a = (2 * (x + 0.5) / image["width"] - 1) * h * image["width"] / image["height"]
        b = (1 - 2 * (y + 0.5) / image["height"]) * h
        d = add(forward, add(scale(right, a), scale(up, b)))
        return self.trace("camera", camera["eye"], d, 0)

    def trace(self, kind, o, d, depth):
        say(ray=kind, origin=o, direction=d)
        best = None
        for name, tree in self.objects:
            for hit in boundaries(tree, name, o, d):
                if hit[0] > EPSILON and (best is None or hit[0] < best[1][0]):
                    best = name, hit
        if best is None:
            say(hit=None)
            colour = self.scene["background"]
        else:
            colour = self.shade(best[0], best[1], o, d, depth)
        say(colour=colour)
        return colour

    def shade(self, name, hit, o, d, depth):
        t, leaf, generic_normal, turned = hit
        p = add(o, scale(d, t))
        outward = unit(transposed(leaf.inverse, generic_normal))
        outward = scale(outward, -1) if turned else outward
        n = scale(outward, -1) if dot(outward, d) > 0 else outward
        say(hit=name, leaf=leaf.name, t=t, point=p, outward=outward, normal=n)
        material = self.scene["materials"][leaf.material]
        colour = mul(material["ambient"], self.scene["ambient"])
        v = unit(scale(d, -1))
        for light in self.scene["lights"]:
            to_light = sub(light["point"], p) if "point" in light else unit(light["directional"])
            l = unit(to_light)
            lit = self.arriving(light, p, to_light) if dot(n, l) > 0 else 0
            arriving = scale(light["colour"], lit)
            diffuse = scale(mul(arriving, material["diffuse"]), max(0, dot(n, l)))
            shine = max(0, dot(reflect(scale(l, -1), n), v)) ** material.get("exponent", 1)
            specular = scale(mul(arriving, material.get("specular", [0, 0, 0])), shine)
            say(light=light["name"], towards=l, diffuse=diffuse, specular=specular)
            colour = add(colour, add(diffuse, specular))
        mirrors, passes = material.get("reflectivity", 0), material.get("transparency", 0)
        if depth == self.scene["limits"]["depth"] or not (mirrors or passes):
            return colour
        refracted = self.refract(outward, n, d, material["index_of_refraction"]) if passes else None
        if passes and not refracted:
            mirrors += passes
        if mirrors:
            colour = add(colour, scale(self.trace("reflected", p, reflect(d, n), depth + 1), mirrors))
        if refracted:
            colour = add(colour, scale(self.trace("refracted", p, refracted, depth + 1), passes))
        return colour

    def refract(self, outward, n, d, index):
        n1, n2 = (1, index) if dot(outward, d) < 0 else (index, 1)
        d, eta = unit(d), n1 / n2
        cosine = -dot(d, n)
        w = 1 - eta * eta * (1 - cosine * cosine)
        refracted = unit(add(scale(d, eta), scale(n, eta * cosine - math.sqrt(w)))) if w >= 0 else None
        say(refracted=refracted, n1=n1, n2=n2)
        return refracted

    def arriving(self, light, p, to_light):
        """The share of a light that comes to p: every surface in the way passes its transparency."""
        say(ray="shadow", light=light["name"], origin=p, direction=to_light)
        end, share = (1 if "point" in light else math.inf), 1
        for name, tree in self.objects:
            for t, leaf, _, _ in boundaries(tree, name, p, to_light):
                if EPSILON < t < end:
                    share *= self.scene["materials"][leaf.material].get("transparency", 0)
        say(light=light["name"], lit=share > 0)
        return share


def main():
    folder = os.path.dirname(os.path.abspath(__file__))
    with open(os.path.join(folder, "still_life.json"), encoding="utf-8") as file:
        tracer = Tracer(json.load(file))
    for argument in sys.argv[1:] or ["235,285"]:
        tracer.pixel(*(int(number) for number in argument.split(",")))


main()
