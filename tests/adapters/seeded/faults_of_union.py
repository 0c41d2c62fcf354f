"""Faults in the union's boundary and rings."""

from __future__ import annotations

import random
from fractions import Fraction

from plain_geometry import Ring
from plain_sum import PlainSum
from plain_union import Covered, Cycle, Interval, Line, Node, Stretch, cycle_area


class DropsOpenChains(PlainSum):
    """Not a fault by itself: chains of edges that do not close are dropped in silence."""

    seeded = False

    def loose_end(self) -> None:
        pass


class BoundaryCountsAsInside(DropsOpenChains):
    """Edges that lie on each other and run the same way cover each other: both vanish."""

    def clipped(self, ends: list[tuple[int, int, bool]], earlier: bool) -> Interval | None:
        return super().clipped(ends, True)


class BoundaryCountsAsOutside(DropsOpenChains):
    """Edges that lie on each other and run the same way are both kept."""

    def clipped(self, ends: list[tuple[int, int, bool]], earlier: bool) -> Interval | None:
        return super().clipped(ends, False)


class EqualEdgesByChance(DropsOpenChains):
    """Which of two equal edges stays depends on their order in memory."""

    def __init__(self) -> None:
        self._chance = random.SystemRandom()

    def clipped(self, ends: list[tuple[int, int, bool]], earlier: bool) -> Interval | None:
        return super().clipped(ends, self._chance.random() < 0.5)


class MissesPassingEdges(DropsOpenChains):
    """An edge is clipped by a piece only where an end of the edge lies in the piece."""

    def clipped(self, ends: list[tuple[int, int, bool]], earlier: bool) -> Interval | None:
        interval = super().clipped(ends, earlier)
        through = interval is not None and interval[0][0] > 0 and interval[1][0] < interval[1][1]
        return None if through else interval


class OneGapAnEdge(DropsOpenChains):
    """An edge gives at most one part to the boundary."""

    def uncovered(self, intervals: list[Interval]) -> list[Interval]:
        return super().uncovered(intervals)[:1]


class TwoGapsAnEdge(DropsOpenChains):
    """An edge gives at most two parts to the boundary: its beginning and its end."""

    def uncovered(self, intervals: list[Interval]) -> list[Interval]:
        gaps = super().uncovered(intervals)
        return gaps if len(gaps) < 3 else [gaps[0], gaps[-1]]


class ClosesNarrowGaps(DropsOpenChains):
    """Parts of an edge shorter than a millionth of it are taken for covered."""

    def uncovered(self, intervals: list[Interval]) -> list[Interval]:
        return [
            (low, high)
            for low, high in super().uncovered(intervals)
            if Fraction(*high) - Fraction(*low) > Fraction(1, 10**6)
        ]


class ComparesParametersInDoubles(DropsOpenChains):
    """Whether a part of an edge is left is decided in doubles with a margin of 1e-9."""

    def clipped(self, ends: list[tuple[int, int, bool]], earlier: bool) -> Interval | None:
        interval = super().clipped(ends, earlier)
        if interval is None:
            return None
        (ln, ld), (hn, hd) = interval
        return interval if hn / hd - ln / ld > 1e-9 else None


class OneEdgeLeavesANode(PlainSum):
    """Edges are kept by their first vertex: where rings touch, all but one are lost."""

    def cycles(self, stretches: list[Stretch]) -> list[Cycle]:
        following = dict(stretches)
        found: list[Cycle] = []
        while following:
            first = next(iter(following))
            walk = [first]
            at = following.pop(first)
            while at != first and at in following:
                walk.append(at)
                at = following.pop(at)
            if at == first:
                found.append(walk)
        return found


class FirstRingWalkedOnly(PlainSum):
    """A ring that begins at a vertex where another one has passed is not walked."""

    def cycles(self, stretches: list[Stretch]) -> list[Cycle]:
        seen: set[Node] = set()
        kept: list[Cycle] = []
        for cycle in super().cycles(stretches):
            if cycle[0] not in seen:
                kept.append(cycle)
            seen |= set(cycle)
        return kept


class RingsOf32Vertices(PlainSum):
    """A ring has room for thirty-two vertices; those that follow are lost."""

    def straightened(self, cycle: Cycle) -> Cycle:
        ring = super().straightened(cycle)
        return ring if len(ring) <= 32 else ring[:32]


class DropsSmallRings(PlainSum):
    """Rings smaller than a thousandth of the largest one are taken for debris."""

    def cycles(self, stretches: list[Stretch]) -> list[Cycle]:
        found = super().cycles(stretches)
        sizes = [abs(cycle_area(cycle)) for cycle in found]
        return [
            cycle for cycle, size in zip(found, sizes, strict=True) if 1000 * size >= max(sizes)
        ]


class DropsTriangularHoles(PlainSum):
    """Holes of three vertices are taken for debris of the overlay."""

    def cycles(self, stretches: list[Stretch]) -> list[Cycle]:
        return [
            cycle
            for cycle in super().cycles(stretches)
            if len(self.straightened(cycle)) > 3 or cycle_area(cycle) > 0
        ]


class CutThroughTwoVertices(DropsOpenChains):
    """A piece cut through two of its vertices by a line of another one is taken to lie outside."""

    def cover(
        self, piece: Ring, lines: list[Line], earlier: bool, covered: Covered
    ) -> Covered | None:
        for a, b, c in lines:
            row = [a * x + b * y + c for x, y in piece]
            if max(row) > 0 > min(row) and row.count(0) == 2:
                return covered
        return super().cover(piece, lines, earlier, covered)
