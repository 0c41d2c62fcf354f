"""The exterior medial axis as a graph: parts between places, reflex ends and infinity."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cmp_to_key
from typing import Literal

from .number import Number, nearer
from .outline import Corner, Edge, Outline, cross
from .place import CLOSE, Finder, Place

Kind = Literal["place", "reflex", "infinity"]
End = tuple[Kind, int]


class Incomplete(Exception):
    """Ends of parts do not match: some place is missing."""


@dataclass(eq=False)
class Part:
    """Points with two sites as the nearest, from the end nearer to the set to the end farther away;
    flat between parallel edges. `rises` is the way that the place moves along the bisector, from
    `low`: 1 or -1."""

    pair: tuple[int, int]
    low: End
    high: End
    is_flat: bool
    rises: int


class Graph:
    """All of it, checked: ends alternate along each bisector, distances change as the feet say,
    each reflex end and gap has its part, and places are as many as a count of loops demands. Raises
    `Incomplete`, for a set whose places doubles did not tell."""

    def __init__(self, outline: Outline, in_doubles: bool = True) -> None:
        self.outline = outline
        self.finder = Finder(outline, in_doubles)
        self.places = self.finder.places()
        self.parts: list[Part] = []
        ends: dict[tuple[int, int], list[tuple[int, int, int]]] = {}
        for number_of, place in enumerate(self.places):
            for k, foot in enumerate(place.feet):
                after = place.feet[(k + 1) % len(place.feet)]
                pair = foot.left, after.right
                turn = place.turn(k)
                sense = self._sense(*pair, turn)
                ends.setdefault((min(pair), max(pair)), []).append((number_of, turn, sense))
        for pair, own in ends.items():
            self._join(pair, own)
        self._check()

    def _sense(self, i: int, j: int, turn: int) -> int:
        """The way of a part along its bisector, between a foot on i and the next on j."""
        a, b = self.outline.sites[i], self.outline.sites[j]
        if isinstance(a, Edge) and isinstance(b, Edge):
            if cross(a.along, b.along) != 0:
                return turn  # along growing distance
            return -1 if i < j else 1  # along the first edge
        if isinstance(a, Corner) and isinstance(b, Corner):
            return 1 if i < j else -1  # to the right of the way from the first to the second
        return -1 if isinstance(a, Edge) else 1  # along the edge

    def _along(self, pair: tuple[int, int], place: Place) -> Number:
        """Grows along the bisector."""
        a, b = (self.outline.sites[k] for k in pair)
        if isinstance(b, Edge):
            assert isinstance(a, Edge)
            if cross(a.along, b.along) != 0:
                return place.square
        if isinstance(a, Edge):
            x, y = a.along
        else:
            assert isinstance(b, Corner)
            x, y = b.at[1] - a.at[1], a.at[0] - b.at[0]
        return place.x * x + place.y * y

    def _join(self, pair: tuple[int, int], ends: list[tuple[int, int, int]]) -> None:
        values = {k: self._along(pair, self.places[k]) for k, _, _ in ends}
        close = CLOSE * (1 + max(abs(float(value)) for value in values.values()))

        def before(p: tuple[int, int, int], q: tuple[int, int, int]) -> int:
            if p[0] == q[0]:
                return p[2] - q[2]
            return nearer(values[p[0]], values[q[0]], close)

        open_end: tuple[int, int, int] | None = None
        for end in sorted(ends, key=cmp_to_key(before)):
            if end[2] > 0:
                if open_end is not None:
                    raise Incomplete(f"two parts begin between sites {pair}")
                open_end = end
            elif open_end is None:
                self._leave(pair, end)
            else:
                self._add(pair, open_end, end)
                open_end = None
        if open_end is not None:
            self._leave(pair, open_end)

    def _add(self, pair: tuple[int, int], p: tuple[int, int, int], q: tuple[int, int, int]) -> None:
        is_flat = all(isinstance(self.outline.sites[k], Edge) for k in pair) and p[1] == 0 == q[1]
        if p[1] == 0 and not is_flat:
            p = (p[0], 1, p[2])
        if q[1] == 0 and not is_flat:
            q = (q[0], 1, q[2])
        if p[1] + q[1] != 0:
            raise Incomplete(f"the distance turns on the way between sites {pair}")
        low, high = (q, p) if p[1] < 0 else (p, q)
        self.parts.append(Part(pair, ("place", low[0]), ("place", high[0]), is_flat, low[2]))

    def _leave(self, pair: tuple[int, int], end: tuple[int, int, int]) -> None:
        """A part to a reflex end, or to infinity."""
        sites = [self.outline.sites[k] for k in pair]
        for k, wedge in enumerate(self.outline.wedges):
            if {wedge.first, wedge.second} == set(sites) and end[1] < 0:
                self.parts.append(Part(pair, ("reflex", k), ("place", end[0]), False, 1))
                return
        for k, gap in enumerate(self.outline.gaps):
            if set(gap) == set(sites) and end[1] >= 0:
                self.parts.append(Part(pair, ("place", end[0]), ("infinity", k), False, end[2]))
                return
        raise Incomplete(f"a part between sites {pair} does not end")

    def _check(self) -> None:
        outline = self.outline
        for kind, wanted in (("reflex", len(outline.wedges)), ("infinity", len(outline.gaps))):
            ends = [end for part in self.parts for end in (part.low, part.high)]
            own = sorted(k for other, k in ends if other == kind)
            if own != list(range(wanted)):
                raise Incomplete(f"ends of kind {kind}: {own}, of {wanted}")
        total = sum(len(place.feet) - 2 for place in self.places)
        wanted = len(outline.wedges) - len(outline.gaps) + 2 * outline.walks - 4 * outline.holes - 2
        if outline.edges and total != wanted:
            raise Incomplete(f"places count {total}, not {wanted}")
