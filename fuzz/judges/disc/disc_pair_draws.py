"""Random pairs of features of an offset polygon, edges and arcs around convex vertices, more than a
third deliberately in special position."""

from __future__ import annotations

import random
from dataclasses import dataclass
from itertools import pairwise

Vector = tuple[int, int]
#: two points of an edge, with the polygon on its left; three of an arc, about the second
Feature = tuple[Vector, ...]

KINDS = ("edge, edge", "arc, edge", "arc, arc")
SPECIAL = ("right angles", "parallel", "one line", "shared end", "end on end", "fives", "mirrored")
# Directions with length 5: ends of such edges and arcs stay rational.
FIVES = ((5, 0), (4, 3), (3, 4), (0, 5), (-3, 4), (-4, 3))


@dataclass(frozen=True)
class Drawn:
    kind: str
    relation: str
    a: Feature
    b: Feature


def draw(rng: random.Random, kind: str) -> Drawn:
    """Draws two features of a kind. Three cases out of five have the `relation` `free`."""
    known = SPECIAL if kind != "arc, edge" else SPECIAL[:-1]  # for equal kinds
    relation = rng.choice(known) if rng.random() < 0.4 else "free"
    size = rng.choice([3, 8, 8, 1000]) if relation == "free" else rng.choice([2, 4, 8])
    first, second = kind.split(", ")
    facing = rng.random() < 0.7  # else most never meet
    while True:
        a = _feature(rng, first, size, relation)
        b = _related(rng, a, _feature(rng, second, size, relation), relation)
        if b is None or not (_is_right(a) and _is_right(b)) or a == b or _is_one_place(a, b):
            continue
        if relation in ("parallel", "one line") or not facing or (_faces(a, b) and _faces(b, a)):
            return Drawn(kind, relation, *((b, a) if rng.random() < 0.5 else (a, b)))


def _feature(rng: random.Random, kind: str, size: int, relation: str) -> Feature:
    p = _vector(rng, size)
    q = _add(p, _way(rng, size, relation))
    return (p, q) if kind == "edge" else (p, q, _add(q, _way(rng, size, relation)))


def _way(rng: random.Random, size: int, relation: str) -> Vector:
    if relation == "right angles":
        length = rng.choice([-1, 1]) * rng.randint(1, size)
        return (length, 0) if rng.random() < 0.5 else (0, length)
    if relation == "fives":
        x, y = rng.choice(FIVES)
        sign = rng.choice([-1, 1])
        return sign * x, sign * y
    return _vector(rng, size)


def _related(rng: random.Random, a: Feature, b: Feature, relation: str) -> Feature | None:
    """The second feature, moved or turned to stand as it is said to the first."""
    d = _add(a[1], a[0], -1)
    if relation == "parallel":
        times = rng.choice([-2, -1, -1, 1])
        return _with_first_edge(b, b[0], (times * d[0], times * d[1]))
    if relation == "one line":
        times = rng.choice([-2, -1, 1, 2])
        start = _add(a[0], d, rng.randint(-3, 3))
        return _with_first_edge(b, start, (times * d[0], times * d[1]))
    if relation == "shared end":
        corner, own = rng.choice(a), rng.randrange(len(b))
        return tuple(_add(x, _add(corner, b[own], -1)) for x in b)
    if relation == "end on end":  # across from the first, sharing its ends' place at one radius
        way = (d[1], -d[0])
        corner = _add(rng.choice(a), way, rng.choice([1, 2]))
        moved = _add(corner, rng.choice(b), -1)
        return tuple(_add(x, moved) for x in b) if way != (0, 0) else None
    if relation == "mirrored":  # in a line through an end, and moved across it
        x = rng.choice(a)[0] + rng.randint(0, 4)
        return tuple((2 * x - u, v) for u, v in reversed(a))
    return b


def _with_first_edge(b: Feature, start: Vector, way: Vector) -> Feature:
    moved = _add(start, way)
    return (start, moved, *(_add(x, _add(moved, b[1], -1)) for x in b[2:]))


def _is_right(feature: Feature) -> bool:
    """No edge of length 0, and a turn to the left."""
    ways = [_add(q, p, -1) for p, q in pairwise(feature)]
    if (0, 0) in ways:
        return False
    return len(ways) == 1 or ways[0][0] * ways[1][1] - ways[0][1] * ways[1][0] > 0


def _faces(a: Feature, b: Feature) -> bool:
    """Whether some point of the other feature lies in front of an edge, or within an arc's turn."""
    ways = [_add(point, a[1], -1) for point in b]
    normals = [(y, -x) for x, y in (_add(q, p, -1) for p, q in pairwise(a))]
    if len(normals) == 1:
        return any(normals[0][0] * x + normals[0][1] * y > 0 for x, y in ways)
    (a0, a1), (b0, b1) = normals
    return any(a0 * y - a1 * x >= 0 and x * b1 - y * b0 >= 0 for x, y in ways)


def _is_one_place(a: Feature, b: Feature) -> bool:
    """Whether both are arcs around one vertex: no vertex has two."""
    return len(a) == len(b) == 3 and a[1] == b[1]


def _vector(rng: random.Random, size: int) -> Vector:
    return rng.randint(-size, size), rng.randint(-size, size)


def _add(a: Vector, b: Vector, times: int = 1) -> Vector:
    return a[0] + times * b[0], a[1] + times * b[1]
