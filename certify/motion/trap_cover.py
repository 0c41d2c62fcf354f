"""Rings and ways out, one after another, until they cover all scales of a range."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from math import inf
from typing import Any

from minkref import _core
from minkref.certify.motion.convex_cells import Place
from minkref.certify.motion.escapes import Escape, Escapes
from minkref.certify.motion.moving_parts import Pair, stays
from minkref.certify.motion.moving_ways import MovingWays, WayAt
from minkref.certify.motion.rings import Ring, Rings
from minkref.certify.motion.scale_cells import Cut, between, cuts
from minkref.certify.motion.search_time import OutOfTime, SearchTime
from minkref.certify.plane.certificate import NoProof
from minkref.certify.simplest import simplest_between
from minkref.motion.scale_ranges import ScaleRange

MOST_ATTEMPTS = 24  # to find a ring that holds just above a scale
MOST_CLAIMS = 100
MOST_IN_A_ROW = 6  # ways out that do not move, before events part the scales
SECONDS = 20.0

RingAt = tuple[ScaleRange, dict[str, Any]]
#: Where ways out have to reach, and the one that goes on there, if it is known.
Goal = tuple[Cut, WayAt | None]


class TrapCover:
    """Finds rings and ways out for a part R among obstacles O, around one place. Each method takes
    a range of scales at which the place is free. Exact. Raises NoProof if the search does not end
    within SECONDS of processor time, or MOST_CLAIMS claims."""

    def __init__(
        self, pair: Pair, sets: tuple[_core.PolygonSet, _core.PolygonSet], at: Place, contact: str
    ) -> None:
        self._pair, self._sets, self._at, self._contact = pair, sets, at, contact
        self._closed = contact == "forbidden"
        self._time = SearchTime(SECONDS)
        self._rings = Rings(pair, at, not self._closed, self._time.spend)
        self._escapes = Escapes(pair, sets, at, contact, self._time.spend)

    def rings(self, scales: ScaleRange) -> list[RingAt]:
        """Returns consecutive ranges, each with the members `ring` and `pairs` for a claim."""
        found: list[RingAt] = []
        reach, end = cuts(scales)
        try:
            while reach < end and len(found) < MOST_CLAIMS:
                tried = (self._ring_at(s, reach, end, found) for s in _candidates(reach, end))
                high = next((one for one in tried if one is not None and reach < one), None)
                if high is None:
                    break
                reach = high
        except OutOfTime:
            pass
        if reach < end:
            raise _no_proof("no ring around the place was found", scales, reach)
        return found

    def _ring_at(self, s: Fraction, reach: Cut, end: Cut, found: list[RingAt]) -> Cut | None:
        """Adds what a ring at a scale proves from a cut on, and says how far."""
        ring = self._rings.around(s)
        if ring is None:
            return None
        low, high = self._cuts(ring)
        if not low <= reach:
            return None
        high = _simple(max(reach, (s, True)), high, end)
        # Corners move from end to end: a corner inside both sets at s stays inside.
        first = None if reach == (s, False) else between(reach, min((s, True), high))
        last = between(max(reach, (s, first is not None)), high)
        for part in (first, last):
            if part is not None:
                found.append((part, self._rings.members(ring, part)))
        return high

    def ways(self, scales: ScaleRange) -> list[WayAt]:
        """Returns consecutive ranges, each with a way out and the direction in which the way goes
        on. Ways that stay come first; where a door shuts or opens, or such ways advance slowly,
        others move with the scale."""
        found: list[WayAt] = []
        reach, end = cuts(scales)
        goals: list[Goal] = [(end, None)]
        moving = MovingWays(
            self._pair, self._sets, self._at, self._contact, scales, self._time.spend
        )
        try:
            self._follow(reach, goals, moving, found)
        except OutOfTime:
            pass
        if goals:
            reach = cuts(found[-1][0])[1] if found else reach
            raise _no_proof("no way out was found", scales, reach)
        return found

    def _follow(
        self, reach: Cut, goals: list[Goal], moving: MovingWays, found: list[WayAt]
    ) -> None:
        """Adds ways out until no goal is left, or none is found."""
        tried: set[Cut] = set()  # goals up to which a moving way was looked for
        in_a_row = 0
        while goals and len(found) < MOST_CLAIMS:
            goal, known = goals[-1]
            if known is not None and reach >= goal:
                found.append(known)
                reach = cuts(known[0])[1]
            if reach >= goal:
                goals.pop()
                in_a_row = 0
                continue
            one = self._staying(reach, goal, known is not None)
            if one is None or cuts(one[0])[1] < goal:
                if known is None and goal not in tried:
                    tried.add(goal)
                    last = moving.up_to(reach, goal)
                    if last is not None:
                        goals.append((max(reach, cuts(last[0])[0]), last))
                        continue
                event = moving.next_event(reach) if in_a_row >= MOST_IN_A_ROW else None
                if event is not None:
                    nearer = [cut for cut in ((event, True), (event, False)) if cut < goal]
                    goals += [(cut, None) for cut in nearer]
                    in_a_row = 0
                    if nearer:
                        continue
                one = one or moving.on_from(reach, goal)
            if one is None:
                return
            in_a_row += 1
            found.append(one)
            reach = cuts(one[0])[1]

    def _staying(self, reach: Cut, end: Cut, is_free: bool) -> WayAt | None:
        """Returns the longest lasting among a few ways that do not move, from a cut on. `is_free`:
        a way out exists at the end, also if the end does not belong to the scales."""
        best: Escape | None = None
        for s in _few(reach, (end[0], end[1] or is_free)):
            one = self._escapes.from_cut(s, reach, end)
            if one is not None and (best is None or _last(one) > _last(best)):
                best = one
            if best is not None and _last(best) >= end:
                break
        if best is None:
            return None
        part = between(reach, _simple(reach, _last(best), end))
        return None if part is None else (part, [*map(stays, best.way)], best.normal)

    def _cuts(self, ring: Ring) -> tuple[Cut, Cut]:
        low: Cut = (ring.low, not (self._closed and ring.low > 0))
        return low, (inf, False) if ring.high is None else (ring.high, self._closed)


def _no_proof(what: str, scales: ScaleRange, reach: Cut) -> NoProof:
    """The error: nothing was found from a cut on; all scales of the range up to it are proven."""
    low, end = cuts(scales)
    where = f"at all scales above {_short(reach[0])}"
    if end[0] != inf and (reach[0] - low[0]) * 8 > (end[0] - low[0]) * 7:
        where = f"at all scales just below {end[0]}"
    told = f"{what} that proves the answer {where}, in {SECONDS:g} s and {MOST_CLAIMS} claims"
    mend = "leave out --certify"
    if reach[0] > low[0]:
        first = (low[0] + 7 * Fraction(reach[0])) / 8
        most = simplest_between(first, first + (Fraction(reach[0]) - first) / 2)
        mend = f"give --to {most}, up to which it is proven, or leave out --certify"
    return NoProof(told, mend)


def _short(scale: Fraction) -> str:
    """A scale as a message has it."""
    text = str(scale)
    return text if len(text) <= 20 else f"{float(scale):.6g}"


def _last(escape: Escape) -> Cut:
    return cuts(escape.scales)[1]


def _simple(low: Cut, high: Cut, end: Cut) -> Cut:
    """The end, or a cut before `high` with a scale of few digits."""
    if high >= end:
        return end
    if high[0] == inf or high[0] <= low[0]:
        return high
    return simplest_between((low[0] + 7 * high[0]) / 8, Fraction(high[0])), False


def _few(reach: Cut, end: Cut) -> Sequence[Fraction]:
    """The last and the first scale between two cuts, if they belong to the range, and a scale with
    few digits between them."""
    low, found = Fraction(reach[0]), []
    high = 2 * low + 1 if end[0] == inf else Fraction(end[0])
    if end[0] != inf and end[1]:
        found.append(high)
    if low > 0 and not reach[1]:
        found.append(low)
    if low < high:
        third = (high - low) / 3
        found.append(simplest_between(low + third, high - third))
    return list(dict.fromkeys(found))


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
