"""The events of a window in space, in parts that follow each other where they are too many to be in
memory at once."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.plane.commands.scale_index import cores

MOST = 8_000_000  # events that one thread may find, some gigabyte
MOST_HALVED = 30  # times; a single scale may have any number of events
PAGE = 4096  # events at a time
OF_PAIRS, OF_MORE = ("vertex", "edge", "parallel"), ("triple", "four")
ONCE = ("facets",)  # counts that are the same in each part
Tell = Callable[..., Any]


@dataclass(frozen=True)
class Part:
    """Those of a part of the window, but for the first so many, which an earlier part has."""

    found: _core.SpaceEvents
    pairs_before: int
    more_before: int

    def rows_of_pairs(self) -> Iterator[Any]:
        return _paged(self.found.rows, self.pairs_before)

    def rows_of_more(self) -> Iterator[Any]:
        return _paged(self.found.concurrent, self.more_before)

    def counts(self) -> Counter[str]:
        counts = Counter(dict(self.found.counts()))
        for page, before in (
            (self.found.rows, self.pairs_before), (self.found.concurrent, self.more_before),
        ):  # fmt: skip
            counts.subtract(row[1] for row in _paged(page, 0, before))
        counts["distinct_of_pairs"] -= self.pairs_before > 0
        counts["distinct_of_more"] -= self.more_before > 0
        counts["distinct"] -= self.pairs_before + self.more_before > 0
        return counts


class EventParts:
    """Iterated once, ascending; then `counts` has what there is in all. A part has at most some
    `most` events a thread, if that is given."""

    def __init__(
        self,
        P: _core.Polyhedron,
        Q: _core.Polyhedron,
        window: tuple[str, str],
        concurrent: bool,
        tell: Tell,
        most: int | None = None,
    ) -> None:
        self._operands = P, Q
        self._windows = [(window[0], window[1], False, 0)]
        self._concurrent, self._tell, self._most = concurrent, tell, most
        self.parts = 0
        self.counts: Counter[str] = Counter()

    def __iter__(self) -> Iterator[Part]:
        while self._windows:
            low, high, follows, halved = self._windows.pop()
            found = self._found(low, high, self._most if halved < MOST_HALVED else None)
            if found is None:
                middle = str((Fraction(low) + Fraction(high)) / 2)
                halved += 1
                self._windows += [(middle, high, True, halved), (low, middle, follows, halved)]
                continue
            part = Part(
                found,
                _at(found.rows, low) if follows else 0,
                _at(found.concurrent, low) if follows else 0,
            )
            self.parts += 1
            counts = part.counts()
            for name in ONCE:
                self.counts[name] = counts.pop(name)
            self.counts.update(counts)
            yield part

    def _found(self, low: str, high: str, most: int | None) -> _core.SpaceEvents | None:
        """None where there are too many."""
        try:
            return _core.space_events(
                *self._operands, low, high, cores(), self._tell, self._concurrent, most
            )
        except _core.LimitExceeded as error:
            if error.code != "too-many-events":
                raise
            return None


def _at(page: Callable[[int, int], list[Any]], low: str) -> int:
    """How many events at the beginning are at this scale."""
    count = 0
    for row in _paged(page, 0):
        if row[0] != low:
            break
        count += 1
    return count


def _paged(
    page: Callable[[int, int], list[Any]], first: int, last: int | None = None
) -> Iterator[Any]:
    while last is None or first < last:
        rows = page(first, PAGE if last is None else min(PAGE, last - first))
        if not rows:
            return
        yield from rows
        first += len(rows)
