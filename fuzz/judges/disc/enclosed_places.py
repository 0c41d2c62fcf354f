"""Places before drawn rings of lines and arcs, in doubles: the rings have to enclose the corners of
polygons inside the set, and to stay within polygons around it."""

from __future__ import annotations

import math
from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise

from minkref import _core
from minkref.disc.closed import Step

CHORDS = 64  # of an arc
SLACK = 1e-9  # of the size
Spot = tuple[float, float]


def misplaced(
    rings: list[list[Step]], inner: _core.PolygonSet, outer: _core.PolygonSet
) -> Iterator[str]:
    """List corners of the polygons inside that the rings leave out, and points halfway along the
    rings' steps outside of the polygons around. Places as near to a ring as chords to arcs are
    skipped."""
    chords = [chord for ring in rings for step in ring for chord in pairwise(points_of(step))]
    radii = [math.dist(step[1:3], step[5:7]) for ring in rings for step in ring if step[0] == "arc"]
    near = max(radii, default=0.0) * (1 - math.cos(math.pi / CHORDS))
    for ring in (ring for polygon in inner.rings() for ring in polygon):
        for corner in ring:
            spot = (float(corner[0]), float(corner[1]))
            slack = near + SLACK * (1 + abs(spot[0]) + abs(spot[1]))
            if is_left_out(spot, chords, slack):
                yield f"{spot} is left out"
    for step in (step for ring in rings for step in ring):
        points = points_of(step)
        x, y = points[len(points) // 2] if step[0] == "arc" else middle(*points)
        size = SLACK * (1 + abs(x) + abs(y))
        beside = [(x + k * size, y + m * size) for k in (-1, 0, 1) for m in (-1, 0, 1)]
        if not any((Fraction(p), Fraction(q)) in outer for p, q in beside):
            yield f"({x}, {y}) lies outside"


def middle(a: Spot, b: Spot) -> Spot:
    return (a[0] + b[0]) / 2, (a[1] + b[1]) / 2


def points_of(step: Step) -> list[Spot]:
    """Return both ends, and points of an arc between; arcs run counter-clockwise."""
    kind, x0, y0, x1, y1, cx, cy = step
    if kind != "arc":
        return [(x0, y0), (x1, y1)]
    start, end = math.atan2(y0 - cy, x0 - cx), math.atan2(y1 - cy, x1 - cx)
    turn = (end - start) % (2 * math.pi)
    radius = math.hypot(x0 - cx, y0 - cy)
    angles = [start + turn * k / CHORDS for k in range(1, CHORDS)]
    between = [(cx + radius * math.cos(a), cy + radius * math.sin(a)) for a in angles]
    return [(x0, y0), *between, (x1, y1)]


def is_left_out(spot: Spot, chords: list[tuple[Spot, Spot]], slack: float) -> bool:
    """Sum the angles under which the chords are seen; nothing is told next to a chord."""
    total = 0.0
    for (ax, ay), (bx, by) in chords:
        ux, uy, vx, vy = ax - spot[0], ay - spot[1], bx - spot[0], by - spot[1]
        across, along = ux * vy - uy * vx, ux * vx + uy * vy
        if abs(across) <= slack * math.hypot(vx - ux, vy - uy) and along <= slack**2:
            return False
        if min(math.hypot(ux, uy), math.hypot(vx, vy)) <= slack:
            return False
        total += math.atan2(across, along)
    return round(total / (2 * math.pi)) == 0
