"""An independent reader of the data of the page with a disc, written from docs/command-line.md."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from minkref.reports.evidence.pages.disc_rings import Piece, Point


class DiscDecoder:
    """Corners belong to halves with one end below the radius; walks from a half that starts a
    boundary part to the next, then on behind that half's twin."""

    def __init__(self, data: dict[str, Any]) -> None:
        self.data = data
        self.motions: dict[int, list[float]] = {}
        firsts = [k for k, half in enumerate(data["halves"]) if half[2] > k]
        for place, k in enumerate(firsts):
            motion = data["motions"][10 * place : 10 * place + 10]
            self.motions[k] = self.motions[data["halves"][k][2]] = motion

    def gap(self, radius: float) -> int:
        return sum(event <= radius for event in self.data["radii"])

    def counts(self, radius: float) -> tuple[int, int]:
        """Components and holes between radii of events."""
        gap = self.gap(radius)
        joined = sum(number <= gap for number, *_ in self.data["joins"])
        holes = sum(birth <= gap < end for birth, end, *_ in self.data["holes"])
        return self.data["polygons"] - joined, holes

    def rings(self, radius: float) -> list[list[Piece]]:
        """In coordinates of P."""
        if self.data["point"] is not None:
            (x, y) = self.data["point"]
            ends = [self._moved((x + radius, y)), self._moved((x - radius, y))]
            centre = self._moved((x, y))
            return [[(centre, ends[0], ends[1]), (centre, ends[1], ends[0])]]
        gap, numbers, halves = self.gap(radius), self.data["numbers"], self.data["halves"]
        # For each half with a corner: the next such half along its walk.
        following: dict[int, int] = {}
        free: list[tuple[int, int]] = []
        for first_side, end_side, first, end in self.data["walks"]:
            cut = [
                k
                for k in range(first, end)
                if (numbers[halves[k][0]] <= gap) != (numbers[halves[k][1]] <= gap)
            ]
            following |= dict(zip(cut, cut[1:] + cut[:1], strict=True))
            above = [k for k in range(first, end) if numbers[halves[k][0]] > gap]
            if not cut and (first == end or above):
                free.append((first_side, end_side))
        rings = [self._ring(list(range(*walk)), walk, radius) for walk in free]
        starts = {k for k in following if numbers[halves[k][0]] <= gap}
        while starts:
            entry = min(starts)
            ring: list[Piece] = []
            while entry in starts:
                starts.remove(entry)
                leaves = following[entry]
                ring += self._stretch(entry, leaves, radius)
                entry = halves[leaves][2]
            rings.append(ring)
        return rings

    def _stretch(self, entry: int, leaves: int, radius: float) -> list[Piece]:
        """From the corner on one half to that on another, along their walk."""
        halves = self.data["halves"]
        *walk, first, end = next(row for row in self.data["walks"] if row[2] <= entry < row[3])
        side, sides, half = halves[entry][4], [halves[entry][4]], entry

        def go_on(to: int) -> None:
            nonlocal side
            while side != to:
                side = side + 1 if side + 1 < walk[1] else walk[0]
                sides.append(side)

        while True:
            half = half + 1 if half + 1 < end else first
            go_on(halves[half][3])
            if half == leaves:
                break
            go_on(halves[half][4])
        joints = [self._joint(side, walk, radius) for side in sides[:-1]]
        places = [self._corner(entry, radius), *joints, self._corner(leaves, radius)]
        return self._pieces(sides, places)

    def _ring(self, sides: list[int], walk: Sequence[int], radius: float) -> list[Piece]:
        joints = [self._joint(side, walk, radius) for side in sides]
        return self._pieces(sides, [joints[-1], *joints])

    def _pieces(self, sides: list[int], places: list[Point | None]) -> list[Piece]:
        """None where a side goes on as the next."""
        pieces: list[Piece] = []
        for side, start, end in zip(sides, places, places[1:], strict=False):
            if start is None or end is None:
                raise AssertionError("two sides of one kind follow each other in this example")
            _, vertex, _, is_arc, *_ = self.data["sides"][side]
            centre = self._moved(self.data["features"][vertex]) if is_arc else None
            pieces.append((centre, self._moved(start), self._moved(end)))
        return pieces

    def _joint(self, side: int, walk: Sequence[int], radius: float) -> Point | None:
        after = side + 1 if side + 1 < walk[1] else walk[0]
        own, following = self.data["sides"][side], self.data["sides"][after]
        if own[3] == following[3]:
            return None
        x, y = self.data["features"][own[2]]
        across, up = self.data["features"][following[0] if own[3] else own[0]][:2]
        return x + radius * across, y + radius * up

    def _corner(self, half: int, radius: float) -> Point:
        ax, ay, r, rest, bx, by, k0, k1, cx, cy = self.motions[half]
        way = radius - r - rest
        root = math.sqrt(max(way * (k0 + k1 * way), 0.0))
        at = ax + way * bx + root * cx, ay + way * by + root * cy
        places = self._ends(half)
        if k0 or k1 or None in places:
            return at
        x, y = (
            min(max(at[i], min(p[i] for p in places)), max(p[i] for p in places)) for i in (0, 1)
        )
        return x, y

    def _ends(self, half: int) -> list[Any]:
        """Where a half starts and ends; None at infinity."""
        start, end, _, from_side, to_side = self.data["halves"][half]
        events, gaps = len(self.data["kinds"]), len(self.data["gaps"])
        vertices = self.data["sides"][from_side][1], self.data["sides"][to_side][2]
        return [
            self.data["places"][2 * node : 2 * node + 2]
            if node < events
            else None
            if node < events + gaps
            else self.data["features"][vertex]
            for node, vertex in zip((start, end), vertices, strict=True)
        ]

    def _moved(self, point: Any) -> Point:
        x, y = self.data["origin"]
        return point[0] + x, point[1] + y
