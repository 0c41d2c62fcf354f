"""Free places in trapezoids whose corners move with the scale, between two events, and ways through
them (docs/certificates-paths.md)."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Sequence
from fractions import Fraction
from itertools import pairwise
from typing import NamedTuple

from minkref.certify.motion.convex_cells import Place
from minkref.certify.motion.moving_parts import MovingPlace, Pair

#: None: far up, where the slope is what counts.
End = Fraction | None


class Linear(NamedTuple):
    """The number constant + s slope at the scale s."""

    constant: Fraction
    slope: Fraction

    def at(self, s: End) -> Fraction:
        return self.slope if s is None else self.constant + s * self.slope


class Line(NamedTuple):
    """The points (x, y) with y = steep x + offset."""

    steep: Fraction
    offset: Linear

    def over(self, x: Linear) -> Linear:
        constant, slope = (self.steep * u + v for u, v in zip(x, self.offset, strict=True))
        return Linear(constant, slope)


class Cell(NamedTuple):
    left: Linear
    right: Linear
    bottom: Line
    top: Line


class Station(NamedTuple):
    """A place on a way at a scale where the way is free, and at the other end of the way's scales.
    `inner`: in the middle of a cell, not on a vertical between two cells."""

    here: Place
    there: Place
    inner: bool


class MovingCells:
    """The free places at all scales between two, at which the rings of the boundary have no event
    and no two of their vertices, or the place, have one x. Exact. O(n^2) for n vertices."""

    def __init__(
        self, pair: Pair, rings: Iterable[Sequence[MovingPlace]], at: Place, scale: Fraction
    ) -> None:
        """`scale`: a scale between the two events."""
        self.at, self.scale = at, scale
        left, right, self._bottom, self._top = _box(pair, at)
        self._edges = [edge for ring in rings for edge in _edges(ring, scale)]
        stops = {x for one, other, _ in self._edges for x in (one, other)}
        stops |= {left, right, Linear(at[0], Fraction(0))}
        self._stops = sorted(stops, key=lambda x: x.at(scale))
        self.cells: list[Cell] = []
        self._next: dict[int, list[int]] = {}
        self._add_cells()

    def channel(self) -> list[int] | None:
        """Returns the cells along a way from the place to the left of everything that collides."""
        start = [k for k, cell in enumerate(self.cells) if self._holds(cell)]
        before: dict[int, int | None] = dict.fromkeys(start)
        queue = deque(start)
        while queue and 0 not in before:
            i = queue.popleft()
            for j in self._next.get(i, []):
                if j not in before:
                    before[j] = i
                    queue.append(j)
        if 0 not in before:
            return None
        found = [0]
        while (earlier := before[found[-1]]) is not None:
            found.append(earlier)
        return found[::-1]

    def stations(self, channel: Sequence[int], here: Fraction, there: End) -> list[Station]:
        """Returns a way through cells, from one scale to another, or for ever. While the cells stay
        as `here`, the way is free at all scales between, and also at `there`, except where a
        passage shuts."""
        found = [Station(self.at, self.at if there is not None else (Fraction(0),) * 2, False)]
        entry = Linear(self.at[0], Fraction(0))
        for i, j in [*pairwise(channel), (channel[-1], None)]:
            cell = self.cells[i]
            leaves = None if j is None else _common_vertical(cell, self.cells[j])
            width = [cell.right.at(s) - cell.left.at(s) for s in (here, there)]
            if leaves is None or leaves == entry or min(width) <= 0:
                found.append(Station(_centre(cell, here), _centre(cell, there), True))
            if j is not None and leaves is not None:
                both = cell, self.cells[j]
                places = [_joint(*both, leaves, s) for s in (here, there)]
                found.append(Station(places[0], places[1], False))
                entry = leaves
        return found

    def _holds(self, cell: Cell) -> bool:
        """Whether the place lies on a vertical side of a cell."""
        x = Linear(self.at[0], Fraction(0))
        if x not in (cell.left, cell.right):
            return False
        low, high = (line.over(x).at(self.scale) for line in (cell.bottom, cell.top))
        return low < self.at[1] < high

    def _add_cells(self) -> None:
        numbers = {x: k for k, x in enumerate(self._stops)}
        rows: list[list[Line]] = [[] for _ in self._stops]
        for one, other, line in self._edges:
            for k in range(*sorted((numbers[one], numbers[other]))):
                rows[k].append(line)
        before: list[int] = []
        for k, (left, right) in enumerate(pairwise(self._stops)):
            ends = left.at(self.scale), right.at(self.scale)
            heights = [
                (2 * line.offset.at(self.scale) + line.steep * sum(ends), line) for line in rows[k]
            ]
            lines = [self._bottom, *(line for _, line in sorted(heights)), self._top]
            here = []
            for bottom, top in zip(lines[::2], lines[1::2], strict=True):
                here.append(len(self.cells))
                self.cells.append(Cell(left, right, bottom, top))
            self._join(before, here, left)
            before = here

    def _join(self, before: Sequence[int], here: Sequence[int], x: Linear) -> None:
        """Joins cells on both sides of a vertical, each listed upwards, that share a part of the
        vertical."""
        i = j = 0
        while i < len(before) and j < len(here):
            one, other = self.cells[before[i]], self.cells[here[j]]
            low, high = _common(one, other, x, self.scale)
            if low < high:
                self._next.setdefault(before[i], []).append(here[j])
                self._next.setdefault(here[j], []).append(before[i])
            if one.top.over(x).at(self.scale) == high:
                i += 1
            else:
                j += 1


def steady(
    numbers: Iterable[Linear], low: Fraction, high: End, at_end: bool
) -> tuple[Fraction, End]:
    """Returns the largest range of scales from `low` on, or up to `high` (`at_end`), at which no
    two different numbers are equal, within [low, high]. Exact."""

    def key(x: Linear) -> tuple[Fraction, Fraction]:
        if not at_end:
            return x.at(low), x.slope
        return (x.slope, x.constant) if high is None else (x.at(high), -x.slope)

    # The first two numbers to meet are neighbours.
    for x, y in pairwise(sorted(set(numbers), key=key)):
        if x.slope == y.slope:
            continue
        s = (y.constant - x.constant) / (x.slope - y.slope)
        if low < s and (high is None or s < high):
            low, high = (s, high) if at_end else (low, s)
    return low, high


def xs_of(rings: Iterable[Sequence[MovingPlace]]) -> list[Linear]:
    return [Linear(v[0], v[1]) for ring in rings for v in ring]


def moving(stations: Sequence[Station], here: Fraction, there: End) -> list[MovingPlace]:
    """Returns a way's places, moving from their positions at one scale to their positions at the
    other. Where the direction between two stations changes, one more place follows: in the convex
    hull of both stations at both scales, and as free as the inner station."""
    path = [stations[0]]
    for end in stations[1:]:
        start = path[-1]
        first = end.here[0] - start.here[0], end.here[1] - start.here[1]
        last = end.there[0] - start.there[0], end.there[1] - start.there[1]
        turns = first[0] * last[1] != first[1] * last[0]
        if turns or first[0] * last[0] + first[1] * last[1] < 0:
            one, other = (start, end) if start.inner else (end, start)
            path.append(Station(one.here, other.there, True))
        path.append(end)
    return [_through(station, here, there) for station in path]


def _through(station: Station, here: Fraction, there: End) -> MovingPlace:
    found: list[Fraction] = []
    for a, b in zip(station.here, station.there, strict=True):
        slope = b if there is None else (b - a) / (there - here)
        found += [a - here * slope, slope]
    return found[0], found[1], found[2], found[3]


def _edges(ring: Sequence[MovingPlace], scale: Fraction) -> list[tuple[Linear, Linear, Line]]:
    """Returns both ends' x, and the line, for each edge that is not vertical."""
    found = []
    for a, b in zip(ring, [*ring[1:], *ring[:1]], strict=True):
        one, other = Linear(*a[:2]), Linear(*b[:2])
        if one != other:
            rise = Linear(*b[2:]).at(scale) - Linear(*a[2:]).at(scale)
            steep = rise / (other.at(scale) - one.at(scale))
            offset = Linear(a[2] - steep * a[0], a[3] - steep * a[1])
            found.append((one, other, Line(steep, offset)))
    return found


def _box(pair: Pair, at: Place) -> tuple[Linear, Linear, Line, Line]:
    """Verticals to the left and the right, lines below and above a place and all that collides, at
    all scales."""
    part, walls = pair.R, pair.O
    found = []
    for x, y in ((-1, 0), (1, 0), (0, -1), (0, 1)):
        far = Fraction(walls.most(walls.root, (x, y)), pair.unit)
        grows = Fraction(part.most(part.root, (-x, -y)), pair.unit)
        sign = x + y
        beyond = max(far, x * at[0] + y * at[1]) + 1
        found.append(Linear(sign * beyond, sign * max(grows, Fraction(0))))
    left, right, bottom, top = found
    return left, right, Line(Fraction(0), bottom), Line(Fraction(0), top)


def _common(one: Cell, other: Cell, x: Linear, s: End) -> tuple[Fraction, Fraction]:
    """Returns the bounds of the common part of two cells on both sides of a vertical."""
    low = max(cell.bottom.over(x).at(s) for cell in (one, other))
    return low, min(cell.top.over(x).at(s) for cell in (one, other))


def _joint(one: Cell, other: Cell, x: Linear, s: End) -> Place:
    low, high = _common(one, other, x, s)
    return x.at(s), (low + high) / 2


def _common_vertical(one: Cell, other: Cell) -> Linear:
    return one.right if one.right == other.left else one.left


def _centre(cell: Cell, s: End) -> Place:
    heights = [line.over(x).at(s) for line in cell[2:] for x in cell[:2]]
    return (cell.left.at(s) + cell.right.at(s)) / 2, sum(heights, Fraction(0)) / 4
