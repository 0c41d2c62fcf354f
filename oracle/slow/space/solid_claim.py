"""Tests a claimed sum in space against points of the true sum.

A claim is a closed surface if along every line its edges cancel. Then the surface winds around
every point off it, and is the sum iff the winding is 1 inside the sum and 0 outside. The tests: for
random points inside each exposed polygon, whether the sum contains the point just below but not the
point just above; for random points, and for points beside planes of pairwise sums, whether the
surface winds correctly.
"""

from __future__ import annotations

import random
from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction

from ..exact import Point
from ..operand import Polygon
from .exposed import Exposed, beside, is_mirrored, lifted, rings_of, sides, viewing_axis
from .solid import Place, Whole, height, inner, outer, shortest, wholes
from .solid_pieces import Plane
from .solid_sum import SolidSum


@dataclass(frozen=True)
class Fault:
    """A fault: `what` is wrong at the point, or a little along `way` unless `way` is (0, 0, 0).
    `in_truth` tells whether the true sum contains this nearby point."""

    what: str
    point: Place
    way: Whole
    in_truth: bool


def faults(
    truth: SolidSum, claim: Exposed, dice: random.Random, inside: int = 1, points: int = 30
) -> Iterator[Fault]:
    """Test `inside` points per polygon, `points` points in the box and as many beside planes.
    Exact."""
    for plane, polygons in claim.planes.items():
        for part in polygons:
            for _ in range(inside):
                yield from of_plane(truth, plane, lifted(inner_point(part, dice), plane))
    for x in (*_in_box(truth, dice, points), *_beside_planes(truth, dice, points)):
        winds = winding(claim, x, dice)
        if winds is not None:
            in_truth = truth.holds(x)
            if winds != in_truth:
                yield Fault(f"the claim winds {winds} times around a point", x, (0, 0, 0), in_truth)


def of_plane(truth: SolidSum, plane: Plane, x: Place) -> Iterator[Fault]:
    """Test a point claimed to be exposed."""
    a, b, c = n = plane[0]
    if truth.holds(x, [n]):
        yield Fault("just above a face is in the sum", x, n, True)
    down = (-a, -b, -c)
    if not truth.holds(x, [down]):
        yield Fault("just below a face is not in the sum", x, down, False)


def place_of(truth: SolidSum, claim: Exposed, fault: Fault, dice: random.Random) -> Place | None:
    """Find a point near the fault that only one of claim and sum contains. None without such a
    point within 2^-60, as beside a face that bounds nothing."""
    for power in range(60):
        t = Fraction(1, 1 << power)
        x, y, z = (p + t * d for p, d in zip(fault.point, fault.way, strict=True))
        winds = winding(claim, (x, y, z), dice)
        if winds is not None and winds != truth.holds((x, y, z)):
            return x, y, z
    return None


def told_apart(one: Exposed, other: Exposed, dice: random.Random, tries: int = 4) -> Place | None:
    """Find a point around which two closed surfaces wind differently, next to a face that only one
    surface has. None without such a point, as for equal surfaces."""
    for mine, theirs in ((one, other), (other, one)):
        for plane, polygons in mine.planes.items():
            if theirs.planes.get(plane) == polygons:
                continue
            for part in polygons * tries:
                x = lifted(inner_point(part, dice), plane)
                for power in (1, 4, 10, 30):
                    t = Fraction(dice.choice((-1, 1)), 1 << power)
                    a, b, c = (p + t * n for p, n in zip(x, plane[0], strict=True))
                    found = winding(one, (a, b, c), dice), winding(other, (a, b, c), dice)
                    if None not in found and found[0] != found[1]:
                        return a, b, c
    return None


def _in_box(truth: SolidSum, dice: random.Random, count: int) -> Iterator[Place]:
    low = [min(box[0][k] for box in truth.boxes) for k in range(3)]
    high = [max(box[1][k] for box in truth.boxes) for k in range(3)]
    for _ in range(count):
        x, y, z = (
            low[k] + (high[k] - low[k]) * Fraction(dice.randint(-20, 1020), 1000) for k in range(3)
        )
        yield x, y, z


def _beside_planes(truth: SolidSum, dice: random.Random, count: int) -> Iterator[Place]:
    """Yield points very near to facets of pairwise sums, on both sides."""
    for _ in range(count):
        pair = dice.randrange(len(truth.pairs))
        a, b = truth.pairs[pair]
        n, _, _ = dice.choice(truth.bounds(pair))
        ends = []
        for piece in (a, b):
            most = piece.support(n)
            face = [corner for corner in piece.corners if inner(n, corner) == most]
            weights = [dice.randint(1, 9) for _ in face]
            total = piece.unit * sum(weights)
            ends.append([
                Fraction(sum(w * corner[k] for w, corner in zip(weights, face, strict=True)), total)
                for k in range(3)
            ])  # fmt: skip
        step = Fraction(dice.choice((-1, 1)), 10**6)
        x, y, z = (ends[0][k] + ends[1][k] + step * n[k] for k in range(3))
        yield x, y, z


def inner_point(part: Polygon, dice: random.Random) -> Point:
    """Return a point inside the polygon: on a random level between two corners, between two
    sides."""
    levels = sorted({point[1] for point in part.outer})
    k = dice.randrange(len(levels) - 1)
    y = levels[k] + (levels[k + 1] - levels[k]) * Fraction(dice.randint(1, 96), 97)
    crossings = sorted(
        a[0] + (b[0] - a[0]) * (y - a[1]) / (b[1] - a[1])
        for ring in rings_of([part])
        for a, b in sides(ring)
        if (a[1] <= y) != (b[1] <= y)
    )
    spans = [(a, b) for a, b in zip(crossings[::2], crossings[1::2], strict=True) if a < b]
    a, b = dice.choice(spans)
    return a + (b - a) * Fraction(dice.randint(1, 96), 97), y


def open_lines(claim: Exposed) -> int:
    """Count the lines along which the faces' edges do not cancel; 0 for a closed surface. Exact."""
    steps: dict[tuple[Whole, Place], dict[Place, int]] = defaultdict(lambda: defaultdict(int))
    for plane, polygons in claim.planes.items():
        for ring in rings_of(polygons):
            for a, b in sides([*ring][:: -1 if is_mirrored(plane[0]) else 1]):
                start, end = lifted(a, plane), lifted(b, plane)
                low, high = min(start, end), max(start, end)
                unit, (p, q) = wholes([low, high])
                d = shortest((q[0] - p[0], q[1] - p[1], q[2] - p[2]))
                x, y, z = (Fraction(value, unit) for value in outer(p, d))
                line = steps[d, (x, y, z)]
                sign = 1 if start == low else -1
                line[low] += sign
                line[high] -= sign
    return sum(any(line.values()) for line in steps.values())


def winding(claim: Exposed, x: Place, dice: random.Random) -> int | None:
    """Count the surface's winding around the point by a ray; None for a point on the surface. Draws
    a new ray if an edge is hit."""
    while True:
        ray = (dice.randint(-999, 999), dice.randint(-999, 999), dice.randint(-999, 999))
        total = 0
        for plane, polygons in claim.planes.items():
            along = inner(plane[0], ray)
            rise = plane[1] - height(plane[0], x)
            if rise == 0 and hit(polygons, x, plane) != 0:
                return None
            if along == 0:
                if rise == 0:
                    break
                continue
            t = rise / along
            if t <= 0:
                continue
            met = hit(polygons, (x[0] + t * ray[0], x[1] + t * ray[1], x[2] + t * ray[2]), plane)
            if met is None:
                break
            total += met * (1 if along > 0 else -1)
        else:
            return total


def hit(polygons: list[Polygon], place: Place, plane: Plane) -> int | None:
    """Return 1 for a point in the plane inside the polygons, 0 outside, None on a side."""
    u, v = beside(viewing_axis(plane[0]))
    x, y = place[u], place[v]
    odd = False
    for ring in rings_of(polygons):
        for a, b in sides(ring):
            turn = (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])
            if turn == 0 and min(a, b) <= (x, y) <= max(a, b):
                return None
            if (a[1] <= y) != (b[1] <= y):
                odd ^= (turn > 0) == (b[1] > a[1])
    return int(odd)
