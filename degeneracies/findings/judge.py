"""Judges witnesses in the plane by definition, in fractions: crossings of rays, and distances. For
a part on a path the point is its place, and in means that it collides there.

Standard library only; written apart from every other judge. `judge.py FILE` takes findings.json, or
a document of `minkref verify --json` with its shrunk findings. It prints a line for each witness,
and ends with 1 if one is refuted.
"""

from __future__ import annotations

import json
import sys
from fractions import Fraction
from itertools import product
from typing import Any

Point = tuple[Fraction, Fraction]
Set = list[list[list[Point]]]


def read(value: dict[str, Any], scale: Fraction = Fraction(1)) -> Set:
    def ring(points: Any) -> list[Point]:
        return [(scale * Fraction(x), scale * Fraction(y)) for x, y in points]

    return [[ring(p["outer"]), *map(ring, p.get("holes", []))] for p in value["polygons"]]


def edges(one: Set) -> list[tuple[Point, Point]]:
    return [(r[i - 1], r[i]) for rings in one for r in rings for i in range(len(r))]


def odd(rings: list[list[Point]], x: Point) -> bool:
    """Whether a ray to the right crosses the rings an odd number of times."""
    crossings = 0
    for (a, b), (c, d) in edges([rings]):
        if (b > x[1]) != (d > x[1]) and a + (c - a) * (x[1] - b) / (d - b) > x[0]:
            crossings += 1
    return crossings % 2 == 1


def square(x: Point, a: Point, b: Point) -> Fraction:
    """The squared distance of a point from a segment."""
    (ux, uy), (vx, vy) = (b[0] - a[0], b[1] - a[1]), (x[0] - a[0], x[1] - a[1])
    length = ux * ux + uy * uy
    t = min(max((ux * vx + uy * vy) / length, Fraction(0)), Fraction(1)) if length else Fraction(0)
    return (vx - t * ux) ** 2 + (vy - t * uy) ** 2


def meet(a: Point, b: Point, c: Point, d: Point) -> bool:
    """Whether two closed segments have a point in common."""

    def turn(p: Point, q: Point, r: Point) -> Fraction:
        return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])

    if any(square(*each) == 0 for each in ((a, c, d), (b, c, d), (c, a, b), (d, a, b))):
        return True
    return turn(a, b, c) * turn(a, b, d) < 0 and turn(c, d, a) * turn(c, d, b) < 0


def in_offset(case: dict[str, Any], x: Point, half: Fraction) -> bool | None:
    grown, radius = read(case["offset"]), Fraction(case["radius"])
    far = min(square(x, a, b) for a, b in edges(grown))
    if any(odd(rings, x) for rings in grown) or (far < (radius - half) ** 2 and half < radius):
        return True
    return False if far > (radius + half) ** 2 else None


def in_union(case: dict[str, Any], x: Point, half: Fraction) -> bool | None:
    """Decided if some polygon has the whole square around x, or none has a point of it."""
    all_rings = [rings for one in case["sets"] for rings in read(one)]
    clear = [min(square(x, a, b) for a, b in edges([r])) > 2 * half**2 for r in all_rings]
    if any(far and odd(r, x) for r, far in zip(all_rings, clear, strict=True)):
        return True
    return False if all(clear) and not any(odd(r, x) for r in all_rings) else None


def in_sum(case: dict[str, Any], x: Point, half: Fraction, curves: bool = False) -> bool | None:
    """Whether sP and x - Q meet, or their boundaries alone: at x and at the corners of the square
    around it, one answer."""
    P, Q = read(case["P"], Fraction(case["scale"])), read(case["Q"])
    answers = set()
    for i, j in [(0, 0), *product((1, -1), repeat=2)]:
        turned = [
            [[(x[0] + i * half - a, x[1] + j * half - b) for a, b in r] for r in rings]
            for rings in Q
        ]
        found = any(meet(*e, *f) for e in edges(P) for f in edges(turned))
        if not curves:
            found = found or any(odd(r, t[0][0]) or odd(t, r[0][0]) for r in P for t in turned)
        answers.add(found)
    return answers.pop() if len(answers) == 1 else None


def collides(case: dict[str, Any], x: Point) -> bool | None:
    """Whether the part at x meets the obstacles: whether -x lies in the sum with these turned."""
    rings = [[p["outer"], *p.get("holes", [])] for p in case["obstacles"]["polygons"]]
    turned = [[[[-Fraction(a), -Fraction(b)] for a, b in r] for r in each] for each in rings]
    Q = {"polygons": [{"outer": each[0], "holes": each[1:]} for each in turned]}
    pair = {"P": case["part"], "Q": Q, "scale": case["scales"][0]}
    return in_sum(pair, (-x[0], -x[1]), Fraction(0))


def truth(finding: dict[str, Any]) -> bool | None:
    """Whether the right answer contains the witness; None if the tolerance hides this."""
    case, witness = finding["case"], finding["witness"]
    x = (Fraction(witness["point"][0]), Fraction(witness["point"][1]))
    half = Fraction(witness.get("tolerance", "0"))
    if "offset" in case:
        return in_offset(case, x, half)
    if "sets" in case:
        return in_union(case, x, half)
    if "part" in case:
        return collides(case, x)
    return in_sum(case, x, half, witness.get("sum") == "boundary")


if __name__ == "__main__":
    bad = 0
    given = json.load(open(sys.argv[1], encoding="utf-8"))
    for one in given if isinstance(given, list) else given["shrunk"]:
        if isinstance(one["case"], str):
            one["case"] = json.loads(one["case"])
        if one["witness"] and "vertices" not in one["case"].get("P", {}):
            right = truth(one) is one["witness"]["in_truth"]
            bad += not right
            print(f"{one.get('id') or one['target']}: {'confirmed' if right else 'REFUTED'}")
    sys.exit(1 if bad else 0)
