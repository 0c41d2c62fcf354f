"""Faults in cutting an operand into convex pieces."""

from __future__ import annotations

from plain_geometry import Point, Ring, area, in_wedge, turn, within
from plain_pieces import Corners
from plain_sum import PlainSum
from plain_union import box_of


def hull(points: list[Point]) -> Ring:
    """The convex hull, counter-clockwise."""
    chains: list[Ring] = []
    for ordered in (sorted(set(points)), sorted(set(points), reverse=True)):
        chain: Ring = []
        for p in ordered:
            while len(chain) > 1 and turn(chain[-2], chain[-1], p) <= 0:
                chain.pop()
            chain.append(p)
        chains.append(chain[:-1])
    return chains[0] + chains[1]


class EarsPassOverRim(PlainSum):
    """An ear may have other vertices on its rim: the test is strict where it must not be."""

    def is_ear(self, ring: Ring, left: list[int], a: int, b: int, c: int) -> bool:
        pa, pb, pc = ring[a], ring[b], ring[c]
        return turn(pa, pb, pc) > 0 and not any(
            turn(pa, pb, p) > 0 and turn(pb, pc, p) > 0 and turn(pc, pa, p) > 0
            for p in (ring[k] for k in left)
        )


class EarsTestNeighboursOnly(PlainSum):
    """An ear is tested against the two vertices next to it on either side."""

    def is_ear(self, ring: Ring, left: list[int], a: int, b: int, c: int) -> bool:
        at, n = left.index(b), len(left)
        near = {left[(at + step) % n] for step in range(-3, 4)}
        return super().is_ear(ring, sorted(near), a, b, c)


class BridgesWithoutLooking(PlainSum):
    """A hole is joined to the first vertex that faces it, be there edges between or not."""

    def bridge(self, ring: Ring, hole: Ring, holes: list[Ring]) -> tuple[int, int] | None:
        for start in sorted(range(len(hole)), key=lambda k: hole[k], reverse=True):
            for at in range(len(ring)):
                if self.sees(ring, at, hole, start, []):
                    return at, start
        return None


class JoinsByOneEnd(PlainSum):
    """Pieces are joined where one end of the diagonal stays convex; the other is not looked at."""

    def stays_convex(self, ring: Ring, one: Corners, other: Corners) -> bool:
        return turn(ring[one[-2]], ring[other[0]], ring[other[1]]) >= 0


class NearlyConvexIsConvex(PlainSum):
    """A polygon that fills 99 parts in 100 of its hull is replaced by the hull."""

    def pieces(self, polygon: list[Ring]) -> list[Ring]:
        if len(polygon) == 1 and len(polygon[0]) > 3:
            around = hull(polygon[0])
            if 100 * area(polygon[0]) >= 99 * area(around):
                return [around]
        return super().pieces(polygon)


class FourCornersAreConvex(PlainSum):
    """A ring of four vertices is taken for convex."""

    def pieces(self, polygon: list[Ring]) -> list[Ring]:
        if len(polygon) == 1 and len(polygon[0]) == 4:
            return [hull(polygon[0])]
        return super().pieces(polygon)


class HoldsSixteenPieces(PlainSum):
    """The pieces of a polygon go into an array of sixteen; what is more is lost."""

    def pieces(self, polygon: list[Ring]) -> list[Ring]:
        return super().pieces(polygon)[:16]


class TakesRingsAsTheyTouch(PlainSum):
    """Rings that touch are joined by a bridge elsewhere, and the touching point stays pinched."""

    def parts(self, rings: list[Ring]) -> list[list[Ring]]:
        return [self.split_where_touched(rings)]


class TouchesAtVerticesOnly(PlainSum):
    """A ring that touches an edge of another one between its ends is not noticed."""

    def split_where_touched(self, rings: list[Ring]) -> list[Ring]:
        return rings


class SharedVerticesOnce(PlainSum):
    """A vertex that an earlier ring has is removed from the later ones as a duplicate."""

    def cleaned(self, rings: list[Ring]) -> list[Ring]:
        seen: set[Point] = set()
        made: list[Ring] = []
        for ring in super().cleaned(rings):
            left = [p for p in ring if p not in seen]
            seen |= set(ring)
            made += [left] if len(left) > 2 else []
        return made


class StraightCornersBackwards(PlainSum):
    """Of a straight vertex and its neighbour the wrong one is removed."""

    def cleaned(self, rings: list[Ring]) -> list[Ring]:
        made: list[Ring] = []
        for ring in rings:
            n = len(ring)
            straight = {k for k in range(n) if turn(ring[k - 1], ring[k], ring[(k + 1) % n]) == 0}
            gone = {(k + 1) % n for k in straight} if n - len(straight) > 2 else set()
            left = [p for k, p in enumerate(ring) if k not in gone]
            made.append(left if len(left) > 2 else ring)
        return super().cleaned(made)


class MergesCloseVertices(PlainSum):
    """Vertices of an operand nearer than a thousandth of its size to the one before are removed."""

    def cleaned(self, rings: list[Ring]) -> list[Ring]:
        x0, y0, x1, y1 = box_of(rings[0])
        reach = max(x1 - x0, y1 - y0)
        made: list[Ring] = []
        for ring in super().cleaned(rings):
            left: Ring = []
            for p in ring:
                near = left and max(abs(p[0] - left[-1][0]), abs(p[1] - left[-1][1])) * 1000
                if not left or near >= reach:
                    left.append(p)
            made.append(left if len(left) > 2 else ring)
        return made


class DropsSlivers(PlainSum):
    """Pieces that fill less than a thousandth of the square on their longer side are dropped."""

    def pieces(self, polygon: list[Ring]) -> list[Ring]:
        if len(polygon[0]) < 3:
            return super().pieces(polygon)
        kept = []
        for piece in super().pieces(polygon):
            x0, y0, x1, y1 = box_of(piece)
            if 500 * area(piece) >= max(x1 - x0, y1 - y0) ** 2:
                kept.append(piece)
        return kept


class CrashesOnStraightVertices(PlainSum):
    """Divides by the turn at a vertex, which is 0 at a straight one."""

    def cleaned(self, rings: list[Ring]) -> list[Ring]:
        for ring in rings:
            for k, p in enumerate(ring):
                _ = 1 / turn(ring[k - 1], p, ring[(k + 1) % len(ring)])
        return rings


class HoleCornersInsideOut(PlainSum):
    """Where a bridge leaves a reflex corner of a hole the wedge is taken for its complement."""

    def sees(
        self, ring: Ring, at: int, hole: Ring, start: int, edges: list[tuple[Point, Point]]
    ) -> bool:
        v, m = ring[at], hole[start]
        before, after = hole[start - 1], hole[(start + 1) % len(hole)]
        if turn(before, m, after) > 0:
            return in_wedge(after, m, before, v) and not within(before, after, v)
        return super().sees(ring, at, hole, start, edges)
