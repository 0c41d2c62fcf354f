"""Radii in order: 0 for reflex ends, then 1, 2, ... for places, then infinity."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from functools import cmp_to_key

from .graph import End, Graph
from .number import Number, nearer, number, order
from .place import CLOSE


class Sets:
    """Union and find over whole numbers."""

    def __init__(self, count: int) -> None:
        self.up = list(range(count))

    def find(self, k: int) -> int:
        while self.up[k] != k:
            self.up[k] = self.up[self.up[k]]
            k = self.up[k]
        return k

    def join(self, a: int, b: int) -> None:
        self.up[self.find(b)] = self.find(a)

    def groups(self, members: Iterable[int]) -> list[list[int]]:
        found: dict[int, list[int]] = {}
        for k in members:
            found.setdefault(self.find(k), []).append(k)
        return list(found.values())


class Levels:
    """`squares[k]` is the squared radius of level k; `of_place` has each place's level. Ends of
    parts have numbers: places first, then reflex ends, then infinity."""

    def __init__(self, graph: Graph) -> None:
        self.graph = graph
        places = graph.places
        close = CLOSE * (1 + graph.finder.size) ** 2

        def before(a: int, b: int) -> int:
            p, q = places[a].square, places[b].square
            return nearer(p, q, close * (1 + float(p)))

        self.squares: list[Number] = [number(0)]
        self.of_place = [0] * len(places)
        last: int | None = None
        for k in sorted(range(len(places)), key=cmp_to_key(before)):
            if last is None or before(last, k) != 0:
                self.squares.append(places[k].square)
            self.of_place[k] = len(self.squares) - 1
            last = k
        self.infinity = len(self.squares)
        self.ends = len(places) + len(graph.outline.wedges) + 1

    def number(self, end: End) -> int:
        kind, k = end
        if kind == "place":
            return k
        return len(self.graph.places) + k if kind == "reflex" else self.ends - 1

    def level(self, end: End) -> int:
        kind, k = end
        if kind == "place":
            return self.of_place[k]
        return 0 if kind == "reflex" else self.infinity

    def below(self, square: Fraction) -> int:
        """The last level with a smaller squared radius; -1 without."""
        found = [k for k, own in enumerate(self.squares) if order(own, number(square)) < 0]
        return max(found, default=-1)

    def groups(self) -> list[list[int]]:
        """Places joined by flat parts."""
        sets = Sets(len(self.graph.places))
        for part in self.graph.parts:
            if part.is_flat:
                sets.join(part.low[1], part.high[1])
        return sets.groups(range(len(self.graph.places)))
