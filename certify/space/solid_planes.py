"""Planes where a sum of two tiled polyhedra may have boundary area, and in each plane the polygon
that holds this area (docs/certificates-solids.md, "Planes")."""

from __future__ import annotations

from collections import defaultdict

from minkref.certify.space.solid_pieces import (
    ScaledTiling,
    Whole,
    inner,
    minus,
    outer,
    plus,
    primitive,
)

Plane = tuple[Whole, int]  # the outward normal, and normal * x


def planes(P: ScaledTiling, Q: ScaledTiling) -> dict[Plane, list[Whole]]:
    """Returns planes in ascending order, each with a polygon's corners counter-clockwise seen from
    outside. Exact. Cost: edges of P's pieces times edges of Q's pieces."""
    found: dict[Plane, set[Whole]] = defaultdict(set)
    for n in P.normals | Q.normals:
        ours, theirs = list(P.tops(n)), list(Q.tops(n))
        for one, height in ours:
            for other, level in theirs:
                if len(one) > 2 or len(other) > 2:
                    found[n, height + level].update(plus(p, q) for p in one for q in other)
    for e, around_e in P.edges:
        way = minus(e[1], e[0])
        for f, around_f in Q.edges:
            n = primitive(outer(way, minus(f[1], f[0])))
            if n == (0, 0, 0):
                continue
            for m in (n, minus((0, 0, 0), n)):
                height, level = inner(m, e[0]), inner(m, f[0])
                if any(inner(m, p) > height for p in around_e):
                    continue
                if all(inner(m, p) <= level for p in around_f):
                    found[m, height + level].update(plus(p, q) for p in e for q in f)
    return {plane: around(list(found[plane]), plane[0]) for plane in sorted(found)}


def around(points: list[Whole], normal: Whole) -> list[Whole]:
    """Returns the hull's corners of points in a plane, counter-clockwise seen against the
    normal."""

    def turn(a: Whole, b: Whole, c: Whole) -> int:
        return inner(outer(minus(b, a), minus(c, b)), normal)

    ring: list[Whole] = []
    for run in (sorted(points), sorted(points, reverse=True)):
        chain: list[Whole] = []
        for p in run:
            while len(chain) > 1 and turn(chain[-2], chain[-1], p) <= 0:
                chain.pop()
            chain.append(p)
        ring += chain[:-1]
    return ring
