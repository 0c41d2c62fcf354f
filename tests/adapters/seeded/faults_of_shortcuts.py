"""Faults by false assumptions about operands: position, size, number of parts."""

from __future__ import annotations

from fractions import Fraction

from plain_geometry import Ring, area
from plain_sum import Exact, PlainSum, Polygon, Set
from plain_union import box_of

Operand = list[list[list[Exact]]]


def edges(polygon: Polygon) -> list[Ring]:
    """The edges of all rings, as segments."""
    return [
        [a, b] for ring in polygon for a, b in zip(ring, ring[1:] + ring[:1], strict=True) if a != b
    ]


class FirstPolygonOfP(PlainSum):
    """Of the first operand only the first polygon is taken."""

    def total(self, P: Operand, Q: Operand) -> Set | None:
        return super().total(P[:1], Q)


class FirstPolygonOfQ(PlainSum):
    """Of the second operand only the first polygon is taken."""

    def total(self, P: Operand, Q: Operand) -> Set | None:
        return super().total(P, Q[:1])


class LargestPolygonOnly(PlainSum):
    """Of the sum only the largest polygon is returned."""

    def __call__(self, P: Set, Q: Set) -> Set | None:
        found = super().__call__(P, Q)
        if found and len(found["polygons"]) > 1:
            found["polygons"] = found["polygons"][-1:]
        return found


class SumOfEachPolygonByItself(PlainSum):
    """The sums of the polygons of P are listed side by side, though they may overlap."""

    def total(self, P: Operand, Q: Operand) -> Set | None:
        if len(P) < 2:
            return super().total(P, Q)
        sums = [super(SumOfEachPolygonByItself, self).total([polygon], Q) for polygon in P]
        return {"polygons": [polygon for each in sums if each for polygon in each["polygons"]]}


class BoundariesOnly(PlainSum):
    """The sum of the boundaries."""

    def piece_sums(self, P: list[Polygon], Q: list[Polygon]) -> list[Ring]:
        first = [edge for polygon in P for edge in edges(polygon)]
        second = [edge for polygon in Q for edge in edges(polygon)]
        return self.regions([self.convex_sum(a, b) for a in first for b in second])


class BoundaryOfP(PlainSum):
    """The second operand is swept along the boundary of the first, whose inside is forgotten."""

    def piece_sums(self, P: list[Polygon], Q: list[Polygon]) -> list[Ring]:
        first = [edge for polygon in P for edge in edges(polygon)]
        second = [piece for polygon in Q for piece in self.pieces(polygon)]
        return self.regions([self.convex_sum(a, b) for a in first for b in second])


class BoundaryOfQ(PlainSum):
    """The first operand is swept along the boundary of the second: wrong where P fits into Q."""

    def piece_sums(self, P: list[Polygon], Q: list[Polygon]) -> list[Ring]:
        first = [piece for polygon in P for piece in self.pieces(polygon)]
        second = [edge for polygon in Q for edge in edges(polygon)]
        return self.regions([self.convex_sum(a, b) for a in first for b in second])


class OriginInQ(PlainSum):
    """The first operand itself is added to the sweep, as if the origin lay in the second."""

    def piece_sums(self, P: list[Polygon], Q: list[Polygon]) -> list[Ring]:
        found = super().piece_sums(P, Q)
        return found and self.regions(found + [piece for p in P for piece in self.pieces(p)])


class MirrorsQ(PlainSum):
    """P and -Q: the configuration space of Q instead of the sum."""

    def total(self, P: Operand, Q: Operand) -> Set | None:
        return super().total(P, [[[(-x, -y) for x, y in r] for r in polygon] for polygon in Q])


class StandsTallInputsOnTheirSide(PlainSum):
    """For a sweep along the longer side x and y of tall operands are swapped, and not back."""

    def __call__(self, P: Set, Q: Set) -> Set | None:
        found = super().__call__(P, Q)
        rings = [polygon[0] for polygon in self.read(P)]
        xs, ys = ([p[k] for ring in rings for p in ring] for k in (0, 1))
        if found is None or not rings or max(ys) - min(ys) < 3 * (max(xs) - min(xs)):
            return found
        for polygon in found["polygons"]:
            polygon["outer"] = [[y, x] for x, y in polygon["outer"]]
            polygon["holes"] = [[[y, x] for x, y in hole] for hole in polygon["holes"]]
        return found


class ClampsToTheGrid(PlainSum):
    """Coordinates beyond a million are clamped to it."""

    def number(self, text: str) -> Fraction:
        return max(Fraction(-(10**6)), min(Fraction(10**6), super().number(text)))


class LimitsDenominators(PlainSum):
    """Denominators beyond a million are replaced by the nearest fraction below it."""

    def number(self, text: str) -> Fraction:
        return super().number(text).limit_denominator(10**6)


class SkipsDistantParts(PlainSum):
    """Polygons of P further from its first one than ten times its size are taken for outliers."""

    def piece_sums(self, P: list[Polygon], Q: list[Polygon]) -> list[Ring]:
        kept = P[:1]
        for polygon in P[1:]:
            x0, y0, x1, y1 = box_of(P[0][0])
            u0, v0, u1, v1 = box_of(polygon[0])
            reach = 10 * max(x1 - x0, y1 - y0)
            if max(u0 - x1, x0 - u1, v0 - y1, y0 - v1) <= reach:
                kept = [*kept, polygon]
        return super().piece_sums(kept, Q)


class SmallPartsLost(PlainSum):
    """Polygons of an operand smaller than a twentieth of its first one are lost."""

    def piece_sums(self, P: list[Polygon], Q: list[Polygon]) -> list[Ring]:
        return super().piece_sums(self.large(P), self.large(Q))

    def large(self, operand: list[Polygon]) -> list[Polygon]:
        return [
            polygon
            for polygon in operand
            if len(polygon[0]) < 3 or 20 * area(polygon[0]) >= area(operand[0][0])
        ]
