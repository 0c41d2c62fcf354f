"""Rings and ways out, one after the other, until all scales of a range are told of."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction
from math import inf
from typing import Any

from minkref import _core
from minkref.certify.certificate import NoProof
from minkref.certify.convex_cells import Place
from minkref.certify.escapes import Escape, Escapes
from minkref.certify.moving_parts import Pair, Vector
from minkref.certify.rings import Ring, Rings
from minkref.certify.scale_cells import Cut, between, cuts
from minkref.certify.simplest import simplest_between
from minkref.scale_ranges import ScaleRange

MOST_ATTEMPTS = 24  # to find what holds just above a scale
MOST_CLAIMS = 100
FEW = 4

RingAt = tuple[ScaleRange, dict[str, Any]]
WayAt = tuple[ScaleRange, list[Place], Vector]


class TrapCover:
    """Of a part R among obstacles O, about one place. Each method takes a range of scales at which
    the place is free. Exact. Raises NoProof where it comes to no end."""

    def __init__(
        self, pair: Pair, sets: tuple[_core.PolygonSet, _core.PolygonSet], at: Place, contact: str
    ) -> None:
        self._contact, self._closed = contact, contact == "forbidden"
        self._rings = Rings(pair, at, not self._closed)
        self._escapes = Escapes(pair, sets, at, contact)

    def rings(self, scales: ScaleRange) -> list[RingAt]:
        """Ranges that follow each other, and the members `ring` and `pairs` of a claim."""
        found: list[RingAt] = []

        def add(reach: Cut, end: Cut) -> Cut | None:
            tried = (add_at(s, reach, end) for s in _candidates(reach, end))
            return next((one for one in tried if one is not None and reach < one), None)

        def add_at(s: Fraction, reach: Cut, end: Cut) -> Cut | None:
            ring = self._rings.around(s)
            if ring is None:
                return None
            low, high = self._cuts(ring)
            if not low <= reach:
                return None
            high = _simple(max(reach, (s, True)), high, end)
            # Corners move from end to end: they are inside of both sets if they are so at s.
            first = None if reach == (s, False) else between(reach, min((s, True), high))
            last = between(max(reach, (s, first is not None)), high)
            for part in (first, last):
                if part is not None:
                    found.append((part, self._rings.members(ring, part)))
            return high

        self._follow(scales, add)
        return found

    def ways(self, scales: ScaleRange) -> list[WayAt]:
        """Ranges that follow each other, a way out, and the direction in which it goes on."""
        found: list[WayAt] = []

        def add(reach: Cut, end: Cut) -> Cut | None:
            best = self._longest_escape(reach, end)
            if best is None:
                return None
            high = _simple(reach, cuts(best.scales)[1], end)
            part = between(reach, high)
            if part is not None:
                found.append((part, best.way, best.normal))
            return high

        self._follow(scales, add)
        return found

    def _longest_escape(self, reach: Cut, end: Cut) -> Escape | None:
        """Of the first few scales at which a way is looked for. What only touches at one may have
        room just beside it."""
        best: Escape | None = None
        for number, s in enumerate(_candidates(reach, end), 1):
            for contact in dict.fromkeys((self._contact, "allowed")):
                one = self._escapes.from_cut(s, reach, end, contact)
                if one is not None and (best is None or _last(one) > _last(best)):
                    best = one
                if best is not None and _last(best) >= end:
                    return best
            if best is not None and number >= FEW:
                break
        return best

    def _cuts(self, ring: Ring) -> tuple[Cut, Cut]:
        low: Cut = (ring.low, not (self._closed and ring.low > 0))
        return low, (inf, False) if ring.high is None else (ring.high, self._closed)

    def _follow(self, scales: ScaleRange, add: Callable[[Cut, Cut], Cut | None]) -> None:
        reach, end = cuts(scales)
        for _ in range(MOST_CLAIMS):
            if not reach < end:
                return
            high = add(reach, end)
            if high is None or not reach < high:
                break
            reach = high
        raise NoProof(f"no ring or way out was found for all scales above {reach[0]}")


def _last(escape: Escape) -> Cut:
    return cuts(escape.scales)[1]


def _simple(low: Cut, high: Cut, end: Cut) -> Cut:
    """The end, or a cut before `high` with a scale of few digits."""
    if high >= end:
        return end
    if high[0] == inf or high[0] <= low[0]:
        return high
    return simplest_between((low[0] + 7 * high[0]) / 8, Fraction(high[0])), False


def _candidates(reach: Cut, end: Cut) -> Iterator[Fraction]:
    """The last scale, the first, and others nearer and nearer to the first."""
    low = Fraction(reach[0])
    high = 2 * low + 1 if end[0] == inf else Fraction(end[0])
    if end[0] != inf:
        yield high
    if low > 0:
        yield low
    step = (high - low) / 2
    for _ in range(MOST_ATTEMPTS if high > low else 0):
        yield simplest_between(low + step / 2, low + step)
        step /= 4
