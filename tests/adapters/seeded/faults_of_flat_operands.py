"""Faults about points, segments and empty sets as operands."""

from __future__ import annotations

from plain_geometry import Ring
from plain_sum import PlainSum, Polygon, Set


class EmptyIsNeutral(PlainSum):
    """The sum with the empty set is the other operand."""

    def __call__(self, P: Set, Q: Set) -> Set | None:
        if not P["polygons"] or not Q["polygons"]:
            return P if P["polygons"] else Q
        return super().__call__(P, Q)


class CrashesOnTheEmptySet(PlainSum):
    """Takes the first polygon of each operand without asking whether there is one."""

    def __call__(self, P: Set, Q: Set) -> Set | None:
        _ = P["polygons"][0], Q["polygons"][0]
        return super().__call__(P, Q)


class PointAtTheOrigin(PlainSum):
    """A point as operand is taken for the origin."""

    def piece_sums(self, P: list[Polygon], Q: list[Polygon]) -> list[Ring]:
        return super().piece_sums(self.moved(P), self.moved(Q))

    def moved(self, operand: list[Polygon]) -> list[Polygon]:
        return [[[(0, 0)]] if len(polygon[0]) == 1 else polygon for polygon in operand]


class FlatIsEmpty(PlainSum):
    """An operand without area is taken for empty."""

    def piece_sums(self, P: list[Polygon], Q: list[Polygon]) -> list[Ring]:
        return super().piece_sums(
            [polygon for polygon in P if len(polygon[0]) > 2],
            [polygon for polygon in Q if len(polygon[0]) > 2],
        )


class SegmentIsItsEnds(PlainSum):
    """A segment as operand is taken for its two ends."""

    def piece_sums(self, P: list[Polygon], Q: list[Polygon]) -> list[Ring]:
        return super().piece_sums(self.ends(P), self.ends(Q))

    def ends(self, operand: list[Polygon]) -> list[Polygon]:
        made: list[Polygon] = []
        for polygon in operand:
            made += [[[p]] for p in polygon[0]] if len(polygon[0]) == 2 else [polygon]
        return made


class LoopsOnASegment(PlainSum):
    """Goes round a ring until it turns left, which a segment never does."""

    def piece_sums(self, P: list[Polygon], Q: list[Polygon]) -> list[Ring]:
        for polygon in P + Q:
            ring, k = polygon[0], 0
            while len(ring) == 2:
                a, b, c = (ring[(k + step) % 2] for step in range(3))
                if (b[0] - a[0]) * (c[1] - b[1]) > (b[1] - a[1]) * (c[0] - b[0]):
                    break
                k += 1
        return super().piece_sums(P, Q)


class SegmentBackwards(PlainSum):
    """A segment as operand is taken to begin at the origin."""

    def piece_sums(self, P: list[Polygon], Q: list[Polygon]) -> list[Ring]:
        return super().piece_sums(self.moved(P), self.moved(Q))

    def moved(self, operand: list[Polygon]) -> list[Polygon]:
        return [
            [[(x - polygon[0][0][0], y - polygon[0][0][1]) for x, y in polygon[0]]]
            if len(polygon[0]) == 2
            else polygon
            for polygon in operand
        ]
