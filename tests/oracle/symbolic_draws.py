"""Random moving segments with small integer data, in general position or on purpose not."""

from __future__ import annotations

import random

from symbolic.moving import MovingSegment, s_edge, t_edge

Vector = tuple[int, int]
RELATIONS = ("free", "free", "parallel", "one line", "shared corner", "end on line")


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


def draw_rows(rng: random.Random, count: int, size: int) -> tuple[list[tuple[Vector, ...]], str]:
    """Rows (p, q, d) of segments, and the relation of all to the first."""
    relation = rng.choice(RELATIONS)
    rows = [(vector(rng, size), vector(rng, size), vector(rng, size, nonzero=True))]
    p, q, d = rows[0]
    for _ in range(count - 1):
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
    rows, relation = draw_rows(rng, len(kinds), size)
    return [build(kind, *row) for kind, row in zip(kinds, rows, strict=True)], relation
