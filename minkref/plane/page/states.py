"""The states of the boundary as the page holds them, with tracks numbered by their first use."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from typing import Any

from minkref.plane.page.replay import Replay
from minkref.plane.page.ring_changes import RingChanges, Row, SlotChange


class States:
    """`encoded`: for each state [slots that end, [slot, is a hole's, component, hole, splice, ...]
    ...], empty where nothing changes; the first is a change from no rings at all. Each is played
    back at once and checked."""

    def __init__(self) -> None:
        self.scales: list[str] = []  # of all states but the first
        self.encoded: list[list[Any]] = []
        self.used: list[int] = []  # original numbers of the tracks
        self.begun = False
        self._number: dict[int, int] = {}  # of each original track
        self._last: list[int | None] = []  # state in which each was last there; None: it still is
        self._first: list[int] = []
        self._there: Counter[int] = Counter()
        self._changes = RingChanges()
        self._replay = Replay()

    def begin(self, rows: Iterable[Row]) -> None:
        """The rings where the window begins."""
        self.begun = True
        self._add(rows)

    def add(self, scale: str, rows: Iterable[Row]) -> None:
        """The rings from this scale on."""
        self.scales.append(scale)
        self._add(rows)

    @property
    def lives(self) -> list[tuple[int, int]]:
        """The first and the last state in which each track is a vertex."""
        end = len(self.encoded) - 1
        return [
            (first, end if last is None else last)
            for first, last in zip(self._first, self._last, strict=True)
        ]

    def _add(self, rows: Iterable[Row]) -> None:
        numbered = [(row[0], row[1], row[2], self._numbers(row[3])) for row in rows]
        change = self._changes.step(numbered)
        self._count(self._replay.step(change))
        self._replay.check(numbered)
        self.encoded.append(
            [change.gone, *(_encoded(changed) for changed in change.changed)]
            if change.gone or change.changed
            else []
        )

    def _numbers(self, tracks: Sequence[int]) -> list[int]:
        numbers = self._number
        for track in tracks:
            if track not in numbers:
                numbers[track] = len(numbers)
                self.used.append(track)
                self._first.append(len(self.encoded))
                self._last.append(None)
        return [numbers[track] for track in tracks]

    def _count(self, places: Counter[int]) -> None:
        """Which tracks come and go."""
        for track, difference in places.items():
            self._there[track] += difference
            gone = self._there[track] == 0
            self._last[track] = len(self.encoded) - 1 if gone else None


def _encoded(changed: SlotChange) -> list[Any]:
    is_hole, component, hole = changed.bounds
    return [changed.slot, int(is_hole), component, hole, *changed.splices]
