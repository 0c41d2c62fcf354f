"""Known facts of a sum, as questions about points and small cubes."""

from __future__ import annotations

from fractions import Fraction
from itertools import product
from math import lcm
from typing import Protocol

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point, Whole, normal, whole
from minkref.fuzz.space.cells import CellSum
from minkref.fuzz.space.meeting import Meeting, cube_inside
from minkref.fuzz.space.membership import Surface
from minkref.fuzz.space.pair import SpacePair, Truth
from minkref.fuzz.space.prism import Prism

MOST_CELLS = 4096  # most cells per cube in a cell-by-cell search


class KnownSum(Protocol):
    def contains(self, point: Point) -> bool:
        """The point lies in the closed sum."""

    def may_cover(self, point: Point, distance: Fraction) -> bool:
        """False: the sum surely does not contain the whole cube with half side `distance`."""

    def clear_of(self, point: Point, distance: Fraction) -> bool:
        """True: the sum contains no point of the cube."""


def known_sum(pair: SpacePair) -> KnownSum:
    if pair.judged_by is Truth.SUM:
        return KnownSurface(pair.exact.surface)
    if pair.truth is Truth.CELLS:
        return KnownCells(pair.cell_sum)
    if pair.truth is Truth.HULL:
        return KnownHull(pair.hull)
    if pair.truth is Truth.PRISM:
        return KnownPrism(pair.prism_sum, pair.meeting)
    return KnownPoints(pair.meeting)


class KnownCells:
    """Exact for cubes too, but those of more than MOST_CELLS cells."""

    def __init__(self, sum: CellSum) -> None:
        self._sum = sum

    def contains(self, point: Point) -> bool:
        return any(cell in self._sum.cells for cell in self._touched(point, Fraction(0)))

    def may_cover(self, point: Point, distance: Fraction) -> bool:
        ranges = []
        for number, unit in zip(point, self._sum.unit, strict=True):
            ranges.append(range((number - distance) // unit, -(-(number + distance) // unit)))
        if any(len(r) > MOST_CELLS for r in ranges):
            return False
        return all(cell in self._sum.cells for cell in product(ranges[0], ranges[1], ranges[2]))

    def clear_of(self, point: Point, distance: Fraction) -> bool:
        cells = self._touched(point, distance)
        return 0 < len(cells) and not any(cell in self._sum.cells for cell in cells)

    def _touched(self, point: Point, distance: Fraction) -> list[tuple[int, int, int]]:
        """Returns the cells that the closed cube meets; empty if too many."""
        ranges = []
        for number, unit in zip(point, self._sum.unit, strict=True):
            first = -(-(number - distance) // unit) - 1
            ranges.append(range(first, (number + distance) // unit + 1))
        if len(ranges[0]) * len(ranges[1]) * len(ranges[2]) > MOST_CELLS:
            return []
        return list(product(ranges[0], ranges[1], ranges[2]))


class KnownHull:
    """`clear_of` is False for some clear cubes near an edge or corner."""

    def __init__(self, hull: Polyhedron) -> None:
        self._unit = hull.denominator
        points = hull.wholes
        self._planes = []
        for face in hull.faces:
            n = normal(*(points[index] for index in face[:3]))
            height = sum(n[k] * points[face[0]][k] for k in range(3))
            self._planes.append((n, height, abs(n[0]) + abs(n[1]) + abs(n[2])))

    def contains(self, point: Point) -> bool:
        return self.may_cover(point, Fraction(0))

    def may_cover(self, point: Point, distance: Fraction) -> bool:
        v, (x, y, z), reach = self._placed(point, distance)
        return all(
            n[0] * x + n[1] * y + n[2] * z + reach * length <= height * v
            for n, height, length in self._planes
        )

    def clear_of(self, point: Point, distance: Fraction) -> bool:
        v, (x, y, z), reach = self._placed(point, distance)
        return any(
            n[0] * x + n[1] * y + n[2] * z - reach * length > height * v
            for n, height, length in self._planes
        )

    def _placed(self, point: Point, distance: Fraction) -> tuple[int, Whole, int]:
        """In integers, over the first number times the denominator of the hull."""
        v = lcm(*(number.denominator for number in (*point, distance)))
        return v, whole(point, v * self._unit), int(distance * v * self._unit)


class KnownSurface:
    """Answers by the sum's surface, exactly except for cubes that touch it: these are neither
    coverable nor clear."""

    def __init__(self, surface: Surface) -> None:
        self._surface = surface

    def contains(self, point: Point) -> bool:
        return self._surface.contains(point)

    def may_cover(self, point: Point, distance: Fraction) -> bool:
        return self.contains(point) and cube_inside(self._surface, point, distance)

    def clear_of(self, point: Point, distance: Fraction) -> bool:
        return not self.contains(point) and cube_inside(self._surface, point, distance)


class KnownPoints:
    """From the definition."""

    def __init__(self, meeting: Meeting) -> None:
        self._meeting = meeting

    def contains(self, point: Point) -> bool:
        return self._meeting.meets(point)

    def may_cover(self, point: Point, distance: Fraction) -> bool:
        return self.contains(point)

    def clear_of(self, point: Point, distance: Fraction) -> bool:
        return self._meeting.apart(point, distance)


class KnownPrism(KnownPoints):
    def __init__(self, prism: Prism, meeting: Meeting) -> None:
        super().__init__(meeting)
        self._prism = prism

    def contains(self, point: Point) -> bool:
        return self._prism.contains(point)

    def may_cover(self, point: Point, distance: Fraction) -> bool:
        """Whether the prism contains all corners of the cube."""
        return all(
            self._prism.contains(
                (point[0] + a * distance, point[1] + b * distance, point[2] + c * distance)
            )
            for a, b, c in product((-1, 1), repeat=3)
        )

    def clear_of(self, point: Point, distance: Fraction) -> bool:
        return not self._prism.contains(point) and super().clear_of(point, distance)
