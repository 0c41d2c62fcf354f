"""Polygons with holes cut into convex pieces: holes joined to the outer ring by bridges, ears
clipped, triangles joined again where the result stays convex. Whole numbers only."""

from __future__ import annotations

from plain_geometry import (
    Point,
    Ring,
    area,
    in_wedge,
    is_around,
    turn,
    walks,
    within,
    without_straight_corners,
)

Corners = tuple[int, ...]  # places in a ring


class Pieces:
    """The stages of the cut; each fault replaces a stage."""

    def pieces(self, polygon: list[Ring]) -> list[Ring]:
        """Convex counter-clockwise polygons whose union is the polygon."""
        outer = polygon[0]
        if len(outer) < 3:
            return [outer]
        rings = self.cleaned(polygon)
        if len(rings) == 1 and self.is_convex(rings[0]):
            return rings
        found: list[Ring] = []
        for part in self.parts(rings):
            ring = self.bridged(part)
            joined = self.joined(ring, self.triangles(ring))
            found += [without_straight_corners([ring[k] for k in piece]) for piece in joined]
        return found

    def parts(self, rings: list[Ring]) -> list[list[Ring]]:
        """Outer ring and holes of each component of the interior. A ring may pass a point twice;
        rings of one component share no point."""
        if len(rings) == 1:
            return [rings]
        found = walks(self.split_where_touched(rings))
        outers = sorted((walk for walk in found if area(walk) > 0), key=area)
        parts = [[outer] for outer in outers]
        for hole in (walk for walk in found if area(walk) < 0):
            next(part for part in parts if is_around(part[0], hole)).append(hole)
        return parts

    def cleaned(self, rings: list[Ring]) -> list[Ring]:
        return [without_straight_corners(ring) for ring in rings]

    def is_convex(self, ring: Ring) -> bool:
        n = len(ring)
        return all(turn(ring[k - 1], ring[k], ring[(k + 1) % n]) > 0 for k in range(n))

    def split_where_touched(self, rings: list[Ring]) -> list[Ring]:
        """The rings with a corner wherever a corner of another one lies on an edge."""
        if len(rings) == 1:
            return rings
        corners = {p for ring in rings for p in ring}
        split: list[Ring] = []
        for ring in rings:
            made: Ring = []
            for a, b in zip(ring, ring[1:] + ring[:1], strict=True):
                on = [p for p in corners if turn(a, b, p) == 0 and within(a, b, p)]
                on.sort(key=lambda p, a=a: abs(p[0] - a[0]) + abs(p[1] - a[1]))  # type: ignore[misc]
                made += [a, *on]
            split.append(made)
        return split

    def bridged(self, rings: list[Ring]) -> Ring:
        """Joins every hole to the outer ring by an edge there and back."""
        ring, *holes = rings
        holes.sort(key=max, reverse=True)
        while holes:
            views = ((hole, self.bridge(ring, hole, holes)) for hole in holes)
            hole, found = next((view for view in views if view[1]), (None, None))
            if hole is None or found is None:
                raise ValueError("a hole that nothing sees")
            at, start = found
            turned = hole[start:] + hole[:start]
            ring = [*ring[: at + 1], *turned, turned[0], *ring[at:]]
            holes.remove(hole)
        return ring

    def bridge(self, ring: Ring, hole: Ring, holes: list[Ring]) -> tuple[int, int] | None:
        """Places on the ring and on the hole that see each other."""
        edges = [e for r in (ring, *holes) for e in zip(r, r[1:] + r[:1], strict=True)]
        for start in sorted(range(len(hole)), key=lambda k: hole[k], reverse=True):
            m = hole[start]
            near = sorted(
                range(len(ring)),
                key=lambda k, m=m: (ring[k][0] - m[0]) ** 2 + (ring[k][1] - m[1]) ** 2,  # type: ignore[misc]
            )
            for at in near:
                if self.sees(ring, at, hole, start, edges):
                    return at, start
        return None

    def sees(
        self, ring: Ring, at: int, hole: Ring, start: int, edges: list[tuple[Point, Point]]
    ) -> bool:
        v, m = ring[at], hole[start]
        before, after = ring[at - 1], ring[(at + 1) % len(ring)]
        if not in_wedge(before, v, after, m):
            return False
        if not in_wedge(hole[start - 1], m, hole[(start + 1) % len(hole)], v):
            return False
        return not any(self.blocks(v, m, a, b) for a, b in edges)

    def blocks(self, v: Point, m: Point, a: Point, b: Point) -> bool:
        """Whether the edge a b meets the open segment v m."""
        ta, tb = turn(v, m, a), turn(v, m, b)
        if (ta == 0 and within(v, m, a)) or (tb == 0 and within(v, m, b)):
            return True
        return ta * tb < 0 and turn(a, b, v) * turn(a, b, m) < 0

    def triangles(self, ring: Ring) -> list[Corners]:
        """Clips ears until a triangle is left."""
        left = list(range(len(ring)))
        found: list[Corners] = []
        k = 0
        patience = len(left)
        while len(left) > 3 and patience:
            n = len(left)
            a, b, c = left[k % n - 1], left[k % n], left[(k + 1) % n]
            if self.is_ear(ring, left, a, b, c):
                found.append((a, b, c))
                del left[k % n]
                patience = n
            else:
                patience -= 1
            k = (k + 1) % n
        if len(left) > 3:
            raise ValueError("no ear is left")
        if turn(*(ring[k] for k in left)) > 0:
            found.append(tuple(left))
        return found

    def is_ear(self, ring: Ring, left: list[int], a: int, b: int, c: int) -> bool:
        pa, pb, pc = ring[a], ring[b], ring[c]
        if turn(pa, pb, pc) <= 0:
            return False
        low, high = min(pa[0], pb[0], pc[0]), max(pa[0], pb[0], pc[0])
        for k in left:
            p = ring[k]
            if (
                low <= p[0] <= high
                and turn(pa, pb, p) >= 0
                and turn(pb, pc, p) >= 0
                and turn(pc, pa, p) >= 0
                and p not in (pa, pb, pc)
            ):
                return False
        return True

    def joined(self, ring: Ring, triangles: list[Corners]) -> list[Corners]:
        """Joins pieces across every diagonal that convexity does not need."""
        pieces: dict[int, Corners] = dict(enumerate(triangles))
        owner = {(t[k - 1], t[k]): number for number, t in pieces.items() for k in range(len(t))}
        for i, j in [edge for edge in owner if edge[0] < edge[1] and edge[::-1] in owner]:
            first, second = owner[i, j], owner[j, i]
            one, other = pieces[first], pieces[second]
            at, there = one.index(j), other.index(i)
            one, other = one[at:] + one[:at], other[there:] + other[:there]
            if self.stays_convex(ring, one, other):
                pieces[first] = one[:-1] + other[:-1]
                del pieces[second]
                for k in range(len(other) - 1):
                    owner[other[k], other[k + 1]] = first
        return list(pieces.values())

    def stays_convex(self, ring: Ring, one: Corners, other: Corners) -> bool:
        """Whether the union of two pieces is convex: `one` runs from j to i, `other` from i to
        j."""
        i, j = ring[other[0]], ring[one[0]]
        return (
            turn(ring[one[-2]], i, ring[other[1]]) >= 0
            and turn(ring[other[-2]], j, ring[one[1]]) >= 0
        )
