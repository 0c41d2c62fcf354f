"""Ways out that move with the scale: up to, or from, a scale at which a door shuts or opens
(docs/certificates-paths.md)."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from functools import cached_property
from itertools import pairwise
from math import inf

from minkref import _core
from minkref.certify.motion.clearance import Clearance, Collision, TooLong
from minkref.certify.motion.convex_cells import Place
from minkref.certify.motion.moving_cells import (
    End,
    Linear,
    MovingCells,
    Station,
    moving,
    steady,
    xs_of,
)
from minkref.certify.motion.moving_parts import MovingPlace, MovingWay, Pair
from minkref.certify.motion.scale_cells import Cut, between, left_of
from minkref.certify.plane.piece_nodes import Vector
from minkref.certify.simplest import simplest_between
from minkref.motion.scale_ranges import ScaleRange

MOST_EDGES = 40_000  # at most: a convolution's edges, vertices of one set times the other's
MOST_VERTICES = 600  # on the boundary
MOST_STEPS = 12  # up to so many, all steps along a way are tried
LEFT: Vector = (-1, 0)

WayAt = tuple[ScaleRange, list[MovingPlace], Vector]


class MovingWays:
    """Finds ways out for a part R among obstacles O from one place, at scales in a range. Exact.
    Calls `spend` between pieces of work; an exception from `spend` ends the work."""

    def __init__(
        self,
        pair: Pair,
        sets: tuple[_core.PolygonSet, _core.PolygonSet],
        at: Place,
        contact: str,
        scales: ScaleRange,
        spend: Callable[[], None],
    ) -> None:
        self._pair, self._sets, self._at, self._contact = pair, sets, at, contact
        self._scales, self._spend = scales, spend

    def up_to(self, reach: Cut, end: Cut) -> WayAt | None:
        """Returns a way that is free up to a cut, from another cut on if possible, else from a
        scale between, which belongs to the way's scales. None if no way exists or the work is too
        much."""
        high = None if end[0] == inf else Fraction(end[0])
        found = self._cells_beside(high, True)
        if found is None:
            return None
        cells, low = found
        first = Fraction(reach[0])
        anchors = dict.fromkeys(
            (first, (3 * first + cells.scale) / 4, max(low, first), cells.scale)
        )
        for here in anchors:
            start = reach if here == first else (here, False)
            if start < end:
                way = self._way(cells, here, high, between(start, end))
                if way is not None:
                    return way
        return None

    def on_from(self, reach: Cut, end: Cut) -> WayAt | None:
        """A way that is free from just above a scale on, to the end or at least to a scale between,
        which belongs to its scales."""
        low = Fraction(reach[0])
        found = self._cells_beside(low, False)
        if found is None:
            return None
        cells, _ = found
        scale = cells.scale if end[0] == inf else min(cells.scale, (low + Fraction(end[0])) / 2)
        return self._way(cells, scale, low, between(reach, min((scale, True), end)))

    def next_event(self, reach: Cut) -> Fraction | None:
        """The least scale above a cut at which the boundary of the sum has an event."""
        if self._index is None:
            return None
        k = bisect_right(self._events, reach[0])
        return self._events[k] if k < len(self._events) else None

    @cached_property
    def _index(self) -> _core.ScaleIndex | None:
        part, obstacles = self._sets
        if len(self._pair.R.points) * len(self._pair.O.points) > MOST_EDGES:
            return None
        low, high = self._scales.low, self._scales.high
        window = (str(low) if low > 0 else None), (None if high is None else str(high))
        return _core.ScaleIndex(part.scaled("-1"), obstacles, *window)

    @cached_property
    def _events(self) -> list[Fraction]:
        return [] if self._index is None else self._index.event_scales()

    @cached_property
    def _tracks(self) -> list[MovingPlace]:
        assert self._index is not None
        rows = ((map(Fraction, a), map(Fraction, b)) for a, b in self._index.tracks())
        return [(x, u, y, v) for (x, y), (u, v) in rows]

    def _cells_beside(self, scale: End, below: bool) -> tuple[MovingCells, Fraction] | None:
        """Returns the cells just below a scale, or just above, and the scale from which on they
        keep their shape."""
        if self._index is None:
            return None
        low, high = self._between_events(scale, below)
        rings = self._rings(low + 1 if high is None else (low + high) / 2)
        if sum(map(len, rings)) > MOST_VERTICES:
            return None
        numbers = [*xs_of(rings), Linear(self._at[0], Fraction(0))]
        low, high = steady(numbers, low, high, below)
        inside = low + 1 if high is None else _within(low, high)
        self._spend()
        return MovingCells(self._pair, rings, self._at, inside), low

    def _between_events(self, scale: End, below: bool) -> tuple[Fraction, End]:
        events = self._events
        if scale is None:
            return (events[-1] if events else self._scales.low), None
        k = bisect_left(events, scale) if below else bisect_right(events, scale)
        low = events[k - 1] if k else self._scales.low
        high = events[k] if k < len(events) else self._scales.high
        return (low, scale) if below else (scale, high)

    def _rings(self, scale: Fraction) -> list[list[MovingPlace]]:
        assert self._index is not None
        found = self._index.rings(str(scale), "track")
        tracks = [self._tracks[k] for k in found.tracks]
        ends = [0, *map(int, found.ring_ends)]
        return [tracks[i:j] for i, j in pairwise(ends)]

    def _way(
        self, cells: MovingCells, here: Fraction, there: End, scales: ScaleRange | None
    ) -> WayAt | None:
        """Returns a way in the cells, from one scale to another; None if not free at all the
        scales."""
        channel = cells.channel()
        if channel is None or scales is None:
            return None
        stations = cells.stations(channel, here, there)
        free = _FreeWays(self._pair, scales, self._contact, (here, there), self._spend)
        short = free.shortened(stations)
        if short is None:
            return None
        path = moving(short, here, there)
        return (scales, path, LEFT) if free.leaves(path[-1], LEFT) else None


class _FreeWays:
    """Ways between two scales, tested for being free at all scales of a range."""

    def __init__(
        self,
        pair: Pair,
        scales: ScaleRange,
        contact: str,
        ends: tuple[Fraction, End],
        spend: Callable[[], None],
    ) -> None:
        self.pair, self.scales, self.contact, self.ends = pair, scales, contact, ends
        self._spend = spend

    def shortened(self, stations: Sequence[Station]) -> list[Station] | None:
        """Without stations that may be left out."""
        short, k, last = [stations[0]], 0, len(stations) - 1
        while k < last:
            steps = (j for j in _steps(k, last) if self._is_free(stations[k], stations[j]))
            k = next(steps, -1)
            if k < 0:
                return None
            short.append(stations[k])
        return short

    def leaves(self, place: MovingPlace, normal: Vector) -> bool:
        """Whether a place lies beyond everything that collides, across a normal, at all scales."""
        part, walls = self.pair.R, self.pair.O
        way = MovingWay(self.pair, place, place, self.scales)
        gap = way.gap(normal, part.root, walls.root)
        return not left_of(way.cell(self.scales), gap, self.scales, self.contact)

    def _is_free(self, start: Station, end: Station) -> bool:
        self._spend()
        path = moving([start, end], *self.ends)
        clearance = Clearance(self.pair, self.scales, self.contact)
        try:
            for one, other in pairwise(path):
                clearance.code(MovingWay(self.pair, one, other, self.scales))
        except (Collision, TooLong, ValueError):
            return False
        return True


def _steps(start: int, last: int) -> Iterator[int]:
    """Numbers of the stations to go on to, the farthest first: all if few, else some."""
    if last - start <= MOST_STEPS:
        yield from range(last, start, -1)
        return
    some = [start + (1 << power) for power in range((last - start).bit_length())]
    yield from [last, *reversed([k for k in some if k < last])]


def _within(low: Fraction, high: Fraction) -> Fraction:
    """A scale of few digits between two."""
    third = (high - low) / 3
    return simplest_between(low + third, high - third)
