"""Ways out of a place, the scales at which they are free, and directions in which their ends go on
for ever (docs/certificates-paths.md)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from minkref import _core
from minkref.certify.convex_cells import Place
from minkref.certify.free_ways import FreeCells
from minkref.certify.moving_parts import Pair, Vector
from minkref.certify.scale_cells import ALL, Cut, common, cuts
from minkref.path_values import valid_scales
from minkref.scale_ranges import ScaleRange

AXES = ((-1, 0), (1, 0), (0, -1), (0, 1))


@dataclass(frozen=True)
class Escape:
    """At these scales a way is free, and its end may go on along the normal."""

    way: list[Place]
    normal: Vector
    scales: ScaleRange


class Escapes:
    """Of a part R among obstacles O. Exact."""

    def __init__(
        self, pair: Pair, sets: tuple[_core.PolygonSet, _core.PolygonSet], at: Place, contact: str
    ) -> None:
        self.pair, self.sets, self.at, self.contact = pair, sets, at, contact
        part, walls = pair.R, pair.O
        self._normals = [*AXES]
        if part.hulls and walls.hulls:
            self._normals = list(dict.fromkeys([*AXES, *pair.directions(part.root, walls.root)]))

    def from_cut(self, s: Fraction, reach: Cut, contact: str) -> Escape | None:
        """A way out found at a scale, at which contact is allowed or forbidden as told, and the
        range of scales from a cut on at which it is one. None where there is none, or the sum has
        too many corners."""
        found = self._best([self.at], reach)
        if found is not None:
            return found
        try:
            way = FreeCells(*self.sets, s, contact, self.at).way(self.at)
        except OverflowError:
            return None
        return None if way is None else self._best(self._shortened(way, s, contact), reach)

    def _best(self, way: list[Place], reach: Cut) -> Escape | None:
        """The escape that holds longest from a cut on, of those that leave the way earliest."""
        for k in range(len(way)):
            found = [self._leaving(way[: k + 1], normal, reach) for normal in self._normals]
            good = [one for one in found if one is not None]
            if good:
                return max(good, key=lambda one: cuts(one.scales)[1])
        return None

    def _leaving(self, way: list[Place], normal: Vector, reach: Cut) -> Escape | None:
        """Along a normal. Where the end of a way is not beyond all that collides at scales at which
        it is free, it goes on."""
        exits = self._exits(way[-1], normal)
        if exits is None or not _begins(exits, reach):
            return None
        free = self._free(way, reach)
        if free is None:
            return None
        scales = common(free, exits)
        if free.high is not None and cuts(exits)[1] < cuts(free)[1]:
            farther = [*way, self._beyond(way[-1], normal, free.high)]
            again, far = self._free(farther, reach), self._exits(farther[-1], normal)
            if again is not None and far is not None:
                way, scales = farther, common(again, far)
        if scales is None or not _begins(scales, reach):
            return None
        return Escape(way, normal, scales)

    def _free(self, way: Sequence[Place], reach: Cut) -> ScaleRange | None:
        """The range of scales from a cut on at which no place of a way collides."""
        found = valid_scales(*self.sets, way, self.contact)
        return next((one for one in found.ranges if _begins(one, reach)), None)

    def _level(self, place: Place, normal: Vector) -> tuple[Fraction, Fraction]:
        """How far a place is beyond all that collides: constant, and times s."""
        part, walls, unit = self.pair.R, self.pair.O, self.pair.unit
        most = Fraction(walls.most(walls.root, normal), unit)
        least = -Fraction(part.most(part.root, (-normal[0], -normal[1])), unit)
        return normal[0] * place[0] + normal[1] * place[1] - most, least

    def _exits(self, place: Place, normal: Vector) -> ScaleRange | None:
        """The scales at which a place is beyond all that collides across a normal."""
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

    def _beyond(self, place: Place, normal: Vector, s: Fraction) -> Place:
        """On along a normal, to where a place is beyond all that collides at a scale."""
        c, d = self._level(place, normal)
        missing = -(c + s * d) + 1
        part = missing / (normal[0] ** 2 + normal[1] ** 2)
        return place[0] + part * normal[0], place[1] + part * normal[1]

    def _shortened(self, way: list[Place], s: Fraction, contact: str) -> list[Place]:
        """Without the corners that may be left out at all scales at which the way is free."""
        found = valid_scales(*self.sets, way, contact)
        free = next((one for one in found.ranges if s in one), None)
        if free is None:
            return way
        low = free.low if free.low > 0 else s / 2
        high = free.high if free.high is not None else 2 * s
        short = [way[0]]
        k = 0
        while k < len(way) - 1:
            for j in range(len(way) - 1, k, -1):
                if j == k + 1 or self._is_free(way[k], way[j], (low, high), contact):
                    short.append(way[j])
                    k = j
                    break
        return short

    def _is_free(
        self, start: Place, end: Place, scales: tuple[Fraction, Fraction], contact: str
    ) -> bool:
        """At all scales strictly between two, or at one."""
        found = valid_scales(*self.sets, [start, end], contact, *scales).ranges
        return any(one.low <= scales[0] and one.high == scales[1] for one in found)


def _begins(scales: ScaleRange, reach: Cut) -> bool:
    """Whether a range goes on from a cut."""
    low, high = cuts(scales)
    return bool(low <= reach < high)
