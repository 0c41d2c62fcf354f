"""Pieces of a boundary as simple rings, by components."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Callable, Sequence
from decimal import Decimal
from typing import Any

from minkref.certify.disc.curve_walk import BoundaryPiece
from minkref.certify.disc.joint_places import Near
from minkref.certify.disc.near_edge import cross, dot
from minkref.certify.plane.certificate import NoProof


def components(
    pieces: Sequence[BoundaryPiece], class_of: Callable[[int], object], same: Decimal
) -> list[list[list[int]]]:
    """Rings as numbers of pieces: the outer ring of a component, then its holes. `class_of`: the
    same for edges of one component. `same`: a smaller sine of a corner is taken for zero."""
    found: dict[object, list[list[int]]] = defaultdict(list)
    for ring in _simple(pieces, same):
        own = found[class_of(pieces[ring[0]].curve.n)]
        if _turn([pieces[k] for k in ring]) > 0:
            own.insert(0, ring)
        else:
            own.append(ring)
    return list(found.values())


def _simple(pieces: Sequence[BoundaryPiece], same: Decimal) -> list[list[int]]:
    """Closed walks, split where one passes a key twice."""
    leaving: dict[Any, list[int]] = defaultdict(list)
    for k, piece in enumerate(pieces):
        leaving[piece.start].append(k)
    left, rings = set(range(len(pieces))), list[list[int]]()
    while left:
        walk = [min(left)]
        while True:
            left.discard(walk[-1])
            after = _next(pieces, leaving[pieces[walk[-1]].end], walk[-1], same)
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


def _next(pieces: Sequence[BoundaryPiece], choice: list[int], k: int, same: Decimal) -> int:
    """The piece that bounds the same wedge of the interior: the first one clockwise from the way
    back, at half a turn or more."""
    if not choice:
        raise NoProof("pieces of the boundary do not close up")
    to = pieces[k].to

    def to_the_right(j: int) -> Decimal:
        """Grows with the angle by which piece j turns right, from 0 to 2; left turns follow."""
        way = pieces[j].from_
        long = (dot(to, to) * dot(way, way)).sqrt()
        return 1 - dot(to, way) / long if cross(to, way) <= same * long else 3 + dot(to, way) / long

    return min(choice, key=to_the_right)


def _angle(way: Near) -> float:
    size = max(map(abs, way))
    return math.atan2(float(way[1] / size), float(way[0] / size))


def _turn(ring: Sequence[BoundaryPiece]) -> float:
    """By how much a ring turns left, 2π or -2π: arcs by less than half a turn, corners to the right
    by half a turn at most, so that rounding decides nothing."""
    total, last = 0.0, ring[-1]
    for piece in ring:
        turns = [(_angle(piece.from_) - _angle(last.to), math.pi / 2)]
        if piece.curve.is_arc:
            turns.append((_angle(piece.to) - _angle(piece.from_), 3 * math.pi / 2))
        for turn, most in turns:
            turn %= 2 * math.pi
            total += turn if turn < most else turn - 2 * math.pi
        last = piece
    return total
