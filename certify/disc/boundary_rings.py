"""Pieces of a boundary as simple rings, by components."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Callable, Sequence
from typing import Any

from minkref.certify.disc.curve_walk import BoundaryPiece
from minkref.certify.disc.joint_places import Near
from minkref.certify.plane.certificate import NoProof

AWAY = 1e-6  # of an angle: corners turn right, or not at all


def components(
    pieces: Sequence[BoundaryPiece], class_of: Callable[[int], object]
) -> list[list[list[int]]]:
    """Rings as numbers of pieces: the outer ring of a component, then its holes. `class_of`: the
    same for edges of one component."""
    found: dict[object, list[list[int]]] = defaultdict(list)
    for ring in _simple(pieces):
        own = found[class_of(pieces[ring[0]].curve.n)]
        if _area([pieces[k] for k in ring]) > 0:
            own.insert(0, ring)
        else:
            own.append(ring)
    return list(found.values())


def _simple(pieces: Sequence[BoundaryPiece]) -> list[list[int]]:
    """Closed walks, split where one passes a key twice."""
    leaving: dict[Any, list[int]] = defaultdict(list)
    for k, piece in enumerate(pieces):
        leaving[piece.start].append(k)
    left, rings = set(range(len(pieces))), list[list[int]]()
    while left:
        walk = [min(left)]
        while True:
            left.discard(walk[-1])
            after = _next(pieces, leaving, walk[-1])
            if after not in left:
                break
            walk.append(after)
        rings += _split(pieces, walk)
    return rings


def _split(pieces: Sequence[BoundaryPiece], walk: list[int]) -> list[list[int]]:
    rings, open_ = list[list[int]](), list[int]()
    for k in walk:
        open_.append(k)
        starts = [pieces[j].start for j in open_]
        if pieces[k].end in starts:
            first = starts.index(pieces[k].end)
            rings.append(open_[first:])
            del open_[first:]
    if open_:
        raise NoProof("pieces of the boundary do not close up")
    return rings


def _next(pieces: Sequence[BoundaryPiece], leaving: dict[Any, list[int]], k: int) -> int:
    """The piece that bounds the same wedge of the interior: the first one clockwise from the way
    back, at half a turn or more."""
    choice = leaving[pieces[k].end]
    if not choice:
        raise NoProof("pieces of the boundary do not close up")
    back = _angle(pieces[k].to) + math.pi

    def turn(j: int) -> float:
        angle = (back - _angle(pieces[j].from_)) % (2 * math.pi)
        return angle if angle > math.pi - AWAY else angle + 2 * math.pi

    return min(choice, key=turn)


def _angle(way: Near) -> float:
    size = max(map(abs, way))
    return math.atan2(float(way[1] / size), float(way[0] / size))


def _area(ring: Sequence[BoundaryPiece]) -> float:
    """The signed area, in squares of the radius."""
    radius = ring[0].curve.radius
    x, y = ring[0].middle
    total = 0.0
    for piece in ring:
        a, b = ((float((p[0] - x) / radius), float((p[1] - y) / radius)) for p in piece.tips)
        total += (a[0] * b[1] - a[1] * b[0]) / 2
        if piece.curve.is_arc:
            angle = (_angle(piece.to) - _angle(piece.from_)) % (2 * math.pi)
            total += (angle - math.sin(angle)) / 2
    return total
