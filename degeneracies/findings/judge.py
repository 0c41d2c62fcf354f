"""Judges witnesses of sums, unions, offsets and insets by definition, in fractions. For a part on a
path the point is its place, and in means that it collides there.

Standard library only; written apart from every other judge. `judge.py FILE` takes findings.json, or
a document of `minkref verify --json` with its shrunk findings. It prints a line for each witness in
the plane, and ends with 1 if one is refuted. A tolerance may hide the answer: refuted, too.
"""

from __future__ import annotations

import json
import sys
from fractions import Fraction
from itertools import product
from typing import Any

Point = tuple[Fraction, Fraction]
Edges = list[tuple[Point, Point]]  # of all rings of a polygon


def read(value: dict[str, Any], scale: Fraction = Fraction(1)) -> list[Edges]:
    def edges(ring: Any) -> Edges:
        points = [(scale * Fraction(x), scale * Fraction(y)) for x, y in ring]
        return list(zip([points[-1], *points], points, strict=False))

    polygons = [[p["outer"], *p.get("holes", [])] for p in value["polygons"]]
    return [[edge for ring in rings for edge in edges(ring)] for rings in polygons]


def turn(a: Point, b: Point, c: Point) -> Fraction:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def holds(polygon: Edges, x: Point) -> bool:
    """Whether a ray to the right crosses the rings an odd number of times."""
    crossed = [(a, b) for a, b in polygon if (a[1] > x[1]) != (b[1] > x[1])]
    return sum((turn(a, b, x) > 0) == (b[1] > a[1]) for a, b in crossed) % 2 == 1


def square(x: Point, a: Point, b: Point) -> Fraction:
    """The squared distance of a point from a segment."""
    (ux, uy), (vx, vy) = (b[0] - a[0], b[1] - a[1]), (x[0] - a[0], x[1] - a[1])
    t = min(max((ux * vx + uy * vy) / (ux * ux + uy * uy or Fraction(1)), Fraction(0)), Fraction(1))
    return (vx - t * ux) ** 2 + (vy - t * uy) ** 2


def meet(a: Point, b: Point, c: Point, d: Point) -> bool:
    """Whether two closed segments have a point in common."""
    crossing = turn(a, b, c) * turn(a, b, d) < 0 and turn(c, d, a) * turn(c, d, b) < 0
    return crossing or 0 in (square(a, c, d), square(b, c, d), square(c, a, b), square(d, a, b))


def in_offset(case: dict[str, Any], x: Point, half: Fraction) -> set[bool]:
    """Answers at the radius and half more and less; a radius below 0 erodes."""
    P, radius = read(case["offset"]), Fraction(case["radius"])
    inside, far = any(holds(p, x) for p in P), min(square(x, *edge) for p in P for edge in p)
    levels = [max(abs(radius) + way * half, Fraction(0)) ** 2 for way in (1, -1)]
    return {inside and far >= level if radius < 0 else inside or far <= level for level in levels}


def in_union(case: dict[str, Any], x: Point, half: Fraction) -> set[bool]:
    """Decided if some polygon has the whole square around x, or none has a point of it."""
    polygons = [p for one in case["sets"] for p in read(one)]
    cut = [min(square(x, *edge) for edge in p) <= 2 * half**2 for p in polygons]
    inside = any(holds(p, x) and not near for p, near in zip(polygons, cut, strict=True))
    return {inside, inside or any(cut)}


def overlap(P: list[Edges], T: list[Edges], curves: bool) -> bool:
    """Whether two sets meet, or their boundaries. Without edges that meet, one holds a vertex of
    the other, or none."""
    if any(meet(*e, *f) for p in P for e in p for t in T for f in t):
        return True
    return not curves and any(holds(p, t[0][0]) or holds(t, p[0][0]) for p in P for t in T)


def in_sum(case: dict[str, Any], x: Point, half: Fraction, curves: bool) -> set[bool]:
    """Whether sP and y - Q meet, for y = x and corners of the square around it."""
    P, Q, answers = read(case["P"], Fraction(case["scale"])), read(case["Q"]), set()
    for i, j in [(0, 0), *product((1, -1), repeat=2)]:
        y = x[0] + i * half, x[1] + j * half
        T = [[((y[0] - a, y[1] - b), (y[0] - c, y[1] - d)) for (a, b), (c, d) in q] for q in Q]
        answers.add(overlap(P, T, curves))
    return answers


def collides(case: dict[str, Any], x: Point) -> set[bool]:
    P, Q = read(case["part"], Fraction(case["scales"][0])), read(case["obstacles"])
    T = [[((a - x[0], b - x[1]), (c - x[0], d - x[1])) for (a, b), (c, d) in q] for q in Q]
    return {overlap(P, T, False)}


def answers(case: dict[str, Any], witness: dict[str, Any]) -> set[bool]:
    (x, y), half = map(Fraction, witness["point"]), Fraction(witness.get("tolerance", "0"))
    if "offset" in case:
        return in_offset(case, (x, y), half)
    if "sets" in case:
        return in_union(case, (x, y), half)
    if "part" in case:
        return collides(case, (x, y))
    return in_sum(case, (x, y), half, witness.get("sum") == "boundary")


if __name__ == "__main__":
    given, refuted = json.load(open(sys.argv[1], encoding="utf-8")), 0
    for one in given if isinstance(given, list) else given["shrunk"]:
        case = json.loads(one["case"]) if isinstance(one["case"], str) else one["case"]
        if one["witness"] and "vertices" not in case.get("P", {}):
            right = answers(case, one["witness"]) == {one["witness"]["in_truth"]}
            refuted += not right
            print(f"{one.get('id') or one['target']}: {'confirmed' if right else 'REFUTED'}")
    sys.exit(1 if refuted else 0)
