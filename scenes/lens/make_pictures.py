#!/usr/bin/env python3
"""Writes the picture of an aperture that a scene in this folder names. Only the standard library is used, and every run writes
the same bytes.

    python3 make_pictures.py
"""

import math
import struct
import zlib
from pathlib import Path

HERE = Path(__file__).parent
SIDE = 128
FINE = 4
INNER = 0.42


def is_in_star(x, y):
    """Whether a point lies within a star of five points, of which one is up, in the unit disc."""
    turn = (math.atan2(x, y) / (2 * math.pi) * 5) % 1
    way = abs(turn - 0.5) * 2  # 1 along a point of the star, 0 between two of them
    angle = (1 - way) * math.pi / 5
    # The side from the tip (1, 0) to the inner corner, as a line in polar coordinates.
    inner = (INNER * math.cos(math.pi / 5), INNER * math.sin(math.pi / 5))
    normal = (inner[1], 1 - inner[0])
    return math.hypot(x, y) * (normal[0] * math.cos(angle) + normal[1] * math.sin(angle)) <= normal[0]


def grey(column, row):
    """The share of a texel that lies in the star, as a byte by the curve of sRGB."""
    places = [(k + 0.5) / FINE for k in range(FINE)]
    inside = sum(
        is_in_star(2 * (column + a) / SIDE - 1, 1 - 2 * (row + b) / SIDE) for a in places for b in places
    )
    linear = inside / FINE**2
    encoded = 12.92 * linear if linear <= 0.0031308 else 1.055 * linear ** (1 / 2.4) - 0.055
    return round(255 * encoded)


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


rows = b"".join(b"\0" + bytes(grey(column, row) for column in range(SIDE)) for row in range(SIDE))
header = struct.pack(">IIBBBBB", SIDE, SIDE, 8, 0, 0, 0, 0)
data = chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b"")
(HERE / "star.png").write_bytes(b"\x89PNG\r\n\x1a\n" + data)
