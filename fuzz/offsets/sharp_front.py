"""A set whose sides move outward, or inward, at unit speed, so that its corners stay sharp.

Each vertex lies where the moved lines of its two sides meet. Until a side vanishes or a vertex
reaches another side (a *meeting*), the moved rings bound the only answer: that of a straight
skeleton, and that of mitres without limit. From a meeting on these differ, and one law is left that
all of them keep: a point within the radius of the set is swept, since no part of the boundary moves
slower than at unit speed.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, lru_cache
from itertools import combinations, pairwise

import minkref
from minkref import _core
from minkref.fuzz.geometry.plane import dot, minus
from minkref.fuzz.offsets.asked_offset import AskedOffset
from minkref.fuzz.offsets.distance import exact
from minkref.fuzz.offsets.lines import Place
from minkref.fuzz.offsets.normals import right_of, unit

NEAR = Fraction(1, 1 << 20)  # of the time: nearly a meeting counts as one


@dataclass(frozen=True)
class Side:
    """`way`: its direction; `normal`: where it goes. Both ends with the ways that they move."""

    way: Place
    normal: Place
    start: Place
    end: Place
    start_moves: Place
    end_moves: Place


@dataclass(frozen=True)
class SharpFront:
    """`polygons`: outer rings counter-clockwise, each with its holes, clockwise."""

    polygons: tuple[tuple[tuple[Place, ...], ...], ...]
    inward: bool

    @cached_property
    def sides(self) -> list[list[list[Side]]]:
        """The sides of each ring of each polygon, the k-th beginning at the k-th vertex."""
        return [[list(self._of(ring)) for ring in rings] for rings in self.polygons]

    def _of(self, ring: tuple[Place, ...]) -> Iterator[Side]:
        ways = [unit(minus(b, a)) for a, b in pairwise([*ring, ring[0]])]
        normals = [right_of(way) for way in ways]
        if self.inward:
            normals = [(-x, -y) for x, y in normals]
        moves = []
        for k, n in enumerate(normals):
            m = normals[k - 1]
            share = 1 + dot(n, m)
            moves.append(((n[0] + m[0]) / share, (n[1] + m[1]) / share))
        for k, (a, b) in enumerate(pairwise([*ring, ring[0]])):
            yield Side(ways[k], normals[k], a, b, moves[k], moves[(k + 1) % len(ring)])

    @cached_property
    def meeting(self) -> Fraction | None:
        """The time of the first meeting, nearly; None if there is none. O(n^2)."""
        sides = [side for rings in self.sides for ring in rings for side in ring]
        if len({side.start for side in sides}) < len(sides):
            return Fraction(0)  # rings touch
        times = [time for side in sides if (time := _end_of(side)) is not None]
        for one, other in combinations(sides, 2):
            for side, far in ((one, other), (other, one)):
                if far.start not in (side.start, side.end):
                    time = _reached(side, far.start, far.start_moves)
                    times += [] if time is None else [time]
        return min(times, default=None)

    def at(self, time: Fraction) -> _core.PolygonSet:
        """The set at a time before the first meeting; vertices are off by 2^-60 of the time."""
        moved = [
            [[_moved(s.start, s.start_moves, time) for s in ring] for ring in rings]
            for rings in self.sides
        ]
        return minkref.PolygonSet(moved)

    def is_free(self, time: Fraction) -> bool:
        """Whether the first meeting is later, clearly."""
        return self.meeting is None or self.meeting > time * (1 + NEAR)


def _moved(place: Place, way: Place, time: Fraction) -> Place:
    return (place[0] + time * way[0], place[1] + time * way[1])


def _end_of(side: Side) -> Fraction | None:
    """When a side has lost its length."""
    loss = -dot(side.way, minus(side.end_moves, side.start_moves))
    return dot(side.way, minus(side.end, side.start)) / loss if loss > 0 else None


def _reached(side: Side, place: Place, way: Place) -> Fraction | None:
    """When a moving point comes to a moving side, or nearly to an end."""
    ahead, nearer = dot(side.normal, minus(place, side.start)), 1 - dot(side.normal, way)
    if nearer == 0:
        return None
    time = ahead / nearer
    if time < 0:
        return None
    here = _moved(place, way, time)
    start = _moved(side.start, side.start_moves, time)
    end = _moved(side.end, side.end_moves, time)
    slack = NEAR * (time + dot(side.way, minus(side.end, side.start)))
    on = dot(side.way, minus(here, start)) >= -slack and dot(side.way, minus(end, here)) >= -slack
    return time if on else None


@lru_cache(8)
def front_of(case: AskedOffset) -> SharpFront:
    """The front of a case's set."""
    polygons = tuple(
        tuple(tuple(exact(p) for p in ring) for ring in polygon) for polygon in case.shape
    )
    return SharpFront(polygons, case.inward)


def is_free(case: AskedOffset, half: Fraction) -> bool:
    """Whether no two parts meet until the radius and a tolerance more."""
    return front_of(case).is_free(abs(case.radius) + half)
