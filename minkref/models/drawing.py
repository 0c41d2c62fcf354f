"""Outlines of thick strokes in integer arithmetic: the same rings on every machine.

A drawing is a list of strokes; a stroke is a chain of nibs (x, y, radius). Samples the plane on a
square grid, and traces the outline by marching squares. Coordinates are integers; the caller
chooses the unit.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from math import isqrt

Nib = tuple[int, int, int]
Node = tuple[int, int]
Ring = list[tuple[int, int]]


def smooth(chain: Sequence[Nib], rounds: int = 3) -> list[Nib]:
    """Cut corners by Chaikin's method; both ends stay. Floors to integers after every round."""
    nibs = list(chain)
    for _ in range(rounds):
        cut = [nibs[0]]
        for (ax, ay, ar), (bx, by, br) in itertools.pairwise(nibs):
            cut.append(((3 * ax + bx) // 4, (3 * ay + by) // 4, (3 * ar + br) // 4))
            cut.append(((ax + 3 * bx) // 4, (ay + 3 * by) // 4, (ar + 3 * br) // 4))
        cut.append(nibs[-1])
        nibs = cut
    return nibs


class Canvas:
    """The ink's height over each grid node: radius less distance, the largest over all strokes."""

    def __init__(self, step: int) -> None:
        self.step = step
        self.ink: dict[Node, int] = {}

    def stroke(self, chain: Sequence[Nib]) -> None:
        """Ink a chain of nibs; a single nib makes a blot."""
        if len(chain) == 1:
            self._segment(chain[0], chain[0])
        for start, end in itertools.pairwise(chain):
            self._segment(start, end)

    def _segment(self, start: Nib, end: Nib) -> None:
        (ax, ay, ar), (bx, by, br) = start, end
        dx, dy = bx - ax, by - ay
        squared = dx * dx + dy * dy
        reach = max(ar, br) + 2 * self.step
        for i in range((min(ax, bx) - reach) // self.step, (max(ax, bx) + reach) // self.step + 2):
            for j in range(
                (min(ay, by) - reach) // self.step, (max(ay, by) + reach) // self.step + 2
            ):
                px, py = i * self.step - ax, j * self.step - ay
                along = px * dx + py * dy
                if along <= 0 or squared == 0:
                    height = ar - isqrt(px * px + py * py)
                elif along >= squared:
                    height = br - isqrt((px - dx) ** 2 + (py - dy) ** 2)
                else:
                    distance = isqrt((px * dy - py * dx) ** 2 // squared)
                    height = ar + (br - ar) * along // squared - distance
                if height > self.ink.get((i, j), -reach):
                    self.ink[(i, j)] = height

    def outline(self) -> list[Ring]:
        """Trace the rings around the ink, with the ink to the left: holes turn clockwise.

        Simple and disjoint: each ring crosses its grid cells along segments that do not meet (at a
        saddle the two inked corners stay apart).
        """
        follows = self._pieces()
        rings: list[Ring] = []
        while follows:
            start = min(follows)
            ring, here = [self._place(start)], follows.pop(start)
            while here != start:
                ring.append(self._place(here))
                here = follows.pop(here)
            rings.append(ring)
        return rings

    def _inked(self, node: Node) -> bool:
        return self.ink.get(node, -1) > 0

    def _pieces(self) -> dict[tuple[Node, Node], tuple[Node, Node]]:
        """Map each crossed grid edge, named (inked node, bare node), to the next."""
        cells = {
            (i + di, j + dj)
            for (i, j), height in self.ink.items()
            if height > 0
            for di in (-1, 0)
            for dj in (-1, 0)
        }
        follows: dict[tuple[Node, Node], tuple[Node, Node]] = {}
        for i, j in cells:
            corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
            inked = [self._inked(corner) for corner in corners]
            for k in range(4):  # a run of inked corners begins at corner k
                if not inked[k] or inked[k - 1]:
                    continue
                last = k
                while inked[(last + 1) % 4]:
                    last += 1
                leave = (corners[last % 4], corners[(last + 1) % 4])
                follows[leave] = (corners[k], corners[k - 1])
        return follows

    def _place(self, edge: tuple[Node, Node]) -> tuple[int, int]:
        """Find the end of the ink on a grid edge, strictly between the edge's nodes."""
        inked, bare = edge
        above = self.ink[inked]
        below = -min(self.ink.get(bare, -self.step), 0)
        part = min(max(self.step * above // (above + below), 1), self.step - 1)
        return (
            inked[0] * self.step + (bare[0] - inked[0]) * part,
            inked[1] * self.step + (bare[1] - inked[1]) * part,
        )
