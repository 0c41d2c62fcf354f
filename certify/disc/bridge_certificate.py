"""Produces certificates for bridges (docs/certificates-features.md). Only checkers are trusted."""

from __future__ import annotations

import json
import math
from collections import Counter
from collections.abc import Iterable, Sequence
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.certify.case_text import disc_head, places, ring_numbers
from minkref.certify.plane.certificate import NoProof

FORM = "feature-certificate-v1"
DENOMINATORS = 1_000_000  # of the places of events
FEWEST = 1e-11  # of the size: a box is larger, since centres come as doubles
Spot = tuple[float, float]
Named = tuple[str, int]


class BridgeCertificate:
    """Claims about equal discs outside P: bridges, and discs touching more features. Exact;
    doubles, in units of the size, choose boxes. `declined` counts reasons against claims: a disc
    nearly touches a third feature, doubles do not tell its place, rings touch at an end. O(n) for
    each bridge."""

    def __init__(self, P: _core.PolygonSet, radius: Fraction) -> None:
        """`radius`: half of alpha. Validates P."""
        P.validate("P")
        self.P, self.radius = P, radius
        self.claims: list[dict[str, Any]] = []
        self.declined: Counter[str] = Counter()
        self._at = places(P)
        x, y = self._at[0] if self._at else (Fraction(0), Fraction(0))
        self._origin = x, y
        far = max((abs(c) for p, q in self._at for c in (p - x, q - y)), default=Fraction(0))
        self._unit = two_to_the(far or Fraction(1))
        self._spots = [(self._in_units(p - x), self._in_units(q - y)) for p, q in self._at]
        self._rings = ring_numbers(P)
        self._next = {n: r[(k + 1) % len(r)] for r in self._rings for k, n in enumerate(r)}
        self._last = {j: i for i, j in self._next.items()}

    def bridges(self, features: _core.Features) -> int:
        """Claims all bridges; returns how many claims exist."""
        for _, _, _, _, rows in features.at(str(2 * self.radius)):
            for _, left, _, right, centre in rows:
                try:
                    named = self._named(left), self._named(right)
                    self._bridge(*named, (centre[2], centre[3]))
                except NoProof as error:
                    self.declined[str(error)] += 1
        return len(self.claims)

    def touches(self) -> int:
        """Claims events at this radius whose place is rational, denominators up to DENOMINATORS;
        returns how many claims exist."""
        events = _core.diagram_events(self.P)
        for _, square, _, _, near, features in events.rows(0, len(events)):
            if square is None or Fraction(square) != self.radius**2:
                continue
            try:
                named = sorted({self._named(feature) for feature in features})
            except NoProof as error:
                self.declined[str(error)] += 1
                continue
            place = self._rational(near, named)
            if place is None:
                self.declined["the place of an event is not rational"] += 1
                continue
            named = sorted({*named, *self._ends(place, named)})
            self.claims.append({"claim": "touch", "centre": [str(x) for x in place],
                                "features": [list(each) for each in named]})  # fmt: skip
        return len(self.claims)

    def _ends(self, place: tuple[Fraction, Fraction], named: Sequence[Named]) -> list[Named]:
        """Vertices as near, at ends of named edges."""
        ends = {end for kind, n in named if kind == "edge" for end in (n, self._next[n])}
        square = self.radius**2
        return [
            ("vertex", n)
            for n in ends
            if (self._at[n][0] - place[0]) ** 2 + (self._at[n][1] - place[1]) ** 2 == square
        ]

    def _rational(self, near: Spot, named: Sequence[Named]) -> tuple[Fraction, Fraction] | None:
        """The place near a double, if it is as far from all features as the radius."""
        if not all(map(math.isfinite, near)):
            return None
        x, y = (Fraction(c).limit_denominator(DENOMINATORS) for c in near)
        for kind, n in named:
            (ax, ay), (bx, by) = self._at[n], self._at[self._next[n]]
            far, length = (x - ax) ** 2 + (y - ay) ** 2, Fraction(1)
            if kind == "edge":
                far = ((x - ax) * (by - ay) - (y - ay) * (bx - ax)) ** 2
                length = (bx - ax) ** 2 + (by - ay) ** 2
            if far != self.radius**2 * length:
                return None
        return x, y

    def _named(self, feature: Sequence[str]) -> Named:
        kind, first, second = feature
        if kind == "edge":
            return kind, self._rings[int(first)][int(second)]
        place = (Fraction(first), Fraction(second))
        if self._at.count(place) > 1:
            raise NoProof("a bridge ends where rings touch")
        return kind, self._at.index(place)

    def _bridge(self, left: Named, right: Named, near: Spot) -> None:
        """A box around the centre: its sides are level lines of both distances, nearly."""
        try:
            centre = (
                self._in_units(Fraction(near[0]) - self._origin[0]),
                self._in_units(Fraction(near[1]) - self._origin[1]),
            )
            one, other = self._way(left, centre), self._way(right, centre)
            sine = one[0] * other[1] - one[1] * other[0]
            radius = self._in_units(self.radius)
            room = min(self._room(left, right, centre, radius), radius)
            half = min(room * abs(sine), radius * sine * sine) / 16
            off = self._in_units(Fraction(math.ulp(near[0])) + Fraction(math.ulp(near[1])))
            if half < max(FEWEST, off):
                raise NoProof("the disc of a bridge nearly touches a third feature")
            step = 2.0 ** math.floor(math.log2(half))
            u = other[1] / sine * step, -other[0] / sine * step  # along it only one distance grows
            w = -one[1] / sine * step, one[0] / sine * step
        except ArithmeticError as error:  # beyond doubles, or an edge too short for them
            raise NoProof("doubles do not tell the place of a bridge") from error
        sides = [[Fraction(c) * self._unit for c in way] for way in (u, w)]
        corner = [Fraction(c) - a - b for c, a, b in zip(near, *sides, strict=True)]
        box = [[str(c) for c in corner], *([str(2 * c) for c in way] for way in sides)]
        self.claims.append(
            {"claim": "bridge", "left": list(left), "right": list(right), "box": box}
        )

    def _in_units(self, x: Fraction) -> float:
        return float(x / self._unit)

    def _way(self, feature: Named, centre: Spot) -> Spot:
        """The direction from the foot to the centre."""
        kind, n = feature
        a = self._spots[n]
        if kind == "vertex":
            way = centre[0] - a[0], centre[1] - a[1]
        else:
            b = self._spots[self._next[n]]
            way = b[1] - a[1], a[0] - b[0]
        far = math.hypot(*way)
        return way[0] / far, way[1] / far

    def _room(self, left: Named, right: Named, centre: Spot, radius: float) -> float:
        """How far the centre may move, by all edges."""
        own: set[int] = set()
        room = math.inf
        for kind, n in (left, right):
            edges = (n,) if kind == "edge" else (self._last[n], n)
            own.update(edges)
            for k in edges:
                room = min(room, *self._beyond(k, centre, kind == "edge", k == n))
        for n in self._next.keys() - own:
            room = min(room, self._distance(n, centre) - radius)
        return room

    def _beyond(self, n: int, p: Spot, is_edge: bool, is_first: bool) -> Iterable[float]:
        """How far a point lies inside both end perpendiculars, or outside one."""
        a, b = self._spots[n], self._spots[self._next[n]]
        dx, dy = b[0] - a[0], b[1] - a[1]
        long = math.hypot(dx, dy)
        over = ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / long
        if is_edge:
            return over, long - over
        return (-over if is_first else over - long,)

    def _distance(self, n: int, p: Spot) -> float:
        a, b = self._spots[n], self._spots[self._next[n]]
        dx, dy = b[0] - a[0], b[1] - a[1]
        square = dx * dx + dy * dy
        t = ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / square if square else 0.0
        t = min(max(t, 0.0), 1.0)
        return math.hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy)

    def case(self) -> str:
        """The case file's text."""
        return f'{{"P":{self.P.to_json()}}}\n'

    def text(self, case: str, title: str = "", producer: str = "") -> str:
        """The certificate; `case`: its case file's relative path."""
        head = disc_head(FORM, self.P, self.radius**2, case, title, producer)
        return json.dumps({**head, "claims": self.claims}, indent=1) + "\n"


def two_to_the(size: Fraction) -> Fraction:
    """A power of two between half of a positive number and twice that."""
    return Fraction(2) ** (size.numerator.bit_length() - size.denominator.bit_length())
