"""Judges openings and closings by a disc: polygons inside and around, which know no diagram; areas
within the drawn rings; counts of rings."""

from __future__ import annotations

import math
from fractions import Fraction

from minkref import _core
from minkref.disc.closed import (
    DiscClosing,
    Step,
    closed_by_disc,
    closing_near,
    opened_by_disc,
    opening_near,
)
from minkref.disc.disc import read_disc
from minkref.fuzz.judges.disc.enclosed_places import misplaced
from minkref.fuzz.judges.disc.insets import inset_case

SHARE = 16  # of the radius, for polygons
Counted = tuple[int, list[str]]


def closing_faults(seed: int, index: int) -> Counted:
    """Compare both operations on a drawn set, at a drawn radius or at an event; count, and list
    faults."""
    P, square, _ = inset_case(seed, index)
    compared, faults = 0, []
    for name, find in (("opening", opened_by_disc), ("closing", closed_by_disc)):
        found = find(P, square, "P", 1)
        compared += 1
        faults += [f"{name}:{seed}:{index}: {fault}" for fault in faults_of(P, square, name, found)]
    return compared, faults


def faults_of(P: _core.PolygonSet, square: str, name: str, found: DiscClosing) -> list[str]:
    """Judge one result."""
    faults = []
    disc = read_disc(f"disc:sqrt:{square}")
    within = disc.bounds(20)[0] / SHARE
    near = opening_near if name == "opening" else closing_near
    bounds = [near(P, disc, within, way) for way in (False, True)]
    inner, outer = (float(Fraction(one.area())) for one in bounds)
    low, high = found.area
    slack = 1e-9 * max(outer, 1e-9)
    if not inner - slack <= high or not low <= outer + slack:
        faults.append(f"the area {low} is not within {inner} and {outer}")
    drawn = abs(sum(ring_area(ring) for ring in found.rings))
    if abs(drawn - low) > 1e-7 * max(low, outer):
        faults.append(f"the rings enclose {drawn}, not {low}")
    own = float(Fraction(P.area()))
    if (low > own + slack) if name == "opening" else (high < own - slack):
        faults.append("the set grows or shrinks the wrong way")
    faults += misplaced(found.rings, bounds[0], bounds[1])
    rings = found.components + found.holes
    if is_apart(found) and len(found.rings) != rings:
        faults.append(f"{len(found.rings)} rings, not {rings}")
    return faults


def ring_area(ring: list[Step]) -> float:
    """The signed area: chords, and the segments between chord and arc."""
    total = 0.0
    for kind, x0, y0, x1, y1, cx, cy in ring:
        total += (x0 - ring[0][1]) * (y1 - ring[0][2]) - (y0 - ring[0][2]) * (x1 - ring[0][1])
        if kind == "arc":
            across = (x0 - cx) * (y1 - cy) - (y0 - cy) * (x1 - cx)
            along = (x0 - cx) * (x1 - cx) + (y0 - cy) * (y1 - cy)
            angle = math.atan2(across, along) % (2 * math.pi)  # half a turn may be rounded
            total += angle * math.hypot(x0 - cx, y0 - cy) ** 2 - across
    return total / 2


def is_apart(found: DiscClosing) -> bool:
    """Tell whether no two rings' ends are nearly the same point, and none lies on a line."""
    points = [(step[1], step[2]) for ring in found.rings for step in ring]
    size = max((abs(c) for point in points for c in point), default=1.0) * 1e-9
    keys = {(round(x / size), round(y / size)) for x, y in points}
    return len(keys) == len(points) and not any(
        _is_inside(point, step, size) for point in points for ring in found.rings for step in ring
    )


def _is_inside(point: tuple[float, float], step: Step, size: float) -> bool:
    kind, x0, y0, x1, y1, *_ = step
    if kind == "arc" or point in ((x0, y0), (x1, y1)):
        return False
    dx, dy = x1 - x0, y1 - y0
    length = math.hypot(dx, dy)
    along = (point[0] - x0) * dx + (point[1] - y0) * dy
    across = abs((point[0] - x0) * dy - (point[1] - y0) * dx)
    return 0 <= along <= length**2 and across <= size * length
