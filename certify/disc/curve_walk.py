"""Walks along offset curves, as certificates have them: places, and what lies between."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from dataclasses import dataclass
from decimal import Decimal
from typing import Any

from minkref.certify.disc.joint_places import JointPlace, Near
from minkref.certify.disc.offset_curve import Interval, OffsetCurve, Spot
from minkref.certify.plane.certificate import NoProof

Key = Any  # a joint's number; the edge, and whether an arc: a curve that goes on at an end


class Joints:
    """Places by number; places nearer than the grid are one."""

    def __init__(self, grid: Decimal) -> None:
        self.places: list[JointPlace] = []
        self._grid, self._cells = grid, dict[tuple[int, int], int]()

    def number(self, spot: Spot) -> int:
        x, y = (int((c / self._grid).to_integral_value()) for c in spot.at)
        for i in (0, -1, 1):
            for j in (0, -1, 1):
                if (x + i, y + j) in self._cells:
                    return self._cells[x + i, y + j]
        self._cells[x, y] = len(self.places)
        self.places.append(spot.exact)
        return len(self.places) - 1


@dataclass(frozen=True)
class BoundaryPiece:
    """A free part of a curve, from key to key, with its directions there."""

    start: Key
    end: Key
    curve: OffsetCurve
    from_: Near
    to: Near


@dataclass(frozen=True)
class _Cut:
    position: Decimal
    value: int | None  # a joint; none: the curve's own end
    key: Key


class CurveWalk:
    """One curve's walk: `entries` for the certificate, `pieces` of the boundary."""

    def __init__(self, curve: OffsetCurve, joints: Joints, keys: tuple[Key, Key]) -> None:
        self.curve, self.pieces = curve, list[BoundaryPiece]()
        cuts = self._cuts(joints, keys)
        self.entries: list[Any] = [cuts[0].value]
        for x, y in itertools.pairwise(cuts):
            self.entries += [*self._between(x, y), y.value]

    def _cuts(self, joints: Joints, keys: tuple[Key, Key]) -> list[_Cut]:
        """The ends, and places at the radius that no edge blocks."""
        curve, slack = self.curve, self.curve.slack
        first, last = curve.ends
        found = [_Cut(first, None, keys[0]), _Cut(last, None, keys[1])]
        for spot in sorted(curve.spots, key=lambda one: one.position):
            at = spot.position
            if not first - slack <= at <= last + slack:
                continue
            if any(part.holds(at, slack) for part in curve.intervals if not part.facing):
                continue
            number = joints.number(spot)
            cut = _Cut(at, number, number)
            if abs(at - first) <= slack:
                found[0] = cut
            elif abs(at - last) <= slack:
                found[-1] = cut
            elif found[-2].value != number:
                found.insert(-1, cut)
        return found

    def _between(self, x: _Cut, y: _Cut) -> Iterator[Any]:
        """Links and places between two cuts."""
        curve = self.curve
        middle = (x.position + y.position) / 2
        over = [part for part in curve.intervals if part.holds(middle, Decimal(0))]
        blocking = [part for part in over if not part.facing]
        two = x.value is not None and y.value is not None
        if blocking:
            yield from self._covered(x, y, two)
            return
        link: Any = [over[0].edge] if over else "free"
        yield link
        if two:
            yield curve.station(x.position, y.position)
            yield link
        if not over:
            tangents = (curve.tangent(curve.point(cut.position)) for cut in (x, y))
            self.pieces.append(BoundaryPiece(x.key, y.key, curve, *tangents))

    def _covered(self, x: _Cut, y: _Cut, two: bool) -> Iterator[Any]:
        slack = self.curve.slack
        parts = [part for part in self.curve.intervals if not part.facing]
        at = x.position
        current = max((p for p in parts if p.low <= at + slack), key=lambda p: p.high)
        yield current.edge
        while current.high < y.position - slack:
            nexts = [p for p in parts if p.low < current.high - slack and p.high > current.high]
            if not nexts:
                raise NoProof("places of the boundary are too near to each other")
            best: Interval = max(nexts, key=lambda p: p.high)
            low, high = max(best.low, at), min(current.high, y.position)
            yield self.curve.station(low, high)
            yield best.edge
            at, current, two = high, best, False
        whole = current.low >= x.position - slack and current.high <= y.position + slack
        if two or whole:  # a checker wants a place that is nearer than the radius
            yield self.curve.station(max(current.low, at), min(current.high, y.position))
            yield current.edge
