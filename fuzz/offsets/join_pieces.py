"""A set grown with joins and caps, as two unions of convex pieces: what every right answer has, and
what none goes beyond.

A side adds its rectangle. At a corner where the side turns away, the join adds a piece between two
rectangles: round a sector, mitred the kite between their outer sides, bevelled a triangle, squared
the kite cut at the radius, at right angles to its axis. A mitre beyond its limit is bevelled by
some libraries, and cut at the limit or at the radius by others: a triangle is due, and the kite cut
at the limit is allowed. A bevel may reach as far as a round join. An end adds nothing, a square, or
half a disc. Unit normals are rounded to 60 bits, and arcs to polygons inside what is due and around
what is allowed.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise

import minkref
from minkref import _core
from minkref.fuzz.geometry.plane import Shape, cross, dot, doubled_area, minus
from minkref.fuzz.offsets.asked_offset import AskedOffset
from minkref.fuzz.offsets.distance import exact
from minkref.fuzz.offsets.lines import Place
from minkref.fuzz.offsets.manner import BEVEL, MITRE, ROUND, SQUARE, Manner
from minkref.fuzz.offsets.normals import right_of, root_of, rounded, unit

Piece = list[Place]
HALVINGS = 4  # of a sector
WITHIN = 1 - Fraction(1, 5000)  # of the radius: the witness is checked with other polygons
CORNERS = 64  # of a disc
NEAR_LIMIT = Fraction(1, 1000)  # of a mitre's limit: on either side of it both answers serve
REVERSED = Fraction(1, 100)  # half the sum of two normals: the side nearly goes back


@dataclass(frozen=True)
class JoinPieces:
    """`reach`: the radius. `due`: pieces of what every answer has, else of what it may have."""

    reach: Fraction
    manner: Manner
    due: bool

    def of(self, case: AskedOffset) -> _core.PolygonSet:
        """The union of all pieces, with the set itself."""
        pieces = [piece for piece in self._all(case) if doubled_area(piece) != 0]
        own = [] if case.lines else [case.set]
        return minkref.unite([*own, *(_set_of(piece) for piece in pieces)])

    def _all(self, case: AskedOffset) -> Iterator[Piece]:
        if not case.lines:
            for polygon in case.shape:
                for ring in polygon:
                    yield from self._ring([exact(p) for p in ring])
        for line in case.lines:
            yield from self._line(line)

    def _ring(self, ring: Sequence[Place]) -> Iterator[Piece]:
        """The right side of a ring, where its outside is."""
        sides = [unit(minus(b, a)) for a, b in pairwise([*ring, ring[0]])]
        for k, (a, b) in enumerate(pairwise([*ring, ring[0]])):
            yield self._rectangle(a, b, right_of(sides[k]))
            yield from self._corner(a, sides[k - 1], sides[k])

    def _line(self, line: Sequence[Place]) -> Iterator[Piece]:
        """Both sides of a line, and its ends."""
        if len(line) == 1:
            yield _disc(line[0], self.reach, self.due)  # its cap is round
            return
        for way in (line, line[::-1]):
            sides = [unit(minus(b, a)) for a, b in pairwise(way)]
            for k, (a, b) in enumerate(pairwise(way)):
                yield self._rectangle(a, b, right_of(sides[k]))
                if k:
                    yield from self._corner(a, sides[k - 1], sides[k])
            yield from self._end(way[-1], sides[-1])

    def _at(self, place: Place, way: Place, factor: Fraction | int = 1) -> Place:
        by = self.reach * factor
        return (place[0] + by * way[0], place[1] + by * way[1])

    def _rectangle(self, a: Place, b: Place, n: Place) -> Piece:
        return [a, self._at(a, n), self._at(b, n), b]

    def _end(self, v: Place, d: Place) -> Iterator[Piece]:
        n = right_of(d)
        m = (-n[0], -n[1])
        if self.manner.cap == SQUARE:
            right, left = self._at(v, n), self._at(v, m)
            yield [right, self._at(right, d), self._at(left, d), left]
        elif self.manner.cap == ROUND:
            yield from self._sector(v, n, d)
            yield from self._sector(v, d, m)

    def _corner(self, v: Place, before: Place, after: Place) -> Iterator[Piece]:
        """The join on the right, between the sides that end and begin at v."""
        n, m = right_of(before), right_of(after)
        if not self.due and self.manner.join in (ROUND, BEVEL):
            yield _disc(v, self.reach, False)
            return
        turned = cross(before, after)
        if turned < 0 or (turned == 0 and dot(before, after) > 0):
            return
        half = ((n[0] + m[0]) / 2, (n[1] + m[1]) / 2)
        square = dot(half, half)
        if square < REVERSED**2:
            if not self.due:
                yield _disc(v, self.reach * (self.manner.limit or 2), False)
        elif self.manner.join == ROUND:
            yield from self._sector(v, n, m)
        else:
            yield self._pointed(v, n, m, half, square)

    def _pointed(self, v: Place, n: Place, m: Place, half: Place, square: Fraction) -> Piece:
        """A bevel, a kite, or a kite cut at right angles to its axis."""
        triangle: Piece = [v, self._at(v, n), self._at(v, m)]
        if self.manner.join == BEVEL:
            return triangle
        most = self.manner.limit if self.manner.join == MITRE else Fraction(1)
        assert most is not None
        if self.manner.join == MITRE:
            most *= 1 - NEAR_LIMIT if self.due else 1 + NEAR_LIMIT
            if self.due and 1 > most * most * square:
                return triangle
        tip = self._at(v, half, 1 / square)
        kite = [v, self._at(v, n), tip, self._at(v, m)]
        length = root_of(square)
        return _clipped(kite, half, dot(v, half) + most * self.reach * length)

    def _sector(self, v: Place, n: Place, m: Place) -> Iterator[Piece]:
        """Between two unit vectors less than half a turn apart, inside the circle."""
        if not self.due:
            yield _disc(v, self.reach, False)
            return
        ways = [n, m]
        for _ in range(HALVINGS):
            middles = [unit((a[0] + b[0], a[1] + b[1])) for a, b in pairwise(ways)]
            ways = [w for pair in zip(ways, middles, strict=False) for w in pair] + [m]
        yield [v, *(self._at(v, way, WITHIN) for way in ways)]


def is_plain(case: AskedOffset) -> bool:
    """Whether joins are judged: no side is shorter than a quarter of the radius, and no corner is
    nearly straight or nearly goes back. Libraries simplify such corners, as far as their tolerance
    lets them, and a mitre's tip moves further than that."""
    rings: list[list[Place]] = [[*line] for line in case.lines] or [
        [exact(p) for p in (*ring, *ring[:2])] for polygon in case.shape for ring in polygon
    ]
    for ring in rings:
        ways = [minus(b, a) for a, b in pairwise(ring)]
        if any(16 * dot(way, way) < case.radius**2 for way in ways):
            return False
        for a, b in pairwise(ways):
            turned, along = cross(a, b), dot(a, b)
            if turned == 0 and along > 0:
                continue
            if abs(turned) * 8 < abs(along) or (along < 0 and abs(turned) * 2 < -along):
                return False
    return True


def _disc(v: Place, radius: Fraction, inside: bool) -> Piece:
    far = radius * (WITHIN if inside else Fraction((1 + 1e-9) / math.cos(math.pi / CORNERS)))
    angles = [math.tau * k / CORNERS for k in range(CORNERS)]
    ways = [(rounded(Fraction(math.cos(a))), rounded(Fraction(math.sin(a)))) for a in angles]
    return [(v[0] + far * x, v[1] + far * y) for x, y in ways]


def _clipped(piece: Piece, way: Place, most: Fraction) -> Piece:
    """The part with `dot(x, way) <= most`."""
    found: Piece = []
    for a, b in pairwise([*piece, piece[0]]):
        p, q = dot(a, way) - most, dot(b, way) - most
        if p <= 0:
            found.append(a)
        if (p < 0 < q) or (q < 0 < p):
            t = p / (p - q)
            found.append((a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])))
    return found


def _set_of(piece: Piece) -> _core.PolygonSet:
    ring = piece if doubled_area(piece) > 0 else piece[::-1]
    shape: Shape = [[[*ring]]]
    return minkref.PolygonSet(shape[0][0])
