"""Random moving segments with small integer data, in general position or on purpose not."""

from __future__ import annotations

import random

from minkref.oracle.symbolic.moving import MovingSegment, s_edge, t_edge

Vector = tuple[int, int]
Row = tuple[Vector, Vector, Vector]
RELATIONS = (
    "free",
    "free",
    "parallel",
    "one line",
    "shared corner",
    "end on line",
    "through a point",
    "through a point",
)


def vector(rng: random.Random, size: int, nonzero: bool = False) -> Vector:
    while True:
        found = rng.randint(-size, size), rng.randint(-size, size)
        if found != (0, 0) or not nonzero:
            return found


def add(a: Vector, b: Vector, times: int = 1) -> Vector:
    return a[0] + times * b[0], a[1] + times * b[1]


def build(kind: str, p: Vector, q: Vector, d: Vector) -> MovingSegment:
    """From s p + q along d, which scales if the kind is S."""
    return s_edge(p, add(p, d), q) if kind == "S" else t_edge(p, q, add(q, d))


def draw_rows(rng: random.Random, kinds: str, size: int) -> tuple[list[Row], str]:
    """Rows (p, q, d) of segments, and the relation of all to the first."""
    relation = rng.choice(RELATIONS)
    rows = [(vector(rng, size), vector(rng, size), vector(rng, size, nonzero=True))]
    p, q, d = rows[0]
    if relation == "through a point":
        # All middles reach one point at one scale.
        s, x = rng.randint(1, 3), vector(rng, size)
        for kind in kinds:
            p, d = vector(rng, size), vector(rng, size, nonzero=True)
            q = add(x, add((s * p[0], s * p[1]), d, s if kind == "S" else 1), -1)
            rows.append((p, q, (2 * d[0], 2 * d[1])))
        return rows[1:], relation
    for _ in kinds[1:]:
        p2, q2, d2 = vector(rng, size), vector(rng, size), vector(rng, size, nonzero=True)
        along = rng.choice([-2, -1, 1, 2])
        if relation in ("parallel", "one line"):
            d2 = (along * d[0], along * d[1])
        if relation == "one line":
            p2, q2 = add(p, d, rng.randint(-2, 2)), add(q, d, rng.randint(-4, 4))
        elif relation == "shared corner":
            p2, q2 = p, q
        elif relation == "end on line":
            p2, q2 = add(p, d, rng.randint(0, 1)), add(q, d, rng.randint(-1, 1))
        rows.append((p2, q2, d2))
    return rows, relation


def draw(rng: random.Random, kinds: str, size: int = 6) -> tuple[list[MovingSegment], str]:
    rows, relation = draw_rows(rng, kinds, size)
    return [build(kind, *row) for kind, row in zip(kinds, rows, strict=True)], relation
