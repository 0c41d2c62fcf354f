"""Judges witnesses of sums, unions, offsets and insets by definition, in fractions; joins and caps
by what every answer has, and what none goes beyond (docs/adapter-protocol.md). For a part on a path
the point tells its place, and in means a collision there.

Standard library only; written apart from every other judge. `judge.py FILE` takes findings.json,
known_offsets.json, or a document of `minkref verify --json` with its shrunk findings. It prints a
line for each witness in the plane, and ends with 1 after a refuted one. A tolerance counts at the
corners of the square around the point, and refutes the witness if they differ.
"""

import json
import sys
from fractions import Fraction
from itertools import combinations, product
from math import isqrt
from typing import Any

Point = tuple[Fraction, Fraction]
Rings = list[list[Point]]
Case = dict[str, Any]
FINE = 1 << 240  # parts of 1 in a root


def read(value: Case, scale: Fraction = Fraction(1)) -> list[Rings]:
    """The rings of each polygon. A line becomes a ring, there and back."""
    every = [[p["outer"], *p.get("holes", [])] for p in value.get("polygons", [])]
    every += [[line + line[-2:0:-1]] for line in value.get("lines", [])]
    return [[[(scale * Fraction(x), scale * Fraction(y)) for x, y in r] for r in p] for p in every]


def sides(rings: Rings) -> list[tuple[Point, Point]]:
    return [side for ring in rings for side in zip(ring, ring[1:] + ring[:1], strict=True)]


def minus(a: Point, b: Point) -> Point:
    return (a[0] - b[0], a[1] - b[1])


def dot(u: Point, w: Point) -> Fraction:
    return u[0] * w[0] + u[1] * w[1]


def cross(u: Point, w: Point) -> Fraction:
    return u[0] * w[1] - u[1] * w[0]


def holds(rings: Rings, x: Point) -> bool:
    """Whether a ray to the right crosses the rings an odd number of times."""
    crossed = [(a, b) for a, b in sides(rings) if (a[1] > x[1]) != (b[1] > x[1])]
    return sum((cross(minus(b, a), minus(x, a)) > 0) == (b[1] > a[1]) for a, b in crossed) % 2 == 1


def square(x: Point, a: Point, b: Point) -> Fraction:
    """The squared distance of a point from a segment."""
    way, off = minus(b, a), minus(x, a)
    t = min(max(dot(way, off) / (dot(way, way) or Fraction(1)), Fraction(0)), Fraction(1))
    return (off[0] - t * way[0]) ** 2 + (off[1] - t * way[1]) ** 2


def meet(a: Point, b: Point, c: Point, d: Point) -> bool:
    """Whether two closed segments have a point in common."""
    u, w = minus(b, a), minus(d, c)
    apart = cross(u, minus(c, a)) * cross(u, minus(d, a)) < 0
    crossing = apart and cross(w, minus(a, c)) * cross(w, minus(b, c)) < 0
    return crossing or 0 in (square(a, c, d), square(b, c, d), square(c, a, b), square(d, a, b))


def overlap(P: list[Rings], Q: list[Rings], by: Point, curves: bool) -> bool:
    """Whether P and Q less a step meet, or their boundaries. If no sides meet, one holds a
    vertex of the other, or none."""
    T = [[[minus(q, by) for q in ring] for ring in rings] for rings in Q]
    if any(meet(*e, *f) for p in P for e in sides(p) for t in T for f in sides(t)):
        return True
    return not curves and any(holds(p, t[0][0]) or holds(t, p[0][0]) for p in P for t in T)


def turns(ring: list[Point]) -> list[tuple[Point, Point, Point]]:
    """At the end of each side its unit vector, the next one, and the mean of the normals to their
    right."""
    ways = []
    for a, b in sides([ring]):
        far = Fraction(isqrt(int(square(a, b, b) * FINE**2)), FINE) or Fraction(1)
        ways.append(((b[0] - a[0]) / far, (b[1] - a[1]) / far))
    pairs = zip(ways, ways[1:] + ways[:1], strict=True)
    return [(u, w, ((u[1] + w[1]) / 2, -(u[0] + w[0]) / 2)) for u, w in pairs]


def moved(rings: Rings, far: Fraction) -> Rings:
    """The rings with all sides further to the right; none if two sides have met on the way."""
    after = []
    for ring in rings:
        steps = [(-far / dot(axis, axis), axis) for *_, axis in turns(ring[-1:] + ring[:-1])]
        after.append([minus(v, (t * x, t * y)) for v, (t, (x, y)) in zip(ring, steps, strict=True)])
    pairs = zip(sides(rings), sides(after), strict=True)
    gone = any(dot(minus(b, a), minus(d, c)) <= 0 for (a, b), (c, d) in pairs)
    met = any(not {*e} & {*f} and meet(*e, *f) for e, f in combinations(sides(after), 2))
    ins = [[holds(rs[:k] + rs[k + 1 :], r[0]) for k, r in enumerate(rs)] for rs in (rings, after)]
    return [] if gone or met or ins[0] != ins[1] else after


def joins(case: Case, d: Point, u: Point, w: Point, axis: Point, r: Fraction, due: bool) -> bool:
    """Whether a join or cap has the point d away from its corner: one that is due, or any."""
    join, cap, disc = case.get("join", "round"), case.get("cap", "round"), dot(d, d) <= r * r
    cosine = dot(axis, axis)  # squared, of half the turn
    if cosine == 0:  # a line ends
        squared = 0 <= dot(d, u) <= r and abs(cross(d, u)) <= r
        rounded = disc and (dot(d, u) >= 0 or not due)
        return {"flat": False, "square": squared, "round": rounded}[cap]
    if not due and join in ("round", "bevel"):
        return disc
    if cross(u, w) <= 0 or not dot(d, w) <= 0 <= dot(d, u):
        return False
    cut = cosine * Fraction(case.get("limit", 1)) ** 2
    if join == "bevel" or (join == "mitre" and due and cut < 1):
        cut = cosine**2
    in_kite = max(cross(d, u), cross(d, w)) <= r and dot(d, axis) ** 2 <= cut * r * r
    return disc if join == "round" else in_kite


def grown(case: Case, x: Point, r: Fraction, due: bool) -> bool:
    """Whether the set, a rectangle of height r to the right of a side, or a join or cap has x."""
    for ring in (ring for p in read(case["offset"]) for ring in p):
        for (a, b), (u, w, axis) in zip(sides([ring]), turns(ring), strict=True):
            d = minus(x, b)
            foot = dot(d, u) <= 0 <= min(dot(minus(x, a), u), cross(d, u))
            if (foot and square(x, a, b) <= r * r) or joins(case, d, u, w, axis, r, due):
                return True
    return any(holds(p, x) for p in read(case["offset"]))


def in_offset(case: Case, spots: list[Point], half: Fraction) -> set[bool]:
    """By distances at both ends of the tolerance; with joins and caps, whether all spots are due,
    and whether one may belong. After sharp sides have met, by distances too."""
    rings = [ring for p in read(case["offset"]) for ring in p]
    inward, radius = Fraction(case["radius"]) < 0, abs(Fraction(case["radius"]))
    reach = [max(radius + way * half, Fraction(0)) for way in (0, -1, 1)]
    sharp = case.get("join") == "sharp"
    fronts = [moved(rings, -r if inward else r) for r in reach] if sharp else []
    if {"join", "cap"} & {*case} and all(fronts):

        def has(y: Point, k: int) -> bool:
            return holds(fronts[k], y) != inward if sharp else grown(case, y, reach[k], k < 2)

        due = all(has(y, 0) for y in spots) and has(spots[0], 1)
        return {due != inward, any(has(y, 2) for y in spots) != inward}
    inside, far = holds(rings, spots[0]), min(square(spots[0], *side) for side in sides(rings))
    return {inside and far >= r**2 if inward else inside or far <= r**2 for r in reach[1:]}


def answers(case: Case, witness: Case) -> set[bool]:
    (x, y), half = map(Fraction, witness["point"]), Fraction(witness.get("tolerance", "0"))
    spots = [(x + i * half, y + j * half) for i, j in [(0, 0), *product((1, -1), repeat=2)]]
    if "offset" in case:
        return in_offset(case, spots, half)
    if "sets" in case:
        return {any(holds(p, at) for one in case["sets"] for p in read(one)) for at in spots}
    if "part" in case:
        part = read(case["part"], Fraction(case["scales"][0]))
        return {overlap(part, read(case["obstacles"]), (x, y), False)}
    P, Q = read(case["P"], Fraction(case["scale"])), read(case["Q"], Fraction(-1))
    return {overlap(P, Q, (-a, -b), witness.get("sum") == "boundary") for a, b in spots}


if __name__ == "__main__":
    given, refuted = json.load(open(sys.argv[1], encoding="utf-8")), 0
    for one in given if isinstance(given, list) else given["shrunk"]:
        case = json.loads(one["case"]) if isinstance(one.get("case"), str) else one.get("case", one)
        if one.get("witness") and "vertices" not in case.get("P", {}) and "features" not in case:
            right = answers(case, one["witness"]) == {one["witness"]["in_truth"]}
            refuted += not right
            name = one.get("id") or one.get("title") or one["target"]
            print(f"{name}: {'confirmed' if right else 'REFUTED'}")
    sys.exit(1 if refuted else 0)
