"""The sets that rings and polygons describe, and how they meet."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction

from minkref import _core
from minkref.exact import set_json
from minkref.repair.rings import Point

Rings = list[list[Point]]  # of a polygon: the outer one, then holes
Box = tuple[Fraction, Fraction, Fraction, Fraction]


@dataclass(frozen=True)
class Region:
    """A set of polygons, valid or not, with the box around it."""

    polygons: list[Rings]

    @property
    def set(self) -> _core.PolygonSet:
        return _core.PolygonSet.from_json(set_text(self.polygons))

    @property
    def area(self) -> Fraction:
        return area_of(self.set)

    @property
    def box(self) -> Box:
        xs, ys = zip(*(point for rings in self.polygons for point in rings[0]), strict=True)
        return min(xs), min(ys), max(xs), max(ys)


def set_text(polygons: Iterable[Rings]) -> str:
    """Write polygons as plain JSON, exactly."""
    return set_json((rings[0], rings[1:]) for rings in polygons)


def region_of(found: _core.PolygonSet) -> Region:
    return Region(found.rings())


def area_of(found: _core.PolygonSet) -> Fraction:
    return Fraction(found.area())


def fault(polygons: Sequence[Rings]) -> _core.BadInput | None:
    """Return the first fault, None for an operand. O(n log n) on usual input."""
    try:
        _core.PolygonSet.from_json(set_text(polygons)).validate()
    except _core.BadInput as error:
        return error
    return None


def filled(points: list[Point], rule: str) -> tuple[Region, bool]:
    """The closure of the points inside a ring by a rule, and whether the ring only touches itself.
    O((n + k) log n)."""
    found, is_touching = _core.filled(Region([[points]]).set, rule)
    return region_of(found), is_touching


def combined(operation: str, regions: Sequence[Region]) -> Region:
    """Unite regions, or take the others away from the first one."""
    return region_of(_core.combined(operation, [region.set for region in regions])[0])


def shared_area(a: Region, b: Region) -> Fraction:
    return area_of(_core.combined("intersection", [a.set, b.set])[0])


def near_pairs(boxes: Sequence[Box]) -> Iterator[tuple[int, int]]:
    """Yield pairs of touching closed boxes, ascending. Linear, plus pairs that overlap along x."""
    order = sorted(range(len(boxes)), key=lambda k: boxes[k][0])
    active: list[int] = []
    found: list[tuple[int, int]] = []
    for k in order:
        left, low, _, high = boxes[k]
        active = [j for j in active if boxes[j][2] >= left]
        found += [
            (min(j, k), max(j, k)) for j in active if boxes[j][1] <= high and boxes[j][3] >= low
        ]
        active.append(k)
    yield from sorted(found)
