"""A point of each hole of a set grown by a disc, or of each component of a set eroded by one, as
the reference draws the boundaries: what is looked for lies to the right of them."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from fractions import Fraction

from minkref import _core
from minkref.fuzz.offsets.distance import Distances, Exact

Piece = tuple[str, float, float, float, float, float, float, float]
Spot = tuple[float, float]
Place = tuple[Fraction, Fraction]
STEPS = 40
ON_ARC = 8  # points of a rounded arc


def far_points(
    grown: _core.Offset, near: Distances, radius: Fraction, outer: bool = False
) -> list[Exact]:
    """Finds a point farther than a radius in each hole, or `outer` ring of an erosion, exactly."""
    found = (
        next((x for x in places if near.of(x).square > radius**2), None)
        for places in places_in_rings(grown, outer)
    )
    return [point for point in found if point is not None]


def places_in_rings(grown: _core.Offset, outer: bool = False) -> list[list[Place]]:
    """Some places for each hole, or `outer` ring of an erosion, by doubles in a frame about as
    large as the ring, those farthest from a piece first; the caller measures distances. None serves
    only if what the ring bounds is thinner than doubles tell."""
    if not (grown.components if outer else grown.holes):
        return []
    return [
        _in_frame_of(grown, ring, (i, j))
        for i, rings in enumerate(grown.drawn_rings())
        for j, ring in enumerate(rings)
        if (j == 0) == outer
    ]


def _in_frame_of(
    grown: _core.Offset, ring: Sequence[Piece], number: tuple[int, int]
) -> list[Place]:
    """Measures the ring again from a corner, in units near its size."""
    origin = (Fraction(ring[0][1]), Fraction(ring[0][2]))
    x0, y0 = ring[0][1], ring[0][2]
    size = max(max(abs(x - x0), abs(y - y0)) for _, x, y, *_ in ring)
    factor = Fraction(1) if size <= 0 else Fraction(2) ** -math.frexp(size)[1]
    i, j = number
    near = grown.drawn_rings((str(origin[0]), str(origin[1])), str(factor))[i][j]
    path = [spot for piece in near for spot in _path(piece)]
    found = sorted(_candidates(near), key=lambda one: -one[0])
    inner = [spot for _, spot in found if _is_in(spot, path)]
    return [(origin[0] + Fraction(x) / factor, origin[1] + Fraction(y) / factor) for x, y in inner]


def _candidates(ring: Sequence[Piece]) -> Iterator[tuple[float, Spot]]:
    for kind, x0, y0, x1, y1, cx, cy, _ in ring:
        length = math.hypot(x1 - x0, y1 - y0) or 1e-300
        nx, ny = (y1 - y0) / length, (x0 - x1) / length
        x, y = (x0 + x1) / 2, (y0 + y1) / 2
        if kind == "arc":
            radius = math.hypot(x0 - cx, y0 - cy)
            x, y = cx + radius * nx, cy + radius * ny
        for k in range(STEPS):
            step = length / 2**k
            yield step, (x + step * nx, y + step * ny)


def _path(piece: Piece) -> Iterator[Spot]:
    kind, x0, y0, x1, y1, cx, cy, _ = piece
    if kind != "arc":
        yield (x0, y0)
        return
    radius = math.hypot(x0 - cx, y0 - cy)
    first = math.atan2(y0 - cy, x0 - cx)
    turn = (math.atan2(y1 - cy, x1 - cx) - first) % math.tau
    for k in range(ON_ARC):
        angle = first + turn * k / ON_ARC
        yield (cx + radius * math.cos(angle), cy + radius * math.sin(angle))


def _is_in(spot: Spot, path: Sequence[Spot]) -> bool:
    x, y = spot
    inside = False
    for (ax, ay), (bx, by) in zip(path, [*path[1:], path[0]], strict=True):
        if (ay > y) != (by > y) and ax + (y - ay) / (by - ay) * (bx - ax) > x:
            inside = not inside
    return inside
