"""Changes played back and held against the rings that they came from."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable

from minkref.plane.page.ring_changes import Bounds, Change, Row, turned


class Replay:
    """The state of a reader of the changes after each change."""

    def __init__(self) -> None:
        self._lists: dict[int, list[int]] = {}
        self._rings: dict[int, tuple[tuple[int, ...], Bounds]] = {}

    def step(self, change: Change) -> Counter[int]:
        """Carries the change out. How many more places each vertex that it names has."""
        places: Counter[int] = Counter()
        for slot in change.gone:
            places.subtract(self._lists.pop(slot))
            del self._rings[slot]
        for changed in change.changed:
            vertices = self._lists.setdefault(changed.slot, [])
            for at, removed, *added in changed.splices:
                places.subtract(vertices[at : at + removed])
                places.update(added)
                vertices[at : at + removed] = added
            self._rings[changed.slot] = (turned(vertices), changed.bounds)
        return places

    def check(self, rows: Iterable[Row]) -> None:
        """Raises AssertionError unless the rings are exactly these. O(vertices)."""
        wanted = sorted((turned(row[3]), row[:3]) for row in rows)
        if sorted(self._rings.values()) != wanted:
            raise AssertionError("the changes of the page do not give the rings of the sum")
