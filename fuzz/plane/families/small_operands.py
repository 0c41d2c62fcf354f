"""Small random polygons for the symbolic oracle: often degenerate, so on small grids."""

from __future__ import annotations

import json
import random
from math import atan2

from minkref.api import BadInput, PolygonSet
from minkref.fuzz.geometry.plane import doubled_area

Corner = tuple[int, int]
Rings = list[list[Corner]]


def star(rng: random.Random, size: int, corners: int) -> list[Corner]:
    """Grid corners around the middle, ordered by angle; perhaps no polygon."""
    points = {(rng.randint(-size, size), rng.randint(-size, size)) for _ in range(corners)}
    cx, cy = rng.uniform(-size, size) / 3, rng.uniform(-size, size) / 3
    return sorted(points, key=lambda p: atan2(p[1] - cy, p[0] - cx))


def stairs(rng: random.Random, size: int) -> list[Corner]:
    """An L: all edges are parallel to an axis."""
    x, y = rng.randint(2, size + 1), rng.randint(2, size + 1)
    u, v = rng.randint(1, x - 1), rng.randint(1, y - 1)
    return [(0, 0), (x, 0), (x, v), (u, v), (u, y), (0, y)]


def comb(rng: random.Random, size: int) -> list[Corner]:
    """Two equally high teeth, up or down: edges on one line."""
    x = [0]
    for _ in range(3):
        x.append(x[-1] + rng.randint(1, size + 1))
    ring = [(0, 0), (x[3], 0), (x[3], 2), (x[2], 2), (x[2], 1), (x[1], 1), (x[1], 2), (0, 2)]
    return ring if rng.random() < 0.5 else [(-a, -b) for a, b in ring]


def framed(rng: random.Random, size: int) -> Rings:
    """A square with a star for a hole."""
    far = size + rng.randint(1, 2)
    frame = [(-far, -far), (far, -far), (far, far), (-far, far)]
    return [frame, star(rng, size, rng.randint(3, 4))[::-1]]


def random_rings(rng: random.Random, size: int) -> Rings:
    shape = rng.randrange(6)
    if shape == 0:
        return [stairs(rng, size)]
    if shape == 1:
        return framed(rng, size)
    if shape == 2:
        return [comb(rng, size)]
    return [star(rng, size, rng.randint(3, 6))]


def as_set(rings: Rings) -> PolygonSet:
    outer, *holes = [[[str(x), str(y)] for x, y in ring] for ring in rings]
    return PolygonSet.from_json(json.dumps({"polygons": [{"outer": outer, "holes": holes}]}))


def random_operand(rng: random.Random, size: int) -> tuple[Rings, PolygonSet]:
    """Draws rings of a valid operand, shifted to put the centre of scaling anywhere."""
    while True:
        rings = random_rings(rng, size)
        if any(len(ring) < 3 for ring in rings):
            continue
        if doubled_area(rings[0]) <= 0 or any(doubled_area(hole) >= 0 for hole in rings[1:]):
            continue
        dx, dy = rng.randint(-size, size), rng.randint(-size, size)
        rings = [[(x + dx, y + dy) for x, y in ring] for ring in rings]
        found = as_set(rings)
        try:
            found.validate()
        except BadInput:
            continue
        return rings, found
