"""Rings of the boundary as changes from one state to the next.

A ring keeps its *slot* while it changes. A change names, for each slot that is touched, what the
ring bounds and the splices of its cyclic list of vertices, so that a state costs as much as is new
in it.
"""

from __future__ import annotations

from bisect import bisect_left
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from itertools import pairwise

Row = tuple[bool, int, int, Sequence[int]]  # is a hole's, component, hole, vertices
Bounds = tuple[bool, int, int]
Splice = list[int]  # where, how many go, and those that come


@dataclass(frozen=True)
class SlotChange:
    """`splices` stand in the order in which they are carried out: from the end of the list on."""

    slot: int
    bounds: Bounds
    splices: list[Splice]


@dataclass(frozen=True)
class Change:
    gone: list[int] = field(default_factory=list)  # slots
    changed: list[SlotChange] = field(default_factory=list)


def turned(ring: Sequence[int]) -> tuple[int, ...]:
    """The ring from its smallest vertex on: equal for equal cyclic lists."""
    start = ring.index(min(ring))
    return (*ring[start:], *ring[:start])


class RingChanges:
    """Finds the changes between the states that it is shown."""

    def __init__(self) -> None:
        self._lists: dict[int, list[int]] = {}  # of each slot, as a reader of the changes has it
        self._bounds: dict[int, Bounds] = {}
        self._known: dict[tuple[int, ...], int] = {}  # slots of the present rings
        self._next = 0

    def step(self, rows: Iterable[Row]) -> Change:
        """O(vertices), and O(n log n) for the n vertices of rings that change."""
        present = {turned(row[3]): row[:3] for row in rows}
        change = Change()
        left = {ring: slot for ring, slot in self._known.items() if ring not in present}
        fresh = [ring for ring in present if ring not in self._known]
        for ring, slot in self._known.items():
            bounds = present.get(ring)
            if bounds is not None and bounds != self._bounds[slot]:
                change.changed.append(SlotChange(slot, bounds, []))
                self._bounds[slot] = bounds
        taken = _heirs(left, fresh)
        for ring, slot in left.items():
            del self._known[ring]
            if slot not in taken.values():
                change.gone.append(slot)
                del self._lists[slot], self._bounds[slot]
        for ring in fresh:
            slot = taken.get(ring, self._next)
            self._next += slot == self._next
            splices = splices_between(self._lists.get(slot, []), ring)
            apply(self._lists.setdefault(slot, []), splices)
            self._bounds[slot] = present[ring]
            self._known[ring] = slot
            change.changed.append(SlotChange(slot, present[ring], splices))
        return change


def _heirs(
    left: dict[tuple[int, ...], int], fresh: list[tuple[int, ...]]
) -> dict[tuple[int, ...], int]:
    """The slot that each new ring takes over: of the ring with which it shares most vertices."""
    owner: dict[int, int] = {}
    for ring, slot in left.items():
        owner.update(dict.fromkeys(ring, slot))
    shared: list[tuple[int, int, int]] = []
    for place, ring in enumerate(fresh):
        counts = Counter(owner[vertex] for vertex in ring if vertex in owner)
        shared += [(-count, slot, place) for slot, count in counts.items()]
    heirs: dict[tuple[int, ...], int] = {}
    for _, slot, place in sorted(shared):
        if fresh[place] not in heirs and slot not in heirs.values():
            heirs[fresh[place]] = slot
    return heirs


def apply(vertices: list[int], splices: Iterable[Splice]) -> None:
    """Carries the splices out."""
    for at, removed, *added in splices:
        vertices[at : at + removed] = added


def splices_between(old: list[int], ring: tuple[int, ...]) -> list[Splice]:
    """From the list `old` to some turn of the cyclic list `ring`: as few vertices as can be once
    the first common one is fixed."""
    places = dict(zip(ring, range(len(ring)), strict=True))
    anchor = next((places[vertex] for vertex in old if vertex in places), 0)
    new = [*ring[anchor:], *ring[:anchor]]
    begin = _common(old, new)
    most = min(len(old), len(new)) - begin
    end = min(_common(old[: begin - 1 : -1] if begin else old[::-1], new[::-1]), most)
    before, after = old[begin : len(old) - end], new[begin : len(new) - end]
    kept = [(-1, -1), *_kept(before, after), (len(before), len(after))]
    splices = []
    for (i, j), (k, m) in pairwise(kept):
        if k - i > 1 or m - j > 1:
            splices.append([begin + i + 1, k - i - 1, *after[j + 1 : m]])
    return splices[::-1]


def _common(one: list[int], other: list[int]) -> int:
    """How many first elements are equal."""
    low, high = 0, min(len(one), len(other))
    while low < high:
        middle = (low + high + 1) // 2
        if one[low:middle] == other[low:middle]:
            low = middle
        else:
            high = middle - 1
    return low


def _kept(before: list[int], after: list[int]) -> list[tuple[int, int]]:
    """Places of a longest common subsequence of two lists in which no element occurs twice."""
    places = {vertex: place for place, vertex in enumerate(after)}
    ends: list[int] = []  # smallest place in `after` at which a subsequence of each length ends
    last: list[int] = []  # the index among `pairs` of that end
    pairs: list[tuple[int, int, int]] = []  # places, and the pair before
    for i, vertex in enumerate(before):
        j = places.get(vertex)
        if j is None:
            continue
        length = bisect_left(ends, j)
        pairs.append((i, j, last[length - 1] if length else -1))
        if length == len(ends):
            ends.append(j)
            last.append(len(pairs) - 1)
        else:
            ends[length], last[length] = j, len(pairs) - 1
    found: list[tuple[int, int]] = []
    at = last[-1] if last else -1
    while at >= 0:
        i, j, at = pairs[at]
        found.append((i, j))
    return found[::-1]
