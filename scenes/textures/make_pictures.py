#!/usr/bin/env python3
"""Writes the pictures that the scenes in this folder name. Only the standard library is used, and every run writes the same bytes.

    python3 make_pictures.py
"""

import math
import random
import struct
import zlib
from pathlib import Path

HERE = Path(__file__).parent


def png(name, width, height, pixel):
    """An 8 bit RGB picture; pixel(x, y) gives bytes, (0, 0) at the top left."""
    rows = b"".join(b"\0" + bytes(c for x in range(width) for c in pixel(x, y)) for y in range(height))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    data = chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b"")
    (HERE / name).write_bytes(b"\x89PNG\r\n\x1a\n" + data)


def hdr(name, width, height, pixel):
    """A Radiance picture in linear RGB, four bytes a pixel with a common exponent, run by run (G. Ward, Real Pixels, 1991)."""
    def encoded(colour):
        largest = max(colour)
        if largest < 1e-32:
            return b"\0\0\0\0"
        mantissa, exponent = math.frexp(largest)
        scale = mantissa * 256.0 / largest
        return bytes([*(min(255, int(c * scale)) for c in colour), exponent + 128])

    def packed(values):
        out, i = bytearray(), 0
        while i < len(values):
            run = 1
            while i + run < len(values) and run < 127 and values[i + run] == values[i]:
                run += 1
            if run > 2:
                out += bytes([128 + run, values[i]])
            else:
                run = min(2, len(values) - i)
                out += bytes([run]) + bytes(values[i:i + run])
            i += run
        return bytes(out)

    rows = bytearray()
    for y in range(height):
        line = [encoded(pixel(x, y)) for x in range(width)]
        rows += bytes([2, 2, width >> 8, width & 255])
        for channel in range(4):
            rows += packed([p[channel] for p in line])
    head = f"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {height} +X {width}\n".encode()
    (HERE / name).write_bytes(head + bytes(rows))


def byte(x):
    return max(0, min(255, round(255 * x)))


def smooth(edge0, edge1, x):
    t = max(0.0, min(1.0, (x - edge0) / (edge1 - edge0)))
    return t * t * (3 - 2 * t)


# ---------------------------------------------------------------- bricks, as a colour and as a height

SIZE, COLUMNS, ROWS = 256, 4, 8
_rng = random.Random(5)
SHADE = [[_rng.uniform(0.78, 1.12) for _ in range(COLUMNS)] for _ in range(ROWS)]
GRAIN = [[_rng.uniform(-0.035, 0.035) for _ in range(SIZE)] for _ in range(SIZE)]


def brick(x, y):
    """(row, column, how far into the brick from 0 in the mortar to 1)."""
    row = y * ROWS // SIZE
    shifted = (x + (SIZE // COLUMNS // 2) * (row % 2)) % SIZE
    across, down = shifted % (SIZE // COLUMNS), y % (SIZE // ROWS)
    edge = min(across, SIZE // COLUMNS - 1 - across, down, SIZE // ROWS - 1 - down)
    return row, shifted * COLUMNS // SIZE, smooth(0.5, 4.5, edge)


def brick_colour(x, y):
    row, column, inside = brick(x, y)
    clay = [c * SHADE[row][column] + GRAIN[y][x] for c in (0.66, 0.33, 0.24)]
    mortar = [0.72 + GRAIN[y][x]] * 3
    return [byte(m + (c - m) * inside) for m, c in zip(mortar, clay)]


def brick_height(x, y):
    row, column, inside = brick(x, y)
    return [byte(inside * (0.8 + 0.15 * (SHADE[row][column] - 0.78)) + 0.3 * GRAIN[y][x])] * 3


# ---------------------------------------------------------------- a grid that tells s from t and left from right

GLYPH_F = ["#####", "#....", "###..", "#....", "#....", "#....", "....."]


def compass(x, y):
    s, t = (x + 0.5) / 256, 1 - (y + 0.5) / 256
    cell = (int(s * 8) + int(t * 8)) % 2
    colour = [0.25 + 0.6 * s, 0.25 + 0.6 * t, 0.75 - 0.35 * (s + t) / 2]
    colour = [c * (1.0 if cell else 0.82) for c in colour]
    if x % 32 in (0, 31) or y % 32 in (0, 31):
        colour = [c * 0.55 for c in colour]
    gx, gy = (x - 78) // 20, (y - 58) // 20
    if 0 <= gx < 5 and 0 <= gy < 7 and GLYPH_F[gy][gx] == "#":
        colour = [0.97, 0.97, 0.95]
    # A red bar along s and a green one along t, both from the corner s = t = 0.
    if s < 0.6 and t < 0.05:
        colour = [0.85, 0.12, 0.1]
    if t < 0.6 and s < 0.05:
        colour = [0.1, 0.6, 0.15]
    return [byte(c) for c in colour]


# ---------------------------------------------------------------- a globe: land, sea, ice and a graticule

_lobes = random.Random(11)
LAND = [(_lobes.uniform(0, 2 * math.pi), _lobes.uniform(-1.0, 1.0), _lobes.uniform(0.25, 0.6)) for _ in range(13)]


def globe(x, y):
    longitude, latitude = 2 * math.pi * (x + 0.5) / 512, math.pi * (0.5 - (y + 0.5) / 256)
    here = (math.cos(latitude) * math.cos(longitude), math.cos(latitude) * math.sin(longitude), math.sin(latitude))
    height = 0.0
    for lon, lat, size in LAND:
        there = (math.cos(lat) * math.cos(lon), math.cos(lat) * math.sin(lon), math.sin(lat))
        angle = math.acos(max(-1.0, min(1.0, sum(a * b for a, b in zip(here, there)))))
        wobble = 1 + 0.25 * math.sin(5 * math.atan2(here[1] - there[1], here[0] - there[0]) + 9 * lon)
        height = max(height, 1 - angle / (size * wobble))
    sea, coast, hill = (0.1, 0.3, 0.55), (0.5, 0.62, 0.3), (0.62, 0.5, 0.33)
    colour = sea if height <= 0 else tuple(c + (h - c) * smooth(0.1, 0.7, height) for c, h in zip(coast, hill))
    ice = smooth(1.18, 1.25, abs(latitude) + 0.05 * math.sin(6 * longitude))
    colour = [c + (0.95 - c) * ice for c in colour]
    if x % 43 == 0 or (y + 1) % 43 == 0:
        colour = [0.7 * c + 0.2 for c in colour]
    return [byte(c) for c in colour]


# ---------------------------------------------------------------- environments

def sky(x, y):
    """Linear light: a sun that is far brighter than white, a sky, a horizon with hills and towers, a meadow."""
    longitude, latitude = 2 * math.pi * (x + 0.5) / 256, math.pi * (0.5 - (y + 0.5) / 128)
    sun = (0.9, 0.62)
    angle = math.hypot((longitude - sun[0]) * math.cos(latitude), latitude - sun[1])
    if latitude < 0:
        stripe = 0.75 + 0.25 * (int(longitude / (math.pi / 12)) % 2)
        fade = smooth(0.0, 1.2, -latitude)
        return [c * stripe * (1 - 0.45 * fade) for c in (0.25, 0.33, 0.12)]
    hills = 0.05 + 0.03 * math.sin(3 * longitude) + 0.015 * math.sin(7 * longitude + 1)
    tower = int(longitude / (math.pi / 8)) % 4 == 1 and (longitude / (math.pi / 8)) % 1 < 0.3 and latitude < 0.26
    if tower:
        lit = 0.5 + 0.5 * math.cos(longitude - sun[0])
        return [c * (0.35 + 0.65 * lit) for c in (0.72, 0.5, 0.34)]
    if latitude < hills:
        return [c * (0.8 + 0.4 * math.cos(longitude - sun[0])) for c in (0.13, 0.2, 0.14)]
    glow = math.exp(-6 * angle)
    zenith, horizon = (0.16, 0.32, 0.72), (0.75, 0.85, 0.98)
    up = smooth(0.0, 1.3, latitude)
    colour = [h + (z - h) * up + glow * g for h, z, g in zip(horizon, zenith, (1.6, 1.2, 0.6))]
    return [300.0, 270.0, 210.0] if angle < 0.045 else colour


FACES = {(1, 0): "up", (0, 1): "left", (1, 1): "front", (2, 1): "right", (3, 1): "back", (1, 2): "down"}
PAINT = {"up": (0.92, 0.91, 0.88), "down": (0.45, 0.3, 0.2), "left": (0.72, 0.3, 0.26), "right": (0.28, 0.5, 0.34),
         "front": (0.8, 0.74, 0.6), "back": (0.34, 0.42, 0.66)}


def room(x, y):
    face = FACES.get((x // 64, y // 64))
    if face is None:
        return [0, 0, 0]
    u, v = (x % 64 + 0.5) / 64, (y % 64 + 0.5) / 64
    colour = list(PAINT[face])
    if face == "down":
        board = int(v * 8)
        colour = [c * (0.85 + 0.3 * ((board * 7 + int(u * 2 + board * 0.37) * 3) % 5) / 5) for c in colour]
        if v * 8 % 1 < 0.08:
            colour = [c * 0.6 for c in colour]
    elif face == "up":
        if math.hypot(u - 0.5, v - 0.5) < 0.16:
            colour = [1.0, 1.0, 0.97]
    else:
        if 0.22 < u < 0.78 and 0.22 < v < 0.66:
            colour = [0.62, 0.8, 0.98]
            if abs(u - 0.5) < 0.02 or abs(v - 0.44) < 0.02:
                colour = [0.95, 0.95, 0.95]
        elif 0.18 < u < 0.82 and 0.18 < v < 0.7:
            colour = [0.95, 0.95, 0.95]
        elif v > 0.9:
            colour = [c * 0.6 for c in colour]
    if min(u, v, 1 - u, 1 - v) < 0.02:
        colour = [c * 0.7 for c in colour]
    return [byte(c) for c in colour]


def checker(x, y):
    return [235, 235, 225] if (x + y) % 2 == 0 else [30, 45, 70]


if __name__ == "__main__":
    png("bricks.png", SIZE, SIZE, brick_colour)
    png("bricks_height.png", SIZE, SIZE, brick_height)
    png("compass.png", 256, 256, compass)
    # Every eighth texel of every eighth row: as few as can be told apart one by one.
    png("compass_small.png", 32, 32, lambda x, y: compass(8 * x + 4, 8 * y + 4))
    png("globe.png", 512, 256, globe)
    png("checker.png", 16, 16, checker)
    png("room_cross.png", 256, 192, room)
    hdr("sky.hdr", 256, 128, sky)
