"""Faults about holes, the operands' and the sum's."""

from __future__ import annotations

from fractions import Fraction

from plain_geometry import Ring, area, side
from plain_sum import PlainSum, Polygon
from plain_union import Cycle, box_of, cycle_area, node_turn


class IgnoresHolesOfP(PlainSum):
    """Holes of the first operand are not read."""

    def piece_sums(self, P: list[Polygon], Q: list[Polygon]) -> list[Ring]:
        return super().piece_sums([polygon[:1] for polygon in P], Q)


class IgnoresHolesOfQ(PlainSum):
    """Holes of the second operand are not read."""

    def piece_sums(self, P: list[Polygon], Q: list[Polygon]) -> list[Ring]:
        return super().piece_sums(P, [polygon[:1] for polygon in Q])


class LosesTheLastHole(PlainSum):
    """The loop over two or more holes ends one hole too early."""

    def filled(self, operand: list[Polygon], other: list[Polygon]) -> list[Polygon]:
        return [
            polygon[:-1] if len(polygon) > 2 else polygon
            for polygon in super().filled(operand, other)
        ]


class HolesOfTheFirstPolygon(PlainSum):
    """Only the first polygon of an operand may have holes."""

    def filled(self, operand: list[Polygon], other: list[Polygon]) -> list[Polygon]:
        found = super().filled(operand, other)
        return found[:1] + [polygon[:1] for polygon in found[1:]]


class FiltersHolesByCircumference(PlainSum):
    """A hole whose circumference is no longer than that of the other operand is filled."""

    def filled(self, operand: list[Polygon], other: list[Polygon]) -> list[Polygon]:
        least = min((self.length(polygon[0]) for polygon in other), default=0)
        return [
            [polygon[0], *(hole for hole in polygon[1:] if self.length(hole) > least)]
            for polygon in super().filled(operand, other)
        ]

    def length(self, ring: Ring) -> int:
        return sum(
            abs(p[0] - q[0]) + abs(p[1] - q[1])
            for p, q in zip(ring, ring[1:] + ring[:1], strict=True)
        )


class FiltersHolesByTheWholeBox(PlainSum):
    """A hole is compared with the box of all polygons of the other operand together."""

    def filled(self, operand: list[Polygon], other: list[Polygon]) -> list[Polygon]:
        if not other:
            return super().filled(operand, other)
        return super().filled(operand, [[[p for polygon in other for p in polygon[0]]]])


class FiltersHolesTurned(PlainSum):
    """The width of a hole is compared with the height of the other operand."""

    def size(self, ring: Ring) -> tuple[int, int]:
        x0, y0, x1, y1 = box_of(ring)
        return (x1 - x0, y1 - y0) if area(ring) < 0 else (y1 - y0, x1 - x0)


class FiltersHolesWithAMargin(PlainSum):
    """A hole larger than the other operand by less than a millionth is filled."""

    def has_room(self, hole: Ring, sizes: list[tuple[int, int]]) -> bool:
        width, height = (size * 10**6 for size in self.size(hole))
        return any(width > w * (10**6 + 1) and height > h * (10**6 + 1) for w, h in sizes)


class FiltersHolesByTheirOwnOperand(PlainSum):
    """After the operands are swapped, the larger first, holes are compared with their own."""

    def filled(self, operand: list[Polygon], other: list[Polygon]) -> list[Polygon]:
        count, against = (sum(len(p[0]) for p in each) for each in (operand, other))
        return super().filled(operand, operand if count < against else other)


class FillsHolesOneUnitTooWide(PlainSum):
    """A hole one unit of the grid wider or higher than the other operand is filled."""

    def has_room(self, hole: Ring, sizes: list[tuple[int, int]]) -> bool:
        width, height = self.size(hole)
        return any(width > w + 1 and height > h + 1 for w, h in sizes)


class FillsAllHoles(PlainSum):
    """Holes of the sum are not written."""

    def put_hole(self, polygons: list[list[Cycle]], hole: Cycle) -> None:
        pass


class OneHoleAPolygon(PlainSum):
    """A polygon of the sum keeps the first of its holes."""

    def nested(self, cycles: list[Cycle]) -> list[list[Cycle]]:
        return [polygon[:2] for polygon in super().nested(cycles)]


class LastHoleNotWritten(PlainSum):
    """Of two or more holes of the sum the last is not written."""

    def nested(self, cycles: list[Cycle]) -> list[list[Cycle]]:
        return [p[:-1] if len(p) > 2 else p for p in super().nested(cycles)]


class HolesAsPolygons(PlainSum):
    """Holes of the sum are written as polygons of their own."""

    def nested(self, cycles: list[Cycle]) -> list[list[Cycle]]:
        return [[ring] for polygon in super().nested(cycles) for ring in polygon]


class HolesByTheirCentre(PlainSum):
    """A hole of the sum is kept where the mean of its vertices lies in it."""

    def put_hole(self, polygons: list[list[Cycle]], hole: Cycle) -> None:
        points = [(Fraction(x, w), Fraction(y, w)) for x, y, w in hole]
        xs, ys = [x for x, _ in points], [y for _, y in points]
        if side(points, (sum(xs) / len(xs), sum(ys) / len(ys))) > 0:
            super().put_hole(polygons, hole)


class OrientationByTheFirstCorner(PlainSum):
    """Whether a ring is a hole is told by the turn at its leftmost listed corner only."""

    def nested(self, cycles: list[Cycle]) -> list[list[Cycle]]:
        outers = [cycle for cycle in cycles if node_turn(cycle[-1], cycle[0], cycle[1]) > 0]
        polygons = [[cycle] for cycle in sorted(outers, key=lambda c: abs(cycle_area(c)))]
        for hole in (cycle for cycle in cycles if cycle not in outers):
            around = [p for p in polygons if self.is_around(p[0], hole)]
            if around:
                around[0].append(hole)
        return polygons


class DropsIslands(PlainSum):
    """Of the sum, polygons in holes of others are not looked for."""

    def nested(self, cycles: list[Cycle]) -> list[list[Cycle]]:
        found = super().nested(cycles)
        return [
            polygon
            for polygon in found
            if not any(self.is_around(other[0], polygon[0]) for other in found if other != polygon)
        ]


class RayThroughVertices(PlainSum):
    """A ray through a vertex counts both edges there: a hole at that height is lost."""

    def is_around(self, outer: Cycle, hole: Cycle) -> bool:
        px, py = (Fraction(value, hole[0][2]) for value in hole[0][:2])
        ring = [(Fraction(x, w), Fraction(y, w)) for x, y, w in outer]
        crossed = 0
        for a, b in zip(ring, ring[1:] + ring[:1], strict=True):
            if min(a[1], b[1]) <= py <= max(a[1], b[1]) and a[1] != b[1]:
                at = a[0] + (py - a[1]) / (b[1] - a[1]) * (b[0] - a[0])
                crossed += at > px
        return crossed % 2 == 1

    def put_hole(self, polygons: list[list[Cycle]], hole: Cycle) -> None:
        if any(self.is_around(polygon[0], hole) for polygon in polygons):
            super().put_hole(polygons, hole)
