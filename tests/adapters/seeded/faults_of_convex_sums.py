"""Faults in the sum of two convex pieces, and in the use of all these sums."""

from __future__ import annotations

from itertools import pairwise
from math import gcd

from faults_of_pieces import hull
from plain_geometry import Point, Ring, area
from plain_sum import PlainSum, Polygon
from plain_union import box_of


class ForgetsTheLastEdge(PlainSum):
    """The merge of the edges ends one edge too early."""

    def convex_sum(self, A: Ring, B: Ring) -> Ring:
        found = super().convex_sum(A, B)
        return found[:-1] if len(found) > 4 else found


class StopsAtTheShorterList(PlainSum):
    """The merge ends when one of the two lists of edges does."""

    def convex_sum(self, A: Ring, B: Ring) -> Ring:
        a, b = self.from_lowest(A), self.from_lowest(B)
        if min(len(a), len(b)) < 3:
            return super().convex_sum(A, B)
        found: Ring = []
        i = j = 0
        while i < len(a) and j < len(b):
            found.append((a[i][0] + b[j][0], a[i][1] + b[j][1]))
            step = self.compare(a[i], a[(i + 1) % len(a)], b[j], b[(j + 1) % len(b)])
            i, j = i + (step >= 0), j + (step <= 0)
        found.append((a[i % len(a)][0] + b[j % len(b)][0], a[i % len(a)][1] + b[j % len(b)][1]))
        return hull(found)


class KeysEdgesByDirection(PlainSum):
    """Edges are kept by their direction: of two parallel ones the later replaces the earlier."""

    def convex_sum(self, A: Ring, B: Ring) -> Ring:
        if min(len(A), len(B)) < 3:
            return super().convex_sum(A, B)
        found = super().convex_sum(A, B)
        lost = {self.direction(p, q) for p, q in zip(A, A[1:] + A[:1], strict=True)}
        lost &= {self.direction(p, q) for p, q in zip(B, B[1:] + B[:1], strict=True)}
        whole = {self.direction(p, q): (p, q) for p, q in zip(A, A[1:] + A[:1], strict=True)}
        made = [found[0]]
        for p, q in pairwise(found):
            way = self.direction(p, q)
            dx, dy = q[0] - p[0], q[1] - p[1]
            if way in lost:
                (ax, ay), (bx, by) = whole[way]
                dx, dy = dx - (bx - ax), dy - (by - ay)
            made.append((made[-1][0] + dx, made[-1][1] + dy))
        return hull(made)

    def direction(self, p: Point, q: Point) -> Point:
        dx, dy = q[0] - p[0], q[1] - p[1]
        common = gcd(dx, dy) or 1
        return (dx // common, dy // common)


class StartsAtDifferentEnds(PlainSum):
    """The merge starts at the lowest vertex of the one piece and the leftmost of the other."""

    _second: Ring | None = None

    def convex_sum(self, A: Ring, B: Ring) -> Ring:
        self._second = B
        return super().convex_sum(A, B)

    def from_lowest(self, ring: Ring) -> Ring:
        if ring is not self._second:
            return super().from_lowest(ring)
        at = ring.index(min(ring))
        return ring[at:] + ring[:at]


class HullOfTheSum(PlainSum):
    """The sum of the convex hulls."""

    def piece_sums(self, P: list[Polygon], Q: list[Polygon]) -> list[Ring]:
        if not P or not Q:
            return []
        first = hull([p for polygon in P for p in polygon[0]])
        second = hull([p for polygon in Q for p in polygon[0]])
        return self.regions([self.convex_sum(first, second)])


class HullOfQ(PlainSum):
    """The second operand is taken for convex."""

    def pieces_of_second(self, Q: list[Polygon]) -> list[Polygon]:
        return [[hull(polygon[0]) or polygon[0]] for polygon in Q]

    def piece_sums(self, P: list[Polygon], Q: list[Polygon]) -> list[Ring]:
        return super().piece_sums(P, self.pieces_of_second(Q))


class TinyQIsAPoint(PlainSum):
    """A second operand a millionth the size of the first is taken for a point."""

    def piece_sums(self, P: list[Polygon], Q: list[Polygon]) -> list[Ring]:
        if P and Q:
            x0, y0, x1, y1 = box_of([p for polygon in P for p in polygon[0]])
            u0, v0, u1, v1 = box_of([p for polygon in Q for p in polygon[0]])
            if 10**6 * max(u1 - u0, v1 - v0) <= max(x1 - x0, y1 - y0):
                return super().piece_sums(P, [[[Q[0][0][0]]]])
        return super().piece_sums(P, Q)


class PrunesByTheBox(PlainSum):
    """A pairwise sum is dropped where its bounding box lies in that of a larger one."""

    def regions(self, sums: list[Ring]) -> list[Ring]:
        kept: list[Ring] = []
        boxes: list[tuple[int, int, int, int]] = []
        for ring in sorted(super().regions(sums), key=area, reverse=True):
            x0, y0, x1, y1 = box_of(ring)
            if not any(u0 <= x0 and x1 <= u1 and v0 <= y0 and y1 <= v1 for u0, v0, u1, v1 in boxes):
                kept.append(ring)
                boxes.append((x0, y0, x1, y1))
        return kept


class PrunesByVertices(PlainSum):
    """Drops a pairwise sum if every vertex lies in some other sum."""

    def regions(self, sums: list[Ring]) -> list[Ring]:
        kept = sorted(super().regions(sums), key=area)
        for ring in list(kept):
            others = [other for other in kept if other is not ring]
            if all(any(self.holds(other, p) for other in others) for p in ring):
                kept = others
        return kept

    def holds(self, ring: Ring, p: Point) -> bool:
        return all(
            (b[0] - a[0]) * (p[1] - a[1]) > (b[1] - a[1]) * (p[0] - a[0])
            for a, b in zip(ring, ring[1:] + ring[:1], strict=True)
        )


class AtMost50Sums(PlainSum):
    """The pairwise sums go into an array of fifty; the smallest of more are left out."""

    def regions(self, sums: list[Ring]) -> list[Ring]:
        return sorted(super().regions(sums), key=area, reverse=True)[:50]


class SkipsTheFirstPieceOfQ(PlainSum):
    """The loop over the pieces of the second operand starts at 1 where these are five or more."""

    def piece_sums(self, P: list[Polygon], Q: list[Polygon]) -> list[Ring]:
        first = [piece for polygon in P for piece in self.pieces(polygon)]
        second = [piece for polygon in Q for piece in self.pieces(polygon)]
        second = second[1:] if len(second) > 4 else second
        return self.regions([self.convex_sum(a, b) for a in first for b in second])
