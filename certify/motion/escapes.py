"""Ways out from a place, the scales at which each is free, and directions in which their ends go on
for ever (docs/certificates-paths.md)."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import inf

from minkref import _core
from minkref.certify.motion.convex_cells import Place
from minkref.certify.motion.free_ways import FreeCells
from minkref.certify.motion.moving_parts import Pair
from minkref.certify.motion.scale_cells import ALL, Cut, common, cuts
from minkref.certify.plane.piece_nodes import Vector
from minkref.motion.path_values import valid_scales
from minkref.motion.scale_ranges import ScaleRange

MOST_STEPS = 24  # up to so many, all steps along a way are tried
AXES = ((-1, 0), (1, 0), (0, -1), (0, 1))


@dataclass(frozen=True)
class Escape:
    """A way, free at these scales, whose end may go on along the normal."""

    way: list[Place]
    normal: Vector
    scales: ScaleRange


class Escapes:
    """Finds ways out for a part R among obstacles O. Exact. Calls `spend` between pieces of work;
    an exception from `spend` ends the work."""

    def __init__(
        self,
        pair: Pair,
        sets: tuple[_core.PolygonSet, _core.PolygonSet],
        at: Place,
        contact: str,
        spend: Callable[[], None],
    ) -> None:
        self.pair, self.sets, self.at, self.contact = pair, sets, at, contact
        self._spend = spend
        part, walls = pair.R, pair.O
        self._normals = [*AXES]
        if part.hulls and walls.hulls:
            self._normals = list(dict.fromkeys([*AXES, *pair.directions(part.root, walls.root)]))

    def from_cut(self, s: Fraction, reach: Cut, end: Cut) -> Escape | None:
        """Returns a way out found at a scale, and the range of scales, from a cut on towards
        another, at which the way leads out. None if no way exists, or the sum has too many
        corners."""
        found = self._best([self.at], reach, end)
        if found is not None and cuts(found.scales)[1] >= end:
            return found
        try:
            way = FreeCells(*self.sets, s, self.contact, self.at).way(self.at)
        except OverflowError:
            return found
        if way is not None:
            other = self._best(self._shortened(way, s), reach, end)
            both = [one for one in (found, other) if one is not None]
            return max(both, key=lambda one: cuts(one.scales)[1], default=None)
        return found

    def _best(self, way: list[Place], reach: Cut, end: Cut) -> Escape | None:
        """Returns the escape that holds longest from a cut on; among equals, the escape that leaves
        the way earliest."""
        best: Escape | None = None
        for k in range(len(way)):
            free = self._free(way[: k + 1], reach)
            if free is None:
                break
            for normal in self._normals:
                found = self._leaving(way[: k + 1], normal, free, reach, end)
                if found is None or (best and cuts(found.scales)[1] <= cuts(best.scales)[1]):
                    continue
                best = found
                if cuts(best.scales)[1] >= end:
                    return best
        return best

    def _leaving(
        self, way: list[Place], normal: Vector, free: ScaleRange, reach: Cut, end: Cut
    ) -> Escape | None:
        """Leaves along a normal: from the way's end at once, or after going on, straight or along
        the normal, to a place beyond everything that collides at all scales at which the way is
        free."""
        found: list[Escape] = []
        exits = self._exits(way[-1], normal)
        if exits is not None:
            found += self._if_it_begins(way, normal, common(free, exits), reach)
        last = min(cuts(free)[1], end)[0]
        if last == inf or (found and cuts(found[0].scales)[1] >= (last, False)):
            return found[0] if found else None
        ways_on: list[Sequence[Fraction | int]] = [normal, *_straight_on(way, normal)]
        for along in ways_on:
            farther = [*way, self._beyond(way[-1], normal, along, (reach[0], Fraction(last)))]
            again, far = self._free(farther, reach), self._exits(farther[-1], normal)
            if again is not None and far is not None:
                found += self._if_it_begins(farther, normal, common(again, far), reach)
        return max(found, key=lambda one: cuts(one.scales)[1], default=None)

    def _if_it_begins(
        self, way: list[Place], normal: Vector, scales: ScaleRange | None, reach: Cut
    ) -> list[Escape]:
        if scales is None or not _begins(scales, reach):
            return []
        return [Escape(way, normal, scales)]

    def _free(self, way: Sequence[Place], reach: Cut) -> ScaleRange | None:
        """Returns the range of scales from a cut on at which no place on a way collides."""
        self._spend()
        found = valid_scales(*self.sets, way, self.contact)
        return next((one for one in found.ranges if _begins(one, reach)), None)

    def _level(self, place: Place, normal: Vector) -> tuple[Fraction, Fraction]:
        """How far a place is beyond all that collides: constant, and times s."""
        part, walls, unit = self.pair.R, self.pair.O, self.pair.unit
        most = Fraction(walls.most(walls.root, normal), unit)
        least = -Fraction(part.most(part.root, (-normal[0], -normal[1])), unit)
        return normal[0] * place[0] + normal[1] * place[1] - most, least

    def _exits(self, place: Place, normal: Vector) -> ScaleRange | None:
        """Returns the scales at which a place lies beyond everything that collides, across a
        normal."""
        if not (self.pair.R.hulls and self.pair.O.hulls):
            return ALL
        c, d = self._level(place, normal)
        weak = self.contact == "allowed"
        if d == 0:
            good = c > 0 or (c == 0 and weak)
            return ALL if good else None
        root = -c / d
        if d > 0:
            is_in = weak and root > 0
            return ScaleRange(max(root, Fraction(0)), None, is_in, False)
        return ScaleRange(Fraction(0), root, False, weak) if root > 0 else None

    def _beyond(
        self,
        place: Place,
        normal: Vector,
        along: Sequence[Fraction | int],
        scales: tuple[Fraction, Fraction],
    ) -> Place:
        """On along a direction, to where a place is beyond all that collides across a normal at two
        scales, and so between."""
        c, d = self._level(place, normal)
        missing = max(1 - (c + s * d) for s in scales)
        part = max(missing, Fraction(0)) / (normal[0] * along[0] + normal[1] * along[1])
        return place[0] + part * along[0], place[1] + part * along[1]

    def _shortened(self, way: list[Place], s: Fraction) -> list[Place]:
        """Drops corners without which the way stays free at all scales of its range."""
        found = valid_scales(*self.sets, way, self.contact)
        free = next((one for one in found.ranges if s in one), None)
        if free is None:
            return way
        low = free.low if free.low > 0 else s / 2
        high = free.high if free.high is not None else 2 * s
        short = [way[0]]
        k = 0
        while k < len(way) - 1:
            for j in _steps(k, len(way) - 1):
                if j == k + 1 or self._is_free(way[k], way[j], (low, high)):
                    short.append(way[j])
                    k = j
                    break
        return short

    def _is_free(self, start: Place, end: Place, scales: tuple[Fraction, Fraction]) -> bool:
        """At all scales strictly between two, or at one."""
        self._spend()
        found = valid_scales(*self.sets, [start, end], self.contact, *scales).ranges
        return any(one.low <= scales[0] and one.high == scales[1] for one in found)


def _steps(start: int, last: int) -> list[int]:
    """Numbers of the corners to go on to, the farthest first: all if few, else some."""
    if last - start <= MOST_STEPS:
        return list(range(last, start, -1))
    some = [start + (1 << power) for power in range((last - start).bit_length())]
    return [last, *reversed([k for k in some if k < last])]


def _straight_on(way: Sequence[Place], normal: Vector) -> list[Place]:
    """The direction of the last segment, if it leads across a normal."""
    if len(way) < 2:
        return []
    along = way[-1][0] - way[-2][0], way[-1][1] - way[-2][1]
    return [along] if along[0] * normal[0] + along[1] * normal[1] > 0 else []


def _begins(scales: ScaleRange, reach: Cut) -> bool:
    """Whether a range goes on from a cut."""
    low, high = cuts(scales)
    return bool(low <= reach < high)
