"""Faults that show only after other calls of the same process, or not every time."""

from __future__ import annotations

import json
import random
import zlib
from itertools import chain

from plain_geometry import Ring
from plain_sum import PlainSum, Polygon, Set
from plain_union import box_of


class CachesPiecesByBox(PlainSum):
    """Pieces are kept by the bounding box and the number of vertices of a polygon."""

    def __init__(self) -> None:
        self._kept: dict[object, list[Ring]] = {}

    def key(self, polygon: list[Ring]) -> object:
        return (box_of(polygon[0]), len(list(chain(*polygon))))

    def pieces(self, polygon: list[Ring]) -> list[Ring]:
        key = self.key(polygon)
        if key not in self._kept:
            self._kept[key] = super().pieces(polygon)
        return self._kept[key]


class CachesPiecesByOuterRing(CachesPiecesByBox):
    """Pieces are kept by the outer ring; the holes are no part of the key."""

    def key(self, polygon: list[Ring]) -> object:
        return tuple(polygon[0])


class CachesPiecesWithoutThePlace(CachesPiecesByBox):
    """Pieces are kept by the ring moved to the origin, and come back where it was at first."""

    def key(self, polygon: list[Ring]) -> object:
        x0, y0 = min(polygon[0])
        return tuple((x - x0, y - y0) for x, y in chain(*polygon))


class CachesSumsByChecksum(PlainSum):
    """Sums are kept by a checksum of twelve bits of the operands."""

    def __init__(self) -> None:
        self._kept: dict[int, Set | None] = {}

    def __call__(self, P: Set, Q: Set) -> Set | None:
        key = zlib.crc32(json.dumps([P, Q]).encode()) & 0xFFF
        if key not in self._kept:
            self._kept[key] = super().__call__(P, Q)
        return self._kept[key]


class KeepsTheLastPiece(PlainSum):
    """A buffer is not emptied when a sum is empty or its operand flat: the next sum has more."""

    def __init__(self) -> None:
        self._buffer: list[Ring] = []

    def piece_sums(self, P: list[Polygon], Q: list[Polygon]) -> list[Ring]:
        found = super().piece_sums(P, Q)
        left, self._buffer = self._buffer, []
        if any(len(polygon[0]) < 3 for polygon in P + Q):
            self._buffer = found[:1]
        return self.regions(found + left)


class KeepsTheLastRoom(PlainSum):
    """The sizes against which holes are filtered are those of the call before."""

    def __init__(self) -> None:
        self._last: list[tuple[int, int]] = []
        self._now: list[tuple[int, int]] = []

    def __call__(self, P: Set, Q: Set) -> Set | None:
        self._last = self._now
        return super().__call__(P, Q)

    def has_room(self, hole: Ring, sizes: list[tuple[int, int]]) -> bool:
        self._now = sizes
        return super().has_room(hole, self._last or sizes)


class LosesAHoleByChance(PlainSum):
    """Two threads write holes into one list: now and then one is lost."""

    def __init__(self) -> None:
        self._chance = random.SystemRandom()

    def pieces(self, polygon: list[Ring]) -> list[Ring]:
        return super().pieces(polygon[:-1] if self.unlucky(polygon) else polygon)

    def unlucky(self, polygon: list[Ring]) -> bool:
        return len(polygon) > 2 and self._chance.random() < 0.25
